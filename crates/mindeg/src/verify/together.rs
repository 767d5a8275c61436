//! Degree limits that exclude each other while angles stay, checked with code that shares nothing with the mesher's.
//!
//! A fan of k triangles with angles of at least a, in a sector of angle t, has spokes whose lengths differ by a factor of at most
//! (sin(t/k + a) / sin a)^k. So each corner of a face takes a least number of triangles, and two corners with an edge between them
//! as many as some apex over that edge leaves for both; behind a corner of one triangle the same holds for the edge that cuts it off. A group is
//! excused if its corners take so many in any mesh with nearly the angles at hand.

use super::map::{MapLines, sides};
use super::matching::VerifiedMesh;
use glam::DVec2;
use mindeg_mesh::planar::PlanarBoundary;
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The shares of the angles at hand that other meshes may be asked to have.
const SHARES: [f64; 4] = [0.25, 0.5, 0.75, 0.95];
const MOST_IN_A_GROUP: usize = 4;
/// With more vertices out of range nothing is tried.
const MOST_VERTICES: usize = 32;
/// No corner is said to take more triangles than this.
const CEILING: u32 = 9;
/// How often a range of angles is halved.
const DEPTH: u32 = 18;

/// A corner of a face between two edges that stay, counter-clockwise from one to the other.
#[derive(Clone, Copy)]
struct Corner {
    vertex: u32,
    ends: [u32; 2],
    angle: f64,
    lengths: [f64; 2],
}

/// The choices of two corners: any mesh has at least one of these numbers in both.
type Choices = Vec<(u32, u32)>;

pub(super) struct Frozen<'a> {
    mesh: &'a VerifiedMesh,
    ends: BTreeMap<u32, Vec<u32>>,
    halves: BTreeSet<[u32; 2]>,
    /// The least angle of the triangles at each vertex, and the share of it that is asked for.
    angles: Vec<f64>,
    share: f64,
}

impl<'a> Frozen<'a> {
    pub(super) fn new(boundary: &PlanarBoundary, lines: &MapLines, mesh: &'a VerifiedMesh) -> Self {
        let mut ends: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for [a, b] in boundary.edges().flat_map(|[a, b]| [[a, b], [b, a]]).chain(lines.edges()) {
            ends.entry(a).or_default().push(b);
        }
        let mut angles = vec![PI; mesh.points.len()];
        for triangle in &mesh.triangles {
            let at = triangle.map(|v| mesh.points[v as usize]);
            let own = |i: usize| turned(at[(i + 1) % 3] - at[i], at[(i + 2) % 3] - at[i]).abs();
            let least = (0..3).map(own).fold(PI, f64::min);
            for v in triangle {
                angles[*v as usize] = least.min(angles[*v as usize]);
            }
        }
        let halves = mesh.triangles.iter().flat_map(|t| sides(*t)).collect();
        Self { mesh, ends, halves, angles, share: 1.0 }
    }

    /// Which of these vertices are in a group that has as few edges above the limit as any mesh with a share of the angles, and that share.
    pub(super) fn excused(mut self, above: &[u32], limit: u32) -> Vec<(u32, f64)> {
        let mut found = BTreeMap::new();
        let shares = if above.len() > MOST_VERTICES { &[] } else { &SHARES[..] };
        for &share in shares {
            self.share = share;
            for vertex in above {
                if !found.contains_key(vertex) {
                    let group = self.group(*vertex, limit).unwrap_or_default();
                    let own = group.into_iter().filter(|v| above.contains(v));
                    own.for_each(|v| _ = found.entry(v).or_insert(share));
                }
            }
        }
        found.into_iter().collect()
    }

    /// The first group round a vertex that is excused, by its size.
    fn group(&self, vertex: u32, limit: u32) -> Option<BTreeSet<u32>> {
        let is_open = |v: &u32| self.corners(*v).len() < self.ends(*v).len();
        let mut groups = BTreeSet::from([BTreeSet::from([vertex])]);
        for _ in 0..MOST_IN_A_GROUP {
            let is_excused = |group: &&BTreeSet<u32>| {
                let degree = |v: &u32| self.mesh.degrees[*v as usize].max(limit);
                self.least(group) >= group.iter().map(degree).sum()
            };
            if let Some(found) = groups.iter().find(is_excused) {
                return Some(found.clone());
            }
            let larger = groups.iter().flat_map(|group| {
                let near = group.iter().flat_map(|v| self.ends(*v).iter().copied());
                let near = near.filter(|v| !group.contains(v) && !is_open(v));
                near.map(|v| group.iter().copied().chain([v]).collect())
            });
            groups = larger.collect();
        }
        None
    }

    /// The other ends of the edges that stay at a vertex; inside a face there are none.
    fn ends(&self, vertex: u32) -> &[u32] {
        self.ends.get(&vertex).map_or(&[], |ends| ends)
    }

    fn corners(&self, vertex: u32) -> Vec<Corner> {
        let span = |end: u32| self.mesh.points[end as usize] - self.mesh.points[vertex as usize];
        let direction = |end: u32| turned(DVec2::X, span(end));
        let mut ends = self.ends(vertex).to_vec();
        ends.sort_by(|a, b| direction(*a).total_cmp(&direction(*b)));
        let corner = |i: usize| {
            let both = [ends[i], ends[(i + 1) % ends.len()]];
            let [from, to] = both.map(span);
            let angle = turned(from, to);
            let angle = if angle <= 0.0 { angle + TAU } else { angle };
            Corner { vertex, ends: both, angle, lengths: [from.length(), to.length()] }
        };
        let corners = (0..ends.len()).map(corner);
        corners.filter(|own| self.halves.contains(&[vertex, own.ends[0]])).collect()
    }

    fn kept(&self, corner: &Corner) -> f64 {
        self.share * self.angles[corner.vertex as usize]
    }

    fn next(&self, corner: &Corner) -> Option<Corner> {
        self.corners(corner.ends[1]).into_iter().find(|own| own.ends[0] == corner.vertex)
    }

    fn previous(&self, corner: &Corner) -> Option<Corner> {
        self.corners(corner.ends[0]).into_iter().find(|own| own.ends[1] == corner.vertex)
    }

    /// The least number of triangles at a group's vertices, those that it has twice counted twice.
    fn least(&self, group: &BTreeSet<u32>) -> u32 {
        let mut left: Vec<Corner> = group.iter().flat_map(|v| self.corners(*v)).collect();
        let mut sum = 0;
        while let Some(first) = left.pop() {
            let mut row = vec![first];
            let mut take = |of: Option<Corner>| {
                let key = |own: &Corner| (own.vertex, own.ends);
                let index =
                    left.iter().position(|own| of.is_some_and(|of| key(&of) == key(own)))?;
                Some(left.swap_remove(index))
            };
            while let Some(own) = take(self.next(&row[row.len() - 1])) {
                row.push(own);
            }
            while let Some(own) = take(self.previous(&row[0])) {
                row.insert(0, own);
            }
            let around = [self.previous(&row[0]), self.next(&row[row.len() - 1])];
            if let [Some(before), Some(after)] = around {
                row.insert(0, before);
                row.push(after);
                sum += Row::new(self, &row).least(&mut Vec::new(), 0, u32::MAX);
            }
        }
        sum
    }
}

/// Corners in a row along a face; the first and the last may have any numbers.
struct Row {
    alone: Vec<u32>,
    pairs: Vec<Choices>,
    /// For each corner those of its neighbours if it has one triangle.
    ears: Vec<Choices>,
}

impl Row {
    fn new(of: &Frozen<'_>, row: &[Corner]) -> Self {
        let alone = |own: &Corner| {
            let log = libm::log(own.lengths[0] / own.lengths[1]);
            let fan = fan([own.angle; 2], [log; 2], of.kept(own)).unwrap_or(1);
            fan.max(1 + u32::from(own.angle >= PI))
        };
        let pair = |two: &[Corner]| match two[0].ends[0] == two[1].ends[1] {
            true => vec![(1, 1)],
            false => Edge::new(&two[0], &two[1]).choices([of.kept(&two[0]), of.kept(&two[1])]),
        };
        let ears = row.windows(3).map(|three| ear(of, &three[0], &three[1], &three[2]));
        Self {
            alone: row.iter().map(alone).collect(),
            pairs: row.windows(2).map(pair).collect(),
            ears: ears.collect(),
        }
    }

    /// The least sum of the inner numbers that continue these, if it is below `best`.
    fn least(&self, given: &mut Vec<u32>, sum: u32, mut best: u32) -> u32 {
        let at = given.len();
        if at == self.alone.len() {
            return sum.min(best);
        }
        let is_inner = at > 0 && at + 1 < self.alone.len();
        for count in self.alone[at].min(CEILING)..=CEILING {
            let fits = |choices: &Choices, a: u32, b: u32| {
                choices.iter().any(|own| own.0.min(CEILING) <= a && own.1.min(CEILING) <= b)
            };
            let sum = sum + if is_inner { count } else { 0 };
            let is_possible = at == 0 || fits(&self.pairs[at - 1], given[at - 1], count);
            let is_cut = at > 1 && given[at - 1] == 1;
            if sum >= best
                || !is_possible
                || is_cut && !fits(&self.ears[at - 2], given[at - 2], count)
            {
                continue;
            }
            given.push(count);
            best = self.least(given, sum, best);
            given.pop();
        }
        best
    }
}

/// The choices beside a corner of one triangle.
fn ear(of: &Frozen<'_>, before: &Corner, own: &Corner, after: &Corner) -> Choices {
    if own.angle >= PI || before.vertex == after.vertex {
        return Vec::new();
    }
    if before.ends[0] == after.vertex {
        return vec![(1, 1)];
    }
    let [at, from, to] =
        [own.vertex, before.vertex, after.vertex].map(|v| of.mesh.points[v as usize]);
    let angle = |p: DVec2, q: DVec2| turned(p, q).abs();
    let [first, second] = [angle(at - from, to - from), angle(at - to, from - to)];
    let most = of.kept(before).max(of.kept(own)).max(of.kept(after));
    let rest = [before.angle - first, after.angle - second];
    if first.min(second).min(own.angle) < most || rest[0].min(rest[1]) <= 0.0 {
        return Vec::new();
    }
    if before.ends[0] == after.ends[1] {
        return vec![(2, 2)];
    }
    let edge = Edge {
        length: from.distance(to),
        angles: rest,
        beside: [before.lengths[0], after.lengths[1]],
    };
    let choices = edge.choices([of.kept(before), of.kept(after)]);
    choices.into_iter().map(|(a, b)| (a + 1, b + 1)).collect()
}

/// An edge with the angles to the next edges at both of its ends, and their lengths.
struct Edge {
    length: f64,
    angles: [f64; 2],
    beside: [f64; 2],
}

impl Edge {
    fn new(one: &Corner, other: &Corner) -> Self {
        Self {
            length: one.lengths[1],
            angles: [one.angle, other.angle],
            beside: [one.lengths[0], other.lengths[1]],
        }
    }

    /// Numbers of triangles at both ends, one of which any apex needs.
    fn choices(&self, kept: [f64; 2]) -> Choices {
        let mut found = Choices::new();
        for end in 0..2 {
            // The triangle to the end of the next edge.
            let angle = self.angles[end].min(PI);
            let tip = DVec2::new(libm::cos(angle), libm::sin(angle)) * self.beside[end];
            let back = tip - DVec2::new(self.length, 0.0);
            let other = turned(-DVec2::X, back).abs();
            let own = [self.angles[end], other, PI - self.angles[end] - other];
            let left = self.angles[1 - end] - other;
            if own.into_iter().fold(PI, f64::min) >= kept[0].max(kept[1]) && left > 0.0 {
                let log = libm::log(back.length() / self.beside[1 - end]);
                let rest = fan([left; 2], [log; 2], kept[1 - end]);
                found.extend(rest.map(|k| if end == 0 { (1, 1 + k) } else { (1 + k, 1) }));
            }
        }
        let low = kept[0].max(kept[1]);
        let whole = self.angles.map(|angle| [low, angle.min(PI - 2.0 * low)]);
        self.divide(whole, kept, DEPTH, &mut found);
        found
    }

    fn divide(&self, angles: [[f64; 2]; 2], kept: [f64; 2], depth: u32, found: &mut Choices) {
        let low = kept[0].max(kept[1]);
        if angles.iter().any(|own| own[0] > own[1]) || angles[0][0] + angles[1][0] > PI - low {
            return;
        }
        let rest = |end: usize| {
            let [own, other] = [angles[end], angles[1 - end]];
            let scale = self.length / self.beside[end];
            let logs = distances(own, other).map(|ratio| libm::log(ratio * scale));
            let left = [self.angles[end] - own[1], self.angles[end] - own[0]];
            Some(1 + fan(left, logs, kept[end])?)
        };
        let (Some(a), Some(b)) = (rest(0), rest(1)) else { return };
        if found.iter().any(|own| own.0 <= a && own.1 <= b) {
            return;
        }
        if depth == 0 {
            found.push((a, b));
            return;
        }
        let wider = usize::from(angles[1][1] - angles[1][0] > angles[0][1] - angles[0][0]);
        let middle = f64::midpoint(angles[wider][0], angles[wider][1]);
        for part in [[angles[wider][0], middle], [middle, angles[wider][1]]] {
            let mut halved = angles;
            halved[wider] = part;
            self.divide(halved, kept, depth - 1, found);
        }
    }
}

/// The range of an apex's distance from an end of an edge of length 1: sin(other) / sin(own + other) grows with the angle at the other end.
fn distances(own: [f64; 2], other: [f64; 2]) -> [f64; 2] {
    let at = |own: f64, other: f64| match own + other < PI {
        true => libm::sin(other) / libm::sin(own + other),
        false => f64::INFINITY,
    };
    let nearest = (FRAC_PI_2 - other[0]).clamp(own[0], own[1]);
    [at(nearest, other[0]), at(own[0], other[1]).max(at(own[1], other[1]))]
}

/// The angle from one direction to another, counter-clockwise, above -π and at most π.
fn turned(from: DVec2, to: DVec2) -> f64 {
    libm::atan2(from.perp_dot(to), from.dot(to))
}

/// The fewest triangles that fill a sector of this range, its edges' lengths apart by a logarithm of that range, with angles of at least
/// `least`; at most [`CEILING`]. `None` if no number does.
fn fan([narrow, wide]: [f64; 2], logs: [f64; 2], least: f64) -> Option<u32> {
    let log = if logs[0] > 0.0 { logs[0] } else { (-logs[1]).max(0.0) };
    for count in 1..=CEILING {
        let each = f64::from(count);
        let (low, high) = ((narrow / each).max(least), (wide / each).min(PI - 2.0 * least));
        if wide / each < least {
            return None;
        }
        let best = (FRAC_PI_2 - least).clamp(low.min(high), high);
        let most = each * libm::log(libm::sin(best + least) / libm::sin(least));
        if count == CEILING || low <= high && most >= log {
            return Some(count);
        }
    }
    None
}
