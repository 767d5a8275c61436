//! JSON values that know where in the text they stand.
//!
//! The parser checks the syntax of the whole text once. Then each value is a piece of that text,
//! which is taken apart where it is asked for; so every error has its line and column, and its
//! words are ours.
//!
//! Limits: a value is read once for each level of nesting above it. Columns count bytes.

use std::collections::BTreeMap;
use std::fmt;

use serde::Deserialize;
use serde::de::{Deserializer, MapAccess, Visitor};
use serde_json::value::RawValue;

use super::error::DomainJsonError;
use super::guess;
use super::syntax;

/// What a length, a size or a growth is to be.
pub(super) const ABOVE_0: &str = "a number above 0";

/// A value of a text.
#[derive(Clone)]
pub(super) struct Value<'t> {
    /// The whole text.
    text: &'t str,
    /// The piece of it that is the value.
    json: &'t str,
    path: String,
}

/// One step into a value.
#[derive(Clone, Copy)]
pub(super) enum Step {
    Key(&'static str),
    Index(usize),
}

/// The values of an object, each under an allowed key that comes once.
pub(super) struct Object<'t> {
    value: Value<'t>,
    wanted: &'static str,
    values: BTreeMap<String, Value<'t>>,
}

impl<'t> Value<'t> {
    /// The value that a whole text is.
    pub(super) fn document(text: &'t str) -> Result<Self, DomainJsonError> {
        match serde_json::from_str::<&RawValue>(text) {
            Ok(raw) => Ok(Self { text, json: raw.get(), path: String::new() }),
            Err(error) => Err(syntax::no_json(text, &error)),
        }
    }

    /// An error about this value.
    pub(super) fn error(&self, message: impl Into<String>) -> DomainJsonError {
        // Both are pieces of the same text.
        let start = self.json.as_ptr() as usize - self.text.as_ptr() as usize;
        let before = &self.text[..start];
        let line = before.bytes().filter(|&byte| byte == b'\n').count() + 1;
        let column = start - before.rfind('\n').map_or(0, |end| end + 1) + 1;
        DomainJsonError { path: self.path.clone(), line, column, message: message.into() }
    }

    /// The error that this value is of another kind than wanted.
    pub(super) fn unexpected(&self, wanted: &str) -> DomainJsonError {
        let found = match self.json.as_bytes()[0] {
            b'{' => "an object".to_owned(),
            b'[' => "a list".to_owned(),
            b'"' => format!("the text {}", shortened(self.json)),
            b't' | b'f' | b'n' => self.json.to_owned(),
            _ => format!("the number {}", shortened(self.json)),
        };
        self.error(format!("found {found}, expected {wanted}"))
    }

    pub(super) fn is_null(&self) -> bool {
        self.json == "null"
    }

    pub(super) fn is_object(&self) -> bool {
        self.json.starts_with('{')
    }

    pub(super) fn is_list(&self) -> bool {
        self.json.starts_with('[')
    }

    /// A finite number.
    pub(super) fn number(&self, wanted: &str) -> Result<f64, DomainJsonError> {
        // Every JSON number is one of Rust's, which are rounded to the nearest f64.
        match self.json.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            Ok(_) if self.json.ends_with(|end: char| end.is_ascii_digit()) => {
                Err(self.error(format!(
                    "the number {} is too large; the maximum is about 1e308",
                    shortened(self.json)
                )))
            }
            _ => Err(self.unexpected(wanted)),
        }
    }

    /// A whole number, at least 0.
    pub(super) fn whole<N: std::str::FromStr>(&self, wanted: &str) -> Result<N, DomainJsonError> {
        self.json.parse().map_err(|_| self.unexpected(wanted))
    }

    /// True or false.
    pub(super) fn truth(&self, wanted: &str) -> Result<bool, DomainJsonError> {
        match self.json {
            "true" => Ok(true),
            "false" => Ok(false),
            _ => Err(self.unexpected(wanted)),
        }
    }

    /// All of it at once, if it is of the type that is wanted.
    pub(super) fn read<T: Deserialize<'t>>(&self) -> Option<T> {
        serde_json::from_str(self.json).ok()
    }

    /// A text.
    pub(super) fn text(&self, wanted: &str) -> Result<String, DomainJsonError> {
        if !self.json.starts_with('"') {
            return Err(self.unexpected(wanted));
        }
        serde_json::from_str(self.json)
            .map_err(|_| self.error("this text has an escape that is no character"))
    }

    /// The values of a list.
    pub(super) fn items(&self, wanted: &str) -> Result<Vec<Self>, DomainJsonError> {
        if !self.is_list() {
            return Err(self.unexpected(wanted));
        }
        let items: Vec<&'t RawValue> =
            serde_json::from_str(self.json).map_err(|error| syntax::no_json(self.json, &error))?;
        let item = |(index, raw): (usize, &'t RawValue)| Self {
            text: self.text,
            json: raw.get(),
            path: format!("{}[{index}]", self.path),
        };
        Ok(items.into_iter().enumerate().map(item).collect())
    }

    /// The keys and values of an object, in order; also keys that come twice.
    fn members(&self, wanted: &str) -> Result<Vec<(String, Self)>, DomainJsonError> {
        if !self.is_object() {
            return Err(self.unexpected(wanted));
        }
        let Members(members) =
            serde_json::from_str(self.json).map_err(|error| syntax::no_json(self.json, &error))?;
        let member = |(key, raw): (String, &'t RawValue)| {
            let dot = if self.path.is_empty() { "" } else { "." };
            let path = format!("{}{dot}{}", self.path, key.escape_debug());
            (key, Self { text: self.text, json: raw.get(), path })
        };
        Ok(members.into_iter().map(member).collect())
    }

    /// An object with no other keys than those allowed.
    pub(super) fn object(
        &self,
        allowed: &[&str],
        wanted: &'static str,
    ) -> Result<Object<'t>, DomainJsonError> {
        let mut values = BTreeMap::new();
        for (key, value) in self.members(wanted)? {
            if !allowed.contains(&key.as_str()) {
                let key = shortened(&format!("{key:?}"));
                let allowed = allowed.iter().map(|key| format!("{key:?}")).collect::<Vec<_>>();
                let allowed = allowed.join(", ");
                return Err(value.error(format!("unknown key {key}; allowed: {allowed}")));
            }
            if values.contains_key(&key) {
                return Err(value.error(format!("the key {key:?} comes twice; give it once")));
            }
            values.insert(key, value);
        }
        Ok(Object { value: self.clone(), wanted, values })
    }

    /// What this value looks like, if it is an object of another format.
    pub(super) fn other_format(&self) -> Option<&'static str> {
        let members = self.members("").ok()?;
        let kind = members.iter().find(|(key, _)| key == "type");
        let kind = kind.and_then(|(_, value)| value.text("").ok());
        guess::of_keys(members.iter().map(|(key, _)| key.as_str()), kind.as_deref())
    }

    /// The value at the end of a path, if the path leads to one.
    pub(super) fn at(&self, path: &[Step]) -> Option<Self> {
        path.iter().try_fold(self.clone(), |value, step| match *step {
            Step::Key(wanted) => {
                let members = value.members("").ok()?;
                members.into_iter().find(|(key, _)| key == wanted).map(|(_, value)| value)
            }
            Step::Index(index) => value.items("").ok()?.into_iter().nth(index),
        })
    }
}

impl<'t> Object<'t> {
    /// The value of a key, if it is there and not null.
    pub(super) fn get(&self, key: &str) -> Option<&Value<'t>> {
        self.values.get(key).filter(|value| !value.is_null())
    }

    /// The value of a key that must be there.
    pub(super) fn need(&self, key: &str) -> Result<&Value<'t>, DomainJsonError> {
        self.get(key).ok_or_else(|| {
            self.value.error(format!("the key {key:?} is missing; expected {}", self.wanted))
        })
    }
}

/// A text for a message, cut where it is long.
fn shortened(text: &str) -> String {
    const LONGEST: usize = 40;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

/// The keys and values of an object, in order.
struct Members<'t>(Vec<(String, &'t RawValue)>);

impl<'de> Deserialize<'de> for Members<'de> {
    fn deserialize<D: Deserializer<'de>>(reader: D) -> Result<Self, D::Error> {
        struct Collect;

        impl<'de> Visitor<'de> for Collect {
            type Value = Members<'de>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Members<'de>, A::Error> {
                let mut members = Vec::new();
                while let Some((key, value)) = map.next_entry::<String, &'de RawValue>()? {
                    members.push((key, value));
                }
                Ok(Members(members))
            }
        }

        reader.deserialize_map(Collect)
    }
}
