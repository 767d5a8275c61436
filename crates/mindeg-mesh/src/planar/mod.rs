//! The boundary of a domain of the plane, proven once: rings of points, straight runs, corners; lines and points
//! inside, and the faces between them.
//!
//! [`PlanarBoundary`] is the only type for points with rings. Its exact sweep is the only proof that
//! rings are simple, apart and nested, and that lines meet at vertices only; only [`turn`] decides whether a
//! boundary is straight at a point.

mod border;
mod boundary;
mod faults;
mod in_ring;
mod map;
mod meetings;
mod sweep;
mod turning;

use glam::DVec2;

pub use border::Border;
pub use boundary::{PlanarBoundary, doubled_area};
pub use faults::{BoundaryFault, BoundaryFaults, MOST_FAULTS};
pub use in_ring::{BoundaryPlace, InRing, ring_name};
pub use map::Faces;
pub use turning::{LEAST_TURN, Turn, passes, straight_runs, turn};

/// Positive if three points run counter-clockwise, 0 if they are on one line; the sign is exact.
#[inline]
pub fn orientation(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    // Not a map of an array, which is not inlined and takes as long as the predicate.
    let coord = |DVec2 { x, y }: DVec2| robust::Coord { x, y };
    robust::orient2d(coord(a), coord(b), coord(c))
}
