//! Why triangles are no surface: all faults, each with its place.

use glam::DVec3;

/// One place where triangles do not form a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceFault {
    /// A point of the place, in units of length; not finite where a coordinate is not.
    pub place: DVec3,
    /// The fault, with the triangles, counted from 0.
    pub what: String,
}

/// All faults of triangles that form no surface; at least one.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceError {
    /// The faults, in the order of their kinds and then of their triangles.
    pub faults: Vec<SurfaceFault>,
}

/// The faults that a message names; it counts the others.
const NAMED: usize = 5;

impl std::fmt::Display for SurfaceError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for (index, SurfaceFault { place, what }) in self.faults.iter().take(NAMED).enumerate() {
            let separator = if index > 0 { "; " } else { "" };
            write!(f, "{separator}{what}, at ({}, {}, {})", place.x, place.y, place.z)?;
        }
        match self.faults.len().saturating_sub(NAMED) {
            0 => Ok(()),
            more => write!(f, "; and {more} more"),
        }
    }
}

impl std::error::Error for SurfaceError {}
