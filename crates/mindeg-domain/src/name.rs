//! The names of domains and sides, which become groups of mesh files.
//!
//! Limits: names may have any letters, but no character that ends a line, steers a terminal or
//! turns the direction of writing.

use std::collections::BTreeMap;

/// Why names cannot be used. Sides are counted from 0 here and from 1 in messages.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NameError {
    /// A name without a visible character.
    #[error("{} is blank; give it a letter or leave it out", whose(*side))]
    Blank {
        /// The side with that name; the domain itself if `None`.
        side: Option<usize>,
    },
    /// A name with a character that mesh files or terminals do not take as text.
    #[error(
        "{} contains the {} U+{:04X}; remove this character",
        whose(*side), kind(*character), *character as u32
    )]
    Character {
        /// The side with that name; the domain itself if `None`.
        side: Option<usize>,
        /// The character.
        character: char,
    },
    /// Two sides of the same name.
    #[error(
        "sides {} and {} are both named {name:?}; names become groups in mesh files and must differ",
        first + 1, second + 1
    )]
    Repeated {
        /// The one.
        first: usize,
        /// The other.
        second: usize,
        /// Their name.
        name: String,
    },
}

fn whose(side: Option<usize>) -> String {
    side.map_or("the domain's name".to_owned(), |side| format!("the name of side {}", side + 1))
}

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

/// Checks the name of a side, or of the domain if there is no side.
pub(crate) fn check(name: &str, side: Option<usize>) -> Result<(), NameError> {
    if name.trim().is_empty() {
        return Err(NameError::Blank { side });
    }
    let is_refused = |character: &char| {
        character.is_control()
            || matches!(character, '\u{2028}' | '\u{2029}')
            || turns_direction(*character)
    };
    match name.chars().find(is_refused) {
        Some(character) => Err(NameError::Character { side, character }),
        None => Ok(()),
    }
}

/// Checks the names of all sides. O(k log k).
pub(crate) fn check_all<'a>(names: impl Iterator<Item = Option<&'a str>>) -> Result<(), NameError> {
    let mut sides = BTreeMap::new();
    for (side, name) in names.enumerate() {
        let Some(name) = name else { continue };
        check(name, Some(side))?;
        if let Some(first) = sides.insert(name, side) {
            return Err(NameError::Repeated { first, second: side, name: name.to_owned() });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_one_line_of_visible_text() {
        for name in ["wall", "Tür 2", "入口", "عمود", "a b", "\u{1f6eb}"] {
            assert_eq!(check(name, None), Ok(()), "{name}");
        }
        #[rustfmt::skip]
        let table = [
            ("", "the domain's name is blank; give it a letter or leave it out"),
            (" \t", "the domain's name is blank; give it a letter or leave it out"),
            ("a\nb", "the domain's name contains the line break U+000A; remove this character"),
            ("a\u{85}b", "the domain's name contains the line break U+0085; remove this character"),
            ("a\u{2028}b", "the domain's name contains the line break U+2028; remove this character"),
            ("a\u{2029}", "the domain's name contains the line break U+2029; remove this character"),
            ("a\u{1b}[2J", "the domain's name contains the control character U+001B; remove this character"),
            ("\u{202e}jbo", "the domain's name contains the direction mark U+202E; remove this character"),
            ("a\u{2066}", "the domain's name contains the direction mark U+2066; remove this character"),
            ("a\u{200f}", "the domain's name contains the direction mark U+200F; remove this character"),
        ];
        for (name, message) in table {
            assert_eq!(check(name, None).unwrap_err().to_string(), message);
        }
        let names = [Some("a"), None, Some("b"), Some("a")];
        assert_eq!(
            check_all(names.into_iter()).unwrap_err().to_string(),
            "sides 1 and 4 are both named \"a\"; names become groups in mesh files and must differ"
        );
        assert_eq!(
            check_all([None, Some("\n")].into_iter()).unwrap_err().to_string(),
            "the name of side 2 is blank; give it a letter or leave it out"
        );
    }
}
