//! The lines of a DXF, two and two.

use super::super::text::{at_line, lines, quoted};
use crate::error::OutlineError;

/// A group code, its value, and the line of the code.
#[derive(Clone, Copy)]
pub(super) struct Pair<'a> {
    pub(super) line: u64,
    pub(super) code: i32,
    pub(super) value: &'a str,
}

/// The pairs of lines.
pub(super) fn pairs(text: &str) -> impl Iterator<Item = Result<Pair<'_>, OutlineError>> {
    let mut lines = lines(text.strip_prefix('\u{feff}').unwrap_or(text));
    std::iter::from_fn(move || {
        let (line, code) = lines.next()?;
        let code = code.trim();
        let Some((_, value)) = lines.next() else {
            // A blank line at the end does not begin a pair.
            let is_end = code.is_empty();
            return (!is_end).then(|| Err(at_line(line, "the file ends within a pair of lines")));
        };
        Some(match code.parse() {
            Ok(code) => Ok(Pair { line, code, value: value.trim() }),
            Err(_) => Err(at_line(line, format!("found {}, expected a group code", quoted(code)))),
        })
    })
}
