//! How small the maximum degree of a model can be.
//!
//! *Sum.* However the faces are triangulated, the mesh has the same number of edges: the intervals
//! of the model, and n + 3h - 3 chords in a face of n vertices and h holes. The largest degree is at
//! least the average one.
//!
//! *Side.* On a straight side of a intervals, a - 2 boundary edges are not sides of an ear, and each
//! has an apex elsewhere on the face. A vertex with c chords in the face is apex to at most c - 1 of
//! them; with m edges of the model and degree D it has at most D - m chords.
//!
//! *Weights.* The average of degrees, weighted, is at most the largest degree. For any weights, each
//! face has a triangulation whose chords weigh least, by a dynamic program. Multiplicative weights
//! look for good ones; the arithmetic is exact.
//!
//! *Search.* `search.rs` decides what these leave open.

use mindeg_exact::{LeastWeight, Refutation};
use mindeg_mesh::{Cancelled, Progress};

use super::joint::Joint;
use mindeg_mesh::parallel::map_all;

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
    /// A search over the triangulations of all faces together, whose proof has been repeated by
    /// [`mindeg_exact::check`].
    Refuted {
        /// The least maximum degree.
        max_degree: u32,
        /// Why no mesh has less.
        refutation: Refutation,
    },
}

impl JointBound {
    /// The maximum degree that this proves to be necessary.
    pub fn max_degree(&self) -> u32 {
        match self {
            Self::Sum { sum, vertices } => sum.div_ceil(u64::from(*vertices).max(1)) as u32,
            Self::Edges { edges, .. } => *edges,
            Self::Side { max_degree, .. } | Self::Refuted { max_degree, .. } => *max_degree,
            Self::Weights { weights, sum } => {
                let total: u128 = weights.iter().map(|&weight| u128::from(weight)).sum();
                sum.div_ceil(total.max(1)) as u32
            }
        }
    }
}

/// The best of the bounds that take near-linear time.
pub(crate) fn cheap(joint: &Joint) -> JointBound {
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
    for face in 0..joint.face_count() {
        if let Some((max_degree, intervals)) = side_bound(joint, face, best.max_degree()) {
            best = JointBound::Side { face: face as u32, intervals, max_degree };
        }
    }
    best
}

/// The bound of the best side of a face, if it is above `above`, and the intervals of that side.
fn side_bound(joint: &Joint, face: usize, above: u32) -> Option<(u32, u32)> {
    let places = joint.face(face).vertices.len() as u32;
    let plane_face = joint.face(face);
    // A side has at most all but one of the intervals; without many, no bound is above.
    if places < above || !plane_face.is_polygon() {
        return None;
    }
    let runs = plane_face.boundary.runs();
    let run_count = runs.iter().max().map_or(0, |&run| run as usize + 1);
    // The vertices of each side, with both corners.
    let mut on_side = vec![Vec::new(); run_count];
    for ring in plane_face.boundary.rings() {
        let mut before = ring.end - 1;
        for place in ring.clone() {
            let [run, run_before] = [place, before].map(|place| runs[place as usize]);
            on_side[run as usize].push(place);
            if run_before != run {
                on_side[run_before as usize].push(place);
            }
            before = place;
        }
    }
    let capacity = |degree: u32, place: u32| {
        let edges = joint.edge_degrees[plane_face.vertices[place as usize] as usize];
        u64::from(degree.saturating_sub(edges + 1))
    };
    let of_all = |degree| (0..runs.len() as u32).map(|place| capacity(degree, place)).sum::<u64>();
    let mut degree = above;
    let mut capacities = of_all(degree);
    let mut best = None;
    for places in on_side {
        // Where a ring begins within a side, a number of a side is left out.
        let intervals = places.len().saturating_sub(1) as u64;
        let apexes = |degree, all: u64| {
            all - places.iter().map(|&place| capacity(degree, place)).sum::<u64>()
        };
        if intervals < 3 || apexes(degree, capacities) >= intervals - 2 {
            continue;
        }
        let most = intervals + u64::from(above) + 3;
        while apexes(degree, capacities) < intervals - 2 && u64::from(degree) < most {
            degree += 1;
            capacities = of_all(degree);
        }
        best = Some((degree, intervals as u32));
    }
    best
}

/// The best of a bound and of weights, for models that are not too large.
pub(super) fn with_weights(
    joint: &Joint,
    bound: JointBound,
    progress: Progress<'_>,
) -> Result<JointBound, Cancelled> {
    let faces: Vec<usize> = (0..joint.face_count()).collect();
    // About n³/6 triples in a convex face.
    let triples = |&face: &usize| u64::from(joint.face(face).vertices.len() as u32).pow(3) / 6;
    if faces.iter().map(triples).fold(0, u64::saturating_add) > MOST_TRIPLES {
        return Ok(bound);
    }
    let solvers = map_all(faces.clone(), |face| {
        let problem = joint.face(face).problem(&joint.triangles[face])?;
        LeastWeight::new(&problem, joint.thresholds[face]).ok()
    });
    let mut weights = vec![1.0; joint.totals.len()];
    let mut best = bound;
    for round in 0..ROUNDS {
        progress.report("proving a bound", round.into(), ROUNDS.into())?;
        let largest = weights.iter().copied().fold(0.0, f64::max);
        let whole: Vec<u64> =
            weights.iter().map(|weight| (weight / largest * UNIT + 0.5) as u64).collect();
        let found = map_all(faces.clone(), |face| {
            let vertices = joint.face(face).vertices.iter();
            let own: Vec<u64> = vertices.map(|&vertex| whole[vertex as usize]).collect();
            solvers[face].as_ref()?.of(&own)
        });
        let of_edges = whole.iter().zip(&joint.edge_degrees);
        let mut sum: u128 =
            of_edges.map(|(&weight, &edges)| u128::from(weight) * u128::from(edges)).sum();
        let mut degrees = joint.edge_degrees.clone();
        for (face, found) in found.into_iter().enumerate() {
            let plane_face = joint.face(face);
            let vertices = &plane_face.vertices;
            match found {
                Some((weight, chords)) => {
                    sum += u128::from(weight);
                    for (&vertex, chords) in vertices.iter().zip(chords) {
                        degrees[vertex as usize] += chords;
                    }
                }
                // A face with holes, or none that is a polygon: each chord weighs at least twice the least weight.
                None => {
                    let least = vertices.iter().map(|&vertex| whole[vertex as usize]).min();
                    let ends: u32 = plane_face.chords(&joint.triangles[face]).iter().sum();
                    sum += u128::from(least.unwrap_or(0)) * u128::from(ends);
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

#[cfg(test)]
mod tests {
    use super::super::of_model;
    use super::*;
    use glam::DVec3;
    use mindeg_domain::{Model, ModelEdge, ModelFace, ModelParts, Side};

    /// A closed model whose edges have one interval, but for some.
    fn model(corners: &[[f64; 3]], faces: &[&[&[u32]]], long: &[[u32; 2]], count: u64) -> Model {
        Model::new(ModelParts {
            corners: corners.iter().copied().map(DVec3::from_array).collect(),
            faces: faces
                .iter()
                .map(|loops| ModelFace {
                    loops: loops.iter().map(|ring| ring.to_vec()).collect(),
                    ..ModelFace::default()
                })
                .collect(),
            edges: long
                .iter()
                .map(|&corners| ModelEdge { corners, side: Side::count(count) })
                .collect(),
            other_edges: Some(Side::count(1)),
            planar_tolerance: None,
        })
        .unwrap()
    }

    fn bound(model: &Model) -> JointBound {
        cheap(&of_model(model, &model.positions(), None, Progress::NONE).unwrap())
    }

    #[test]
    fn one_apex_serves_a_long_side() {
        let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        // Each face begins at each of its corners, so that each of its sides is the first and the last.
        for turn in 0..3 {
            let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]].map(|mut face: [u32; 3]| {
                face.rotate_left(turn);
                face
            });
            let loops = faces.each_ref().map(|face| [&face[..]]);
            let loops = loops.each_ref().map(|loops| &loops[..]);
            for (long, first) in
                [([0, 1], 0), ([0, 2], 0), ([1, 2], 0), ([0, 3], 1), ([1, 3], 1), ([2, 3], 2)]
            {
                let model = model(&corners, &loops, &[long], 12);
                // 10 edges need the apex, which so has 11 chords beside its 3 edges.
                let expected = JointBound::Side { face: first, intervals: 12, max_degree: 14 };
                assert_eq!(bound(&model), expected, "{long:?}, turned by {turn}");
            }
        }
    }

    #[test]
    fn a_side_of_two_edges_is_one() {
        let corners =
            [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.5, 0.0, 0.0]];
        for turn in 0..4 {
            let [mut below, mut before] = [[4, 0, 2, 1], [4, 1, 3, 0]];
            below.rotate_left(turn);
            before.rotate_left(turn);
            let faces: [&[&[u32]]; 4] = [&[&below], &[&before], &[&[1, 2, 3]], &[&[0, 3, 2]]];
            let model = model(&corners, &faces, &[[0, 4], [1, 4]], 6);
            let expected = JointBound::Side { face: 0, intervals: 12, max_degree: 14 };
            assert_eq!(bound(&model), expected, "turned by {turn}");
        }
    }

    #[test]
    fn the_vertices_of_a_hole_serve_a_long_side() {
        let ring = |low: f64, high: f64, z: f64| {
            [[low, low, z], [high, low, z], [high, high, z], [low, high, z]]
        };
        let corners =
            [ring(0.0, 3.0, 0.0), ring(0.0, 3.0, 1.0), ring(1.0, 2.0, 0.0), ring(1.0, 2.0, 1.0)]
                .concat();
        for turn in 0..4 {
            let turned = |mut ring: [u32; 4]| {
                ring.rotate_left(turn);
                ring
            };
            let (bottom, top) = (turned([3, 2, 1, 0]), turned([4, 5, 6, 7]));
            let (below, above) = (turned([8, 9, 10, 11]), turned([15, 14, 13, 12]));
            let outer: [[u32; 4]; 4] = std::array::from_fn(|i| {
                let (i, j) = (i as u32, (i as u32 + 1) % 4);
                [i, j, j + 4, i + 4]
            });
            let inner: [[u32; 4]; 4] = std::array::from_fn(|i| {
                let (i, j) = (i as u32 + 8, (i as u32 + 1) % 4 + 8);
                [j, i, i + 4, j + 4]
            });
            let walls: Vec<[&[u32]; 1]> =
                outer.iter().chain(&inner).map(|wall| [&wall[..]]).collect();
            let ends = [[&bottom[..], &below[..]], [&top[..], &above[..]]];
            let faces: Vec<&[&[u32]]> =
                walls.iter().map(|wall| &wall[..]).chain(ends.iter().map(|end| &end[..])).collect();
            // Two opposite edges are long: the wall between them has apexes for both, the faces with the
            // hole have six vertices beside the long side, each with 3 edges.
            for long in
                [[[0, 1], [4, 5]], [[1, 2], [5, 6]], [[8, 9], [12, 13]], [[11, 8], [15, 12]]]
            {
                let model = model(&corners, &faces, &long, 40);
                // 38 edges need an apex; a vertex with D - 3 chords serves D - 4 of them: 6 of 7 serve 42.
                let expected = JointBound::Side { face: 8, intervals: 40, max_degree: 11 };
                assert_eq!(bound(&model), expected, "{long:?}, turned by {turn}");
            }
        }
    }
}
