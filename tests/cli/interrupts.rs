//! Stopping a run, or closing its output, leaves neither a half-written file nor a temporary file.

use crate::mesh::{content, text};
use crate::run::{Running, hearing_signals, output_of};
use std::fs;
use std::io::Read;
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// The arguments of a run: half a million triangles, too many for a pipe to take at once.
const MESH: [&str; 5] =
    ["mesh", "--rectangle", "4x3", "--intervals", "125000,125000,125000,125000"];

const A_MOMENT: Duration = Duration::from_millis(5);

fn start(folder: &Path, arguments: &[&str]) -> Running {
    let mut command = hearing_signals("sh");
    command
        // Some signals would leave a core file in the folder.
        .args(["-c", "ulimit -c 0; exec \"$@\"", "sh", env!("CARGO_BIN_EXE_mindeg")])
        .args(MESH)
        .args(arguments)
        .current_dir(folder)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    Running::start(&mut command)
}

/// Waits until something is so; it is when the run is where it should be.
#[track_caller]
fn wait_until(so: impl Fn() -> bool) {
    let start = Instant::now();
    while !so() {
        assert!(start.elapsed() < Duration::from_secs(60), "it never comes to that");
        sleep(A_MOMENT);
    }
}

/// The lengths of the temporary files of a folder.
fn temporary(folder: &Path) -> Vec<u64> {
    let names = content(folder).into_iter().filter(|name| name.ends_with(".part"));
    names.filter_map(|name| Some(fs::metadata(folder.join(name)).ok()?.len())).collect()
}

fn folder_with(kept: &[&str]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for name in kept {
        fs::write(folder.path().join(name), "before").expect("a file to keep");
    }
    folder
}

#[track_caller]
fn is_as_before(folder: &Path, kept: &[&str]) {
    assert_eq!(content(folder), kept);
    for name in kept {
        assert_eq!(fs::read_to_string(folder.join(name)).expect("it is there"), "before");
    }
}

#[test]
fn a_signal_ends_the_run_and_leaves_what_was_there() {
    // SIGHUP, SIGINT, SIGQUIT, SIGALRM, SIGTERM, SIGXCPU
    for signal in [1, 2, 3, 14, 15, 24] {
        let kept = ["mesh.bin", "mesh.gltf", "mesh.obj"];
        let folder = folder_with(&kept);
        let outputs =
            ["-o", "mesh.obj", "-o", "mesh.gltf", "-o", "new.glb", "-o", "-", "--format", "obj"];
        let mut child = start(folder.path(), &outputs);
        // Nobody reads standard output, so the run waits there with all files written.
        wait_until(|| temporary(folder.path()).iter().filter(|&&len| len > 5_000_000).count() == 3);
        child.send(signal);
        let status = child.status();
        assert_eq!(status.signal(), Some(signal));
        is_as_before(folder.path(), &kept);
    }
}

#[test]
fn signals_in_the_middle_of_a_file_leave_what_was_there() {
    for wait_for in [0, 1, 10_000_000] {
        let kept = ["mesh.obj"];
        let folder = folder_with(&kept);
        let mut child = start(folder.path(), &["-o", "mesh.obj", "-o", "-", "--format", "obj"]);
        wait_until(|| temporary(folder.path()).iter().any(|&len| len >= wait_for));
        // Several signals, as from a user who loses patience.
        for signal in [2, 2, 15] {
            child.send(signal);
        }
        assert!(child.status().signal().is_some());
        is_as_before(folder.path(), &kept);
    }
}

/// Only Linux tells a process what it was started to ignore.
#[cfg(target_os = "linux")]
#[test]
fn a_hangup_that_is_to_be_ignored_is() {
    let mut command = Command::new("sh");
    command
        .args(["-c", "trap '' HUP; exec \"$@\"", "sh", env!("CARGO_BIN_EXE_mindeg")])
        .args(MESH)
        .args(["-o", "-", "--format", "obj", "-q"])
        .stdout(Stdio::piped());
    let mut child = Running::start(&mut command);
    let mut out = child.take_output();
    let mut begin = [0];
    out.read_exact(&mut begin).expect("the run writes");
    child.send(1);
    let mut rest = Vec::new();
    out.read_to_end(&mut rest).expect("the run writes on");
    assert_eq!(child.status().code(), Some(0));
    assert!(rest.ends_with(b"\n") && rest.len() > 10_000_000);
}

#[test]
fn a_reader_that_stops_early_does_not_keep_files_from_others() {
    let folder = folder_with(&["mesh.obj"]);
    let outputs = ["-o", "-", "--format", "obj", "-o", "mesh.obj", "-o", "mesh.glb"];
    let mut child = start(folder.path(), &outputs);
    let mut begin = [0; 100];
    let mut out = child.take_output();
    out.read_exact(&mut begin).expect("the run writes");
    drop(out);
    let output = child.output();
    assert_eq!((output.status.code(), output.stderr), (Some(0), Vec::new()));
    assert_eq!(content(folder.path()), ["mesh.glb", "mesh.obj"]);
    assert!(fs::read(folder.path().join("mesh.obj")).expect("it is there").starts_with(&begin));
}

#[test]
fn a_named_pipe_is_written_to() {
    let folder = folder_with(&[]);
    let pipe = folder.path().join("pipe.obj");
    assert!(Command::new("mkfifo").arg(&pipe).status().expect("mkfifo is there").success());
    for (reader, least) in [("cat", 10_000_000), ("head -c 1000", 1000)] {
        let mut child = start(folder.path(), &["-o", "pipe.obj", "-q"]);
        let script = format!("timeout 60 {reader} < \"$1\"");
        let read = output_of(Command::new("sh").args(["-c", &script, "sh", text(&pipe)]));
        assert!(read.stdout.len() >= least);
        assert_eq!(child.status().code(), Some(0));
        assert_eq!(content(folder.path()), ["pipe.obj"]);
    }
}

#[test]
fn what_others_opened_is_never_replaced() {
    let folder = folder_with(&[]);
    let file = folder.path().join("x.obj");
    for (output, redirection) in
        [("/dev/stdout", ">>"), ("/dev/fd/1", ">>"), ("/dev/stderr", "2>>"), ("/dev/fd/7", "7>>")]
    {
        let script = format!(
            "echo '# mine' > \"$2\"; \"$1\" mesh --rectangle 4x3 --intervals 3,3,2,2 -q \
             --format obj -o {output} {redirection} \"$2\""
        );
        let mindeg = env!("CARGO_BIN_EXE_mindeg");
        let run = output_of(Command::new("sh").args(["-c", &script, "sh", mindeg, text(&file)]));
        assert_eq!(run.status.code(), Some(0));
        let written = fs::read_to_string(&file).expect("it is there");
        assert!(written.starts_with("# mine\n# mindeg") && written.contains("\nf "), "{written}");
    }
}

#[test]
fn a_file_keeps_its_permissions() {
    use std::os::unix::fs::PermissionsExt;
    let folder = folder_with(&["private.obj", "protected.obj"]);
    let path = |name: &str| folder.path().join(name);
    let mode = |name: &str, mode| {
        let permissions = fs::Permissions::from_mode(mode);
        fs::set_permissions(path(name), permissions).expect("the file is ours");
    };
    mode("private.obj", 0o600);
    mode("protected.obj", 0o444);
    let write = |name| start(folder.path(), &["-q", "-o", name]).output();

    assert_eq!(write("private.obj").status.code(), Some(0));
    let written = fs::metadata(path("private.obj")).expect("it is there");
    assert!(written.len() > 10_000_000);
    assert_eq!(written.permissions().mode() & 0o777, 0o600);

    let refused = write("protected.obj");
    assert_eq!(refused.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("protected.obj: it is read-only"));
    assert_eq!(fs::read_to_string(path("protected.obj")).expect("it is there"), "before");
}
