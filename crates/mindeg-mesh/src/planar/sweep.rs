//! Checks that rings of points are simple and apart, and finds how they nest: a sweep from left to
//! right (Shamos and Hoey 1976) with exact predicates.
//!
//! The sweep visits the vertices in the order of x, then of y. The edges that cross the sweep line
//! are kept in the order in which they cross it. Two edges are compared when they become neighbours
//! there. Before any point where edges meet that should not, the first edges to meet are neighbours,
//! so the sweep stops there at the latest and its order never fails. The edge below the leftmost
//! vertex of a ring gives the ring that contains that vertex.
//!
//! Every decision is a comparison of coordinates or the sign of `robust::orient2d`, which is exact:
//! no decision has a tolerance. O(n log n) time.
//!
//! Limits: reports only the leftmost of several faults. Coordinates must be finite; if a product of
//! two differences is below 1e-290, the sign is that of floating point.

use std::cmp::Ordering;
use std::collections::BTreeSet;
use std::ops::Bound;

use glam::DVec2;

use super::boundary::PlanarBoundary;
use super::orientation;

/// A point where rings meet themselves or each other. An edge is named by its first vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Meeting {
    /// Two vertices are at the same point.
    SamePoint([u32; 2]),
    /// A vertex lies inside an edge.
    Touch { vertex: u32, edge: u32 },
    /// Two edges cross inside both.
    Crossing([u32; 2]),
    /// The edges at a vertex lie on each other.
    FoldsBack(u32),
}

/// The nesting and the direction of a ring.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Nesting {
    pub(super) is_counter_clockwise: bool,
    /// The innermost ring around this one.
    pub(super) parent: Option<usize>,
}

/// Checks rings of points, each of at least 3 vertices, and returns their nesting. O(n log n).
///
/// # Errors
///
/// The first fault from the left.
pub(super) fn nesting(boundary: &PlanarBoundary) -> Result<Vec<Nesting>, Meeting> {
    let nesting = vec![None; boundary.ring_count()];
    let mut sweep = Sweep { boundary, crossing: BTreeSet::new(), nesting };
    sweep.check_folds()?;
    let mut vertices: Vec<_> = boundary.points().iter().copied().zip(0..).collect();
    vertices.sort_unstable_by(|a, b| from_left(a.0, b.0).then(a.1.cmp(&b.1)));
    if let Some(pair) = vertices.windows(2).find(|pair| pair[0].0 == pair[1].0) {
        return Err(Meeting::SamePoint([pair[0].1, pair[1].1]));
    }
    for (_, vertex) in vertices {
        sweep.pass(vertex)?;
    }
    let known = sweep.nesting.into_iter().flatten();
    Ok(known.collect())
}

/// The order in which the sweep passes points.
fn from_left(a: DVec2, b: DVec2) -> Ordering {
    let order = |a: f64, b: f64| a.partial_cmp(&b).unwrap_or(Ordering::Equal);
    order(a.x, b.x).then(order(a.y, b.y))
}

/// An edge that crosses the sweep line.
#[derive(Clone, Copy, Debug)]
struct Edge {
    left: DVec2,
    right: DVec2,
    /// The vertex where it begins, at either end.
    begin: u32,
    /// Whether the edge begins at its left end.
    is_rightward: bool,
}

/// From below, where both edges cross the sweep line. Edges that overlap are in any order.
impl Ord for Edge {
    fn cmp(&self, other: &Self) -> Ordering {
        if self.begin == other.begin {
            return Ordering::Equal;
        }
        if from_left(self.left, other.left) == Ordering::Greater {
            return other.cmp(self).reverse();
        }
        let above = |point| orientation(self.left, self.right, point);
        let mut side = 0.0;
        if self.left != other.left {
            side = above(other.left);
        }
        if side == 0.0 {
            side = above(other.right);
        }
        // An edge is below another edge that lies to its left.
        0.0.partial_cmp(&side).unwrap_or(Ordering::Equal).then(self.begin.cmp(&other.begin))
    }
}

impl PartialOrd for Edge {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Edge {
    fn eq(&self, other: &Self) -> bool {
        self.begin == other.begin
    }
}

impl Eq for Edge {}

struct Sweep<'a> {
    boundary: &'a PlanarBoundary,
    /// The edges that cross the sweep line, from below.
    crossing: BTreeSet<Edge>,
    /// The nesting of each ring that the sweep has met.
    nesting: Vec<Option<Nesting>>,
}

impl Sweep<'_> {
    /// The edge that begins at a vertex.
    fn edge(&self, begin: u32) -> Edge {
        let (from, to) =
            (self.boundary.point(begin), self.boundary.point(self.boundary.next(begin)));
        let is_rightward = from_left(from, to) == Ordering::Less;
        let (left, right) = if is_rightward { (from, to) } else { (to, from) };
        Edge { left, right, begin, is_rightward }
    }

    /// Checks that no edge lies on the previous one. Later steps rely on that.
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

    fn pass(&mut self, vertex: u32) -> Result<(), Meeting> {
        let [before, after] =
            [self.boundary.previous(vertex), vertex].map(|begin| self.edge(begin));
        match (before.is_rightward, after.is_rightward) {
            (true, true) => self.replace(before, after),
            (false, false) => self.replace(after, before),
            (true, false) => {
                self.crossing.remove(&before);
                self.crossing.remove(&after);
                match self.neighbours(&before) {
                    [Some(below), Some(above)] => self.check(&below, &above),
                    _ => Ok(()),
                }
            }
            (false, true) => {
                self.crossing.insert(before);
                self.crossing.insert(after);
                self.check_neighbours(&before)?;
                self.check_neighbours(&after)?;
                self.place_ring(vertex, before, after);
                Ok(())
            }
        }
    }

    /// An edge ends where another begins.
    fn replace(&mut self, old: Edge, new: Edge) -> Result<(), Meeting> {
        self.crossing.remove(&old);
        self.crossing.insert(new);
        self.check_neighbours(&new)
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

    /// Finds the parent and the direction of a ring, from its leftmost vertex.
    fn place_ring(&mut self, vertex: u32, before: Edge, after: Edge) {
        let ring = self.boundary.in_ring(vertex).ring;
        if self.nesting[ring].is_some() {
            return;
        }
        let is_counter_clockwise = after < before;
        let lower = if is_counter_clockwise { after } else { before };
        let parent = self.neighbours(&lower)[0].and_then(|below| {
            let around = self.boundary.in_ring(below.begin).ring;
            // The sweep met the surrounding ring before.
            let Nesting { is_counter_clockwise, parent } = self.nesting[around]?;
            if below.is_rightward == is_counter_clockwise { Some(around) } else { parent }
        });
        self.nesting[ring] = Some(Nesting { is_counter_clockwise, parent });
    }

    /// Checks that two edges have no common point, except the vertex between consecutive edges.
    fn check(&self, a: &Edge, b: &Edge) -> Result<(), Meeting> {
        let [ends_of_a, ends_of_b] =
            [a, b].map(|edge| [edge.begin, self.boundary.next(edge.begin)]);
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
                    return Err(Meeting::Touch { vertex, edge: edge.begin });
                }
            }
        }
        let are_apart = |[first, second]: [f64; 2]| (first > 0.0) == (second > 0.0);
        if are_apart(around_a) || are_apart(around_b) {
            return Ok(());
        }
        let edges = [a.begin.min(b.begin), a.begin.max(b.begin)];
        Err(Meeting::Crossing(edges))
    }
}

impl Edge {
    /// Whether a point on the line through the edge lies on the edge.
    fn spans(&self, point: DVec2) -> bool {
        from_left(self.left, point) != Ordering::Greater
            && from_left(point, self.right) != Ordering::Greater
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn of(rings: &[&[[i32; 2]]]) -> Result<Vec<Nesting>, Meeting> {
        nesting(&boundary(rings))
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

        let check = |y: f64| nesting(&PlanarBoundary::of_mesh(&[tip(y)]));
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
            let found = nesting(&boundary);
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
