//! `mindeg fill`.

use crate::mesh::{content, text};
use crate::run::{Run, mindeg, shell};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

/// A cone without its base, as an OBJ: `n` vertices round the z axis at height `base`, and a tip.
pub(crate) fn cone(n: usize, base: f64, tip: f64) -> String {
    let mut text = String::from("o cone\n");
    cone_at(&mut text, n, base, tip, 0);
    text
}

/// Two cones that open towards each other.
pub(crate) fn cones() -> String {
    let mut text = String::from("o lower\n");
    cone_at(&mut text, 12, 1.0, 0.0, 0);
    text += "o upper\n";
    cone_at(&mut text, 7, 2.0, 3.0, 13);
    text
}

fn cone_at(text: &mut String, n: usize, base: f64, tip: f64, before: usize) {
    for i in 0..n {
        let angle = std::f64::consts::TAU * i as f64 / n as f64;
        *text += &format!("v {} {} {base}\n", angle.cos(), angle.sin());
    }
    *text += &format!("v 0 0 {tip}\n");
    for i in 0..n {
        let [a, b] = [i, (i + 1) % n].map(|i| before + i + 1);
        let [a, b] = if tip > base { [a, b] } else { [b, a] };
        *text += &format!("f {a} {b} {}\n", before + n + 1);
    }
}

fn fill(name: &str, content: &str, options: &[&str]) -> (tempfile::TempDir, Run) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join(name);
    fs::write(&path, content).expect("a file");
    let output = folder.path().join("out.obj");
    let run = mindeg(["fill", text(&path), "-o", text(&output)].iter().chain(options));
    (folder, run)
}

fn inspected(folder: &Path, name: &str) -> Value {
    mindeg(["inspect", text(&folder.join(name)), "--json"]).json()
}

#[track_caller]
fn assert_closed(folder: &Path, name: &str, euler: i64) {
    let found = inspected(folder, name);
    assert_eq!((&found["boundary_loops"], &found["open_boundaries"]), (&json!(0), &json!(0)));
    assert_eq!(found["euler_characteristic"], euler);
    for defect in ["non_manifold_edges", "non_manifold_vertices", "inconsistent_edges"] {
        assert_eq!(found[defect], json!([]), "{defect}");
    }
}

#[test]
fn a_cone_is_closed_and_the_summary_says_how() {
    let (folder, run) = fill("cone.obj", &cone(30, 0.0, 2.0), &["--json"]);
    let found = run.json();
    assert_eq!((&found["vertices"], &found["triangles"]), (&json!(31), &json!(58)));
    let [filled] = &found["filled"].as_array().expect("a list")[..] else { panic!("{found}") };
    for (key, expected) in [
        ("loop", json!(1)),
        ("vertices", json!(30)),
        ("first_vertex", json!(0)),
        ("limit", json!(6)),
        ("triangles", json!([30, 58])),
    ] {
        assert_eq!(filled[key], expected, "{key}");
    }
    assert!(filled["max_degree"].as_u64().expect("a degree") <= 6);
    // A regular polygon of 30 vertices.
    let area = 15.0 * (std::f64::consts::TAU / 30.0).sin();
    assert!((filled["area"].as_f64().expect("an area") - area).abs() < 1e-9);
    assert_eq!((&found["left_open"], &found["crossings"]), (&json!([]), &json!([])));
    assert!(run.errors.contains("filled 1 loop with 28 triangles"), "{}", run.errors);
    assert_closed(folder.path(), "out.obj", 2);
    let written = fs::read_to_string(folder.path().join("out.obj")).expect("a file");
    assert!(written.contains("fill"), "the group has its name");
}

/// Two vertices at one place are one on both sides of a seam: the apex has 4 edges, not 5.
#[test]
fn values_at_vertices_that_the_mesh_lacks_are_told() {
    let cone = cone(6, 1.0, 0.0) + "vt 0 0\n";
    let (_folder, run) = fill("cone.obj", &cone, &["--json"]);
    assert!(run.errors.contains("\nNot in the mesh: texture coordinates.\n"), "{run:?}");
    assert_eq!(run.json()["dropped"], json!(["texture coordinates"]));
}

#[test]
fn the_degree_of_a_filled_mesh_counts_a_seam_once() {
    let cone = "v 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nv 1 0 0\nf 1 2 3\nf 1 3 4\nf 1 4 5\nf 1 5 6\n";
    let (folder, run) = fill("seam.obj", cone, &["--json"]);
    assert_eq!(run.json()["max_degree"], 4);
    assert_eq!(inspected(folder.path(), "out.obj")["max_degree"], 4);
}

#[test]
fn an_angle_that_is_demanded_of_new_triangles_is_kept_or_nothing_is_written() {
    let (folder, run) = fill("cone.obj", &cone(30, 0.0, 2.0), &["--target-angle", "20"]);
    assert_eq!(run.code, Some(3), "{run:?}");
    assert!(run.errors.contains("below the target angle of 20°"), "{}", run.errors);
    let triangle = run.errors.split("triangle ").nth(1).and_then(|rest| rest.split(' ').next());
    // The cone has the first 30.
    assert!(triangle.and_then(|index| index.parse().ok()) >= Some(30_u32), "{}", run.errors);
    assert_eq!(content(folder.path()), ["cone.obj"]);
    let (_folder, run) = fill("cone.obj", &cone(30, 0.0, 2.0), &["--target-angle", "1"]);
    assert_eq!(run.code, Some(0), "{run:?}");
}

#[test]
fn the_old_mesh_stays_bit_for_bit() {
    // Numbers with all their digits, names, quads, and a line.
    let mesh = "o shell\nv 0.1 0.30000000000000004 1e-300\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\nv 0.5 0.5 2\n\
                v 0.25 0.5 1\nv 0.75 0.5 1\ng near\nf 1 2 7 6\nf 2 3 7\ng far\nf 3 4 6 7\nf 4 1 6\nl 1 3\n";
    let (folder, run) = fill("shell.obj", mesh, &["-q"]);
    assert_eq!((run.code, run.errors.as_str()), (Some(0), ""));
    let folder = folder.path();
    let positions = |name: &str| -> Vec<Vec<u64>> {
        let text = fs::read_to_string(folder.join(name)).expect("a file");
        let vertices = text.lines().filter_map(|line| line.strip_prefix("v "));
        let bits = |x: &str| x.parse::<f64>().expect("a number").to_bits();
        vertices.map(|line| line.split_whitespace().map(bits).collect()).collect()
    };
    assert_eq!(positions("shell.obj"), positions("out.obj"));
    assert_closed(folder, "out.obj", 2);
    // Each list starts with the values that mindeg writes for the mesh alone.
    let [shell, same] = ["shell.obj", "same.obj"].map(|name| folder.join(name));
    let convert = ["convert", text(&shell), "-q", "-o"];
    assert_eq!(mindeg(convert.iter().chain(&[text(&same)])).code, Some(0));
    let faces = |name: &str| -> Vec<String> {
        let text = fs::read_to_string(folder.join(name)).expect("a file");
        let keys = ["f ", "g ", "o "];
        let lines = text.lines().filter(|line| keys.iter().any(|key| line.starts_with(key)));
        // Normals are made anew.
        let corner = |word: &str| word.split('/').next().unwrap_or_default().to_owned();
        lines.map(|line| line.split(' ').map(corner).collect::<Vec<_>>().join(" ")).collect()
    };
    let (before, after) = (faces("same.obj"), faces("out.obj"));
    assert_eq!(before[..], after[..before.len()]);
    assert!(after[before.len()].ends_with(" fill"), "{:?}", &after[before.len()..]);
}

#[test]
fn loops_are_chosen_by_number_vertex_and_point() {
    for (choice, filled) in
        [("1", 1), ("2", 2), ("v0", 1), ("v15", 2), ("0,0,0.5", 1), ("9,9,9", 2)]
    {
        let (_folder, run) = fill("both.obj", &cones(), &["--json", "--loop", choice]);
        let found = run.json();
        assert_eq!(found["filled"].as_array().map(Vec::len), Some(1), "{choice}");
        assert_eq!(found["filled"][0]["loop"], filled, "{choice}");
    }
    let (folder, run) = fill("both.obj", &cones(), &["--loop", "2", "--loop", "1"]);
    assert_eq!(run.code, Some(0), "{run:?}");
    assert_closed(folder.path(), "out.obj", 4);
    for (choice, words) in [
        (
            "3",
            &["both.obj has no loop 3; its loops are:", "loop 2 (7 vertices from vertex 13 on)"][..],
        ),
        ("v12", &["no boundary loop through vertex 12"]),
        ("v99999999", &["no boundary loop through vertex 99999999"]),
        ("0", &["--loop", "the index of a loop from 1, such as 2"]),
        ("1,2", &["--loop", "a point near it such as 0,0,1.5"]),
    ] {
        let (folder, run) = fill("both.obj", &cones(), &["--loop", choice]);
        run.refuses(words);
        assert_eq!(content(folder.path()), ["both.obj"]);
    }
}

#[test]
fn what_cannot_be_filled_is_refused_or_stays_open_with_a_reason() {
    let closed = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let three = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 2 1 4\nf 1 2 5\n";
    let turned = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 3 4\n";
    for (mesh, options, words) in [
        (closed, &[][..], &["m.obj has no boundary loop; it is closed"][..]),
        (triangle, &[], &["no loop to fill", "the boundary of a single triangle"]),
        (three, &[], &["no loop to fill", "an edge with three faces or more"]),
        (turned, &[], &["no loop to fill", "do not agree in orientation"]),
        (
            &cone(40, 0.0, 1.0),
            &["--max-loop", "40"],
            &["it has 40 vertices, and only loops below 40"],
        ),
        (
            &cone(40, 0.0, 1.0),
            &["--max-degree", "4"],
            &["m.obj: loop 1 from vertex 0: no triangulation", "maximum degree 4; the least is 5"],
        ),
        (&cone(2001, 0.0, 1.0), &["--max-loop", "9999"], &["2001 vertices; the maximum is 2000"]),
        (&cone(9, 0.0, 1.0), &["--max-degree", "few"], &["--max-degree", "whole number"]),
    ] {
        let (folder, run) = fill("m.obj", mesh, options);
        run.refuses(words);
        assert_eq!(content(folder.path()), ["m.obj"]);
    }
    // One loop is filled, and one stays open.
    let (_folder, run) = fill("both.obj", &cones(), &["--max-loop", "12", "--json"]);
    let found = run.json();
    assert_eq!(found["left_open"][0]["loop"], 1);
    assert!(
        run.errors.contains("loop 1 (12 vertices from vertex 0 on) stays open"),
        "{}",
        run.errors
    );
}

/// A wavy loop of `n` vertices round the z axis, with a collar of triangles outside it.
fn wavy_collar(n: usize) -> String {
    let mut text = String::new();
    for scale in [1.0, 1.4] {
        for i in 0..n {
            let angle = std::f64::consts::TAU * i as f64 / n as f64;
            let point = [angle.cos(), angle.sin(), 0.4 * (6.0 * angle).cos()];
            let [x, y, z] = point.map(|coordinate| scale * coordinate);
            text += &format!("v {x} {y} {z}\n");
        }
    }
    for i in 1..=n {
        let next = i % n + 1;
        text += &format!("f {next} {i} {}\nf {next} {} {}\n", n + i, n + i, n + next);
    }
    text
}

#[test]
fn the_least_degree_without_much_more_area_is_chosen() {
    let filled = |options: &[&str]| {
        let options = [&["--loop", "v0", "--json"], options].concat();
        let (_folder, run) = fill("wavy.obj", &wavy_collar(24), &options);
        (run.json()["filled"][0].clone(), run.errors)
    };
    let (chosen, errors) = filled(&[]);
    assert_eq!((&chosen["limit"], &chosen["least_limit"]), (&json!(8), &json!(6)), "{chosen}");
    let area = |found: &Value, key: &str| found[key].as_f64().expect("an area");
    let least = area(&chosen, "area_without_limit");
    assert!(area(&chosen, "area") <= 1.05 * least);
    assert!(area(&chosen, "area_at_least_limit") > 1.5 * least);
    let told = "degree limit 8, the least that takes at most 5% more area than no limit; area ";
    assert!(errors.contains(told), "{errors}");
    assert!(errors.contains("; --max-degree 6 takes 61.9% more"), "{errors}");
    // Any area, so the least limit; and that limit by name.
    let (least_limit, errors) = filled(&["--extra-area", "inf"]);
    assert_eq!((&least_limit["limit"], &least_limit["least_limit"]), (&json!(6), &Value::Null));
    assert!(errors.contains("degree limit 6; area "), "{errors}");
    assert_eq!(filled(&["--max-degree", "6"]).0, least_limit);
    // No more area at all.
    let (none, _) = filled(&["--extra-area", "0"]);
    assert_eq!(none["area"], none["area_without_limit"]);
    for wrong in ["-1%", "much", "nan"] {
        let (_folder, run) = fill("wavy.obj", &wavy_collar(24), &["--extra-area", wrong]);
        run.refuses(&["--extra-area", "give a share of 0 or more, such as 0.05, or 5%; or inf"]);
    }
    let both = ["--extra-area", "1%", "--max-degree", "7"];
    fill("wavy.obj", &wavy_collar(24), &both).1.refuses(&["--max-degree"]);
}

#[test]
fn crossings_are_a_warning() {
    // A needle through the opening of a cone.
    let mesh = cone(8, 0.0, 2.0) + "v 0.3 0.2 -1\nv 0.3 0.2 0.1\nv 0.3 0.25 0.1\nf 10 11 12\n";
    let (_folder, run) = fill("needle.obj", &mesh, &["--json"]);
    assert_eq!(run.json()["crossings"].as_array().map(Vec::len), Some(1));
    assert!(run.errors.contains("warning: a new triangle crosses another one"), "{}", run.errors);
}

#[test]
fn hostile_meshes_end_in_a_message() {
    for (name, content) in [
        ("m.obj", "f 1 2 3\n"),
        ("m.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n"),
        ("m.obj", ""),
        ("m.glb", "glTF\u{2}"),
        ("m.txt", "v 0 0 0\n"),
    ] {
        let (_folder, run) = fill(name, content, &[]);
        run.refuses(&[name]);
    }
    let (_folder, run) = fill("huge.obj", &cone(9, -1e300, 1e300), &["--json"]);
    assert_eq!(run.json()["filled"][0]["triangles"], json!([9, 16]));
}

#[cfg(unix)]
#[test]
fn any_number_of_threads_writes_the_same_bytes() {
    let folder = tempfile::tempdir().expect("a folder");
    // Several loops, of which two touch in a vertex.
    let mut mesh = cone(90, 0.3, 2.0);
    cone_at(&mut mesh, 30, 1.0, -3.0, 91);
    mesh += "v 9 0 0\nv 9 1 0\nv 8 1 0\nv 8 0 1\nv 9 -1 0\nv 10 -1 0\nv 9 0 1\n";
    mesh += "f 123 124 125 126\nf 123 127 128 129\n";
    fs::write(folder.path().join("m.obj"), mesh).expect("a file");
    for threads in [1, 2, 7] {
        let script = format!(
            "RAYON_NUM_THREADS={threads} \"$MINDEG\" fill m.obj -q -o {threads}.obj -o {threads}.glb"
        );
        let run = shell(folder.path(), &script);
        assert_eq!(run.code, Some(0), "{run:?}");
    }
    let read = |name: String| fs::read(folder.path().join(name)).expect("a file");
    for format in ["obj", "glb"] {
        for threads in [2, 7] {
            assert_eq!(read(format!("{threads}.{format}")), read(format!("1.{format}")));
        }
    }
}

/// A frame of eight triangles round a square hole, flat.
const FRAME: &str = "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 2 1 0\nv 2 2 0\nv 1 2 0\nf 1 2 6\nf 1 6 5\nf 2 3 7\n\
                     f 2 7 6\nf 3 4 8\nf 3 8 7\nf 4 1 5\nf 4 5 8\n";

#[test]
fn the_rim_of_a_flat_sheet_stays_open_unless_it_is_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let [file, out] = ["frame.obj", "closed.obj"].map(|name| folder.path().join(name));
    std::fs::write(&file, FRAME).expect("a file");
    let [file, out] = [&file, &out].map(|path| path.to_str().expect("a name"));
    let run = mindeg(["fill", file, "-o", out]);
    assert_eq!(run.code, Some(0), "{}", run.errors);
    for words in [
        "filled 1 loop with 2 triangles",
        "loop 1 (4 vertices from vertex 0 on) stays open: it is the rim",
        "hint: --loop 1 fills the rim all the same",
    ] {
        assert!(run.errors.contains(words), "{words}: {}", run.errors);
    }
    assert!(!run.errors.contains("cross"), "{}", run.errors);
    let run = mindeg(["fill", out, "-o", file]);
    // The way out is told once.
    assert!(!run.errors.contains("name it"), "{}", run.errors);
    run.refuses(&["no loop to fill", "rim of a flat sheet", "--loop 1 fills the rim all the same"]);
    let run = mindeg(["fill", out, "-o", &format!("{out}.obj"), "--loop", "1"]);
    assert!(run.errors.contains("filled 1 loop"), "{}", run.errors);
    assert!(!run.errors.contains("--loop"), "{}", run.errors);
}

#[test]
fn points_inside_are_told_with_their_degrees() {
    let (folder, run) = fill("cone.obj", &cone(24, 0.0, 2.0), &["--interior", "--json"]);
    let found = run.json();
    let filled = &found["filled"][0];
    let [first, end] = [0, 1].map(|at: usize| filled["vertices_inside"][at].as_u64());
    assert_eq!((first, end), (Some(25), found["vertices"].as_u64()));
    assert_eq!((&filled["violations"], &filled["without_points"]), (&json!([]), &Value::Null));
    assert!(
        filled["degrees"][0].as_u64() >= Some(5) && filled["degrees"][1].as_u64() <= Some(7),
        "{filled}"
    );
    assert_closed(folder.path(), "out.obj", 2);
    let (_, run) = fill("cone.obj", &cone(24, 0.0, 2.0), &["--interior"]);
    assert!(run.errors.contains("points inside, degrees 5 to "), "{}", run.errors);
}
