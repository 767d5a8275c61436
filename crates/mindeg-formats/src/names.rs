//! Distinct names for the objects of a file.

use std::collections::HashMap;

/// A name for a line of text, without what would end the line.
pub(crate) fn one_line(name: &str) -> String {
    name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}

/// A name with underscores for white space, where many readers of an OBJ end it.
pub(crate) fn without_blanks(name: &str) -> String {
    name.split_whitespace().collect::<Vec<_>>().join("_")
}

/// The names that a file has so far.
#[derive(Default)]
pub(crate) struct Names {
    /// Each name, and the number that was last added to it.
    taken: HashMap<String, u32>,
}

impl Names {
    /// The name, if the file does not have it yet; else the name with `_2`, `_3` or the first
    /// number that makes a new one. O(1), but where made names meet others.
    pub(crate) fn distinct(&mut self, name: String) -> String {
        if !self.taken.contains_key(&name) {
            self.taken.insert(name.clone(), 1);
            return name;
        }
        loop {
            let number = self.taken.entry(name.clone()).or_default();
            *number += 1;
            let made = format!("{name}_{number}");
            if !self.taken.contains_key(&made) {
                self.taken.insert(made.clone(), 1);
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
}
