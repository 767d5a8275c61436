//! The outline of a domain: rings of boundary points that stay where they are.

use crate::edge_tree::{EdgeTree, Item, is_straight};
use crate::exact::{meet, orientation};
use crate::triangle::{angle_at, cross};
use glam::DVec2;
use thiserror::Error;

/// Simple rings of boundary points: the outer one counter-clockwise, holes clockwise.
///
/// The domain lies to the left of every edge. Rings do not touch themselves or each other.
#[derive(Debug, Clone)]
pub struct Outline {
    points: Vec<DVec2>,
    next: Vec<u32>,
    previous: Vec<u32>,
    starts: Vec<u32>,
}

/// Why rings of points do not bound a domain.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum OutlineError {
    /// No ring at all.
    #[error("the outline has no ring; give an outer ring of at least 3 points")]
    NoRing,
    /// More points than indices.
    #[error("the outline has more than {max} points")]
    TooManyPoints {
        /// The greatest number of points.
        max: usize,
    },
    /// A ring without an area.
    #[error("ring {ring} has {points} points; a ring has at least 3")]
    ShortRing {
        /// The ring's index.
        ring: usize,
        /// Its points.
        points: usize,
    },
    /// A coordinate that is no ordinary number, or too great or small to square.
    #[error("vertex {vertex} of the outline is at ({}, {}); coordinates are finite, and 0 or of magnitude 1e-70 to 1e70", at[0], at[1])]
    Coordinate {
        /// The vertex.
        vertex: u32,
        /// Its position.
        at: [f64; 2],
    },
    /// A ring that goes round the wrong way.
    #[error("ring {ring} runs {}; reverse it: the outer ring (ring 0) runs counter-clockwise and holes run clockwise", if *.ring == 0 { "clockwise" } else { "counter-clockwise" })]
    Direction {
        /// The ring's index.
        ring: usize,
    },
    /// Two edges that have a point in common which is not their common end.
    #[error("boundary edges {}-{} and {}-{} touch or cross; rings must not touch themselves or each other", first[0], first[1], second[0], second[1])]
    Crossing {
        /// The vertices of one edge.
        first: [u32; 2],
        /// The vertices of the other.
        second: [u32; 2],
    },
    /// A hole outside the outer ring or inside another hole.
    #[error(
        "ring {ring} does not lie inside the domain; holes lie inside ring 0 and outside each other"
    )]
    Nesting {
        /// The hole's index.
        ring: usize,
    },
}

/// The greatest number of points of a mesh.
pub(crate) const MAX_POINTS: usize = 1 << 30;

/// True for coordinates whose squares, and areas made of them, neither overflow nor vanish.
pub(crate) fn is_usable(point: DVec2) -> bool {
    point.to_array().iter().all(|x| *x == 0.0 || (1e-70..=1e70).contains(&x.abs()))
}

impl Outline {
    /// An outline from its rings: the outer ring first, then the holes.
    ///
    /// Vertices are numbered through the rings in their order. O(n log n) where edges are short
    /// beside the domain.
    ///
    /// # Errors
    ///
    /// If a ring is too short, runs the wrong way, touches itself or another ring, or if a
    /// hole lies outside.
    pub fn new<R: AsRef<[DVec2]>>(rings: &[R]) -> Result<Self, OutlineError> {
        if rings.is_empty() {
            return Err(OutlineError::NoRing);
        }
        let count: usize = rings.iter().map(|ring| ring.as_ref().len()).sum();
        if count > MAX_POINTS {
            return Err(OutlineError::TooManyPoints { max: MAX_POINTS });
        }
        let mut outline = Self::with_capacity(count);
        for (ring, points) in rings.iter().map(AsRef::as_ref).enumerate() {
            outline.push(ring, points)?;
        }
        outline.starts.push(count as u32);
        outline.check_crossings()?;
        outline.check_nesting()?;
        Ok(outline)
    }

    fn with_capacity(count: usize) -> Self {
        Self {
            points: Vec::with_capacity(count),
            next: Vec::with_capacity(count),
            previous: Vec::with_capacity(count),
            starts: Vec::new(),
        }
    }

    /// A search tree over the edges; an edge's id is its first vertex.
    pub(crate) fn edge_tree(&self) -> EdgeTree {
        EdgeTree::of_rings(self.rings().map(|ring| {
            let start = ring.clone().find(|v| self.is_corner(*v)).unwrap_or(ring.start);
            let ids = (start..ring.end).chain(ring.start..start);
            let item = |id| Item {
                id,
                from: self.point(id),
                to: self.point(self.next(id)),
                size: self.length(id),
            };
            ids.map(item).collect()
        }))
    }

    /// True if the boundary turns here.
    fn is_corner(&self, vertex: u32) -> bool {
        let [before, at, after] =
            [self.previous(vertex), vertex, self.next(vertex)].map(|v| self.point(v));
        !is_straight(at - before, after - at)
    }

    /// The vertices where the boundary turns, in ascending order.
    pub(crate) fn corners(&self) -> impl Iterator<Item = u32> + '_ {
        (0..self.points.len() as u32).filter(|vertex| self.is_corner(*vertex))
    }

    /// An outline from rings that are known to bound triangles, in any number and order.
    pub(crate) fn of_mesh(rings: &[Vec<DVec2>]) -> Self {
        let mut outline = Self::with_capacity(0);
        rings.iter().for_each(|ring| outline.link(ring));
        outline.starts.push(outline.points.len() as u32);
        outline
    }

    fn link(&mut self, points: &[DVec2]) {
        let start = self.points.len() as u32;
        let end = start + points.len() as u32;
        self.starts.push(start);
        self.points.extend(points);
        self.next.extend((start + 1..end).chain([start]));
        self.previous.extend([end - 1].into_iter().chain(start..end - 1));
    }

    fn push(&mut self, ring: usize, points: &[DVec2]) -> Result<(), OutlineError> {
        let (start, count) = (self.points.len() as u32, points.len());
        if count < 3 {
            return Err(OutlineError::ShortRing { ring, points: count });
        }
        if let Some(bad) = points.iter().position(|point| !is_usable(*point)) {
            let at = points[bad].to_array();
            return Err(OutlineError::Coordinate { vertex: start + bad as u32, at });
        }
        self.link(points);
        let area: f64 =
            (1..count - 1).map(|i| cross(points[i] - points[0], points[i + 1] - points[0])).sum();
        if (area < 0.0) == (ring == 0) {
            return Err(OutlineError::Direction { ring });
        }
        Ok(())
    }

    fn check_crossings(&self) -> Result<(), OutlineError> {
        let tree = self.edge_tree();
        for [a, b] in self.edges() {
            let (from, to) = (self.point(a), self.point(b));
            let mut crossed = None;
            tree.visit(
                |node| node.may_touch(from, to),
                |edge| {
                    let [c, d] = [edge, self.next(edge)];
                    // Each pair once; neighbours have an end in common and must not fold back.
                    let is_bad = if c <= a {
                        false
                    } else if c == b || d == a {
                        let corner = if c == b { b } else { a };
                        self.folds_back(corner)
                    } else {
                        meet(from, to, self.point(c), self.point(d))
                    };
                    if is_bad && crossed.is_none() {
                        crossed = Some([c, d]);
                    }
                },
            );
            if let Some(second) = crossed {
                return Err(OutlineError::Crossing { first: [a, b], second });
            }
        }
        Ok(())
    }

    /// True if the boundary turns by 180 degrees here, so that its two edges overlap.
    fn folds_back(&self, vertex: u32) -> bool {
        let [before, at, after] =
            [self.previous(vertex), vertex, self.next(vertex)].map(|v| self.point(v));
        before == at
            || after == at
            || orientation(before, at, after) == 0.0 && (before - at).dot(after - at) > 0.0
    }

    fn check_nesting(&self) -> Result<(), OutlineError> {
        for ring in 1..self.ring_count() {
            let probe = self.point(self.starts[ring]);
            let winding = |other: usize| self.winds(other, probe);
            let outside = !winding(0) || (1..self.ring_count()).any(|o| o != ring && winding(o));
            if outside {
                return Err(OutlineError::Nesting { ring });
            }
        }
        Ok(())
    }

    /// True if `ring` goes round `probe`, which is not on it.
    fn winds(&self, ring: usize, probe: DVec2) -> bool {
        let mut is_inside = false;
        for vertex in self.starts[ring]..self.starts[ring + 1] {
            let (a, b) = (self.point(vertex), self.point(self.next(vertex)));
            if (a.y <= probe.y) != (b.y <= probe.y) {
                let is_left = orientation(a, b, probe) > 0.0;
                is_inside ^= is_left == (b.y > a.y);
            }
        }
        is_inside
    }

    /// The boundary points, ring after ring.
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// The number of rings: 1 and the number of holes.
    #[must_use]
    pub fn ring_count(&self) -> usize {
        self.starts.len() - 1
    }

    /// The boundary edges, the domain to the left of each.
    pub fn edges(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        (0..).zip(&self.next).map(|(vertex, next)| [vertex, *next])
    }

    /// The vertex after `vertex` on its ring.
    ///
    /// # Panics
    ///
    /// If the outline has no such vertex.
    #[must_use]
    pub fn next(&self, vertex: u32) -> u32 {
        self.next[vertex as usize]
    }

    /// The vertex before `vertex` on its ring.
    ///
    /// # Panics
    ///
    /// If the outline has no such vertex.
    #[must_use]
    pub fn previous(&self, vertex: u32) -> u32 {
        self.previous[vertex as usize]
    }

    /// The interior angle at a vertex in radians, above 0 and below 2 pi.
    ///
    /// # Panics
    ///
    /// If the outline has no such vertex.
    #[must_use]
    pub fn angle(&self, vertex: u32) -> f64 {
        angle_at(
            self.point(vertex),
            self.point(self.next(vertex)),
            self.point(self.previous(vertex)),
        )
    }

    pub(crate) fn point(&self, vertex: u32) -> DVec2 {
        self.points[vertex as usize]
    }

    /// The length of the edge from `vertex` to the next.
    pub(crate) fn length(&self, vertex: u32) -> f64 {
        self.point(vertex).distance(self.point(self.next(vertex)))
    }

    /// The longer side of the box round all points.
    pub(crate) fn extent(&self) -> f64 {
        let points = || self.points.iter().copied();
        let low = points().reduce(DVec2::min).unwrap_or_default();
        let high = points().reduce(DVec2::max).unwrap_or_default();
        (high - low).max_element()
    }

    /// The vertices of each ring.
    pub(crate) fn rings(&self) -> impl Iterator<Item = std::ops::Range<u32>> + '_ {
        self.starts.windows(2).map(|ends| ends[0]..ends[1])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(points: &[[f64; 2]]) -> Vec<DVec2> {
        points.iter().copied().map(DVec2::from).collect()
    }

    fn square(x: f64, y: f64, size: f64) -> Vec<DVec2> {
        ring(&[[x, y], [x + size, y], [x + size, y + size], [x, y + size]])
    }

    fn hole(x: f64, y: f64, size: f64) -> Vec<DVec2> {
        square(x, y, size).into_iter().rev().collect()
    }

    #[test]
    fn a_square_with_two_holes_is_an_outline() {
        let outline =
            Outline::new(&[square(0.0, 0.0, 9.0), hole(1.0, 1.0, 2.0), hole(5.0, 5.0, 1.0)]);
        let outline = outline.unwrap();
        assert_eq!(outline.ring_count(), 3);
        assert_eq!(outline.next(3), 0);
        assert_eq!(outline.previous(4), 7);
        assert!((outline.angle(0).to_degrees() - 90.0).abs() < 1e-12);
        assert!((outline.angle(4).to_degrees() - 270.0).abs() < 1e-12);
    }

    #[test]
    fn bad_rings_are_refused() {
        let error = |rings: &[Vec<DVec2>]| Outline::new(rings).unwrap_err();
        assert_eq!(error(&[]), OutlineError::NoRing);
        assert_eq!(
            error(&[ring(&[[0.0, 0.0], [1.0, 0.0]])]),
            OutlineError::ShortRing { ring: 0, points: 2 }
        );
        assert!(matches!(
            error(&[ring(&[[0.0, 0.0], [f64::NAN, 0.0], [1.0, 1.0]])]),
            OutlineError::Coordinate { vertex: 1, .. }
        ));
        assert_eq!(error(&[hole(0.0, 0.0, 1.0)]), OutlineError::Direction { ring: 0 });
        let outer = square(0.0, 0.0, 9.0);
        assert_eq!(
            error(&[outer.clone(), square(1.0, 1.0, 1.0)]),
            OutlineError::Direction { ring: 1 }
        );
        assert_eq!(
            error(&[outer.clone(), hole(20.0, 0.0, 1.0)]),
            OutlineError::Nesting { ring: 1 }
        );
        // Between the arms of a U.
        let u = [
            [0.0, 0.0],
            [9.0, 0.0],
            [9.0, 9.0],
            [6.0, 9.0],
            [6.0, 3.0],
            [3.0, 3.0],
            [3.0, 9.0],
            [0.0, 9.0],
        ];
        assert_eq!(error(&[ring(&u), hole(4.0, 5.0, 1.0)]), OutlineError::Nesting { ring: 1 });
        assert_eq!(
            error(&[outer.clone(), hole(1.0, 1.0, 4.0), hole(2.0, 2.0, 1.0)]),
            OutlineError::Nesting { ring: 2 }
        );
        assert!(matches!(
            error(&[outer.clone(), hole(8.0, 8.0, 4.0)]),
            OutlineError::Crossing { .. }
        ));
        // A bow tie with a positive area, a spike, and a repeated point.
        let tie = ring(&[[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 3.0], [-9.0, 1.0]]);
        assert!(matches!(
            error(&[tie]),
            OutlineError::Crossing { .. } | OutlineError::Direction { .. }
        ));
        let spike = ring(&[[0.0, 0.0], [4.0, 0.0], [8.0, 0.0], [4.0, 0.0], [0.0, 4.0]]);
        assert!(matches!(error(&[spike]), OutlineError::Crossing { .. }));
        let twice = ring(&[[0.0, 0.0], [4.0, 0.0], [4.0, 0.0], [0.0, 4.0]]);
        assert!(matches!(error(&[twice]), OutlineError::Crossing { .. }));
    }
}
