//! The shape of a side between its corners: straight, an arc, a cubic Bézier or a polyline.
//!
//! A [`Curve`] is the user's input; a [`Path`] is that curve between two corners and has a point for
//! any share of the length. Arcs are closed forms, kurbo measures Béziers, and polylines are measured
//! edge by edge. kurbo is built without `std`, so that its functions are those of `libm` too.
//!
//! Limits: points of a Bézier are accurate to about 1e-11 of its length.

use std::f64::consts::{PI, TAU};

use glam::DVec2;
use kurbo::{CubicBez, ParamCurve, ParamCurveArclen, Point};
use mindeg_mesh::{number, place};

use crate::error::{DomainError, Place};
use crate::limits::{GREATEST_COORDINATE, LEAST_SIDE};

/// The shape of a side from its corner to the next.
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_domain::{Arc, Curve, Domain, Side};
///
/// // Half a disk: the arc from (1, 0) to (-1, 0) over the top, and the diameter.
/// let cap = Side::count(8).along(Curve::Arc(Arc::Through(DVec2::Y)));
/// let domain = Domain::polygon([[1.0, 0.0], [-1.0, 0.0]], vec![cap, Side::count(4)])?;
/// assert!(domain.placement().point(4).abs_diff_eq(DVec2::Y, 1e-15));
/// assert_eq!(domain.placement().side_length(0), std::f64::consts::PI);
/// # Ok::<(), mindeg_domain::DomainError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Curve {
    /// Straight.
    #[default]
    Line,
    /// Along a circle.
    Arc(Arc),
    /// Along a cubic Bézier curve with these two control points.
    Cubic([DVec2; 2]),
    /// Straight from point to point: these, and the corners at the ends.
    Polyline(Vec<DVec2>),
}

/// An arc of a circle from one corner to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Arc {
    /// Through this point.
    Through(DVec2),
    /// Around this point; all the way round if the side ends where it starts.
    Center {
        /// The center.
        center: DVec2,
        /// Whether the arc runs clockwise about the center.
        is_clockwise: bool,
    },
}

impl Curve {
    /// The same curve from its end to its start.
    pub(crate) fn reversed(self) -> Self {
        match self {
            Self::Arc(Arc::Center { center, is_clockwise }) => {
                Self::Arc(Arc::Center { center, is_clockwise: !is_clockwise })
            }
            Self::Cubic([first, second]) => Self::Cubic([second, first]),
            Self::Polyline(mut points) => {
                points.reverse();
                Self::Polyline(points)
            }
            Self::Line | Self::Arc(Arc::Through(_)) => self,
        }
    }

    /// The points given besides the corners.
    pub fn points(&self) -> &[DVec2] {
        match self {
            Self::Line => &[],
            Self::Arc(Arc::Through(point) | Arc::Center { center: point, .. }) => {
                std::slice::from_ref(point)
            }
            Self::Cubic(points) => points,
            Self::Polyline(points) => points,
        }
    }
}

/// A curve between two corners.
pub(crate) enum Path {
    Line { start: DVec2, end: DVec2 },
    Arc(ArcPath),
    Cubic(Pieces<CubicBez>),
    Polyline(Pieces<[DVec2; 2]>),
}

impl Path {
    pub(crate) fn new(curve: &Curve, start: DVec2, end: DVec2) -> Result<Self, DomainError> {
        let is_usable =
            |point: &&DVec2| point.abs().max_element() <= GREATEST_COORDINATE && !point.is_nan();
        if let Some(index) = curve.points().iter().position(|point| !is_usable(&point)) {
            let DVec2 { x, y } = curve.points()[index];
            return Err(Place::key("points").then(index).error(format!(
                "point {} of the curve is at ({x:?}, {y:?}); coordinates must be finite and at \
                     most {GREATEST_COORDINATE:e} in size",
                index + 1
            )));
        }
        // kurbo takes minutes to measure next to no length.
        let distance = |point: &DVec2| (point - start).abs().max_element();
        let size = curve.points().iter().chain([&end]).map(distance).fold(0.0, f64::max);
        if size < LEAST_SIDE {
            let message = if size == 0.0 {
                "the side has no length; move its points apart".to_owned()
            } else {
                format!(
                    "its points are {} apart at most; a side is at least {LEAST_SIDE:e} long: use another unit \
                     of length",
                    number(size)
                )
            };
            return Err(Place::key("points").error(message));
        }
        Ok(match curve {
            Curve::Line => Self::Line { start, end },
            Curve::Arc(arc) => Self::Arc(ArcPath::new(arc, start, end)?),
            Curve::Cubic([first, second]) => {
                let [p0, p1, p2, p3] = [start, *first, *second, end].map(|p| Point::new(p.x, p.y));
                Self::Cubic(cubic_pieces(CubicBez { p0, p1, p2, p3 }))
            }
            Curve::Polyline(points) => {
                let starts = [start].into_iter().chain(points.iter().copied());
                let ends = points.iter().copied().chain([end]);
                let edges = starts.zip(ends).map(|(start, end)| [start, end]);
                Self::Polyline(Pieces::new(edges, |[start, end]| start.distance(*end)))
            }
        })
    }

    pub(crate) fn length(&self) -> f64 {
        match self {
            Self::Line { start, end } => start.distance(*end),
            Self::Arc(arc) => arc.length(),
            Self::Cubic(pieces) => pieces.length(),
            Self::Polyline(edges) => edges.length(),
        }
    }

    /// The point at a share of the length, strictly between 0 and 1.
    pub(crate) fn point(&self, share: f64) -> DVec2 {
        match self {
            Self::Line { start, end } => *start + share * (*end - *start),
            Self::Arc(arc) => arc.point(share),
            Self::Cubic(pieces) => {
                let (piece, rest) = pieces.at(share);
                let parameter = piece.inv_arclen(rest, CUBIC_ACCURACY * pieces.length());
                let Point { x, y } = piece.eval(parameter);
                DVec2::new(x, y)
            }
            Self::Polyline(edges) => {
                let ([start, end], rest) = edges.at(share);
                *start + rest / start.distance(*end) * (*end - *start)
            }
        }
    }
}

/// An arc by the chord from its start to its end, or by its center where the chord says little.
pub(crate) struct ArcPath {
    start: DVec2,
    end: DVec2,
    /// In radians, above 0 counter-clockwise, up to a whole turn either way.
    angle: f64,
    /// The center, set only for arcs above half a turn.
    center: Option<DVec2>,
}

impl ArcPath {
    fn new(arc: &Arc, start: DVec2, end: DVec2) -> Result<Self, DomainError> {
        let error = |message| Err(Place::key("points").error(message));
        let (angle, center) = match *arc {
            Arc::Through(_) if start == end => {
                return error("the arc ends where it starts; give its \"center\"".to_owned());
            }
            Arc::Through(point) => {
                // The turn at any point of an arc is half of the arc's angle.
                let (before, after) = (point - start, end - point);
                let turn = libm::atan2(before.perp_dot(after), before.dot(after));
                if turn == 0.0 || turn.abs() == PI {
                    return error(format!(
                        "the arc goes through {}, which lies on the line through its corners; move that point off, or drop \
                         the arc",
                        place(point)
                    ));
                }
                let chord = end - start;
                let center = start.midpoint(end) + chord.perp() / (2.0 * libm::tan(turn));
                (2.0 * turn, center)
            }
            Arc::Center { center, is_clockwise } => {
                let (from, to) = (start - center, end - center);
                let radii = [from, to].map(DVec2::length);
                let is_same = (radii[0] - radii[1]).abs() <= 1e-9 * radii[0].max(radii[1]);
                if !is_same || radii[0] == 0.0 {
                    let [start, end] = radii;
                    return error(format!(
                        "the arc's center is {start:?} from the corner where the arc starts and \
                         {end:?} from the corner where it ends; move it to where both are equal"
                    ));
                }
                let turn = libm::atan2(from.perp_dot(to), from.dot(to));
                let angle = match (is_clockwise, turn) {
                    (false, turn) if turn <= 0.0 => turn + TAU,
                    (true, turn) if turn >= 0.0 => turn - TAU,
                    (_, turn) => turn,
                };
                (angle, center)
            }
        };
        let center = (angle.abs() > PI).then_some(center);
        Ok(Self { start, end, angle, center })
    }

    fn length(&self) -> f64 {
        match self.center {
            Some(center) => self.angle.abs() * center.distance(self.start),
            None => {
                let half = self.angle / 2.0;
                self.start.distance(self.end) * half / libm::sin(half)
            }
        }
    }

    fn point(&self, share: f64) -> DVec2 {
        let turned = |arm: DVec2, angle: f64| {
            let (sin, cos) = libm::sincos(angle);
            cos * arm + sin * arm.perp()
        };
        if let Some(center) = self.center {
            return center + turned(self.start - center, share * self.angle);
        }
        // From the start, the point is in the direction of the chord of its share of the angle.
        let half = self.angle / 2.0;
        let chord = (self.end - self.start) * (libm::sin(share * half) / libm::sin(half));
        self.start + turned(chord, (share - 1.0) * half)
    }
}

/// Consecutive pieces of a curve, with the length up to each.
pub(crate) struct Pieces<T> {
    pieces: Vec<T>,
    /// The length up to the end of each piece.
    ends: Vec<f64>,
}

impl<T> Pieces<T> {
    fn new(pieces: impl Iterator<Item = T>, length: impl Fn(&T) -> f64) -> Self {
        let pieces: Vec<T> = pieces.collect();
        let mut sum = 0.0;
        let ends = pieces.iter().map(|piece| {
            sum += length(piece);
            sum
        });
        Self { ends: ends.collect(), pieces }
    }

    fn length(&self) -> f64 {
        self.ends.last().copied().unwrap_or(0.0)
    }

    /// The piece at a share of the length, and the remaining length from its start. O(log k).
    fn at(&self, share: f64) -> (&T, f64) {
        let length = share * self.length();
        let last = self.pieces.len() - 1;
        let index = self.ends.partition_point(|&end| end < length).min(last);
        let start = index.checked_sub(1).map_or(0.0, |before| self.ends[before]);
        (&self.pieces[index], length - start)
    }
}

/// The accuracy of a Bézier's lengths, as a share of the whole length.
const CUBIC_ACCURACY: f64 = 1e-11;

/// A Bézier in pieces that are nearly straight, so that measuring them is fast.
fn cubic_pieces(cubic: CubicBez) -> Pieces<CubicBez> {
    const PIECES: u32 = 32;
    let at = |i: u32| f64::from(i) / f64::from(PIECES);
    let bound =
        cubic.p0.distance(cubic.p1) + cubic.p1.distance(cubic.p2) + cubic.p2.distance(cubic.p3);
    let pieces = (0..PIECES).map(|i| cubic.subsegment(at(i)..at(i + 1)));
    Pieces::new(pieces, |piece| piece.arclen(CUBIC_ACCURACY * bound))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn path(curve: &Curve, start: [f64; 2], end: [f64; 2]) -> Path {
        Path::new(curve, start.into(), end.into()).unwrap()
    }

    fn through(x: f64, y: f64) -> Curve {
        Curve::Arc(Arc::Through(DVec2::new(x, y)))
    }

    fn around(x: f64, y: f64, is_clockwise: bool) -> Curve {
        Curve::Arc(Arc::Center { center: DVec2::new(x, y), is_clockwise })
    }

    /// Points of an arc, by the angle from its center.
    #[test]
    fn arcs_follow_their_circles() {
        for (curve, start, end, radius, center, first, angle) in [
            (through(0.0, 1.0), 0.0, PI, 1.0, [0.0, 0.0], 0.0, PI),
            (through(0.0, -1.0), 0.0, PI, 1.0, [0.0, 0.0], 0.0, -PI),
            (around(0.0, 0.0, false), 0.3, 0.5, 1.0, [0.0, 0.0], 0.3, 0.2),
            (around(0.0, 0.0, true), 0.3, 0.5, 1.0, [0.0, 0.0], 0.3, 0.2 - TAU),
            (around(0.0, 0.0, false), 0.5, 0.3, 1.0, [0.0, 0.0], 0.5, TAU - 0.2),
            (around(0.0, 0.0, false), 0.0, 0.0, 1.0, [0.0, 0.0], 0.0, TAU),
            (around(0.0, 0.0, true), 0.0, 0.0, 1.0, [0.0, 0.0], 0.0, -TAU),
            (through(-1.0, 0.0), -0.1, 0.1, 1.0, [0.0, 0.0], -0.1, 0.2 - TAU),
        ] {
            let at =
                |angle: f64| DVec2::from(center) + radius * DVec2::new(angle.cos(), angle.sin());
            let path = Path::new(&curve, at(start), at(end)).unwrap();
            assert!((path.length() - radius * angle.abs()).abs() < 2e-13, "{curve:?}");
            for share in [1e-9, 0.1, 0.5, 0.75, 1.0 - 1e-9] {
                let (found, expected) = (path.point(share), at(first + share * angle));
                assert!(found.distance(expected) < 2e-13, "{curve:?} {share}: {found}");
            }
        }
    }

    #[test]
    fn a_flat_arc_keeps_its_precision() {
        let curve = through(0.5, 1e-9);
        let path = path(&curve, [0.0, 0.0], [1.0, 0.0]);
        assert!((path.point(0.5).y - 1e-9).abs() < 1e-24);
        assert!((path.point(0.25).y - 0.75e-9).abs() < 1e-18);
    }

    #[test]
    fn polylines_and_beziers_are_divided_by_length() {
        let bent = Curve::Polyline([[3.0, 0.0], [3.0, 1.0]].map(DVec2::from).to_vec());
        let path_of_bent = path(&bent, [0.0, 0.0], [2.0, 1.0]);
        assert_eq!(path_of_bent.length(), 5.0);
        for (share, point) in
            [(0.2, [1.0, 0.0]), (0.6, [3.0, 0.0]), (0.7, [3.0, 0.5]), (0.9, [2.5, 1.0])]
        {
            assert!(path_of_bent.point(share).distance(point.into()) < 1e-15, "{share}");
        }

        // A straight Bézier, whose parameter is not its length.
        let straight = Curve::Cubic([[0.1, 0.0], [0.2, 0.0]].map(DVec2::from));
        let path_of_straight = path(&straight, [0.0, 0.0], [1.0, 0.0]);
        for share in [0.1, 0.25, 0.9] {
            assert!((path_of_straight.point(share).x - share).abs() < 1e-10, "{share}");
        }

        // Compares with sums of many chords.
        let wild = Curve::Cubic([[4.0, 1.0], [-3.0, 1.0]].map(DVec2::from));
        let path_of_wild = path(&wild, [0.0, 0.0], [1.0, 0.0]);
        let eval = |t: f64| {
            let s = 1.0 - t;
            3.0 * s * s * t * DVec2::new(4.0, 1.0)
                + 3.0 * s * t * t * DVec2::new(-3.0, 1.0)
                + t * t * t * DVec2::X
        };
        let mut sum = 0.0;
        let mut up_to = Vec::new();
        for i in 0..200_000_u32 {
            up_to.push(sum);
            let [a, b] = [i, i + 1].map(|i| eval(f64::from(i) / 200_000.0));
            sum += a.distance(b);
        }
        assert!(
            (path_of_wild.length() - sum).abs() < 1e-8 * sum,
            "{} {sum}",
            path_of_wild.length()
        );
        for share in [0.1, 0.37, 0.5, 0.93] {
            let i = up_to.partition_point(|&length| length < share * sum);
            let expected = eval(i as f64 / 200_000.0);
            assert!(path_of_wild.point(share).distance(expected) < 1e-4, "{share}");
        }
    }

    #[test]
    fn refuses_with_the_reason() {
        let message = |curve: Curve, start: [f64; 2], end: [f64; 2]| {
            Path::new(&curve, start.into(), end.into())
                .map(|path| path.length())
                .unwrap_err()
                .to_string()
        };
        let (zero, one) = ([0.0, 0.0], [1.0, 0.0]);
        #[rustfmt::skip]
        let table = [
            (message(through(0.5, 0.0), zero, one), "the arc goes through (0.5, 0), which lies on the line through its corners; move that point off, or drop the arc"),
            (message(through(2.0, 0.0), zero, one), "the arc goes through (2, 0), which lies on the line through its corners; move that point off, or drop the arc"),
            (message(through(2.0, 0.0), zero, zero), "the arc ends where it starts; give its \"center\""),
            (message(around(0.25, 0.0, false), zero, one), "the arc's center is 0.25 from the corner where the arc starts and 0.75 from the corner where it ends; move it to where both are equal"),
            (message(around(0.0, 0.0, false), zero, zero), "the side has no length; move its points apart"),
            (message(Curve::Cubic([DVec2::ZERO; 2]), zero, zero), "the side has no length; move its points apart"),
            (message(Curve::Polyline(vec![DVec2::ZERO]), zero, zero), "the side has no length; move its points apart"),
            (message(Curve::Polyline(vec![DVec2::ONE, DVec2::new(0.0, f64::NAN)]), zero, zero), "point 2 of the curve is at (0.0, NaN); coordinates must be finite and at most 1e100 in size"),
            (message(Curve::Cubic([DVec2::ONE, DVec2::new(2e100, 0.0)]), zero, zero), "point 2 of the curve is at (2e100, 0.0); coordinates must be finite and at most 1e100 in size"),
        ];
        for (found, expected) in table {
            assert_eq!(found, expected);
        }
    }

    /// Found by fuzzing: kurbo measured this for minutes.
    #[test]
    fn a_curve_shorter_than_the_shortest_side_is_refused() {
        let cubic = Curve::Cubic([DVec2::new(3.56e-307, 0.0), DVec2::ZERO]);
        let refused = Path::new(&cubic, DVec2::ZERO, DVec2::ZERO).err();
        assert_eq!(
            refused.unwrap().message,
            "its points are 3.56e-307 apart at most; a side is at least 1e-100 long: use another unit of length"
        );
    }
}
