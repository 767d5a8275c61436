//! Strips: triangles between two chains of boundary vertices, in the order of a word.
//!
//! An optimal triangulation is one strip, or two that share an edge. A strip stores its chains,
//! its word and its ears, so it takes O(1) memory.
//!
//! Limits: strips and chains are only as general as the constructions of this crate need. A
//! strip always starts with an ear, and a chain has at most one jump.

mod fill;

use crate::ring::Ring;
use crate::word::{Letter, Word};
use core::ops::RangeInclusive;

/// Consecutive boundary vertices, with at most one jump over vertices that another strip covers.
/// O(1) memory.
///
/// # Example
///
/// ```
/// use mindeg_core::{Boundary, least_degree_triangulation};
///
/// // The corner strip at corner 0 covers 28, 0 and 1.
/// let triangulation = least_degree_triangulation(&Boundary::new(&[12, 9, 4, 4])?);
/// let chain = *triangulation.strips().next().unwrap().x();
/// let vertices: Vec<u32> = (0..chain.len()).map(|index| chain.vertex(index)).collect();
/// assert_eq!(vertices, [26, 27, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11]);
/// # Ok::<(), mindeg_core::Defect>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Chain {
    first: u32,
    len: u32,
    direction: Direction,
    jump: Option<Jump>,
    ring: Ring,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Direction {
    CounterClockwise,
    Clockwise,
}

/// After the vertex at index `after` the chain skips `skipped` boundary vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Jump {
    pub(crate) after: u32,
    pub(crate) skipped: u32,
}

impl Chain {
    /// `len` vertices from `first` on.
    pub(crate) fn new(first: u32, len: u32, direction: Direction, ring: Ring) -> Self {
        debug_assert!(first < ring.len() && 0 < len && len < ring.len());
        Self { first, len, direction, jump: None, ring }
    }

    pub(crate) fn with_jump(self, jump: Jump) -> Self {
        Self { jump: Some(jump), ..self }
    }

    /// The number of vertices, at least 1.
    #[expect(clippy::len_without_is_empty, reason = "a chain is never empty")]
    pub fn len(&self) -> u32 {
        self.len
    }

    /// The vertex at `index`, in `0..len`. O(1).
    ///
    /// # Panics
    ///
    /// If `index` is not below [`len`](Self::len).
    pub fn vertex(&self, index: u32) -> u32 {
        assert!(
            index < self.len,
            "index {index} is out of range; the chain has {} vertices",
            self.len
        );
        let steps = match self.jump {
            Some(jump) if index > jump.after => index + jump.skipped,
            _ => index,
        };
        match self.direction {
            Direction::CounterClockwise => self.ring.forward(self.first, steps),
            Direction::Clockwise => self.ring.backward(self.first, steps),
        }
    }

    /// The index of `vertex`, or none if it is not on the chain. O(1).
    fn index_of(&self, vertex: u32) -> Option<u32> {
        let steps = match self.direction {
            Direction::CounterClockwise => self.ring.steps(self.first, vertex),
            Direction::Clockwise => self.ring.steps(vertex, self.first),
        };
        let index = match self.jump {
            Some(jump) if steps > jump.after + jump.skipped => steps - jump.skipped,
            Some(jump) if steps > jump.after => return None,
            _ => steps,
        };
        (index < self.len).then_some(index)
    }

    /// The indices of the vertices from which the next one does not have a neighbouring id:
    /// before a jump, and between vertices n-1 and 0.
    fn irregular_steps(&self) -> [Option<u32>; 2] {
        let last_id = match self.direction {
            Direction::CounterClockwise => self.ring.len() - 1,
            Direction::Clockwise => 0,
        };
        [self.jump.map(|jump| jump.after), self.index_of(last_id)]
    }
}

/// The end of a strip, after its last cross edge; see [`Strip`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// One more triangle, an ear with this tip.
    Ear(u32),
    /// Another strip. The two share the edge, and this strip counts it as its own.
    Shared,
    /// Nothing: the edge is a boundary edge. Only the boundary (1,1,1) has this.
    Boundary,
}

/// Triangles between an x chain, which runs counter-clockwise, and a y chain, which runs
/// clockwise beside it.
///
/// A **cross edge** (x_i, y_j) joins the two. The first triangle is an ear, (tip, x_0, y_0). From
/// the cross edge (x_0, y_0) on, each letter of the [`Word`] moves one end of the current cross
/// edge: X adds the triangle (x_i, x_{i+1}, y_j), Y adds (x_i, y_{j+1}, y_j). An [`End`] follows
/// the last cross edge.
///
/// ```text
///     y_j                     y_j --- y_{j+1}
///      |  \                     |  Y  /
///      |  X  \                  |  /
///     x_i --- x_{i+1}          x_i
/// ```
///
/// With an alternating word, this is a triangle strip of graphics libraries; with other words, a
/// generalized one.
///
/// # Example
///
/// ```
/// use mindeg_core::{Boundary, End, Letter, least_degree_triangulation};
///
/// let triangulation = least_degree_triangulation(&Boundary::new(&[3, 3, 2, 2])?);
/// let strip = triangulation.strips().next().unwrap();
/// assert_eq!(strip.tip(), 3);
/// assert_eq!(strip.triangle(0), [3, 4, 2]);
/// assert_eq!(strip.word().letter(0), Letter::X);
/// assert_eq!(strip.triangle(1), [4, 5, 2]);
/// assert_eq!(strip.end(), End::Ear(8));
/// # Ok::<(), mindeg_core::Defect>(())
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
    pub fn x(&self) -> &Chain {
        &self.x
    }

    /// The chain along which letter Y advances.
    pub fn y(&self) -> &Chain {
        &self.y
    }

    /// The order in which the strip advances.
    pub fn word(&self) -> &Word {
        &self.word
    }

    /// The tip of the ear that every strip starts with, before the first cross edge.
    pub fn tip(&self) -> u32 {
        self.tip
    }

    /// The end of the strip, after its last cross edge.
    pub fn end(&self) -> End {
        self.end
    }

    /// The number of triangles, ears included.
    pub fn triangle_count(&self) -> u32 {
        1 + self.word.len() + u32::from(matches!(self.end, End::Ear(_)))
    }

    /// The triangle at `index`, in `0..triangle_count`, counter-clockwise. O(1).
    ///
    /// Index 0 is the ear at the start. One triangle for each letter of the word follows, then
    /// the ear at the end if the strip has one.
    ///
    /// # Panics
    ///
    /// If `index` is not below [`triangle_count`](Self::triangle_count).
    pub fn triangle(&self, index: u32) -> [u32; 3] {
        let count = self.triangle_count();
        assert!(index < count, "index {index} is out of range; the strip has {count} triangles");
        if index == 0 {
            return [self.tip, self.x.vertex(0), self.y.vertex(0)];
        }
        let letter = index - 1;
        let i = self.word.xs_before(letter);
        let j = letter - i;
        let (x, y) = (self.x.vertex(i), self.y.vertex(j));
        match self.end {
            End::Ear(tip) if letter == self.word.len() => [x, tip, y],
            _ => match self.word.letter(letter) {
                Letter::X => [x, self.x.vertex(i + 1), y],
                Letter::Y => [x, self.y.vertex(j + 1), y],
            },
        }
    }

    /// The number of cross edges that are interior edges, a shared edge included.
    pub(crate) fn interior_edge_count(&self) -> u32 {
        self.word.len() + u32::from(self.end != End::Boundary)
    }

    /// The cross edge at `index`, from the x chain to the y chain. O(1).
    pub(crate) fn edge(&self, index: u32) -> [u32; 2] {
        let i = self.word.xs_before(index);
        [self.x.vertex(i), self.y.vertex(index - i)]
    }

    /// The vertices that cross edges join to `vertex`, counter-clockwise; none if `vertex` is not
    /// on a chain. O(1).
    pub(crate) fn opposite(&self, vertex: u32) -> Option<Opposite> {
        if self.end == End::Boundary {
            return None;
        }
        if let Some(index) = self.x.index_of(vertex) {
            let indices = self.opposite_of_x(index);
            return Some(Opposite { from: Letter::X, chain: self.y, indices });
        }
        let index = self.y.index_of(vertex)?;
        let indices = self.opposite_of_y(index);
        Some(Opposite { from: Letter::Y, chain: self.x, indices })
    }

    /// The indices on the y chain that cross edges join to index `index` on the x chain.
    fn opposite_of_x(&self, index: u32) -> RangeInclusive<u32> {
        let first = if index == 0 { 0 } else { self.word.ys_before_x(index - 1) };
        let last =
            if index == self.word.xs() { self.word.ys() } else { self.word.ys_before_x(index) };
        first..=last
    }

    /// The indices on the x chain that cross edges join to index `index` on the y chain.
    fn opposite_of_y(&self, index: u32) -> RangeInclusive<u32> {
        let first = if index == 0 { 0 } else { self.word.xs_before_y(index - 1) };
        let last =
            if index == self.word.ys() { self.word.xs() } else { self.word.xs_before_y(index) };
        first..=last
    }
}

/// The consecutive vertices of one chain that cross edges join to one vertex of the other.
#[derive(Clone, Debug)]
pub(crate) struct Opposite {
    /// The chain of the one vertex. Counter-clockwise round a vertex of x, the y chain runs
    /// backwards.
    pub(crate) from: Letter,
    chain: Chain,
    indices: RangeInclusive<u32>,
}

impl Opposite {
    pub(crate) fn len(&self) -> u32 {
        if self.indices.is_empty() { 0 } else { self.indices.end() - self.indices.start() + 1 }
    }
}

impl Iterator for Opposite {
    type Item = u32;

    fn next(&mut self) -> Option<u32> {
        let index = match self.from {
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
    fn the_longest_chains_walk_the_largest_rings() {
        for len in crate::MAX_VERTICES - 2..=crate::MAX_VERTICES {
            let ring = Ring::new(len);
            for first in [0, 1, len / 2, len - 2, len - 1] {
                for direction in [Direction::CounterClockwise, Direction::Clockwise] {
                    let chain = Chain::new(first, len - 9, direction, ring);
                    for after in [0, 1, len / 2, len - 11, len - 10] {
                        for skipped in 0..7 {
                            let chain = chain.with_jump(Jump { after, skipped });
                            check_chain(&chain, u64::from(len), after, skipped);
                        }
                    }
                }
            }
        }
    }

    /// In 64 bits, at the ends of the chain and at its jump.
    fn check_chain(chain: &Chain, ring: u64, after: u32, skipped: u32) {
        let near_jump = after.saturating_sub(20)..after.saturating_add(20).min(chain.len());
        let ends = (0..20).chain(chain.len() - 20..chain.len());
        for index in ends.chain(near_jump) {
            let steps = u64::from(index) + if index > after { u64::from(skipped) } else { 0 };
            let first = u64::from(chain.first);
            let vertex = match chain.direction {
                Direction::CounterClockwise => (first + steps) % ring,
                Direction::Clockwise => (first + ring - steps) % ring,
            };
            assert_eq!(u64::from(chain.vertex(index)), vertex, "{chain:?}, {index}");
            assert_eq!(chain.index_of(vertex as u32), Some(index), "{chain:?}");
        }
        for step in 1..=skipped {
            let passed = match chain.direction {
                Direction::CounterClockwise => chain.ring.forward(chain.vertex(after), step),
                Direction::Clockwise => chain.ring.backward(chain.vertex(after), step),
            };
            assert_eq!(chain.index_of(passed), None, "{chain:?}");
        }
    }

    #[test]
    fn a_chain_walks_the_ring_both_ways_and_jumps() {
        let ring = Ring::new(10);
        let jump = Jump { after: 1, skipped: 3 };
        for (chain, vertices) in [
            (Chain::new(8, 4, Direction::CounterClockwise, ring), &[8, 9, 0, 1][..]),
            (Chain::new(1, 4, Direction::Clockwise, ring), &[1, 0, 9, 8]),
            (Chain::new(7, 4, Direction::CounterClockwise, ring).with_jump(jump), &[7, 8, 2, 3]),
            (Chain::new(1, 3, Direction::Clockwise, ring).with_jump(jump), &[1, 0, 6]),
        ] {
            let walked: Vec<u32> = (0..chain.len()).map(|index| chain.vertex(index)).collect();
            assert_eq!(walked, vertices);
            for vertex in 0..ring.len() {
                let index = vertices.iter().position(|&other| other == vertex);
                assert_eq!(chain.index_of(vertex), index.map(|index| index as u32), "{vertex}");
            }
        }
    }

    #[test]
    fn a_strip_emits_its_word() {
        // A ring of 8: ears at 0 and 4, x = 1 2 3, y = 7 6 5.
        let strip = Strip::new(
            0,
            Chain::new(1, 3, Direction::CounterClockwise, Ring::new(8)),
            Chain::new(7, 3, Direction::Clockwise, Ring::new(8)),
            Word::alternating(Letter::X, 2, 2),
            End::Ear(4),
        );
        let triangles: Vec<_> = (0..strip.triangle_count()).map(|i| strip.triangle(i)).collect();
        assert_eq!(triangles, [[0, 1, 7], [1, 2, 7], [2, 6, 7], [2, 3, 6], [3, 5, 6], [3, 4, 5]]);
        let edges: Vec<_> = (0..strip.interior_edge_count()).map(|i| strip.edge(i)).collect();
        assert_eq!(edges, [[1, 7], [2, 7], [2, 6], [3, 6], [3, 5]]);
        let opposite = |vertex| strip.opposite(vertex).map(|run| run.collect::<Vec<_>>());
        assert_eq!(opposite(2), Some([6, 7].into()));
        assert_eq!(opposite(7), Some([1, 2].into()));
        assert_eq!(opposite(0), None);
    }
}
