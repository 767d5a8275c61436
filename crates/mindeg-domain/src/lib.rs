//! The input of a mesh: a polygon, with or without holes, the division of its sides, and limits on
//! its degrees.
//!
//! ```
//! use mindeg_domain::{Domain, Side};
//!
//! let domain = Domain::rectangle(4.0, 3.0, [12, 9, 4, 4].map(Side::count).to_vec())?;
//! assert_eq!(domain.rings().vertex_count(), 29);
//! assert_eq!(domain.placement().point(12).to_array(), [4.0, 0.0]);
//! # Ok::<(), mindeg_domain::DomainError>(())
//! ```
//!
//! Vertices and sides have indices from 0, ring after ring, with the domain on the left: the outer ring
//! counter-clockwise, vertex 0 at its first corner, and then each hole clockwise. y points up. The points of a convex
//! outline with straight sides are formulas, so nothing there grows with the number of vertices unless a function
//! says so; the points of any other domain are stored. Everything is f64; transcendental functions come from `libm`,
//! so the same input gives the same bits on every machine.
//!
//! Without the feature `json`, which is on by default, `Domain::from_json` and serde are left out.
//!
//! # Limits
//!
//! The plane. Rings may not touch, themselves or each other; lines may: a hole that touches is a region without triangles. Lines inside them meet rings and each other at vertices only.

mod build;
mod constraints;
mod curve;
mod depths;
mod divided;
mod domain;
mod error;
mod given;
mod inside;
mod interior;
mod intersection;
mod joined;
#[cfg(feature = "json")]
mod json;
mod limits;
mod map;
mod matching;
mod model;
mod name;
mod noding;
mod on_box;
mod open_water;
mod opening;
mod outline;
mod periodic;
mod placement;
mod projection;
mod rectangle;
mod rings;
mod side;
mod side_points;
mod sizes;
mod spacing;
mod spacing_law;
mod split;
mod turning;

pub use build::DomainBuilder;
pub use constraints::{Constraints, ExternalDegree, SideConstraint, VertexConstraint};
pub use curve::{Arc, Curve};
pub use depths::{DepthRules, Depths};
pub use domain::Domain;
pub use error::{DomainError, Place};
pub use inside::{InnerPoint, Inside, Region};
pub use interior::{Interior, Prefer};
#[cfg(feature = "json")]
pub use json::{DomainDescription, DomainJsonError, ModelDescription};
pub use limits::{
    EXACT_COORDINATES, GREATEST_COORDINATE, GREATEST_EXTERNAL_DEGREE, LEAST_SHARE, LEAST_SIDE,
    MAX_STORED_VERTICES,
};
pub use matching::{Move, SideMatch};
pub use mindeg_mesh::LineKind;
pub use mindeg_mesh::planar::InRing;
pub use model::{
    FaceGroup, FromMesh, Model, ModelEdge, ModelFace, ModelParts, ModelPlace, PLANAR_SHARE, Plane,
};
pub use open_water::{OpenWater, first_names};
pub use opening::Opening;
pub use outline::{Outline, Ring};
pub use periodic::{Periodic, PeriodicSide};
pub use placement::{Placement, Walk};
pub use projection::{GlobeRegion, Projection};
pub use rectangle::Rectangle;
pub use rings::Rings;
pub use side::{Intervals, Side};
pub use sizes::{Size, SizeAt, SizeBetween, SizeFile, SizeFrom};
pub use spacing::Spacing;
pub use spacing_law::SpacingLaw;
pub use turning::ConvexForm;
