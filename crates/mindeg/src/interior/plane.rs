//! The plane of a mesh, as coordinates in two dimensions and back.

use glam::{DVec2, DVec3};

/// A plane with its front, on which triangles are counter-clockwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Plane {
    origin: DVec3,
    u: DVec3,
    v: DVec3,
}

impl Plane {
    /// The plane through `origin` with this normal. Across an axis, coordinates go over exactly.
    pub(super) fn new(origin: DVec3, normal: DVec3) -> Self {
        let [x, y, z] = normal.to_array();
        let is_zero = |a: f64, b: f64| a == 0.0 && b == 0.0;
        let axes = if is_zero(x, y) {
            Some(if z > 0.0 { [DVec3::X, DVec3::Y] } else { [DVec3::Y, DVec3::X] })
        } else if is_zero(y, z) {
            Some(if x > 0.0 { [DVec3::Y, DVec3::Z] } else { [DVec3::Z, DVec3::Y] })
        } else if is_zero(z, x) {
            Some(if y > 0.0 { [DVec3::Z, DVec3::X] } else { [DVec3::X, DVec3::Z] })
        } else {
            None
        };
        if let Some([u, v]) = axes {
            // Only the coordinate across the plane is left in the origin.
            let across = normal.abs() / normal.abs().max_element();
            return Self { origin: origin * across, u, v };
        }
        let normal = normal.normalize_or_zero();
        let u = normal.any_orthonormal_vector();
        Self { origin, u, v: normal.cross(u) }
    }

    pub(super) fn project(&self, point: DVec3) -> DVec2 {
        let from = point - self.origin;
        DVec2::new(from.dot(self.u), from.dot(self.v))
    }

    pub(super) fn lift(&self, point: DVec2) -> DVec3 {
        self.origin + self.u * point.x + self.v * point.y
    }

    /// How far a point is from the plane.
    pub(super) fn distance(&self, point: DVec3) -> f64 {
        (point - self.origin).dot(self.u.cross(self.v)).abs()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn planes_across_an_axis_are_exact() {
        let point = DVec3::new(0.1, 0.7, 1e9 + 0.3);
        for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
            for normal in [axis * 7.0, axis * -0.3] {
                let plane = Plane::new(point, normal);
                assert_eq!(plane.distance(point), 0.0);
                assert_eq!(plane.lift(plane.project(point)), point);
                assert!(plane.u.cross(plane.v).dot(normal) > 0.0);
            }
        }
    }

    #[test]
    fn other_planes_keep_lengths_and_the_front() {
        let normal = DVec3::new(1.0, -2.0, 0.5);
        let origin = DVec3::new(3.0, 1.0, 2.0);
        let plane = Plane::new(origin, normal);
        let [a, b] = [DVec2::new(1.0, 2.0), DVec2::new(-3.0, 0.5)];
        let lengths = [a.distance(b), plane.lift(a).distance(plane.lift(b))];
        assert!((lengths[0] - lengths[1]).abs() < 1e-14);
        assert!((plane.project(plane.lift(a)) - a).length() < 1e-14);
        assert!(plane.distance(plane.lift(b)) < 1e-14);
        let turn = (plane.lift(a) - origin).cross(plane.lift(b) - origin).dot(normal);
        assert!(turn * a.perp_dot(b) > 0.0);
    }
}
