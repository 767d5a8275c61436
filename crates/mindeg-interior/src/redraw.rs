//! Degrees mended by drawing the discs round them anew: the triangulation first ([`bistellar`](crate::bistellar)), then the points.
//!
//! Trials keep all triangles proper and change few of them at a time. Where lines meet, edges of very different lengths leave them no room:
//! most ways to other degrees lead over triangles that are turned over.

use crate::anneal::settle_all;
use crate::array_mesh::ArrayMesh;
use crate::bistellar::redrawn;
use crate::disc::{Disc, ENOUGH_TRIANGLES};
use crate::goal::Weights;
use crate::optimise::smooth_and_mend;
use crate::options::Options;
use crate::sketch::Effort;
use crate::smooth::{Power, Sweeper};
use crate::stage::Stage;
use crate::verdict::enough;
use crate::worth::Worth;
use mindeg_mesh::{Cancelled, Random};

/// One pass over all places: the rings of a disc, the effort, and the share of a local limit that no triangle may lose.
struct Round {
    rings: usize,
    effort: Effort,
    kept: f64,
}

const fn round(rings: usize, moves: u32, shape: f64, vertex: f64, kept: f64) -> Round {
    Round { rings, effort: Effort { moves, shape, vertex }, kept }
}

/// Later ones try more at fewer places, with fewer vertices and less regard to shapes.
const ROUNDS: [Round; 9] = [
    round(2, 60, 3.0, 2.0, 0.3),
    round(3, 60, 2.0, 8.0, 0.2),
    round(4, 100, 2.0, 8.0, 0.2),
    round(5, 200, 1.0, 8.0, 0.1),
    round(6, 300, 1.0, 8.0, 0.1),
    round(7, 300, 1.0, 8.0, 0.1),
    round(6, 600, 0.5, 8.0, 0.05),
    round(9, 600, 0.5, 8.0, 0.05),
    round(7, 1000, 0.5, 8.0, 0.02),
];

/// When discs are drawn anew: before anything else is tried where degrees are wrong at very many vertices, or where all else has failed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Turn {
    First,
    Last,
}

/// Where all else has failed, all rounds are made once and the later ones again with other seeds. With this one larger discs are
/// drawn anew, in large meshes: small ones are begun anew.
const HARD: u64 = 3;
/// So many times as many moves are made in those.
const HARD_MOVES: u32 = 3;
/// From so many triangles on a mesh is large.
const LARGE: usize = 10_000;
/// With more places than this left, larger discs would take too long.
const MOST_HARD: usize = 30;
/// The first round of those.
const LATER: usize = 4;
/// In so many first rounds, which have the most places, triangles are smoothed and no more.
const HASTY: usize = 3;

/// The vertices whose degrees are out of their ranges.
pub(crate) fn broken(mesh: &ArrayMesh, weights: &Weights) -> impl Iterator<Item = u32> {
    (0..mesh.vertices.len() as u32).filter(|v| is_broken(mesh, weights, *v))
}

fn is_broken(mesh: &ArrayMesh, weights: &Weights, vertex: u32) -> bool {
    mesh.vertices[vertex as usize].triangles > 0 && weights.excess(mesh, vertex) > 0
}

/// Draws the discs round all vertices anew whose degrees are out of their ranges, until none is left or all rounds are over.
pub(crate) fn redraw(
    mesh: &mut ArrayMesh,
    weights: &Weights,
    options: &Options,
    turn: Turn,
    stage: &mut Stage<'_>,
) -> Result<(), Cancelled> {
    let (single, enough) = (Weights::single(options, weights.floor), enough(options));
    let seeds = match turn {
        Turn::First => 0..=0,
        Turn::Last if mesh.triangles.len() < LARGE => 1..=HARD - 1,
        Turn::Last => 1..=HARD,
    };
    let rounds = |seed: u64| {
        ROUNDS
            .iter()
            .enumerate()
            .skip(if seed > 1 { LATER } else { 0 })
            .map(move |round| (seed, round))
    };
    for (seed, (index, Round { rings, effort, kept })) in seeds.flat_map(rounds) {
        let is_hard = seed == HARD;
        let (most, times) =
            if is_hard { (2 * ENOUGH_TRIANGLES, HARD_MOVES) } else { (ENOUGH_TRIANGLES, 1) };
        let effort = Effort { moves: times * effort.moves, ..*effort };
        let wrong: Vec<u32> = broken(mesh, weights).collect();
        if is_hard && wrong.len() > MOST_HARD {
            break;
        }
        for vertex in wrong {
            stage.still()?;
            if !is_broken(mesh, weights, vertex) {
                continue;
            }
            let Some(disc) = Disc::cut(mesh, weights, vertex, *rings, most) else { continue };
            let before = Worth::of(&disc.mesh, weights, enough);
            let mut random = Random::new(seed << 32 | index as u64);
            let Some(mut found) = redrawn(&disc.mesh, weights, effort, &mut random) else {
                continue;
            };
            let mut stage = stage.within();
            if turn == Turn::First && index < HASTY {
                Sweeper::new().run(&mut found, Power::Two, 5, &mut stage)?;
                Sweeper::new().run(&mut found, Power::Four, 5, &mut stage)?;
            } else {
                smooth_and_mend(&mut found, &single, None, &mut Sweeper::new(), &mut stage)?;
            }
            settle_all(&mut found, weights);
            let after = Worth::of(&found, weights, enough);
            let keeps = after.excess < before.excess && after.least() >= kept.min(before.least());
            if keeps && found.check().is_ok() {
                disc.put_back(mesh, &found);
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::array_mesh::Kind;
    use crate::array_mesh::tests::grid;
    use crate::filling::Filling;
    use crate::goal::Goal;
    use mindeg_mesh::Progress;

    #[test]
    fn degrees_are_mended_and_what_stays_stays() {
        let options = Options::default();
        let weights = Weights { interior: 6..=6, ..Weights::local(&options, 36.0) };
        for turn in [Turn::First, Turn::Last] {
            let mut mesh = grid(8);
            mesh.goals.push(Goal { least: 1, triangles: 5, ..weights.goal_inside() });
            for vertex in mesh.vertices.iter_mut().filter(|v| v.kind == Kind::Boundary) {
                vertex.goal = 0;
            }
            // The flip of an edge breaks four degrees.
            let cell = 2 * (4 * 8 + 4) as u32;
            let mut filling = Filling::default();
            [[40, 41, 49], [41, 50, 49]].into_iter().for_each(|t| filling.push(t, ()));
            mesh.replace(&[cell, cell + 1], &filling);
            assert_eq!(broken(&mesh, &weights).count(), 4);
            let mut stage = Stage::new(Progress::NONE, "redrawing");
            redraw(&mut mesh, &weights, &options, turn, &mut stage).unwrap();
            assert_eq!(broken(&mesh, &weights).count(), 0, "{turn:?}");
            mesh.check().unwrap();
            assert_eq!(mesh.locked_edges().len(), 2);
        }
    }
}
