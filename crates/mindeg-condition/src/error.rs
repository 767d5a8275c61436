//! Refusals.

use mindeg_mesh::planar::BoundaryFaults;
use thiserror::Error;

/// Why a boundary is not conditioned.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ConditionError {
    /// A demand is out of its range.
    #[error("{0}")]
    Demand(&'static str),
    /// The new boundary crosses or touches itself, since rounding moved a new point.
    #[error(
        "the conditioned boundary is not sound: {0}; allow a smaller angle or a larger distance"
    )]
    Unsound(BoundaryFaults),
    /// The narrow places cannot be told.
    #[error("{0}; demand no least width")]
    Narrow(String),
    /// More points than a mesh can have.
    #[error(
        "the conditioned boundary has more than {0} points; demand a smaller angle or allow a larger distance"
    )]
    Points(usize),
}
