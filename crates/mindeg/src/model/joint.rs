//! The triangulations of all faces, and the degrees that they make together.

use glam::DVec3;
use mindeg_domain::Model;
use mindeg_exact::Problem;
use mindeg_mesh::Progress;

use super::face::PlaneFace;
use crate::error::MeshError;
use mindeg_mesh::parallel::map_all;

/// Faces from one report of progress to the next.
const REPORT: usize = 1 << 10;

/// A model with a triangulation of every face.
pub(super) struct Joint<'m> {
    pub(super) model: &'m Model,
    pub(super) positions: Vec<DVec3>,
    faces: Vec<PlaneFace>,
    /// For each face its triangles, by indices on its rings.
    pub(super) triangles: Vec<Vec<[u32; 3]>>,
    /// For each vertex its edges, over all faces.
    pub(super) totals: Vec<u32>,
    /// For each vertex its edges of the divided model.
    pub(super) edge_degrees: Vec<u32>,
    /// For each face the least tangent of an angle that it must keep.
    pub(super) thresholds: Vec<f64>,
    /// For each face the tangent of its Delaunay triangulation's minimum angle, if angles count.
    delaunay: Vec<f64>,
}

/// A face, its first triangles, the tangent it must keep and Delaunay's.
type First = (PlaneFace, Vec<[u32; 3]>, f64, f64);

impl<'m> Joint<'m> {
    /// Starts from the formula for convex faces and from Delaunay for others; from Delaunay for all
    /// if angles count.
    pub(super) fn new(
        model: &'m Model,
        keep_angle: Option<f64>,
        progress: Progress<'_>,
    ) -> Result<Self, MeshError> {
        let positions = model.positions();
        let mut triangles = Vec::with_capacity(model.face_count());
        let mut thresholds = Vec::with_capacity(model.face_count());
        let mut delaunay = Vec::new();
        let mut faces = Vec::with_capacity(model.face_count());
        let indices: Vec<usize> = (0..model.face_count()).collect();
        let counter = progress.counter("triangulating faces", indices.len() as u64);
        for chunk in indices.chunks(REPORT) {
            let firsts = map_all(chunk.to_vec(), |face| first(model, &positions, face, keep_angle));
            for first in firsts {
                let (face, first, threshold, tangent) = first?;
                faces.push(face);
                triangles.push(first);
                thresholds.push(threshold);
                if keep_angle.is_some() {
                    delaunay.push(tangent);
                }
            }
            counter.add(chunk.len())?;
        }
        let edge_degrees = model.edge_degrees();
        let mut totals = edge_degrees.clone();
        for (face, triangles) in faces.iter().zip(&triangles) {
            let vertices = &face.vertices;
            for (chords, &vertex) in chords(vertices.len(), triangles).iter().zip(vertices) {
                totals[vertex as usize] += chords;
            }
        }
        Ok(Self { model, positions, faces, triangles, totals, edge_degrees, thresholds, delaunay })
    }

    pub(super) fn face(&self, face: usize) -> &PlaneFace {
        &self.faces[face]
    }

    pub(super) fn max_degree(&self) -> u32 {
        self.totals.iter().copied().max().unwrap_or(0)
    }

    /// Gives a face other triangles.
    pub(super) fn replace(&mut self, face: usize, triangles: Vec<[u32; 3]>) {
        let vertices = &self.faces[face].vertices;
        let before = chords(vertices.len(), &self.triangles[face]);
        let after = chords(vertices.len(), &triangles);
        for ((before, after), &vertex) in before.iter().zip(&after).zip(vertices) {
            let total = &mut self.totals[vertex as usize];
            *total = *total + after - before;
        }
        self.triangles[face] = triangles;
    }

    /// The smallest share that a face has of its Delaunay triangulation's minimum angle.
    pub(super) fn angle_share(&self) -> Option<f64> {
        let share = |(face, &most): (usize, &f64)| {
            let own = self.face(face).min_tangent(&self.triangles[face]);
            libm::atan(own) / libm::atan(most)
        };
        self.delaunay.iter().enumerate().map(share).min_by(f64::total_cmp)
    }
}

/// The chords at each place of a face: a vertex has as many triangles, less one.
pub(super) fn chords(places: usize, triangles: &[[u32; 3]]) -> Vec<u32> {
    let mut counts = vec![0_u32; places];
    triangles.as_flattened().iter().for_each(|&place| counts[place as usize] += 1);
    counts.iter().map(|count| count.saturating_sub(1)).collect()
}

fn first(
    model: &Model,
    positions: &[DVec3],
    face: usize,
    keep_angle: Option<f64>,
) -> Result<First, MeshError> {
    let plane_face = PlaneFace::new(model, positions, face)?;
    let check = |triangles: &[[u32; 3]]| -> Result<Problem, MeshError> {
        let failed = |error| MeshError::of_face(face, error);
        plane_face.problem(triangles).map_err(failed)
    };
    let Some(share) = keep_angle else {
        let closed_form = plane_face.closed_form();
        if let Some(triangles) = closed_form.filter(|triangles| check(triangles).is_ok()) {
            return Ok((plane_face, triangles, 0.0, 0.0));
        }
        let triangles = plane_face.delaunay(face)?;
        check(&triangles)?;
        return Ok((plane_face, triangles, 0.0, 0.0));
    };
    let triangles = plane_face.delaunay(face)?;
    check(&triangles)?;
    let most = plane_face.min_tangent(&triangles);
    // Tangents are compared to 36 bits; the last of them decides nothing.
    let threshold = libm::tan(share * libm::atan(most)) * (1.0 - 1e-10);
    Ok((plane_face, triangles, threshold.min(most), most))
}
