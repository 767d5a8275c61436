//! A file in memory, read from front to back as words, lines and bytes.

use crate::ReadError;
use crate::numbers::Numbers;
use crate::words::number;
use glam::DVec3;

/// The place in a file up to which it has been read.
pub(crate) struct Scanner<'a> {
    bytes: &'a [u8],
    at: usize,
    /// Whether numbers are bytes, and in which order.
    pub(crate) encoding: Numbers,
}

impl<'a> Scanner<'a> {
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, at: 0, encoding: Numbers::Text }
    }

    /// How many bytes have been read.
    pub(crate) fn offset(&self) -> usize {
        self.at
    }

    /// Goes on at an offset, or at the end if that is before it.
    pub(crate) fn go_to(&mut self, offset: usize) {
        self.at = offset.min(self.bytes.len());
    }

    /// The bytes that remain.
    pub(crate) fn rest(&self) -> &'a [u8] {
        &self.bytes[self.at..]
    }

    /// An error at this place: by its line in a text, else by its byte.
    pub(crate) fn problem(&self, problem: impl Into<String>) -> ReadError {
        match self.encoding {
            Numbers::Text => {
                let line_ends = memchr::memchr_iter(b'\n', &self.bytes[..self.at]).count();
                ReadError::line(line_ends as u64 + 1, problem)
            }
            _ => ReadError::byte(self.at, problem),
        }
    }

    /// [`problem`](Self::problem), at a place before this one.
    pub(crate) fn problem_at(&self, offset: usize, problem: impl Into<String>) -> ReadError {
        Self { bytes: self.bytes, at: offset.min(self.at), encoding: self.encoding }
            .problem(problem)
    }

    /// The next word of a text; none at the end.
    pub(crate) fn word(&mut self) -> Option<&'a [u8]> {
        let rest = self.rest();
        let start = rest.iter().position(|byte| !byte.is_ascii_whitespace())?;
        let rest = &rest[start..];
        let len = rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
        self.at += start + len;
        Some(&rest[..len])
    }

    /// The rest of the line without its end, which is read too; none at the end of the file.
    pub(crate) fn line(&mut self) -> Option<&'a [u8]> {
        let rest = self.rest();
        if rest.is_empty() {
            return None;
        }
        let end = memchr::memchr(b'\n', rest);
        self.at += end.map_or(rest.len(), |end| end + 1);
        let line = &rest[..end.unwrap_or(rest.len())];
        Some(line.strip_suffix(b"\r").unwrap_or(line))
    }

    /// So many bytes, which are to be `what`.
    pub(crate) fn take(&mut self, len: usize, what: &str) -> Result<&'a [u8], ReadError> {
        let taken = self.rest().get(..len);
        let taken = taken.ok_or_else(|| {
            let left = self.rest().len();
            self.problem(format!("{what} should take {len} bytes; the file has {left} more"))
        })?;
        self.at += len;
        Ok(taken)
    }

    /// The bytes of `count` items of `len` bytes each, which are to be `what`.
    pub(crate) fn take_items(
        &mut self,
        count: u64,
        len: usize,
        what: &str,
    ) -> Result<&'a [u8], ReadError> {
        let bytes = usize::try_from(count).ok().and_then(|count| count.checked_mul(len));
        let bytes = bytes.ok_or_else(|| {
            self.problem(format!("the file cannot hold {count} {what} of {len} bytes each"))
        })?;
        self.take(bytes, what)
    }

    /// A number of 4 bytes, or the next word.
    pub(crate) fn int(&mut self, what: &str) -> Result<i64, ReadError> {
        match self.encoding {
            Numbers::Text => self.parsed(what, "a whole number"),
            _ => self.array(what).map(i32::from_le_bytes).map(i64::from),
        }
    }

    /// A number of 8 bytes, 0 or more, or the next word.
    pub(crate) fn size(&mut self, what: &str) -> Result<u64, ReadError> {
        match self.encoding {
            Numbers::Text => self.parsed(what, "a whole number, 0 or more"),
            _ => self.array(what).map(u64::from_le_bytes),
        }
    }

    /// A number of 8 bytes, or the next word. It need not be finite.
    pub(crate) fn double(&mut self, what: &str) -> Result<f64, ReadError> {
        match self.encoding {
            Numbers::Text => self.parsed(what, "a number"),
            _ => self.array(what).map(f64::from_le_bytes),
        }
    }

    /// Three finite numbers.
    pub(crate) fn point(&mut self) -> Result<DVec3, ReadError> {
        let mut point = [0.0; 3];
        for coordinate in &mut point {
            *coordinate = self.double("a coordinate")?;
            if !coordinate.is_finite() {
                return Err(self.problem(format!("a coordinate is {coordinate}")));
            }
        }
        Ok(DVec3::from_array(point))
    }

    /// Bytes of a number, the least significant first.
    fn array<const N: usize>(&mut self, what: &str) -> Result<[u8; N], ReadError> {
        let bytes = self.rest().first_chunk();
        let mut bytes: [u8; N] =
            *bytes.ok_or_else(|| self.problem(format!("the file ends within {what}")))?;
        self.at += N;
        if self.encoding == Numbers::BigEndian {
            bytes.reverse();
        }
        Ok(bytes)
    }

    /// The next word as a number.
    pub(crate) fn parsed<T: std::str::FromStr>(
        &mut self,
        what: &str,
        kind: &str,
    ) -> Result<T, ReadError> {
        let word = self.word();
        let word = word.ok_or_else(|| self.problem(format!("the file ends before {what}")))?;
        number(word).ok_or_else(|| {
            let shown = String::from_utf8_lossy(&word[..word.len().min(40)]);
            self.problem(format!("{what} is {shown:?}, which is not {kind}"))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_lines_and_bytes_follow_one_another() {
        let mut scanner = Scanner::new(b" 12 x\r\n rest of it\nabc");
        assert_eq!(scanner.int("a number").unwrap(), 12);
        assert_eq!(scanner.line(), Some(&b" x"[..]));
        assert_eq!(scanner.word(), Some(&b"rest"[..]));
        assert_eq!(scanner.line(), Some(&b" of it"[..]));
        assert_eq!(scanner.take(2, "two").unwrap(), b"ab");
        let error = scanner.take(2, "two letters").unwrap_err();
        let problem = "line 3: two letters should take 2 bytes; the file has 1 more";
        assert_eq!(error.to_string(), problem);
        let error = scanner.size("the count").unwrap_err();
        let problem = "line 3: the count is \"c\", which is not a whole number, 0 or more";
        assert_eq!(error.to_string(), problem);
        assert_eq!((scanner.word(), scanner.line()), (None, None));
        scanner.encoding = Numbers::BigEndian;
        assert_eq!(scanner.int("it").unwrap_err().to_string(), "byte 22: the file ends within it");
        let error = scanner.take_items(u64::MAX, 8, "numbers").unwrap_err().to_string();
        assert!(error.starts_with("byte 22: the file cannot hold 18446744073709551615"), "{error}");
    }

    #[test]
    fn numbers_in_bytes_have_an_order() {
        for (encoding, value) in [(Numbers::LittleEndian, 2), (Numbers::BigEndian, 1 << 25)] {
            let mut scanner = Scanner::new(&[2, 0, 0, 0]);
            scanner.encoding = encoding;
            assert_eq!(scanner.int("it").unwrap(), value);
        }
    }
}
