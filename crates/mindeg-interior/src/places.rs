//! The search by place: where a degree is out of its range or an angle below its local limit, the disc round
//! that place is worked on alone, until it is as wanted or all has failed.

use crate::ahead::Ahead;
use crate::anneal::{anneal, settle_all};
use crate::array_mesh::{ArrayMesh, Kind};
use crate::chains::chains;
use crate::disc::{Disc, ENOUGH_TRIANGLES};
use crate::failed::Failed;
use crate::goal::{Goal, Weights};
use crate::optimise::{Pairs, pairs_of_operations, smooth_packed};
use crate::options::Options;
use crate::redraw::{Turn, broken, redraw};
use crate::restart::Restart;
use crate::smooth::Sweeper;
use crate::stage::Stage;
use crate::star::Stars;
use crate::triangle::{has_sine, min_angle};
use crate::verdict::enough;
use crate::worth::{GOOD, Worth};
use mindeg_mesh::{Cancelled, Random};
use std::collections::BTreeSet;
use std::f64::consts::PI;

/// Passes over all places; each tries twice as much as the one before.
const PASSES: u32 = 5;
/// The rings of a disc in each pass.
const RINGS: [usize; 6] = [2, 3, 4, 6, 9, 9];
/// Trials of operations for angles: at any mesh, and for each triangle.
const TRIALS: [usize; 2] = [1500, 2];
/// From so many on, more triangles bring half a trial each: as measured, more hardly raise shares.
const MANY_TRIALS: usize = 25_000;
/// Still more triangles bring none.
const MANY_TRIANGLES: usize = 60_000;
/// Trials of operations for degrees, likewise.
const TRIALS_FOR_DEGREES: [usize; 2] = [12_000, 1];
/// At most so many times as much is tried where a degree is out of its range, if so many trials are left for each.
const MOST_FOR_BROKEN: u64 = 2;
const TRIALS_FOR_BROKEN: usize = 1200;
/// Of the time at places, as measured on a map of 3,142 regions.
const SHARE_OF_REDRAWING: f64 = 0.75;
/// If fewer are left for each, discs are first drawn anew, which takes less time for each and costs more angles.
const FEW_FOR_BROKEN: usize = 300;
/// From this effort on, new starts get pairs of operations, too.
const MANY: u64 = 4;
/// The search for one chain takes as long as so many trials, at most.
const CHAIN: usize = 400;
/// Random operations in a row.
const STEPS: u32 = 100;
/// The same after a chain of operations or a new start.
const STEPS_AFTERWARDS: u32 = 40;

/// Works on all places where something is left to be desired. The mesh never gets worse: a disc is replaced if
/// violations get fewer, or if the least share of a local limit and the least angle do not fall and something gets better. `share`: of the trials for
/// angles that a mesh of this size may take.
pub(crate) fn mend_places(
    mesh: &mut ArrayMesh,
    options: &Options,
    stars: &Stars,
    floor: f64,
    share: f64,
    stage: &mut Stage<'_>,
) -> Result<(), Cancelled> {
    let weights = Weights::local(options, floor);
    let enough = enough(options);
    let enough_sine = libm::sin(enough.min(60.0) * (PI / 180.0));
    let work = Work { options, enough, enough_sine, weights };
    let triangles = mesh.triangles.len();
    let more = triangles.min(MANY_TRIANGLES) / 2;
    let angles = TRIALS[0] + (TRIALS[1] * triangles).min(MANY_TRIALS + more);
    let degrees = TRIALS_FOR_DEGREES[0] + TRIALS_FOR_DEGREES[1] * triangles;
    let mut left = [(share * angles as f64) as usize, degrees];
    let count = |mesh: &ArrayMesh| broken(mesh, &work.weights).count();
    if left[1] < FEW_FOR_BROKEN * count(mesh) {
        stage.part(SHARE_OF_REDRAWING, |stage| {
            redraw(mesh, &work.weights, options, stars, Turn::First, stage)
        })?;
        left[1] = left[1].min(TRIALS_FOR_BROKEN * count(mesh));
    }
    let given_for_angles = left[0].max(1) as f64;
    for pass in 0..PASSES {
        let places = work.places(mesh);
        if places.is_empty() {
            break;
        }
        let broken = count(mesh);
        let affordable = (left[1] / (TRIALS_FOR_BROKEN * broken.max(1))) as u64;
        let is_hasty = affordable == 0;
        let affordable = affordable >> pass;
        let mut waiting = broken;
        // Later passes try more at fewer places.
        let is_last = pass + 1 == PASSES;
        let kept = [0, if is_last { 0 } else { left[1] / 2 }];
        let of = places.len() as f64;
        let mut ahead = Ahead::new();
        for (index, vertex) in places.iter().enumerate() {
            // With trials left for all, each pass takes about as long as all before it; else trials are what takes time.
            let passes = f64::from((1 << pass) - 1) + f64::from(1 << pass) * index as f64 / of;
            let tried = 1.0 - left[0] as f64 / given_for_angles;
            stage.reach(tried.max(passes / f64::from((1 << PASSES) - 1)))?;
            // The rings of the disc of a vertex, where trials are left for it.
            let rings = |v: u32| {
                let is_alive = mesh.vertices[v as usize].triangles > 0;
                let kind = usize::from(is_alive && work.weights.excess(mesh, v) > 0);
                (is_alive && left[kind] > kept[kind]).then(|| RINGS[pass as usize + kind])
            };
            if rings(*vertex).is_none() {
                continue;
            }
            let cut = |v| Disc::cut(mesh, &work.weights, v, rings(v)?, ENOUGH_TRIANGLES);
            let given = |disc: &Disc, kind: usize| {
                // Each broken place leaves as much to those that wait for their turn.
                let sharing = if work.is_broken(disc) { waiting.max(1) } else { 1 };
                left[kind].saturating_sub(kept[kind]) / sharing
            };
            let mend = |disc: &Disc| {
                let before = work.worth(&disc.mesh);
                let kind = usize::from(before.excess > 0);
                let given = given(disc, kind);
                let mut unused = given;
                let most = if work.is_broken(disc) { MOST_FOR_BROKEN } else { 1 };
                let effort = (1 << pass) * affordable.clamp(1, most);
                let better = if before.is_good() || given == 0 {
                    Ok(None)
                } else {
                    work.mended(disc, before, effort, is_hasty, &mut unused, stage)
                };
                (kind, given, given - unused, better)
            };
            let Some((disc, mut mended)) = ahead.turn(&places[index..], cut, mend) else {
                continue;
            };
            let (kind, then, used, _) = mended;
            let now = given(&disc, kind);
            // With other trials ahead of its turn it may have ended elsewhere.
            if then != now && used >= then.min(now) {
                mended = mend(&disc);
            }
            let (kind, _, used, better) = mended;
            waiting = waiting.saturating_sub(usize::from(work.is_broken(&disc)));
            left[kind] -= used;
            if let Some(better) = better? {
                ahead.forget(&disc);
                disc.put_back(mesh, &better);
                if kind == 1 {
                    // Mended degrees cost angles, which may take half as long.
                    let again = (used / 2).min(left[1]);
                    left = [left[0] + again, left[1] - again];
                }
            }
        }
    }
    redraw(mesh, &work.weights, options, stars, Turn::Last, stage)
}

/// The input that all places share.
struct Work<'a> {
    options: &'a Options,
    weights: Weights,
    /// The angle from which on nothing is left to be desired, and its sine.
    enough: f64,
    enough_sine: f64,
}

/// The best mesh of a disc so far.
struct Best {
    before: Worth,
    found: Option<(Worth, ArrayMesh)>,
}

impl Best {
    /// Takes a mesh if it is better. True if nothing is left to be desired.
    fn offer(&mut self, mesh: ArrayMesh, worth: Worth) -> bool {
        let least = self.found.as_ref().map_or(&self.before, |best| &best.0);
        if !worth.is_allowed(&self.before) || !worth.is_better(least) || mesh.check().is_err() {
            return false;
        }
        self.found = Some((worth, mesh));
        self.is_done()
    }

    /// True if nothing is left to be desired.
    fn is_done(&self) -> bool {
        self.found.as_ref().is_some_and(|found| found.0.is_done(&self.before))
    }

    /// The best mesh so far, if it has fewer violations.
    fn mesh(&self) -> Option<&ArrayMesh> {
        let better = self.found.as_ref().filter(|found| found.0.excess < self.before.excess);
        better.map(|found| &found.1)
    }
}

impl Work<'_> {
    fn worth(&self, mesh: &ArrayMesh) -> Worth {
        Worth::of(mesh, &self.weights, self.enough)
    }

    /// True if the degree in the middle of a disc is out of its range.
    fn is_broken(&self, disc: &Disc) -> bool {
        self.weights.excess(&disc.mesh, 0) > 0
    }

    /// The vertices where something is left to be desired, the worst first.
    fn places(&self, mesh: &ArrayMesh) -> Vec<u32> {
        // Degrees come first, by how far they are out of their range; then the least shares.
        let mut found: Vec<(std::cmp::Reverse<u32>, f64, u32)> = Vec::new();
        for (v, vertex) in (0..).zip(&mesh.vertices) {
            let excess = if vertex.triangles > 0 { self.weights.excess(mesh, v) } else { 0 };
            if excess > 0 {
                found.push((std::cmp::Reverse(excess), 0.0, v));
            }
        }
        for (t, triangle) in (0..).zip(&mesh.triangles) {
            if !triangle.is_alive() {
                continue;
            }
            if self.weights.is_outside(mesh, t) {
                found.push((std::cmp::Reverse(1), 0.0, triangle.vertices[0]));
            }
            if has_sine(mesh.corners(t), self.enough_sine) {
                continue;
            }
            let share = self.share(mesh, t);
            if share < GOOD {
                // The vertex with the least limit.
                let goal = |v: u32| mesh.goals.get(mesh.vertices[v as usize].goal as usize);
                let limit = |v: u32| goal(v).map_or(90.0, Goal::local_limit);
                let [a, b, c] = triangle.vertices;
                let least = |v: u32, u: u32| if limit(u) < limit(v) { u } else { v };
                found.push((std::cmp::Reverse(0), share, least(least(a, b), c)));
            }
        }
        found.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.cmp(&b.2)));
        let mut once = BTreeSet::new();
        found.into_iter().map(|place| place.2).filter(|v| once.insert(*v)).collect()
    }

    /// The share of its local limit that a triangle's minimum angle has.
    fn share(&self, mesh: &ArrayMesh, triangle: u32) -> f64 {
        let limit = self.weights.local_limit(mesh, triangle).min(self.enough);
        min_angle(mesh.corners(triangle)) / limit
    }

    /// A better mesh of a disc, if one was found: by chains of operations for degrees, by pairs of operations, by random
    /// operations in a row, and by new starts. `left`: the trials that may be made.
    fn mended(
        &self,
        disc: &Disc,
        before: Worth,
        effort: u64,
        is_hasty: bool,
        left: &mut usize,
        stage: &Stage<'_>,
    ) -> Result<Option<ArrayMesh>, Cancelled> {
        let weights = &self.weights;
        let mut best = Best { before, found: None };
        let mut stage = stage.within();
        // Chains are cheap and mend nearly everything, but cost angles: where trials suffice, they come last.
        if is_hasty {
            self.mend_degrees(&disc.mesh, &mut best, effort, left);
        }
        if best.is_done() {
            return Ok(best.found.map(|best| best.1));
        }
        let mut mesh = best.mesh().unwrap_or(&disc.mesh).clone();
        self.pairs(&mut mesh, effort, left, &mut stage)?;
        settle_all(&mut mesh, weights);
        let worth = self.worth(&mesh);
        let mut is_done = best.offer(mesh, worth);
        // Vertices of the rim come last.
        let near = disc.mesh.vertices.iter().filter(|v| v.kind == Kind::Free).count().max(1);
        let mut starts = Restart::new(&disc.mesh, self.options, weights).starts();
        for turn in 0..effort {
            let mut random = Random::new(effort << 32 | turn);
            if is_done || *left == 0 {
                break;
            }
            let mut mesh = best.mesh().unwrap_or(&disc.mesh).clone();
            let trials = anneal(&mut mesh, weights, near, STEPS, &mut random);
            *left = left.saturating_sub(trials);
            settle_all(&mut mesh, weights);
            let worth = self.worth(&mesh);
            if best.offer(mesh, worth) {
                break;
            }
            // Single operations from there took most of the time at places, and brought nothing that these do not.
            if let Some(mut mesh) = starts.next(&mut stage)? {
                smooth_packed(&mut mesh, &mut Sweeper::new(), &mut stage)?;
                // The cost of packing, triangulating and smoothing, in trials.
                *left = left.saturating_sub(mesh.triangles.len() / 2);
                if effort >= MANY {
                    self.pairs(&mut mesh, effort / 2, left, &mut stage)?;
                }
                let all = mesh.vertices.len();
                let trials = anneal(&mut mesh, weights, all, STEPS_AFTERWARDS, &mut random);
                *left = left.saturating_sub(trials);
                settle_all(&mut mesh, weights);
                let worth = self.worth(&mesh);
                is_done = best.offer(mesh, worth);
            }
        }
        if !is_hasty && best.mesh().is_none() {
            self.mend_degrees(&disc.mesh, &mut best, effort, left);
        }
        Ok(best.found.map(|best| best.1))
    }

    /// Mends degrees by chains of operations.
    fn mend_degrees(&self, disc: &ArrayMesh, best: &mut Best, effort: u64, left: &mut usize) {
        let most = usize::try_from(effort).map_or(usize::MAX, |effort| CHAIN * effort);
        let (mut mesh, mut excess) = (disc.clone(), self.worth(disc).excess);
        while excess > 0 && *left > 0 {
            let mut least: Option<(Worth, ArrayMesh)> = None;
            for mut mesh in chains(&mesh, &self.weights, most, left) {
                settle_all(&mut mesh, &self.weights);
                let all = mesh.vertices.len();
                let (steps, mut random) = (STEPS_AFTERWARDS, Random::new(0));
                let trials = anneal(&mut mesh, &self.weights, all, steps, &mut random);
                *left = left.saturating_sub(trials);
                settle_all(&mut mesh, &self.weights);
                let worth = self.worth(&mesh);
                let is_better = |least: &(Worth, _)| worth.is_better(&least.0);
                if worth.excess < excess && least.as_ref().is_none_or(is_better) {
                    least = Some((worth, mesh));
                }
            }
            let Some((worth, better)) = least else { break };
            excess = worth.excess;
            mesh = better;
            best.offer(mesh.clone(), worth);
        }
    }

    /// A round of pairs of operations at so many vertices.
    fn pairs(
        &self,
        mesh: &mut ArrayMesh,
        vertices: u64,
        left: &mut usize,
        stage: &mut Stage<'_>,
    ) -> Result<(), Cancelled> {
        let vertices = usize::try_from(vertices).unwrap_or(usize::MAX);
        let mut pairs = Pairs { vertices, firsts: 2, trials: 0, most: *left };
        pairs_of_operations(mesh, &self.weights, &mut pairs, &mut Failed::new(), stage)?;
        *left = left.saturating_sub(pairs.trials);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::array_mesh::tests::grid;
    use mindeg_mesh::Progress;

    #[test]
    fn places_are_mended_beside_edges_that_stay() {
        let mut mesh = grid(7);
        let area = |mesh: &ArrayMesh| -> f64 {
            let alive = (0..).zip(&mesh.triangles).filter(|(_, t)| t.is_alive());
            alive.map(|(t, _)| crate::triangle::doubled_area(mesh.corners(t))).sum()
        };
        let goal = Goal {
            least: 1,
            triangles: 4,
            limit: 45.0,
            ..Weights::local(&Options::default(), 36.0).goal_inside()
        };
        mesh.goals.push(goal.aimed());
        for vertex in mesh.vertices.iter_mut().filter(|vertex| vertex.kind == Kind::Boundary) {
            vertex.goal = 0;
        }
        // A vertex beside the locked edge is pushed far off its middle.
        mesh.vertices[17].at.x += 0.9;
        let before = area(&mesh);
        let options = Options::default();
        let mut stage = Stage::new(Progress::NONE, "mending");
        mend_places(&mut mesh, &options, &Stars::default(), 36.0, 1.0, &mut stage).unwrap();
        mesh.check().unwrap();
        assert!((area(&mesh) - before).abs() < 1e-9);
        assert_eq!(mesh.locked_edges().len(), 2);
        let alive = (0..).zip(&mesh.triangles).filter(|(_, t)| t.is_alive());
        let least = alive.map(|(t, _)| crate::triangle::min_angle(mesh.corners(t)));
        assert!(least.fold(90.0, f64::min) > 30.0);
    }
}
