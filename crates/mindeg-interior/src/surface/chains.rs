//! Chains of operations on a surface that bring degrees into their ranges where no pair of operations does: each mends one
//! vertex and may break others, which the next mends. As in the plane, nothing moves while chains are looked for; the best
//! are then done with all smoothing and guards.

use crate::goal::Weights;
use crate::manifold::Manifold;
use crate::operations::{Cavity, Operation, operations};
use crate::stage::Stage;
use crate::surface::reference::OnSurface;
use crate::surface::work::SurfaceMesh;
use crate::trial::Bench;
use mindeg_mesh::Cancelled;

/// The longest chain.
const LONGEST: u32 = 5;
/// By so much degrees may be out of their ranges between two operations, beyond what they were at first.
const MOST_SLACK: u32 = 3;
/// So many chains are tried at a vertex, the cheapest first.
const KEPT: usize = 8;
/// So many operations are looked at for one vertex.
const MOST: usize = 12_000;
/// So many vertices get a search: a mesh with more broken ones has a part that cannot be mended.
const VERTICES: usize = 300;
/// Angles may fall to this share of the floor: they are mended later.
const BROKEN_FLOOR: f64 = 0.4;

/// Mends vertices whose degrees are out of range. Returns how many chains were done.
pub(crate) fn mend(
    mesh: &mut SurfaceMesh<'_>,
    weights: &Weights,
    stage: &mut Stage<'_>,
) -> Result<usize, Cancelled> {
    let is_broken = |mesh: &SurfaceMesh<'_>, v: u32| {
        mesh.vertices[v as usize].triangles > 0 && weights.excess(mesh, v) > 0
    };
    let all = 0..mesh.vertices.len() as u32;
    let broken: Vec<u32> = all.filter(|v| is_broken(mesh, *v)).take(VERTICES).collect();
    let mut done = 0;
    for vertex in broken {
        stage.still()?;
        if !is_broken(mesh, vertex) {
            continue;
        }
        for chain in found(mesh, weights, vertex) {
            if carried_out(mesh, weights, &chain) {
                done += 1;
                break;
            }
        }
    }
    Ok(done)
}

/// The best chains of the fewest operations that lower the excess.
fn found(mesh: &mut SurfaceMesh<'_>, weights: &Weights, vertex: u32) -> Vec<Chain> {
    let excess = weights.excess(mesh, vertex);
    mesh.record();
    let mut search = Search { mesh, weights, excess, allowed: 0, left: MOST, found: Vec::new() };
    let mut chain = Chain::default();
    for (slack, length) in (1..=MOST_SLACK).flat_map(|slack| (1..=LONGEST).map(move |l| (slack, l)))
    {
        if search.left == 0 || !search.found.is_empty() {
            break;
        }
        search.allowed = excess + slack;
        search.extend(&mut chain, &[vertex], excess, length);
    }
    let found = search.found;
    mesh.commit();
    found
}

/// Operations one after the other, the vertices of all their cavities, and by how much they raise the cost of shapes.
#[derive(Debug, Clone, Default)]
struct Chain {
    operations: Vec<Operation>,
    vertices: Vec<u32>,
    cost: f64,
}

struct Search<'a, 's> {
    mesh: &'a mut SurfaceMesh<'s>,
    weights: &'a Weights,
    /// By how much the degree of the vertex was out of its range at first.
    excess: u32,
    /// By so much degrees may be between two operations.
    allowed: u32,
    /// Operations that may be looked at.
    left: usize,
    /// The cheapest first.
    found: Vec<Chain>,
}

impl Search<'_, '_> {
    fn excess_of(&self, vertices: &[u32]) -> u32 {
        let is_used = |v: &&u32| self.mesh.vertices[**v as usize].triangles > 0;
        vertices.iter().filter(is_used).map(|v| self.weights.excess(self.mesh, *v)).sum()
    }

    /// Tries all operations at the last broken vertex that mend it.
    fn extend(&mut self, chain: &mut Chain, broken: &[u32], excess: u32, length: u32) {
        let Some(&vertex) = broken.last() else { return };
        let mut list = Vec::new();
        operations(self.mesh, vertex, true, &mut list);
        for operation in list {
            if self.left == 0 {
                return;
            }
            self.left -= 1;
            let (mark, count, cost) = (self.mesh.mark(), chain.vertices.len(), chain.cost);
            self.step(chain, operation, broken, excess, length);
            self.mesh.undo(mark);
            chain.vertices.truncate(count);
            chain.cost = cost;
        }
    }

    fn step(
        &mut self,
        chain: &mut Chain,
        operation: Operation,
        broken: &[u32],
        excess: u32,
        length: u32,
    ) {
        let mut cavity = Cavity::default();
        if !cavity.open(self.mesh, operation) {
            return;
        }
        let (before, vertex) = (self.excess_of(&cavity.vertices), broken[broken.len() - 1]);
        let own = self.weights.excess(self.mesh, vertex);
        if !cavity.plan(self.mesh, operation) {
            return;
        }
        let shape = |search: &Self, t: u32| search.weights.triangle(search.mesh, t).0;
        let old: f64 = cavity.removed.iter().map(|t| shape(self, *t)).sum();
        let first = self.mesh.triangles.len() as u32;
        cavity.carry_out(self.mesh);
        // Vertices that were broken from the start may be mended, too.
        let next = (excess + self.excess_of(&cavity.vertices)).saturating_sub(before);
        let is_mended = self.excess_of(&[vertex]) < own;
        let is_last = next < self.excess;
        if !is_mended || next > self.allowed || length == 1 && !is_last {
            return;
        }
        let new: f64 = (first..self.mesh.triangles.len() as u32).map(|t| shape(self, t)).sum();
        chain.cost += new - old;
        let most = self.found.get(KEPT - 1).map_or(f64::INFINITY, |found| found.cost);
        if chain.cost.is_nan() || chain.cost >= most {
            return;
        }
        chain.operations.push(operation);
        chain.vertices.extend(&cavity.vertices);
        if is_last {
            let at = self.found.partition_point(|found| found.cost <= chain.cost);
            self.found.insert(at, chain.clone());
            self.found.truncate(KEPT);
        } else {
            let mut now: Vec<u32> =
                broken.iter().copied().filter(|v| !cavity.vertices.contains(v)).collect();
            now.extend(cavity.vertices.iter().filter(|v| self.excess_of(&[**v]) > 0));
            self.extend(chain, &now, next, length - 1);
        }
        chain.operations.pop();
    }
}

/// Does a chain with all smoothing, if degrees get better, no angle too small, and the space is kept.
fn carried_out(mesh: &mut SurfaceMesh<'_>, weights: &Weights, chain: &Chain) -> bool {
    let given = mesh.vertices.len() as u32;
    let mut vertices = chain.vertices.clone();
    vertices.sort_unstable();
    vertices.dedup();
    let old: Vec<u32> = vertices.iter().copied().filter(|v| *v < given).collect();
    mesh.record();
    let mut bench = Bench::new(mesh, weights.clone());
    let is_used =
        |bench: &Bench<'_, OnSurface<'_>>, v: &u32| bench.mesh.vertices[*v as usize].triangles > 0;
    let excess = |bench: &Bench<'_, OnSurface<'_>>, vertices: &[u32]| -> u32 {
        let used = vertices.iter().filter(|v| is_used(bench, v));
        used.map(|v| bench.weights.excess(bench.mesh, *v)).sum()
    };
    let (before, angle) = (excess(&bench, &old), bench.cost(&old, std::iter::empty()).min_angle);
    let survey = OnSurface::survey(bench.mesh, &old, false);
    let is_done = chain
        .operations
        .iter()
        .all(|operation| bench.perform(*operation, f64::INFINITY, f64::NEG_INFINITY).is_some());
    let is_good = is_done && {
        let after = bench.cost(&vertices, std::iter::empty()).min_angle;
        let used: Vec<u32> = vertices.iter().copied().filter(|v| is_used(&bench, v)).collect();
        let keeps = |survey| OnSurface::keeps(bench.mesh, &survey, &used);
        excess(&bench, &vertices) < before
            && after >= angle.min(BROKEN_FLOOR * weights.floor)
            && survey.is_none_or(keeps)
    };
    if !is_good {
        mesh.undo(0);
    }
    mesh.commit();
    is_good
}
