//! Reads JSON text for serde, with the path, line and column of every fault.
//!
//! A struct is read from an object only; serde_json would accept a list, too.

use serde::de::value::MapAccessDeserializer;
use serde::de::{
    DeserializeOwned, DeserializeSeed, Deserializer, IntoDeserializer, MapAccess, SeqAccess,
    Visitor,
};
use serde::forward_to_deserialize_any;

use super::error::DomainJsonError;
use super::fault::{Fault, one_of, quoted, shortened};
use super::text::{Reader, at, checked};
use crate::error::{Place, Step};

/// The value that a whole text is.
pub(super) fn read<T: DeserializeOwned>(text: &str) -> Result<T, DomainJsonError> {
    let text = checked(text)?;
    let mut reader = Reader { text, at: 0 };
    T::deserialize(&mut reader).map_err(|mut fault| {
        fault.steps.reverse();
        at(text, fault.at.unwrap_or(0), &Place(fault.steps), fault.message)
    })
}

impl<'t> Reader<'t> {
    /// Reads the value that starts here. A fault without a position gets the position of this value.
    fn placed<T>(&mut self, read: impl FnOnce(&mut Self) -> Result<T, Fault>) -> Result<T, Fault> {
        self.peek();
        let start = self.at;
        read(self).map_err(|mut fault| {
            if fault.at.is_none() {
                if fault.is_expectation {
                    let found = Reader { text: self.text, at: start }.found();
                    fault.message = format!("found {found}, expected {}", fault.message);
                }
                fault.at = Some(start);
                if let Some(key) = fault.key.take() {
                    self.peek();
                    fault.at = Some(self.at);
                    fault.steps.push(Step::Key(key));
                }
            }
            fault
        })
    }

    /// The result of a visitor on the list or object that starts here.
    fn inside<T>(
        &mut self,
        visit: impl FnOnce(&mut Items<'_, 't>) -> Result<T, Fault>,
    ) -> Result<T, Fault> {
        self.at += 1;
        let mut items = Items { reader: self, index: 0, key: String::new() };
        let value = visit(&mut items)?;
        let taken = items.index;
        match (self.item(), taken) {
            (None, _) => self.at += 1,
            (Some(()), 0) => return Err(Fault::expected("one key".to_owned())),
            (Some(()), taken) => return Err(Fault::expected(format!("a list of {taken}"))),
        }
        Ok(value)
    }

    fn object<T>(
        &mut self,
        keys: &[&str],
        visit: impl FnOnce(&mut Items<'_, 't>) -> Result<T, Fault>,
    ) -> Result<T, Fault> {
        self.placed(|reader| match reader.peek() {
            b'{' => reader.inside(visit),
            _ if keys.is_empty() => Err(Fault::expected("an object".to_owned())),
            _ => Err(Fault::expected(format!("an object with {}", quoted(keys).join(", ")))),
        })
    }
}

impl<'de, 't> Deserializer<'de> for &mut Reader<'t> {
    type Error = Fault;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        self.placed(|reader| match reader.peek() {
            b'{' => reader.inside(|items| visitor.visit_map(items)),
            b'[' => reader.inside(|items| visitor.visit_seq(items)),
            b'"' => visitor.visit_string(reader.string()?),
            b't' | b'f' => visitor.visit_bool(reader.token() == "true"),
            b'n' => {
                reader.token();
                visitor.visit_unit()
            }
            _ => {
                let token = reader.token();
                if let Ok(whole) = token.parse() {
                    return visitor.visit_u64(whole);
                }
                // Every JSON number is a valid Rust number; Rust rounds to the nearest f64.
                match token.parse::<f64>() {
                    Ok(number) if number.is_finite() => visitor.visit_f64(number),
                    _ => Err(Fault::new(format!(
                        "the number {} is too large; the maximum is about 1e308",
                        shortened(token)
                    ))),
                }
            }
        })
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        if self.peek() == b'n' {
            self.token();
            return visitor.visit_none();
        }
        visitor.visit_some(self)
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        keys: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        self.object(keys, |items| visitor.visit_map(items))
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        variants: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        self.placed(|reader| match reader.peek() {
            b'"' => visitor.visit_enum(reader.string()?.into_deserializer()),
            b'{' => reader.inside(|items| match items.reader.item() {
                Some(()) => visitor.visit_enum(MapAccessDeserializer::new(items)),
                None => Err(Fault::expected(one_of(variants))),
            }),
            _ => Err(Fault::expected(one_of(variants))),
        })
    }

    fn deserialize_map<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        self.object(&[], |items| visitor.visit_map(items))
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf unit
        unit_struct newtype_struct seq tuple tuple_struct identifier ignored_any
    }
}

/// The items of a list or object.
struct Items<'r, 't> {
    reader: &'r mut Reader<'t>,
    index: usize,
    /// The last key.
    key: String,
}

impl<'de> SeqAccess<'de> for &mut Items<'_, '_> {
    type Error = Fault;

    fn next_element_seed<S: DeserializeSeed<'de>>(
        &mut self,
        seed: S,
    ) -> Result<Option<S::Value>, Fault> {
        if self.reader.item().is_none() {
            return Ok(None);
        }
        let index = self.index;
        self.index += 1;
        seed.deserialize(&mut *self.reader).map(Some).map_err(|mut fault| {
            fault.steps.push(Step::Index(index));
            fault
        })
    }
}

impl<'de> MapAccess<'de> for &mut Items<'_, '_> {
    type Error = Fault;

    fn next_key_seed<S: DeserializeSeed<'de>>(
        &mut self,
        seed: S,
    ) -> Result<Option<S::Value>, Fault> {
        if self.reader.item().is_none() {
            return Ok(None);
        }
        self.key = self.reader.string()?;
        let key = self.key.as_str().into_deserializer();
        seed.deserialize(key).map(Some).map_err(|mut fault: Fault| {
            if fault.is_expectation {
                fault.message = format!("unknown key {:?}; expected {}", self.key, fault.message);
            }
            self.reader.peek();
            let steps = vec![Step::Key(self.key.clone())];
            Fault { at: Some(self.reader.at), steps, ..fault }
        })
    }

    fn next_value_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Result<S::Value, Fault> {
        seed.deserialize(&mut *self.reader).map_err(|mut fault| {
            fault.steps.push(Step::Key(self.key.clone()));
            fault
        })
    }
}
