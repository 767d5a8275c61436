//! A domain as the solver takes it: a convex one by its counts, up to the size of dense work; any
//! other one by a Delaunay triangulation, which shows what sees what.
//!
//! Limits: with holes, the solver searches within a number of steps.

use std::cmp::Reverse;

use mindeg_domain::{ConvexForm, Domain};
use mindeg_exact::measure::least_tangent;
use mindeg_exact::{MAX_CANDIDATES, MAX_VERTICES, Problem, Unsolved, windows};
use mindeg_mesh::{Cancelled, Progress};

use crate::boundary_mesh::{BoundaryMesh, points_of};
use crate::conflict;
use crate::error::MeshError;

/// The most triples of vertices that see each other for which the best angles are searched: some
/// seconds to a minute on one core.
const MAX_ANGLE_TRIPLES: u64 = 300_000_000;

/// A domain as a problem, with its constraints.
#[derive(Clone, Debug)]
pub(crate) struct Posed<'a> {
    domain: &'a Domain,
    pub(crate) problem: Problem,
    /// The domain's index of the problem's vertex 0.
    first: u32,
    /// Minimum angle of the Delaunay triangulation, in degrees, where the problem has one.
    pub(crate) delaunay_min_angle: Option<f64>,
}

impl<'a> Posed<'a> {
    /// A convex domain by its counts, any other one by a Delaunay triangulation.
    ///
    /// # Errors
    ///
    /// A convex domain with more than [`MAX_VERTICES`] boundary vertices, and points without a
    /// Delaunay triangulation.
    pub(crate) fn new(domain: &'a Domain, progress: Progress<'_>) -> Result<Self, MeshError> {
        match domain.convex() {
            Some(form) => Self::convex(domain, form),
            None => Self::triangulated(domain, progress),
        }
    }

    /// As [`new`](Self::new), and a convex domain that is too large by a Delaunay triangulation, too.
    pub(crate) fn of_any_size(
        domain: &'a Domain,
        progress: Progress<'_>,
    ) -> Result<Self, MeshError> {
        match domain.convex() {
            Some(form) if form.boundary().vertex_count() <= MAX_VERTICES => {
                Self::convex(domain, form)
            }
            _ => Self::triangulated(domain, progress),
        }
    }

    /// The domain.
    pub(crate) fn domain(&self) -> &'a Domain {
        self.domain
    }

    fn convex(domain: &'a Domain, form: &ConvexForm) -> Result<Self, MeshError> {
        let (boundary, first) = (form.boundary(), form.first());
        // The solver refuses a number of vertices too large for the memory of one point each.
        if boundary.vertex_count() > MAX_VERTICES {
            return Err(Unsolved::TooManyVertices { vertices: boundary.vertex_count() }.into());
        }
        let mut points = points_of(domain);
        points.rotate_left(first as usize);
        let problem = Problem::new(boundary, &points)?;
        let posed = Self { domain, problem, first, delaunay_min_angle: None };
        Ok(posed.with_constraints())
    }

    /// Any domain by a Delaunay triangulation.
    pub(crate) fn triangulated(
        domain: &'a Domain,
        progress: Progress<'_>,
    ) -> Result<Self, MeshError> {
        if domain.is_map() {
            return Err(MeshError::refused(
                "the domain has lines or points inside, which this does not take",
            ));
        }
        let boundary = domain.boundary()?;
        let triangles = mindeg_delaunay::triangles(&boundary, &[], &[], progress)?;
        let least_tangent = least_tangent(boundary.points(), &triangles);
        let problem = Problem::triangulated(&boundary, &triangles)?;
        let delaunay_min_angle = Some(libm::atan(least_tangent).to_degrees());
        Ok(Self { domain, problem, first: 0, delaunay_min_angle }.with_constraints())
    }

    fn with_constraints(mut self) -> Self {
        if self.domain.is_constrained() {
            for vertex in 0..self.domain.rings().vertex_count() {
                let external = self.domain.external_degree(self.in_domain(vertex));
                self.problem.set_external_degree(vertex, external);
            }
        }
        self.set_degree_limits(&self.degree_limits());
        self
    }

    /// The domain's index of a vertex of the problem.
    fn in_domain(&self, vertex: u32) -> u32 {
        let count = self.domain.rings().vertex_count();
        let left = count - self.first;
        if vertex < left { vertex + self.first } else { vertex - left }
    }

    fn set_degree_limits(&mut self, limits: &[(u32, u32)]) {
        limits.iter().for_each(|&(vertex, limit)| self.problem.set_degree_limit(vertex, limit));
    }

    /// The problem's vertices with a degree limit, and the limits.
    fn degree_limits(&self) -> Vec<(u32, u32)> {
        if !self.domain.is_constrained() {
            return Vec::new();
        }
        let limit = |vertex| self.domain.degree_limit(self.in_domain(vertex));
        let vertices = 0..self.domain.rings().vertex_count();
        vertices.filter_map(|vertex| Some((vertex, limit(vertex)?))).collect()
    }

    /// The mesh of a triangulation of the problem's vertices.
    pub(crate) fn mesh(&self, mut triangles: Vec<[u32; 3]>) -> Result<BoundaryMesh, MeshError> {
        // Every triangle cuts off the vertices from its smallest to its largest. Sorted like that,
        // what one cuts off follows on it, and neighbours mostly share an edge.
        triangles.sort_unstable_by_key(|&[first, _, last]| (first, Reverse(last)));
        if self.first > 0 {
            let vertices = triangles.as_flattened_mut().iter_mut();
            vertices.for_each(|vertex| *vertex = self.in_domain(*vertex));
        }
        BoundaryMesh::with_triangles(self.domain, triangles)
    }

    /// The mesh that windows reach: with `share` of the minimum angle of the Delaunay triangulation,
    /// and no vertex above `max_degree` if that can be reached, else as few edges as can be. None if
    /// windows do not keep the degree limits of single vertices.
    pub(crate) fn windows(
        &self,
        share: f64,
        max_degree: u32,
        progress: Progress<'_>,
    ) -> Result<Option<BoundaryMesh>, MeshError> {
        let least_angle = share * self.delaunay_min_angle.unwrap_or(0.0);
        let least_tangent = libm::tan(least_angle.to_radians());
        let windowed = windows(&self.problem, max_degree, least_tangent, progress)?;
        if !windowed.keeps_vertex_limits {
            return Ok(None);
        }
        // These triangles are in an order of their own already.
        Ok(Some(BoundaryMesh::with_triangles(self.domain, windowed.triangles)?))
    }

    /// Whether the best angles can be searched for in some seconds to a minute: a convex domain that
    /// is not too large, or a polygon without holes in which few vertices see each other.
    pub(crate) fn has_best_angles(&self, progress: Progress<'_>) -> Result<bool, Cancelled> {
        self.is_within(MAX_ANGLE_TRIPLES, progress)
    }

    /// Whether the problem has exact answers, and as many triples of vertices see each other at most.
    pub(crate) fn is_within(
        &self,
        triples: u64,
        progress: Progress<'_>,
    ) -> Result<bool, Cancelled> {
        if self.domain.convex().is_some() {
            return Ok(self.domain.rings().vertex_count() <= MAX_VERTICES);
        }
        Ok(self.problem.count_triples(triples, progress)?.is_some())
    }

    /// Why the solver has no answer, with the vertices whose degree limits no mesh keeps together.
    pub(crate) fn unsolved(&self, error: Unsolved, progress: Progress<'_>) -> MeshError {
        match error {
            Unsolved::VertexLimits => {}
            // Windows did not keep the limits, and the search with holes took all its steps.
            Unsolved::NotAPolygon | Unsolved::Undecided if self.domain.is_constrained() => {
                return MeshError::LimitsNotReached;
            }
            Unsolved::NotAPolygon => {
                return MeshError::Refused(format!(
                    "more than {MAX_CANDIDATES} triangles are possible here, too many for the search of all \
                     meshes; take fewer points, or the least degree that is reached"
                ));
            }
            _ => return error.into(),
        }
        match self.vertices_in_conflict(progress) {
            Ok(vertices) => {
                let there = if vertices.len() == 1 { "there" } else { "at one of them or more" };
                MeshError::Refused(format!(
                    "no mesh keeps the degree limits of {}; raise max_degree {there}",
                    conflict::vertex_list(&vertices)
                ))
            }
            Err(error) => error.into(),
        }
    }

    /// Vertices whose degree limits no mesh keeps together, where those of all conflict.
    fn vertices_in_conflict(&self, progress: Progress<'_>) -> Result<Vec<u32>, Unsolved> {
        let mut plain = self.clone();
        plain.problem.clear_degree_limits();
        let conflict = |limits: &[(u32, u32)]| {
            let mut posed = plain.clone();
            posed.set_degree_limits(limits);
            match mindeg_exact::least_max_degree(&posed.problem, progress) {
                Ok(_) => Ok(false),
                Err(Unsolved::VertexLimits) => Ok(true),
                Err(error) => Err(error),
            }
        };
        let tries = most_tries(self.domain.rings().vertex_count());
        let found = conflict::smallest(self.degree_limits(), tries, conflict)?;
        let mut vertices: Vec<u32> =
            found.into_iter().map(|(vertex, _)| self.in_domain(vertex)).collect();
        vertices.sort_unstable();
        Ok(vertices)
    }
}

/// The most times that the search for a conflict solves the problem, in O(n³) time each.
fn most_tries(vertex_count: u32) -> u64 {
    const TRIES: u64 = 64;
    /// Up to this many vertices a try takes some milliseconds.
    const SMALL: u64 = 256;
    TRIES * SMALL.pow(3) / u64::from(vertex_count).max(SMALL).pow(3)
}
