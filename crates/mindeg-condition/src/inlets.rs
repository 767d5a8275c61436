//! Inlets about one edge wide: what single vertices and pairs of edges allow, their triangles together may not.
//!
//! In such an inlet there is hardly room for points, so its triangles have their corners on its shore. The best of these
//! triangulations is found exactly (`fit.rs`). Where it stays below the demanded angle, and so does a mesh of the inlet with points
//! inside, points of the shore are moved (`shift.rs`), dropped, or put on edges, each where it helps most, until there is one that
//! reaches it.

mod chords;
mod fit;
mod shift;

use crate::chains::Chains;
use crate::changes::{BoundaryChange, ChangeKind, Left, Reason};
use crate::demands::BoundaryDemands;
use crate::error::ConditionError;
use chords::inlets;
use fit::{angle_further_in, angle_of, angle_with_point, meshed_angle};
use glam::DVec2;
use mindeg_mesh::planar::PlanarBoundary;

/// So often all inlets are looked at, since a change of one may be another one's.
const ROUNDS: usize = 2;
/// The most changes of one inlet.
const MOST_CHANGES: usize = 6;
/// A change is worth so many degrees at least.
const WORTH: f64 = 0.05;
/// The shares of the allowed distance by which a point is moved.
const SHARES: [f64; 2] = [1.0, 0.4];
/// The directions in which it is.
const DIRECTIONS: usize = 8;

/// A change of an inlet.
#[derive(Clone, Copy)]
enum Step {
    Shift { vertex: u32, to: DVec2 },
    Drop { vertex: u32 },
    Insert { edge: u32, at: DVec2 },
}

impl Chains {
    /// Changes the inlets whose triangles cannot have the demanded angle. `prove` proves the chains as they are, and gives their boundary.
    pub(crate) fn widen_inlets(
        &mut self,
        prove: impl Fn(&Self) -> Result<PlanarBoundary, ConditionError>,
        demands: &BoundaryDemands,
    ) -> Result<Vec<Left>, ConditionError> {
        self.longest = self.edges().map(|edge| self.length(edge)).fold(0.0, f64::max);
        let mut is_changed = true;
        for round in 0.. {
            // Where a vertex has a smaller limit of its own, that is what decides.
            let is_open = |inlet: &Vec<u32>| self.least_limit(inlet) >= demands.angle;
            let found = inlets(self, &prove(self)?)?.into_iter().filter(is_open);
            let limits = found.map(|inlet| (self.reached(&inlet, demands.angle), inlet));
            let small: Vec<(f64, Vec<u32>)> =
                limits.filter(|(limit, _)| *limit < demands.angle).collect();
            if !is_changed || small.is_empty() || round == ROUNDS {
                let left = |(limit, inlet): &(f64, Vec<u32>)| Left {
                    at: self.at(inlet[inlet.len() / 2]),
                    limit: limit.max(angle_further_in(self, inlet)),
                    reason: Reason::Narrow,
                };
                let left = small.iter().map(left);
                return Ok(left.filter(|left| left.limit < demands.angle).collect());
            }
            is_changed = false;
            for (limit, inlet) in small {
                // A change of another one may have taken points of it.
                if inlet.iter().all(|v| self.vertices[*v as usize].is_alive) {
                    is_changed |= self.widen(inlet, limit, demands);
                }
            }
            if is_changed {
                self.divide(demands)?;
            }
        }
        Ok(Vec::new())
    }

    /// The angle that is reached in an inlet closed at its mouth: by triangles alone, or else with points inside.
    fn reached(&self, inlet: &[u32], wanted: f64) -> f64 {
        let alone = angle_of(self, inlet);
        if alone >= wanted { alone } else { alone.max(meshed_angle(self, inlet)) }
    }

    /// Changes an inlet until its triangles can have the demanded angle, or nothing more helps. Tells whether anything has changed.
    fn widen(&mut self, mut inlet: Vec<u32>, mut limit: f64, demands: &BoundaryDemands) -> bool {
        let mut is_changed = false;
        for _ in 0..MOST_CHANGES {
            if limit >= demands.angle {
                break;
            }
            // The angle that each reaches, up to the demand, how far it moves the shore, and the step.
            let mut steps: Vec<(f64, f64, Step)> = Vec::new();
            for step in self.steps(&inlet, demands) {
                let Some((reached, moved)) = self.try_step(step, &inlet, demands) else { continue };
                if reached >= (limit + WORTH).min(demands.angle) {
                    steps.push((reached.min(demands.angle), moved, step));
                }
            }
            steps.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.total_cmp(&b.1)));
            let best = steps.into_iter().find(|(_, _, step)| self.is_safe(*step));
            let Some((_, _, step)) = best else { break };
            self.take(step, &mut inlet, demands);
            limit = angle_of(self, &inlet).min(self.least_limit(&inlet));
            is_changed = true;
        }
        is_changed
    }

    /// The least limit at the shore's own vertices and those beside them.
    fn least_limit(&self, inlet: &[u32]) -> f64 {
        let before = inlet.first().map(|first| self.previous(*first));
        let after = inlet.last().map(|last| self.next(*last));
        let all = inlet.iter().copied().chain(before).chain(after);
        all.map(|v| self.limit(v)).fold(60.0, f64::min)
    }

    /// All changes that there are.
    fn steps(&self, inlet: &[u32], demands: &BoundaryDemands) -> Vec<Step> {
        let mut steps = Vec::new();
        for (index, &vertex) in inlet.iter().enumerate() {
            let is_end = index == 0 || index + 1 == inlet.len();
            let is_old = demands.within > 0.0 && self.vertices[vertex as usize].home.is_none();
            if !is_end && is_old && self.drop_distance(vertex, demands).is_some() {
                steps.push(Step::Drop { vertex });
            }
            if index + 1 < inlet.len() && !self.is_kept_edge(vertex) {
                let at = self.at(vertex).midpoint(self.at(self.next(vertex)));
                steps.push(Step::Insert { edge: vertex, at });
            }
            let Some((home, reach)) = self.reach(vertex, demands) else { continue };
            for share in SHARES {
                for direction in 0..DIRECTIONS {
                    let angle = std::f64::consts::TAU * direction as f64 / DIRECTIONS as f64;
                    let by = DVec2::new(libm::cos(angle), libm::sin(angle));
                    steps.push(Step::Shift { vertex, to: home + by * (reach * share) });
                }
            }
        }
        steps
    }

    /// The angle that an inlet would have after a change, and how far that moves the shore; none if it would not do.
    fn try_step(
        &mut self,
        step: Step,
        inlet: &[u32],
        demands: &BoundaryDemands,
    ) -> Option<(f64, f64)> {
        match step {
            Step::Shift { vertex, to } => {
                let moved = self.shifted_by(vertex, to, demands)?;
                let old = std::mem::replace(&mut self.vertices[vertex as usize].point.at, to);
                let own = self.least_limit(inlet);
                let reached = (own >= demands.angle).then(|| angle_of(self, inlet));
                self.vertices[vertex as usize].point.at = old;
                Some((reached?, moved))
            }
            // Its own limits are no smaller then.
            Step::Drop { vertex } => {
                let without: Vec<u32> = inlet.iter().copied().filter(|v| *v != vertex).collect();
                let reached = angle_of(self, &without);
                Some((reached, self.drop_distance(vertex, demands)?))
            }
            Step::Insert { edge, at } => {
                let [from, to] = [edge, self.next(edge)];
                let beside = self.limit_with(from, to, at).min(self.limit_with(to, from, at));
                let is_good = beside >= demands.angle;
                is_good.then(|| (angle_with_point(self, inlet, edge, at), 0.0))
            }
        }
    }

    /// Makes a change.
    fn take(&mut self, step: Step, inlet: &mut Vec<u32>, demands: &BoundaryDemands) {
        match step {
            Step::Shift { vertex, to } => self.shift(vertex, to, demands),
            Step::Drop { vertex } => {
                self.drop(vertex);
                inlet.retain(|v| *v != vertex);
            }
            Step::Insert { edge, at } => {
                let new = self.insert(edge, at);
                self.changes.push(BoundaryChange { kind: ChangeKind::Inserted, at });
                let at = inlet.iter().position(|v| *v == edge);
                inlet.insert(at.map_or(inlet.len(), |at| at + 1), new);
            }
        }
    }

    /// Whether a change lets nothing cross; `drop_distance` has looked at drops.
    fn is_safe(&self, step: Step) -> bool {
        match step {
            Step::Shift { vertex, to } => self.is_shift_free(vertex, to),
            Step::Drop { .. } | Step::Insert { .. } => true,
        }
    }
}
