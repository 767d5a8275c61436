//! The rank of triangulations whose angles are all large enough.

use crate::measure;
use glam::DVec2;
use std::cmp::Ordering;

/// The rank of the triangulation of a piece: greater is better, and the best whole consists of best
/// pieces.
pub(crate) trait Merit: Copy + Ord + Send + Sync {
    /// The merit of a piece without triangles, a boundary edge.
    const EMPTY: Self;
    /// Whether all triangulations have equal rank.
    const ALL_EQUAL: bool;

    fn of_triangle(corners: [DVec2; 3]) -> Self;

    fn plus(self, other: Self) -> Self;

    /// The merit with one more vertex at its degree limit.
    fn with_full_vertex(self) -> Self;
}

/// Any triangulation.
impl Merit for () {
    const EMPTY: Self = ();
    const ALL_EQUAL: bool = true;

    fn of_triangle(_: [DVec2; 3]) -> Self {}

    fn plus(self, (): Self) -> Self {}

    fn with_full_vertex(self) -> Self {}
}

/// The rule for ties: fewer vertices at their degree limit, then a larger sum of `shape`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct TieBreak {
    /// The number of vertices at their degree limit.
    pub(crate) full_vertices: u32,
    /// In units of 1/[`measure::SHAPE_UNIT`].
    pub(crate) shape: u64,
}

impl Ord for TieBreak {
    fn cmp(&self, other: &Self) -> Ordering {
        let fewer = other.full_vertices.cmp(&self.full_vertices);
        fewer.then(self.shape.cmp(&other.shape))
    }
}

impl PartialOrd for TieBreak {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Merit for TieBreak {
    const EMPTY: Self = Self { full_vertices: 0, shape: 0 };
    const ALL_EQUAL: bool = false;

    fn of_triangle(corners: [DVec2; 3]) -> Self {
        Self { full_vertices: 0, shape: measure::shape(corners) }
    }

    fn plus(self, other: Self) -> Self {
        Self {
            full_vertices: self.full_vertices + other.full_vertices,
            shape: self.shape + other.shape,
        }
    }

    fn with_full_vertex(self) -> Self {
        Self { full_vertices: self.full_vertices + 1, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn full_vertices_come_before_shape() {
        let [few_plain, few_fair, many_fair] = [(1, 5), (1, 6), (2, 9)]
            .map(|(full_vertices, shape)| TieBreak { full_vertices, shape });
        assert!(many_fair < few_plain && few_plain < few_fair);
        assert!(few_fair.with_full_vertex() < few_fair);
        let both = TieBreak { full_vertices: 3, shape: 14 };
        assert_eq!(few_plain.plus(many_fair), both);
        assert_eq!(both.plus(TieBreak::EMPTY), both);
    }
}
