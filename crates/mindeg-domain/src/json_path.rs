//! Where in a JSON text the value at a path stands, for errors that show only when the text has
//! been read.
//!
//! Limits: columns count bytes.

use std::fmt;

use serde::de::{DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};

/// One step into a JSON value.
#[derive(Clone, Copy)]
pub(crate) enum Step {
    Key(&'static str),
    Index(usize),
}

/// The line and column, both from 1, of the value at a path. Steps at the end of the path that
/// lead nowhere are dropped: what is wrong with a text may be a value that was left out.
///
/// The text is JSON; reads it once for every step dropped.
pub(crate) fn locate(text: &str, path: &mut Vec<Step>) -> (usize, usize) {
    while !path.is_empty() {
        let mut reader = serde_json::Deserializer::from_str(text);
        if let Err(stop) = WalkTo(path).deserialize(&mut reader) {
            // The reader has stopped right before the value.
            return (stop.line(), stop.column() + 1);
        }
        path.pop();
    }
    (1, 1)
}

/// A path as people write it, such as `sides[2].spacing`.
pub(crate) fn display(path: &[Step]) -> String {
    let path: String = path
        .iter()
        .map(|step| match step {
            Step::Key(key) => format!(".{key}"),
            Step::Index(index) => format!("[{index}]"),
        })
        .collect();
    path.trim_start_matches('.').to_owned()
}

/// Walks to the value at a path and fails there, for the position that the parser puts on
/// errors. Succeeds where the path leads nowhere.
struct WalkTo<'a>(&'a [Step]);

impl<'de> DeserializeSeed<'de> for WalkTo<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, reader: D) -> Result<(), D::Error> {
        if self.0.is_empty() {
            return Err(D::Error::custom("here"));
        }
        reader.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for WalkTo<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object or a list")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        while let Some(key) = map.next_key::<String>()? {
            if matches!(self.0[0], Step::Key(wanted) if wanted == key) {
                return map.next_value_seed(WalkTo(&self.0[1..]));
            }
            map.next_value::<IgnoredAny>()?;
        }
        Ok(())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<(), A::Error> {
        let Step::Index(index) = self.0[0] else { return Ok(()) };
        for _ in 0..index {
            if list.next_element::<IgnoredAny>()?.is_none() {
                return Ok(());
            }
        }
        list.next_element_seed(WalkTo(&self.0[1..])).map(|_| ())
    }
}
