//! A triangle mesh in space as a file has it.

use crate::connectivity::boundary::{BoundaryEdges, BoundaryLoop};
use crate::connectivity::stars::Stars;
use glam::DVec3;
use std::ops::Range;
use thiserror::Error;

/// A triangle mesh in space: any number of parts, with or without boundary, sound or not.
///
/// Vertices are numbered from 0 in the order of the file, whether a triangle uses them or not.
/// Every triangle names existing vertices, and every position is finite; nothing else is
/// promised: triangles may repeat, be flat, disagree in orientation or meet three at an edge.
///
/// # Example
///
/// ```
/// use glam::DVec3;
/// use mindeg_mesh::TriMesh;
///
/// let square = vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
/// let mesh = TriMesh::new(square, vec![[0, 1, 2], [0, 2, 3]])?;
/// assert_eq!(mesh.boundary_loops()[0].vertices, [0, 1, 2, 3]);
/// # Ok::<(), mindeg_mesh::TriMeshError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct TriMesh {
    positions: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    parts: Vec<Part>,
    non_triangles: NonTriangles,
}

/// Why points and triangles are no [`TriMesh`].
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum TriMeshError {
    /// A triangle names a vertex that the mesh does not have.
    #[error(
        "triangle {triangle} (counted from 0) has a vertex {vertex}, and the mesh has {vertices} \
         vertices"
    )]
    NoSuchVertex {
        /// The triangle, counted from 0.
        triangle: usize,
        /// The vertex, counted from 0.
        vertex: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A position with a coordinate that is infinite or not a number.
    #[error("vertex {vertex} (counted from 0) has a coordinate that is not a finite number")]
    NotFinite {
        /// The vertex, counted from 0.
        vertex: usize,
    },
    /// More vertices than there are vertex numbers.
    #[error("the mesh has {vertices} vertices, and {} is the most that can be read", u32::MAX)]
    TooManyVertices {
        /// How many vertices there are.
        vertices: usize,
    },
    /// More triangles than there are triangle numbers.
    #[error("the mesh has {triangles} triangles, and {} is the most that can be read", u32::MAX)]
    TooManyTriangles {
        /// How many triangles there are.
        triangles: usize,
    },
    /// There is no surface in the file.
    #[error(
        "the file holds no triangle and no other face ({vertices} vertices, {line_segments} line \
         segments); is it a mesh in this format?"
    )]
    NoFaces {
        /// How many vertices there are.
        vertices: usize,
        /// How many line segments there are.
        line_segments: u64,
    },
}

/// A named stretch of a mesh's triangles: an object or group of an OBJ, a node of a glTF.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// The name in the file; empty where there is none.
    pub name: String,
    /// The triangles of the part; never empty.
    pub triangles: Range<usize>,
}

/// What a file held besides triangles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NonTriangles {
    /// Faces with four corners. Each was split into two triangles at its first corner.
    pub quads: u64,
    /// Faces with more corners. Each was split into a fan from its first corner.
    pub polygons: u64,
    /// Line segments. They were left out.
    pub line_segments: u64,
    /// Single points. They were left out.
    pub points: u64,
}

impl TriMesh {
    /// A mesh from positions and triangles, as one part without a name. O(n).
    ///
    /// # Errors
    ///
    /// A position that is not finite, a triangle with a vertex that is not there, more than
    /// `u32::MAX` vertices or triangles, or no triangle at all.
    pub fn new(positions: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Result<Self, TriMeshError> {
        let parts = vec![Part { name: String::new(), triangles: 0..triangles.len() }];
        Self::with_parts(positions, triangles, parts, NonTriangles::default())
    }

    /// A mesh in several parts, which hold every triangle once, in order. O(n).
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new).
    pub fn with_parts(
        positions: Vec<DVec3>,
        triangles: Vec<[u32; 3]>,
        mut parts: Vec<Part>,
        non_triangles: NonTriangles,
    ) -> Result<Self, TriMeshError> {
        let vertices = positions.len();
        if u32::try_from(vertices).is_err() {
            return Err(TriMeshError::TooManyVertices { vertices });
        }
        if u32::try_from(triangles.len()).is_err() {
            return Err(TriMeshError::TooManyTriangles { triangles: triangles.len() });
        }
        if triangles.is_empty() {
            let line_segments = non_triangles.line_segments;
            return Err(TriMeshError::NoFaces { vertices, line_segments });
        }
        if let Some(vertex) = positions.iter().position(|position| !position.is_finite()) {
            return Err(TriMeshError::NotFinite { vertex });
        }
        for (triangle, corners) in triangles.iter().enumerate() {
            if let Some(&vertex) = corners.iter().find(|&&vertex| vertex as usize >= vertices) {
                return Err(TriMeshError::NoSuchVertex { triangle, vertex, vertices });
            }
        }
        parts.retain(|part| !part.triangles.is_empty());
        Ok(Self { positions, triangles, parts, non_triangles })
    }

    /// The positions of the vertices, in units of the file.
    #[must_use]
    pub fn positions(&self) -> &[DVec3] {
        &self.positions
    }

    /// The triangles by their vertices, in the order and orientation of the file. At least one.
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The parts, which hold every triangle once, in order.
    #[must_use]
    pub fn parts(&self) -> &[Part] {
        &self.parts
    }

    /// The loops of edges that belong to one triangle only, in the order of their first
    /// vertices.
    ///
    /// At a vertex, a loop goes on with the boundary edge found by turning from triangle to
    /// triangle, so that loops which touch in a vertex stay apart. A closed loop starts at its
    /// least vertex; one that runs into an edge with three triangles or more is open. Triangles
    /// that name a vertex twice are passed over. O(n) time and memory, but for sorting at
    /// vertices of very high degree.
    #[must_use]
    pub fn boundary_loops(&self) -> Vec<BoundaryLoop> {
        BoundaryEdges::new(&Stars::new(self.positions.len(), &self.triangles)).loops()
    }

    /// What the file held besides triangles.
    #[must_use]
    pub fn non_triangles(&self) -> NonTriangles {
        self.non_triangles
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refuses_what_is_no_mesh_and_says_what() {
        let square = [DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
        let mut broken = square;
        broken[2].y = f64::NAN;
        for (positions, triangles, message) in [
            (
                square,
                vec![],
                "the file holds no triangle and no other face (4 vertices, 0 line segments); is it a mesh in this format?",
            ),
            (
                square,
                vec![[0, 1, 2], [0, 2, 4]],
                "triangle 1 (counted from 0) has a vertex 4, and the mesh has 4 vertices",
            ),
            (
                broken,
                vec![[0, 1, 2]],
                "vertex 2 (counted from 0) has a coordinate that is not a finite number",
            ),
        ] {
            let error = TriMesh::new(positions.to_vec(), triangles).unwrap_err();
            assert_eq!(error.to_string(), message);
        }
    }
}
