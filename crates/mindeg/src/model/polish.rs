//! Better angles at the degree that was reached.
//!
//! Each face gets the triangulation with the least sum of the cotangents of minimum angles, which
//! the worst triangles decide, among those in which no vertex has more edges than the maximum.

use std::collections::BTreeSet;

use glam::DVec2;
use mindeg_exact::measure::min_angle_tangent;
use mindeg_exact::{Block, Cost, Patch};
use mindeg_mesh::{Cancelled, Progress};

use super::colors::classes;
use super::joint::Joint;
use mindeg_mesh::parallel::map_all;

/// How often every face is improved.
const ROUNDS: u64 = 2;

/// With more vertices, windows around the worst triangles alone.
const SMALL: usize = 2000;

/// The triangles of a block.
const SMALL_BLOCK: usize = 64;
const LARGE_BLOCK: usize = 12;

/// The cost of a vertex above the limit, more than that of all triangles.
const TOO_MANY: u32 = 1 << 27;

/// The largest cost of a triangle, and the unit of cotangents.
const MOST: f64 = 65_536.0;
const UNIT: f64 = 16.0;

struct Angles {
    /// For each place the most chords.
    most: Vec<u32>,
    threshold: f64,
}

impl Cost for Angles {
    fn vertex(&self, place: u32, chords: u32) -> u32 {
        if chords > self.most[place as usize] { TOO_MANY } else { 0 }
    }

    fn triangle(&self, corners: [DVec2; 3]) -> Option<u32> {
        let tangent = min_angle_tangent(corners);
        let is_allowed = self.threshold <= 0.0 || tangent >= self.threshold;
        is_allowed.then(|| (UNIT / tangent).min(MOST) as u32)
    }
}

pub(super) fn polish(joint: &mut Joint, progress: Progress<'_>) -> Result<(), Cancelled> {
    let degree = joint.max_degree();
    let classes = classes(joint);
    let total = ROUNDS * classes.len() as u64;
    for round in 0..ROUNDS {
        for (index, class) in (0..).zip(&classes) {
            progress.report("improving angles", round * classes.len() as u64 + index, total)?;
            let found = map_all(class.to_vec(), |face| improved(joint, face, degree));
            for (&face, found) in class.iter().zip(found) {
                if let Some(triangles) = found {
                    joint.replace(face, triangles);
                }
            }
        }
    }
    Ok(())
}

fn improved(joint: &Joint, face: usize, degree: u32) -> Option<Vec<[u32; 3]>> {
    let plane_face = joint.face(face);
    let problem = plane_face.problem(&joint.triangles[face])?;
    let mut patch = Patch::new(&problem);
    // Of places that are one vertex, the first may take what the vertex has left.
    let mut seen = BTreeSet::new();
    let most = |(place, &vertex): (u32, &u32)| match seen.insert(vertex) {
        true => (degree + patch.chords(place)).saturating_sub(joint.totals[vertex as usize]),
        false => patch.chords(place),
    };
    let most = (0..).zip(&plane_face.vertices).map(most).collect();
    let cost = Angles { most, threshold: joint.thresholds[face] };
    let is_small = joint.totals.len() <= SMALL;
    if is_small && plane_face.boundary.ring_count() == 1 && patch.triangles().len() <= SMALL_BLOCK {
        let is_changed = patch.improve(Block { vertex: 0, skip: 0, size: SMALL_BLOCK }, &cost);
        return is_changed.then(|| patch.triangles().to_vec());
    }
    let tangent = |triangle: &[u32; 3]| {
        min_angle_tangent(triangle.map(|place| plane_face.boundary.point(place)))
    };
    let mut is_changed = false;
    let tries = if is_small { 8 } else { 1 };
    for _ in 0..tries {
        let worst = patch.triangles().iter().min_by(|a, b| tangent(a).total_cmp(&tangent(b)))?;
        let size = if is_small { SMALL_BLOCK } else { LARGE_BLOCK };
        let block = Block { vertex: worst[0], skip: 0, size };
        if !patch.improve(block, &cost) {
            break;
        }
        is_changed = true;
    }
    is_changed.then(|| patch.triangles().to_vec())
}

#[cfg(test)]
mod tests {
    use super::super::descent::Descent;
    use super::super::of_model;
    use super::*;
    use glam::DVec3;
    use mindeg_domain::{Model, ModelFace, ModelParts, Side};

    #[test]
    fn angles_get_better_at_the_same_degree() {
        let corner = |i: u32| {
            DVec3::new(4.0 * f64::from(i & 1), 2.0 * f64::from(i >> 1 & 1), f64::from(i >> 2))
        };
        let quads =
            [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let model = Model::new(ModelParts {
            corners: (0..8).map(corner).collect(),
            faces: quads
                .map(|quad: [u32; 4]| ModelFace {
                    loops: vec![quad.to_vec()],
                    ..ModelFace::default()
                })
                .to_vec(),
            edges: vec![],
            other_edges: Some(Side::size(0.5)),
            planar_tolerance: None,
        })
        .unwrap();
        let mut joint = of_model(&model, &model.positions(), None, Progress::NONE).unwrap();
        assert!(Descent::new(&mut joint, Progress::NONE).reach(7, 100_000).unwrap());
        let costs = |joint: &Joint| -> Vec<f64> {
            let cost = |face: usize| {
                let points = joint.face(face).boundary.points();
                let of = |triangle: &[u32; 3]| {
                    1.0 / min_angle_tangent(triangle.map(|place| points[place as usize]))
                };
                joint.triangles[face].iter().map(of).sum()
            };
            (0..model.face_count()).map(cost).collect()
        };
        let before = costs(&joint);
        polish(&mut joint, Progress::NONE).unwrap();
        assert!(joint.max_degree() <= 7);
        let after = costs(&joint);
        assert!(
            after.iter().sum::<f64>() < 0.9 * before.iter().sum::<f64>(),
            "{before:?} {after:?}"
        );
    }
}
