//! The lines of a file, by sections.

use glam::DVec3;

use super::super::text::{at_line, lines, number_at, whole_at};
use crate::error::ReadError;

/// The lines that are not blank.
pub(super) struct Rows<'a> {
    rows: Box<dyn Iterator<Item = (u64, &'a str)> + 'a>,
    pub(super) last: u64,
}

impl<'a> Rows<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        let rows = lines(text).map(|(line, text)| (line, text.trim()));
        Self { rows: Box::new(rows.filter(|(_, text)| !text.is_empty())), last: 0 }
    }

    pub(super) fn try_next(&mut self) -> Option<(u64, &'a str)> {
        let row = self.rows.next()?;
        self.last = row.0;
        Some(row)
    }

    pub(super) fn next(&mut self, what: &str) -> Result<Row<'a>, ReadError> {
        match self.try_next() {
            Some((line, text)) if !text.starts_with('$') => {
                Ok(Row { line, words: text.split_ascii_whitespace() })
            }
            ended => {
                let line = ended.map_or(self.last + 1, |(line, _)| line);
                Err(at_line(line, format!("the section ends where {what} should be")))
            }
        }
    }

    pub(super) fn skip_to_end_of(&mut self, section: &str, start: u64) -> Result<(), ReadError> {
        while let Some((_, text)) = self.try_next() {
            if text.strip_prefix("$End") == Some(section) {
                return Ok(());
            }
        }
        Err(at_line(start, format!("the section has no end: $End{section} is missing")))
    }
}

/// A line of numbers.
pub(super) struct Row<'a> {
    pub(super) line: u64,
    pub(super) words: std::str::SplitAsciiWhitespace<'a>,
}

impl Row<'_> {
    pub(super) fn whole(&mut self, what: &str) -> Result<i64, ReadError> {
        whole_at(self.line, self.words.next(), what)
    }

    pub(super) fn point(&mut self) -> Result<DVec3, ReadError> {
        let mut next = |what| number_at(self.line, self.words.next(), what);
        Ok(DVec3::new(next("x coordinate")?, next("y coordinate")?, next("z coordinate")?))
    }
}
