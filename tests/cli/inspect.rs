use crate::run::{Run, mindeg, mindeg_reading};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

fn text(path: &Path) -> &str {
    path.to_str().expect("paths here are UTF-8")
}

/// A folder, and a file in it.
fn file(name: &str, content: impl AsRef<[u8]>) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join(name);
    fs::write(&path, content).expect("a file");
    (folder, path)
}

fn inspect_obj(content: &str, options: &[&str]) -> Run {
    let (_folder, path) = file("mesh.obj", content);
    mindeg(["inspect", text(&path)].iter().chain(options))
}

/// A square of two triangles, a triangle on its right side that occurs twice, a flat one on its
/// left; an unused vertex; a pentagon of three triangles apart; a line.
const BROKEN: &str = "\
v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0.5 0\nv 9 9 9\n\
v 5 0 0\nv 6 0 0\nv 6.5 1 0\nv 5.5 2 0\nv 4.5 1 0\n\
f 1 2 3\nf 1 3 4\nf 2 5 3\nf 5 3 2\nf 1 4 4\nf 7 8 9\nf 7 9 10\nf 7 10 11\nl 1 2 3\n";

#[test]
fn what_is_wrong_comes_first() {
    let run = inspect_obj(BROKEN, &[]);
    assert_eq!((run.code, run.errors.as_str()), (Some(0), ""));
    let lines: Vec<&str> = run.text().lines().collect();
    assert!(
        lines[0].contains("5 kinds of defects; maximum degree 4, angles from 0°"),
        "{}",
        lines[0]
    );
    let words = |line: &str| line.split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(
        lines[1..6].iter().map(|line| words(line)).collect::<Vec<_>>(),
        [
            "non-manifold edges 1 1-2",
            "edges with inconsistent winding 2 1-4, 2-4",
            "duplicate faces 1 3",
            "zero-area triangles 1 4",
            "unreferenced vertices 1 5",
        ]
    );
    let said = "2 line segments and 0 points";
    assert!(run.text().contains(said), "{said:?} is missing in: {}", run.text());
}

#[test]
fn json_holds_what_is_known_of_a_mesh() {
    let found = inspect_obj(BROKEN, &["--json", "--poles-above", "3"]).json();
    for (key, expected) in [
        ("vertices", json!(11)),
        ("welded_vertices", json!(0)),
        ("triangles", json!(8)),
        ("quads", json!(0)),
        ("polygons", json!(0)),
        ("line_segments", json!(2)),
        ("points", json!(0)),
        ("not_read", json!([])),
        ("faces", json!(7)),
        ("edges", json!(14)),
        ("boundary_edges", json!(8)),
        ("boundary_loops", json!(1)),
        ("open_boundaries", json!(1)),
        ("components", json!(2)),
        ("euler_characteristic", json!(3)),
        ("non_manifold_edges", json!([[1, 2]])),
        ("non_manifold_vertices", json!([])),
        ("inconsistent_edges", json!([[1, 4], [2, 4]])),
        ("duplicate_faces", json!([3])),
        ("duplicate_triangles", json!([3])),
        ("zero_area_triangles", json!([4])),
        ("unreferenced_vertices", json!([5])),
        ("max_degree", json!(4)),
        ("degree_histogram", json!({"boundary": {"2": 3, "3": 4, "4": 2}, "interior": {"2": 1}})),
        (
            "poles",
            json!([
                {"vertex": 2, "degree": 4, "on_boundary": true, "position": [1.0, 1.0, 0.0]},
                {"vertex": 6, "degree": 4, "on_boundary": true, "position": [5.0, 0.0, 0.0]},
            ]),
        ),
        ("outline", Value::Null),
    ] {
        assert_eq!(found[key], expected, "{key}");
    }
    // JSON has no number for infinity.
    assert_eq!(found["metrics"]["edge_ratio"]["max"], Value::Null);
    assert_eq!(found["worst_triangles"][0]["triangle"], 4);
}

#[test]
fn a_mesh_of_ours_has_its_known_figures_in_every_format() {
    let folder = tempfile::tempdir().expect("a folder");
    let files = ["obj", "glb", "gltf"].map(|end| folder.path().join("plate").with_extension(end));
    let arguments = ["mesh", "--rectangle", "4x3", "--intervals", "12,9,4,4", "--json"];
    let outputs = files.iter().flat_map(|file| ["-o", text(file)]);
    let summary = mindeg(arguments.into_iter().chain(outputs)).json();
    for file in &files {
        let found = mindeg(["inspect", text(file), "--json"]).json();
        assert_eq!(found["file"], text(file));
        assert_eq!((&found["vertices"], &found["faces"]), (&json!(29), &json!(27)));
        assert_eq!((&found["edges"], &found["boundary_edges"]), (&json!(55), &json!(29)));
        assert_eq!(found["euler_characteristic"], 1);
        assert_eq!(found["max_degree"], summary["max_degree"]);
        assert_eq!(found["degree_histogram"]["interior"], json!({}));
        assert_eq!(
            found["outline"],
            json!({"corners": [0, 12, 21, 25], "intervals": [12, 9, 4, 4], "least_max_degree": 5})
        );
        assert_eq!(found["no_outline"], Value::Null);
        for key in ["min_angle", "max_angle"] {
            let [found, expected] = [&found, &summary].map(|json| json[key].as_f64());
            let ratio = found.expect("an angle") / expected.expect("an angle");
            assert!((ratio - 1.0).abs() < 1e-5, "{key} in {}", text(file));
        }
    }
    let run = mindeg(["inspect", text(&files[0])]);
    assert!(run.text().contains("4 sides with 12, 9, 4, 4 intervals"), "{}", run.text());
    assert!(run.text().contains("least maximum degree for it is 5, as this mesh has 5"));
}

#[test]
fn seams_are_welded_unless_asked() {
    let seam = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 4 5 6\n";
    for (options, components, welded) in [(&["--json"][..], 1, 2), (&["--json", "--no-weld"], 2, 0)]
    {
        let found = inspect_obj(seam, options).json();
        assert_eq!(
            (&found["components"], &found["welded_vertices"]),
            (&json!(components), &json!(welded))
        );
    }
    assert!(inspect_obj(seam, &[]).text().contains("merged with an earlier one: 2"));
}

#[test]
fn a_tolerance_merges_near_vertices() {
    let seam =
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1e-9 0\nv 1 1.000000001 0\nv 0 1 0\nf 1 2 3\nf 4 5 6\n";
    for (options, components, welded) in [
        (&["--json"][..], 2, 0),
        (&["--json", "--weld", "0"], 2, 0),
        (&["--json", "--weld", "5e-10"], 2, 0),
        (&["--json", "--weld", "2e-9"], 1, 2),
    ] {
        let found = inspect_obj(seam, options).json();
        let counts = (&found["components"], &found["welded_vertices"]);
        assert_eq!(counts, (&json!(components), &json!(welded)), "{options:?}");
    }
    for tolerance in ["-1", "nan", "inf", "near"] {
        inspect_obj(seam, &["--weld", tolerance]).refuses(&["--weld", "a length, 0 or more"]);
    }
    inspect_obj(seam, &["--weld", "1", "--no-weld"]).refuses(&["--weld", "--no-weld"]);
}

#[test]
fn a_thin_rectangle_has_its_outline_or_is_too_thin_to_tell() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("thin.obj");
    let mesh = |size: &str| {
        let arguments = ["mesh", "--rectangle", size, "--intervals", "4,2,4,3", "-q", "-o"];
        assert_eq!(mindeg(arguments.iter().chain(&[text(&path)])).code, Some(0));
        mindeg(["inspect", text(&path), "--json"]).json()
    };
    let found = mesh("1x1e-7");
    assert_eq!(found["outline"]["intervals"], json!([4, 2, 4, 3]));
    assert_eq!(found["outline"]["least_max_degree"], found["max_degree"]);
    let found = mesh("1x1e-14");
    assert_eq!(found["outline"], Value::Null);
    let reason = found["no_outline"].as_str().expect("a reason");
    assert!(reason.contains("to tell"), "{reason}");
}

#[test]
fn corners_that_32_bit_floats_move_are_too_fine_to_tell() {
    let domain = r#"{"polygon": {"corners": [[-200.06209578396403, 149.03416137923696],
        [-297.8174489286897, -24.081040154789186], [264.19810801890065, -94.74963434519486]]},
        "sides": [{"intervals": 3}, {"intervals": 8, "spacing": {"first_length": 1e-5}},
        {"intervals": 3}]}"#;
    let (folder, path) = file("tri.json", domain);
    let files = ["obj", "glb"].map(|end| folder.path().join("tri").with_extension(end));
    let run = mindeg(["mesh", text(&path), "-q", "-o", text(&files[0]), "-o", text(&files[1])]);
    assert_eq!(run.code, Some(0), "{run:?}");
    let [obj, glb] = files.map(|path| mindeg(["inspect", text(&path), "--json"]).json());
    assert_eq!(obj["outline"]["intervals"], json!([3, 8, 3]));
    assert_eq!(obj["outline"]["least_max_degree"], 5);
    assert_eq!(glb["outline"], Value::Null);
    let reason = glb["no_outline"].as_str().expect("a reason");
    assert!(reason.contains("too fine to tell"), "{reason}");
}

/// Runs `inspect -` with what it reads.
fn inspect_input(content: &[u8], options: &[&str]) -> Run {
    mindeg_reading(["inspect", "-"].iter().chain(options), content)
}

#[test]
fn standard_input_is_read_in_every_format() {
    let folder = tempfile::tempdir().expect("a folder");
    let files = ["obj", "glb"].map(|end| folder.path().join("plate").with_extension(end));
    let mesh = ["mesh", "--rectangle", "4x3", "--intervals", "3,3,2,2", "-q"];
    let outputs = files.iter().flat_map(|file| ["-o", text(file)]);
    assert_eq!(mindeg(mesh.into_iter().chain(outputs)).code, Some(0));
    for path in &files {
        let found = inspect_input(&fs::read(path).expect("it is there"), &["--json", "-q"]).json();
        assert_eq!((&found["file"], &found["faces"]), (&json!("standard input"), &json!(8)));
    }
    let obj = fs::read(&files[0]).expect("it is there");
    assert_eq!(inspect_input(&obj, &["--format", "obj"]).code, Some(0));
    inspect_input(&obj, &["--format", "glb"]).refuses(&["standard input", "JSON"]);
    inspect_input(b"", &[]).refuses(&["standard input is empty; a mesh is expected"]);
    let outside = br#"{"asset":{"version":"2.0"},"buffers":[{"uri":"a.bin","byteLength":4}]}"#;
    inspect_input(outside, &[]).refuses(&["standard input", "a.bin", "no folder"]);
    mindeg(["inspect", text(&files[0]), "--format", "obj"])
        .refuses(&["--format", "the name of a file"]);
}

#[test]
fn an_outline_depends_on_the_angle_of_corners() {
    let bent = "v 0 0 0\nv 1 -0.02 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 5\nf 2 4 5\nf 2 3 4\n";
    for (angle, intervals) in [("1", json!([1, 1, 1, 1, 1])), ("3", json!([2, 1, 1, 1]))] {
        let found = inspect_obj(bent, &["--json", "--corner-angle", angle]).json();
        assert_eq!(found["outline"]["intervals"], intervals, "{angle}");
    }
    inspect_obj(bent, &["--corner-angle", "91"]).refuses(&["--corner-angle", "0 to 90"]);
    inspect_obj(bent, &["--corner-angle", "-1"]).refuses(&["--corner-angle", "0 to 90"]);
    let dart = "v 0 0 0\nv 2 -1 0\nv 1 0 0\nv 2 1 0\nf 1 2 3\nf 1 3 4\n";
    let run = inspect_obj(dart, &[]);
    assert!(
        run.text().contains("The least maximum degree of triangles for it is 3"),
        "{}",
        run.text()
    );
}

/// A fan of 10 triangles in a half disk, with angles of 18 degrees at vertex 0.
fn fan() -> String {
    let mut obj = "v 0 0 0\n".to_owned();
    for i in 0..=10 {
        let angle = f64::from(18 * i).to_radians();
        obj += &format!("v {} {} 0\n", angle.cos(), angle.sin());
    }
    (2..12).for_each(|i| obj += &format!("f 1 {i} {}\n", i + 1));
    obj
}

#[test]
fn gates_end_with_code_3_and_name_what_fails() {
    for (gates, words) in [
        (&["--max-degree", "11", "--target-angle", "17.9"][..], &[][..]),
        (&["--max-degree", "10"], &["vertex 0 has 11 edges", "more than the maximum degree of 10"]),
        (
            &["--target-angle", "20"],
            &["triangle ", "vertices 0, ", "below the target angle of 20°"],
        ),
        (&["--max-degree", "10", "--target-angle", "20"], &["vertex 0 has", "triangle "]),
    ] {
        let run = inspect_obj(&fan(), gates);
        let code = if words.is_empty() { 0 } else { 3 };
        assert_eq!(run.code, Some(code), "{run:?}");
        // The report is printed nevertheless.
        assert!(run.text().contains("maximum degree 11"), "{run:?}");
        assert_eq!(run.errors.is_empty(), words.is_empty(), "{run:?}");
        for word in words {
            assert!(run.errors.contains(word), "{word:?} is missing in: {}", run.errors);
        }
    }
    for angle in ["61", "-1", "nan", "steep"] {
        inspect_obj(&fan(), &["--target-angle", angle]).refuses(&["--target-angle", "0 to 60"]);
    }
}

#[test]
fn gates_hold_when_nobody_reads_the_report() {
    let (_folder, path) = file("fan.obj", fan());
    let mut child = Command::new(env!("CARGO_BIN_EXE_mindeg"))
        .args(["inspect", text(&path), "--max-degree", "4"])
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("the binary starts");
    drop(child.stdout.take());
    assert_eq!(child.wait().expect("the run ends").code(), Some(3));
}

#[test]
fn a_mesh_that_fails_its_gates_is_not_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("plate.obj");
    let mesh = |gates: &[&str]| {
        let arguments =
            ["mesh", "--rectangle", "4x3", "--intervals", "12,9,4,4", "-o", text(&path)];
        mindeg(arguments.iter().chain(gates))
    };
    let kept_angle = ["--keep-angle", "95%", "--max-degree", "5"];
    for (gates, word) in [
        (&kept_angle[..], "maximum degree of 5"),
        (&["--target-angle", "30"], "target angle of 30°"),
    ] {
        let run = mesh(gates);
        assert_eq!(run.code, Some(3), "{run:?}");
        assert!(run.errors.contains(word), "{run:?}");
        assert!(!path.exists(), "{gates:?}");
    }
    let passed = mesh(&["--max-degree", "5", "--target-angle", "1"]);
    assert_eq!(passed.code, Some(0), "{passed:?}");
    // The same vertex and triangle as the file's.
    let [from_mesh, from_file] = [
        mesh(&["--keep-angle", "0%", "--max-degree", "4", "--target-angle", "30"]).errors,
        mindeg(["inspect", text(&path), "--max-degree", "4", "--target-angle", "30"]).errors,
    ];
    let named = |errors: &str| -> Vec<u32> {
        let numbers = errors.split(|c: char| !c.is_ascii_digit()).filter(|part| !part.is_empty());
        numbers.take(6).map(|part| part.parse().expect("digits")).collect()
    };
    assert_eq!(named(&from_mesh), named(&from_file), "{from_mesh}{from_file}");
}

#[test]
fn what_cannot_be_read_is_code_1_and_what_is_broken_code_2() {
    let missing = mindeg(["inspect", "no/such.obj"]);
    assert_eq!(missing.code, Some(1), "{missing:?}");
    assert!(missing.errors.contains("cannot read no/such.obj"), "{missing:?}");
    for (name, content, words) in [
        ("mesh.svg", "<svg>", &["mesh.svg", "mindeg writes .svg", ".obj, .glb, .gltf"][..]),
        ("mesh.vtk", "<VTKFile>", &["mesh.vtk", "the name ends in .vtk", "end in .vtu"]),
        ("mesh", "", &[".obj, .glb, .gltf"]),
        ("mesh.obj", "", &["mesh.obj", "no triangle"]),
        ("mesh.obj", "v 0 0 0\nf 1 2 3\n", &["mesh.obj", "line 2", "vertex 3"]),
        ("MESH.OBJ", "v 0 0\n", &["line 1"]),
        ("mesh.glb", "glTF", &["mesh.glb", "header"]),
        ("mesh.gltf", "{", &["mesh.gltf", "JSON"]),
    ] {
        let (_folder, path) = file(name, content);
        mindeg(["inspect", text(&path)]).refuses(words);
    }
}

/// A .gltf with its .bin, in a folder.
fn gltf() -> (tempfile::TempDir, PathBuf, PathBuf) {
    let folder = tempfile::tempdir().expect("a folder");
    let [gltf, bin] = ["plate.gltf", "plate.bin"].map(|name| folder.path().join(name));
    let arguments =
        ["mesh", "--rectangle", "4x3", "--intervals", "3,3,2,2", "-q", "-o", text(&gltf)];
    assert_eq!(mindeg(arguments).code, Some(0));
    (folder, gltf, bin)
}

#[test]
fn a_gltf_has_its_files_in_its_folder() {
    let (folder, gltf, bin) = gltf();
    let document = fs::read_to_string(&gltf).expect("it is there");
    for name in ["../plate.bin", "/etc/passwd", "a/../../plate.bin"] {
        fs::write(&gltf, document.replace("plate.bin", name)).expect("a file");
        mindeg(["inspect", text(&gltf)]).refuses(&[name, "not in the folder"]);
    }
    for name in ["./plate.bin", "plate%2ebin", "below/plate.bin"] {
        fs::create_dir_all(folder.path().join("below")).expect("a folder");
        fs::copy(&bin, folder.path().join("below/plate.bin")).expect("a file");
        fs::write(&gltf, document.replace("plate.bin", name)).expect("a file");
        let run = mindeg(["inspect", text(&gltf)]);
        assert_eq!(run.code, Some(0), "{run:?}");
    }
    fs::write(&gltf, document).expect("a file");
    let whole = fs::read(&bin).expect("it is there");
    fs::write(&bin, &whole[..whole.len() - 1]).expect("a file");
    mindeg(["inspect", text(&gltf)]).refuses(&["plate.gltf", "buffers[0]"]);
    fs::remove_file(&bin).expect("it is there");
    let run = mindeg(["inspect", text(&gltf)]);
    assert_eq!(run.code, Some(1), "{run:?}");
    assert!(run.errors.contains("plate.bin"), "{run:?}");
}

#[test]
fn files_cut_short_are_refused_or_read_for_what_they_hold() {
    let folder = tempfile::tempdir().expect("a folder");
    let [obj, glb] = ["plate.obj", "plate.glb"].map(|name| folder.path().join(name));
    let mesh = ["mesh", "--rectangle", "4x3", "--intervals", "3,3,2,2", "-q"];
    assert_eq!(mindeg(mesh.iter().chain(&["-o", text(&obj), "-o", text(&glb)])).code, Some(0));
    let whole = fs::read(&glb).expect("it is there");
    for length in (0..whole.len()).step_by(whole.len() / 20) {
        fs::write(&glb, &whole[..length]).expect("a file");
        mindeg(["inspect", text(&glb)]).refuses(&["plate.glb"]);
    }
    let whole = fs::read(&obj).expect("it is there");
    for length in (0..whole.len()).step_by(whole.len() / 20) {
        fs::write(&obj, &whole[..length]).expect("a file");
        let run = mindeg(["inspect", text(&obj)]);
        assert!(matches!(run.code, Some(0 | 2)), "{length}: {run:?}");
    }
}

/// The keys of all objects, such as `poles[].vertex`. Keys that are numbers are data, and those
/// of `metrics` are all the same.
fn keys(value: &Value, path: &str, into: &mut BTreeSet<String>) {
    match value {
        Value::Object(map) => {
            for (key, value) in map {
                if key.parse::<u32>().is_ok() {
                    continue;
                }
                let key = if path == "metrics" { "*" } else { key };
                let path = if path.is_empty() { key.into() } else { format!("{path}.{key}") };
                keys(value, &path, into);
                into.insert(path);
            }
        }
        Value::Array(items) => {
            items.iter().for_each(|item| keys(item, &format!("{path}[]"), into));
        }
        _ => {}
    }
}

#[test]
fn every_key_is_documented() {
    let documentation = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/inspect.md");
    let documentation = fs::read_to_string(documentation).expect("the documentation is there");
    let (_, table) = documentation.split_once("| key |").expect("a table of keys");
    let (table, measures) = table.split_once("\n\n").expect("what follows the table");
    let rows = table.lines().filter_map(|line| line.strip_prefix("| `"));
    let documented: BTreeSet<String> =
        rows.filter_map(|row| row.split_once('`')).map(|(key, _)| key.to_owned()).collect();

    let (_folder, gltf, _) = gltf();
    let found = mindeg(["inspect", text(&gltf), "--json", "--poles-above", "3"]).json();
    let mut there = BTreeSet::new();
    keys(&found, "", &mut there);
    assert_eq!(there, documented);

    let help = mindeg(["inspect", "--help"]);
    for key in found.as_object().expect("an object").keys() {
        let mut words = help.text().split(|c: char| !c.is_alphanumeric() && c != '_');
        assert!(words.any(|word| word == key), "{key} is missing in the help");
    }
    for name in found["metrics"].as_object().expect("an object").keys() {
        assert!(measures.contains(&format!("| `{name}` |")), "{name}");
    }
}

#[test]
fn the_same_file_gives_the_same_bytes() {
    let bytes = |option| inspect_obj(BROKEN, option).output;
    for option in [&["--json"][..], &[]] {
        let [one, other] = [bytes(option), bytes(option)].map(|bytes| {
            let text = String::from_utf8(bytes).expect("text");
            // But for its path.
            text.split_once("mesh.obj").expect("the path").1.to_owned()
        });
        assert_eq!(one, other);
    }
}

#[test]
fn a_format_that_the_content_told_is_named_with_its_fault() {
    let ele = "6 3 0\n 1 1 2 8\n 2 2 7 8\n 3 2 3 7\n 4 3 6 7\n 5 3 4 6\n 6 4 5 6\n";
    let run = mindeg_reading(["inspect", "-"], ele.as_bytes());
    run.refuses(&[
        "standard input: line ",
        "; the content looks like ",
        "if it is another format, give --format",
    ]);
    let told = mindeg_reading(["inspect", "-", "--format", "off"], ele.as_bytes());
    assert!(!told.errors.contains("looks like"), "{}", told.errors);
}
