//! Faces as a file lists them, of three corners and more.

use crate::lists::push;
use glam::DVec3;
use mindeg_mesh::ear_clipping::cut_polygon;
use mindeg_mesh::{NonTriangles, Polygons, TriMesh, TriMeshError};
use std::collections::TryReserveError;

/// The faces of a file so far. Faces of more than three corners are cut at the end, when all
/// positions are known.
#[derive(Default)]
pub(crate) struct FaceList {
    triangles: Vec<[u32; 3]>,
    /// Set when the first face with more than three corners is read.
    polygons: Option<Polygons>,
    quads: u64,
    larger: u64,
}

impl FaceList {
    /// How many triangles the faces take.
    pub(crate) fn triangle_count(&self) -> usize {
        self.triangles.len()
    }

    /// How many faces there are.
    pub(crate) fn face_count(&self) -> u64 {
        // Each start has one polygon.
        let polygons = self.polygons.as_ref().map(|polygons| polygons.triangle_starts.len());
        polygons.unwrap_or(self.triangles.len()) as u64
    }

    /// Adds a face. One with fewer than three corners is left out.
    pub(crate) fn push(&mut self, corners: &[u32]) -> Result<(), TryReserveError> {
        let &[a, b, ref others @ ..] = corners else { return Ok(()) };
        match others {
            [] => return Ok(()),
            [_] => {}
            [_, _] => self.quads += 1,
            _ => self.larger += 1,
        }
        let first = self.triangles.len();
        self.triangles.try_reserve(others.len())?;
        self.triangles.push([a, b, others[0]]);
        // A place for the triangles that the face will be cut into.
        self.triangles.extend(others.windows(2).map(|edge| [a, edge[0], edge[1]]));
        if self.polygons.is_none() && corners.len() > 3 {
            self.polygons = Some(as_polygons(&self.triangles[..first])?);
        }
        if let Some(polygons) = &mut self.polygons {
            // More triangles than 32 bits count are refused at the end.
            push(&mut polygons.triangle_starts, first as u32)?;
            polygons.corners.try_reserve(corners.len())?;
            polygons.corners.extend_from_slice(corners);
        }
        Ok(())
    }

    /// The mesh of these faces, in one group; `counts` are those of what else the file has.
    ///
    /// # Errors
    ///
    /// As [`TriMesh::new`].
    pub(crate) fn into_mesh(
        self,
        positions: Vec<DVec3>,
        counts: NonTriangles,
    ) -> Result<TriMesh, TriMeshError> {
        let Self { mut triangles, polygons, quads, larger } = self;
        let Ok(triangle_count) = u32::try_from(triangles.len()) else {
            return Err(TriMeshError::too_many("triangles", triangles.len()));
        };
        let Some(mut polygons) = polygons else {
            return Ok(TriMesh::new(positions, triangles)?.with_non_triangles(counts));
        };
        polygons.triangle_starts.push(triangle_count);
        let exists = |&corner: &u32| {
            positions.get(corner as usize).is_some_and(|position| position.is_finite())
        };
        // Otherwise the faces are not a mesh; the code below finds the reason.
        if polygons.corners.iter().all(exists) {
            cut_polygons(&polygons, &positions, &mut triangles);
        }
        let counts = NonTriangles { quads, polygons: larger, ..counts };
        Ok(TriMesh::new(positions, triangles)?.with_polygons(polygons).with_non_triangles(counts))
    }
}

/// Triangles as polygons, but for where the last one ends.
fn as_polygons(triangles: &[[u32; 3]]) -> Result<Polygons, TryReserveError> {
    let mut polygons = Polygons::default();
    polygons.triangle_starts.try_reserve(triangles.len() + 2)?;
    polygons.triangle_starts.extend(0..triangles.len() as u32);
    polygons.corners.try_reserve(3 * triangles.len())?;
    polygons.corners.extend_from_slice(triangles.as_flattened());
    Ok(polygons)
}

/// Cuts the polygons into triangles, each into those that have been set aside for it.
fn cut_polygons(polygons: &Polygons, positions: &[DVec3], triangles: &mut [[u32; 3]]) {
    let mut cut = Vec::new();
    for (corners, &start) in polygons.iter().zip(&polygons.triangle_starts) {
        if corners.len() > 3 {
            cut.clear();
            cut_polygon(corners, positions, &mut cut);
            triangles[start as usize..][..cut.len()].copy_from_slice(&cut);
        }
    }
}
