//! Degrees mended by drawing the discs round them anew: the triangulation first ([`bistellar`](crate::bistellar)), then the points.
//!
//! Trials keep all triangles proper and change few of them at a time. Where lines meet, edges of very different lengths leave them no room:
//! most ways to other degrees lead over triangles that are turned over.

use crate::ahead::Ahead;
use crate::anneal::settle_all;
use crate::array_mesh::{ArrayMesh, NONE};
use crate::bistellar::redrawn;
use crate::disc::{Disc, ENOUGH_TRIANGLES};
use crate::goal::Weights;
use crate::optimise::smooth_and_mend;
use crate::options::Options;
use crate::sketch::Effort;
use crate::smooth::{Power, Sweeper};
use crate::stage::Stage;
use crate::star::Stars;
use crate::together::Together;
use crate::triangle::min_angle;
use crate::verdict::enough;
use crate::worth::Worth;
use mindeg_mesh::{Cancelled, Random};
use std::collections::BTreeSet;

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

/// Where all else has failed, all rounds are made once and the later ones again with other seeds. From this one on larger discs are
/// drawn anew, in large meshes, but not where it is proven that no mesh is better: small ones are begun anew.
const HARD: u64 = 3;
/// The last seed.
const LAST: u64 = 12;
/// After so many seeds without a better disc no more are tried.
const FRUITLESS: u64 = 2;
/// No more moves are made in one turn, at any mesh and for each triangle: the search ends where degrees are out of their ranges nearly everywhere.
const MOST_MOVES: [u64; 2] = [20_000_000, 800];
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

/// The vertices above their limits of which it is proven that no mesh with such angles brings them nearer.
fn proven_together(mesh: &ArrayMesh, options: &Options, stars: &Stars) -> BTreeSet<u32> {
    // The sectors of vertices that are one are counted apart.
    if !options.joined.is_empty() {
        return BTreeSet::new();
    }
    let mut at = vec![NONE; mesh.goals.len()];
    let mut angles = vec![60.0_f64; mesh.goals.len()];
    for (t, triangle) in (0..).zip(&mesh.triangles).filter(|(_, triangle)| triangle.is_alive()) {
        let angle = min_angle(mesh.corners(t));
        for v in triangle.vertices {
            let goal = mesh.vertices[v as usize].goal as usize;
            if let Some(least) = angles.get_mut(goal) {
                (*least, at[goal]) = (least.min(angle), v);
            }
        }
    }
    let count = |v: &u32| mesh.vertices.get(*v as usize).map_or(0, |vertex| vertex.triangles);
    let counts: Vec<u32> = at.iter().map(count).collect();
    let limits: Vec<u32> = mesh.goals.iter().map(|goal| goal.triangles).collect();
    let groups = Together::new(stars, &angles, &counts, &limits).groups();
    groups.into_iter().flat_map(|(group, _)| group).map(|goal| at[goal as usize]).collect()
}

/// Draws the discs round all vertices anew whose degrees are out of their ranges, until none is left or all rounds are over.
pub(crate) fn redraw(
    mesh: &mut ArrayMesh,
    weights: &Weights,
    options: &Options,
    stars: &Stars,
    turn: Turn,
    stage: &mut Stage<'_>,
) -> Result<(), Cancelled> {
    let (single, enough) = (Weights::single(options, weights.floor), enough(options));
    let seeds = match turn {
        Turn::First => 0..=0,
        Turn::Last if mesh.triangles.len() < LARGE => 1..=HARD - 1,
        Turn::Last => 1..=LAST,
    };
    let mut left = MOST_MOVES[0] + MOST_MOVES[1] * mesh.triangles.len() as u64;
    let mut proven = (0, BTreeSet::new());
    let mut last_success = HARD;
    let rounds = |seed: u64| {
        ROUNDS
            .iter()
            .enumerate()
            .skip(if seed > 1 { LATER } else { 0 })
            .map(move |round| (seed, round))
    };
    for (seed, (index, Round { rings, effort, kept })) in seeds.flat_map(rounds) {
        let is_hard = seed >= HARD;
        let (most, times) =
            if is_hard { (2 * ENOUGH_TRIANGLES, HARD_MOVES) } else { (ENOUGH_TRIANGLES, 1) };
        let effort = Effort { moves: times * effort.moves, ..*effort };
        if is_hard && proven.0 != seed {
            proven = (seed, proven_together(mesh, options, stars));
        }
        let wrong: Vec<u32> =
            broken(mesh, weights).filter(|vertex| !proven.1.contains(vertex)).collect();
        let is_hopeless = wrong.len() > MOST_HARD || seed > last_success + FRUITLESS;
        if wrong.is_empty() || is_hard && is_hopeless {
            break;
        }
        let within = stage.within();
        let draw = |disc: &Disc| {
            let before = Worth::of(&disc.mesh, weights, enough);
            let mut random = Random::new(seed << 32 | index as u64);
            let (found, moves) = redrawn(&disc.mesh, weights, effort, &mut random);
            let Some(mut found) = found else { return Ok((None, moves)) };
            let mut stage = within.clone();
            if turn == Turn::First && index < HASTY {
                Sweeper::new().run(&mut found, Power::Two, 5, &mut stage)?;
                Sweeper::new().run(&mut found, Power::Four, 5, &mut stage)?;
            } else {
                smooth_and_mend(&mut found, &single, None, &mut Sweeper::new(), &mut stage)?;
            }
            settle_all(&mut found, weights);
            let after = Worth::of(&found, weights, enough);
            let keeps = after.excess < before.excess && after.least() >= kept.min(before.least());
            Ok(((keeps && found.check().is_ok()).then_some(found), moves))
        };
        let mut ahead = Ahead::new();
        for at in 0..wrong.len() {
            if turn == Turn::First {
                // All rounds take about as long.
                let rounds = index as f64 + at as f64 / wrong.len() as f64;
                stage.reach(rounds / ROUNDS.len() as f64)?;
            }
            stage.still()?;
            if left == 0 {
                return Ok(());
            }
            let cut = |vertex: u32| {
                let is_left = is_broken(mesh, weights, vertex);
                is_left.then(|| Disc::cut(mesh, weights, vertex, *rings, most)).flatten()
            };
            let Some((disc, drawn)) = ahead.turn(&wrong[at..], cut, &draw) else { continue };
            let (found, moves) = drawn?;
            left = left.saturating_sub(moves);
            if let Some(found) = found {
                last_success = seed;
                ahead.forget(&disc);
                disc.put_back(mesh, &found);
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::array_mesh::tests::grid;
    use crate::array_mesh::{Kind, Vertex};
    use crate::breaklines::Breaklines;
    use crate::filling::Filling;
    use crate::goal::Goal;
    use glam::DVec2;
    use mindeg_mesh::Progress;
    use mindeg_mesh::planar::PlanarBoundary;

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
            redraw(&mut mesh, &weights, &options, &Stars::default(), turn, &mut stage).unwrap();
            assert_eq!(broken(&mesh, &weights).count(), 0, "{turn:?}");
            mesh.check().unwrap();
            assert_eq!(mesh.locked_edges().len(), 2);
        }
    }

    /// Eight triangles round a point where four lines meet, which may have seven: in front of corners that turn inwards each sector has two.
    #[test]
    fn vertices_that_no_mesh_brings_nearer_to_their_limits_are_known() {
        let weights = Weights::local(&Options::default(), 36.0);
        for (inner, is_proven) in [(0.4, true), (1.0, false)] {
            let turned = |p: DVec2| [p, p.perp(), -p, -p.perp()];
            let (tips, sides) = (turned(DVec2::X), turned(DVec2::splat(inner)));
            let ring: Vec<DVec2> =
                (0..8).map(|i| if i % 2 == 0 { tips[i / 2] } else { sides[i / 2] }).collect();
            let lines = Breaklines {
                points: vec![DVec2::ZERO],
                edges: (0..4).map(|i| [2 * i, 8]).collect(),
            };
            let vertex = |(at, goal): (&DVec2, u32)| Vertex {
                at: *at,
                size: 1.0,
                anchor: NONE,
                goal,
                triangles: 0,
                kind: if goal < 8 { Kind::Boundary } else { Kind::Fixed },
            };
            let vertices = ring.iter().chain(&lines.points).zip(0..).map(vertex).collect();
            let triangles: Vec<[u32; 3]> = (0..8).map(|i| [8, i, (i + 1) % 8]).collect();
            let goal = |v| Goal { triangles: if v < 8 { 4 } else { 7 }, ..weights.goal_inside() };
            let goals = (0..9).map(goal).collect();
            let mesh = ArrayMesh::new(vertices, &triangles, goals, &lines.edges).unwrap();
            let stars = Stars::new(&PlanarBoundary::new(&[ring]).unwrap(), &lines);
            let found = proven_together(&mesh, &Options::default(), &stars);
            assert_eq!(found, if is_proven { BTreeSet::from([8]) } else { BTreeSet::new() });
        }
    }
}
