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
struct Excess {
    most_chords: Vec<u32>,
    weights: Breakout,
    noise: Vec<u32>,
}

impl Excess {
    fn of(&self, vertex: usize, chords: u32) -> u32 {
        chords.saturating_sub(self.most_chords[vertex])
    }
}

impl Cost for Excess {
    fn vertex(&self, vertex: u32, chords: u32) -> u32 {
        let vertex = vertex as usize;
        self.weights.cost(vertex, self.of(vertex, chords)) + self.noise[vertex] * chords
    }
}

/// A descent that can go on where it has stopped. The same input has the same answer on every machine.
pub(super) struct Descent<'a> {
    patch: Patch<'a>,
    excess: Excess,
    random: Random,
    round: usize,
    /// The smallest number of crowded vertices, and its round.
    fewest: usize,
    fewest_at: usize,
}

impl<'a> Descent<'a> {
    /// A descent from these triangles to some in which no vertex has more chords than `most_chords` says.
    pub(super) fn new(problem: &'a Problem, triangles: &[[u32; 3]], most_chords: Vec<u32>) -> Self {
        let vertices = most_chords.len();
        let (weights, noise) = (Breakout::new(vertices), vec![0; vertices]);
        Self {
            patch: Patch::of(problem, triangles),
            excess: Excess { most_chords, weights, noise },
            random: Random::new(0),
            round: 0,
            fewest: usize::MAX,
            fewest_at: 0,
        }
    }

    /// The triangles, if the descent meets them within the steps that are left, off which it takes its own, and before
    /// many rounds pass without progress: from then on it takes no more steps.
    pub(super) fn go_on(
        &mut self,
        left: &mut u64,
        stage: &Stage<'_>,
    ) -> Result<Option<Vec<[u32; 3]>>, Cancelled> {
        let before = self.patch.steps();
        let most = before.saturating_add(*left);
        let found = loop {
            let crowded = (0..self.excess.most_chords.len()).filter(|&it| self.is_crowded(it));
            let crowded = crowded.count();
            if crowded == 0 {
                break Some(self.patch.triangles().to_vec());
            }
            if crowded < self.fewest {
                (self.fewest, self.fewest_at) = (crowded, self.round);
            }
            // Longer than it took so far, and some rounds more.
            let is_stuck = self.round > 2 * self.fewest_at + PATIENCE;
            if is_stuck || self.patch.steps() >= most {
                break None;
            }
            stage.report((self.patch.steps() - before) as f64 / *left as f64)?;
            self.round();
        };
        *left = left.saturating_sub(self.patch.steps() - before);
        Ok(found)
    }

    fn is_crowded(&self, vertex: usize) -> bool {
        self.excess.of(vertex, self.patch.chords(vertex as u32)) > 0
    }

    fn round(&mut self) {
        let random = &mut self.random;
        self.excess.noise.fill_with(|| Breakout::noise(random.bits()));
        for vertex in 0..self.excess.most_chords.len() {
            let chance = self.random.bits();
            if self.is_crowded(vertex) || chance.is_multiple_of(SELDOM) {
                let (skip, size) =
                    ((chance >> 32) as u32, Breakout::SIZES[self.round % Breakout::SIZES.len()]);
                self.patch.improve(Block { vertex: vertex as u32, skip, size }, &self.excess);
            }
        }
        let Self { patch, excess: Excess { most_chords, weights, .. }, .. } = self;
        weights.end_round(|vertex| patch.chords(vertex as u32) > most_chords[vertex]);
        self.round += 1;
    }
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
            let mut descent = Descent::new(&problem, &fan, vec![most; 24]);
            let found = descent.go_on(&mut left, &stage).unwrap();
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
