//! Lines of a text file as words and numbers, with errors that name the line.

use crate::ReadError;
use crate::lines::Lines;
use crate::words::{finite, number};
use glam::DVec3;
use std::io::BufRead;
use std::slice::SliceIndex;

/// The lines of a text file that say something: without comments, without blank ones.
pub(crate) struct Records<R> {
    lines: Lines<R>,
    /// The letter that starts a comment, if one does.
    comment: Option<u8>,
    /// How many lines of the file come before the first.
    before: u64,
    /// The last line: its number, and its text.
    number: u64,
    text: Vec<u8>,
}

impl<R: BufRead> Records<R> {
    pub(crate) fn new(input: R, comment: Option<u8>) -> Self {
        Self { lines: Lines::new(input), comment, before: 0, number: 0, text: Vec::new() }
    }

    /// The same lines, after some that were read before.
    pub(crate) fn after(self, before: u64) -> Self {
        Self { before, number: before, ..self }
    }

    /// Goes to the next line with words; false after the last.
    fn advance(&mut self) -> Result<bool, ReadError> {
        loop {
            let Some((number, line)) = self.lines.next()? else { return Ok(false) };
            self.number = self.before + number;
            let end = self.comment.and_then(|comment| memchr::memchr(comment, line));
            let line = line[..end.unwrap_or(line.len())].trim_ascii();
            if !line.is_empty() {
                self.text.clear();
                self.text.try_reserve(line.len())?;
                self.text.extend_from_slice(line);
                return Ok(true);
            }
        }
    }

    /// The next line as it is, also a blank one.
    pub(crate) fn next_raw(&mut self) -> Result<Option<Words<'_>>, ReadError> {
        let Some((number, line)) = self.lines.next()? else { return Ok(None) };
        self.number = self.before + number;
        self.text.clear();
        self.text.try_reserve(line.len())?;
        self.text.extend_from_slice(line);
        Ok(Some(self.words(..)))
    }

    /// The words of a part of the last line.
    pub(crate) fn words(&self, part: impl SliceIndex<[u8], Output = [u8]>) -> Words<'_> {
        Words { rest: &self.text[part], line: self.number }
    }

    /// The number of the last line.
    pub(crate) fn line(&self) -> u64 {
        self.number
    }

    /// The next line with words.
    pub(crate) fn next(&mut self) -> Result<Option<Words<'_>>, ReadError> {
        Ok(self.advance()?.then(|| self.words(..)))
    }

    /// The next line with words, which must hold `what`.
    pub(crate) fn expect(&mut self, what: &str) -> Result<Words<'_>, ReadError> {
        // Where the file ends is the line after the last.
        let line = self.number + 1;
        self.next()?.ok_or_else(|| ReadError::line(line, format!("the file ends before {what}")))
    }
}

/// The words of a line.
#[derive(Clone, Copy)]
pub(crate) struct Words<'a> {
    pub(crate) rest: &'a [u8],
    pub(crate) line: u64,
}

impl<'a> Words<'a> {
    /// The next word.
    pub(crate) fn word(&mut self) -> Option<&'a [u8]> {
        let text = self.rest.trim_ascii_start();
        let end = text.iter().position(u8::is_ascii_whitespace).unwrap_or(text.len());
        let (word, rest) = text.split_at(end);
        self.rest = rest;
        (!word.is_empty()).then_some(word)
    }

    /// Whether no word follows.
    pub(crate) fn is_empty(&self) -> bool {
        self.rest.trim_ascii().is_empty()
    }

    /// An error in this line.
    pub(crate) fn problem(&self, problem: impl Into<String>) -> ReadError {
        ReadError::line(self.line, problem)
    }

    /// The rest of the line.
    pub(crate) fn text(&self) -> String {
        String::from_utf8_lossy(self.rest.trim_ascii()).into_owned()
    }

    /// The next word as a finite number.
    pub(crate) fn number(&mut self, what: &str) -> Result<f64, ReadError> {
        self.value(what, "a finite number", finite)
    }

    /// The next word as the number of a vertex.
    pub(crate) fn id(&mut self) -> Result<u32, ReadError> {
        self.value("the number of a vertex", "a whole number of 32 bits", number)
    }

    /// The next words as x, y and a third coordinate.
    pub(crate) fn point(&mut self, third: &str) -> Result<DVec3, ReadError> {
        Ok(DVec3::new(self.number("x")?, self.number("y")?, self.number(third)?))
    }

    /// The next word as a whole number.
    pub(crate) fn integer(&mut self, what: &str) -> Result<i64, ReadError> {
        self.value(what, "a whole number", number)
    }

    /// The next word as a whole number, 0 or more.
    pub(crate) fn count(&mut self, what: &str) -> Result<u64, ReadError> {
        self.value(what, "a whole number, 0 or more", number)
    }

    fn value<T>(
        &mut self,
        what: &str,
        kind: &str,
        of_word: impl Fn(&[u8]) -> Option<T>,
    ) -> Result<T, ReadError> {
        let line = *self;
        let word = self.word().ok_or_else(|| line.problem(format!("{what} is missing")))?;
        of_word(word).ok_or_else(|| {
            let word = String::from_utf8_lossy(word);
            line.problem(format!("{what} is {word:?}, which is not {kind}"))
        })
    }
}
