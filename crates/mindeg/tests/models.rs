//! Whole models: the least maximum degrees that are known, and watertight meshes.

use std::collections::{BTreeMap, BTreeSet};

use crate::solids::Solid;
use mindeg::glam::DVec3;
use mindeg::model::{JointBound, ModelMesh, fill_model, mesh_model};
use mindeg::{Goal, Interior, Model, Progress, Side, TriMesh};

fn meshed(model: &Model) -> ModelMesh {
    mesh_model(model, Goal::LeastDegree, 0.25, Progress::NONE).unwrap()
}

/// Checks that a mesh is a closed two-manifold with the model's points, counted by other means than the
/// library's; returns its Euler characteristic.
fn check_closed(model: &Model, meshed: &ModelMesh) -> i64 {
    let mesh = &meshed.mesh;
    let mut half_edges = BTreeMap::new();
    let mut degrees = vec![0; mesh.positions().len()];
    for &[a, b, c] in mesh.triangles() {
        for edge in [(a, b), (b, c), (c, a)] {
            assert_eq!(half_edges.insert(edge, ()), None, "{edge:?} twice");
        }
    }
    for &(a, b) in half_edges.keys() {
        assert!(half_edges.contains_key(&(b, a)), "{a}-{b} is open");
        degrees[a as usize] += 1;
    }
    assert_eq!(degrees.iter().max(), Some(&meshed.max_degree));
    assert!(degrees.iter().all(|&degree| degree >= 3));
    assert_eq!(mesh.positions(), model.positions());
    degrees.len() as i64 - half_edges.len() as i64 / 2 + mesh.triangles().len() as i64
}

fn volume(meshed: &ModelMesh) -> f64 {
    let at = |vertex: u32| meshed.mesh.positions()[vertex as usize];
    let of = |&[a, b, c]: &[u32; 3]| at(a).dot(at(b).cross(at(c)));
    meshed.mesh.triangles().iter().map(of).sum::<f64>() / 6.0
}

/// Meshes a solid of genus 0 and checks it; its degree and bound.
fn solve(solid: &Solid, side: Side) -> [u32; 2] {
    let model = solid.model(side);
    let meshed = meshed(&model);
    assert_eq!(check_closed(&model, &meshed), 2);
    let expected = solid.volume();
    assert!((volume(&meshed) / expected - 1.0).abs() < 1e-12, "{} {expected}", volume(&meshed));
    [meshed.max_degree, meshed.lower_bound]
}

#[test]
fn even_models_reach_the_bound_of_the_sum() {
    let cube = Solid::block(1.0, 1.0, 1.0);
    for (n, least) in [(1, 5), (2, 6), (3, 6), (4, 6), (5, 6), (6, 6), (8, 6)] {
        assert_eq!(solve(&cube, Side::count(n)), [least, least], "cube, {n} intervals");
    }
    let block = Solid::block(4.0, 2.0, 1.0);
    assert_eq!(solve(&block, Side::size(0.5)), [6, 6], "box");
    let prism = Solid::prism(&[[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]], 6.0);
    assert_eq!(solve(&prism, Side::size(1.0)), [6, 6], "prism");
    let l_block = Solid::l_block();
    for n in 1..=3 {
        assert_eq!(solve(&l_block, Side::size(1.0 / f64::from(n))), [6, 6], "L-block, {n} a unit");
    }
    assert_eq!(solve(&Solid::house(), Side::size(1.0)), [6, 6], "house");
    let ball = Solid::truncated_icosahedron();
    assert_eq!(solve(&ball, Side::count(1)), [6, 6], "truncated icosahedron");
}

/// Neither descent nor a search by clauses finds it.
#[test]
fn a_truncated_icosahedron_with_three_intervals_an_edge_has_degree_6() {
    let model = Solid::truncated_icosahedron().model(Side::count(3));
    assert_eq!(model.positions().len(), 240);
    let meshed = mesh_model(&model, Goal::LeastDegree, 1.0, Progress::NONE).unwrap();
    assert_eq!(check_closed(&model, &meshed), 2);
    assert_eq!([meshed.max_degree, meshed.lower_bound], [6, 6]);
}

#[test]
fn uneven_models_reach_the_bound_of_weights() {
    // One edge of 20 intervals: the four other corners of its two faces get all their chords.
    let cube = Solid::block(1.0, 1.0, 1.0);
    let long = cube.clone().with_counts(|edge| if edge == 0 { 20 } else { 1 });
    assert_eq!(solve(&long, Side::count(1)), [14, 14]);
    // The counts 1 to 12 in some order.
    let uneven = cube.with_counts(|edge| (edge as u64 * 7) % 12 + 1);
    let [degree, bound] = solve(&uneven, Side::count(1));
    assert!(degree <= bound + 1 && degree <= 9, "{degree} {bound}");
}

#[test]
fn no_bound_is_above_a_mesh() {
    // Without descent, a bound alone is looked for; another mesh of the same points has the degree.
    let shapes = [
        Solid::block(2.0, 1.5, 1.0),
        Solid::prism(&[[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]], 6.0),
        Solid::plate(
            &[[0.0, 0.0], [3.0, 0.0], [3.0, 3.0], [0.0, 3.0]],
            &[vec![[1.0, 1.0], [2.0, 1.0], [1.0, 2.0]]],
            1.0,
        ),
    ];
    for (seed, solid) in (0..3).flat_map(|seed| shapes.iter().map(move |solid| (seed, solid))) {
        let count = |edge: usize| {
            let random = (edge as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15 ^ (seed << 32)) >> 40;
            // Few edges are long, as where a bound is above the average.
            if random.is_multiple_of(5) { 6 + random % 8 } else { 1 + random % 3 }
        };
        let model = solid.clone().with_counts(count).model(Side::count(1));
        let with_effort =
            |effort| mesh_model(&model, Goal::LeastDegree, effort, Progress::NONE).unwrap();
        let (bound, other) = (with_effort(0.0), with_effort(0.01));
        let at_least = bound.lower_bound.max(other.lower_bound);
        assert!(at_least <= bound.max_degree.min(other.max_degree), "{seed}: {bound:?}");
        assert_eq!(other.is_proven(), other.max_degree == other.lower_bound);
        for (bound, mesh) in [(&bound, &other), (&other, &bound)] {
            check_bound(&bound.bounded_by, bound.lower_bound, &mesh.mesh);
        }
    }
}

/// A prism of six sides with a hole of three corners, of which descent and sums leave open whether degree 6 is possible.
#[test]
fn a_search_closes_the_gap_of_a_prism() {
    let ring = |corners: u32, radius: f64| {
        let at = |corner: u32| {
            let angle = std::f64::consts::TAU * f64::from(corner) / f64::from(corners);
            [radius * libm::cos(angle), radius * libm::sin(angle)]
        };
        (0..corners).map(at).collect::<Vec<_>>()
    };
    let prism = Solid::plate(&ring(6, 2.0), &[ring(3, 0.8)], 1.0);
    let meshed =
        mesh_model(&prism.model(Side::count(1)), Goal::LeastDegree, 0.01, Progress::NONE).unwrap();
    assert_eq!((meshed.max_degree, meshed.lower_bound), (7, 7));
    assert!(matches!(meshed.bounded_by, JointBound::Refuted { max_degree: 7, .. }));
}

/// Checks that a mesh satisfies what a bound says of every mesh.
fn check_bound(bound: &JointBound, at_least: u32, mesh: &TriMesh) {
    let degrees = mesh.degrees();
    match bound {
        JointBound::Sum { sum, vertices } => {
            assert_eq!(degrees.len() as u32, *vertices);
            assert_eq!(degrees.iter().map(|&degree| u64::from(degree)).sum::<u64>(), *sum);
            assert_eq!(sum.div_ceil(u64::from(*vertices)), u64::from(at_least));
        }
        JointBound::Edges { vertex, edges } => {
            assert_eq!(*edges, at_least);
            assert!(degrees[*vertex as usize] >= *edges);
        }
        JointBound::Weights { weights, sum } => {
            let weighted =
                weights.iter().zip(degrees).map(|(&w, &d)| u128::from(w) * u128::from(d));
            assert!(weighted.sum::<u128>() >= *sum);
            let total: u128 = weights.iter().map(|&weight| u128::from(weight)).sum();
            assert_eq!(sum.div_ceil(total), u128::from(at_least));
        }
        // The degree of this bound is the degree that a mesh must have.
        JointBound::Side { max_degree, .. } => assert_eq!(*max_degree, at_least),
        // The checker has repeated the proof.
        JointBound::Refuted { max_degree, .. } => assert_eq!(*max_degree, at_least),
        other => unreachable!("{other:?} is checked nowhere"),
    }
}

#[test]
fn a_smaller_share_of_the_angle_allows_a_smaller_degree() {
    let solid = Solid::block(4.0, 1.0, 1.0).with_counts(|edge| [9, 2, 5][edge % 3]);
    let model = solid.model(Side::count(1));
    let found = [0.05, 0.5, 1.0].map(|share| {
        let meshed = mesh_model(&model, Goal::KeepAngle(share), 0.1, Progress::NONE).unwrap();
        assert!(meshed.angle_share.unwrap() >= share * (1.0 - 1e-9), "{share}: {meshed:?}");
        meshed.max_degree
    });
    assert!(found[0] < found[1] && found[1] <= found[2], "{found:?}");
}

/// The vertices of a closed mesh with other degrees than 5 to 7, counted by its edges.
fn out_of_range(mesh: &TriMesh) -> Vec<u32> {
    let mut neighbors = BTreeMap::<u32, BTreeSet<u32>>::new();
    for triangle in mesh.triangles() {
        for vertex in triangle {
            neighbors.entry(*vertex).or_default().extend(triangle.iter().filter(|v| *v != vertex));
        }
    }
    let is_out = |all: &BTreeSet<u32>| !(5..=7).contains(&all.len());
    neighbors.into_iter().filter(|(_, all)| is_out(all)).map(|(v, _)| v).collect()
}

#[test]
fn degrees_of_filled_models_count_over_edges_and_corners() {
    let cube = Solid::block(1.0, 1.0, 1.0);
    for intervals in [3, 4, 9] {
        let model = cube.model(Side::count(intervals));
        let filled = fill_model(&model, &Interior::default(), Progress::NONE).unwrap();
        let points = filled.mesh.positions();
        let given = model.positions();
        assert_eq!(points[..given.len()], given);
        assert_eq!(filled.interior_points, points.len() - given.len());
        assert_eq!(filled.violations, out_of_range(&filled.mesh));
        assert!(filled.violations.is_empty(), "{intervals}: {:?}", filled.violations);
        assert!(filled.min_angle > 35.0, "{intervals}: {}", filled.min_angle);
        // Points stay in their planes, and triangles face out.
        for corners in filled.mesh.triangles() {
            let [a, b, c] = corners.map(|v| points[v as usize]);
            let is_on =
                |axis: usize, value: f64| [a, b, c].iter().all(|p| (p[axis] - value).abs() < 1e-12);
            assert!((0..3).any(|axis| is_on(axis, 0.0) || is_on(axis, 1.0)));
            assert!((b - a).cross(c - a).dot(a - DVec3::splat(0.5)) > 0.0);
        }
    }
}
