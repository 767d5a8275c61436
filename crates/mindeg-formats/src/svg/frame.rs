//! Where a mesh lies in a picture.

use super::style::{BOTTOM, MAX_HEIGHT, MAX_SLENDERNESS, SIDE_MARGIN, TOP, WIDTH};
use glam::DVec2;
use mindeg_mesh::Bounds;

/// How points of the mesh become points of the picture, whose y runs downwards.
pub(super) struct Frame {
    /// Pixels to a unit of length in x and in y.
    scale: DVec2,
    /// The upper left corner of the mesh's box, in the mesh and in the picture.
    from: DVec2,
    to: DVec2,
    /// The size of the mesh's box in the picture.
    pub(super) size: DVec2,
}

impl Frame {
    /// The place of the mesh in a picture of its own.
    pub(super) fn of_picture(bounds: Bounds) -> Self {
        let min = DVec2::new(SIDE_MARGIN, TOP);
        Self::new(bounds, Bounds { min, max: DVec2::new(WIDTH - SIDE_MARGIN, TOP + MAX_HEIGHT) })
    }

    pub(super) fn new(bounds: Bounds, room: Bounds) -> Self {
        // A single point, or a size that numbers cannot hold, is drawn as of size 1.
        let mut length = bounds.size();
        if !(1e-300..=1e300).contains(&length.max_element()) {
            length = DVec2::ONE;
        }
        let thinnest = length.max_element() / MAX_SLENDERNESS;
        let drawn = length.max(DVec2::splat(thinnest));
        let size = drawn * (room.size() / drawn).min_element();
        let scale = (size / length).map(|scale| if scale.is_finite() { scale } else { 1.0 });
        let to = DVec2::new(room.center().x - size.x / 2.0, room.min.y);
        Self { scale, from: DVec2::new(bounds.min.x, bounds.max.y), to, size }
    }

    pub(super) fn place(&self, point: DVec2) -> DVec2 {
        self.to + (point - self.from) * self.scale * DVec2::new(1.0, -1.0)
    }

    /// How the picture distorts the mesh, if it does.
    pub(super) fn stretch(&self) -> Option<String> {
        let DVec2 { x, y } = self.scale;
        let (what, factor) = if x > y { ("width", x / y) } else { ("height", y / x) };
        (factor > 1.0 + 1e-6)
            .then(|| format!("{what} drawn {} times too large", (factor * 10.0).round() / 10.0))
    }

    pub(super) fn height(&self) -> f64 {
        TOP + self.size.y + BOTTOM
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_box_has_a_place() {
        let room = Bounds { min: DVec2::ZERO, max: DVec2::new(100.0, 80.0) };
        for size in [
            [0.0, 0.0],
            [0.0, 2.0],
            [2.0, 0.0],
            [5e-324, 5e-324],
            [5e-324, 1.0],
            [1e308, 1.0],
            [f64::MAX, f64::MAX],
        ] {
            let max = DVec2::from(size);
            // The second box is too wide for a difference.
            for min in [DVec2::ZERO, -max] {
                let frame = Frame::new(Bounds { min, max }, room);
                assert!(frame.size.is_finite() && frame.size.max_element() > 0.0, "{size:?}");
                let at = frame.place(min.midpoint(max));
                assert!(!at.is_nan(), "{size:?}: {at}");
            }
        }
    }
}
