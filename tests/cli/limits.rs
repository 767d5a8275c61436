//! Impossible work is refused before the first byte, and a later failure leaves no file.

use crate::mesh::{content, text};
use crate::run::{Run, mindeg, output_of};
use std::fs;
use std::io::{self, Write};
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

const BILLIONS: [&str; 5] =
    ["mesh", "--rectangle", "4x3", "--intervals", "1000000000,1000000000,1000000000,1000000000"];

/// A refusal takes milliseconds. To choose a mesh of that size would take minutes.
const AT_ONCE: Duration = Duration::from_secs(120);

#[track_caller]
fn refuses(code: i32, run: &Run, words: &[&str]) {
    assert_eq!(run.code, Some(code), "{run:?}");
    for word in words {
        assert!(run.errors.contains(word), "{word:?} is missing in: {}", run.errors);
    }
}

#[test]
fn what_no_file_can_hold_is_refused_at_once() {
    let folder = tempfile::tempdir().expect("a folder");
    let start = Instant::now();
    for (outputs, code, words) in [
        (&["x.glb"][..], 2, &["x.glb", "4 GiB", "176000000004 bytes", ".gltf"][..]),
        (&["x.svg"], 2, &["x.svg", "100000 vertices", "OBJ"]),
        (&["x.gltf"], 2, &["x.gltf", "too close together", "OBJ"]),
        // A coincidence takes longer to find than a count, and other files must not be begun.
        (&["x.gltf", "x.svg"], 2, &["x.svg"]),
        (&["x.obj", "x.gltf"], 2, &["x.gltf"]),
    ] {
        let outputs = outputs.iter().flat_map(|name| ["-o".into(), folder.path().join(name)]);
        let run = mindeg(BILLIONS.iter().map(Into::into).chain(outputs));
        refuses(code, &run, words);
        assert!(content(folder.path()).is_empty());
    }
    let too_many = [&BILLIONS[..4], &["4294967294,1,1,1", "-o", "x.obj"]].concat();
    mindeg(too_many).refuses(&["4294967294"]);
    assert!(start.elapsed() < AT_ONCE, "{:?}", start.elapsed());
}

#[test]
fn one_file_is_not_written_twice() {
    let folder = tempfile::tempdir().expect("a folder");
    let [plain, detour] = ["x.obj", "../folder/x.obj"].map(|name| {
        let inner = folder.path().join("folder");
        fs::create_dir_all(&inner).expect("a folder");
        inner.join(name)
    });
    let small = ["mesh", "--rectangle", "4x3", "--intervals", "3,3,2,2"];
    let twice = small.into_iter().chain(["-o", text(&plain), "-o", text(&detour)]);
    mindeg(twice).refuses(&["the same file"]);
    // A .gltf writes its .bin, too.
    let (gltf, binary) = (folder.path().join("x.gltf"), folder.path().join("x.bin"));
    let run = mindeg(small.into_iter().chain([
        "-o",
        text(&gltf),
        "-o",
        text(&binary),
        "--format",
        "obj",
    ]));
    run.refuses(&["two outputs would write", "x.bin (a .gltf has a .bin beside it)"]);
    assert_eq!(content(folder.path()), ["folder"]);
}

/// Runs commands on a file system of some KiB, if the system allows one.
struct SmallDisk {
    folder: tempfile::TempDir,
    unshare: &'static str,
}

impl SmallDisk {
    fn new() -> Option<Self> {
        let allowed = |flags: &&str| {
            let mount = "mount -t tmpfs none /mnt || mount -t tmpfs none /tmp";
            let run = Command::new("unshare").args([flags, "sh", "-c", mount]).output();
            run.is_ok_and(|run| run.status.success())
        };
        let unshare = ["-m", "-Urm"].into_iter().find(allowed);
        if unshare.is_none() {
            // Past the harness, which keeps back what a test says as long as it passes.
            let _ = writeln!(io::stderr(), "NOT TESTED: full disks; unshare and mount are refused");
        }
        Some(Self { folder: tempfile::tempdir().expect("a folder"), unshare: unshare? })
    }

    /// Runs mindeg on the disk, which holds kept.obj, and returns the disk's contents afterwards.
    fn mindeg(&self, kibibytes: u64, arguments: &[&str]) -> (Run, String) {
        let script = r#"
            mount -t tmpfs -o size="$1k" none "$2" && cd "$2" && echo before > kept.obj || exit 99
            binary=$3
            shift 3
            "$binary" "$@"
            code=$?
            ls -A && cat kept.obj
            exit $code"#;
        let mut command = Command::new("unshare");
        command
            .args([self.unshare, "sh", "-c", script, "sh", &kibibytes.to_string()])
            .args([self.folder.path(), Path::new(env!("CARGO_BIN_EXE_mindeg"))])
            .args(arguments);
        let run = output_of(&mut command);
        let after = String::from_utf8_lossy(&run.stdout).into_owned();
        let errors = String::from_utf8_lossy(&run.stderr).into_owned();
        (Run { code: run.status.code(), output: Vec::new(), errors }, after)
    }
}

const NOTHING_NEW: &str = "kept.obj\nbefore\n";

#[test]
fn a_full_disk_leaves_nothing() {
    let Some(disk) = SmallDisk::new() else { return };
    let thousands = ["mesh", "--rectangle", "4x3", "--intervals", "5000,5000,5000,5000", "-q"];
    let outputs = |files: &[&'static str]| {
        let outputs = files.iter().flat_map(|&file| ["-o", file]);
        thousands.into_iter().chain(outputs).collect::<Vec<_>>()
    };
    let len = |format| {
        let run = mindeg(thousands.into_iter().chain(["-o", "-", "--format", format]));
        assert_eq!(run.code, Some(0), "{run:?}");
        run.output.len() as u64
    };
    let [obj, glb] = ["obj", "glb"].map(len);

    // The disk takes either, but not both.
    let capacity = (obj.max(glb) + 50_000) / 1024;
    let (run, after) = disk.mindeg(capacity, &outputs(&["kept.obj", "new.glb"]));
    refuses(1, &run, &["cannot write ", "No space left"]);
    assert_eq!(after, NOTHING_NEW);
    for file in ["kept.obj", "new.glb", "new.gltf"] {
        let (run, after) = disk.mindeg(capacity, &outputs(&[file]));
        assert_eq!(run.code, Some(0), "{run:?}");
        assert!(after.contains(file) && !after.contains(".part"), "{after}");
    }
    for (file, len) in [("kept.obj", obj), ("new.glb", glb), ("new.svg", 100_000)] {
        let (run, after) = disk.mindeg(len / 1024 - 8, &outputs(&[file]));
        refuses(1, &run, &[&format!("cannot write {file}"), "No space left"]);
        assert_eq!(after, NOTHING_NEW);
    }
}

#[test]
fn a_file_beyond_what_the_system_allows_leaves_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let limited = "ulimit -f 200; cd \"$1\"; exec \"$2\" mesh --rectangle 4x3 -o x.obj \
                   --intervals 5000,5000,5000,5000";
    let mindeg = env!("CARGO_BIN_EXE_mindeg");
    let folder_name = text(folder.path());
    let run = output_of(Command::new("sh").args(["-c", limited, "sh", folder_name, mindeg]));
    let errors = String::from_utf8_lossy(&run.stderr);
    assert_eq!(run.status.code(), Some(1), "{errors}");
    assert!(errors.contains("cannot write x.obj: File too large"), "{errors}");
    assert!(content(folder.path()).is_empty());
}

/// A ring with a hole that has more possible triangles than the search takes: each command says what is known, and what
/// to do.
#[test]
fn gaps_of_large_domains_say_what_to_do() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("large.json");
    let corner = |corner: u32| {
        let (sin, cos) = (f64::from(corner) * std::f64::consts::TAU / 200.0).sin_cos();
        let radius = if corner.is_multiple_of(2) { 100.0 } else { 99.99 };
        format!("[{}, {}]", radius * cos, radius * sin)
    };
    let ring = (0..200).map(corner).collect::<Vec<_>>().join(", ");
    let hole = r#"[{"ring": [[1, 1], [2, 1], [1.5, 2]]}]"#;
    let limits = (0..9).map(|v| format!(r#"{{"vertex": {v}, "max_degree": 3}}"#));
    let limits = limits.collect::<Vec<_>>().join(", ");
    let domain = format!(r#"{{"ring": [{ring}], "holes": {hole}, "vertices": [{limits}]}}"#);
    fs::write(&file, domain).expect("a file");
    let degree = mindeg(["degree", text(&file)]);
    assert!(degree.text().contains("is possible is not known: the search of all meshes takes a"));
    assert!(degree.text().contains("which --effort multiplies"), "{degree:?}");
    let trade_off = mindeg(["tradeoff", text(&file)]);
    assert!(trade_off.text().contains("Not all of these are proven"), "{trade_off:?}");
    assert!(!trade_off.text().contains("fewer points"), "{trade_off:?}");
    for (limit, words) in [
        ("3", "no mesh here has maximum degree 3: each has at least 4, as mindeg degree proves"),
        ("4", "no mesh of maximum degree 4 was found; "),
    ] {
        let run = mindeg(["mesh", text(&file), "--max-degree", limit, "-o", "x.obj"]);
        refuses(2, &run, &[words]);
    }
}
