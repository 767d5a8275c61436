//! One face as a planar problem, and its first triangulation.

use glam::DVec3;
use mindeg_core::{Boundary, least_degree_triangulation};
use mindeg_domain::Model;
use mindeg_exact::Problem;
use mindeg_exact::measure::min_angle_tangent;
use mindeg_mesh::planar::{Border, PlanarBoundary};
use mindeg_mesh::{Progress, check};

use crate::error::MeshError;

/// A face: the vertex of the whole at each place, and its boundary in its plane.
pub(crate) struct PlaneFace {
    pub(crate) vertices: Vec<u32>,
    pub(crate) boundary: PlanarBoundary,
    is_polygon: bool,
}

impl PlaneFace {
    pub(super) fn new(model: &Model, positions: &[DVec3], face: usize) -> Result<Self, MeshError> {
        let (vertices, boundary) =
            model.boundary(face, positions).map_err(|error| MeshError::of_face(face, error))?;
        Ok(Self { vertices, boundary, is_polygon: true })
    }

    /// A face of a map, each edge of which is of a straight run.
    pub(crate) fn of_border(border: Border, runs: Vec<u32>) -> Self {
        let Border { boundary, vertices, .. } = border;
        let touches = (0..boundary.vertex_count()).any(|place| boundary.twins(place).count() > 0);
        let is_polygon =
            !touches && boundary.segments().is_empty() && boundary.inner_points().is_empty();
        Self { vertices, boundary: boundary.with_sides(Vec::new(), runs), is_polygon }
    }

    /// Whether the face is a polygon, with or without holes, that does not touch itself and has no lines or points inside.
    pub(crate) fn is_polygon(&self) -> bool {
        self.is_polygon
    }

    /// The face as the solver takes it, if it is a polygon.
    pub(crate) fn problem(&self, triangles: &[[u32; 3]]) -> Option<Problem> {
        self.is_polygon.then(|| Problem::triangulated(&self.boundary, triangles).ok()).flatten()
    }

    /// Checks that triangles are a triangulation of the face.
    pub(super) fn check(&self, triangles: &[[u32; 3]]) -> Result<(), String> {
        if self.is_polygon {
            let problem = Problem::triangulated(&self.boundary, triangles);
            return problem.map(drop).map_err(|error| error.to_string());
        }
        let inner = self.boundary.inner_points();
        let checked = check::triangulation(&self.boundary, inner, triangles);
        checked.map(drop).map_err(|error| error.to_string())
    }

    /// The chords at each place: a vertex on a ring has one triangle more, and lines inside are none.
    pub(super) fn chords(&self, triangles: &[[u32; 3]]) -> Vec<u32> {
        let mut counts = vec![0_u32; self.vertices.len()];
        triangles.as_flattened().iter().for_each(|&place| counts[place as usize] += 1);
        let on_rings = counts[..self.boundary.points().len()].iter_mut();
        on_rings.for_each(|count| *count = count.saturating_sub(1));
        for &place in self.boundary.segments().as_flattened() {
            counts[place as usize] = counts[place as usize].saturating_sub(1);
        }
        counts
    }

    pub(super) fn delaunay(&self, face: usize) -> Result<Vec<[u32; 3]>, MeshError> {
        let boundary = &self.boundary;
        let (inner, segments) = (boundary.inner_points(), boundary.segments());
        mindeg_delaunay::triangles(boundary, inner, segments, Progress::NONE)
            .map_err(|error| MeshError::of_face(face, error))
    }

    /// The tangent of the minimum angle of some triangles.
    pub(super) fn min_tangent(&self, triangles: &[[u32; 3]]) -> f64 {
        let tangent = |triangle: &[u32; 3]| {
            min_angle_tangent(triangle.map(|place| self.boundary.point(place)))
        };
        triangles.iter().map(tangent).fold(f64::INFINITY, f64::min)
    }

    /// The triangulation of least degree by the formula, if the face is convex.
    pub(super) fn closed_form(&self) -> Option<Vec<[u32; 3]>> {
        let (points, runs) = (self.boundary.points(), self.boundary.runs());
        let n = points.len();
        if self.boundary.ring_count() > 1 || !self.is_polygon {
            return None;
        }
        // Where runs begin.
        let starts: Vec<usize> = (0..n).filter(|&v| runs[v] != runs[(v + n - 1) % n]).collect();
        let at = |i: usize| points[starts[i % starts.len()]];
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

#[cfg(test)]
mod tests {
    use super::*;
    use mindeg_core::least_max_degree;

    fn faces(json: &str) -> Vec<PlaneFace> {
        let model = Model::from_json(json).unwrap();
        let positions = model.positions();
        (0..model.face_count())
            .map(|face| PlaneFace::new(&model, &positions, face).unwrap())
            .collect()
    }

    #[test]
    fn convex_faces_have_the_least_degree_by_the_formula() {
        // Two faces begin within a side of two edges.
        let tetrahedron = r#"{
            "corners": [[0, 0, 0], [4, 0, 0], [0, 3, 0], [0, 0, 2], [2, 0, 0]],
            "faces": [[4, 0, 2, 1], [4, 1, 3, 0], [1, 2, 3], [0, 3, 2]], "size": 0.5}"#;
        let counts: [&[u64]; 4] = [&[6, 10, 8], &[9, 4, 8], &[10, 7, 9], &[4, 7, 6]];
        for (face, counts) in faces(tetrahedron).iter().zip(counts) {
            let n = face.vertices.len();
            assert_eq!(n as u64, counts.iter().sum::<u64>());
            let triangles = face.closed_form().unwrap();
            assert_eq!(triangles.len(), n - 2);
            // A boundary vertex has an edge more than triangles.
            let mut degrees = vec![1; n];
            triangles.as_flattened().iter().for_each(|&place| degrees[place as usize] += 1);
            let least = least_max_degree(&Boundary::new(counts).unwrap());
            assert_eq!(degrees.into_iter().max(), Some(least), "{counts:?}");
            let area = |&[a, b, c]: &[u32; 3]| {
                let [a, b, c] = [a, b, c].map(|place| face.boundary.point(place));
                (b - a).perp_dot(c - a)
            };
            assert!(triangles.iter().all(|triangle| area(triangle) > 1e-9), "{counts:?}");
        }
    }

    #[test]
    fn other_faces_have_no_formula() {
        let l_block = r#"{
            "corners": [[0,0,0], [2,0,0], [2,1,0], [1,1,0], [1,2,0], [0,2,0],
                        [0,0,1], [2,0,1], [2,1,1], [1,1,1], [1,2,1], [0,2,1]],
            "faces": [[5,4,3,2,1,0], [6,7,8,9,10,11], [0,1,7,6], [1,2,8,7], [2,3,9,8],
                      [3,4,10,9], [4,5,11,10], [5,0,6,11]], "size": 0.5}"#;
        let has =
            faces(l_block).iter().map(|face| face.closed_form().is_some()).collect::<Vec<_>>();
        assert_eq!(has, [false, false, true, true, true, true, true, true]);
    }
}
