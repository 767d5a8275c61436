//! Why a file could not be read.

use glam::DVec2;
use mindeg_domain::Projection;
use mindeg_mesh::place;
use thiserror::Error;

/// Why a file could not be read as outlines, or a polygon of it is not a domain.
#[derive(Clone, Debug, Error, PartialEq)]
#[error("{place}{}{problem}", if place.is_empty() { "" } else { ": " })]
pub struct OutlineError {
    /// Where: a line, a path into the document, a point. Empty for the whole file.
    pub place: String,
    /// The fault, and the way to fix it.
    pub problem: String,
    /// The places of the plane that both tell.
    pub(crate) told: Vec<DVec2>,
    /// Whether rings cross, touch or repeat points, which [`Outlines::repaired`] may mend.
    ///
    /// [`Outlines::repaired`]: super::Outlines::repaired
    pub is_touch: bool,
}

impl OutlineError {
    /// An error at a position in a file.
    pub(crate) fn place(place: impl Into<String>, problem: impl Into<String>) -> Self {
        let (place, problem, told) = (place.into(), problem.into(), Vec::new());
        Self { place, problem, told, is_touch: false }
    }

    /// The same error, which tells these places.
    pub(crate) fn telling(self, told: impl IntoIterator<Item = DVec2>) -> Self {
        Self { told: told.into_iter().collect(), ..self }
    }

    /// The same error with its places in degrees, as a file has them that was projected.
    #[must_use]
    pub fn in_degrees(mut self, projection: &Projection) -> Self {
        for at in &self.told {
            let words = Projection::in_words(projection.to_degrees(*at));
            for text in [&mut self.place, &mut self.problem] {
                *text = text.replace(&place(*at), &words);
            }
        }
        self
    }
}

impl From<mindeg_formats::ReadError> for OutlineError {
    fn from(error: mindeg_formats::ReadError) -> Self {
        Self::place("", error.to_string())
    }
}

impl From<mindeg_domain::DomainError> for OutlineError {
    fn from(error: mindeg_domain::DomainError) -> Self {
        let of_more = error.more.iter().flat_map(|other| &other.told);
        let told: Vec<DVec2> = error.told.iter().chain(of_more).copied().collect();
        Self { is_touch: error.is_touch, ..Self::place("", error.to_string()).telling(told) }
    }
}
