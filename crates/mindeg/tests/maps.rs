//! Maps: regions that are holes, and the check of meshes.

use std::collections::BTreeSet;

use glam::{DVec2, DVec3};
use mindeg::interior::{self, InteriorMesh, angle_limit, mesh};
use mindeg::{Domain, Group, Interior, Progress, Size, SizeAt, TriMesh, Triangles, verify};

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
        (r#""lines": [{"corners": [[1, 0], [1, 2]]}], "regions": [{"at": [0.5, 1], "hole": true}]"#, "regions[0].at: region 1 at (0.5, 1) is a hole, and edge 1 has no region on either side; draw the outline around the hole"),
        (r#""lines": [{"corners": [[1, 0.5], [3, 0.5], [2, 1.5]], "closed": true}, {"corners": [[1.8, 0.8], [2, 1]]}], "regions": [{"at": [2, 0.7], "hole": true}]"#, "regions[0].at: region 1 at (2, 0.7) is a hole, and edge 1 of line 2 has no region on either side; drop this edge, or make one of its sides a region"),
        (r#""holes": [{"ring": [[1.9, 0.7], [2, 0.8], [2.1, 0.7]]}], "lines": [{"corners": [[1, 0.5], [3, 0.5], [2, 1.5]], "closed": true}], "regions": [{"at": [2, 0.6], "hole": true}]"#, "regions[0].at: region 1 at (2, 0.6) is a hole, and edge 1 of hole 1 has no region on either side; drop the inner one of the two holes"),
        (r#""points": [{"at": [2, 0.9]}], "lines": [{"corners": [[1, 0.5], [3, 0.5], [2, 1.5]], "closed": true}], "regions": [{"at": [2, 0.6], "hole": true}]"#, "regions[0].at: region 1 at (2, 0.6) is a hole around point 1; move the point, or drop it"),
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
/// The engine counts the sectors of a vertex apart: the report told degree 5, proven, of a mesh with a vertex of 6 edges.
#[test]
fn the_degree_where_holes_touch_is_that_of_all_sectors() {
    // Two lines in each sector make them four edges each.
    let (domain, found) = meshed(
        r#"{"polygon": {"corners": [[0, 0], [4, 0], [8, 0], [8, 8], [0, 8]]}, "size": 1,
            "lines": [{"corners": [[4, 0], [5, 3], [3, 3]], "closed": true},
                      {"corners": [[4, 0], [1, 1]]}, {"corners": [[4, 0], [2, 3]]},
                      {"corners": [[4, 0], [6, 3]]}, {"corners": [[4, 0], [7, 1]]}],
            "regions": [{"at": [4, 2], "hole": true}]}"#,
    );
    let degrees = found.mesh.degrees();
    let place = DVec3::new(4.0, 0.0, 0.0);
    let at = found.mesh.positions().iter().position(|at| *at == place).unwrap();
    assert!(degrees[at] >= 8, "{}", degrees[at]);
    assert!(at < domain.rings().vertex_count() as usize);
    assert!(*found.report.boundary_degree.end() >= degrees[at], "{:?}", found.report);
}

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

/// The kind of defect that a mesh has on a domain.
fn defect(domain: &Domain, mesh: &TriMesh) -> String {
    let found = verify::triangulation(mesh, domain, None);
    found.map_or_else(|defect| defect.kind.to_owned(), |_| "none".to_owned())
}

/// The mesh with other triangles and groups.
fn changed(mesh: &TriMesh, change: impl Fn(usize, [u32; 3]) -> Vec<[u32; 3]>) -> TriMesh {
    let mut triangles = Vec::new();
    let mut groups = Vec::new();
    for group in mesh.groups() {
        let start = triangles.len() as u32;
        for t in group.triangles.clone() {
            triangles.extend(change(t as usize, mesh.triangles()[t as usize]));
        }
        groups.push(Group { triangles: start..triangles.len() as u32, ..group.clone() });
    }
    TriMesh::new(mesh.positions().to_vec(), triangles).unwrap().with_groups(groups)
}

#[test]
fn meshes_of_maps_are_verified_with_holes_lines_and_groups() {
    let (domain, found) = meshed(TOUCHING);
    let mesh = found.mesh;
    let verified = verify::triangulation(&mesh, &domain, None).unwrap();
    let inside = domain.border().unwrap().boundary.inner_points().len();
    assert_eq!(verified.interior_points, found.report.interior_points - inside);
    assert_eq!((&verified.out_of_range[..], &verified.certified[..]), (&[][..], &[][..]));
    let (triangles, groups) = (mesh.triangles(), mesh.groups());
    // The first two triangles on both sides of an edge: of the pier, and of none.
    let across = |edge: [u32; 2]| {
        let has = |ends: [u32; 2]| {
            triangles.iter().position(|&[a, b, c]| [[a, b], [b, c], [c, a]].contains(&ends))
        };
        Some([has(edge)?, has([edge[1], edge[0]])?])
    };
    let flipped = |edge: [u32; 2]| {
        let pair = across(edge).unwrap();
        let far = pair.map(|t| *triangles[t].iter().find(|v| !edge.contains(v)).unwrap());
        changed(&mesh, |t, own| match pair.iter().position(|at| *at == t) {
            Some(0) => vec![[far[0], edge[0], far[1]]],
            Some(_) => vec![[far[0], far[1], edge[1]]],
            None => vec![own],
        })
    };
    let boundary = domain.boundary().unwrap();
    let pier = boundary.line(5)[1];
    assert_eq!(defect(&domain, &flipped(pier)), "missing_edge");
    // A triangle less beside the lake, and one more in it.
    let lake = boundary.line(0);
    let beside = |edge: [u32; 2]| {
        let is_own = |&[a, b, c]: &[u32; 3]| [[a, b], [b, c], [c, a]].contains(&edge);
        triangles.iter().position(is_own)
    };
    let [edge, next] = [lake[2], lake[3]];
    let (edge, own) = match beside(edge) {
        Some(t) => (edge, t),
        None => ([edge[1], edge[0]], beside([edge[1], edge[0]]).unwrap()),
    };
    let less = changed(&mesh, |t, own_triangle| if t == own { vec![] } else { vec![own_triangle] });
    assert_eq!(defect(&domain, &less), "missing_edge");
    let third = next[1];
    let more = changed(&mesh, |t, given| match t == own {
        true => vec![given, [edge[1], edge[0], third]],
        false => vec![given],
    });
    assert_ne!(defect(&domain, &more), "none");
    // Groups: one triangle in another, two regions swapped.
    let end = groups[0].triangles.end;
    let mut other = groups.to_vec();
    (other[0].triangles.end, other[1].triangles.start) = (end - 1, end - 1);
    assert_eq!(defect(&domain, &mesh.clone().with_groups(other)), "group");
    let mut swapped = groups.to_vec();
    (swapped[0].name, swapped[1].name) = (groups[1].name.clone(), groups[0].name.clone());
    assert_eq!(defect(&domain, &mesh.clone().with_groups(swapped)), "group");
    // Files without groups have one.
    let one = Group::new("mesh", 0..triangles.len() as u32);
    assert_eq!(defect(&domain, &mesh.clone().with_groups(vec![one])), "none");
    // A region without triangles.
    let spit = groups[1].triangles.clone();
    let empty = changed(&mesh, |t, own| match spit.contains(&(t as u32)) {
        true => vec![],
        false => vec![own],
    });
    assert_ne!(defect(&domain, &empty), "none");
    // The same domain without the hole has an empty place too many; its own mesh covers the hole.
    let filled = Domain::from_json(&TOUCHING.replace(r#"{"at": [2, 2], "hole": true}, "#, ""));
    let filled = filled.unwrap();
    assert_eq!(defect(&filled, &mesh), "empty_region");
    let covering = interior::mesh(&filled, &Interior::default(), Progress::NONE).unwrap().mesh;
    assert_eq!(defect(&filled, &covering), "none");
    assert_eq!(defect(&domain, &covering), "filled_hole");
}

/// Nine lines meet at a point: no mesh has less than nine edges there. A tenth vertex out of range is no excuse.
#[test]
fn degrees_that_lines_alone_exceed_are_certified() {
    let spoke = |i: u32| {
        let end = DVec2::from_angle(f64::from(i) * std::f64::consts::TAU / 9.0) * 3.0;
        format!(r#"{{"corners": [[4, 4], [{}, {}]], "intervals": 4}}"#, end.x + 4.0, end.y + 4.0)
    };
    let spokes: Vec<String> = (0..9).map(spoke).collect();
    let text = format!(
        r#"{{"rectangle": {{"width": 8, "height": 8}}, "size": 1, "lines": [{}]}}"#,
        spokes.join(", ")
    );
    let (domain, found) = meshed(&text);
    let verified = verify::triangulation(&found.mesh, &domain, None).unwrap();
    assert_eq!(verified.points[verified.certified[0] as usize], DVec2::splat(4.0));
    let own: Vec<u32> = found.report.certified.iter().map(|own| own.vertex).collect();
    let certified = verified.certified.iter().map(|point| verified.vertex_of[*point as usize]);
    assert_eq!(certified.collect::<Vec<_>>(), own);
    let broken: Vec<u32> = found.report.violations.iter().map(|own| own.vertex).collect();
    let range = verified.out_of_range.iter().map(|point| verified.vertex_of[*point as usize]);
    assert_eq!(range.collect::<Vec<_>>(), broken);
}

/// Four kites meet at a point, and no edge cuts off a corner there: their sides alone are four edges, and each kite adds one.
#[test]
fn degrees_that_the_regions_exceed_together_are_proven_and_checked() {
    let text = |side: f64, size: f64| {
        let line = |end: [i32; 2]| format!(r#"{{"points": [[0, 0], {end:?}]}}"#);
        let lines: Vec<String> = [[1, 0], [0, 1], [-1, 0], [0, -1]].map(line).to_vec();
        let (a, b) = (side, -side);
        let corners =
            format!("[1,0], [{a},{a}], [0,1], [{b},{a}], [-1,0], [{b},{b}], [0,-1], [{a},{b}]");
        let domain = format!(r#"{{"polygon": {{"corners": [{corners}]}}, "size": {size}"#);
        format!(r#"{domain}, "lines": [{}]}}"#, lines.join(", "))
    };
    for (side, size, count) in [(0.4, 0.4, 1), (0.9, 3.0, 0)] {
        let (domain, found) = meshed(&text(side, size));
        let report = &found.report;
        let verified = verify::triangulation(&found.mesh, &domain, None).unwrap();
        assert_eq!((report.certified.len(), verified.certified.len()), (0, 0));
        let own: Vec<u32> = report.together.iter().flat_map(|own| own.vertices.clone()).collect();
        let checked: Vec<u32> =
            verified.together.iter().map(|own| verified.vertex_of[own.0 as usize]).collect();
        assert_eq!((own.len(), &own), (count, &checked), "{side}");
        assert_eq!(report.violations.iter().filter(|own| own.at == DVec2::ZERO).count(), count);
        let shares = report.together.iter().map(|own| own.share);
        assert!(shares.eq(verified.together.iter().map(|own| own.1)));
    }
}

/// A spoke of the fan at one corner ended on the border between two regions, which was missing in the mesh.
#[test]
fn borders_of_one_long_edge_stay_whole() {
    for lake in [[3, 3, 6, 9], [6, 3, 9, 6], [3, 3, 6, 6]] {
        let [left, bottom, right, top] = lake;
        for width in [15, 20] {
            let (domain, found) = meshed(&format!(
                r#"{{"ring": [[0, 0], [10, 0], [{width}, 0], [{width}, 10], [10, 10], [0, 10]],
                    "lines": [{{"corners": [[10, 0], [10, 10]], "intervals": 1}},
                        {{"corners": [[{left}, {bottom}], [{right}, {bottom}], [{right}, {top}], [{left}, {top}]],
                        "closed": true, "intervals": 1}}]}}"#
            ));
            has_all_edges(&domain, &found);
            let all = f64::from(10 * width);
            assert!((area(&found) - all).abs() < 1e-9, "{lake:?}, {width}");
        }
    }
}
