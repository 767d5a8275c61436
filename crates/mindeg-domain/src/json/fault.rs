//! The errors of serde, in sentences for people who write JSON by hand.

use std::fmt;

use serde::de::{Error, Expected, Unexpected};

use crate::error::Step;

/// An error of serde.
#[derive(Debug)]
pub(super) struct Fault {
    pub(super) message: String,
    /// The start of the value, once known.
    pub(super) at: Option<usize>,
    /// The way to it, innermost first.
    pub(super) steps: Vec<Step>,
    /// Whether the message must begin with the value found instead.
    pub(super) is_expectation: bool,
    /// The key that it is about, if that comes after the start of its object.
    pub(super) key: Option<String>,
}

impl Fault {
    pub(super) fn new(message: String) -> Self {
        Self { message, at: None, steps: Vec::new(), is_expectation: false, key: None }
    }

    pub(super) fn expected(expected: String) -> Self {
        Self { is_expectation: true, ..Self::new(expected) }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Fault {}

impl Error for Fault {
    fn custom<T: fmt::Display>(message: T) -> Self {
        Self::new(message.to_string())
    }

    fn invalid_type(_: Unexpected<'_>, expected: &dyn Expected) -> Self {
        let theirs = expected.to_string();
        Self::expected(match &*theirs {
            "f64" | "f32" => "a number".to_owned(),
            "u32" | "u64" | "usize" => "a whole number".to_owned(),
            "a string" => "a text in double quotes".to_owned(),
            "a boolean" => "true or false".to_owned(),
            "a sequence" => "a list".to_owned(),
            "a sequence of 2 f64 values" => "a pair [x, y] of numbers".to_owned(),
            "a sequence of 3 f64 values" => "a triple [x, y, z] of numbers".to_owned(),
            "struct variant" | "newtype variant" => "an object with this key".to_owned(),
            _ if theirs.starts_with("struct ") => "an object".to_owned(),
            _ => theirs.replace("an array of length", "a list of"),
        })
    }

    fn invalid_value(found: Unexpected<'_>, expected: &dyn Expected) -> Self {
        Self::invalid_type(found, expected)
    }

    fn invalid_length(_: usize, expected: &dyn Expected) -> Self {
        Self::invalid_type(Unexpected::Seq, expected)
    }

    fn unknown_variant(_: &str, allowed: &'static [&'static str]) -> Self {
        Self::expected(one_of(allowed))
    }

    fn unknown_field(key: &str, allowed: &'static [&'static str]) -> Self {
        if key == "fixed" && allowed.contains(&"size_inside") {
            return Self::new(
                "\"fixed\" is now \"lines\" and \"points\" of the domain, beside \"interior\""
                    .to_owned(),
            );
        }
        let key = shortened(&format!("{key:?}"));
        Self::new(format!("unknown key {key}; allowed: {}", quoted(allowed).join(", ")))
    }

    fn missing_field(key: &'static str) -> Self {
        Self::new(format!("the key {key:?} is missing"))
    }

    fn duplicate_field(key: &'static str) -> Self {
        let message = format!("the key {key:?} comes twice; give it once");
        Self { key: Some(key.to_owned()), ..Self::new(message) }
    }
}

pub(super) fn quoted(names: &[&str]) -> Vec<String> {
    names.iter().map(|name| format!("{name:?}")).collect()
}

pub(super) fn one_of(names: &[&str]) -> String {
    let names = quoted(names);
    match names.split_last() {
        Some((last, first)) if !first.is_empty() => format!("{} or {last}", first.join(", ")),
        _ => names.concat(),
    }
}

/// A text for a message, cut where it is long.
pub(super) fn shortened(text: &str) -> String {
    const LONGEST: usize = 40;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}
