//! The nodes of a file, each with a tag of its own.

use glam::DVec3;

use crate::ReadError;
use crate::lists::push;
use crate::scanner::Scanner;

#[derive(Default)]
pub(super) struct Nodes {
    positions: Vec<DVec3>,
    count: u32,
    /// The tag of the first node.
    first: u64,
    /// Tag and index of every node, in the order of tags, unless tags count up from the first.
    tags: Option<Vec<(u64, u32)>>,
}

impl Nodes {
    pub(super) fn push_tag(&mut self, tag: u64) -> Result<(), ReadError> {
        if self.count == 0 {
            self.first = tag;
        }
        let index = self.count;
        let counts_up = tag.checked_sub(self.first) == Some(index.into());
        if !counts_up && self.tags.is_none() {
            let mut tags = Vec::new();
            tags.try_reserve(index as usize + 1)?;
            tags.extend((0..index).map(|index| (self.first + u64::from(index), index)));
            self.tags = Some(tags);
        }
        if let Some(tags) = &mut self.tags {
            push(tags, (tag, index))?;
        }
        // More than 32 bits count are refused with the positions.
        self.count = index.saturating_add(1);
        Ok(())
    }

    pub(super) fn push_position(&mut self, scanner: &mut Scanner<'_>) -> Result<(), ReadError> {
        let mut position = [0.0; 3];
        for coordinate in &mut position {
            *coordinate = scanner.double("a coordinate")?;
            if !coordinate.is_finite() {
                return Err(scanner.problem(format!("a coordinate is {coordinate}")));
            }
        }
        Ok(push(&mut self.positions, DVec3::from_array(position))?)
    }

    /// Makes the nodes ready to be found.
    pub(super) fn sort(&mut self, scanner: &Scanner<'_>) -> Result<(), ReadError> {
        let Some(tags) = &mut self.tags else { return Ok(()) };
        tags.sort_unstable();
        match tags.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            Some(pair) => Err(scanner.problem(format!("two nodes have the tag {}", pair[0].0))),
            None => Ok(()),
        }
    }

    /// The index of the node with a tag.
    pub(super) fn index(&self, tag: u64) -> Option<u32> {
        match &self.tags {
            None => {
                let index = u32::try_from(tag.checked_sub(self.first)?).ok()?;
                (index < self.count).then_some(index)
            }
            Some(tags) => {
                let found = tags.binary_search_by_key(&tag, |&(tag, _)| tag).ok()?;
                Some(tags[found].1)
            }
        }
    }

    pub(super) fn into_positions(self) -> Vec<DVec3> {
        self.positions
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nodes_are_found_by_any_tags() {
        for tags in [&[1, 2, 3, 4][..], &[0, 1], &[7, 8, 12, 9], &[5, 3], &[u64::MAX, 0, 1]] {
            let mut nodes = Nodes::default();
            tags.iter().for_each(|&tag| nodes.push_tag(tag).unwrap());
            nodes.sort(&Scanner::new(b"")).unwrap();
            for (&tag, index) in tags.iter().zip(0..) {
                assert_eq!(nodes.index(tag), Some(index), "{tags:?}");
            }
            assert_eq!(nodes.index(99), None);
            assert_eq!(nodes.index(13), None);
        }
        let mut nodes = Nodes::default();
        [4, 5, 4].iter().for_each(|&tag| nodes.push_tag(tag).unwrap());
        let error = nodes.sort(&Scanner::new(b"")).unwrap_err();
        assert_eq!(error.to_string(), "line 1: two nodes have the tag 4");
    }
}
