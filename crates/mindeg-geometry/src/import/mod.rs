//! Reading triangle meshes from files, whatever program wrote them.
//!
//! [`obj`] and [`gltf`] turn a file into a [`TriMesh`]: positions and triangles under
//! the file's own vertex numbers, from which the boundary can be had again. Readers take
//! an [`std::io::Read`] or [`std::io::BufRead`]; a malformed file is an error that says what is
//! wrong and where, never a panic.
//!
//! Limits: the surface alone is read. Normals, texture coordinates, colors, materials,
//! animations and skins are not.

pub mod gltf;
pub mod obj;

pub use mindeg_mesh::{NonTriangles, Part, TriMesh, TriMeshError};

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
    /// Points and triangles that are no mesh.
    #[error(transparent)]
    Mesh(#[from] TriMeshError),
}
