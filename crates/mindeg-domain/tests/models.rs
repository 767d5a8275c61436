//! Models: their contents, and the errors of bad ones.

use glam::DVec3;
use mindeg_domain::{FromMesh, Model, ModelPlace, Side, Spacing};
use mindeg_mesh::{Group, Polygons, TriMesh};

const CUBE: &str =
    r#""corners": [[0,0,0], [1,0,0], [1,1,0], [0,1,0], [0,0,1], [1,0,1], [1,1,1], [0,1,1]]"#;
const QUADS: [&str; 6] =
    ["[0,3,2,1]", "[4,5,6,7]", "[0,1,5,4]", "[1,2,6,5]", "[2,3,7,6]", "[3,0,4,7]"];

fn cube(quads: &[&str], rest: &str) -> String {
    format!("{{{CUBE}, \"faces\": [{}]{rest}}}", quads.join(", "))
}

#[track_caller]
fn refused(text: &str, message: &str) {
    let error = Model::from_json(text).unwrap_err().to_string();
    assert!(error.ends_with(message), "{error}");
}

#[test]
fn neighbours_share_the_points_of_an_edge() {
    let rest = r#", "size": 0.3, "edges": [
        {"corners": [1, 0], "spacing": {"geometric": {"ratio": 2}}, "intervals": 4, "name": "toe"}]"#;
    let model = Model::from_json(&cube(&QUADS, rest)).unwrap();
    assert_eq!((model.edge_count(), model.vertex_count()), (12, 8 + 3 + 11 * 2));
    assert_eq!(model.edge_name(0), Some("toe"));
    // From corner 0, where the longest interval is, since the edge is given from corner 1.
    let positions = model.positions();
    let toe: Vec<f64> = model.edge_vertices(0).map(|v| positions[v as usize].x).collect();
    let expected = [0.0, 8.0 / 15.0, 12.0 / 15.0, 14.0 / 15.0, 1.0];
    assert!(toe.iter().zip(expected).all(|(x, expected)| (x - expected).abs() < 1e-15), "{toe:?}");
    // The bottom passes the edge downwards, the front upwards.
    let (bottom, front) = (model.face_vertices(0), model.face_vertices(2));
    let upward: Vec<u32> = model.edge_vertices(0).collect();
    assert!(front.windows(5).any(|part| part == upward));
    let downward: Vec<u32> = upward.iter().rev().copied().collect();
    let twice = [&bottom[..], &bottom].concat();
    assert!(twice.windows(5).any(|part| part == downward));
    assert_eq!(model.place(8), ModelPlace::Edge { edge: 0, point: 1 });
    assert_eq!(model.place(3), ModelPlace::Corner(3));
    let sum: u32 = model.edge_degrees().iter().sum();
    assert_eq!(sum, 2 * (4 + 11 * 3));
}

#[test]
fn faces_are_counter_clockwise_in_their_planes() {
    // A slanted triangle with a hole that is given the wrong way round.
    let text = r#"{"corners": [[0,0,0], [9,0,0], [0,9,3], [2,2,0.6666666666666666],
                               [4,2,0.6666666666666666], [2,4,1.3333333333333333]],
                   "faces": [{"corners": [0,1,2], "holes": [[3,4,5]]}], "size": 1}"#;
    let model = Model::from_json(text).unwrap();
    let (_, boundary) = model.boundary(0, &model.positions()).unwrap();
    let points = boundary.points();
    let area = |ring: std::ops::Range<u32>| {
        let of = |i| boundary.point(i).perp_dot(boundary.point(boundary.next(i)));
        ring.map(of).sum::<f64>() / 2.0
    };
    let slope = 10.0_f64.sqrt() / 3.0;
    assert!((area(boundary.ring(0)) / (40.5 * slope) - 1.0).abs() < 1e-12);
    assert!((area(boundary.ring(1)) / (-2.0 * slope) - 1.0).abs() < 1e-12);
    assert_eq!(boundary.runs().iter().max(), Some(&5));
    assert_eq!(model.face_size(0) as usize, points.len());
}

#[test]
fn a_corner_on_a_line_makes_no_new_run() {
    let text = r#"{"corners": [[0,0,0], [2,0,0], [4,0,0], [4,3,0], [0,3,0]],
                   "faces": [[1,2,3,4,0]], "size": 1}"#;
    let model = Model::from_json(text).unwrap();
    let runs = |model: &Model| model.boundary(0, &model.positions()).unwrap().1.runs().to_vec();
    // From corner 1 on: 2 + 3 + 4 + 3 + 2 edges, the first and the last on one line.
    assert_eq!(runs(&model), [0, 0, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 0, 0]);
    // A turn is an angle, here of 45 degrees at corners 1 and 2: the unit of length does not matter.
    for unit in [1e-30, 1.0, 1e30] {
        let corner = |[x, y]: [f64; 2]| format!("[{:?},{:?},0]", x * unit, y * unit);
        let corners = [[0.0, 0.0], [1.0, 0.0], [2.0, 1.0], [2.0, 3.0], [0.0, 3.0]].map(corner);
        let size = 9.0 * unit;
        let text = format!(
            r#"{{"corners": [{}], "faces": [[1,2,3,4,0]], "size": {size:?}}}"#,
            corners.join(",")
        );
        assert_eq!(runs(&Model::from_json(&text).unwrap()), [0, 1, 2, 3, 4], "{unit}");
    }
}

#[test]
fn bad_faces_are_refused_with_a_reason() {
    let with = |extra: &str| {
        let mut quads = QUADS.to_vec();
        quads.push(extra);
        cube(&quads, ", \"size\": 0.5")
    };
    for (face, message) in [
        ("[3,2,1,0]", "faces 0 and 6 have the same corners; remove one of them"),
        ("[0,1,9]", "face 6 names corner 9; the model has corners 0 to 7"),
        ("[0,1]", "face 6 has a loop of 2 corners; a loop needs at least 3"),
        (
            "[0,1,2,3,1]",
            "face 6 goes from corner 1 to corner 0 and straight back; remove the spike",
        ),
        ("[0,1,2,1,3]", "and straight back; remove the spike"),
        ("[0,2,1,3]", "face 6 has no area; remove it or move its corners"),
        (
            "[0,1,6,3]",
            "off its plane, and the tolerance is 0.00001; cut the face in triangles, or raise the \
             tolerance",
        ),
    ] {
        refused(&with(face), message);
    }
    let flat = |corners: &str, face: &str| {
        format!("{{\"corners\": {corners}, \"faces\": [{face}], \"size\": 1}}")
    };
    let square = "[[0,0,0], [4,0,0], [4,4,0], [0,4,0], [8,1,0], [9,1,0], [9,2,0]]";
    for (corners, face, message) in [
        (
            "[[0,0,0], [4,0,0], [1,3,0], [4,3,0], [0,1,0]]",
            "[0,1,2,3,4]",
            "face 0 crosses itself: its edges 1-2 and 3-4 (by corners) meet",
        ),
        (
            "[[0,0,0], [4,0,0], [4,3,0], [2,0,0], [0,3,0]]",
            "[0,1,2,3,4]",
            "face 0 touches itself: corner 3 lies on its edge 0-1 (by corners)",
        ),
        (
            square,
            r#"{"corners": [0,1,2,3], "holes": [[4,5,6]]}"#,
            "hole 0 of face 0 is not inside the face's outer loop",
        ),
        (
            "[[0,0,0], [4,0,0], [4,4,0], [4,4,0]]",
            "[0,1,2,3]",
            "corners 2 and 3 of an edge are at the same place; merge them or move one",
        ),
        (
            "[[0,0,0], [4,0,0], [4,4]]",
            "[0,1,2]",
            "corners[2]: found a list of 2 values, expected a triple [x, y, z] of numbers",
        ),
        (
            square,
            r#"{"corners": [0,1,2,3], "group": " "}"#,
            "the name of the group of face 0 is blank; give it a letter or leave it out",
        ),
    ] {
        refused(&flat(corners, face), message);
    }
}

#[test]
fn bad_divisions_are_refused_with_a_reason() {
    let edges = |edges: &str| cube(&QUADS, &format!(", \"size\": 0.5, \"edges\": [{edges}]"));
    for (given, message) in [
        (
            r#"{"corners": [0,1], "intervals": 3}, {"corners": [1,0], "intervals": 4}"#,
            "edges[1]: the edge from corner 0 to corner 1 has 3 intervals in one place and 4 in \
             another; give it one count",
        ),
        (
            r#"{"corners": [0,1], "intervals": 3}, {"corners": [1,0], "intervals": 3}"#,
            "edges[1]: the edge from corner 0 to corner 1 is given twice; give it once",
        ),
        (
            r#"{"corners": [0,6], "intervals": 3}"#,
            "edges[0]: edge 0 joins corners 0 and 6, but no face has such an edge",
        ),
        (
            r#"{"corners": [0,1], "intervals": 0}"#,
            "edges[0]: the edge from corner 0 to corner 1 has 0 intervals; the minimum is 1",
        ),
    ] {
        refused(&edges(given), message);
    }
    refused(
        &cube(&QUADS, ""),
        "the edge from corner 0 to corner 1 has no interval count; give \"size\" for all edges, or \
         an entry in \"edges\"",
    );
    refused(
        r#"{"corners": [], "faces": [], "size": 1}"#,
        "faces: the model has no face; give each face as a loop of corners",
    );
}

#[test]
fn what_is_odd_is_noted() {
    let notes = |quads: &[&str]| {
        Model::from_json(&cube(quads, ", \"size\": 0.5")).unwrap().notes().to_vec()
    };
    assert!(notes(&QUADS).is_empty());
    assert_eq!(
        notes(&QUADS[..5]),
        ["The model is open: 4 edges have one face: 0-3, 0-4, 3-7, 4-7 (by corners)."]
    );
    let mut flipped = QUADS;
    flipped[5] = "[7,4,0,3]";
    assert_eq!(
        notes(&flipped),
        ["Flipped: face 0 and face 5 run along their common edge in the same direction; turn one \
          of them round. 4 such edges: 0-3, 0-4, 3-7, 4-7 (by corners)."]
    );
    let mut fin = QUADS.to_vec();
    fin.push("[0,1,6,7]");
    assert_eq!(
        notes(&fin),
        [
            "The model is open: 2 edges have one face: 0-7, 1-6 (by corners).",
            "2 edges have three faces or more: 0-1, 6-7 (by corners)."
        ]
    );
    let bent = cube(&QUADS, ", \"size\": 0.5").replace("[1,1,1]", "[1,1,1.000001]");
    let bent = Model::from_json(&bent).unwrap();
    let [note] = bent.notes() else { panic!("one note") };
    assert!(note.starts_with("1 face is not quite planar: corners are up to 2.5e-7 off (face 1)"));
    assert!(note.ends_with("within the tolerance of 0.00001."), "{note}");
}

fn with(merge_coplanar: bool) -> FromMesh {
    FromMesh { edges: Side::count(2), merge_coplanar, planar_tolerance: None }
}

#[test]
fn a_polygon_with_a_bridge_has_a_hole() {
    let corners = [[0, 0], [6, 0], [6, 6], [0, 6], [2, 2], [4, 2], [3, 4]];
    let corners: Vec<DVec3> =
        corners.map(|[x, y]| DVec3::new(f64::from(x), f64::from(y), 0.0)).to_vec();
    let polygon = vec![0, 1, 2, 3, 0, 4, 6, 5, 4];
    let mut triangles = Vec::new();
    mindeg_mesh::ear_clipping::cut_polygon(&polygon, &corners, &mut triangles);
    let polygons = Polygons { triangle_starts: vec![0, triangles.len() as u32], corners: polygon };
    let mesh = TriMesh::new(corners, triangles).unwrap().with_polygons(polygons);
    let model = Model::of_mesh(&mesh, &with(false)).unwrap();
    let (_, boundary) = model.boundary(0, &model.positions()).unwrap();
    assert!(boundary.rings().eq([0..8, 8..14]));
    assert_eq!(model.edge_count(), 7);
}

/// The cube as triangles with corners of their own, in two groups.
fn triangle_cube(subdivided: bool) -> TriMesh {
    let corner = |i: u32| DVec3::new((i & 1).into(), (i >> 1 & 1).into(), (i >> 2 & 1).into());
    let quads =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let mut positions: Vec<DVec3> = Vec::new();
    for [a, b, c, d] in quads.map(|quad| quad.map(corner)) {
        if subdivided {
            let center = (a + c) / 2.0;
            for (p, q) in [(a, b), (b, c), (c, d), (d, a)] {
                let middle = (p + q) / 2.0;
                positions.extend([p, middle, center, middle, q, center]);
            }
        } else {
            positions.extend([a, b, c, a, c, d]);
        }
    }
    let triangles: Vec<[u32; 3]> =
        (0..positions.len() as u32 / 3).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let count = triangles.len() as u32;
    let group = |name: &str, triangles| Group::new(name, triangles);
    let groups = vec![group("ends", 0..count / 3), group("walls", count / 3..count)];
    TriMesh::new(positions, triangles).unwrap().with_groups(groups)
}

#[test]
fn coplanar_triangles_merge_to_faces() {
    for subdivided in [false, true] {
        let mesh = triangle_cube(subdivided);
        let model = Model::of_mesh(&mesh, &with(true)).unwrap();
        assert_eq!((model.face_count(), model.edge_count()), (6, 12), "{subdivided}");
        assert_eq!(model.vertex_count(), 8 + 12);
        assert!(model.is_closed() && model.notes().is_empty());
        let names: Vec<_> = model.groups().iter().map(|group| group.name.as_deref()).collect();
        assert_eq!(names, [Some("ends"), Some("walls")]);
        assert_eq!(model.group_of(1), 0);
        assert_eq!(model.group_of(2), 1);
    }
    let apart = Model::of_mesh(&triangle_cube(false), &with(false)).unwrap();
    assert_eq!((apart.face_count(), apart.edge_count()), (12, 18));
    let cube = triangle_cube(false);
    let open = TriMesh::new(cube.positions().to_vec(), cube.triangles()[1..].to_vec()).unwrap();
    let open = Model::of_mesh(&open, &with(false)).unwrap();
    assert!(!open.is_closed());
    assert_eq!(open.boundary_edges().count(), 3);
}

/// A cylinder of many narrow walls: each is nearly in the plane of the next wall.
#[test]
fn a_round_wall_does_not_become_one_face() {
    let n = 720;
    let point = |i: u32, z: f64| {
        let angle = std::f64::consts::TAU * f64::from(i % n) / f64::from(n);
        DVec3::new(libm::cos(angle), libm::sin(angle), z)
    };
    let positions = (0..2 * n).map(|i| point(i / 2, f64::from(i % 2))).collect();
    let triangles = (0..n)
        .flat_map(|i| {
            let [a, b] = [2 * i, 2 * ((i + 1) % n)];
            [[a, b, b + 1], [a, b + 1, a + 1]]
        })
        .collect();
    let mesh = TriMesh::new(positions, triangles).unwrap();
    let model = Model::of_mesh(&mesh, &with(true)).unwrap();
    assert_eq!(model.face_count(), n as usize);
}

#[test]
fn all_edges_can_be_divided_in_another_way() {
    let model = Model::from_json(&cube(&QUADS, ", \"size\": 0.5")).unwrap();
    let side = Side::count(4).spaced(Spacing::Bump { ratio: 0.5 });
    let model = model.divided(&side).unwrap();
    assert_eq!(model.vertex_count(), 8 + 12 * 3);
    assert_eq!(model.positions().len(), 44);
    let error = model.divided(&Side::size(-1.0)).unwrap_err().to_string();
    assert_eq!(
        error,
        "the edge from corner 0 to corner 1: the size is -1.0; it must be a finite number above 0"
    );
}

#[test]
fn a_model_takes_a_name() {
    let model = Model::from_json(&cube(&QUADS, r#", "size": 1"#)).unwrap();
    assert_eq!(model.name(), None);
    assert_eq!(model.named("cube").name(), Some("cube"));
}
