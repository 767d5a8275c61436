//! Points on edges: they move nothing, and mend a short edge beside a long one and long edges in a strait.

use crate::chains::Chains;
use crate::changes::{BoundaryChange, ChangeKind, Left, Reason, Why};
use crate::demands::BoundaryDemands;
use crate::error::ConditionError;
use crate::tents::Arms;
use glam::DVec2;
use mindeg_interior::{SizeAt, grow_fast};
use std::collections::BTreeMap;

/// Rounds of dividing: each halves what is too long.
const ROUNDS: usize = 64;
/// Edges of more wanted lengths than this are divided, and with a size points are dropped up to such edges.
pub(crate) const LONGEST: f64 = 4.0 / 3.0;
/// Where lengths shall change gradually, tents in a strait do not even meet if they are so many times as high: that
/// leaves room for triangles with equal sides across it.
const ROOM: f64 = 2.0;
/// Halving the longer of two edges makes their ratio smaller if it is above this.
const UNEVEN: f64 = std::f64::consts::SQRT_2;
/// The most points of a boundary.
const MOST_POINTS: usize = 20_000_000;
/// Edges shorter than this share of the largest coordinate are not divided.
const SHORTEST: f64 = 1e-12;

impl Chains<'_> {
    /// Divides edges until all limits are as demanded, or nothing more helps.
    pub(crate) fn divide(&mut self, demands: &BoundaryDemands) -> Result<(), ConditionError> {
        let mut fresh: Vec<u32> = self.alive().collect();
        for _ in 0..ROUNDS {
            let long = self.long_edges(&fresh, demands);
            fresh.clear();
            for (vertex, why) in long {
                let at = self.middle(vertex);
                if !self.is_insert_free(vertex, at) {
                    continue;
                }
                let new = self.insert(vertex, at);
                let (kind, edge) =
                    (ChangeKind::Inserted, self.vertices[vertex as usize].point.edge);
                self.changes.push(BoundaryChange::of_edge(kind, at, why, edge));
                fresh.extend([vertex, new, self.next(new)]);
            }
            if fresh.is_empty() {
                break;
            }
            fresh.sort_unstable();
            fresh.dedup();
            if self.vertices.len() > MOST_POINTS {
                return Err(ConditionError::Points(MOST_POINTS));
            }
        }
        Ok(())
    }

    /// Whether a point may be put on the edge that begins at a vertex: rounded it is hardly on the line, and a vertex that nearly
    /// touches the edge may be between.
    pub(crate) fn is_insert_free(&self, vertex: u32, at: DVec2) -> bool {
        let [a, b] = [vertex, self.next(vertex)];
        let places = [a, a, b].map(|v| self.place(v));
        self.is_free([self.at(a), at, self.at(b)], places)
    }

    /// The edges that are to be divided because of what is around some vertices, each with the first reason: those there that are too
    /// long, those of straits, and those that grow too fast.
    pub(crate) fn long_edges(
        &self,
        fresh: &[u32],
        demands: &BoundaryDemands,
    ) -> BTreeMap<u32, Why> {
        let largest = self.alive().map(|v| self.at(v).abs().max_element()).fold(0.0, f64::max);
        // Tents that just do not meet leave no room for the triangles between them.
        let room = if demands.growth > 0.0 { ROOM } else { 1.0 };
        let roomy = libm::atan(room * libm::tan(demands.angle.to_radians())).to_degrees();
        let too_long = fresh.iter().flat_map(|vertex| self.to_divide(*vertex, demands));
        let fresh: Vec<u32> = fresh.iter().copied().filter(|v| self.is_edge(*v)).collect();
        let (edges, from) = self.edges_with_last(&fresh);
        let in_straits = self.in_straits(&edges, from, roomy, demands.angle).into_iter();
        let in_straits = in_straits.map(|edge| (edge, Why::Strait));
        let growing = self.growing(&edges, from, demands.growth).into_iter();
        let growing = growing.map(|edge| (edge, Why::Growth));
        let mut long: BTreeMap<u32, Why> = BTreeMap::new();
        for (edge, why) in too_long.chain(in_straits).chain(growing) {
            if !self.is_kept_edge(edge) && self.length(edge) >= SHORTEST * largest {
                long.entry(edge).or_insert(why);
            }
        }
        long
    }

    /// The wanted length of an edge at a place, if there is one.
    pub(crate) fn size_at(&self, at: DVec2, demands: &BoundaryDemands) -> Option<f64> {
        let size = (self.size_at)(at).min(demands.size.unwrap_or(f64::INFINITY));
        size.is_finite().then_some(size)
    }

    /// The edges at a vertex that are too long: for the size, or beside another one.
    fn to_divide(&self, vertex: u32, demands: &BoundaryDemands) -> Vec<(u32, Why)> {
        let mut long: Vec<(u32, Why)> = Vec::new();
        let (mut longest, mut shortest) = ((0.0, vertex), f64::INFINITY);
        for edge in self.edges_at(vertex) {
            let length = self.length(edge);
            let size = self.size_at(self.middle(edge), demands);
            if size.is_some_and(|size| length > LONGEST * size) {
                long.push((edge, Why::Size));
            }
            if length >= longest.0 {
                longest = (length, edge);
            }
            shortest = shortest.min(length);
        }
        // A corner that is too sharp gets the angle that it has, but for rounding.
        let wanted = demands.angle.min(self.limit_of_angles(vertex) * (1.0 - 1e-9));
        let is_uneven = longest.0 > UNEVEN * shortest && self.limit(vertex) < wanted;
        long.extend(is_uneven.then_some((longest.1, Why::Limit)));
        long
    }

    /// All edges, some of them last, and how many come before these.
    fn edges_with_last(&self, last: &[u32]) -> (Vec<u32>, usize) {
        let mut is_last = vec![false; self.vertices.len()];
        last.iter().for_each(|edge| is_last[*edge as usize] = true);
        let mut edges: Vec<u32> = self.edges().filter(|edge| !is_last[*edge as usize]).collect();
        let before = edges.len();
        edges.extend(last);
        (edges, before)
    }

    /// The edges that are too long for one near them and `growth` times their distance, if one of the two is from the index `from` on; none
    /// without growth.
    fn growing(&self, edges: &[u32], from: usize, growth: f64) -> Vec<u32> {
        if growth == 0.0 {
            return Vec::new();
        }
        let place = |edge: &u32| SizeAt { at: self.middle(*edge), size: self.length(*edge) };
        let places: Vec<SizeAt> = edges.iter().map(place).collect();
        let growing = grow_fast(&places, from, growth, LONGEST).into_iter();
        growing.map(|index| edges[index]).collect()
    }

    /// The limit of the whole, in degrees.
    pub(crate) fn limit_of_all(&self) -> f64 {
        let least = self.alive().map(|v| self.limit(v)).fold(60.0, f64::min);
        self.tents(least).into_iter().map(|tent| tent.0).fold(least, f64::min)
    }

    /// The places that stay below the demanded angle.
    pub(crate) fn left(&self, demands: &BoundaryDemands) -> Vec<Left> {
        let mut left: Vec<Left> = Vec::new();
        for vertex in self.alive().filter(|v| self.place(*v) == *v) {
            let limit = self.limit(vertex);
            if limit >= demands.angle {
                continue;
            }
            let reason = if self.is_meeting(vertex) {
                Reason::Meeting
            } else if self.is_kept(vertex) {
                Reason::Kept
            } else if self.limit_of_angles(vertex) < demands.angle {
                Reason::Sharp
            } else if [self.previous(vertex), vertex].iter().any(|edge| self.is_kept_edge(*edge)) {
                Reason::Kept
            } else {
                Reason::Short
            };
            left.push(Left { at: self.at(vertex), limit, reason });
        }
        let arms = Arms::of(self);
        for (limit, edges) in self.tents(demands.angle) {
            // The corner between them is there already.
            if arms.least_between(self, edges).is_some_and(|least| least <= limit) {
                continue;
            }
            let is_kept = edges.iter().any(|edge| self.is_kept_edge(*edge));
            let reason = if is_kept { Reason::Kept } else { Reason::Short };
            left.push(Left { at: self.at(edges[0]), limit, reason });
        }
        left
    }
}
