//! Why a domain cannot be meshed, in the words that a user reads.

use crate::run::mindeg_reading;

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
        ("{\"rectangle\": {\"width\": 1e-17, \"height\": 1}, \"size\": 1}", "line 1, column 25, rectangle.width: the rectangle's width is 1e-17, and its coordinates are up to 1.0: 64-bit floats cannot tell its corners apart; keep width and height within a factor of 1e14, and the rectangle near the origin"),
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
