//! What to mesh: a convex outline, how its sides are divided, and what single vertices allow.
//!
//! ```
//! use mindeg_domain::Domain;
//!
//! let domain = Domain::from_json(
//!     r#"{"rectangle": {"width": 4, "height": 3}, "sides": [
//!         {"intervals": 12}, {"intervals": 9}, {"intervals": 4}, {"intervals": 4}]}"#,
//! )?;
//! assert_eq!(domain.boundary().vertex_count(), 29);
//! assert_eq!(domain.placement().point(12).to_array(), [4.0, 0.0]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Vertices and sides are numbered as in `mindeg-core`: from 0, counter-clockwise, vertex 0
//! at the first corner. y points up. Points are formulas, so nothing here grows with the number of
//! vertices unless a function says so. Everything is f64; transcendental functions come from
//! `libm`, so the same input gives the same bits on every machine.
//!
//! # Limits
//!
//! Convex outlines with straight sides, in the plane.

mod constraint;
mod domain;
mod domain_error;
mod domain_json;
mod domain_json_error;
mod json_path;
mod outline;
mod placement;
mod rectangle;
mod spacing;
mod spacing_law;

pub use constraint::{ConstraintPlace, GREATEST_OUTSIDE_DEGREE, OutsideDegree, VertexConstraint};
pub use domain::{Domain, GREATEST_COORDINATE, Intervals, LEAST_SIDE, Outline, Side};
pub use domain_error::DomainError;
pub use domain_json_error::DomainJsonError;
pub use placement::{Placement, Walk};
pub use rectangle::Rectangle;
pub use spacing::{LEAST_SHARE, Spacing, SpacingError};
pub use spacing_law::SpacingLaw;
