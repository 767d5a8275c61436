//! Chains of operations that bring degrees into their ranges: each mends one vertex and may break others, which the next mends.
//! Nothing moves between them, so thousands are tried in the time of one trial that smooths.

use crate::array_mesh::ArrayMesh;
use crate::goal::Weights;
use crate::operations::{Cavity, Operation, operations};
use std::cmp::Ordering;

/// The longest chain.
const LONGEST: u32 = 6;
/// By so much degrees may be out of their ranges between two operations, beyond what they were at first.
const MOST_SLACK: u32 = 3;
/// The best so many chains are kept.
const KEPT: usize = 4;
/// So many operations cost as much as a trial that smooths.
const OF_A_TRIAL: usize = 30;
/// A shape may cost so much more between two operations.
const COSTLY: f64 = 1e4;

/// The meshes after the best chains of the fewest operations that bring degrees nearer to their ranges in all, those with the best
/// shapes first. The search ends after as much time as `most` trials take; `left` is lowered by those that it took.
pub(crate) fn chains(
    mesh: &ArrayMesh,
    weights: &Weights,
    most: usize,
    left: &mut usize,
) -> Vec<ArrayMesh> {
    let mut mesh = mesh.clone();
    let is_broken =
        |v: &u32| mesh.vertices[*v as usize].triangles > 0 && weights.excess(&mesh, *v) > 0;
    // The vertex in the middle comes first, by its index.
    let broken: Vec<u32> = (0..mesh.vertices.len() as u32).rev().filter(is_broken).collect();
    let excess = broken.iter().map(|v| weights.excess(&mesh, *v)).sum();
    let given = most.min(*left) * OF_A_TRIAL;
    mesh.record();
    let (best, allowed) = (Vec::new(), excess);
    let mut search = Search { mesh, weights, excess, allowed, left: given, best };
    for (slack, length) in (1..=MOST_SLACK).flat_map(|slack| (1..=LONGEST).map(move |l| (slack, l)))
    {
        if search.left == 0 || !search.best.is_empty() {
            break;
        }
        search.allowed = excess + slack;
        search.extend(&broken, excess, 0.0, length);
    }
    *left -= (given - search.left) / OF_A_TRIAL;
    search.best.into_iter().map(|best| best.1).collect()
}

struct Search<'a> {
    mesh: ArrayMesh,
    weights: &'a Weights,
    /// By how much degrees were out of their ranges at first.
    excess: u32,
    /// By so much they may be between two operations.
    allowed: u32,
    /// Operations that may be tried.
    left: usize,
    /// The cost of shapes over that at first, and the mesh; the least first.
    best: Vec<(f64, ArrayMesh)>,
}

impl Search<'_> {
    /// Tries all operations at the last broken vertex that mend it.
    fn extend(&mut self, broken: &[u32], excess: u32, cost: f64, length: u32) {
        let Some(&vertex) = broken.last() else { return };
        let mut list = Vec::new();
        operations(&self.mesh, vertex, true, &mut list);
        for operation in list {
            if self.left == 0 {
                return;
            }
            self.left -= 1;
            let mark = self.mesh.mark();
            self.step(operation, vertex, broken, excess, cost, length);
            self.mesh.undo(mark);
        }
    }

    fn step(
        &mut self,
        operation: Operation,
        vertex: u32,
        broken: &[u32],
        excess: u32,
        cost: f64,
        length: u32,
    ) {
        let mut cavity = Cavity::default();
        if !cavity.open(&self.mesh, operation) || !cavity.plan(&mut self.mesh, operation) {
            return;
        }
        let of = |search: &Self, v: u32, triangles: u32| match triangles {
            0 => 0,
            _ => search.weights.excess_of(&search.mesh, v, triangles),
        };
        let mut next = excess;
        let mut now: Vec<u32> = broken.to_vec();
        for &v in &cavity.vertices {
            let before = self.mesh.vertices[v as usize].triangles;
            let after = before.saturating_add_signed(cavity.growth(&self.mesh, v));
            let [old, new] = [of(self, v, before), of(self, v, after)];
            if v == vertex && new >= old {
                return;
            }
            next = next + new - old;
            now.retain(|other| *other != v || new > 0);
            if new > 0 && !now.contains(&v) {
                now.push(v);
            }
        }
        let is_last = next < self.excess;
        if next > self.allowed || length == 1 && !is_last {
            return;
        }
        let shape = |search: &Self, t: u32| search.weights.triangle(&search.mesh, t).0;
        let before: f64 = cavity.removed.iter().map(|t| shape(self, *t)).sum();
        let first = self.mesh.triangles.len() as u32;
        cavity.carry_out(&mut self.mesh);
        let after: f64 = (first..self.mesh.triangles.len() as u32).map(|t| shape(self, t)).sum();
        let cost = cost + after - before;
        let most = self.best.get(KEPT - 1).map_or(COSTLY, |best| best.0);
        if cost.partial_cmp(&most) != Some(Ordering::Less) {
            return;
        }
        if is_last {
            let mut mesh = self.mesh.clone();
            mesh.commit();
            let at = self.best.partition_point(|best| best.0 <= cost);
            self.best.insert(at, (cost, mesh));
            self.best.truncate(KEPT);
        } else {
            self.extend(&now, next, cost, length - 1);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::anneal::settle_all;
    use crate::array_mesh::Kind;
    use crate::array_mesh::tests::grid;
    use crate::options::Options;
    use mindeg_mesh::Random;

    fn excess(mesh: &ArrayMesh, weights: &Weights) -> u32 {
        let used = (0..).zip(&mesh.vertices).filter(|(_, vertex)| vertex.triangles > 0);
        used.map(|(v, _)| weights.excess(mesh, v)).sum()
    }

    /// The mesh after an operation, if that is possible.
    fn after(mesh: &ArrayMesh, operation: Operation) -> Option<ArrayMesh> {
        let (mut mesh, mut cavity) = (mesh.clone(), Cavity::default());
        let is_possible = cavity.open(&mesh, operation) && cavity.plan(&mut mesh, operation);
        is_possible.then(|| cavity.carry_out(&mut mesh))?;
        Some(mesh)
    }

    /// Degrees of exactly 6 inside.
    fn strict() -> Weights {
        Weights { interior: 6..=6, ..Weights::local(&Options::default(), 36.0) }
    }

    /// A grid after a random flip and others that break degrees no further: faults that have wandered apart.
    fn flipped(seed: u64, weights: &Weights) -> ArrayMesh {
        let (mut mesh, mut random) = (grid(8), Random::new(seed));
        mesh.goals.push(crate::goal::Goal { least: 1, triangles: 4, ..weights.goal_inside() });
        for vertex in mesh.vertices.iter_mut().filter(|vertex| vertex.kind == Kind::Boundary) {
            vertex.goal = 0;
        }
        let mut broken = u32::MAX;
        for _ in 0..200 {
            let triangle = random.below(mesh.triangles.len()) as u32;
            let flip = Operation::Flip { triangle, corner: random.below(3) as u8 };
            if !mesh.triangles[triangle as usize].is_alive() {
                continue;
            }
            let Some(mut flipped) = after(&mesh, flip) else { continue };
            let now = excess(&flipped, weights);
            if (1..=broken).contains(&now) {
                settle_all(&mut flipped, weights);
                (mesh, broken) = (flipped, now);
            }
        }
        mesh
    }

    #[test]
    fn chains_mend_degrees_that_no_single_operation_mends() {
        let weights = strict();
        let (mut hard, mut mended) = (0, 0);
        for seed in 0..60 {
            let mesh = flipped(seed, &weights);
            let before = excess(&mesh, &weights);
            let mut list = Vec::new();
            let is_easy = (0..mesh.vertices.len() as u32).any(|vertex| {
                operations(&mesh, vertex, true, &mut list);
                let mut found = list.iter().filter_map(|operation| after(&mesh, *operation));
                found.any(|mesh| excess(&mesh, &weights) < before)
            });
            if before == 0 || is_easy {
                continue;
            }
            hard += 1;
            let mut left = 1000;
            let found = chains(&mesh, &weights, 200, &mut left);
            assert!(left >= 800 && found.len() <= KEPT);
            mended += usize::from(!found.is_empty());
            for mesh in found {
                mesh.check().unwrap();
                assert!(excess(&mesh, &weights) < before);
            }
        }
        assert!(hard > 10 && 2 * mended > hard, "{mended} of {hard}");
    }

    #[test]
    fn chains_end_when_no_trials_are_left() {
        let weights = strict();
        let meshes = (0..9).map(|seed| flipped(seed, &weights));
        let broken = meshes.into_iter().find(|mesh| excess(mesh, &weights) > 0).unwrap();
        for (most, mut left) in [(0, 50), (50, 0)] {
            let given = left;
            assert!(chains(&broken, &weights, most, &mut left).is_empty());
            assert_eq!(left, given);
        }
    }
}
