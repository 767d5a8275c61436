//! Two solvers that are slow and plainly right, and the problems they are given.

use glam::DVec2;
use mindeg_core::{Boundary, verify};
use mindeg_exact::{Optimum, Problem, measure};
use proptest::prelude::*;
use std::cmp::Reverse;
use std::collections::BTreeMap;

/// A problem whose parts the slow solvers can read.
#[derive(Clone, Debug)]
pub(crate) struct Instance {
    pub(crate) sides: Vec<u64>,
    pub(crate) boundary: Boundary,
    pub(crate) points: Vec<DVec2>,
    pub(crate) outside: Vec<u32>,
    pub(crate) own_limits: Vec<Option<u32>>,
}

/// The order of triangulations: the tangent of the minimum angle, the number of
/// vertices at their limit, the sum of shapes.
pub(crate) type Rank = (f64, Reverse<u32>, u64);

impl Instance {
    pub(crate) fn new(sides: &[u64], points: Vec<DVec2>) -> Self {
        let boundary = Boundary::new(sides).unwrap();
        let (outside, own_limits) = (vec![0; points.len()], vec![None; points.len()]);
        Self { sides: sides.to_vec(), boundary, points, outside, own_limits }
    }

    /// A polygon with these corners, the intervals of each side equal.
    pub(crate) fn uniform(corners: &[DVec2], sides: &[u64]) -> Self {
        Self::spaced(corners, sides, |_, place| place)
    }

    /// Points at `spacing(vertex, place)` of their side, where uniform spacing has `place`.
    pub(crate) fn spaced(
        corners: &[DVec2],
        sides: &[u64],
        spacing: impl Fn(usize, f64) -> f64,
    ) -> Self {
        let mut points = Vec::new();
        for (side, &intervals) in sides.iter().enumerate() {
            let (from, to) = (corners[side], corners[(side + 1) % corners.len()]);
            for step in 0..intervals {
                let place = spacing(points.len(), step as f64 / intervals as f64);
                points.push(from + (to - from) * place);
            }
        }
        Self::new(sides, points)
    }

    pub(crate) fn problem(&self) -> Problem {
        let mut problem = Problem::new(&self.boundary, &self.points).unwrap();
        for (vertex, (&outside, &own_limit)) in (0..).zip(self.outside.iter().zip(&self.own_limits))
        {
            problem.set_external_degree(vertex, outside);
            if let Some(limit) = own_limit {
                problem.set_degree_limit(vertex, limit);
            }
        }
        problem
    }

    fn corners(&self, triangle: [u32; 3]) -> [DVec2; 3] {
        triangle.map(|vertex| self.points[vertex as usize])
    }

    fn limit(&self, vertex: usize, max_degree: u32) -> u32 {
        self.own_limits[vertex].map_or(max_degree, |own| own.min(max_degree))
    }

    /// The rank of a triangulation given by its triangles, if it keeps the limits.
    pub(crate) fn rank(&self, triangles: &[[u32; 3]], max_degree: u32) -> Option<Rank> {
        let degrees = verify(&self.sides, triangles.iter().copied()).unwrap().degrees;
        let mut full = 0;
        for (vertex, (degree, outside)) in degrees.iter().zip(&self.outside).enumerate() {
            let limit = self.limit(vertex, max_degree);
            if degree + outside > limit {
                return None;
            }
            full += u32::from(degree + outside == limit);
        }
        let corners = |triangle: &[u32; 3]| self.corners(*triangle);
        let tangents = triangles.iter().map(|t| measure::min_angle_tangent(corners(t)));
        let shapes = triangles.iter().map(|t| measure::shape(corners(t)));
        Some((tangents.fold(f64::INFINITY, f64::min), Reverse(full), shapes.sum()))
    }

    /// The rank of the best of all triangulations, one after the other.
    pub(crate) fn best_of_all(&self, max_degree: u32) -> Option<Rank> {
        let mut best = None;
        let ring = vec![(0, self.boundary.vertex_count() - 1)];
        self.visit_all(ring, &mut Vec::new(), &mut |triangles| {
            let rank = self.rank(triangles, max_degree);
            if rank > best {
                best = rank;
            }
        });
        best
    }

    /// Calls `visit` for every way to triangulate what is beneath the open edges.
    fn visit_all(
        &self,
        mut open: Vec<(u32, u32)>,
        triangles: &mut Vec<[u32; 3]>,
        visit: &mut impl FnMut(&[[u32; 3]]),
    ) {
        let Some((i, j)) = open.pop() else { return visit(triangles) };
        if j == i + 1 {
            return self.visit_all(open, triangles, visit);
        }
        for apex in i + 1..j {
            if !self.boundary.is_flat([i, apex, j]) {
                let mut open = open.clone();
                open.extend([(i, apex), (apex, j)]);
                triangles.push([i, apex, j]);
                self.visit_all(open, triangles, visit);
                triangles.pop();
            }
        }
    }

    /// The rank of the best triangulation, by dynamic programming: first the largest minimum
    /// angle for every pair of end degrees, then the best of those that have the angle found.
    pub(crate) fn best_by_table(&self, max_degree: u32) -> Option<Rank> {
        let angle = |left: f64, right: f64, triangle, _| {
            Some(left.min(right).min(measure::min_angle_tangent(self.corners(triangle))))
        };
        let tangent = self.best_in_table(max_degree, f64::INFINITY, angle, |rank, _| rank)?;

        let none = (Reverse(0), 0);
        let full = |(Reverse(full), shape): (Reverse<u32>, u64), is_full| {
            (Reverse(full + u32::from(is_full)), shape)
        };
        let tie = |(Reverse(full_left), left), (Reverse(full_right), right), triangle, is_full| {
            let corners = self.corners(triangle);
            let shape = left + right + measure::shape(corners);
            let rank = full((Reverse(full_left + full_right), shape), is_full);
            (measure::min_angle_tangent(corners) >= tangent).then_some(rank)
        };
        let (full, shape) = self.best_in_table(max_degree, none, tie, full)?;
        Some((tangent, full, shape))
    }

    /// The best rank of the whole, where `join` makes a piece's rank of two pieces, their
    /// triangle, and whether its apex is at its limit, and `close` counts the last two vertices.
    fn best_in_table<R: Copy + PartialOrd>(
        &self,
        max_degree: u32,
        empty: R,
        join: impl Fn(R, R, [u32; 3], bool) -> Option<R>,
        close: impl Fn(R, bool) -> R,
    ) -> Option<R> {
        let n = self.points.len();
        // Chords allowed, below 0 where there are too many edges already.
        let capacity = |vertex: usize| {
            i64::from(self.limit(vertex, max_degree)) - 2 - i64::from(self.outside[vertex])
        };
        let mut table = BTreeMap::<(usize, usize), BTreeMap<(i64, i64), R>>::new();
        for span in 1..n {
            for i in 0..n - span {
                let j = i + span;
                if span == 1 {
                    table.insert((i, j), BTreeMap::from([((0, 0), empty)]));
                    continue;
                }
                let mut piece = BTreeMap::new();
                for apex in i + 1..j {
                    let triangle = [i, apex, j].map(|vertex| vertex as u32);
                    if self.boundary.is_flat(triangle) {
                        continue;
                    }
                    let left_edge = i64::from(apex - i > 1);
                    let right_edge = i64::from(j - apex > 1);
                    for (&(at_i, at_left), &left) in &table[&(i, apex)] {
                        for (&(at_right, at_j), &right) in &table[&(apex, j)] {
                            let at_apex = at_left + at_right + left_edge + right_edge;
                            if at_apex > capacity(apex) {
                                continue;
                            }
                            let is_full = at_apex == capacity(apex);
                            let Some(rank) = join(left, right, triangle, is_full) else { continue };
                            let best = piece.entry((at_i + left_edge, at_j + right_edge));
                            let best = best.or_insert(rank);
                            if rank > *best {
                                *best = rank;
                            }
                        }
                    }
                }
                table.insert((i, j), piece);
            }
        }
        let whole = table[&(0, n - 1)].iter();
        let within =
            whole.filter(|&(&(first, last), _)| first <= capacity(0) && last <= capacity(n - 1));
        let ranks = within.map(|(&(first, last), &rank)| {
            close(close(rank, first == capacity(0)), last == capacity(n - 1))
        });
        ranks.fold(None, |best, rank| if Some(rank) > best { Some(rank) } else { best })
    }

    /// Checks an answer against the rank of the best.
    pub(crate) fn check(&self, optimum: &Optimum, max_degree: u32, best: Rank) {
        let (tangent, Reverse(full), shape) = best;
        assert_eq!(self.rank(&optimum.triangles, max_degree), Some(best), "{self:?}");
        assert_eq!(optimum.max_degree, max_degree);
        assert_eq!(optimum.min_angle, libm::atan(tangent).to_degrees(), "{self:?}");
        assert_eq!(optimum.vertices_at_limit, full, "{self:?}");
        assert_eq!(optimum.shape_sum, shape as f64 / measure::SHAPE_UNIT as f64, "{self:?}");
        assert!(optimum.triangles.is_sorted());
    }
}

/// Corners of a regular polygon, stretched.
pub(crate) fn regular(sides: usize, stretch: f64) -> Vec<DVec2> {
    let angle = |corner: usize| std::f64::consts::TAU * corner as f64 / sides as f64;
    (0..sides).map(|corner| DVec2::from_angle(angle(corner)) * DVec2::new(stretch, 1.0)).collect()
}

/// Problems of at most `largest` vertices. Half of them are symmetric or nearly so, since ties
/// need equals; half are irregular; and half have limits on some vertices.
pub(crate) fn instances(largest: u64) -> impl Strategy<Value = Instance> {
    let sides = prop::collection::vec(1..=largest / 2, 3..=6)
        .prop_filter("too many vertices", move |sides| sides.iter().sum::<u64>() <= largest);
    let limits = prop_oneof![
        Just(Vec::new()),
        prop::collection::vec((0_u32..3, prop::option::weighted(0.2, 2_u32..8)), largest as usize),
    ];
    let wobbles = prop_oneof![Just(0.0), 0.0..0.4];
    (sides, 0.3..3.0, wobbles, prop::collection::vec(-1.0..1.0, largest as usize), limits).prop_map(
        |(sides, stretch, wobble, shifts, limits)| {
            let corners = regular(sides.len(), stretch);
            let mut instance = Instance::spaced(&corners, &sides, |vertex, place| {
                let gap = 1.0 / *sides.iter().max().unwrap() as f64;
                if place == 0.0 { 0.0 } else { place + gap * wobble * shifts[vertex] }
            });
            for (vertex, (outside, own_limit)) in
                limits.into_iter().take(instance.points.len()).enumerate()
            {
                instance.outside[vertex] = outside;
                instance.own_limits[vertex] = own_limit;
            }
            instance
        },
    )
}
