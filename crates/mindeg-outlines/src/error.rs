//! Why a file could not be read.

use thiserror::Error;

/// Why a file could not be read as outlines, or a polygon of it is not a domain.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("{place}{}{problem}", if place.is_empty() { "" } else { ": " })]
pub struct OutlineError {
    /// Where: a line, a path into the document, a point. Empty for the whole file.
    pub place: String,
    /// The fault, and the way to fix it.
    pub problem: String,
    /// Whether rings cross, touch or repeat points, which [`Outlines::repaired`] may mend.
    ///
    /// [`Outlines::repaired`]: super::Outlines::repaired
    pub is_touch: bool,
}

impl OutlineError {
    /// An error at a position in a file.
    pub(crate) fn place(place: impl Into<String>, problem: impl Into<String>) -> Self {
        Self { place: place.into(), problem: problem.into(), is_touch: false }
    }
}

impl From<mindeg_formats::ReadError> for OutlineError {
    fn from(error: mindeg_formats::ReadError) -> Self {
        Self::place("", error.to_string())
    }
}

impl From<mindeg_domain::DomainError> for OutlineError {
    fn from(error: mindeg_domain::DomainError) -> Self {
        Self { is_touch: error.is_touch, ..Self::place("", error.to_string()) }
    }
}
