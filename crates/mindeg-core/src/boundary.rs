//! The input: how many intervals each side of a convex polygon has.
//!
//! Limits: no positions. The code that places the vertices must ensure a convex polygon.

use crate::Defect;
use crate::ring::Ring;
use alloc::format;
use alloc::vec::Vec;

/// The maximum number of boundary vertices, `2^32 - 2`.
///
/// Vertex indices are `u32`, and none is `u32::MAX`: graphics programs use that value for
/// primitive restart.
pub const MAX_VERTICES: u32 = u32::MAX - 1;

/// A convex polygon with each side divided into intervals; no positions.
///
/// Boundary vertices have the indices `0 … n-1`, counter-clockwise; vertex 0 is the corner
/// where side 0 starts. The interface counts sides from 0, messages count them from 1.
/// Memory is O(k) for k sides, whatever the number of intervals.
///
/// # Example
///
/// ```
/// use mindeg_core::Boundary;
///
/// let boundary = Boundary::new(&[3, 3, 2, 2])?;
/// assert_eq!(boundary.vertex_count(), 10);
/// assert_eq!(boundary.corner(2), 6);
/// assert_eq!(boundary.side_of(7), 2);
/// assert!(boundary.is_flat([0, 2, 3])); // all on side 0
/// assert!(!boundary.is_flat([9, 0, 1]));
/// # Ok::<(), mindeg_core::Defect>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Boundary {
    /// The first vertex of every side, then the vertex count: strictly increasing, k + 1 long.
    corners: Vec<u32>,
}

impl Boundary {
    /// A boundary from the number of intervals of each side, counter-clockwise: at least 3 sides,
    /// at least 1 interval on each. O(k).
    ///
    /// # Errors
    ///
    /// Fewer than three sides, a side without intervals, or more than [`MAX_VERTICES`] intervals
    /// in total.
    pub fn new(intervals: &[u64]) -> Result<Self, Defect> {
        if intervals.len() < 3 {
            let sides = intervals.len();
            let plural = if sides == 1 { "" } else { "s" };
            return Err(Defect::new(format!(
                "found {sides} side{plural}; a polygon needs at least 3"
            )));
        }
        let mut corners = Vec::with_capacity(intervals.len() + 1);
        let mut total = 0_u32;
        corners.push(total);
        for (side, &intervals) in (1..).zip(intervals) {
            if intervals == 0 {
                return Err(Defect::new(format!(
                    "side {side} has 0 intervals; every side needs at least 1"
                )));
            }
            total = u32::try_from(intervals)
                .ok()
                .and_then(|count| total.checked_add(count))
                .filter(|&total| total <= MAX_VERTICES)
                .ok_or_else(|| {
                    Defect::new(format!(
                        "side {side} has {intervals} intervals, with which the boundary exceeds the \
                         maximum of {MAX_VERTICES} vertices; use fewer intervals"
                    ))
                })?;
            corners.push(total);
        }
        Ok(Self { corners })
    }

    /// The number of sides, k >= 3.
    pub fn side_count(&self) -> usize {
        self.corners.len() - 1
    }

    /// The number of boundary vertices n, which is also the number of intervals. At least 3.
    pub fn vertex_count(&self) -> u32 {
        self.corners[self.side_count()]
    }

    /// The number of intervals of `side`, in `1..=n-2`. O(1).
    ///
    /// # Panics
    ///
    /// If `side` is not below [`side_count`](Self::side_count).
    pub fn intervals(&self, side: usize) -> u32 {
        self.corners[side + 1] - self.corners[side]
    }

    /// The number of intervals of each side, side 0 first.
    pub fn sides(&self) -> impl ExactSizeIterator<Item = u32> + '_ {
        self.corners.windows(2).map(|pair| pair[1] - pair[0])
    }

    /// The vertex where `side` starts; `corner(k)` is vertex 0 again. O(1).
    ///
    /// # Panics
    ///
    /// If `side` is above [`side_count`](Self::side_count).
    pub fn corner(&self, side: usize) -> u32 {
        if side == self.side_count() { 0 } else { self.corners[side] }
    }

    pub(crate) fn ring(&self) -> Ring {
        Ring::new(self.vertex_count())
    }

    /// The side of `vertex`; a corner belongs to the side that starts there.
    /// O(log k).
    ///
    /// # Panics
    ///
    /// If `vertex` is not below [`vertex_count`](Self::vertex_count).
    pub fn side_of(&self, vertex: u32) -> usize {
        let n = self.vertex_count();
        assert!(vertex < n, "vertex {vertex} does not exist; the boundary has {n} vertices");
        self.corners.partition_point(|&corner| corner <= vertex) - 1
    }

    /// Whether all three vertices lie on one side, so that the triangle has no area. O(log k).
    ///
    /// # Panics
    ///
    /// If a vertex is not below [`vertex_count`](Self::vertex_count).
    pub fn is_flat(&self, triangle: [u32; 3]) -> bool {
        let on_side = |side: usize| {
            triangle.iter().all(|&vertex| {
                (self.corners[side]..self.corners[side + 1]).contains(&vertex)
                    || vertex == self.corner(side + 1)
            })
        };
        // If three vertices lie on one side, at most one of them is the corner where the next side
        // starts. `side_of` gives that one side for the others.
        triangle.iter().any(|&vertex| on_side(self.side_of(vertex)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::string::ToString;

    #[test]
    fn indices_start_at_the_first_corner() {
        let boundary = Boundary::new(&[3, 1, 2]).unwrap();
        assert_eq!(boundary.vertex_count(), 6);
        assert_eq!((0..=3).map(|s| boundary.corner(s)).collect::<Vec<_>>(), [0, 3, 4, 0]);
        assert_eq!((0..6).map(|v| boundary.side_of(v)).collect::<Vec<_>>(), [0, 0, 0, 1, 2, 2]);
        assert!(boundary.sides().eq([3, 1, 2]));
        assert_eq!((0..3).map(|s| boundary.intervals(s)).collect::<Vec<_>>(), [3, 1, 2]);
    }

    #[test]
    fn flat_means_all_three_on_one_side() {
        let boundary = Boundary::new(&[3, 1, 2]).unwrap();
        for (triangle, flat) in [
            ([0, 1, 2], true),
            ([0, 1, 3], true),
            ([4, 5, 0], true),
            ([0, 4, 5], true),
            ([0, 3, 4], false),
            ([3, 4, 5], false),
            ([5, 0, 1], false),
        ] {
            assert_eq!(boundary.is_flat(triangle), flat, "{triangle:?}");
        }
    }

    #[test]
    fn a_refused_list_of_counts_names_the_side() {
        for (intervals, message) in [
            (&[][..], "found 0 sides; a polygon needs at least 3"),
            (&[5], "found 1 side; a polygon needs at least 3"),
            (&[1, 0, 1], "side 2 has 0 intervals; every side needs at least 1"),
            (
                &[1, 1, 1 << 40],
                "side 3 has 1099511627776 intervals, with which the boundary exceeds the maximum \
                 of 4294967294 vertices; use fewer intervals",
            ),
            (
                &[4_294_967_292, 1, 2],
                "side 3 has 2 intervals, with which the boundary exceeds the maximum of \
                 4294967294 vertices; use fewer intervals",
            ),
        ] {
            assert_eq!(Boundary::new(intervals).unwrap_err().to_string(), message);
        }
        assert_eq!(Boundary::new(&[4_294_967_292, 1, 1]).unwrap().vertex_count(), MAX_VERTICES);
    }
}
