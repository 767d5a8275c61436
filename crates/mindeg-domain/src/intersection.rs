//! Rings that are not simple, not apart, or not holes of the outer one: where, and what to do.
//!
//! Limits: of several faults the first from the left is reported.

use std::fmt;

use glam::DVec2;
use mindeg_mesh::planar::BoundaryFault;

use crate::rings::{InRing, Rings};

/// A boundary point, by the side that starts there or that it lies on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointPlace {
    /// The side.
    pub side: InRing,
    /// The index of the point on its side, from 0 at the corner where the side starts.
    pub index: u32,
    /// Whether the side is the whole ring, so that its points are counted with the corner.
    pub is_alone: bool,
    /// The x coordinate.
    pub x: f64,
    /// The y coordinate.
    pub y: f64,
}

/// A boundary edge, by its side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EdgePlace {
    /// The side.
    pub side: InRing,
    /// The index of the edge on its side, from 0.
    pub index: u32,
    /// Whether the side is one edge.
    pub is_side: bool,
    /// Whether the side is the whole ring.
    pub is_alone: bool,
}

/// "corner 3", "point 4 of side 2 of hole 1", or "point 12" of a ring that is one side.
impl fmt::Display for PointPlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { side: InRing { ring, .. }, index, .. } = *self;
        match index {
            _ if self.is_alone => {
                f.write_str(&InRing { ring, index: index as usize }.named("point"))
            }
            0 => f.write_str(&self.side.corner()),
            _ => write!(f, "point {index} of {}", self.side.side()),
        }
    }
}

/// "side 3", "interval 5 of side 3 of hole 1", or "edge 12" of a ring that is one side.
impl fmt::Display for EdgePlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_alone {
            let edge = InRing { index: self.index as usize, ..self.side };
            return f.write_str(&edge.named("edge"));
        }
        if !self.is_side {
            write!(f, "interval {} of ", self.index + 1)?;
        }
        f.write_str(&self.side.side())
    }
}

/// Why rings are not the boundary of a domain.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum IntersectionError {
    /// The boundary passes a point twice.
    #[error(
        "{second} is at ({:?}, {:?}), where {first} is too; a boundary passes each point once: move \
         one of them, or split the ring there",
        second.x, second.y
    )]
    RepeatedPoint {
        /// The one.
        first: PointPlace,
        /// The other.
        second: PointPlace,
    },
    /// A point lies on an edge that it is no end of.
    #[error(
        "{point} at ({:?}, {:?}) lies on {edge}; rings may not touch: move the point off, or split \
         the ring there",
        point.x, point.y
    )]
    Touch {
        /// The point.
        point: PointPlace,
        /// The edge.
        edge: EdgePlace,
    },
    /// Two edges cross.
    #[error(
        "{first} and {second} cross near ({x:?}, {y:?}); list the points in the order in which they \
         lie around the domain, and keep rings apart"
    )]
    Crossing {
        /// The one.
        first: EdgePlace,
        /// The other.
        second: EdgePlace,
        /// The x coordinate of the crossing, rounded.
        x: f64,
        /// The y coordinate of the crossing, rounded.
        y: f64,
    },
    /// The edges at a point lie on each other.
    #[error(
        "the boundary folds back on itself at {point} at ({:?}, {:?}) (0°); drop the point or move it",
        point.x, point.y
    )]
    FoldsBack {
        /// The point.
        point: PointPlace,
    },
    /// A hole outside the outer ring.
    #[error(
        "hole {hole} lies outside the outline, with its first corner at ({x:?}, {y:?}); move it \
         inside, or drop it"
    )]
    HoleOutside {
        /// The hole, from 1.
        hole: usize,
        /// The x coordinate of its first corner.
        x: f64,
        /// The y coordinate of its first corner.
        y: f64,
    },
    /// A hole inside another hole.
    #[error(
        "hole {hole} lies inside hole {around}, with its first corner at ({x:?}, {y:?}); drop one of \
         them"
    )]
    HoleInHole {
        /// The hole, from 1.
        hole: usize,
        /// The hole around it, from 1.
        around: usize,
        /// The x coordinate of its first corner.
        x: f64,
        /// The y coordinate of its first corner.
        y: f64,
    },
    /// A hole around the outer ring.
    #[error(
        "the outline lies inside hole {hole}; give the outer ring first, and the holes inside it"
    )]
    HoleAround {
        /// The hole, from 1.
        hole: usize,
    },
    /// Any other fault of the points.
    #[error("{0}; move the point")]
    Other(BoundaryFault),
}

/// A fault of the rings with its places in words.
pub(crate) fn placed(fault: BoundaryFault, points: &[DVec2], rings: &Rings) -> IntersectionError {
    let vertex = |at: InRing| rings.ring(at.ring).start + at.index as u32;
    let is_alone = |ring: usize| rings.ring_sides(ring).len() == 1;
    let point = |at: InRing| {
        let (vertex, is_alone) = (vertex(at), is_alone(at.ring));
        let side = rings.side_of(vertex);
        let DVec2 { x, y } = points[vertex as usize];
        let index = vertex - rings.corner(side);
        PointPlace { side: rings.in_ring(side), index, is_alone, x, y }
    };
    let edge = |at: InRing| {
        let (begin, is_alone) = (vertex(at), is_alone(at.ring));
        let side = rings.side_of(begin);
        let (index, is_side) = (begin - rings.corner(side), rings.intervals(side) == 1);
        EdgePlace { side: rings.in_ring(side), index, is_side, is_alone }
    };
    let corner = |ring: usize| points[rings.ring(ring).start as usize];
    match fault {
        BoundaryFault::SamePoint(vertices) => {
            let [first, second] = vertices.map(point);
            IntersectionError::RepeatedPoint { first, second }
        }
        BoundaryFault::Touch { vertex, edge: on } => {
            IntersectionError::Touch { point: point(vertex), edge: edge(on) }
        }
        BoundaryFault::FoldsBack(vertex) => IntersectionError::FoldsBack { point: point(vertex) },
        BoundaryFault::Crossing(edges) => {
            let ends = |at| [vertex(at), rings.next(vertex(at))].map(|v| points[v as usize]);
            let DVec2 { x, y } = crossing(edges.map(ends));
            let [first, second] = edges.map(edge);
            IntersectionError::Crossing { first, second, x, y }
        }
        BoundaryFault::HoleInHole { hole, around } => {
            let DVec2 { x, y } = corner(hole);
            IntersectionError::HoleInHole { hole, around, x, y }
        }
        BoundaryFault::HoleAround { hole } => IntersectionError::HoleAround { hole },
        BoundaryFault::HoleOutside { hole } => {
            let DVec2 { x, y } = corner(hole);
            IntersectionError::HoleOutside { hole, x, y }
        }
        // Rings are long enough, their points finite, and either way round is taken.
        fault => IntersectionError::Other(fault),
    }
}

/// Where two edges cross, for a message.
fn crossing([[a, b], [c, d]]: [[DVec2; 2]; 2]) -> DVec2 {
    let (first, second) = (b - a, d - c);
    let share = (c - a).perp_dot(second) / first.perp_dot(second);
    let share = if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.5 };
    a + share * first
}

#[cfg(test)]
mod tests {
    use crate::{Domain, DomainError, Ring, Side};

    fn ring(corners: &[[f64; 2]], intervals: u64) -> Ring {
        Ring::new(corners.iter().copied(), vec![Side::count(intervals); corners.len()])
    }

    const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]];

    fn holes(holes: &[Ring]) -> Result<Domain, DomainError> {
        Domain::of_rings([&[ring(&SQUARE, 2)], holes].concat())
    }

    #[test]
    fn names_the_place() {
        let of = |corners: &[[f64; 2]], intervals| Domain::of_rings(vec![ring(corners, intervals)]);
        let triangle = |x: f64, y: f64| ring(&[[x, y], [x + 1.0, y], [x, y + 1.0]], 1);
        #[rustfmt::skip]
        let table = [
            (of(&[[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]], 1), "side 1 and side 3 cross near (0.5, 0.5); list the points in the order in which they lie around the domain, and keep rings apart"),
            (of(&[[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]], 3), "interval 2 of side 1 and interval 2 of side 3 cross near (0.5, 0.5); list the points in the order in which they lie around the domain, and keep rings apart"),
            (of(&[[0.0, 0.0], [2.0, 0.0], [1.0, 0.0]], 1), "the boundary folds back on itself at corner 1 at (0.0, 0.0) (0°); drop the point or move it"),
            (of(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 0.0], [0.0, 2.0]], 1), "corner 4 at (2.0, 0.0) lies on side 1; rings may not touch: move the point off, or split the ring there"),
            (of(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 0.0], [0.0, 2.0]], 2), "corner 4 is at (2.0, 0.0), where point 1 of side 1 is too; a boundary passes each point once: move one of them, or split the ring there"),
            (holes(&[triangle(2.0, 2.0), triangle(9.0, 2.0)]), "hole 2 lies outside the outline, with its first corner at (9.0, 2.0); move it inside, or drop it"),
            (holes(&[ring(&[[1.0, 1.0], [7.0, 1.0], [1.0, 7.0]], 1), triangle(2.0, 2.0)]), "hole 2 lies inside hole 1, with its first corner at (2.0, 2.0); drop one of them"),
            (holes(&[triangle(2.0, 2.0), ring(&SQUARE.map(|[x, y]| [2.0 * x - 4.0, 2.0 * y - 4.0]), 1)]), "the outline lies inside hole 2; give the outer ring first, and the holes inside it"),
            (holes(&[triangle(2.0, 2.0), triangle(1.0, 2.0)]), "corner 2 of hole 2 is at (2.0, 2.0), where corner 1 of hole 1 is too; a boundary passes each point once: move one of them, or split the ring there"),
            (holes(&[triangle(2.0, 0.0)]), "corner 1 of hole 1 at (2.0, 0.0) lies on interval 1 of side 1; rings may not touch: move the point off, or split the ring there"),
            (holes(&[triangle(7.5, 2.0)]), "interval 1 of side 2 and side 1 of hole 1 cross near (8.0, 2.0); list the points in the order in which they lie around the domain, and keep rings apart"),
        ];
        for (outcome, message) in table {
            assert_eq!(outcome.unwrap_err().to_string(), message);
        }
    }
}
