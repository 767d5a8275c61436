//! The contents of files, and the files that a run opens.

use crate::run::{Run, mindeg_reading, shell};
use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;
use tempfile::TempDir;

const SVG: &str = "<svg><circle id='lid' cx='5' cy='5' r='2'/></svg>";
const SQUARE: &str = "x,y\n0,0\n4,0\n4,3\n0,3\n";
const PLATE: &str = r#"{"rectangle": {"width": 4, "height": 3}, "size": 1}"#;
/// Vertices in the .node beside.
const POLY: &str = "0 2 0 0\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n";
const NODE: &str = "4 2 0 0\n1 0 0\n2 4 0\n3 4 3\n4 0 3\n";

/// A folder with these files.
fn folder(files: &[(&str, &str)]) -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, text) in files {
        fs::write(folder.path().join(name), text).expect("a file");
    }
    folder
}

fn run(folder: &Path, arguments: &str) -> Run {
    shell(folder, &format!("exec timeout 60 \"$MINDEG\" {arguments}"))
}

#[test]
fn every_command_that_takes_a_domain_takes_outlines() {
    let folder =
        folder(&[("icon.svg", SVG), ("square.csv", SQUARE), ("a.poly", POLY), ("a.node", NODE)]);
    let lines = "v 0 0 0\nv 4 0 0\nv 0 3 0\nl 1 2 3 1\n";
    fs::write(folder.path().join("lines.obj"), lines).expect("a file");
    for file in ["icon.svg", "square.csv", "a.poly", "lines.obj"] {
        for command in [
            "view FILE -o v.html",
            "mesh FILE -o m.obj",
            "degree FILE",
            "tradeoff FILE",
            "domain FILE",
            "compare FILE -o c.html",
        ] {
            let run = run(folder.path(), &command.replace("FILE", file));
            assert_eq!(run.code, Some(0), "{command} {file}: {run:?}");
        }
    }
    // A mesh is still shown unchanged, in any format.
    let made = "mesh square.csv -q -o s.msh -o s.node -o s.obj -o s.stl";
    assert_eq!(run(folder.path(), made).code, Some(0));
    for file in ["s.msh", "s.poly", "s.obj", "s.stl"] {
        let shown = run(folder.path(), &format!("view {file} --size 1 -o v.html"));
        shown.refuses(&["is a mesh, which is shown as it is"]);
        let run = run(folder.path(), &format!("view {file} -o v.html"));
        assert_eq!(run.code, Some(0), "{run:?}");
    }
}

#[test]
fn the_node_beside_a_poly_is_a_regular_file_of_its_folder() {
    let folder = folder(&[("a.poly", POLY), ("b.poly", POLY), ("c.poly", POLY)]);
    let outside = tempfile::NamedTempFile::new().expect("a file");
    fs::write(outside.path(), NODE).expect("a file");
    assert_eq!(shell(folder.path(), "mkfifo a.node").code, Some(0));
    symlink("/dev/zero", folder.path().join("b.node")).expect("a link");
    symlink(outside.path(), folder.path().join("c.node")).expect("a link");
    for (file, words) in [
        ("a.poly", "it is a pipe or a device"),
        ("b.poly", "it is not in the folder"),
        ("c.poly", "it is not in the folder"),
    ] {
        for command in ["domain FILE", "mesh FILE -o x.obj", "degree FILE"] {
            run(folder.path(), &command.replace("FILE", file)).refuses(&[file, words]);
        }
    }
}

#[test]
fn standard_input_tells_its_format_or_is_asked_for_it() {
    let folder = folder(&[("d.json", PLATE)]);
    let made = "mesh d.json -q -o m.stl -o m.14 -o m.node -o m.glb -o m.msh -o m.obj";
    assert_eq!(run(folder.path(), made).code, Some(0));
    for file in ["m.stl", "m.14", "m.glb", "m.msh", "m.obj"] {
        let run = run(folder.path(), &format!("inspect - < {file}"));
        assert_eq!(run.code, Some(0), "{file}: {run:?}");
        assert!(run.text().contains("maximum degree 4"), "{file}: {run:?}");
    }
    let of_node =
        "it looks like Triangle's .node, whose .ele is a second file; give the path of it";
    run(folder.path(), "inspect - < m.node").refuses(&[of_node]);
    let unknown = "the content tells no mesh format; give --format obj, glb,";
    run(folder.path(), "inspect - < d.json").refuses(&[unknown]);
}

#[test]
fn a_name_that_no_file_can_give_is_refused() {
    let folder = folder(&[("d.json", PLATE)]);
    let script = "exec \"$MINDEG\" mesh d.json -q -o \"$(printf '\\377.gltf')\"";
    shell(folder.path(), script).refuses(&["the name is not UTF-8 text", "has to name its .bin"]);
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 1);
}

#[test]
fn an_output_beside_the_one_that_is_named_is_told() {
    let folder = folder(&[("d.json", PLATE)]);
    assert_eq!(run(folder.path(), "mesh d.json -q -o d.node").code, Some(0));
    run(folder.path(), "improve d.node -o d.ele")
        .refuses(&["d.ele has d.poly beside it; d.poly is the mesh's data itself; give another"]);
}

#[test]
fn a_format_that_contradicts_the_name_is_told() {
    let folder = folder(&[("d.json", PLATE)]);
    run(folder.path(), "mesh d.json -o q.ply --format obj")
        .refuses(&["q.ply: the name tells its format, and --format asks for obj"]);
    assert_eq!(run(folder.path(), "mesh d.json -q -o q.obj --format obj").code, Some(0));
    assert_eq!(run(folder.path(), "mesh d.json -q -o q.tmp --format obj").code, Some(0));
}

#[test]
fn files_of_other_programs_are_refused_with_a_way_in() {
    let folder = folder(&[
        ("coast.shp", "\0\0\u{27}\n\0\0\0\0"),
        ("coast.zip", "PK\u{3}\u{4}coast.shp"),
        ("part.step", "ISO-10303-21;\nHEADER;\n"),
        ("x.geo", "lc = 0.15;\nPoint(1) = {0, 0, 0, lc};\n"),
    ]);
    for (file, words) in [
        ("coast.shp", "`ogr2ogr outline.geojson coast.shp` writes its polygons as GeoJSON"),
        (
            "coast.zip",
            "`ogr2ogr outline.geojson /vsizip/coast.zip` writes the polygons of a shapefile",
        ),
        ("part.step", "`gmsh -1 part.step -o outline.msh`"),
        ("x.geo", "`gmsh -1 x.geo -o outline.msh` writes its curves as an outline"),
    ] {
        run(folder.path(), &format!("domain {file}")).refuses(&[file, words]);
        run(folder.path(), &format!("mesh {file} -o m.obj")).refuses(&[words]);
        run(folder.path(), &format!("inspect {file}")).refuses(&[words]);
    }
}

#[test]
fn a_mesh_and_a_domain_the_wrong_way_round_are_to_be_swapped() {
    let folder = folder(&[("d.json", PLATE), ("square.csv", SQUARE)]);
    assert_eq!(run(folder.path(), "mesh square.csv -q -o m.obj").code, Some(0));
    for domain in ["d.json", "square.csv"] {
        let way = format!("{domain} is a domain; swap the two: mindeg verify m.obj {domain}");
        run(folder.path(), &format!("verify {domain} m.obj")).refuses(&[&way]);
    }
}

#[test]
fn a_polygon_without_a_name_takes_that_of_its_file() {
    let folder = folder(&[("part.csv", SQUARE)]);
    assert!(run(folder.path(), "domain part.csv").text().contains("    1  part: 4 points"));
    let run = run(folder.path(), "mesh part.csv -o m.obj");
    assert!(run.errors.starts_with("part: 4 vertices"), "{run:?}");
    let mesh = fs::read_to_string(folder.path().join("m.obj")).expect("it was written");
    assert!(mesh.contains("\no part\n"), "{mesh}");
}

#[test]
fn every_command_that_writes_says_so() {
    let folder = folder(&[("d.json", PLATE), ("a.obj", "v 0 0 0\nv 4 0 0\nv 0 3 0\nf 1 2 3\n")]);
    for (arguments, files) in [
        ("mesh d.json -o m.obj -o m.gltf", "wrote m.obj, m.gltf, m.bin"),
        ("tradeoff d.json -o page.html", "wrote page.html"),
        ("compare d.json -o c.html", "wrote c.html"),
        ("view d.json -o v.html", "wrote v.html"),
        ("convert a.obj -o c.glb", "wrote c.glb"),
        ("domain d.json -o e.json", "wrote e.json"),
    ] {
        let told = run(folder.path(), arguments);
        // What to do next comes after it, as that can take longer.
        let answer = told.errors.split("hint:").next().unwrap_or_default();
        assert!(answer.ends_with(&format!("{files}\n")), "{arguments}: {told:?}");
        if !arguments.starts_with("domain") {
            assert_eq!(run(folder.path(), &format!("{arguments} -q")).errors, "", "{arguments}");
        }
    }
}

/// A name with a color, a bell, a C1 control, a line break and a character that turns text round.
const EVIL: &str = "n\u{1b}[31mX\u{7}\u{9b}1m\u{202e}\nwrote all";

#[test]
fn no_name_of_a_file_steers_a_terminal() {
    let name = serde_json::to_string(EVIL).expect("JSON");
    let feature = |x: u32| {
        format!(
            r#"{{"type": "Feature", "properties": {{"name": {name}}}, "geometry": {{"type": "Polygon",
                "coordinates": [[[{x}, 0], [{x}.5, 0], [{x}, 1], [{x}, 0]]]}}}}"#
        )
    };
    let collection = |features: &[String]| {
        format!(r#"{{"type": "FeatureCollection", "features": [{}]}}"#, features.join(", "))
    };
    let dxf = "0\nSECTION\n2\nENTITIES\n0\nXX\u{1b}[31m\n8\n0\n0\nLWPOLYLINE\n8\nla\u{1b}]0;pwn\u{7}\n90\n3\n\
               70\n1\n10\n0\n20\n0\n10\n1\n20\n0\n10\n0\n20\n1\n0\nENDSEC\n0\nEOF\n";
    let folder = folder(&[
        ("one.geojson", &collection(&[feature(0)])),
        ("two.geojson", &collection(&[feature(0), feature(2)])),
        ("a.dxf", dxf),
        ("e\u{1b}[31m.csv", SQUARE),
    ]);
    for command in [
        "domain one.geojson",
        "domain two.geojson",
        "mesh two.geojson -o m.obj",
        "mesh one.geojson -o \"$(printf 'w\\033[31m.obj')\"",
        "mesh one.geojson -o \"$(printf 'no/w\\033[31m.obj')\"",
        "degree two.geojson",
        "domain a.dxf",
        "mesh a.dxf -o m.obj",
        "domain e*.csv",
        "inspect e*.csv",
        "mesh one.geojson e*.csv -o m.obj",
        "--color always mesh one.geojson e*.csv -o m.obj",
    ] {
        let run = run(folder.path(), command);
        let printed = format!("{}{}", run.text(), run.errors);
        let steers = |c: char| (c.is_control() && c != '\n') || c == '\u{202e}';
        let without_colors = printed.replace("\u{1b}[1m\u{1b}[31merror:\u{1b}[0m", "");
        assert!(!without_colors.contains(steers), "{command}: {printed:?}");
        assert!(!printed.contains("\nwrote all"), "{command}: {printed:?}");
    }
    // The name is the one that the domain gets.
    let text = run(folder.path(), "domain one.geojson");
    assert!(text.text().contains("  n [31mX  1m  wrote all: 3 points"), "{text:?}");
    let written = run(folder.path(), "mesh one.geojson -o \"$(printf 'w\\033[31m.obj')\"");
    assert!(written.errors.contains("\nwrote w\\u{1b}[31m.obj\n"), "{written:?}");
}

#[test]
fn outlines_come_by_standard_input_alone() {
    mindeg_reading(["domain", "-"], POLY.as_bytes())
        .refuses(&["standard input", "standard input has no folder where it could be"]);
}
