//! The optimiser: smoothing, single operations where something is wrong, then pairs of operations.

use crate::array_mesh::ArrayMesh;
use crate::compass::polish;
use crate::failed::Failed;
use crate::goal::Weights;
use crate::manifold::Manifold;
use crate::operations::{Operation, operations};
use crate::smooth::{Power, Sweeper};
use crate::stage::Stage;
use crate::trial::Bench;
use crate::triangle::{has_sine, min_angle};
use mindeg_mesh::Cancelled;
use std::collections::VecDeque;

/// Rounds of operations and smoothing.
const ROUNDS: usize = 4;
/// Angles this much above the floor are polished, too, in degrees.
const MARGIN: f64 = 4.0;
/// The guard looks at so many operations.
const GUARDED: usize = 5;
/// Where an operation mends a degree, angles may fall to this share of the floor: they are mended later.
const BROKEN_FLOOR: f64 = 0.4;

/// The kind of pairs of operations, after those of single operations.
const PAIRS: usize = 2;

/// Which vertices need work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Need {
    /// A degree out of its range, or a triangle with too small an angle.
    Any,
    /// A degree out of its range.
    Degree,
}

/// Improves a mesh in place. With `pairs`, what single operations leave is tried with two in a row.
pub(crate) fn optimise<S: Manifold>(
    mesh: &mut ArrayMesh<S>,
    weights: &Weights,
    mut pairs: Option<Pairs>,
    stage: &mut Stage<'_>,
) -> Result<(), Cancelled> {
    let mut sweeper = Sweeper::new();
    smooth_and_mend(mesh, weights, pairs.as_mut(), &mut sweeper, stage)?;
    polish_all(mesh, weights, &mut sweeper, stage)
}

/// Moves the vertices of a mesh as it was packed.
pub(crate) fn smooth_packed<S: Manifold>(
    mesh: &mut ArrayMesh<S>,
    sweeper: &mut Sweeper<S::Vector>,
    stage: &mut Stage<'_>,
) -> Result<(), Cancelled> {
    stage.reach(0.4)?;
    sweeper.run(mesh, Power::Two, 10, stage)?;
    stage.reach(0.5)?;
    sweeper.run(mesh, Power::Four, 5, stage)
}

/// Smooths, and does operations as long as they help.
pub(crate) fn smooth_and_mend<S: Manifold>(
    mesh: &mut ArrayMesh<S>,
    weights: &Weights,
    mut pairs: Option<&mut Pairs>,
    sweeper: &mut Sweeper<S::Vector>,
    stage: &mut Stage<'_>,
) -> Result<(), Cancelled> {
    smooth_packed(mesh, sweeper, stage)?;
    let mut failed = Failed::new();
    for round in 0..ROUNDS {
        failed.look(mesh);
        stage.reach(0.6 + 0.1 * round as f64)?;
        let mut changes = 0;
        for need in [Need::Any, Need::Degree] {
            changes += singles(mesh, weights, need, &mut failed, stage)?;
        }
        if let Some(pairs) = &mut pairs {
            changes += pairs_of_operations(mesh, weights, pairs, &mut failed, stage)?;
        }
        if changes == 0 && round > 0 {
            break;
        }
        sweeper.run(mesh, Power::Four, 5, stage)?;
    }
    Ok(())
}

/// True if no degree and no angle leaves anything to be desired.
pub(crate) fn is_done<S: Manifold>(mesh: &ArrayMesh<S>, weights: &Weights) -> bool {
    needy(mesh, weights, Need::Any).is_empty()
}

/// The vertices where something is wrong, ascending.
fn needy<S: Manifold>(mesh: &ArrayMesh<S>, weights: &Weights, need: Need) -> VecDeque<u32> {
    let mut is_needy: Vec<bool> = (0..)
        .zip(&mesh.vertices)
        .map(|(v, vertex)| vertex.triangles > 0 && weights.excess(mesh, v) > 0)
        .collect();
    if need == Need::Any {
        for (t, triangle) in (0..).zip(&mesh.triangles) {
            if triangle.is_alive() && lacks(mesh, weights, t) {
                triangle.vertices.iter().for_each(|v| is_needy[*v as usize] = true);
            }
        }
    }
    (0..mesh.vertices.len() as u32).filter(|v| is_needy[*v as usize]).collect()
}

/// True if a triangle's minimum angle is smaller than it should be, or no corner inside where one should be.
fn lacks<S: Manifold>(mesh: &ArrayMesh<S>, weights: &Weights, triangle: u32) -> bool {
    if weights.is_outside(mesh, triangle) {
        return true;
    }
    let corners = mesh.corners(triangle);
    !has_sine(corners, weights.floor_sine)
        && min_angle(corners) < weights.wanted_angle(mesh, triangle) - 1e-3
}

/// True if something is wrong at a vertex.
fn is_needy<S: Manifold>(
    bench: &mut Bench<'_, S>,
    vertex: u32,
    need: Need,
    star: &mut Vec<u32>,
) -> bool {
    if bench.mesh.vertices[vertex as usize].triangles == 0 {
        return false;
    }
    if bench.weights.excess(bench.mesh, vertex) > 0 {
        return true;
    }
    if need == Need::Degree {
        return false;
    }
    bench.mesh.star(vertex, star);
    star.iter().any(|t| lacks(bench.mesh, &bench.weights, *t))
}

/// Works through all needy vertices with the best single operation of each. Returns the number of operations done.
fn singles<S: Manifold>(
    mesh: &mut ArrayMesh<S>,
    weights: &Weights,
    need: Need,
    failed: &mut Failed<S::Vector>,
    stage: &mut Stage<'_>,
) -> Result<usize, Cancelled> {
    let mut star = Vec::new();
    let mut list = Vec::new();
    let mut bench = Bench::new(mesh, weights.clone());
    let mut queue = needy(bench.mesh, weights, need);
    queue.retain(|v| !failed.has(need as usize, *v));
    let mut is_queued = vec![false; bench.mesh.vertices.len()];
    queue.iter().for_each(|v| is_queued[*v as usize] = true);
    let mut left = 20 * queue.len() + 100;
    let mut done = 0;
    while let Some(vertex) = queue.pop_front() {
        is_queued[vertex as usize] = false;
        if left == 0 {
            break;
        }
        left -= 1;
        if left.is_multiple_of(256) {
            stage.still()?;
        }
        if !is_needy(&mut bench, vertex, need, &mut star) {
            continue;
        }
        operations(bench.mesh, vertex, false, &mut list);
        let Some(best) = best_single(&mut bench, &list, need) else {
            failed.add(need as usize, vertex);
            continue;
        };
        bench.perform(best, f64::INFINITY, f64::NEG_INFINITY);
        done += 1;
        failed.forget(&bench.cavity.vertices);
        is_queued.resize(bench.mesh.vertices.len(), false);
        for v in &bench.cavity.vertices {
            if !is_queued[*v as usize] {
                is_queued[*v as usize] = true;
                queue.push_back(*v);
            }
        }
    }
    Ok(done)
}

/// The operation that lowers the energy most, within the guard.
fn best_single<S: Manifold>(
    bench: &mut Bench<'_, S>,
    list: &[Operation],
    need: Need,
) -> Option<Operation> {
    let floor = match need {
        Need::Any => bench.weights.floor,
        Need::Degree => BROKEN_FLOOR * bench.weights.floor,
    };
    let mut best: Vec<(f64, Operation)> = Vec::new();
    let allowance = match need {
        Need::Any if bench.weights.may_violate => f64::INFINITY,
        Need::Any => 0.0,
        Need::Degree => -0.5 * bench.weights.degree,
    };
    // The guard is costly: it looks at the best alone, until one passes.
    let most = if S::IS_PLANE { 1 } else { GUARDED };
    bench.mesh.record();
    for operation in list {
        let mark = bench.mesh.mark();
        let needed = best.get(most - 1).map_or(0.0, |best| best.0);
        if let Some(effect) = bench.perform(*operation, allowance, needed)
            && effect.is_good(floor)
        {
            let at = best.partition_point(|best| best.0 >= effect.gain());
            best.insert(at, (effect.gain(), *operation));
            best.truncate(most);
        }
        bench.mesh.undo(mark);
    }
    let found = best.iter().find(|best| S::IS_PLANE || bench.keeps(&[best.1]));
    let found = found.map(|best| best.1);
    bench.mesh.commit();
    found
}

/// How far the search for pairs goes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pairs {
    /// Vertices that one round tries pairs at: some ten milliseconds each.
    pub(crate) vertices: usize,
    /// First operations that are followed up.
    pub(crate) firsts: usize,
    /// How often operations have been tried.
    pub(crate) trials: usize,
    /// How often they may be tried in all.
    pub(crate) most: usize,
}

impl Pairs {
    /// A whole mesh, from one start.
    pub(crate) const FOR_A_TRY: Self = Self { vertices: 300, firsts: 10, trials: 0, most: 2500 };
}

/// The same with two operations in a row, the first of which may be worse.
pub(crate) fn pairs_of_operations<S: Manifold>(
    mesh: &mut ArrayMesh<S>,
    weights: &Weights,
    pairs: &mut Pairs,
    failed: &mut Failed<S::Vector>,
    stage: &mut Stage<'_>,
) -> Result<usize, Cancelled> {
    let mut star = Vec::new();
    let mut bench = Bench::new(mesh, weights.clone());
    let mut queue = needy(bench.mesh, weights, Need::Any);
    queue.retain(|v| !failed.has(PAIRS, *v));
    let mut left = (3 * queue.len() + 20).min(pairs.vertices);
    let mut done = 0;
    while let Some(vertex) = queue.pop_front() {
        if left == 0 || pairs.trials + bench.trials() > pairs.most {
            break;
        }
        left -= 1;
        stage.still()?;
        if !is_needy(&mut bench, vertex, Need::Any, &mut star) {
            continue;
        }
        if failed.has(PAIRS, vertex) {
            continue;
        }
        let Some(pair) = best_pair(&mut bench, vertex, pairs.firsts) else {
            failed.add(PAIRS, vertex);
            continue;
        };
        for operation in pair {
            bench.perform(operation, f64::INFINITY, f64::NEG_INFINITY);
            failed.forget(&bench.cavity.vertices);
            queue.extend(&bench.cavity.vertices);
        }
        done += 1;
    }
    pairs.trials += bench.trials();
    Ok(done)
}

fn best_pair<S: Manifold>(
    bench: &mut Bench<'_, S>,
    vertex: u32,
    most: usize,
) -> Option<[Operation; 2]> {
    let mut firsts = Vec::new();
    operations(bench.mesh, vertex, true, &mut firsts);
    bench.mesh.record();
    // The most promising first operations, by what they alone do.
    let mut ranked = Vec::new();
    for (index, operation) in firsts.iter().enumerate() {
        let mark = bench.mesh.mark();
        let allowance = 2.1 * bench.weights.degree;
        if let Some(effect) = bench.perform(*operation, allowance, f64::NEG_INFINITY) {
            ranked.push((-effect.gain(), index));
        }
        bench.mesh.undo(mark);
    }
    ranked.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let floor = bench.weights.floor;
    let mut best: Option<(f64, [Operation; 2])> = None;
    let mut good = Vec::new();
    let (mut star, mut seconds) = (Vec::new(), Vec::new());
    for (_, index) in ranked.into_iter().take(most) {
        let first = firsts[index];
        let mark = bench.mesh.mark();
        if let Some(one) = bench.perform(first, f64::INFINITY, f64::NEG_INFINITY) {
            let centers = bench.cavity.vertices.clone();
            for center in centers {
                if !is_needy(bench, center, Need::Any, &mut star) {
                    continue;
                }
                operations(bench.mesh, center, true, &mut seconds);
                for second in &seconds {
                    let mark = bench.mesh.mark();
                    let allowance = one.before.hard - one.after.hard;
                    let needed = best.map_or(0.0, |(gain, _)| gain) - one.gain();
                    if let Some(two) = bench.perform(*second, allowance, needed) {
                        let gain = one.gain() + two.gain();
                        let energy = one.before.energy.min(two.after.energy).abs();
                        let least = one.after.min_angle.min(two.before.min_angle);
                        // The first may have spoilt what the second's patch mends.
                        let spoilt = least < one.before.min_angle.min(floor);
                        let reached = if spoilt {
                            two.after.min_angle
                        } else {
                            two.after.min_angle.min(floor)
                        };
                        let is_good = gain > 1e-7 * (1.0 + energy)
                            && reached >= one.before.min_angle.min(floor);
                        if is_good && best.is_none_or(|(most, _)| gain > most) {
                            good.push((gain, [first, *second]));
                            best = good.last().copied();
                        }
                    }
                    bench.mesh.undo(mark);
                }
            }
        }
        bench.mesh.undo(mark);
    }
    // The last is the best.
    let found = good.iter().rev().take(GUARDED).find(|good| S::IS_PLANE || bench.keeps(&good.1));
    let found = found.map(|good| good.1);
    bench.mesh.commit();
    found
}

/// Moves the vertices of small angles until they rest.
fn polish_all<S: Manifold>(
    mesh: &mut ArrayMesh<S>,
    weights: &Weights,
    sweeper: &mut Sweeper<S::Vector>,
    stage: &mut Stage<'_>,
) -> Result<(), Cancelled> {
    sweeper.start(mesh.vertices.len(), true);
    sweeper.sweep(mesh, 15, stage, |mesh, v, ring| {
        // However short a move is, it counts.
        if polish(mesh, v, weights.floor + MARGIN, ring) { f64::INFINITY } else { 0.0 }
    })
}
