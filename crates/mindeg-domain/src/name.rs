//! The names of domains, sides, faces and edges, which become groups of mesh files. Sides, holes and lines may share
//! a name: they are one group then.
//!
//! Limits: names may have any letters, but no character that ends a line, controls a terminal or
//! changes the direction of writing.

use std::collections::HashSet;

use crate::error::{DomainError, Place};

fn kind(character: char) -> &'static str {
    match character {
        '\n' | '\r' | '\u{85}' | '\u{2028}' | '\u{2029}' => "line break",
        character if turns_direction(character) => "direction mark",
        _ => "control character",
    }
}

/// The bidirectional controls of Unicode: with them a terminal shows another name than the file has.
fn turns_direction(character: char) -> bool {
    matches!(character, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// Checks a name of something at a place.
pub(crate) fn check(name: &str, place: Place, of: &str) -> Result<(), DomainError> {
    if name.trim().is_empty() {
        let message = format!("the name of {of} is blank; give it a letter or leave it out");
        return Err(place.error(message));
    }
    let is_refused = |character: &char| {
        character.is_control()
            || matches!(character, '\u{2028}' | '\u{2029}')
            || turns_direction(*character)
    };
    match name.chars().find(is_refused) {
        Some(character) => Err(place.error(format!(
            "the name of {of} contains the {} U+{:04X}; remove this character",
            kind(character),
            character as u32
        ))),
        None => Ok(()),
    }
}

/// Checks that nothing without a name gets one that is given to something else, since both would be one group.
///
/// `unnamed` gives each by the place of its name and the name that it gets.
pub(crate) fn check_unnamed<'a>(
    given: impl Iterator<Item = &'a str>,
    unnamed: impl Iterator<Item = (Place, String)>,
) -> Result<(), DomainError> {
    let given: HashSet<&str> = given.collect();
    if given.is_empty() {
        return Ok(());
    }
    match unnamed.into_iter().find(|(_, name)| given.contains(&**name)) {
        Some((place, name)) => Err(place.error(format!(
            "without a name it is called {name:?}, and something else has that name; give it another one"
        ))),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_one_line_of_visible_text() {
        for name in ["wall", "Tür 2", "入口", "عمود", "a b", "\u{1f6eb}"] {
            assert_eq!(check(name, Place::default(), "the domain"), Ok(()), "{name}");
        }
        #[rustfmt::skip]
        let table = [
            ("", "the name of the domain is blank; give it a letter or leave it out"),
            (" \t", "the name of the domain is blank; give it a letter or leave it out"),
            ("a\nb", "the name of the domain contains the line break U+000A; remove this character"),
            ("a\u{85}b", "the name of the domain contains the line break U+0085; remove this character"),
            ("a\u{2028}b", "the name of the domain contains the line break U+2028; remove this character"),
            ("a\u{2029}", "the name of the domain contains the line break U+2029; remove this character"),
            ("a\u{1b}[2J", "the name of the domain contains the control character U+001B; remove this character"),
            ("\u{202e}jbo", "the name of the domain contains the direction mark U+202E; remove this character"),
            ("a\u{2066}", "the name of the domain contains the direction mark U+2066; remove this character"),
            ("a\u{200f}", "the name of the domain contains the direction mark U+200F; remove this character"),
        ];
        for (name, message) in table {
            assert_eq!(
                check(name, Place::default(), "the domain").unwrap_err().to_string(),
                message
            );
        }
    }
}
