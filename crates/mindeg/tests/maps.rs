//! Maps: regions that are holes.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::BTreeSet;

use glam::{DVec2, DVec3};
use mindeg::interior::{InteriorMesh, angle_limit, mesh};
use mindeg::{Domain, Interior, Progress, Size, SizeAt, Triangles};

fn meshed(text: &str) -> (Domain, InteriorMesh) {
    let domain = Domain::from_json(text).unwrap();
    let wanted = domain.interior().cloned().unwrap_or_default();
    let found = mesh(&domain, &wanted, Progress::NONE).unwrap();
    (domain, found)
}

/// The area of the triangles, all of which are counter-clockwise.
fn area(found: &InteriorMesh) -> f64 {
    let at = |v: u32| found.mesh.positions()[v as usize].truncate();
    let of = |[a, b, c]: [u32; 3]| (at(b) - at(a)).perp_dot(at(c) - at(a)) / 2.0;
    let areas: Vec<f64> = found.mesh.triangles().iter().copied().map(of).collect();
    assert!(areas.iter().all(|area| *area > 0.0));
    areas.iter().sum()
}

/// The number of fans of the triangles at a point.
fn fans(found: &InteriorMesh, at: [f64; 2]) -> usize {
    let at = DVec2::from(at).extend(0.0);
    let vertex = found.mesh.positions().iter().position(|point| *point == at).unwrap() as u32;
    let mut ends = [BTreeSet::new(), BTreeSet::new()];
    for triangle in found.mesh.triangles() {
        if let Some(corner) = triangle.iter().position(|&v| v == vertex) {
            ends[0].insert(triangle[(corner + 1) % 3]);
            ends[1].insert(triangle[(corner + 2) % 3]);
        }
    }
    ends[0].difference(&ends[1]).count()
}

/// Every edge of the boundary and its lines is an edge of the mesh.
fn has_all_edges(domain: &Domain, found: &InteriorMesh) {
    let edges: BTreeSet<[u32; 2]> = found
        .mesh
        .triangles()
        .iter()
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
        .flat_map(|[a, b]| [[a, b], [b, a]])
        .collect();
    let boundary = domain.boundary().unwrap();
    for edge in boundary.edges().chain(boundary.segments().iter().copied()) {
        assert!(edges.contains(&edge), "{edge:?}");
    }
}

/// A hole that touches a corner of the outline and another hole, which has a border with a region around an island.
const TOUCHING: &str = r#"{"rectangle": {"width": 8, "height": 8}, "size": 0.5, "lines": [
    {"corners": [[0, 0], [3, 1], [4, 4], [1, 3]], "closed": true, "intervals": 6, "name": "lake"},
    {"corners": [[4, 4], [6, 5], [6, 7]], "intervals": 4},
    {"corners": [[4, 4], [4, 6], [6, 7]], "intervals": 4},
    {"corners": [[4, 4], [5, 5], [6, 7]], "intervals": 5, "name": "strand"},
    {"corners": [[4, 4], [8, 4]], "intervals": 8, "name": "border"},
    {"corners": [[4, 4], [4, 2]], "intervals": 4, "name": "pier"}],
    "regions": [{"at": [2, 2], "hole": true}, {"at": [4.3, 5], "hole": true},
        {"at": [7, 7], "name": "land"}, {"at": [5.5, 5.2], "name": "spit"}]}"#;

#[test]
fn holes_may_touch_the_outline_and_each_other() {
    let (domain, found) = meshed(TOUCHING);
    has_all_edges(&domain, &found);
    // Without the lake of 8 and the hole between strand and shore.
    let hole = [[4.0, 4.0], [5.0, 5.0], [6.0, 7.0], [4.0, 6.0]].map(DVec2::from);
    let hole: f64 = (0..4).map(|i| hole[i].perp_dot(hole[(i + 1) % 4])).sum::<f64>() / 2.0;
    assert!((area(&found) - (64.0 - 8.0 - hole)).abs() < 1e-9, "{}", area(&found));
    assert_eq!(fans(&found, [0.0, 0.0]), 2);
    assert_eq!(fans(&found, [4.0, 4.0]), 2);
    assert_eq!(fans(&found, [6.0, 7.0]), 1);
    assert!(found.report.violations.is_empty(), "{:?}", found.report.violations);
    // Vertices are those of the domain: the boundary, then what lies inside.
    let boundary = domain.boundary().unwrap();
    let given: Vec<DVec3> =
        boundary.points().iter().chain(boundary.inner_points()).map(|p| p.extend(0.0)).collect();
    assert_eq!(found.mesh.positions()[..given.len()], given[..]);
    let groups: Vec<&str> = found.mesh.groups().iter().map(|group| &*group.name).collect();
    assert_eq!(groups, ["land", "spit", "region 5"]);
    let lake = found.mesh.lines().iter().find(|line| line.name == "lake").cloned().unwrap();
    assert_eq!(lake.segments.len(), 24);
}

/// Two lakes that touch at two points have an island between them, which shares these points with the shore.
#[test]
fn holes_may_cut_the_domain_in_two() {
    let (domain, found) = meshed(
        r#"{"rectangle": {"width": 8, "height": 8}, "size": 0.5, "points": [{"at": [4, 4.1], "name": "well"}], "lines": [
            {"corners": [[4, 2], [5, 4], [4, 6]], "intervals": 4}, {"corners": [[4, 2], [7, 4], [4, 6]], "intervals": 6},
            {"corners": [[4, 2], [3, 4], [4, 6]], "intervals": 4}, {"corners": [[4, 2], [1, 4], [4, 6]], "intervals": 6}],
            "regions": [{"at": [6, 4], "hole": true}, {"at": [2, 4], "hole": true}, {"at": [4, 4], "name": "island"}]}"#,
    );
    has_all_edges(&domain, &found);
    assert!((area(&found) - (64.0 - 8.0)).abs() < 1e-9, "{}", area(&found));
    assert_eq!((fans(&found, [4.0, 2.0]), fans(&found, [4.0, 6.0])), (2, 2));
    let groups: Vec<&str> = found.mesh.groups().iter().map(|group| &*group.name).collect();
    assert_eq!(groups, ["island", "region 4"]);
    assert_eq!(found.report.violations, []);
    assert!(found.report.local.worst > 0.8, "{:?}", found.report.local);
}

#[test]
fn the_limit_at_a_hole_of_lines_names_the_line() {
    let domain = Domain::from_json(
        r#"{"rectangle": {"width": 8, "height": 8}, "size": 1, "lines": [
            {"corners": [[2, 2], [4, 2], [4, 4], [2, 4]], "closed": true, "sides": [
                {"intervals": 20}, {"intervals": 1}, {"intervals": 1}, {"intervals": 1}], "name": "duct"}],
            "regions": [{"at": [3, 3], "hole": true}]}"#,
    )
    .unwrap();
    let limit = angle_limit(&domain, &Interior::default()).unwrap();
    let cause = limit.cause.to_string();
    assert!(cause.contains("on duct, where intervals of "), "{cause}");
    let wanted = Interior {
        sizes: vec![Size::At(SizeAt { at: [4.5, 3.0].into(), size: 0.5 })],
        ..Interior::default()
    };
    let coarse = mesh(&domain, &wanted, Progress::NONE).unwrap().coarse_sides;
    assert!(coarse.iter().any(|side| side.name == "duct"), "{coarse:?}");
}

#[test]
fn holes_without_a_region_beside_them_are_refused_with_the_place() {
    let of = |rest: &str| {
        let text = format!(r#"{{"rectangle": {{"width": 4, "height": 2}}, "size": 1, {rest}}}"#);
        let error = Domain::from_json(&text).unwrap_err();
        format!("{}: {}", error.path, error.message)
    };
    #[rustfmt::skip]
    let table = [
        (r#""lines": [{"corners": [[1, 0], [1, 2]]}], "regions": [{"at": [0.5, 1], "hole": true}]"#, "regions[0].at: region 1 at (0.5, 1.0) is a hole, and edge 1 has no region on either side; draw the outline around the hole"),
        (r#""lines": [{"corners": [[1, 0.5], [3, 0.5], [2, 1.5]], "closed": true}, {"corners": [[1.8, 0.8], [2, 1]]}], "regions": [{"at": [2, 0.7], "hole": true}]"#, "regions[0].at: region 1 at (2.0, 0.7) is a hole, and edge 1 of line 2 has no region on either side; drop this edge, or make one of its sides a region"),
        (r#""holes": [{"ring": [[1.9, 0.7], [2, 0.8], [2.1, 0.7]]}], "lines": [{"corners": [[1, 0.5], [3, 0.5], [2, 1.5]], "closed": true}], "regions": [{"at": [2, 0.6], "hole": true}]"#, "regions[0].at: region 1 at (2.0, 0.6) is a hole, and edge 1 of hole 1 has no region on either side; drop the inner one of the two holes"),
        (r#""points": [{"at": [2, 0.9]}], "lines": [{"corners": [[1, 0.5], [3, 0.5], [2, 1.5]], "closed": true}], "regions": [{"at": [2, 0.6], "hole": true}]"#, "regions[0].at: region 1 at (2.0, 0.6) is a hole around point 1; move the point, or drop it"),
        (r#""regions": [{"at": [2, 0.6], "hole": true, "name": "well"}]"#, "regions[0].name: region 1 is a hole, which has no triangles; drop its name"),
    ];
    for (rest, expected) in table {
        assert_eq!(of(rest), expected, "{rest}");
    }
}

/// All edges at a point count, on either side of a hole that touches it.
#[test]
fn sectors_share_the_degree_limit_of_their_vertex() {
    let with = |limit: u32| {
        let text = format!(
            r#"{{"polygon": {{"corners": [[4, 4], [4, 0], [8, 0], [8, 8], [0, 8], [0, 4]]}}, "size": 0.5,
                "lines": [{{"corners": [[4, 4], [6, 5.5], [5.5, 6]], "closed": true, "intervals": 6}}],
                "regions": [{{"at": [5, 5], "hole": true}}], "vertices": [{{"vertex": 0, "max_degree": {limit}}}]}}"#
        );
        mesh(&Domain::from_json(&text).unwrap(), &Interior::default(), Progress::NONE)
    };
    for limit in [4, 5, 6] {
        let found = with(limit).unwrap();
        assert!(found.report.violations.is_empty(), "{:?}", found.report.violations);
        assert_eq!(found.mesh.degrees()[0], limit);
    }
    let refused = with(3).unwrap_err().to_string();
    assert_eq!(refused, "vertex 0 has a degree limit of 3; its boundary edges alone are 4");
}

/// Sizes of regions and near lines beside holes.
#[test]
fn sizes_hold_beside_holes() {
    let counts = |text: &str| {
        let found = meshed(text).1.mesh;
        let count = |name: &str| {
            let group = found.groups().iter().find(|group| group.name == name).unwrap();
            group.triangles.len()
        };
        [count("land"), count("spit")]
    };
    let [land, spit] = counts(TOUCHING);
    let [finer, same] = counts(&TOUCHING.replace(r#""land""#, r#""land", "size": 0.2"#));
    assert!(finer > 2 * land && same < 2 * spit, "{finer} {land} {same} {spit}");
    let near = r#"{"interior": {"sizes": [{"from": ["lake"], "size": 0.2}]}, "#;
    let coarse = meshed(&TOUCHING.replacen('{', near, 1)).1.coarse_sides;
    assert_eq!(coarse[0].name, "lake", "{coarse:?}");
}
