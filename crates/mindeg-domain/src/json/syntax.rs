//! The position where a text stops being JSON, in words for people who write it by hand.

use serde_json::error::Category;

use super::error::DomainJsonError;
use super::guess;

/// The smallest domain.
const EXAMPLE: &str = "{\"rectangle\": {\"width\": 4, \"height\": 3}, \"size\": 1}";

/// The error of a text that is not JSON, with a guess at its format.
pub(super) fn no_json(text: &str, error: &serde_json::Error) -> DomainJsonError {
    let at = |line: usize, column: usize, message| {
        let (line, column) = (line.max(1), column.max(1));
        DomainJsonError { path: String::new(), line, column, message, more: Vec::new() }
    };
    if text.trim().is_empty() {
        return at(1, 1, format!("the input is empty; give a domain in JSON, such as {EXAMPLE}"));
    }
    if let Some(format) = guess::of_text(text) {
        return at(
            1,
            1,
            format!("this looks like {format}; give a domain in JSON, such as {EXAMPLE}"),
        );
    }
    let line = text.split('\n').nth(error.line().saturating_sub(1)).unwrap_or_default();
    let found = line.as_bytes().get(error.column().saturating_sub(1)).copied();
    at(error.line(), error.column(), words(error, found))
}

/// The parser's error about the byte that it found, in our words: its own are for programmers.
fn words(error: &serde_json::Error, found: Option<u8>) -> String {
    if error.classify() == Category::Eof {
        return "the JSON text ends too early; close every {, [ and \" that is open".to_owned();
    }
    let theirs = error.to_string();
    let words = [
        ("trailing comma", "a comma without a value after it; remove it"),
        ("trailing characters", "text after the end of the domain; remove it"),
        (
            "key must be a string",
            match found {
                Some(b'}') => "a comma without a value after it; remove it",
                Some(b'0'..=b'9') => {
                    "a number after a comma, where a key is expected; write decimals with a point"
                }
                _ => "a key must stand in double quotes",
            },
        ),
        ("expected `:`", "a key must be followed by : and a value"),
        ("expected `,` or `}`", "a value must be followed by , or }"),
        ("expected `,` or `]`", "a value must be followed by , or ]"),
        (
            "control character",
            "a line break or control character in a text; remove it, or close the text before it with \"",
        ),
        ("invalid number", "this is not a JSON number; write it as 0.5, -2 or 1e-3"),
        ("invalid escape", "this \\ escape is not JSON; write \\\\ for a backslash"),
        (
            "expected",
            "this is not a JSON value; give a number, a text in double quotes, true, false, null, [ ] or { }",
        ),
    ];
    let known = words.iter().find(|(start, _)| theirs.starts_with(start));
    known.map_or("this is not JSON", |(_, ours)| ours).to_owned()
}
