//! The pieces of a ring: where they run, how long they are, how far they turn.
//!
//! Lengths are sums of Gauss-Legendre quadratures over [`CELLS`] cells of a curve. The only
//! transcendental functions are `libm`'s, so points have the same bits on every machine.

use std::f64::consts::PI;

use glam::DVec2;

/// How a piece of a ring runs from its start to its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PieceCurve {
    /// Straight.
    Line,
    /// A cubic Bézier curve with these two control points.
    Cubic([DVec2; 2]),
    /// An elliptic arc.
    Arc(EllipseArc),
}

/// An elliptic arc: the points `center + axes[0] * cos(a) + axes[1] * sin(a)` for angles `a`
/// from `start` to `start + sweep`, in radians. The axes of a circle are as long as its radius and
/// perpendicular.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EllipseArc {
    /// The center.
    pub center: DVec2,
    /// Two conjugate half axes.
    pub axes: [DVec2; 2],
    /// The angle at the start.
    pub start: f64,
    /// The angle from the start to the end, negative for clockwise if the axes turn
    /// counter-clockwise.
    pub sweep: f64,
}

/// A piece of a ring with its ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// Where it starts.
    pub start: DVec2,
    /// Where it ends.
    pub end: DVec2,
    /// How it runs between.
    pub curve: PieceCurve,
}

/// The cells into which lengths along a curve are divided.
const CELLS: usize = 32;

/// By how much an interval of a curve turns at most, if no size is given: 15 degrees.
const TURN_OF_INTERVAL: f64 = PI / 12.0;

/// The nodes on [-1, 1] and the weights of Gauss-Legendre quadrature with five points.
const NODES: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
];

impl EllipseArc {
    /// The point at an angle.
    #[must_use]
    pub fn point(&self, angle: f64) -> DVec2 {
        let (sin, cos) = libm::sincos(angle);
        self.center + self.axes[0] * cos + self.axes[1] * sin
    }

    fn direction(&self, angle: f64) -> DVec2 {
        let (sin, cos) = libm::sincos(angle);
        self.axes[1] * cos - self.axes[0] * sin
    }
}

impl Segment {
    /// The point at a parameter from 0 to 1; the ends are exact.
    #[must_use]
    pub fn point(&self, t: f64) -> DVec2 {
        if t <= 0.0 {
            return self.start;
        }
        if t >= 1.0 {
            return self.end;
        }
        let s = 1.0 - t;
        match self.curve {
            PieceCurve::Line => self.start * s + self.end * t,
            PieceCurve::Cubic([a, b]) => {
                self.start * (s * s * s)
                    + a * (3.0 * s * s * t)
                    + b * (3.0 * s * t * t)
                    + self.end * (t * t * t)
            }
            PieceCurve::Arc(arc) => arc.point(arc.start + arc.sweep * t),
        }
    }

    /// How fast the point moves with the parameter.
    fn velocity(&self, t: f64) -> DVec2 {
        let s = 1.0 - t;
        match self.curve {
            PieceCurve::Line => self.end - self.start,
            PieceCurve::Cubic([a, b]) => {
                (a - self.start) * (3.0 * s * s)
                    + (b - a) * (6.0 * s * t)
                    + (self.end - b) * (3.0 * t * t)
            }
            PieceCurve::Arc(arc) => arc.direction(arc.start + arc.sweep * t) * arc.sweep,
        }
    }

    /// The direction at the start; zero if the piece is a point.
    #[must_use]
    pub fn direction_at_start(&self) -> DVec2 {
        match self.curve {
            // A control point on the end tells no direction; the next one does.
            PieceCurve::Cubic([a, b]) => first_difference(self.start, [a, b, self.end]),
            _ => self.velocity(0.0),
        }
    }

    /// The direction at the end; zero if the piece is a point.
    #[must_use]
    pub fn direction_at_end(&self) -> DVec2 {
        match self.curve {
            PieceCurve::Cubic([a, b]) => -first_difference(self.end, [b, a, self.start]),
            _ => self.velocity(1.0),
        }
    }

    /// The length.
    #[must_use]
    pub fn length(&self) -> f64 {
        match self.curve {
            PieceCurve::Line => norm(self.end - self.start),
            _ => self.lengths()[CELLS],
        }
    }

    /// The length from the start to the end of each cell.
    fn lengths(&self) -> [f64; CELLS + 1] {
        let mut lengths = [0.0; CELLS + 1];
        for cell in 0..CELLS {
            let ends = [cell, cell + 1].map(|end| end as f64 / CELLS as f64);
            lengths[cell + 1] = lengths[cell] + self.length_between(ends[0], ends[1]);
        }
        lengths
    }

    fn length_between(&self, from: f64, to: f64) -> f64 {
        let half = (to - from) / 2.0;
        let speed = |node: f64| norm(self.velocity(from + half * (1.0 + node)));
        half * NODES.iter().map(|&(node, weight)| weight * speed(node)).sum::<f64>()
    }

    /// The points at the given lengths from the start, which increase.
    #[must_use]
    pub fn points_at(&self, wanted: &[f64]) -> Vec<DVec2> {
        if self.curve == PieceCurve::Line {
            let length = self.length();
            return wanted.iter().map(|&wanted| self.point(wanted / length)).collect();
        }
        let lengths = self.lengths();
        let at = |&wanted: &f64| {
            let cell = lengths.partition_point(|&length| length <= wanted).clamp(1, CELLS) - 1;
            let start = cell as f64 / CELLS as f64;
            let (mut low, mut high) = (start, (cell + 1) as f64 / CELLS as f64);
            // Each step halves the cell: take as many steps as an f64 has bits.
            for _ in 0..53 {
                let middle = (low + high) / 2.0;
                if lengths[cell] + self.length_between(start, middle) < wanted {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            self.point((low + high) / 2.0)
        };
        wanted.iter().map(at).collect()
    }

    /// Into how many intervals the piece is divided if no size is given: each turns by at most
    /// 15 degrees, and a straight piece is one.
    #[must_use]
    pub fn intervals_by_turning(&self) -> u32 {
        if self.curve == PieceCurve::Line {
            return 1;
        }
        let directions = (0..=CELLS).map(|i| match i {
            0 => self.direction_at_start(),
            CELLS => self.direction_at_end(),
            _ => self.velocity(i as f64 / CELLS as f64),
        });
        let directions: Vec<DVec2> = directions.filter(|&it| it != DVec2::ZERO).collect();
        let turned: f64 = directions.windows(2).map(|pair| angle_between(pair[0], pair[1])).sum();
        // A little less, so that rounding does not make one more of a quarter of a circle.
        let count = libm::ceil(turned / TURN_OF_INTERVAL - 1e-6);
        if count >= 1.0 { count as u32 } else { 1 }
    }
}

/// From `from` to the first of the points that is another one.
fn first_difference(from: DVec2, points: [DVec2; 3]) -> DVec2 {
    points.into_iter().map(|point| point - from).find(|&it| it != DVec2::ZERO).unwrap_or_default()
}

/// The length of a vector, also where its square overflows or vanishes.
pub(super) fn norm(vector: DVec2) -> f64 {
    libm::hypot(vector.x, vector.y)
}

/// The angle by which one direction turns into another, from 0 to π.
pub(super) fn angle_between(from: DVec2, to: DVec2) -> f64 {
    // Their products neither overflow nor vanish.
    let [from, to] = [from, to].map(|it| it / it.abs().max_element());
    libm::atan2(from.perp_dot(to), from.dot(to)).abs()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, TAU};

    fn quarter() -> Segment {
        let arc = EllipseArc {
            center: DVec2::ZERO,
            axes: [DVec2::X * 2.0, DVec2::Y * 2.0],
            start: 0.0,
            sweep: FRAC_PI_2,
        };
        Segment { start: DVec2::X * 2.0, end: DVec2::Y * 2.0, curve: PieceCurve::Arc(arc) }
    }

    /// A cubic that runs along a line with uneven speed.
    fn straight_cubic() -> Segment {
        let curve = PieceCurve::Cubic([DVec2::new(0.0, 0.0), DVec2::new(1.0, 1.0)]);
        Segment { start: DVec2::ZERO, end: DVec2::new(3.0, 3.0), curve }
    }

    #[test]
    fn lengths_are_those_of_the_curves() {
        assert!((quarter().length() - PI).abs() < 1e-14);
        assert!((straight_cubic().length() - 18.0_f64.sqrt()).abs() < 1e-12);
        // A parabola y = x²/2 on [0, 1]: (√2 + asinh 1) / 2.
        let (a, b) = (DVec2::new(1.0 / 3.0, 0.0), DVec2::new(2.0 / 3.0, 1.0 / 6.0));
        let parabola = Segment {
            start: DVec2::ZERO,
            end: DVec2::new(1.0, 0.5),
            curve: PieceCurve::Cubic([a, b]),
        };
        let length = (2.0_f64.sqrt() + 1.0_f64.asinh()) / 2.0;
        assert!((parabola.length() - length).abs() < 1e-13, "{}", parabola.length());
    }

    #[test]
    fn the_points_of_a_cubic_are_those_of_bernstein() {
        let [start, a, b, end] =
            [[64.0, 0.0], [0.0, 64.0], [128.0, 0.0], [0.0, 192.0]].map(DVec2::from);
        let segment = Segment { start, end, curve: PieceCurve::Cubic([a, b]) };
        assert_eq!(
            [0.0, 0.25, 1.0].map(|t| segment.point(t)),
            [start, DVec2::new(45.0, 30.0), end]
        );
        // The first control point lies on the start and tells no direction.
        let segment = Segment { curve: PieceCurve::Cubic([start, b]), ..segment };
        assert!(segment.direction_at_start().perp_dot(b - start) == 0.0);
        assert!(segment.direction_at_start().dot(b - start) > 0.0);
    }

    #[test]
    fn points_lie_at_the_lengths_that_were_asked_for() {
        let points = quarter().points_at(&[PI / 3.0, PI * 2.0 / 3.0]);
        for (point, angle) in points.iter().zip([PI / 6.0, PI / 3.0]) {
            assert!(point.distance(DVec2::from_angle(angle) * 2.0) < 1e-14, "{point}");
        }
        let points = straight_cubic().points_at(&[18.0_f64.sqrt() / 3.0]);
        assert!(points[0].distance(DVec2::ONE) < 1e-9, "{points:?}");
        let line = Segment { start: DVec2::ZERO, end: DVec2::X * 8.0, curve: PieceCurve::Line };
        assert_eq!(line.points_at(&[2.0, 6.0]), [DVec2::X * 2.0, DVec2::X * 6.0]);
    }

    #[test]
    fn curves_take_an_interval_for_each_15_degrees() {
        assert_eq!(quarter().intervals_by_turning(), 6);
        assert_eq!(straight_cubic().intervals_by_turning(), 1);
        let PieceCurve::Arc(arc) = quarter().curve else { unreachable!() };
        let circle = PieceCurve::Arc(EllipseArc { sweep: TAU, ..arc });
        let circle = Segment { end: quarter().start, curve: circle, ..quarter() };
        assert_eq!(circle.intervals_by_turning(), 24);
        // All four points at one position.
        let point = Segment {
            start: DVec2::ONE,
            end: DVec2::ONE,
            curve: PieceCurve::Cubic([DVec2::ONE; 2]),
        };
        assert_eq!((point.intervals_by_turning(), point.length()), (1, 0.0));
        assert_eq!(point.direction_at_start(), DVec2::ZERO);
    }
}
