//! The shape of a domain: whether its corners are those of a strictly convex polygon, and which way
//! round they are given.
//!
//! Everything follows from the angle by which the outline turns at each corner. A closed outline
//! that always turns the same way, and once around in all, is a simple, strictly convex polygon;
//! a pentagram always turns the same way too, but goes around twice.
//!
//! Angles come from differences of coordinates, so that nothing is lost far from the origin but
//! what the coordinates themselves have lost. A corner is straight where it turns by less than
//! [`LEAST_TURN`], or by less than the rounding of its coordinates can make out of nothing.
//!
//! Limits: corners are judged one at a time, so of an outline with several faults the first is
//! reported.

use std::f64::consts::{PI, TAU};

use glam::DVec2;

use crate::limits::{GREATEST_COORDINATE, LEAST_ROUNDINGS, LEAST_SIDE, LEAST_TURN};
use crate::rectangle::{Rectangle, RectangleError};

/// The shape of a domain.
#[derive(Clone, Debug, PartialEq)]
pub enum Outline {
    /// A rectangle; its sides are bottom, right, top and left.
    Rectangle(Rectangle),
    /// The corners of a convex polygon; side `s` runs from corner `s` to the next.
    Polygon(Vec<DVec2>),
}

/// Why corners are not those of a convex polygon. Corners are counted from 0 here and from 1 in
/// messages.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OutlineError {
    /// Measures that are not those of a rectangle.
    #[error(transparent)]
    Rectangle(#[from] RectangleError),
    /// Fewer than three corners.
    #[error(
        "found {corners} {}; an outline needs at least 3",
        if *corners == 1 { "corner" } else { "corners" }
    )]
    TooFewCorners {
        /// The number of corners.
        corners: usize,
    },
    /// A coordinate that is not finite or greater than
    /// [`GREATEST_COORDINATE`](crate::GREATEST_COORDINATE).
    #[error(
        "corner {} is at ({x:?}, {y:?}); coordinates must be finite and at most \
         {GREATEST_COORDINATE:e} in size",
        corner + 1
    )]
    Coordinate {
        /// The corner.
        corner: usize,
        /// Its x coordinate.
        x: f64,
        /// Its y coordinate.
        y: f64,
    },
    /// Two neighbouring corners at the same point.
    #[error(
        "corners {} and {} are the same point ({x:?}, {y:?}); give each corner once (the outline \
         closes by itself)",
        first + 1, second + 1
    )]
    RepeatedCorner {
        /// The one.
        first: usize,
        /// The next.
        second: usize,
        /// The x coordinate.
        x: f64,
        /// The y coordinate.
        y: f64,
    },
    /// Two neighbouring corners that 64-bit floats hardly tell apart, or nearer than
    /// [`LEAST_SIDE`](crate::LEAST_SIDE).
    #[error(
        "corners {} and {} coincide: their distance is {distance:.1e}, and the minimum at these \
         coordinates is {least:.1e}; drop one of them",
        first + 1, second + 1
    )]
    CoincidentCorners {
        /// The one.
        first: usize,
        /// The next.
        second: usize,
        /// Their distance.
        distance: f64,
        /// The least distance that two corners with these coordinates must have.
        least: f64,
    },
    /// A corner that is straight or reflex, or where the outline folds back on itself.
    #[error("corner {} at ({x:?}, {y:?}) {}", corner + 1, describe_angle(*angle))]
    NotConvex {
        /// The corner.
        corner: usize,
        /// Its x coordinate.
        x: f64,
        /// Its y coordinate.
        y: f64,
        /// Its inside angle in degrees: 0 where the outline folds back, 180 where it is
        /// straight, to within 1e-9 radians; otherwise between 180 and 360.
        angle: f64,
    },
    /// All corners turn the same way, but more than once around.
    #[error(
        "the outline goes around {turns} times, so its sides cross; list the corners in the order \
         in which they lie around the domain"
    )]
    NotSimple {
        /// How many times.
        turns: u32,
    },
}

fn describe_angle(angle: f64) -> String {
    if angle == 0.0 {
        "folds back on itself (0°); every corner must turn the same way".to_owned()
    } else if angle == 180.0 {
        "is straight (180°); every corner must turn; drop this corner, so that its two sides \
         become one"
            .to_owned()
    } else {
        format!("is reflex ({angle:.6}°); every corner must turn the same way")
    }
}

impl Outline {
    /// The corners as given.
    pub(crate) fn corners(&self) -> Result<Vec<DVec2>, RectangleError> {
        match self {
            Self::Rectangle(rectangle) => rectangle.corners(),
            Self::Polygon(corners) => Ok(corners.clone()),
        }
    }
}

/// The way round in which corners are given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Orientation {
    CounterClockwise,
    Clockwise,
}

/// Checks corners and tells their orientation. O(k).
pub(crate) fn orientation(corners: &[DVec2]) -> Result<Orientation, OutlineError> {
    let count = corners.len();
    if count < 3 {
        return Err(OutlineError::TooFewCorners { corners: count });
    }
    for (corner, &DVec2 { x, y }) in corners.iter().enumerate() {
        // Not a NaN either.
        if !(x.abs() <= GREATEST_COORDINATE && y.abs() <= GREATEST_COORDINATE) {
            return Err(OutlineError::Coordinate { corner, x, y });
        }
    }
    for first in 0..count {
        check_distance(corners, first)?;
    }

    let turns: Vec<f64> = (0..count).map(|corner| turn(corners, corner)).collect();
    let total: f64 = turns.iter().sum();
    // The total is a multiple of a full turn. Where it is none at all the outline crosses
    // itself, and some corner is to be named whichever way the rest is read.
    let orientation =
        if total > -PI { Orientation::CounterClockwise } else { Orientation::Clockwise };
    let sign = if orientation == Orientation::CounterClockwise { 1.0 } else { -1.0 };
    for (corner, &turn) in turns.iter().enumerate() {
        let turn = sign * turn;
        let angle = if turn.abs() < least_turn(corners, corner) {
            180.0
        } else if turn.abs() > PI - LEAST_TURN {
            0.0
        } else if turn < 0.0 {
            (PI - turn).to_degrees()
        } else {
            continue;
        };
        let DVec2 { x, y } = corners[corner];
        return Err(OutlineError::NotConvex { corner, x, y, angle });
    }
    match (total.abs() / TAU).round() as u32 {
        1 => Ok(orientation),
        turns => Err(OutlineError::NotSimple { turns }),
    }
}

/// Checks that a corner and the next are apart.
fn check_distance(corners: &[DVec2], first: usize) -> Result<(), OutlineError> {
    let second = (first + 1) % corners.len();
    let (start, end) = (corners[first], corners[second]);
    if start == end {
        let DVec2 { x, y } = start;
        return Err(OutlineError::RepeatedCorner { first, second, x, y });
    }
    // Neither difference overflows or vanishes where its square would.
    let span = (end - start).abs();
    let distance = libm::hypot(span.x, span.y);
    let rounding = f64::EPSILON * start.abs().max(end.abs()).max_element();
    let least = LEAST_SIDE.max(LEAST_ROUNDINGS * rounding);
    // The longer difference alone decides what is too short to be a side.
    if span.max_element() < LEAST_SIDE || distance < LEAST_ROUNDINGS * rounding {
        return Err(OutlineError::CoincidentCorners { first, second, distance, least });
    }
    Ok(())
}

/// The incoming and the outgoing side at a corner.
fn sides_at(corners: &[DVec2], corner: usize) -> [DVec2; 2] {
    let count = corners.len();
    let before = corners[(corner + count - 1) % count];
    let after = corners[(corner + 1) % count];
    [corners[corner] - before, after - corners[corner]]
}

/// By how much the outline turns left at a corner, in radians, in (-π, π].
fn turn(corners: &[DVec2], corner: usize) -> f64 {
    let [incoming, outgoing] = sides_at(corners, corner);
    libm::atan2(incoming.perp_dot(outgoing), incoming.dot(outgoing))
}

/// The least turn at a corner that is not straight.
fn least_turn(corners: &[DVec2], corner: usize) -> f64 {
    let [incoming, outgoing] = sides_at(corners, corner).map(DVec2::length);
    // Each end of a side may be off by half a unit in the last place in either coordinate.
    let count = corners.len();
    let rounding = f64::EPSILON
        * [corner + count - 1, corner, corner + 1]
            .map(|i| corners[i % count].abs().max_element())
            .into_iter()
            .fold(0.0, f64::max);
    LEAST_TURN.max(rounding * (1.0 / incoming + 1.0 / outgoing))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check_corners(corners: &[[f64; 2]]) -> Result<Orientation, OutlineError> {
        let corners: Vec<DVec2> = corners.iter().copied().map(DVec2::from).collect();
        orientation(&corners)
    }

    #[test]
    fn tells_the_orientation_of_convex_polygons() {
        let polygons: &[&[[f64; 2]]] = &[
            &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
            &[[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]],
            &[[5e5, 5e6], [500_012.5, 5e6], [500_012.5, 5_000_007.25], [5e5, 5_000_007.25]],
            &[[0.0, 0.0], [2e-5, 1e-12], [1e-5, 1e-11]],
            &[[-1e100, -1e100], [1e100, -1e100], [1e100, 1e100]],
            &[[0.0, 0.0], [1e-100, 0.0], [0.0, 1e-100]],
        ];
        for corners in polygons {
            assert_eq!(check_corners(corners), Ok(Orientation::CounterClockwise), "{corners:?}");
            let clockwise: Vec<[f64; 2]> = corners.iter().rev().copied().collect();
            assert_eq!(check_corners(&clockwise), Ok(Orientation::Clockwise), "{corners:?}");
        }
    }

    #[test]
    fn refuses_what_is_not_convex_and_names_the_corner() {
        let table: &[(&[[f64; 2]], &str)] = &[
            (&[[0.0, 0.0], [1.0, 0.0]], "found 2 corners; an outline needs at least 3"),
            (
                &[[0.0, 0.0], [1.0, f64::NAN], [0.0, 1.0]],
                "corner 2 is at (1.0, NaN); coordinates must be finite and at most 1e100 in size",
            ),
            (&[[0.0, 0.0], [1.0, 0.0], [0.0, 1e101]], "corner 3 is at (0.0, 1e101)"),
            (
                &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 0.0]],
                "corners 4 and 1 are the same point (0.0, 0.0); give each corner once (the outline closes by itself)",
            ),
            (
                &[[0.0, 0.0], [1e-101, 0.0], [0.0, 1e-101]],
                "corners 1 and 2 coincide: their distance is 1.0e-101, and the minimum at these coordinates is 1.0e-100; drop one of them",
            ),
            (
                &[[0.0, 0.0], [4.0, 0.0], [4.0, 1e-17], [0.0, 3.0]],
                "corners 2 and 3 coincide: their distance is 1.0e-17, and the minimum at these coordinates is 7.1e-15; drop one of them",
            ),
            (
                &[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [0.0, 3.0]],
                "corner 2 at (1.0, 0.0) is straight (180°); every corner must turn; drop this corner, so that its two sides become one",
            ),
            (
                &[[0.0, 0.0], [4.0, 0.0], [1.0, 1.0], [0.0, 4.0]],
                "corner 3 at (1.0, 1.0) is reflex (233.130102°); every corner must turn the same way",
            ),
            // The same, clockwise: the reflex corner is still the one named.
            (
                &[[0.0, 4.0], [1.0, 1.0], [4.0, 0.0], [0.0, 0.0]],
                "corner 2 at (1.0, 1.0) is reflex (233.130102°)",
            ),
            (
                &[[0.0, 0.0], [2.0, 0.0], [1.0, 0.0]],
                "corner 1 at (0.0, 0.0) folds back on itself (0°)",
            ),
            // A bow tie.
            (
                &[[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]],
                "corner 2 at (1.0, 1.0) is reflex (315.000000°)",
            ),
            // On a slanted line in survey coordinates, up to rounding.
            (
                &[
                    [500_000.1, 4_650_000.1],
                    [500_001.1, 4_650_000.4],
                    [500_002.1, 4_650_000.7],
                    [500_000.0, 4_650_009.0],
                ],
                "corner 2 at (500001.1, 4650000.4) is straight (180°)",
            ),
        ];
        for (corners, message) in table {
            let error = check_corners(corners).unwrap_err().to_string();
            assert!(error.starts_with(message), "{error}");
        }
    }

    #[test]
    fn refuses_a_pentagram() {
        let star = |order: u32| {
            let corner = |i: u32| f64::from(order * i) * TAU / 5.0;
            (0..5).map(|i| DVec2::new(corner(i).cos(), corner(i).sin())).collect::<Vec<_>>()
        };
        assert_eq!(orientation(&star(1)), Ok(Orientation::CounterClockwise));
        assert_eq!(orientation(&star(2)), Err(OutlineError::NotSimple { turns: 2 }));
        assert_eq!(orientation(&star(3)), Err(OutlineError::NotSimple { turns: 2 }));
        assert_eq!(orientation(&star(4)), Ok(Orientation::Clockwise));
    }

    #[test]
    fn a_billionth_of_a_radian_is_straight() {
        for (rise, is_straight) in [(4e-10, true), (6e-10, false)] {
            let corners = [[0.0, 0.0], [1.0, -rise], [2.0, 0.0], [1.0, 1.0]];
            assert_eq!(check_corners(&corners).is_err(), is_straight, "{rise}");
        }
    }
}
