//! Words and numbers of text formats.

use std::str::FromStr;

/// The words of a line, between white space.
pub(crate) fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty())
}

/// A word as a number; `None` if it does not parse.
pub(crate) fn number<T: FromStr>(word: &[u8]) -> Option<T> {
    std::str::from_utf8(word).ok()?.parse().ok()
}

/// A number that is neither infinite nor NaN. Fortran's exponents (`1.5D+03`) count too.
pub(crate) fn finite(word: &[u8]) -> Option<f64> {
    let value = number::<f64>(word).or_else(|| {
        let exponent = word.iter().position(|byte| matches!(byte, b'd' | b'D'))?;
        let mut word = word.to_vec();
        word[exponent] = b'e';
        number(&word)
    });
    value.filter(|value| value.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read() {
        for (word, value) in [
            (&b"1.5"[..], Some(1.5)),
            (b"-1e3", Some(-1000.0)),
            (b"1.5D+03", Some(1500.0)),
            (b"2d0", Some(2.0)),
            (b"inf", None),
            (b"NaN", None),
            (b"1e999", None),
            (b"", None),
            (b"d", None),
            (b"1,5", None),
        ] {
            assert_eq!(finite(word), value, "{:?}", word.escape_ascii());
        }
        assert!(words(b" 1\t 2  3 ").eq([b"1", b"2", b"3"]));
    }
}
