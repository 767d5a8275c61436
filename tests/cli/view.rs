//! The page for one mesh.

use crate::mesh::text;
use crate::run::{Run, ends_quietly_when_nobody_reads, mindeg, mindeg_reading};
use serde_json::Value;
use std::fs;

/// What is known of all meshes of a domain, in JSON.
const LIMITS: [&str; 4] = ["least_max_degree", "at_least", "angle_limit", "share_of_limit"];
const PLATE: [&str; 4] = ["--rectangle", "4x3", "--size", "0.5"];

/// A square of two triangles that stands upright: x to the right, z up.
const UPRIGHT: &str = "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nf 1 2 3\nf 1 3 4\n";

/// The page that a run writes to standard output.
#[track_caller]
fn page(arguments: &[&str]) -> String {
    let run = mindeg([&["view", "-o", "-"], arguments].concat());
    assert_eq!((run.code, run.errors.as_str()), (Some(0), ""));
    run.text().to_owned()
}

/// The figure of this name in a page.
#[track_caller]
fn figure<'a>(page: &'a str, name: &str) -> &'a str {
    let row = format!("<th scope=\"row\">{name}</th><td data-column=\"Value\">");
    assert!(page.contains(&row), "{name} is missing");
    let (_, after) = page.split_once(&row).expect("it is there");
    after.split_once("</td>").expect("the cell ends").0
}

#[test]
fn a_domain_is_shown_as_mesh_makes_it() {
    let folder = tempfile::tempdir().expect("a folder");
    for options in [&[][..], &["--keep-angle", "95%"], &["--max-degree", "5"], &["--interior"]] {
        let path = folder.path().join("plate.obj");
        let arguments = [&["mesh", "--json", "-o", text(&path)], &PLATE[..], options].concat();
        let made = mindeg(arguments).json();
        let own = page(&[&PLATE, options].concat());
        let shown = folder.path().join("plate.html");
        let command = [&["view", "--json", "-o", text(&shown)], &PLATE[..], options].concat();
        let shown = mindeg(command).json();
        for key in LIMITS {
            assert_eq!(shown[key], made[key], "{options:?} {key}");
        }
        // A mesh within a degree is found without the largest angle.
        let has_angle = !options.contains(&"--max-degree");
        let is_known = LIMITS.map(|key| !shown[key].is_null());
        assert_eq!(is_known[1..], [true, has_angle, has_angle], "{shown}");
        // Of a mesh from a file nothing is known.
        let of_file = folder.path().join("file.html");
        let of_file = mindeg(["view", text(&path), "--json", "-o", text(&of_file)]).json();
        assert!(LIMITS.iter().all(|key| of_file.get(key) == Some(&Value::Null)), "{of_file}");
        let read = page(&[text(&path)]);
        for page in [&own, &read] {
            for (name, key) in [
                ("Vertices", "vertices"),
                ("Triangles", "triangles"),
                ("Maximum degree", "max_degree"),
            ] {
                assert_eq!(figure(page, name), made[key].to_string(), "{options:?}");
            }
            let angle: f64 =
                figure(page, "Minimum angle").trim_end_matches('°').parse().expect("°");
            assert!((angle - made["min_angle"].as_f64().expect("a number")).abs() < 0.01);
            let is_ring = page.contains(r#""is_ring":true"#);
            assert_eq!(
                is_ring,
                !options.contains(&"--interior"),
                "all vertices are on the boundary"
            );
        }
    }
}

#[test]
fn the_page_is_complete_and_says_what_made_it() {
    let page = page(&PLATE);
    assert!(page.contains("default-src 'none'"), "a policy that forbids requests");
    assert!(!page.contains("http://") && !page.contains("https://"), "nothing from elsewhere");
    assert!(page.contains("<code>mindeg view -o - --rectangle 4x3 --size 0.5</code>"));
    assert!(!page.contains("Thinned out") && !page.contains("class SpaceStage"));
}

#[test]
fn a_mesh_in_space_is_turned() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("upright.obj");
    fs::write(&path, UPRIGHT).expect("a file");
    let page = page(&[text(&path)]);
    assert!(page.contains("Drag to turn") && page.contains("class SpaceStage"), "{page}");
    assert_eq!(figure(&page, "Minimum angle"), "45.000°");
}

#[test]
fn vertices_in_one_place_are_one_and_quads_are_cut() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("split.obj");
    let split = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 -0\n\
                 f 1 2 3 4\nf 5 6 7 8\n";
    fs::write(&path, split).expect("a file");
    let page = page(&[text(&path)]);
    assert_eq!((figure(&page, "Vertices"), figure(&page, "Triangles")), ("6", "4"));
    assert!(page.contains("2 vertices of the file have the coordinates of an earlier one"));
    assert!(page.contains("Quads and larger polygons are shown as the triangles"));
}

#[test]
fn triangles_left_out_of_the_drawing_are_told() {
    let page = page(&["--rectangle", "4x3", "--intervals", "25001,25001,25001,25001"]);
    assert!(page.contains("100\u{202f}000 of 100\u{202f}002 triangles are drawn"));
    assert_eq!(figure(&page, "Triangles"), "100\u{202f}002");
}

#[test]
fn what_is_no_mesh_and_no_domain_is_refused() {
    let view = |arguments: &[&str]| -> Run { mindeg([&["view"], arguments].concat()) };
    let folder = tempfile::tempdir().expect("a folder");
    let mesh = folder.path().join("a.obj");
    fs::write(&mesh, "v 0 0 0\nv 4 0 0\nv 0 3 0\nf 1 2 3\n").expect("a file");
    let mesh = text(&mesh);
    for (arguments, words) in [
        (&["-o", "a.html"][..], &["no domain: name its file"][..]),
        (&["a.obj", "-o", "a.png"], &["-o a.png: a view ends in .html"]),
        (&[mesh, "--size", "1", "-o", "a.html"], &["a.obj is a mesh", "--size is for domains"]),
        (&[mesh, "--keep-angle", "1", "-o", "a.html"], &["--keep-angle is for domains"]),
        (&["a.obj"], &["where to? name a file, such as -o view.html"]),
        (&["a.obj", "a.html"], &["give every output with -o: -o a.html"]),
        (&["a.obj", "b.obj", "-o", "a.html"], &["one mesh at a time: b.obj is a second one"]),
        (
            &["--rectangle", "4x3", "--size", "1", "--max-degree", "2", "-o", "a.html"],
            &["no triangulation here has maximum degree 2; the least is 4"],
        ),
    ] {
        view(arguments).refuses(words);
    }
    let missing = view(&["no-such.obj", "-o", "a.html"]);
    assert_eq!(missing.code, Some(1), "{missing:?}");
    assert!(missing.errors.contains("cannot read no-such.obj"), "{missing:?}");
}

#[test]
fn a_domain_comes_from_standard_input_and_a_closed_pipe_is_no_failure() {
    let domain = br#"{"name": "a plate", "rectangle": {"width": 4, "height": 3}, "size": 1}"#;
    let run = mindeg_reading(["view", "-", "-o", "-"], domain);
    assert_eq!(run.code, Some(0), "{run:?}");
    assert!(run.text().contains("<h1>a plate</h1>"));
    ends_quietly_when_nobody_reads(["view", "--rectangle", "4x3", "--size", "0.01", "-o", "-"]);
}

/// A whole model is shown by its mesh.
#[test]
fn a_model_is_shown() {
    let folder = tempfile::tempdir().expect("a folder");
    let page = folder.path().join("cube.html").display().to_string();
    let cube = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/models/cube.json");
    let least = mindeg(["view", cube, "-o", &page, "--json"]).json();
    assert!(std::fs::metadata(&page).is_ok());
    let inside = mindeg(["view", cube, "--interior", "-o", &page, "--json"]).json();
    let obj = folder.path().join("cube.obj");
    let made = mindeg(["mesh", cube, "-o", text(&obj), "--json"]).json();
    let own = |key: &&str| least[*key] == made[*key] && !made[*key].is_null();
    assert!(LIMITS[..2].iter().all(own), "{least} {made}");
    assert!(LIMITS.iter().all(|key| inside.get(key) == Some(&Value::Null)), "{inside}");
    assert!(inside["vertices"].as_u64() > least["vertices"].as_u64(), "{least} {inside}");
}
