//! Inspections of meshes with known results.

use glam::{DQuat, DVec3, Vec3Swizzles as _};
use mindeg_mesh::inspection::{Inspection, InspectionOptions, NoConvexOutline};
use mindeg_mesh::{Polygons, TriMesh};

fn inspect(positions: Vec<DVec3>, triangles: &[[u32; 3]]) -> Inspection {
    let mesh = TriMesh::new(positions, triangles.to_vec()).unwrap();
    Inspection::of(&mesh, &InspectionOptions::default())
}

/// Vertices without two at one point or three on a line.
fn apart(count: u32) -> Vec<DVec3> {
    (0..count).map(f64::from).map(|i| DVec3::new(i, i * i, i * i * i)).collect()
}

/// The torus with a grid of 3 by 3 vertices.
fn torus() -> Vec<[u32; 3]> {
    let vertex = |i: u32, j: u32| 3 * (i % 3) + j % 3;
    let square = |i, j| {
        let [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
        [[a, b, c], [a, c, d]]
    };
    (0..9).flat_map(|n| square(n / 3, n % 3)).collect()
}

#[rustfmt::skip]
#[test]
fn how_meshes_hang_together() {
    const TETRAHEDRON: [[u32; 3]; 4] = [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]];
    let fan = |n: u32| (1..=n).map(|i| [0, i, i % n + 1]).collect::<Vec<_>>();
    let band = |n: u32| (0..n).map(|i| [i, (i + 1) % n, (i + 2) % n]).collect::<Vec<_>>();
    let moved = |by: u32| TETRAHEDRON.map(|t| t.map(|v| v + by));
    // Vertices, edges, boundary edges, loops, open boundaries, components, Euler characteristic.
    for (name, triangles, expected) in [
        ("a triangle", vec![[0, 1, 2]], [3, 3, 3, 1, 0, 1, 1]),
        ("two", vec![[0, 1, 2], [0, 2, 3]], [4, 5, 4, 1, 0, 1, 1]),
        ("two that disagree", vec![[0, 1, 2], [0, 3, 2]], [4, 5, 4, 1, 0, 1, 1]),
        ("two apart", vec![[0, 1, 2], [3, 4, 5]], [6, 6, 6, 2, 0, 2, 2]),
        ("two that touch in a vertex", vec![[0, 1, 2], [0, 3, 4]], [5, 6, 6, 2, 0, 2, 1]),
        ("two that touch in two vertices", vec![[0, 1, 2], [2, 3, 4], [4, 5, 0]], [6, 9, 9, 3, 0, 3, 0]),
        ("three at an edge", vec![[0, 1, 2], [0, 1, 3], [0, 1, 4]], [5, 7, 6, 0, 3, 1, 1]),
        ("one twice", vec![[0, 1, 2], [0, 1, 2]], [3, 3, 0, 0, 0, 1, 2]),
        ("a fan with a center", fan(5), [6, 10, 5, 1, 0, 1, 1]),
        ("a tetrahedron", TETRAHEDRON.into(), [4, 6, 0, 0, 0, 1, 2]),
        ("one with a hole", TETRAHEDRON[..3].into(), [4, 6, 3, 1, 0, 1, 1]),
        ("two tetrahedra", [TETRAHEDRON, moved(4)].concat(), [8, 12, 0, 0, 0, 2, 4]),
        ("two that touch in a vertex", [TETRAHEDRON, moved(3)].concat(), [7, 12, 0, 0, 0, 2, 3]),
        ("two that touch in an edge", [TETRAHEDRON, moved(2)].concat(), [6, 11, 0, 0, 0, 1, 3]),
        ("a torus", torus(), [9, 27, 0, 0, 0, 1, 0]),
        ("a Möbius strip", band(5), [5, 10, 5, 1, 0, 1, 0]),
        ("a repeated vertex", vec![[0, 1, 2], [3, 3, 4]], [3, 3, 3, 1, 0, 1, 1]),
    ] {
        let count = triangles.iter().flatten().max().unwrap() + 1;
        let i = inspect(apart(count), &triangles);
        let used = i.vertex_count - i.unreferenced_vertices.len();
        let found = [used, i.edge_count, i.boundary_edge_count, i.boundary_loop_count, i.open_boundary_count, i.component_count];
        assert_eq!(found.map(|n| n as i64), expected[..6], "{name}");
        assert_eq!(i.euler_characteristic, expected[6], "{name}");
    }
}

/// The indices of defects, by kind; an empty list means no defect.
#[derive(Debug, Default, PartialEq)]
struct Defects {
    non_manifold_edges: Vec<[u32; 2]>,
    non_manifold_vertices: Vec<u32>,
    inconsistent_edges: Vec<[u32; 2]>,
    duplicates: Vec<u32>,
    zero_area: Vec<u32>,
    unreferenced: Vec<u32>,
}

fn defects(inspection: Inspection) -> Defects {
    Defects {
        non_manifold_edges: inspection.non_manifold_edges,
        non_manifold_vertices: inspection.non_manifold_vertices,
        inconsistent_edges: inspection.inconsistent_edges,
        duplicates: inspection.duplicate_faces,
        zero_area: inspection.zero_area_triangles,
        unreferenced: inspection.unreferenced_vertices,
    }
}

#[rustfmt::skip]
#[test]
fn every_defect_is_named() {
    let none = Defects::default;
    for (triangles, expected) in [
        (&[[0, 1, 2], [0, 2, 3]][..], none()),
        (&torus(), none()),
        (&[[1, 0, 2], [1, 3, 0], [0, 1, 4]], Defects { non_manifold_edges: vec![[0, 1]], ..none() }),
        (&[[2, 0, 1], [3, 2, 4]], Defects { non_manifold_vertices: vec![2], ..none() }),
        (&[[0, 1, 2], [0, 3, 2]], Defects { inconsistent_edges: vec![[0, 2]], ..none() }),
        (&[[0, 1, 2], [0, 1, 3]], Defects { inconsistent_edges: vec![[0, 1]], ..none() }),
        // A Möbius strip cannot agree everywhere.
        (&[[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 0], [4, 0, 1]], Defects { inconsistent_edges: vec![[0, 1]], ..none() }),
        (&[[0, 1, 2], [2, 1, 0]], Defects { duplicates: vec![1], ..none() }),
        (&[[0, 1, 2], [0, 2, 3], [1, 2, 0]], Defects { duplicates: vec![2], non_manifold_edges: vec![[0, 2]], inconsistent_edges: vec![[0, 1], [1, 2]], ..none() }),
        (&[[0, 1, 2], [2, 1, 0], [1, 0, 2], [0, 2, 1]], Defects { duplicates: vec![1, 2, 3], non_manifold_edges: vec![[0, 1], [0, 2], [1, 2]], ..none() }),
        (&[[0, 1, 2], [0, 1, 4]], Defects { inconsistent_edges: vec![[0, 1]], unreferenced: vec![3], ..none() }),
        (&[[0, 1, 2], [1, 1, 3], [3, 3, 3]], Defects { zero_area: vec![1, 2], unreferenced: vec![3], ..none() }),
    ] {
        let count = triangles.iter().flatten().max().unwrap() + 1;
        assert_eq!(defects(inspect(apart(count), triangles)), expected, "{triangles:?}");
    }
}

#[test]
fn a_mesh_without_a_face_is_told_so() {
    let found = inspect(apart(3), &[[0, 0, 1], [2, 2, 2]]);
    assert_eq!((found.triangle_count, found.face_count, found.edge_count), (2, 0, 0));
    assert_eq!((found.component_count, found.euler_characteristic), (0, 0));
    assert_eq!((found.highest_degree, found.max_degree()), (None, 0));
    assert_eq!(found.unreferenced_vertices, [0, 1, 2]);
    assert_eq!(found.zero_area_triangles, [0, 1]);
    assert_eq!(found.outline, Err(NoConvexOutline::NotADisk));
}

#[test]
fn zero_area_is_exact() {
    let at = |x: f64, y: f64| DVec3::new(x, y, 0.0);
    // Exact for numbers of 50 bits.
    let on_line = |t: f64| at(7.0 * t, 3.0 * t);
    for (points, flat) in [
        ([at(0.0, 0.0), at(1.0, 0.0), at(3.0, 0.0)], true),
        ([at(0.0, 0.0), at(1.0, 0.0), at(1.0, 0.0)], true),
        ([at(0.0, 0.0), at(1.0, 1e-300), at(3.0, 0.0)], false),
        ([at(0.0, 0.0), at(1e-200, 0.0), at(0.0, 1e-200)], false),
        ([at(0.0, 0.0), at(1e200, 0.0), at(0.0, 1e200)], false),
        // Far from the origin, areas that rounding of the coordinates could explain.
        ([at(1e8, 0.0), at(1e8 + 1.0, 0.0), at(1e8 + 1.0, 1e-8)], false),
        ([at(1e8, 1e8), at(1e8 + 1.0, 1e8 + 1.0), at(1e8 + 2.0, 1e8 + 2.0)], true),
        ([at(1e6, 0.0), at(1e6 + 1.0, 0.0), at(1e6, libm::ldexp(1.0, -31))], false),
        // Not on a line, but as close to one as 64-bit floats allow.
        ([at(0.1, 0.1), at(0.2, 0.2), at(0.3, 0.1 + 0.2)], false),
        // Differences of these are rounded, and the rounded differences span an area.
        ([at(0.1, 0.3), at(1.0, 3.0), at(2.0, 6.0)], false),
        ([at(-0.1, -0.1), at(1.0, 1.0), at(1e17, 1e17)], true),
        // The rounded differences span an area, although the corners are on one line.
        (
            [
                on_line(26958134.66505146),
                on_line(54.58221712067461),
                on_line(0.0019638091325759888),
            ],
            true,
        ),
        ([at(1e308, 0.0), at(-1e308, 0.0), at(0.0, 1e308)], false),
        ([at(1e308, 1e308), at(-1e308, -1e308), at(3e307, 3e307)], true),
    ] {
        for turn in [|p| p, |p: DVec3| DVec3::new(p.z, p.x, p.y), |p: DVec3| p.yzx()] {
            let points = points.map(turn);
            let found = inspect(points.to_vec(), &[[0, 1, 2]]);
            assert_eq!(!found.zero_area_triangles.is_empty(), flat, "{points:?}");
            // A needle like this is measured as flat.
            let is_flat = flat || points.iter().any(|p| p.to_array().contains(&1e-300));
            let min_angle = found.worst_triangles.first().unwrap().quality.min_angle;
            assert!(min_angle == 0.0 || !is_flat, "{points:?}");
        }
    }
}

/// Two triangles with corners of their own, as in flat shading.
const SEAM: [[f64; 3]; 6] = [
    [0.0, 0.0, 0.0],
    [2.0, 0.0, 0.0],
    [2.0, 1.0, 0.0],
    [0.0, 0.0, 0.0],
    [2.0, 1.0, 0.0],
    [0.0, 1.0, -0.0],
];

#[test]
fn vertices_in_one_place_count_as_one_unless_asked() {
    let positions = SEAM.map(DVec3::from).to_vec();
    let mesh = TriMesh::new(positions, vec![[0, 1, 2], [3, 4, 5]]).unwrap();
    let welded = Inspection::of(&mesh, &InspectionOptions::default());
    assert_eq!((welded.vertex_count, welded.welded_count, welded.edge_count), (6, 2, 5));
    assert_eq!((welded.component_count, welded.euler_characteristic), (1, 1));
    assert!(welded.boundary_degrees.iter().eq([(2, 2), (3, 2)]));
    assert_eq!(welded.highest_degree.unwrap().vertex, 0);
    assert!(welded.unreferenced_vertices.is_empty());
    assert_eq!(welded.outline.unwrap().corners, [0, 1, 2, 5]);

    let as_it_is = InspectionOptions { weld: None, ..InspectionOptions::default() };
    let apart = Inspection::of(&mesh, &as_it_is);
    assert_eq!((apart.vertex_count, apart.welded_count, apart.edge_count), (6, 0, 6));
    assert_eq!((apart.component_count, apart.euler_characteristic), (2, 2));
}

#[test]
fn a_triangle_that_welding_closes_is_no_face() {
    // The top of a globe: the pole occurs twice, and one triangle is between its copies.
    let positions = [DVec3::Z, DVec3::Z, DVec3::X, DVec3::Y].to_vec();
    let found = inspect(positions, &[[0, 2, 3], [0, 1, 3]]);
    assert_eq!((found.triangle_count, found.face_count), (2, 1));
    assert_eq!(found.zero_area_triangles, [1]);
    assert_eq!(
        (found.edge_count, found.boundary_loop_count, found.euler_characteristic),
        (3, 1, 1)
    );
}

#[test]
fn degrees_are_split_and_poles_named_highest_first() {
    // Two wheels: 10 spokes round vertex 0, which is interior, and 12 from vertex 20 to a rim
    // that is open, so that it is on the boundary.
    let wheel = (1..=10).map(|i| [0, i, i % 10 + 1]);
    let fan = (21..32).map(|i| [20, i, i + 1]);
    let triangles: Vec<_> = wheel.chain(fan).collect();
    let mesh = TriMesh::new(apart(33), triangles).unwrap();
    let found = Inspection::of(&mesh, &InspectionOptions::default());
    assert!(found.interior_degrees.iter().eq([(10, 1)]));
    assert!(found.boundary_degrees.iter().eq([(2, 2), (3, 20), (12, 1)]));
    let poles: Vec<_> = found.poles.iter().map(|p| (p.vertex, p.degree, p.on_boundary)).collect();
    assert_eq!(poles, [(20, 12, true), (0, 10, false)]);
    assert_eq!(found.highest_degree, Some(found.poles[0]));
    assert_eq!(found.unreferenced_vertices, (11..20).collect::<Vec<_>>());

    for (pole_degree, poles) in [(9, 2), (10, 1), (11, 1), (12, 0)] {
        let options = InspectionOptions { pole_degree, ..InspectionOptions::default() };
        assert_eq!(Inspection::of(&mesh, &options).poles.len(), poles, "{pole_degree}");
    }
}

#[test]
fn the_worst_triangles_come_first() {
    // Right triangles of height 1, with decreasing minimum angles except for one.
    let mut positions = Vec::new();
    for width in [1.0, 7.0, 2.0, 3.0, 4.0, 5.0, 6.0] {
        positions.extend([DVec3::ZERO, DVec3::X * width, DVec3::Y].map(|p| p + DVec3::Z * width));
    }
    let triangles: Vec<[u32; 3]> = (0..7).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let found = inspect(positions.clone(), &triangles);
    let worst: Vec<_> = found.worst_triangles.iter().map(|worst| worst.triangle).collect();
    assert_eq!(worst, [1, 6, 5, 4, 3]);
    let least = found.quality.metric("min_angle").unwrap().min;
    assert_eq!(found.worst_triangles.first().unwrap().quality.min_angle, least);
    assert_eq!(found.quality.shares_below, [0.0, 0.0, 2.0 / 7.0, 4.0 / 7.0, 5.0 / 7.0]);

    // Equal triangles stay in the order of the mesh.
    let in_turn: Vec<_> = triangles[..2].iter().cycle().take(12).copied().collect();
    let worst = inspect(positions, &in_turn).worst_triangles;
    assert_eq!(worst.iter().map(|worst| worst.triangle).collect::<Vec<_>>(), [1, 3, 5, 7, 9]);
}

/// A mesh of polygons, each cut into a fan, and whatever points.
fn of_polygons(positions: Vec<DVec3>, polygons: &[Vec<u32>]) -> TriMesh {
    let mut triangles = Vec::new();
    let mut triangle_starts = vec![0];
    for corners in polygons {
        triangles.extend(corners[1..].windows(2).map(|edge| [corners[0], edge[0], edge[1]]));
        triangle_starts.push(triangles.len() as u32);
    }
    let polygons = Polygons { triangle_starts, corners: polygons.concat() };
    TriMesh::new(positions, triangles).unwrap().with_polygons(polygons)
}

fn inspect_polygons(polygons: &[Vec<u32>]) -> Inspection {
    let count = polygons.iter().flatten().max().unwrap() + 1;
    let mesh = of_polygons(apart(count), polygons);
    Inspection::of(&mesh, &InspectionOptions::default())
}

#[rustfmt::skip]
#[test]
fn polygons_hang_together_as_the_file_has_them() {
    let ring = |n: u32, at: u32| (0..n).map(move |i| at + i).collect::<Vec<_>>();
    let side = |n: u32, i: u32| vec![i, (i + 1) % n, n + (i + 1) % n, n + i];
    let open_cylinder = |n: u32| (0..n).map(|i| side(n, i)).collect::<Vec<_>>();
    let cylinder = |n: u32| [open_cylinder(n), vec![ring(n, 0).into_iter().rev().collect(), ring(n, n)]].concat();
    let cone = |n: u32| (0..n).map(|i| vec![i, (i + 1) % n, n]).chain([ring(n, 0).into_iter().rev().collect()]).collect::<Vec<_>>();
    let at = |i: u32, j: u32| 5 * (i % 5) + j % 5;
    let torus: Vec<Vec<u32>> = (0..25).map(|n| (n / 5, n % 5)).map(|(i, j)| vec![at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]).collect();
    let grid: Vec<Vec<u32>> = (0..16).map(|n| (n / 4, n % 4)).map(|(i, j)| vec![at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]).collect();
    // Faces, edges, boundary edges, loops, components, Euler characteristic, highest degree.
    for (name, polygons, expected) in [
        ("a doublet", vec![vec![0, 1, 2, 3], vec![2, 1, 0, 4]], [2, 6, 4, 1, 1, 1, 3]),
        ("a 12-gon", vec![ring(12, 0)], [1, 12, 12, 1, 1, 1, 2]),
        ("a cylinder", cylinder(32), [34, 96, 0, 0, 1, 2, 3]),
        ("an open cylinder", open_cylinder(32), [32, 96, 64, 2, 1, 0, 3]),
        ("a cone", cone(32), [33, 64, 0, 0, 1, 2, 32]),
        ("a torus", torus, [25, 50, 0, 0, 1, 0, 4]),
        ("a grid", grid, [16, 40, 16, 1, 1, 1, 4]),
        ("a cube", vec![vec![0, 3, 2, 1], vec![4, 5, 6, 7], vec![0, 1, 5, 4], vec![1, 2, 6, 5], vec![2, 3, 7, 6], vec![3, 0, 4, 7]], [6, 12, 0, 0, 1, 2, 3]),
        ("a square with a hole and a bridge", vec![vec![0, 1, 2, 3, 0, 4, 7, 6, 5, 4]], [1, 9, 8, 2, 1, 0, 3]),
        ("a face that touches itself", vec![vec![0, 1, 2, 0, 3, 4]], [1, 6, 6, 1, 1, 0, 4]),
        ("a triangle and a quad", vec![vec![0, 1, 2], vec![0, 2, 3, 4]], [2, 6, 5, 1, 1, 1, 3]),
    ] {
        let i = inspect_polygons(&polygons);
        let found = [i.face_count, i.edge_count, i.boundary_edge_count, i.boundary_loop_count, i.component_count].map(|n| n as i64);
        assert_eq!(found, expected[..5], "{name}");
        assert_eq!([i.euler_characteristic, i64::from(i.max_degree())], expected[5..], "{name}");
        let touches_itself = name.ends_with("touches itself");
        assert_eq!(i.non_manifold_vertices, if touches_itself { vec![0] } else { vec![] }, "{name}");
        let defects = Defects { non_manifold_vertices: vec![], zero_area: vec![], ..defects(i) };
        assert_eq!(defects, Defects::default(), "{name}");
    }
}

#[test]
fn faces_that_repeat_others_are_named() {
    for (polygons, expected) in [
        (vec![vec![0, 1, 2, 3], vec![2, 3, 0, 1], vec![3, 2, 1, 0]], &[1, 2][..]),
        // The same corners in another order are another face.
        (vec![vec![0, 1, 2, 3], vec![0, 2, 1, 3]], &[]),
        (vec![vec![0, 1, 2, 3, 4], vec![0, 1, 3, 2, 4]], &[]),
        (vec![vec![5, 3, 4, 1, 2], vec![0, 1, 2], vec![4, 3, 5, 2, 1]], &[2]),
        (vec![vec![0, 1, 2, 3], vec![0, 1, 2]], &[]),
        (vec![vec![0, 1, 2], vec![0, 2, 3, 4], vec![1, 2, 0, 0]], &[2]),
    ] {
        assert_eq!(inspect_polygons(&polygons).duplicate_faces, expected, "{polygons:?}");
    }
}

/// The sphere of three.js with 16 by 12 quads as triangles, and a seam of vertices that occur
/// twice, but not at exactly the same point.
fn sphere(place: impl Fn(DVec3) -> DVec3) -> TriMesh {
    let [columns, rows] = [16_u32, 12];
    let mut positions = Vec::new();
    for (row, column) in (0..=rows).flat_map(|row| (0..=columns).map(move |column| (row, column))) {
        let [u, v] = [(column, columns), (row, rows)].map(|(i, n)| f64::from(i) / f64::from(n));
        let (phi, theta) = (u * std::f64::consts::TAU, v * std::f64::consts::PI);
        let [x, y] = [-libm::cos(phi) * libm::sin(theta), libm::cos(theta)];
        positions.push(place(DVec3::new(x, y, libm::sin(phi) * libm::sin(theta))));
    }
    let mut triangles = Vec::new();
    for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
        let at = |row: u32, column: u32| row * (columns + 1) + column;
        let [b, a] = [at(row, column), at(row, column + 1)];
        let [c, d] = [at(row + 1, column), at(row + 1, column + 1)];
        triangles.extend((row > 0).then_some([a, b, d]));
        triangles.extend((row + 1 < rows).then_some([b, c, d]));
    }
    TriMesh::new(positions, triangles).unwrap()
}

#[test]
fn a_tolerance_closes_a_seam_wherever_it_is() {
    let turn = DQuat::from_xyzw(0.1, 0.7, -0.3, 0.6).normalize();
    let moved = |p: DVec3| turn * p + DVec3::new(1.0, 2.0, 3.0);
    let single = |p: DVec3| p.as_vec3().as_dvec3();
    let in_place = sphere(|p| p);
    for mesh in [in_place.clone(), sphere(single), sphere(moved), sphere(|p| single(moved(p)))] {
        let of = |weld| {
            let options = InspectionOptions { weld, ..InspectionOptions::default() };
            Inspection::of(&mesh, &options)
        };
        let diagonal = 12.0_f64.sqrt();
        let closed = of(Some(1e-7 * diagonal));
        assert_eq!((closed.boundary_edge_count, closed.euler_characteristic), (0, 2));
        // 16 copies of each pole, and 11 vertices of the seam.
        assert_eq!(closed.welded_count, 32 + 11);
        assert!(of(None).welded_count == 0);
    }
    // Two rows of the seam, at the poles.
    let exact = Inspection::of(&in_place, &InspectionOptions::default());
    assert!(exact.boundary_edge_count > 0, "{exact:?}");
}

#[test]
fn welding_closes_polygons_too() {
    // A quad whose first two corners are merged, beside a triangle.
    let positions = [DVec3::ZERO, DVec3::X * 1e-9, DVec3::X, DVec3::Y, -DVec3::X].to_vec();
    let mesh = of_polygons(positions, &[vec![0, 1, 2, 3], vec![1, 3, 4]]);
    let of = |weld| {
        let found = Inspection::of(&mesh, &InspectionOptions { weld, ..Default::default() });
        (found.welded_count, found.face_count, found.edge_count, found.euler_characteristic)
    };
    assert_eq!(of(Some(0.0)), (0, 2, 7, 0));
    assert_eq!(of(Some(1e-8)), (1, 2, 5, 1));
}
