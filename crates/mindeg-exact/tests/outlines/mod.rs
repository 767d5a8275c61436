//! Polygons to test with, a plain definition of visibility, and all triangulations of the small
//! ones.

#![allow(dead_code, reason = "who includes this takes what it needs")]

use glam::DVec2;
use mindeg_exact::{Problem, measure};
use mindeg_mesh::planar::PlanarBoundary;
use robust::{Coord, orient2d};
use std::cmp::Reverse;

pub(crate) fn turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    let [a, b, c] = [a, b, c].map(|p| Coord { x: p.x, y: p.y });
    orient2d(a, b, c)
}

/// A simple polygon whose corners are joined by sides of one or more edges.
#[derive(Clone, Debug)]
pub(crate) struct Outline {
    pub(crate) points: Vec<DVec2>,
    /// Of each vertex the side that its edge is on.
    pub(crate) side_of: Vec<u32>,
}

impl Outline {
    /// Corners and the number of edges of each side.
    pub(crate) fn new(corners: &[(f64, f64)], counts: &[u32]) -> Self {
        let mut outline = Self { points: Vec::new(), side_of: Vec::new() };
        for (side, &count) in counts.iter().enumerate() {
            let (from, to) = (corners[side], corners[(side + 1) % corners.len()]);
            let (from, to) = (DVec2::from(from), DVec2::from(to));
            for step in 0..count {
                outline.points.push(from + (to - from) * (f64::from(step) / f64::from(count)));
                outline.side_of.push(side as u32);
            }
        }
        outline
    }

    pub(crate) fn l_shape(counts: [u32; 6]) -> Self {
        let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 2.0), (2.0, 4.0), (0.0, 4.0)];
        Self::new(&corners, &counts)
    }

    /// Outer floor, right, right tip, right inside, inner floor, left inside, left tip, left.
    pub(crate) fn u_shape(counts: [u32; 8]) -> Self {
        let corners = [(0, 0), (6, 0), (6, 4), (4, 4), (4, 2), (2, 2), (2, 4), (0, 4)];
        Self::new(&corners.map(|(x, y)| (f64::from(x), f64::from(y))), &counts)
    }

    /// A spine of some edges below, and teeth upwards.
    pub(crate) fn comb(teeth: u32, spine: u32, others: u32) -> Self {
        let width = f64::from(2 * teeth - 1);
        let mut corners = vec![(0.0, 0.0), (width, 0.0)];
        for tooth in (0..teeth).rev() {
            let left = f64::from(2 * tooth);
            corners.extend([(left + 1.0, 3.0), (left, 3.0)]);
            if tooth > 0 {
                corners.extend([(left, 1.0), (left - 1.0, 1.0)]);
            }
        }
        let mut counts = vec![others; corners.len()];
        counts[0] = spine;
        Self::new(&corners, &counts)
    }

    /// Two radii in turn.
    pub(crate) fn gear(teeth: u32, count: u32) -> Self {
        let at = |step: u32, radius: f64| {
            let angle = std::f64::consts::TAU * f64::from(step) / f64::from(4 * teeth);
            (radius * libm::cos(angle), radius * libm::sin(angle))
        };
        let corners: Vec<_> =
            (0..4 * teeth).map(|step| at(step, if step % 4 < 2 { 2.0 } else { 1.5 })).collect();
        Self::new(&corners, &vec![count; corners.len()])
    }

    /// A band wound up square.
    pub(crate) fn spiral(turns: u32) -> Self {
        let steps = 12 * turns;
        let at = |step: u32, offset: f64| {
            let angle = std::f64::consts::TAU * f64::from(step) / 12.0;
            let radius = 1.0 + f64::from(step) / 12.0 + offset;
            (radius * libm::cos(angle), radius * libm::sin(angle))
        };
        let outer = (0..=steps).map(|step| at(step, 0.5));
        let inner = (0..=steps).rev().map(|step| at(step, 0.0));
        let corners: Vec<_> = outer.chain(inner).collect();
        Self::new(&corners, &vec![1; corners.len()])
    }

    /// A random ring with integer corners; every side is divided at exact positions.
    pub(crate) fn random(random: &mut Random, corners: usize, most: usize) -> Option<Self> {
        let grid = if random.below(2) == 0 { 7 } else { 100 };
        let mut at = Vec::<(f64, f64)>::new();
        while at.len() < corners {
            let [x, y] = [0; 2].map(|_: u32| (random.below(grid) * 12) as f64);
            if !at.contains(&(x, y)) {
                at.push((x, y));
            }
        }
        // Uncross until nothing crosses.
        let points = |at: &[(f64, f64)]| at.iter().copied().map(DVec2::from).collect::<Vec<_>>();
        for _ in 0..200 {
            let now = points(&at);
            let crossing = (0..corners).find_map(|a| {
                let b = (a + 2..corners).find(|&b| {
                    (b + 1) % corners != a
                        && touch([now[a], now[a + 1]], [now[b], now[(b + 1) % corners]])
                })?;
                Some((a + 1, b))
            });
            let Some((from, to)) = crossing else { break };
            at[from..=to].reverse();
        }
        let area: f64 = (0..corners)
            .map(|i| DVec2::from(at[i]).perp_dot(DVec2::from(at[(i + 1) % corners])))
            .sum();
        if area < 0.0 {
            at.reverse();
        }
        let mut counts = vec![1; corners];
        while random.below(3) > 0 && counts.iter().sum::<u32>() < most as u32 {
            let side = random.below(corners as u64) as usize;
            if counts[side] < 4 {
                counts[side] += 1;
            }
        }
        let outline = Self::new(&at, &counts);
        outline.is_simple().then_some(outline)
    }

    pub(crate) fn len(&self) -> usize {
        self.points.len()
    }

    /// No two edges touch but neighbours, and these at their common end only.
    pub(crate) fn is_simple(&self) -> bool {
        let n = self.len();
        let at = |i: usize| self.points[i % n];
        let is_spike = |i: usize| {
            let (before, here, after) = (at(i + n - 1), at(i), at(i + 1));
            turn(before, here, after) == 0.0 && (here - before).dot(after - here) <= 0.0
        };
        !(0..n).any(is_spike)
            && (0..n).all(|a| {
                (a + 2..n)
                    .all(|b| (b + 1) % n == a || !touch([at(a), at(a + 1)], [at(b), at(b + 1)]))
            })
    }

    /// Whether the open segment between two vertices is in the open interior, by definition. O(n).
    pub(crate) fn is_visible(&self, i: usize, j: usize) -> bool {
        let n = self.len();
        let at = |i: usize| self.points[i % n];
        let (a, b) = (at(i), at(j));
        let touches = (0..n).any(|k| {
            let shares = [k, (k + 1) % n].iter().any(|&end| end == i || end == j);
            !shares && touch([a, b], [at(k), at(k + 1)])
        });
        let passes = (0..n).any(|k| k != i && k != j && on(at(k), [a, b]));
        // It begins within the interior angle.
        let (before, after) = (at(i + n - 1), at(i + 1));
        let is_left_of_after = turn(a, after, b) > 0.0;
        let is_right_of_before = turn(a, b, before) > 0.0;
        let begins_inside = if turn(before, a, after) > 0.0 {
            is_left_of_after && is_right_of_before
        } else {
            is_left_of_after || is_right_of_before
        };
        !touches && !passes && begins_inside
    }

    fn is_on_one_side(&self, i: usize, j: usize) -> bool {
        let of = |v: usize| [self.side_of[(v + self.len() - 1) % self.len()], self.side_of[v]];
        of(i).iter().any(|side| of(j).contains(side))
    }

    /// Whether an edge of a triangulation may join two vertices.
    pub(crate) fn may_join(&self, i: usize, j: usize) -> bool {
        let span = i.abs_diff(j);
        span == 1 || span + 1 == self.len() || (self.is_visible(i, j) && !self.is_on_one_side(i, j))
    }

    /// A triangulation by cutting off ears.
    pub(crate) fn ears(&self) -> Vec<[u32; 3]> {
        let mut ring: Vec<usize> = (0..self.len()).collect();
        let mut triangles = Vec::new();
        while ring.len() > 3 {
            let n = ring.len();
            let ear = (0..n).find(|&i| {
                let ear = [ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]];
                let [a, b, c] = ear.map(|v| self.points[v]);
                let is_in =
                    |p| turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
                turn(a, b, c) > 0.0
                    && !ring.iter().any(|v| !ear.contains(v) && is_in(self.points[*v]))
            });
            let i = ear.expect("a simple polygon has an ear");
            triangles.push([ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]]);
            ring.remove(i);
        }
        triangles.push([ring[0], ring[1], ring[2]]);
        triangles.into_iter().map(|triangle| triangle.map(|v| v as u32)).collect()
    }

    /// The points as one ring.
    pub(crate) fn boundary(&self) -> PlanarBoundary {
        PlanarBoundary::new(&[&self.points]).unwrap().with_sides(Vec::new(), self.side_of.clone())
    }

    pub(crate) fn problem(&self) -> Problem {
        Problem::triangulated(&self.boundary(), &self.ears()).unwrap()
    }

    /// All triangulations.
    pub(crate) fn triangulations(&self) -> Vec<Vec<[u32; 3]>> {
        let n = self.len();
        let may_join: Vec<Vec<bool>> =
            (0..n).map(|i| (0..n).map(|j| i != j && self.may_join(i, j)).collect()).collect();
        let mut all = Vec::new();
        visit_all(&may_join, vec![(0, n - 1)], &mut Vec::new(), &mut all);
        all
    }
}

fn visit_all(
    may_join: &[Vec<bool>],
    mut open: Vec<(usize, usize)>,
    triangles: &mut Vec<[u32; 3]>,
    all: &mut Vec<Vec<[u32; 3]>>,
) {
    let Some((i, j)) = open.pop() else {
        all.push(triangles.clone());
        return;
    };
    if j == i + 1 {
        return visit_all(may_join, open, triangles, all);
    }
    for apex in i + 1..j {
        if may_join[i][apex] && may_join[apex][j] {
            let mut open = open.clone();
            open.extend([(i, apex), (apex, j)]);
            triangles.push([i, apex, j].map(|v| v as u32));
            visit_all(may_join, open, triangles, all);
            triangles.pop();
        }
    }
}

/// Whether closed segments touch.
pub(crate) fn touch([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> bool {
    let sign = |x: f64| if x > 0.0 { 1 } else { -i32::from(x < 0.0) };
    let (s, t) = (sign(turn(a, b, c)), sign(turn(a, b, d)));
    let (u, v) = (sign(turn(c, d, a)), sign(turn(c, d, b)));
    (s * t < 0 && u * v < 0) || on(c, [a, b]) || on(d, [a, b]) || on(a, [c, d]) || on(b, [c, d])
}

/// Whether a point is on a closed segment.
pub(crate) fn on(p: DVec2, [a, b]: [DVec2; 2]) -> bool {
    turn(a, b, p) == 0.0 && (p - a).dot(p - b) <= 0.0
}

/// The order of triangulations: the tangent of the minimum angle, the number of
/// vertices at their limit, the sum of shapes.
pub(crate) type Rank = (f64, Reverse<u32>, u64);

/// The numbers of one triangulation that ranking takes.
pub(crate) struct Measured {
    pub(crate) degrees: Vec<u32>,
    pub(crate) tangent: f64,
    pub(crate) shape: u64,
}

impl Measured {
    pub(crate) fn new(points: &[DVec2], triangles: &[[u32; 3]]) -> Self {
        // Every vertex is on one ring, so its edges are one more than its triangles.
        let mut degrees = vec![1; points.len()];
        triangles.as_flattened().iter().for_each(|&v| degrees[v as usize] += 1);
        let corners = |t: &[u32; 3]| t.map(|v| points[v as usize]);
        let tangents = triangles.iter().map(|t| measure::min_angle_tangent(corners(t)));
        let shape = triangles.iter().map(|t| measure::shape(corners(t))).sum();
        Self { degrees, tangent: tangents.fold(f64::INFINITY, f64::min), shape }
    }

    /// The rank, if the triangulation keeps the limits; external edges count.
    pub(crate) fn rank(&self, limits: &[u32], outside: &[u32]) -> Option<Rank> {
        let total = || self.degrees.iter().zip(outside).map(|(degree, outside)| degree + outside);
        let full = total().zip(limits).filter(|(total, limit)| total == *limit).count();
        let is_kept = total().zip(limits).all(|(total, limit)| total <= *limit);
        is_kept.then_some((self.tangent, Reverse(full as u32), self.shape))
    }
}

/// Numbers that are the same on every machine.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn below(&mut self, most: u64) -> u64 {
        // splitmix64
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) % most
    }
}
