//! Whole models: the least maximum degrees that are known, and watertight meshes.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

mod solids;

use std::collections::BTreeMap;

use mindeg::model::{ModelGoal, ModelMesh, mesh_model};
use mindeg::{Model, Progress, Side};
use solids::Solid;

fn meshed(model: &Model) -> ModelMesh {
    let goal = ModelGoal { effort: 0.25, ..ModelGoal::default() };
    mesh_model(model, goal, Progress::NONE).unwrap()
}

/// That a mesh is a closed two-manifold with the model's points, counted by other means than the
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
fn time_table() {
    if std::env::var("TIMES").is_err() {
        return;
    }
    let cube = Solid::block(1.0, 1.0, 1.0);
    let ball = Solid::truncated_icosahedron();
    for (name, solid, side) in [
        ("cube 2", &cube, Side::count(2)),
        ("cube 8", &cube, Side::count(8)),
        ("box 1/2", &Solid::block(4.0, 2.0, 1.0), Side::size(0.5)),
        ("box 1/4", &Solid::block(4.0, 2.0, 1.0), Side::size(0.25)),
        ("L 3", &Solid::l_block(), Side::size(1.0 / 3.0)),
        ("L 4", &Solid::l_block(), Side::size(0.25)),
        ("house 1", &Solid::house(), Side::size(1.0)),
        ("house 1/2", &Solid::house(), Side::size(0.5)),
        ("ball 1", &ball, Side::count(1)),
        ("ball 2", &ball, Side::count(2)),
        ("ball 3", &ball, Side::count(3)),
        ("long", &cube.clone().with_counts(|e| if e == 0 { 20 } else { 1 }), Side::count(1)),
        ("uneven", &cube.clone().with_counts(|e| (e as u64 * 7) % 12 + 1), Side::count(1)),
    ] {
        let model = solid.model(side);
        let start = std::time::Instant::now();
        let meshed = mesh_model(&model, ModelGoal::default(), Progress::NONE).unwrap();
        println!(
            "{name}: V {} degree {} bound {} angle {:.2} {:.2?}",
            model.vertex_count(),
            meshed.max_degree,
            meshed.lower_bound,
            meshed.min_angle,
            start.elapsed()
        );
    }
}
