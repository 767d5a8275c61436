//! Why an outline and its sides are not a domain: one variant for each concept, which has the
//! reasons in full.

use mindeg_core::BoundaryError;

use crate::constraints::ConstraintError;
use crate::name::NameError;
use crate::outline::OutlineError;
use crate::placement::PlacementError;
use crate::side::SideError;

/// Why an outline and its sides are not a domain. Sides and corners are counted from 0 here and
/// from 1 in messages, in the order in which they were given.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DomainError {
    /// Corners that are not those of a convex polygon.
    #[error(transparent)]
    Outline(#[from] OutlineError),
    /// Another number of sides than corners.
    #[error(
        "{sides} {} described and the outline has {corners}; describe each side once",
        if *sides == 1 { "side is" } else { "sides are" }
    )]
    SideCount {
        /// The corners of the outline.
        corners: usize,
        /// The sides described.
        sides: usize,
    },
    /// Names that cannot be used.
    #[error(transparent)]
    Name(#[from] NameError),
    /// A side that cannot be divided.
    #[error("side {}: {source}", side + 1)]
    Side {
        /// The side.
        side: usize,
        /// Why.
        source: SideError,
    },
    /// Interval counts that are no boundary.
    #[error(transparent)]
    Boundary(#[from] BoundaryError),
    /// Points that 64-bit floats cannot tell apart.
    #[error(transparent)]
    Placement(#[from] PlacementError),
    /// Constraints that do not fit the boundary.
    #[error(transparent)]
    Constraint(#[from] ConstraintError),
}
