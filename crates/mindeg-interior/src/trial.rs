//! Trying an operation: do it, smooth round it, compare costs, and take it back or keep it.

use crate::array_mesh::ArrayMesh;
use crate::compass::settle;
use crate::energy::Cost;
use crate::goal::Weights;
use crate::manifold::Manifold;
use crate::operations::{Cavity, Operation};
use crate::smooth::{Power, Ring, smooth};
use crate::space::Plane;

/// The mesh under work, with what trials need again and again.
pub(crate) struct Bench<'a, S: Manifold = Plane> {
    pub(crate) mesh: &'a mut ArrayMesh<S>,
    pub(crate) weights: Weights,
    pub(crate) cavity: Cavity<S>,
    ring: Ring<S::Vector>,
    star: Vec<u32>,
    /// The triangles that the last cost is of, and the cost of degrees: all of it, and the part for hard violations.
    patch: Vec<u32>,
    degrees: f64,
    hard: f64,
    /// When a triangle was last put into a patch.
    seen: Vec<u32>,
    round: u32,
}

/// The result of an operation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Effect {
    pub(crate) before: Cost,
    pub(crate) after: Cost,
}

impl Effect {
    /// By how much the energy falls.
    pub(crate) fn gain(&self) -> f64 {
        self.before.energy - self.after.energy
    }

    /// True if the energy falls and no angle below `floor` gets smaller: the hard guard.
    pub(crate) fn is_good(&self, floor: f64) -> bool {
        self.gain() > 1e-7 * (1.0 + self.after.energy.abs())
            && self.after.min_angle >= self.before.min_angle.min(floor)
    }
}

impl<'a, S: Manifold> Bench<'a, S> {
    pub(crate) fn new(mesh: &'a mut ArrayMesh<S>, weights: Weights) -> Self {
        let seen = vec![0; mesh.triangles.len()];
        Self {
            mesh,
            weights,
            cavity: Cavity::default(),
            ring: Ring::default(),
            star: Vec::new(),
            patch: Vec::new(),
            degrees: 0.0,
            hard: 0.0,
            seen,
            round: 0,
        }
    }

    /// How often operations have been tried; those that end before anything is costly count by half.
    pub(crate) fn trials(&self) -> usize {
        self.round as usize / 2
    }

    /// The cost of some vertices, of all triangles at those that can move, and of further triangles.
    pub(crate) fn cost(&mut self, vertices: &[u32], further: impl Iterator<Item = u32>) -> Cost {
        self.gather(vertices, further);
        self.sum(f64::INFINITY)
    }

    /// Finds the triangles that such a cost is of, and the cost of degrees.
    fn gather(&mut self, vertices: &[u32], further: impl Iterator<Item = u32>) {
        self.round += 1;
        self.seen.resize(self.mesh.triangles.len().max(self.seen.len()), 0);
        self.patch.clear();
        (self.degrees, self.hard) = (0.0, 0.0);
        for t in further {
            put(&mut self.patch, &mut self.seen, self.round, t);
        }
        for v in vertices {
            let vertex = &self.mesh.vertices[*v as usize];
            if vertex.triangles == 0 {
                continue;
            }
            let (all, hard) = self.weights.vertex(self.mesh, *v);
            self.degrees += all;
            self.hard += hard;
            if vertex.kind.is_movable() {
                self.mesh.star(*v, &mut self.star);
                for t in &self.star {
                    put(&mut self.patch, &mut self.seen, self.round, *t);
                }
            }
        }
    }

    /// The cost of what was gathered last, which may have moved since; no more is added once it is above `most`.
    fn sum(&self, most: f64) -> Cost {
        let mut cost = Cost { energy: self.degrees, min_angle: 180.0, hard: self.hard };
        for t in &self.patch {
            let (energy, angle) = self.weights.triangle(self.mesh, *t);
            cost.energy += energy;
            cost.min_angle = cost.min_angle.min(angle);
            if cost.energy > most {
                break;
            }
        }
        cost
    }

    /// Does an operation and smooths the cavity. `None` if it is not possible, if it raises the cost of
    /// hard degree violations by more than `allowance`, or if its gain is surely, or nearly so, below `needed`;
    /// whatever was done is in the log.
    pub(crate) fn perform(
        &mut self,
        operation: Operation,
        allowance: f64,
        needed: f64,
    ) -> Option<Effect> {
        let mut cavity = std::mem::take(&mut self.cavity);
        let effect = self.perform_in(&mut cavity, operation, allowance, needed);
        self.cavity = cavity;
        effect
    }

    fn perform_in(
        &mut self,
        cavity: &mut Cavity<S>,
        operation: Operation,
        allowance: f64,
        needed: f64,
    ) -> Option<Effect> {
        // Most operations fail here, before anything is costly: in the plane by their degrees.
        if !cavity.find(self.mesh, operation) {
            return None;
        }
        let foreseen = S::IS_PLANE.then(|| self.hard_change_foreseen(cavity, operation));
        if foreseen.is_some_and(|change| change > allowance)
            || !cavity.surround(self.mesh, operation)
            || !cavity.plan(self.mesh, operation)
        {
            return None;
        }
        let counts = |v: &u32| S::counts_triangles(self.mesh, *v);
        let is_counted = S::IS_PLANE || cavity.vertices.iter().all(counts);
        let known = foreseen.or_else(|| is_counted.then(|| self.hard_change(cavity)));
        debug_assert!(foreseen.is_none_or(|change| change == self.hard_change(cavity)));
        if known.is_some_and(|change| change > allowance) {
            return None;
        }
        let before = self.cost(&cavity.vertices, cavity.removed.iter().copied());
        let is_vain = |change: f64| before.energy - before.hard - change < needed;
        // Nothing but violations is left at best.
        if known.is_some_and(is_vain) {
            return None;
        }
        let first = self.mesh.triangles.len() as u32;
        cavity.carry_out(self.mesh);
        if known.is_none() {
            let hard = |v: &u32| match self.mesh.vertices[*v as usize].triangles {
                0 => 0.0,
                _ => self.weights.vertex(self.mesh, *v).1,
            };
            let change = cavity.vertices.iter().map(hard).sum::<f64>() - before.hard;
            if change > allowance || is_vain(change) {
                return None;
            }
        }
        let added = first..self.mesh.triangles.len() as u32;
        for _ in 0..SWEEPS {
            for v in &cavity.vertices {
                let vertex = &self.mesh.vertices[*v as usize];
                if vertex.kind.is_movable() && vertex.triangles > 0 {
                    smooth(self.mesh, *v, Power::Four, &mut self.ring);
                }
            }
        }
        self.gather(&cavity.vertices, added.clone());
        // Above rounding.
        let hair = 1e-9 * (1.0 + before.energy.abs() + needed.abs());
        let most = before.energy - needed + hair;
        if !self.weights.by_share {
            let after = self.sum(most);
            return (after.energy <= most).then_some(Effect { before, after });
        }
        // Angles settle where they are in doubt, not where much would be lost even so.
        let left = before.energy - self.hard - needed;
        let doubtful = self.hard + (left + hair) / SETTLED;
        let after = self.sum(doubtful);
        if after.energy > doubtful || left < SETTLED * (after.energy - after.hard) {
            return None;
        }
        for v in &cavity.vertices {
            let vertex = &self.mesh.vertices[*v as usize];
            if vertex.kind.is_movable() && vertex.triangles > 0 {
                settle(self.mesh, *v, &self.weights, 0.03, &mut self.ring);
            }
        }
        // Angles decide some degrees in space.
        if !is_counted {
            self.gather(&cavity.vertices, added);
        }
        let after = self.sum(most);
        (after.energy <= most).then_some(Effect { before, after })
    }

    /// True if operations in a row keep what the space wants to be kept. The mesh is as before.
    pub(crate) fn keeps(&mut self, operations: &[Operation]) -> bool {
        let mark = self.mesh.mark();
        let is_kept = operations.iter().all(|operation| {
            if !self.cavity.open(self.mesh, *operation) {
                return false;
            }
            let survey = S::survey(self.mesh, &self.cavity.vertices, false);
            let effect = self.perform(*operation, f64::INFINITY, f64::NEG_INFINITY);
            let keeps = |survey| S::keeps(self.mesh, &survey, &self.cavity.vertices);
            effect.is_some() && survey.is_none_or(keeps)
        });
        self.mesh.undo(mark);
        is_kept
    }

    /// The change of the cost of hard degree violations, from what is known before the operation is planned.
    fn hard_change_foreseen(&self, cavity: &Cavity<S>, operation: Operation) -> f64 {
        let foreseen = cavity.foreseen(self.mesh, operation);
        let change = |&(v, after): &(u32, u32)| {
            let excess = |triangles: u32| match triangles {
                // Not there, or no longer.
                0 => 0.0,
                _ => f64::from(self.weights.excess_of(self.mesh, v, triangles).pow(2)),
            };
            let before = self.mesh.vertices.get(v as usize).map_or(0, |vertex| vertex.triangles);
            excess(after) - excess(before)
        };
        foreseen.iter().map(change).sum::<f64>() * self.weights.degree
    }

    /// The change of the cost of hard degree violations.
    fn hard_change(&self, cavity: &Cavity<S>) -> f64 {
        let mut change = 0.0;
        for v in &cavity.vertices {
            let before = self.mesh.vertices[*v as usize].triangles;
            let after = before.saturating_add_signed(cavity.growth(self.mesh, *v));
            let excess = |triangles: u32| match triangles {
                // Not there, or no longer.
                0 => 0.0,
                _ => f64::from(self.weights.excess_of(self.mesh, *v, triangles).pow(2)),
            };
            change += excess(after) - excess(before);
        }
        change * self.weights.degree
    }
}

/// Sweeps over a cavity after an operation.
const SWEEPS: usize = 3;
/// The share of the cost that is left, at least, when angles have settled.
const SETTLED: f64 = 0.3;

fn put(patch: &mut Vec<u32>, seen: &mut [u32], round: u32, triangle: u32) {
    if seen[triangle as usize] != round {
        seen[triangle as usize] = round;
        patch.push(triangle);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::array_mesh::Kind;
    use crate::array_mesh::tests::grid;
    use crate::operations::operations;
    use crate::options::Options;
    use glam::DVec2;

    /// Calls `check` with every operation on a mesh, what it does if it is not rejected, and the gain that is left at best:
    /// all cost but that of violations gone.
    fn with_each(weights: &Weights, mut check: impl FnMut(&mut Bench<'_>, Operation, Effect, f64)) {
        let mut mesh = grid(6);
        // Free vertices are off their middles, each another way.
        let shift = |v: usize| DVec2::from_angle(v as f64) * 0.3;
        let free = mesh.vertices.iter_mut().enumerate().filter(|(_, v)| v.kind == Kind::Free);
        free.for_each(|(v, vertex)| vertex.at += shift(v));
        mesh.record();
        let mut list = Vec::new();
        let mut bench = Bench::new(&mut mesh, weights.clone());
        for vertex in 0..bench.mesh.vertices.len() as u32 {
            operations(bench.mesh, vertex, true, &mut list);
            for operation in list.clone() {
                let mark = bench.mesh.mark();
                let effect = bench.perform(operation, f64::INFINITY, f64::NEG_INFINITY);
                bench.mesh.undo(mark);
                if let Some(effect) = effect {
                    let most = effect.before.energy - effect.after.hard;
                    check(&mut bench, operation, effect, most);
                    bench.mesh.undo(mark);
                }
            }
        }
    }

    #[test]
    fn only_operations_that_cannot_gain_enough_end_before_a_vertex_moves() {
        let options = Options::default();
        let (mut kept, mut rejected) = (0, 0);
        for weights in [Weights::single(&options, 36.0), Weights::pairs(&options, 36.0)] {
            with_each(&weights, |bench, operation, effect, most| {
                assert!(most >= effect.gain());
                let mark = bench.mesh.mark();
                let triangles = bench.mesh.triangles.len();
                assert!(bench.perform(operation, f64::INFINITY, effect.gain()).is_some());
                bench.mesh.undo(mark);
                kept += 1;
                // A new vertex may be planned; no triangle is.
                let above = most + 1e-9 * (1.0 + most.abs());
                assert!(bench.perform(operation, f64::INFINITY, above).is_none());
                rejected += usize::from(bench.mesh.triangles.len() == triangles);
            });
        }
        assert!(kept > 200 && rejected == kept, "{kept} {rejected}");
    }

    #[test]
    fn where_shares_count_operations_that_lack_much_end_before_angles_settle() {
        let weights = Weights::local(&Options::default(), 36.0);
        let (mut good, mut lost, mut rejected) = (0, 0, 0);
        with_each(&weights, |bench, operation, effect, most| {
            // An operation that gains anything is done.
            if effect.gain() > 0.0 {
                good += 1;
                lost += usize::from(bench.perform(operation, f64::INFINITY, 0.0).is_none());
            } else if most - effect.gain() > 1.0 {
                // One that would have to lose no angle at all is not.
                let all = most - 1e-9 * (1.0 + most.abs());
                assert!(bench.perform(operation, f64::INFINITY, all).is_none());
                rejected += 1;
            }
        });
        assert!(good > 20 && lost == 0 && rejected > 100, "{good} {lost} {rejected}");
    }
}
