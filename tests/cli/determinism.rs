//! The same bytes in every run: tests/determinism/digests.txt, with one, two and seven threads.

use crate::run::output_of;
use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

fn repository() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The output of `sha256sum` for some bytes.
fn sha256(bytes: &[u8]) -> String {
    let mut command = Command::new("sha256sum");
    let mut child =
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().expect("sha256sum");
    child.stdin.take().expect("a pipe").write_all(bytes).expect("it reads");
    let output = child.wait_with_output().expect("it ends");
    String::from_utf8_lossy(&output.stdout).split(' ').next().unwrap_or_default().to_owned()
}

/// A third of the cases, each with another number of threads; tests/determinism/run does all.
#[test]
fn what_is_written_has_the_committed_digest_with_any_number_of_threads() {
    let digests = fs::read_to_string(repository().join("tests/determinism/digests.txt"))
        .expect("the digests");
    let mut threads = [1, 2, 7].into_iter().cycle();
    let mut tried = 0;
    for line in digests.lines() {
        let [name, goal, format, digest] = line.split(' ').collect::<Vec<_>>()[..] else {
            unreachable!("{line}")
        };
        let options: &[&str] = match goal {
            "least" => &[],
            "keep-95" => &["--keep-angle", "95%"],
            "interior" => &["--interior"],
            // Models take seconds each.
            _ => continue,
        };
        if !matches!((goal, format), ("least", "obj" | "vtu" | "msh") | (_, "obj")) {
            continue;
        }
        let file = repository().join(format!("assets/domains/{name}.json"));
        let count = threads.next().unwrap_or(1);
        let mut command = Command::new(env!("CARGO_BIN_EXE_mindeg"));
        command.args(["mesh", "-q", "-o", "-", "--format", format]).arg(file).args(options);
        let run = output_of(command.env("RAYON_NUM_THREADS", count.to_string()));
        assert!(run.status.success(), "{line}: {}", String::from_utf8_lossy(&run.stderr));
        assert_eq!(sha256(&run.stdout), digest, "{line}, {count} threads");
        tried += 1;
    }
    assert_eq!(tried, 5 * 13);
}
