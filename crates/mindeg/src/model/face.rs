//! One face as a planar problem, and its first triangulation.

use glam::DVec3;
use mindeg_core::{Boundary, least_degree_triangulation};
use mindeg_domain::Model;
use mindeg_exact::Problem;
use mindeg_exact::measure::least_tangent;
use mindeg_mesh::Progress;
use mindeg_mesh::planar::PlanarBoundary;

use crate::error::MeshError;

/// A face: the vertices of the model at each place, and its boundary in its plane.
pub(super) struct PlaneFace {
    pub(super) vertices: Vec<u32>,
    pub(super) boundary: PlanarBoundary,
}

impl PlaneFace {
    pub(super) fn new(model: &Model, positions: &[DVec3], face: usize) -> Result<Self, MeshError> {
        let (vertices, boundary) =
            model.boundary(face, positions).map_err(|error| MeshError::of_face(face, error))?;
        Ok(Self { vertices, boundary })
    }

    pub(super) fn problem(
        &self,
        triangles: &[[u32; 3]],
    ) -> Result<Problem, mindeg_exact::Unsolved> {
        Problem::triangulated(&self.boundary, triangles)
    }

    pub(super) fn delaunay(&self, face: usize) -> Result<Vec<[u32; 3]>, MeshError> {
        mindeg_delaunay::triangles(&self.boundary, &[], &[], Progress::NONE)
            .map_err(|error| MeshError::of_face(face, error))
    }

    /// The tangent of the minimum angle of some triangles.
    pub(super) fn min_tangent(&self, triangles: &[[u32; 3]]) -> f64 {
        least_tangent(self.boundary.points(), triangles)
    }

    /// The triangulation of least degree by the formula, if the face is convex.
    pub(super) fn closed_form(&self) -> Option<Vec<[u32; 3]>> {
        let (points, runs) = (self.boundary.points(), self.boundary.runs());
        let n = points.len();
        if self.boundary.ring_count() > 1 {
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
