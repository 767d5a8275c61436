//! Text formats: lines, words and numbers, with the line in every error.

use std::collections::BTreeMap;

use glam::DVec2;

use crate::error::OutlineError;

/// The text of a file, without the mark that some programs put before UTF-8.
pub(super) fn text_of(bytes: &[u8]) -> Result<&str, OutlineError> {
    match std::str::from_utf8(bytes) {
        Ok(text) => Ok(text.strip_prefix('\u{feff}').unwrap_or(text)),
        Err(error) => Err(OutlineError::place(
            format!("byte {}", error.valid_up_to()),
            "this is not UTF-8 text; save the file as UTF-8 text",
        )),
    }
}

/// The lines and their numbers from 1.
pub(super) fn lines(text: &str) -> impl Iterator<Item = (u64, &str)> {
    (1..).zip(text.lines())
}

pub(super) fn at_line(line: u64, problem: impl Into<String>) -> OutlineError {
    OutlineError::place(format!("line {line}"), problem)
}

/// A finite number.
pub(super) fn number(word: &str) -> Option<f64> {
    word.parse().ok().filter(|number: &f64| number.is_finite())
}

/// A word as a message shows it: in quotes, not longer than a line.
pub(super) fn quoted(word: &str) -> String {
    const LONGEST: usize = 40;
    match word.char_indices().nth(LONGEST) {
        None => format!("{word:?}"),
        Some((end, _)) => format!("{:?}…", &word[..end]),
    }
}

/// A point as a message shows it.
pub(super) fn shown(point: DVec2) -> String {
    mindeg_mesh::place(point)
}

/// Such as "1 line" or "3 lines".
pub(super) fn counted(count: usize, one: &str) -> String {
    if count == 1 { format!("1 {one}") } else { format!("{count} {one}s") }
}

/// Kinds with their numbers, such as "1 line, 3 points"; empty without any.
pub(super) fn counted_all<K: AsRef<str>>(counts: &BTreeMap<K, usize>) -> String {
    let kinds: Vec<String> =
        counts.iter().map(|(kind, &count)| counted(count, kind.as_ref())).collect();
    kinds.join(", ")
}

/// A name without the characters that a domain refuses and a terminal obeys.
pub(super) fn clean(name: &str) -> String {
    let is_refused = |c: char| {
        c.is_control()
            || matches!(c, '\u{2028}' | '\u{2029}' | '\u{61c}' | '\u{200e}' | '\u{200f}')
            || matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
    };
    name.replace(is_refused, " ").trim().to_owned()
}
