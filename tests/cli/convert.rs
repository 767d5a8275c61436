//! Every format into every other.

use crate::mesh::text;
use crate::run::mindeg;
use mindeg_formats::Format;
use std::fs;
use std::path::{Path, PathBuf};

/// A plate with a dent: nine vertices on a square, the middle one of which is moved.
const SPACE: &str = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0.5\nv 2 1 0\nv 0 2 0\nv 1 2 0\n\
    v 2 2 0\nf 1 2 5\nf 1 5 4\nf 2 3 6\nf 2 6 5\nf 4 5 8\nf 4 8 7\nf 5 6 9\nf 5 9 8\n";

const IS_WRITTEN: fn(&Format) -> bool = |format| *format != Format::Png || cfg!(feature = "png");

fn path(folder: &Path, stem: &str, format: Format) -> PathBuf {
    folder.join(stem).with_extension(format.extension())
}

/// Vertices and faces as `mindeg inspect` counts them.
fn counts(file: &Path) -> [u64; 2] {
    let report = mindeg(["inspect".as_ref(), file.as_os_str(), "--json".as_ref()]).json();
    ["vertices", "faces"].map(|count| report[count].as_u64().expect("a count"))
}

#[test]
fn every_format_becomes_every_other() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let flat = folder.join("flat.obj");
    fs::write(&flat, SPACE.replace("0.5", "0")).expect("a file");
    for start in Format::READ.into_iter().filter(|format| Format::WRITTEN.contains(format)) {
        let source = path(folder, "source", start);
        let run = mindeg(["convert".as_ref(), flat.as_os_str(), "-o".as_ref(), source.as_ref()]);
        assert_eq!(run.code, Some(0), "{start:?}: {}", run.errors);
        let target =
            |end: Format| path(folder, &format!("{}-to-{}", start.name(), end.name()), end);
        let ends = || Format::WRITTEN.into_iter().filter(IS_WRITTEN);
        // One run for all: most of its time goes by before it begins.
        let outputs = ends().flat_map(|end| ["-o".into(), target(end).into_os_string()]);
        let run = mindeg(["convert".into(), source.into_os_string()].into_iter().chain(outputs));
        assert_eq!(run.code, Some(0), "{start:?}: {}", run.errors);
        for end in ends() {
            let target = target(end);
            for file in end.files(&target) {
                let len = fs::metadata(&file).expect("it was written").len();
                assert!(len > 20, "{} has {len} bytes", file.display());
            }
            if Format::READ.contains(&end) {
                assert_eq!(counts(&target), [9, 8], "{start:?} to {end:?}");
            }
        }
    }
}

#[test]
fn a_mesh_in_space_goes_where_the_format_has_space() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let source = folder.join("space.obj");
    fs::write(&source, SPACE).expect("a file");
    for end in Format::WRITTEN.into_iter().filter(IS_WRITTEN) {
        let target = path(folder, "target", end);
        let run = mindeg(["convert".as_ref(), source.as_os_str(), "-o".as_ref(), target.as_ref()]);
        if end.is_planar() {
            run.refuses(&["holds meshes in the plane, and the z of this one goes from 0 to 0.5"]);
            assert!(!target.exists(), "nothing is left behind");
        } else {
            assert_eq!(run.code, Some(0), "{end:?}: {}", run.errors);
        }
        if !end.is_planar() && Format::READ.contains(&end) {
            assert_eq!(counts(&target), [9, 8], "{end:?}");
        }
    }
}

#[cfg(not(feature = "png"))]
#[test]
fn a_build_without_png_says_so() {
    let folder = tempfile::tempdir().expect("a folder");
    let source = folder.path().join("flat.obj");
    fs::write(&source, SPACE).expect("a file");
    let target = folder.path().join("flat.png");
    let run = mindeg(["convert".as_ref(), source.as_os_str(), "-o".as_ref(), target.as_ref()]);
    run.refuses(&[
        "does not write a picture in pixels; write .svg, or build it with the feature png",
    ]);
}

#[test]
fn the_kind_of_a_side_reaches_fort_14_with_and_without_interior_points() {
    let domain = br#"{"rectangle": {"width": 4, "height": 3}, "sides": [
        {"intervals": 4, "kind": "open", "name": "sea"}, {"intervals": 3}, {"intervals": 4},
        {"intervals": 3}]}"#;
    for interior in ["--interior", "--no-interior"] {
        let run = crate::run::mindeg_reading(
            ["mesh", "-", "-o", "-", "--format", "fort14", "-q", interior],
            domain,
        );
        let text = run.text();
        for line in ["1 = number of open boundaries", "5 = nodes of open boundary 1 (sea)"] {
            assert!(text.contains(line), "{interior}: {text}");
        }
    }
}

#[test]
fn markers_of_a_poly_are_physical_tags_of_an_msh_and_markers_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name).display().to_string();
    let poly =
        "4 2 0 0\n1 0 0\n2 4 0\n3 4 3\n4 0 3\n4 1\n1 1 2 20\n2 2 3 1\n3 3 4 20\n4 4 1 300\n0\n";
    fs::write(at("plate.poly"), poly).expect("a file");
    let names = "$PhysicalNames\n4\n1 20 \"marker 20\"\n1 1 \"marker 1\"\n1 300 \"marker 300\"\n2 2 \"plate\"\n";
    let curves = "\n1 0 0 0 4 0 0 1 20 0\n2 4 0 0 4 3 0 1 1 0\n3 0 3 0 4 3 0 1 20 0\n4 0 0 0 0 3 0 1 300 0\n1 0 0 0 4 3 0 1 2 0\n";
    let lines = "\n1 1 2 20 1 1 2\n2 1 2 1 2 2 3\n3 1 2 20 3 3 4\n4 1 2 300 4 4 1\n5 2 2 2 1 ";
    for (version, elements) in [("4.1", curves), ("2.2", lines)] {
        let options = ["--ascii", "--msh-version", version, "-q"];
        let run = ["mesh", &at("plate.poly"), "-o", &at("mesh.msh")];
        mindeg(run.into_iter().chain(options)).text();
        let file = fs::read_to_string(at("mesh.msh")).expect("a mesh");
        assert!(file.contains(names) && file.contains(elements), "{file}");
        mindeg(["convert", &at("mesh.msh"), "-o", &at("again.node"), "-q"]).text();
        let file = fs::read_to_string(at("again.poly")).expect("segments");
        let segments = "\n0 2 0 1\n4 1\n 1 1 2 20\n 2 2 3 1\n 3 3 4 20\n 4 4 1 300\n0\n";
        assert!(file.ends_with(segments), "{file}");
    }
}

#[test]
fn the_summary_in_json_is_that_of_the_mesh() {
    let folder = tempfile::tempdir().expect("a folder");
    let [source, ply, page] =
        ["space.obj", "space.ply", "space.html"].map(|it| folder.path().join(it));
    fs::write(&source, SPACE).expect("a file");
    let inspected = mindeg(["inspect", text(&source), "--json"]).json();
    for (command, output) in [("convert", &ply), ("view", &page)] {
        let run = mindeg([command, text(&source), "-o", text(output), "--json", "-q"]);
        assert_eq!((run.code, run.errors.as_str()), (Some(0), ""));
        let summary = run.json();
        assert_eq!(summary["file"], text(&source));
        assert_eq!(summary["files"], serde_json::json!([text(output)]));
        assert_eq!((&summary["vertices"], &summary["triangles"]), (&9.into(), &8.into()));
        assert_eq!(summary["max_degree"], inspected["max_degree"]);
        assert!(summary["min_angle"].as_f64() < summary["max_angle"].as_f64(), "{summary}");
        assert_eq!(summary["dropped"], serde_json::json!([]));
        let mut format = vec![command, text(&source), "-o", "-", "--json"];
        format.extend((command == "convert").then_some(["--format", "obj"]).into_iter().flatten());
        mindeg(format).refuses(&["or the summary of --json, not both"]);
    }
}

#[test]
fn values_at_vertices_that_no_output_has_are_told_by_each_command() {
    let folder = tempfile::tempdir().expect("a folder");
    let square = folder.path().join("square.off");
    fs::write(&square, "STOFF\n4 2 0\n0 0 0 0 0\n1 0 0 1 0\n1 1 0 1 1\n0 1 0 0 1\n3 0 1 2 255 0 0\n3 0 2 3 255 0 0\n")
        .expect("a file");
    for command in ["convert", "improve"] {
        let output = folder.path().join(format!("{command}.off"));
        let run = mindeg([command, text(&square), "-o", text(&output)]);
        assert_eq!(run.code, Some(0), "{run:?}");
        assert!(run.errors.contains("Not in the mesh: texture coordinates, colors.\n"), "{run:?}");
    }
    let plain = folder.path().join("convert.off");
    let run = mindeg(["convert", text(&plain), "-o", text(&folder.path().join("again.off"))]);
    assert!(run.code == Some(0) && !run.errors.contains("Not in the mesh"), "{run:?}");
}

#[test]
fn larger_faces_and_curved_edges_are_told_by_each_command() {
    let quad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    let curved = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 0 0 0\n2 4 0 0\n3 0 4 0\n4 2 -0.5 0\n5 2 2 0\n6 0 2 0\n\
                  $EndNodes\n$Elements\n1\n1 9 2 0 1 1 2 3 4 5 6\n$EndElements\n";
    for (name, content, missing) in [
        ("quad.obj", quad, "faces with more than three corners"),
        ("curved.msh", curved, "the curved edges of elements of higher order"),
    ] {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join(name);
        fs::write(&file, content).expect("a file");
        for command in ["convert", "improve"] {
            let output = folder.path().join(format!("{command}.off"));
            let run = mindeg([command, text(&file), "-o", text(&output)]);
            assert_eq!(run.code, Some(0), "{run:?}");
            assert!(run.errors.contains(&format!("Not in the mesh: {missing}.\n")), "{run:?}");
        }
    }
}
