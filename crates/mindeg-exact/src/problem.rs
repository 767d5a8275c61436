//! A problem: boundary points, external degrees and degree limits of single vertices.

use crate::chords::Chords;
use crate::limits::DegreeLimits;
use crate::linked::Linked;
use crate::progress::Stage;
use crate::sides::Sides;
use crate::unsolved::{MAX_VERTICES, Unsolved};
use crate::visibility;
use glam::DVec2;
use mindeg_core::{Boundary, least_degree_triangulation};
use mindeg_mesh::planar::{PlanarBoundary, orientation};
use mindeg_mesh::{Cancelled, Progress};
use std::sync::OnceLock;

/// The most triples of vertices that see each other in another polygon: 4 * 10^9.
///
/// One pass of the dynamic program over 10^9 triples takes 5 to 10 seconds on one core. A coastline
/// of 20,000 vertices has some 10^9, an L of 2,000 has 2.5 * 10^8.
pub const MAX_TRIPLES: u64 = 4_000_000_000;

/// The steps of a search with holes by default, some 5 seconds on one core. Degrees between the bounds get four
/// times as many.
pub const COVER_STEPS: u64 = 1_000_000_000;

/// The largest external degree in windows, which take larger ones for this.
pub(crate) const MANY_EDGES: u32 = 1 << 30;

/// The most chords, some 50 bytes each.
const MAX_CHORDS: usize = 1 << 24;

/// The boundary points of a polygon, and the external degrees and degree limits of its vertices.
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_core::Boundary;
/// use mindeg_exact::{Problem, Progress, best_angle};
///
/// let boundary = Boundary::new(&[2, 1, 1])?;
/// let points = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (0.0, 2.0)].map(DVec2::from);
/// let mut problem = Problem::new(&boundary, &points)?;
/// problem.set_external_degree(1, 3); // a mesh below has three more edges there
/// let optimum = best_angle(&problem, 6, Progress::NONE)?;
/// assert_eq!(optimum.vertices_at_limit, 1); // 3 external, 2 of the boundary, 1 inside
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Problem {
    pub(crate) domain: Domain,
    points: Vec<DVec2>,
    sides: Sides,
    external_degrees: Vec<u32>,
    degree_limits: Vec<Option<u32>>,
    pub(crate) max_triples: u64,
    /// All chords that a triangulation may use, once they are known.
    visible: OnceLock<Chords>,
    max_steps: u64,
    pub(crate) wanted_degree: Option<u32>,
}

/// The domain that the points bound.
#[derive(Clone, Debug)]
pub(crate) enum Domain {
    /// A convex polygon, where every two vertices see each other.
    Convex(Boundary),
    /// A polygon whose ring is 0, 1, 2 and so on, with a triangulation that shows which vertices
    /// see each other.
    Simple(Linked),
    /// Any other domain, with a triangulation.
    Rings(Linked),
}

impl Problem {
    /// The problem of a boundary whose vertex v is at `points[v]`. O(n).
    ///
    /// The points must be those of a convex polygon, counter-clockwise. This is not checked: the
    /// boundary alone decides which triangles are flat, and any other triangle without positive
    /// area in floating point has an angle of 0.
    ///
    /// # Errors
    ///
    /// More than [`MAX_VERTICES`] vertices, another number of points, or a point that is not
    /// finite.
    pub fn new(boundary: &Boundary, points: &[DVec2]) -> Result<Self, Unsolved> {
        let vertices = boundary.vertex_count();
        if vertices > MAX_VERTICES {
            return Err(Unsolved::TooManyVertices { vertices });
        }
        if points.len() != vertices as usize {
            return Err(Unsolved::Refused(format!(
                "found {} points for {vertices} boundary vertices; give one for each",
                points.len()
            )));
        }
        require_finite(points)?;
        let sides = Sides::of_boundary(boundary);
        Ok(Self::new_with(Domain::Convex(boundary.clone()), points, sides))
    }

    /// The problem of any polygon, with or without holes, from some triangulation of its boundary
    /// points. O(n log n).
    ///
    /// Two vertices of one [run](PlanarBoundary::runs) are never joined by a chord, which matters where
    /// rounding has moved points off the line between the ends of a side.
    ///
    /// The triangles are counter-clockwise, in any order. Any triangulation shows which vertices see each
    /// other; for angles and for [`windows`](crate::windows()) give a constrained Delaunay triangulation.
    /// With holes, only windows work.
    ///
    /// Triangles that overlap without a common edge are not detected.
    ///
    /// No chord joins two vertices of one side, and none [passes](mindeg_mesh::planar::passes) a vertex. An
    /// edge of `triangles` that does is flipped; where it cannot be, the side is not straight, and each of
    /// its edges counts as a side of its own, or the domain [is too thin](Self::keeps_clear) for the
    /// tolerance.
    ///
    /// # Errors
    ///
    /// Points that are not finite, triangles that are not counter-clockwise or overlap at an edge, a boundary
    /// of the triangles that is not this one.
    ///
    /// # Example
    ///
    /// ```
    /// use glam::DVec2;
    /// use mindeg_exact::{Problem, Progress, least_max_degree};
    /// use mindeg_mesh::planar::PlanarBoundary;
    ///
    /// // An L of six corners.
    /// let points = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)];
    /// let points = points.map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)));
    /// let fan = [[3, 4, 5], [3, 5, 0], [3, 0, 1], [3, 1, 2]];
    /// let problem = Problem::triangulated(&PlanarBoundary::new(&[points])?, &fan)?;
    /// assert_eq!(least_max_degree(&problem, Progress::NONE)?, 4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn triangulated(
        boundary: &PlanarBoundary,
        triangles: &[[u32; 3]],
    ) -> Result<Self, Unsolved> {
        let points = boundary.points();
        require_finite(points)?;
        for (triangle, corners) in triangles.iter().enumerate() {
            if let Some(vertex) = corners.iter().find(|&&corner| corner as usize >= points.len()) {
                return Err(Unsolved::Refused(format!(
                    "triangle {triangle} has vertex {vertex}, but the vertices are 0 to {}",
                    points.len().saturating_sub(1)
                )));
            }
            let [a, b, c] = corners.map(|corner| points[corner as usize]);
            if orientation(a, b, c) <= 0.0 {
                return Err(Unsolved::Refused(format!(
                    "triangle {triangle} is clockwise or has no area; give counter-clockwise triangles"
                )));
            }
        }
        let mut mesh = Linked::new(triangles.to_vec()).map_err(|[from, to]| {
            Unsolved::Refused(format!(
                "the edge from {from} to {to} has two triangles on the same side; remove one of them"
            ))
        })?;
        let is_boundary = |&[from, to]: &[u32; 2]| boundary.next(from) == to;
        let edges = mesh.boundary_edges();
        if !edges.clone().all(|edge| is_boundary(&edge)) || edges.count() < points.len() {
            return Err(Unsolved::refused(
                "the triangles have another boundary than the domain; give a triangulation of it",
            ));
        }
        let sides = Sides::of_triangulation(&mut mesh, points, boundary.runs());
        let is_simple = boundary.ring_count() == 1 && triangles.len() + 2 == points.len();
        let domain = if is_simple { Domain::Simple(mesh) } else { Domain::Rings(mesh) };
        Ok(Self::new_with(domain, points, sides))
    }

    fn new_with(domain: Domain, points: &[DVec2], sides: Sides) -> Self {
        Self {
            domain,
            points: points.to_vec(),
            sides,
            external_degrees: vec![0; points.len()],
            degree_limits: vec![None; points.len()],
            max_triples: MAX_TRIPLES,
            visible: OnceLock::new(),
            max_steps: COVER_STEPS,
            wanted_degree: None,
        }
    }

    /// Sets the most triples of vertices that see each other, in place of [`MAX_TRIPLES`]. Exact
    /// work counts them before it starts; convex polygons have [`MAX_VERTICES`] instead.
    pub fn set_max_triples(&mut self, triples: u64) {
        self.max_triples = triples;
        // They may be too many now.
        self.visible = OnceLock::new();
    }

    /// Sets the most steps of a search of a domain with holes, in place of [`COVER_STEPS`].
    pub fn set_max_steps(&mut self, steps: u64) {
        self.max_steps = steps;
    }

    /// The limit of [`set_max_steps`](Self::set_max_steps).
    pub fn max_steps(&self) -> u64 {
        self.max_steps
    }

    /// Lets [`degree_range`](crate::degree_range) of a problem without limits end as soon as it knows whether some
    /// triangulation has at most this maximum degree.
    pub fn set_wanted_degree(&mut self, degree: u32) {
        self.wanted_degree = Some(degree);
    }

    /// The points, by vertex.
    #[must_use]
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// Sets the external degree of `vertex`, 0 at first: its edges in neighbouring meshes, which
    /// count towards its degree.
    ///
    /// Edges of this boundary are not among them. So, for a mesh that shares a side, it is that
    /// mesh's degree less 2 inside the side, and less 1 at either end.
    ///
    /// # Panics
    ///
    /// If the boundary has no such vertex.
    pub fn set_external_degree(&mut self, vertex: u32, edges: u32) {
        self.external_degrees[vertex as usize] = edges;
    }

    /// Sets the degree limit of `vertex`, which holds beside the limit for all vertices. External
    /// edges count.
    ///
    /// # Panics
    ///
    /// If the boundary has no such vertex.
    pub fn set_degree_limit(&mut self, vertex: u32, limit: u32) {
        self.degree_limits[vertex as usize] = Some(limit);
    }

    /// Takes the degree limits of all vertices away.
    pub fn clear_degree_limits(&mut self) {
        self.degree_limits.fill(None);
    }

    /// Whether no vertex has external edges or a degree limit of its own.
    pub(crate) fn is_plain(&self) -> bool {
        self.external_degrees.iter().all(|&edges| edges == 0)
            && self.degree_limits.iter().all(Option::is_none)
    }

    /// The limits of all vertices; none if a vertex without chords is above its limit.
    pub(crate) fn degree_limits(&self, max_degree: u32) -> Option<DegreeLimits> {
        let own_limits = self.degree_limits.iter();
        let limits = own_limits.map(|own| own.unwrap_or(max_degree).min(max_degree));
        let chords = limits
            .zip(&self.external_degrees)
            .map(|(limit, &external)| limit.checked_sub(2)?.checked_sub(external))
            .collect::<Option<_>>()?;
        Some(DegreeLimits { max_degree, chords })
    }

    /// The maximum degree of triangles; the edges at a vertex of one fan are one more than its triangles.
    pub(crate) fn max_degree_of(&self, triangles: &[[u32; 3]]) -> u32 {
        let mut edges = vec![1_u32; self.points.len()];
        triangles.as_flattened().iter().for_each(|&corner| edges[corner as usize] += 1);
        let all = edges.iter().zip(&self.external_degrees);
        all.map(|(&own, &external)| external.saturating_add(own)).max().unwrap_or(0)
    }

    /// A limit for all vertices that no triangulation exceeds.
    pub(crate) fn no_limit(&self) -> u32 {
        let external = self.external_degrees.iter().copied().max().unwrap_or(0);
        external.saturating_add(self.points.len() as u32 - 1)
    }

    /// Whether its chords keep the tolerance of [`mindeg_mesh::planar::passes`]. If not, its domain is
    /// convex, so that they pass no vertices but those of a side, or so thin that they pass only what they
    /// touch.
    #[must_use]
    pub fn keeps_clear(&self) -> bool {
        self.sides.clear.is_some()
    }

    /// The straight sides.
    pub(crate) fn sides(&self) -> &Sides {
        &self.sides
    }

    /// The external degree of `vertex`, at most [`MANY_EDGES`], so that adding to it does not
    /// overflow.
    pub(crate) fn external_degree(&self, vertex: u32) -> u32 {
        self.external_degrees[vertex as usize].min(MANY_EDGES)
    }

    /// The degree limit of this vertex alone.
    pub(crate) fn own_limit(&self, vertex: u32) -> Option<u32> {
        self.degree_limits[vertex as usize]
    }

    /// For each vertex the one after it on its ring.
    pub(crate) fn next(&self) -> Vec<u32> {
        let vertices = self.points.len() as u32;
        match &self.domain {
            Domain::Convex(_) => (1..vertices).chain([0]).collect(),
            Domain::Simple(mesh) | Domain::Rings(mesh) => {
                let mut next = vec![0; self.points.len()];
                mesh.boundary_edges().for_each(|[from, to]| next[from as usize] = to);
                next
            }
        }
    }

    /// Some triangulation of the points.
    pub(crate) fn triangulation(&self) -> Linked {
        match &self.domain {
            Domain::Convex(boundary) => {
                let triangles = least_degree_triangulation(boundary).triangles().collect();
                Linked::new(triangles).expect("the formula makes a triangulation")
            }
            Domain::Simple(mesh) | Domain::Rings(mesh) => mesh.clone(),
        }
    }

    /// All chords that a triangulation may use, if their triples are within the limit.
    pub(crate) fn chords(&self, progress: Progress<'_>) -> Result<&Chords, Unsolved> {
        let chords = self.visible_chords(progress)?;
        self.require_triples(chords, progress)?;
        Ok(chords)
    }

    /// All chords that a triangulation may use, if they are not too many.
    pub(crate) fn visible_chords(&self, progress: Progress<'_>) -> Result<&Chords, Unsolved> {
        if let Some(chords) = self.visible.get() {
            return Ok(chords);
        }
        let chords = match &self.domain {
            Domain::Convex(_) => Chords::all(self.points.len(), &self.sides),
            Domain::Simple(mesh) => {
                let stage = Stage::new(progress, "finding chords");
                let most = self.max_chords();
                let chords = visibility::chords(mesh, &self.points, &self.sides, most, &stage)?;
                chords.ok_or(Unsolved::TooLarge { max_triples: self.max_triples })?
            }
            Domain::Rings(_) => return Err(Unsolved::NotAPolygon),
        };
        Ok(self.visible.get_or_init(|| chords))
    }

    /// Refuses chords of another polygon than a convex one if they have too many triples.
    pub(crate) fn require_triples(
        &self,
        chords: &Chords,
        progress: Progress<'_>,
    ) -> Result<(), Unsolved> {
        if let Domain::Convex(_) = self.domain {
            return Ok(());
        }
        let stage = Stage::new(progress, "counting triples of vertices");
        let triples = chords.count_triples(self.max_triples, &stage)?;
        triples.map(|_| ()).ok_or(Unsolved::TooLarge { max_triples: self.max_triples })
    }

    /// The number of triples of vertices that see each other, the work of one pass of the dynamic
    /// program; none if it is more than `most`, or if the problem has no exact answers. O(triples),
    /// and little more than O(`most`).
    ///
    /// # Errors
    ///
    /// A cancelled `progress`.
    pub fn count_triples(
        &self,
        most: u64,
        progress: Progress<'_>,
    ) -> Result<Option<u64>, Cancelled> {
        let chords = match self.visible_chords(progress) {
            Ok(chords) => chords,
            Err(Unsolved::Cancelled(cancelled)) => return Err(cancelled),
            Err(_) => return Ok(None),
        };
        chords.count_triples(most, &Stage::new(progress, "counting triples of vertices"))
    }

    /// The most chords that exact work takes.
    pub(crate) fn max_chords(&self) -> usize {
        MAX_CHORDS.min(usize::try_from(self.max_triples).unwrap_or(MAX_CHORDS))
    }
}

fn require_finite(points: &[DVec2]) -> Result<(), Unsolved> {
    let Some(vertex) = points.iter().position(|point| !point.is_finite()) else { return Ok(()) };
    Err(Unsolved::Refused(format!(
        "the point of vertex {vertex} is not finite; give finite coordinates"
    )))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle() -> (Boundary, [DVec2; 4]) {
        let points = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (0.0, 2.0)].map(DVec2::from);
        (Boundary::new(&[2, 1, 1]).unwrap(), points)
    }

    #[test]
    fn refuses_other_points_than_the_boundary_has() {
        let (boundary, mut points) = triangle();
        let check = |boundary: &Boundary, points: &[DVec2], message: &str| {
            assert_eq!(Problem::new(boundary, points).unwrap_err().to_string(), message);
        };
        check(
            &Boundary::new(&[4095, 1, 1]).unwrap(),
            &points,
            "found 4097 boundary vertices; exact work takes at most 4096; use fewer intervals, or \
             the formula of least degree, which takes any number",
        );
        check(&boundary, &points[1..], "found 3 points for 4 boundary vertices; give one for each");
        points[2].y = f64::NAN;
        check(&boundary, &points, "the point of vertex 2 is not finite; give finite coordinates");
    }

    #[test]
    fn limits_leave_capacity() {
        let (boundary, points) = triangle();
        let mut problem = Problem::new(&boundary, &points).unwrap();
        assert!(problem.is_plain());
        assert_eq!(problem.degree_limits(5).unwrap().chords, [3, 3, 3, 3]);
        problem.set_external_degree(1, 2);
        problem.set_degree_limit(2, 4);
        problem.set_degree_limit(3, 9);
        assert!(!problem.is_plain());
        assert_eq!(problem.degree_limits(5).unwrap().chords, [3, 1, 2, 3]);
        assert_eq!(problem.degree_limits(problem.no_limit()).unwrap().chords, [3, 1, 2, 3]);
        assert!(problem.degree_limits(3).is_none());
        problem.set_external_degree(0, u32::MAX);
        assert!(problem.degree_limits(problem.no_limit()).is_none());
    }
}
