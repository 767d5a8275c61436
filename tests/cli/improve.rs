//! Improving planar meshes, and presets.

use crate::mesh::{content, text};
use crate::run::mindeg;
use mindeg_formats::obj;
use std::fmt::Write;
use std::fs;
use std::path::Path;

/// A grid of cells of 1 by 1, each cut in two, with its inner vertices moved; in a plane of space.
fn grid(cells: u32, moved: f64) -> String {
    let across = cells + 1;
    let mut text = String::new();
    for v in 0..across * across {
        let (i, j) = (v % across, v / across);
        let is_inner = i % cells != 0 && j % cells != 0;
        let shift = if is_inner { moved * f64::from(v * 7919 % 13) / 13.0 } else { 0.0 };
        let (x, y) = (f64::from(i) + shift, f64::from(j) + shift * 0.7);
        writeln!(text, "v {x} {} {}", 0.6 * y, 0.8 * y).expect("strings take all");
    }
    for cell in 0..cells * cells {
        if cell == cells * cells / 2 {
            text.push_str("g north\n");
        }
        let v = cell / cells * across + cell % cells + 1;
        writeln!(
            text,
            "f {v} {} {}\nf {} {} {}",
            v + 1,
            v + across,
            v + 1,
            v + across + 1,
            v + across
        )
        .expect("strings take all");
    }
    text
}

fn write(folder: &Path, name: &str, content: &str) -> std::path::PathBuf {
    let path = folder.join(name);
    fs::write(&path, content).expect("the folder takes files");
    path
}

#[test]
fn a_bad_mesh_becomes_a_good_one() {
    let folder = tempfile::tempdir().expect("a folder for the files");
    let before = write(folder.path(), "before.obj", &grid(8, 0.45));
    let after = folder.path().join("after.obj");
    let run = mindeg(["improve", text(&before), "-o", text(&after), "--json"]);
    let summary = run.json();
    let angle = |when: &str| summary[when]["min_angle"].as_f64().expect("an angle");
    assert!(angle("after") > angle("before"), "{summary}");
    assert_eq!(summary["after"]["violations"], serde_json::json!([]));
    assert_eq!(summary["kept_edges"], 8);
    let read = |path: &Path| obj::read(&fs::read(path).expect("a file")[..]).expect("an OBJ");
    let (old, new) = (read(&before), read(&after));
    let names = |mesh: &mindeg_mesh::TriMesh| -> Vec<String> {
        mesh.groups().iter().map(|group| group.name.clone()).collect()
    };
    assert_eq!(names(&new).len(), names(&old).len());
    assert_eq!(names(&new).last().map(String::as_str), Some("north"));
    let boundary = |mesh: &mindeg_mesh::TriMesh| -> Vec<_> {
        mesh.boundary_loops()[0].vertices.iter().map(|v| mesh.positions()[*v as usize]).collect()
    };
    assert_eq!(boundary(&old), boundary(&new));
    // In words.
    let again = mindeg(["improve", text(&before), "-o", text(&after)]);
    for words in ["before:", "after:", "of the limit", "8 edges inside were kept", "wrote "] {
        assert!(again.errors.contains(words), "{words:?} is missing in: {}", again.errors);
    }
}

#[test]
fn what_cannot_be_improved_is_refused() {
    let folder = tempfile::tempdir().expect("a folder for the files");
    let after = folder.path().join("after.obj");
    let refuses = |file: &str, options: &[&str], words: &[&str]| {
        let before = write(folder.path(), "before.obj", file);
        let arguments = ["improve", text(&before), "-o", text(&after)];
        mindeg(arguments.into_iter().chain(options.iter().copied())).refuses(words);
        assert_eq!(content(folder.path()), ["before.obj"]);
    };
    let bent = "v 0 0 0\nv 1 0 0\nv 1 1 0.2\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";
    refuses(bent, &[], &["the mesh is not planar: vertex ", "mindeg remesh takes"]);
    let solid = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    refuses(solid, &[], &["the mesh is not planar but a surface in space: mindeg remesh"]);
    let both = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 4 3\n";
    refuses(both, &[], &["parts of the mesh are turned over"]);
    let bow = "v 0 0 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv -1 -1 0\nf 1 2 3\nf 1 4 5\n";
    refuses(bow, &[], &["the mesh cannot be improved"]);
    refuses(&grid(3, 0.1), &["--target-angle", "59"], &["a minimum angle of 59° is impossible"]);
    let before = write(folder.path(), "before.obj", bent);
    mindeg(["improve", text(&before), "-o", text(&before)]).refuses(&["is the mesh itself"]);
}

#[test]
fn presets_are_gates_for_any_mesh() {
    let folder = tempfile::tempdir().expect("a folder for the files");
    // Nine triangles round a vertex.
    let mut wheel = "v 0 0 0\n".to_owned();
    for i in 0..9 {
        let angle = std::f64::consts::TAU * f64::from(i) / 9.0;
        writeln!(wheel, "v {} {} 0", angle.cos(), angle.sin()).expect("strings take all");
    }
    for i in 0..9 {
        writeln!(wheel, "f 1 {} {}", i + 2, (i + 1) % 9 + 2).expect("strings take all");
    }
    let file = write(folder.path(), "wheel.obj", &wheel);
    let gate = |preset: &str| {
        let run = mindeg(["inspect", text(&file), "--preset", preset]);
        (run.code, run.errors)
    };
    let (code, message) = gate("fvcom");
    assert_eq!(code, Some(3), "{message}");
    assert!(
        message.contains("preset fvcom: vertex 0 at (0, 0) has 9 triangles, above 8"),
        "{message}"
    );
    assert_eq!(gate("swan").0, Some(0));
    let (code, message) = gate("qmap");
    assert!(
        code == Some(3) && message.contains("vertex 0 at (0, 0) has 9 edges, above 6"),
        "{message}"
    );
    // A tenth triangle at a second center, which counts as the first one within the tolerance alone.
    let near = wheel.clone() + "v 1e-9 0 0\nf 11 3 2\n";
    let near = write(folder.path(), "near.obj", &near);
    for (weld, triangles) in
        [(&["--weld", "0"][..], 9), (&["--no-weld"], 9), (&["--weld", "1e-6"], 10)]
    {
        let run = mindeg([&["inspect", text(&near), "--preset", "fvcom"], weld].concat());
        let words = format!("vertex 0 at (0, 0) has {triangles} triangles, above 8");
        assert!(run.code == Some(3) && run.errors.contains(&words), "{weld:?}: {run:?}");
    }
    // The mesh that improve makes keeps it.
    let after = folder.path().join("after.obj");
    let run = mindeg(["improve", text(&file), "-o", text(&after), "--preset", "fvcom", "-q"]);
    assert_eq!(run.code, Some(0), "{run:?}");
    assert_eq!(mindeg(["inspect", text(&after), "--preset", "fvcom"]).code, Some(0));
}
