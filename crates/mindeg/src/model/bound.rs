//! How small the maximum degree of a model can be.
//!
//! *Sum.* However the faces are triangulated, the mesh has the same number of edges: the intervals
//! of the model, and n + 3h - 3 chords in a face of n vertices and h holes. The largest degree is at
//! least the average one.
//!
//! *Side.* On a straight side of a intervals, a - 2 boundary edges are no side of an ear, and each
//! has an apex elsewhere on the face. A vertex with c chords in the face is apex to at most c - 1 of
//! them; with m edges of the model and degree D it has at most D - m chords.
//!
//! *Weights.* The average of degrees, weighted, is at most the largest degree. For any weights, each
//! face has a triangulation whose chords weigh least, by a dynamic program. Multiplicative weights
//! look for good ones; the arithmetic is exact.

use mindeg_exact::LeastWeight;
use mindeg_mesh::{Cancelled, Progress};

use super::joint::Joint;
use crate::parallel::map_indices;

/// The most triples of vertices, over all faces, for which weights are looked for.
const MOST_TRIPLES: u64 = 4_000_000;

/// How often the weights change.
const ROUNDS: u32 = 250;

/// The largest weight.
const UNIT: f64 = 1_048_576.0;

/// Why no mesh of a model has a smaller maximum degree.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum JointBound {
    /// The sum of the degrees, divided by the number of vertices and rounded up.
    Sum {
        /// The sum.
        sum: u64,
        /// The vertices.
        vertices: u32,
    },
    /// The edges of the model at one vertex.
    Edges {
        /// The vertex.
        vertex: u32,
        /// Its edges of the model.
        edges: u32,
    },
    /// A side of one face with too many intervals for the other vertices of the face.
    Side {
        /// The face.
        face: u32,
        /// The intervals of the side.
        intervals: u32,
        /// The least maximum degree.
        max_degree: u32,
    },
    /// The weighted sum of the degrees, divided by the sum of the weights and rounded up.
    Weights {
        /// The weight of each vertex.
        weights: Vec<u64>,
        /// The weighted sum of the degrees is at least this.
        sum: u128,
    },
}

impl JointBound {
    /// The maximum degree that this proves to be necessary.
    #[must_use]
    pub fn max_degree(&self) -> u32 {
        match self {
            Self::Sum { sum, vertices } => sum.div_ceil(u64::from(*vertices).max(1)) as u32,
            Self::Edges { edges, .. } => *edges,
            Self::Side { max_degree, .. } => *max_degree,
            Self::Weights { weights, sum } => {
                let total: u128 = weights.iter().map(|&weight| u128::from(weight)).sum();
                sum.div_ceil(total.max(1)) as u32
            }
        }
    }
}

/// The best of the bounds that take near-linear time.
pub(super) fn cheap(joint: &Joint<'_>) -> JointBound {
    let sum = joint.totals.iter().map(|&total| u64::from(total)).sum();
    let mut best = JointBound::Sum { sum, vertices: joint.totals.len() as u32 };
    let most_edges = joint
        .edge_degrees
        .iter()
        .enumerate()
        .max_by_key(|&(v, &edges)| (edges, std::cmp::Reverse(v)));
    if let Some((vertex, &edges)) = most_edges
        && edges > best.max_degree()
    {
        best = JointBound::Edges { vertex: vertex as u32, edges };
    }
    for face in 0..joint.model.face_count() {
        if let Some((max_degree, intervals)) = side_bound(joint, face, best.max_degree()) {
            best = JointBound::Side { face: face as u32, intervals, max_degree };
        }
    }
    best
}

/// The bound of the best side of a face, if it is above `above`, and the intervals of that side.
fn side_bound(joint: &Joint<'_>, face: usize, above: u32) -> Option<(u32, u32)> {
    let places = joint.model.face_size(face);
    // A side has at most all but one of the intervals; without many, no bound is above.
    if places < above {
        return None;
    }
    let plane_face = joint.face(face);
    let edges = |place: usize| joint.edge_degrees[plane_face.vertices[place] as usize];
    let n = plane_face.vertices.len();
    let run_count = plane_face.runs.iter().max().map_or(0, |&run| run as usize + 1);
    let apexes = |degree: u32, run: u32| -> u64 {
        let capacity = |place: usize| u64::from(degree.saturating_sub(edges(place) + 1));
        let ring =
            plane_face.rings.iter().find(|ring| ring.contains(&first_of(&plane_face.runs, run)));
        let before = |place: usize| {
            let ring = ring.cloned().unwrap_or(0..n as u32);
            if ring.contains(&(place as u32)) && place as u32 == ring.start {
                ring.end as usize - 1
            } else {
                place.saturating_sub(1)
            }
        };
        let is_on =
            |place: usize| plane_face.runs[place] == run || plane_face.runs[before(place)] == run;
        (0..n).filter(|&place| !is_on(place)).map(capacity).sum()
    };
    let mut best: Option<(u32, u32)> = None;
    for run in 0..run_count as u32 {
        let intervals = plane_face.runs.iter().filter(|&&other| other == run).count() as u64;
        let mut degree = best.map_or(above, |(degree, _)| degree);
        if intervals < 3 || apexes(degree, run) >= intervals - 2 {
            continue;
        }
        while apexes(degree, run) < intervals - 2
            && u64::from(degree) < intervals + u64::from(above) + 3
        {
            degree += 1;
        }
        best = Some((degree, intervals as u32));
    }
    best
}

fn first_of(runs: &[u32], run: u32) -> u32 {
    runs.iter().position(|&other| other == run).unwrap_or(0) as u32
}

/// The best of a bound and of weights, for models that are not too large.
pub(super) fn with_weights(
    joint: &Joint<'_>,
    bound: JointBound,
    progress: Progress<'_>,
) -> Result<JointBound, Cancelled> {
    let faces: Vec<usize> = (0..joint.model.face_count()).collect();
    // About n³/6 triples in a convex face.
    let triples = |&face: &usize| u64::from(joint.model.face_size(face)).pow(3) / 6;
    if faces.iter().map(triples).fold(0, u64::saturating_add) > MOST_TRIPLES {
        return Ok(bound);
    }
    let solvers = map_indices(&faces, |face| {
        let plane_face = joint.face(face);
        let problem = plane_face.problem(&joint.triangles[face]).ok()?;
        let least = LeastWeight::new(&problem, joint.thresholds[face]).ok();
        Some((least, plane_face.vertices))
    });
    let mut weights = vec![1.0; joint.totals.len()];
    let mut best = bound;
    for round in 0..ROUNDS {
        progress.report("proving a bound", round.into(), ROUNDS.into())?;
        let largest = weights.iter().copied().fold(0.0, f64::max);
        let whole: Vec<u64> =
            weights.iter().map(|weight| (weight / largest * UNIT + 0.5) as u64).collect();
        let found = map_indices(&faces, |face| {
            let (solver, vertices) = solvers[face].as_ref()?;
            let own: Vec<u64> = vertices.iter().map(|&vertex| whole[vertex as usize]).collect();
            solver.as_ref()?.of(&own)
        });
        let of_edges = whole.iter().zip(&joint.edge_degrees);
        let mut sum: u128 =
            of_edges.map(|(&weight, &edges)| u128::from(weight) * u128::from(edges)).sum();
        let mut degrees = joint.edge_degrees.clone();
        for (face, found) in found.into_iter().enumerate() {
            let Some((_, vertices)) = &solvers[face] else { continue };
            match found {
                Some((weight, chords)) => {
                    sum += u128::from(weight);
                    for (&vertex, chords) in vertices.iter().zip(chords) {
                        degrees[vertex as usize] += chords;
                    }
                }
                // A face with holes: each chord weighs at least twice the least weight.
                None => {
                    let least = vertices.iter().map(|&vertex| whole[vertex as usize]).min();
                    let count = joint.triangles[face].len() * 3 - vertices.len();
                    sum += u128::from(least.unwrap_or(0)) * count as u128;
                }
            }
        }
        let found = JointBound::Weights { weights: whole, sum };
        if found.max_degree() > best.max_degree() {
            best = found;
        }
        if best.max_degree() >= joint.max_degree() {
            break;
        }
        let mean =
            degrees.iter().map(|&degree| f64::from(degree)).sum::<f64>() / degrees.len() as f64;
        let pace = 0.15 / (1.0 + f64::from(round) / 20.0);
        for (weight, &degree) in weights.iter_mut().zip(&degrees) {
            let change = (pace * (f64::from(degree) - mean)).clamp(-1.0, 1.0);
            *weight = (*weight / largest * libm::exp(change)).max(1e-9);
        }
    }
    Ok(best)
}
