//! What is wrong with a domain or a model, and in which of its parts.

use std::fmt;

use mindeg_mesh::planar::InRing;

/// What is wrong with the description of a domain or a model, and where.
///
/// Sides and corners are those of the description, also where a ring was turned.
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
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
#[non_exhaustive]
pub struct DomainError {
    /// The part that is wrong.
    pub place: Place,
    /// What is wrong with it and what to do.
    pub message: String,
    /// Whether points or edges meet that should be apart, which a repair of the rings may mend.
    pub is_touch: bool,
}

/// A part of a description, by the keys and indices from 0 that lead to it in JSON; the whole by none.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Place(pub(crate) Vec<Step>);

/// One step to a part.
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
    /// A part of this part.
    pub(crate) fn then(mut self, step: impl Into<Step>) -> Self {
        self.0.push(step.into());
        self
    }

    /// A key of the whole.
    pub(crate) fn key(key: &str) -> Self {
        Self::default().then(key)
    }

    /// A ring: the whole for the outer one.
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
}

impl DomainError {
    pub(crate) fn new(place: Place, message: impl Into<String>) -> Self {
        Self { place, message: message.into(), is_touch: false }
    }

    /// Points or edges that meet.
    pub(crate) fn touch(place: Place, message: impl Into<String>) -> Self {
        Self { is_touch: true, ..Self::new(place, message) }
    }

    /// What is wrong with a key of a side, which is to be told [of which](Self::within).
    pub(crate) fn key(key: &str, message: impl Into<String>) -> Self {
        Self::new(Place::key(key), message)
    }

    /// The same about a part of something larger.
    pub(crate) fn inside(mut self, mut whole: Place) -> Self {
        whole.0.append(&mut self.place.0);
        Self { place: whole, ..self }
    }

    /// The same about a part of something larger, which the message names first.
    pub(crate) fn within(self, whole: Place, name: &str) -> Self {
        let message = format!("{name}: {}", self.message);
        Self { message, ..self }.inside(whole)
    }

    pub(crate) fn of_side(self, side: InRing) -> Self {
        self.within(Place::side(side), &side.side())
    }
}

/// A number of things in words: "1 side", "2 sides".
pub(crate) fn counted(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}
