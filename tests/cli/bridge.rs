//! `mindeg bridge`.

use crate::fill::{cone, cones};
use crate::mesh::{content, text};
use crate::run::{Run, mindeg, shell};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

/// A folder with these files, and a run of `bridge` there that writes `out.obj`.
fn bridge(files: &[(&str, &str)], options: &[&str]) -> (tempfile::TempDir, Run) {
    let folder = tempfile::tempdir().expect("a folder");
    let mut arguments = vec!["bridge".to_owned()];
    for (name, content) in files {
        let path = folder.path().join(name);
        fs::write(&path, content).expect("a file");
        arguments.push(text(&path).to_owned());
    }
    arguments.extend(["-o".to_owned(), text(&folder.path().join("out.obj")).to_owned()]);
    arguments.extend(options.iter().map(|option| (*option).to_owned()));
    let run = mindeg(arguments);
    (folder, run)
}

fn inspected(folder: &Path) -> Value {
    mindeg(["inspect", text(&folder.join("out.obj")), "--json"]).json()
}

#[test]
fn two_meshes_are_joined_into_one_that_is_closed() {
    for n in [12, 7, 3] {
        let files = [("lower.obj", &*cone(12, 1.0, 0.0)), ("upper.obj", &*cone(n, 2.0, 3.0))];
        let (folder, run) = bridge(&files, &["--json"]);
        let found = run.json();
        // Three edges at each vertex, one of the strip, and the even share of the others.
        let least = json!(4 + 12_usize.div_ceil(n));
        for key in ["max_degree", "least_max_degree", "at_least"] {
            assert_eq!(found[key], least, "{key}");
        }
        assert_eq!(found["triangles"], 12 + n + 12 + n);
        assert_eq!(found["strip"], json!([12 + n, 24 + 2 * n]));
        assert_eq!((&found["planar"], &found["crossings"]), (&json!(false), &json!([])));
        assert!(run.errors.contains("the least possible, as counting proves"), "{}", run.errors);
        let mesh = inspected(folder.path());
        assert_eq!(
            (&mesh["boundary_loops"], &mesh["euler_characteristic"]),
            (&json!(0), &json!(2))
        );
        for defect in ["non_manifold_edges", "non_manifold_vertices", "inconsistent_edges"] {
            assert_eq!(mesh[defect], json!([]), "{defect}");
        }
        assert_eq!(mesh["components"], 1);
        // Both loops of one file give the same strip.
        if n == 7 {
            let (_folder, run) = bridge(&[("both.obj", &cones())], &["--json"]);
            let again = run.json();
            for key in ["max_degree", "min_angle", "strip", "vertices", "triangles"] {
                assert_eq!(again[key], found[key], "{key}");
            }
        }
    }
}

#[test]
fn values_at_vertices_that_either_file_has_are_told() {
    let lower = cone(6, 1.0, 0.0) + "vn 0 0 1\n";
    let upper = cone(6, 2.0, 3.0) + "vt 0 0\nvn 0 0 1\n";
    let (_folder, run) = bridge(&[("lower.obj", &lower), ("upper.obj", &upper)], &["--json"]);
    let kinds = ["normals of the file", "texture coordinates"];
    let sentence = format!("\nNot in the mesh: {}.\n", kinds.join(", "));
    assert!(run.errors.contains(&sentence), "{run:?}");
    assert_eq!(run.json()["dropped"], json!(kinds));
}

#[test]
fn a_higher_degree_is_taken_where_it_is_allowed() {
    let files = [("lower.obj", &*cone(12, 1.0, 0.0)), ("upper.obj", &*cone(7, 2.0, 3.0))];
    let (_folder, run) = bridge(&files, &["--json", "--max-degree", "9"]);
    let found = run.json();
    assert!(found["min_angle"].as_f64() >= found["angle_without_limit"].as_f64().map(|a| a - 1e-9));
    let (folder, run) = bridge(&files, &["--max-degree", "5"]);
    run.refuses(&["maximum degree 5; the least is 6"]);
    assert_eq!(content(folder.path()), ["lower.obj", "upper.obj"]);
    let (folder, run) = bridge(&files, &["--target-angle", "59"]);
    assert_eq!(run.code, Some(3), "{run:?}");
    assert!(run.errors.contains("below the target angle of 59°"), "{}", run.errors);
    assert_eq!(content(folder.path()), ["lower.obj", "upper.obj"]);
}

/// A square ring in a plane: a hole within four triangles pairs.
const FRAME: &str = "v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nv 2 2 0\nv 7 2 0\nv 7 7 0\nv 2 7 0\n\
                     f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

#[test]
fn in_a_plane_nothing_folds() {
    let patch = "v 4 4 0\nv 5 4 0\nv 5.5 5 0\nv 4 5 0\nf 1 2 3 4\n";
    let (folder, run) =
        bridge(&[("frame.obj", FRAME), ("patch.obj", patch)], &["--from", "v4", "--json"]);
    assert_eq!(run.json()["planar"], true);
    let mesh = inspected(folder.path());
    assert!((mesh["area"].as_f64().expect("an area") - 81.0).abs() < 1e-12);
    assert_eq!((&mesh["boundary_loops"], &mesh["euler_characteristic"]), (&json!(1), &json!(1)));

    let outside = "v 14 4 0\nv 15 4 0\nv 15 5 0\nv 14 5 0\nf 1 2 3 4\n";
    let face_down = "v 4 4 0\nv 5 4 0\nv 5 5 0\nv 4 5 0\nf 4 3 2 1\n";
    for other in [outside, face_down] {
        let (_folder, run) =
            bridge(&[("frame.obj", FRAME), ("other.obj", other)], &["--from", "v4"]);
        run.refuses(&["both loops lie in one plane", "one must lie inside"]);
    }
}

#[test]
fn loops_must_be_named_where_there_are_several() {
    let patch = "v 4 4 1\nv 5 4 1\nv 5 5 1\nv 4 5 1\nf 1 2 3 4\n";
    let closed = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    let (frame, patch, closed) =
        (("frame.obj", FRAME), ("patch.obj", patch), ("closed.obj", closed));
    let three = cones() + "o third\nv 5 0 0\nv 6 0 0\nv 6 1 0\nv 5 1 0\nf 22 23 24 25\n";
    let three = ("three.obj", &*three);
    for (files, options, words) in [
        (
            &[frame, patch][..],
            &[][..],
            &[
                "frame.obj has 2 boundary loops; name one with --from; its loops are:",
                "loop 2 (4 vertices from vertex 4 on), around 4.5,4.5,0",
            ][..],
        ),
        (&[patch, frame], &[], &["frame.obj has 2 boundary loops; name one with --to"]),
        (&[patch], &[], &["patch.obj has 1 boundary loop; a bridge takes two: give a second mesh"]),
        (&[closed, patch], &[], &["closed.obj has no boundary loop; it is closed"]),
        (&[three], &["--from", "1"], &["three.obj has 3 boundary loops; name one with --to"]),
        (&[three], &["--from", "1", "--to", "v0"], &["both ends of the bridge are loop 1"]),
        (&[three], &["--from", "7"], &["three.obj has no loop 7"]),
    ] {
        let (_folder, run) = bridge(files, options);
        run.refuses(words);
    }
    let (_folder, run) = bridge(&[three], &["--from", "5,0,0", "--to", "v14", "--json"]);
    let found = run.json();
    assert_eq!((&found["from"]["loop"], &found["to"]["loop"]), (&json!(3), &json!(2)));
}

#[test]
fn a_mesh_inside_out_is_a_warning() {
    // Cones that both open upward: one would have to be turned over.
    let files = [("lower.obj", &*cone(24, 1.0, 0.0)), ("upper.obj", &*cone(24, 2.0, 1.5))];
    let (_folder, run) = bridge(&files, &[]);
    assert_eq!(run.code, Some(0), "{run:?}");
    assert!(run.errors.contains("warning: the strip is twisted"), "{}", run.errors);
}

#[cfg(unix)]
#[test]
fn any_number_of_threads_writes_the_same_bytes() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("m.obj"), cones()).expect("a file");
    for threads in [1, 2, 7] {
        let script =
            format!("RAYON_NUM_THREADS={threads} \"$MINDEG\" bridge m.obj -q -o {threads}.obj");
        let run = shell(folder.path(), &script);
        assert_eq!(run.code, Some(0), "{run:?}");
    }
    let read =
        |threads: u32| fs::read(folder.path().join(format!("{threads}.obj"))).expect("a file");
    assert!(read(1) == read(2) && read(1) == read(7));
}

/// The messages of a run, without the folder's path.
fn message(folder: &tempfile::TempDir, run: &Run) -> String {
    run.errors.replace(&format!("{}/", folder.path().display()), "").trim_end().to_owned()
}

#[test]
fn hostile_input_ends_in_one_clear_message() {
    let closed = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    let two_points = "v 0 0 0\nv 1 0 0\nl 1 2\n";
    let not_finite = "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n";
    let turned = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 3 4\n";
    let touching = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 1 0\nv 2 2 0\nv 1 2 0\nf 1 2 3 4\n\
                    f 3 5 6 7\n";
    for (files, options, expected) in [
        (
            &[("a.obj", closed)][..],
            &[][..],
            "error: a.obj has 0 boundary loops; a bridge takes two: give a second mesh",
        ),
        (
            &[("a.obj", closed), ("b.obj", square)],
            &[],
            "error: a.obj has no boundary loop; it is closed",
        ),
        (
            &[("b.obj", square), ("a.obj", closed)],
            &[],
            "error: a.obj has no boundary loop; it is closed",
        ),
        (
            &[("a.obj", square)],
            &[],
            "error: a.obj has 1 boundary loop; a bridge takes two: give a second mesh",
        ),
        (
            &[("a.obj", two_points), ("b.obj", square)],
            &[],
            "error: a.obj: the mesh has no triangle (2 vertices)",
        ),
        (
            &[("a.obj", not_finite), ("b.obj", square)],
            &[],
            "error: a.obj: line 2: the coordinate \"nan\" is not a finite number",
        ),
        (
            &[("a.obj", ""), ("b.obj", square)],
            &[],
            "error: a.obj: the mesh has no triangle (0 vertices)",
        ),
        (
            &[("a.obj", turned), ("b.obj", square)],
            &[],
            "error: loop 1 cannot be bridged: its faces do not agree in orientation: at edge 1-3 they turn over",
        ),
        (
            &[("a.obj", touching)],
            &[],
            "error: the loops touch at vertex 2; a bridge needs loops without a common vertex",
        ),
        (
            &[("a.obj", square), ("b.obj", square)],
            &["--max-degree", "-1"],
            "error: invalid value '-1' for '--max-degree <D>': give a whole number of 0 or more, such \
             as 5\n\nFor more information, try '--help'.",
        ),
    ] {
        let (folder, run) = bridge(files, options);
        run.refuses(&[]);
        assert_eq!(message(&folder, &run), expected);
        assert!(!folder.path().join("out.obj").exists());
    }
    // The same file as both meshes.
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.obj");
    fs::write(&path, square).expect("a file");
    let output = folder.path().join("out.obj");
    let run = mindeg(["bridge", text(&path), text(&path), "-o", text(&output)]);
    run.refuses(&[]);
    assert_eq!(
        message(&folder, &run),
        "error: the loops touch: vertex 0 of the first mesh and vertex 0 of the second are at the \
         same place; move one of the meshes"
    );
}

#[test]
fn linked_and_huge_loops_are_bridged_and_told() {
    // Two squares that are links of a chain.
    let flat = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n";
    let upright = "v 1 1 -1\nv 3 1 -1\nv 3 1 1\nv 1 1 1\nf 1 2 3 4\n";
    let (_folder, run) = bridge(&[("flat.obj", flat), ("upright.obj", upright)], &["--json"]);
    assert_ne!(run.json()["crossings"], json!([]));
    assert!(run.errors.contains("cross others, the first "), "{}", run.errors);
    // Coordinates near the ends of what numbers can hold.
    for size in ["1e300", "1e-300"] {
        let at =
            |z: &str| format!("v 0 0 {z}\nv {size} 0 {z}\nv {size} {size} {z}\nv 0 {size} {z}\n");
        let lower = at("0") + "f 4 3 2 1\n";
        let upper = at(size) + "f 1 2 3 4\n";
        let (_folder, run) = bridge(&[("a.obj", &lower), ("b.obj", &upper)], &["--json"]);
        let found = run.json();
        assert_eq!((&found["strip"], &found["max_degree"]), (&json!([4, 12]), &json!(5)), "{size}");
    }
}

/// A tube of `n` faces around between two heights, and at the rim of each end.
fn ring(n: usize, heights: [f64; 2]) -> String {
    let turn = |i: usize| std::f64::consts::TAU * i as f64 / n as f64;
    let points = heights
        .iter()
        .flat_map(|z| (0..n).map(move |i| format!("v {} {} {z}\n", turn(i).cos(), turn(i).sin())));
    let faces = (0..n).map(|i| {
        let [a, b] = [i + 1, (i + 1) % n + 1];
        format!("f {a} {b} {}\nf {b} {} {}\n", a + n, b + n, a + n)
    });
    points.chain(faces).collect()
}

#[test]
fn ends_far_apart_are_joined_with_points_between() {
    let files = [("lower.obj", &*ring(16, [0.0, 0.4])), ("upper.obj", &*ring(16, [5.0, 5.4]))];
    let ends = ["--from", "v16", "--to", "v0"];
    let (_, plain) = bridge(&files, &[&ends[..], &["--json"]].concat());
    let (folder, run) = bridge(&files, &[&ends[..], &["--json", "--interior"]].concat());
    let (plain, found) = (plain.json(), run.json());
    assert_eq!((&plain["vertices_inside"], &plain["violations"]), (&Value::Null, &json!([])));
    assert_eq!((&found["violations"], &found["crossings"]), (&json!([]), &json!([])));
    assert_eq!(found["vertices_inside"][0], 64);
    let [least, most] = [0, 1].map(|i| found["degrees"][i].as_u64().unwrap());
    assert!(least >= 5 && most <= 7 && found["max_degree"] == most, "{found}");
    let angle = |of: &Value| of["min_angle"].as_f64().unwrap();
    assert!(angle(&plain) < 6.0 && angle(&found) > 30.0, "{plain} {found}");
    assert!(run.errors.contains("points inside: degrees 5 to"), "{}", run.errors);
    let mesh = inspected(folder.path());
    assert_eq!((&mesh["boundary_loops"], &mesh["components"]), (&json!(2), &json!(1)));
}
