//! Rings and lines of points that are dropped and put between others, with the old points that they stand for.
//!
//! Each ring is a chain, and each line. Where lines meet each other or rings, each chain has a vertex of its own at the one
//! place; these stay.

use crate::changes::{BoundaryChange, ChangeKind, Point, Why};
use crate::demands::{Given, Hold, SizeAtPlace};
use crate::grid::Grid;
use glam::DVec2;
use mindeg_mesh::planar::PlanarBoundary;
use std::collections::{BTreeMap, BTreeSet};

/// No vertex: before the first one of an open line, and after the last.
pub(crate) const NONE: u32 = u32::MAX;

/// A point, linked with those before and after it on its chain.
pub(crate) struct Vertex {
    pub(crate) point: Point,
    pub(crate) previous: u32,
    pub(crate) next: u32,
    pub(crate) chain: u32,
    /// The first vertex at its place.
    pub(crate) place: u32,
    pub(crate) hold: Hold,
    pub(crate) is_alive: bool,
    /// Whether the domain is on the left and on the right of the edge from here to the next point.
    pub(crate) has_domain: [bool; 2],
    /// Whether that edge is of a side that stays straight.
    pub(crate) is_straight: bool,
    /// The dropped points that this edge stands for, in order.
    pub(crate) dropped: Vec<DVec2>,
    /// How far a point that was put on an edge was from the old boundary then, at most.
    pub(crate) off: f64,
    /// Where it was before it was moved.
    pub(crate) home: Option<DVec2>,
}

/// All rings and lines, and the log of changes.
pub(crate) struct Chains<'a> {
    pub(crate) vertices: Vec<Vertex>,
    /// How many chains are rings, and how many are lines, which follow.
    rings: usize,
    lines: usize,
    /// All vertices at each place where chains meet or end.
    meetings: BTreeMap<u32, Vec<u32>>,
    pub(crate) grid: Grid,
    /// So many triangles meet at each vertex of a ring, at least.
    pub(crate) least_triangles: u32,
    /// Points that no change may take to the other side.
    marks: Vec<DVec2>,
    marked: Grid,
    pub(crate) changes: Vec<BoundaryChange>,
    pub(crate) size_at: &'a SizeAtPlace<'a>,
    /// Longer edges are in the grid at every such length too, once points are moved; infinite before.
    pub(crate) spacing: f64,
    /// How far points were moved at most.
    pub(crate) shifted: f64,
}

impl<'a> Chains<'a> {
    /// The chains of a boundary.
    pub(crate) fn new(
        boundary: &PlanarBoundary,
        Given { hold, has_domain, is_straight, size_at, marks }: &Given<
            'a,
            impl Fn(u32) -> Hold,
            impl Fn(u32) -> [bool; 2],
            impl Fn(u32) -> bool,
        >,
        least_triangles: u32,
    ) -> Self {
        let mut vertices: Vec<Vertex> = Vec::with_capacity(boundary.edge_count() as usize);
        let mut vertex = |of: u32, edge: u32, [previous, next]: [u32; 2], chain: usize| {
            let index = vertices.len() as u32;
            vertices.push(Vertex {
                point: Point { at: boundary.point(of), of: Some(of), edge },
                previous,
                next,
                chain: chain as u32,
                place: index,
                hold: if next == NONE { Hold::Point } else { hold(edge) },
                is_alive: true,
                has_domain: if next == NONE { [false; 2] } else { has_domain(edge) },
                is_straight: next != NONE && is_straight(edge),
                dropped: Vec::new(),
                off: 0.0,
                home: None,
            });
        };
        for (chain, range) in boundary.rings().enumerate() {
            let (first, last) = (range.start, range.end - 1);
            for at in range {
                let previous = if at == first { last } else { at - 1 };
                vertex(at, at, [previous, if at == last { first } else { at + 1 }], chain);
            }
        }
        let (rings, mut edge) = (boundary.ring_count(), boundary.vertex_count());
        let mut first = edge;
        for line in 0..boundary.line_count() {
            let segments = boundary.line(line);
            let is_closed = is_closed(segments);
            let last = first + segments.len() as u32 - u32::from(is_closed);
            let link = |at: u32, end: u32, to: u32, around: u32| match at == end {
                true if is_closed => around,
                true => NONE,
                false => to,
            };
            for (index, ends) in (first..).zip(segments) {
                let previous = link(index, first, index.wrapping_sub(1), last);
                let links = [previous, link(index, last, index + 1, first)];
                vertex(ends[0], edge, links, rings + line);
                edge += 1;
            }
            if let (false, Some(ends)) = (is_closed, segments.last()) {
                vertex(ends[1], edge - 1, [last - 1, NONE], rings + line);
            }
            first = last + 1;
        }
        let points: Vec<DVec2> = vertices.iter().map(|vertex| vertex.point.at).collect();
        let in_segments: BTreeSet<u32> =
            boundary.segments().as_flattened().iter().copied().collect();
        let loose = (boundary.vertex_count()..)
            .zip(boundary.inner_points())
            .filter(|(vertex, _)| !in_segments.contains(vertex));
        let marks: Vec<DVec2> =
            loose.map(|(_, point)| *point).chain(marks.iter().copied()).collect();
        let mut chains = Self {
            vertices,
            rings,
            lines: boundary.line_count(),
            meetings: BTreeMap::new(),
            grid: Grid::new(&points),
            marked: Grid::new(&marks),
            least_triangles,
            marks,
            changes: Vec::new(),
            size_at: *size_at,
            spacing: f64::INFINITY,
            shifted: 0.0,
        };
        chains.meet();
        chains
    }

    /// Finds the places where chains meet or end, and keeps them.
    fn meet(&mut self) {
        let mut at_place: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for (index, vertex) in (0..).zip(&self.vertices) {
            at_place.entry(vertex.point.of.unwrap_or(NONE)).or_default().push(index);
        }
        for (_, own) in at_place {
            let is_end = |v: &u32| {
                let Vertex { previous, next, .. } = self.vertices[*v as usize];
                previous == NONE || next == NONE
            };
            if own.len() == 1 && !own.iter().any(is_end) {
                continue;
            }
            for &vertex in &own {
                let vertex = &mut self.vertices[vertex as usize];
                vertex.place = own[0];
                vertex.hold = vertex.hold.max(Hold::Point);
            }
            self.meetings.insert(own[0], own);
        }
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

    pub(crate) fn place(&self, vertex: u32) -> u32 {
        self.vertices[vertex as usize].place
    }

    pub(crate) fn alive(&self) -> impl Iterator<Item = u32> + use<'_> {
        (0..).zip(&self.vertices).filter(|(_, vertex)| vertex.is_alive).map(|(index, _)| index)
    }

    /// Whether an edge begins at a vertex that is there.
    pub(crate) fn is_edge(&self, vertex: u32) -> bool {
        let vertex = &self.vertices[vertex as usize];
        vertex.is_alive && vertex.next != NONE
    }

    /// The edges, each by its first vertex.
    pub(crate) fn edges(&self) -> impl Iterator<Item = u32> + use<'_> {
        self.alive().filter(|vertex| self.next(*vertex) != NONE)
    }

    /// The vertices that edges join to the place of a vertex, each with whether the domain is on the left of the edge as seen from there.
    pub(crate) fn neighbors(&self, vertex: u32) -> Vec<(u32, bool)> {
        let mut neighbors = Vec::with_capacity(2);
        for edge in self.edges_at(vertex) {
            let (own, next) = (&self.vertices[edge as usize], self.next(edge));
            if own.place == self.place(vertex) {
                neighbors.push((next, own.has_domain[0]));
            } else {
                neighbors.push((edge, own.has_domain[1]));
            }
        }
        neighbors
    }

    /// Whether chains meet or end at a vertex.
    pub(crate) fn is_meeting(&self, vertex: u32) -> bool {
        self.meetings.contains_key(&self.place(vertex))
    }

    /// The edges at the place of a vertex.
    pub(crate) fn edges_at(&self, vertex: u32) -> impl Iterator<Item = u32> + use<'_> {
        let own = self.meetings.get(&self.place(vertex));
        let single = if own.is_none() { Some(vertex) } else { None };
        let all = own.into_iter().flatten().copied().chain(single);
        all.flat_map(|v| [self.previous(v), v]).filter(|edge| *edge != NONE && self.is_edge(*edge))
    }

    /// The length of the edge from a vertex to the next.
    pub(crate) fn length(&self, vertex: u32) -> f64 {
        self.at(vertex).distance(self.at(self.next(vertex)))
    }

    /// The middle of the edge from a vertex to the next.
    pub(crate) fn middle(&self, vertex: u32) -> DVec2 {
        self.at(vertex).midpoint(self.at(self.next(vertex)))
    }

    /// The chains that are left, each from its first point that is there.
    pub(crate) fn order(&self) -> Vec<Vec<u32>> {
        let mut chains: Vec<Vec<u32>> = vec![Vec::new(); self.rings + self.lines];
        for first in self.alive() {
            let chain = &mut chains[self.vertices[first as usize].chain as usize];
            if chain.is_empty() {
                chain.push(first);
                let mut at = self.next(first);
                while at != first && at != NONE {
                    chain.push(at);
                    at = self.next(at);
                }
            }
        }
        chains
    }

    /// The points of the rings that are left, and of the lines.
    pub(crate) fn points(&self) -> (Vec<Vec<Point>>, Vec<Vec<Point>>) {
        let point = |vertex: u32| self.vertices[vertex as usize].point;
        let mut rings = self.order();
        let lines = rings.split_off(self.rings);
        rings.retain(|ring| !ring.is_empty());
        let points = |chains: Vec<Vec<u32>>| {
            chains.into_iter().map(|chain| chain.into_iter().map(point).collect()).collect()
        };
        (points(rings), points(lines))
    }

    /// The rings that are left.
    pub(crate) fn ring_order(&self) -> Vec<Vec<u32>> {
        let mut rings = self.order();
        rings.truncate(self.rings);
        rings.retain(|ring| !ring.is_empty());
        rings
    }

    /// The greatest distance of a dropped point from the edge that stands for it, or of a moved one from its place.
    pub(crate) fn moved(&self) -> f64 {
        let of_edge = |vertex: u32| {
            let ends = [vertex, self.next(vertex)].map(|v| self.at(v));
            farthest(&self.vertices[vertex as usize].dropped, ends)
        };
        self.edges().map(of_edge).fold(self.shifted, f64::max)
    }

    /// How far the boundary moved at each dropped, moved or new point.
    pub(crate) fn distances(&self) -> BTreeMap<[u64; 2], f64> {
        let key = |at: DVec2| at.to_array().map(f64::to_bits);
        let mut distances = BTreeMap::new();
        for vertex in self.alive() {
            let own = &self.vertices[vertex as usize];
            if own.next != NONE {
                let ends = [vertex, own.next].map(|v| self.at(v));
                let dropped = own.dropped.iter();
                distances.extend(dropped.map(|point| (key(*point), farthest(&[*point], ends))));
            }
            let moved = match own.home {
                Some(home) => Some((home, home.distance(own.point.at) + own.off)),
                None => own.point.of.is_none().then_some((own.point.at, own.off)),
            };
            distances.extend(moved.map(|(at, moved)| (key(at), moved)));
        }
        distances
    }

    /// Drops the holes of a smaller area, but for those with a point that stays.
    pub(crate) fn drop_holes(&mut self, least: f64) {
        for ring in self.order().into_iter().take(self.rings).skip(1) {
            let at = |index: usize| self.at(ring[index % ring.len()]);
            let doubled: f64 = (0..ring.len()).map(|i| at(i).perp_dot(at(i + 1))).sum();
            let is_kept = ring.iter().any(|v| self.is_kept(*v));
            if doubled.abs() / 2.0 >= least || is_kept {
                continue;
            }
            let center = ring.iter().map(|v| self.at(*v)).sum::<DVec2>() / ring.len() as f64;
            let edge = self.vertices[ring[0] as usize].point.edge;
            let kind = ChangeKind::HoleDropped;
            self.changes.push(BoundaryChange::of_edge(kind, center, Why::Area, edge));
            ring.iter().for_each(|v| self.vertices[*v as usize].is_alive = false);
        }
    }

    /// Whether the triangle that would change sides is free: it has no mark, and no point but those at `places`.
    pub(crate) fn is_free(&self, corners: [DVec2; 3], places: [u32; 3]) -> bool {
        let is_other = |v: u32| {
            let vertex = &self.vertices[v as usize];
            vertex.is_alive && !places.contains(&vertex.place)
        };
        !self.grid.any_within(corners, |v| self.at(v), is_other)
            && !self.marked.any_within(corners, |mark| self.marks[mark as usize], |_| true)
    }

    /// Puts a point on the edge that begins at a vertex.
    pub(crate) fn insert(&mut self, vertex: u32, at: DVec2) -> u32 {
        let new = self.vertices.len() as u32;
        let next = self.next(vertex);
        let ends = [vertex, next].map(|v| self.at(v));
        // Ends that were moved take the edge with them.
        let moved = |v: u32| {
            let own = &self.vertices[v as usize];
            own.off + own.home.map_or(0.0, |home| home.distance(own.point.at))
        };
        let ends_off = moved(vertex).max(moved(next));
        let own = &mut self.vertices[vertex as usize];
        let off = farthest(&own.dropped, ends).max(ends_off);
        // Points before the new one stay with the first half, in their order.
        let share = share_along(at, ends);
        let until = own.dropped.iter().position(|point| share_along(*point, ends) > share);
        let dropped = own.dropped.split_off(until.unwrap_or(own.dropped.len()));
        let point = Point { at, of: None, edge: own.point.edge };
        let (chain, has_domain, is_straight) = (own.chain, own.has_domain, own.is_straight);
        own.next = new;
        self.vertices.push(Vertex {
            point,
            previous: vertex,
            next,
            chain,
            place: new,
            hold: Hold::Free,
            is_alive: true,
            has_domain,
            is_straight,
            dropped,
            off,
            home: None,
        });
        self.vertices[next as usize].previous = new;
        self.grid.insert(new, at);
        self.put_along(new);
        new
    }

    /// Whether the point of a vertex stays.
    pub(crate) fn is_kept(&self, vertex: u32) -> bool {
        self.vertices[vertex as usize].hold >= Hold::Point
    }

    /// Whether the edge that begins at a vertex is not divided.
    pub(crate) fn is_kept_edge(&self, edge: u32) -> bool {
        self.vertices[edge as usize].hold == Hold::Edge
    }
}

/// Whether a line ends where it begins.
pub(crate) fn is_closed(segments: &[[u32; 2]]) -> bool {
    segments.first().map(|ends| ends[0]) == segments.last().map(|ends| ends[1])
}

/// The greatest distance of some points from a segment.
pub(crate) fn farthest(points: &[DVec2], ends @ [a, b]: [DVec2; 2]) -> f64 {
    let distance =
        |&point: &DVec2| point.distance(a.lerp(b, share_along(point, ends).clamp(0.0, 1.0)));
    points.iter().map(distance).fold(0.0, f64::max)
}

/// Where along a segment a point is: 0 at its start, 1 at its end.
pub(crate) fn share_along(point: DVec2, [a, b]: [DVec2; 2]) -> f64 {
    let along = b - a;
    let squared = along.length_squared();
    if squared > 0.0 { (point - a).dot(along) / squared } else { 0.0 }
}
