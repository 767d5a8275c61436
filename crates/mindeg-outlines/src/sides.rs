//! The sides of a ring, and the points on them.
//!
//! A side ends at a corner: where the ring turns by more than an angle, where the file begins a
//! side, or where the name of the sides changes.

use mindeg_mesh::number;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc as Shared;

use glam::DVec2;

use super::curve::{PieceCurve, Segment, angle_between};
use super::outline::DrawnRing;
use crate::error::OutlineError;

/// How rings are divided.
#[derive(Clone, Debug, PartialEq)]
pub struct Division {
    /// The ring has a corner where it turns by more than this angle, in degrees.
    pub corner_angle: f64,
    /// The length that the intervals of every side should have. Without it the points of the file
    /// are kept, and curves get points so that no interval turns by more than 15 degrees.
    pub size: Option<f64>,
    /// The same for sides and lines of a name, in place of that.
    pub sizes: BTreeMap<String, f64>,
}

impl Default for Division {
    /// The points of the file, with corners where a ring turns by more than 30 degrees.
    fn default() -> Self {
        Self { corner_angle: 30.0, size: None, sizes: BTreeMap::new() }
    }
}

/// A side of a ring.
#[derive(Clone, Debug, PartialEq)]
pub struct DividedSide {
    /// The name that the file gives.
    pub name: Option<Shared<str>>,
    /// The points from its corner on, without the end, which is the next side's corner.
    pub points: Vec<DVec2>,
    /// Whether it is one straight line, whose points may be worked out from its ends.
    pub is_line: bool,
}

/// The most points that a division makes.
const MOST_POINTS: u64 = 50_000_000;

/// A turn that exceeds the corner angle by less, in radians, is rounding.
const ROUNDING: f64 = 1e-9;

impl DrawnRing {
    /// The sides with their points, from the first corner of the file on. A ring without corners
    /// is one side, which begins at the first point of the file.
    ///
    /// # Errors
    ///
    /// A size that makes more than fifty million points.
    pub fn divided(&self, division: &Division) -> Result<Vec<DividedSide>, OutlineError> {
        let count = self.pieces.len();
        let mut corners = self.corners(0..count, division);
        if corners.is_empty() && count > 0 {
            corners.push(0);
        }
        // Where there are fewer than three sides, one interval each makes no polygon.
        let least = match corners.len() {
            1 => 3,
            2 => 2,
            _ => 1,
        };
        let end = corners.first().map_or(0, |first| first + count);
        self.divided_at(&corners, end, least, division)
    }

    /// The sides of the open line that ends where the last piece starts.
    ///
    /// # Errors
    ///
    /// A size that makes more than fifty million points.
    pub(super) fn divided_open(
        &self,
        division: &Division,
    ) -> Result<Vec<DividedSide>, OutlineError> {
        let end = self.pieces.len().saturating_sub(1);
        let mut corners = self.corners(1..end, division);
        corners.insert(0, 0);
        self.divided_at(&corners, end, 1, division)
    }

    /// The pieces in a range that begin a side.
    fn corners(&self, pieces: Range<usize>, division: &Division) -> Vec<usize> {
        let corner_angle = division.corner_angle.to_radians() + ROUNDING;
        pieces.filter(|&piece| self.is_corner(piece, corner_angle)).collect()
    }

    /// The sides between corners and the end, each of at least so many intervals.
    fn divided_at(
        &self,
        corners: &[usize],
        end: usize,
        least: u32,
        division: &Division,
    ) -> Result<Vec<DividedSide>, OutlineError> {
        let count = self.pieces.len();
        let mut total = 0.0;
        let mut sides = Vec::with_capacity(corners.len());
        for (index, &corner) in corners.iter().enumerate() {
            let end = corners.get(index + 1).copied().unwrap_or(end);
            let segments: Vec<Segment> =
                (corner..end).map(|piece| self.segment(piece % count)).collect();
            let is_line = segments.len() == 1 && segments[0].curve == PieceCurve::Line;
            let name = self.pieces[corner].side.clone();
            let own = name.as_deref().and_then(|name| division.sizes.get(name).copied());
            let points = match own.or(division.size) {
                None => kept(&segments, &mut total)?,
                Some(size) => {
                    let least = if is_line { 1 } else { least };
                    evenly_spaced(&segments, size, least, &mut total)?
                }
            };
            sides.push(DividedSide { name, points, is_line });
        }
        Ok(sides)
    }

    /// Whether a side begins where a piece does.
    fn is_corner(&self, piece: usize, corner_angle: f64) -> bool {
        let count = self.pieces.len();
        let before = (piece + count - 1) % count;
        if self.pieces[piece].begins_side || self.pieces[piece].side != self.pieces[before].side {
            return true;
        }
        let incoming = self.segment(before).direction_at_end();
        let outgoing = self.segment(piece).direction_at_start();
        // A piece that is a point has no direction.
        incoming == DVec2::ZERO
            || outgoing == DVec2::ZERO
            || angle_between(incoming, outgoing) > corner_angle
    }
}

fn check_total(total: &mut f64, more: f64, size: f64) -> Result<(), OutlineError> {
    *total += more;
    // Not a NaN either.
    if *total <= MOST_POINTS as f64 {
        return Ok(());
    }
    let points = *total;
    let problem = format!(
        "the size {size:?} makes {} points, and at most {MOST_POINTS} are stored; give a larger size",
        number(points)
    );
    Err(OutlineError::place("", problem))
}

/// The points of the file, and some along curves.
fn kept(segments: &[Segment], total: &mut f64) -> Result<Vec<DVec2>, OutlineError> {
    let mut points = Vec::with_capacity(segments.len());
    for segment in segments {
        let intervals = segment.intervals_by_turning();
        check_total(total, f64::from(intervals), 0.0)?;
        points.push(segment.start);
        if intervals > 1 {
            let step = segment.length() / f64::from(intervals);
            let lengths: Vec<f64> = (1..intervals).map(|i| step * f64::from(i)).collect();
            points.extend(segment.points_at(&lengths));
        }
    }
    Ok(points)
}

/// Points at equal lengths along a side.
fn evenly_spaced(
    segments: &[Segment],
    size: f64,
    least: u32,
    total: &mut f64,
) -> Result<Vec<DVec2>, OutlineError> {
    let lengths: Vec<f64> = segments.iter().map(Segment::length).collect();
    let length: f64 = lengths.iter().sum();
    let intervals = libm::round(length / size).max(f64::from(least));
    check_total(total, intervals, size)?;
    let intervals = intervals as u32;
    let mut points = vec![segments[0].start];
    let mut passed = 0.0;
    let mut next = 1;
    for (index, (segment, own)) in segments.iter().zip(lengths).enumerate() {
        let is_last = index + 1 == segments.len();
        let mut wanted = Vec::new();
        while next < intervals {
            let along = length * (f64::from(next) / f64::from(intervals)) - passed;
            if along >= own && !is_last {
                break;
            }
            wanted.push(along.max(0.0));
            next += 1;
        }
        if !wanted.is_empty() {
            points.extend(segment.points_at(&wanted));
        }
        passed += own;
    }
    Ok(points)
}

#[cfg(test)]
mod tests {
    use super::super::curve::EllipseArc;
    use super::super::outline::Piece;
    use super::*;
    use std::f64::consts::{PI, TAU};

    fn ring(points: &[[f64; 2]]) -> DrawnRing {
        DrawnRing::of_points(points.iter().copied().map(DVec2::from))
    }

    /// The points of the sides.
    fn points(ring: &DrawnRing, corner_angle: f64, size: Option<f64>) -> Vec<Vec<[f64; 2]>> {
        let sides = ring.divided(&Division { corner_angle, size, ..Division::default() }).unwrap();
        let points = |side: &DividedSide| side.points.iter().map(|it| it.to_array()).collect();
        sides.iter().map(points).collect()
    }

    #[test]
    fn sides_end_where_the_ring_turns_by_more_than_the_angle() {
        // A square whose lower side has a slight bend at the first point.
        let square = ring(&[[2.0, 0.1], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]]);
        let expected: [&[[f64; 2]]; 4] =
            [&[[4.0, 0.0]], &[[4.0, 4.0]], &[[0.0, 4.0]], &[[0.0, 0.0], [2.0, 0.1]]];
        assert_eq!(points(&square, 30.0, None), expected);
        assert_eq!(points(&square, 1.0, None).len(), 5);
        assert_eq!(points(&square, 180.0, None).len(), 1);
        // Two corners turn by 90 degrees, the others by some more.
        assert_eq!(points(&square, 90.0, None)[0].len(), 3);
    }

    #[test]
    fn names_and_the_file_begin_sides() {
        let mut square = ring(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]);
        square.pieces[1].begins_side = true;
        assert_eq!(points(&square, 30.0, None).len(), 5);
        square.pieces[1].begins_side = false;
        square.pieces[1].side = Some("wall".into());
        let sides = square.divided(&Division::default()).unwrap();
        let names: Vec<Option<&str>> = sides.iter().map(|side| side.name.as_deref()).collect();
        assert_eq!(names, [None, Some("wall"), None, None, None]);
    }

    #[test]
    fn sizes_divide_sides_by_their_length() {
        let square = ring(&[[0.0, 0.0], [3.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]);
        let sides = points(&square, 30.0, Some(1.0));
        assert_eq!(sides.iter().map(Vec::len).collect::<Vec<_>>(), [4; 4]);
        assert_eq!(sides[0], [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0]]);
        let sides = points(&square, 30.0, Some(100.0));
        assert_eq!(sides.iter().map(Vec::len).collect::<Vec<_>>(), [1; 4]);
        let error = square.divided(&Division { size: Some(1e-12), ..Division::default() });
        let message = error.unwrap_err().to_string();
        assert_eq!(
            message,
            "the size 1e-12 makes 4e12 points, and at most 50000000 are stored; give a larger size"
        );
    }

    #[test]
    fn curves_are_divided_by_arc_length() {
        let arc = |center: DVec2, start: f64, sweep: f64| {
            PieceCurve::Arc(EllipseArc { center, axes: [DVec2::X, DVec2::Y], start, sweep })
        };
        let circle = DrawnRing {
            pieces: vec![Piece { curve: arc(DVec2::ZERO, 0.0, TAU), ..Piece::line(DVec2::X) }],
        };
        assert_eq!(points(&circle, 30.0, None)[0].len(), 24);
        assert_eq!(points(&circle, 30.0, Some(100.0))[0].len(), 3);
        let sixths = points(&circle, 30.0, Some(TAU / 6.0));
        for (i, point) in sixths[0].iter().enumerate() {
            let expected = DVec2::from_angle(i as f64 * PI / 3.0);
            assert!(expected.distance(DVec2::from(*point)) < 1e-14);
        }
        // A stadium: one side without corners, of two lines and two half circles.
        let piece = |curve, x, y| Piece { curve, ..Piece::line(DVec2::new(x, y)) };
        let stadium = DrawnRing {
            pieces: vec![
                piece(PieceCurve::Line, 0.0, -1.0),
                piece(arc(DVec2::X * 2.0, -PI / 2.0, PI), 2.0, -1.0),
                piece(PieceCurve::Line, 2.0, 1.0),
                piece(arc(DVec2::ZERO, PI / 2.0, PI), 0.0, 1.0),
            ],
        };
        assert_eq!(points(&stadium, 30.0, None), [points(&stadium, 0.1, None).concat()]);
        let length = 4.0 + TAU;
        let sides = points(&stadium, 30.0, Some(length / 4.0));
        assert_eq!(sides[0].len(), 4);
        let quarter = length / 4.0 - 2.0;
        let expected = DVec2::X * 2.0 + DVec2::from_angle(quarter - PI / 2.0);
        assert!(expected.distance(sides[0][1].into()) < 1e-14, "{sides:?}");
        assert!(DVec2::new(2.0, 1.0).distance(sides[0][2].into()) < 1e-14, "{sides:?}");
    }
}
