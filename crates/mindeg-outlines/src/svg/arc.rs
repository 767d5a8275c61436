//! Elliptical arcs as SVG gives them: by their ends.

use std::f64::consts::{PI, TAU};

use glam::DVec2;

use super::super::curve::{EllipseArc, PieceCurve};

/// The radii, the rotation in degrees and the flags of an arc.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ends {
    pub(super) radii: DVec2,
    pub(super) rotation: f64,
    pub(super) is_large: bool,
    /// Whether angles increase, from x towards y.
    pub(super) sweeps: bool,
}

/// The arc between two points, by the appendix on implementation of SVG: radii that are too small
/// are scaled up, an arc without a radius is a line.
pub(super) fn between(start: DVec2, end: DVec2, ends: Ends) -> PieceCurve {
    let mut radii = ends.radii.abs();
    if radii.min_element() == 0.0 || start == end {
        return PieceCurve::Line;
    }
    let (sin, cos) = match ends.rotation.rem_euclid(360.0) {
        0.0 => (0.0, 1.0),
        _ => libm::sincos(ends.rotation.to_radians()),
    };
    // In the frame of the ellipse, scaled so that it is a circle of radius 1.
    let half = (start - end) / 2.0;
    let turned = DVec2::new(cos * half.x + sin * half.y, cos * half.y - sin * half.x);
    let mut unit = turned / radii;
    let size = unit.length();
    if size > 1.0 {
        radii *= size;
        unit /= size;
    }
    let height = (1.0 - unit.length_squared()).max(0.0).sqrt();
    let across = unit.perp().normalize_or_zero() * height;
    // Centers of both circles of radius 1 through the ends lie off the middle by `across`.
    let center = if ends.is_large == ends.sweeps { across } else { -across };
    let angle_of = |p: DVec2| libm::atan2(p.y, p.x);
    let from = angle_of(unit - center);
    let to = angle_of(-unit - center);
    let mut sweep = to - from;
    if ends.sweeps && sweep < 0.0 {
        sweep += TAU;
    } else if !ends.sweeps && sweep > 0.0 {
        sweep -= TAU;
    }
    // Half a circle, up to rounding: the flag for the longer way does not matter then.
    if height == 0.0 {
        sweep = if ends.sweeps { PI } else { -PI };
    }
    let axes = [DVec2::new(cos, sin) * radii.x, DVec2::new(-sin, cos) * radii.y];
    let middle = (start + end) / 2.0;
    let center = middle + axes[0] * center.x + axes[1] * center.y;
    PieceCurve::Arc(EllipseArc { center, axes, start: from, sweep })
}

#[cfg(test)]
mod tests {
    use super::super::super::curve::Segment;
    use super::*;

    #[test]
    fn arcs_run_from_end_to_end_the_way_of_their_flags() {
        for (radii, rotation) in [([2.0, 2.0], 0.0), ([3.0, 1.5], 30.0), ([0.1, 0.1], 0.0)] {
            for (is_large, sweeps) in [(false, false), (false, true), (true, false), (true, true)] {
                let (start, end) = (DVec2::new(1.0, 0.5), DVec2::new(2.0, 2.0));
                let ends = Ends { radii: radii.into(), rotation, is_large, sweeps };
                let curve = between(start, end, ends);
                let PieceCurve::Arc(arc) = curve else { panic!("{curve:?}") };
                assert!(arc.point(arc.start).distance(start) < 1e-14, "{ends:?}");
                assert!(arc.point(arc.start + arc.sweep).distance(end) < 1e-14, "{ends:?}");
                assert_eq!(arc.sweep > 0.0, sweeps);
                if radii[0] > 1.0 {
                    assert_eq!(arc.sweep.abs() > PI, is_large, "{ends:?}");
                } else {
                    assert_eq!(arc.sweep.abs(), PI);
                }
                let length = Segment { start, end, curve }.length();
                assert!(length > start.distance(end));
            }
        }
    }

    #[test]
    fn arcs_without_radius_or_extent_are_lines() {
        let ends =
            Ends { radii: DVec2::new(0.0, 1.0), rotation: 0.0, is_large: true, sweeps: true };
        assert_eq!(between(DVec2::ZERO, DVec2::X, ends), PieceCurve::Line);
        let ends = Ends { radii: DVec2::ONE, ..ends };
        assert_eq!(between(DVec2::X, DVec2::X, ends), PieceCurve::Line);
    }
}
