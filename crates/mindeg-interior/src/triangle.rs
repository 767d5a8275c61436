//! Measures of one triangle.

use crate::space::Vector;
use glam::DVec2;
use std::f64::consts::PI;

/// Twice the area of the triangle of the sides `a` and `b`, positive counter-clockwise.
pub(crate) fn cross(a: DVec2, b: DVec2) -> f64 {
    a.perp_dot(b)
}

/// Twice the signed area.
pub(crate) fn doubled_area<V: Vector>([a, b, c]: [V; 3]) -> f64 {
    (b - a).doubled(c - a)
}

/// The longest edge, squared.
pub(crate) fn longest_squared<V: Vector>([a, b, c]: [V; 3]) -> f64 {
    a.distance_squared(b).max(b.distance_squared(c)).max(c.distance_squared(a))
}

/// The minimum angle in degrees: the angle opposite the shortest edge. 0 or below if inverted.
pub(crate) fn min_angle<V: Vector>([a, b, c]: [V; 3]) -> f64 {
    let (ab, bc, ca) = (a.distance_squared(b), b.distance_squared(c), c.distance_squared(a));
    let doubled = (b - a).doubled(c - a);
    // 2 u.v = |u|^2 + |v|^2 - |u - v|^2 would cancel; the dot product does not.
    let dot = if ab <= bc && ab <= ca {
        (a - c).dot(b - c)
    } else if bc <= ca {
        (b - a).dot(c - a)
    } else {
        (c - b).dot(a - b)
    };
    libm::atan2(doubled, dot) * (180.0 / PI)
}

/// The minimum angle of a counter-clockwise triangle of the plane in degrees; 0 of another one.
#[must_use]
pub fn least_angle(corners: [DVec2; 3]) -> f64 {
    min_angle(corners).max(0.0)
}

/// True if the minimum angle's sine is at least this, by the edges' lengths alone: no trigonometry.
pub(crate) fn has_sine<V: Vector>(corners @ [a, b, c]: [V; 3], sine: f64) -> bool {
    let squares = [a.distance_squared(b), b.distance_squared(c), c.distance_squared(a)];
    let least = squares[0].min(squares[1]).min(squares[2]);
    let doubled = doubled_area(corners);
    // The minimum angle's sine is the doubled area over the product of the two longer edges.
    doubled > 0.0 && doubled * doubled * least >= sine * sine * squares[0] * squares[1] * squares[2]
}

/// The maximum angle in degrees: the angle opposite the longest edge.
pub(crate) fn max_angle<V: Vector>([a, b, c]: [V; 3]) -> f64 {
    let (ab, bc, ca) = (a.distance_squared(b), b.distance_squared(c), c.distance_squared(a));
    let doubled = (b - a).doubled(c - a);
    let dot = if ab >= bc && ab >= ca {
        (a - c).dot(b - c)
    } else if bc >= ca {
        (b - a).dot(c - a)
    } else {
        (c - b).dot(a - b)
    };
    libm::atan2(doubled, dot) * (180.0 / PI)
}

/// True if the triangle is counter-clockwise and not flat: three rounded points of one
/// straight side never pass.
pub(crate) fn is_proper<V: Vector>(corners: [V; 3]) -> bool {
    doubled_area(corners) > 2e-9 * longest_squared(corners)
}

/// How far a triangle is from equilateral: the sum of its squared edges over 4 sqrt(3) times its
/// area. 1 at best, infinite without area.
pub(crate) fn distortion<V: Vector>(corners @ [a, b, c]: [V; 3]) -> f64 {
    let doubled = doubled_area(corners);
    if doubled <= 0.0 {
        return f64::INFINITY;
    }
    let squares = a.distance_squared(b) + b.distance_squared(c) + c.distance_squared(a);
    squares / (2.0 * SQRT_3 * doubled)
}

/// The square root of 3.
pub(crate) const SQRT_3: f64 = 1.732_050_807_568_877_2;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn measures_of_known_triangles() {
        let corners = |c: [[f64; 2]; 3]| c.map(DVec2::from);
        let right = corners([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
        assert!((min_angle(right) - 45.0).abs() < 1e-12);
        assert!((max_angle(right) - 90.0).abs() < 1e-12);
        assert!(is_proper(right));
        let equilateral = corners([[0.0, 0.0], [2.0, 0.0], [1.0, SQRT_3]]);
        assert!((distortion(equilateral) - 1.0).abs() < 1e-12);
        assert!((min_angle(equilateral) - 60.0).abs() < 1e-12);
        // Far from the origin, from each corner: 30, 45 and 105 degrees.
        let mut scalene = corners([[7.0, 5.0], [8.0 + SQRT_3, 5.0], [8.0, 6.0]]);
        for _ in 0..3 {
            assert!((min_angle(scalene) - 30.0).abs() < 1e-12, "{scalene:?}");
            assert!((max_angle(scalene) - 105.0).abs() < 1e-12, "{scalene:?}");
            scalene.rotate_left(1);
        }
        let inverted = corners([[0.0, 0.0], [0.0, 1.0], [1.0, 0.0]]);
        assert!(min_angle(inverted) < 0.0);
        assert!(!is_proper(inverted));
        assert_eq!(distortion(inverted), f64::INFINITY);
        assert!(!is_proper(corners([[0.0, 0.0], [0.5, -1e-12], [1.0, 0.0]])));
    }
}
