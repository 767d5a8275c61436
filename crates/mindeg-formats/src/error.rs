//! Why a file could not be read or written: a place, and a sentence.

use std::collections::TryReserveError;
use std::fmt::Display;
use std::io;

use glam::DVec3;
use mindeg_mesh::{Positions, TriMeshError, coordinate};
use thiserror::Error;

/// Why a file could not be read as a mesh.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ReadError {
    /// The reader failed.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// A second file that the first one needs could not be read. The kind of the source is
    /// [`InvalidInput`](io::ErrorKind::InvalidInput) if it is a URI that is never read.
    #[error("the file {uri:?}, which this one needs, could not be read: {source}")]
    External {
        /// The file, as the first one names it.
        uri: String,
        /// The error of the input.
        source: io::Error,
    },
    /// The file breaks the rules of its format, or uses a feature that is not read.
    #[error("{place}{}{problem}", if .place.is_empty() { "" } else { ": " })]
    Fault {
        /// The line, counted from 1; the byte, counted from 0; or a path into the document. Empty
        /// for the whole file.
        place: String,
        /// The fault, and what would be right.
        problem: String,
    },
}

impl ReadError {
    /// An error in a line of a text, counted from 1.
    pub(crate) fn line(line: u64, problem: impl Into<String>) -> Self {
        Self::place(format!("line {line}"), problem)
    }

    /// An error at an offset of a binary file.
    pub(crate) fn byte(offset: impl Display, problem: impl Into<String>) -> Self {
        Self::place(format!("byte {offset}"), problem)
    }

    /// An error at a part of a structured format; an empty place is the whole file.
    pub(crate) fn place(place: impl Into<String>, problem: impl Into<String>) -> Self {
        Self::Fault { place: place.into(), problem: problem.into() }
    }

    /// The same error; a fault without a place gets that of `at`.
    pub(crate) fn or_at(self, at: impl FnOnce(String) -> Self) -> Self {
        match self {
            Self::Fault { place, problem } if place.is_empty() => at(problem),
            error => error,
        }
    }

    /// The same error, in a file that is one of several.
    pub(crate) fn within(self, file: &str) -> Self {
        match self {
            Self::Fault { place, problem } => Self::place(format!("{file}, {place}"), problem),
            error => error,
        }
    }
}

/// Too little memory.
impl From<TryReserveError> for ReadError {
    fn from(error: TryReserveError) -> Self {
        Self::Io(error.into())
    }
}

/// Points and triangles that are not a mesh.
impl From<TriMeshError> for ReadError {
    fn from(error: TriMeshError) -> Self {
        Self::place("", error.to_string())
    }
}

/// Why a mesh could not be written.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum WriteError {
    /// The writer failed.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// The format cannot hold the mesh: a sentence that says why and what to do.
    #[error("{0}")]
    Refused(String),
}

impl WriteError {
    /// Refuses a mesh with more of something than a format holds.
    pub(crate) fn unless_at_most(
        limit: u32,
        (format, what): (&str, &str),
        count: u64,
    ) -> Result<(), Self> {
        if count <= limit.into() {
            return Ok(());
        }
        Err(Self::Refused(format!(
            "{format} holds {limit} {what} at most, and this mesh has {count}"
        )))
    }

    /// Refuses positions that do not all have the same z.
    pub(crate) fn unless_in_plane(format: &str, positions: &dyn Positions) -> Result<(), Self> {
        let bounds = positions.bounds();
        let [min, max] = [bounds.min.z, bounds.max.z];
        if min == max {
            return Ok(());
        }
        Err(Self::Refused(format!(
            "{format} holds meshes in the plane, and the z of this one goes from {} to {}; \
             write .vtu, .ply or .obj instead",
            coordinate(min),
            coordinate(max)
        )))
    }

    /// A coordinate beyond the range of 32-bit floats.
    pub(crate) fn out_of_range(vertex: u32, point: DVec3) -> Self {
        let DVec3 { x, y, .. } = point;
        Self::Refused(format!(
            "vertex {vertex} (counted from 0) at ({x}, {y}) is beyond the range of 32-bit \
             floats; scale the domain down, or write OBJ"
        ))
    }

    /// Two vertices, in the order of the boundary, that are one point in 32-bit floats.
    pub(crate) fn coincident([first, second]: [u32; 2], point: DVec3) -> Self {
        let DVec3 { x, y, .. } = point;
        Self::Refused(format!(
            "vertices {first} and {second} (counted from 0) at ({x}, {y}) are too close together \
             for 32-bit floats to tell them apart; use fewer intervals there, or write OBJ, which \
             keeps every digit"
        ))
    }
}
