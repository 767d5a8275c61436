//! Memory does not grow with a mesh that streams, and where there is too little of it a run says so.

use crate::run::{Running, shell};
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
        let peak = peak(1 << 20, format, per_vertex);
        assert!(peak < limit, "{format}: {peak} bytes");
    }
}

/// Runs mindeg in a folder under limits on memory, in KB: each run gives a result, or ends with
/// exit code 1 and a message that names `what`. Gives the codes.
#[track_caller]
fn codes(folder: &std::path::Path, arguments: &str, what: &str) -> [Option<i32>; 5] {
    [20_000, 60_000, 200_000, 500_000, 1_500_000].map(|kilobytes| {
        let script = format!("ulimit -c 0; ulimit -v {kilobytes}; exec \"$MINDEG\" {arguments}");
        let run = shell(folder, &script);
        let message = &run.errors;
        match run.code {
            Some(0) => assert_eq!(message, "", "{kilobytes} KB, {arguments}"),
            Some(1) => assert!(
                message.contains("out of memory: ") && message.contains(what),
                "{kilobytes} KB, {arguments}: {message}"
            ),
            _ => unreachable!("{kilobytes} KB, {arguments}: {run:?}"),
        }
        run.code
    })
}

/// A tube that is open at both ends, as an OBJ of 30,000 vertices, from this height up.
fn tube(height: u32) -> String {
    const AROUND: u32 = 100;
    const RINGS: u32 = 300;
    let mut obj = String::new();
    for ring in 0..RINGS {
        for i in 0..AROUND {
            let angle = std::f64::consts::TAU * f64::from(i) / f64::from(AROUND);
            let z = f64::from(height) + 0.01 * f64::from(ring);
            obj.push_str(&format!("v {:.9} {:.9} {z:.4}\n", angle.cos(), angle.sin()));
        }
    }
    for ring in 1..RINGS {
        for i in 0..AROUND {
            let [a, b] = [i, (i + 1) % AROUND].map(|i| (ring - 1) * AROUND + i + 1);
            let (c, d) = (a + AROUND, b + AROUND);
            obj.push_str(&format!("f {a} {b} {d}\nf {a} {d} {c}\n"));
        }
    }
    obj
}

#[test]
fn too_little_memory_ends_every_command_with_what_it_was_for() {
    let folder = tempfile::tempdir().expect("a folder");
    let codes = |arguments: &str, what: &str| codes(folder.path(), arguments, what);
    let made = "\"$MINDEG\" mesh --rectangle 4x3 --size 2e-5 -q -o m.obj -o m.glb -o m.gltf; \
                echo '{\"name\": \"plate\", \"rectangle\": {\"width\": 4, \"height\": 3}, \
                \"size\": 0.01}' > plate.json; \
                \"$MINDEG\" mesh plate.json --size 0.03 --interior -q -o plate.obj";
    assert_eq!(shell(folder.path(), made).code, Some(0));
    for (name, height) in [("open.obj", 0), ("lid.obj", 5)] {
        fs::write(folder.path().join(name), tube(height)).expect("a file");
    }
    let (result, refusal) = (Some(0), Some(1));

    // What takes next to nothing is done at any of these limits.
    for small in [
        "degree 3,3,2,2",
        "suggest 30,2,4,2",
        "suggest 1000000000,1,1,1 --target 100000",
        "completions bash",
        "domain plate.json",
        "degree plate.json",
        "suggest plate.json",
    ] {
        assert_eq!(codes(small, ""), [result; 5], "{small}");
    }
    // More threads than there is memory for.
    let holes = concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/domains/plate-with-holes.json");
    for kilobytes in [20_000, 100_000, 600_000] {
        let threads = format!(
            "ulimit -c 0; ulimit -v {kilobytes}; RAYON_NUM_THREADS=64 exec \"$MINDEG\" degree {holes}"
        );
        assert_eq!(shell(folder.path(), &threads).code, result, "{kilobytes} KB");
    }
    for small in [
        "mesh --rectangle 4x3 --size 0.5 -q -o s.obj -o s.glb -o s.svg",
        "mesh --rectangle 4x3 --size 0.5 -q --max-degree 5 -o s.obj",
        "tradeoff --rectangle 4x3 --size 0.5 -o t.html",
    ] {
        assert_eq!(codes(small, "the domain")[4], result, "{small}");
    }
    // The rest needs more than the least of the limits, and no more than the largest.
    for (arguments, what) in [
        ("mesh --rectangle 4x3 --size 2e-5 -q -o b.obj -o b.glb", "meshing the domain"),
        ("mesh plate.json --optimize angle -q -o b.obj", "plate"),
        ("tradeoff --rectangle 4x3 --intervals 300,300,300,300 --limit 1", "the domain"),
        ("compare --rectangle 4x3 --size 4e-4 -q -o c.html --time-limit 1", "comparing the domain"),
        ("compare plate.json -q -o f/ --size 4e-4 --time-limit 1", "comparing plate"),
        ("inspect m.obj --json", "reading m.obj"),
        ("inspect m.glb --json", "m.glb"),
        ("convert m.obj -q -o x.glb", "reading m.obj"),
        ("convert m.glb -q -o x.obj", "reading m.glb"),
        ("view m.obj -q -o v.html", "m.obj"),
        ("verify m.obj --rectangle 4x3 --size 2e-5 -q", "m.obj"),
        ("improve plate.obj -q -o i.obj --write-anyway", "plate.obj"),
        ("mesh plate.json --size 0.03 --interior -q -o p.obj", "plate"),
        ("mesh open.obj --intervals 1 -q -o faces.obj", "open.obj"),
        ("fill open.obj -q -o closed.obj", "open.obj"),
        ("bridge open.obj lid.obj --from 2 --to 1 -q -o joined.obj", "open.obj"),
    ] {
        let codes = codes(arguments, what);
        assert_eq!((codes[0], codes[4]), (refusal, result), "{arguments}: {codes:?}");
    }
}
