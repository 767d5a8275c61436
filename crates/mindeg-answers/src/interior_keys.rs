//! The options of interior points, as forms and command lines offer them.

use mindeg::DomainDescription;
use serde::Serialize;
use serde_json::{Map, Value};

/// A key of [`mindeg::Interior`] that has one value; keys with lists of places are for files.
#[derive(Clone, Debug, Serialize)]
pub struct InteriorKey {
    /// The key in JSON.
    pub name: String,
    /// Its text in the JSON Schema, on one line.
    pub text: String,
    /// The value without it, in words.
    pub default: String,
    /// The kind of its value.
    pub value: KeyValue,
    /// The values of a choice.
    pub choices: Vec<String>,
}

/// The kind of a key's value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum KeyValue {
    /// A number.
    Number,
    /// A whole number.
    WholeNumber,
    /// Two whole numbers: the least and the greatest.
    Range,
    /// One of some words.
    Choice,
}

/// The keys of [`mindeg::Interior`] with one value, from its JSON Schema: an option more is a field more there, and
/// nothing here.
#[must_use]
pub fn interior_keys() -> Vec<InteriorKey> {
    let schema: Map<String, Value> =
        serde_json::from_str(&DomainDescription::schema()).unwrap_or_default();
    let types = schema.get("$defs").cloned().unwrap_or_default();
    let keys = types["Interior"]["properties"].as_object().cloned().unwrap_or_default();
    keys.into_iter().filter_map(|(name, schema)| key(name, &schema, &types)).collect()
}

/// A key whose value may be null, which lists are not.
fn key(name: String, schema: &Value, types: &Value) -> Option<InteriorKey> {
    let text = schema["description"].as_str().unwrap_or_default().replace('\n', " ");
    let default = text.split_once("[default: ").map_or("", |(_, rest)| rest.trim_end_matches(']'));
    let mut choices = Vec::new();
    let value = match schema["type"][0].as_str() {
        Some("number") => KeyValue::Number,
        Some("integer") => KeyValue::WholeNumber,
        Some("array") => KeyValue::Range,
        _ => {
            let choice = schema["anyOf"][0]["$ref"].as_str()?.rsplit('/').next()?;
            let words = types[choice]["oneOf"].as_array()?.iter();
            choices.extend(words.filter_map(|word| word["const"].as_str().map(str::to_owned)));
            KeyValue::Choice
        }
    };
    Some(InteriorKey { default: default.to_owned(), name, text, value, choices })
}

#[cfg(test)]
mod tests {
    use super::*;
    use mindeg::Interior;

    #[test]
    fn every_key_with_one_value_is_found() {
        let keys = interior_keys();
        let of_json = serde_json::to_value(Interior::default()).unwrap();
        let names: Vec<&str> = keys.iter().map(|key| &*key.name).collect();
        for key in of_json.as_object().unwrap().keys() {
            assert!(names.contains(&&**key), "{key}");
        }
        assert!(!names.contains(&"sizes") && !names.contains(&"fixed"));
        let prefer = keys.iter().find(|key| key.name == "prefer").unwrap();
        assert_eq!((prefer.value, &*prefer.default), (KeyValue::Choice, "degree"));
        assert_eq!(prefer.choices, ["degree", "angle"]);
        let range = keys.iter().find(|key| key.name == "interior_degree").unwrap();
        assert_eq!((range.value, &*range.default), (KeyValue::Range, "5 to 7"));
    }
}
