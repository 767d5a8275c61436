//! The bytes of a binary file, with errors that name the offset.

use crate::ReadError;
use std::io::{self, BufRead, ErrorKind};

/// The bytes of a file from front to back.
pub(crate) struct Bytes<R> {
    input: R,
    offset: u64,
}

impl<R: BufRead> Bytes<R> {
    /// The bytes that follow the first `offset` bytes of a file.
    pub(crate) fn new(input: R, offset: u64) -> Self {
        Self { input, offset }
    }

    /// An error at this offset.
    pub(crate) fn problem(&self, problem: impl Into<String>) -> ReadError {
        ReadError::byte(self.offset, problem)
    }

    /// Reads as many bytes as `out` holds, which are to be `what`.
    pub(crate) fn fill(&mut self, out: &mut [u8], what: &str) -> Result<(), ReadError> {
        self.input.read_exact(out).map_err(|error| match error.kind() {
            ErrorKind::UnexpectedEof => self.problem(format!("the file ends within {what}")),
            _ => error.into(),
        })?;
        self.offset += out.len() as u64;
        Ok(())
    }

    /// Whether the file ends here.
    pub(crate) fn is_at_end(&mut self) -> Result<bool, ReadError> {
        Ok(!has_more(&mut self.input)?)
    }
}

/// Whether an input goes on; if so, its buffer holds some of it. A signal neither ends it nor is an error.
pub(crate) fn has_more(input: &mut impl BufRead) -> io::Result<bool> {
    loop {
        match input.fill_buf() {
            Err(error) if error.kind() == ErrorKind::Interrupted => {}
            buffer => return Ok(!buffer?.is_empty()),
        }
    }
}
