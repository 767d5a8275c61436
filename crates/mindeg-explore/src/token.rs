//! Random names that no other page can guess.

use std::fmt::Write as _;

/// 32 random bytes in hexadecimal.
pub(crate) fn token() -> Result<String, getrandom::Error> {
    let mut bytes = [0; 32];
    getrandom::fill(&mut bytes)?;
    Ok(bytes.iter().fold(String::new(), |mut text, byte| {
        // Writing to a string cannot fail.
        let _ = write!(text, "{byte:02x}");
        text
    }))
}

/// Whether two tokens are the same, in a time that does not tell how much of them is.
pub(crate) fn is_same(given: &[u8], right: &[u8]) -> bool {
    let differences = given.iter().zip(right).fold(0, |all, (a, b)| all | (a ^ b));
    given.len() == right.len() && differences == 0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_same_token_is_the_same() {
        assert!(is_same(b"abcd", b"abcd"));
        // Two differences do not make up for each other.
        for given in [&b"aacd"[..], b"bacd", b"bbcd", b"abc", b"abcde", b""] {
            assert!(!is_same(given, b"abcd"), "{given:?}");
        }
        assert!(!is_same(b"bb", b"aa"));
    }
}
