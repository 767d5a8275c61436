//! Why a file could not be read or written.

use std::collections::TryReserveError;
use std::io;

use glam::DVec3;
use mindeg_mesh::TriMeshError;
use thiserror::Error;

/// Why a file could not be read as a mesh.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ReadError {
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
    /// A second file that the first one needs could not be read. The kind of the source is
    /// [`InvalidInput`](io::ErrorKind::InvalidInput) if it is a URI that is never read.
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

impl ReadError {
    /// An error at a part of a structured format.
    pub(crate) fn place(place: impl Into<String>, problem: impl Into<String>) -> Self {
        Self::Place { place: place.into(), problem: problem.into() }
    }
}

/// Too little memory.
impl From<TryReserveError> for ReadError {
    fn from(error: TryReserveError) -> Self {
        Self::Io(error.into())
    }
}

/// Why a mesh could not be written.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum WriteError {
    /// The writer failed.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// A `.glb` gives its own length as a 32-bit number.
    #[error(
        "a .glb holds 4 GiB at most, and this mesh would take at least {bytes} bytes; write a \
         .gltf with its .bin or an OBJ, which may be larger, or use fewer intervals"
    )]
    TooLargeForGlb {
        /// The length of the file, or a lower bound of it.
        bytes: u64,
    },
    /// A coordinate beyond the range of 32-bit floats.
    #[error(
        "vertex {vertex} (counted from 0) at ({}, {}) is beyond the range of glTF's 32-bit \
         floats; scale the domain down, or write OBJ", .point.x, .point.y
    )]
    OutOfRange {
        /// The vertex.
        vertex: u32,
        /// Where it is.
        point: DVec3,
    },
    /// Two vertices that are one point in 32-bit floats.
    #[error(
        "vertices {} and {} (counted from 0) at ({}, {}) are too close together for glTF's \
         32-bit floats to tell them apart; use fewer intervals there, or write OBJ, which keeps \
         every digit", .vertices[0], .vertices[1], .point.x, .point.y
    )]
    Coincident {
        /// The vertices, in the order of the boundary.
        vertices: [u32; 2],
        /// Where the second is.
        point: DVec3,
    },
    /// A mesh with more vertices than a picture can show.
    #[error(
        "an SVG shows {limit} vertices at most, and this mesh has {vertices}; write OBJ or glTF, \
         or use fewer intervals"
    )]
    TooLargeForSvg {
        /// How many the mesh has.
        vertices: u32,
        /// The most an SVG shows.
        limit: u32,
    },
}
