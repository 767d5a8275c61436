//! Why a domain cannot be meshed, in the words that a user reads.

use crate::run::{mindeg, mindeg_reading};
use serde_json::{Value, json};

/// The message of `mindeg mesh` about a domain on standard input, without its start.
#[track_caller]
fn refused(domain: &str) -> String {
    let run = mindeg_reading(["mesh", "-", "-o", "no-such-folder/x.obj"], domain.as_bytes());
    run.refuses(&["error: standard input: "]);
    run.errors.trim_end().replacen("error: standard input: ", "", 1)
}

#[test]
fn a_domain_is_refused_in_words_of_its_own() {
    let square = r#""rectangle": {"width": 4, "height": 3}"#;
    #[rustfmt::skip]
    let table = [
        ("{@, \"sides\": [3, 3, 2, 2]}", "line 1, column 52, sides[0]: found the number 3, expected an object with \"intervals\", \"size\", \"spacing\", \"name\", \"kind\", \"outside_degree\", \"max_degree\", \"points\", \"polyline\", \"arc\", \"bezier\", \"match\""),
        ("{@, \"sides\": [[3], [3], [2], [2]]}", "line 1, column 52, sides[0]: found a list of 1 value, expected an object with \"intervals\", \"size\", \"spacing\", \"name\", \"kind\", \"outside_degree\", \"max_degree\", \"points\", \"polyline\", \"arc\", \"bezier\", \"match\""),
        ("{\"rectangle\": [4, 3], \"size\": 1}", "line 1, column 15, rectangle: found a list of 2 values, expected an object with \"width\", \"height\", \"origin\", \"rotation\""),
        ("{@, \"size\": 1e-300}", "line 1, column 50, size: side 1: the size 1e-300 makes 4e300 intervals, and a boundary has at most 4294967294 vertices; give a larger size"),
        ("{@, \"size\": 1, \"vertices\": [{\"vertex\": 1, \"max_degree\": 2}]}", "line 1, column 94, vertices[0].max_degree: vertex 1 has a max_degree of 2 and needs 3: 2 edges along its straight side and 1 into the domain; raise max_degree to 3 or more"),
        ("{@, \"size\": 1, \"name\": \"\u{2028}line\"}", "line 1, column 61, name: the name of the domain contains the line break U+2028; remove this character"),
        ("{\"rectangle\": {\"width\": 1e-17, \"height\": 1}, \"size\": 1}", "line 1, column 25, rectangle.width: the rectangle's width is 1e-17, and its coordinates are up to 1: 64-bit floats cannot tell its corners apart; keep width and height within a factor of 1e14, and the rectangle near the origin"),
        ("{\"type\": \"FeatureCollection\", \"features\": []}", "no Polygon or MultiPolygon; the collection is empty"),
    ];
    for (domain, message) in table {
        assert_eq!(refused(&domain.replace('@', square)), message);
    }
}

#[test]
fn degree_limits_that_conflict_are_named_by_their_vertices() {
    // A square has two triangles: two neighbouring corners cannot both be tips.
    let limit = |vertex: u32| format!(r#"{{"vertex": {vertex}, "max_degree": 2}}"#);
    let domain = |vertices: &[u32]| {
        let vertices: Vec<String> = vertices.iter().map(|&vertex| limit(vertex)).collect();
        format!(
            r#"{{"rectangle": {{"width": 1, "height": 1}}, "size": 1, "vertices": [{}]}}"#,
            vertices.join(", ")
        )
    };
    let run = mindeg_reading(["mesh", "-", "-o", "x.obj"], domain(&[3, 0, 2]).as_bytes());
    run.refuses(&[
        "no mesh keeps the degree limits of vertices 0 and 3 together; raise max_degree",
    ]);
}

#[test]
fn all_faults_of_rings_are_told() {
    let domain = r#"{"ring": [[0, 0], [10, 0], [10, 10], [0, 10]],
 "holes": [{"ring": [[1, 1], [3, 3], [3, 1], [1, 3]]}, {"ring": [[5, 5], [7, 7], [7, 5], [5, 7]]},
  {"ring": [[12, 12], [13, 12], [13, 13]]},
  {"ring": [[8, 8], [12, 8], [12, 9], [8, 9]]}]}"#;
    let said = refused(domain);
    assert!(said.starts_with("line 2, column "), "{said}");
    for fault in [
        "edge 1 of hole 1 and edge 3 of hole 1 cross",
        "; also, edge 1 of hole 2 and edge 3 of hole 2 cross",
        "; also, edge 2 and edge 1 of hole 4 cross",
        "; also, hole 3 lies outside the outline",
    ] {
        assert!(said.contains(fault), "{said}");
    }
    let run = mindeg_reading(["domain", "-", "--json"], domain.as_bytes());
    assert_eq!(run.code, Some(2), "{run:?}");
    let rows: Value = serde_json::from_str(run.text()).expect("JSON");
    let faults = rows[0]["faults"].as_array().expect("a list");
    let places: Vec<_> = faults.iter().map(|fault| (&fault["path"], &fault["line"])).collect();
    assert_eq!(places.len(), 5, "{rows:#}");
    for (path, line) in
        [("holes[0].ring[2]", 2), ("holes[1].ring[2]", 2), ("holes[2]", 3), ("holes[3].ring[2]", 4)]
    {
        assert!(places.contains(&(&json!(path), &json!(line))), "{path}: {places:?}");
    }
}

#[test]
fn interval_counts_by_option_are_interval_counts() {
    for command in ["degree", "suggest"] {
        let [typed, option] = [&["3,4,5"][..], &["--intervals", "3,4,5"]]
            .map(|counts| mindeg([command].iter().chain(counts)).text().to_owned());
        assert_eq!(typed, option);
    }
}
