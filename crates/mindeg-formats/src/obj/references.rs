//! Numbers by which the elements of an OBJ name its vertices, texture coordinates and normals.

/// Things of one kind that an OBJ numbers: how many are defined, and which are named.
#[derive(Default)]
pub(super) struct Numbered {
    /// How many are defined so far.
    pub(super) count: u64,
    /// The greatest one named so far, counted from 1, and the line that names it.
    greatest: u64,
    line: u64,
}

impl Numbered {
    /// The index, counted from 0, of the one with this number in the file: a positive number
    /// counts from the first, a negative one back from the last so far. It may be defined later.
    pub(super) fn index(&mut self, number: i64, line: u64) -> Result<u64, Unknown> {
        let positive = match number {
            1.. => number.unsigned_abs(),
            _ => (self.count + 1)
                .checked_sub(number.unsigned_abs())
                .filter(|&positive| number != 0 && positive > 0)
                .ok_or(Unknown { line, number, count: self.count })?,
        };
        if positive > self.greatest {
            (self.greatest, self.line) = (positive, line);
        }
        Ok(positive - 1)
    }

    /// At the end of the file: the greatest one named, if it has not been defined.
    pub(super) fn unknown(&self) -> Option<Unknown> {
        // A number is an i64.
        let number = self.greatest as i64;
        (self.greatest > self.count).then_some(Unknown {
            line: self.line,
            number,
            count: self.count,
        })
    }
}

/// A number that names nothing.
#[derive(Clone, Copy)]
pub(super) struct Unknown {
    pub(super) line: u64,
    number: i64,
    /// How many there were to name.
    count: u64,
}

impl Unknown {
    /// The error in words, for things of this kind.
    pub(super) fn message(&self, what: &str) -> String {
        let Self { number, count, .. } = self;
        match number {
            0 => format!("{what} 0 does not exist; numbers start at 1"),
            1.. => format!("{what} {number} does not exist; the file has {count}"),
            _ => format!("{what} {number} does not exist; the file has {count} up to this line"),
        }
    }
}

/// The whole number that a word starts with, and the rest of the word; none if it starts with
/// something else, or if the number is beyond 64 bits.
pub(super) fn leading_number(word: &[u8]) -> Option<(i64, &[u8])> {
    let (is_negative, digits) = match word {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] => (false, rest),
        _ => (false, word),
    };
    let mut number = 0_i64;
    let mut len = 0;
    for &byte in digits {
        let digit = byte.wrapping_sub(b'0');
        if digit > 9 {
            break;
        }
        // Downwards, since there is one more negative number.
        number = number.checked_mul(10)?.checked_sub(i64::from(digit))?;
        len += 1;
    }
    let number = if is_negative { number } else { number.checked_neg()? };
    (len > 0).then_some((number, &digits[len..]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_to_their_last_digit() {
        for (word, expected) in [
            ("", None),
            ("-", None),
            ("x1", None),
            ("/1", None),
            ("1", Some((1, ""))),
            ("-12/3", Some((-12, "/3"))),
            ("+7x", Some((7, "x"))),
            ("9223372036854775807", Some((i64::MAX, ""))),
            ("-9223372036854775808", Some((i64::MIN, ""))),
            ("9223372036854775808", None),
            ("-9223372036854775809", None),
        ] {
            let expected = expected.map(|(number, rest): (_, &str)| (number, rest.as_bytes()));
            assert_eq!(leading_number(word.as_bytes()), expected, "{word:?}");
        }
    }
}
