//! Points on edges: they move nothing, and mend a short edge beside a long one and long edges in a strait.

use crate::changes::{BoundaryChange, ChangeKind, Left, Reason};
use crate::demands::BoundaryDemands;
use crate::error::ConditionError;
use crate::rings::Rings;
use glam::DVec2;
use mindeg_interior::limits::tents_below;
use mindeg_mesh::planar::PlanarBoundary;
use std::collections::BTreeSet;

/// Rounds of dividing: each halves what is too long.
const ROUNDS: usize = 64;
/// Edges of more wanted lengths than this are divided.
const LONGEST: f64 = 4.0 / 3.0;
/// Where lengths shall change gradually, tents in a strait do not even meet if they are so many times as high: that
/// leaves room for triangles with equal sides across it.
const ROOM: f64 = 2.0;
/// Halving the longer of two edges makes their ratio smaller if it is above this.
const UNEVEN: f64 = std::f64::consts::SQRT_2;
/// The most points of a boundary.
const MOST_POINTS: usize = 20_000_000;
/// Edges shorter than this share of the largest coordinate are not divided.
const SHORTEST: f64 = 1e-12;

impl Rings {
    /// Divides edges until all limits are as demanded, or nothing more helps.
    pub(crate) fn divide(&mut self, demands: &BoundaryDemands) -> Result<(), ConditionError> {
        let largest = self.alive().map(|v| self.at(v).abs().max_element()).fold(0.0, f64::max);
        // Tents that just do not meet leave no room for the triangles between them.
        let room = if demands.growth > 0.0 { ROOM } else { 1.0 };
        let roomy = libm::atan(room * libm::tan(demands.angle.to_radians())).to_degrees();
        let mut fresh: Vec<u32> = self.alive().collect();
        for _ in 0..ROUNDS {
            let mut long: BTreeSet<u32> = BTreeSet::new();
            for vertex in fresh.drain(..) {
                long.extend(self.to_divide(vertex, demands));
            }
            long.extend(self.in_straits(roomy, demands.angle));
            long.extend(self.alive().filter(|edge| self.grows_fast(*edge, demands.growth)));
            let long: Vec<u32> = self.only_alive(long).collect();
            for vertex in long {
                if self.is_kept_edge(vertex) || self.length(vertex) < SHORTEST * largest {
                    continue;
                }
                let at = self.at(vertex).midpoint(self.at(self.next(vertex)));
                let new = self.insert(vertex, at);
                self.changes.push(BoundaryChange { kind: ChangeKind::Inserted, at });
                fresh.extend([vertex, new, self.next(new)]);
            }
            if fresh.is_empty() {
                break;
            }
            if self.vertices.len() > MOST_POINTS {
                return Err(ConditionError::Points(MOST_POINTS));
            }
        }
        Ok(())
    }

    /// The edges at a vertex that are too long: for the size, or beside the other one.
    fn to_divide(
        &self,
        vertex: u32,
        demands: &BoundaryDemands,
    ) -> impl Iterator<Item = u32> + use<> {
        let edges = [self.previous(vertex), vertex];
        let [before, after] = edges.map(|edge| self.length(edge));
        let is_uneven = self.limit(vertex) < demands.angle
            && self.angle(vertex).to_degrees() >= demands.angle
            && before.max(after) > UNEVEN * before.min(after);
        let longer = if before > after { edges[0] } else { edges[1] };
        let most = demands.size.map_or(f64::INFINITY, |size| LONGEST * size);
        let long = edges.into_iter().zip([before, after]).filter(move |(_, length)| *length > most);
        long.map(|(edge, _)| edge).chain(is_uneven.then_some(longer))
    }

    /// True if an edge is too long for one near it and `growth` times their distance.
    fn grows_fast(&self, edge: u32, growth: f64) -> bool {
        if growth == 0.0 {
            return false;
        }
        let middle = |edge: u32| self.at(edge).midpoint(self.at(self.next(edge)));
        let (own, length) = (middle(edge), self.length(edge));
        let reach = DVec2::splat(length / growth + length);
        self.grid.any_near([own - reach, own + reach], |other| {
            self.vertices[other as usize].is_alive
                && LONGEST * (self.length(other) + growth * own.distance(middle(other))) < length
        })
    }

    /// The longer edge of each pair whose tents meet.
    fn in_straits(&self, angle: f64, demanded: f64) -> Vec<u32> {
        let order = self.order();
        let names = order.concat();
        let boundary = self.boundary(&order);
        let longer = |edges: [u32; 2]| {
            let [a, b] = edges.map(|edge| names[edge as usize]);
            match (self.is_kept_edge(a), self.is_kept_edge(b)) {
                (false, true) => a,
                (true, false) => b,
                _ if self.length(a) >= self.length(b) => a,
                _ => b,
            }
        };
        // Beside a corner tents with room meet at every length of edges.
        let is_beside = |edges: [u32; 2]| {
            let [a, b] = edges.map(|edge| names[edge as usize]);
            let within = |from: u32, to: u32| {
                std::iter::successors(Some(from), |v| Some(self.next(*v))).take(4).any(|v| v == to)
            };
            within(a, b) || within(b, a)
        };
        let tents = tents_below(&boundary, angle).into_iter();
        let tents = tents.filter(|tent| tent.angle < demanded || !is_beside(tent.edges));
        tents.map(|tent| longer(tent.edges)).collect()
    }

    fn boundary(&self, order: &[Vec<u32>]) -> PlanarBoundary {
        let points = |ring: &Vec<u32>| ring.iter().map(|v| self.at(*v)).collect();
        PlanarBoundary::of_mesh(&order.iter().map(points).collect::<Vec<Vec<DVec2>>>())
    }

    /// The places of the conditioned boundary that stay below the demanded angle.
    pub(crate) fn left(&self, boundary: &PlanarBoundary, demands: &BoundaryDemands) -> Vec<Left> {
        let names = self.order().concat();
        let mut left: Vec<Left> = Vec::new();
        for &vertex in &names {
            let limit = self.limit(vertex);
            if limit >= demands.angle {
                continue;
            }
            let reason = if self.is_kept(vertex) {
                Reason::Kept
            } else if self.angle(vertex).to_degrees() < demands.angle {
                Reason::Sharp
            } else if [self.previous(vertex), vertex].iter().any(|edge| self.is_kept_edge(*edge)) {
                Reason::Kept
            } else {
                Reason::Short
            };
            left.push(Left { at: self.at(vertex), limit, reason });
        }
        for tent in tents_below(boundary, demands.angle) {
            let edges = tent.edges.map(|edge| names[edge as usize]);
            let is_kept = edges.iter().any(|edge| self.is_kept_edge(*edge));
            let reason = if is_kept { Reason::Kept } else { Reason::Short };
            left.push(Left { at: self.at(edges[0]), limit: tent.angle, reason });
        }
        left
    }
}
