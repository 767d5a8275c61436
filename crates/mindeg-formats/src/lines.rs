//! The lines of a text file, one at a time.

use crate::bytes::has_more;
use memchr::memchr2;
use std::io::{self, BufRead, ErrorKind};

/// The longest line that is read, in bytes, with the lines that continue it. A face of 700,000
/// corners fits.
const LONGEST: usize = 1 << 24;

/// The lines of a text, ended by LF, CR LF or CR.
pub(crate) struct Lines<R> {
    input: R,
    line: Vec<u8>,
    number: u64,
    /// Whether the line before ended in a CR, so that an LF right after it belongs to it.
    after_return: bool,
    /// Whether a line that ends in a backslash goes on in the next.
    continues: bool,
}

impl<R: BufRead> Lines<R> {
    pub(crate) fn new(input: R) -> Self {
        Self { input, line: Vec::new(), number: 0, after_return: false, continues: false }
    }

    /// A line that ends in a backslash goes on in the next, as in OBJ.
    pub(crate) fn with_continued_lines(self) -> Self {
        Self { continues: true, ..self }
    }

    /// The next line without its end, and its number, counted from 1; none after the last. The
    /// number of a line that goes on is that of its last part.
    pub(crate) fn next(&mut self) -> io::Result<Option<(u64, &[u8])>> {
        self.line.clear();
        let mut found = false;
        while self.append_line()? {
            found = true;
            match self.line.last_mut() {
                Some(last @ b'\\') if self.continues => *last = b' ',
                _ => break,
            }
        }
        // Other programs write this mark at the start of a file in UTF-8.
        let mark: &[u8] = if self.number == 1 { b"\xef\xbb\xbf" } else { b"" };
        let line = self.line.strip_prefix(mark).unwrap_or(&self.line);
        Ok(found.then_some((self.number, line)))
    }

    /// Appends one line of the file without its end; false after the last.
    fn append_line(&mut self) -> io::Result<bool> {
        let mut found = false;
        loop {
            if !has_more(&mut self.input)? {
                self.number += u64::from(found);
                return Ok(found);
            }
            let buffer = self.input.fill_buf()?;
            let skipped = usize::from(self.after_return && buffer[0] == b'\n');
            self.after_return = false;
            let rest = &buffer[skipped..];
            let end = memchr2(b'\n', b'\r', rest);
            let text = &rest[..end.unwrap_or(rest.len())];
            if self.line.len() + text.len() > LONGEST {
                let message = format!(
                    "line {} is longer than {} MiB; is it a text file?",
                    self.number + 1,
                    LONGEST >> 20
                );
                return Err(io::Error::new(ErrorKind::InvalidData, message));
            }
            self.line.try_reserve(text.len())?;
            self.line.extend_from_slice(text);
            found |= !rest.is_empty();
            let consumed = skipped + text.len() + usize::from(end.is_some());
            if let Some(end) = end {
                self.after_return = rest[end] == b'\r';
                self.input.consume(consumed);
                self.number += 1;
                return Ok(true);
            }
            self.input.consume(consumed);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::BufReader;

    /// The lines, read with a buffer of so many bytes.
    fn lines(text: &str, buffer: usize) -> Vec<(u64, String)> {
        let mut lines =
            Lines::new(BufReader::with_capacity(buffer, text.as_bytes())).with_continued_lines();
        let mut found = Vec::new();
        while let Some((number, line)) = lines.next().unwrap() {
            found.push((number, String::from_utf8(line.to_vec()).unwrap()));
        }
        found
    }

    #[test]
    fn lines_end_in_every_way() {
        for (text, expected) in [
            ("", &[][..]),
            ("\n", &[(1, "")]),
            ("a", &[(1, "a")]),
            ("a\nb\n", &[(1, "a"), (2, "b")]),
            ("a\r\nb\r\n\r\nc", &[(1, "a"), (2, "b"), (3, ""), (4, "c")]),
            ("a\rb\r\rc", &[(1, "a"), (2, "b"), (3, ""), (4, "c")]),
            ("a \\\nb\nc", &[(2, "a  b"), (3, "c")]),
            ("a\\\r\nb\\\rc", &[(3, "a b c")]),
            ("a\\", &[(1, "a ")]),
            ("\u{feff}a\n\u{feff}b", &[(1, "a"), (2, "\u{feff}b")]),
        ] {
            for buffer in [1, 2, 3, 100] {
                let found = lines(text, buffer);
                let found: Vec<_> = found.iter().map(|(n, line)| (*n, line.as_str())).collect();
                assert_eq!(found, expected, "{text:?}, buffer of {buffer}");
            }
        }
    }

    #[test]
    fn a_line_without_end_is_refused() {
        let mut lines = Lines::new(BufReader::new(io::repeat(b' ')));
        let error = lines.next().unwrap_err();
        assert_eq!(error.to_string(), "line 1 is longer than 16 MiB; is it a text file?");
        let continued = b"\\\n".repeat(LONGEST + 1);
        let error = Lines::new(&continued[..]).with_continued_lines().next().unwrap_err();
        assert_eq!(error.to_string(), "line 16777217 is longer than 16 MiB; is it a text file?");
    }
}
