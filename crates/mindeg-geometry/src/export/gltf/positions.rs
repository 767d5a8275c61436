//! Positions as glTF stores them: 32-bit floats, near the origin.

use crate::export::{ExportError, Plane};
use crate::{Bounds, Mesh};
use glam::{DVec2, Vec3};

/// A coordinate range is far from the origin when it begins this many of its own lengths
/// away, or more: then 32-bit floats near the origin keep at least three bits more of it.
const FAR: f64 = 8.0;

/// How the points of a mesh become positions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Positions {
    /// What is taken off every point: a point of 32-bit floats, so that a reader that adds
    /// it again adds what was taken off.
    offset: DVec2,
    plane: Plane,
}

/// The least and the greatest of each coordinate, of positions as stored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Extent {
    pub(super) min: Vec3,
    pub(super) max: Vec3,
}

impl Positions {
    pub(super) fn new(bounds: Bounds, plane: Plane) -> Self {
        let offset = |min: f64, max: f64| {
            let length = max - min;
            let distance = f64::max(min, -max);
            // Written so that a length that overflows counts as near.
            let center = min + 0.5 * length;
            if distance >= FAR * length { f64::from(center as f32) } else { 0.0 }
        };
        let Bounds { min, max } = bounds;
        Self { offset: DVec2::new(offset(min.x, max.x), offset(min.y, max.y)), plane }
    }

    /// The position of a point, relative to the [`translation`](Self::translation).
    pub(super) fn of(&self, point: DVec2) -> Vec3 {
        // Rounding can make a zero negative; adding zero undoes it.
        self.plane.place(point - self.offset).as_vec3() + Vec3::ZERO
    }

    /// What moves the positions back to the points; nothing where they are near the origin.
    pub(super) fn translation(&self) -> Option<[f32; 3]> {
        let moved = self.offset != DVec2::ZERO;
        moved.then(|| self.plane.place(self.offset).as_vec3().to_array())
    }

    /// Looks at every position once, in O(n) time and O(1) memory.
    ///
    /// Refuses a coordinate beyond the range of 32-bit floats, and a vertex in the same
    /// place as one of the two before it round the boundary. Two steps back suffice for
    /// uniform spacing: where neighbors differ, points meet across a sharp corner at most,
    /// and the first pair there is the closest.
    pub(super) fn survey(&self, mesh: &Mesh) -> Result<Extent, ExportError> {
        let n = mesh.vertex_count();
        let mut before = [n - 2, n - 1].map(|v| (v, self.of(mesh.point(v))));
        let mut extent = Extent { min: Vec3::INFINITY, max: Vec3::NEG_INFINITY };
        for (vertex, point) in (0..).zip(mesh.points()) {
            let position = self.of(point);
            if !position.is_finite() {
                return Err(ExportError::OutOfRange { vertex, point });
            }
            if let Some((other, _)) = before.iter().find(|(_, other)| *other == position) {
                let vertices = [*other, vertex];
                return Err(ExportError::Coincident { vertices, point });
            }
            extent.min = extent.min.min(position);
            extent.max = extent.max.max(position);
            before = [before[1], (vertex, position)];
        }
        Ok(extent)
    }
}
