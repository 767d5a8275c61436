//! Files that are not meshes, or that refer to files that are not meshes.

use crate::mesh::text;
use crate::run::{Run, mindeg};
use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::Command;

/// A .gltf that names this file.
fn gltf_naming(path: &Path, uri: &str) {
    let document = format!(
        r#"{{"asset": {{"version": "2.0"}}, "buffers": [{{"byteLength": 4, "uri": "{uri}"}}]}}"#
    );
    fs::write(path, document).expect("a file");
}

#[track_caller]
fn fails(run: &Run, code: i32, words: &[&str]) {
    assert_eq!(run.code, Some(code), "{run:?}");
    for word in words {
        assert!(run.errors.contains(word), "{word:?} is missing in: {}", run.errors);
    }
    assert!(!run.errors.contains("backtrace"), "{run:?}");
}

#[test]
fn only_regular_files_in_the_folder_of_a_gltf_are_read() {
    let folder = tempfile::tempdir().expect("a folder");
    let outside = tempfile::NamedTempFile::new().expect("a file");
    let at = |name: &str| folder.path().join(name);
    let status = Command::new("mkfifo").arg(at("pipe.bin")).status().expect("mkfifo runs");
    assert!(status.success());
    symlink(outside.path(), at("out.bin")).expect("a link");
    symlink("/dev/zero", at("zero.bin")).expect("a link");
    fs::create_dir(at("below.bin")).expect("a folder");
    fs::write(at("four"), [0; 4]).expect("a file");
    symlink("four", at("in.bin")).expect("a link");
    let gltf = at("a.gltf");
    for (uri, code, words) in [
        ("pipe.bin", 1, &["pipe or a device", "only regular files"][..]),
        ("below.bin", 1, &["it is a folder"]),
        ("out.bin", 2, &["not in the folder"]),
        ("zero.bin", 2, &["not in the folder"]),
        ("http://x.y/a.bin", 2, &["only files beside the .gltf are read"]),
        ("file:///etc/passwd", 2, &["only files beside the .gltf are read"]),
        ("", 2, &["the name is empty"]),
        // Read, and found to hold no triangle.
        ("in.bin", 2, &["no triangle"]),
    ] {
        gltf_naming(&gltf, uri);
        fails(&mindeg(["inspect", text(&gltf)]), code, words);
    }
}

#[test]
fn a_line_without_end_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let zero = folder.path().join("z.obj");
    symlink("/dev/zero", &zero).expect("a link");
    fails(&mindeg(["inspect", text(&zero)]), 1, &["z.obj", "line 1 is longer than 16 MiB"]);
}

/// Runs with so many KiB of memory in all.
fn within(kibibytes: u32, arguments: &[&str]) -> Run {
    let shell = format!("ulimit -c 0; ulimit -v {kibibytes}; exec \"$@\"");
    let mut command = Command::new("sh");
    command.args(["-c", &shell, "sh", env!("CARGO_BIN_EXE_mindeg")]).args(arguments);
    command.env("RAYON_NUM_THREADS", "1");
    let output = command.output().expect("a shell");
    Run {
        code: output.status.code(),
        output: output.stdout,
        errors: String::from_utf8_lossy(&output.stderr).into_owned(),
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_mesh_that_does_not_fit_in_memory_is_an_error_that_names_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let [obj, glb] = ["m.obj", "m.glb"].map(|name| folder.path().join(name));
    let mesh = ["mesh", "--rectangle", "4x3", "--size", "2e-5", "-q"];
    assert_eq!(mindeg(mesh.iter().chain(&["-o", text(&obj), "-o", text(&glb)])).code, Some(0));
    for (file, kibibytes) in [(&obj, 40_000), (&obj, 60_000), (&glb, 40_000), (&glb, 60_000)] {
        let run = within(kibibytes, &["inspect", text(file)]);
        fails(&run, 1, &["out of memory", text(file)]);
    }
}
