//! Outlines of other programs, wherever a domain is taken.

use crate::run::{mindeg, mindeg_reading};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// A folder with the files of a test.
fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, text) in files {
        fs::write(folder.path().join(name), text).expect("a file");
    }
    folder
}

fn text(path: &Path) -> String {
    fs::read_to_string(path).expect("a text")
}

/// The `x y` of each vertex of an OBJ.
fn points(obj: &str) -> Vec<[f64; 2]> {
    let point = |line: &str| {
        let mut words =
            line.strip_prefix("v ")?.split(' ').map(|word| word.parse().expect("a number"));
        Some([words.next()?, words.next()?])
    };
    obj.lines().filter_map(point).collect()
}

const TRIANGLE: [[f64; 2]; 3] = [[0.1, 0.0], [4.0, 0.0], [0.1, 3.3]];

/// The same triangle in every format. Y is turned in SVG.
const FILES: [(&str, &str); 9] = [
    (
        "a.geojson",
        r#"{"type": "Polygon", "coordinates": [[[0.1, 0], [4, 0], [0.1, 3.3], [0.1, 0]]]}"#,
    ),
    (
        "a.json",
        r#"{"type": "Feature", "geometry": {"type": "Polygon", "coordinates": [[[0.1, 0], [4, 0], [0.1, 3.3], [0.1, 0]]]}}"#,
    ),
    ("a.wkt", "POLYGON((0.1 0, 4 0, 0.1 3.3, 0.1 0))"),
    ("a.svg", "<svg><path d='M.1 0H4L.1-3.3z'/></svg>"),
    ("a.csv", "x,y\n0.1,0\n4,0\n0.1,3.3\n"),
    ("a.obj", "v 0.1 0 0\nv 4 0 0\nv 0.1 3.3 0\nl 1 2 3 1\n"),
    (
        "a.msh",
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0.1 0 0\n2 4 0 0\n3 0.1 3.3 0\n$EndNodes\n$Elements\n3\n1 1 2 0 1 1 2\n2 1 2 0 1 2 3\n3 1 2 0 1 3 1\n$EndElements\n",
    ),
    ("a.poly", "3 2 0 0\n1 0.1 0\n2 4 0\n3 0.1 3.3\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n"),
    (
        "a.dxf",
        "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n70\n1\n10\n0.1\n20\n0\n10\n4\n20\n0\n10\n0.1\n20\n3.3\n0\nENDSEC\n0\nEOF\n",
    ),
];

#[test]
fn every_format_is_meshed_with_its_points_bit_for_bit() {
    let folder = folder(&FILES);
    for (name, content) in FILES {
        let (file, out) = (folder.path().join(name), folder.path().join("out.obj"));
        let run = mindeg(["mesh".as_ref(), file.as_os_str(), "-o".as_ref(), out.as_os_str()]);
        assert_eq!(run.code, Some(0), "{name}: {}", run.errors);
        assert_eq!(points(&text(&out)), TRIANGLE, "{name}");
        // Standard input tells no extension.
        let run = mindeg_reading(["mesh", "-", "-o", "-", "--format", "obj"], content.as_bytes());
        assert_eq!(run.code, Some(0), "{name}: {}", run.errors);
        assert_eq!(points(run.text()), TRIANGLE, "{name}");
    }
}

/// All lines of MSH 2.2 bound its only surface, or lie in it.
#[test]
fn the_only_surface_of_an_old_msh_has_its_name_and_what_lies_in_it() {
    let nodes = "1 0 0 0\n2 4 0 0\n3 4 3 0\n4 0 3 0\n5 1 1 0\n6 2 1 0\n7 1 2 0\n8 9 9 0\n";
    // The last node is of no group, as the center of an arc.
    let elements = "1 1 2 1 1 1 2\n2 1 2 1 2 2 3\n3 1 2 1 3 3 4\n4 1 2 1 4 4 1\n5 1 2 2 5 5 6\n6 15 2 3 7 7\n7 15 2 0 8 8\n";
    let names = "4\n1 1 \"wall\"\n1 2 \"crack\"\n0 3 \"gauge\"\n2 4 \"fluid\"\n";
    let msh = format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n{names}$EndPhysicalNames\n\
         $Nodes\n8\n{nodes}$EndNodes\n$Elements\n7\n{elements}$EndElements\n"
    );
    let folder = folder(&[("old.msh", &msh)]);
    let (file, out) = (folder.path().join("old.msh"), folder.path().join("new.msh"));
    let run = mindeg([
        "mesh".as_ref(),
        file.as_os_str(),
        "--interior".as_ref(),
        "--ascii".as_ref(),
        "-o".as_ref(),
        out.as_os_str(),
    ]);
    assert!(run.errors.starts_with("fluid: 4 boundary"), "{run:?}");
    let made = text(&out);
    for name in ["1 1 \"wall\"", "1 2 \"crack\"", "2 3 \"fluid\"", "0 4 \"gauge\""] {
        assert!(made.contains(name), "{name}: {made}");
    }
    // Without a name the line has no surface around it.
    fs::write(&file, msh.replace("4\n1 1", "3\n1 1").replace("2 4 \"fluid\"\n", ""))
        .expect("a file");
    let run = mindeg(["mesh".as_ref(), file.as_os_str(), "-o".as_ref(), out.as_os_str()]);
    let note = "left out an open line of 1 piece that ends at (1, 1); with a physical surface around it, it stays";
    assert!(run.errors.contains(note), "{run:?}");
}

/// Lines of MSH 2.2 do not say which surface they bound.
#[test]
fn several_surfaces_without_their_boundaries_are_refused_with_the_way_out() {
    let lines = [[1, 2], [2, 3], [3, 4], [4, 1], [2, 4]];
    let lines = (1..).zip(lines).map(|(tag, [a, b])| format!("{tag} 1 2 0 {tag} {a} {b}\n"));
    let msh = format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 4 0 0\n3 4 3 0\n4 0 3 0\n$EndNodes\n\
         $Elements\n5\n{}$EndElements\n",
        lines.collect::<String>()
    );
    let run = mindeg_reading(["mesh", "-", "-o", "-", "--format", "obj"], msh.as_bytes());
    run.refuses(&[
        "the point (4, 0): three or more lines meet there",
        "as MSH 4.1 (gmsh -1 -format msh4)",
    ]);
}

#[test]
fn domains_are_written_as_json_that_gives_the_same_points() {
    let folder = folder(&FILES);
    let json = folder.path().join("domain.json");
    let [one, other] = ["one.obj", "other.obj"].map(|name| folder.path().join(name));
    let call = |words: &[&str]| {
        let run = mindeg(words);
        assert_eq!(run.code, Some(0), "{words:?}: {}", run.errors);
    };
    let [json, one, other] = [&json, &one, &other].map(|path| path.to_str().expect("a name"));
    for (name, _) in FILES {
        let file = folder.path().join(name);
        let file = file.to_str().expect("a name");
        for options in [&[][..], &["--size", "0.37"]] {
            call(&[&["domain", file, "-o", json], options].concat());
            call(&[&["mesh", file, "-o", one], options].concat());
            call(&["mesh", json, "-o", other]);
            assert_eq!(text(Path::new(one)), text(Path::new(other)), "{name}");
        }
    }
}

#[test]
fn every_command_that_takes_a_domain_takes_outlines() {
    let wkt = "POLYGON((0 0, 4 0, 4 3, 0 3))";
    for words in [
        &["degree", "-", "--size", "1"][..],
        &["suggest", "-", "--size", "1"],
        &["tradeoff", "-", "--size", "1"],
        &["compare", "-", "--size", "1", "--json"],
        &["domain", "-"],
        &["domain", "-", "-o", "-"],
        &["view", "-", "-o", "-"],
    ] {
        let run = mindeg_reading(words, wkt.as_bytes());
        assert_eq!(run.code, Some(0), "{words:?}: {}", run.errors);
    }
    let run = mindeg_reading(["degree", "-", "--size", "1", "--json"], wkt.as_bytes());
    assert_eq!(run.json()["intervals"], json!([4, 3, 4, 3]));
}

/// Two polygons of one name, one with a hole, and one without a name.
const MAP: &str = r#"{"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"name": "Isles"}, "geometry": {"type": "MultiPolygon", "coordinates": [
        [[[0, 0], [6, 0], [6, 6], [0, 6]], [[2, 2], [2, 4], [4, 4], [4, 2]]],
        [[[8, 0], [9, 0], [8, 1]]]]}},
    {"type": "Feature", "geometry": {"type": "Polygon", "coordinates": [[[20, 0], [21, 0], [20, 1]]]}},
    {"type": "Feature", "geometry": {"type": "Point", "coordinates": [20, 0]}}]}"#;

fn names_in(folder: &Path) -> Vec<String> {
    let name = |entry: fs::DirEntry| entry.file_name().to_string_lossy().into_owned();
    let entries = fs::read_dir(folder).expect("a folder");
    let mut names: Vec<String> = entries.map(|entry| name(entry.expect("an entry"))).collect();
    names.sort();
    names
}

#[test]
fn several_polygons_are_listed_chosen_or_written_to_a_folder() {
    let folder = folder(&[("map.geojson", MAP)]);
    let map = folder.path().join("map.geojson");
    let map = map.to_str().expect("a name");
    let run = mindeg(["domain", map, "--json"]);
    let rows = run.json();
    let column = |key: &str| -> Vec<Value> {
        rows.as_array().expect("a list").iter().map(|row| row[key].clone()).collect()
    };
    assert_eq!(column("name"), [json!("Isles 1"), json!("Isles 2"), Value::Null]);
    assert_eq!(column("rings"), [2, 1, 1]);
    assert_eq!(column("vertices"), [8, 3, 3]);
    assert_eq!(column("area"), [32.0, 0.5, 0.5]);
    assert!(
        mindeg(["domain", map])
            .text()
            .contains("    1  Isles 1: 8 points on 8 sides, 1 hole, area 32")
    );

    for (feature, points) in [("Isles 2", 3), ("2", 3), ("3", 3), ("Isles 1", 8)] {
        let run = mindeg(["domain", map, "--feature", feature, "--json"]);
        assert_eq!(run.json()[0]["vertices"], points, "{feature}");
    }
    let one_file = folder.path().join("x.obj");
    let one_file = one_file.to_str().expect("a name");
    mindeg(["mesh", map, "--feature", "4", "-o", one_file]).refuses(&[
        "no polygon is \"4\"; give a name, or an index from 1 to 3: 1 (Isles 1), 2 (Isles 2), 3",
    ]);
    mindeg(["mesh", map, "--separate", "-o", one_file])
        .refuses(&["has 3 polygons, and", "x.obj is one file; give a folder, such as -o meshes/"]);
    mindeg(["domain", map, "-o", "x.json"]).refuses(&["has 3 polygons; choose one with --feature, by its name or index: 1 (Isles 1), 2 (Isles 2), 3"]);
    assert!(!Path::new(one_file).exists());

    let out = folder.path().join("out/");
    let run = mindeg(["mesh".as_ref(), map.as_ref(), "-o".as_ref(), out.as_os_str()]);
    assert_eq!(run.code, Some(0), "{}", run.errors);
    assert_eq!(names_in(&out), ["Isles-1.obj", "Isles-2.obj", "polygon-3.obj"]);
    assert_eq!(points(&text(&out.join("Isles-2.obj"))), [[8.0, 0.0], [9.0, 0.0], [8.0, 1.0]]);
    // Nothing is overwritten.
    let before = text(&out.join("Isles-1.obj"));
    let run = mindeg(["mesh".as_ref(), map.as_ref(), "-o".as_ref(), out.as_os_str()]);
    assert_eq!(run.code, Some(1));
    assert!(
        run.errors.contains("Isles-1.obj exists; a file for each polygon overwrites none"),
        "{}",
        run.errors
    );
    assert_eq!(text(&out.join("Isles-1.obj")), before);

    let pattern = folder.path().join("p/{index}-{name}.json");
    let run = mindeg(["domain".as_ref(), map.as_ref(), "-o".as_ref(), pattern.as_os_str()]);
    assert_eq!(run.code, Some(0), "{}", run.errors);
    assert_eq!(
        names_in(&folder.path().join("p")),
        ["1-Isles-1.json", "2-Isles-2.json", "3-polygon-3.json"]
    );
    let pattern = folder.path().join("q/{name}.svg");
    let run = mindeg([
        "mesh".as_ref(),
        map.as_ref(),
        "--feature".as_ref(),
        "Isles".as_ref(),
        "-o".as_ref(),
        pattern.as_os_str(),
    ]);
    assert_eq!(run.code, Some(0), "{}", run.errors);
    assert_eq!(names_in(&folder.path().join("q")), ["Isles-1.svg", "Isles-2.svg"]);
}

#[test]
fn a_polygon_that_is_no_domain_does_not_keep_the_others_from_it() {
    let wkt = "POLYGON((0 0,4 4,4 0,0 4))\nPOLYGON((0 0,4 0,4 4))";
    let folder = folder(&[("a.wkt", wkt)]);
    let (file, out) = (folder.path().join("a.wkt"), folder.path().join("out/"));
    let run = mindeg(["mesh".as_ref(), file.as_os_str(), "-o".as_ref(), out.as_os_str()]);
    assert_eq!(run.code, Some(2));
    assert!(
        run.errors.contains("1 of 2 polygons have no mesh; those of the others were written"),
        "{}",
        run.errors
    );
    assert!(
        run.errors.contains("\npolygon 1: side 1 and side 3 cross near (2, 2)"),
        "{}",
        run.errors
    );
    assert_eq!(names_in(&out), ["polygon-2.obj"]);
}

/// Both were called "domain" in the text and "mesh" in their files.
#[test]
fn meshes_of_polygons_without_names_are_called_apart() {
    let folder = folder(&[("a.wkt", "POLYGON((0 0, 4 0, 4 4, 0 4)) POLYGON((9 0, 12 0, 12 4))")]);
    let (file, out) = (folder.path().join("a.wkt"), folder.path().join("out/"));
    let run = mindeg(["mesh".as_ref(), file.as_os_str(), "-o".as_ref(), out.as_os_str()]);
    for index in [1, 2] {
        let told = format!("polygon {index}: {} vertices, ", 5 - index);
        assert!(run.errors.contains(&told), "{run:?}");
        let obj = text(&out.join(format!("polygon-{index}.obj")));
        assert!(obj.contains(&format!("\no polygon_{index}\n")), "{obj}");
        let index = index.to_string();
        let mesh = out.join(format!("polygon-{index}.obj"));
        let words = ["verify".as_ref(), mesh.as_os_str(), file.as_os_str()];
        let feature = ["--feature".as_ref(), index.as_ref()];
        assert_eq!(mindeg([&words[..], &feature[..]].concat()).code, Some(0));
    }
}

/// What edges of a size cut off is no fault of the outline, which a repair would mend.
#[test]
fn edges_of_a_size_that_cross_are_told_with_what_helps() {
    let coast = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/outlines/saronic.geojson");
    let told = |size: &str| {
        let words =
            ["mesh", coast, "--size", size, "--project", "auto", "-o", "-", "--format", "obj"];
        let run = mindeg(words);
        assert_eq!(run.code, Some(2), "{run:?}");
        run.errors
    };
    let errors = told("5000");
    assert!(errors.contains("--condition keeps edges of this size apart"), "{errors}");
    assert!(!errors.contains("--repair"), "{errors}");
    // Here the outline itself crosses.
    let bow = folder(&[("bow.wkt", "POLYGON((0 0,4 4,4 0,0 4))")]);
    let bow = bow.path().join("bow.wkt");
    let bow = bow.to_str().expect("a path");
    let run = mindeg(["mesh", bow, "--size", "1", "-o", "-", "--format", "obj"]);
    assert!(run.errors.contains("--repair mends such places"), "{run:?}");
}

#[test]
fn rings_that_touch_themselves_are_refused_or_repaired() {
    let wkt = "POLYGON((0 0,2 1,4 0,4 2,2 1,0 2,0 2))";
    let words = ["mesh", "-", "-o", "-", "--format", "obj"];
    mindeg_reading(words, wkt.as_bytes()).refuses(&["polygon 1", "--repair mends such places"]);
    let run = mindeg_reading(["domain", "-", "--repair", "--json"], wkt.as_bytes());
    assert!(
        run.errors.contains("repaired polygon 1: dropped 1 repeated point; made 2 polygons of 1"),
        "{}",
        run.errors
    );
    assert_eq!(run.json().as_array().map(Vec::len), Some(2));
}

/// The ring runs twice round a piece of its area.
#[test]
fn polygons_of_a_repair_do_not_overlap() {
    let wkt = "POLYGON((0 5,2 0,0 2,1 5,1 1))";
    for (options, expected) in [
        (&[][..], 2.350_6),
        (&["--fill-rule", "evenodd"], 2.350_6),
        (&["--fill-rule", "nonzero"], 2.925_3),
    ] {
        let words = [&["domain", "-", "--repair", "--json"], options].concat();
        let run = mindeg_reading(words, wkt.as_bytes());
        let areas = run
            .json()
            .as_array()
            .unwrap()
            .iter()
            .map(|it| it["area"].as_f64().unwrap())
            .sum::<f64>();
        assert!((areas - expected).abs() < 1e-4, "{options:?}: {areas}");
    }
    mindeg_reading(["domain", "-", "--fill-rule", "evenodd"], wkt.as_bytes())
        .refuses(&["--repair"]);
    mindeg_reading(["domain", "-", "--repair", "--fill-rule", "odd"], wkt.as_bytes())
        .refuses(&["found \"odd\", expected evenodd or nonzero"]);
}

#[test]
fn curves_and_sides_are_divided_by_their_length() {
    let svg = "<svg><circle r='1'/></svg>";
    let count = |words: &[&str]| {
        let run = mindeg_reading([&["domain", "-", "--json"], words].concat(), svg.as_bytes());
        run.json()[0]["vertices"].clone()
    };
    assert_eq!(count(&[]), 24);
    assert_eq!(count(&["--size", "0.1"]), 63);
    // Sides between corners of more than 30 degrees keep their ends.
    let wkt = "POLYGON((0 0, 2 0.1, 4 0, 4 4, 0 4))";
    let vertices = |words: &[&str]| {
        let run = mindeg_reading([&["domain", "-", "--json"], words].concat(), wkt.as_bytes());
        (run.json()[0]["sides"].clone(), run.json()[0]["vertices"].clone())
    };
    assert_eq!(vertices(&["--size", "1"]).1, 16);
    assert_eq!(vertices(&["--size", "1", "--corner-angle", "180"]).1, 16);
    assert_eq!(vertices(&["--size", "10", "--corner-angle", "3"]).1, 5);
}

#[test]
fn mistakes_are_named_with_what_to_do() {
    let folder = folder(&[
        ("lie.svg", "POLYGON((0 0,4 0,0 3))"),
        ("lie.json", "0 0\n1 0\n0 1\n"),
        ("domain.wkt", r#"{"rectangle": {"width": 4, "height": 3}, "size": 1}"#),
        ("plain.json", r#"{"rectangle": {"width": 4, "height": 3}, "size": 1}"#),
        ("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
        ("broken.geojson", "{\"type\": \"Polygon\",\n\"coordinates\": [[[0, 0], [1, \"a\"]]]}"),
        ("what.xyz", "hello world\n"),
        ("a.wkt", "POLYGON((0 0,4 0,0 3))"),
    ]);
    let at = |name: &str| -> PathBuf { folder.path().join(name) };
    for (name, options, words) in [
        (
            "lie.svg",
            &[][..],
            &[
                "lie.svg: the name ends as SVG does, and the content looks like WKT; rename the file to end in .wkt",
            ][..],
        ),
        (
            "lie.json",
            &[],
            &[
                "lie.json: the name ends in .json, and the content looks like a list of points; rename the file to end in .csv",
            ],
        ),
        (
            "domain.wkt",
            &[],
            &[
                "domain.wkt: the name ends as WKT does, and the content is JSON; rename the file to end in .json",
            ],
        ),
        (
            "plain.json",
            &["--feature", "1"],
            &[
                "--feature is for outlines such as GeoJSON or SVG;",
                "plain.json is a domain in JSON",
            ],
        ),
        ("plain.json", &["--repair", "--snap", "1"], &["--snap is for outlines"]),
        (
            "broken.geojson",
            &[],
            &[
                "broken.geojson: coordinates[0][1]: found the text \"a\" in a position, expected a number",
            ],
        ),
        ("a.wkt", &["--size", "1e-12"], &["the size 1e-12 makes", "give a larger size"]),
        ("a.wkt", &["--corner-angle", "200"], &["give an angle from 0 to 180 degrees, such as 30"]),
    ] {
        let file = at(name);
        let mut call = vec!["mesh", file.to_str().expect("a name"), "-o", "no-such-folder/x.obj"];
        call.extend(options);
        mindeg(&call).refuses(words);
    }
    // mesh, degree and suggest take faces as a model.
    let mesh = at("mesh.obj");
    mindeg(["tradeoff".as_ref(), mesh.as_os_str()]).refuses(&[
        "mesh.obj: the file has faces, so it is a model or a mesh: mindeg mesh meshes its faces and tells their least degree",
    ]);
}

#[test]
fn the_boundary_of_a_mesh_becomes_a_domain() {
    let folder = folder(&[]);
    let at = |name: &str| folder.path().join(name).display().to_string();
    let domain = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/domains/plate-with-holes.json");
    let run = |arguments: &[&str]| {
        let run = mindeg(arguments);
        assert_eq!(run.code, Some(0), "{arguments:?}: {}", run.errors);
        run
    };
    run(&["mesh", domain, "-q", "--interior", "-o", &at("a.node"), "-o", &at("a.14")]);
    for mesh in ["a.node", "a.ele", "a.14"] {
        mindeg(["mesh", &at(mesh), "-o", &at("x.obj")]).refuses(&[
            mesh,
            "a domain is expected",
            "-o outline.poly` writes the boundary",
        ]);
    }
    run(&["convert", &at("a.14"), "-q", "-o", &at("b.poly")]);
    let sorted = |name: &str| {
        let mut points = points(&text(&folder.path().join(name)));
        points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
        points
    };
    run(&["mesh", domain, "-q", "-o", &at("c.obj")]);
    for (poly, obj) in [("a.poly", "a.obj"), ("b.poly", "b.obj")] {
        run(&["mesh", &at(poly), "-q", "-o", &at(obj)]);
        assert_eq!(sorted(obj), sorted("c.obj"), "{poly}");
        assert!(run(&["domain", &at(poly), "-o", "-"]).text().contains("left bore"), "{poly}");
    }
}

/// Two states with a border of two edges, and an island of the first, in TopoJSON.
const STATES: &str = r#"{"type": "Topology", "transform": {"scale": [0.1, 0.1], "translate": [0.7, 0]},
    "arcs": [[[20, 0], [1, 10], [-1, 10]], [[20, 20], [-20, 0], [0, -20], [20, 0]],
             [[20, 0], [20, 0], [0, 20], [-20, 0]], [[60, 0], [10, 0], [0, 10], [-10, -10]]],
    "objects": {
        "states": {"type": "GeometryCollection", "geometries": [
            {"type": "MultiPolygon", "arcs": [[[0, 1]], [[3]]], "properties": {"title": "West"}},
            {"type": "Polygon", "arcs": [[2, -1]], "properties": {"title": "East"}}]},
        "nation": {"type": "Polygon", "arcs": [[1, 2]]}}}"#;

/// The vertices and the triangles of each `o` of an OBJ.
fn groups(obj: &str) -> BTreeMap<String, Vec<[usize; 3]>> {
    let mut groups: BTreeMap<String, Vec<[usize; 3]>> = BTreeMap::new();
    let mut name = "";
    for line in obj.lines() {
        if let Some(own) = line.strip_prefix("o ") {
            name = own;
        } else if let Some(face) = line.strip_prefix("f ") {
            let corner = |word: &str| {
                word.split('/').next().expect("a word").parse::<usize>().expect("a number") - 1
            };
            let corners: Vec<usize> = face.split(' ').map(corner).collect();
            groups.entry(name.to_owned()).or_default().push([corners[0], corners[1], corners[2]]);
        }
    }
    groups
}

#[test]
fn polygons_that_share_borders_become_one_mesh() {
    let folder = folder(&[("states.json", STATES)]);
    let at = |name: &str| folder.path().join(name).to_str().expect("a name").to_owned();
    let (file, out) = (at("states.json"), at("out.obj"));
    let mesh = ["mesh", &file, "--layer", "states", "--name-by", "title", "--interior"];
    let run = mindeg([&mesh[..], &["--json", "-o", &out]].concat());
    assert_eq!(run.code, Some(0), "{}", run.errors);
    assert_eq!([&run.json()["regions"], &run.json()["parts"]], [3, 2]);
    let obj = text(Path::new(&out));
    let (points, groups) = (points(&obj), groups(&obj));
    assert_eq!(groups.keys().collect::<Vec<_>>(), ["East", "West"]);
    // Each point of the file is there, once.
    let number = |index: f64, scale: f64, move_by: f64| index * scale + move_by;
    let border = [[20.0, 0.0], [21.0, 10.0], [20.0, 20.0]];
    let others = [[0.0, 20.0], [0.0, 0.0], [40.0, 0.0], [40.0, 20.0], [60.0, 0.0], [70.0, 10.0]];
    let index_of = |[x, y]: [f64; 2]| {
        let point = [number(x, 0.1, 0.7), number(y, 0.1, 0.0)];
        let found: Vec<usize> = (0..points.len()).filter(|&at| points[at] == point).collect();
        let &[only] = &found[..] else { panic!("{point:?} is there {} times", found.len()) };
        only
    };
    others.into_iter().for_each(|point| _ = index_of(point));
    // Each edge of the border is one of a triangle on either side.
    let border = border.map(index_of);
    let has = |name: &str, a: usize, b: usize| {
        let edges = groups[name].iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        edges.filter(|edge| *edge == [a, b]).count()
    };
    for pair in border.windows(2) {
        assert_eq!([has("West", pair[0], pair[1]), has("East", pair[1], pair[0])], [1, 1]);
    }
    // The areas are those of the polygons.
    let area = |name: &str| -> f64 {
        let doubled = |&[a, b, c]: &[usize; 3]| {
            let [[ax, ay], [bx, by], [cx, cy]] = [a, b, c].map(|at| points[at]);
            (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        };
        groups[name].iter().map(doubled).sum::<f64>() / 2.0
    };
    for (name, expected) in [("West", 4.1 + 0.5), ("East", 3.9)] {
        assert!((area(name) - expected).abs() < 1e-12, "{name}: {}", area(name));
    }

    // One file each is possible, too; a part of its own has a domain.
    let run = mindeg([&mesh[..], &["--separate", "-q", "-o", &at("each/")]].concat());
    assert_eq!(run.code, Some(0), "{}", run.errors);
    assert_eq!(names_in(&folder.path().join("each")), ["East.obj", "West-1.obj", "West-2.obj"]);
    mindeg([&mesh[..], &["--separate", "-o", &out]].concat()).refuses(&["has 3 polygons, and"]);
    let run = mindeg(["degree", &file, "--layer", "nation"]);
    assert_eq!(run.code, Some(0), "{}", run.errors);
}

#[test]
fn layers_properties_and_overlaps_are_named() {
    let overlap = "POLYGON((0 0, 4 0, 4 4, 0 4)) POLYGON((2 2, 6 2, 6 6, 2 6))";
    let folder = folder(&[("a.json", STATES), ("b.wkt", overlap)]);
    let at = |name: &str| folder.path().join(name).to_str().expect("a name").to_owned();
    let (file, wkt, out) = (at("a.json"), at("b.wkt"), at("out.obj"));
    for (options, message) in [
        (&[&*file][..], "the file has several layers; choose one of \"nation\", \"states\""),
        (&[&file, "--layer", "x"], "no layer is \"x\"; the file has \"nation\", \"states\""),
        (
            &[&file, "--layer", "states", "--name-by", "name"],
            "no feature has the property \"name\"; they have \"title\"",
        ),
        (&[&wkt], "(4, 2): a border of polygon 1 meets one of polygon 2 there"),
        (&[&wkt, "--snap", "1"], "--repair"),
        (&[&wkt, "--name-by", "name"], "WKT has no properties; polygons are named by"),
        (&[&wkt, "--layer", "name"], "WKT has no layers; a layer is an object of TopoJSON"),
    ] {
        mindeg([&["mesh", "--interior", "-o", &out][..], options].concat()).refuses(&[message]);
        assert!(!Path::new(&out).exists());
    }
}

#[test]
fn a_repair_of_regions_keeps_their_borders_shared() {
    // The second covers a strip of the first, and lacks a point of the third by a little.
    let wkt = "POLYGON((0 0, 4 0, 4 4, 0 4)) POLYGON((3 0, 8 0, 8 4, 3 4)) POLYGON((8 0, 9 0, 9 4, 8 4, 8.00001 2))";
    let folder = folder(&[("a.wkt", wkt)]);
    let at = |name: &str| folder.path().join(name).to_str().expect("a name").to_owned();
    let (file, out) = (at("a.wkt"), at("out.obj"));
    let mesh = ["mesh", &file, "--interior", "-o", &out];
    let way_out = "; --repair mends such places, and says what it changes";
    mindeg(mesh).refuses(&["a border of polygon 1 meets one of polygon 2 there", way_out]);
    let islands = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/outlines/islands.geojson");
    mindeg(["domain", islands, "--repair", "--snap", "1m"]).refuses(&["--snap is in metres"]);
    let run = mindeg([&mesh[..], &["--repair", "--snap", "0.001m"]].concat());
    assert_eq!(run.code, Some(0), "{}", run.errors);
    for words in ["with points nearer than 0.001 as one", "gave an area of 4,", "in 1 part:"] {
        assert!(run.errors.contains(words), "{words}: {}", run.errors);
    }
    let obj = text(Path::new(&out));
    assert_eq!(groups(&obj).len(), 3);
}

/// Natural Earth's lands have some hundred ice shelves in others: one sentence named them all.
#[test]
fn of_many_polygons_that_are_left_out_a_few_are_named() {
    let inside = |x: u32| format!(" POLYGON(({x} 1, {0} 1, {0} 2, {x} 2))", x + 1);
    let wkt = (1..9).fold("POLYGON((0 0, 10 0, 10 4, 0 4))".to_owned(), |wkt, x| wkt + &inside(x));
    let folder = folder(&[("a.wkt", &wkt)]);
    let at = |name: &str| folder.path().join(name).to_str().expect("a name").to_owned();
    let run = mindeg(["mesh", &at("a.wkt"), "--interior", "--repair", "-o", &at("out.obj")]);
    assert_eq!(run.code, Some(0), "{}", run.errors);
    let words = "left out polygon 2, polygon 3, polygon 4, polygon 5, polygon 6, …, which";
    assert!(run.errors.contains(words), "{}", run.errors);
}

/// Regions that share a place, holes, lines that leave, slivers: each is refused with the place and what to do.
#[test]
fn bad_maps_are_refused_with_the_place() {
    let square = r#"{"rectangle": {"width": 4, "height": 4}, "size": 1, "#;
    let hole = r#""holes": [{"corners": [[1, 1], [2, 1], [2, 2], [1, 2]]}], "#;
    let json = |rest: &str| format!("{square}{rest}}}");
    let twice = "POLYGON((0 0, 4 0, 4 4, 0 4)) ";
    let across = r#"{"type": "MultiPolygon", "coordinates": [[[[178, 0], [-178, 0], [-178, 2], [178, 2]]],
        [[[0, 1], [2, 1], [2, 3], [0, 3]]]]}"#;
    let files: [(&str, String, [&str; 3]); 10] = [
        (
            "across.geojson",
            across.to_owned(),
            ["1 polygon with edges across the antimeridian", "--repair cuts", "there"],
        ),
        (
            "same.json",
            json(r#""regions": [{"at": [1, 1]}, {"at": [1, 1]}]"#),
            ["regions[1].at", "(1, 1) is at the point of region 1", "drop one"],
        ),
        (
            "face.json",
            json(r#""regions": [{"at": [1, 1]}, {"at": [3, 1]}]"#),
            ["regions[1].at", "(3, 1) lies in the same face", "draw a line between them"],
        ),
        (
            "hole.json",
            json(&format!(r#"{hole}"regions": [{{"at": [1.5, 1.5]}}]"#)),
            ["regions[0].at", "(1.5, 1.5) lies outside the domain", "move it inside"],
        ),
        (
            "leaves.json",
            json(r#""lines": [{"points": [[1, 1], [5, 2]]}]"#),
            ["lines[0]", "cross near (4, 1.75)", "the line leaves the domain"],
        ),
        (
            "in-hole.json",
            json(&format!(r#"{hole}"lines": [{{"points": [[1.2, 1.2], [1.5, 1.6]]}}]"#)),
            ["lines[0]", "leaves the domain near (1.2, 1.2)", "keep it inside"],
        ),
        (
            "drawn-twice.wkt",
            format!("{twice}POLYGON((4.0005 0, 8 0, 8 4, 4.0005 4))"),
            ["(4, 4)", "polygon 1 and polygon 2", "--repair --snap 0.001 closes it"],
        ),
        (
            "sliver.wkt",
            format!("{twice}POLYGON((4 0, 8 0, 8 4, 4 4, 4.0005 2))"),
            ["(4, 4)", "polygon 1 and polygon 2", "--repair --snap"],
        ),
        (
            "three.wkt",
            format!("{twice}POLYGON((4 0, 8 0, 8 4, 4 4)) POLYGON((4 0, 6 1, 6 3, 4 4))"),
            ["the edge from (4, 4) to (4, 0)", "polygon 2 and polygon 3", "--repair"],
        ),
        (
            "same.wkt",
            format!("{twice}{twice}"),
            ["the edge from (0, 0) to (4, 0)", "polygon 1 and polygon 2", "--repair"],
        ),
    ];
    let all: Vec<(&str, &str)> = files.iter().map(|(name, text, _)| (*name, &**text)).collect();
    let folder = folder(&all);
    let out = folder.path().join("out.obj");
    for (name, _, words) in &files {
        let path = folder.path().join(name);
        let run =
            mindeg(["mesh", path.to_str().unwrap(), "--interior", "-o", out.to_str().unwrap()]);
        run.refuses(&words[..]);
        assert!(!out.exists(), "{name}");
    }
}

/// Several shapes of WKT and SVG, and layers of a DXF, as one mesh.
#[test]
fn shapes_of_every_format_become_regions_by_name() {
    let dxf = |layer: &str, x: u32| {
        format!(
            "0\nLWPOLYLINE\n8\n{layer}\n70\n1\n10\n{x}\n20\n0\n10\n{}\n20\n0\n10\n{}\n20\n2\n10\n{x}\n20\n2\n",
            x + 2,
            x + 2
        )
    };
    let dxf =
        format!("0\nSECTION\n2\nENTITIES\n{}{}0\nENDSEC\n0\nEOF\n", dxf("sand", 0), dxf("clay", 2));
    let files = [
        (
            "a.wkt",
            "GEOMETRYCOLLECTION(POLYGON((0 0, 2 0, 2 2, 0 2)), MULTIPOLYGON(((2 0, 4 0, 4 2, 2 2)), ((4 0, 6 0, 6 2, 4 2))))",
        ),
        (
            "a.svg",
            "<svg><path id='left' d='M0 0h4v4h-4z'/><rect id='right' x='4' width='4' height='4'/></svg>",
        ),
        ("a.dxf", &*dxf),
    ];
    let folder = folder(&files);
    for (name, options, expected) in [
        ("a.wkt", &[][..], &["polygon_1", "polygon_2", "polygon_3"][..]),
        ("a.svg", &[], &["left", "right"]),
        ("a.dxf", &["--name-by", "layer"], &["clay", "sand"]),
        ("a.dxf", &["--layer", "Clay"], &["clay"]),
    ] {
        let [path, out] = [name, "out.obj"].map(|name| folder.path().join(name));
        let [path, out] = [&path, &out].map(|path| path.to_str().unwrap());
        let run =
            mindeg([&["mesh", path, "--interior", "--size", "1", "-o", out], options].concat());
        assert_eq!(run.code, Some(0), "{name}: {}", run.errors);
        let obj = text(Path::new(out));
        let found = groups(&obj);
        let found: Vec<&str> = found.keys().map(String::as_str).collect();
        assert_eq!(found, expected, "{name} {options:?}");
        fs::remove_file(out).expect("the mesh");
    }
}
