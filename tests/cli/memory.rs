//! Memory does not grow with a mesh that streams.

use crate::run::Running;
use std::fs;
use std::io::{self, Read};
use std::process::{Command, Stdio};

/// The peak resident set, in bytes, of a run that has written all of a file but the last bytes, in a
/// format that takes so many bytes a vertex.
fn peak(intervals: u64, format: &str, per_vertex: u64) -> u64 {
    // Four sides. No pipe takes the rest, so the run cannot end meanwhile.
    let nearly_all = 4 * intervals * per_vertex - 3_000_000;
    let mut command = Command::new(env!("CARGO_BIN_EXE_mindeg"));
    command
        .args(["mesh", "--rectangle", "4x3", "-q", "--format", format, "-o", "-", "--intervals"])
        .arg([intervals; 4].map(|count| count.to_string()).join(","))
        .stdout(Stdio::piped());
    let mut child = Running::start(&mut command);
    let mut out = child.take_output();
    let read = io::copy(&mut out.by_ref().take(nearly_all), &mut io::sink());
    assert_eq!(read.expect("the pipe is read"), nearly_all);
    let status = fs::read_to_string(format!("/proc/{}/status", child.id())).expect("it runs");
    io::copy(&mut out, &mut io::sink()).expect("the rest is read");
    assert!(child.status().success());
    let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kibibytes = peak.and_then(|peak| peak.trim().strip_suffix(" kB")).expect("Linux tells it");
    kibibytes.parse::<u64>().expect("a number") * 1024
}

#[test]
fn peak_memory_is_small_at_any_size() {
    let threads = std::thread::available_parallelism().map_or(1, |threads| threads.get() as u64);
    let limit = 64_000_000 + threads * (1 << 20);
    // The most points that are kept while plans are compared, and beyond.
    for intervals in [1 << 18, 1 << 20] {
        let peak = peak(intervals, "glb", 44);
        assert!(peak < limit, "{intervals} intervals a side: {peak} bytes");
    }
    for (format, per_vertex) in [("msh", 124), ("vtu", 110), ("vtk", 88)] {
        let peak = peak(1 << 19, format, per_vertex);
        assert!(peak < limit, "{format}: {peak} bytes");
    }
}
