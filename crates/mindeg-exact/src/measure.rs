//! The two measures of a triangle that the solver compares: minimum angle and shape.
//!
//! Both use `+ - * /` alone, so they are the same on every machine, and both are rounded to
//! 36 bits. Rounding is part of the definition: on a symmetric domain, triangles that are each
//! other's mirror images should be equally good, and the last bits of a coordinate would
//! otherwise decide between them at random.
//!
//! Limits: rounding does not help if coordinates are large against the edges. In survey coordinates
//! of a few million, mirror images differ in the ninth digit already; if ties matter, triangulate
//! relative to a nearby origin.

use glam::DVec2;

/// The [`shape`] of an equilateral triangle, 2^36.
pub const SHAPE_UNIT: u64 = 1 << 36;

/// The tangent of the minimum angle of a counter-clockwise triangle, to 36 significant bits: 0 to
/// √3.
///
/// The tangent grows with the angle, so it orders triangles as their minimum angles do. With
/// squared edge lengths x <= y <= z and area A it is 4A/(y+z-x). It is 0 if the triangle is
/// clockwise or flat in f64, or too large or too small for it.
///
/// ```
/// use glam::DVec2;
/// use mindeg_exact::measure;
///
/// let half_square = [DVec2::ZERO, DVec2::X, DVec2::Y];
/// assert_eq!(measure::min_angle_tangent(half_square), 1.0);
/// let [a, b, c] = half_square;
/// assert_eq!(measure::min_angle_tangent([a, c, b]), 0.0);
/// ```
#[must_use]
pub fn min_angle_tangent(triangle: [DVec2; 3]) -> f64 {
    let [a, b, c] = from_the_first(triangle);
    let squares = [(b - a).length_squared(), (c - b).length_squared(), (a - c).length_squared()];
    tangent_of((b - a).perp_dot(c - a), squares)
}

/// The tangent of the minimum angle, to 36 bits, from twice the area and the squares of the edges.
pub(crate) fn tangent_of(double_area: f64, [x, y, z]: [f64; 3]) -> f64 {
    const ROUNDED_OFF: u32 = f64::MANTISSA_DIGITS - 36;
    let tangent = 2.0 * double_area / (x + y + z - 2.0 * x.min(y).min(z));
    if tangent > 0.0 {
        let half = 1 << (ROUNDED_OFF - 1);
        f64::from_bits((tangent.to_bits() + half) >> ROUNDED_OFF << ROUNDED_OFF)
    } else {
        0.0
    }
}

/// The least [`min_angle_tangent`] of some triangles; infinite without any.
#[must_use]
pub fn least_tangent(points: &[DVec2], triangles: &[[u32; 3]]) -> f64 {
    let tangent = |triangle: &[u32; 3]| min_angle_tangent(triangle.map(|v| points[v as usize]));
    triangles.iter().map(tangent).fold(f64::INFINITY, f64::min)
}

/// Verdict's `shape` of a counter-clockwise triangle, 4√3 A/(x²+y²+z²), in units of 2^-36:
/// from 0 to [`SHAPE_UNIT`], which is equilateral.
///
/// Whole units make the sum over a mesh the same in whatever order it is taken.
///
/// ```
/// use glam::DVec2;
/// use mindeg_exact::measure;
///
/// let half_square = [DVec2::ZERO, DVec2::X, DVec2::Y];
/// let shape = measure::shape(half_square) as f64 / measure::SHAPE_UNIT as f64;
/// assert!((shape - 0.75_f64.sqrt()).abs() < 1e-10);
/// ```
#[must_use]
pub fn shape(triangle: [DVec2; 3]) -> u64 {
    let [a, b, c] = from_the_first(triangle);
    let squares = (b - a).length_squared() + (c - b).length_squared() + (a - c).length_squared();
    let shape = 12.0_f64.sqrt() * (b - a).perp_dot(c - a) / squares;
    if shape > 0.0 { (shape.min(1.0) * SHAPE_UNIT as f64 + 0.5) as u64 } else { 0 }
}

/// The triangle from its first point in the order of x, then y. The same triangle must always have
/// the same value, and rounding depends on the point that differences start from.
fn from_the_first([a, b, c]: [DVec2; 3]) -> [DVec2; 3] {
    let is_before = |p: DVec2, q: DVec2| p.x < q.x || (p.x == q.x && p.y < q.y);
    if is_before(b, a) && is_before(b, c) {
        [b, c, a]
    } else if is_before(c, a) && is_before(c, b) {
        [c, a, b]
    } else {
        [a, b, c]
    }
}

/// The angle in degrees that has this tangent.
pub(crate) fn degrees(tangent: f64) -> f64 {
    libm::atan(tangent).to_degrees()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const ORIGIN: DVec2 = DVec2::ZERO;

    /// The triangle over an edge of length 1 with these angles at its ends, in degrees.
    fn with_angles(left: f64, right: f64) -> [DVec2; 3] {
        let [left, right] = [left, right].map(f64::to_radians);
        let reach = right.sin() / (left + right).sin();
        [ORIGIN, DVec2::X, DVec2::from_angle(left) * reach]
    }

    #[test]
    fn measures_the_minimum_angle_at_any_corner() {
        for (left, right, minimum) in [
            (60.0, 60.0, 60.0),
            (45.0, 90.0, 45.0),
            (90.0, 30.0, 30.0),
            (10.0, 160.0, 10.0),
            (120.0, 59.0, 1.0),
            (0.001, 90.0, 0.001),
        ] {
            let [a, b, c] = with_angles(left, right);
            for triangle in [[a, b, c], [b, c, a], [c, a, b]] {
                let tangent = min_angle_tangent(triangle);
                assert!((degrees(tangent) / minimum - 1.0).abs() < 1e-10, "{left}, {right}");
            }
            assert_eq!(min_angle_tangent([a, c, b]), 0.0);
            assert_eq!(shape([a, c, b]), 0);
        }
    }

    #[test]
    fn mirror_images_measure_the_same() {
        for (left, right) in [(61.0, 47.0), (13.7, 90.1), (100.0, 3.0), (59.9, 60.2)] {
            // Far enough from the origin for rounding to differ.
            let [a, b, c] = with_angles(left, right).map(|point| point + DVec2::new(0.1, 0.7));
            let [e, d, f] = [a, b, c].map(|point| DVec2::new(7.3 - point.x, point.y));
            assert_eq!(min_angle_tangent([a, b, c]), min_angle_tangent([d, e, f]));
            assert_eq!(shape([a, b, c]), shape([d, e, f]));
        }
    }

    #[test]
    fn shape_is_verdicts() {
        // 4√3 A/(x²+y²+z²) for legs of 3 and 4: √3 24/50.
        let triangle = [ORIGIN, DVec2::X * 3.0, DVec2::Y * 4.0];
        let expected = 3.0_f64.sqrt() * 24.0 / 50.0;
        assert!((shape(triangle) as f64 / SHAPE_UNIT as f64 - expected).abs() < 1e-10);
        assert_eq!(shape(with_angles(60.0, 60.0)), SHAPE_UNIT);
    }

    #[test]
    fn triangles_without_area_measure_0() {
        for (b, c) in [
            (DVec2::X, DVec2::X * 2.0),
            (ORIGIN, ORIGIN),
            (DVec2::X, DVec2::X),
            (DVec2::X * 1e200, DVec2::Y * 1e200),
            (DVec2::X * 1e-200, DVec2::Y * 1e-200),
        ] {
            assert_eq!(min_angle_tangent([ORIGIN, b, c]), 0.0, "{b} {c}");
            assert_eq!(shape([ORIGIN, b, c]), 0, "{b} {c}");
        }
    }

    proptest! {
        /// A chord was pruned where its triangle's value, taken from another corner, rounded down.
        #[test]
        fn values_do_not_depend_on_the_corner_a_triangle_starts_from(
            points in prop::array::uniform6(-1e6..1e6_f64)
        ) {
            let [a, b, c] = [0, 2, 4].map(|i| DVec2::new(points[i], points[i + 1]));
            for turned in [[b, c, a], [c, a, b]] {
                prop_assert_eq!(
                    min_angle_tangent([a, b, c]).to_bits(),
                    min_angle_tangent(turned).to_bits()
                );
                prop_assert_eq!(shape([a, b, c]), shape(turned));
            }
        }
    }
}
