//! Faults of a JSON document, in words for people who have the file and not its reader.

use serde_json::Error;
use serde_json::error::Category;

/// Says what the parser found.
pub(super) fn problem(error: &Error) -> String {
    let place = format!("line {}, column {}", error.line().max(1), error.column().max(1));
    match error.classify() {
        Category::Eof => format!("the JSON text ends too early, in {place}: the file is not whole"),
        Category::Syntax | Category::Io => format!("this is not JSON, in {place}"),
        Category::Data => format!("{}, in {place}", unfit(error)),
    }
}

/// The fault of a value that is JSON and does not fit.
fn unfit(error: &Error) -> String {
    let message = error.to_string();
    let message = message.rsplit_once(" at line ").map_or(&*message, |(message, _)| message);
    if let Some(key) = quoted(message, "missing field ") {
        return format!("the key \"{key}\" is missing");
    }
    if let Some(key) = quoted(message, "duplicate field ") {
        return format!("the key \"{key}\" is given twice");
    }
    if let Some(length) = message.strip_prefix("invalid length ") {
        return format!("found an array of length {length}");
    }
    let found = message.strip_prefix("invalid type: ").or(message.strip_prefix("invalid value: "));
    match found.and_then(|found| found.rsplit_once(", expected ")) {
        Some((found, expected)) => {
            format!("found {}, expected {}", value(found), wanted(expected))
        }
        None => message.to_owned(),
    }
}

/// The text in backticks behind some words.
fn quoted<'a>(message: &'a str, words: &str) -> Option<&'a str> {
    message.strip_prefix(words)?.strip_prefix('`')?.strip_suffix('`')
}

fn value(found: &str) -> String {
    match found {
        "map" => "an object".to_owned(),
        "sequence" => "an array".to_owned(),
        _ => match quoted(found, "integer ").or(quoted(found, "floating point ")) {
            Some(number) => format!("the number {number}"),
            None => found.replace("string ", "the text ").replace("boolean ", ""),
        },
    }
}

fn wanted(expected: &str) -> &str {
    match expected {
        "u8" | "u16" | "u32" | "u64" | "usize" => "a whole number",
        "f32" | "f64" => "a number",
        "a sequence" => "an array",
        "a map" => "an object",
        "a string" => "a text",
        "a boolean" => "true or false",
        _ if expected.starts_with("struct ") => "an object",
        _ => expected,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde::Deserialize;

    #[derive(Debug, Deserialize)]
    #[expect(dead_code, reason = "only errors are looked at")]
    struct Part {
        count: u32,
        names: Vec<String>,
        share: f64,
    }

    #[test]
    fn no_word_is_the_parsers() {
        for (text, expected) in [
            ("", "the JSON text ends too early, in line 1, column 1: the file is not whole"),
            (
                "{\n \"count\": ",
                "the JSON text ends too early, in line 2, column 10: the file is not whole",
            ),
            ("v 0 0 0", "this is not JSON, in line 1, column 1"),
            ("{}", "the key \"count\" is missing, in line 1, column 2"),
            (
                r#"{"count": -1}"#,
                "found the number -1, expected a whole number, in line 1, column 12",
            ),
            (
                r#"{"count": 1.5}"#,
                "found the number 1.5, expected a whole number, in line 1, column 13",
            ),
            (
                r#"{"count": "7"}"#,
                "found the text \"7\", expected a whole number, in line 1, column 13",
            ),
            (
                r#"{"count": 1, "count": 2}"#,
                "the key \"count\" is given twice, in line 1, column 20",
            ),
            (r#"{"names": {}}"#, "found an object, expected an array, in line 1, column 10"),
            (r#"{"names": [true]}"#, "found `true`, expected a text, in line 1, column 15"),
            (r#"{"share": []}"#, "found an array, expected a number, in line 1, column 10"),
            ("7", "found the number 7, expected an object, in line 1, column 1"),
        ] {
            let error = serde_json::from_str::<Part>(text).unwrap_err();
            assert_eq!(problem(&error), expected, "{error}");
        }
    }
}
