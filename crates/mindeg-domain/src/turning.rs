//! Where the boundary turns and where it is straight: the straight runs, in which exact work forbids
//! chords, and the convex form for the formulas.
//!
//! The boundary is a sequence of *pieces*: a straight side is one piece, and so is each edge of a
//! side that is not straight. Two consecutive pieces are one straight *run* if [`planar::turn`] finds
//! them straight.
//!
//! Limits: each turn is checked alone, so a run of many pieces may bend a little in total.

use std::f64::consts::TAU;

use glam::DVec2;
use mindeg_core::Boundary;
use mindeg_mesh::planar::{self, Turn};

use crate::placement::Placement;
use crate::rings::Rings;

/// A convex domain for the formulas of `mindeg-core`: no holes, and one side for each straight run
/// of the boundary.
///
/// # Example
///
/// ```
/// use mindeg_domain::{Domain, Side};
///
/// // The bottom is two sides on one line, and the domain's first corner is in its middle.
/// let corners = [[2.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0], [0.0, 0.0]];
/// let domain = Domain::polygon(corners, [2, 3, 4, 3, 1].map(Side::count).into())?;
/// let form = domain.convex().expect("a rectangle is convex");
/// assert!(form.boundary().sides().eq([3, 4, 3, 3]));
/// assert_eq!(form.first(), 2); // vertex 0 of the core's boundary is vertex 2 of the domain
/// # Ok::<(), mindeg_domain::DomainError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ConvexForm {
    boundary: Boundary,
    first: u32,
}

impl ConvexForm {
    /// The intervals of the straight runs, counter-clockwise.
    pub fn boundary(&self) -> &Boundary {
        &self.boundary
    }

    /// The vertex of the domain where the first run starts: vertex v of the
    /// [`boundary`](Self::boundary) is vertex (v + first) mod n of the domain.
    pub fn first(&self) -> u32 {
        self.first
    }
}

/// A piece of the boundary.
#[derive(Clone, Copy)]
struct Piece {
    /// The vertex where it starts.
    first: u32,
    start: DVec2,
    end: DVec2,
}

/// The turn from one piece to the next.
fn turn(incoming: Piece, outgoing: Piece) -> Turn {
    planar::turn([incoming.start, incoming.end], [outgoing.start, outgoing.end])
}

/// The boundary of a placement, some of whose sides are straight.
#[derive(Clone, Copy)]
pub(crate) struct Turning<'a> {
    pub(crate) placement: &'a Placement,
    /// Whether each side is straight.
    pub(crate) straight: &'a [bool],
}

impl Turning<'_> {
    fn rings(&self) -> &Rings {
        self.placement.rings()
    }

    /// The piece that the edge at a vertex belongs to.
    fn piece(&self, vertex: u32) -> Piece {
        let rings = self.rings();
        let side = rings.side_of(vertex);
        let (first, end) = if self.straight[side] {
            (rings.corner(side), rings.side_end(side))
        } else {
            (vertex, rings.next(vertex))
        };
        Piece { first, start: self.placement.point(first), end: self.placement.point(end) }
    }

    /// The turn at a vertex. O(log k).
    pub(crate) fn at(&self, vertex: u32) -> Turn {
        let (before, after) = (self.piece(self.rings().previous(vertex)), self.piece(vertex));
        if before.first == after.first { Turn::Straight } else { turn(before, after) }
    }

    /// The first vertices of the pieces of a ring, and the turn at each. O(1) for each piece.
    fn pieces(&self, ring: usize) -> Vec<(u32, Turn)> {
        let rings = self.rings();
        let mut pieces = Vec::new();
        for side in rings.ring_sides(ring) {
            let first = rings.corner(side);
            if self.straight[side] {
                let [start, end] =
                    [first, rings.side_end(side)].map(|corner| self.placement.point(corner));
                pieces.push(Piece { first, start, end });
                continue;
            }
            let mut start = self.placement.point(first);
            for vertex in first..first + rings.intervals(side) {
                let end = self.placement.point(rings.next(vertex));
                pieces.push(Piece { first: vertex, start, end });
                start = end;
            }
        }
        let mut before = pieces[pieces.len() - 1];
        let turns = pieces.into_iter().map(|piece| {
            let at = (piece.first, turn(before, piece));
            before = piece;
            at
        });
        turns.collect()
    }

    /// For each vertex, the run that the edge beginning there belongs to. O(n).
    pub(crate) fn runs(&self) -> Vec<u32> {
        planar::straight_runs(self.rings().rings(), |ring| self.pieces(ring))
    }

    /// Which way round a ring runs if it always turns the same way, and once around in all: then it
    /// is simple and convex. O(1) for each piece.
    pub(crate) fn convex_orientation(&self, ring: usize) -> Option<Orientation> {
        let mut total = 0.0;
        let (mut left, mut right) = (false, false);
        for (_, turn) in self.pieces(ring) {
            match turn {
                Turn::Straight => {}
                Turn::Back => return None,
                Turn::By(angle) => {
                    total += angle;
                    left |= angle > 0.0;
                    right |= angle < 0.0;
                }
            }
        }
        let is_once = (total.abs() / TAU).round() == 1.0;
        match (left, right) {
            (true, false) if is_once => Some(Orientation::CounterClockwise),
            (false, true) if is_once => Some(Orientation::Clockwise),
            _ => None,
        }
    }

    /// The convex form, if the domain has no holes and its ring is convex and counter-clockwise.
    pub(crate) fn convex_form(&self) -> Option<ConvexForm> {
        let rings = self.rings();
        if rings.ring_count() > 1
            || self.convex_orientation(0) != Some(Orientation::CounterClockwise)
        {
            return None;
        }
        let starts = self.pieces(0).into_iter().filter(|&(_, turn)| turn != Turn::Straight);
        let starts: Vec<u32> = starts.map(|(first, _)| first).collect();
        let first = *starts.first()?;
        let ends = starts[1..].iter().copied().chain([first + rings.vertex_count()]);
        let intervals: Vec<u64> =
            starts.iter().zip(ends).map(|(&start, end)| u64::from(end - start)).collect();
        let boundary = Boundary::new(&intervals).ok()?;
        Some(ConvexForm { boundary, first })
    }
}

/// The direction of a ring.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Orientation {
    CounterClockwise,
    Clockwise,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Domain, Side};
    use mindeg_mesh::planar::LEAST_TURN;

    fn polygon(corners: &[[f64; 2]], intervals: &[u64]) -> Domain {
        let sides = intervals.iter().map(|&count| Side::count(count)).collect();
        Domain::polygon(corners.iter().copied(), sides).unwrap()
    }

    #[test]
    fn collinear_sides_are_one_run() {
        let corners = [[1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [1.0, 2.0], [0.0, 2.0], [0.0, 0.0]];
        let domain = polygon(&corners, &[1, 2, 1, 1, 2, 1]);
        assert_eq!(domain.straight_runs(), [0, 1, 1, 2, 2, 3, 3, 0]);
        let form = domain.convex().unwrap();
        assert!(form.boundary().sides().eq([2, 2, 2, 2]));
        assert_eq!(form.first(), 1);
    }

    #[test]
    fn a_reflex_corner_ends_a_run_and_the_convex_form() {
        let domain = polygon(&[[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [0.0, 2.0]], &[2, 1, 1, 1]);
        assert!(domain.convex().is_some());
        let domain = polygon(&[[0.0, 0.0], [2.0, 0.0], [0.9, 0.9], [0.0, 2.0]], &[2, 1, 2, 1]);
        assert_eq!(domain.convex(), None);
        assert_eq!(domain.straight_runs(), [0, 0, 1, 2, 2, 3]);
    }

    #[test]
    fn a_billionth_of_a_radian_is_straight() {
        for (rise, runs) in [(4e-10, 3), (6e-10, 4), (-4e-10, 3), (-6e-10, 4)] {
            let domain = polygon(&[[0.0, 0.0], [1.0, -rise], [2.0, 0.0], [1.0, 1.0]], &[1; 4]);
            assert_eq!(domain.straight_runs().iter().max(), Some(&(runs - 1)), "{rise}");
            let is_convex = rise > -LEAST_TURN / 2.0;
            assert_eq!(domain.convex().is_some(), is_convex, "{rise}");
        }
        // On a slanted line in survey coordinates, up to rounding.
        let corners = [
            [500_000.1, 4_650_000.1],
            [500_001.1, 4_650_000.4],
            [500_002.1, 4_650_000.7],
            [5e5, 4_650_009.0],
        ];
        assert_eq!(polygon(&corners, &[1; 4]).straight_runs(), [0, 0, 1, 2]);
    }

    /// Found by fuzzing: every corner beside such an edge counted as straight, and no chord was left.
    #[test]
    fn a_corner_beside_an_edge_of_one_unit_in_the_last_place_is_one() {
        let near = 31.0_f64 / 7.0;
        let corners = [[near, near], [near, near.next_up()], [0.0, 30.0], [0.0, 0.0]];
        let domain = Domain::from_rings([corners.map(DVec2::from).to_vec()]).unwrap();
        assert_eq!(domain.straight_runs(), [0, 1, 2, 3]);
        assert!(domain.convex().is_some());
    }
}
