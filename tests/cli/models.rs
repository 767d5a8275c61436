use crate::mesh::text;
use crate::run::{Run, mindeg};
use serde_json::{Value, json};
use std::fs;
use std::path::{Path, PathBuf};

fn model(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/models").join(name)
}

fn mesh<'a>(file: &'a Path, outputs: &'a [PathBuf], more: &'a [&'a str]) -> Run {
    let outputs = outputs.iter().flat_map(|file| ["-o", text(file)]);
    mindeg(["mesh", text(file), "--json"].into_iter().chain(outputs).chain(more.iter().copied()))
}

fn inspected(file: &Path) -> Value {
    mindeg(["inspect", text(file), "--json"]).json()
}

#[test]
fn models_become_watertight_meshes() {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, more, degree, genus, volume) in [
        ("cube.json", &[][..], 6, 0, 1.0),
        ("house.json", &[], 6, 0, 192.0),
        // Two bores with 12 sides through plates of 6: 60*6 + 44*6 square, 40 wide.
        ("bracket.json", &[], 7, 2, (60.0 * 6.0 + 44.0 * 6.0) * 40.0 - 2.0 * 192.0 * 6.0),
        ("bracket.obj", &["--size", "4"], 7, 2, 24960.0 - 2.0 * 192.0 * 6.0),
    ] {
        let files = ["obj", "glb"].map(|end| folder.path().join("part").with_extension(end));
        let summary = mesh(&model(name), &files, more).json();
        assert_eq!((&summary["closed"], &summary["notes"]), (&json!(true), &json!([])), "{name}");
        assert_eq!(summary["max_degree"], degree, "{name}");
        assert_eq!(summary["lower_bound"], degree, "{name}");
        for file in &files {
            let found = inspected(file);
            assert_eq!((&found["closed"], &found["manifold"]), (&json!(true), &json!(true)));
            assert_eq!(found["genus"], genus, "{name}");
            assert_eq!(found["max_degree"], degree, "{name}");
            let inside = found["volume"].as_f64().expect("a volume");
            // The corners of the bores have four digits.
            assert!((inside / volume - 1.0).abs() < 1e-5, "{name}: {inside} {volume}");
            assert_eq!(found["inconsistent_edges"], json!([]));
        }
    }
}

#[test]
fn groups_and_named_edges_get_into_the_files() {
    let folder = tempfile::tempdir().expect("a folder");
    let files = [folder.path().join("house.obj")];
    let summary = mesh(&model("house.json"), &files, &["--boundary-lines"]).json();
    let groups: Vec<_> = summary["groups"].as_array().expect("groups").iter().collect();
    assert_eq!(groups.len(), 3);
    assert_eq!((&groups[0]["name"], &groups[0]["material"]), (&json!("walls"), &json!("brick")));
    assert_eq!(groups[0]["faces"], 4);
    let written = fs::read_to_string(&files[0]).expect("the file");
    for line in ["walls_brick", "floor_concrete", "roof_tiles", "ridge"] {
        assert!(written.lines().any(|at| at.ends_with(line)), "{line}");
    }
}

#[test]
fn a_mesh_of_triangles_becomes_a_model_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let triangles = [folder.path().join("triangles.glb")];
    mesh(&model("cube.json"), &triangles, &["--quiet"]);
    let files = [folder.path().join("again.obj")];
    let summary = mesh(&triangles[0], &files, &["--intervals", "3"]).json();
    assert_eq!((&summary["faces"], &summary["vertices"]), (&json!(6), &json!(32)));
    assert_eq!((&summary["max_degree"], &summary["lower_bound"]), (&json!(6), &json!(6)));
}

#[test]
fn the_angle_that_is_asked_for_is_kept() {
    let folder = tempfile::tempdir().expect("a folder");
    let files = [folder.path().join("house.obj")];
    let summary = mesh(&model("house.json"), &files, &["--keep-angle", "95%"]).json();
    assert!(summary["angle_share"].as_f64().expect("a share") >= 0.95);
    assert!(summary["max_degree"].as_u64() >= summary["lower_bound"].as_u64());
}

#[test]
fn faces_with_interior_points_stay_watertight() {
    let folder = tempfile::tempdir().expect("a folder");
    let files = ["obj", "glb"].map(|end| folder.path().join("part").with_extension(end));
    let summary = mesh(&model("bracket.json"), &files, &["--interior"]).json();
    assert!(summary["interior_points"].as_u64() > Some(20), "{summary}");
    let found = inspected(&files[0]);
    assert_eq!((&found["closed"], &found["genus"]), (&json!(true), &json!(2)));
    assert!((found["volume"].as_f64().expect("a volume") / 22656.0 - 1.0).abs() < 1e-5);
    assert_eq!(found["max_degree"], summary["max_degree"]);
    assert!(found["min_angle"].as_f64() > Some(20.0));
    assert_eq!(inspected(&files[1])["closed"], true);
}

#[test]
fn threads_change_no_byte() {
    let folder = tempfile::tempdir().expect("a folder");
    let written = |threads: &str| {
        let file = folder.path().join(threads).with_extension("obj");
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_mindeg"));
        command.env("RAYON_NUM_THREADS", threads);
        let path = model("bracket.json");
        command.args(["mesh", text(&path), "--keep-angle", "80%", "-q", "-o", text(&file)]);
        assert!(command.status().expect("it runs").success());
        fs::read(file).expect("the file")
    };
    assert!(written("1") == written("3"));
}

#[test]
fn open_and_bad_models_say_what_is_wrong() {
    let folder = tempfile::tempdir().expect("a folder");
    let files = [folder.path().join("out.obj")];
    let written = |name: &str, text: &str| {
        let path = folder.path().join(name);
        fs::write(&path, text).expect("it can be written");
        path
    };
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    let open = written("open.obj", &format!("{square}f 1 2 3 4\n"));
    let run = mesh(&open, &files, &["--size", "0.5"]);
    let note = "The model is open: 4 edges have one face: 0-1, 0-3, 1-2, 2-3 (by corners).";
    assert!(run.errors.contains(note), "{}", run.errors);
    assert_eq!(run.json()["closed"], false);
    mesh(&open, &files, &[]).refuses(&["--size S", "--intervals N"]);
    mesh(&open, &files, &["--intervals", "2,3"]).refuses(&["for a model give one"]);
    let both = ["--size", "1", "--interior", "--max-degree", "6"];
    mesh(&open, &files, &both).refuses(&["--interior"]);
    let twice = written("twice.obj", &format!("{square}f 1 2 3 4\nf 4 3 2 1\n"));
    mesh(&twice, &files, &["--size", "1"]).refuses(&["faces 0 and 1 have the same corners"]);
    let bent = written("bent.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\nf 1 2 3 4\n");
    mesh(&bent, &files, &["--size", "1"]).refuses(&["face 0 is not planar", "tolerance"]);
    let run = mesh(&bent, &files, &["--size", "1", "--planar-tolerance", "0.1"]);
    assert!(run.errors.contains("not quite planar"), "{}", run.errors);
    let crossed =
        written("crossed.obj", "v 0 0 0\nv 4 0 0\nv 1 3 0\nv 4 3 0\nv 0 1 0\nf 1 2 3 4 5\n");
    mesh(&crossed, &files, &["--size", "1"]).refuses(&["face 0 crosses itself"]);
}
