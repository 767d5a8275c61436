//! Decimals as text, fast where they come again.
//!
//! Limits: only the last one is kept, which does for points in the order of sides.

/// Decimals of one coordinate after another, each after a space.
///
/// The last one is kept: along a side that is parallel to an axis, one coordinate stays the same.
pub(crate) struct Decimals<F> {
    last: Option<F>,
    text: Text<LONGEST_DECIMAL>,
    digits: zmij::Buffer,
}

/// How long a decimal can get: a space, a sign, 17 digits with a point, and `e-308`; longer by what
/// makes copying all of it as fast as it gets.
const LONGEST_DECIMAL: usize = 32;

/// A short text. Appending it copies all `N` bytes, which is fast since their number is known, and
/// takes back those too many.
#[derive(Clone, Copy)]
pub(crate) struct Text<const N: usize> {
    bytes: [u8; N],
    len: usize,
}

impl<const N: usize> Text<N> {
    pub(crate) const EMPTY: Self = Self { bytes: [0; N], len: 0 };

    pub(crate) fn push(&mut self, text: &[u8]) {
        self.bytes[self.len..][..text.len()].copy_from_slice(text);
        self.len += text.len();
    }

    pub(crate) fn append_to(&self, buffer: &mut Vec<u8>) {
        let end = buffer.len() + self.len;
        buffer.extend_from_slice(&self.bytes);
        buffer.truncate(end);
    }
}

impl<F> Default for Decimals<F> {
    fn default() -> Self {
        Self { last: None, text: Text::EMPTY, digits: zmij::Buffer::new() }
    }
}

impl<F: zmij::Float + PartialEq> Decimals<F> {
    pub(crate) fn new() -> Self {
        Self::default()
    }

    /// Appends a finite number that is not -0: the shortest decimal that reads back the same.
    pub(crate) fn push(&mut self, value: F, buffer: &mut Vec<u8>) {
        self.keep(value);
        self.text.append_to(buffer);
    }

    /// [`push`](Self::push), for the first of a line: without the space.
    pub(crate) fn push_first(&mut self, value: F, buffer: &mut Vec<u8>) {
        self.keep(value);
        buffer.extend_from_slice(&self.text.bytes[1..self.text.len]);
    }

    fn keep(&mut self, value: F) {
        if self.last != Some(value) {
            let number = self.digits.format_finite(value);
            let number = number.strip_suffix(".0").unwrap_or(number);
            self.text = Text::EMPTY;
            self.text.push(b" ");
            self.text.push(number.as_bytes());
            self.last = Some(value);
        }
    }
}

/// Appends a whole number after a space.
pub(crate) fn push_integer(value: impl itoa::Integer, buffer: &mut Vec<u8>) {
    buffer.push(b' ');
    push_digits(value, buffer);
}

/// Appends the digits of a whole number.
pub(crate) fn push_digits(value: impl itoa::Integer, buffer: &mut Vec<u8>) {
    buffer.extend_from_slice(itoa::Buffer::new().format(value).as_bytes());
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_come_again_as_they_are() {
        let mut decimals = Decimals::new();
        let mut text = Vec::new();
        for value in [0.0, 0.0, 1.5, 1.5, 0.1, 1e300, 1e300, -2.0, -5e-324] {
            decimals.push(value, &mut text);
        }
        decimals.push_first(2.5, &mut text);
        assert_eq!(String::from_utf8_lossy(&text), " 0 0 1.5 1.5 0.1 1e+300 1e+300 -2 -5e-3242.5");
    }
}
