//! Where the boundary points of a convex domain lie, and how good a mesh on them is.

mod spacing;
mod spacing_law;

pub use spacing::{LEAST_SHARE, Spacing, SpacingError};
pub use spacing_law::SpacingLaw;
