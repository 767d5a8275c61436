//! Pairs of edges whose tents meet: points on them help, unless a corner or an edge that stays is what decides.

use crate::chains::{Chains, NONE};
use glam::DVec2;
use mindeg_interior::limits::tents_below;

/// Arms are near each other along the boundary within so many arms.
const BESIDE: usize = 4;
/// Edges of an arm have the direction of its first one, within so many degrees.
const STRAIGHT: f64 = 1.0;

impl Chains<'_> {
    /// The pairs of edges whose tents of an angle meet, each with the angle from which on they do.
    pub(crate) fn tents(&self, angle: f64) -> Vec<(f64, [u32; 2])> {
        self.tents_of(&self.edges().collect::<Vec<u32>>(), 0, angle)
    }

    /// The same with one of the edges from the index `from` on.
    fn tents_of(&self, all: &[u32], from: usize, angle: f64) -> Vec<(f64, [u32; 2])> {
        let (mut edges, mut names) = (Vec::new(), Vec::new());
        let has_domain = |edge: u32| self.vertices[edge as usize].has_domain;
        let first = all[..from].iter().flat_map(|edge| has_domain(*edge)).filter(|is| *is).count();
        for &edge in all {
            let ends = [edge, self.next(edge)].map(|v| self.place(v));
            let [left, right] = has_domain(edge);
            edges.extend(left.then_some(ends));
            edges.extend(right.then_some([ends[1], ends[0]]));
            names.resize(edges.len(), edge);
        }
        let tents = tents_below(&edges, first, |v| self.at(v), angle).into_iter();
        tents.map(|tent| (tent.angle, tent.edges.map(|edge| names[edge as usize]))).collect()
    }

    /// The longer edge of each pair whose tents meet, if one is of the edges from the index `from` on.
    pub(crate) fn in_straits(
        &self,
        edges: &[u32],
        from: usize,
        angle: f64,
        demanded: f64,
    ) -> Vec<u32> {
        let longer = |[a, b]: [u32; 2]| match self.beside_whole([a, b]) {
            Some([_, other]) => other,
            None if self.length(a) >= self.length(b) => a,
            None => b,
        };
        // Beside a corner that is not blunt tents with room meet at every length of edges, and beside one that is too sharp all do. An
        // edge that stays whole is like such a corner for all that its tent meets.
        let arms = Arms::of(self);
        let is_of_use = |&(limit, pair): &(f64, [u32; 2])| {
            let corner = arms.least_between(self, pair).filter(|least| *least < 2.0 * angle);
            let whole = Some(self.least_beside_whole(pair)).filter(|least| *least < angle);
            corner.into_iter().chain(whole).all(|least| limit < demanded && least >= demanded)
        };
        self.tents_of(edges, from, angle)
            .into_iter()
            .filter(is_of_use)
            .map(|tent| longer(tent.1))
            .collect()
    }

    /// The edge of two that stays whole, and then the other; none if both do, or none.
    fn beside_whole(&self, [a, b]: [u32; 2]) -> Option<[u32; 2]> {
        match (self.is_kept_edge(a), self.is_kept_edge(b)) {
            (true, false) => Some([a, b]),
            (false, true) => Some([b, a]),
            _ => None,
        }
    }

    /// The greatest angle in degrees, at most 90, up to which the tent of an edge that stays whole does not meet another edge, however
    /// short that is; 90 if none of the two stays, or both do.
    fn least_beside_whole(&self, pair: [u32; 2]) -> f64 {
        let Some([whole, other]) = self.beside_whole(pair) else { return 90.0 };
        let [start, end, from, to] =
            [whole, self.next(whole), other, self.next(other)].map(|vertex| self.at(vertex));
        let base = end - start;
        // The angle at the base of the tent that has a point on its border: the greater of the two that the point is seen at.
        let angle_of = |point: DVec2| {
            let height = base.perp_dot(point - start).abs();
            let run = base.dot(point - start).min(base.dot(end - point));
            libm::atan2(height, run.max(0.0)).to_degrees()
        };
        // Along a line each of the two angles only rises or only falls, so the greater one is least at an end or where they are equal.
        let [at, step] = [(start.midpoint(end) - from).dot(base), (to - from).dot(base)];
        let middle = (step != 0.0).then(|| from.lerp(to, (at / step).clamp(0.0, 1.0)));
        [from, to].into_iter().chain(middle).map(angle_of).fold(90.0, f64::min)
    }
}

/// The arms of a boundary: edges one after the other in one direction. However many they are, an arm ends at one corner.
pub(crate) struct Arms {
    /// The first edge of the arm of each edge.
    first: Vec<u32>,
    /// The last edge of each arm, by its first.
    last: Vec<u32>,
}

impl Arms {
    /// O(n) for n vertices.
    pub(crate) fn of(chains: &Chains<'_>) -> Self {
        let unknown = vec![NONE; chains.vertices.len()];
        let mut arms = Self { first: unknown.clone(), last: unknown };
        let least = libm::cos(STRAIGHT.to_radians());
        let along =
            |edge: u32| (chains.at(chains.next(edge)) - chains.at(edge)).normalize_or_zero();
        let goes_on = |from: u32, edge: u32| {
            !chains.is_meeting(edge) && along(from).dot(along(edge)) >= least
        };
        let begins = |edge: &u32| {
            let previous = chains.previous(*edge);
            previous == NONE || !goes_on(previous, *edge)
        };
        // A ring without a corner has an arm that begins anywhere.
        for first in chains.edges().filter(begins).chain(chains.edges()) {
            let mut edge = first;
            while arms.first[edge as usize] == NONE {
                (arms.first[edge as usize], arms.last[first as usize]) = (first, edge);
                let next = chains.next(edge);
                if !chains.is_edge(next) || !goes_on(first, next) {
                    break;
                }
                edge = next;
            }
        }
        arms
    }

    /// The least angle at the vertices between two edges in degrees, if their arms are beside each other.
    pub(crate) fn least_between(&self, chains: &Chains<'_>, edges: [u32; 2]) -> Option<f64> {
        let [from, to] = edges.map(|edge| self.first[edge as usize]);
        if from == to {
            return Some(180.0);
        }
        let mut reached: Vec<(u32, f64)> = vec![(from, 180.0)];
        let mut start = 0;
        for _ in 0..BESIDE {
            let end = reached.len();
            for index in start..end {
                let (arm, least) = reached[index];
                for vertex in [arm, chains.next(self.last[arm as usize])] {
                    let least = least.min(chains.angle(vertex).to_degrees());
                    for other in chains.edges_at(vertex).map(|edge| self.first[edge as usize]) {
                        if other == to {
                            return Some(least);
                        }
                        if reached.iter().all(|known| known.0 != other) {
                            reached.push((other, least));
                        }
                    }
                }
            }
            start = end;
        }
        None
    }
}
