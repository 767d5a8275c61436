use crate::mesh::text;
#[cfg(unix)]
use crate::run::shell;
use crate::run::{Run, mindeg};
use serde_json::{Value, json};
use std::fs;
use std::path::{Path, PathBuf};

fn model(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/models").join(name)
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
        assert_eq!(summary["at_least"], degree, "{name}");
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
    for line in ["usemtl brick", "usemtl concrete", "usemtl tiles", "o walls", "mtllib house.mtl"] {
        assert!(written.lines().any(|at| at == line), "{line}");
    }
    assert!(written.lines().any(|at| at.ends_with("ridge")));
}

/// A tetrahedron as Blender writes one: an object, a library and two materials.
const PAINTED: &str = "mtllib painted.mtl\no Cone\nv 0 0 0\nv 4 0 0\nv 0 3 0\nv 0 0 2\n\
    usemtl Red paint\nf 1 3 2\nf 1 2 4\nusemtl steel\nf 2 3 4\nf 1 4 3\n";

#[test]
fn materials_come_from_files_and_go_to_files() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    fs::write(at("painted.obj"), PAINTED).expect("a file");
    let library =
        "newmtl Red paint\nNs 250\nKd 0.5 0.25 0\nd 1\nnewmtl steel\nKd 0.5 0.5 0.5\nd 0.75\n";
    fs::write(at("painted.mtl"), library).expect("a file");
    let files = [at("part.obj"), at("part.glb")];
    let summary = mesh(&at("painted.obj"), &files, &["--size", "1"]).json();
    let names: Vec<&str> = summary["files"].as_array().expect("files").iter().map(file).collect();
    assert_eq!(names, ["part.obj", "part.mtl", "part.glb"]);
    let group = |name: &str, color: Value, triangles: &Value| json!({"name": "Cone", "material": name, "color": color, "faces": 2, "triangles": triangles});
    let groups = &summary["groups"];
    assert_eq!(
        groups[0],
        group("Red paint", json!([0.5, 0.25, 0.0, 1.0]), &groups[0]["triangles"])
    );
    assert_eq!(groups[1], group("steel", json!([0.5, 0.5, 0.5, 0.75]), &groups[1]["triangles"]));
    // From glTF to OBJ all is as from OBJ to OBJ.
    let back = at("back.obj");
    let run = mindeg(["convert", text(&files[1]), "-o", text(&back)]);
    assert!(run.errors.contains("back.mtl"), "{run:?}");
    let read = |path: &Path| fs::read_to_string(path).expect("a file");
    let uses = |path: &Path| -> Vec<String> {
        let text = read(path);
        text.lines().filter(|line| line.starts_with("usemtl")).map(str::to_owned).collect()
    };
    assert_eq!(uses(&back), ["usemtl Red_paint", "usemtl steel"]);
    assert_eq!(uses(&files[0]), uses(&back));
    let colors = "newmtl Red_paint\nKd 0.5 0.25 0\nd 1\nnewmtl steel\nKd 0.5 0.5 0.5\nd 0.75\n";
    assert!(read(&at("part.mtl")).ends_with(colors));
    assert_eq!(read(&at("part.mtl")), read(&at("back.mtl")));

    // No output replaces a library that was read; without the library there is a note.
    let same = [at("painted.glb"), at("painted.obj")];
    fs::rename(at("painted.obj"), at("other.obj")).expect("a file");
    mesh(&at("other.obj"), &same[1..], &["--size", "1"]).refuses(&["painted.mtl is the"]);
    fs::remove_file(at("painted.mtl")).expect("a file");
    let run = mesh(&at("other.obj"), &same[..1], &["--size", "1"]);
    let note = "The material library \"painted.mtl\" is not read, so its materials have no colors";
    assert!(run.errors.contains(note), "{}", run.errors);
    assert_eq!(run.json()["groups"][1]["material"], "steel");
}

fn file(path: &Value) -> &str {
    path.as_str().and_then(|path| path.rsplit('/').next()).expect("a path")
}

#[test]
fn materials_of_a_json_model_have_colors() {
    let folder = tempfile::tempdir().expect("a folder");
    let files = [folder.path().join("part.glb")];
    let model = r#"{"corners": [[0,0,0], [4,0,0], [0,3,0], [0,0,2]], "size": 1, "faces": [[0,2,1],
        [0,1,3], [1,2,3], {"corners": [0,3,2], "material": "steel"}], "materials": [MATERIALS]}"#;
    let path = folder.path().join("model.json");
    let with = |materials: &str| {
        fs::write(&path, model.replace("MATERIALS", materials)).expect("a file");
        mesh(&path, &files, &[])
    };
    let summary = with(r#"{"name": "steel", "color": [0.5, 0.5, 0.75]}"#).json();
    assert_eq!(summary["groups"][1]["color"], json!([0.5, 0.5, 0.75, 1.0]));
    assert_eq!(with("").json()["groups"][1]["color"], Value::Null);
    for (materials, words) in [
        (r#"{"name": "steel", "color": [2, 0, 0]}"#, "each from 0 to 1"),
        (r#"{"name": "steel", "color": [0, 0]}"#, "a color is a list of red, green and blue"),
        (r#"{"name": "a"}, {"name": "a"}"#, "the list has two materials \"a\"; drop one"),
        (r#"{"color": [0, 0, 0]}"#, "name"),
        (r#"{"name": " "}"#, "the name of the material is blank"),
    ] {
        with(materials).refuses(&["materials[", words]);
    }
}

#[test]
fn presets_are_gates_of_models_too() {
    let folder = tempfile::tempdir().expect("a folder");
    let files = [folder.path().join("part.obj")];
    let run = mesh(&model("cube.json"), &files, &["--preset", "qmap"]);
    assert_eq!(run.code, Some(0), "{run:?}");
    fs::remove_file(&files[0]).expect("a file");
    for more in [&[][..], &["--interior"]] {
        let options: Vec<&str> = [more, &["--preset", "qmap"]].concat();
        let run = mesh(&model("bracket.json"), &files, &options);
        assert_eq!(run.code, Some(3), "{run:?}");
        assert!(run.errors.contains("preset qmap: vertex "), "{}", run.errors);
        assert!(run.errors.contains(" edges, above 6"), "{}", run.errors);
        assert!(!files[0].exists());
    }
}

#[cfg(unix)]
#[test]
fn a_model_may_come_by_standard_input() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::copy(model("cube.json"), folder.path().join("cube.json")).expect("a copy");
    let script = "\"$MINDEG\" mesh cube.json -q -o file.obj && \"$MINDEG\" mesh - -q -o piped.obj \
                  < cube.json && cmp file.obj piped.obj";
    let run = shell(folder.path(), script);
    assert_eq!(run.code, Some(0), "{run:?}");
    let run = shell(folder.path(), "echo '{\"faces\": 3}' | \"$MINDEG\" mesh - -o out.obj");
    run.refuses(&["standard input: ", "faces"]);
    // A model from there has no name, and one thing is told as one.
    let triangle = "v 0 0 0\\nv 1 0 0\\nv 0 1 0\\nf 1 2 3\\n";
    let script = format!("printf '{triangle}' | \"$MINDEG\" degree - --size 5");
    let run = shell(folder.path(), &script);
    assert!(run.text().starts_with("model: 1 face, 3 vertices, 1 triangle, "), "{run:?}");
    let domain = r#"{"polygon": {"corners": [[0, 0], [2, 0], [0, 1]]}, "size": 1}"#;
    let run = shell(folder.path(), &format!("echo '{domain}' | \"$MINDEG\" mesh - -q -o out.obj"));
    assert_eq!(run.code, Some(0), "{run:?}");
}

#[test]
fn degrees_over_all_faces_with_interior_points_are_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let files = [folder.path().join("part.obj")];
    let run = mesh(&model("bracket.json"), &files, &["--interior"]);
    let summary = run.json();
    let total = summary["max_degree"].as_u64().expect("a degree");
    assert_eq!((total, &summary["violations"]), (7, &json!([])), "{summary}");
    assert!(run.errors.contains("degrees 5 to 7, at the boundary 5 at most"), "{}", run.errors);
    // The same by the checker, at no distance.
    let part = folder.path().join("faces.obj");
    mesh(&model("bracket.json"), std::slice::from_ref(&part), &["--quiet"]);
    let checked = mindeg(["verify", text(&files[0]), "--surface", text(&part), "--tolerance", "0"]);
    assert_eq!(checked.code, Some(0), "{checked:?}");
    assert_eq!(inspected(&files[0])["max_degree"], total);
}

#[test]
fn a_mesh_of_triangles_becomes_a_model_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let triangles = [folder.path().join("triangles.glb")];
    mesh(&model("cube.json"), &triangles, &["--quiet"]);
    let files = [folder.path().join("again.obj")];
    let summary = mesh(&triangles[0], &files, &["--intervals", "3"]).json();
    assert_eq!((&summary["faces"], &summary["vertices"]), (&json!(6), &json!(32)));
    assert_eq!((&summary["max_degree"], &summary["at_least"]), (&json!(6), &json!(6)));
}

#[test]
fn the_angle_that_is_asked_for_is_kept() {
    let folder = tempfile::tempdir().expect("a folder");
    let files = [folder.path().join("house.obj")];
    let summary = mesh(&model("house.json"), &files, &["--keep-angle", "95%"]).json();
    assert!(summary["share_of_limit"].as_f64().expect("a share") >= 0.95);
    assert!(summary["max_degree"].as_u64() >= summary["at_least"].as_u64());
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
    let both = ["--size", "1", "--interior", "--keep-angle", "95%"];
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

#[test]
fn a_model_for_a_solver_gets_points_inside() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("mesh.obj").display().to_string();
    let made = |option: &[&str]| {
        let common =
            ["mesh", "assets/models/bracket.obj", "--size", "5", "-o", &out, "--json", "-q"];
        mindeg([&common[..], option].concat()).json()
    };
    let wanted = made(&["--for", "solver"]);
    assert_eq!(wanted, made(&["--interior"]));
    assert!(wanted["interior_points"].as_u64() > Some(0), "{wanted}");
}
