//! Domains that are not convex, or have holes.

use crate::run::mindeg;
use std::fs;
use std::path::PathBuf;
use tempfile::TempDir;

const L: &str = r#"{"polygon": {"corners": [[0,0],[4,0],[4,2],[2,2],[2,4],[0,4]]},
    "sides": [{"intervals":13},{"intervals":6},{"intervals":6},{"intervals":6},{"intervals":6},{"intervals":13}]}"#;

const FRAME: &str = r#"{"name": "frame", "polygon": {"corners": [[0,0],[4,0],[4,4],[0,4]]},
    "sides": [{"intervals":4},{"intervals":4},{"intervals":4},{"intervals":4}],
    "holes": [{"corners": [[1,1],[1,3],[3,3],[3,1]],
        "sides": [{"intervals":2},{"intervals":2},{"intervals":2},{"intervals":2}]}]}"#;

/// A U whose inner floor has 60 intervals.
const U: &str = r#"{"polygon": {"corners": [[0,0],[6,0],[6,4],[4,4],[4,2],[2,2],[2,4],[0,4]]},
    "sides": [{"intervals":2},{"intervals":2},{"intervals":2},{"intervals":2},{"intervals":60},
        {"intervals":2},{"intervals":2},{"intervals":2}]}"#;

/// A folder with the domain in it.
fn written(domain: &str) -> (TempDir, PathBuf) {
    let folder = TempDir::new().expect("a folder");
    let path = folder.path().join("domain.json");
    fs::write(&path, domain).expect("the domain is written");
    (folder, path)
}

#[test]
fn degree_tells_the_degree_and_why() {
    for (domain, least, at_least, reached, kind, words) in [
        (L, Some(5), 5, 5, "blocked_zig_zags", "one of 50 zig-zags"),
        (FRAME, Some(5), 5, 5, "no_strip", "a mesh of degree 4 is a strip between two rings"),
        (U, Some(23), 23, 23, "apexes", "are the side of no ear, and only 3 vertices"),
    ] {
        let (_folder, path) = written(domain);
        let path = path.to_str().expect("a path is text");
        let answer = mindeg(["degree", path, "--json"]).json();
        assert_eq!(answer["least_max_degree"].as_u64(), least);
        assert_eq!((&answer["at_least"], &answer["reached"]), (&at_least.into(), &reached.into()));
        assert_eq!(answer["certificate"]["kind"], kind);
        let run = mindeg(["degree", path]);
        assert!(run.text().contains(words), "{}", run.text());
    }
}

/// Windows reach 7 here, and 4 is the bound of counting.
const SLITS: &str = r#"{"ring": [[0, -4112], [25, 625], [-22, 484]], "holes": [
    {"ring": [[5, -1856], [3, -2013], [4, -1392], [10, -1980]]},
    {"ring": [[17, -494], [12, 120], [15, 86], [15, 63], [14, -14]]}]}"#;

#[test]
fn a_refutation_is_written_and_repeated() {
    let (folder, path) = written(SLITS);
    let at = |name: &str| folder.path().join(name).to_str().expect("a path is text").to_owned();
    let (path, out, proof) =
        (path.to_str().expect("a path is text"), at("mesh.obj"), at("proof.json"));
    let answer = mindeg(["degree", path, "--proof", &proof, "--json"]).json();
    assert_eq!((&answer["least_max_degree"], &answer["reached_by"]), (&6.into(), &"search".into()));
    let certificate = &answer["certificate"];
    assert_eq!((&certificate["kind"], &certificate["checked"]), (&"refuted".into(), &true.into()));
    assert!(certificate["clauses"].as_u64().is_some_and(|clauses| clauses > 0), "{certificate}");
    assert_eq!(mindeg(["mesh", path, "-o", &out]).code, Some(0));
    let verified = mindeg(["verify", &out, path, "--proof", &proof, "--optimal", "--json"]).json();
    assert_eq!(
        (&verified["optimal"], &verified["proof"]["kind"]),
        (&"yes".into(), &"refuted".into())
    );
    // Without its first clause the rest does not follow; on another domain neither.
    let text = fs::read_to_string(&proof).expect("the proof is there");
    let mut changed: serde_json::Value = serde_json::from_str(&text).expect("it is JSON");
    changed["clauses"].as_array_mut().expect("a list").remove(0);
    fs::write(&proof, changed.to_string()).expect("the proof is written");
    let verified = mindeg(["verify", &out, path, "--proof", &proof, "--json"]).json();
    assert_eq!(verified["optimal"], "unknown");
    changed["refuted_degree"] = 6.into();
    fs::write(&proof, changed.to_string()).expect("the proof is written");
    mindeg(["verify", &out, path, "--proof", &proof])
        .refuses(&["refutes degree 6, but the mesh has degree 6", "that refutes degree 5"]);
    fs::write(&proof, r#"{"refuted_degree": 5, "clauses": [[{"has": [1]}]]}"#)
        .expect("it is written");
    mindeg(["verify", &out, path, "--proof", &proof]).refuses(&["neither a chord nor a triangle"]);
    let (_other, path) = written(FRAME);
    let path = path.to_str().expect("a path is text");
    mindeg(["degree", path, "--proof", &proof]).refuses(&["no clauses prove this degree"]);
}

#[test]
fn a_mesh_keeps_what_it_is_asked_for() {
    let (folder, path) = written(L);
    let path = path.to_str().expect("a path is text");
    let out = folder.path().join("l.obj");
    let out = out.to_str().expect("a path is text");
    let least = mindeg(["mesh", path, "-o", out, "--json"]).json();
    assert_eq!((&least["max_degree"], &least["least_max_degree"]), (&5.into(), &5.into()));
    let kept = mindeg(["mesh", path, "-o", out, "--keep-angle", "95%", "--json"]).json();
    assert_eq!(kept["max_degree"], 6);
    let [angle, most, share] =
        ["min_angle", "angle_limit", "share_of_limit"].map(|key| kept[key].as_f64().unwrap());
    assert!(angle >= 0.95 * most && (share - angle / most).abs() < 1e-9, "{kept}");
    mindeg(["mesh", path, "-o", out, "--max-degree", "4"]).refuses(&["the least is 5"]);
    let seen = mindeg(["inspect", out, "--json"]).json();
    assert_eq!((&seen["max_degree"], &seen["euler_characteristic"]), (&6.into(), &1.into()));
    assert_eq!(seen["polygon"]["least_max_degree"], 5, "{}", seen["polygon"]);
}

#[test]
fn a_mesh_goes_around_a_hole_in_every_report() {
    let (folder, path) = written(FRAME);
    let path = path.to_str().expect("a path is text");
    let at = |name: &str| folder.path().join(name).to_str().expect("a path is text").to_owned();
    let [obj, svg, html] = ["frame.obj", "frame.svg", "frame.html"].map(at);
    let mesh = mindeg(["mesh", path, "-o", &obj, "-o", &svg, "--json"]).json();
    assert_eq!((&mesh["max_degree"], &mesh["triangles"]), (&5.into(), &24.into()));
    assert_eq!((&mesh["least_max_degree"], &mesh["at_least"]), (&5.into(), &5.into()));
    let seen = mindeg(["inspect", &obj, "--json"]).json();
    assert_eq!((&seen["boundary_loops"], &seen["area"]), (&2.into(), &12.0.into()));
    assert_eq!((&seen["polygon"]["holes"], &seen["polygon"]["reached"]), (&1.into(), &5.into()));
    let curve = mindeg(["tradeoff", path, "--json", "-o", &svg, "-o", &html]).json();
    assert_eq!(curve["points"][0]["exact"], true);
    let report = mindeg(["compare", path, "--json", "-o", &html]).json();
    assert_eq!(
        (&report["domain"]["holes"], &report["domain"]["triangles"]),
        (&1.into(), &24.into())
    );
    assert_eq!(report["domain"]["least_max_degree"], 5);
    let methods = report["methods"].as_array().expect("a list");
    let names: Vec<_> = methods.iter().filter_map(|method| method["name"].as_str()).collect();
    assert_eq!(
        names,
        ["mindeg", "Delaunay", "Ear clipping", "Exact, degree 5", "mindeg, points inside"]
    );
    assert_eq!((&methods[0]["max_degree"], &methods[0]["valid"]), (&5.into(), &true.into()));
    assert_eq!((&methods[1]["max_degree"], &methods[1]["valid"]), (&6.into(), &true.into()));
}
