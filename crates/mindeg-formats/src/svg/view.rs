//! From where a mesh in space is seen.

use crate::corners::{Corners, triangles};
use glam::{DVec2, DVec3};
use mindeg_mesh::{Bounds, Mesh};

/// Triangles asked for at a time.
const BLOCK: u32 = 1 << 12;

/// The axis that a picture drops. The first of those that stay points to the right, the other
/// upwards, so a picture is a mirror image of nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum View {
    X,
    Y,
    Z,
}

impl View {
    /// Along the axis that the triangles face most, weighted by area; along z among equals. O(n).
    pub(super) fn of(mesh: &dyn Mesh) -> Self {
        let Bounds { min, max } = mesh.bounds();
        if min.z == max.z {
            return Self::Z;
        }
        let mut corners = Corners::new(mesh);
        let mut facing = DVec3::ZERO;
        let count = mesh.triangle_count();
        for start in (0..count).step_by(BLOCK as usize) {
            for triangle in triangles(mesh, start..start.saturating_add(BLOCK).min(count)) {
                let [a, b, c] = corners.positions(triangle);
                facing += (b - a).cross(c - a).abs();
            }
        }
        let DVec3 { x, y, z } = facing;
        if z >= x && z >= y {
            Self::Z
        } else if y >= x {
            Self::Y
        } else {
            Self::X
        }
    }

    pub(super) fn of_point(self, point: DVec3) -> DVec2 {
        match self {
            Self::X => DVec2::new(point.y, point.z),
            Self::Y => DVec2::new(point.x, point.z),
            Self::Z => point.truncate(),
        }
    }

    /// How near to the eye a point is.
    pub(super) fn nearness(self, point: DVec3) -> f64 {
        match self {
            Self::X => point.x,
            // With x to the right and z upwards, y points away.
            Self::Y => -point.y,
            Self::Z => point.z,
        }
    }

    pub(super) fn of_box(self, bounds: Bounds<DVec3>) -> Bounds {
        Bounds { min: self.of_point(bounds.min), max: self.of_point(bounds.max) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mindeg_mesh::TriMesh;

    #[test]
    fn the_axis_that_triangles_face_is_dropped() {
        let wall = |points: [[f64; 3]; 3]| {
            let points = points.map(DVec3::from_array).to_vec();
            View::of(&TriMesh::new(points, vec![[0, 1, 2], [2, 1, 0]]).unwrap())
        };
        assert_eq!(wall([[0.0, 0.0, 0.0], [2.0, 0.0, 0.1], [0.0, 2.0, 0.0]]), View::Z);
        assert_eq!(wall([[0.0, 0.0, 0.0], [2.0, 0.1, 0.0], [0.0, 0.0, 2.0]]), View::Y);
        assert_eq!(wall([[0.0, 0.0, 0.0], [0.1, 2.0, 0.0], [0.0, 0.0, 2.0]]), View::X);
    }
}
