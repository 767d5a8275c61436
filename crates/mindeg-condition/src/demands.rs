//! The demands on a boundary.

use crate::error::ConditionError;
use glam::DVec2;

/// The least growth: below it, edges beside one that was halved would have to be halved, too, and so on.
pub const LEAST_GROWTH: f64 = 0.35;

/// The growth at which a mesh reaches its limits nearly everywhere.
pub(crate) const GROWTH: f64 = 0.4;

/// An edge below this share of the size is short: shores may move apart by four times as much, so hardly any has to stay.
pub(crate) const SHORT: f64 = 1.0 / 16.0;

/// The changes that a vertex of a boundary may undergo.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Hold {
    /// Everything; on a straight side, all that leaves it straight.
    Free,
    /// It ends a straight side: dropped, it leaves the end to the next vertex of that side.
    End,
    /// It is not dropped, but cut off where it is too sharp: a corner where something else begins.
    Corner,
    /// Its point stays.
    Point,
    /// Its point stays, and its edge to the next vertex is not divided.
    Edge,
}

/// The wanted length of an edge at a place; infinite where none is wanted but that of the demands.
pub(crate) type SizeAtPlace<'a> = dyn Fn(DVec2) -> f64 + Sync + 'a;

/// The rules for the edges of a boundary, and points that no change takes to the other side of one.
pub(crate) struct Given<'a, H, D, S> {
    pub(crate) hold: H,
    pub(crate) has_domain: D,
    pub(crate) is_straight: S,
    pub(crate) size_at: &'a SizeAtPlace<'a>,
    pub(crate) marks: &'a [DVec2],
}

/// The demands on a boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundaryDemands {
    /// The minimum angle that the boundary shall allow, in degrees: above 0 and at most 40.
    pub angle: f64,
    /// How far the new boundary may be from the old one, and the old one from the new one; 0 moves nothing.
    pub within: f64,
    /// The wanted length of an edge: shorter ones are joined where `within` allows it, longer ones divided. None: neither, but
    /// for the angle.
    pub size: Option<f64>,
    /// No edge is longer than 4/3 of another and `growth` times their distance together, from [`LEAST_GROWTH`] on; 0 for no
    /// such rule. The limit of an angle is a bound, which a mesh reaches more surely where lengths change gradually.
    pub growth: f64,
    /// Holes of a smaller area are dropped.
    pub least_hole: f64,
    /// So many triangles meet at each vertex of a ring, 1 or 2, at least: with 2, a mesh may have a corner inside in each triangle.
    pub least_triangles: u32,
    /// Narrower arms of the domain and straits are closed, narrower tongues of what is outside cut off, if they are deeper than wide.
    /// `within` does not bound this. 0: none.
    pub narrowest: f64,
}

/// 25 degrees, lengths that change gradually, and nothing moved.
impl Default for BoundaryDemands {
    fn default() -> Self {
        let least_triangles = 1;
        let (within, least_hole, narrowest) = (0.0, 0.0, 0.0);
        let growth = GROWTH;
        Self { angle: 25.0, within, size: None, growth, least_hole, least_triangles, narrowest }
    }
}

impl BoundaryDemands {
    /// Edges of about one length; the boundary moves by an eighth of it at most, less than a mesh of that
    /// length shows.
    #[must_use]
    pub fn of_size(size: f64) -> Self {
        Self { size: Some(size), within: size / 8.0, ..Self::default() }
    }

    pub(crate) fn check(&self) -> Result<(), ConditionError> {
        let is_length = |length: f64| length.is_finite() && length >= 0.0;
        if !(self.angle > 0.0 && self.angle <= 40.0) {
            return Err(ConditionError::Demand(
                "the angle is to be above 0 and at most 40 degrees",
            ));
        }
        if !is_length(self.within) {
            return Err(ConditionError::Demand("the distance is to be 0 or more"));
        }
        if self.size.is_some_and(|size| !is_length(size) || size == 0.0) {
            return Err(ConditionError::Demand("the size is to be above 0"));
        }
        if !is_length(self.growth) || self.growth > 0.0 && self.growth < LEAST_GROWTH {
            return Err(ConditionError::Demand("the growth is to be 0, or 0.35 or more"));
        }
        if !is_length(self.least_hole) {
            return Err(ConditionError::Demand("the least area of a hole is to be 0 or more"));
        }
        if !(1..=2).contains(&self.least_triangles) {
            return Err(ConditionError::Demand("the least number of triangles is to be 1 or 2"));
        }
        if !is_length(self.narrowest) {
            return Err(ConditionError::Demand("the least width is to be 0 or more"));
        }
        Ok(())
    }
}
