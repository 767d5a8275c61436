//! Narrow water that is opened, as far as the boundary may move: its edges would have to be as short as it is narrow.

use crate::chains::{Chains, share_along};
use crate::changes::Why;
use crate::demands::BoundaryDemands;
use glam::DVec2;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Water narrower than this share of the size is opened.
const NARROW: f64 = 0.25;
/// So often all of it is looked at, since a point that moves may be in the way of another.
const ROUNDS: usize = 4;
/// The shares of a move that are tried.
const SHARES: [f64; 4] = [1.0, 0.5, 0.25, 0.125];
/// A smaller share of a move is none.
const LEAST: f64 = 1e-3;
/// Tents of so many degrees meet across all water that is narrow beside its edges.
const STEEP: f64 = 45.0;

impl Chains<'_> {
    /// Moves the shores of narrow water apart, where there is a size.
    pub(crate) fn open_narrow(&mut self, demands: &BoundaryDemands) {
        if demands.size.is_none() || demands.within == 0.0 {
            return;
        }
        self.put_edges();
        for _ in 0..ROUNDS {
            let mut is_changed = false;
            for (vertex, by) in self.too_near(demands) {
                is_changed |= self.move_apart(vertex, by, demands);
            }
            if !is_changed {
                break;
            }
        }
    }

    /// The points that are too near to an edge across water, each with its way to half of the width that it should have.
    fn too_near(&self, demands: &BoundaryDemands) -> BTreeMap<u32, DVec2> {
        let mut nearest: BTreeMap<u32, (f64, DVec2)> = BTreeMap::new();
        for (_, [one, other]) in self.tents(STEEP) {
            let ends = [one, other].map(|edge| [edge, self.next(edge)]);
            let shared =
                ends[0].iter().any(|v| ends[1].iter().any(|w| self.place(*v) == self.place(*w)));
            if shared {
                continue;
            }
            for (own, across) in [(ends[0], ends[1]), (ends[1], ends[0])] {
                let across = across.map(|v| self.at(v));
                for vertex in own {
                    let way = self.at(vertex) - nearest_on(self.at(vertex), across);
                    let distance = way.length();
                    let size = self.size_at(self.at(vertex), demands);
                    let width = NARROW * size.unwrap_or(0.0);
                    if distance < width && distance > 0.0 {
                        let known = nearest.entry(vertex).or_insert((f64::INFINITY, DVec2::ZERO));
                        if distance < known.0 {
                            *known = (distance, way * ((width - distance) / (2.0 * distance)));
                        }
                    }
                }
            }
        }
        nearest.into_iter().map(|(vertex, (_, by))| (vertex, by)).collect()
    }

    /// Moves a point by some way, or by a share of it where something is in the way. Tells whether it did.
    fn move_apart(&mut self, vertex: u32, by: DVec2, demands: &BoundaryDemands) -> bool {
        let Some((home, reach)) = self.reach(vertex, demands) else { return false };
        let at = self.at(vertex);
        for share in SHARES {
            let from_home = at + by * share - home;
            let to = home + from_home * (reach / from_home.length()).min(1.0);
            if to.distance(at) < LEAST * by.length() {
                return false;
            }
            let is_allowed = self.shifted_by(vertex, to, demands).is_some()
                && self.is_shift_free(vertex, to)
                && self.stays_blunt(vertex, to, demands);
            if is_allowed {
                self.shift(vertex, to, Why::Near, demands);
                return true;
            }
        }
        false
    }

    /// Whether no corner gets sharper than the angle if a vertex goes somewhere.
    fn stays_blunt(&mut self, vertex: u32, to: DVec2, demands: &BoundaryDemands) -> bool {
        let around = [self.previous(vertex), vertex, self.next(vertex)];
        let least = |chains: &Self| around.map(|v| chains.angle(v)).into_iter().fold(TAU, f64::min);
        let before = least(self).min(demands.angle.to_radians());
        let at = std::mem::replace(&mut self.vertices[vertex as usize].point.at, to);
        let after = least(self);
        self.vertices[vertex as usize].point.at = at;
        after >= before
    }
}

/// The point of an edge that is nearest to a point.
fn nearest_on(point: DVec2, [a, b]: [DVec2; 2]) -> DVec2 {
    a.lerp(b, share_along(point, [a, b]).clamp(0.0, 1.0))
}
