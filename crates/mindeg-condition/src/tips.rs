//! Sharp corners: no mesh has a greater minimum angle than the angle of a corner, so a tip is cut off.

use crate::chains::{Chains, farthest};
use crate::changes::{BoundaryChange, ChangeKind, Why};
use crate::demands::BoundaryDemands;

/// At most this share of an edge is cut off with a tip.
const MOST_OF_EDGE: f64 = 0.5;
/// So often a cut is halved until the boundary moves little enough and nothing is in its way.
const TRIES: usize = 20;

impl Chains<'_> {
    /// Cuts off corners that are sharper than the demanded angle, as far as the boundary may move, but no farther than
    /// it takes for an edge of the wanted length.
    pub(crate) fn cut_tips(&mut self, demands: &BoundaryDemands) {
        if demands.within == 0.0 {
            return;
        }
        let is_tip = |v: &u32| self.limit_of_angles(*v) < demands.angle;
        let tips: Vec<u32> = self.alive().filter(is_tip).collect();
        for tip in tips {
            if !self.is_kept(tip) {
                self.cut(tip, demands);
            }
        }
    }

    fn cut(&mut self, tip: u32, demands: &BoundaryDemands) {
        let [before, after] = [self.previous(tip), self.next(tip)];
        let (at, half) = (self.at(tip), self.angle(tip) / 2.0);
        let edges = [before, after].map(|v| self.at(v) - at);
        let shortest = edges[0].length().min(edges[1].length());
        let size = self.size_at(at, demands).unwrap_or(f64::INFINITY);
        let for_size = size / (2.0 * libm::sin(half));
        // A hair less, so that no rounding takes the cut farther.
        let mut cut = (demands.within * (1.0 - 1e-9) / libm::cos(half))
            .min(MOST_OF_EDGE * shortest)
            .min(for_size);
        for _ in 0..TRIES {
            let ends = edges.map(|edge| at + edge * (cut / edge.length()));
            let places = [before, tip, after].map(|v| self.place(v));
            let is_free = self.is_free([ends[0], at, ends[1]], places);
            let olds = [before, tip].map(|v| &self.vertices[v as usize].dropped[..]).concat();
            // Old points of what is left of the two edges are counted too: that is on the safe side.
            let near = [[self.at(before), ends[0]], ends, [ends[1], self.at(after)]];
            let moved = |point| {
                near.map(|edge| farthest(&[point], edge)).into_iter().fold(f64::INFINITY, f64::min)
            };
            let is_near = olds.into_iter().chain([at]).all(|point| moved(point) <= demands.within);
            let is_new = ends[0] != ends[1] && ends.iter().all(|end| *end != at);
            if is_free && is_near && is_new {
                // The tip goes; the points around it stand for it.
                let second = self.insert(tip, ends[1]);
                let first = self.insert(before, ends[0]);
                self.leave_straight(first, tip);
                let own = &mut self.vertices[tip as usize];
                own.is_alive = false;
                let dropped = std::mem::take(&mut own.dropped);
                self.vertices[first as usize].next = second;
                self.vertices[first as usize].dropped.push(at);
                self.vertices[first as usize].dropped.extend(dropped);
                self.vertices[second as usize].previous = first;
                self.put_along(first);
                let edge = self.vertices[tip as usize].point.edge;
                self.changes.push(BoundaryChange::of_edge(ChangeKind::Cut, at, Why::Limit, edge));
                return;
            }
            cut /= 2.0;
        }
    }
}
