//! Two rings in one plane.

use glam::DVec3;
use robust::{Coord, orient2d};

/// How far from the plane a vertex may be, as a share of the rings' extent.
const TOLERANCE: f64 = 1e-9;

/// The projection of two rings in one plane along the axis that is nearest to its normal.
pub(super) struct Plane {
    /// The vertices of the x ring, then those of the y ring.
    points: Vec<Coord<f64>>,
    /// The sign of the strip's triangles.
    turn: f64,
    is_opposite: bool,
}

impl Plane {
    /// None if the rings do not lie in one plane.
    pub(super) fn of(x: &[DVec3], y: &[DVec3]) -> Option<Self> {
        let all = || x.iter().chain(y);
        let extent =
            all().fold(0.0_f64, |most, &point| most.max((point - x[0]).abs().max_element()));
        let scale = if extent > 0.0 && extent.is_finite() { extent } else { return None };
        let relative = |point: DVec3| (point - x[0]) / scale;
        let [own, others] = [x, y].map(|ring| newell(ring.iter().map(|&point| relative(point))));
        let outer = if own.length() >= others.length() { own } else { others };
        let normal = outer.try_normalize()?;
        if all().any(|&point| relative(point).dot(normal).abs() > TOLERANCE) {
            return None;
        }
        let size = normal.abs();
        let axes = if size.z >= size.x && size.z >= size.y {
            [0, 1]
        } else if size.x >= size.y {
            [1, 2]
        } else {
            [2, 0]
        };
        let points = all().map(|point| Coord { x: point[axes[0]], y: point[axes[1]] }).collect();
        // The third axis, along which the projection looks.
        let along = 3 - axes[0] - axes[1];
        let is_outer = own.length() >= others.length();
        // The triangles run forward along the x ring and backward along the y ring.
        let turn = if is_outer { own[along] } else { -others[along] };
        Some(Self { points, turn, is_opposite: own[along] * others[along] < 0.0 })
    }

    /// Whether the rings run round in opposite directions: then each strip folds.
    pub(super) fn is_opposite(&self) -> bool {
        self.is_opposite
    }

    /// Whether a triangle of the strip lies on the side on which all must lie, with an area. Exact.
    pub(super) fn is_unfolded(&self, triangle: [usize; 3]) -> bool {
        let [a, b, c] = triangle.map(|vertex| self.points[vertex]);
        let turn = orient2d(a, b, c);
        turn > 0.0 && self.turn > 0.0 || turn < 0.0 && self.turn < 0.0
    }
}

/// Twice the area vector of a ring.
fn newell(ring: impl Iterator<Item = DVec3> + Clone) -> DVec3 {
    let next = ring.clone().skip(1).chain(ring.clone().take(1));
    ring.zip(next).map(|(a, b)| a.cross(b)).sum()
}
