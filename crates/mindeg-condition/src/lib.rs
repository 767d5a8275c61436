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
//! Lines inside are changed as rings are, each once for both sides; where they meet each other or rings, they stay.
//!
//! With a least width, narrower straits and arms of the domain are closed first, and narrower tongues of what is outside cut off.

mod chains;
mod changes;
mod demands;
mod dropping;
mod edges;
mod error;
mod grid;
mod inlets;
mod narrow;
mod opening;
mod past;
mod round;
mod rounds;
mod stars;
mod straight;
mod tents;
mod tips;

pub use changes::{
    BoundaryChange, ChangeKind, Conditioned, Left, Narrow, NarrowReason, Point, Reason, Why,
};
pub use demands::{BoundaryDemands, Hold, LEAST_GROWTH};
pub use error::ConditionError;

use crate::demands::Given;
use glam::DVec2;
use mindeg_mesh::planar::PlanarBoundary;

/// Changes a boundary by as little as it takes for the limit of its minimum angle to reach the demanded angle.
/// `hold` tells of each edge what may happen to it and to its first vertex. There is domain on both sides of every line.
///
/// First points are dropped, each where the boundary moves least, at vertices whose limit is too small (with a size,
/// wherever edges are shorter); then sharp corners are cut; then edges are divided. Dropping a point or cutting a
/// corner needs a triangle that no other point lies in, so nothing crosses, and points inside stay in their faces; the exact
/// sweep of [`PlanarBoundary::map`] checks the result. The same input gives the same result on every machine.
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
    let on_rings = boundary.vertex_count();
    condition_map(
        boundary,
        demands,
        hold,
        |edge| [true, edge >= on_rings],
        |_| false,
        &|_| f64::INFINITY,
        &[],
    )
}

/// [`condition`] where not all faces are meshed: `has_domain` tells of each edge whether one that is lies on its left, and on its
/// right; `is_straight` whether it is of a side that stays straight, such as those of a box. `size_at`
/// tells of a place how long an edge there should be at most, beside the size of the demands, or infinity. No change takes one of `marks` to the
/// other side of an edge.
///
/// # Errors
///
/// [`ConditionError`].
pub fn condition_map(
    boundary: &PlanarBoundary,
    demands: &BoundaryDemands,
    hold: impl Fn(u32) -> Hold,
    has_domain: impl Fn(u32) -> [bool; 2],
    is_straight: impl Fn(u32) -> bool,
    size_at: &(dyn Fn(DVec2) -> f64 + Sync),
    marks: &[DVec2],
) -> Result<Conditioned, ConditionError> {
    demands.check()?;
    let given = Given { hold, has_domain, is_straight, size_at, marks };
    if demands.narrowest == 0.0 {
        return Ok(round::of_wide(boundary, demands, &given, None)?.found);
    }
    rounds::of_narrow(boundary, demands, &given)
}
