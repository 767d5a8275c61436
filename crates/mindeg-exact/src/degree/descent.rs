//! Takes edges off vertices above their limits, block by block, when windows are stuck: a block may cost other
//! vertices an excess that later blocks take away again.
//!
//! [`Breakout`] says how the descent leaves a hole.

use crate::breakout::Breakout;
use crate::patch::{Block, Cost, Patch};
use crate::problem::Problem;
use crate::progress::Stage;
use mindeg_mesh::{Cancelled, Random};

/// So many rounds without a smaller number of crowded vertices are waited for at least.
const PATIENCE: usize = 40;

/// Of the vertices that keep their limits, one in so many has a block in a round.
const SELDOM: u64 = 8;

/// The costs of vertices in a round.
struct Excess<'a> {
    most_chords: &'a [u32],
    weights: Breakout,
    noise: Vec<u32>,
}

impl Excess<'_> {
    fn of(&self, vertex: usize, chords: u32) -> u32 {
        chords.saturating_sub(self.most_chords[vertex])
    }
}

impl Cost for Excess<'_> {
    fn vertex(&self, vertex: u32, chords: u32) -> u32 {
        let vertex = vertex as usize;
        self.weights.cost(vertex, self.of(vertex, chords)) + self.noise[vertex] * chords
    }
}

/// A triangulation in which no vertex has more chords than `most_chords` says, if the descent from these triangles
/// meets one before many rounds pass without progress and within the steps that are left, off which it takes its own.
/// The same input has the same answer on every machine.
pub(super) fn descend(
    problem: &Problem,
    triangles: &[[u32; 3]],
    most_chords: &[u32],
    left: &mut u64,
    stage: &Stage<'_>,
) -> Result<Option<Vec<[u32; 3]>>, Cancelled> {
    let vertices = most_chords.len();
    let mut patch = Patch::of(problem, triangles);
    let (weights, noise) = (Breakout::new(vertices), vec![0; vertices]);
    let mut excess = Excess { most_chords, weights, noise };
    let mut random = Random::new(0);
    let (mut fewest, mut fewest_at) = (usize::MAX, 0);
    for round in 0.. {
        let is_crowded = |patch: &Patch<'_>, excess: &Excess<'_>, vertex: usize| {
            excess.of(vertex, patch.chords(vertex as u32)) > 0
        };
        let crowded = (0..vertices).filter(|&vertex| is_crowded(&patch, &excess, vertex)).count();
        if crowded == 0 {
            *left = left.saturating_sub(patch.steps());
            return Ok(Some(patch.triangles().to_vec()));
        }
        if crowded < fewest {
            (fewest, fewest_at) = (crowded, round);
        }
        // Longer than it took so far, and some rounds more.
        if patch.steps() >= *left || round > 2 * fewest_at + PATIENCE {
            break;
        }
        stage.report(patch.steps() as f64 / *left as f64)?;
        excess.noise.fill_with(|| Breakout::noise(random.bits()));
        for vertex in 0..vertices {
            let chance = random.bits();
            if is_crowded(&patch, &excess, vertex) || chance.is_multiple_of(SELDOM) {
                let (skip, size) =
                    ((chance >> 32) as u32, Breakout::SIZES[round % Breakout::SIZES.len()]);
                patch.improve(Block { vertex: vertex as u32, skip, size }, &excess);
            }
        }
        excess.weights.end_round(|vertex| patch.chords(vertex as u32) > most_chords[vertex]);
    }
    *left = left.saturating_sub(patch.steps());
    Ok(None)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;
    use mindeg_mesh::Progress;
    use mindeg_mesh::planar::PlanarBoundary;

    #[test]
    fn a_fan_becomes_a_strip_and_what_is_impossible_ends() {
        let at = |corner: u32| DVec2::from_angle(f64::from(corner) * std::f64::consts::TAU / 24.0);
        let points: Vec<DVec2> = (0..24).map(at).collect();
        let fan: Vec<[u32; 3]> = (1..23).map(|corner| [0, corner, corner + 1]).collect();
        let problem =
            Problem::triangulated(&PlanarBoundary::new(&[points]).unwrap(), &fan).unwrap();
        let stage = Stage::new(Progress::NONE, "testing");
        let reach = |most: u32, mut left: u64| {
            let found = descend(&problem, &fan, &[most; 24], &mut left, &stage).unwrap();
            (found, left)
        };
        let (found, left) = reach(2, 10_000_000);
        let found = found.unwrap();
        assert_eq!((found.len(), problem.max_degree_of(&found)), (22, 4));
        assert!(0 < left && left < 10_000_000);
        assert_eq!(reach(2, 10_000_000), (Some(found), left));
        assert_eq!(reach(1, 1000), (None, 0));
        let (none, left) = reach(1, u64::MAX);
        assert!(none.is_none() && u64::MAX - left < 100_000_000);
    }
}
