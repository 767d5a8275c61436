//! What to mesh: a convex outline, how its sides are divided, and what limits its degrees.
//!
//! ```
//! use mindeg_domain::{Domain, Side};
//!
//! let domain = Domain::rectangle(4.0, 3.0, [12, 9, 4, 4].map(Side::count).to_vec())?;
//! assert_eq!(domain.boundary().vertex_count(), 29);
//! assert_eq!(domain.placement().point(12).to_array(), [4.0, 0.0]);
//! # Ok::<(), mindeg_domain::DomainError>(())
//! ```
//!
//! Vertices and sides are numbered as in `mindeg-core`: from 0, counter-clockwise, vertex 0
//! at the first corner. y points up. Points are formulas, so nothing here grows with the number of
//! vertices unless a function says so. Everything is f64; transcendental functions come from
//! `libm`, so the same input gives the same bits on every machine.
//!
//! Without the feature `json`, which is on by default, `Domain::from_json` is left out, and serde
//! with it.
//!
//! # Limits
//!
//! Convex outlines with straight sides, in the plane.

mod constraints;
mod domain;
mod domain_error;
mod interior;
#[cfg(feature = "json")]
mod json;
mod limits;
mod name;
mod outline;
mod placement;
mod rectangle;
mod side;
mod spacing;
mod spacing_law;

pub use constraints::{
    ConstraintError, ConstraintPlace, Constraints, ExternalDegree, SideConstraint, VertexConstraint,
};
pub use domain::Domain;
pub use domain_error::DomainError;
pub use interior::{FixedLines, Interior, LineEnd, Prefer, SizeAt};
#[cfg(feature = "json")]
pub use json::DomainJsonError;
pub use limits::{GREATEST_COORDINATE, GREATEST_EXTERNAL_DEGREE, LEAST_SHARE, LEAST_SIDE};
pub use name::NameError;
pub use outline::{Outline, OutlineError};
pub use placement::{Placement, PlacementError, Walk};
pub use rectangle::{Rectangle, RectangleError};
pub use side::{Intervals, Side, SideError};
pub use spacing::{Spacing, SpacingError};
pub use spacing_law::SpacingLaw;
