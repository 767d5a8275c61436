//! The words of a line of an OBJ.

/// The words of a line, up to a comment.
pub(super) struct Words<'a>(pub(super) &'a [u8]);

impl<'a> Iterator for Words<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        let start = self.0.iter().position(|byte| !byte.is_ascii_whitespace())?;
        let rest = &self.0[start..];
        let is_end = |byte: &u8| byte.is_ascii_whitespace() || *byte == b'#';
        let end = rest.iter().position(is_end).unwrap_or(rest.len());
        let (word, rest) = rest.split_at(end);
        self.0 = rest;
        (!word.is_empty()).then_some(word)
    }
}

impl Words<'_> {
    /// The rest of the line: a name, which may hold blanks and #.
    pub(super) fn text(&self) -> String {
        String::from_utf8_lossy(self.0.trim_ascii()).into_owned()
    }
}
