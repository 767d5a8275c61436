//! Chains of operations on a surface that bring degrees into their ranges where no pair of operations does: each mends one
//! vertex and may break others, which the next mends. As in the plane, nothing moves while chains are looked for; the best
//! are then done with all smoothing and guards.

use crate::goal::Weights;
use crate::manifold::Manifold;
use crate::operations::{Cavity, Operation, operations};
use crate::surface::reference::OnSurface;
use crate::surface::work::SurfaceMesh;
use crate::trial::Bench;
use crate::triangle::min_angle;

/// The longest chain.
const LONGEST: u32 = 5;
/// By so much degrees may be out of their ranges between two operations, beyond what they were at first.
const MOST_SLACK: u32 = 3;
/// So many chains are tried at a vertex, the cheapest first.
const KEPT: usize = 8;
/// Angles may fall to this share of what they should be, and where they are so small already to this share of what they were:
/// they are mended later.
pub(crate) const BROKEN: f64 = 0.4;
pub(crate) const LOST: f64 = 0.5;

/// By how much the degree of a vertex is out of its range; 0 where it has no triangle.
fn excess_at(mesh: &SurfaceMesh<'_>, weights: &Weights, vertex: u32) -> u32 {
    match mesh.vertices[vertex as usize].triangles {
        0 => 0,
        _ => weights.excess(mesh, vertex),
    }
}

/// The same of some vertices, together.
pub(crate) fn excess_of(mesh: &SurfaceMesh<'_>, weights: &Weights, vertices: &[u32]) -> u32 {
    vertices.iter().map(|v| excess_at(mesh, weights, *v)).sum()
}

/// True if the degree of a vertex is out of its range.
pub(crate) fn is_broken(mesh: &SurfaceMesh<'_>, weights: &Weights, vertex: u32) -> bool {
    excess_at(mesh, weights, vertex) > 0
}

/// Does the best of the shortest chains that lower the excess and keep what must be kept, looking at `most` operations. True
/// if there is one; else the mesh is as it was. The mesh is recording.
pub(crate) fn is_mended(
    mesh: &mut SurfaceMesh<'_>,
    weights: &Weights,
    vertex: u32,
    most: usize,
) -> bool {
    let excess = weights.excess(mesh, vertex);
    let (mut left, mut failed) = (most, Vec::new());
    for (slack, length) in (1..=MOST_SLACK).flat_map(|slack| (1..=LONGEST).map(move |l| (slack, l)))
    {
        if left == 0 {
            break;
        }
        let allowed = excess + slack;
        let mut search =
            Search { mesh, weights, excess, allowed, left, failed: &failed, found: Vec::new() };
        search.extend(&mut Chain::default(), &[vertex], excess, length);
        let found = search.found;
        left = search.left;
        for chain in found {
            if carried_out(mesh, weights, &chain) {
                return true;
            }
            failed.push(chain.operations);
        }
    }
    false
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
    /// Chains that were no use.
    failed: &'a [Vec<Operation>],
    /// The cheapest first.
    found: Vec<Chain>,
}

impl Search<'_, '_> {
    /// Tries all operations at the last broken vertex that mend it.
    fn extend(&mut self, chain: &mut Chain, broken: &[u32], excess: u32, length: u32) {
        let Some(&vertex) = broken.last() else { return };
        let (mut list, mut known) = (Vec::new(), Vec::new());
        operations(self.mesh, vertex, true, &mut list);
        for operation in list {
            if self.left == 0 {
                return;
            }
            self.left -= 1;
            let (mark, count, cost) = (self.mesh.mark(), chain.vertices.len(), chain.cost);
            self.step(chain, operation, broken, &mut known, excess, length);
            self.mesh.undo(mark);
            chain.vertices.truncate(count);
            chain.cost = cost;
        }
    }

    /// Does an operation and what may follow. `known` has the excess of vertices before it: it is the same for all operations tried in
    /// its place.
    fn step(
        &mut self,
        chain: &mut Chain,
        operation: Operation,
        broken: &[u32],
        known: &mut Vec<(u32, u32)>,
        excess: u32,
        length: u32,
    ) {
        let mut cavity = Cavity::default();
        if !cavity.open(self.mesh, operation) {
            return;
        }
        let mut before_at = |v: u32| {
            let found = known.iter().find(|known| known.0 == v).map(|known| known.1);
            found.unwrap_or_else(|| {
                let excess = excess_at(self.mesh, self.weights, v);
                known.push((v, excess));
                excess
            })
        };
        let vertex = broken[broken.len() - 1];
        let before: u32 = cavity.vertices.iter().map(|v| before_at(*v)).sum();
        let own = before_at(vertex);
        if !cavity.plan(self.mesh, operation) {
            return;
        }
        let shape = |search: &Self, t: u32| search.weights.triangle(search.mesh, t).0;
        let old: f64 = cavity.removed.iter().map(|t| shape(self, *t)).sum();
        let first = self.mesh.triangles.len() as u32;
        cavity.carry_out(self.mesh);
        // Vertices that were broken from the start may be mended, too.
        let after = cavity.vertices.iter().map(|v| excess_at(self.mesh, self.weights, *v));
        let after: Vec<u32> = after.collect();
        let next = (excess + after.iter().sum::<u32>()).saturating_sub(before);
        let is_mended =
            cavity.vertices.iter().zip(&after).any(|(v, excess)| *v == vertex && *excess < own);
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
        if is_last && self.failed.contains(&chain.operations) {
            // Nothing follows, either: it would be longer than needed.
        } else if is_last {
            let at = self.found.partition_point(|found| found.cost <= chain.cost);
            self.found.insert(at, chain.clone());
            self.found.truncate(KEPT);
        } else {
            let mut now: Vec<u32> =
                broken.iter().copied().filter(|v| !cavity.vertices.contains(v)).collect();
            let is_broken = |(_, excess): &(&u32, &u32)| **excess > 0;
            now.extend(cavity.vertices.iter().zip(&after).filter(is_broken).map(|(v, _)| *v));
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
    let mark = mesh.mark();
    let mut bench = Bench::new(mesh, weights.clone());
    let is_used =
        |bench: &Bench<'_, OnSurface<'_>>, v: &u32| bench.mesh.vertices[*v as usize].triangles > 0;
    let before = excess_of(bench.mesh, weights, &old);
    let share = least_share(bench.mesh, weights, &old);
    let survey = OnSurface::survey(bench.mesh, &old, false);
    let is_done = chain
        .operations
        .iter()
        .all(|operation| bench.perform(*operation, f64::INFINITY, f64::NEG_INFINITY).is_some());
    let is_good = is_done && {
        let used: Vec<u32> = vertices.iter().copied().filter(|v| is_used(&bench, v)).collect();
        let keeps = |survey| OnSurface::keeps(bench.mesh, &survey, &used);
        excess_of(bench.mesh, weights, &vertices) < before
            && least_share(bench.mesh, weights, &used) >= BROKEN.min(LOST * share)
            && survey.is_none_or(keeps)
    };
    if !is_good {
        mesh.undo(mark);
    }
    is_good
}

/// The least share that the angles of the triangles at some vertices have of what they should be.
pub(crate) fn least_share(mesh: &SurfaceMesh<'_>, weights: &Weights, vertices: &[u32]) -> f64 {
    let mut star = Vec::new();
    let mut least = f64::INFINITY;
    for v in vertices {
        mesh.star(*v, &mut star);
        let shares =
            star.iter().map(|t| min_angle(mesh.corners(*t)) / weights.wanted_angle(mesh, *t));
        least = shares.fold(least, f64::min);
    }
    least
}
