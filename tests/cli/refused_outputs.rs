//! An output must be a file of its own: otherwise every command that writes leaves the folder unchanged.

use crate::run::{Run, shell};
use std::collections::BTreeMap;
use std::fs;
use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
use std::path::Path;

/// Every command that writes, but for its output, and the extension of that.
const COMMANDS: [(&str, &str); 14] = [
    ("mesh in/d.json -q -o", "obj"),
    ("mesh in/d.json -q -o", "glb"),
    ("mesh in/d.json -q --interior -o", "vtu"),
    ("mesh in/d.json -q --max-degree 6 -o", "svg"),
    ("mesh in/cube.json -q -o", "ply"),
    ("tradeoff in/d.json -q -o", "html"),
    ("compare in/d.json -q -o", "html"),
    ("view in/d.json -q -o", "html"),
    ("view in/a.obj -q -o", "html"),
    ("convert in/a.obj -q -o", "msh"),
    ("improve in/a.obj -q -o", "obj"),
    ("remesh in/open.obj -q -o", "obj"),
    ("fill in/open.obj -q -o", "obj"),
    ("bridge in/two.obj -q --from 1 --to 2 -o", "obj"),
];

/// The contents of a folder: the target of each link, and the bytes of each file.
fn content(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).expect("the folder is there") {
        let path = entry.expect("it can be read").path();
        let kind = fs::symlink_metadata(&path).expect("it is there");
        let bytes = if kind.is_symlink() {
            fs::read_link(&path).expect("a link").into_os_string().into_encoded_bytes()
        } else if kind.is_dir() {
            found.extend(content(&path));
            Vec::new()
        } else {
            fs::read(&path).expect("a file")
        };
        found.insert(path.display().to_string(), bytes);
    }
    found
}

/// A folder with something for every command to read.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let inputs = folder.path().join("in");
    fs::create_dir(&inputs).expect("a folder");
    let write = |name: &str, text: &str| fs::write(inputs.join(name), text).expect("a file");
    write("d.json", r#"{"rectangle": {"width": 4, "height": 3}, "size": 1}"#);
    write("cube.json", include_str!("../../assets/models/cube.json"));
    write("a.obj", "v 0 0 0\nv 4 0 0\nv 4 3 0\nv 0 3 0\nf 1 2 3 4\n");
    write(
        "open.obj",
        "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 2 2 3\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n",
    );
    // Two tetrahedra without their bases, which face each other.
    write(
        "two.obj",
        "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 -2\nf 2 1 4\nf 3 2 4\nf 1 3 4\n\
         v 0 0 5\nv 2 0 5\nv 0 2 5\nv 0 0 7\nf 5 6 8\nf 6 7 8\nf 7 5 8\n",
    );
    folder
}

fn run(folder: &Path, before: &str, command: &str, output: &str) -> Run {
    shell(folder, &format!("{before}exec \"$MINDEG\" {command} {output}"))
}

#[track_caller]
fn refuses(folder: &Path, before: &str, command: &str, output: &str, words: &[&str]) {
    let there = content(folder);
    let run = run(folder, before, command, output);
    assert_eq!(run.code, Some(1), "{command} {output}: {run:?}");
    for word in words {
        assert!(run.errors.contains(word), "{word:?} is missing for {command}: {}", run.errors);
    }
    assert!(content(folder) == there, "{command} {output} changed the folder");
}

/// Each command writes, so that the refusals below are of the output and of nothing else.
#[test]
fn every_command_writes_a_new_file_and_replaces_an_old_one() {
    for (command, extension) in COMMANDS {
        let folder = folder();
        let output = format!("x.{extension}");
        let first = run(folder.path(), "", command, &output);
        assert_eq!(first.code, Some(0), "{command}: {first:?}");
        let path = folder.path().join(&output);
        let written = fs::read(&path).expect("it is there");
        fs::write(&path, "before").expect("a file");
        assert_eq!(run(folder.path(), "", command, &output).code, Some(0), "{command}");
        let again = fs::read(&path).expect("it is there");
        // A comparison tells how long each method took.
        assert!(again == written || command.starts_with("compare"), "{command}");
        assert_ne!(again, b"before", "{command}");
    }
}

#[test]
fn no_command_replaces_a_link() {
    for (command, extension) in COMMANDS {
        let folder = folder();
        let at = |name: &str| folder.path().join(name);
        fs::write(at("file"), "before").expect("a file");
        fs::create_dir(at("below")).expect("a folder");
        for target in ["file", "missing", "below/missing", "/dev/null"] {
            let link = at(&format!("x.{extension}"));
            symlink(target, &link).expect("a link");
            let output = format!("x.{extension}");
            refuses(folder.path(), "", command, &output, &[&output, "it is a link"]);
            fs::remove_file(link).expect("it is there");
        }
        let hard = at(&format!("hard.{extension}"));
        fs::hard_link(at("file"), &hard).expect("a link");
        let output = format!("hard.{extension}");
        refuses(folder.path(), "", command, &output, &[&output, "hard link"]);
        assert_eq!(fs::metadata(hard).expect("it is there").nlink(), 2);
    }
}

#[test]
fn no_command_replaces_what_is_read_only() {
    for (command, extension) in COMMANDS {
        let folder = folder();
        let output = format!("x.{extension}");
        let path = folder.path().join(&output);
        fs::write(&path, "before").expect("a file");
        fs::set_permissions(&path, fs::Permissions::from_mode(0o444)).expect("it is ours");
        refuses(folder.path(), "", command, &output, &[&output, "read-only"]);
    }
}

#[test]
fn no_command_replaces_a_folder() {
    for (command, extension) in COMMANDS {
        let folder = folder();
        // A comparison writes its page into a folder.
        if command.starts_with("compare") {
            continue;
        }
        let output = format!("x.{extension}");
        fs::create_dir(folder.path().join(&output)).expect("a folder");
        refuses(folder.path(), "", command, &output, &["folder"]);
        // A name that only a folder can have.
        let output = format!("new.{extension}/");
        refuses(folder.path(), "", command, &output, &["folder"]);
    }
}

/// The system refuses every byte of a file.
#[test]
fn what_the_system_does_not_take_leaves_the_old_file() {
    for (command, extension) in COMMANDS {
        let folder = folder();
        let output = format!("x.{extension}");
        fs::write(folder.path().join(&output), "before").expect("a file");
        let limit = "ulimit -c 0; ulimit -f 0; ";
        refuses(folder.path(), limit, command, &output, &[&output, "File too large"]);
        // Pages go by their extension, which no device has.
        if extension == "html" {
            continue;
        }
        let full = format!("/dev/full --format {extension}");
        refuses(folder.path(), "", command, &full, &["/dev/full", "No space left"]);
    }
}

/// Many runs at once on one file: whenever somebody looks, it is one of the results, whole.
#[test]
fn runs_that_race_leave_one_result_and_never_a_mixture() {
    for (command, extension, runs) in [
        ("mesh --rectangle 4x3 -q --intervals", "obj", ["3,3,2,2", "2000,300,200,900"]),
        ("mesh --rectangle 4x3 -q --intervals", "glb", ["3,3,2,2", "2000,300,200,900"]),
        ("convert -q", "ply", ["in/a.obj", "in/open.obj"]),
    ] {
        let folder = folder();
        let output = format!("x.{extension}");
        let path = folder.path().join(&output);
        let alone = runs.map(|variant| {
            let run = run(folder.path(), "", &format!("{command} {variant} -o"), &output);
            assert_eq!(run.code, Some(0), "{run:?}");
            fs::read(&path).expect("it is there")
        });
        assert_ne!(alone[0], alone[1]);
        let script = format!(
            "for i in 1 2 3 4 5 6; do \"$MINDEG\" {command} {} -o {output} & \"$MINDEG\" {command} {} \
             -o {output} & done; wait",
            runs[0], runs[1]
        );
        let done = std::sync::atomic::AtomicBool::new(false);
        let looks = std::thread::scope(|scope| {
            let racing = scope.spawn(|| {
                let run = shell(folder.path(), &script);
                done.store(true, std::sync::atomic::Ordering::Relaxed);
                run
            });
            let mut looks = 0;
            while !done.load(std::sync::atomic::Ordering::Relaxed) {
                let found = fs::read(&path).expect("it is always there");
                assert!(alone.contains(&found), "a mixture of {} bytes", found.len());
                looks += 1;
            }
            let racing = racing.join().expect("it ends");
            assert_eq!((racing.code, &*racing.errors), (Some(0), ""));
            looks
        });
        assert!(looks > 0);
        assert!(alone.contains(&fs::read(&path).expect("it is there")));
        let there: Vec<String> = content(folder.path()).into_keys().collect();
        assert!(!there.iter().any(|name| name.ends_with(".part")), "{there:?}");
    }
}
