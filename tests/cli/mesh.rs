use crate::run::{Run, ends_quietly_when_nobody_reads, mindeg, mindeg_reading};
use mindeg_core::verify;
use mindeg_formats::obj;
use std::fs;
use std::path::{Path, PathBuf};

/// The bundled domains that are not convex, or whose sides are curved: not every command takes them.
const OTHERS: [&str; 5] = [
    "great-britain.json",
    "half-round-cap.json",
    "l-bracket.json",
    "plate-with-holes.json",
    "step-channel.json",
];

/// The bundled domains that are convex with straight sides.
pub(crate) fn domains() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/domains");
    let mut domains: Vec<PathBuf> = fs::read_dir(folder)
        .expect("the domains are there")
        .map(|entry| entry.expect("the folder can be read").path())
        .collect();
    domains.retain(|path| !OTHERS.iter().any(|name| path.ends_with(name)));
    domains.sort();
    domains
}

/// Who begins with an example reads nothing of what is wrong with it.
#[test]
fn no_bundled_domain_has_a_note() {
    for file in
        domains().into_iter().chain(OTHERS.map(|name| PathBuf::from("assets/domains").join(name)))
    {
        let answer = mindeg(["degree", text(&file), "--json"]).json();
        assert_eq!(answer.get("notes"), None, "{file:?}");
    }
}

pub(crate) fn text(path: &Path) -> &str {
    path.to_str().expect("paths here are UTF-8")
}

/// The names of everything in a folder.
pub(crate) fn content(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .expect("the folder is there")
        .map(|entry| entry.expect("it can be read").file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

#[test]
fn every_domain_is_meshed_into_every_format() {
    let folder = tempfile::tempdir().expect("a folder for the files");
    let domains = domains();
    assert_eq!(domains.len(), 8);
    for domain in domains {
        let file = |extension| folder.path().join("mesh").with_extension(extension);
        let files = ["obj", "glb", "gltf", "svg"].map(file);
        let mut arguments = vec!["mesh", text(&domain), "--json"];
        files.iter().for_each(|file| arguments.extend(["-o", text(file)]));
        let summary = mindeg(arguments).json();

        assert_eq!(summary["max_degree"], summary["least_max_degree"], "{domain:?}");
        let all = ["mesh.obj", "mesh.glb", "mesh.gltf", "mesh.bin", "mesh.svg"];
        let all = all.map(|name| folder.path().join(name));
        assert_eq!(summary["files"], serde_json::json!(all.each_ref().map(|file| text(file))));
        assert_eq!(
            content(folder.path()),
            ["mesh.bin", "mesh.glb", "mesh.gltf", "mesh.obj", "mesh.svg"]
        );

        let read = |path: &Path| fs::read(path).expect("the file was written");
        let obj = obj::read(&read(&files[0])[..]).expect("the OBJ reads back");
        let vertices = summary["vertices"].as_u64().expect("a count");
        assert_eq!(obj.positions().len() as u64, vertices, "{domain:?}");
        assert_eq!(obj.triangles().len() as u64, summary["triangles"].as_u64().expect("a count"));
        let loops = obj.boundary_loops();
        assert_eq!(loops.len(), 1, "{domain:?}");
        assert_eq!(loops[0].vertices.len() as u64, vertices, "{domain:?}");
    }
}

#[test]
fn a_summary_says_what_was_meshed_and_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str| text(&folder.path().join(name)).to_owned();
    let clockwise = br#"{"name": "wedge", "polygon": {"corners": [[0, 0], [0, 3], [4, 0]]},
        "sides": [{"intervals": 3}, {"intervals": 2}, {"intervals": 1}]}"#;
    let [gltf, svg] = ["w.gltf", "w.svg"].map(file);
    let mesh = |more: &[&str]| {
        let arguments = ["mesh", "-", "-o", &gltf, "-o", &svg];
        mindeg_reading(arguments.iter().chain(more), clockwise)
    };
    let summary = mesh(&["--json"]).json();
    assert_eq!(summary["name"], "wedge");
    assert_eq!(summary["reversed"], true);
    let intervals = summary["intervals"].as_array().expect("a list").clone();
    assert_eq!(intervals.iter().filter_map(serde_json::Value::as_u64).sum::<u64>(), 6);
    assert_eq!(summary["files"], serde_json::json!([gltf, file("w.bin"), svg]));
    let said = mesh(&[]).errors;
    assert!(said.contains(&format!("wrote {gltf}, {}, {svg}\n", file("w.bin"))), "{said}");
    assert!(said.contains("ran clockwise"), "{said}");

    let unnamed = ["mesh", "--rectangle", "4x3", "--size", "1", "-o", "-", "--format", "obj"];
    let run = mindeg(unnamed);
    assert!(
        run.errors.starts_with("domain: 14 vertices") && !run.errors.contains("wrote"),
        "{run:?}"
    );
    let summary = mindeg([&unnamed[..5], &["--json", "-o", &svg]].concat()).json();
    assert_eq!((&summary["name"], &summary["reversed"]), (&serde_json::Value::Null, &false.into()));
    assert_eq!(summary["intervals"], serde_json::json!([4, 3, 4, 3]));
}

#[test]
fn a_failed_gate_names_what_fails_in_the_usual_digits() {
    let panel = domains().into_iter().find(|path| path.ends_with("wing-panel.json"));
    let panel = panel.expect("the domain is there");
    let mesh = ["mesh", text(&panel), "-o", "/dev/null", "--format", "obj"];
    let run = mindeg(mesh.iter().chain(&["--target-angle", "10"]));
    assert_eq!(run.code, Some(3), "{run:?}");
    let message = &run.errors;
    assert!(message.starts_with("error: triangle "), "{message}");
    assert!(message.contains("has an angle of 0.475°, below the target angle of 10°"), "{message}");
    assert!(message.contains("(vertices "), "{message}");
    // With another goal, the degree is demanded as well.
    let both = ["--keep-angle", "95%", "--max-degree", "4", "--target-angle", "10"];
    let message = mindeg(mesh.iter().chain(&both)).errors;
    assert!(message.contains(" edges, more than the maximum degree of 4; triangle "), "{message}");
    assert!(message.contains("; --write-anyway writes the mesh all the same"), "{message}");
}

#[test]
fn the_mesh_written_is_the_proven_one() {
    let run = mindeg([
        "mesh",
        "--rectangle",
        "4x3",
        "--intervals",
        "12,9,4,4",
        "-o",
        "-",
        "--format",
        "obj",
        "-q",
    ]);
    assert_eq!((run.code, run.errors.as_str()), (Some(0), ""));
    let mesh = obj::read(&run.output[..]).expect("the OBJ reads back");
    let verified = verify(&[12, 9, 4, 4], mesh.triangles().iter().copied());
    assert_eq!(verified.expect("a triangulation").max_degree, 5);
}

#[test]
fn a_domain_comes_from_standard_input() {
    let domain = br#"{"name": "fan", "polygon": {"corners": [[0, 0], [4, 0], [0, 3]]},
        "sides": [{"intervals": 3}, {"size": 1}, {"intervals": 2, "name": "left"}]}"#;
    let run = mindeg_reading(["mesh", "-", "-o", "-", "--format", "obj"], domain);
    assert_eq!(run.code, Some(0), "{}", run.errors);
    assert!(run.errors.contains("fan: 10 vertices, 8 triangles, maximum degree 4"), "{run:?}");
}

#[test]
fn options_override_the_file() {
    let panel = domains().into_iter().find(|path| path.ends_with("figure-1.json"));
    let panel = panel.expect("the domain is there");
    let count = |arguments: &[&str]| {
        let common = ["mesh", text(&panel), "-o", "/dev/null", "--format", "obj", "--json"];
        mindeg(common.iter().chain(arguments)).json()["vertices"].clone()
    };
    assert_eq!(count(&[]), 10);
    assert_eq!(count(&["--intervals", "5,4,5,4"]), 18);
    assert!(count(&["--size", "0.1"]).as_u64() > Some(50));
}

#[test]
fn bad_input_is_refused_with_what_to_do() {
    let rectangle = ["mesh", "--rectangle", "4x3", "-o", "x.obj"];
    let with = |more: &[&str]| mindeg(rectangle.iter().chain(more));
    with(&[]).refuses(&["--intervals", "--size"]);
    with(&["--intervals", "3,3,2"]).refuses(&["3 counts for 4 sides"]);
    with(&["--intervals", "3,3,0,2"]).refuses(&["side 3", "at least 1"]);
    with(&["--intervals", "3,3,2,2", "--size", "1"]).refuses(&["--size"]);
    with(&["--size", "0"]).refuses(&["size"]);
    with(&["--size", "nan"]).refuses(&["size"]);
    with(&["--size", "1e-300"]).refuses(&["side 1", "4294967294"]);
    with(&["--intervals", "3,3,2,2", "--spacing", "geometric:0"]).refuses(&["side 1", "ratio"]);
    with(&["--intervals", "3,3,2,2", "--spacing", "gemetric:1.2"]).refuses(&["geometric"]);
    with(&["--intervals", "3,3,2,2", "-o", "y.fbx"]).refuses(&["y.fbx", ".obj", "--format"]);
    with(&["--intervals", "3,3,2,2", "-o", "-"]).refuses(&["--format"]);
    with(&["--intervals", "3,3,2,2", "-o", "-", "--format", "gltf"]).refuses(&[".bin", "glb"]);
    with(&["--intervals", "3,3,2,2", "-o", "-", "--format", "obj", "--json"])
        .refuses(&["standard output"]);
    with(&["--intervals", "3,3,2,2", "-o", "x.obj"]).refuses(&["x.obj", "twice"]);
    mindeg(["mesh", "-o", "x.obj"]).refuses(&["--rectangle"]);
    mindeg(["mesh", "--rectangle", "4", "-o", "x.obj"]).refuses(&["4x3"]);
    mindeg(["mesh", "--rectangle", "-4x3", "--size", "1", "-o", "x.obj"]).refuses(&["width"]);
    let corners =
        |corners: &str| mindeg(["mesh", "--corners", corners, "--size", "1", "-o", "x.obj"]);
    corners("0,0 1,0").refuses(&["3"]);
    corners("0,0 4,0 0,4 4,4").refuses(&["side 4", "side 2", "(2, 2)"]);
    corners("0,0 4,0 0,0 0,4").refuses(&["corner 2", "folds back"]);
    corners("0,0 1,0 1,nan").refuses(&["corner 3"]);
    corners("0,0 1;0 1,1").refuses(&["corner 2"]);
    assert!(!Path::new("x.obj").exists());
}

#[test]
fn bad_json_is_refused_with_its_path_and_line() {
    for (json, words) in [
        ("{", &["standard input", "line 1"][..]),
        ("{\n\"rectangle\": 4}", &["rectangle", "line 2"]),
        (
            "{\"rectangle\": {\"width\": 4, \"height\": 3},\n\"sides\": [{\"interval\": 3}]}",
            &["sides[0]", "interval", "line 2"],
        ),
        (
            "{\"rectangle\": {\"width\": 4, \"height\": 3}, \"sides\": [{\"intervals\": 3}]}",
            &["sides", "outline has 4"],
        ),
    ] {
        mindeg_reading(["mesh", "-", "-o", "x.obj"], json.as_bytes()).refuses(words);
    }
    mindeg_reading(["mesh", "-", "-o", "x.obj"], b"\xff\xfe").refuses(&["UTF-8"]);
}

#[track_caller]
fn cannot(run: &Run, words: &[&str]) {
    assert_eq!(run.code, Some(1), "{run:?}");
    for word in words {
        assert!(run.errors.contains(word), "{word:?} is missing in: {}", run.errors);
    }
}

const SMALL: [&str; 5] = ["mesh", "--rectangle", "4x3", "--intervals", "3,3,2,2"];

#[test]
fn what_cannot_be_read_or_written_is_named() {
    cannot(&mindeg(["mesh", "no/such.json", "-o", "x.obj"]), &["no/such.json", "read"]);
    let folder = tempfile::tempdir().expect("a folder");
    let missing = folder.path().join("no/such/folder.obj");
    cannot(&mindeg(SMALL.into_iter().chain(["-o", text(&missing)])), &["folder.obj", "write"]);
    let is_folder = folder.path().join("folder.obj");
    fs::create_dir(&is_folder).expect("a folder");
    cannot(&mindeg(SMALL.into_iter().chain(["-o", text(&is_folder)])), &["is a folder"]);
    assert_eq!(content(folder.path()), ["folder.obj"]);
}

#[test]
fn files_appear_whole_or_not_at_all() {
    let folder = tempfile::tempdir().expect("a folder");
    let kept = folder.path().join("kept.obj");
    fs::write(&kept, "before").expect("a file to keep");
    // The second output cannot be written, so the first must not replace what was there.
    let missing = folder.path().join("no/such.obj");
    let run = mindeg(SMALL.into_iter().chain(["-o", text(&kept), "-o", text(&missing)]));
    cannot(&run, &["such.obj"]);
    assert_eq!(fs::read_to_string(&kept).expect("it is there"), "before");
    assert_eq!(content(folder.path()), ["kept.obj"]);

    let run = mindeg(SMALL.into_iter().chain(["-o", text(&kept)]));
    assert_eq!(run.code, Some(0), "{run:?}");
    assert!(fs::read_to_string(&kept).expect("it is there").starts_with('#'));
    assert_eq!(content(folder.path()), ["kept.obj"]);
}

#[cfg(unix)]
#[test]
fn new_files_follow_the_mask() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempfile::tempdir().expect("a folder");
    let [plain, mesh] = ["plain", "mesh.obj"].map(|name| folder.path().join(name));
    fs::write(&plain, "").expect("a file");
    let run = mindeg(SMALL.into_iter().chain(["-o", text(&mesh)]));
    assert_eq!(run.code, Some(0), "{run:?}");
    let mode = |path| fs::metadata(path).expect("it is there").permissions().mode();
    assert_eq!(mode(&mesh), mode(&plain));
}

#[cfg(unix)]
#[test]
fn a_device_is_written_to_and_not_replaced() {
    use std::os::unix::fs::FileTypeExt;
    let run = mindeg(SMALL.into_iter().chain(["-o", "/dev/null", "--format", "glb"]));
    assert_eq!(run.code, Some(0), "{run:?}");
    assert!(fs::metadata("/dev/null").expect("it is there").file_type().is_char_device());
    let full = mindeg(SMALL.into_iter().chain(["-o", "/dev/full", "--format", "glb"]));
    cannot(&full, &["/dev/full"]);
}

#[test]
fn a_reader_that_stops_early_ends_the_run_quietly() {
    let large = ["mesh", "--rectangle", "4x3", "--intervals", "50000,50000,50000,50000"];
    let quiet = ["-o", "-", "--format", "obj", "--quiet"];
    ends_quietly_when_nobody_reads(large.into_iter().chain(quiet));
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let bytes = |format| {
        let size = ["mesh", "--rectangle", "4x3", "--size", "0.1", "-o", "-", "-q", "--format"];
        mindeg(size.into_iter().chain([format])).output
    };
    for format in ["obj", "glb", "svg"] {
        assert_eq!(bytes(format), bytes(format), "{format}");
    }
}

/// With few points and holes, plain `mesh` has the mesh of the trade-off's first row; with more it names the command for it.
#[test]
fn the_first_row_is_what_mesh_makes_or_names() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    let (file, out) = (at("slit.json"), at("slit.obj"));
    let angle = |found: &serde_json::Value| found["min_angle"].as_f64().expect("an angle");
    let part = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/outlines/part.dxf");
    let made = mindeg(["mesh", part, "-o", text(&out), "--json"]).json();
    let rows = mindeg(["tradeoff", part, "--json"]).json();
    let first = &rows["points"][0];
    assert_eq!(first["max_degree"], made["max_degree"]);
    assert!((angle(first) - angle(&made)).abs() < 1e-6, "{first} {made}");

    let ten = |count: usize| vec![serde_json::json!({"intervals": 10}); count];
    let mut sides = ten(4);
    (sides[0], sides[2]) =
        (serde_json::json!({"intervals": 100}), serde_json::json!({"intervals": 20}));
    let hole = [[4.5, 1.0], [5.5, 1.0], [5.5, 2.0], [4.5, 2.0]];
    let slit = serde_json::json!({"rectangle": {"width": 10, "height": 3}, "sides": sides,
        "holes": [{"corners": hole, "sides": ten(4)}]});
    fs::write(&file, slit.to_string()).expect("a file");
    let run = mindeg(["mesh", text(&file), "-o", text(&out), "--json"]);
    let told = mindeg(["mesh", text(&file), "-o", text(&out)]).errors;
    let hint = "hint: a search that takes longer may give a larger angle at this degree:\n";
    let (before, rest) = told.split_once(hint).unwrap_or_else(|| panic!("{told}"));
    // The answer does not wait for what to do next, nor does who reads JSON.
    assert!(before.contains("\nwrote "), "{told}");
    assert!(run.errors.contains("\nwrote ") && !run.errors.contains("hint"), "{run:?}");
    let line = rest.lines().next().expect("a command");
    assert!(line.starts_with("mindeg mesh ") && line.ends_with(" --optimize angle"), "{line}");
    let words = ["mesh", text(&file), "-o", text(&out), "--optimize", "angle", "--json"];
    let (plain, best) = (run.json(), mindeg(words).json());
    assert_eq!(plain["max_degree"], best["max_degree"]);
    assert!(angle(&best) > angle(&plain), "{plain} {best}");
}

/// The advice for a patch was to make the mesh that was just written: degree 5 and 11.079° of gusset.json.
#[test]
fn the_mesh_that_was_written_is_not_advised() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("a.obj").display().to_string();
    for (domain, is_told) in [("gusset", false), ("figure-1", true)] {
        let file = format!("{}/assets/domains/{domain}.json", env!("CARGO_MANIFEST_DIR"));
        let run = mindeg(["mesh", &file, "-o", &out]);
        assert!(run.errors.contains("hint: for a solver"), "{run:?}");
        assert_eq!(run.errors.contains("hint: for a patch"), is_told, "{run:?}");
    }
}

#[test]
fn a_mesh_and_a_domain_in_each_others_place_are_told() {
    let part = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/outlines/part.dxf");
    let words = format!("swap the two: mindeg mesh {part} -o plate.obj");
    mindeg(["mesh", "plate.obj", "-o", part, "--size", "1"]).refuses(&[&words]);
}

/// Where no mesh of the points has the angle that is asked for, that is said, and what would reach it.
#[test]
fn an_angle_that_the_points_do_not_allow_is_refused_with_the_way_out() {
    let plate = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/domains/plate-with-holes.json");
    let run = mindeg(["mesh", plate, "--target-angle", "10", "-o", "-", "--format", "obj"]);
    assert_eq!(run.code, Some(3), "{run:?}");
    let words = "no mesh of these points alone has more than 4.972°; --interior puts points inside";
    assert!(run.errors.contains(words), "{}", run.errors);
}
