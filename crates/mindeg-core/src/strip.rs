//! Strips: triangles between two chains of boundary vertices, in the order of a word.
//!
//! An optimal triangulation is one strip, or two that share an edge. A strip knows its
//! chains, its word and its ears and nothing else, so it takes O(1) memory.
//!
//! Limits: what is here suffices for the constructions of this crate. A strip always starts with
//! an ear, and a chain has one jump at most.

mod fill;

use crate::word::{Letter, Word};
use core::ops::RangeInclusive;

/// Consecutive boundary vertices, with at most one jump over vertices cut off by another strip.
///
/// # Example
///
/// ```
/// use mindeg_core::{Boundary, min_degree_triangulation};
///
/// // The main strip leaves 28, 0 and 1 to the cap at corner 0.
/// let triangulation = min_degree_triangulation(&Boundary::new(&[12, 9, 4, 4])?);
/// let chain = *triangulation.strips().next().unwrap().x();
/// let vertices: Vec<u32> = (0..chain.len()).map(|index| chain.vertex(index)).collect();
/// assert_eq!(vertices, [26, 27, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11]);
/// # Ok::<(), mindeg_core::BoundaryError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Chain {
    first: u32,
    len: u32,
    direction: Direction,
    jump: Option<Jump>,
    vertex_count: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Direction {
    CounterClockwise,
    Clockwise,
}

/// After the vertex at index `after` the chain leaves out `skipped` boundary vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Jump {
    pub(crate) after: u32,
    pub(crate) skipped: u32,
}

impl Chain {
    /// `len` vertices from `first` on, on a ring of `vertex_count`.
    pub(crate) fn new(first: u32, len: u32, direction: Direction, vertex_count: u32) -> Self {
        debug_assert!(first < vertex_count && 0 < len && len < vertex_count);
        Self { first, len, direction, jump: None, vertex_count }
    }

    pub(crate) fn with_jump(self, jump: Jump) -> Self {
        Self { jump: Some(jump), ..self }
    }

    /// The number of vertices, at least 1.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "a chain is never empty")]
    pub fn len(&self) -> u32 {
        self.len
    }

    /// The vertex at `index`, in `0..len`. O(1).
    ///
    /// # Panics
    ///
    /// When `index` is not below [`len`](Self::len).
    #[must_use]
    pub fn vertex(&self, index: u32) -> u32 {
        assert!(index < self.len, "a chain of {} vertices has none at {index}", self.len);
        let steps = match self.jump {
            Some(jump) if index > jump.after => index + jump.skipped,
            _ => index,
        };
        // Steps and first are below the vertex count, so one subtraction wraps the ring.
        match self.direction {
            Direction::CounterClockwise => {
                let to_end = self.vertex_count - self.first;
                if steps < to_end { self.first + steps } else { steps - to_end }
            }
            Direction::Clockwise => {
                if steps <= self.first {
                    self.first - steps
                } else {
                    self.vertex_count - (steps - self.first)
                }
            }
        }
    }

    /// The index of `vertex`, or none when it is not on the chain. O(1).
    fn index_of(&self, vertex: u32) -> Option<u32> {
        let (from, to) = match self.direction {
            Direction::CounterClockwise => (self.first, vertex),
            Direction::Clockwise => (vertex, self.first),
        };
        let steps = if to >= from { to - from } else { self.vertex_count - (from - to) };
        let index = match self.jump {
            Some(jump) if steps > jump.after + jump.skipped => steps - jump.skipped,
            Some(jump) if steps > jump.after => return None,
            _ => steps,
        };
        (index < self.len).then_some(index)
    }

    /// The steps, by the index they start from, that do not lead to a neighbouring id: over a
    /// jump, and between vertices n-1 and 0.
    fn uneven_steps(&self) -> [Option<u32>; 2] {
        let last_id = match self.direction {
            Direction::CounterClockwise => self.vertex_count - 1,
            Direction::Clockwise => 0,
        };
        [self.jump.map(|jump| jump.after), self.index_of(last_id)]
    }
}

/// What lies beyond the last edge across a strip; see [`Strip`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// One more triangle, an ear with this tip.
    Ear(u32),
    /// Another strip, along a shared edge that this strip counts as its own.
    Shared,
    /// Nothing: the edge is a boundary edge. Only the single triangle needs this.
    Boundary,
}

/// Triangles between an x chain, which runs counter-clockwise, and a y chain, which runs
/// clockwise beside it.
///
/// First comes an ear, the triangle (tip, x_0, y_0). From the edge (x_0, y_0) on, each letter of
/// the word moves one end of the current edge (x_i, y_j): X adds the triangle (x_i, x_{i+1}, y_j),
/// Y adds (x_i, y_{j+1}, y_j). What follows the last edge is an [`End`].
///
/// With an alternating word this is what graphics libraries call a triangle strip; other words
/// make it a generalized one.
///
/// # Example
///
/// ```
/// use mindeg_core::{Boundary, End, Letter, min_degree_triangulation};
///
/// let triangulation = min_degree_triangulation(&Boundary::new(&[3, 3, 2, 2])?);
/// let strip = triangulation.strips().next().unwrap();
/// assert_eq!(strip.tip(), 3);
/// assert_eq!(strip.triangle(0), [3, 4, 2]);
/// assert_eq!(strip.word().letter(0), Letter::X);
/// assert_eq!(strip.triangle(1), [4, 5, 2]);
/// assert_eq!(strip.end(), End::Ear(8));
/// # Ok::<(), mindeg_core::BoundaryError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Strip {
    tip: u32,
    x: Chain,
    y: Chain,
    word: Word,
    end: End,
}

impl Strip {
    pub(crate) fn new(tip: u32, x: Chain, y: Chain, word: Word, end: End) -> Self {
        debug_assert!(x.len == word.xs() + 1 && y.len == word.ys() + 1);
        debug_assert!(x.direction == Direction::CounterClockwise);
        debug_assert!(y.direction == Direction::Clockwise);
        Self { tip, x, y, word, end }
    }

    /// The chain along which letter X advances.
    #[must_use]
    pub fn x(&self) -> &Chain {
        &self.x
    }

    /// The chain along which letter Y advances.
    #[must_use]
    pub fn y(&self) -> &Chain {
        &self.y
    }

    /// The order of advances.
    #[must_use]
    pub fn word(&self) -> &Word {
        &self.word
    }

    /// The tip of the ear that every strip starts with, before the first edge across.
    #[must_use]
    pub fn tip(&self) -> u32 {
        self.tip
    }

    /// What lies after the last edge across.
    #[must_use]
    pub fn end(&self) -> End {
        self.end
    }

    /// The number of triangles, ears included.
    #[must_use]
    pub fn triangle_count(&self) -> u32 {
        1 + self.word.len() + u32::from(matches!(self.end, End::Ear(_)))
    }

    /// The triangle with the given number, in `0..triangle_count`, counter-clockwise. O(1).
    ///
    /// The ear at the start is number 0, then comes one triangle for each letter of the word,
    /// then the ear at the end if there is one.
    ///
    /// # Panics
    ///
    /// When `number` is not below [`triangle_count`](Self::triangle_count).
    #[must_use]
    pub fn triangle(&self, number: u32) -> [u32; 3] {
        assert!(number < self.triangle_count(), "triangle {number} does not exist");
        if number == 0 {
            return [self.tip, self.x.vertex(0), self.y.vertex(0)];
        }
        let place = number - 1;
        let i = self.word.xs_before(place);
        let j = place - i;
        let (x, y) = (self.x.vertex(i), self.y.vertex(j));
        match self.end {
            End::Ear(tip) if place == self.word.len() => [x, tip, y],
            _ => match self.word.letter(place) {
                Letter::X => [x, self.x.vertex(i + 1), y],
                Letter::Y => [x, self.y.vertex(j + 1), y],
            },
        }
    }

    /// The number of interior edges across the strip, a shared edge included.
    pub(crate) fn interior_edge_count(&self) -> u32 {
        self.word.len() + u32::from(self.end != End::Boundary)
    }

    /// The edge across with the given number, from the x chain to the y chain. O(1).
    pub(crate) fn edge(&self, number: u32) -> [u32; 2] {
        let i = self.word.xs_before(number);
        [self.x.vertex(i), self.y.vertex(number - i)]
    }

    /// The vertices across from `vertex` in this strip, counter-clockwise. O(1).
    pub(crate) fn across(&self, vertex: u32) -> Option<Across> {
        if self.end == End::Boundary {
            return None;
        }
        if let Some(index) = self.x.index_of(vertex) {
            let indices = self.indices_across_x(index);
            return Some(Across { seen_from: Letter::X, chain: self.y, indices });
        }
        let index = self.y.index_of(vertex)?;
        let indices = self.indices_across_y(index);
        Some(Across { seen_from: Letter::Y, chain: self.x, indices })
    }

    /// The indices on the y chain that the vertex at `index` of the x chain is joined to.
    fn indices_across_x(&self, index: u32) -> RangeInclusive<u32> {
        let first = if index == 0 { 0 } else { self.word.ys_before_x(index - 1) };
        let last =
            if index == self.word.xs() { self.word.ys() } else { self.word.ys_before_x(index) };
        first..=last
    }

    fn indices_across_y(&self, index: u32) -> RangeInclusive<u32> {
        let first = if index == 0 { 0 } else { self.word.xs_before_y(index - 1) };
        let last =
            if index == self.word.ys() { self.word.xs() } else { self.word.xs_before_y(index) };
        first..=last
    }
}

/// The part of the opposite chain that one vertex is joined to.
#[derive(Clone, Debug)]
pub(crate) struct Across {
    /// The chain of the one vertex. From x, counter-clockwise order runs through y backwards.
    pub(crate) seen_from: Letter,
    chain: Chain,
    indices: RangeInclusive<u32>,
}

impl Across {
    pub(crate) fn len(&self) -> u32 {
        if self.indices.is_empty() { 0 } else { self.indices.end() - self.indices.start() + 1 }
    }
}

impl Iterator for Across {
    type Item = u32;

    fn next(&mut self) -> Option<u32> {
        let index = match self.seen_from {
            Letter::X => self.indices.next_back(),
            Letter::Y => self.indices.next(),
        };
        index.map(|index| self.chain.vertex(index))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec::Vec;

    #[test]
    fn a_chain_walks_the_ring_both_ways_and_jumps() {
        let ring = 10;
        let jump = Jump { after: 1, skipped: 3 };
        for (chain, vertices) in [
            (Chain::new(8, 4, Direction::CounterClockwise, ring), &[8, 9, 0, 1][..]),
            (Chain::new(1, 4, Direction::Clockwise, ring), &[1, 0, 9, 8]),
            (Chain::new(7, 4, Direction::CounterClockwise, ring).with_jump(jump), &[7, 8, 2, 3]),
            (Chain::new(1, 3, Direction::Clockwise, ring).with_jump(jump), &[1, 0, 6]),
        ] {
            let walked: Vec<u32> = (0..chain.len()).map(|index| chain.vertex(index)).collect();
            assert_eq!(walked, vertices);
            for vertex in 0..ring {
                let place = vertices.iter().position(|&other| other == vertex);
                assert_eq!(chain.index_of(vertex), place.map(|place| place as u32), "{vertex}");
            }
        }
    }

    #[test]
    fn a_strip_emits_its_word() {
        // A ring of 8: ears at 0 and 4, x = 1 2 3, y = 7 6 5.
        let strip = Strip::new(
            0,
            Chain::new(1, 3, Direction::CounterClockwise, 8),
            Chain::new(7, 3, Direction::Clockwise, 8),
            Word::alternating(Letter::X, 2, 2),
            End::Ear(4),
        );
        let triangles: Vec<_> = (0..strip.triangle_count()).map(|i| strip.triangle(i)).collect();
        assert_eq!(triangles, [[0, 1, 7], [1, 2, 7], [2, 6, 7], [2, 3, 6], [3, 5, 6], [3, 4, 5]]);
        let edges: Vec<_> = (0..strip.interior_edge_count()).map(|i| strip.edge(i)).collect();
        assert_eq!(edges, [[1, 7], [2, 7], [2, 6], [3, 6], [3, 5]]);
        let across = |vertex| strip.across(vertex).map(|across| across.collect::<Vec<_>>());
        assert_eq!(across(2), Some([6, 7].into()));
        assert_eq!(across(7), Some([1, 2].into()));
        assert_eq!(across(0), None);
    }
}
