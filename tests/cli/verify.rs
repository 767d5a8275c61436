//! `mindeg verify`: meshes that are right, meshes that are not, limits, and what a script gets.

use crate::mesh::text;
use crate::run::{Run, mindeg, mindeg_reading};
use std::cell::Cell;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// Every format that mindeg reads, by extension.
const READ: [&str; 12] =
    ["obj", "glb", "gltf", "msh", "vtu", "vtk", "ply", "stl", "off", "node", "14", "2dm"];

fn asset(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/domains");
    folder.join(format!("{name}.json")).to_string_lossy().into_owned()
}

/// A mesh of the 4 by 3 plate at size 1, as an OBJ whose lines a test can change.
struct Plate {
    folder: TempDir,
    file: PathBuf,
    /// The number of files with changes.
    changed: Cell<u32>,
}

const PLATE: [&str; 4] = ["--rectangle", "4x3", "--size", "1"];

impl Plate {
    fn new() -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("plate.obj");
        let run = mindeg(["mesh"].into_iter().chain(PLATE).chain(["-q", "-o", text(&file)]));
        assert_eq!(run.code, Some(0), "{run:?}");
        Self { folder, file, changed: Cell::new(0) }
    }

    /// The mesh with some lines changed.
    fn with(&self, change: impl Fn(usize, &str) -> Option<String>) -> PathBuf {
        let lines = fs::read_to_string(&self.file).expect("it was written");
        let changed = lines.lines().enumerate().filter_map(|(index, line)| change(index, line));
        self.changed.set(self.changed.get() + 1);
        let file = self.folder.path().join(format!("changed-{}.obj", self.changed.get()));
        let text: String = changed.flat_map(|line| [line, "\n".to_owned()]).collect();
        fs::write(&file, text).expect("a file");
        file
    }

    #[track_caller]
    fn verify(&self, file: &Path, options: &[&str]) -> Run {
        let arguments = ["verify", text(file)].into_iter().chain(PLATE);
        mindeg(arguments.chain(["-q"]).chain(options.iter().copied()))
    }
}

#[test]
fn a_mesh_in_any_format_passes_with_its_proof() {
    let folder = tempfile::tempdir().expect("a folder");
    let stem = folder.path().join("channel");
    let files: Vec<PathBuf> = READ.iter().map(|end| stem.with_extension(end)).collect();
    let domain = asset("step-channel");
    let outputs = files.iter().flat_map(|file| ["-o", text(file)]);
    let made = mindeg(["mesh", &domain, "-q"].into_iter().chain(outputs));
    assert_eq!(made.code, Some(0), "{made:?}");
    for file in &files {
        let found = mindeg(["verify", text(file), &domain, "-q", "--optimal", "--json"]).json();
        assert_eq!(found["valid"], true, "{found}");
        assert_eq!(found["max_degree"], 5);
        assert_eq!(found["optimal"], "yes");
        assert_eq!(found["proof"]["kind"], "blocked_zig_zags");
        assert_eq!(found["boundary_vertices"], 197);
        assert_eq!(found["interior_points"], 0);
        assert_eq!(found["passed"], true);
    }
}

#[test]
fn the_report_says_what_was_checked() {
    let plate = Plate::new();
    let run = plate.verify(&plate.file, &[]);
    let name = text(&plate.file);
    assert_eq!(
        run.text(),
        format!(
            "{name} is a triangulation of the domain\n\
             boundary points   14; the farthest vertex is 0 off (tolerance 4e-6)\n\
             interior points   0\n\
             triangles         12\n\
             maximum degree    4, at vertex 1\n\
             optimal           yes, checked: the edges are too many for 3 at every vertex (theorems 3 and 15)\n\
             minimum angle     11.310°, in triangle 3; 61.4% of the largest possible, 18.435°\n"
        )
    );
    assert_eq!((run.code, run.errors.as_str()), (Some(0), ""));
}

#[test]
fn interior_points_are_accepted_and_share_the_boundarys_limit() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("x.stl");
    let domain = asset("plate-with-holes");
    let made = mindeg(["mesh", &domain, "--interior", "-q", "-o", text(&file)]);
    assert_eq!(made.code, Some(0), "{made:?}");
    let run = mindeg(["verify", text(&file), &domain, "--keep-angle", "85%", "--json"]);
    let found = run.json();
    assert!(found["interior_points"].as_u64() > Some(100), "{found}");
    assert_eq!((&found["optimal"], &found["proof"]), (&"unknown".into(), &None::<bool>.into()));
    let [angle, limit, share] = ["min_angle", "angle_limit", "share_of_limit"]
        .map(|key| found[key].as_f64().expect("a number"));
    assert!((angle / limit - share).abs() < 1e-12 && share > 0.85, "{found}");
}

#[test]
fn a_defect_is_named_and_ends_with_3() {
    let plate = Plate::new();
    let faces = |line: &str| line.starts_with("f ");
    let lines = fs::read_to_string(&plate.file).expect("it was written");
    let first_face = lines.lines().position(faces).expect("faces");
    for (file, message) in [
        (
            plate.with(|index, line| (index != first_face + 5).then(|| line.to_owned())),
            "the edge from vertex",
        ),
        (
            plate.with(|index, line| {
                let mut words: Vec<&str> = line.split(' ').collect();
                if index == first_face {
                    words.swap(1, 2);
                }
                Some(words.join(" "))
            }),
            "is turned over",
        ),
        (
            plate.with(|index, line| {
                let twice =
                    if index == first_face { format!("{line}\n{line}") } else { line.to_owned() };
                Some(twice)
            }),
            "has the same vertices as triangle 0",
        ),
        (
            plate.with(|_, line| Some(line.replace("v 4 ", "v 4.1 "))),
            "no vertex is at boundary point",
        ),
        (
            plate.with(|index, line| {
                let is_second = index == first_face + 1;
                Some(if is_second { "f 1 2 3 4".to_owned() } else { line.to_owned() })
            }),
            "1 face has more than three corners; mindeg convert cuts it into triangles",
        ),
    ] {
        let run = plate.verify(&file, &[]);
        assert_eq!(run.code, Some(3), "{message}: {run:?}");
        assert!(run.output.is_empty(), "{run:?}");
        let start = format!("error: {} is no triangulation of the domain: ", text(&file));
        assert!(
            run.errors.starts_with(&start) && run.errors.contains(message),
            "{message}: {run:?}"
        );

        let run = plate.verify(&file, &["--json"]);
        assert_eq!(run.code, Some(3), "{run:?}");
        let report: serde_json::Value = serde_json::from_str(run.text()).expect("JSON");
        assert_eq!((&report["valid"], &report["passed"]), (&false.into(), &false.into()));
        assert!(report["defect"]["message"].as_str().is_some_and(|it| it.contains(message)));
    }
}

#[test]
fn named_limits_pass_or_say_what_fails() {
    let plate = Plate::new();
    for (options, message) in [
        (
            &["--max-degree", "4", "--target-angle", "11.3", "--keep-angle", "61%", "--optimal"][..],
            "",
        ),
        (&["--max-degree", "3"], "vertex 1 has 4 edges, more than the maximum degree of 3"),
        (
            &["--target-angle", "12"],
            "triangle 3 (vertices 2, 11, 12) has an angle of 11.310°, below the target angle of 12°",
        ),
        (
            &["--keep-angle", "70%"],
            "triangle 3 has an angle of 11.310°, 61.4% of the largest possible minimum; --keep-angle \
             asks for 70%",
        ),
        (&["--preset", "fvcom"], ""),
    ] {
        let run = plate.verify(&plate.file, options);
        assert_eq!(run.code, Some(if message.is_empty() { 0 } else { 3 }), "{run:?}");
        let said = if message.is_empty() {
            String::new()
        } else {
            format!("error: {message} (counted from 0)\n")
        };
        assert_eq!(run.errors, said);
        assert!(run.text().starts_with(text(&plate.file)), "{run:?}");
    }

    // A mesh with the best angle has a larger degree, and is told so.
    let best = plate.folder.path().join("best.obj");
    let made =
        ["mesh"].into_iter().chain(PLATE).chain(["--keep-angle", "100%", "-q", "-o", text(&best)]);
    assert_eq!(mindeg(made).code, Some(0));
    let run = plate.verify(&best, &["--optimal", "--keep-angle", "100%"]);
    assert_eq!(run.code, Some(3), "{run:?}");
    assert!(
        run.errors.contains("and a mesh with 4 exists; --optimal asks for the least"),
        "{run:?}"
    );
    assert!(run.text().contains("100% of the largest possible"), "{run:?}");
}

#[test]
fn lengths_and_areas_of_zero_are_written_as_0() {
    let plate = Plate::new();
    let moved = |x: &'static str| {
        plate.with(move |_, line| {
            let is_first = line == "v 0 0 0";
            Some(if is_first { format!("v {x} 0 0") } else { line.to_owned() })
        })
    };
    for (x, written) in [("5.551115123125783e-17", "0"), ("-3e-15", "0"), ("4e-15", "4e-15")] {
        let file = moved(x);
        let text = plate.verify(&file, &[]).text().to_owned();
        assert!(text.contains(&format!("the farthest vertex is {written} off")), "{x} {text}");
        // A program gets what was found.
        let exact = plate.verify(&file, &["--json"]).json()["farthest"].as_f64();
        assert_eq!(exact, x.trim_start_matches('-').parse().ok(), "{x}");
    }
    let domain = asset("../models/cube");
    let part = plate.folder.path().join("cube.stl");
    assert_eq!(mindeg(["mesh", &domain, "-q", "-o", text(&part)]).code, Some(0));
    let run = mindeg(["verify", text(&part), "--surface", text(&part), "--tolerance", "0"]);
    let distance = "at most 0 (0%) from the part, and back at most 0 (0%); tolerance 0 (0%)";
    // The distance found is 1e-14, which is rounding.
    assert!(run.text().contains(distance), "{run:?}");
    // Three points in a line, far from the zero of the coordinates: an area of zero, not of roundings.
    let flat = plate.folder.path().join("flat.obj");
    fs::write(&flat, "v 0.1 0.1 0\nv 0.2 0.2 0\nv 0.3 0.3 0\nf 1 2 3\n").expect("a file");
    let run = mindeg(["inspect", text(&flat)]);
    assert!(run.text().contains("Total area: 0."), "{run:?}");
}

#[test]
fn limits_of_the_domain_hold() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("x.obj");
    let domain = |limit: &str| {
        format!(
            r#"{{"rectangle": {{"width": 4, "height": 3}}, "size": 1, "sides": [
                {limit}, {{}}, {{"outside_degree": 3}}, {{}}]}}"#
        )
    };
    let made = mindeg_reading(["mesh", "-", "-q", "-o", text(&file)], domain("{}").as_bytes());
    assert_eq!(made.code, Some(0), "{made:?}");
    let verify = |limit: &str| {
        mindeg_reading(["verify", text(&file), "-", "--json"], domain(limit).as_bytes())
    };
    let found = verify("{}").json();
    assert_eq!((&found["max_degree"], &found["optimal"]), (&6.into(), &"yes".into()), "{found}");
    let run = verify(r#"{"max_degree": 3}"#);
    assert_eq!(run.code, Some(3), "{run:?}");
    assert!(run.errors.contains("more than the domain allows at boundary point"), "{run:?}");
}

#[test]
fn rounded_meshes_pass_within_the_tolerance() {
    let plate = Plate::new();
    let shifted = plate.with(|_, line| Some(line.replace("v 4 ", "v 4.001 ")));
    let run = plate.verify(&shifted, &[]);
    assert_eq!(run.code, Some(3), "{run:?}");
    assert!(run.errors.contains("if the mesh was rounded, give a larger --tolerance"), "{run:?}");
    assert_eq!(plate.verify(&shifted, &["--tolerance", "0.01"]).code, Some(0));
    plate.verify(&shifted, &["--tolerance", "1"]).refuses(&[
        "a tolerance of 1 is too large: the shortest interval is 1 long; give less than half of that",
    ]);
}

/// docs/verify.md has a row for every key.
/// A remesh and the part that it was made from: the way to compare them is named.
#[test]
fn two_meshes_are_told_how_they_are_compared() {
    let part = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/models/bracket.obj");
    mindeg(["verify", "new.obj", part])
        .refuses(&[&format!("to compare with it: mindeg verify new.obj --surface {part}")]);
    // A file that holds no mesh has the message on domains.
    let run = mindeg(["verify", part, "no-such.json"]);
    assert!(run.code == Some(1) && !run.errors.contains("--surface"), "{}", run.errors);
}

#[test]
fn every_key_of_the_report_is_documented() {
    let page = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/verify.md"))
        .expect("the page");
    let plate = Plate::new();
    let found = plate.verify(&plate.file, &["--json"]).json();
    let keys: Vec<&str> =
        found.as_object().expect("an object").keys().map(String::as_str).collect();
    let help = mindeg(["verify", "--help"]);
    let help = help.text().split_whitespace().collect::<Vec<_>>().join(" ");
    for key in &keys {
        assert!(page.contains(&format!("| `{key}` |")), "{key}");
        assert!(help.contains(key), "{key}");
    }
    assert_eq!(page.matches("\n| `").count(), keys.len() + KINDS.len() + PROOFS.len());
    for kind in KINDS.iter().chain(&PROOFS) {
        assert!(page.contains(&format!("| `{kind}` |")), "{kind}");
    }
}

const KINDS: [&str; 16] = [
    "larger_faces",
    "not_planar",
    "no_vertex",
    "repeated_vertex",
    "repeated_triangle",
    "no_area",
    "turned_over",
    "overlap",
    "outside",
    "open_boundary",
    "open_edge",
    "missing_edge",
    "filled_hole",
    "empty_region",
    "group",
    "parts",
];

const PROOFS: [&str; 13] = [
    "balanced_cut",
    "medial_triangle",
    "long_side",
    "no_balanced_cut",
    "counting",
    "blocked_zig_zags",
    "apexes",
    "no_strip",
    "refuted",
    "search",
    "edges",
    "side",
    "weights",
];

/// A vertex inside has no edges that stay, which the search for an excuse once asked for.
#[test]
fn a_vertex_inside_with_too_many_edges_is_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let [mesh, domain] = ["fan.obj", "octagon.json"].map(|name| folder.path().join(name));
    let ring = ["1 0", "0.7 0.7", "0 1", "-0.7 0.7", "-1 0", "-0.7 -0.7", "0 -1", "0.7 -0.7"];
    let points: Vec<String> =
        ring.iter().map(|at| format!("[{}]", at.replace(' ', ", "))).collect();
    fs::write(&domain, format!(r#"{{"ring": [{}]}}"#, points.join(", "))).expect("a file");
    let vertices = ring.iter().chain(&["0 0"]).map(|at| format!("v {at} 0\n"));
    let faces = (1..9).map(|v| format!("f {v} {} 9\n", v % 8 + 1));
    fs::write(&mesh, vertices.chain(faces).collect::<String>()).expect("a file");
    let run = mindeg(["verify", text(&mesh), text(&domain)]);
    assert_eq!(run.code, Some(0), "{run:?}");
    assert!(
        run.text().contains("degrees inside    1 out of range, the first at vertex 8"),
        "{run:?}"
    );
}

/// What the reason says of a bound is what `at_least` has.
#[test]
fn a_bound_below_what_is_reached_is_checked_and_told_in_json_too() {
    let folder = tempfile::tempdir().expect("a folder");
    let coast = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/outlines/saronic.geojson");
    let mesh = folder.path().join("coast.obj");
    let run = mindeg(["mesh", coast, "-q", "-o", text(&mesh)]);
    assert_eq!(run.code, Some(0), "{run:?}");
    let verdict = mindeg(["verify", text(&mesh), coast, "--json"]).json();
    assert_eq!((&verdict["optimal"], &verdict["at_least"]), (&"unknown".into(), &5.into()));
    let reason = verdict["reason"].as_str().expect("a reason");
    assert_eq!(reason, "no mesh has less than 5, checked, and none with less than 6 was found");
}
