//! A triangle surface as the reference of a remesher: what it keeps, how long its edges are, where it projects to.
//!
//! A [`Surface`] welds triangles, refuses what is no manifold with all places, finds features as curves between
//! corners, and divides the rest into patches. [`Surface::nearest`] finds the nearest point of a patch,
//! [`Surface::refined`] divides triangles and gives each vertex the edge length wanted there.
//!
//! ```
//! use glam::DVec3;
//! use mindeg_surfaces::{FeatureRules, Spot, Surface};
//!
//! // A square, folded along its diagonal: two patches, and the boundary in four curves that the fold joins.
//! let points = [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 1.0), DVec3::Y];
//! let surface = Surface::new(&points, &[[0, 1, 2], [0, 2, 3]], &[], &FeatureRules::default())?;
//! assert_eq!(surface.patch_count(), 2);
//! assert_eq!(surface.curves().len(), 5);
//! assert_eq!(surface.spot(2), Spot::Corner);
//! # Ok::<(), mindeg_surfaces::SurfaceError>(())
//! ```
//!
//! Limits: manifold surfaces whose triangles face the same way; a point where several fans meet becomes several
//! vertices.

mod curves;
mod fault;
mod features;
mod links;
mod nearest;
mod refine;
mod sizes;
mod surface;

pub use curves::{CurveSpan, FeatureCurve};
pub use fault::{SurfaceError, SurfaceFault};
pub use features::{FeatureRules, Given};
pub use nearest::Foot;
pub use sizes::SizeRules;
pub use surface::{Spot, Surface};

/// No triangle, no vertex.
pub const NONE: u32 = u32::MAX;
