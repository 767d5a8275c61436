//! Disjoint sets of items, joined one pair at a time.

/// The items 0 to n - 1, at first each in a set of its own.
#[derive(Clone, Debug)]
pub struct DisjointSets {
    /// Another item of the same set, never greater; the set's least item points to itself.
    parents: Vec<u32>,
    count: usize,
}

impl DisjointSets {
    /// The things 0 to `things` - 1, with indices of 32 bits.
    pub fn new(things: usize) -> Self {
        Self { parents: (0..).take(things).collect(), count: things }
    }

    /// Joins the sets of two items. O(log n) amortized.
    pub fn join(&mut self, a: u32, b: u32) {
        let [a, b] = [self.least(a), self.least(b)];
        if a != b {
            self.parents[a.max(b) as usize] = a.min(b);
            self.count -= 1;
        }
    }

    /// The number of sets.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The least item in the set of `thing`. O(log n) amortized.
    pub fn least(&mut self, mut thing: u32) -> u32 {
        loop {
            let parent = self.parents[thing as usize];
            if parent == thing {
                return thing;
            }
            // Halves the path, so that the next call is faster.
            let grandparent = self.parents[parent as usize];
            self.parents[thing as usize] = grandparent;
            thing = grandparent;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn joins_and_counts() {
        let mut sets = DisjointSets::new(6);
        for (a, b, count) in [(0, 1, 5), (1, 0, 5), (4, 3, 4), (5, 4, 3), (3, 1, 2), (5, 0, 2)] {
            sets.join(a, b);
            assert_eq!(sets.count(), count, "{a} and {b}");
        }
    }
}
