//! What is read.

use glam::DVec2;

use super::*;
use crate::constraints::{ExternalDegree, VertexConstraint};
use crate::side::Side;
use crate::spacing::Spacing;
use mindeg_mesh::LineKind;

#[test]
fn reads_every_key() {
    let domain = Domain::from_json(
        r#"{
            "name": "plate",
            "polygon": {"corners": [[0, 0], [8, 0], [8, 4], [0, 4]]},
            "size": 2,
            "sides": [
                {"spacing": "uniform", "name": "bottom"},
                {"intervals": 3, "spacing": {"first_length": 0.5}},
                {"size": 1, "spacing": {"beta": {"beta": 1.2}}},
                {"spacing": {"parameters": [0.25, 0.5]}}
            ]
        }"#,
    )
    .unwrap();
    assert_eq!(domain.name(), Some("plate"));
    assert!(domain.rings().sides().eq([4, 3, 8, 3]));
    assert_eq!(domain.sides()[0], Side::size(2.0).named("bottom"));
    assert_eq!(domain.sides()[1], Side::count(3).spaced(Spacing::FirstLength(0.5)));
    assert_eq!(domain.sides()[3], Side::parameters(vec![0.25, 0.5]));

    let text = r#"{"rectangle": {"width": 2, "height": 1, "origin": [5, 6], "rotation": 90}, "size": 0.5}"#;
    for text in [text.to_owned(), format!("\u{feff}{text}\n")] {
        let domain = Domain::from_json(&text).unwrap();
        assert!(domain.rings().sides().eq([4, 2, 4, 2]));
        assert_eq!(domain.placement().corners()[1], DVec2::new(5.0, 8.0));
    }
}

#[test]
fn reads_constraints() {
    let domain = Domain::from_json(
        r#"{
            "rectangle": {"width": 4, "height": 3}, "size": 2,
            "sides": [
                {"outside_degree": 2}, {"outside_degree": [1, 0, 2], "max_degree": 9}, {}, {}
            ],
            "vertices": [
                {"vertex": 6, "max_degree": 4}, {"vertex": 1, "outside_degree": 1}
            ]
        }"#,
    )
    .unwrap();
    let [bottom, right, top, left] = &domain.constraints().sides[..] else {
        panic!("one for each side")
    };
    assert_eq!(bottom.external_degree, ExternalDegree::Inside(2));
    assert_eq!(right.external_degree, ExternalDegree::Each(vec![1, 0, 2]));
    assert_eq!(
        [bottom, right, top, left].map(|side| side.degree_limit),
        [None, Some(9), None, None]
    );
    let vertex = |vertex, external_degree, degree_limit| VertexConstraint {
        vertex,
        external_degree,
        degree_limit,
    };
    assert_eq!(domain.constraints().vertices, [vertex(1, 1, None), vertex(6, 0, Some(4))]);
}

#[test]
fn null_counts_as_left_out() {
    let domain = Domain::from_json(
        r#"{"name": null, "polygon": null, "vertices": null, "size": 1,
            "rectangle": {"width": 2, "height": 1, "origin": null, "rotation": null},
            "sides": [{"spacing": null, "outside_degree": null, "max_degree": null}, {}, {}, {}]}"#,
    );
    let same = Domain::from_json(r#"{"rectangle": {"width": 2, "height": 1}, "size": 1}"#);
    let (domain, same) = (domain.unwrap(), same.unwrap());
    assert_eq!((domain.placement(), domain.name()), (same.placement(), None));
    assert!(!domain.is_constrained());
}

/// The reader's own float parser is allowed to be off by a unit in the last place.
#[test]
fn coordinates_are_the_nearest_f64() {
    for i in 0..2000_u32 {
        let x = 1e5 + f64::from(i) / 7.0;
        let text =
            format!(r#"{{"size": 1e5, "polygon": {{"corners": [[0, 0], [{x}, 0], [{x}, 1e6]]}}}}"#);
        let domain = Domain::from_json(&text).unwrap();
        assert_eq!(domain.placement().corners()[1].x, x);
    }
}

/// A unit square in whose JSON the last side is as given, on line 3 from column 2 on.
pub(super) fn with_side(side: &str) -> String {
    format!(
        "{{\"rectangle\": {{\"width\": 1, \"height\": 1}}, \"sides\": [\n\
         {{\"intervals\": 1}}, {{\"intervals\": 1}}, {{\"intervals\": 1, \"name\": \"top\"}},\n {side}]}}"
    )
}

/// A domain in which the hole is as given, from column 63 on.
pub(super) fn with_hole(hole: &str) -> String {
    format!(r#"{{"rectangle": {{"width": 9, "height": 9}}, "size": 3, "holes": [{hole}]}}"#)
}

#[test]
fn reads_holes_rings_and_curves() {
    let holes = r#"{"corners": [[1, 1], [2, 1], [1, 2]], "size": 0.5, "sides": [{"name": "a", "max_degree": 9}, {"intervals": 3}, {}]},
        {"ring": [[4, 4], [4, 5], [5, 4.5]], "sides": [{"name": "b", "kind": "island"}]},
        {"corners": [[7, 7]], "sides": [{"intervals": 6, "arc": {"center": [6.5, 7]}}]},
        {"corners": [[6, 1], [8, 1]], "sides": [{"arc": {"through": [7, 2]}, "intervals": 4}, {"points": [[7, 0.5]]}]},
        {"corners": [[1, 6], [2, 6]], "sides": [{"bezier": [[1, 8], [2, 8]], "intervals": 3}, {"polyline": [[2, 5], [1, 5]]}]}"#;
    let domain = Domain::from_json(&with_hole(holes)).unwrap();
    let rings = domain.rings();
    assert!(rings.rings().eq([0..12, 12..19, 19..22, 22..28, 28..34, 34..38]));
    assert_eq!(domain.notes().len(), 2, "{:?}", domain.notes());
    // Turned: from the first corner back.
    assert_eq!(domain.sides()[6].name.as_deref(), Some("a"));
    assert_eq!(domain.constraints().sides[6].degree_limit, Some(9));
    assert_eq!(domain.sides()[7].kind, Some(LineKind::Island));
    let names: Vec<_> = (4..13).map(|side| domain.side_name(side)).collect();
    assert_eq!(
        names,
        [
            "hole 1 side 1",
            "hole 1 side 2",
            "a",
            "b",
            "hole 3",
            "hole 4 side 1",
            "hole 4 side 2",
            "hole 5 side 1",
            "hole 5 side 2"
        ]
    );
    let point = |vertex| domain.placement().point(vertex).to_array();
    assert_eq!([19, 20, 21].map(point), [[4.0, 4.0], [4.0, 5.0], [5.0, 4.5]]);
    assert_eq!([28, 32, 33].map(point), [[6.0, 1.0], [8.0, 1.0], [7.0, 0.5]]);
    assert!(
        (22..28)
            .all(|v| (domain.placement().point(v).distance(DVec2::new(6.5, 7.0)) - 0.5).abs()
                < 1e-15)
    );
    // The polyline of 3, in intervals of 3.
    assert_eq!(rings.intervals(12), 1);

    let ring = Domain::from_json(r#"{"ring": [[0.1, 0], [1e3, -0.0], [0.3, 7]]}"#).unwrap();
    assert!(ring.placement().points().eq([[0.1, 0.0], [1e3, -0.0], [0.3, 7.0]].map(DVec2::from)));
    assert!(ring.convex().is_some());
}

/// The parser's words and the names of Rust's types must not reach a message.
#[test]
fn any_value_in_any_place_is_refused_in_our_words() {
    let values = [
        "3",
        "-1",
        "2.5",
        "1e999",
        "\"a\"",
        "true",
        "null",
        "[]",
        "[1]",
        "[[1]]",
        "{}",
        r#"{"a": 1}"#,
    ];
    let places = [
        "@",
        r#"{"name": @}"#,
        r#"{"rectangle": @}"#,
        r#"{"rectangle": {"width": @, "height": 1}, "size": 1}"#,
        r#"{"rectangle": {"width": 1, "height": 1, "origin": @}, "size": 1}"#,
        r#"{"rectangle": {"width": 1, "height": 1, "rotation": @}, "size": 1}"#,
        r#"{"rectangle": {"width": 1, "height": 1}, "size": @}"#,
        r#"{"rectangle": {"width": 1, "height": 1}, "sides": @}"#,
        r#"{"rectangle": {"width": 1, "height": 1}, "sides": [@, @, @, @]}"#,
        r#"{"rectangle": {"width": 1, "height": 1}, "size": 1, "vertices": @}"#,
        r#"{"rectangle": {"width": 1, "height": 1}, "size": 1, "vertices": [@]}"#,
        r#"{"rectangle": {"width": 1, "height": 1}, "size": 1, "vertices": [{"vertex": @, "max_degree": 9}]}"#,
        r#"{"rectangle": {"width": 1, "height": 1}, "size": 1, "vertices": [{"vertex": 1, "max_degree": @}]}"#,
        r#"{"polygon": @, "size": 1}"#,
        r#"{"polygon": {"corners": @}, "size": 1}"#,
        r#"{"polygon": {"corners": [[0, 0], @, [1, 1]]}, "size": 1}"#,
        r#"{"polygon": {"corners": [[0, 0], [@, 0], [1, 1]]}, "size": 1}"#,
    ];
    let in_side = [
        r#"{"intervals": @}"#,
        r#"{"size": @}"#,
        r#"{"intervals": 2, "name": @}"#,
        r#"{"intervals": 2, "spacing": @}"#,
        r#"{"intervals": 2, "spacing": {"bump": @}}"#,
        r#"{"intervals": 2, "spacing": {"bump": {"ratio": @}}}"#,
        r#"{"intervals": 2, "spacing": {"first_length": @}}"#,
        r#"{"spacing": {"parameters": @}}"#,
        r#"{"spacing": {"parameters": [@]}}"#,
        r#"{"intervals": 2, "outside_degree": @}"#,
        r#"{"intervals": 2, "outside_degree": [@, 0, 0]}"#,
        r#"{"intervals": 2, "max_degree": @}"#,
    ];
    let places = places.map(str::to_owned).into_iter().chain(in_side.map(with_side));
    let theirs = [
        "invalid", "variant", "sequence", "map", "struct", "u64", "u32", "f64", "usize", "integer",
        "floating", "EOF", "ident", "Keys", "field", "boolean", "tuple",
    ];
    let mut refused = 0;
    for place in places {
        for value in values {
            if let Err(error) = Domain::from_json(&place.replace('@', value)) {
                let found = theirs.iter().find(|word| error.message.contains(**word));
                assert_eq!(found, None, "{error}");
                refused += 1;
            }
        }
    }
    assert!(refused > 250, "{refused}");
}
