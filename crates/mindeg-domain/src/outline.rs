//! Whether a list of corners is a strictly convex polygon, and which way round it is given.
//!
//! Everything follows from the angle by which the outline turns at each corner. A closed outline
//! that always turns the same way, and once around in all, is a simple, strictly convex polygon;
//! a pentagram always turns the same way too, but goes around twice.
//!
//! Angles come from differences of coordinates, so that nothing is lost far from the origin but
//! what the coordinates themselves have lost. A corner is straight where it turns by less than
//! [`STRAIGHT`], or by less than the rounding of its coordinates can make out of nothing.
//!
//! Limits: corners are judged one at a time, so of an outline with several faults the first is
//! reported.

use std::f64::consts::{PI, TAU};

use glam::DVec2;

use crate::domain::{GREATEST_COORDINATE, LEAST_SIDE};
use crate::domain_error::DomainError;

/// A corner that turns by less, in radians, is straight: 0.2 mm in 200 km.
pub(crate) const STRAIGHT: f64 = 1e-9;

/// The way round in which corners are given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Orientation {
    CounterClockwise,
    Clockwise,
}

/// Checks corners and tells their orientation. O(k).
pub(crate) fn check(corners: &[DVec2]) -> Result<Orientation, DomainError> {
    let count = corners.len();
    if count < 3 {
        return Err(DomainError::TooFewCorners { corners: count });
    }
    for (corner, &DVec2 { x, y }) in corners.iter().enumerate() {
        // Not a NaN either.
        if !(x.abs() <= GREATEST_COORDINATE && y.abs() <= GREATEST_COORDINATE) {
            return Err(DomainError::Coordinate { corner, x, y });
        }
    }
    for (first, &DVec2 { x, y }) in corners.iter().enumerate() {
        let second = (first + 1) % count;
        let side = (corners[second] - corners[first]).abs();
        if side.max_element() < LEAST_SIDE {
            return Err(DomainError::RepeatedCorner { first, second, x, y });
        }
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
        } else if turn.abs() > PI - STRAIGHT {
            0.0
        } else if turn < 0.0 {
            (PI - turn).to_degrees()
        } else {
            continue;
        };
        let DVec2 { x, y } = corners[corner];
        return Err(DomainError::NotConvex { corner, x, y, angle });
    }
    match (total.abs() / TAU).round() as u32 {
        1 => Ok(orientation),
        turns => Err(DomainError::NotSimple { turns }),
    }
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
    STRAIGHT.max(rounding * (1.0 / incoming + 1.0 / outgoing))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check_corners(corners: &[[f64; 2]]) -> Result<Orientation, DomainError> {
        let corners: Vec<DVec2> = corners.iter().copied().map(DVec2::from).collect();
        check(&corners)
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
            (&[[0.0, 0.0], [1.0, 0.0]], "an outline needs at least 3 corners, and 2 are given"),
            (
                &[[0.0, 0.0], [1.0, f64::NAN], [0.0, 1.0]],
                "corner 2 is at (1.0, NaN); coordinates must be finite and at most 1e100 in size",
            ),
            (&[[0.0, 0.0], [1.0, 0.0], [0.0, 1e101]], "corner 3 is at (0.0, 1e101)"),
            (
                &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 0.0]],
                "corners 4 and 1 are the same point (0.0, 0.0), or as good as; give each corner once (the outline closes by itself)",
            ),
            (&[[0.0, 0.0], [1e-101, 0.0], [0.0, 1e-101]], "corners 1 and 2 are the same point"),
            (
                &[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [0.0, 3.0]],
                "corner 2 at (1.0, 0.0) is straight (180°); every corner must turn the same way",
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
        assert_eq!(check(&star(1)), Ok(Orientation::CounterClockwise));
        assert_eq!(check(&star(2)), Err(DomainError::NotSimple { turns: 2 }));
        assert_eq!(check(&star(3)), Err(DomainError::NotSimple { turns: 2 }));
        assert_eq!(check(&star(4)), Ok(Orientation::Clockwise));
    }

    #[test]
    fn a_billionth_of_a_radian_is_straight() {
        for (rise, is_straight) in [(4e-10, true), (6e-10, false)] {
            let corners = [[0.0, 0.0], [1.0, -rise], [2.0, 0.0], [1.0, 1.0]];
            assert_eq!(check_corners(&corners).is_err(), is_straight, "{rise}");
        }
    }
}
