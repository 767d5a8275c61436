//! The whole message of what is not read.

use super::tests::{with_hole, with_side};
use super::*;

/// Every message that is not the expected one, below it.
fn check_all(table: &[(impl AsRef<str>, &str)]) {
    let differs = |(text, message): &(_, &str)| {
        let text: &str = AsRef::as_ref(text);
        let found =
            Domain::from_json(text).map_or_else(|error| error.to_string(), |_| "read".into());
        (found != *message).then(|| format!("{text}\n  {message}\n  {found}\n"))
    };
    let differences: String = table.iter().filter_map(differs).collect();
    assert!(differences.is_empty(), "{differences}");
}

#[test]
fn says_what_is_wrong_with_a_side() {
    #[rustfmt::skip]
    let table = [
        (r#"3"#, r#"line 3, column 2, sides[3]: found the number 3, expected an object with "intervals", "size", "spacing", "name", "kind", "outside_degree", "max_degree", "points", "polyline", "arc", "bezier""#),
        (r#"[3]"#, r#"line 3, column 2, sides[3]: found a list of 1 value, expected an object with "intervals", "size", "spacing", "name", "kind", "outside_degree", "max_degree", "points", "polyline", "arc", "bezier""#),
        (r#"[3, null, "uniform", "x", 1, 4]"#, r#"line 3, column 2, sides[3]: found a list of 6 values, expected an object with "intervals", "size", "spacing", "name", "kind", "outside_degree", "max_degree", "points", "polyline", "arc", "bezier""#),
        (r#"null"#, r#"line 3, column 2, sides[3]: found null, expected an object with "intervals", "size", "spacing", "name", "kind", "outside_degree", "max_degree", "points", "polyline", "arc", "bezier""#),
        (r#""a""#, r#"line 3, column 2, sides[3]: found the text "a", expected an object with "intervals", "size", "spacing", "name", "kind", "outside_degree", "max_degree", "points", "polyline", "arc", "bezier""#),
        (r#"{"intervals": 2.5}"#, r#"line 3, column 16, sides[3].intervals: found the number 2.5, expected a whole number"#),
        (r#"{"intervals": -1}"#, r#"line 3, column 16, sides[3].intervals: found the number -1, expected a whole number"#),
        (r#"{"intervals": "3"}"#, r#"line 3, column 16, sides[3].intervals: found the text "3", expected a whole number"#),
        (r#"{"intervals": 18446744073709551616}"#, r#"line 3, column 16, sides[3].intervals: found the number 18446744073709551616, expected a whole number"#),
        (r#"{"intervals": [3]}"#, r#"line 3, column 16, sides[3].intervals: found a list of 1 value, expected a whole number"#),
        (r#"{"interval": 1}"#, r#"line 3, column 15, sides[3].interval: unknown key "interval"; allowed: "intervals", "size", "spacing", "name", "kind", "outside_degree", "max_degree", "points", "polyline", "arc", "bezier""#),
        (r#"{"size": "a"}"#, r#"line 3, column 11, sides[3].size: found the text "a", expected a number"#),
        (r#"{"size": 1e999}"#, r#"line 3, column 11, sides[3].size: the number 1e999 is too large; the maximum is about 1e308"#),
        (r#"{"intervals": 1, "intervals": 1}"#, r#"line 3, column 32, sides[3].intervals: the key "intervals" comes twice; give it once"#),
        (r#"{"intervals": 1, "spacing": "even"}"#, r#"line 3, column 30, sides[3].spacing: found the text "even", expected "uniform", "geometric", "bump", "beta", "first_length", "last_length" or "parameters""#),
        (r#"{"intervals": 1, "spacing": "bump"}"#, r#"line 3, column 30, sides[3].spacing: found the text "bump", expected an object with this key"#),
        (r#"{"intervals": 1, "spacing": 1}"#, r#"line 3, column 30, sides[3].spacing: found the number 1, expected "uniform", "geometric", "bump", "beta", "first_length", "last_length" or "parameters""#),
        (r#"{"intervals": 1, "spacing": {}}"#, r#"line 3, column 30, sides[3].spacing: found an object, expected "uniform", "geometric", "bump", "beta", "first_length", "last_length" or "parameters""#),
        (r#"{"intervals": 1, "spacing": [1]}"#, r#"line 3, column 30, sides[3].spacing: found a list of 1 value, expected "uniform", "geometric", "bump", "beta", "first_length", "last_length" or "parameters""#),
        (r#"{"intervals": 1, "spacing": {"bump": {"ratio": 2}, "beta": {"beta": 2}}}"#, r#"line 3, column 30, sides[3].spacing: found an object, expected one key"#),
        (r#"{"intervals": 1, "spacing": {"bumb": {"ratio": 2}}}"#, r#"line 3, column 39, sides[3].spacing.bumb: unknown key "bumb"; expected "uniform", "geometric", "bump", "beta", "first_length", "last_length" or "parameters""#),
        (r#"{"intervals": 1, "spacing": {"bump": {"c": 2}}}"#, r#"line 3, column 45, sides[3].spacing.bump.c: unknown key "c"; allowed: "ratio""#),
        (r#"{"intervals": 1, "spacing": {"bump": {"ratio": true}}}"#, r#"line 3, column 49, sides[3].spacing.bump.ratio: found true, expected a number"#),
        (r#"{"intervals": 1, "spacing": {"bump": 2}}"#, r#"line 3, column 39, sides[3].spacing.bump: found the number 2, expected an object"#),
        (r#"{"intervals": 1, "spacing": {"geometric": [1.2]}}"#, r#"line 3, column 44, sides[3].spacing.geometric: found a list of 1 value, expected an object"#),
        (r#"{"intervals": 1, "spacing": {"geometric": {}}}"#, r#"line 3, column 44, sides[3].spacing.geometric: the key "ratio" is missing"#),
        (r#"{"intervals": 1, "spacing": {"first_length": "a"}}"#, r#"line 3, column 47, sides[3].spacing.first_length: found the text "a", expected a number"#),
        (r#"{"spacing": {"parameters": 0.5}}"#, r#"line 3, column 29, sides[3].spacing.parameters: found the number 0.5, expected a list"#),
        (r#"{"spacing": {"parameters": [0.5, "a"]}}"#, r#"line 3, column 35, sides[3].spacing.parameters[1]: found the text "a", expected a number"#),
        (r#"{"outside_degree": -1}"#, r#"line 3, column 21, sides[3].outside_degree: found the number -1, expected a whole number, or for a side a list of one whole number for each vertex from its first corner to its last"#),
        (r#"{"outside_degree": 5000000000}"#, r#"line 3, column 21, sides[3].outside_degree: found the number 5000000000, expected a whole number, or for a side a list of one whole number for each vertex from its first corner to its last"#),
        (r#"{"outside_degree": [1, "a"]}"#, r#"line 3, column 25, sides[3].outside_degree[1]: found the text "a", expected a whole number"#),
        (r#"{"max_degree": 2.5}"#, r#"line 3, column 17, sides[3].max_degree: found the number 2.5, expected a whole number"#),
        (r#"{"max_degree": {}}"#, r#"line 3, column 17, sides[3].max_degree: found an object, expected a whole number"#),
        (r#"{"intervals": 1, "name": 3}"#, r#"line 3, column 27, sides[3].name: found the number 3, expected a text in double quotes"#),
        (r#"{"intervals": 1, "name": "\ud800"}"#, r#"line 3, column 27, sides[3].name: this text has an escape that is no character"#),
        (r#"{"intervals": 0}"#, r#"line 3, column 16, sides[3].intervals: side 4 has 0 intervals; every side needs at least 1"#),
        (r#"{"size": 0}"#, r#"line 3, column 11, sides[3].size: side 4: the size is 0.0; it must be a finite number above 0"#),
        (r#"{}"#, r#"line 3, column 2, sides[3]: give "intervals" (a whole number) or "size" (a target interval length)"#),
        (r#"{"intervals": 1, "size": 1}"#, r#"line 3, column 2, sides[3]: give either "intervals" or "size", not both"#),
        (r#"{"size": 1, "spacing": {"parameters": [0.5]}}"#, r#"line 3, column 2, sides[3]: "parameters" say how many intervals there are; drop "size""#),
        (r#"{"intervals": 1, "name": "top"}"#, r#"line 3, column 27, sides[3].name: sides 3 and 4 are both named "top"; names become groups in mesh files and must differ"#),
        (r#"{"intervals": 1, "name": "a\u2028b"}"#, r#"line 3, column 27, sides[3].name: the name of side 4 contains the line break U+2028; remove this character"#),
        (r#"{"intervals": 1, "name": "\u202eb"}"#, r#"line 3, column 27, sides[3].name: the name of side 4 contains the direction mark U+202E; remove this character"#),
        (r#"{"intervals": 1, "name": " "}"#, r#"line 3, column 27, sides[3].name: the name of side 4 is blank; give it a letter or leave it out"#),
        (r#"{"intervals": 2, "spacing": {"bump": {"ratio": 0}}}"#, r#"line 3, column 30, sides[3].spacing: side 4: the ratio is 0.0; it must be a finite number above 0"#),
        (r#"{"intervals": 3, "spacing": {"parameters": [0.5]}}"#, r#"line 3, column 30, sides[3].spacing: side 4: 1 parameter makes 2 intervals, and the side has 3; drop the interval count or make them agree"#),
        (r#"{"intervals": 2, "spacing": {"first_length": 1}}"#, r#"line 3, column 30, sides[3].spacing: side 4: an interval of length 1.0 leaves nothing of the side's 1.0 for the other 1 interval; give a shorter length or 1 interval"#),
        (r#"{"intervals": 1, "outside_degree": [1]}"#, r#"line 3, column 37, sides[3].outside_degree: side 4: outside_degree lists 1 number, and the side has 2 vertices, both corners included; give one for each, or a single number for all that are not corners"#),
        (r#"{"intervals": 1, "outside_degree": 1000000001}"#, r#"line 3, column 37, sides[3].outside_degree: side 4: outside_degree is 1000000001; the maximum is 1000000000"#),
        (r#"{"intervals": 1, "max_degree": 1}"#, r#"line 3, column 33, sides[3].max_degree: vertex 3 has a max_degree of 1 and needs 2: 2 edges along the boundary; raise max_degree to 2 or more"#),
        (r#"{"intervals": 2, "max_degree": 2}"#, r#"line 3, column 33, sides[3].max_degree: vertex 4 has a max_degree of 2 and needs 3: 2 edges along its straight side and 1 into the domain; raise max_degree to 3 or more"#),
        (r#"{"spacing": {"parameters": [0.5, 0.5]}}"#, r#"line 3, column 35, sides[3].spacing.parameters[1]: side 4: parameter 2 (0.5) is not above the one before (0.5); parameters must increase"#),
        (r#"{"size": 1e-300}"#, r#"line 3, column 11, sides[3].size: side 4: the size 1e-300 makes 1.0e300 intervals, and a boundary has at most 4294967294 vertices; give a larger size"#),
        (r#"{"intervals": 4294967294}"#, r#"line 3, column 16, sides[3].intervals: side 4 has 4294967294 intervals, with which the boundary exceeds the maximum of 4294967294 vertices; use fewer intervals"#),
    ];
    check_all(&table.map(|(side, message)| (with_side(side), message)));
}

#[test]
fn says_what_is_wrong_with_holes_rings_and_curves() {
    let triangle = r#""corners": [[1, 1], [2, 1], [1, 2]]"#;
    let hole = |keys: &str| with_hole(&format!("{{{triangle}, {keys}}}"));
    let side = |keys: &str| with_side(&format!("{{{keys}}}"));
    let ring = |points: &str| format!(r#"{{"ring": {points}}}"#);
    #[rustfmt::skip]
    let table = [
        (with_hole("3"), r#"line 1, column 63, holes[0]: found the number 3, expected an object with "corners", "ring", "sides", "size""#),
        (with_hole("{}"), r#"line 1, column 63, holes[0]: the key "corners" or "ring" is missing; give "corners": [[x, y], …] and "sides" or "size", or "ring": [[x, y], …]"#),
        (hole(r#""ring": []"#), r#"line 1, column 63, holes[0]: a hole has either "corners" or a "ring"; drop one"#),
        (hole(r#""name": "a""#), r#"line 1, column 109, holes[0].name: unknown key "name"; allowed: "corners", "ring", "sides", "size""#),
        (hole(r#""sides": [{}]"#), r#"line 1, column 110, holes[0].sides: 1 side is described and hole 1 has 3; describe each side once"#),
        (hole(r#""sides": [{}, {"intervals": 0}, {}]"#), r#"line 1, column 129, holes[0].sides[1].intervals: side 2 of hole 1 has 0 intervals; every side needs at least 1"#),
        (hole(r#""size": 0"#), r#"line 1, column 109, holes[0].size: side 1 of hole 1: the size is 0.0; it must be a finite number above 0"#),
        (hole(r#""sides": [{"name": "a"}, {"name": "a"}, {}]"#), r#"line 1, column 135, holes[0].sides[1].name: sides 1 and 2 of hole 1 are both named "a"; names become groups in mesh files and must differ"#),
        (hole(r#""sides": [{}, {}, {"outside_degree": [1]}]"#), r#"line 1, column 138, holes[0].sides[2].outside_degree: side 3 of hole 1: outside_degree lists 1 number, and the side has 2 vertices, both corners included; give one for each, or a single number for all that are not corners"#),
        (with_hole(r#"{"corners": [[1, 1], [12, 1], [1, 2]]}"#), r#"line 1, column 63, holes[0]: interval 1 of side 2 and interval 3 of side 1 of hole 1 cross near (9.0, 1.0); list the points in the order in which they lie around the domain, and keep rings apart"#),
        (with_hole(r#"{"corners": [[11, 1], [12, 1], [11, 2]]}"#), r#"line 1, column 63, holes[0]: hole 1 lies outside the outline, with its first corner at (11.0, 1.0); move it inside, or drop it"#),
        (with_hole(r#"{"corners": [[1, 1], [2, 1]]}"#), r#"line 1, column 75, holes[0].corners: found 2 corners of hole 1; a hole of straight sides needs at least 3"#),
        (with_hole(r#"{"ring": [[1, 1], [2, 1], [1, 1], [3, 5]]}"#), r#"line 1, column 81, holes[0].ring[1]: the boundary folds back on itself at point 2 of hole 1 at (2.0, 1.0) (0°); drop the point or move it"#),
        (with_hole(r#"{"ring": [[1, 1], [2, 1], [1, 2]], "size": 1}"#), r#"line 1, column 106, holes[0].size: a "ring" has its own points; drop "size""#),
        (ring("3"), r#"line 1, column 10, ring: found the number 3, expected a list"#),
        (ring("[[0, 0], [1, 0]]"), r#"line 1, column 10, ring: found 2 points; a ring needs at least 3"#),
        (ring("[[0, 0], [1, 0], [0, 1, 0]]"), r#"line 1, column 27, ring[2]: found a list of 3 values, expected a list of 2"#),
        (ring("[[0, 0], [1, 0], [0, 1e999]]"), r#"line 1, column 31, ring[2][1]: the number 1e999 is too large; the maximum is about 1e308"#),
        (ring("[[0, 0], [1, 0], [0, 1e101]]"), r#"line 1, column 27, ring[2]: side 1: point 2 of the curve is at (0.0, 1e101); coordinates must be finite and at most 1e100 in size"#),
        (ring("[[0, 0], [1, 1], [1, 0], [0, 1]]"), r#"line 1, column 27, ring[2]: edge 1 and edge 3 cross near (0.5, 0.5); list the points in the order in which they lie around the domain, and keep rings apart"#),
        (ring("[[0, 0], [4, 0], [4, 4], [4, 0], [0, 4]]"), r#"line 1, column 27, ring[2]: the boundary folds back on itself at point 3 at (4.0, 4.0) (0°); drop the point or move it"#),
        (ring("[[0, 0], [4, 0], [4, 4], [3, 4], [4, 0], [0, 4]]"), r#"line 1, column 43, ring[4]: point 5 is at (4.0, 0.0), where point 2 is too; a boundary passes each point once: move one of them, or split the ring there"#),
        (r#"{"ring": [[0, 0], [1, 0], [0, 1]], "size": 1}"#.to_owned(), r#"line 1, column 44, size: a "ring" has its own points; drop "size""#),
        (r#"{"ring": [[0, 0], [1, 0], [0, 1]], "sides": [{}, {}]}"#.to_owned(), r#"line 1, column 45, sides: found 2 sides; a "ring" is one side; for several, give corners and the "points" of each side"#),
        (r#"{"ring": [[0, 0], [1, 0], [0, 1]], "sides": [{"intervals": 3}]}"#.to_owned(), r#"line 1, column 60, sides[0].intervals: a "ring" has its own points; drop "intervals""#),
        (side(r#""points": [[0, 0.5]], "intervals": 2"#), r#"line 3, column 2, sides[3]: "points" say how many intervals there are; drop "intervals""#),
        (side(r#""points": [[0, 0.5]], "spacing": "uniform""#), r#"line 3, column 2, sides[3]: "points" say how many intervals there are; drop "spacing""#),
        (side(r#""points": [[0, 0.2], [0, 0.8]]"#), r#"line 3, column 24, sides[3].points[1]: side 4: point 2 at (0.0, 0.8) is not farther along the straight side than the one before; list the points in the order in which they lie on it"#),
        (side(r#""points": [[0.1, 0.5], [0.5, 0], [0.2, 0.3]]"#), r#"line 3, column 26, sides[3].points[1]: point 2 of side 4 at (0.5, 0.0) lies on side 1; rings may not touch: move the point off, or split the ring there"#),
        (side(r#""points": [[0, 1], [0, 0.5]]"#), r#"line 3, column 14, sides[3].points[0]: side 4: point 1 at (0.0, 1.0) is not farther along the straight side than the one before; list the points in the order in which they lie on it"#),
        (side(r#""points": [[0, 0.5]], "arc": {"through": [0, 0]}"#), r#"line 3, column 2, sides[3]: a side runs one way: give either "points" or "arc""#),
        (side(r#""intervals": 3, "arc": {"through": [0, 0.5]}"#), r#"line 3, column 26, sides[3].arc: side 4: the arc goes through (0.0, 0.5), which lies on the line through its corners; move that point off, or drop the arc"#),
        (side(r#""intervals": 3, "arc": {"center": [1, 0]}"#), r#"line 3, column 26, sides[3].arc: side 4: the arc's center is 1.4142135623730951 from the corner where the arc starts and 1.0 from the corner where it ends; move it to where both are equal"#),
        (side(r#""intervals": 3, "arc": {}"#), r#"line 3, column 26, sides[3].arc: give exactly one of "through": [x, y] and "center": [x, y]"#),
        (side(r#""intervals": 3, "arc": {"through": [1, 1], "clockwise": true}"#), r#"line 3, column 59, sides[3].arc.clockwise: "through" says which way the arc runs; drop "clockwise""#),
        (side(r#""intervals": 3, "arc": {"center": [1, 1], "clockwise": 1}"#), r#"line 3, column 58, sides[3].arc.clockwise: found the number 1, expected true or false"#),
        (side(r#""intervals": 3, "bezier": [[1, 1]]"#), r#"line 3, column 29, sides[3].bezier: found a list of 1 value, expected a list of 2"#),
        (side(r#""intervals": 3, "kind": "water""#), r#"line 3, column 27, sides[3].kind: found the text "water", expected "open", "land" or "island""#),
    ];
    check_all(&table);
}

#[test]
fn says_what_is_wrong_with_a_domain() {
    #[rustfmt::skip]
    let table = [
        (r#"3"#, r#"line 1, column 1: found the number 3, expected an object with "name", "rectangle", "polygon", "ring", "sides", "size", "holes", "vertices", "interior""#),
        (r#"true"#, r#"line 1, column 1: found true, expected an object with "name", "rectangle", "polygon", "ring", "sides", "size", "holes", "vertices", "interior""#),
        (r#"[]"#, r#"line 1, column 1: found a list; a domain is an object with "rectangle", "polygon" or "ring", and "sides" or "size"; the corners of a polygon go into "polygon": {"corners": [[x, y], …]}"#),
        (r#"[[0, 0], [4, 0], [0, 3]]"#, r#"line 1, column 1: found a list; a domain is an object with "rectangle", "polygon" or "ring", and "sides" or "size"; the corners of a polygon go into "polygon": {"corners": [[x, y], …]}"#),
        (r#"{}"#, r#"line 1, column 1: the outline is missing; give "rectangle": {"width": w, "height": h}, "polygon": {"corners": [[x, y], …]} or "ring": [[x, y], …]"#),
        (r#"{"polygon": [[0, 0], [1, 0]]}"#, r#"line 1, column 13, polygon: found a list of 2 values, expected an object with "corners""#),
        (r#"{"polygon": [[[0, 0], [4, 0], [0, 3]]]}"#, r#"line 1, column 13, polygon: found a list of 1 value, expected an object with "corners""#),
        (r#"{"polygon": {}}"#, r#"line 1, column 13, polygon: the key "corners" is missing"#),
        (r#"{"polygon": {"corners": [[0, 0], [1, 0, 0]]}}"#, r#"line 1, column 34, polygon.corners[1]: found a list of 3 values, expected a list of 2"#),
        (r#"{"polygon": {"corners": [[0, 0], [1]]}}"#, r#"line 1, column 34, polygon.corners[1]: found a list of 1 value, expected a pair [x, y] of numbers"#),
        (r#"{"polygon": {"corners": [[0, 0], [1, "a"]]}}"#, r#"line 1, column 38, polygon.corners[1][1]: found the text "a", expected a number"#),
        (r#"{"polygon": {"corners": [[0, 0], {"x": 1, "y": 0}]}}"#, r#"line 1, column 34, polygon.corners[1]: found an object, expected a pair [x, y] of numbers"#),
        (r#"{"polygon": {"corners": []}, "size": 1}"#, r#"line 1, column 25, polygon.corners: found 0 corners; an outline of straight sides needs at least 3"#),
        (r#"{"rectangle": [4, 3]}"#, r#"line 1, column 15, rectangle: found a list of 2 values, expected an object with "width", "height", "origin", "rotation""#),
        (r#"{"rectangle": 4}"#, r#"line 1, column 15, rectangle: found the number 4, expected an object with "width", "height", "origin", "rotation""#),
        (r#"{"rectangle": {"width": 1}}"#, r#"line 1, column 15, rectangle: the key "height" is missing"#),
        (r#"{"rectangle": {"width": null, "height": 1}}"#, r#"line 1, column 25, rectangle.width: found null, expected a number"#),
        (r#"{"rectangle": {"width": 1, "heigth": 1}}"#, r#"line 1, column 38, rectangle.heigth: unknown key "heigth"; allowed: "width", "height", "origin", "rotation""#),
        (r#"{"rectangle": {"width": 1, "height": 1, "origin": 3}}"#, r#"line 1, column 51, rectangle.origin: found the number 3, expected a pair [x, y] of numbers"#),
        (r#"{"rectangle": {"width": 1, "height": 1}, "vertices": [[3, 1, 5]], "size": 1}"#, r#"line 1, column 55, vertices[0]: found a list of 3 values, expected an object with "vertex", "outside_degree", "max_degree""#),
        (r#"{"rectangle": {"width": 1, "height": 1}, "vertices": {"vertex": 1}, "size": 1}"#, r#"line 1, column 54, vertices: found an object, expected a list"#),
        (r#"{"rectangle": {"width": 1, "height": 1}, "size": 1, "vertices": [{"id": 1}]}"#, r#"line 1, column 73, vertices[0].id: unknown key "id"; allowed: "vertex", "outside_degree", "max_degree""#),
        (r#"{"rectangle": {"width": 1, "height": 1}, "size": 1, "vertices": [{"vertex": -1}]}"#, r#"line 1, column 77, vertices[0].vertex: found the number -1, expected a whole number"#),
        (r#"{"rectangle": {"width": 1, "height": 1}, "size": 1, "vertices": [{"max_degree": 4}]}"#, r#"line 1, column 66, vertices[0]: the key "vertex" is missing"#),
        (r#"{"rectangle": {"width": 1, "height": 1}, "size": 1, "vertices": [{"vertex": 1}]}"#, r#"line 1, column 66, vertices[0]: give "outside_degree" (edges on the other side of the boundary) or "max_degree" (a degree limit), or drop the vertex"#),
        (r#"{"rectangle": {"width": 1, "height": 1}, "size": 1, "vertices": [{"vertex": 4, "max_degree": 3}]}"#, r#"line 1, column 77, vertices[0].vertex: vertex 4 does not exist; the 4 vertices are numbered from 0, counter-clockwise from the first corner"#),
        (r#"{"rectangle": {"width": 1, "height": 1}, "size": 1, "vertices": [{"vertex": 1, "max_degree": 3}, {"max_degree": 4, "vertex": 1}]}"#, r#"line 1, column 126, vertices[1].vertex: vertex 1 is listed twice; give it one entry"#),
        (r#"{"rectangle": {"width": 1, "height": 1}, "size": 1, "vertices": [{"vertex": 1, "max_degree": 3, "outside_degree": 2}]}"#, r#"line 1, column 94, vertices[0].max_degree: vertex 1 has a max_degree of 3 and needs 4: 2 edges along the boundary and 2 outside; raise max_degree to 4 or more"#),
        (r#"{"rectangle": {"width": 1, "height": 1}, "size": 0.5, "vertices": [{"vertex": 1, "max_degree": 2}]}"#, r#"line 1, column 96, vertices[0].max_degree: vertex 1 has a max_degree of 2 and needs 3: 2 edges along its straight side and 1 into the domain; raise max_degree to 3 or more"#),
        (r#"{"rectangle": {"width": 1, "height": 1}, "size": 1, "vertices": [{"vertex": 1, "outside_degree": 4000000000}]}"#, r#"line 1, column 98, vertices[0].outside_degree: entry 1: outside_degree is 4000000000; the maximum is 1000000000"#),
        (r#"{"sides": [], "rectangle": {"width": 1, "height": 1}}"#, r#"line 1, column 11, sides: 0 sides are described and the outline has 4; describe each side once"#),
        (r#"{"sides": [{"intervals": 1}], "rectangle": {"width": 1, "height": 1}}"#, r#"line 1, column 11, sides: 1 side is described and the outline has 4; describe each side once"#),
        (r#"{"rectangle": {"width": 1, "height": 1}}"#, r#"line 1, column 1: the sides are missing; give "sides": [{"intervals": n}, …], or a target interval length "size" for all"#),
        (r#"{"rectangle": {"width": 1, "height": 1}, "sides": 3}"#, r#"line 1, column 51, sides: found the number 3, expected a list"#),
        (r#"{"rectangle": {"width": 1, "height": 1}, "sides": {"intervals": 3}}"#, r#"line 1, column 51, sides: found an object, expected a list"#),
        (r#"{"rectangle": {"width": 1, "height": 1}, "size": -1}"#, r#"line 1, column 50, size: side 1: the size is -1.0; it must be a finite number above 0"#),
        (r#"{"rectangle": {"width": 1, "height": 1}, "size": 1e-300}"#, r#"line 1, column 50, size: side 1: the size 1e-300 makes 1.0e300 intervals, and a boundary has at most 4294967294 vertices; give a larger size"#),
        (r#"{"rectangle": {"width": 1, "height": 1}, "size": 1e-300, "sides": [{}, {}, {}, {}]}"#, r#"line 1, column 50, size: side 1: the size 1e-300 makes 1.0e300 intervals, and a boundary has at most 4294967294 vertices; give a larger size"#),
        (r#"{"rectangle": {"width": 1, "height": 1}, "size": 1e-9, "sides": [{}, {}, {}, {"intervals": 4000000000}]}"#, r#"line 1, column 92, sides[3].intervals: side 4 has 4000000000 intervals, with which the boundary exceeds the maximum of 4294967294 vertices; use fewer intervals"#),
        (r#"{"rectangle": {"width": 1, "height": 1}, "name": 3, "size": 1}"#, r#"line 1, column 50, name: found the number 3, expected a text in double quotes"#),
        (r#"{"rectangle": {"width": 1, "height": 1}, "name": "a\nb", "size": 1}"#, r#"line 1, column 50, name: the name of the domain contains the line break U+000A; remove this character"#),
        (r#"{"rectangle": {"width": 1, "height": 1}, "polygon": {"corners": []}}"#, r#"line 1, column 53, polygon: a domain has one outline; drop "rectangle" or "polygon""#),
        (r#"{"size": 1, "rectangle": {"width": 1, "height": -1}}"#, r#"line 1, column 49, rectangle.height: the rectangle's height is -1.0; it must be a finite number above 0"#),
        (r#"{"size": 1, "rectangle": {"width": 1e-17, "height": 1}}"#, r#"line 1, column 36, rectangle.width: the rectangle's width is 1e-17, and its coordinates are up to 1.0: 64-bit floats cannot tell its corners apart; keep width and height within a factor of 1e14, and the rectangle near the origin"#),
        (r#"{"size": 1, "rectangle": {"width": 1e20, "height": 1}}"#, r#"line 1, column 52, rectangle.height: the rectangle's height is 1.0, and its coordinates are up to 1e20: 64-bit floats cannot tell its corners apart; keep width and height within a factor of 1e14, and the rectangle near the origin"#),
        (r#"{"size": 1, "rectangle": {"width": 1e101, "height": 1}}"#, r#"line 1, column 26, rectangle: a corner of the rectangle is at (1e101, 0.0); coordinates must be finite and at most 1e100 in size; use another unit of length"#),
        (r#"{"size": 1, "rectangle": {"width": 1e-13, "height": 1}, "sides": [{"intervals": 99}, {}, {}, {}]}"#, r#"line 1, column 26, rectangle: corner 1: the points next to it are 1.0e-15 from the other side, too close to be told apart at the size of the coordinates; make the intervals there longer or the angle larger, or move the domain towards the origin"#),
        (r#"{"size": 1e9, "rectangle": {"width": 1, "height": 1e-15}}"#, r#"line 1, column 51, rectangle.height: the rectangle's height is 1e-15, and its coordinates are up to 1.0: 64-bit floats cannot tell its corners apart; keep width and height within a factor of 1e14, and the rectangle near the origin"#),
        ("{\"size\": 1, \"polygon\": {\"corners\":\n[[0,0],[3,0],\n[1,0],[0,1]]}}", r#"line 2, column 8, polygon.corners[1]: the boundary folds back on itself at corner 2 at (3.0, 0.0) (0°); drop the point or move it"#),
        (r#"{"size": 1, "polygon": {"corners": [[0,0],[4,0],[4,1e-17],[0,3]]}}"#, r#"line 1, column 49, polygon.corners[2]: corners 2 and 3 coincide: their distance is 1.0e-17, and the minimum at these coordinates is 7.1e-15; drop one of them"#),
        (r#"{"size": 1, "polygon": {"corners": [[0,0],[4,0],[0,3],[0,0]]}}"#, r#"line 1, column 37, polygon.corners[0]: corners 4 and 1 are the same point (0.0, 0.0); give each corner once (the outline closes by itself)"#),
        (r#"{"size": 9, "polygon": {"corners": [[0,0],[4,0],[1,1],[4,4],[2,0],[0,2]]}}"#, r#"line 1, column 61, polygon.corners[4]: corner 5 at (2.0, 0.0) lies on side 1; rings may not touch: move the point off, or split the ring there"#),
    ];
    check_all(&table);
}

#[test]
fn says_where_a_text_is_no_json_and_what_it_looks_like() {
    #[rustfmt::skip]
    let table = [
        ("", r#"line 1, column 1: the input is empty; give a domain in JSON, such as {"rectangle": {"width": 4, "height": 3}, "size": 1}"#),
        ("  \n ", r#"line 1, column 1: the input is empty; give a domain in JSON, such as {"rectangle": {"width": 4, "height": 3}, "size": 1}"#),
        ("\u{feff}", r#"line 1, column 1: the input is empty; give a domain in JSON, such as {"rectangle": {"width": 4, "height": 3}, "size": 1}"#),
        ("{", r#"line 1, column 1: the JSON text ends too early; close every {, [ and " that is open"#),
        ("{}{}", r#"line 1, column 3: text after the end of the domain; remove it"#),
        ("{\"size\": 1,}", r#"line 1, column 12: a comma without a value after it; remove it"#),
        ("{\"size\": 1,5}", r#"line 1, column 12: a number after a comma, where a key is expected; write decimals with a point"#),
        ("{\"size\": [1,]}", r#"line 1, column 13: this is not a JSON value; give a number, a text in double quotes, true, false, null, [ ] or { }"#),
        ("{size: 1}", r#"line 1, column 2: a key must stand in double quotes"#),
        ("{\"size\" 1}", r#"line 1, column 9: a key must be followed by : and a value"#),
        ("{\"size\": 1 \"name\": 2}", r#"line 1, column 12: a value must be followed by , or }"#),
        ("{\"size\": [1 2]}", r#"line 1, column 13: a value must be followed by , or ]"#),
        ("{\"size\": .5}", r#"line 1, column 10: this is not a JSON value; give a number, a text in double quotes, true, false, null, [ ] or { }"#),
        ("{\"size\": 01}", r#"line 1, column 11: this is not a JSON number; write it as 0.5, -2 or 1e-3"#),
        ("{\"size\": -}", r#"line 1, column 11: this is not a JSON number; write it as 0.5, -2 or 1e-3"#),
        ("{\"size\": NaN}", r#"line 1, column 10: this is not a JSON value; give a number, a text in double quotes, true, false, null, [ ] or { }"#),
        ("{\"name\": \"a\nb\"}", r#"line 1, column 11: a line break or control character in a text; remove it, or close the text before it with ""#),
        ("{\"name\": \"a\\qb\"}", r#"line 1, column 13: this \ escape is not JSON; write \\ for a backslash"#),
        ("{\"name\": \"a", r#"line 1, column 11: the JSON text ends too early; close every {, [ and " that is open"#),
        ("{'size': 1}", r#"line 1, column 2: a key must stand in double quotes"#),
        ("hello", r#"line 1, column 1: this is not a JSON value; give a number, a text in double quotes, true, false, null, [ ] or { }"#),
        ("# Blender\no cube\nv 1 2 3\nf 1 2 3", r#"line 1, column 1: this looks like an OBJ mesh (mindeg inspect reads meshes); give a domain in JSON, such as {"rectangle": {"width": 4, "height": 3}, "size": 1}"#),
        ("v 0 0 0\nv 1 0 0", r#"line 1, column 1: this looks like an OBJ mesh (mindeg inspect reads meshes); give a domain in JSON, such as {"rectangle": {"width": 4, "height": 3}, "size": 1}"#),
        ("$MeshFormat\n4.1 0 8", r#"line 1, column 1: this looks like a Gmsh mesh (.msh); give a domain in JSON, such as {"rectangle": {"width": 4, "height": 3}, "size": 1}"#),
        ("Point(1) = {0, 0, 0};", r#"line 1, column 1: this looks like a Gmsh geometry (.geo); give a domain in JSON, such as {"rectangle": {"width": 4, "height": 3}, "size": 1}"#),
        ("x,y\n0,0\n1,0", r#"line 1, column 1: this looks like a list of points (CSV); they go into "polygon": {"corners": [[x, y], …]}; give a domain in JSON, such as {"rectangle": {"width": 4, "height": 3}, "size": 1}"#),
        ("0,0\n4,0\n3,2", r#"line 1, column 1: this looks like a list of points (CSV); they go into "polygon": {"corners": [[x, y], …]}; give a domain in JSON, such as {"rectangle": {"width": 4, "height": 3}, "size": 1}"#),
        ("0 0\n4 0", r#"line 1, column 1: this looks like a list of points (CSV); they go into "polygon": {"corners": [[x, y], …]}; give a domain in JSON, such as {"rectangle": {"width": 4, "height": 3}, "size": 1}"#),
        ("1;2", r#"line 1, column 1: this looks like a list of points (CSV); they go into "polygon": {"corners": [[x, y], …]}; give a domain in JSON, such as {"rectangle": {"width": 4, "height": 3}, "size": 1}"#),
        ("<svg xmlns=", r#"line 1, column 1: this looks like an SVG drawing; give a domain in JSON, such as {"rectangle": {"width": 4, "height": 3}, "size": 1}"#),
        ("<?xml version=", r#"line 1, column 1: this looks like XML, such as a VTU mesh or an SVG drawing; give a domain in JSON, such as {"rectangle": {"width": 4, "height": 3}, "size": 1}"#),
        ("POLYGON ((0 0, 4 0, 0 3))", r#"line 1, column 1: this looks like WKT; give a domain in JSON, such as {"rectangle": {"width": 4, "height": 3}, "size": 1}"#),
        ("ply\nformat ascii", r#"line 1, column 1: this looks like a PLY mesh; give a domain in JSON, such as {"rectangle": {"width": 4, "height": 3}, "size": 1}"#),
        ("solid cube", r#"line 1, column 1: this looks like an STL mesh; give a domain in JSON, such as {"rectangle": {"width": 4, "height": 3}, "size": 1}"#),
        ("# vtk DataFile Version 3.0", r#"line 1, column 1: this looks like a VTK mesh; give a domain in JSON, such as {"rectangle": {"width": 4, "height": 3}, "size": 1}"#),
        ("OFF\n8 6 0", r#"line 1, column 1: this looks like an OFF mesh; give a domain in JSON, such as {"rectangle": {"width": 4, "height": 3}, "size": 1}"#),
        ("{\"type\": \"FeatureCollection\", \"features\": []}", r#"line 1, column 1: this looks like GeoJSON; a domain is an object with "rectangle", "polygon" or "ring", and "sides" or "size""#),
        ("{\"type\": \"Polygon\", \"coordinates\": [[[0, 0]]]}", r#"line 1, column 1: this looks like GeoJSON; a domain is an object with "rectangle", "polygon" or "ring", and "sides" or "size""#),
        ("{\"type\": \"MultiPolygon\", \"coordinates\": []}", r#"line 1, column 1: this looks like GeoJSON; a domain is an object with "rectangle", "polygon" or "ring", and "sides" or "size""#),
        ("{\"asset\": {\"version\": \"2.0\"}, \"meshes\": []}", r#"line 1, column 1: this looks like a glTF mesh (mindeg inspect reads meshes); a domain is an object with "rectangle", "polygon" or "ring", and "sides" or "size""#),
    ];
    check_all(&table);
}
