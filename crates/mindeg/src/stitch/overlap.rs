//! Which triangles of a mesh make place for another mesh that they overlap.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use glam::DVec2;
use mindeg_mesh::planar::orientation;
use mindeg_mesh::{Bounds, BoxTree, TriMesh, edges_of};

use super::gap::is_right_of;
use super::proof::boundary_of;
use crate::error::MeshError;

/// A front vertex leaves the gap this angle at least, in radians: two triangles of 25°.
const LEAST_ANGLE: f64 = 50.0 * TAU / 360.0;

/// Triangles of a mesh that made place for another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dropped {
    /// How many triangles overlapped the other mesh or touched it.
    pub overlapping: usize,
    /// How many were too near it for good triangles between.
    pub near: usize,
    /// The vertices that went with them.
    pub vertices: usize,
}

/// The boundary of a mesh, with a tree to find its edges.
pub(super) struct Border<'a> {
    pub(super) points: &'a [DVec2],
    /// The boundary vertex after each.
    pub(super) next: BTreeMap<u32, u32>,
    pub(super) edges: Vec<[u32; 2]>,
    tree: BoxTree,
}

impl<'a> Border<'a> {
    fn new(triangles: &[[u32; 3]], points: &'a [DVec2]) -> Result<Self, MeshError> {
        let next = boundary_of(triangles, points)?;
        let edges: Vec<[u32; 2]> = next.iter().map(|(from, to)| [*from, *to]).collect();
        let boxes = edges.iter().map(|ends| around(&ends.map(|end| points[end as usize])));
        let tree = BoxTree::new(boxes.collect());
        Ok(Self { points, next, edges, tree })
    }

    pub(super) fn ends(&self, edge: u32) -> [DVec2; 2] {
        self.edges[edge as usize].map(|end| self.points[end as usize])
    }

    /// The nearest edge to a point, and how far it is.
    pub(super) fn nearest(&self, at: DVec2) -> (u32, f64) {
        let squared = |edge: u32| nearest_of(self.ends(edge), at).distance_squared(at);
        let found = self.tree.nearest(at.extend(0.0), f64::INFINITY, squared);
        // A mesh has a boundary.
        found.map_or((0, f64::INFINITY), |(edge, squared)| (edge, squared.sqrt()))
    }

    /// The edges that a segment meets.
    pub(super) fn met_by(&self, ends: [DVec2; 2]) -> Vec<u32> {
        let mut found = Vec::new();
        self.tree.meet(around(&ends), &mut found);
        found.retain(|&edge| meet(self.ends(edge), ends));
        found.sort_unstable();
        found
    }

    /// Whether a point lies in the mesh. O(n).
    pub(super) fn has(&self, at: DVec2) -> bool {
        let crosses = self
            .edges
            .iter()
            .filter(|ends| is_right_of(at, ends.map(|end| self.points[end as usize])));
        crosses.count() % 2 == 1
    }
}

/// Two meshes of which the second one overlaps the first.
pub(super) struct Overlap<'a> {
    /// The first mesh.
    pub(super) first: Border<'a>,
    /// The second one, whole.
    pub(super) second: Border<'a>,
    triangles: &'a [[u32; 3]],
    /// Which triangles of the second one overlap the first, or touch it.
    overlaps: Vec<bool>,
    /// For each other triangle, its distance from the first mesh in edges, the longer ones of both.
    distance: Vec<f64>,
    /// The triangles beside each, across its edges.
    beside: Vec<[Option<u32>; 3]>,
}

impl<'a> Overlap<'a> {
    /// O(n log n), and for each part of the second mesh beyond the boundary of the first one, O(n).
    pub(super) fn new(
        [first, second]: [&'a TriMesh; 2],
        [first_points, points]: &'a [Vec<DVec2>; 2],
    ) -> Result<Self, MeshError> {
        let triangles = second.triangles();
        let (first, second) =
            (Border::new(first.triangles(), first_points)?, Border::new(triangles, points)?);
        let corners = |triangle: usize| triangles[triangle].map(|corner| points[corner as usize]);
        let mut overlaps: Vec<bool> = (0..triangles.len())
            .map(|triangle| {
                let own = corners(triangle);
                let mut found = Vec::new();
                first.tree.meet(around(&own), &mut found);
                found.into_iter().any(|edge| touches(own, first.ends(edge)))
            })
            .collect();
        let beside = beside(triangles);
        // Parts that the boundary of the first mesh separates lie in it or not as a whole.
        let mut is_known = overlaps.clone();
        for start in 0..triangles.len() {
            if is_known[start] {
                continue;
            }
            let is_in = first.has(corners(start)[0]);
            let mut open = vec![start as u32];
            is_known[start] = true;
            while let Some(triangle) = open.pop() {
                overlaps[triangle as usize] = is_in;
                for next in beside[triangle as usize].into_iter().flatten() {
                    if !std::mem::replace(&mut is_known[next as usize], true) {
                        open.push(next);
                    }
                }
            }
        }
        let near: Vec<(u32, f64)> = points.iter().map(|at| first.nearest(*at)).collect();
        let distance = (0..triangles.len()).map(|triangle| {
            let [a, b, c] = corners(triangle);
            let own = a.distance(b).max(b.distance(c)).max(c.distance(a));
            let of_corner = |corner: u32| {
                let (edge, distance) = near[corner as usize];
                let [from, to] = first.ends(edge);
                distance / own.max(from.distance(to))
            };
            triangles[triangle].map(of_corner).into_iter().fold(f64::INFINITY, f64::min)
        });
        let distance = distance.collect();
        Ok(Self { first, second, triangles, overlaps, distance, beside })
    }

    /// The triangles of the second mesh that go: those that overlap, those nearer than a number of edges around
    /// them, and those that would make the front jagged.
    pub(super) fn dropped(&self, width: f64) -> Result<(Vec<bool>, Dropped), MeshError> {
        let mut is_dropped = self.overlaps.clone();
        let overlapping = is_dropped.iter().filter(|it| **it).count();
        if overlapping == 0 {
            return Err(MeshError::refused(
                "the meshes do not overlap: give the area between them with --within (within in Python)",
            ));
        }
        let all = 0..self.triangles.len() as u32;
        let mut open: Vec<u32> = all.filter(|it| is_dropped[*it as usize]).collect();
        while let Some(triangle) = open.pop() {
            for next in self.beside[triangle as usize].into_iter().flatten() {
                let at = next as usize;
                if !is_dropped[at] && self.distance[at] < width {
                    is_dropped[at] = true;
                    open.push(next);
                }
            }
        }
        self.clean(&mut is_dropped);
        let dropped = is_dropped.iter().filter(|it| **it).count();
        if dropped == self.triangles.len() {
            return Err(MeshError::refused(
                "the second mesh lies in the first one, or all of it is too near: nothing is left to join; give the meshes \
                 in the other order",
            ));
        }
        Ok((is_dropped, Dropped { overlapping, near: dropped - overlapping, vertices: 0 }))
    }

    /// Drops triangles until the front is even: each vertex on it has its triangles in one fan, on the boundary beside an edge of
    /// it, and leaves the gap an angle that is not sharp.
    fn clean(&self, is_dropped: &mut [bool]) {
        let points = self.second.points;
        let mut of_vertex: Vec<Vec<u32>> = vec![Vec::new(); points.len()];
        for (triangle, corners) in (0..).zip(self.triangles) {
            corners.iter().for_each(|corner| of_vertex[*corner as usize].push(triangle));
        }
        // Each round drops a triangle, or is the last one.
        loop {
            let mut going: Vec<u32> = Vec::new();
            let is_touched: Vec<bool> =
                of_vertex.iter().map(|own| own.iter().any(|it| is_dropped[*it as usize])).collect();
            for (triangle, corners) in (0..).zip(self.triangles) {
                if corners.iter().all(|corner| is_touched[*corner as usize]) {
                    going.push(triangle);
                }
            }
            for (vertex, own) in (0..).zip(&of_vertex) {
                let left: Vec<u32> =
                    own.iter().copied().filter(|it| !is_dropped[*it as usize]).collect();
                if left.is_empty() || left.len() == own.len() {
                    continue;
                }
                let angles = |list: &[u32]| -> f64 {
                    list.iter()
                        .map(|it| angle_at(vertex, self.triangles[*it as usize], points))
                        .sum()
                };
                let is_bank = self.second.next.contains_key(&vertex);
                let whole = if is_bank { angles(own) } else { TAU };
                let is_sharp = whole - angles(&left) < LEAST_ANGLE;
                // A fan has one triangle more than inner edges.
                let inner = left.iter().flat_map(|it| edges_of(self.triangles[*it as usize]));
                let inner: Vec<[u32; 2]> = inner.filter(|ends| ends.contains(&vertex)).collect();
                let has = |ends: [u32; 2]| inner.contains(&ends);
                let shared = inner.iter().filter(|[from, to]| has([*to, *from])).count() / 2;
                let bank = self.second.next.get(&vertex).is_some_and(|next| has([vertex, *next]))
                    || inner
                        .iter()
                        .any(|[from, to]| *to == vertex && self.second.next.get(from) == Some(to));
                if is_sharp || shared + 1 != left.len() || is_bank && !bank {
                    going.extend(left);
                }
            }
            going.retain(|it| !is_dropped[*it as usize]);
            if going.is_empty() {
                return;
            }
            going.iter().for_each(|it| is_dropped[*it as usize] = true);
        }
    }
}

fn beside(triangles: &[[u32; 3]]) -> Vec<[Option<u32>; 3]> {
    let mut edges: Vec<([u32; 2], u32)> =
        (0..).zip(triangles).flat_map(|(at, t)| edges_of(*t).map(|ends| (ends, at))).collect();
    edges.sort_unstable();
    let across = |[from, to]: [u32; 2]| {
        let at = edges.binary_search_by_key(&[to, from], |edge| edge.0).ok()?;
        Some(edges[at].1)
    };
    triangles.iter().map(|triangle| edges_of(*triangle).map(across)).collect()
}

/// The angle of a triangle at one of its corners.
fn angle_at(vertex: u32, corners: [u32; 3], points: &[DVec2]) -> f64 {
    let at = corners.iter().position(|corner| *corner == vertex).unwrap_or_default();
    let [here, next, last] = [at, at + 1, at + 2].map(|it| points[corners[it % 3] as usize]);
    angle([next - here, last - here])
}

/// The angle from one direction to another, counter-clockwise.
pub(super) fn angle([from, to]: [DVec2; 2]) -> f64 {
    let angle = libm::atan2(from.perp_dot(to), from.dot(to));
    if angle < 0.0 { angle + TAU } else { angle }
}

fn around(points: &[DVec2]) -> Bounds<glam::DVec3> {
    let fold = |pick: fn(DVec2, DVec2) -> DVec2, from: DVec2| {
        points.iter().fold(from, |a, b| pick(a, *b)).extend(0.0)
    };
    Bounds { min: fold(DVec2::min, DVec2::INFINITY), max: fold(DVec2::max, DVec2::NEG_INFINITY) }
}

/// The point of a segment that is nearest to a point.
pub(super) fn nearest_of([from, to]: [DVec2; 2], at: DVec2) -> DVec2 {
    let along = to - from;
    from + along * ((at - from).dot(along) / along.length_squared()).clamp(0.0, 1.0)
}

/// Whether two segments have a point in common.
pub(super) fn meet([a, b]: [DVec2; 2], [p, q]: [DVec2; 2]) -> bool {
    let parts = |[a, b]: [DVec2; 2], [p, q]: [DVec2; 2]| {
        let [one, other] = [orientation(a, b, p), orientation(a, b, q)];
        !(one > 0.0 && other > 0.0 || one < 0.0 && other < 0.0)
    };
    let [low, high] = [a.min(b), a.max(b)];
    let is_near = p.max(q).cmpge(low).all() && p.min(q).cmple(high).all();
    is_near && parts([a, b], [p, q]) && parts([p, q], [a, b])
}

/// Whether a triangle and a segment have a point in common.
fn touches([a, b, c]: [DVec2; 3], ends: [DVec2; 2]) -> bool {
    let is_in = |at: DVec2| {
        [[a, b], [b, c], [c, a]].into_iter().all(|[from, to]| orientation(from, to, at) >= 0.0)
    };
    is_in(ends[0]) || [[a, b], [b, c], [c, a]].into_iter().any(|edge| meet(edge, ends))
}
