//! Rings of points that are dropped and put between others, with the old points that they stand for.

use crate::changes::{BoundaryChange, ChangeKind, Point};
use crate::demands::{BoundaryDemands, Hold};
use crate::grid::Grid;
use glam::DVec2;
use mindeg_interior::limits::{degree_limit, fan_limit};
use mindeg_mesh::planar::PlanarBoundary;
use std::cmp::Reverse;
use std::collections::{BTreeSet, BinaryHeap, VecDeque};
use std::f64::consts::TAU;

/// The edges that a boundary vertex may have, but for reflex corners.
pub(crate) const MOST_EDGES: u32 = 5;

/// With a size, points are dropped up to edges of so many sizes.
const LONGEST: f64 = 4.0 / 3.0;

/// A point, linked with those before and after it on its ring.
pub(crate) struct Vertex {
    pub(crate) point: Point,
    pub(crate) previous: u32,
    pub(crate) next: u32,
    pub(crate) ring: u32,
    pub(crate) hold: Hold,
    pub(crate) is_alive: bool,
    /// The dropped points that the edge from here to the next point stands for, in order.
    pub(crate) dropped: Vec<DVec2>,
}

/// All rings, and the log of changes.
pub(crate) struct Rings {
    pub(crate) vertices: Vec<Vertex>,
    /// The points of each ring; 0 if it was dropped.
    pub(crate) counts: Vec<u32>,
    pub(crate) grid: Grid,
    pub(crate) changes: Vec<BoundaryChange>,
}

impl Rings {
    pub(crate) fn new(boundary: &PlanarBoundary, hold: impl Fn(u32) -> Hold) -> Self {
        let mut vertices = Vec::with_capacity(boundary.points().len());
        for (ring, range) in (0..).zip(boundary.rings()) {
            let (first, last) = (range.start, range.end - 1);
            vertices.extend(range.map(|vertex| Vertex {
                point: Point { at: boundary.point(vertex), of: Some(vertex), edge: vertex },
                previous: if vertex == first { last } else { vertex - 1 },
                next: if vertex == last { first } else { vertex + 1 },
                ring,
                hold: hold(vertex),
                is_alive: true,
                dropped: Vec::new(),
            }));
        }
        let counts = boundary.rings().map(|range| range.len() as u32).collect();
        Self { vertices, counts, grid: Grid::new(boundary.points()), changes: Vec::new() }
    }

    pub(crate) fn at(&self, vertex: u32) -> DVec2 {
        self.vertices[vertex as usize].point.at
    }

    pub(crate) fn previous(&self, vertex: u32) -> u32 {
        self.vertices[vertex as usize].previous
    }

    pub(crate) fn next(&self, vertex: u32) -> u32 {
        self.vertices[vertex as usize].next
    }

    pub(crate) fn alive(&self) -> impl Iterator<Item = u32> + use<'_> {
        (0..).zip(&self.vertices).filter(|(_, vertex)| vertex.is_alive).map(|(index, _)| index)
    }

    /// The length of the edge from a vertex to the next.
    pub(crate) fn length(&self, vertex: u32) -> f64 {
        self.at(vertex).distance(self.at(self.next(vertex)))
    }

    /// The interior angle at a vertex, in radians.
    pub(crate) fn angle(&self, vertex: u32) -> f64 {
        angle([self.previous(vertex), vertex, self.next(vertex)].map(|v| self.at(v)))
    }

    /// The fan limit at a vertex, in degrees.
    pub(crate) fn limit(&self, vertex: u32) -> f64 {
        limit([self.previous(vertex), vertex, self.next(vertex)].map(|v| self.at(v)))
    }

    /// The rings that are left, each from its first point that is there.
    pub(crate) fn order(&self) -> Vec<Vec<u32>> {
        let mut rings: Vec<Vec<u32>> = vec![Vec::new(); self.counts.len()];
        for first in self.alive() {
            let ring = &mut rings[self.vertices[first as usize].ring as usize];
            if ring.is_empty() {
                ring.push(first);
                let mut at = self.next(first);
                while at != first {
                    ring.push(at);
                    at = self.next(at);
                }
            }
        }
        rings.retain(|ring| !ring.is_empty());
        rings
    }

    pub(crate) fn points(&self) -> Vec<Vec<Point>> {
        let point = |vertex: u32| self.vertices[vertex as usize].point;
        self.order().into_iter().map(|ring| ring.into_iter().map(point).collect()).collect()
    }

    /// The greatest distance of a dropped point from the edge that stands for it.
    pub(crate) fn moved(&self) -> f64 {
        let of_edge = |vertex: u32| {
            let ends = [vertex, self.next(vertex)].map(|v| self.at(v));
            farthest(&self.vertices[vertex as usize].dropped, ends)
        };
        self.alive().map(of_edge).fold(0.0, f64::max)
    }

    /// Drops the holes of a smaller area, but for those with a point that stays.
    pub(crate) fn drop_holes(&mut self, least: f64) {
        for ring in self.order().into_iter().skip(1) {
            let at = |index: usize| self.at(ring[index % ring.len()]);
            let doubled: f64 = (0..ring.len()).map(|i| at(i).perp_dot(at(i + 1))).sum();
            let is_kept = ring.iter().any(|v| self.is_kept(*v));
            if doubled.abs() / 2.0 >= least || is_kept {
                continue;
            }
            let center = ring.iter().map(|v| self.at(*v)).sum::<DVec2>() / ring.len() as f64;
            self.changes.push(BoundaryChange { kind: ChangeKind::HoleDropped, at: center });
            self.counts[self.vertices[ring[0] as usize].ring as usize] = 0;
            ring.iter().for_each(|v| self.vertices[*v as usize].is_alive = false);
        }
    }

    /// Drops points: with a size, those that are nearest to their neighbours' line first; then those at vertices
    /// whose limit is too small.
    pub(crate) fn simplify(&mut self, demands: &BoundaryDemands) {
        if demands.within == 0.0 {
            return;
        }
        if let Some(size) = demands.size {
            self.thin(demands, size * LONGEST);
        }
        let is_bad = |rings: &Self, v: u32| rings.limit(v) < demands.angle;
        let mut queue: VecDeque<u32> = self.alive().filter(|v| is_bad(self, *v)).collect();
        while let Some(vertex) = queue.pop_front() {
            if !self.vertices[vertex as usize].is_alive || !is_bad(self, vertex) {
                continue;
            }
            let near = [vertex, self.previous(vertex), self.next(vertex)];
            let moves = near.iter().filter_map(|v| Some((self.drop_distance(*v, demands)?, *v)));
            let best = moves.min_by(|a, b| a.0.total_cmp(&b.0));
            if let Some((_, dropped)) = best {
                let ends = self.drop(dropped);
                queue.extend(ends.into_iter().filter(|v| is_bad(self, *v)));
            }
        }
    }

    /// Drops the points that are nearest to their neighbours' line, as long as no edge gets longer than `longest`.
    fn thin(&mut self, demands: &BoundaryDemands, longest: f64) {
        // Distances are not negative, so their bits have their order.
        let entry = |rings: &Self, vertex: u32| {
            let [u, w] = [rings.previous(vertex), rings.next(vertex)];
            let is_short = rings.at(u).distance(rings.at(w)) <= longest;
            let distance = is_short.then(|| rings.drop_distance(vertex, demands))??;
            Some(Reverse((distance.to_bits(), vertex)))
        };
        let mut heap: BinaryHeap<_> = self.alive().filter_map(|v| entry(self, v)).collect();
        while let Some(top @ Reverse((_, vertex))) = heap.pop() {
            // Its neighbours may have changed.
            if self.vertices[vertex as usize].is_alive && entry(self, vertex) == Some(top) {
                let ends = self.drop(vertex);
                heap.extend(ends.into_iter().filter_map(|v| entry(self, v)));
            }
        }
    }

    /// How far the boundary moves if a vertex is dropped; none if it may not be.
    fn drop_distance(&self, vertex: u32, demands: &BoundaryDemands) -> Option<f64> {
        let own = &self.vertices[vertex as usize];
        if own.hold > Hold::Free || self.counts[own.ring as usize] <= 3 {
            return None;
        }
        let (u, v, w) = (own.previous, vertex, own.next);
        let ends = [u, w].map(|v| self.at(v));
        let of = |v: u32| farthest(&self.vertices[v as usize].dropped, ends);
        let distance = farthest(&[self.at(v)], ends).max(of(u)).max(of(v));
        if distance > demands.within {
            return None;
        }
        let [before, after] = [self.previous(u), self.next(w)].map(|v| self.at(v));
        let new = limit([before, ends[0], ends[1]]).min(limit([ends[0], ends[1], after]));
        let old = [u, v, w].map(|v| self.limit(v)).into_iter().fold(demands.angle, f64::min);
        let is_better = new >= demands.angle || new > old;
        let is_free = || {
            let is_other = |v: u32| ![own.previous, vertex, own.next].contains(&v);
            let is_in_the_way = |v: u32| is_other(v) && self.vertices[v as usize].is_alive;
            !self.grid.any_within([ends[0], self.at(v), ends[1]], |v| self.at(v), is_in_the_way)
        };
        (is_better && is_free()).then_some(distance)
    }

    /// Drops a vertex. Returns its neighbours.
    fn drop(&mut self, vertex: u32) -> [u32; 2] {
        let own = &mut self.vertices[vertex as usize];
        own.is_alive = false;
        let (u, w, at, ring) = (own.previous, own.next, own.point.at, own.ring);
        let after = std::mem::take(&mut own.dropped);
        let before = &mut self.vertices[u as usize];
        // The edge is another one.
        before.hold = before.hold.min(Hold::Point);
        before.next = w;
        before.dropped.push(at);
        before.dropped.extend(after);
        self.vertices[w as usize].previous = u;
        self.counts[ring as usize] -= 1;
        self.changes.push(BoundaryChange { kind: ChangeKind::Dropped, at });
        [u, w]
    }

    /// Puts a point on the edge that begins at a vertex.
    pub(crate) fn insert(&mut self, vertex: u32, at: DVec2) -> u32 {
        let new = self.vertices.len() as u32;
        let next = self.next(vertex);
        let ends = [vertex, next].map(|v| self.at(v));
        let own = &mut self.vertices[vertex as usize];
        // Points before the new one stay with the first half, in their order.
        let share = share_along(at, ends);
        let until = own.dropped.iter().position(|point| share_along(*point, ends) > share);
        let dropped = own.dropped.split_off(until.unwrap_or(own.dropped.len()));
        let point = Point { at, of: None, edge: own.point.edge };
        let ring = own.ring;
        own.next = new;
        self.vertices.push(Vertex {
            point,
            previous: vertex,
            next,
            ring,
            hold: Hold::Free,
            is_alive: true,
            dropped,
        });
        self.vertices[next as usize].previous = new;
        self.counts[ring as usize] += 1;
        self.grid.insert(new, at);
        new
    }

    /// Whether the point of a vertex stays.
    pub(crate) fn is_kept(&self, vertex: u32) -> bool {
        self.vertices[vertex as usize].hold >= Hold::Point
    }

    /// Whether the edge that begins at a vertex is not divided.
    pub(crate) fn is_kept_edge(&self, vertex: u32) -> bool {
        self.vertices[vertex as usize].hold == Hold::Edge
    }

    /// The vertices of a set that are there.
    pub(crate) fn only_alive(
        &self,
        vertices: BTreeSet<u32>,
    ) -> impl Iterator<Item = u32> + use<'_> {
        vertices.into_iter().filter(|v| self.vertices[*v as usize].is_alive)
    }
}

/// The interior angle at the second of three points of a ring, in radians.
fn angle([before, at, after]: [DVec2; 3]) -> f64 {
    let (out, back) = (after - at, before - at);
    let angle = libm::atan2(out.perp_dot(back), out.dot(back));
    if angle < 0.0 { angle + TAU } else { angle }
}

/// The fan limit at the second of three points of a ring, in degrees.
fn limit(points @ [before, at, after]: [DVec2; 3]) -> f64 {
    let angle = angle(points);
    let triangles = degree_limit(angle, MOST_EDGES) - 1;
    fan_limit(angle, before.distance(at), at.distance(after), Some(triangles))
}

/// The greatest distance of some points from a segment.
pub(crate) fn farthest(points: &[DVec2], ends @ [a, b]: [DVec2; 2]) -> f64 {
    let distance =
        |&point: &DVec2| point.distance(a.lerp(b, share_along(point, ends).clamp(0.0, 1.0)));
    points.iter().map(distance).fold(0.0, f64::max)
}

/// Where along a segment a point is: 0 at its start, 1 at its end.
fn share_along(point: DVec2, [a, b]: [DVec2; 2]) -> f64 {
    let along = b - a;
    let squared = along.length_squared();
    if squared > 0.0 { (point - a).dot(along) / squared } else { 0.0 }
}
