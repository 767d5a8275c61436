//! Where straight edges meet: vertices on both, until edges meet at their ends alone.
//!
//! The plane is cut into strips, and each is swept from left to right. Whether edges meet is decided
//! exactly; the point where they cross is rounded, which may make further crossings, so that the edges
//! are looked at again.

use std::collections::BTreeMap;

use glam::DVec2;
use mindeg_mesh::planar::orientation;

use super::super::text::shown;
use super::super::vertices::Vertices;
use super::edge::Edge;

/// The most comparisons of two edges, which take some seconds.
pub(in super::super) const MOST_COMPARISONS: u64 = 1_000_000_000;

/// How many comparisons a point costs, which takes memory, too.
const COST_OF_POINT: u64 = 100;

/// The most rounds over rounded crossings. Two or three rounds suffice for nearly all input.
const ROUNDS: usize = 40;

/// The edges with a vertex wherever two of them meet, and how many were added.
pub(in super::super) fn parted(
    mut edges: Vec<Edge>,
    vertices: &mut Vertices,
) -> Result<(Vec<Edge>, usize), String> {
    let mut added = 0;
    let mut budget = MOST_COMPARISONS;
    let mut near = DVec2::ZERO;
    for _ in 0..ROUNDS {
        let meetings = meetings(&edges, &vertices.points, &mut budget)?;
        let Some(&first) = meetings.values().flatten().next() else { return Ok((edges, added)) };
        near = first;
        edges = with_vertices(edges, meetings, vertices, &mut added);
    }
    Err(format!(
        "edges cross nearer to each other than 64-bit floats, about {}; simplify the outline there",
        shown(near)
    ))
}

/// The points to insert into each edge, in any order.
pub(in super::super) type Meetings = BTreeMap<usize, Vec<DVec2>>;

pub(in super::super) fn meetings(
    edges: &[Edge],
    points: &[DVec2],
    budget: &mut u64,
) -> Result<Meetings, String> {
    let ends: Vec<[DVec2; 2]> =
        edges.iter().map(|edge| edge.ends.map(|end| points[end as usize])).collect();
    let low = |edge: usize| ends[edge][0].min(ends[edge][1]);
    let high = |edge: usize| ends[edge][0].max(ends[edge][1]);
    let bottom = (0..ends.len()).map(|edge| low(edge).y).fold(f64::INFINITY, f64::min);
    let top = (0..ends.len()).map(|edge| high(edge).y).fold(f64::NEG_INFINITY, f64::max);
    let sum: f64 = (0..ends.len()).map(|edge| high(edge).y - low(edge).y).sum();
    // So many strips that each edge lies in four of them or fewer, on average.
    let most = (ends.len() as f64).sqrt().min(3.0 * ends.len() as f64 * (top - bottom) / sum);
    let count = if most >= 1.0 { most as usize } else { 1 };
    let strip = |y: f64| ((y - bottom) / (top - bottom) * count as f64) as usize;
    // Of edges that run alike, as many do where spikes lie on each other, one is compared.
    let mut first = BTreeMap::new();
    let first: Vec<usize> =
        (0..).zip(edges).map(|(edge, it)| *first.entry(it.ends).or_insert(edge)).collect();
    let mut order: Vec<(usize, usize)> = (0..ends.len())
        .filter(|&edge| first[edge] == edge)
        .flat_map(|edge| (strip(low(edge).y)..=strip(high(edge).y)).map(move |at| (at, edge)))
        .collect();
    order.sort_by(|a, b| {
        (a.0.cmp(&b.0)).then(low(a.1).x.total_cmp(&low(b.1).x)).then(a.1.cmp(&b.1))
    });
    let mut meetings = Meetings::new();
    for (at, &(own, one)) in order.iter().enumerate() {
        let right = high(one).x;
        for &(other_strip, other) in &order[at + 1..] {
            *budget = budget.checked_sub(1).ok_or_else(too_many)?;
            if other_strip != own || low(other).x > right {
                break;
            }
            let from = low(one).y.max(low(other).y);
            // Two edges may lie in several strips together.
            if from <= high(one).y.min(high(other).y) && strip(from) == own {
                for (which, point) in meeting(ends[one], ends[other]) {
                    *budget = budget.checked_sub(COST_OF_POINT).ok_or_else(too_many)?;
                    meetings.entry([one, other][which]).or_default().push(point);
                }
            }
        }
    }
    for edge in (0..ends.len()).filter(|&edge| first[edge] != edge) {
        if let Some(points) = meetings.get(&first[edge]).cloned() {
            let cost = COST_OF_POINT.saturating_mul(points.len() as u64);
            *budget = budget.checked_sub(cost).ok_or_else(too_many)?;
            meetings.insert(edge, points);
        }
    }
    Ok(meetings)
}

fn too_many() -> String {
    "more edges lie above each other than can be compared in some seconds; simplify the outline"
        .into()
}

/// The points that two edges have in common, but for ends of both: each with the edge, 0 or 1, that
/// lacks it.
pub(in super::super) fn meeting(one: [DVec2; 2], other: [DVec2; 2]) -> Vec<(usize, DVec2)> {
    let side = |[a, b]: [DVec2; 2], p: DVec2| orientation(a, b, p);
    let of_other = other.map(|end| side(one, end));
    let opposite = |[a, b]: [f64; 2]| a > 0.0 && b < 0.0 || a < 0.0 && b > 0.0;
    let beside = |[a, b]: [f64; 2]| a > 0.0 && b > 0.0 || a < 0.0 && b < 0.0;
    if beside(of_other) {
        return Vec::new();
    }
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
    if opposite(of_other) && opposite(of_one) {
        let share = of_one[0] / (of_one[0] - of_one[1]);
        let point = one[0] + (one[1] - one[0]) * share;
        // Rounding leaves the box of neither edge.
        let low = one[0].min(one[1]).max(other[0].min(other[1]));
        let high = one[0].max(one[1]).min(other[0].max(other[1]));
        let point = point.max(low).min(high);
        for (edge, ends) in [one, other].into_iter().enumerate() {
            if !ends.contains(&point) {
                found.push((edge, point));
            }
        }
    }
    found
}

/// The edges with vertices at points inside them; counts these.
pub(in super::super) fn with_vertices(
    edges: Vec<Edge>,
    mut meetings: Meetings,
    vertices: &mut Vertices,
    added: &mut usize,
) -> Vec<Edge> {
    let mut parts = Vec::with_capacity(edges.len() + meetings.len());
    for (index, edge) in edges.into_iter().enumerate() {
        let mut points = meetings.remove(&index).unwrap_or_default();
        let start = vertices.points[edge.ends[0] as usize];
        let distance = |point: &DVec2| (*point - start).length_squared();
        points.sort_by(|a, b| {
            (distance(a).total_cmp(&distance(b)))
                .then(a.x.total_cmp(&b.x))
                .then(a.y.total_cmp(&b.y))
        });
        // Two edges that end at a vertex both find it on a third.
        points.dedup();
        *added += points.len();
        let mut from = edge.ends[0];
        for end in points.into_iter().map(|point| vertices.index_near(point)).chain([edge.ends[1]])
        {
            if from != end {
                parts.push(Edge { ends: [from, end], ..edge });
            }
            from = end;
        }
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Spikes on a line once took a minute: in the second round each piece met all that lie on it.
    #[test]
    fn edges_that_run_alike_are_compared_once() {
        let points = [0.0, 1.0, 2.0, 0.5].map(|x| DVec2::new(x, 0.0));
        let edge = |ends| Edge { ends, chord: 0 };
        let edges =
            [vec![edge([0, 1]); 1000], vec![edge([1, 2]); 1000], vec![edge([0, 3])]].concat();
        let mut budget = 1000 * COST_OF_POINT + 100;
        let meetings = meetings(&edges, &points, &mut budget).unwrap();
        assert_eq!(meetings.len(), 1000);
        assert!((0..1000).all(|edge| meetings[&edge] == [points[3]]));
    }
}
