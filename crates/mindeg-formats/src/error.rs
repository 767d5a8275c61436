//! Why a file could not be read or written.

use std::collections::TryReserveError;
use std::io;

use glam::DVec3;
use mindeg_mesh::{Positions, TriMeshError};
use thiserror::Error;

use crate::format::Format;

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
    /// Bytes of a binary format are not as the format has them.
    #[error("byte {offset}: {problem}")]
    Byte {
        /// The offset in the file, counted from 0.
        offset: u64,
        /// What is wrong, and what would be right.
        problem: String,
    },
    /// The name and the content of a file do not agree on a format, or tell none that is read.
    #[error("{problem}")]
    Format {
        /// What the two say, and what to do.
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
    /// An error in a line of a text, counted from 1.
    pub(crate) fn line(line: u64, problem: impl Into<String>) -> Self {
        Self::Line { line, problem: problem.into() }
    }

    /// An error at an offset of a binary file.
    pub(crate) fn byte(offset: usize, problem: impl Into<String>) -> Self {
        Self::Byte { offset: offset as u64, problem: problem.into() }
    }

    /// The same error, in a file that is one of several.
    pub(crate) fn within(self, file: &str) -> Self {
        match self {
            Self::Line { line, problem } => Self::place(format!("{file}, line {line}"), problem),
            error => error,
        }
    }

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
        "vertex {vertex} (counted from 0) at ({}, {}) is beyond the range of 32-bit \
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
        "vertices {} and {} (counted from 0) at ({}, {}) are too close together for \
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
    /// A mesh in space, in a format for meshes in the plane.
    #[error(
        "{} holds meshes in the plane, and the z of this one goes from {} to {}; write .vtu, \
         .ply or .obj instead", .format.description(), .z[0], .z[1]
    )]
    NotInPlane {
        /// The format.
        format: Format,
        /// The smallest and the largest z.
        z: [f64; 2],
    },
    /// A format that does not hold so large a mesh.
    #[error("{} holds {limit} {what} at most, and this mesh has {count}", .format.description())]
    TooLarge {
        /// The format.
        format: Format,
        /// What there are too many of.
        what: &'static str,
        /// How many the mesh has.
        count: u64,
        /// The most that the format holds.
        limit: u64,
    },
    /// A format that this build leaves out.
    #[error("this build of mindeg does not write {}; write .svg, or build it with the feature {feature}", .format.description())]
    NotBuilt {
        /// The format.
        format: Format,
        /// The feature that brings it.
        feature: &'static str,
    },
    /// A format that is read and not written.
    #[error("{} is read and not written", .0.description())]
    NotWritten(Format),
}

impl WriteError {
    /// Refuses more vertices than a 32-bit integer with a sign counts from 1.
    pub(crate) fn unless_numbered(format: Format, positions: &dyn Positions) -> Result<(), Self> {
        let (count, limit) = (positions.vertex_count().into(), i32::MAX.unsigned_abs().into());
        if count <= limit {
            return Ok(());
        }
        Err(Self::TooLarge { format, what: "vertices", count, limit })
    }

    /// Refuses positions that do not all have the same z.
    pub(crate) fn unless_in_plane(format: Format, positions: &dyn Positions) -> Result<(), Self> {
        let bounds = positions.bounds();
        let z = [bounds.min.z, bounds.max.z];
        if z[0] == z[1] { Ok(()) } else { Err(Self::NotInPlane { format, z }) }
    }
}
