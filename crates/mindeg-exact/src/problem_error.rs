//! Why input is not a problem.

use thiserror::Error;

use crate::size::MAX_VERTICES;

/// Why input is not a [`Problem`](crate::Problem).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ProblemError {
    /// More vertices than [`MAX_VERTICES`].
    #[error(
        "found {vertices} boundary vertices; exact work takes at most {MAX_VERTICES}; use fewer \
         intervals, or the formula of least degree, which takes any number"
    )]
    TooManyVertices {
        /// Their number.
        vertices: u32,
    },
    /// The numbers of points and vertices differ.
    #[error("found {points} points for {vertices} boundary vertices; give one for each")]
    PointCount {
        /// The vertices.
        vertices: u32,
        /// The points.
        points: usize,
    },
    /// A triangle has a vertex without a point.
    #[error("triangle {triangle} has vertex {vertex}, but the vertices are 0 to {last}")]
    NoSuchVertex {
        /// The triangle.
        triangle: usize,
        /// Its vertex.
        vertex: u32,
        /// The largest vertex.
        last: usize,
    },
    /// A triangle that is clockwise or has no area, exactly.
    #[error("triangle {triangle} is clockwise or has no area; give counter-clockwise triangles")]
    NotCounterClockwise {
        /// The triangle.
        triangle: usize,
    },
    /// An edge with two triangles on one side, or three triangles.
    #[error("the edge from {from} to {to} has two triangles on the same side; remove one of them")]
    Overlap {
        /// Where it begins.
        from: u32,
        /// Where it ends.
        to: u32,
    },
    /// A vertex that the boundary does not pass exactly once.
    #[error(
        "the boundary passes vertex {vertex} {times} times, expected once; leave out interior \
         points, and keep rings apart"
    )]
    NotOnBoundary {
        /// The vertex.
        vertex: u32,
        /// The times that the boundary passes it.
        times: u32,
    },
    /// A coordinate is infinite or not a number.
    #[error("the point of vertex {vertex} is not finite; give finite coordinates")]
    NotFinite {
        /// The vertex.
        vertex: u32,
    },
}
