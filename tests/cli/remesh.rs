//! `mindeg remesh`, and `mindeg verify --surface`.

use crate::mesh::text;
use crate::run::mindeg;
use std::fs;
use std::path::Path;

fn asset(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets");
    folder.join(name).to_string_lossy().into_owned()
}

#[test]
fn a_mesh_is_compared_with_its_part() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("bracket.obj");
    let part = asset("models/bracket.obj");
    let made = mindeg(["mesh", &part, "--size", "4", "-q", "-o", text(&file)]);
    assert_eq!(made.code, Some(0), "{made:?}");
    let options = ["--surface", &part, "--feature-angle", "20", "--tolerance", "0"];
    let verify = |options: &[&str]| {
        mindeg(["verify", text(&file)].into_iter().chain(options.iter().copied()))
    };
    let run = verify(&[&options[..], &["--json"]].concat());
    let found: serde_json::Value = serde_json::from_str(run.text()).expect("JSON");
    assert_eq!(run.code, Some(3));
    // It has no points inside: degrees are out of range, and nothing else is wrong.
    let kinds: Vec<&str> = found["defects"]
        .as_array()
        .expect("a list")
        .iter()
        .filter_map(|d| d["kind"].as_str())
        .collect();
    assert_eq!(kinds, ["degree"], "{found}");
    assert!(found["to_part"]["at_most"].as_f64() < Some(1e-6), "{found}");
    assert!(found["features_from_part"]["at_most"].as_f64() < Some(1e-6), "{found}");
    assert!(run.errors.contains("have another degree than 5 to 7"), "{run:?}");
    let read = verify(&options).text().to_owned();
    assert!(
        read.contains("does not keep the surface of") && read.contains("distance          at most"),
        "{read}"
    );
    // Sharp edges that are cut in two are not the part's.
    let run = verify(&[&options[..], &["--keep-features", "--target-angle", "60"]].concat());
    assert!(run.errors.contains("sharp edges of the part are none of the mesh"), "{run:?}");
    assert!(run.errors.contains("below the target angle of 60°"), "{run:?}");
    let page = fs::read_to_string(asset("../docs/remesh.md")).expect("the page");
    let help = mindeg(["verify", "--help"]);
    let help = help.text().split_whitespace().collect::<Vec<_>>().join(" ");
    for key in found.as_object().expect("an object").keys() {
        assert!(page.contains(&format!("`{key}`")) && help.contains(key), "{key}");
    }
}

#[test]
fn shares_are_for_surfaces_and_domains_are_none() {
    let part = asset("models/bracket.obj");
    let domain = asset("domains/l-bracket.json");
    let run = mindeg(["verify", &part, &domain, "--tolerance", "1%"]);
    assert_eq!(run.code, Some(2));
    assert!(run.errors.contains("--tolerance takes a share with --surface alone"), "{run:?}");
    let run = mindeg(["verify", &part, "--surface", &part, "--rectangle", "4x3"]);
    assert_eq!(run.code, Some(2), "{run:?}");
    let run = mindeg(["verify", &part, "--keep-boundary"]);
    assert_eq!(run.code, Some(2), "{run:?}");
}

#[test]
fn a_part_is_meshed_anew_and_passes_the_check() {
    let folder = tempfile::tempdir().expect("a folder");
    let [file, again] = ["part.obj", "again.stl"].map(|name| folder.path().join(name));
    let part = asset("models/bracket.obj");
    let options = ["--size", "5", "--tolerance", "1%"];
    let remesh = |from: &str, to: &Path, more: &[&str]| {
        let arguments = ["remesh", from, "-o", text(to)];
        mindeg(arguments.iter().chain(&options).chain(more).copied().collect::<Vec<_>>())
    };
    let made = remesh(&part, &file, &["--json"]).json();
    assert_eq!(
        (&made["interior_degree"][0], &made["interior_degree"][1]),
        (&5.into(), &7.into()),
        "{made}"
    );
    assert_eq!(
        (&made["corners"], &made["curves"], &made["patches"]),
        (&12.into(), &22.into(), &10.into())
    );
    assert!(made["min_angle"].as_f64() > Some(30.0), "{made}");
    let found =
        mindeg(["verify", text(&file), "--surface", &part, "--tolerance", "1%", "--json"]).json();
    assert_eq!((&found["valid"], &found["vertices"]), (&true.into(), &made["vertices"]));
    for key in ["to_part", "from_part"] {
        assert_eq!(found[key]["at_most"], made[key]["at_most"]);
    }
    let page = fs::read_to_string(asset("../docs/remesh.md")).expect("the page");
    let help = mindeg(["remesh", "--help"]);
    let help = help.text().split_whitespace().collect::<Vec<_>>().join(" ");
    for key in made.as_object().expect("an object").keys() {
        assert!(page.contains(&format!("`{key}`")) && help.contains(key), "{key}");
    }
    // The remesh is a part, too: what was kept is kept again.
    let run = remesh(text(&file), &again, &["--keep-features"]);
    assert_eq!(run.code, Some(0), "{run:?}");
    assert!(run.errors.contains("It keeps 22 feature curves, "), "{run:?}");
}

#[test]
fn what_is_not_kept_is_not_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("part.obj");
    let part = asset("models/bracket.obj");
    let arguments = ["remesh", &part, "-q", "--size", "5", "-o", text(&file)];
    let run = |more: &[&str]| mindeg(arguments.iter().chain(more).copied().collect::<Vec<_>>());
    let refused = run(&["--tolerance", "0"]);
    assert_eq!((refused.code, file.exists()), (Some(3), false), "{refused:?}");
    assert!(refused.errors.contains("the mesh is off the part by"), "{refused:?}");
    let refused = run(&["--target-angle", "45"]);
    assert_eq!((refused.code, file.exists()), (Some(3), false), "{refused:?}");
    assert!(refused.errors.contains("below the target angle of 45°"), "{refused:?}");
    let written = run(&["--tolerance", "0", "--write-anyway"]);
    assert_eq!((written.code, file.exists()), (Some(3), true), "{written:?}");
    // A surface that is none, with its places.
    let broken = folder.path().join("broken.obj");
    fs::write(&broken, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 2 1 4\nf 2 1 5\n")
        .expect("a file");
    mindeg(["remesh", text(&broken), "-o", text(&file)])
        .refuses(&["the part is no surface: 3 triangles share an edge (0, 1, 2), at (0.5, 0, 0)"]);
}

#[test]
fn tips_of_a_tetrahedron_are_proven() {
    let folder = tempfile::tempdir().expect("a folder");
    let [part, file] = ["part.obj", "mesh.stl"].map(|name| folder.path().join(name));
    fs::write(&part, "v 0 0 0\nv 1 1 0\nv 0 1 1\nv 1 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
        .expect("a file");
    let made = mindeg(["remesh", text(&part), "-o", text(&file), "--size", "0.2", "--json"]);
    assert!(made.errors.contains("4 vertices have the degree that corners of the part force"));
    assert!(made.errors.contains("; --feature-angle 180 may drop these corners."), "{made:?}");
    let made = made.json();
    assert_eq!(
        (made["violations"].as_array().map(Vec::len), made["interior_degree"][0].as_u64()),
        (Some(0), Some(3))
    );
    let run = mindeg(["verify", text(&file), "--surface", text(&part), "--json"]);
    assert_eq!(run.code, Some(0), "{run:?}");
    let proven = run.json()["certified"].as_array().cloned().expect("a list");
    assert_eq!((proven.len(), &proven[0]["allowed"]), (4, &serde_json::json!([3, 3])));
}

#[test]
fn values_at_vertices_that_the_mesh_lacks_are_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let [part, file] = ["part.obj", "mesh.stl"].map(|name| folder.path().join(name));
    let sheet = "v 0 0 0 1 0 0\nv 4 0 0 1 0 0\nv 4 3 0 0 1 0\nv 0 3 0 0 0 1\nvt 0 0\nvn 0 0 1\n\
                 f 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/1/1 4/1/1\n";
    fs::write(&part, sheet).expect("a file");
    let made = mindeg(["remesh", text(&part), "-o", text(&file), "--size", "1", "--json"]);
    let kinds = ["texture coordinates", "normals of the file", "colors"];
    let sentence = format!("Not in the mesh: {}.", kinds.join(", "));
    assert!(made.errors.contains(&sentence), "{made:?}");
    assert_eq!(made.json()["dropped"], serde_json::json!(kinds));
}

#[test]
fn dirty_parts_are_refused_unless_they_are_to_be_repaired() {
    let folder = tempfile::tempdir().expect("a folder");
    let [part, file] = ["part.obj", "mesh.ply"].map(|name| folder.path().join(name));
    // A tetrahedron with a fin, a face twice, and one turned over.
    fs::write(
        &part,
        "v 0 0 0\nv 1 1 0\nv 0 1 1\nv 1 0 1\nv 0.5 0.4 -0.5\nf 1 3 2\nf 1 2 4\nf 2 4 3\nf 3 1 4\nf 1 3 2\nf 1 2 5\n",
    )
    .expect("a file");
    // Four edges along each of its own: triangles that are nearly alike, as the preset asks for.
    let arguments = ["remesh", text(&part), "-o", text(&file), "--size", "0.35"];
    mindeg(arguments).refuses(&["share an edge", "--repair mends what can be mended"]);
    let run = mindeg(arguments.into_iter().chain(["--repair", "--json", "--preset", "sms"]));
    assert!(
        run.errors.contains("Repaired first: 1 doubled face dropped, 1 face too many at an edge dropped, 1 face turned over."),
        "{run:?}"
    );
    let made = run.json();
    assert_eq!(
        (&made["repairs"]["turned_faces"], &made["repairs"]["filled_holes"]),
        (&1.into(), &0.into())
    );
    assert_eq!(made["boundary_degree"], serde_json::Value::Null);
}

#[test]
fn edges_follow_the_curvature() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("part.obj");
    let part = asset("models/bracket.obj");
    let vertices = |more: &[&str]| {
        let arguments = ["remesh", &part, "-o", text(&file), "--size", "4", "--json"];
        let made = mindeg(arguments.iter().chain(more).copied().collect::<Vec<_>>()).json();
        assert_eq!(made["violations"].as_array().map(Vec::len), Some(0), "{made}");
        made["vertices"].as_u64().expect("a number")
    };
    let [even, by_curvature] = [vertices(&[]), vertices(&["--curvature"])];
    assert!(3 * by_curvature < 2 * even, "{even} {by_curvature}");
}
