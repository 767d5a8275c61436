//! Lines, groups or points under their names: those that share a name are one group.

use std::collections::HashMap;

/// The different names of some items, and which item has which: items that share a name are one group.
///
/// # Example
///
/// ```
/// use mindeg_mesh::ByName;
///
/// let sides = ByName::new(["wall", "inlet", "wall"]);
/// assert_eq!((&sides.names[..], &sides.of[..]), (&["wall", "inlet"].map(String::from)[..], &[0, 1, 0][..]));
/// assert_eq!(sides.items(), [vec![0, 2], vec![1]]);
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ByName {
    /// The names, in the order of their first items.
    pub names: Vec<String>,
    /// The index of the name of each item.
    pub of: Vec<u32>,
}

impl ByName {
    /// O(n) for n items.
    pub fn new(items: impl IntoIterator<Item = impl AsRef<str>>) -> Self {
        let mut indices = HashMap::new();
        let mut found = Self::default();
        for item in items {
            let name = item.as_ref();
            let index = match indices.get(name) {
                Some(&index) => index,
                None => {
                    let index = found.names.len() as u32;
                    indices.insert(name.to_owned(), index);
                    found.names.push(name.to_owned());
                    index
                }
            };
            found.of.push(index);
        }
        found
    }

    /// For each name its items.
    pub fn items(&self) -> Vec<Vec<usize>> {
        let mut items = vec![Vec::new(); self.names.len()];
        for (item, name) in self.of.iter().enumerate() {
            items[*name as usize].push(item);
        }
        items
    }
}
