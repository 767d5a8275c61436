//! Numbers in bytes or as the words of a line, and what ends the parts that they are in.

use crate::sections::Section;

/// The numbers of one record, appended to a file.
pub(super) struct Record<'a> {
    buffer: &'a mut Vec<u8>,
    is_binary: bool,
    is_first: bool,
}

impl<'a> Record<'a> {
    pub(super) fn new(is_binary: bool, buffer: &'a mut Vec<u8>) -> Self {
        Self { buffer, is_binary, is_first: true }
    }

    /// A number of 4 bytes.
    pub(super) fn int(&mut self, value: i32) -> &mut Self {
        self.put(&value.to_le_bytes(), itoa::Buffer::new().format(value))
    }

    /// A number of 8 bytes.
    pub(super) fn size(&mut self, value: u64) -> &mut Self {
        self.put(&value.to_le_bytes(), itoa::Buffer::new().format(value))
    }

    /// A finite number.
    pub(super) fn double(&mut self, value: f64) -> &mut Self {
        let value = value + 0.0;
        let mut digits = zmij::Buffer::new();
        let text = digits.format_finite(value);
        self.put(&value.to_le_bytes(), text.strip_suffix(".0").unwrap_or(text))
    }

    /// Ends the line, in text.
    pub(super) fn end(&mut self) -> &mut Self {
        if !self.is_binary {
            self.buffer.push(b'\n');
        }
        self.is_first = true;
        self
    }

    fn put(&mut self, bytes: &[u8], text: &str) -> &mut Self {
        if self.is_binary {
            self.buffer.extend_from_slice(bytes);
        } else {
            if !self.is_first {
                self.buffer.push(b' ');
            }
            self.buffer.extend_from_slice(text.as_bytes());
        }
        self.is_first = false;
        self
    }
}

/// The end of a part of the file.
pub(super) fn end_of<'a>(kind: &str, is_binary: bool) -> Section<'a> {
    let line_end = if is_binary { "\n" } else { "" };
    Section::bytes(format!("{line_end}$End{kind}\n"))
}
