//! Tests of reading.

use glam::DVec2;

use super::*;
use crate::constraints::{ExternalDegree, VertexConstraint};
use crate::interior::{Interior, Prefer};
use crate::side::Side;
use crate::sizes::{Size, SizeAt, SizeBetween, SizeFrom};
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

/// The reader's own float parser may be off by a unit in the last place.
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

/// A unit square in JSON with the given last side, on line 3 from column 2 on.
pub(super) fn with_side(side: &str) -> String {
    format!(
        "{{\"rectangle\": {{\"width\": 1, \"height\": 1}}, \"sides\": [\n\
         {{\"intervals\": 1}}, {{\"intervals\": 1}}, {{\"intervals\": 1, \"name\": \"top\"}},\n {side}]}}"
    )
}

/// A domain in JSON with the given hole, from column 63 on.
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
    let notes = domain.notes();
    assert!(
        notes.len() == 1 && notes[0].starts_with("The corners of hole 1 and hole 3 ran"),
        "{notes:?}"
    );
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

fn with_interior(interior: &str) -> Result<Domain, String> {
    let text = format!(
        r#"{{"rectangle": {{"width": 4, "height": 3}}, "size": 1, "interior": {interior}}}"#
    );
    Domain::from_json(&text).map_err(|error| error.to_string())
}

#[test]
fn reads_every_key_of_the_interior() {
    let found = with_interior(
        r#"{"growth": 0.3, "size_inside": 2, "min_size": 0.01, "max_size": 3, "across": 3, "sizes": [[1, 1, 0.1], [3, 2, 0.2],
            {"from": ["wall", "side 1"], "size": 0.1, "growth": 0, "until": 2}, {"size": 1, "from": ["a"]},
            {"points": [[0, 0, 1], [1, 0, 2], [0, 1, 3]], "triangles": [[0, 1, 2]]}],
            "interior_degree": [4, 8], "boundary_degree": 6, "boundary_corners": 2, "target_angle": 25,
            "prefer": "angle"}"#,
    );
    let size_at = |x, y, size| SizeAt { at: DVec2::new(x, y), size };
    let expected = Interior {
        growth: Some(0.3),
        size_inside: Some(2.0),
        min_size: Some(0.01),
        max_size: Some(3.0),
        across: Some(3.0),
        sizes: vec![
            Size::At(size_at(1.0, 1.0, 0.1)),
            Size::At(size_at(3.0, 2.0, 0.2)),
            Size::From(SizeFrom {
                from: vec!["wall".to_owned(), "side 1".to_owned()],
                size: 0.1,
                growth: Some(0.0),
                until: Some(2.0),
            }),
            Size::From(SizeFrom { from: vec!["a".to_owned()], size: 1.0, ..SizeFrom::default() }),
            Size::Between(SizeBetween {
                points: vec![
                    size_at(0.0, 0.0, 1.0),
                    size_at(1.0, 0.0, 2.0),
                    size_at(0.0, 1.0, 3.0),
                ],
                triangles: vec![[0, 1, 2]],
            }),
        ],
        interior_degree: Some(4..=8),
        boundary_degree: Some(6),
        boundary_corners: Some(2),
        target_angle: Some(25.0),
        prefer: Some(Prefer::Angle),
        max_points: None,
    };
    assert_eq!(found.unwrap().interior(), Some(&expected));
    assert_eq!(with_interior("{}").unwrap().interior(), Some(&Interior::default()));
    assert_eq!(with_interior("null").unwrap().interior(), None);
}

#[test]
fn refuses_what_the_interior_cannot_be_with_the_place() {
    for (interior, message) in [
        (
            "true",
            "interior: found true, expected an object with \"growth\", \"size_inside\", \"min_size\", \"max_size\", \"across\", \"sizes\", \"interior_degree\", \"boundary_degree\", \"boundary_corners\", \"target_angle\", \"prefer\", \"max_points\"",
        ),
        (
            r#"{"growth": 0}"#,
            "interior.growth: growth is 0; it is a finite number above 0 (0.5 is usual, less grows slower)",
        ),
        (
            r#"{"size_inside": -1}"#,
            "interior.size_inside: the size inside is -1; a size is a finite number above 0",
        ),
        (
            r#"{"sizes": [[1, 2]]}"#,
            "interior.sizes[0]: found a list of 2 values, expected a list of 3",
        ),
        (
            r#"{"sizes": [[1, 2, 0]]}"#,
            "interior.sizes[0]: size 0 is 0; a size is a finite number above 0",
        ),
        (
            r#"{"sizes": [[1, 2, 1], 3]}"#,
            "interior.sizes[1]: found the number 3, expected a size [x, y, h], or an object with \"from\", \"points\", \"rows\" or \"file\"",
        ),
        (
            r#"{"sizes": [{"from": ["wall"]}]}"#,
            "interior.sizes[0]: a size is [x, y, h], {\"from\": [\"wall\"], \"size\": h}, which may have \"growth\" and \"until\", {\"points\": [[x, y, h], …], \"triangles\": [[a, b, c], …]}, {\"origin\": [x, y], \"spacing\": [dx, dy], \"rows\": [[h, …], …]}, or {\"file\": \"sizes.asc\"}",
        ),
        (
            r#"{"sizes": [{"from": [], "size": 1}]}"#,
            "interior.sizes[0].from: give the names of sides and lines, such as [\"wall\"]",
        ),
        (
            r#"{"sizes": [{"from": ["a"], "size": 1, "until": 0}]}"#,
            "interior.sizes[0].until: the distance is 0; it is a finite number above 0",
        ),
        (
            r#"{"sizes": [{"points": [[0, 0, 1]], "triangles": [[0, 0, 1]]}]}"#,
            "interior.sizes[0].triangles[0]: found point 1; there are 1 points, from 0",
        ),
        (
            r#"{"sizes": [{"origin": [0, 0], "spacing": [1, 1], "rows": [[1, 2], [3]]}]}"#,
            "interior.sizes[0]: the rows of a grid have the same number of values, at least one; null leaves one out",
        ),
        (
            r#"{"min_size": 2, "max_size": 1}"#,
            "interior.min_size: the least size, 2, is above the greatest, 1",
        ),
        (
            r#"{"interior_degree": 6}"#,
            "interior.interior_degree: found the number 6, expected a list of 2",
        ),
        (
            r#"{"prefer": "speed"}"#,
            "interior.prefer: found the text \"speed\", expected \"degree\" or \"angle\"",
        ),
        (
            r#"{"fixed": {"points": [[1, 1]]}}"#,
            "interior.fixed: \"fixed\" is now \"lines\" and \"points\" of the domain, beside \"interior\"",
        ),
        (
            r#"{"grow": 1}"#,
            "interior.grow: unknown key \"grow\"; allowed: \"growth\", \"size_inside\", \"min_size\", \"max_size\", \"across\", \"sizes\", \"interior_degree\", \"boundary_degree\", \"boundary_corners\", \"target_angle\", \"prefer\", \"max_points\"",
        ),
    ] {
        let error = with_interior(interior).unwrap_err();
        let (place, error) = error.split_once(", interior").unwrap();
        assert_eq!(format!("interior{error}"), message);
        // Each error is within the value.
        let column: usize = place.trim_start_matches("line 1, column ").parse().unwrap();
        assert!((65..65 + interior.len()).contains(&column), "{place}");
    }
}

#[test]
fn a_grid_of_sizes_becomes_triangles() {
    let grid =
        r#"{"sizes": [{"origin": [1, 2], "spacing": [2, 1], "rows": [[1, 2, 3], [4, 5, null]]}]}"#;
    let domain = with_interior(grid).unwrap();
    let [Size::Between(between)] = &domain.interior().unwrap().sizes[..] else {
        panic!("{domain:?}")
    };
    assert_eq!((between.points.len(), between.triangles.len()), (5, 2));
    assert_eq!(between.points[4], SizeAt { at: DVec2::new(3.0, 3.0), size: 5.0 });
}

#[test]
fn what_is_wanted_inside_survives_writing() {
    let given = with_interior(
        r#"{"growth": 0.3, "size_inside": 0.7, "min_size": 0.1, "sizes": [[1, 1, 0.1],
            {"from": ["a"], "size": 1, "until": 2}, {"points": [[0, 0, 1]], "triangles": []}, {"file": "a.asc"}], "interior_degree": [5, 8],
            "boundary_degree": 6, "target_angle": 20, "prefer": "angle"}"#,
    )
    .unwrap();
    let again = Domain::from_json(&given.to_json()).unwrap();
    assert!(given.interior().is_some());
    assert_eq!(again.interior(), given.interior());
}

#[test]
fn what_is_written_is_read_as_the_same_domain() {
    for text in [
        r#"{"name": "a", "rectangle": {"width": 4, "height": 3, "origin": [1, 0.1], "rotation": 30}, "size": 0.3,
            "vertices": [{"vertex": 3, "outside_degree": 2}, {"vertex": 1, "max_degree": 9}]}"#,
        r#"{"rectangle": {"width": 4, "height": 3}, "sides": [
            {"intervals": 3, "spacing": {"geometric": {"ratio": 1.2}}, "name": "bottom", "kind": "open"},
            {"intervals": 3, "spacing": {"bump": {"ratio": 1.2}}, "outside_degree": 1, "max_degree": 8},
            {"intervals": 3, "spacing": {"first_length": 0.1}, "outside_degree": [1, 2, 3, 4], "kind": "land"},
            {"spacing": {"parameters": [0.1, 0.7]}, "kind": "island"}]}"#,
        // Clockwise, with curves of all kinds and holes.
        r#"{"polygon": {"corners": [[0, 0], [0, 6], [6, 6], [6, 0]]}, "sides": [
            {"size": 0.7, "arc": {"through": [-1, 3]}},
            {"intervals": 5, "bezier": [[2, 7], [4, 5.5]], "spacing": {"last_length": 0.1}},
            {"points": [[6.1, 4], [6.3, 2.1]], "name": "x"},
            {"intervals": 4, "polyline": [[4, -0.1], [2, 0.1]], "spacing": {"beta": {"beta": 1.2}}}],
            "holes": [
                {"corners": [[2, 1]], "sides": [{"intervals": 7, "arc": {"center": [2, 2], "clockwise": true}}]},
                {"corners": [[4, 4]], "sides": [{"intervals": 7, "arc": {"center": [4, 4.5]}}]},
                {"ring": [[1, 4], [2, 4.1], [1.5, 4.7]]}]}"#,
    ] {
        let domain = Domain::from_json(text).unwrap();
        let again = Domain::from_json(&domain.to_json()).unwrap();
        assert!(again.placement().points().eq(domain.placement().points()), "{text}");
        let names = |domain: &Domain| -> Vec<String> {
            (0..domain.sides().len()).map(|side| domain.side_name(side)).collect()
        };
        assert_eq!((names(&again), again.name()), (names(&domain), domain.name()), "{text}");
        if domain.turned.is_empty() {
            assert_eq!(again.sides(), domain.sides(), "{text}");
        }
        assert_eq!(again.constraints(), domain.constraints(), "{text}");
        let words: String = domain.to_json().split_whitespace().collect();
        assert!(!words.contains("\"outside_degree\":0"), "{text}");
        assert_eq!(again.rings(), domain.rings(), "{text}");
        assert_eq!(again.to_json(), domain.to_json());
    }
}

#[test]
fn a_side_without_own_points_is_one_interval() {
    let read = |side: &str| Domain::from_json(&with_side(side)).unwrap();
    let domain = read(r#"{"points": []}"#);
    assert!(domain.rings().sides().eq([1, 1, 1, 1]));
    assert!(domain.is_straight(3) && domain.convex().is_some());
    let again = Domain::from_json(&domain.to_json()).unwrap();
    assert_eq!(again.sides(), domain.sides());
}

/// The error was once that the side has no length.
#[test]
fn a_ring_below_the_smallest_length_is_refused_for_its_size() {
    let error = Domain::from_json(r#"{"ring": [[0, 0], [1e-140, 0], [0, 1e-140]]}"#).unwrap_err();
    assert_eq!(
        error.to_string(),
        "line 1, column 10, ring: side 1: its points are 1e-140 apart at most; a side is at least 1e-100 long: use another unit of length"
    );
}

#[test]
fn coordinates_keep_every_bit() {
    let text = r#"{"ring": [[-0, 0.1], [9007199254740993, -5e-324], [1.7976931348623157e99, 7]]}"#;
    let description: DomainDescription = reader::read(text).unwrap();
    let json = serde_json::json!(description);
    let ring: Vec<[f64; 2]> = serde_json::from_value(json["ring"].clone()).unwrap();
    assert!(ring[0][0] == 0.0 && ring[0][0].is_sign_negative());
    assert_eq!(ring[1], [9_007_199_254_740_992.0, -5e-324]);
    assert_eq!(ring[2], [1.797_693_134_862_315_7e99, 7.0]);
}

/// Values that JSON cannot express (NaN) come from other programs, without a text.
#[test]
fn a_number_that_is_none_is_refused_by_the_key() {
    let mut description = DomainDescription::default();
    description.size = Some(f64::NAN);
    description.rectangle = Some(crate::Rectangle::new(f64::NAN, 1.0));
    let error = description.clone().domain().unwrap_err();
    assert_eq!(error.place.to_string(), "rectangle.width");
    assert_eq!(error.message, "the rectangle's width is NaN; it must be a finite number above 0");
    description.rectangle = Some(crate::Rectangle::new(1.0, 1.0));
    let error = description.domain().unwrap_err();
    assert_eq!(error.message, "side 1: the size is NaN; it must be a finite number above 0");
}

/// Only meshing refused them once, without the name of the file.
#[test]
fn coordinates_too_large_or_small_for_exact_work_are_refused_when_read() {
    let dart = |scale: f64| {
        let corners = [[0.0, 0.0], [4.0, 0.0], [1.0, 1.0], [0.0, 4.0]];
        let corners = corners.map(|corner| corner.map(|x| x * scale));
        Domain::from_json(&format!(
            r#"{{"size": {scale:?}, "polygon": {{"corners": {corners:?}}}}}"#
        ))
    };
    for scale in [1e-42, 1.0, 8e59] {
        assert!(dart(scale).is_ok(), "{scale}");
    }
    for scale in [1e-43, 1e60] {
        let error = dart(scale).unwrap_err();
        assert_eq!(error.path, "polygon.corners");
        assert!(error.message.contains("of magnitude 1.794e-43 to 3.214e60"), "{error}");
    }
    // Convex domains are formulas, at any scale.
    let plate = r#"{"rectangle": {"width": 4e80, "height": 3e80}, "size": 1e80}"#;
    assert!(Domain::from_json(plate).is_ok());
}

/// A map with every kind of line.
const MAP: &str = r#"{"rectangle": {"width": 4, "height": 2}, "size": 0.5,
    "holes": [{"corners": [[3, 1]], "sides": [{"arc": {"center": [2.8, 1]}, "intervals": 8, "name": "bore"}]}],
    "lines": [
        {"corners": [[2, 0], [2, 2]], "name": "interface"},
        {"corners": [[1, 1]], "sides": [{"arc": {"center": [0.7, 1]}, "intervals": 10, "name": "fibre"}]},
        {"points": [[2.2, 0.5], [2.4, 0.6], [2.6, 0.5]], "name": "breakline"},
        {"corners": [[2, 1.25], [1.5, 1.5], [0.25, 2]], "intervals": 2, "sides": [{}, {"name": "end", "size": 0.7}]},
        {"points": [[3.2, 0.2], [3.4, 0.2], [3.3, 0.3]], "closed": true}],
    "points": [{"at": [3.5, 0.5], "name": "gauge", "size": 0.05}, {"at": [1.5, 1.5]}],
    "regions": [{"at": [0.2, 0.2], "name": "matrix"}, {"at": [0.7, 1], "name": "fibre"},
        {"at": [3.5, 1.5], "name": "steel", "material": "S235"}]}"#;

#[test]
fn reads_a_map() {
    let domain = Domain::from_json(MAP).unwrap();
    let boundary = domain.boundary().unwrap();
    // Of 24 vertices on the outline one more, where line 4 ends; the middle of the top was one.
    assert_eq!((boundary.ring(0), boundary.ring(1)), (0..25, 25..33));
    assert_eq!(
        boundary.inner_points()[..2],
        domain.inside().points.iter().map(|p| p.at).collect::<Vec<_>>()
    );
    let lines: Vec<(String, u32)> = domain
        .inner_lines()
        .into_iter()
        .map(|(line, _)| (line.name, line.segments.end - line.segments.start))
        .collect();
    let expected = [
        ("interface", 5),
        ("fibre", 10),
        ("breakline", 2),
        ("line 4", 2),
        ("end", 2),
        ("line 5", 3),
    ];
    assert_eq!(lines, expected.map(|(name, count)| (name.to_owned(), count)));
    let faces = domain.faces().unwrap();
    assert_eq!(faces.count, 5);
    let names: Vec<String> = (0..5).map(|face| domain.region_name(face)).collect();
    assert_eq!(names, ["matrix", "fibre", "steel", "region 4", "region 5"]);
    assert_eq!(domain.region_material(2), Some("S235"));
    // The interface has a size, the fibre a number of intervals.
    let divisible = domain.divisible_segments();
    assert_eq!((divisible.len(), divisible[0], divisible[5]), (24, true, false));
    // Line 4 ends at a corner within line 1 and at the point.
    assert_eq!(boundary.line(3)[0][0], boundary.line(0)[2][1]);
    assert!(boundary.line(3).iter().flatten().any(|&vertex| vertex == 34));
    assert_eq!(domain.notes().len(), 4, "{:?}", domain.notes());
    assert!(domain.convex().is_none());
}

#[test]
fn a_map_is_written_as_it_was_read() {
    let domain = Domain::from_json(MAP).unwrap();
    let again = Domain::from_json(&domain.to_json()).unwrap();
    assert_eq!(again.inside(), domain.inside());
    assert_eq!(again.boundary().unwrap(), domain.boundary().unwrap());
    assert_eq!(again.faces(), domain.faces());
}

#[test]
fn lines_of_clockwise_domains_keep_their_places() {
    let clockwise = r#"{"polygon": {"corners": [[0, 0], [0, 2], [4, 2], [4, 0]]}, "size": 1,
        "lines": [{"corners": [[1, 0], [1, 2]], "intervals": 3}]}"#;
    let domain = Domain::from_json(clockwise).unwrap();
    let boundary = domain.boundary().unwrap();
    let ends =
        [boundary.line(0)[0][0], boundary.line(0)[2][1]].map(|v| boundary.point(v).to_array());
    assert_eq!(ends, [[1.0, 0.0], [1.0, 2.0]]);
}

#[test]
fn a_line_ends_at_the_nearest_of_several_near_points() {
    let domain = Domain::from_json(
        r#"{"polygon": {"corners": [[0, 0], [4, 0], [4, 2], [0, 2]]}, "sides": [
            {"points": [[1, 0], [1.000000002, 0]]}, {"intervals": 1}, {"intervals": 1}, {"intervals": 1}],
            "lines": [{"points": [[1.000000002, 0], [1, 1]]}]}"#,
    )
    .unwrap();
    let boundary = domain.boundary().unwrap();
    assert_eq!(boundary.point(boundary.line(0)[0][0]).to_array(), [1.000_000_002, 0.0]);
}

#[test]
fn refuses_maps_with_the_place() {
    let of = |rest: &str| {
        let text = format!(r#"{{"rectangle": {{"width": 4, "height": 2}}, "size": 1, {rest}}}"#);
        let error = Domain::from_json(&text).unwrap_err();
        format!("{}: {}", error.path, error.message)
    };
    #[rustfmt::skip]
    let table = [
        (r#""lines": [{}]"#, "lines[0]: the key \"corners\" or \"points\" is missing; give \"corners\": [[x, y], …] and \"intervals\", \"size\" or \"sides\", or \"points\": [[x, y], …]"),
        (r#""lines": [{"corners": [[1, 1]]}]"#, "lines[0]: line 1: side 1: the side has no length; move its points apart"),
        (r#""lines": [{"corners": [[1, 1], [2, 1]], "sides": [{"size": 0}]}]"#, "lines[0].sides[0].size: line 1: side 1: the size is 0.0; it must be a finite number above 0"),
        (r#""lines": [{"corners": [[1, 1], [5, 1]]}]"#, "lines[0]: point 1 of side 2 and line 1 have the same point (4, 1); end a line there, or move one of them"),
        (r#""lines": [{"corners": [[1, 0.5], [3, 1.5]]}, {"corners": [[1, 1.5], [3, 0.5]], "intervals": 1}]"#, "lines[0]: line 1 touches line 2 at (2, 1); end a line there, or give the point to both"),
        (r#""lines": [{"points": [[1, 1], [6, 1.5]]}]"#, "lines[0]: interval 2 of side 2 and line 1 cross near (4, 1.3), where the line leaves the domain; end it there, or keep it inside"),
        (r#""lines": [{"points": [[5, 1], [6, 1.5]]}]"#, "lines[0]: line 1 leaves the domain near (5, 1); keep it inside, off holes"),
        (r#""lines": [{"corners": [[1, 0], [3, 0]]}]"#, "lines[0]: interval 2 of side 1 and line 1 lie on each other near (1, 0); drop one of them"),
        (r#""points": [{"at": [1, 1]}, {"at": [1, 1]}]"#, "points[1]: point 1 and point 2 have the same point (1, 1); end a line there, or move one of them"),
        (r#""points": [{"at": [1, 5]}]"#, "points[0]: point 1 leaves the domain near (1, 5); keep it inside, off holes"),
        (r#""points": [{"at": [1, 1], "size": -1}]"#, "points[0].size: the size is -1.0; it must be a finite number above 0"),
        (r#""regions": [{"at": [1, 1]}, {"at": [2, 1]}]"#, "regions[1].at: region 2 at (2, 1) lies in the same face as region 1; drop one of them, or draw a line between them"),
        (r#""regions": [{"at": [1, 9]}]"#, "regions[0].at: region 1 at (1, 9) lies outside the domain; move it inside, or drop it"),
        (r#""regions": [{"at": [1, 1]}, {"at": [3, 1]}, {"at": [1, 1]}]"#, "regions[2].at: region 3 at (1, 1) is at the point of region 1; drop one of them"),
        (r#""lines": [{"corners": [[1, 0], [1, 2]]}], "regions": [{"at": [3, 1]}, {"at": [1, 1.5]}]"#, "regions[1].at: region 2 at (1, 1.5) is no point inside a region; move it off sides, lines and points"),
        (r#""regions": [{"at": [1, 1], "name": " "}]"#, "regions[0].name: the name of region 1 is blank; give it a letter or leave it out"),
        (r#""lines": [{"corners": [[1, 1], [2, 1]], "sides": [{"max_degree": 5}]}]"#, "lines[0].sides[0]: line 1: degrees are limited at the boundary only; drop \"max_degree\" and \"outside_degree\""),
    ];
    for (rest, expected) in table {
        assert_eq!(of(rest), expected, "{rest}");
    }
}

#[test]
fn sides_lines_and_holes_may_share_a_name() {
    let domain = Domain::from_json(
        r#"{"polygon": {"corners": [[0, 0], [0, 4], [4, 4], [4, 0]]},
            "sides": [{"intervals": 2, "name": "wall"}, {"intervals": 1}, {"intervals": 1, "name": "wall"}, {"intervals": 1}],
            "holes": [{"corners": [[1, 1], [2, 1], [1, 2]], "sides": [{"intervals": 1, "name": "wall"}, {"intervals": 1}, {"intervals": 1}]}],
            "lines": [{"points": [[3, 1], [3, 2], [3, 3]], "name": "wall"}],
            "points": [{"at": [0, 2], "name": "a"}, {"at": [3, 2], "name": "b"}, {"at": [2, 3], "name": "c"},
                       {"at": [3, 3], "name": "d"}, {"at": [4, 4]}]}"#,
    )
    .unwrap();
    let names: Vec<_> = (0..7).map(|side| domain.side_name(side)).collect();
    assert_eq!(
        names,
        ["side 1", "wall", "side 3", "wall", "hole 1 side 1", "hole 1 side 2", "wall"]
    );
    // Points at boundary points and on lines are named, and the outline was turned.
    let boundary = domain.boundary().unwrap();
    let at = |vertex| boundary.point(vertex).to_array();
    let named: Vec<_> =
        domain.named_vertices().into_iter().map(|one| (one.name, at(one.vertex))).collect();
    let expected = [("a", [0.0, 2.0]), ("b", [3.0, 2.0]), ("c", [2.0, 3.0]), ("d", [3.0, 3.0])];
    assert_eq!(named, expected.map(|(name, at)| (name.to_owned(), at)));
    assert_eq!(boundary.inner_points().len(), 4);
    let again = Domain::from_json(&domain.to_json()).unwrap();
    assert_eq!(
        (again.named_vertices(), again.boundary().unwrap()),
        (domain.named_vertices(), boundary)
    );
}

#[test]
fn no_name_is_given_to_what_has_none() {
    let sides = r#""rectangle": {"width": 2, "height": 1}, "size": 1, "sides": [{"name": "side 2"}, {}, {}, {}]"#;
    let error = Domain::from_json(&format!("{{{sides}}}")).unwrap_err();
    let called = "without a name it is called \"side 2\", and something else has that name; give it another one";
    assert!(error.to_string().ends_with(&format!("sides[1]: {called}")), "{error}");
    let lines = r#""rectangle": {"width": 2, "height": 1}, "size": 1, "lines": [{"corners": [[1, 0], [1, 1]]}],
        "regions": [{"at": [0.5, 0.5], "name": "region 2"}]"#;
    let error = Domain::from_json(&format!("{{{lines}}}")).unwrap_err();
    assert!(error.to_string().contains("without a name it is called \"region 2\""), "{error}");
}
