//! Where a ring crosses itself, or a vertex lies on another of its edges: vertices on both.
//!
//! A sweep over the edges from left to right, compared with those that overlap in x. Whether edges
//! cross is exact; the point where they do is rounded, so the ring is looked at again.
//!
//! Limits: straight pieces only; a ring of more than [`MOST_COMPARISONS`] comparisons stays as it is.

use std::collections::BTreeMap;

use glam::DVec2;

use super::super::curve::Curve;
use super::super::orientation::orientation;
use super::super::outline::{Piece, Ring};

/// The most comparisons of two edges, which take about a second.
const MOST_COMPARISONS: u64 = 200_000_000;

/// How often rounded crossings are looked at again.
const ROUNDS: u32 = 4;

/// The ring with a vertex wherever it meets itself, and how many were added.
pub(super) fn with_vertices(mut ring: Ring) -> (Ring, usize) {
    let mut added = 0;
    for _ in 0..ROUNDS {
        let meetings = meetings(&ring);
        let count: usize = meetings.values().map(Vec::len).sum();
        if count == 0 {
            break;
        }
        added += count;
        ring = inserted(ring, meetings);
    }
    (ring, added)
}

/// The points to insert into each edge, in their order on it.
fn meetings(ring: &Ring) -> BTreeMap<usize, Vec<DVec2>> {
    let mut meetings: BTreeMap<usize, Vec<DVec2>> = BTreeMap::new();
    let edges: Vec<[DVec2; 2]> = ring.segments().map(|it| [it.start, it.end]).collect();
    let is_straight = |&edge: &usize| ring.pieces[edge].curve == Curve::Line;
    let left = |edge: usize| edges[edge][0].x.min(edges[edge][1].x);
    let right = |edge: usize| edges[edge][0].x.max(edges[edge][1].x);
    let mut order: Vec<usize> = (0..edges.len()).filter(is_straight).collect();
    order.sort_by(|&a, &b| left(a).total_cmp(&left(b)).then(a.cmp(&b)));
    let mut active: Vec<usize> = Vec::new();
    let mut comparisons = 0;
    for edge in order {
        active.retain(|&other| right(other) >= left(edge));
        comparisons += active.len() as u64;
        if comparisons > MOST_COMPARISONS {
            return BTreeMap::new();
        }
        for &other in &active {
            for (one, point) in meeting(edges[edge], edges[other]) {
                let of = if one == 0 { edge } else { other };
                meetings.entry(of).or_default().push(point);
            }
        }
        active.push(edge);
    }
    // Two edges that end at a vertex both find it on a third.
    for (&edge, points) in &mut meetings {
        let distance = |point: &DVec2| (*point - edges[edge][0]).length_squared();
        points.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
        points.dedup();
    }
    meetings
}

/// The points that two edges have in common, but for ends of both: each with the edge, 0 or 1, that
/// lacks it.
fn meeting(one: [DVec2; 2], other: [DVec2; 2]) -> Vec<(usize, DVec2)> {
    let lowest = |[a, b]: [DVec2; 2]| a.y.min(b.y);
    let highest = |[a, b]: [DVec2; 2]| a.y.max(b.y);
    if lowest(one) > highest(other) || lowest(other) > highest(one) {
        return Vec::new();
    }
    let side = |[a, b]: [DVec2; 2], p: DVec2| orientation(a, b, p);
    let of_other = other.map(|end| side(one, end));
    let of_one = one.map(|end| side(other, end));
    let mut found = Vec::new();
    let lies_inside = |[a, b]: [DVec2; 2], p: DVec2| {
        p != a && p != b && p.cmpge(a.min(b)).all() && p.cmple(a.max(b)).all()
    };
    for end in 0..2 {
        if of_other[end] == 0.0 && lies_inside(one, other[end]) {
            found.push((0, other[end]));
        }
        if of_one[end] == 0.0 && lies_inside(other, one[end]) {
            found.push((1, one[end]));
        }
    }
    let opposite = |[a, b]: [f64; 2]| a > 0.0 && b < 0.0 || a < 0.0 && b > 0.0;
    if opposite(of_other) && opposite(of_one) {
        let share = of_one[0] / (of_one[0] - of_one[1]);
        let point = one[0] + (one[1] - one[0]) * share;
        for (edge, ends) in [one, other].into_iter().enumerate() {
            if !ends.contains(&point) {
                found.push((edge, point));
            }
        }
    }
    found
}

fn inserted(ring: Ring, mut meetings: BTreeMap<usize, Vec<DVec2>>) -> Ring {
    let mut pieces = Vec::with_capacity(ring.pieces.len());
    for (index, piece) in ring.pieces.into_iter().enumerate() {
        let side = piece.side.clone();
        pieces.push(piece);
        if let Some(points) = meetings.remove(&index) {
            let inner =
                points.into_iter().map(|point| Piece { side: side.clone(), ..Piece::line(point) });
            pieces.extend(inner);
        }
    }
    Ring { pieces }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(points: &[[f64; 2]]) -> (Vec<[f64; 2]>, usize) {
        let ring = Ring::of_points(points.iter().copied().map(DVec2::from));
        let (ring, added) = with_vertices(ring);
        (ring.pieces.iter().map(|piece| piece.start.to_array()).collect(), added)
    }

    #[test]
    fn vertices_stand_where_a_ring_meets_itself() {
        for (given, expected, added) in [
            (
                &[[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]][..],
                &[[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]][..],
                0,
            ),
            (
                &[[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 4.0]],
                &[[0.0, 0.0], [2.0, 2.0], [4.0, 4.0], [4.0, 0.0], [2.0, 2.0], [0.0, 4.0]],
                2,
            ),
            // A vertex on an edge.
            (
                &[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 0.0], [0.0, 4.0]],
                &[[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 0.0], [0.0, 4.0]],
                1,
            ),
        ] {
            assert_eq!(points(given), (expected.to_vec(), added));
        }
    }
}
