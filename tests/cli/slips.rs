//! The answers to likely slips: the whole message.

use crate::pinned;
use crate::run::{mindeg, mindeg_reading};

/// Arguments separated by spaces, `"` for one that has spaces; and the message up to the first empty line.
const SLIPS: &str = "tests/cli/slips.txt";

/// The arguments of a line, as a shell sees them.
fn words(line: &str) -> Vec<&str> {
    let mut words = Vec::new();
    for (i, quoted) in line.split('"').enumerate() {
        if i % 2 == 0 { words.extend(quoted.split_whitespace()) } else { words.push(quoted) }
    }
    words
}

#[test]
fn pinned_slips_are_answered_with_what_was_meant() {
    pinned::check(SLIPS, |line| {
        let run = mindeg(words(line));
        assert_eq!(run.code, Some(2), "{line}: {run:?}");
        let (first, _) = run.errors.split_once("\n\n").unwrap_or((run.errors.trim_end(), ""));
        first.strip_prefix("error: ").unwrap_or(first).to_owned()
    });
}

#[test]
fn no_message_has_words_of_the_libraries() {
    let foreign = [
        "invalid digit",
        "too large to fit",
        "from empty string",
        "invalid float",
        "os error",
        "EOF while",
        ".part",
        "expected struct",
    ];
    let lines = [
        "suggest 3,3,3 --limit x",
        "inspect a.obj --poles-above x",
        "mesh no/such.json -o x.obj",
        "mesh --rectangle 4x3 --size 1 -o no/such/x.obj",
        "degree ,",
        "inspect no.obj",
        "mesh --rectangle 4x3 --size 1 -o /proc/x.obj",
        "mesh --rectangle 4x3 --size= -o x.obj",
    ];
    let slips = pinned::inputs(include_str!("slips.txt"));
    for line in lines.into_iter().chain(slips.iter().map(String::as_str)) {
        let run = mindeg(words(line));
        assert!(matches!(run.code, Some(1 | 2)), "{line}: {run:?}");
        for word in foreign {
            assert!(!run.errors.contains(word), "{line}: {}", run.errors);
        }
    }
    for empty in ["", " \n"] {
        mindeg_reading(["tradeoff", "-"], empty.as_bytes()).refuses(&["standard input is empty"]);
    }
}
