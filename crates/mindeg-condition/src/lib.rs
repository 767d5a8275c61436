//! Conditioning of a boundary: the least change of its points that lets a mesh with points inside reach a given minimum angle.
//!
//! A mesh keeps its boundary bit for bit, so the boundary limits its angles
//! ([`mindeg_interior::limits`]): a short edge beside a long one, a sharp corner, two long edges in a strait. What can be
//! mended without moving the boundary is mended by points on its edges; what cannot, by dropping points and cutting
//! tips, nowhere farther than a given distance.
//!
//! ```
//! use glam::DVec2;
//! use mindeg_condition::{BoundaryDemands, Hold, condition};
//! use mindeg_mesh::planar::PlanarBoundary;
//!
//! // A square with a step of a hundredth in one side.
//! let ring = [[0.0, 0.0], [5.0, 0.0], [5.0, 0.01], [10.0, 0.01], [10.0, 10.0], [0.0, 10.0]];
//! let boundary = PlanarBoundary::new(&[ring.map(DVec2::from)])?;
//! let demands = BoundaryDemands { angle: 25.0, within: 0.02, ..BoundaryDemands::default() };
//! let conditioned = condition(&boundary, &demands, |_| Hold::Free)?;
//! assert!(conditioned.before < 10.0 && conditioned.after >= 25.0);
//! assert!(conditioned.moved <= 0.02 && conditioned.left.is_empty());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Limits: straits are neither closed nor opened, they get shorter edges; two rings are never joined.

mod changes;
mod demands;
mod edges;
mod error;
mod grid;
mod rings;
mod tips;

pub use changes::{BoundaryChange, ChangeKind, Left, Point, Reason};
pub use demands::{BoundaryDemands, Hold, LEAST_GROWTH};
pub use error::ConditionError;

use crate::rings::{MOST_EDGES, Rings};
use glam::DVec2;
use mindeg_interior::limits::{Limits, degree_limit, limits};
use mindeg_mesh::planar::PlanarBoundary;

/// A conditioned boundary.
#[derive(Debug, Clone, PartialEq)]
pub struct Conditioned {
    /// The new rings; the first is the outer one, as before.
    pub rings: Vec<Vec<Point>>,
    /// All changes, in the order in which they were made.
    pub changes: Vec<BoundaryChange>,
    /// The places that stay below the demanded angle.
    pub left: Vec<Left>,
    /// The limit of the old boundary, in degrees.
    pub before: f64,
    /// The limit of the new boundary, in degrees.
    pub after: f64,
    /// The greatest distance of a dropped point from the new boundary, which bounds the distance of both boundaries from each
    /// other.
    pub moved: f64,
}

/// Changes a boundary by as little as it takes for the limit of its minimum angle to reach the demanded angle.
/// `hold` tells of each vertex what may happen to it.
///
/// First points are dropped, each where the boundary moves least, at vertices whose limit is too small (with a size,
/// wherever edges are shorter); then sharp corners are cut; then edges are divided. Dropping a point or cutting a
/// corner needs a triangle that no other point lies in, so no ring crosses another; the exact sweep of
/// [`PlanarBoundary::new`] checks the result. The same input gives the same result on every machine.
///
/// O(n log n) for n points of the result where edges are short beside the domain.
///
/// # Errors
///
/// [`ConditionError`].
pub fn condition(
    boundary: &PlanarBoundary,
    demands: &BoundaryDemands,
    hold: impl Fn(u32) -> Hold,
) -> Result<Conditioned, ConditionError> {
    demands.check()?;
    let before = limit_of(boundary).angle();
    let mut rings = Rings::new(boundary, hold);
    rings.drop_holes(demands.least_hole);
    rings.simplify(demands);
    rings.cut_tips(demands);
    rings.divide(demands)?;
    let points = rings.points();
    let places: Vec<Vec<DVec2>> =
        points.iter().map(|ring| ring.iter().map(|point| point.at).collect()).collect();
    let new = PlanarBoundary::new(&places).map_err(ConditionError::Unsound)?;
    let after = limit_of(&new).angle();
    let left = rings.left(&new, demands);
    let moved = rings.moved();
    Ok(Conditioned { rings: points, changes: rings.changes, left, before, after, moved })
}

/// The limits of a boundary with the degrees that meshes with points inside keep.
fn limit_of(boundary: &PlanarBoundary) -> Limits {
    limits(boundary, |vertex| degree_limit(boundary.angle(vertex), MOST_EDGES))
}
