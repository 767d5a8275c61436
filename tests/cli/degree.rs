use crate::run::{ends_quietly_when_nobody_reads, mindeg, shell};
use serde_json::json;
use std::fs;

#[test]
fn the_table_of_optima() {
    for (intervals, max_degree, kind) in [
        ("1,1,1", 2, "balanced_cut"),
        ("2,1,1", 3, "balanced_cut"),
        ("1,1,1,1", 3, "balanced_cut"),
        ("3,1,1", 4, "balanced_cut"),
        ("1,1,1,1,1", 4, "balanced_cut"),
        ("3,3,2,2", 4, "balanced_cut"),
        ("10,10,10,10", 4, "balanced_cut"),
        ("8,6,8,5", 4, "balanced_cut"),
        ("2,2,2", 4, "medial_triangle"),
        ("3,3,3", 5, "no_balanced_cut"),
        ("12,9,4,4", 5, "no_balanced_cut"),
        ("14,3,5,2", 5, "long_side"),
        ("30,2,4,2", 7, "long_side"),
        ("1000,3,5,2", 114, "long_side"),
        ("4294967292,1,1", 4_294_967_293_u32, "long_side"),
    ] {
        let answer = mindeg(["degree", intervals, "--json"]).json();
        assert_eq!(answer["least_max_degree"], max_degree, "{intervals}");
        assert_eq!(answer["certificate"]["kind"], kind, "{intervals}");
        assert_eq!(answer["certificate"]["bound"], max_degree, "{intervals}");
    }
}

#[test]
fn json_has_the_agreed_keys() {
    let answer = mindeg(["degree", "30,2,4,2", "--json"]).json();
    let expected = json!({
        "intervals": [30, 2, 4, 2],
        "holes": 0,
        "vertices": 38,
        "triangles": 36,
        "interior_edges": 35,
        "least_max_degree": 7,
        "at_least": 7,
        "reached": 7,
        "reached_by": "formula",
        "certificate": {"kind": "long_side", "side": 1, "bound": 7},
    });
    assert_eq!(answer, expected);
}

#[test]
fn text_says_why() {
    for (intervals, reason) in [
        ("1,1,1", "only one triangle"),
        ("3,3,2,2", "zig-zag between sides 2 to 3 (5 intervals) and sides 4 to 1 (5)"),
        ("2,2,2", "three midpoints"),
        ("30,2,4,2", "the 7 vertices off side 1\n(30 intervals)"),
        ("12,9,4,4", "every two differ by 3 or more"),
    ] {
        let run = mindeg(["degree", intervals]);
        assert_eq!((run.code, run.errors.as_str()), (Some(0), ""));
        assert!(run.text().contains(reason), "{}", run.text());
    }
}

#[test]
fn bad_counts_are_refused_with_the_side() {
    for (intervals, words) in [
        ("3,3", &["found 2 sides", "at least 3"][..]),
        ("3,0,3", &["side 2", "at least 1"]),
        ("3,3,99999999999", &["side 3", "4294967294"]),
        ("3,3,99999999999999999999999", &["side 3"]),
        ("3,three,3", &["side 2", "three"]),
        ("", &["side 1"]),
    ] {
        mindeg(["degree", intervals]).refuses(words);
    }
}

#[test]
fn a_closed_pipe_ends_quietly() {
    ends_quietly_when_nobody_reads(["degree", &vec!["1"; 20_000].join(","), "--json"]);
}

#[test]
fn a_domain_is_told_which_mesh_to_take() {
    let channel = "assets/domains/boundary-layer-channel.json";
    let run = mindeg(["degree", channel]);
    assert_eq!(run.code, Some(0), "{}", run.errors);
    let text = String::from_utf8_lossy(&run.output).into_owned();
    for words in [
        "hint: for a patch that must keep its points, take degree 5: minimum angle 2.010°, 97.0% of",
        "boundary-layer-channel.json --keep-angle 95% -o boundary-layer-channel-keep-angle-95.obj",
        "boundary-layer-channel.json --interior -o boundary-layer-channel-points-inside.obj",
    ] {
        assert!(text.contains(words), "{words:?} is missing in {text}");
    }
}

/// The commands among the hints make the meshes that they promise, whatever was asked of the domain.
#[cfg(unix)]
#[test]
fn hinted_commands_make_what_they_promise() {
    let root = env!("CARGO_MANIFEST_DIR");
    let folder = tempfile::tempdir().unwrap();
    let inside =
        r#"{"rectangle": {"width": 4, "height": 3}, "size": 1, "interior": {"growth": 0.4}}"#;
    fs::write(folder.path().join("my domain.json"), inside).unwrap();
    let run =
        |line: &str| shell(folder.path(), &format!("mindeg() {{ \"$MINDEG\" \"$@\"; }}; {line}"));
    for words in [
        "--rectangle 4x3 --size 0.5 --periodic 'side 2=side 4'",
        "'my domain.json'",
        &format!("{root}/assets/outlines/part.dxf --size 5"),
        &format!("{root}/assets/outlines/icon.svg --size 0.5 --fill-rule evenodd --repair"),
        &format!(
            "{root}/assets/outlines/islands.geojson --feature 2 --project none --corner-angle 40"
        ),
    ] {
        let of_degree = run(&format!("mindeg degree {words}")).text().to_owned();
        let of_mesh = run(&format!("mindeg mesh {words} --no-interior -o 'a mesh.vtu'")).errors;
        for (answer, is_named) in [(of_degree, false), (of_mesh, true)] {
            let lines: Vec<&str> = answer.lines().collect();
            let hinted: Vec<_> = lines
                .windows(2)
                .filter(|two| two[1].starts_with("mindeg mesh "))
                .filter(|two| !two[0].contains("takes longer"))
                .collect();
            assert_eq!(hinted.len(), 2, "{words}: {answer}");
            for two in hinted {
                let made = run(&format!("{} --json", two[1])).json();
                let angle = format!("minimum angle {:.3}°", made["min_angle"].as_f64().unwrap());
                assert!(two[0].contains(&angle), "{two:?} gives {angle}");
                let [which, other] = match two[1].contains("--interior") {
                    true => ["-points-inside.obj", "-keep-angle-95.obj"],
                    false => ["-keep-angle-95.obj", "-points-inside.obj"],
                };
                let file = made["files"][0].as_str().unwrap();
                let is_told = file.ends_with(which) && !file.contains(other);
                assert!(if is_named { file == "a mesh.vtu" } else { is_told }, "{two:?}: {file}");
            }
        }
    }
}

#[test]
fn the_degree_of_a_model_is_that_of_its_mesh() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("mesh.obj").display().to_string();
    for file in [&["assets/models/bracket.obj", "--size", "5"][..], &["assets/models/cube.json"]] {
        let told = mindeg([&["degree"], file, &["--json"]].concat()).json();
        let meshed = mindeg([&["mesh"], file, &["-o", &out, "--json", "-q"]].concat()).json();
        for key in ["max_degree", "least_max_degree", "at_least", "bounded_by", "vertices"] {
            assert_eq!(told[key], meshed[key], "{file:?} {key}");
        }
    }
    mindeg(["degree", "assets/models/bracket.obj"]).refuses(&["give --size"]);
    mindeg(["degree", "assets/models/cube.json", "--proof", &out])
        .refuses(&["--proof is for a domain; ", "is a model"]);
}

#[test]
fn points_on_edges_are_named_where_the_limit_is_not_low_too() {
    let run = mindeg(["degree", "assets/domains/wing-panel.json"]);
    let words = "If the boundary may have 8 points more, condition it: minimum angle 36.100°";
    assert!(run.text().contains(words), "{run:?}");
    // The mesh itself tells it of lower limits alone.
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("wing.obj");
    let out = out.to_str().expect("paths here are UTF-8");
    let run = mindeg(["mesh", "assets/domains/wing-panel.json", "--interior", "-o", out]);
    assert!(run.code == Some(0) && !run.errors.contains("--condition puts"), "{run:?}");
}
