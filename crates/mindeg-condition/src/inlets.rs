//! Inlets and straits about one edge wide: what single vertices and pairs of edges allow, their triangles together may not.
//!
//! In such an inlet there is hardly room for points, so its triangles have their corners on its shore. The best of these
//! triangulations is found exactly (`fit.rs`). Where it stays below the demanded angle, and so does a mesh of the inlet with points
//! inside, points of the shore are moved (`shift.rs`), dropped, or put on edges, each where it helps most, until there is one that
//! reaches it.

mod chords;
mod fit;
mod shift;
mod straits;

use crate::chains::Chains;
use crate::changes::{BoundaryChange, ChangeKind, Left, Reason};
use crate::demands::BoundaryDemands;
use crate::error::ConditionError;
use chords::inlets;
use fit::{angle_further_in, angle_of, angle_with_point, meshed_angle};
use glam::DVec2;
use mindeg_mesh::Progress;
use mindeg_mesh::planar::PlanarBoundary;
use straits::straits;

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
            let is_open = |shores: &Vec<Vec<u32>>| self.least_limit(shores) >= demands.angle;
            let boundary = prove(self)?;
            let (inner, lines) = (boundary.inner_points(), boundary.segments());
            let triangles = mindeg_delaunay::triangles(&boundary, inner, lines, Progress::NONE)
                .map_err(|error| ConditionError::Narrow(error.to_string()))?;
            let inlets = inlets(self, &boundary, &triangles);
            let straits = straits(self, &boundary, &triangles, &inlets);
            let found = inlets.into_iter().map(|shore| vec![shore]).chain(straits);
            let limits = found.filter(is_open).map(|shores| self.reached(shores, demands.angle));
            let small: Vec<(f64, Vec<Vec<u32>>)> =
                limits.filter(|(limit, _)| *limit < demands.angle).collect();
            if !is_changed || small.is_empty() || round == ROUNDS {
                let left = |(limit, shores): &(f64, Vec<Vec<u32>>)| Left {
                    at: self.at(shores[0][shores[0].len() / 2]),
                    limit: limit.max(angle_further_in(self, shores).0),
                    reason: Reason::Narrow,
                };
                let left = small.iter().map(left);
                return Ok(left.filter(|left| left.limit < demands.angle).collect());
            }
            is_changed = false;
            for (limit, shores) in small {
                // A change of another one may have taken points of it, or put some on its edges.
                if shores.iter().all(|shore| self.is_run(shore)) {
                    is_changed |= self.widen(shores, limit, demands);
                }
            }
            if is_changed {
                self.divide(demands)?;
            }
        }
        Ok(Vec::new())
    }

    /// The angle that is reached between shores: by triangles alone, or else with points inside; and the shores up to the mouths for that.
    fn reached(&self, shores: Vec<Vec<u32>>, wanted: f64) -> (f64, Vec<Vec<u32>>) {
        let alone = angle_of(self, &shores);
        if alone >= wanted {
            return (alone, shores);
        }
        let meshed = meshed_angle(self, &shores);
        if meshed >= wanted || shores.len() == 1 {
            return (alone.max(meshed), shores);
        }
        // The mouths of a strait are anywhere.
        let (further_in, within) = angle_further_in(self, &shores);
        if further_in > alone.max(meshed) {
            (further_in, within)
        } else {
            (alone.max(meshed), shores)
        }
    }

    /// Whether a shore is there, point by point.
    fn is_run(&self, shore: &[u32]) -> bool {
        shore.iter().all(|v| self.vertices[*v as usize].is_alive)
            && shore.windows(2).all(|ends| self.next(ends[0]) == ends[1])
    }

    /// Changes an inlet until its triangles can have the demanded angle, or nothing more helps. Tells whether anything has changed.
    fn widen(
        &mut self,
        mut shores: Vec<Vec<u32>>,
        mut limit: f64,
        demands: &BoundaryDemands,
    ) -> bool {
        let mut is_changed = false;
        for _ in 0..MOST_CHANGES {
            if limit >= demands.angle {
                break;
            }
            // The angle that each reaches, up to the demand, how far it moves the shore, and the step.
            let mut steps: Vec<(f64, f64, Step)> = Vec::new();
            for step in self.steps(&shores, demands) {
                let Some((reached, moved)) = self.try_step(step, &shores, demands) else {
                    continue;
                };
                if reached >= (limit + WORTH).min(demands.angle) {
                    steps.push((reached.min(demands.angle), moved, step));
                }
            }
            steps.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.total_cmp(&b.1)));
            let best = steps.into_iter().find(|(_, _, step)| self.is_safe(*step));
            let Some((_, _, step)) = best else { break };
            self.take(step, &mut shores, demands);
            limit = angle_of(self, &shores).min(self.least_limit(&shores));
            is_changed = true;
        }
        is_changed
    }

    /// The least limit at the shore's own vertices and those beside them.
    fn least_limit(&self, shores: &[Vec<u32>]) -> f64 {
        let around = |shore: &Vec<u32>| {
            let before = shore.first().map(|first| self.previous(*first));
            let after = shore.last().map(|last| self.next(*last));
            [before, after].into_iter().flatten()
        };
        let all = shores.iter().flatten().copied().chain(shores.iter().flat_map(around));
        all.map(|v| self.limit(v)).fold(60.0, f64::min)
    }

    /// All changes that there are.
    fn steps(&self, shores: &[Vec<u32>], demands: &BoundaryDemands) -> Vec<Step> {
        let mut steps = Vec::new();
        let of_shore = |shore: &Vec<u32>| {
            let ends = [shore[0], shore[shore.len() - 1]];
            shore
                .iter()
                .map(move |v| (*v, *v == ends[0] || *v == ends[1], *v == ends[1]))
                .collect::<Vec<_>>()
        };
        for (vertex, is_end, is_last) in shores.iter().flat_map(of_shore) {
            let is_old = demands.within > 0.0 && self.vertices[vertex as usize].home.is_none();
            if !is_end && is_old && self.drop_distance(vertex, demands).is_some() {
                steps.push(Step::Drop { vertex });
            }
            if !is_last && !self.is_kept_edge(vertex) {
                let at = self.at(vertex).midpoint(self.at(self.next(vertex)));
                steps.push(Step::Insert { edge: vertex, at });
            }
            let Some((home, reach)) = self.reach(vertex, demands) else { continue };
            // Farther than an edge is long there is seldom a place for it.
            let edges = self.edges_at(vertex).map(|edge| self.length(edge));
            let reach = edges.fold(0.0, f64::max).min(reach);
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
        shores: &[Vec<u32>],
        demands: &BoundaryDemands,
    ) -> Option<(f64, f64)> {
        match step {
            Step::Shift { vertex, to } => {
                let moved = self.shifted_by(vertex, to, demands)?;
                let old = std::mem::replace(&mut self.vertices[vertex as usize].point.at, to);
                let own = self.least_limit(shores);
                let reached = (own >= demands.angle).then(|| angle_of(self, shores));
                self.vertices[vertex as usize].point.at = old;
                Some((reached?, moved))
            }
            // Its own limits are no smaller then.
            Step::Drop { vertex } => {
                let mut without = shores.to_vec();
                without.iter_mut().for_each(|shore| shore.retain(|v| *v != vertex));
                let reached = angle_of(self, &without);
                Some((reached, self.drop_distance(vertex, demands)?))
            }
            Step::Insert { edge, at } => {
                let [from, to] = [edge, self.next(edge)];
                let beside = self.limit_with(from, to, at).min(self.limit_with(to, from, at));
                let is_good = beside >= demands.angle;
                is_good.then(|| (angle_with_point(self, shores, edge, at), 0.0))
            }
        }
    }

    /// Makes a change.
    fn take(&mut self, step: Step, shores: &mut [Vec<u32>], demands: &BoundaryDemands) {
        match step {
            Step::Shift { vertex, to } => self.shift(vertex, to, demands),
            Step::Drop { vertex } => {
                self.drop(vertex);
                shores.iter_mut().for_each(|shore| shore.retain(|v| *v != vertex));
            }
            Step::Insert { edge, at } => {
                let new = self.insert(edge, at);
                self.changes.push(BoundaryChange { kind: ChangeKind::Inserted, at });
                for shore in shores {
                    if let Some(at) = shore.iter().position(|v| *v == edge) {
                        shore.insert(at + 1, new);
                    }
                }
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
