//! Remeshes of small parts: what they keep, and what is refused.

#![cfg(feature = "interior")]

use mindeg::glam::DVec3;
use mindeg::remesh::{PartError, Remesh, remesh};
use mindeg::{Bounds, Group, Positions, Progress, TriMesh, Triangles};

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

/// Where the shortest chains of operations that mend a degree move the surface too far, longer ones do not, or those of
/// shorter edges.
#[test]
fn bent_blocks_have_no_vertex_with_another_degree() {
    let blocks = [
        (&include_bytes!("bent-blocks-1.off")[..], 0.214),
        (&include_bytes!("bent-blocks-2.off")[..], 0.287),
    ];
    for (text, size) in blocks {
        let part = mindeg_formats::off::read(text).unwrap();
        let bounds = Bounds::of_space(part.positions().iter().copied()).unwrap();
        let tolerance = Some(0.01 * bounds.size().length());
        let wish = Remesh { size: Some(size), tolerance, ..Remesh::default() };
        let found = remesh(&part, &wish, Progress::NONE).unwrap();
        assert_eq!(found.defects().count(), 0);
        assert_eq!(found.verified.out_of_range, []);
        // Seven curves leave no other choice.
        assert!(found.verified.proven.iter().all(|proven| proven.sectors.len() == 7));
    }
}

/// A ball of few triangles, the middles of whose edges are far inside: edges shorten until the surfaces are near.
#[test]
fn without_wishes_surfaces_are_near() {
    let ball = |rings: u32| {
        let around = 2 * rings;
        let at = |ring: u32, turn: u32| {
            let [polar, turn] =
                [f64::from(ring) / f64::from(rings), f64::from(2 * turn) / f64::from(around)]
                    .map(|share| share * std::f64::consts::PI);
            DVec3::new(polar.sin() * turn.cos(), polar.sin() * turn.sin(), polar.cos())
        };
        let mut points = vec![DVec3::Z, DVec3::NEG_Z];
        points.extend((1..rings).flat_map(|ring| (0..around).map(move |turn| at(ring, turn))));
        let index = |ring: u32, turn: u32| match ring {
            0 => 0,
            ring if ring == rings => 1,
            ring => 2 + (ring - 1) * around + turn % around,
        };
        let quads = (0..rings).flat_map(|ring| (0..around).map(move |turn| (ring, turn)));
        let triangles = quads.flat_map(|(ring, turn)| {
            let [a, b] = [turn, turn + 1].map(|turn| index(ring, turn));
            let [c, d] = [turn, turn + 1].map(|turn| index(ring + 1, turn));
            [[a, c, d], [a, d, b]].into_iter().filter(|[x, y, z]| x != y && y != z && z != x)
        });
        let triangles = triangles.collect();
        TriMesh::new(points, triangles).unwrap()
    };
    let part = ball(16);
    let diagonal = 2.0 * 3.0_f64.sqrt();
    let found = remesh(&part, &Remesh::default(), Progress::NONE).unwrap();
    assert_eq!(found.reached.off_degree, []);
    assert!(found.distance() < 0.003 * diagonal, "{}", found.distance());
    // A size is what is wanted then.
    let wish = Remesh { size: Some(0.25), ..Remesh::default() };
    let found = remesh(&part, &wish, Progress::NONE).unwrap();
    assert!(found.distance() > 0.003 * diagonal, "{}", found.distance());
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
