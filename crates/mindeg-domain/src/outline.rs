//! The shape of a domain as a user gives it: corners, and the sides that join them.
//!
//! Limits: corners are checked one at a time, so only the first fault is reported. Whether rings
//! cross is checked later, on all points (`intersection.rs`).

use glam::DVec2;
use mindeg_mesh::planar::{InRing, ring_name};
use mindeg_mesh::{number, place};

use crate::curve::Curve;
use crate::error::{DomainError, Place, counted};
use crate::limits::{GREATEST_COORDINATE, LEAST_ROUNDINGS, LEAST_SIDE};
use crate::rectangle::Rectangle;
use crate::side::Side;

/// The shape of a domain's outer ring.
#[derive(Clone, Debug, PartialEq)]
pub enum Outline {
    /// A rectangle; its sides are bottom, right, top and left.
    Rectangle(Rectangle),
    /// The corners of a simple polygon; side `s` runs from corner `s` to the next.
    Polygon(Vec<DVec2>),
}

/// A ring, or a line inside a domain: corners, and one [`Side`] from each to the next. A ring whose sides are
/// curved may have one or two corners. An open line has one side fewer than corners.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ring {
    /// The corners, in order; either way round.
    pub corners: Vec<DVec2>,
    /// One for each corner, from there to the next.
    pub sides: Vec<Side>,
}

impl Outline {
    /// The corners as given.
    pub(crate) fn corners(&self) -> Result<Vec<DVec2>, DomainError> {
        match self {
            Self::Rectangle(rectangle) => rectangle.corners(),
            Self::Polygon(corners) => Ok(corners.clone()),
        }
    }
}

impl Ring {
    /// A ring of points, kept bit for bit: a single side, which starts and ends at the first point.
    pub fn of_points(points: impl IntoIterator<Item = impl Into<DVec2>>) -> Self {
        let mut points = points.into_iter().map(Into::into);
        let Some(first) = points.next() else { return Self::default() };
        Self { corners: vec![first], sides: vec![Side::points(points.collect())] }
    }

    /// A ring of corners and sides.
    pub fn new(corners: impl IntoIterator<Item = impl Into<DVec2>>, sides: Vec<Side>) -> Self {
        Self { corners: corners.into_iter().map(Into::into).collect(), sides }
    }

    /// Whether it is a line with two ends: one side fewer than corners.
    pub fn is_open(&self) -> bool {
        self.sides.len() < self.corners.len()
    }
}

/// Checks the corners of a ring. O(k).
pub(crate) fn check_corners(ring: usize, given: &Ring) -> Result<(), DomainError> {
    let Ring { corners, sides } = given;
    let count = corners.len();
    let is_curved = sides.iter().any(|side| side.curve != Curve::Line);
    if count == 0 || (count < 3 && !is_curved) {
        let (of, whose) = match ring {
            0 => (String::new(), "an outline"),
            _ => (format!(" of {}", ring_name(ring)), "a hole"),
        };
        return Err(Place::corners(ring).error(format!(
            "found {}{of}; {whose} of straight sides needs at least 3",
            counted(count, "corner")
        )));
    }
    check_positions(ring, corners, true)
}

/// Checks that corners are ordinary numbers, and each apart from the next.
pub(crate) fn check_positions(
    ring: usize,
    corners: &[DVec2],
    is_closed: bool,
) -> Result<(), DomainError> {
    let count = corners.len();
    for (index, &DVec2 { x, y }) in corners.iter().enumerate() {
        // Not a NaN either.
        if !(x.abs() <= GREATEST_COORDINATE && y.abs() <= GREATEST_COORDINATE) {
            let corner = InRing { ring, index };
            return Err(Place::corner(corner).error(format!(
                "{} is at ({x:?}, {y:?}); coordinates must be finite and at most \
                     {GREATEST_COORDINATE:e} in size",
                corner.corner()
            )));
        }
    }
    if count == 1 {
        return Ok(());
    }
    let pairs = count - usize::from(!is_closed);
    (0..pairs).try_for_each(|first| check_distance(ring, corners, first))
}

/// Checks that a corner and the next are apart.
fn check_distance(ring: usize, corners: &[DVec2], first: usize) -> Result<(), DomainError> {
    let second = (first + 1) % corners.len();
    let (start, end) = (corners[first], corners[second]);
    let second = InRing { ring, index: second };
    let both = format!("corners {} and {}", first + 1, second.named_last());
    let error = |message| Err(Place::corner(second).touch(message).telling([start]));
    if start == end {
        let whole = if ring == 0 { "outline" } else { "hole" };
        return error(format!(
            "{both} are the same point {}; give each corner once (the {whole} closes by itself)",
            place(start)
        ));
    }
    // Neither difference overflows or vanishes where its square would.
    let span = (end - start).abs();
    let distance = libm::hypot(span.x, span.y);
    let rounding = f64::EPSILON * start.abs().max(end.abs()).max_element();
    let least = LEAST_SIDE.max(LEAST_ROUNDINGS * rounding);
    // The longer difference alone decides whether a side is too short.
    if span.max_element() < LEAST_SIDE || distance < LEAST_ROUNDINGS * rounding {
        return error(format!(
            "{both} coincide: their distance is {}, and the minimum at these coordinates is {}; \
             drop one of them",
            number(distance),
            number(least)
        ));
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
            (0, &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 0.0]], "corners 4 and 1 are the same point (0, 0); give each corner once (the outline closes by itself)"),
            (3, &[[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [0.0, 3.0]], "corners 2 and 3 of hole 3 are the same point (1, 0); give each corner once (the hole closes by itself)"),
            (0, &[[0.0, 0.0], [1e-101, 0.0], [0.0, 1e-101]], "corners 1 and 2 coincide: their distance is 1e-101, and the minimum at these coordinates is 1e-100; drop one of them"),
            (0, &[[0.0, 0.0], [4.0, 0.0], [4.0, 1e-17], [0.0, 3.0]], "corners 2 and 3 coincide: their distance is 1e-17, and the minimum at these coordinates is 7.105e-15; drop one of them"),
        ];
        for (ring, corners, message) in table {
            let corners: Vec<DVec2> = corners.iter().copied().map(DVec2::from).collect();
            let given = Ring { corners, sides: Vec::new() };
            assert_eq!(check_corners(*ring, &given).unwrap_err().to_string(), *message);
        }
    }
}
