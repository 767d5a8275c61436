//! `mindeg verify --surface`: remeshes of parts.

use crate::mesh::text;
use crate::run::mindeg;
use std::fs;
use std::path::Path;

fn asset(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets");
    folder.join(name).to_string_lossy().into_owned()
}

#[test]
fn a_mesh_is_compared_with_its_part() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("bracket.obj");
    let part = asset("models/bracket.obj");
    let made = mindeg(["mesh", &part, "--size", "4", "-q", "-o", text(&file)]);
    assert_eq!(made.code, Some(0), "{made:?}");
    let options = ["--surface", &part, "--feature-angle", "20", "--tolerance", "0"];
    let verify = |options: &[&str]| {
        mindeg(["verify", text(&file)].into_iter().chain(options.iter().copied()))
    };
    let run = verify(&[&options[..], &["--json"]].concat());
    let found: serde_json::Value = serde_json::from_str(run.text()).expect("JSON");
    assert_eq!(run.code, Some(3));
    // It has no points inside: degrees are out of range, and nothing else is wrong.
    let kinds: Vec<&str> = found["defects"]
        .as_array()
        .expect("a list")
        .iter()
        .filter_map(|d| d["kind"].as_str())
        .collect();
    assert_eq!(kinds, ["degree"], "{found}");
    assert!(found["to_part"]["at_most"].as_f64() < Some(1e-6), "{found}");
    assert!(found["features_from_part"]["at_most"].as_f64() < Some(1e-6), "{found}");
    assert!(run.errors.contains("have another degree than 5 to 7"), "{run:?}");
    let read = verify(&options).text().to_owned();
    assert!(
        read.contains("does not keep the surface of") && read.contains("distance          at most"),
        "{read}"
    );
    // Sharp edges that are cut in two are not the part's.
    let run = verify(&[&options[..], &["--keep-features", "--target-angle", "60"]].concat());
    assert!(run.errors.contains("sharp edges of the part are none of the mesh"), "{run:?}");
    assert!(run.errors.contains("below the target angle of 60°"), "{run:?}");
    let page = fs::read_to_string(asset("../docs/remesh.md")).expect("the page");
    let help = mindeg(["verify", "--help"]);
    let help = help.text().split_whitespace().collect::<Vec<_>>().join(" ");
    for key in found.as_object().expect("an object").keys() {
        assert!(page.contains(&format!("`{key}`")) && help.contains(key), "{key}");
    }
}

#[test]
fn shares_are_for_surfaces_and_domains_are_none() {
    let part = asset("models/bracket.obj");
    let domain = asset("domains/l-bracket.json");
    let run = mindeg(["verify", &part, &domain, "--tolerance", "1%"]);
    assert_eq!(run.code, Some(2));
    assert!(run.errors.contains("--tolerance takes a share with --surface alone"), "{run:?}");
    let run = mindeg(["verify", &part, "--surface", &part, "--rectangle", "4x3"]);
    assert_eq!(run.code, Some(2), "{run:?}");
    let run = mindeg(["verify", &part, "--keep-boundary"]);
    assert_eq!(run.code, Some(2), "{run:?}");
}
