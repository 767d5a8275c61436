//! The smallest box around some points.

use glam::DVec2;

/// The smallest box around a set of points with sides parallel to the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The least coordinates.
    pub min: DVec2,
    /// The greatest coordinates.
    pub max: DVec2,
}

impl Bounds {
    /// Width and height of the box.
    #[must_use]
    pub fn size(&self) -> DVec2 {
        self.max - self.min
    }

    /// The middle of the box.
    #[must_use]
    pub fn center(&self) -> DVec2 {
        self.min + self.size() / 2.0
    }
}
