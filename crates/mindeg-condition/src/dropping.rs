//! Points that are dropped: each where the boundary moves least.

use crate::chains::{Chains, NONE, farthest};
use crate::changes::{BoundaryChange, ChangeKind, Point, Why};
use crate::demands::{BoundaryDemands, Hold, SHORT};
use crate::edges::LONGEST;
use glam::DVec2;
use std::cmp::Reverse;
use std::collections::{BinaryHeap, VecDeque};

impl Chains<'_> {
    /// Drops points at vertices whose limit is too small.
    pub(crate) fn simplify(&mut self, demands: &BoundaryDemands) {
        if demands.within == 0.0 {
            return;
        }
        let is_bad = |chains: &Self, v: u32| chains.limit(v) < demands.angle;
        let mut queue: VecDeque<u32> = self.alive().filter(|v| is_bad(self, *v)).collect();
        while let Some(vertex) = queue.pop_front() {
            if !self.vertices[vertex as usize].is_alive || !is_bad(self, vertex) {
                continue;
            }
            let near = self.neighbors(vertex).into_iter().map(|neighbor| neighbor.0);
            let moves = [vertex].into_iter().chain(near);
            let moves = moves.filter_map(|v| Some((self.drop_distance(v, demands)?, v)));
            let best = moves.min_by(|a, b| a.0.total_cmp(&b.0));
            if let Some((_, dropped)) = best {
                let ends = self.drop(dropped, Why::Limit);
                queue.extend(ends.into_iter().filter(|v| is_bad(self, *v)));
            }
        }
    }

    /// With a size, drops the points that are nearest to their neighbours' line, as long as no edge gets too long for it.
    pub(crate) fn thin(&mut self, demands: &BoundaryDemands) {
        if demands.size.is_none() || demands.within == 0.0 {
            return;
        }
        // Distances are not negative, so their bits have their order.
        let entry = |chains: &Self, vertex: u32| {
            let [u, w] = [chains.previous(vertex), chains.next(vertex)];
            let is_short = || {
                let [from, to] = [u, w].map(|v| chains.at(v));
                let size = chains.size_at(from.midpoint(to), demands);
                size.is_some_and(|size| from.distance(to) <= LONGEST * size)
            };
            let is_short = u != NONE && w != NONE && is_short();
            let distance = is_short.then(|| chains.drop_distance(vertex, demands))??;
            Some(Reverse((distance.to_bits(), vertex)))
        };
        let mut heap: BinaryHeap<_> = self.alive().filter_map(|v| entry(self, v)).collect();
        while let Some(top @ Reverse((_, vertex))) = heap.pop() {
            // Its neighbours may have changed.
            if self.vertices[vertex as usize].is_alive && entry(self, vertex) == Some(top) {
                let ends = self.drop(vertex, Why::Size);
                heap.extend(ends.into_iter().filter_map(|v| entry(self, v)));
            }
        }
    }

    /// Whether an edge is short beside the size.
    pub(crate) fn has_short(&self, demands: &BoundaryDemands) -> bool {
        self.edges().any(|edge| self.is_short(edge, demands))
    }

    fn is_short(&self, edge: u32, demands: &BoundaryDemands) -> bool {
        // Sizes of places alone ask for no longer edges.
        let size = demands.size.and_then(|_| self.size_at(self.middle(edge), demands));
        size.is_some_and(|size| self.length(edge) < SHORT * size)
    }

    /// Drops ends of edges that are short beside the size, the shortest first, where the angles at their neighbours allow it: what
    /// these have of uneven edges then, points on edges mend.
    pub(crate) fn join_short(&mut self, demands: &BoundaryDemands) {
        if demands.within == 0.0 {
            return;
        }
        let entry = |chains: &Self, edge: u32| {
            let length = chains.length(edge).to_bits();
            chains.is_short(edge, demands).then_some(Reverse((length, edge)))
        };
        let mut heap: BinaryHeap<_> = self.edges().filter_map(|edge| entry(self, edge)).collect();
        while let Some(top @ Reverse((_, edge))) = heap.pop() {
            if !self.is_edge(edge) || entry(self, edge) != Some(top) {
                continue;
            }
            let ends = [edge, self.next(edge)];
            let moves = ends
                .into_iter()
                .filter_map(|v| Some((self.drop_distance_of(v, demands, true)?, v)));
            if let Some((_, dropped)) = moves.min_by(|a, b| a.0.total_cmp(&b.0)) {
                let [before, _] = self.drop(dropped, Why::Size);
                heap.extend(entry(self, before));
            }
        }
    }

    /// How far the boundary moves if a vertex is dropped; none if it may not be.
    pub(crate) fn drop_distance(&self, vertex: u32, demands: &BoundaryDemands) -> Option<f64> {
        self.drop_distance_of(vertex, demands, false)
    }

    /// [`drop_distance`](Self::drop_distance), or that of a vertex of a short edge.
    fn drop_distance_of(
        &self,
        vertex: u32,
        demands: &BoundaryDemands,
        is_short: bool,
    ) -> Option<f64> {
        let own = &self.vertices[vertex as usize];
        if own.hold > Hold::End || own.previous == NONE || own.next == NONE {
            return None;
        }
        let (u, v, w) = (own.previous, vertex, own.next);
        let ends = [u, w].map(|v| self.at(v));
        let of = |v: u32| farthest(&self.vertices[v as usize].dropped, ends);
        let distance = farthest(&[self.at(v)], ends).max(of(u)).max(of(v));
        if distance > demands.within {
            return None;
        }
        let limit = |chain: &Self, of: u32, to: DVec2| match is_short {
            true => chain.limit_of_angles_with(of, v, to),
            false => chain.limit_with(of, v, to),
        };
        let new = limit(self, u, ends[1]).min(limit(self, w, ends[0]));
        let old = [u, v, w].map(|v| self.limit(v)).into_iter().fold(demands.angle, f64::min);
        let is_better = new >= demands.angle || new > old;
        let places = [u, v, w].map(|v| self.place(v));
        // Neither does a ring of three points lose one, nor do two lines between the same places become one.
        let is_apart = || {
            let neighbors = self.neighbors(u);
            !neighbors.iter().any(|neighbor| self.place(neighbor.0) == places[2])
        };
        let is_free = || self.is_free([ends[0], self.at(v), ends[1]], places);
        (is_better && places[0] != places[2] && is_apart() && is_free()).then_some(distance)
    }

    /// Drops a vertex. Returns its neighbours.
    pub(crate) fn drop(&mut self, vertex: u32, why: Why) -> [u32; 2] {
        // Across the end of a straight side the edge is of the other one.
        self.leave_straight(self.previous(vertex), vertex);
        let own = &mut self.vertices[vertex as usize];
        own.is_alive = false;
        let (u, w, Point { at, edge, .. }) = (own.previous, own.next, own.point);
        let after = std::mem::take(&mut own.dropped);
        let before = &mut self.vertices[u as usize];
        // The edge is another one.
        before.hold = before.hold.min(Hold::Point);
        before.next = w;
        before.dropped.push(at);
        before.dropped.extend(after);
        self.vertices[w as usize].previous = u;
        self.changes.push(BoundaryChange::of_edge(ChangeKind::Dropped, at, why, edge));
        self.put_along(u);
        [u, w]
    }
}
