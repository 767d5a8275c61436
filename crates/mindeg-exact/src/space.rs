//! Triangles in space, measured in integers.
//!
//! Points are first scaled by a power of two to a box of edges below 1, which changes no digit.
//! Areas and shapes are then rounded to integers, so that sums over a mesh are the same in
//! whatever order they are taken, and "least" has one meaning on every machine.

use crate::measure::tangent_of;
use glam::DVec3;

/// The unit of area: 2^-50 of the square of the scaled box's unit.
const AREA_BITS: i32 = 50;

/// Of triangulations whose areas are equal but for rounding, the one of the better shapes is
/// wanted. So a triangle of shape s costs 1 - s of 2^-36 besides its area.
const SHAPE_BITS: i32 = 14;

/// A triangle is flat if its least height is below this share of its longest edge.
const FLAT: f64 = 1e-9;

/// The cost of a triangulation: flat triangles first, then area and shape.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Cost {
    pub(crate) flat: u32,
    /// In units of 2^-50 of the scaled box.
    pub(crate) area: u64,
}

impl Cost {
    pub(crate) const NONE: Self = Self { flat: 0, area: 0 };
    /// More than any triangulation costs.
    pub(crate) const INFINITE: Self = Self { flat: u32::MAX, area: u64::MAX };

    pub(crate) fn plus(self, other: Self) -> Self {
        Self { flat: self.flat + other.flat, area: self.area + other.area }
    }
}

/// The points in a box of edges below 1, scaled by a power of two.
pub(crate) fn scaled<'a>(points: impl Iterator<Item = &'a DVec3> + Clone) -> Vec<DVec3> {
    let [min, max] =
        points.clone().fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[min, max], &point| {
            [min.min(point), max.max(point)]
        });
    // Halves, since the difference of two large numbers may be infinite.
    let extent = (0.5 * max - 0.5 * min).max_element();
    let exponent = if extent > 0.0 { libm::frexp(extent).1 + 1 } else { 0 };
    // In two steps: one alone may be beyond the range of f64.
    let half = -exponent / 2;
    let steps = [half, -exponent - half].map(|step| libm::ldexp(1.0, step));
    points.map(|&point| point * steps[0] * steps[1]).collect()
}

/// The cost of a triangle of scaled points.
pub(crate) fn cost(a: DVec3, b: DVec3, c: DVec3) -> Cost {
    let (u, v) = (b - a, c - a);
    let squares = [u.length_squared(), v.length_squared(), (c - b).length_squared()];
    let longest = squares[0].max(squares[1]).max(squares[2]);
    let double = u.cross(v).length();
    let unit = (1_u64 << AREA_BITS) as f64;
    let area = (0.5 * double * unit + 0.5) as u64;
    if double.is_nan() || double <= FLAT * longest {
        return Cost { flat: 1, area };
    }
    let shape = 12.0_f64.sqrt() * double / (squares[0] + squares[1] + squares[2]);
    let penalty = (1.0 - shape).max(0.0) * (1_u64 << SHAPE_BITS) as f64;
    Cost { flat: 0, area: area + penalty as u64 }
}

/// The tangent of the minimum angle, to 36 bits; 0 for a flat triangle.
/// See [`measure::min_angle_tangent`](crate::measure::min_angle_tangent).
pub(crate) fn min_angle_tangent(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    let (u, v) = (b - a, c - a);
    let squares = [u.length_squared(), v.length_squared(), (c - b).length_squared()];
    tangent_of(u.cross(v).length(), squares)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_triangle_costs_its_area_and_little_for_its_shape() {
        let unit = 1_u64 << AREA_BITS;
        let cost_of = |x: f64, y: f64| cost(DVec3::ZERO, DVec3::X * x, DVec3::Y * y);
        let half = cost_of(1.0, 0.5);
        assert_eq!(half.flat, 0);
        assert!(half.area > unit / 4 && half.area < unit / 4 + (1 << SHAPE_BITS));
        assert_eq!(cost_of(1.0, 0.9e-9).flat, 1);
        assert_eq!(cost_of(1.0, 1.1e-9).flat, 0);
        assert_eq!(cost_of(0.0, 0.0), Cost { flat: 1, area: 0 });
        let better = cost(DVec3::ZERO, DVec3::X, DVec3::new(0.5, 0.5, 0.0));
        assert!(better < half && better.area >= unit / 4);
    }

    #[test]
    fn points_of_any_size_are_scaled_without_a_digit_lost() {
        for size in [1.0, 3e-300, 1.7e308, 5e-324, 0.0] {
            let points = [DVec3::ZERO, DVec3::X * size, DVec3::Y * -size];
            let scaled = scaled(points.iter());
            assert!(scaled.iter().all(|p| p.is_finite() && p.abs().max_element() <= 1.0), "{size}");
            if size > 1e-320 {
                let (fraction, _) = libm::frexp(size);
                assert_eq!(libm::frexp(scaled[1].x).0, fraction, "{size}");
                assert!(scaled[1].x >= 0.125, "{size}");
            }
        }
    }

    #[test]
    fn angles_are_those_of_the_plane() {
        let [a, b, c] = [[0.0, 0.0], [4.0, 0.0], [3.0, 2.0]].map(glam::DVec2::from);
        let in_plane = crate::measure::min_angle_tangent([a, b, c]);
        let lift = |p: glam::DVec2| DVec3::new(p.x, 0.0, p.y);
        assert_eq!(min_angle_tangent(lift(b), lift(a), lift(c)), in_plane);
        assert_eq!(mindeg_mesh::quality::area_in_space([a, b, c].map(lift)), 4.0);
    }
}
