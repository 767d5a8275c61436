//! The boundary of a domain without positions: rings of sides, and sides of intervals.
//!
//! Ring 0 is the outer one, the others are holes. Vertices and sides have indices ring after ring,
//! from the first corner of each ring on, with the domain on the left: counter-clockwise round the
//! outer ring, clockwise round a hole.
//!
//! Limits: up to [`MAX_VERTICES`] vertices in all.

use std::ops::Range;

use mindeg_core::MAX_VERTICES;
use mindeg_mesh::planar::{InRing, ring_name};

use crate::error::{DomainError, Place, counted};

/// The rings of a boundary, each divided into sides, each side into intervals; no positions.
///
/// Memory is O(k) for k sides, whatever the number of intervals.
///
/// # Example
///
/// ```
/// use mindeg_domain::Rings;
///
/// // A square with a triangular hole.
/// let rings = Rings::new(&[&[3, 3, 2, 2][..], &[1, 2, 1]])?;
/// assert_eq!((rings.vertex_count(), rings.ring_count()), (14, 2));
/// assert_eq!((rings.ring(1), rings.ring_sides(1)), (10..14, 4..7));
/// assert_eq!((rings.corner(5), rings.side_end(5)), (11, 13));
/// assert_eq!((rings.next(9), rings.next(13), rings.previous(10)), (0, 10, 13));
/// assert_eq!((rings.side_of(12), rings.ring_of(12)), (5, 1));
/// # Ok::<(), mindeg_domain::DomainError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rings {
    /// The first vertex of every side, then the vertex count: strictly increasing, k + 1 long.
    corners: Vec<u32>,
    /// The first side of every ring, then the side count: strictly increasing.
    first_sides: Vec<usize>,
}

impl Rings {
    /// Rings from the number of intervals of each side of each ring. O(k).
    ///
    /// # Errors
    ///
    /// No ring, a ring with fewer than three intervals, a side without intervals, or more than
    /// [`MAX_VERTICES`] intervals in total.
    pub fn new<S: AsRef<[u64]>>(rings: &[S]) -> Result<Self, DomainError> {
        if rings.is_empty() {
            return Err(Place::default().error("a boundary needs an outer ring"));
        }
        let (mut corners, mut first_sides) = (vec![0], vec![0]);
        let mut total = 0_u32;
        for (ring, sides) in rings.iter().enumerate() {
            let start = total;
            for (index, &intervals) in sides.as_ref().iter().enumerate() {
                let side = InRing { ring, index };
                if intervals == 0 {
                    let name = side.side();
                    return Err(Place::side(side)
                        .then("intervals")
                        .error(format!("{name} has 0 intervals; every side needs at least 1")));
                }
                total = u32::try_from(intervals)
                    .ok()
                    .and_then(|count| total.checked_add(count))
                    .filter(|&total| total <= MAX_VERTICES)
                    .ok_or_else(|| {
                        Place::side(side).then("intervals").error(format!(
                            "{} has {intervals} intervals, with which the boundary exceeds the \
                                 maximum of {MAX_VERTICES} vertices; use fewer intervals",
                            side.side()
                        ))
                    })?;
                corners.push(total);
            }
            let intervals = total - start;
            if intervals < 3 {
                let found = counted(intervals as usize, "interval");
                return Err(Place::ring(ring)
                    .then("sides")
                    .error(format!("{} has {found}; a ring needs at least 3", ring_name(ring))));
            }
            first_sides.push(corners.len() - 1);
        }
        Ok(Self { corners, first_sides })
    }

    /// The number of vertices n of all rings, which is also the number of intervals.
    pub fn vertex_count(&self) -> u32 {
        self.corners[self.side_count()]
    }

    /// The number of triangles of every mesh without further points: n + 2 h - 2 with h holes.
    pub fn triangle_count(&self) -> u32 {
        self.vertex_count() + 2 * (self.ring_count() as u32 - 1) - 2
    }

    /// The number of rings, at least 1: the outer one and the holes.
    pub fn ring_count(&self) -> usize {
        self.first_sides.len() - 1
    }

    /// The vertices of a ring, at least 3.
    ///
    /// # Panics
    ///
    /// If `ring` is not below [`ring_count`](Self::ring_count).
    pub fn ring(&self, ring: usize) -> Range<u32> {
        let Range { start, end } = self.ring_sides(ring);
        self.corners[start]..self.corners[end]
    }

    /// The vertices of all rings, ring by ring.
    pub fn rings(&self) -> impl ExactSizeIterator<Item = Range<u32>> + '_ {
        (0..self.ring_count()).map(|ring| self.ring(ring))
    }

    /// The sides of a ring, at least 1.
    ///
    /// # Panics
    ///
    /// If `ring` is not below [`ring_count`](Self::ring_count).
    pub fn ring_sides(&self, ring: usize) -> Range<usize> {
        self.first_sides[ring]..self.first_sides[ring + 1]
    }

    /// The ring of a side. O(log h) for h rings.
    ///
    /// # Panics
    ///
    /// If `side` is not below [`side_count`](Self::side_count).
    pub fn ring_of_side(&self, side: usize) -> usize {
        let count = self.side_count();
        assert!(side < count, "side {side} does not exist; the boundary has {count} sides");
        self.first_sides.partition_point(|&first| first <= side) - 1
    }

    /// A side by its ring and its index in it. O(log h).
    ///
    /// # Panics
    ///
    /// If `side` is not below [`side_count`](Self::side_count).
    pub fn in_ring(&self, side: usize) -> InRing {
        let ring = self.ring_of_side(side);
        InRing { ring, index: side - self.first_sides[ring] }
    }

    /// The number of sides k of all rings.
    pub fn side_count(&self) -> usize {
        self.corners.len() - 1
    }

    /// The number of intervals of `side`. O(1).
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

    /// The vertex where `side` starts. O(1).
    ///
    /// # Panics
    ///
    /// If `side` is not below [`side_count`](Self::side_count).
    pub fn corner(&self, side: usize) -> u32 {
        let count = self.side_count();
        assert!(side < count, "side {side} does not exist; the boundary has {count} sides");
        self.corners[side]
    }

    /// The vertices where sides start, ascending.
    pub fn corner_vertices(&self) -> &[u32] {
        &self.corners[..self.side_count()]
    }

    /// The vertex where `side` ends and the next side of its ring starts. O(log h).
    ///
    /// # Panics
    ///
    /// If `side` is not below [`side_count`](Self::side_count).
    pub fn side_end(&self, side: usize) -> u32 {
        self.corners[self.next_side(side)]
    }

    /// The side after `side` in its ring. O(log h).
    ///
    /// # Panics
    ///
    /// If `side` is not below [`side_count`](Self::side_count).
    pub fn next_side(&self, side: usize) -> usize {
        let Range { start, end } = self.ring_sides(self.ring_of_side(side));
        if side + 1 == end { start } else { side + 1 }
    }

    /// The side before `side` in its ring. O(log h).
    ///
    /// # Panics
    ///
    /// If `side` is not below [`side_count`](Self::side_count).
    pub fn previous_side(&self, side: usize) -> usize {
        let Range { start, end } = self.ring_sides(self.ring_of_side(side));
        if side == start { end - 1 } else { side - 1 }
    }

    /// The side of `vertex`; a corner belongs to the side that starts there. O(log k).
    ///
    /// # Panics
    ///
    /// If `vertex` is not below [`vertex_count`](Self::vertex_count).
    pub fn side_of(&self, vertex: u32) -> usize {
        let n = self.vertex_count();
        assert!(vertex < n, "vertex {vertex} does not exist; the boundary has {n} vertices");
        self.corners.partition_point(|&corner| corner <= vertex) - 1
    }

    /// The ring of `vertex`. O(log h).
    ///
    /// # Panics
    ///
    /// If `vertex` is not below [`vertex_count`](Self::vertex_count).
    pub fn ring_of(&self, vertex: u32) -> usize {
        let n = self.vertex_count();
        assert!(vertex < n, "vertex {vertex} does not exist; the boundary has {n} vertices");
        self.first_sides.partition_point(|&first| self.corners[first] <= vertex) - 1
    }

    /// The vertex after `vertex` round its ring. O(log h).
    ///
    /// # Panics
    ///
    /// If `vertex` is not below [`vertex_count`](Self::vertex_count).
    pub fn next(&self, vertex: u32) -> u32 {
        let Range { start, end } = self.ring(self.ring_of(vertex));
        if vertex + 1 == end { start } else { vertex + 1 }
    }

    /// The vertex before `vertex` round its ring. O(log h).
    ///
    /// # Panics
    ///
    /// If `vertex` is not below [`vertex_count`](Self::vertex_count).
    pub fn previous(&self, vertex: u32) -> u32 {
        let Range { start, end } = self.ring(self.ring_of(vertex));
        if vertex == start { end - 1 } else { vertex - 1 }
    }

    /// Whether `vertex` is a corner; false for vertices that do not exist. O(log k).
    pub fn is_corner(&self, vertex: u32) -> bool {
        self.corners[..self.side_count()].binary_search(&vertex).is_ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn three() -> Rings {
        Rings::new(&[vec![3, 1, 2], vec![3], vec![1, 1, 1]]).unwrap()
    }

    #[test]
    fn indices_run_ring_by_ring() {
        let rings = three();
        assert_eq!((rings.vertex_count(), rings.side_count(), rings.ring_count()), (12, 7, 3));
        assert!(rings.rings().eq([0..6, 6..9, 9..12]));
        assert!(rings.sides().eq([3, 1, 2, 3, 1, 1, 1]));
        let sides = 0..7;
        assert!(sides.clone().map(|s| rings.corner(s)).eq([0, 3, 4, 6, 9, 10, 11]));
        assert!(sides.clone().map(|s| rings.side_end(s)).eq([3, 4, 0, 6, 10, 11, 9]));
        assert!(sides.clone().map(|s| rings.ring_of_side(s)).eq([0, 0, 0, 1, 2, 2, 2]));
        assert!(sides.clone().map(|s| rings.next_side(s)).eq([1, 2, 0, 3, 5, 6, 4]));
        assert!(sides.clone().map(|s| rings.previous_side(s)).eq([2, 0, 1, 3, 6, 4, 5]));
        assert!(sides.map(|s| rings.in_ring(s).index).eq([0, 1, 2, 0, 0, 1, 2]));
        let vertices = 0..12;
        assert!(
            vertices.clone().map(|v| rings.side_of(v)).eq([0, 0, 0, 1, 2, 2, 3, 3, 3, 4, 5, 6])
        );
        assert!(vertices.clone().map(|v| rings.next(v)).eq([1, 2, 3, 4, 5, 0, 7, 8, 6, 10, 11, 9]));
        assert!(vertices.clone().all(|v| rings.previous(rings.next(v)) == v));
        assert!(
            vertices.clone().map(|v| rings.ring_of(v)).eq([0, 0, 0, 0, 0, 0, 1, 1, 1, 2, 2, 2])
        );
        assert!((0..=12).filter(|&v| rings.is_corner(v)).eq([0, 3, 4, 6, 9, 10, 11]));
    }

    #[test]
    fn refuses_with_the_reason() {
        let message = |rings: &[Vec<u64>]| Rings::new(rings).unwrap_err().to_string();
        let most = u64::from(MAX_VERTICES);
        #[rustfmt::skip]
        let table = [
            (vec![], "a boundary needs an outer ring"),
            (vec![vec![]], "the outline has 0 intervals; a ring needs at least 3"),
            (vec![vec![1, 1]], "the outline has 2 intervals; a ring needs at least 3"),
            (vec![vec![3], vec![1]], "hole 1 has 1 interval; a ring needs at least 3"),
            (vec![vec![1, 0, 1]], "side 2 has 0 intervals; every side needs at least 1"),
            (vec![vec![3], vec![3], vec![3, 0]], "side 2 of hole 2 has 0 intervals; every side needs at least 1"),
            (vec![vec![3], vec![1 << 40]], "side 1 of hole 1 has 1099511627776 intervals, with which the boundary exceeds the maximum of 4294967294 vertices; use fewer intervals"),
            (vec![vec![most - 2, 3]], "side 2 has 3 intervals, with which the boundary exceeds the maximum of 4294967294 vertices; use fewer intervals"),
        ];
        for (rings, expected) in table {
            assert_eq!(message(&rings), expected);
        }
        assert_eq!(Rings::new(&[[most - 3, 3]]).unwrap().vertex_count(), MAX_VERTICES);
    }
}
