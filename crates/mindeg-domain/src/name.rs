//! The names of domains and sides, which become groups of mesh files.
//!
//! Limits: names may have any letters, but no character that ends a line, steers a terminal or
//! turns the direction of writing.

use std::collections::BTreeMap;

use crate::rings::InRing;

/// Why names cannot be used.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NameError {
    /// A name without a visible character.
    #[error("{} is blank; give it a letter or leave it out", whose(*side))]
    Blank {
        /// The side with that name; the domain itself if `None`.
        side: Option<InRing>,
    },
    /// A name with a character that mesh files or terminals do not take as text.
    #[error(
        "{} contains the {} U+{:04X}; remove this character",
        whose(*side), kind(*character), *character as u32
    )]
    Character {
        /// The side with that name; the domain itself if `None`.
        side: Option<InRing>,
        /// The character.
        character: char,
    },
    /// Two sides of the same name.
    #[error(
        "{} are both named {name:?}; names become groups in mesh files and must differ",
        both(*first, *second)
    )]
    Repeated {
        /// The one.
        first: InRing,
        /// The other.
        second: InRing,
        /// Their name.
        name: String,
    },
}

fn whose(side: Option<InRing>) -> String {
    side.map_or("the domain's name".to_owned(), |side| format!("the name of {}", side.side()))
}

fn both(first: InRing, second: InRing) -> String {
    if first.ring == second.ring {
        format!("sides {} and {}", first.index + 1, second.named_last())
    } else {
        format!("{} and {}", first.side(), second.side())
    }
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
pub(crate) fn check(name: &str, side: Option<InRing>) -> Result<(), NameError> {
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
pub(crate) fn check_all<'a>(
    names: impl Iterator<Item = (InRing, Option<&'a str>)>,
) -> Result<(), NameError> {
    let mut sides = BTreeMap::new();
    for (side, name) in names {
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
        let message = |names: &[(usize, usize, Option<&'static str>)]| {
            let names = names.iter().map(|&(ring, index, name)| (InRing { ring, index }, name));
            check_all(names).unwrap_err().to_string()
        };
        let differ = "names become groups in mesh files and must differ";
        #[rustfmt::skip]
        let table = [
            (message(&[(0, 0, Some("a")), (0, 1, None), (0, 2, Some("b")), (0, 3, Some("a"))]), format!("sides 1 and 4 are both named \"a\"; {differ}")),
            (message(&[(0, 1, Some("a")), (2, 0, Some("a"))]), format!("side 2 and side 1 of hole 2 are both named \"a\"; {differ}")),
            (message(&[(2, 1, Some("a")), (2, 3, Some("a"))]), format!("sides 2 and 4 of hole 2 are both named \"a\"; {differ}")),
            (message(&[(0, 0, None), (0, 1, Some("\n"))]), "the name of side 2 is blank; give it a letter or leave it out".to_owned()),
            (message(&[(1, 0, Some(" "))]), "the name of side 1 of hole 1 is blank; give it a letter or leave it out".to_owned()),
        ];
        for (found, expected) in table {
            assert_eq!(found, expected);
        }
    }
}
