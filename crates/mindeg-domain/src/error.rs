//! Errors in a domain or a model, and the places in its description.

use std::fmt;

use glam::DVec2;
use mindeg_mesh::planar::InRing;

/// An error in the description of a domain or a model, and its place.
///
/// Sides and corners are those of the description, even if a ring was reversed.
///
/// # Example
///
/// ```
/// use mindeg_domain::{Domain, Side};
///
/// let mut sides = vec![Side::count(2); 4];
/// sides[2] = Side::size(0.0);
/// let error = Domain::rectangle(4.0, 3.0, sides).unwrap_err();
/// assert_eq!(error.place.to_string(), "sides[2].size");
/// assert_eq!(error.message, "side 3: the size is 0.0; it must be a finite number above 0");
/// ```
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{message}{}", also(more.iter().map(|it| &*it.message)))]
#[non_exhaustive]
pub struct DomainError {
    /// The place of the error in the description.
    pub place: Place,
    /// The error and how to fix it.
    pub message: String,
    /// The places of the plane that the message tells, as [`place`](fn@mindeg_mesh::place) writes them.
    pub told: Vec<DVec2>,
    /// Whether points or edges meet that should be apart; a repair of the rings may fix it.
    pub is_touch: bool,
    /// The other faults of the rings, lines and points.
    pub more: Vec<DomainError>,
}

/// A value in a description: the keys and indices from 0 that lead to it in JSON; empty for the whole.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Place(pub(crate) Vec<Step>);

/// One step on the way to a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Step {
    Key(String),
    Index(usize),
}

impl From<&str> for Step {
    fn from(key: &str) -> Self {
        Self::Key(key.to_owned())
    }
}

impl From<usize> for Step {
    fn from(index: usize) -> Self {
        Self::Index(index)
    }
}

/// `holes[0].sides[2].name`; nothing for the whole.
impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (at, step) in self.0.iter().enumerate() {
            match step {
                Step::Key(key) if at == 0 => write!(f, "{}", key.escape_debug())?,
                Step::Key(key) => write!(f, ".{}", key.escape_debug())?,
                Step::Index(index) => write!(f, "[{index}]")?,
            }
        }
        Ok(())
    }
}

impl Place {
    /// A value inside this one.
    pub(crate) fn then(mut self, step: impl Into<Step>) -> Self {
        self.0.push(step.into());
        self
    }

    /// A key of the whole description.
    pub(crate) fn key(key: &str) -> Self {
        Self::default().then(key)
    }

    /// A ring; the outer ring is the whole description.
    pub(crate) fn ring(ring: usize) -> Self {
        match ring.checked_sub(1) {
            None => Self::default(),
            Some(hole) => Self::key("holes").then(hole),
        }
    }

    pub(crate) fn corners(ring: usize) -> Self {
        let outline = if ring == 0 { Self::key("polygon") } else { Self::ring(ring) };
        outline.then("corners")
    }

    pub(crate) fn corner(corner: InRing) -> Self {
        Self::corners(corner.ring).then(corner.index)
    }

    pub(crate) fn side(side: InRing) -> Self {
        Self::ring(side.ring).then("sides").then(side.index)
    }

    /// A fault of this value.
    pub(crate) fn error(self, message: impl Into<String>) -> DomainError {
        let (message, told, more) = (message.into(), Vec::new(), Vec::new());
        DomainError { place: self, message, told, is_touch: false, more }
    }

    /// Points or edges that meet.
    pub(crate) fn touch(self, message: impl Into<String>) -> DomainError {
        DomainError { is_touch: true, ..self.error(message) }
    }
}

impl DomainError {
    /// The same error, whose message tells these places.
    pub(crate) fn telling(self, told: impl IntoIterator<Item = DVec2>) -> Self {
        Self { told: told.into_iter().collect(), ..self }
    }

    /// The same error, seen from the value that contains this one.
    pub(crate) fn inside(mut self, mut whole: Place) -> Self {
        let more = self.more.into_iter().map(|error| error.inside(whole.clone())).collect();
        whole.0.append(&mut self.place.0);
        Self { place: whole, more, ..self }
    }

    /// As [`inside`](Self::inside); the message also names the outer value first.
    pub(crate) fn within(self, whole: Place, name: &str) -> Self {
        let message = format!("{name}: {}", self.message);
        Self { message, ..self }.inside(whole)
    }

    pub(crate) fn of_side(self, side: InRing) -> Self {
        self.within(Place::side(side), &side.side())
    }
}

/// A count in words: "1 side", "2 sides".
pub(crate) fn counted(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}

/// Other faults in words, after the first: a few, without what to do about them.
pub(crate) fn also<'a>(messages: impl ExactSizeIterator<Item = &'a str>) -> String {
    /// The most that are told.
    const SHOWN: usize = 4;
    let more = messages.len().saturating_sub(SHOWN);
    let mut text: String = messages
        .take(SHOWN)
        .map(|message| format!("; also, {}", message.split("; ").next().unwrap_or(message)))
        .collect();
    if more > 0 {
        text += &format!("; and {more} more");
    }
    text
}
