//! Checks that the rings and lines of a boundary are simple and apart, finds how rings nest, and what lies
//! between them: a sweep from left to right (Shamos and Hoey 1976) with exact predicates.
//!
//! The sweep visits the vertices in the order of x, then of y. The edges that cross the sweep line
//! are kept in the order in which they cross it. Two edges are compared when they become neighbours
//! there. Before any point where edges meet that should not, the first edges to meet are neighbours,
//! so the sweep stops there at the latest and its order never fails. The edge below the leftmost
//! vertex of a ring gives the ring that contains that vertex; the edge below any other edge gives the face
//! between the two.
//!
//! Every decision is a comparison of coordinates or the sign of `robust::orient2d`, which is exact:
//! no decision has a tolerance. O(n log n) time.
//!
//! Limits: reports only the leftmost of several faults. Coordinates must be finite; if a product of
//! two differences is below 1e-290, the sign is that of floating point.

mod edge;

use std::cmp::Ordering;
use std::collections::BTreeSet;
use std::ops::Bound;

pub(super) use edge::side_of;
use edge::{Edge, POINT, from_left};

use super::boundary::PlanarBoundary;
use super::orientation;
use crate::connectivity::disjoint_sets::DisjointSets;

/// A point where rings or lines meet themselves or each other. An edge has the index of
/// [`PlanarBoundary::ends`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Meeting {
    /// Two vertices are at the same point.
    SamePoint([u32; 2]),
    /// A vertex lies inside an edge.
    Touch { vertex: u32, edge: u32 },
    /// Two edges cross inside both.
    Crossing([u32; 2]),
    /// The edges of a ring at a vertex lie on each other.
    FoldsBack(u32),
    /// Two edges from one vertex lie on each other, and one of them is of a line.
    Overlap([u32; 2]),
}

/// The nesting and the direction of a ring.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Nesting {
    pub(super) is_counter_clockwise: bool,
    /// The innermost ring around this one.
    pub(super) parent: Option<usize>,
}

/// The result of a sweep over a valid boundary.
pub(super) struct Swept {
    pub(super) nesting: Vec<Nesting>,
    /// The innermost ring around each edge of a line.
    pub(super) around_segments: Vec<Option<usize>>,
    /// The inner points that no line has, with the innermost ring around each.
    pub(super) around_points: Vec<(u32, Option<usize>)>,
    /// If wanted: the [sides](side_of) of edges, joined where no edge is between them.
    pub(super) sides: Option<DisjointSets>,
}

/// The outside of all rings, as a side.
pub(super) fn outside(boundary: &PlanarBoundary) -> u32 {
    2 * boundary.edge_count()
}

/// The face around an inner point, as a side.
pub(super) fn around_point(boundary: &PlanarBoundary, vertex: u32) -> u32 {
    outside(boundary) + 1 + vertex - boundary.vertex_count()
}

/// Checks a boundary whose rings have at least 3 vertices each, in either direction. O(n log n).
///
/// # Errors
///
/// The first fault from the left.
pub(super) fn swept(boundary: &PlanarBoundary, has_sides: bool) -> Result<Swept, Meeting> {
    let points = boundary.inner_points().len();
    let mut sweep = Sweep {
        boundary,
        spokes: spokes(boundary),
        crossing: BTreeSet::new(),
        nesting: vec![None; boundary.ring_count()],
        around_segments: vec![None; boundary.segments().len()],
        around_points: Vec::new(),
        sides: has_sides.then(|| DisjointSets::new(outside(boundary) as usize + 1 + points)),
    };
    sweep.check_folds()?;
    sweep.check_overlaps()?;
    let mut vertices: Vec<_> = boundary.points.iter().copied().zip(0..).collect();
    vertices.sort_unstable_by(|a, b| from_left(a.0, b.0).then(a.1.cmp(&b.1)));
    if let Some(pair) = vertices.windows(2).find(|pair| pair[0].0 == pair[1].0) {
        return Err(Meeting::SamePoint([pair[0].1, pair[1].1]));
    }
    let (mut ending, mut starting) = (Vec::new(), Vec::new());
    for (_, vertex) in vertices {
        sweep.edges_at(vertex, &mut ending, &mut starting);
        sweep.pass(vertex, &mut ending, &mut starting)?;
    }
    let Sweep { nesting, around_segments, mut around_points, sides, .. } = sweep;
    around_points.sort_unstable();
    let nesting = nesting.into_iter().flatten().collect();
    Ok(Swept { nesting, around_segments, around_points, sides })
}

/// The edges of lines at each vertex, as pairs in ascending order.
fn spokes(boundary: &PlanarBoundary) -> Vec<(u32, u32)> {
    let edges = (boundary.vertex_count()..).zip(boundary.segments());
    let mut spokes: Vec<_> = edges.flat_map(|(edge, ends)| ends.map(|end| (end, edge))).collect();
    spokes.sort_unstable();
    spokes
}

struct Sweep<'a> {
    boundary: &'a PlanarBoundary,
    /// The edges of lines at each vertex.
    spokes: Vec<(u32, u32)>,
    /// The edges that cross the sweep line, from below.
    crossing: BTreeSet<Edge>,
    /// The nesting of each ring that the sweep has met.
    nesting: Vec<Option<Nesting>>,
    around_segments: Vec<Option<usize>>,
    around_points: Vec<(u32, Option<usize>)>,
    sides: Option<DisjointSets>,
}

impl Sweep<'_> {
    fn edge(&self, index: u32) -> Edge {
        let [from, to] = self.boundary.ends(index).map(|vertex| self.boundary.point(vertex));
        let is_rightward = from_left(from, to) == Ordering::Less;
        let (left, right) = if is_rightward { (from, to) } else { (to, from) };
        Edge { left, right, index, is_rightward }
    }

    fn is_on_ring(&self, vertex: u32) -> bool {
        vertex < self.boundary.vertex_count()
    }

    /// The edges of lines at a vertex.
    fn spokes_at(&self, vertex: u32) -> &[(u32, u32)] {
        let from = self.spokes.partition_point(|&(end, _)| end < vertex);
        let count = self.spokes[from..].partition_point(|&(end, _)| end == vertex);
        &self.spokes[from..from + count]
    }

    /// The edges that end at a vertex, coming from the left, and those that start there.
    fn edges_at(&self, vertex: u32, ending: &mut Vec<Edge>, starting: &mut Vec<Edge>) {
        ending.clear();
        starting.clear();
        let at = self.boundary.point(vertex);
        let mut take = |index: u32| {
            let edge = self.edge(index);
            if edge.left == at { starting.push(edge) } else { ending.push(edge) }
        };
        if self.is_on_ring(vertex) {
            [self.boundary.previous(vertex), vertex].into_iter().for_each(&mut take);
        }
        self.spokes_at(vertex).iter().for_each(|&(_, edge)| take(edge));
    }

    /// Checks that no edge of a ring lies on the previous one. Later steps rely on that.
    fn check_folds(&self) -> Result<(), Meeting> {
        let folds = |&vertex: &u32| {
            let around = [self.boundary.previous(vertex), vertex, self.boundary.next(vertex)];
            let [before, at, after] = around.map(|vertex| self.boundary.point(vertex));
            let side = from_left(at, before);
            side == from_left(at, after)
                && side != Ordering::Equal
                && orientation(at, before, after) == 0.0
        };
        match (0..self.boundary.vertex_count()).find(folds) {
            Some(vertex) => Err(Meeting::FoldsBack(vertex)),
            None => Ok(()),
        }
    }

    /// Checks that no edge of a line lies on another edge from the same vertex.
    fn check_overlaps(&self) -> Result<(), Meeting> {
        let (mut ending, mut starting) = (Vec::new(), Vec::new());
        for same in self.spokes.chunk_by(|a, b| a.0 == b.0) {
            let at = self.boundary.point(same[0].0);
            self.edges_at(same[0].0, &mut ending, &mut starting);
            for edges in [&mut ending, &mut starting] {
                let far = |edge: &Edge| if edge.left == at { edge.right } else { edge.left };
                let turn = |a: &Edge, b: &Edge| orientation(at, far(a), far(b));
                let order = |a: &Edge, b: &Edge| 0.0.partial_cmp(&turn(a, b));
                edges.sort_by(|a, b| order(a, b).unwrap_or(Ordering::Equal));
                if let Some(pair) = edges.windows(2).find(|pair| turn(&pair[0], &pair[1]) == 0.0) {
                    let [a, b] = [pair[0].index, pair[1].index];
                    return Err(Meeting::Overlap([a.min(b), a.max(b)]));
                }
            }
        }
        Ok(())
    }

    fn pass(
        &mut self,
        vertex: u32,
        ending: &mut [Edge],
        starting: &mut [Edge],
    ) -> Result<(), Meeting> {
        for edge in &*ending {
            self.crossing.remove(edge);
        }
        self.crossing.extend(starting.iter().copied());
        for edge in &*starting {
            self.check_neighbours(edge)?;
        }
        starting.sort_unstable();
        for edge in &*starting {
            self.place(edge);
        }
        if let ([edge, ..], []) = (&*ending, &*starting)
            && let [Some(below), Some(above)] = self.neighbours(edge)
        {
            self.check(&below, &above)?;
        }
        self.join_sides(ending, starting);
        if ending.is_empty() && starting.is_empty() { self.place_point(vertex) } else { Ok(()) }
    }

    /// The edges below and above an edge, which itself need not be in the list.
    fn neighbours(&self, edge: &Edge) -> [Option<Edge>; 2] {
        let below = self.crossing.range((Bound::Unbounded, Bound::Excluded(edge))).next_back();
        let above = self.crossing.range((Bound::Excluded(edge), Bound::Unbounded)).next();
        [below, above].map(Option::<&Edge>::copied)
    }

    fn check_neighbours(&self, edge: &Edge) -> Result<(), Meeting> {
        let neighbours = self.neighbours(edge);
        neighbours.iter().flatten().try_for_each(|other| self.check(edge, other))
    }

    /// Finds what is below an edge that starts, where that is not known. Of edges that start at one vertex,
    /// the lowest comes first.
    fn place(&mut self, edge: &Edge) {
        let segment = edge.index.checked_sub(self.boundary.vertex_count());
        let ring = match segment {
            None => Some(self.boundary.in_ring(edge.index).ring),
            Some(_) => None,
        };
        if ring.is_some_and(|ring| self.nesting[ring].is_some()) && self.sides.is_none() {
            return;
        }
        let below = self.neighbours(edge)[0];
        let around = self.around(below);
        if let Some(segment) = segment {
            self.around_segments[segment as usize] = around;
        }
        if let Some(ring) = ring {
            // At its leftmost vertex, a ring's lower edge runs to the right if the ring is counter-clockwise.
            let is_counter_clockwise = edge.is_rightward;
            self.nesting[ring].get_or_insert(Nesting { is_counter_clockwise, parent: around });
        }
        let outside = outside(self.boundary);
        if let Some(sides) = &mut self.sides {
            sides.join(edge.below(), below.map_or(outside, |below| below.above()));
        }
    }

    /// The innermost ring around what is right above an edge, or below all edges.
    fn around(&self, below: Option<Edge>) -> Option<usize> {
        let below = below?;
        if let Some(segment) = below.index.checked_sub(self.boundary.vertex_count()) {
            return self.around_segments[segment as usize];
        }
        let ring = self.boundary.in_ring(below.index).ring;
        // The sweep met the ring before.
        let Nesting { is_counter_clockwise, parent } = self.nesting[ring]?;
        if below.is_rightward == is_counter_clockwise { Some(ring) } else { parent }
    }

    /// Finds what is around a point that no edge has, and checks that it is on none.
    fn place_point(&mut self, vertex: u32) -> Result<(), Meeting> {
        let at = self.boundary.point(vertex);
        let point = Edge { left: at, right: at, index: POINT, is_rightward: true };
        let [below, above] = self.neighbours(&point);
        let touches =
            |edge: &&Edge| orientation(edge.left, edge.right, at) == 0.0 && edge.spans(at);
        if let Some(edge) = below.iter().chain(&above).find(touches) {
            return Err(Meeting::Touch { vertex, edge: edge.index });
        }
        self.around_points.push((vertex, self.around(below)));
        let (outside, side) = (outside(self.boundary), around_point(self.boundary, vertex));
        if let Some(sides) = &mut self.sides {
            sides.join(side, below.map_or(outside, |below| below.above()));
        }
        Ok(())
    }

    /// Joins the sides between the edges at one vertex.
    fn join_sides(&mut self, ending: &mut [Edge], starting: &[Edge]) {
        let Some(sides) = &mut self.sides else { return };
        ending.sort_unstable();
        for pair in ending.windows(2) {
            sides.join(pair[0].above(), pair[1].below());
        }
        match (&*ending, starting) {
            ([low, .., high], []) | ([], [low, .., high]) => sides.join(low.below(), high.above()),
            ([edge], []) | ([], [edge]) => sides.join(edge.below(), edge.above()),
            ([low, ..], [lowest, ..]) => {
                sides.join(low.below(), lowest.below());
                let [high, highest] = [ending, starting].map(|edges| edges[edges.len() - 1]);
                sides.join(high.above(), highest.above());
            }
            ([], []) => {}
        }
    }

    /// Checks that two edges have no common point, except a vertex of both.
    fn check(&self, a: &Edge, b: &Edge) -> Result<(), Meeting> {
        let [ends_of_a, ends_of_b] = [a, b].map(|edge| self.boundary.ends(edge.index));
        if ends_of_a.iter().any(|end| ends_of_b.contains(end)) {
            return Ok(());
        }
        let sides_of = |edge: &Edge, ends: [u32; 2]| {
            ends.map(|end| orientation(edge.left, edge.right, self.boundary.point(end)))
        };
        let (around_b, around_a) = (sides_of(b, ends_of_a), sides_of(a, ends_of_b));
        for (edge, ends, sides) in [(a, ends_of_b, around_a), (b, ends_of_a, around_b)] {
            for (vertex, side) in ends.into_iter().zip(sides) {
                if side == 0.0 && edge.spans(self.boundary.point(vertex)) {
                    return Err(Meeting::Touch { vertex, edge: edge.index });
                }
            }
        }
        let are_apart = |[first, second]: [f64; 2]| (first > 0.0) == (second > 0.0);
        if are_apart(around_a) || are_apart(around_b) {
            return Ok(());
        }
        let edges = [a.index.min(b.index), a.index.max(b.index)];
        Err(Meeting::Crossing(edges))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;
    use proptest::prelude::*;

    fn of(rings: &[&[[i32; 2]]]) -> Result<Vec<Nesting>, Meeting> {
        swept(&boundary(rings), false).map(|swept| swept.nesting)
    }

    fn boundary(rings: &[&[[i32; 2]]]) -> PlanarBoundary {
        let point = |&[x, y]: &[i32; 2]| DVec2::new(x.into(), y.into());
        let rings = rings.iter().map(|ring| ring.iter().map(point).collect::<Vec<_>>());
        PlanarBoundary::of_mesh(&rings.collect::<Vec<_>>())
    }

    const SQUARE: [[i32; 2]; 4] = [[0, 0], [9, 0], [9, 9], [0, 9]];

    #[test]
    fn tells_how_rings_nest() {
        let small = |x: i32, y: i32| [[x, y], [x + 1, y + 1], [x + 1, y]];
        let inner = [[3, 3], [7, 3], [7, 7], [3, 7]];
        let found = of(&[&SQUARE, &small(1, 1), &inner, &small(4, 4), &small(20, 4), &small(1, 7)]);
        let ring = |is_counter_clockwise, parent| Nesting { is_counter_clockwise, parent };
        let clockwise = |parent| ring(false, parent);
        assert_eq!(
            found.unwrap(),
            [
                ring(true, None),
                clockwise(Some(0)),
                ring(true, Some(0)),
                clockwise(Some(2)),
                clockwise(None),
                clockwise(Some(0)),
            ]
        );
    }

    #[test]
    fn names_what_is_wrong() {
        let cases: &[(&[&[[i32; 2]]], Meeting)] = &[
            (&[&[[0, 0], [2, 2], [2, 0], [0, 2]]], Meeting::Crossing([0, 2])),
            (&[&[[0, 0], [4, 0], [4, 4], [2, 0], [0, 2]]], Meeting::Touch { vertex: 3, edge: 0 }),
            (&[&[[0, 0], [4, 0], [4, 4], [4, 0], [0, 4]]], Meeting::FoldsBack(2)),
            (&[&[[0, 0], [4, 0], [4, 4], [3, 4], [4, 0], [0, 4]]], Meeting::SamePoint([1, 4])),
            (&[&[[0, 0], [4, 0], [2, 0], [0, 2]]], Meeting::FoldsBack(1)),
            (&[&[[0, 0], [4, 0], [9, 0], [0, 2], [0, 5]]], Meeting::FoldsBack(4)),
            (&[&[[0, 0], [0, 9], [0, 4], [-3, 4]]], Meeting::FoldsBack(1)),
            (&[&[[0, 0], [3, 0], [9, 0]]], Meeting::FoldsBack(0)),
            (&[&SQUARE, &[[2, 9], [3, 5], [5, 5]]], Meeting::Touch { vertex: 4, edge: 2 }),
            (&[&SQUARE, &[[2, 2], [9, 9], [9, 12]]], Meeting::SamePoint([2, 5])),
            (&[&SQUARE, &[[0, 0], [0, 9], [-9, 9]]], Meeting::SamePoint([0, 4])),
            (&[&SQUARE, &[[0, 2], [0, 7], [-9, 9]]], Meeting::Touch { vertex: 4, edge: 3 }),
            (&[&SQUARE, &[[8, 8], [8, 4], [11, 4]]], Meeting::Crossing([1, 5])),
        ];
        for (rings, fault) in cases {
            assert_eq!(of(rings), Err(*fault), "{rings:?}");
        }
    }

    #[test]
    fn the_smallest_gap_is_enough() {
        // A tooth whose tip is one unit in the last place from the side below it.
        let tip =
            |y: f64| [[0.0, 0.0], [1.0, 0.1], [1.0, 1.0], [0.5, y], [0.0, 1.0]].map(DVec2::from);
        let below = DVec2::new(0.5, 0.05);

        let check =
            |y: f64| swept(&PlanarBoundary::of_mesh(&[tip(y)]), false).map(|swept| swept.nesting);
        assert_eq!(orientation(DVec2::ZERO, DVec2::new(1.0, 0.1), below), 0.0);
        assert!(check(below.y.next_up()).is_ok());
        assert_eq!(check(below.y), Err(Meeting::Touch { vertex: 3, edge: 0 }));
        assert_eq!(check(below.y.next_down()), Err(Meeting::Crossing([0, 3])));
    }

    /// By the definition: every pair of edges, every pair of vertices, in exact integers.
    fn is_simple(points: &[[i32; 2]], edges: &[[u32; 2]]) -> bool {
        let area = |[a, b, c]: [[i32; 2]; 3]| {
            i64::from(b[0] - a[0]) * i64::from(c[1] - a[1])
                - i64::from(b[1] - a[1]) * i64::from(c[0] - a[0])
        };
        let within = |a: [i32; 2], b: [i32; 2], c: [i32; 2]| {
            (0..2).all(|i| a[i].min(b[i]) <= c[i] && c[i] <= a[i].max(b[i]))
        };
        let at = |v: u32| points[v as usize];
        for (i, &[a, b]) in edges.iter().enumerate() {
            for (j, &[c, d]) in edges.iter().enumerate() {
                if i == j {
                    continue;
                }
                let [a, b, c, d] = [a, b, c, d].map(|v| (v, at(v)));
                // An end of one edge on the other, unless it is the same vertex.
                if c.0 != a.0 && c.0 != b.0 && area([a.1, b.1, c.1]) == 0 && within(a.1, b.1, c.1) {
                    return false;
                }
                let sides =
                    |p: [i32; 2], q, r, s| area([p, q, r]).signum() * area([p, q, s]).signum();
                if sides(a.1, b.1, c.1, d.1) < 0 && sides(c.1, d.1, a.1, b.1) < 0 {
                    return false;
                }
            }
        }
        true
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]

        /// On a small grid most rings touch or cross themselves, and all degenerate cases come up.
        #[test]
        fn agrees_with_the_definition(
            rings in prop::collection::vec(prop::collection::vec([0..7_i32, 0..7], 3..6), 1..3),
        ) {
            let boundary = boundary(&rings.iter().map(Vec::as_slice).collect::<Vec<_>>());
            let found = swept(&boundary, false).map(|swept| swept.nesting);
            let all: Vec<[i32; 2]> = rings.concat();
            prop_assert_eq!(found.is_ok(), is_simple(&all, &Vec::from_iter(boundary.edges())), "{:?}", found);
            if let Ok(found) = found {
                for (ring, nesting) in rings.iter().zip(found) {
                    let area: i32 = (0..ring.len())
                        .map(|i| (ring[i], ring[(i + 1) % ring.len()]))
                        .map(|(a, b)| a[0] * b[1] - a[1] * b[0])
                        .sum();
                    prop_assert_eq!(nesting.is_counter_clockwise, area > 0);
                }
            }
        }
    }
}
