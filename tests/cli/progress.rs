//! The progress of long work appears on a terminal, and nowhere else.

use crate::run::{Run, output_of};
use std::io::{self, Write};
use std::process::Command;

/// Runs a shell command that calls `$MINDEG`; with `terminal`, standard error is one. What the
/// command prints, to a terminal or not, is in the output.
fn shell(command: &str, terminal: bool) -> Option<Run> {
    let mut run = if terminal {
        let mut script = Command::new("script");
        // Its standard input is empty, or it would wait for what is typed.
        script.args(["-qec", command, "/dev/null"]).stdin(std::process::Stdio::null());
        script
    } else {
        let mut shell = Command::new("sh");
        shell.args(["-c", &format!("({command}) 2>&1")]);
        shell
    };
    run.env("MINDEG", env!("CARGO_BIN_EXE_mindeg")).env("TERM", "xterm");
    if Command::new("script").arg("--version").output().is_err() {
        // Past the harness, which keeps back what a test says as long as it passes.
        let _ = writeln!(io::stderr(), "NOT TESTED: progress on a terminal; there is no script(1)");
        return None;
    }
    let run = output_of(&mut run);
    let errors = String::from_utf8_lossy(&run.stderr).into_owned();
    Some(Run { code: run.status.code(), output: run.stdout, errors })
}

/// An OBJ of 40 MB for a reader that takes two seconds for it.
const SLOW: &str = "\"$MINDEG\" mesh --rectangle 4x3 --intervals 100000,100000,100000,100000 \
     -o - --format obj QUIET | \
     for part in 1 2 3 4 5 6 7 8 9 10; do head -c 4100000; sleep 0.2; done > /dev/null";

#[test]
fn share_and_time_show_while_files_are_written() {
    let Some(run) = shell(&SLOW.replace("QUIET", ""), true) else { return };
    let shown = run.text();
    for word in ["writing .obj ", "%, ", "s left"] {
        assert!(shown.contains(word), "{word:?} is missing in {shown:?}");
    }
    // The line is cleared before the summary.
    let (_, after) = shown.rsplit_once(" left").expect("a bar was there");
    let (cleared, summary) =
        after.split_once("domain: 400000 vertices").expect("a summary follows");
    assert!(cleared.contains("\u{1b}[2K"), "{cleared:?}");
    assert!(!summary.contains("writing"));
    // The share goes up to all there is.
    let bars = shown.split("writing .obj ").skip(1);
    let shares = bars.filter_map(|bar| bar.split_once('%')?.0.rsplit(' ').next()?.parse().ok());
    let shares: Vec<u32> = shares.collect();
    assert!(shares.is_sorted() && shares.len() > 1 && shares.iter().all(|&share| share <= 100));
}

#[test]
fn triangles_rate_and_time_show_while_the_mesh_is_chosen() {
    // A demand that no mesh meets: nothing is written.
    let command = "RAYON_NUM_THREADS=1 \"$MINDEG\" mesh --rectangle 4x3 -o /dev/null --format obj \
                   --intervals 1000000,1000000,1000000,1000000 --spacing geometric:1.000004 \
                   --target-angle 60 2>&1";
    let Some(run) = shell(command, true) else { return };
    let shown = run.text();
    let words = ["choosing the mesh ", "% of 16 million triangles, ", " million/s, ", "s left"];
    for word in words.into_iter().chain(["measuring the angles ", "% of 4 million triangles"]) {
        assert!(shown.contains(word), "{word:?} is missing in {shown:?}");
    }
    assert!(shown.contains("below the target angle of 60°"));
}

#[test]
fn bytes_show_while_a_file_is_read() {
    let folder = tempfile::tempdir().expect("a folder");
    // A file that comes in slowly.
    let command = "mkfifo \"$PIPE\"; (\"$MINDEG\" mesh --rectangle 4x3 --size 0.001 -o - -q --format obj \
                   | (head -c 100000; sleep 1.2; cat) > \"$PIPE\") & \"$MINDEG\" inspect \"$PIPE\"";
    let pipe = folder.path().join("pipe.obj");
    let command = command.replace("$PIPE", pipe.to_str().expect("paths here are UTF-8"));
    let Some(run) = shell(&command, true) else { return };
    let shown = run.text();
    let (bar, report) = shown.rsplit_once(" left").expect("a bar was there");
    assert!(bar.contains("reading ") && bar.contains(" of "), "{bar:?}");
    assert!(report.contains("\u{1b}[2K") && report.contains("nothing wrong"), "{report:?}");
}

#[test]
fn time_shows_while_methods_are_compared() {
    let folder = tempfile::tempdir().expect("a folder");
    let report = folder.path().join("report.json");
    // Ear clipping would take longer.
    let command = "\"$MINDEG\" compare --rectangle 4x3 --intervals 8000,8000,8000,8000 \
                   --time-limit 1.7 -o \"$REPORT\"";
    let command = command.replace("$REPORT", report.to_str().expect("paths here are UTF-8"));
    let Some(run) = shell(&command, true) else { return };
    let shown = run.text();
    let (_, last) = shown
        .rsplit_once("comparing the domain, 1.7 s at most for each method ")
        .unwrap_or_else(|| panic!("no bar: {shown:?}"));
    // A spinner and the seconds, of which a busy machine shows more than one.
    let (bar, verdict) = last.split_once("s ").expect("a bar ends with its time");
    let seconds = bar.rsplit(' ').next().and_then(|digits| digits.parse::<u32>().ok());
    assert!(seconds.is_some_and(|seconds| seconds >= 1), "{last:?}");
    assert!(verdict.contains("\u{1b}[2K") && verdict.contains("Delaunay"), "{verdict:?}");
    assert!(report.exists());
}

#[test]
fn no_bar_shows_where_none_is_wanted() {
    let short = "\"$MINDEG\" mesh --rectangle 4x3 --size 0.1 -o /dev/null --format obj";
    let runs = [
        // No terminal.
        (SLOW.replace("QUIET", ""), false),
        (SLOW.replace("QUIET", "--quiet"), true),
        (short.to_owned(), true),
    ];
    // At once: their readers sleep.
    std::thread::scope(|scope| {
        for (command, terminal) in &runs {
            scope.spawn(move || {
                let Some(run) = shell(command, *terminal) else { return };
                let shown = run.text();
                assert!(
                    !shown.contains("left") && !shown.contains('\u{1b}'),
                    "{command}: {shown:?}"
                );
            });
        }
    });
    // If the mesh itself goes to the terminal, no bar may disturb it.
    let folder = tempfile::tempdir().expect("a folder");
    let command = "mkfifo \"$PIPE\"; (sleep 1.2; cat \"$PIPE\" > /dev/null) & \"$MINDEG\" mesh \
                   --rectangle 4x3 --intervals 9000,9000,9000,9000 -o \"$PIPE\" -o - --format obj";
    let pipe = folder.path().join("pipe");
    let command = command.replace("$PIPE", pipe.to_str().expect("paths here are UTF-8"));
    let Some(run) = shell(&command, true) else { return };
    let shown = run.text();
    assert!(shown.contains("\nf ") && !shown.contains('\u{1b}'), "{}", &shown[..200]);
}
