//! One face as a planar problem, and its first triangulation.

use std::ops::Range;

use glam::{DVec2, DVec3};
use mindeg_core::{Boundary, least_degree_triangulation};
use mindeg_domain::Model;
use mindeg_exact::Problem;
use mindeg_exact::measure::min_angle_tangent;
use mindeg_mesh::Progress;

use super::error::ModelMeshError;

/// The vertices of a face in its plane.
pub(super) struct PlaneFace {
    /// The vertices of the model, at each place.
    pub(super) vertices: Vec<u32>,
    pub(super) points: Vec<DVec2>,
    /// The straight run of the boundary edge that begins at each place.
    pub(super) runs: Vec<u32>,
    pub(super) rings: Vec<Range<u32>>,
    corners: Vec<u32>,
}

impl PlaneFace {
    pub(super) fn new(model: &Model, positions: &[DVec3], face: usize) -> Self {
        let rings = model.rings(face);
        let plane = model.plane(face);
        let project = |&vertex: &u32| plane.project(positions[vertex as usize]);
        let points: Vec<DVec2> = rings.vertices.iter().map(project).collect();
        let runs = rings.straight_runs(&points);
        Self { vertices: rings.vertices, points, runs, rings: rings.rings, corners: rings.corners }
    }

    pub(super) fn problem(
        &self,
        triangles: &[[u32; 3]],
    ) -> Result<Problem, mindeg_exact::ProblemError> {
        Problem::triangulated(&self.points, &self.runs, triangles)
    }

    pub(super) fn delaunay(&self, face: usize) -> Result<Vec<[u32; 3]>, ModelMeshError> {
        mindeg_delaunay::of_rings(&self.points, &self.rings, &self.corners, &[], Progress::NONE)
            .map_err(|source| ModelMeshError::Delaunay { face, source })
    }

    /// The tangent of the minimum angle of some triangles.
    pub(super) fn min_tangent(&self, triangles: &[[u32; 3]]) -> f64 {
        let tangent = |triangle: &[u32; 3]| {
            min_angle_tangent(triangle.map(|place| self.points[place as usize]))
        };
        triangles.iter().map(tangent).fold(f64::INFINITY, f64::min)
    }

    /// The triangulation of least degree by the formula, if the face is convex.
    pub(super) fn closed_form(&self) -> Option<Vec<[u32; 3]>> {
        let n = self.points.len();
        if self.rings.len() > 1 {
            return None;
        }
        // Where runs begin.
        let starts: Vec<usize> =
            (0..n).filter(|&v| self.runs[v] != self.runs[(v + n - 1) % n]).collect();
        let at = |i: usize| self.points[starts[i % starts.len()]];
        let turns_left = |i: usize| (at(i + 1) - at(i)).perp_dot(at(i + 2) - at(i + 1)) > 0.0;
        // A loop that is simple and turns left at every corner goes round once.
        if starts.len() < 3 || !(0..starts.len()).all(turns_left) {
            return None;
        }
        let counts: Vec<u64> = (0..starts.len())
            .map(|i| ((starts[(i + 1) % starts.len()] + n - starts[i] - 1) % n + 1) as u64)
            .collect();
        let boundary = Boundary::new(&counts).ok()?;
        let place = |vertex: u32| ((vertex as usize + starts[0]) % n) as u32;
        let triangulation = least_degree_triangulation(&boundary);
        Some(triangulation.triangles().map(|triangle| triangle.map(place)).collect())
    }
}
