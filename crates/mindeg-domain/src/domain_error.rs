//! Why an outline and its sides are not a domain: one variant for each concept, which has the
//! reasons in full.

use crate::constraint_error::ConstraintError;
use crate::intersection::IntersectionError;
use crate::name::NameError;
use crate::outline::OutlineError;
use crate::placement_error::PlacementError;
use crate::rings::{InRing, RingsError, ring_name};
use crate::side::SideError;

/// Why outlines and their sides are not a domain. Sides and corners are counted in the order in
/// which they were given, also where a ring was turned.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DomainError {
    /// Corners that are not those of a ring.
    #[error(transparent)]
    Outline(#[from] OutlineError),
    /// Another number of sides than corners.
    #[error(
        "{sides} {} described and {} has {corners}; describe each side once",
        if *sides == 1 { "side is" } else { "sides are" }, ring_name(*ring)
    )]
    SideCount {
        /// The ring.
        ring: usize,
        /// The corners of the ring.
        corners: usize,
        /// The sides described.
        sides: usize,
    },
    /// Names that cannot be used.
    #[error(transparent)]
    Name(#[from] NameError),
    /// A side that cannot be divided.
    #[error("{}: {source}", side.side())]
    Side {
        /// The side.
        side: InRing,
        /// Why.
        source: SideError,
    },
    /// Interval counts that are those of no boundary.
    #[error(transparent)]
    Rings(#[from] RingsError),
    /// More boundary vertices than are wanted.
    #[error(
        "the boundary has {vertices} points; at most {max} are wanted here; use fewer intervals"
    )]
    TooManyVertices {
        /// The points.
        vertices: u32,
        /// What [`DomainBuilder::max_vertices`](crate::DomainBuilder::max_vertices) was given.
        max: u32,
    },
    /// Too many points to store, of a domain that is not convex with straight sides.
    #[error(
        "the boundary has {vertices} points; a domain that is not convex with straight sides takes at \
         most {max}; use fewer intervals"
    )]
    TooManyStored {
        /// The points.
        vertices: u32,
        /// [`MAX_STORED_VERTICES`](crate::MAX_STORED_VERTICES).
        max: u32,
    },
    /// Not enough memory for the points.
    #[error("not enough memory for a boundary of {vertices} points; use fewer intervals")]
    NoMemory {
        /// The points.
        vertices: u32,
    },
    /// Rings that cross, touch or do not nest.
    #[error(transparent)]
    Intersection(#[from] IntersectionError),
    /// Points that 64-bit floats cannot tell apart.
    #[error(transparent)]
    Placement(#[from] PlacementError),
    /// Constraints that do not fit the boundary.
    #[error(transparent)]
    Constraint(#[from] ConstraintError),
}
