//! Why a file could not be read.

use thiserror::Error;

/// Why a file could not be read as outlines.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum ReadError {
    /// A line of a text format is not as the format has it.
    #[error("line {line}: {problem}")]
    Line {
        /// The line, counted from 1.
        line: u64,
        /// What is wrong, and what would be right.
        problem: String,
    },
    /// A part of a file is not as the format has it, or not supported.
    #[error("{place}: {problem}")]
    Place {
        /// The part: a path into the document, a point, a position in the text.
        place: String,
        /// What is wrong, and what would be right.
        problem: String,
    },
}

impl ReadError {
    /// An error at a part of a file.
    pub(crate) fn place(place: impl Into<String>, problem: impl Into<String>) -> Self {
        Self::Place { place: place.into(), problem: problem.into() }
    }
}
