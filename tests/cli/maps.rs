//! Maps without interior points, from files to files.

use crate::run::mindeg;
use std::fs;
use std::path::Path;
use tempfile::tempdir;

const MAP: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/outlines/two-materials.geojson");

fn text(path: &Path) -> &str {
    path.to_str().expect("a path in ASCII")
}

#[test]
fn every_format_keeps_regions_lines_and_the_proof() {
    let folder = tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    for extension in ["obj", "msh", "vtu", "npz"] {
        let mesh = at(&format!("map.{extension}"));
        let run = mindeg(["mesh", MAP, "-o", text(&mesh)]);
        assert!(run.errors.contains("maximum degree 6 (least possible 6)"), "{}", run.errors);
        let verified = mindeg(["verify", text(&mesh), MAP, "--optimal", "--json"]).json();
        assert_eq!(verified["proof"]["kind"], "refuted", "{verified}");
        assert_eq!(
            (verified["given_points"].as_u64(), verified["interior_points"].as_u64()),
            (Some(19), Some(0))
        );
        let back = at(&format!("{extension}.obj"));
        mindeg(["convert", text(&mesh), "-o", text(&back), "--boundary-lines", "-q"]).text();
        let back = fs::read_to_string(back).expect("an OBJ");
        for name in ["matrix", "fibre", "steel"] {
            assert!(back.lines().any(|line| line.ends_with(name)), "{extension}: {name}");
        }
    }
}

/// A basin with a weir and a gauge, each a feature of its own.
#[test]
fn lines_and_points_of_geojson_are_in_the_mesh_under_their_names() {
    let folder = tempdir().expect("a folder");
    let feature = |name: &str, geometry: &str| {
        format!(
            r#"{{"type": "Feature", "properties": {{"name": "{name}"}}, "geometry": {geometry}}}"#
        )
    };
    let basin = r#"{"type": "Polygon", "coordinates": [[[0, 0], [8, 0], [8, 8], [0, 8], [0, 0]]]}"#;
    let features = [
        feature("basin", basin),
        feature("weir", r#"{"type": "LineString", "coordinates": [[2, 2], [4, 3], [6, 2]]}"#),
        feature("gauge", r#"{"type": "Point", "coordinates": [4, 6]}"#),
    ];
    let given = folder.path().join("basin.geojson");
    let of_features = |all: &[String]| {
        format!(r#"{{"type": "FeatureCollection", "features": [{}]}}"#, all.join(", "))
    };
    fs::write(&given, of_features(&features)).expect("a file");
    for inside in [&[][..], &["--interior"]] {
        let mesh = folder.path().join("basin.inp");
        let arguments = ["mesh", text(&given), "--size", "1", "-o", text(&mesh)];
        let run = mindeg(arguments.iter().chain(inside));
        assert_eq!(run.code, Some(0), "{}", run.errors);
        let written = fs::read_to_string(&mesh).expect("a mesh");
        assert!(
            ["NSET=weir\n", "NSET=gauge\n", ", 4, 6, 0\n"]
                .iter()
                .all(|words| written.contains(words)),
            "{written}"
        );
    }
    // A line that leaves the basin has no place there but by a repair.
    let out = feature("road", r#"{"type": "LineString", "coordinates": [[1, 1], [9, 1]]}"#);
    fs::write(&given, of_features(&[&features[..], &[out]].concat())).expect("a file");
    let refused = mindeg(["degree", text(&given)]);
    assert!(
        refused.errors.contains("(8, 1): a line meets a border of basin there"),
        "{}",
        refused.errors
    );
    let repaired = mindeg(["degree", text(&given), "--repair"]);
    assert!(
        repaired.errors.contains("dropped 1 edge of lines outside the polygons"),
        "{}",
        repaired.errors
    );
}

/// Two sides, a hole and no other thing are called wall, two lines interface.
const SHARED: &str = r#"{"rectangle": {"width": 4, "height": 2}, "size": 0.5, "name": "plate",
    "sides": [{"name": "wall"}, {"name": "outlet"}, {"name": "wall"}, {"name": "inlet"}],
    "holes": [{"corners": [[3, 1]], "sides": [{"arc": {"center": [2.8, 1]}, "intervals": 16, "name": "wall"}]}],
    "lines": [{"corners": [[2, 0], [2, 2]], "intervals": 4, "name": "interface"},
              {"corners": [[1.3, 1], [1.7, 1]], "intervals": 2, "name": "interface"}],
    "points": [{"at": [0.5, 1], "name": "gauge"}],
    "regions": [{"at": [0.2, 0.2], "name": "matrix"}, {"at": [3.5, 1.5], "name": "steel", "material": "S235"}]}"#;

#[test]
fn a_name_is_one_group_in_every_format() {
    let folder = tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    let domain = at("shared.json");
    fs::write(&domain, SHARED).expect("a file");
    let written = |name: &str, options: &[&str]| {
        let mesh = at(name);
        let command = ["mesh", text(&domain), "--interior", "-q", "-o", text(&mesh)];
        mindeg([&command, options].concat()).text();
        String::from_utf8_lossy(&fs::read(&mesh).expect("a mesh")).into_owned()
    };
    let after = |file: &str, start: &str| -> Vec<String> {
        file.lines().filter_map(|line| line.strip_prefix(start)).map(str::to_owned).collect()
    };
    for version in ["2.2", "4.1"] {
        let msh = written("a.msh", &["--msh-version", version]);
        let (_, names) = msh.split_once("$PhysicalNames\n").expect("names");
        let (names, _) = names.split_once("$End").expect("an end");
        let names: Vec<&str> = names.lines().skip(1).collect();
        let expected = [
            "1 1 \"wall\"",
            "1 2 \"outlet\"",
            "1 3 \"inlet\"",
            "1 4 \"interface\"",
            "2 5 \"matrix\"",
            "2 6 \"steel\"",
            "0 7 \"gauge\"",
        ];
        assert_eq!(names, expected, "{version}");
    }
    let su2 = written("a.su2", &[]);
    assert_eq!(after(&su2, "MARKER_TAG= "), ["wall", "outlet", "inlet", "interface"]);
    assert_eq!(after(&su2, "MARKER_ELEMS= "), ["32", "4", "4", "6"]);
    let inp = written("a.inp", &[]);
    assert_eq!(after(&inp, "*ELEMENT, TYPE=S3, ELSET="), ["matrix", "steel"]);
    // Abaqus adds up what has one name.
    let mut sets = after(&inp, "*NSET, NSET=");
    sets.sort();
    sets.dedup();
    assert_eq!(sets, ["gauge", "inlet", "interface", "outlet", "wall"]);
    let obj = written("a.obj", &["--boundary-lines"]);
    assert!(
        ["matrix", "steel"].iter().all(|name| after(&obj, "o ").iter().any(|own| own == name)),
        "{obj}"
    );
    assert!(["wall", "interface"].iter().all(|name| obj.contains(name)), "{obj}");
    let gltf = written("a.gltf", &[]);
    assert!(["matrix", "steel", "S235"].iter().all(|name| gltf.contains(&format!("{name:?}"))));
    let fort = written("a.14", &[]);
    assert!(
        ["wall", "outlet", "inlet"].iter().all(|name| fort.contains(&format!("({name})"))),
        "{fort}"
    );
    // Names by numbers, each once.
    for name in ["a.vtu", "a.npz"] {
        let file = written(name, &[]);
        assert!(name == "a.npz" || file.contains("interface"), "{name}");
        let back = at("back.msh");
        mindeg(["convert", text(&at(name)), "--ascii", "-q", "-o", text(&back)]).text();
        let back = fs::read_to_string(&back).expect("an MSH");
        for group in ["wall", "interface", "matrix", "steel"] {
            assert_eq!(back.matches(&format!("\"{group}\"")).count(), 1, "{name}: {group}");
        }
    }
}

/// Lines that cross are refused with both and the place; a repair gives them a point there.
#[test]
fn lines_that_cross_are_mended_by_a_repair() {
    let folder = tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    let (domain, mesh) = (at("cross.json"), at("cross.obj"));
    let cross = r#"{"rectangle": {"width": 4, "height": 2}, "size": 0.5, "lines": [
        {"corners": [[1, 1], [3, 1]], "intervals": 4}, {"corners": [[2, 0.5], [2, 1.7]], "intervals": 3}]}"#;
    fs::write(&domain, cross).expect("a file");
    let command = ["mesh", text(&domain), "--interior", "-o", text(&mesh)];
    mindeg(command).refuses(&[
        "lines[0]",
        "line 1",
        "line 2",
        "(2, 1)",
        "--repair gives lines that cross a point",
    ]);
    assert!(!mesh.exists());
    let run = mindeg([&command[..], &["--repair"]].concat());
    assert!(run.errors.contains("Line 1 crosses line 2 at (2, 1)"), "{}", run.errors);
    let verified = mindeg(["verify", text(&mesh), text(&domain), "--repair", "--json"]).json();
    assert_eq!(verified["valid"], true, "{verified}");
    // Nothing is mended in vain.
    mindeg(["mesh", text(&domain), "--snap", "1", "--repair", "-o", text(&mesh)])
        .refuses(&["--snap is for outlines"]);
}

/// Two polygons that overlap are repaired together by both commands; a mesh of them as they were is none of the map.
#[test]
fn a_mesh_of_polygons_that_were_repaired_together_is_verified() {
    let folder = tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    let (file, mesh) = (at("two.wkt"), at("two.obj"));
    let polygons =
        "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))\nPOLYGON ((1.9 0, 4 0, 4 2, 1.9 2, 1.9 0))\n";
    fs::write(&file, polygons).expect("a file");
    mindeg(["mesh", text(&file), "--repair", "--interior", "-q", "-o", text(&mesh)]).text();
    let verified = mindeg(["verify", text(&mesh), text(&file), "--repair", "--json"]).json();
    assert_eq!(verified["valid"], true, "{verified}");
    mindeg(["verify", text(&mesh), text(&file), "--json"]).refuses(&["--repair mends such places"]);
}

/// The same of the boundary points alone.
#[test]
fn polygons_that_overlap_are_repaired_together_without_points_inside() {
    let folder = tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    let (file, mesh) = (at("two.geojson"), at("two.obj"));
    let square = |name: &str, [x, end]: [f64; 2]| {
        format!(
            r#"{{"type": "Feature", "properties": {{"name": "{name}"}}, "geometry": {{"type": "Polygon",
                "coordinates": [[[{x}, 0], [{end}, 0], [{end}, 5], [{x}, 5], [{x}, 0]]]}}}}"#
        )
    };
    let squares = [square("a", [0.0, 5.02]), square("b", [5.0, 10.0])].join(",");
    let collection = format!(r#"{{"type": "FeatureCollection", "features": [{squares}]}}"#);
    fs::write(&file, collection).expect("a file");
    let refused = mindeg(["mesh", text(&file), "-o", text(&mesh)]);
    refused.refuses(&["--repair mends such places"]);
    mindeg(["mesh", text(&file), "--repair", "-q", "-o", text(&mesh)]).text();
    let verified = mindeg(["verify", text(&mesh), text(&file), "--repair", "--json"]).json();
    assert_eq!(verified["valid"], true, "{verified}");
}

/// Eight states with islands: each part is verified against its domain.
#[test]
fn a_mesh_of_several_parts_is_verified() {
    let folder = tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    let states = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/outlines/states.json");
    let from = [states, "--layer", "states", "--name-by", "name"];
    let (all, one) = (at("all.obj"), at("one.obj"));
    mindeg([&["mesh"], &from[..], &["--interior", "-q", "-o", text(&all)]].concat()).text();
    let verified = mindeg([&["verify", text(&all)], &from[..], &["--json"]].concat()).json();
    let parts = verified["parts"].as_array().expect("a list");
    assert!(parts.len() > 1 && verified["passed"] == true, "{verified}");
    let count =
        |key: &str| parts.iter().map(|part| part[key].as_u64().expect("a number")).sum::<u64>();
    let mesh = fs::read_to_string(&all).expect("an OBJ");
    let lines = |start: &str| mesh.lines().filter(|line| line.starts_with(start)).count() as u64;
    assert_eq!(count("triangles"), lines("f "));
    let vertices = ["boundary_vertices", "given_points", "interior_points"].map(count);
    assert_eq!(vertices.iter().sum::<u64>(), lines("v "));
    // One vertex elsewhere, and a mesh of one part.
    let moved = mesh.replacen("v ", "v 1", 1);
    fs::write(&one, moved).expect("a file");
    let run = mindeg([&["verify", text(&one)], &from[..]].concat());
    assert!(
        run.code == Some(3) && run.errors.contains("is no triangulation of states in part 1: "),
        "{}",
        run.errors
    );
    mindeg(
        [&["mesh"], &from[..], &["--feature", "Nevada", "--interior", "-q", "-o", text(&one)]]
            .concat(),
    )
    .text();
    let run = mindeg([&["verify", text(&one)], &from[..]].concat());
    assert!(run.errors.contains("the mesh has 1 part (which"), "{}", run.errors);
}

/// Two regions that share a side, and an island.
const ISLANDS: &str = r#"{"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"name": "west"}, "geometry":
        {"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 3], [0, 3]]]}},
    {"type": "Feature", "properties": {"name": "east"}, "geometry":
        {"type": "Polygon", "coordinates": [[[4, 0], [7, 0], [7, 3], [4, 3]]]}},
    {"type": "Feature", "properties": {"name": "east"}, "geometry":
        {"type": "Polygon", "coordinates": [[[8, 0], [9, 0], [8, 1]]]}}]}"#;

/// Without interior points, regions that do not all hang together are one mesh, too.
#[test]
fn parts_without_interior_points_are_one_mesh() {
    let folder = tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    let (map, mesh) = (at("map.geojson"), at("map.obj"));
    fs::write(&map, ISLANDS).expect("a file");
    let from = [text(&map), "--size", "0.5"];
    let run = mindeg([&["mesh"], &from[..], &["-o", text(&mesh), "--json"]].concat());
    assert!(run.errors.contains("map: 3 regions in 2 parts: "), "{}", run.errors);
    let made = run.json();
    assert_eq!(
        (made["regions"].as_u64(), made["parts"].as_array().map(Vec::len)),
        (Some(3), Some(2))
    );
    let read = fs::read_to_string(&mesh).expect("an OBJ");
    let lines = |start: &str| read.lines().filter(|line| line.starts_with(start)).count() as u64;
    assert_eq!(made["vertices"], lines("v "));
    assert_eq!(made["triangles"], lines("f "));
    // The island is of the group of its name.
    assert_eq!(["o west", "o east"].map(lines), [1, 1]);

    let verified = mindeg([&["verify", text(&mesh)], &from[..], &["--json"]].concat()).json();
    assert_eq!(
        (verified["valid"].as_bool(), verified["parts"].as_array().map(Vec::len)),
        (Some(true), Some(2))
    );

    let degree = mindeg([&["degree"], &from[..], &["--json"]].concat()).json();
    let reached =
        degree["parts"].as_array().expect("a list").iter().map(|part| part["reached"].as_u64());
    assert_eq!(degree["reached"].as_u64(), reached.max().flatten());
    assert_eq!(degree["reached"], made["max_degree"]);
    for (key, total) in [("vertices", lines("v ")), ("triangles", lines("f "))] {
        assert_eq!(degree[key], total, "{key}");
    }
    let run = mindeg([&["degree"], &from[..]].concat());
    let said = run.text();
    assert!(said.contains("Decided by part 1 (west, …), whose vertices count from 0:"), "{said}");
    assert!(said.contains("With interior points, part 2 (east) decides: "), "{said}");

    let figures = at("figures.json");
    let run = mindeg([&["tradeoff"], &from[..], &["--json", "-o", text(&figures)]].concat());
    let curve = run.json();
    let points = curve["points"].as_array().expect("a list");
    assert_eq!(points[0]["max_degree"], degree["reached"], "{curve}");
    assert_eq!(points.last().expect("a point")["share_of_limit"], 1.0);
    let written = fs::read_to_string(&figures).expect("figures");
    assert_eq!(serde_json::from_str::<serde_json::Value>(&written).expect("JSON"), curve);

    let limited = mindeg(
        [&["mesh"], &from[..], &["-o", text(&mesh), "--keep-angle", "1", "--json"]].concat(),
    )
    .json();
    assert!(
        limited["min_angle"].as_f64()
            > Some(0.999 * curve["angle_limit"].as_f64().expect("an angle"))
    );

    for (command, options, why) in [
        (
            "mesh",
            &["--max-degree", "3", "-o", "x.obj"][..],
            "part 1 (west, …): no mesh here has maximum degree 3: each has at least 5",
        ),
        ("mesh", &["--size-inside", "1", "-o", "x.obj"], "add --interior"),
        ("degree", &["--proof", "x.json"], "choose one with --feature"),
        ("tradeoff", &["-o", "x.svg"], "a picture shows one domain, and the file has 2 parts"),
    ] {
        mindeg([&[command], &from[..], options].concat()).refuses(&[why]);
    }
    // Polygons that are no map say why, and what else there is.
    fs::write(&map, ISLANDS.replace("[[4, 0], [7, 0]", "[[3, 0], [7, 0]")).expect("a file");
    let run = mindeg(["mesh", text(&map), "-o", text(&at("none.obj"))]);
    run.refuses(&["west", "east", "; or give --separate and a folder"]);
    assert!(!at("none.obj").exists());
}

#[test]
fn degrees_come_with_their_bound() {
    let answer = mindeg(["degree", MAP, "--json"]).json();
    assert_eq!((answer["regions"].as_u64(), answer["holes"].as_u64()), (Some(3), Some(1)));
    assert_eq!(
        (&answer["least_max_degree"], &answer["certificate"]["kind"]),
        (&6.into(), &"refuted".into())
    );
    // Each triangle has three sides; the boundary has 46 edges.
    let [triangles, interior] =
        ["triangles", "interior_edges"].map(|key| answer[key].as_u64().expect("a number"));
    assert_eq!(3 * triangles, 2 * interior + 46);
    mindeg(["mesh", MAP, "--max-degree", "5", "-o", "map.obj"])
        .refuses(&["no mesh here has maximum degree 5: each has at least 6"]);
    let proof = ["degree", MAP, "--proof", "proof.json"];
    mindeg(proof).refuses(&["mindeg verify finds and checks its proof"]);
    let folder = tempdir().expect("a folder");
    let two = folder.path().join("two.json");
    let regions = r#"[{"at": [1, 1], "name": "left"}, {"at": [3, 1], "name": "right"}]"#;
    let domain = format!(
        r#"{{"rectangle": {{"width": 4, "height": 2}}, "size": 1, "lines": [{{"corners": [[2, 0], [2, 2]]}}],
            "regions": {regions}}}"#
    );
    fs::write(&two, domain).expect("a file");
    let degrees = |command| mindeg([command, text(&two), "--json"]).json();
    assert_eq!(degrees("suggest")["reached"], degrees("degree")["reached"]);
}

/// Other methods keep the same regions and lines.
#[test]
fn maps_are_compared_region_by_region() {
    let folder = tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    let (html, meshes) = (at("report.html"), at("meshes"));
    let run = mindeg(["compare", MAP, "--json", "-o", text(&html), "--save-meshes", text(&meshes)]);
    let report = run.json();
    let domain = &report["domain"];
    assert_eq!((domain["regions"].as_u64(), domain["holes"].as_u64()), (Some(3), Some(1)));
    let figures = ["vertices", "triangles", "interior_edges"].map(|key| domain[key].as_u64());
    assert_eq!(figures, [65, 84, 103].map(Some));
    let names: Vec<_> =
        report["methods"].as_array().expect("a list").iter().map(|it| &it["name"]).collect();
    assert_eq!(names[..3], ["mindeg", "Delaunay", "Ear clipping"]);
    assert_eq!(
        names[3..],
        ["mindeg, 95% of the angle", "mindeg, fewest edges", "mindeg, points inside"]
    );
    let [own, delaunay, ears] = [0, 1, 2].map(|method| &report["methods"][method]);
    assert_eq!((own["max_degree"].as_u64(), own["valid"].as_bool()), (Some(6), Some(true)));
    assert!(delaunay["valid"] == true && delaunay["max_degree"].as_u64() > Some(6), "{delaunay}");
    // The crate drops points on straight lines beside holes.
    assert!(ears["valid"] == true || ears["defects"][0]["kind"] == "missing_triangles", "{ears}");
    for name in ["mindeg.obj", "delaunay.obj"] {
        let verified = mindeg(["verify", text(&meshes.join(name)), MAP, "--json"]).json();
        assert_eq!(
            (verified["valid"].as_bool(), verified["given_points"].as_u64()),
            (Some(true), Some(19)),
            "{verified}"
        );
    }
    let page = fs::read_to_string(&html).expect("a report");
    assert!(page.contains(" · 1 hole · 3 regions · 65 vertices · 84 triangles · "));
    assert!(page.contains("of a map, the angles are searched for, not proven"));
    // With points inside, the other program has no mesh, and says why.
    let report = mindeg(["compare", MAP, "--json", "--interior"]).json();
    let [own, other] = [0, 1].map(|method| &report["interior"][method]);
    assert!(
        own["violations"] == 0 && other["failure"] == "it takes no lines or points inside",
        "{report}"
    );
}

/// A report is of one part: a folder takes one of each.
#[test]
fn parts_of_a_map_are_compared_one_by_one() {
    let folder = tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    let map = at("map.geojson");
    fs::write(&map, ISLANDS).expect("a file");
    let compare = |output: &str| {
        mindeg(["compare", text(&map), "--size", "0.5", "-q", "-o", text(&at(output))])
    };
    compare("one.html").refuses(&["has 2 parts", "-o reports/", "--feature"]);
    assert!(!at("one.html").exists());
    compare("reports/").text();
    let mut pages: Vec<_> = fs::read_dir(at("reports"))
        .expect("a folder")
        .map(|it| it.expect("a file").file_name())
        .collect();
    pages.sort();
    assert_eq!(pages, ["index.html", "map-1.html", "map-1.json", "map-2.html", "map-2.json"]);
    let page = |name: &str| fs::read_to_string(at("reports").join(name)).expect("a page");
    assert!(page("map-1.html").contains(" 2 regions ") && page("index.html").contains("map-2"));
    // The command of a page makes the mesh of its part, in a file of its own.
    let part = at("reports").join("map-2.json");
    let command =
        format!("mindeg mesh {} --keep-angle 95% -o map-2-keep-angle-95.obj", text(&part));
    assert!(page("map-2.html").contains(&command), "{command}");
    let out = at("part.obj");
    let made = mindeg(["mesh", text(&part), "-o", text(&out), "--json"]).json();
    assert!(page("map-2.html").contains(&format!("{} boundary vertices", made["vertices"])));
}

/// Limits of single vertices hold with each goal, and are said to be out of reach where they are.
#[test]
fn limits_of_single_vertices_are_kept() {
    let folder = tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    let (domain, mesh) = (at("map.json"), at("map.obj"));
    let limits = [(0, 2), (5, 3), (8, 4), (17, 3), (18, 3), (30, 3)];
    let json = |vertices: serde_json::Value| {
        serde_json::json!({"rectangle": {"width": 4, "height": 2}, "size": 0.25, "vertices": vertices,
            "lines": [{"corners": [[2, 0], [2, 2]], "size": 0.25}]})
    };
    let listed = |limits: &[(u32, u32)]| {
        limits
            .iter()
            .map(|(vertex, limit)| serde_json::json!({"vertex": vertex, "max_degree": limit}))
            .collect()
    };
    fs::write(&domain, json(listed(&limits)).to_string()).expect("a file");
    // The neighbours of each vertex, from 1.
    let degrees = || {
        let mut edges = std::collections::BTreeSet::new();
        for face in fs::read_to_string(&mesh)
            .expect("an OBJ")
            .lines()
            .filter_map(|line| line.strip_prefix("f "))
        {
            let [a, b, c] = face
                .split(' ')
                .map(|v| v.split('/').next().unwrap_or(v).parse::<u32>().expect("an index"))
                .collect::<Vec<_>>()[..]
            else {
                panic!("{face}")
            };
            edges.extend([[a, b], [b, c], [c, a]].map(|[a, b]| [a.min(b), a.max(b)]));
        }
        move |vertex: u32| edges.iter().flatten().filter(|end| **end == vertex + 1).count() as u32
    };
    let mut angles = Vec::new();
    for goal in
        [&[][..], &["--max-degree", "6"], &["--keep-angle", "50%"], &["--optimize", "angle"]]
    {
        let made =
            mindeg([&["mesh", text(&domain), "-o", text(&mesh), "--json"], goal].concat()).json();
        angles.push(made["min_angle"].as_f64().expect("an angle"));
        let degree = degrees();
        for (vertex, limit) in limits {
            assert!(degree(vertex) <= limit, "{goal:?}: vertex {vertex}");
        }
    }
    assert!(angles[1] > angles[0] && angles[3] >= angles[0], "{angles:?}");
    // Without limits, some vertex has more.
    fs::write(&domain, json(listed(&[])).to_string()).expect("a file");
    mindeg(["mesh", text(&domain), "-o", text(&mesh), "-q"]).text();
    let degree = degrees();
    assert!(limits.iter().any(|&(vertex, limit)| degree(vertex) > limit));
    let all: Vec<_> =
        (1..24).filter(|v| ![0, 8, 16].contains(&(v % 24))).map(|vertex| (vertex, 3)).collect();
    fs::write(&domain, json(listed(&all)).to_string()).expect("a file");
    mindeg(["mesh", text(&domain), "-o", text(&at("none.obj"))])
        .refuses(&["keeps the degree limits of single vertices"]);
    assert!(!at("none.obj").exists());
}

#[test]
fn a_map_has_the_name_of_its_file_with_and_without_points_inside() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/outlines/two-materials.geojson");
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("x.obj").display().to_string();
    for option in ["--quiet", "--interior"] {
        let found = crate::run::mindeg(["mesh", file, "-o", &out, "--json", option]).json();
        assert_eq!(found["name"], "two-materials", "{option}");
    }
}

/// One map had two regions in `degree` and one in `mesh --interior`, where they share a name.
#[test]
fn all_commands_count_the_same_regions() {
    let folder = tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    let (map, out) = (at("map.geojson"), at("map.obj"));
    for (island, parts) in [("[8, 0], [9, 0], [8, 1]", 2), ("[7, 0], [8, 0], [7, 3]", 1)] {
        let text = ISLANDS.replace("[8, 0], [9, 0], [8, 1]", island);
        fs::write(&map, text).expect("a file");
        let of = |words: &[&str]| {
            let found = mindeg([words, &[self::text(&map), "--json"]].concat()).json();
            found["regions"].as_u64().expect("a count")
        };
        let mesh = ["mesh", "-o", self::text(&out)];
        let inside = [&mesh[..], &["--interior"]].concat();
        assert_eq!([of(&["degree"]), of(&inside)], [3, 3], "{parts}");
        if parts > 1 {
            assert_eq!(of(&mesh), 3);
        }
    }
}

#[test]
fn one_triangle_is_one_triangle() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name).display().to_string();
    std::fs::write(at("t.svg"), "<svg><path d='M0 0h2v2z'/></svg>").expect("a file");
    assert_eq!(crate::run::mindeg(["mesh", &at("t.svg"), "-o", &at("t.obj")]).code, Some(0));
    let obj = std::fs::read_to_string(at("t.obj")).expect("a mesh");
    assert!(obj.contains("\n# 3 vertices, 1 triangle, maximum degree 2\n"), "{obj}");
}

/// Parts that share no edge have one advice, whose meshes have its figures.
#[test]
fn parts_of_a_map_have_the_same_advice_everywhere() {
    let folder = tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    let out = at("mesh.obj");
    let parts =
        "POLYGON((0 0, 1 0, 2 0, 2 0.3, 2 2, 0 2, 0 0.2)) POLYGON((5 0, 6 0, 9 0, 9 1, 5 1))";
    // Alone, the house keeps 95% of its own larger angle at degree 6 only.
    let house = "<svg viewBox='0 0 24 24'><path d='M10 20v-6h4v6h5v-8h3L12 3 2 12h3v8z'/><circle cx='30' cy='12' r='5'/></svg>";
    for (name, content) in [("parts.wkt", parts), ("house.svg", house)] {
        let file = at(name);
        fs::write(&file, content).expect("a file");
        let figures = mindeg(["tradeoff", text(&file), "--json"]).json();
        let written = mindeg(["mesh", text(&file), "-o", text(&out)]).errors;
        // The mesh of least degree of the house is the patch, which nobody makes twice.
        let is_patch = name == "house.svg";
        assert!(written.contains(" --interior\n"), "{written}");
        assert_eq!(written.contains(" --keep-angle 95%\n"), !is_patch, "{written}");
        let told = [
            mindeg(["tradeoff", text(&file)]).text().to_owned(),
            mindeg(["degree", text(&file)]).text().to_owned(),
            mindeg(["view", text(&file), "-o", text(&at("page.html"))]).errors,
        ];
        for purpose in ["solver", "patch", "fewest"] {
            let advised = &figures["advice"][purpose];
            let words = ["mesh", text(&file), "--for", purpose, "--json", "-o", text(&out)];
            let made = mindeg(words).json();
            for key in ["max_degree", "min_angle"] {
                let [told, is] = [advised, &made].map(|it| it[key].as_f64().expect("a number"));
                assert!((told - is).abs() < 1e-9, "{name}, {purpose}, {key}: {told} {is}");
            }
            let angle = advised["min_angle"].as_f64().expect("a number");
            let written = (purpose == "solver" || !is_patch).then_some(&written);
            for text in told.iter().chain(written).filter(|_| purpose != "fewest") {
                assert!(text.contains(&format!("minimum angle {angle:.3}°")), "{purpose}: {text}");
            }
        }
        assert_eq!(figures["advised"], figures["advice"]["patch"]["max_degree"], "{name}");
        assert!(!figures["advice"]["patch"]["share_of_delaunay"].is_null(), "{name}");
        // A row is the mesh of all parts within its degree.
        for row in figures["points"].as_array().expect("rows") {
            let degree = row["max_degree"].to_string();
            let words = ["mesh", text(&file), "--max-degree", &degree, "--json", "-o", text(&out)];
            let made = mindeg(words).json();
            let [told, is] = [row, &made].map(|it| it["min_angle"].as_f64().expect("an angle"));
            assert!((told - is).abs() < 1e-6, "{name}, {degree}: {told} {is}");
        }
    }
}

/// Every command mends overlaps as `mesh` does, and `view` shows all parts.
#[test]
fn overlaps_are_repaired_alike_by_all_commands() {
    let folder = tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    let (file, page) = (at("land.wkt"), at("page.html"));
    let land = "POLYGON((0 0, 5.02 0, 5.02 5, 0 5)) POLYGON((5 0, 10 0, 10 5, 5 5)) POLYGON((20 0, 25 0, 25 5))";
    fs::write(&file, land).expect("a file");
    for command in ["tradeoff", "degree", "view"] {
        let output: &[&str] = if command == "view" { &["-o", text(&page)] } else { &[] };
        let run = mindeg([&[command, text(&file), "--repair"], output].concat());
        assert_eq!(run.code, Some(0), "{command}: {}", run.errors);
        assert!(run.errors.contains("repaired 3 polygons together"), "{command}: {}", run.errors);
    }
    fs::write(&file, &land[..land.rfind(" POLYGON").expect("a polygon")]).expect("a file");
    let run = mindeg(["compare", text(&file), "--repair", "-o", text(&page)]);
    assert!(run.code == Some(0) && run.errors.contains("repaired 2 polygons"), "{}", run.errors);
}
