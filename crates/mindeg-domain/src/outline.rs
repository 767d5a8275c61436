//! The shape of a domain as a user gives it: corners, and what joins them.
//!
//! Limits: corners are judged one at a time, so of several faults the first is reported. Whether
//! rings cross is judged later, on all points (`intersection.rs`).

use glam::DVec2;

use crate::curve::Curve;
use crate::limits::{GREATEST_COORDINATE, LEAST_ROUNDINGS, LEAST_SIDE};
use crate::rectangle::{Rectangle, RectangleError};
use crate::rings::{InRing, ring_name};
use crate::side::Side;

/// The shape of a domain's outer ring.
#[derive(Clone, Debug, PartialEq)]
pub enum Outline {
    /// A rectangle; its sides are bottom, right, top and left.
    Rectangle(Rectangle),
    /// The corners of a simple polygon; side `s` runs from corner `s` to the next.
    Polygon(Vec<DVec2>),
}

/// A ring: corners, and one [`Side`] from each to the next. A ring whose sides are curved may have
/// one or two corners.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ring {
    /// The corners, in order; either way round.
    pub corners: Vec<DVec2>,
    /// One for each corner, from there to the next.
    pub sides: Vec<Side>,
}

/// Why corners are not those of a ring.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OutlineError {
    /// Measures that are not those of a rectangle.
    #[error(transparent)]
    Rectangle(#[from] RectangleError),
    /// Fewer than three corners.
    #[error(
        "found {corners} {}{}; {} of straight sides needs at least 3",
        if *corners == 1 { "corner" } else { "corners" },
        if *ring == 0 { String::new() } else { format!(" of {}", ring_name(*ring)) },
        if *ring == 0 { "an outline" } else { "a hole" }
    )]
    TooFewCorners {
        /// The ring.
        ring: usize,
        /// The number of corners.
        corners: usize,
    },
    /// A coordinate that is not finite or greater than
    /// [`GREATEST_COORDINATE`](crate::GREATEST_COORDINATE).
    #[error(
        "{} is at ({x:?}, {y:?}); coordinates must be finite and at most \
         {GREATEST_COORDINATE:e} in size",
        corner.corner()
    )]
    Coordinate {
        /// The corner.
        corner: InRing,
        /// Its x coordinate.
        x: f64,
        /// Its y coordinate.
        y: f64,
    },
    /// Two neighbouring corners at the same point.
    #[error(
        "corners {} and {} are the same point ({x:?}, {y:?}); give each corner once ({} closes by \
         itself)",
        first.index + 1, second.named_last(), if first.ring == 0 { "the outline" } else { "the hole" }
    )]
    RepeatedCorner {
        /// The one.
        first: InRing,
        /// The next.
        second: InRing,
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
        first.index + 1, second.named_last()
    )]
    CoincidentCorners {
        /// The one.
        first: InRing,
        /// The next.
        second: InRing,
        /// Their distance.
        distance: f64,
        /// The least distance that two corners with these coordinates must have.
        least: f64,
    },
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

impl Ring {
    /// A ring of points, which come back bit for bit: one side, that starts and ends at the first.
    #[must_use]
    pub fn of_points(points: impl IntoIterator<Item = impl Into<DVec2>>) -> Self {
        let mut points = points.into_iter().map(Into::into);
        let Some(first) = points.next() else { return Self::default() };
        Self { corners: vec![first], sides: vec![Side::points(points.collect())] }
    }

    /// A ring of corners and sides.
    #[must_use]
    pub fn new(corners: impl IntoIterator<Item = impl Into<DVec2>>, sides: Vec<Side>) -> Self {
        Self { corners: corners.into_iter().map(Into::into).collect(), sides }
    }
}

/// Checks the corners of a ring. O(k).
pub(crate) fn check_corners(ring: usize, given: &Ring) -> Result<(), OutlineError> {
    let Ring { corners, sides } = given;
    let count = corners.len();
    let is_curved = sides.iter().any(|side| side.curve != Curve::Line);
    if count == 0 || (count < 3 && !is_curved) {
        return Err(OutlineError::TooFewCorners { ring, corners: count });
    }
    for (index, &DVec2 { x, y }) in corners.iter().enumerate() {
        // Not a NaN either.
        if !(x.abs() <= GREATEST_COORDINATE && y.abs() <= GREATEST_COORDINATE) {
            return Err(OutlineError::Coordinate { corner: InRing { ring, index }, x, y });
        }
    }
    if count == 1 {
        return Ok(());
    }
    (0..count).try_for_each(|first| check_distance(ring, corners, first))
}

/// Checks that a corner and the next are apart.
fn check_distance(ring: usize, corners: &[DVec2], first: usize) -> Result<(), OutlineError> {
    let second = (first + 1) % corners.len();
    let (start, end) = (corners[first], corners[second]);
    let [first, second] = [first, second].map(|index| InRing { ring, index });
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refuses_corners_that_are_not_apart() {
        #[rustfmt::skip]
        let table: &[(usize, &[[f64; 2]], &str)] = &[
            (0, &[[0.0, 0.0], [1.0, 0.0]], "found 2 corners; an outline of straight sides needs at least 3"),
            (2, &[[0.0, 0.0]], "found 1 corner of hole 2; a hole of straight sides needs at least 3"),
            (0, &[[0.0, 0.0], [1.0, f64::NAN], [0.0, 1.0]], "corner 2 is at (1.0, NaN); coordinates must be finite and at most 1e100 in size"),
            (1, &[[0.0, 0.0], [1.0, 0.0], [0.0, 1e101]], "corner 3 of hole 1 is at (0.0, 1e101); coordinates must be finite and at most 1e100 in size"),
            (0, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 0.0]], "corners 4 and 1 are the same point (0.0, 0.0); give each corner once (the outline closes by itself)"),
            (3, &[[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [0.0, 3.0]], "corners 2 and 3 of hole 3 are the same point (1.0, 0.0); give each corner once (the hole closes by itself)"),
            (0, &[[0.0, 0.0], [1e-101, 0.0], [0.0, 1e-101]], "corners 1 and 2 coincide: their distance is 1.0e-101, and the minimum at these coordinates is 1.0e-100; drop one of them"),
            (0, &[[0.0, 0.0], [4.0, 0.0], [4.0, 1e-17], [0.0, 3.0]], "corners 2 and 3 coincide: their distance is 1.0e-17, and the minimum at these coordinates is 7.1e-15; drop one of them"),
        ];
        for (ring, corners, message) in table {
            let corners: Vec<DVec2> = corners.iter().copied().map(DVec2::from).collect();
            let given = Ring { corners, sides: Vec::new() };
            assert_eq!(check_corners(*ring, &given).unwrap_err().to_string(), *message);
        }
    }
}
