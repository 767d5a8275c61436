//! The names of domains, sides, faces and edges, which become groups of mesh files.
//!
//! Limits: names may have any letters, but no character that ends a line, controls a terminal or
//! changes the direction of writing.

use mindeg_mesh::planar::InRing;
use std::collections::BTreeMap;

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

/// Checks the names of all sides. O(k log k).
pub(crate) fn check_all<'a>(
    names: impl Iterator<Item = (InRing, Option<&'a str>)>,
) -> Result<(), DomainError> {
    let mut sides = BTreeMap::new();
    for (side, name) in names {
        let Some(name) = name else { continue };
        let place = || Place::side(side).then("name");
        check(name, place(), &side.side())?;
        if let Some(first) = sides.insert(name, side) {
            let both = if first.ring == side.ring {
                format!("sides {} and {}", first.index + 1, side.named_last())
            } else {
                format!("{} and {}", first.side(), side.side())
            };
            return Err(place().error(format!(
                "{both} are both named {name:?}; names become groups in mesh files and must differ"
            )));
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
