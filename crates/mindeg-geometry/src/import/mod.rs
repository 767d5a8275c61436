//! Reading triangle meshes from files, whatever program wrote them.
//!
//! [`obj`] and [`gltf`] turn a file into a [`SurfaceMesh`]: positions and triangles under
//! the file's own vertex numbers, from which the boundary can be had again. Readers take
//! an [`std::io::Read`] or [`std::io::BufRead`]; a malformed file is an error that says what is
//! wrong and where, never a panic.
//!
//! Limits: the surface alone is read. Normals, texture coordinates, colors, materials,
//! animations and skins are not.

pub mod gltf;
pub mod obj;
mod surface;

pub use crate::connectivity::boundary::BoundaryLoop;
pub use surface::{NonTriangles, Part, SurfaceMesh};

use std::io;
use thiserror::Error;

/// Why a file could not be read as a mesh.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ImportError {
    /// The reader failed.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// A line of a text format is not as the format has it.
    #[error("line {line}: {problem}")]
    Line {
        /// The line, counted from 1.
        line: u64,
        /// What is wrong, and what would be right.
        problem: String,
    },
    /// A part of a structured format is not as the format has it, or not supported.
    #[error("{place}: {problem}")]
    Place {
        /// The part, as a path into the document.
        place: String,
        /// What is wrong, and what would be right.
        problem: String,
    },
    /// A second file that the first one needs could not be read.
    #[error("the file {uri:?}, which this one needs, could not be read: {source}")]
    External {
        /// The file, as the first one names it.
        uri: String,
        /// What went wrong.
        source: io::Error,
    },
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
