//! What is asked: a placed boundary, and what single vertices allow.

use glam::DVec2;
use mindeg_core::Boundary;
use thiserror::Error;

/// The most boundary vertices that exact work is offered for, 4,096.
///
/// Time grows with the cube of the number of vertices and memory with its square.
pub const MAX_VERTICES: u32 = 4096;

/// A placed boundary, with what its vertices already have or may not exceed.
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_core::Boundary;
/// use mindeg_exact::{Problem, best_angle, unwatched};
///
/// let boundary = Boundary::new(&[2, 1, 1])?;
/// let points = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (0.0, 2.0)].map(DVec2::from);
/// let mut problem = Problem::new(&boundary, &points)?;
/// problem.set_outside_degree(1, 3); // a mesh below has three more edges there
/// let optimum = best_angle(&problem, 6, &mut unwatched)?;
/// assert_eq!(optimum.vertices_at_cap, 1); // 3 outside, 2 of the boundary, 1 inside
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Problem {
    boundary: Boundary,
    points: Vec<DVec2>,
    outside_degrees: Vec<u32>,
    max_degrees: Vec<Option<u32>>,
}

/// Why a boundary and points are no [`Problem`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ProblemError {
    /// More vertices than [`MAX_VERTICES`].
    #[error(
        "{vertices} boundary vertices are more than the {MAX_VERTICES} that exact work serves; \
         use fewer intervals, or the mesh of least degree, which can be had at any size"
    )]
    TooManyVertices {
        /// How many there are.
        vertices: u32,
    },
    /// Not one point for every vertex.
    #[error("there are {points} points for {vertices} boundary vertices; give one for each")]
    PointCount {
        /// The vertices.
        vertices: u32,
        /// The points.
        points: usize,
    },
    /// A coordinate is infinite or not a number.
    #[error("the point of vertex {vertex} is not finite")]
    NotFinite {
        /// The vertex.
        vertex: u32,
    },
}

impl Problem {
    /// The problem of a boundary whose vertex v is at `points[v]`. O(n).
    ///
    /// The points are to be those of a convex polygon, counter-clockwise, but that is not
    /// checked: which triangles are flat is up to the boundary alone, and any other one that
    /// has no positive area in floating point has an angle of 0.
    ///
    /// # Errors
    ///
    /// More than [`MAX_VERTICES`] vertices, not one point for each, or one that is not finite.
    pub fn new(boundary: &Boundary, points: &[DVec2]) -> Result<Self, ProblemError> {
        let vertices = boundary.vertex_count();
        if vertices > MAX_VERTICES {
            return Err(ProblemError::TooManyVertices { vertices });
        }
        if points.len() != vertices as usize {
            return Err(ProblemError::PointCount { vertices, points: points.len() });
        }
        if let Some((vertex, _)) = (0..).zip(points).find(|(_, point)| !point.is_finite()) {
            return Err(ProblemError::NotFinite { vertex });
        }
        Ok(Self {
            boundary: boundary.clone(),
            points: points.to_vec(),
            outside_degrees: vec![0; points.len()],
            max_degrees: vec![None; points.len()],
        })
    }

    /// The boundary.
    #[must_use]
    pub fn boundary(&self) -> &Boundary {
        &self.boundary
    }

    /// Where the vertices are.
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// Says that `vertex` has this many edges beyond the boundary. They count towards its
    /// degree wherever a cap is meant.
    ///
    /// Edges of this boundary are not among them. So where another mesh shares a side, they are
    /// its degree less 2 inside the side, and its degree less 1 at either end.
    ///
    /// # Panics
    ///
    /// When the boundary has no such vertex.
    pub fn set_outside_degree(&mut self, vertex: u32, edges: u32) {
        self.outside_degrees[vertex as usize] = edges;
    }

    /// Gives `vertex` a cap of its own, which holds beside the cap for all.
    ///
    /// # Panics
    ///
    /// When the boundary has no such vertex.
    pub fn set_max_degree(&mut self, vertex: u32, max_degree: u32) {
        self.max_degrees[vertex as usize] = Some(max_degree);
    }

    /// Whether no vertex has edges outside or a cap of its own.
    pub(crate) fn is_plain(&self) -> bool {
        self.outside_degrees.iter().all(|&edges| edges == 0)
            && self.max_degrees.iter().all(Option::is_none)
    }

    /// The caps of all vertices; none where one has too many edges without any inside.
    pub(crate) fn caps(&self, max_degree: u32) -> Option<Caps> {
        let degrees = self.max_degrees.iter().map(|own| own.unwrap_or(max_degree).min(max_degree));
        let chords = degrees
            .zip(&self.outside_degrees)
            .map(|(degree, &outside)| degree.checked_sub(2)?.checked_sub(outside))
            .collect::<Option<_>>()?;
        Some(Caps { max_degree, chords })
    }

    /// A cap for all that is as good as none.
    pub(crate) fn no_cap(&self) -> u32 {
        let outside = self.outside_degrees.iter().copied().max().unwrap_or(0);
        outside.saturating_add(self.boundary.vertex_count() - 1)
    }
}

/// A cap for all, and what it leaves to each vertex.
#[derive(Clone, Debug)]
pub(crate) struct Caps {
    pub(crate) max_degree: u32,
    /// How many chords each vertex may have.
    pub(crate) chords: Vec<u32>,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle() -> (Boundary, [DVec2; 4]) {
        let points = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (0.0, 2.0)].map(DVec2::from);
        (Boundary::new(&[2, 1, 1]).unwrap(), points)
    }

    #[test]
    fn refuses_what_is_no_placed_boundary() {
        let (boundary, mut points) = triangle();
        let check = |boundary: &Boundary, points: &[DVec2], message: &str| {
            assert_eq!(Problem::new(boundary, points).unwrap_err().to_string(), message);
        };
        check(
            &Boundary::new(&[4095, 1, 1]).unwrap(),
            &points,
            "4097 boundary vertices are more than the 4096 that exact work serves; use fewer \
             intervals, or the mesh of least degree, which can be had at any size",
        );
        check(
            &boundary,
            &points[1..],
            "there are 3 points for 4 boundary vertices; give one for each",
        );
        points[2].y = f64::NAN;
        check(&boundary, &points, "the point of vertex 2 is not finite");
    }

    #[test]
    fn caps_leave_what_is_not_taken() {
        let (boundary, points) = triangle();
        let mut problem = Problem::new(&boundary, &points).unwrap();
        assert!(problem.is_plain());
        assert_eq!(problem.caps(5).unwrap().chords, [3, 3, 3, 3]);
        problem.set_outside_degree(1, 2);
        problem.set_max_degree(2, 4);
        problem.set_max_degree(3, 9);
        assert!(!problem.is_plain());
        assert_eq!(problem.caps(5).unwrap().chords, [3, 1, 2, 3]);
        assert_eq!(problem.caps(problem.no_cap()).unwrap().chords, [3, 1, 2, 3]);
        assert!(problem.caps(3).is_none());
        problem.set_outside_degree(0, u32::MAX);
        assert!(problem.caps(problem.no_cap()).is_none());
    }
}
