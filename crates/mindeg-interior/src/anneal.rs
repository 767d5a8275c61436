//! Random operations on a disc, each kept by chance if it costs little: the way over a hill that no pair crosses.

use crate::array_mesh::{ArrayMesh, Kind};
use crate::compass::settle;
use crate::goal::Weights;
use crate::operations::operations;
use crate::smooth::Ring;
use crate::trial::Bench;
use mindeg_mesh::Random;

/// The heat at the start and at the end.
const HEAT: [f64; 2] = [6.0, 0.1];

/// Tries so many operations at the first `near` vertices of a mesh and at new ones, and ends with the best mesh on
/// the way. Returns how many could be done.
pub(crate) fn anneal(
    mesh: &mut ArrayMesh,
    weights: &Weights,
    near: usize,
    steps: u32,
    random: &mut Random,
) -> usize {
    let given = mesh.vertices.len();
    let mut bench = Bench::new(mesh, weights.clone());
    let mut list = Vec::new();
    let (mut gained, mut best) = (0.0, (0.0, bench.mesh.mark()));
    bench.mesh.record();
    for step in 0..steps {
        let share = f64::from(step) / f64::from(steps);
        let heat = HEAT[0] * libm::exp(share * libm::log(HEAT[1] / HEAT[0]));
        let among = near + bench.mesh.vertices.len() - given;
        // The vertex in the middle more often than others.
        let vertex = match random.below(among + 3) {
            at if at < near => at,
            at if at < among => given + at - near,
            _ => 0,
        } as u32;
        if bench.mesh.vertices[vertex as usize].triangles == 0 {
            continue;
        }
        operations(bench.mesh, vertex, true, &mut list);
        if list.is_empty() {
            continue;
        }
        let operation = list[random.below(list.len())];
        let mark = bench.mesh.mark();
        let allowance = if random.unit() < 0.5 { 0.0 } else { f64::INFINITY };
        let needed = heat * libm::log(random.unit().max(1e-300));
        let keeps = match bench.perform(operation, allowance, needed) {
            Some(effect) if effect.gain() > needed => {
                gained += effect.gain();
                true
            }
            _ => false,
        };
        if !keeps {
            bench.mesh.undo(mark);
        } else if gained > best.0 + 1e-9 {
            best = (gained, bench.mesh.mark());
        }
    }
    bench.mesh.undo(best.1);
    bench.mesh.commit();
    bench.trials()
}

/// Sweeps at most.
const SWEEPS: usize = 4;

/// Moves all free vertices of a disc until they rest.
pub(crate) fn settle_all(mesh: &mut ArrayMesh, weights: &Weights) {
    let mut ring = Ring::default();
    for _ in 0..SWEEPS {
        let mut moved = false;
        for v in 0..mesh.vertices.len() as u32 {
            let vertex = &mesh.vertices[v as usize];
            if vertex.kind == Kind::Free && vertex.triangles > 0 {
                moved |= settle(mesh, v, weights, 0.004, &mut ring);
            }
        }
        if !moved {
            break;
        }
    }
}
