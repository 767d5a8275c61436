//! Degree limits, and the capacities that they leave to vertices.

use crate::chords::Chords;

/// A degree limit for all vertices, and the chords that it leaves to each.
#[derive(Clone, Debug)]
pub(crate) struct DegreeLimits {
    /// The limit for all vertices.
    pub(crate) max_degree: u32,
    /// The most chords of each vertex.
    pub(crate) chords: Vec<u32>,
}

impl DegreeLimits {
    /// The capacity of each vertex: limited where `matters` is true of the number of its chords in
    /// `chords` and of the most that it may have.
    pub(crate) fn capacities(
        &self,
        chords: &Chords,
        matters: impl Fn(u32, u32) -> bool,
    ) -> Vec<Capacity> {
        let capacity = |(degree, &most)| {
            if matters(degree, most) { Capacity::Limited(most) } else { Capacity::Unlimited }
        };
        chords.degrees().into_iter().zip(&self.chords).map(capacity).collect()
    }
}

/// How many chords a vertex may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Capacity {
    /// At most this many; they are counted.
    Limited(u32),
    /// Any number; they are not counted.
    Unlimited,
}

impl Capacity {
    /// The amount that one more chord adds to the count.
    pub(crate) fn step(self) -> u32 {
        u32::from(self != Self::Unlimited)
    }

    /// The largest count.
    pub(crate) fn most(self) -> u32 {
        if let Self::Limited(chords) = self { chords } else { 0 }
    }
}
