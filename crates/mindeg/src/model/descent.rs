//! Block descent: one face after another gets the triangulation that is best beside the others.
//!
//! A vertex with more edges than the degree D that is aimed at costs what [`Breakout`] says; each chord costs a little
//! noise.

use mindeg_exact::measure::min_angle_tangent;
use mindeg_exact::{Block, Breakout, Cost, Patch};
use mindeg_mesh::{Cancelled, Progress, Random};

use super::colors::classes;
use super::face::PlaneFace;
use super::flips;
use super::joint::Joint;
use mindeg_mesh::parallel::map_all;

/// Steps of the dynamic program that one degree may take, by default: some seconds on one core.
pub(super) const LEVEL_STEPS: u64 = 1 << 28;

/// In large models each degree may take as many steps a vertex.
pub(super) const STEPS_PER_VERTEX: u64 = 1000;

/// The cost of the setup of a face, in steps per vertex.
const SETUP_STEPS: u64 = 200;

/// A face of at most this many triangles without holes is one block.
const WHOLE: usize = 64;

/// With at most this many vertices, every face is a block in every round; else only those with a
/// crowded vertex, as windows.
const SMALL: usize = 2000;

pub(super) struct Descent<'j> {
    joint: &'j mut Joint,
    classes: Vec<Vec<usize>>,
    progress: Progress<'j>,
}

/// The costs of one face in one round.
struct FaceCost<'a> {
    face: &'a PlaneFace,
    /// For each place the edges of its vertex outside the face's chords.
    others: Vec<u32>,
    weights: &'a Breakout,
    noise: Vec<u32>,
    degree: u32,
    threshold: f64,
}

impl Cost for FaceCost<'_> {
    fn vertex(&self, place: u32, chords: u32) -> u32 {
        let place = place as usize;
        let excess = (self.others[place] + chords).saturating_sub(self.degree);
        let vertex = self.face.vertices[place] as usize;
        self.weights.cost(vertex, excess) + self.noise[place] * chords
    }

    fn triangle(&self, corners: [glam::DVec2; 3]) -> Option<u32> {
        let is_allowed = self.threshold <= 0.0 || min_angle_tangent(corners) >= self.threshold;
        is_allowed.then_some(0)
    }
}

impl<'j> Descent<'j> {
    pub(super) fn new(joint: &'j mut Joint, progress: Progress<'j>) -> Self {
        let classes = classes(joint);
        Self { joint, classes, progress }
    }

    pub(super) fn joint(&self) -> &Joint {
        self.joint
    }

    pub(super) fn joint_mut(&mut self) -> &mut Joint {
        self.joint
    }

    /// Aims at a degree: whether no vertex has more edges at the end. If that fails, the result is
    /// the best there was.
    pub(super) fn reach(&mut self, degree: u32, most_steps: u64) -> Result<bool, Cancelled> {
        let before = self.joint.max_degree();
        if before <= degree {
            return Ok(true);
        }
        let mut best = (before, self.joint.triangles.clone(), self.joint.totals.clone());
        let mut weights = Breakout::new(self.joint.totals.len());
        let mut steps = 0;
        let mut round = 0;
        let stage = format!("looking for degree {degree}");
        while steps < most_steps {
            self.progress.report(&stage, steps, most_steps)?;
            let is_crowded: Vec<bool> =
                self.joint.totals.iter().map(|&total| total > degree).collect();
            if !is_crowded.contains(&true) {
                return Ok(true);
            }
            steps += 1 + self.round(degree, round, &weights, &is_crowded);
            weights.end_round(|vertex| self.joint.totals[vertex] > degree);
            let reached = self.joint.max_degree();
            if reached < best.0 {
                best = (reached, self.joint.triangles.clone(), self.joint.totals.clone());
            }
            round += 1;
        }
        (_, self.joint.triangles, self.joint.totals) = best;
        Ok(self.joint.max_degree() <= degree)
    }

    /// One round over the faces, class by class. Returns the steps of work.
    fn round(&mut self, degree: u32, round: u64, weights: &Breakout, is_crowded: &[bool]) -> u64 {
        let is_small = is_crowded.len() <= SMALL;
        let mut order: Vec<usize> = (0..self.classes.len()).collect();
        order.sort_by_key(|&class| Random::at(&[degree.into(), round, class as u64]));
        let mut steps = 0;
        for class in order {
            let joint = &*self.joint;
            let solve = |face: usize| {
                let is_active =
                    is_small || joint.face(face).vertices.iter().any(|&v| is_crowded[v as usize]);
                if is_active {
                    improved(joint, face, degree, round, weights, is_small)
                } else {
                    None
                }
            };
            let found = map_all(self.classes[class].clone(), solve);
            let faces = self.classes[class].clone();
            for (face, found) in faces.into_iter().zip(found) {
                if let Some((triangles, own_steps)) = found {
                    steps += own_steps;
                    if let Some(triangles) = triangles {
                        self.joint.replace(face, triangles);
                    }
                }
            }
        }
        steps
    }
}

/// The triangles of a face after a round, if they changed, and the steps of work.
fn improved(
    joint: &Joint,
    face: usize,
    degree: u32,
    round: u64,
    weights: &Breakout,
    is_small: bool,
) -> Option<(Option<Vec<[u32; 3]>>, u64)> {
    let plane_face = joint.face(face);
    let places = plane_face.vertices.len();
    let total = |place: usize| joint.totals[plane_face.vertices[place] as usize];
    let chords = plane_face.chords(&joint.triangles[face]);
    let others = (0..places).map(|place| total(place) - chords[place]).collect();
    let noise = |place| {
        let random = Random::at(&[degree.into(), round, face as u64, place as u64]);
        if is_small { Breakout::noise(random) } else { 0 }
    };
    let cost = FaceCost {
        face: plane_face,
        others,
        weights,
        noise: (0..places).map(noise).collect(),
        degree,
        threshold: joint.thresholds[face],
    };
    let Some(problem) = plane_face.problem(&joint.triangles[face]) else {
        let (triangles, steps) =
            flips::improved(plane_face, &joint.triangles[face], chords, &cost, |place, chords| {
                cost.others[place as usize] + chords > degree
            });
        return Some((triangles, SETUP_STEPS * places as u64 + steps));
    };
    let mut patch = Patch::new(&problem);
    let is_crowded =
        |patch: &Patch<'_>, place: usize| cost.others[place] + patch.chords(place as u32) > degree;
    let mut changed = false;
    let is_whole =
        is_small && plane_face.boundary.ring_count() == 1 && joint.triangles[face].len() <= WHOLE;
    let sizes = Breakout::SIZES;
    if is_whole {
        changed = patch.improve(Block { vertex: 0, skip: 0, size: WHOLE }, &cost);
    } else {
        for place in 0..places {
            let random = Random::at(&[round, face as u64, place as u64, 1]);
            let is_tried = is_crowded(&patch, place) || (is_small && random.is_multiple_of(8));
            if is_tried {
                let size = sizes[usize::try_from(round % sizes.len() as u64).expect("an index")];
                let block = Block { vertex: place as u32, skip: (random >> 32) as u32, size };
                changed |= patch.improve(block, &cost);
            }
        }
    }
    let steps = SETUP_STEPS * places as u64 + patch.steps();
    Some((changed.then(|| patch.triangles().to_vec()), steps))
}
