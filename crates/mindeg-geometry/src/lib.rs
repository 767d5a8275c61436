//! Where the boundary points of a convex domain lie, and how good a mesh on them is.

mod domain;
mod domain_error;
mod domain_json;
mod json_path;
mod mesh;
mod outline;
mod placement;
pub mod quality;
mod spacing;
mod spacing_law;
mod summary;

pub use domain::{Domain, GREATEST_COORDINATE, Intervals, LEAST_SIDE, Outline, Rectangle, Side};
pub use domain_error::DomainError;
pub use domain_json::DomainJsonError;
pub use mesh::{AngleRange, DegreeHistograms, Mesh, MeshError};
pub use placement::{Bounds, Placement};
pub use spacing::{LEAST_SHARE, Spacing, SpacingError};
pub use spacing_law::SpacingLaw;
