//! Closed meshes: closed, manifold, genus, volume.

use glam::DVec3;
use mindeg_mesh::TriMesh;
use mindeg_mesh::inspection::{Inspection, InspectionOptions};

fn inspect(positions: &[DVec3], triangles: &[[u32; 3]]) -> Inspection {
    let mesh = TriMesh::new(positions.to_vec(), triangles.to_vec()).unwrap();
    Inspection::of(&mesh, &InspectionOptions::default())
}

const TETRAHEDRON: [DVec3; 4] = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
const FACES: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];

#[test]
fn a_tetrahedron_has_a_sixth_of_a_cube() {
    let far = TETRAHEDRON.map(|corner| corner + DVec3::splat(1e6));
    for corners in [TETRAHEDRON, far] {
        let inspection = inspect(&corners, &FACES);
        assert!(inspection.is_closed() && inspection.is_manifold());
        assert_eq!((inspection.genus(), inspection.volume), (Some(0), Some(1.0 / 6.0)));
    }
    let inside_out = FACES.map(|[a, b, c]| [a, c, b]);
    assert_eq!(inspect(&TETRAHEDRON, &inside_out).volume, Some(-1.0 / 6.0));
}

#[test]
fn what_has_no_inside_has_no_volume() {
    let open = inspect(&TETRAHEDRON, &FACES[..3]);
    assert_eq!((open.is_closed(), open.genus(), open.volume), (false, None, None));
    let mut flipped = FACES;
    flipped[2].swap(0, 1);
    let flipped = inspect(&TETRAHEDRON, &flipped);
    assert_eq!((flipped.is_closed(), flipped.genus(), flipped.volume), (true, None, None));
}

#[test]
fn a_torus_has_genus_1_and_parts_add_up() {
    // 3 by 3 quads round and round.
    let at = |i: u32, j: u32| (i % 3) * 3 + j % 3;
    let turn = |k: u32| std::f64::consts::TAU * f64::from(k) / 3.0;
    let point = |k: u32| {
        let (u, v) = (turn(k / 3), turn(k % 3));
        let radius = 3.0 + v.cos();
        DVec3::new(radius * u.cos(), radius * u.sin(), v.sin())
    };
    let points: Vec<DVec3> = (0..9).map(point).collect();
    let quads = (0..9).map(|k| (k / 3, k % 3));
    let triangles: Vec<[u32; 3]> = quads
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            [[a, b, c], [a, c, d]]
        })
        .collect();
    let torus = inspect(&points, &triangles);
    assert_eq!((torus.euler_characteristic, torus.genus()), (0, Some(1)));
    let shifted = points.iter().map(|&point| point + DVec3::X * 20.0);
    let two: Vec<DVec3> = points.iter().copied().chain(shifted).collect();
    let second = triangles.iter().map(|triangle| triangle.map(|vertex| vertex + 9));
    let both: Vec<[u32; 3]> = triangles.iter().copied().chain(second).collect();
    let both = inspect(&two, &both);
    assert_eq!(both.genus(), Some(2));
    assert!((both.volume.unwrap() / torus.volume.unwrap() - 2.0).abs() < 1e-12);
}
