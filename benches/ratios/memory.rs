//! The peak memory of `mindeg mesh`, measured by `/usr/bin/time`.
//!
//! The real file is written to the target folder, which takes 13 GB for a moment.

use crate::table;
use std::path::Path;
use std::process::{Command, Stdio};

/// Four sides of a square that has the origin in the middle, where 32-bit floats are finest.
const SQUARE: &str = "-1,-1 1,-1 1,1 -1,1";

pub(crate) fn print() {
    if !Path::new("/usr/bin/time").exists() {
        println!("\nMemory was not measured: /usr/bin/time is not there (package `time`).");
        return;
    }
    let columns = ["output", "triangles", "to", "seconds", "peak memory, MB (aim 64)"];
    table::head("Memory of `mindeg mesh`", &columns);
    // About the most intervals to a side for which a .glb stays below 4 GiB.
    let largest_glb = 24_402_000;
    for (format, intervals) in
        [("obj", 250_000), ("obj", 25_000_000), ("glb", 250_000), ("glb", largest_glb)]
    {
        let file =
            Path::new(env!("CARGO_TARGET_TMPDIR")).join("mindeg-ratios").with_extension(format);
        for (to, path) in
            [("/dev/null", Path::new("/dev/null")), ("pipe", Path::new("-")), ("file", &file)]
        {
            let (seconds, megabytes) = measure(format, intervals, path);
            let mark = if megabytes <= 64.0 { "" } else { "**" };
            table::row(&[
                format.to_uppercase(),
                format!("{:.1} million", f64::from(4 * intervals - 2) / 1e6),
                to.to_owned(),
                format!("{seconds:.1}"),
                format!("{mark}{megabytes:.1}{mark}"),
            ]);
        }
        std::fs::remove_file(&file).unwrap();
    }
}

/// Seconds and megabytes.
fn measure(format: &str, intervals: u32, path: &Path) -> (f64, f64) {
    let mut child = Command::new("/usr/bin/time")
        .args(["-f", "%e %M", env!("CARGO_BIN_EXE_mindeg"), "mesh", "--quiet", "--corners", SQUARE])
        .args(["--intervals", &[intervals; 4].map(|count| count.to_string()).join(",")])
        .args(["--format", format, "-o"])
        .arg(path)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // Whoever reads the pipe takes what comes and keeps nothing.
    std::io::copy(&mut child.stdout.take().unwrap(), &mut std::io::sink()).unwrap();
    let output = child.wait_with_output().unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{said}");
    let (seconds, kilobytes) = said.trim().split_once(' ').unwrap();
    (seconds.parse().unwrap(), kilobytes.parse::<f64>().unwrap() * 1024.0 / 1e6)
}
