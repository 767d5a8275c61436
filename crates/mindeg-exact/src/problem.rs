//! What is asked: a placed boundary, and what single vertices allow.

use crate::chords::{Chords, Sides};
use crate::triangulation::{Triangulation, orientation};
use crate::visibility;
use glam::DVec2;
use mindeg_core::{Boundary, least_degree_triangulation};
use thiserror::Error;

/// The most boundary vertices that exact work is offered for on a convex polygon, 4,096.
///
/// Time grows with the cube of the number of vertices and memory with its square.
pub const MAX_VERTICES: u32 = 4096;

/// The most triples of vertices that see each other that exact work is offered for on other polygons: 4 * 10^9.
///
/// One pass of the dynamic program over 10^9 triples takes 5 to 10 seconds on one core. A coastline of
/// 20,000 vertices has some 10^9, an L of 2,000 has 2.5 * 10^8.
pub const MAX_TRIPLES: u64 = 4_000_000_000;

/// More edges outside are not told apart where only windows are at work.
pub(crate) const MANY_EDGES: u32 = 1 << 30;

/// The most chords that exact work keeps, some 50 bytes each.
const MAX_CHORDS: usize = 1 << 24;

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
    pub(crate) domain: Domain,
    points: Vec<DVec2>,
    sides: Sides,
    outside_degrees: Vec<u32>,
    max_degrees: Vec<Option<u32>>,
    max_triples: u64,
}

/// What the points bound.
#[derive(Clone, Debug)]
pub(crate) enum Domain {
    /// A convex polygon, where every two vertices see each other.
    Convex(Boundary),
    /// A polygon whose ring is 0, 1, 2 and so on, with a triangulation to see through.
    Simple(Triangulation),
    /// Any other domain.
    Rings(Triangulation),
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
    #[error("triangle {triangle} is clockwise or has no area; a triangulation has neither")]
    NotCounterClockwise {
        /// The triangle.
        triangle: usize,
    },
    /// An edge with two triangles on one side, or three triangles.
    #[error("the edge from {from} to {to} has two triangles on the same side")]
    Overlap {
        /// Where it begins.
        from: u32,
        /// Where it ends.
        to: u32,
    },
    /// A vertex that is not once, and only once, on the boundary.
    #[error(
        "the boundary passes vertex {vertex} {times} times; every vertex has to be on the \
         boundary, and rings may not touch"
    )]
    NotOnBoundary {
        /// The vertex.
        vertex: u32,
        /// How often the boundary passes it.
        times: u32,
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
        let sides = Sides::of_boundary(boundary);
        Self::checked(Domain::Convex(boundary.clone()), points, sides)
    }

    /// The problem of any polygon, with or without holes, of which some triangulation of the
    /// boundary points is known. O(n log n).
    ///
    /// `side_of[v]` names the straight side of the boundary edge that begins at vertex v. Two
    /// vertices of one side are never joined by a chord, which matters where rounding has moved
    /// points off the line between the side's ends. Edges that are no part of a longer straight
    /// side have names of their own.
    ///
    /// The triangles are counter-clockwise, with the domain on the left of all boundary edges, in any order.
    /// Any triangulation will do to find out which vertices see each other; for angles and for
    /// [`windows`](crate::windows()) it should be a constrained Delaunay triangulation. Where
    /// the boundary is the ring 0, 1, 2, …, n-1, all exact answers are to be had; else there are
    /// holes, or vertices in another order, and windows alone.
    ///
    /// That the rings do not cross is not checked: triangles that overlap without a common edge
    /// are not noticed.
    ///
    /// # Errors
    ///
    /// Other numbers of sides than of points, points that are not finite, triangles that are not counter-clockwise or
    /// overlap at an edge, vertices that the boundary does not pass just once.
    ///
    /// # Example
    ///
    /// ```
    /// use glam::DVec2;
    /// use mindeg_exact::{Problem, least_max_degree, unwatched};
    ///
    /// // An L of six corners.
    /// let points = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)];
    /// let points = points.map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)));
    /// let fan = [[3, 4, 5], [3, 5, 0], [3, 0, 1], [3, 1, 2]];
    /// let problem = Problem::triangulated(&points, &[0, 1, 2, 3, 4, 5], &fan)?;
    /// assert_eq!(least_max_degree(&problem, &mut unwatched)?, 4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn triangulated(
        points: &[DVec2],
        side_of: &[u32],
        triangles: &[[u32; 3]],
    ) -> Result<Self, ProblemError> {
        let vertices = points.len();
        if side_of.len() != vertices {
            return Err(ProblemError::PointCount {
                vertices: side_of.len() as u32,
                points: vertices,
            });
        }
        for (triangle, corners) in triangles.iter().enumerate() {
            if let Some(&vertex) = corners.iter().find(|&&corner| corner as usize >= vertices) {
                let last = vertices.saturating_sub(1);
                return Err(ProblemError::NoSuchVertex { triangle, vertex, last });
            }
        }
        find_not_finite(points)?;
        for (triangle, corners) in triangles.iter().enumerate() {
            let [a, b, c] = corners.map(|corner| points[corner as usize]);
            if orientation(a, b, c) <= 0.0 {
                return Err(ProblemError::NotCounterClockwise { triangle });
            }
        }
        let mesh = Triangulation::new(triangles.to_vec())
            .map_err(|[from, to]| ProblemError::Overlap { from, to })?;
        let mut passes = vec![0_u32; vertices];
        let mut is_ring = true;
        for [from, to] in mesh.boundary_edges() {
            passes[from as usize] += 1;
            is_ring &= to as usize == (from as usize + 1) % vertices;
        }
        if let Some((vertex, &times)) = (0..).zip(&passes).find(|&(_, &times)| times != 1) {
            return Err(ProblemError::NotOnBoundary { vertex, times });
        }
        let sides = Sides::of_triangulation(&mesh, side_of);
        let is_simple = is_ring && triangles.len() + 2 == vertices;
        let domain = if is_simple { Domain::Simple(mesh) } else { Domain::Rings(mesh) };
        Self::checked(domain, points, sides)
    }

    fn checked(domain: Domain, points: &[DVec2], sides: Sides) -> Result<Self, ProblemError> {
        find_not_finite(points)?;
        Ok(Self {
            domain,
            points: points.to_vec(),
            sides,
            outside_degrees: vec![0; points.len()],
            max_degrees: vec![None; points.len()],
            max_triples: MAX_TRIPLES,
        })
    }

    /// Sets how many triples of vertices that see each other exact work may have, in place of
    /// [`MAX_TRIPLES`]. They are counted before the work starts; convex polygons have
    /// [`MAX_VERTICES`] instead.
    pub fn set_max_triples(&mut self, triples: u64) {
        self.max_triples = triples;
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
        outside.saturating_add(self.points.len() as u32 - 1)
    }

    /// The straight sides.
    pub(crate) fn sides(&self) -> &Sides {
        &self.sides
    }

    /// The edges beyond the boundary at `vertex`, at most [`MANY_EDGES`], so that adding to them
    /// does not overflow.
    pub(crate) fn outside_degree(&self, vertex: u32) -> u32 {
        self.outside_degrees[vertex as usize].min(MANY_EDGES)
    }

    /// The vertex's own limit.
    pub(crate) fn own_limit(&self, vertex: u32) -> Option<u32> {
        self.max_degrees[vertex as usize]
    }

    /// Some triangulation of the points.
    pub(crate) fn triangulation(&self) -> Triangulation {
        match &self.domain {
            Domain::Convex(boundary) => {
                let triangles = least_degree_triangulation(boundary).triangles().collect();
                Triangulation::new(triangles).expect("the formula makes a triangulation")
            }
            Domain::Simple(mesh) | Domain::Rings(mesh) => mesh.clone(),
        }
    }

    /// All chords that a triangulation may use.
    pub(crate) fn chords(&self) -> Result<Chords, NoChords> {
        match &self.domain {
            Domain::Convex(_) => Ok(Chords::all(self.points.len(), &self.sides)),
            Domain::Simple(mesh) => {
                let most = MAX_CHORDS.min(usize::try_from(self.max_triples).unwrap_or(MAX_CHORDS));
                visibility::chords(mesh, &self.points, &self.sides, most)
                    .filter(|chords| chords.count_triples(self.max_triples).is_some())
                    .ok_or(NoChords::TooMany)
            }
            Domain::Rings(_) => Err(NoChords::Rings),
        }
    }

    /// The limit of [`set_max_triples`](Self::set_max_triples).
    pub(crate) fn max_triples(&self) -> u64 {
        self.max_triples
    }
}

/// Why exact work cannot start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NoChords {
    /// More triples than the problem allows.
    TooMany,
    /// The domain is no polygon.
    Rings,
}

fn find_not_finite(points: &[DVec2]) -> Result<(), ProblemError> {
    match (0..).zip(points).find(|(_, point)| !point.is_finite()) {
        Some((vertex, _)) => Err(ProblemError::NotFinite { vertex }),
        None => Ok(()),
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
