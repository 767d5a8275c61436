//! Meshes with interior points, and the limits of their angles.

use crate::mesh::{content, domains, text};
use crate::run::{mindeg, mindeg_reading};
use mindeg_formats::obj;
use serde_json::{Value, json};
use std::fs;
use std::path::Path;
use tempfile::tempdir;

/// A rectangle whose left side is coarse between two fine ones.
const COARSE: [&str; 5] = ["mesh", "--rectangle", "4x4", "--intervals", "16,16,16,2"];

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

#[test]
fn every_domain_gets_interior_points() {
    let folder = tempfile::tempdir().expect("a folder for the files");
    for domain in domains() {
        let file = folder.path().join("mesh.obj");
        let run = mindeg(["mesh", text(&domain), "--interior", "--json", "-o", text(&file)]);
        let summary = run.json();
        assert_eq!(summary["found_by"], "interior");
        assert_eq!(summary["violations"], serde_json::json!([]), "{domain:?}");
        let limit = number(&summary["angle_limit"]);
        assert!(number(&summary["min_angle"]) >= 0.95 * limit.min(35.0), "{domain:?}: {summary}");
        assert_eq!(summary["limit"]["angle_limit"], summary["angle_limit"]);
        let [least, most] = ["at_least", "max_degree"].map(|key| number(&summary[key]));
        assert!(3.0 <= least && least <= most, "{summary}");
        let is_least = summary["least_max_degree"] == summary["max_degree"];
        assert!(is_least || summary["least_max_degree"].is_null() && least < most, "{summary}");
        let most = [&summary["boundary_degree"][1], &summary["interior_degree"][1]];
        assert_eq!(summary["max_degree"].as_u64(), most.iter().filter_map(|it| it.as_u64()).max());
        let mesh = obj::read(&fs::read(&file).expect("the file was written")[..]).expect("an OBJ");
        assert_eq!(mesh.positions().len() as u64, summary["vertices"].as_u64().expect("a count"));
        let count = summary["boundary_vertices"].as_u64().expect("a count") as u32;
        let mut rings: Vec<u32> =
            mesh.boundary_loops().iter().flat_map(|l| l.vertices.clone()).collect();
        rings.sort_unstable();
        assert_eq!(rings, (0..count).collect::<Vec<_>>(), "{domain:?}");

        // The boundary is that of the mesh without interior points, to the last digit.
        let plain = folder.path().join("plain.obj");
        assert_eq!(mindeg(["mesh", text(&domain), "-q", "-o", text(&plain)]).code, Some(0));
        let vertices = |file| -> Vec<String> {
            let text = fs::read_to_string(file).expect("the file was written");
            let lines = text.lines().filter(|line| line.starts_with("v "));
            lines.take(count as usize).map(str::to_owned).collect()
        };
        assert_eq!(vertices(&file), vertices(&plain), "{domain:?}");
    }
}

#[test]
fn the_degree_comes_with_its_bound() {
    let hub = |lines: usize| {
        let line = |turn: usize| {
            let [x, y] =
                [[4, 0], [4, 4], [0, 4], [-4, 4], [-4, 0], [-4, -4], [0, -4], [4, -4], [4, 2]]
                    [turn];
            json!({"corners": [[0, 0], [x, y]]})
        };
        json!({"polygon": {"corners": [[-4, -4], [4, -4], [4, 4], [-4, 4]]}, "size": 1,
            "lines": (0..lines).map(line).collect::<Vec<_>>()})
    };
    for (domain, at_least) in [
        // Nine lines meet, each in a triangle.
        (hub(9), 9),
        // A line that ends inside is turned around by three triangles; the edges of the square have too many ends for 3.
        (hub(1), 4),
        // Of a square with one interval to a side, a diagonal makes two triangles.
        (json!({"polygon": {"corners": [[0, 0], [1, 0], [1, 1], [0, 1]]}, "size": 1}), 3),
        // A triangle is a mesh of itself.
        (json!({"polygon": {"corners": [[0, 0], [1, 0], [0, 1]]}, "size": 9}), 2),
    ] {
        let folder = tempdir().expect("a folder");
        let out = folder.path().join("mesh.obj");
        let run = mindeg_reading(
            [
                "mesh",
                "-",
                "--interior",
                "-q",
                "--json",
                "--write-anyway",
                "-o",
                out.to_str().expect("a path"),
            ],
            domain.to_string().as_bytes(),
        );
        let summary = run.json();
        assert_eq!(summary["at_least"], at_least, "{domain}");
        let is_proven = summary["max_degree"] == at_least;
        assert_eq!(summary["least_max_degree"] == at_least, is_proven, "{domain}");
    }
}

#[test]
fn the_summary_names_the_limit_and_what_lifts_it() {
    let folder = tempfile::tempdir().expect("a folder for the file");
    let file = folder.path().join("mesh.obj");
    let run = mindeg(COARSE.into_iter().chain(["--interior", "-o", text(&file)]));
    assert_eq!(run.code, Some(0), "{run:?}");
    for words in [
        "domain: 50 boundary and ",
        "of the limit) to ",
        "degrees 5 to 7 inside, ",
        "The boundary allows a minimum angle of at most ",
        ", decided by corner 1 (vertex 0), where intervals of 2 and 0.25 meet at 90.000°. With ",
        "intervals on side 4 it would be ",
        "Neighbouring triangles differ in area by a factor of ",
        "wrote ",
    ] {
        assert!(run.errors.contains(words), "{words:?} is missing in: {}", run.errors);
    }
}

/// A corner that broke its degree limit once had 129% of the limit.
#[test]
fn no_mesh_has_more_than_all_of_the_limit() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("a.obj").display().to_string();
    let file =
        concat!(env!("CARGO_MANIFEST_DIR"), "/crates/mindeg-interior/tests/multiscale-side.json");
    let command = ["mesh", file, "--interior", "--prefer", "angle", "-o", &out, "--json"];
    let summary = mindeg(command).json();
    assert_ne!(summary["corners"], serde_json::json!([]), "a limit costs angle: {summary}");
    assert!(number(&summary["share_of_limit"]) <= 1.0, "{summary}");
    assert!(number(&summary["min_angle"]) <= number(&summary["angle_limit"]), "{summary}");
}

#[test]
fn impossible_targets_are_refused_with_the_limit() {
    let folder = tempfile::tempdir().expect("a folder for the file");
    let file = folder.path().join("mesh.obj");
    let aims = ["--interior", "--target-angle", "40", "-o", text(&file)];
    mindeg(COARSE.into_iter().chain(aims)).refuses(&[
        "a minimum angle of 40° is impossible. The boundary allows a minimum angle of at most ",
        "corner 1 (vertex 0)",
        "intervals on side 4 it would be ",
    ]);
    assert_eq!(content(folder.path()), [] as [&str; 0]);
}

#[test]
fn what_is_demanded_and_not_reached_is_not_written() {
    let folder = tempfile::tempdir().expect("a folder for the file");
    let file = folder.path().join("mesh.obj");
    // A corner between unequal intervals takes degrees other than 6.
    let all = || {
        let domain = ["mesh", "--rectangle", "4x4", "--intervals", "12,12,12,1"];
        domain.into_iter().chain(["--interior", "--interior-degree", "6..6", "-o", text(&file)])
    };
    let run = mindeg(all());
    assert_eq!(run.code, Some(3), "{run:?}");
    assert!(run.errors.contains("outside the range: vertex "), "{}", run.errors);
    assert!(run.errors.contains("--write-anyway writes the mesh all the same"), "{}", run.errors);
    assert_eq!(content(folder.path()), [] as [&str; 0]);
    // Written all the same, the exit code is the same.
    let run = mindeg(all().chain(["--write-anyway"]));
    assert_eq!(run.code, Some(3), "{run:?}");
    assert_eq!(content(folder.path()), ["mesh.obj"]);
}

#[test]
fn options_that_do_not_go_together_are_refused() {
    let with = |options: &[&'static str]| {
        mindeg(
            COARSE.into_iter().chain(["-o", "-", "--format", "obj"]).chain(options.iter().copied()),
        )
    };
    for (options, words) in [
        (
            &["--interior", "--keep-angle", "95%"][..],
            &["--keep-angle is for meshes of boundary points alone", "--target-angle A"][..],
        ),
        (&["--interior", "--optimize", "angle"], &["--optimize", "--prefer angle"]),
        (&["--growth", "0.3"], &["--growth is for meshes with interior points; add --interior"]),
        (&["--interior", "--growth", "0"], &["--growth", "it is a finite number above 0"]),
        (&["--interior", "--growth", "-1"], &["--growth", "it is a finite number above 0"]),
        (
            &["--interior", "--size-inside", "0"],
            &["--size-inside", "a size is a finite number above 0"],
        ),
        (&["--interior", "--interior-degree", "7..9"], &["the range must contain 6"]),
        (&["--interior", "--boundary-degree", "3"], &["a boundary degree of 3 is too low"]),
        (&["--interior", "--target-angle", "90"], &["give degrees from 0 to 60"]),
        (&["--interior", "--no-interior"], &["--no-interior"]),
    ] {
        with(options).refuses(words);
    }
}

#[test]
fn a_domain_file_says_what_is_wanted_inside() {
    let domain = |interior: &str| {
        format!(
            r#"{{"rectangle": {{"width": 4, "height": 3}}, "size": 0.5, "interior": {interior}}}"#
        )
    };
    let run = |interior: &str, more: &[&str]| {
        let arguments = ["mesh", "-", "-o", "-", "--format", "obj", "-q"];
        let arguments = arguments.into_iter().chain(more.iter().copied());
        mindeg_reading(arguments, domain(interior).as_bytes())
    };
    let vertices = |run: &crate::run::Run| {
        assert_eq!(run.code, Some(0), "{run:?}");
        run.text().lines().filter(|line| line.starts_with("v ")).count()
    };
    let plain = vertices(&run("{}", &[]));
    assert!(plain > 28 + 20, "{plain}");
    assert_eq!(vertices(&run("{}", &["--no-interior"])), 28);
    assert_eq!(vertices(&run("null", &[])), 28);
    assert!(vertices(&run(r#"{"sizes": [[2, 1.5, 0.05]]}"#, &[])) > plain + 20);
    // Options go before the file.
    let coarse = vertices(&run(r#"{"size_inside": 0.1}"#, &["--size-inside", "1"]));
    assert!(coarse < plain, "{coarse} {plain}");
    for (interior, words) in [
        (r#"{"sizes": [[9, 1, 0.1]]}"#, "entry 1 of sizes at (9, 1) is not inside the domain"),
        (
            r#"{"fixed": {"points": [[1, 1]]}}"#,
            "interior.fixed: \"fixed\" is now \"lines\" and \"points\" of the domain",
        ),
        (r#"{"growth": 0}"#, "interior.growth: growth is 0; it is a finite number above 0"),
    ] {
        run(interior, &[]).refuses(&[words]);
    }
    run("{}", &["--keep-angle", "95%"]).refuses(&["with \"interior\" in the domain's file"]);
}

#[test]
fn more_points_than_allowed_are_refused_before_they_are_made() {
    let sizes = ["--interior", "--size-inside", "1e-9", "-o", "-", "--format", "obj"];
    let fine = ["mesh", "--rectangle", "4x4", "--size", "0.25"];
    let run = mindeg(fine.into_iter().chain(sizes));
    run.refuses(&["the mesh needs more than ", "raise the size inside"]);
}

#[test]
fn equal_input_gives_equal_bytes_on_any_number_of_threads() {
    let run = |threads: &str| {
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_mindeg"));
        command.args(COARSE).args(["--interior", "-o", "-", "--format", "obj", "-q"]);
        let output = crate::run::output_of(command.env("RAYON_NUM_THREADS", threads));
        assert!(output.status.success(), "{output:?}");
        output.stdout
    };
    assert!(!run("1").is_empty());
    assert_eq!(run("1"), run("4"));
}

#[test]
fn degree_and_suggest_tell_the_limit_of_a_domain() {
    let domain = domains().into_iter().find(|path| path.ends_with("dominated-side.json"));
    let domain = domain.expect("it is there");
    let answer = mindeg(["degree", text(&domain), "--json"]).json();
    let limit = &answer["limit"];
    assert!((number(&limit["angle_limit"]) - 7.68).abs() < 0.01, "{limit}");
    assert!((number(&limit["angle_limit_at_any_degree"]) - 11.25).abs() < 0.01, "{limit}");
    assert!(number(&limit["lift"]["angle_limit"]) > 7.68, "{limit}");
    let tighter = mindeg(["degree", text(&domain), "--json", "--boundary-degree", "4"]).json();
    assert!((number(&tighter["limit"]["angle_limit"]) - 5.73).abs() < 0.01, "{tighter}");
    assert_eq!(mindeg(["degree", "3,3,2,2", "--json"]).json()["limit"], Value::Null);

    let told = mindeg(["degree", text(&domain)]);
    let words = "With interior points: The boundary allows a minimum angle of at most 7.683° within the degree limits (11.250° at any degree), decided by corner 1";
    assert!(told.text().contains(words), "{}", told.text());

    let suggested = mindeg(["suggest", text(&domain)]);
    for words in
        ["With interior points the minimum angle is at most 7.683°, decided by corner 1", "\nFor "]
    {
        assert!(suggested.text().contains(words), "{}", suggested.text());
    }
    let steps = mindeg(["suggest", text(&domain), "--json"]).json();
    let steps = steps["angle_suggestions"].as_array().expect("a list");
    assert!(!steps.is_empty());
    let angle = |step: &Value| number(&step["min_angle"]);
    assert!(steps.windows(2).all(|pair| angle(&pair[0]) < angle(&pair[1])), "{steps:?}");
}

/// A square of four corners had two triangles, whatever size was asked for inside.
#[test]
fn sizes_that_the_boundary_contradicts_are_told_with_a_way_out() {
    let folder = tempfile::tempdir().expect("a folder for the files");
    let [square, mesh] = ["square.geojson", "mesh.obj"].map(|name| folder.path().join(name));
    let json = r#"{"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]]}"#;
    fs::write(&square, json).expect("the file is written");
    let run = |options: &[&'static str]| {
        let files = ["mesh", text(&square), "--interior", "-o", text(&mesh)];
        mindeg(files.into_iter().chain(options.iter().copied()))
    };
    let errors = run(&["--size-inside", "0.1"]).errors;
    for words in [
        "warning: the boundary and lines are never divided, and too coarse for the sizes asked for: side 1 has an edge \
         1 long at (0.5, 0) where the size asked for is 0.1, which takes 10 intervals on it, not 1; side 2",
        "or all of them --size 0.1; or add --condition, which divides edges down to --min-size.",
    ] {
        assert!(errors.contains(words), "{errors}");
    }
    let sides = run(&["--size-inside", "0.1", "--json"]).json()["coarse_sides"].clone();
    assert_eq!(sides[3]["name"], "side 4");
    assert_eq!((&sides[0]["wanted_intervals"], &sides[0]["intervals"]), (&10.into(), &1.into()));
    let errors = run(&[]).errors;
    assert!(
        errors.contains("No point fits inside: the boundary is never divided. --size S"),
        "{errors}"
    );
    // The advice leads to a mesh of that size.
    let divided = run(&["--size-inside", "0.1", "--size", "0.1"]);
    let words = "% of the edges inside are 0.7 to 1.4 times as long as wanted, all 0.";
    assert!(divided.errors.contains(words) && !divided.errors.contains("warning"), "{divided:?}");
    let answer = run(&["--size-inside", "0.1", "--size", "0.1", "--json"]).json();
    assert_eq!(answer["coarse_sides"], serde_json::json!([]));
    assert!(number(&answer["sizes"]["near"]) > 0.9, "{answer}");
}

#[test]
fn sizes_come_from_grids_and_background_meshes() {
    let folder = tempfile::tempdir().expect("a folder for the files");
    let [grid, mesh, other] =
        ["sizes.asc", "mesh.obj", "other.txt"].map(|name| folder.path().join(name));
    // 0.5 on the left, 0.1 on the right.
    let head = "ncols 3\nnrows 2\nxllcenter 0\nyllcenter 0\ncellsize 4\n";
    fs::write(&grid, format!("{head}0.5 0.1 0.1\n0.5 0.1 0.1\n")).expect("the file is written");
    fs::write(&other, "hello").expect("the file is written");
    let run = |sizes: &[&str]| {
        let rectangle =
            ["mesh", "--rectangle", "8x4", "--size", "0.5", "-o", text(&mesh), "--json"];
        mindeg(rectangle.into_iter().chain(sizes.iter().copied()))
    };
    let plain = run(&["--interior"]).json();
    let fine = run(&["--interior", "--sizes", text(&grid)]).json();
    let triangles = |answer: &Value| answer["triangles"].as_u64().expect("a count");
    assert!(triangles(&fine) > 2 * triangles(&plain), "{fine} {plain}");
    // A domain's file names it.
    let domain = folder.path().join("domain.json");
    let json = |name: &str| {
        let interior = format!(r#"{{"sizes": [{{"file": "{name}"}}]}}"#);
        let rectangle = r#""rectangle": {"width": 8, "height": 4}, "size": 0.5"#;
        fs::write(&domain, format!(r#"{{{rectangle}, "interior": {interior}}}"#))
            .expect("the file is written");
        mindeg(["mesh", text(&domain), "-o", text(&mesh), "--json"])
    };
    assert_eq!(triangles(&json("sizes.asc").json()), triangles(&fine));
    json("../sizes.asc").refuses(&[
        "interior.sizes[0]: ../sizes.asc: it is not in the folder of the file that names it",
    ]);
    // Intervals of 0.5 stay where 0.1 is asked for.
    let coarse = fine["coarse_sides"].as_array().expect("a list");
    let right = coarse.iter().find(|side| side["name"] == "side 2").expect("the right side");
    assert_eq!((coarse.len(), &right["wanted_intervals"]), (3, &40.into()));
    run(&["--sizes", text(&grid)])
        .refuses(&["--sizes is for meshes with interior points; add --interior"]);
    run(&["--interior", "--sizes", text(&other)])
        .refuses(&["other.txt: sizes are read from an ESRI grid (.asc)"]);
    let same =
        ["mesh", "--rectangle", "8x4", "--size", "0.5", "--interior", "--sizes", text(&grid), "-o"];
    mindeg(same.into_iter().chain([text(&grid), "--format", "obj"]))
        .refuses(&["is the file of sizes itself"]);
}

#[test]
fn an_angle_that_nobody_asked_for_is_offered() {
    let at = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/domains/l-bracket.json");
    let folder = tempdir().expect("a folder");
    let output = folder.path().join("bracket.obj");
    let run = |options: &[&str]| {
        mindeg(["mesh", text(&at), "--interior", "-o", text(&output)].iter().chain(options))
    };
    let plain = run(&[]);
    assert!(
        plain
            .errors
            .contains("hint: no more than 35° is asked for; --target-angle 42 looks for more"),
        "{plain:?}"
    );
    let asked = run(&["--target-angle", "42"]);
    assert!(asked.code == Some(0) && !asked.errors.contains("hint: no more"), "{asked:?}");
}

#[test]
fn few_long_sides_are_told_what_divides_them() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("mesh.obj").display().to_string();
    let ring = |[low, high]: [u32; 2]| {
        format!(
            "[[{low}, {low}], [{high}, {low}], [{high}, {high}], [{low}, {high}], [{low}, {low}]]"
        )
    };
    let polygon = |rings: String| {
        format!(
            r#"{{"type": "Feature", "properties": {{}}, "geometry": {{"type": "Polygon", "coordinates": [{rings}]}}}}"#
        )
    };
    let [land, lake] = [[0, 1000], [300, 600]].map(ring);
    let features = [polygon(format!("{land}, {lake}")), polygon(lake)].join(", ");
    let map = format!(r#"{{"type": "FeatureCollection", "features": [{features}]}}"#);
    let hint =
        "hint: few long sides leave little room for good triangles; --size 100 divides them.";
    let mesh = ["mesh", "-", "--interior", "-o", &out];
    let run = mindeg_reading(mesh, map.as_bytes());
    assert!(run.code == Some(0) && run.errors.contains(hint), "{run:?}");
    let run = mindeg_reading([&mesh[..], &["--size", "100"]].concat(), map.as_bytes());
    assert!(run.errors.contains("Each triangle reaches the limit of its place"), "{run:?}");
    assert!(run.code == Some(0) && !run.errors.contains("hint"), "{run:?}");
}

/// `--size 0.4` was told after `--size 0.4`.
#[test]
fn a_size_that_divides_no_side_is_not_told() {
    let folder = tempdir().expect("a folder");
    let out = folder.path().join("mesh.obj").display().to_string();
    let notched = "POLYGON((0 0,4 0,4 3,2 0.1,0 3,0 0))";
    for (size, is_told) in [("1", true), ("0.4", false)] {
        let run = mindeg_reading(
            ["mesh", "-", "--interior", "--size", size, "-o", &out],
            notched.as_bytes(),
        );
        assert_eq!(run.errors.contains("--size 0.4 divides them"), is_told, "{run:?}");
        assert_eq!(run.code, Some(0), "{run:?}");
    }
}

/// A grid in other coordinates than the domain's had no effect, without a word.
#[test]
fn sizes_beside_the_domain_are_told() {
    let folder = tempdir().expect("a folder");
    let [grid, out] = ["sizes.asc", "a.obj"].map(|name| folder.path().join(name));
    let [grid, out] = [&grid, &out].map(|path| path.to_str().expect("a path in ASCII"));
    for (corner, words) in [(1000, "it has x from 1000.5 to 1001.5 and y from 0.5 to 1.5"), (0, "")]
    {
        let lines =
            format!("ncols 2\nnrows 2\nxllcorner {corner}\nyllcorner 0\ncellsize 1\n1 1\n1 1\n");
        fs::write(grid, lines).expect("a grid");
        let arguments =
            ["mesh", "--rectangle", "4x3", "--size", "1", "--interior", "--sizes", grid, "-o", out];
        let said = mindeg(arguments).errors;
        assert_eq!(said.contains("lies beside the domain"), !words.is_empty(), "{said}");
        assert!(said.contains(words), "{said}");
    }
}
