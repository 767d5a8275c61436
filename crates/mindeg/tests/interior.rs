//! Meshes with interior points through the library.
#![cfg(feature = "interior")]

use glam::DVec3;
use mindeg::glam;
use mindeg::interior::{improve, mesh};
use mindeg::{
    Domain, Goal, Group, InnerPoint, Inside, Interior, Positions, Progress, Ring, Side, TriMesh,
    Triangles,
};
use proptest::prelude::*;

fn rectangle(counts: [u64; 4]) -> Domain {
    Domain::rectangle(4.0, 3.0, counts.map(Side::count).into()).unwrap()
}

/// A grid of cells of 1 by 1, each cut in two, with its inner vertices moved.
fn grid(cells: u32, moved: f64, place: impl Fn(f64, f64) -> DVec3) -> TriMesh {
    let across = cells + 1;
    let point = |v: u32| {
        let (i, j) = (v % across, v / across);
        let is_inner = i % cells != 0 && j % cells != 0;
        let shift = if is_inner { moved * f64::from(v * 7919 % 13) / 13.0 } else { 0.0 };
        place(f64::from(i) + shift, f64::from(j) + shift * 0.7)
    };
    let points = (0..across * across).map(point).collect();
    let triangles = (0..cells * cells)
        .map(|cell| cell / cells * across + cell % cells)
        .flat_map(|v| [[v, v + 1, v + across], [v + 1, v + across + 1, v + across]])
        .collect();
    TriMesh::new(points, triangles).unwrap()
}

#[test]
fn the_boundary_comes_first_bit_for_bit_with_its_sides() {
    let domain = rectangle([12, 9, 4, 4]);
    let found = mesh(&domain, &Interior::default(), Progress::NONE).unwrap();
    let boundary: Vec<DVec3> = domain.placement().points().map(|p| p.extend(0.0)).collect();
    assert_eq!(found.mesh.positions()[..29], boundary[..]);
    assert_eq!(found.mesh.boundary_loops()[0].vertices, (0..29).collect::<Vec<_>>());
    let names: Vec<_> = found.mesh.lines().iter().map(|line| line.name.clone()).collect();
    assert_eq!(names, ["side 1", "side 2", "side 3", "side 4"]);
    assert_eq!(found.report.violations, []);
}

#[test]
fn lines_inside_are_lines_of_the_mesh() {
    let line = |corners: &[[f64; 2]]| {
        Ring::new(corners.iter().copied(), vec![Side::size(9.0); corners.len() - 1])
    };
    let inside = Inside {
        lines: vec![line(&[[0.0, 1.5], [2.0, 1.0], [4.0, 1.5]]), line(&[[2.0, 1.0], [2.0, 2.2]])],
        points: vec![InnerPoint { at: [3.0, 2.5].into(), ..InnerPoint::default() }],
        regions: Vec::new(),
    };
    let domain = rectangle([16, 12, 16, 12]).with_inside(inside).unwrap();
    let found = mesh(&domain, &Interior::default(), Progress::NONE).unwrap();
    let lines = found.mesh.lines();
    assert_eq!(lines[4].name, "line 1");
    assert_eq!(lines[5].name, "line 2");
    let point = |v: u32| found.mesh.positions()[v as usize].truncate();
    for (line, ends, length) in [
        (&lines[4], [[0.0, 1.5], [4.0, 1.5]], 2.0 * 2_f64.hypot(0.5)),
        (&lines[5], [[2.0, 1.0], [2.0, 2.2]], 1.2),
    ] {
        let pieces =
            &found.mesh.segments()[line.segments.start as usize..line.segments.end as usize];
        assert!(pieces.len() > 2 && pieces.windows(2).all(|pair| pair[0][1] == pair[1][0]));
        assert_eq!([point(pieces[0][0]), point(pieces[pieces.len() - 1][1])], ends.map(Into::into));
        let sum: f64 = pieces.iter().map(|[a, b]| point(*a).distance(point(*b))).sum();
        assert!((sum - length).abs() < 1e-12);
    }
    assert_eq!(found.mesh.positions()[56], DVec3::new(3.0, 2.5, 0.0));
    // The first line divides the domain.
    let groups: Vec<&str> = found.mesh.groups().iter().map(|group| &*group.name).collect();
    assert_eq!(groups, ["region 1", "region 2"]);
}

/// A matrix with a fibre, beside steel: areas by region, and the fibre's edges as they were given.
#[test]
fn a_map_is_one_mesh_with_a_group_for_each_region() {
    let domain = Domain::from_json(
        r#"{"rectangle": {"width": 4, "height": 2}, "size": 0.25, "lines": [
            {"corners": [[2, 0], [2, 2]], "name": "interface"},
            {"corners": [[0.5, 0.5], [1.5, 0.5], [1.5, 1.5], [0.5, 1.5]], "closed": true, "intervals": 3}],
            "regions": [{"at": [0.1, 0.1], "name": "matrix"}, {"at": [1, 1], "name": "fibre"},
                {"at": [3, 1], "name": "beam", "material": "steel"}]}"#,
    );
    let domain = domain.unwrap();
    let found = mesh(&domain, &Interior::default(), Progress::NONE).unwrap().mesh;
    let at = |v: u32| found.positions()[v as usize].truncate();
    let area = |[a, b, c]: [u32; 3]| (at(b) - at(a)).perp_dot(at(c) - at(a)) / 2.0;
    for (group, (name, expected)) in
        found.groups().iter().zip([("matrix", 3.0), ("fibre", 1.0), ("beam", 4.0)])
    {
        let own = &found.triangles()[group.triangles.start as usize..group.triangles.end as usize];
        let sum: f64 = own.iter().copied().map(area).sum();
        assert!(group.name == name && (sum - expected).abs() < 1e-12, "{group:?} {sum}");
    }
    assert_eq!(found.groups()[2].label(), "beam");
    assert_eq!(found.groups()[2].material.as_ref().map(|own| &*own.name), Some("steel"));
    let line = found.lines()[5].clone();
    assert_eq!((&*line.name, line.segments.len()), ("line 2", 12));
}

#[test]
fn what_lies_inside_is_never_left_out_of_a_mesh_of_boundary_points() {
    let (line, point, steel) = (
        r#""lines": [{"corners": [[2, 0], [2, 2]]}]"#,
        r#""points": [{"at": [2, 1]}]"#,
        r#""regions": [{"at": [1, 1], "name": "steel"}]"#,
    );
    for (inside, vertices, group) in
        [(line, 13, Some("region 1")), (point, 13, None), (steel, 12, Some("steel"))]
    {
        let text = format!(r#"{{"rectangle": {{"width": 4, "height": 2}}, "size": 1, {inside}}}"#);
        let domain = Domain::from_json(&text).unwrap();
        let found = mindeg::mesh(&domain, Goal::LeastDegree, Progress::NONE).unwrap().mesh;
        let groups = found.groups();
        let name = groups.first().map(|group| &*group.name);
        assert_eq!((found.vertex_count(), name), (vertices, group), "{inside}");
        let corners: Vec<u32> = found.triangles().flatten().collect();
        assert!((0..vertices).all(|vertex| corners.contains(&vertex)), "{inside}");
    }
}

#[test]
fn degree_limits_of_vertices_are_kept_with_their_external_degrees() {
    use mindeg::{Constraints, Outline, Rectangle, VertexConstraint};
    let outline = Outline::Rectangle(Rectangle::new(4.0, 4.0));
    let sides = [8; 4].map(Side::count).to_vec();
    let tight = VertexConstraint { vertex: 4, external_degree: 2, degree_limit: Some(5) };
    let constraints = Constraints { vertices: vec![tight], ..Constraints::default() };
    let domain = Domain::builder(outline, sides).constraints(constraints).build().unwrap();
    let found = mesh(&domain, &Interior::default(), Progress::NONE).unwrap();
    // Five edges in all, two of them outside; four would be usual.
    assert_eq!(found.mesh.degrees()[4], 3, "{:?}", found.report);
    assert_eq!(found.report.violations, []);
}

#[test]
fn improving_works_in_any_plane_and_keeps_the_boundary() {
    let tilt = glam::DQuat::from_euler(glam::EulerRot::XYZ, 0.3, -1.1, 2.0);
    for place in [
        (&|x, y| DVec3::new(x, y, 0.0)) as &dyn Fn(f64, f64) -> DVec3,
        &|x, y| DVec3::new(y, x, 5.0),
        &|x, y| DVec3::new(x, 0.1, -y),
        &|x, y| DVec3::new(-1e3, -y, x),
        &|x, y| tilt * DVec3::new(x, y, 0.0) + DVec3::new(1.0, 20.0, 3.0),
    ] {
        let mesh = grid(8, 0.45, place);
        let found = improve(&mesh, &Interior::default(), Progress::NONE).unwrap();
        assert!(found.before.min_angle < 28.0);
        assert!(found.after.min_angle > 30.0, "{:?}", found.after);
        assert_eq!(found.after.violations, []);
        // Every boundary vertex is where it was, bit for bit.
        let boundary = |mesh: &TriMesh| -> Vec<DVec3> {
            let vertices = &mesh.boundary_loops()[0].vertices;
            vertices.iter().map(|v| mesh.positions()[*v as usize]).collect()
        };
        assert_eq!(boundary(&found.mesh), boundary(&mesh));
        // The area is what it was, and all faces the same way.
        let doubled = |mesh: &TriMesh| -> DVec3 {
            let corner = |v: u32| mesh.positions()[v as usize];
            let normal =
                |t: &[u32; 3]| (corner(t[1]) - corner(t[0])).cross(corner(t[2]) - corner(t[0]));
            mesh.triangles().iter().map(normal).sum()
        };
        assert!((doubled(&mesh) - doubled(&found.mesh)).length() < 1e-9 * 128.0);
    }
}

#[test]
fn improving_keeps_groups_and_lines() {
    let mesh = grid(6, 0.45, |x, y| DVec3::new(x, y, 0.0));
    let group = |name: &str, triangles| Group::new(name, triangles);
    let groups = vec![group("south", 0..24), group("north", 24..72)];
    let line = mindeg::Line { name: "wall".to_owned(), segments: 0..2, is_straight: false };
    // Along two inner edges of the group in the north.
    let mesh = mesh.with_groups(groups).with_lines(vec![line], vec![[30, 31], [31, 32]]).unwrap();
    let found = improve(&mesh, &Interior::default(), Progress::NONE).unwrap();
    assert_eq!(found.kept_edges, 6 + 2);
    assert!(found.after.min_angle >= found.before.min_angle);
    let area = |mesh: &TriMesh, group: usize| -> f64 {
        let range = &mesh.groups()[group].triangles;
        let corner = |v: u32| mesh.positions()[v as usize].truncate();
        mesh.triangles()[range.start as usize..range.end as usize]
            .iter()
            .map(|t| (corner(t[1]) - corner(t[0])).perp_dot(corner(t[2]) - corner(t[0])))
            .sum()
    };
    for group in [0, 1] {
        assert_eq!(found.mesh.groups()[group].name, mesh.groups()[group].name);
        assert!((area(&found.mesh, group) - area(&mesh, group)).abs() < 1e-9);
    }
    let ends = |mesh: &TriMesh| -> Vec<DVec3> {
        mesh.segments().as_flattened().iter().map(|v| mesh.positions()[*v as usize]).collect()
    };
    assert_eq!(ends(&found.mesh), ends(&mesh));
    let edges: Vec<[u32; 2]> = found
        .mesh
        .triangles()
        .iter()
        .flat_map(|[a, b, c]| [[*a, *b], [*b, *c], [*c, *a]])
        .collect();
    assert!(found.mesh.segments().iter().all(|segment| edges.contains(segment)));
}

#[test]
fn repeated_vertices_are_merged() {
    // Each triangle with vertices of its own, as an STL has them.
    let mesh = grid(5, 0.45, |x, y| DVec3::new(x, y, 0.0));
    let points: Vec<DVec3> =
        mesh.triangles().as_flattened().iter().map(|v| mesh.positions()[*v as usize]).collect();
    let soup = (0..50).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
    let found = improve(&TriMesh::new(points, soup).unwrap(), &Interior::default(), Progress::NONE);
    let found = found.unwrap();
    assert_eq!(found.merged, 150 - 36);
    assert_eq!(found.mesh.boundary_loops()[0].vertices.len(), 20);
    assert!(found.after.min_angle > 30.0);
}

#[test]
fn meshes_that_are_not_planar_are_refused() {
    let refusal = |mesh: &TriMesh| improve(mesh, &Interior::default(), Progress::NONE).unwrap_err();
    let bent = grid(4, 0.0, |x, y| DVec3::new(x, y, if x > 3.5 { 1e-3 } else { 0.0 }));
    let error = refusal(&bent);
    assert!(error.to_string().contains("the mesh is not planar: vertex "), "{error}");
    let points = vec![DVec3::ZERO, DVec3::X, DVec3::Y];
    let both = TriMesh::new(points.clone(), vec![[0, 1, 2], [0, 2, 1]]).unwrap();
    assert!(
        refusal(&both).to_string().contains("parts of the mesh are turned over, or it has no area")
    );
    let line = TriMesh::new(vec![DVec3::ZERO, DVec3::X, DVec3::X * 2.0], vec![[0, 1, 2]]).unwrap();
    assert_eq!(refusal(&line), refusal(&both));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    /// On any number of threads the same bytes, with the boundary as it was.
    #[test]
    fn thread_counts_change_nothing(counts in prop::array::uniform4(1..14_u64), ratio in 0.7..1.4_f64) {
        let sides = counts.map(|count| {
            Side::count(count).spaced(mindeg::Spacing::Geometric { ratio })
        });
        let domain = Domain::polygon([[0.0, 0.0], [5.0, 0.5], [4.0, 4.0], [-1.0, 3.0]], sides.into());
        let domain = domain.unwrap();
        let run = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| mesh(&domain, &Interior::default(), Progress::NONE).unwrap())
        };
        let (one, three) = (run(1), run(3));
        prop_assert_eq!(&one.mesh, &three.mesh);
        let count = domain.placement().vertex_count();
        for (vertex, point) in (0..count).zip(domain.placement().points()) {
            let bits = |p: DVec3| p.to_array().map(f64::to_bits);
            prop_assert_eq!(bits(one.mesh.positions()[vertex as usize]), bits(point.extend(0.0)));
        }
        prop_assert!(one.mesh.vertex_count() >= count);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    /// The same where many places near each other are mended at once.
    #[test]
    fn places_are_mended_alike_on_any_number_of_threads(radii in prop::collection::vec(0.2..1.0_f64, 40..90)) {
        let turn = std::f64::consts::TAU / radii.len() as f64;
        let corners: Vec<[f64; 2]> = radii
            .iter()
            .enumerate()
            .map(|(i, radius)| [radius * libm::cos(i as f64 * turn), radius * libm::sin(i as f64 * turn)])
            .collect();
        let domain = Domain::polygon(corners, vec![Side::count(1); radii.len()]).unwrap();
        let run = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| mesh(&domain, &Interior::default(), Progress::NONE).unwrap())
        };
        prop_assert_eq!(&run(1).mesh, &run(4).mesh);
    }
}
