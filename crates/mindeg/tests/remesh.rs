//! Remeshes of small parts: what they keep, and what is refused.

#![cfg(feature = "interior")]
#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use mindeg::glam::DVec3;
use mindeg::remesh::{PartError, Remesh, remesh};
use mindeg::{Group, Positions, Progress, TriMesh, Triangles};

/// A box of two triangles to a side; the first `open` sides are left out.
fn cuboid(extent: DVec3, open: usize) -> TriMesh {
    let points = (0..8_u32).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(f64::from));
    let points = points.map(|p| extent * DVec3::from(p)).collect();
    let quads =
        [[4, 5, 7, 6], [0, 2, 3, 1], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = quads[open..].iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    TriMesh::new(points, triangles).unwrap()
}

#[test]
fn a_box_keeps_its_surface_its_groups_and_its_name() {
    let part = cuboid(DVec3::new(1.0, 2.0, 1.0), 0).named("box");
    let groups = vec![Group::new("top", 0..2), Group::new("sides", 2..12)];
    let part = part.with_groups(groups);
    let wish = Remesh { size: Some(0.3), tolerance: Some(0.0), ..Remesh::default() };
    let found = remesh(&part, &wish, Progress::NONE).unwrap();
    assert_eq!(found.defects().count(), 0);
    assert!(found.reached.off_degree.is_empty() && found.verified.min_angle.0 > 30.0);
    assert!(found.distance() < 1e-7, "{}", found.distance());
    assert_eq!((found.features.curves, found.features.corners, found.features.patches), (12, 8, 6));
    let names: Vec<&str> = found.mesh.groups().iter().map(|group| group.name.as_str()).collect();
    assert_eq!((names, found.mesh.name()), (vec!["top", "sides"], Some("box")));
    for triangle in &found.mesh.triangles()[found.mesh.groups()[0].triangles.end as usize..] {
        assert!(triangle.iter().any(|v| found.mesh.positions()[*v as usize].z < 1.0));
    }
}

#[test]
fn the_number_of_vertices_is_near_the_one_asked_for() {
    let part = cuboid(DVec3::new(1.0, 2.0, 3.0), 0);
    for vertices in [300, 1200] {
        let wish = Remesh { vertices: Some(vertices), ..Remesh::default() };
        let found = remesh(&part, &wish, Progress::NONE).unwrap();
        let share = f64::from(found.mesh.vertex_count()) / f64::from(vertices);
        assert!((0.8..1.25).contains(&share), "{share}");
    }
}

#[test]
fn a_boundary_is_kept_bit_for_bit() {
    // An open box, remeshed at another size with the boundary and features that it got at first.
    let fine = Remesh { size: Some(0.21), ..Remesh::default() };
    let first = remesh(&cuboid(DVec3::ONE, 1), &fine, Progress::NONE).unwrap();
    let wish =
        Remesh { size: Some(0.3), keep_boundary: true, keep_features: true, ..Remesh::default() };
    let found = remesh(&first.mesh, &wish, Progress::NONE).unwrap();
    assert_eq!(found.defects().count(), 0, "{:?}", found.defects().collect::<Vec<_>>());
    assert!(
        found.mesh.boundary_loops()[0].vertices.len()
            == first.mesh.boundary_loops()[0].vertices.len()
    );
    let free =
        remesh(&first.mesh, &Remesh { size: Some(0.3), ..Remesh::default() }, Progress::NONE)
            .unwrap();
    assert!(
        free.mesh.boundary_loops()[0].vertices.len()
            < first.mesh.boundary_loops()[0].vertices.len()
    );
}

#[test]
fn wishes_without_a_meaning_and_parts_that_are_no_surface_are_refused() {
    let part = cuboid(DVec3::ONE, 0);
    for (wish, words) in [
        (Remesh { size: Some(0.0), ..Remesh::default() }, "the size is 0"),
        (Remesh { size: Some(1.0), vertices: Some(9), ..Remesh::default() }, "not both"),
        (Remesh { vertices: Some(3), ..Remesh::default() }, "4 vertices at least"),
        (Remesh { tolerance: Some(f64::NAN), ..Remesh::default() }, "the tolerance is NaN"),
        (Remesh { feature_angle: 181.0, ..Remesh::default() }, "the feature angle is 181"),
        (Remesh { target_angle: Some(60.0), ..Remesh::default() }, "the target angle is 60"),
    ] {
        let error = remesh(&part, &wish, Progress::NONE).unwrap_err();
        assert!(
            matches!(error, PartError::BadOption(_)) && error.to_string().contains(words),
            "{error}"
        );
    }
    let mut triangles = part.triangles().to_vec();
    triangles.push([0, 7, 3]);
    triangles[0].swap(0, 1);
    let broken = TriMesh::new(part.positions().to_vec(), triangles).unwrap();
    let error = remesh(&broken, &Remesh::default(), Progress::NONE).unwrap_err();
    let PartError::NoSurface(faults) = &error else { panic!("{error}") };
    assert!(
        faults.faults.len() >= 3 && error.to_string().contains("3 triangles share an edge"),
        "{error}"
    );
}

#[test]
fn reflex_corners_of_a_boundary_have_five_edges_at_most() {
    // Flat: a letter L, and the head of an arrow.
    let letter = |corners: &[[f64; 2]], triangles: &[[u32; 3]]| {
        let points = corners.iter().map(|p| DVec3::new(p[0], p[1], 0.0)).collect();
        TriMesh::new(points, triangles.to_vec()).unwrap()
    };
    let l = letter(
        &[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]],
        &[[0, 1, 2], [0, 2, 3], [0, 3, 5], [3, 4, 5]],
    );
    let arrow = letter(&[[0.0, 0.0], [3.0, 1.0], [0.0, 2.0], [1.0, 1.0]], &[[0, 1, 3], [1, 2, 3]]);
    for (part, size) in [(l, 0.2), (arrow, 0.15)] {
        let wish = Remesh { size: Some(size), ..Remesh::default() };
        let found = remesh(&part, &wish, Progress::NONE).unwrap();
        assert!(found.reached.off_degree.is_empty(), "{:?}", found.reached.off_degree);
        assert!(found.verified.out_of_range.is_empty(), "{:?}", found.verified.defects);
    }
}
