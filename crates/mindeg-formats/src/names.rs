//! Names as files can hold them: the one home of what a format cannot take.
//!
//! A mesh, its groups, lines and materials may be called anything. Every writer passes every name
//! through one of these functions. Formats with strings of their own escape them there: JSON in glTF.

use std::collections::hash_map::Entry;
use std::collections::{HashMap, HashSet};
use std::ops::RangeInclusive;

use crate::WriteError;

/// A name in one line of a text: blanks for control characters and line breaks, and the replacement
/// character for the two that XML cannot hold (U+FFFE and U+FFFF).
///
/// # Example
///
/// ```
/// assert_eq!(mindeg_formats::one_line("left\nside\u{ffff}"), "left side\u{fffd}");
/// ```
#[must_use]
pub fn one_line(name: &str) -> String {
    let held = |letter: char| match letter {
        '\u{2028}' | '\u{2029}' => ' ',
        '\u{fffe}' | '\u{ffff}' => char::REPLACEMENT_CHARACTER,
        letter if letter.is_control() => ' ',
        letter => letter,
    };
    name.chars().map(held).collect()
}

/// A name as one word of a line, which is never empty: underscores for white space, where many readers
/// end a name, and for a backslash at the end, which would join the next line to this one.
pub(crate) fn word(name: &str) -> String {
    let mut word = one_line(name).split_whitespace().collect::<Vec<_>>().join("_");
    if word.is_empty() || word.ends_with('\\') {
        word.pop();
        word.push('_');
    }
    word
}

/// A name to stand between double quotes in a line, which is never blank. Gmsh takes 127 characters;
/// this leaves some for a number.
pub(crate) fn quoted(name: &str) -> String {
    const LONGEST: usize = 120;
    let quoted: String = one_line(name).replace('"', "'").chars().take(LONGEST).collect();
    if quoted.trim().is_empty() { "_".to_owned() } else { quoted }
}

/// A name as the text of an XML element.
pub(crate) fn xml(name: &str) -> String {
    one_line(name).replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// The word before the number of a marker of Triangle in the name of a side.
pub(crate) const MARKER: &str = "marker";
/// The word before the number of an attribute of Triangle in the name of a group.
pub(crate) const REGION: &str = "region";
/// The word before the tag of a physical group of MSH that has no name.
pub(crate) const PHYSICAL: &str = "physical";

/// A number for each name, all different: N of `N`, or of `marker N` if that is one of the words, where N is allowed and not 0, and no name
/// before has it; else the least ones from 1 on that are left. O(n) time.
pub(crate) fn numbers<'a>(
    names: impl IntoIterator<Item = &'a str>,
    words: &[&str],
    allowed: RangeInclusive<i64>,
) -> Vec<i64> {
    let mut taken = HashSet::from([0]);
    let own = |name: &'a str| {
        let word = words.iter().find_map(|word| name.strip_prefix(word)?.strip_prefix(' '));
        let text = word.unwrap_or(name);
        let number: i64 = text.parse().ok().filter(|number| allowed.contains(number))?;
        // A number has one spelling: `07` is none.
        (number.to_string() == text && taken.insert(number)).then_some(number)
    };
    let own: Vec<Option<i64>> = names.into_iter().map(own).collect();
    let mut free = (1..).filter(|number| !taken.contains(number));
    own.into_iter().map(|own| own.or_else(|| free.next()).unwrap_or(1)).collect()
}

/// Refuses the name of a file beside this one that a text cannot hold: with line breaks or other
/// control characters, or with the character that stands for bytes that are not UTF-8.
pub(crate) fn check_file_name(name: &str) -> Result<(), WriteError> {
    let is_held = |letter: char| !letter.is_control() && letter != char::REPLACEMENT_CHARACTER;
    if name.chars().all(is_held) {
        return Ok(());
    }
    Err(WriteError::Refused(format!(
        "the file would have to name {name:?} beside it, which is not UTF-8 or has control \
         characters; write it under another name"
    )))
}

/// The names that a file has so far, all different: a second one gets a number.
#[derive(Debug, Default)]
pub(crate) struct Names {
    /// Each name, and the number that was last added to it.
    taken: HashMap<String, u32>,
    /// The name in the file for each name in the mesh that [`of`](Self::of) was asked for.
    of: HashMap<String, String>,
    /// Whether the format takes upper and lower case for the same.
    folds_case: bool,
}

impl Names {
    /// For a format that takes upper and lower case for the same.
    pub(crate) fn folding_case() -> Self {
        Self { folds_case: true, ..Self::default() }
    }

    /// The name in the file for a name in the mesh: the same each time, and never that of another
    /// name. `made` makes a name of the format.
    pub(crate) fn of(&mut self, name: &str, made: impl FnOnce(&str) -> String) -> String {
        if let Some(found) = self.of.get(name) {
            return found.clone();
        }
        let found = self.distinct(made(name));
        self.of.insert(name.to_owned(), found.clone());
        found
    }

    /// The name, if the file does not have it yet; else the name with `_2`, `_3` or the first
    /// number that makes a new one. O(1), but where made names meet others.
    pub(crate) fn distinct(&mut self, name: String) -> String {
        let folds_case = self.folds_case;
        let key = |name: &str| if folds_case { name.to_lowercase() } else { name.to_owned() };
        let wanted = key(&name);
        if let Entry::Vacant(free) = self.taken.entry(wanted.clone()) {
            free.insert(1);
            return name;
        }
        loop {
            let number = self.taken.entry(wanted.clone()).or_default();
            *number += 1;
            let made = format!("{name}_{number}");
            if let Entry::Vacant(free) = self.taken.entry(key(&made)) {
                free.insert(1);
                return made;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_come_again_get_numbers() {
        let mut names = Names::default();
        let wanted = ["a", "b", "a", "a", "a_2", "a_5", "a", "a", "b_2", "b"];
        let made = wanted.map(|name| names.distinct(name.to_owned()));
        assert_eq!(made, ["a", "b", "a_2", "a_3", "a_2_2", "a_5", "a_4", "a_6", "b_2", "b_3"]);
    }

    #[test]
    fn numbers_are_those_of_names_and_differ() {
        let of =
            |names: &[&str], allowed| numbers(names.iter().copied(), &[MARKER, PHYSICAL], allowed);
        let names = ["wall", "marker 2", "2", "physical 5", "physical 2", "region 9", "marker 5"];
        assert_eq!(of(&names, i64::MIN..=i64::MAX), [1, 2, 3, 5, 4, 6, 7]);
        let names = ["marker -4", "marker 0", "9", "10", "07", "marker  7", "marker 7x", "+7", ""];
        assert_eq!(of(&names, i64::MIN..=i64::MAX), [-4, 1, 9, 10, 2, 3, 4, 5, 6]);
        assert_eq!(of(&names, 1..=9), [1, 2, 9, 3, 4, 5, 6, 7, 8]);
        assert_eq!(of(&["99999999999999999999"], i64::MIN..=i64::MAX), [1]);
    }

    #[test]
    fn words_end_no_line_and_join_none() {
        for (name, expected) in [
            ("st\\", "st_"),
            ("C:\\parts\\ ", "C:\\parts_"),
            ("a\\\u{2028}", "a_"),
            ("\\", "_"),
            ("", "_"),
            (" \n", "_"),
            ("a b\rc", "a_b_c"),
            ("\u{fffe}", "\u{fffd}"),
        ] {
            assert_eq!(word(name), expected, "{name:?}");
        }
    }

    #[test]
    fn names_that_differ_stay_different() {
        let mut names = Names::default();
        let made = ["a\"", "a'", "a\"", "a'"].map(|name| names.of(name, quoted));
        assert_eq!(made, ["a'", "a'_2", "a'", "a'_2"]);
        let mut names = Names::folding_case();
        let made = ["Wall", "wall", "WALL"].map(|name| names.of(name, word));
        assert_eq!(made, ["Wall", "wall_2", "WALL_3"]);
    }
}
