//! The triangulations of all faces, and the degrees that they make together.

use mindeg_mesh::Progress;

use super::face::PlaneFace;
use crate::error::MeshError;
use mindeg_mesh::parallel::map_all;

/// Faces from one report of progress to the next.
const REPORT: usize = 1 << 10;

/// Faces with a triangulation of each.
pub(crate) struct Joint {
    faces: Vec<PlaneFace>,
    /// For each face its triangles, by indices on its rings.
    pub(crate) triangles: Vec<Vec<[u32; 3]>>,
    /// For each vertex its edges, over all faces.
    pub(crate) totals: Vec<u32>,
    /// For each vertex its edges that every mesh has.
    pub(crate) edge_degrees: Vec<u32>,
    /// For each face the least tangent of an angle that it must keep.
    pub(crate) thresholds: Vec<f64>,
    /// For each face the tangent of its Delaunay triangulation's minimum angle, if angles count.
    delaunay: Vec<f64>,
}

/// A face, its first triangles, the tangent it must keep and Delaunay's.
type First = (PlaneFace, Vec<[u32; 3]>, f64, f64);

impl Joint {
    /// Starts from the formula for convex faces and from Delaunay for others; from Delaunay for all
    /// if angles count. `face` makes the face with an index below `face_count`; `edge_degrees` are the edges that every
    /// mesh has, at each vertex.
    pub(crate) fn new(
        face_count: usize,
        face: impl Fn(usize) -> Result<PlaneFace, MeshError> + Sync,
        edge_degrees: Vec<u32>,
        keep_angle: Option<f64>,
        progress: Progress<'_>,
    ) -> Result<Self, MeshError> {
        let mut triangles = Vec::with_capacity(face_count);
        let mut thresholds = Vec::with_capacity(face_count);
        let mut delaunay = Vec::new();
        let mut faces = Vec::with_capacity(face_count);
        let indices: Vec<usize> = (0..face_count).collect();
        let counter = progress.counter("triangulating faces", indices.len() as u64);
        for chunk in indices.chunks(REPORT) {
            let firsts = map_all(chunk.to_vec(), |index| first(face(index)?, index, keep_angle));
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
        let mut totals = edge_degrees.clone();
        for (face, triangles) in faces.iter().zip(&triangles) {
            for (chords, &vertex) in face.chords(triangles).iter().zip(&face.vertices) {
                totals[vertex as usize] += chords;
            }
        }
        Ok(Self { faces, triangles, totals, edge_degrees, thresholds, delaunay })
    }

    pub(crate) fn face_count(&self) -> usize {
        self.faces.len()
    }

    pub(crate) fn face(&self, face: usize) -> &PlaneFace {
        &self.faces[face]
    }

    pub(crate) fn max_degree(&self) -> u32 {
        self.totals.iter().copied().max().unwrap_or(0)
    }

    /// Counts so many edges more at a vertex.
    pub(crate) fn raise(&mut self, vertex: u32, by: u32) {
        for degrees in [&mut self.edge_degrees, &mut self.totals] {
            let degree = &mut degrees[vertex as usize];
            *degree = degree.saturating_add(by);
        }
    }

    /// Gives a face other triangles.
    pub(crate) fn replace(&mut self, face: usize, triangles: Vec<[u32; 3]>) {
        let own = &self.faces[face];
        let (before, after) = (own.chords(&self.triangles[face]), own.chords(&triangles));
        for ((before, after), &vertex) in before.iter().zip(&after).zip(&own.vertices) {
            let total = &mut self.totals[vertex as usize];
            *total = *total + after - before;
        }
        self.triangles[face] = triangles;
    }

    /// Asks of every face for this share of the least of their Delaunay triangulations' minimum angles, in place of its own.
    pub(crate) fn keep_least(&mut self, share: f64) {
        let least = self.delaunay_tangent();
        let threshold = (libm::tan(share * libm::atan(least)) * (1.0 - 1e-10)).min(least);
        self.thresholds.fill(threshold);
    }

    /// The tangent of the minimum angle of all faces' Delaunay triangulations, if angles count.
    pub(crate) fn delaunay_tangent(&self) -> f64 {
        self.delaunay.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// The smallest share that a face has of its Delaunay triangulation's minimum angle.
    pub(crate) fn angle_share(&self) -> Option<f64> {
        let share = |(face, &most): (usize, &f64)| {
            let own = self.face(face).min_tangent(&self.triangles[face]);
            libm::atan(own) / libm::atan(most)
        };
        self.delaunay.iter().enumerate().map(share).min_by(f64::total_cmp)
    }
}

/// A face's first triangles.
fn first(plane_face: PlaneFace, face: usize, keep_angle: Option<f64>) -> Result<First, MeshError> {
    let check = |triangles: &[[u32; 3]]| {
        plane_face.check(triangles).map_err(|error| MeshError::of_face(face, error))
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
