use crate::run::{mindeg, mindeg_reading};
use serde_json::json;
use std::fs;

#[test]
fn json_lists_every_lower_degree_with_its_change() {
    let answer = mindeg(["suggest", "30,2,4,2", "--json"]).json();
    assert_eq!(answer["intervals"], json!([30, 2, 4, 2]));
    assert_eq!(answer["least_max_degree"], 7);
    assert_eq!(
        answer["suggestions"][1],
        json!({
            "least_max_degree": 5,
            "reached": 5,
            "cost": 7,
            "cost_at_least": 7,
            "changes": [{"side": 2, "by": 7}],
            "intervals": [30, 9, 4, 2],
        })
    );
    let degrees: Vec<_> = answer["suggestions"]
        .as_array()
        .expect("a list")
        .iter()
        .map(|row| row["least_max_degree"].clone())
        .collect();
    assert_eq!(degrees, [6, 5, 4, 3]);
}

#[test]
fn what_is_suggested_has_the_degree_it_promises() {
    for intervals in ["30,2,4,2", "12,9,4,4", "3,3,3", "1000,3,5,2", "5,5,5,5,5,1,1"] {
        let answer = mindeg(["suggest", intervals, "--max-degree", "4", "--json"]).json();
        let row = &answer["suggestions"][0];
        let counts = row["intervals"].to_string();
        let counts = counts.trim_matches(['[', ']']);
        let after = mindeg(["degree", counts, "--json"]).json();
        assert_eq!(after["least_max_degree"], row["least_max_degree"], "{intervals}");
        assert_eq!(after["least_max_degree"], 4, "{intervals}");
    }
}

#[test]
fn text_says_what_to_do() {
    let text = |arguments: &[&str]| mindeg(["suggest"].iter().chain(arguments)).text().to_owned();
    assert_eq!(
        text(&["12,9,4,4", "--max-degree", "4"]),
        "The least maximum degree is 5.\nFor 4: add 2 to side 2, giving 12,11,4,4.\n"
    );
    assert!(text(&["3,3,2,2", "--max-degree", "4"]).ends_with("No change is needed.\n"));
    assert!(text(&["1,1,1"]).ends_with("No change of counts brings it down.\n"));
}

#[test]
fn degree_ends_with_a_hint_above_four() {
    let last = |intervals| {
        let run = mindeg(["degree", intervals]);
        run.text().lines().last().expect("some text").to_owned()
    };
    assert_eq!(last("12,9,4,4"), "hint: add 2 to side 2 and it is 4; mindeg suggest tells more.");
    assert!(!last("3,3,2,2").contains("Hint"));
}

#[test]
fn a_target_out_of_reach_is_refused() {
    mindeg(["suggest", "3,3,2,2", "--max-degree", "2"]).refuses(&["4 sides", "2 or less"]);
    mindeg(["suggest", "3,3", "--max-degree", "4"]).refuses(&["found 2 sides", "at least 3"]);
}

#[test]
fn a_domain_s_file_has_the_counts_too() {
    let path = |name: &str| {
        let domains = crate::mesh::domains();
        let path = domains.iter().find(|path| path.ends_with(name)).expect("it is there");
        crate::mesh::text(path).to_owned()
    };
    // The options that describe a domain without a file are those of mesh.
    let options = ["degree", "--rectangle", "4x3", "--intervals", "3,3,2,2", "--json"];
    let [typed, counts] = [mindeg(options).json(), mindeg(["degree", "3,3,2,2", "--json"]).json()];
    assert_eq!(typed["certificate"], counts["certificate"]);
    mindeg(["suggest", "3,3,2,2", "--size", "1"]).refuses(&["the counts are given already"]);
    for command in ["degree", "suggest"] {
        // Counts alone tell nothing of angles.
        let without_angles = |mut answer: serde_json::Value| {
            let keys = answer.as_object_mut().expect("an object");
            keys.retain(|key, _| key != "limit" && key != "angle_suggestions");
            answer
        };
        let of = |counts: &str| without_angles(mindeg([command, counts, "--json"]).json());
        assert_eq!(of(&path("figure-1.json")), of("3,3,2,2"), "{command}");
        let domain = r#"{"rectangle": {"width": 4, "height": 3}, "size": 1}"#;
        let read = mindeg_reading([command, "-", "--json"], domain.as_bytes());
        assert_eq!(without_angles(read.json()), of("4,3,4,3"), "{command}");
        if command == "degree" {
            continue; // it tells the degree under limits, too
        }
        let limited = r#"{"rectangle": {"width": 4, "height": 3}, "size": 1, "sides": [
            {"outside_degree": [0, 1, 0, 0, 0]}, {}, {}, {}]}"#;
        mindeg_reading([command, "-"], limited.as_bytes())
            .refuses(&["outside_degree or max_degree of single vertices", "degree, mesh"]);
        // A limit of a whole side holds after a change, too.
        let limited =
            FRAME.replacen(r#"{"intervals": 3}"#, r#"{"intervals": 3, "max_degree": 4}"#, 1);
        let answer = mindeg_reading([command, "-", "--json"], limited.as_bytes()).json();
        assert_eq!(answer["suggestions"][0]["reached"], 4, "{answer}");
    }
}

#[test]
fn a_huge_side_prints_some_suggestions() {
    let mut counts = vec!["1"; 100];
    counts.insert(0, "4294967000");
    let counts = counts.join(",");
    let run = mindeg(["suggest", &counts]);
    assert_eq!(run.code, Some(0), "{run:?}");
    assert_eq!(run.text().lines().count(), 22);
    assert!(
        run.text().ends_with(" rows, spread evenly; --limit 0 prints all.\n"),
        "{}",
        run.text()
    );

    let rows = |limit| mindeg(["suggest", "1000,3,5,2", "--json", "--limit", limit]).json();
    let (all, five) = (rows("0"), rows("5"));
    let [all, five] = [&all, &five].map(|answer| answer["suggestions"].as_array().expect("a list"));
    assert_eq!((all.len(), five.len()), (55, 5));
    assert_eq!((&five[0], &five[4]), (&all[0], &all[54]));
    assert_eq!(rows("5")["suggestion_count"], 55);
}

/// A square of 12 intervals with a square hole of 4.
const FRAME: &str = r#"{"polygon": {"corners": [[0, 0], [4, 0], [4, 4], [0, 4]]},
    "sides": [{"intervals": 3}, {"intervals": 3}, {"intervals": 3}, {"intervals": 3}],
    "holes": [{"corners": [[1, 1], [1, 3], [3, 3], [3, 1]], "sides": [{"intervals": 1}, {"intervals": 1}, {"intervals": 1}, {"intervals": 1}]}]}"#;

#[test]
fn with_holes_changes_are_searched_and_say_what_is_proven() {
    let reading = |arguments: &[&str], domain: &str| {
        mindeg_reading(["suggest", "-"].iter().chain(arguments), domain.as_bytes())
    };
    let text = reading(&[], FRAME).text().to_owned();
    let first = "The least maximum degree is 5.\nFor 4: add 2 to hole 1 side 1 and add 2 to hole 1 side 2 and ";
    assert!(text.starts_with(first), "{text}");
    assert!(text.contains(", giving 3,3,3,3; 3,3,3,3.\n"), "{text}");
    let answer = reading(&["--json", "--max-degree", "4"], FRAME).json();
    let row = &answer["suggestions"][0];
    assert_eq!((&row["cost"], &row["cost_at_least"]), (&json!(8), &json!(8)));
    assert_eq!(row["changes"][0], json!({"side": 5, "by": 2}));
    reading(&["--max-degree", "3"], FRAME).refuses(&["no counts on this domain", "below 4"]);
    assert!(reading(&["--max-degree", "5"], FRAME).text().contains("No change is needed.\n"));
    // A polygon that is not convex.
    let ell = r#"{"polygon": {"corners": [[0, 0], [6, 0], [6, 1], [1, 1], [1, 6], [0, 6]]}, "sides": [
        {"intervals": 9}, {"intervals": 1}, {"intervals": 1}, {"intervals": 1}, {"intervals": 1}, {"intervals": 1}]}"#;
    let row = &reading(&["--json"], ell).json()["suggestions"][0];
    assert_eq!((&row["cost"], &row["cost_at_least"]), (&json!(1), &json!(1)));
}

/// A drawn outline has no counts: an edge is divided, and no point is taken away or moved.
#[test]
fn drawn_outlines_get_points_on_their_longest_edges() {
    let frame = r#"{"ring": [[0, 0], [2, 0], [4, 0], [4, 2], [4, 4], [2, 4], [0, 4], [0, 2]],
        "holes": [{"ring": [[1, 1], [1, 2], [1, 3], [1.5, 3], [2, 3], [3, 3], [3, 1]]}]}"#;
    let reading = |arguments: &[&str]| {
        mindeg_reading(["suggest", "-"].iter().chain(arguments), frame.as_bytes())
    };
    let text = reading(&[]).text().to_owned();
    let change = "For 4: add 1 to hole 1 at (3, 2), giving 8; 8.";
    assert!(
        text.starts_with("The least maximum degree is 5.\n") && text.contains(change),
        "{text}"
    );
    let row = &reading(&["--json"]).json()["suggestions"][0];
    assert_eq!((&row["cost"], &row["cost_at_least"]), (&json!(1), &json!(1)));
    assert_eq!(row["changes"][0]["points"], json!([[3.0, 2.0]]));
}

#[test]
fn a_model_is_told_which_edges_to_change() {
    let folder = tempfile::tempdir().expect("a folder");
    let tetrahedron = folder.path().join("tetrahedron.json");
    let text = r#"{"corners": [[0,0,0], [1,0,0], [0,1,0], [0,0,1]], "size": 0.8,
            "edges": [{"corners": [2, 3], "intervals": 2, "name": "ridge"}],
            "faces": [[0,2,1], [0,1,3], [1,2,3], [2,0,3]]}"#;
    fs::write(&tetrahedron, text).expect("a file");
    let tetrahedron = tetrahedron.to_str().expect("UTF-8");
    let text = mindeg(["suggest", tetrahedron]);
    assert!(text.text().contains("take 1 from edge ridge"), "{}", text.text());
    let answer = mindeg(["suggest", tetrahedron, "--max-degree", "4", "--json"]).json();
    let [row] = &answer["suggestions"].as_array().unwrap()[..] else { panic!("{answer}") };
    assert_eq!(row["reached"], 4);
    assert_eq!(row["changes"].as_array().unwrap().len(), 2, "{row}");
    assert!(row["changes"][0]["corners"].is_array(), "{row}");

    let brackets = ["suggest", "assets/models/bracket.obj", "--size", "5"];
    assert!(mindeg(brackets).text().contains("No change of counts brings it down."));
    mindeg(&brackets[..2]).refuses(&["--size S"]);
    mindeg(["suggest", tetrahedron, "--max-degree", "2"])
        .refuses(&["no counts on this model", "below 3"]);
}

#[test]
fn domains_beside_each_other_each_have_their_changes() {
    let folder = tempfile::tempdir().expect("a folder");
    let square = |x: u32, top: &str| {
        let right = x + 9;
        format!(
            r#"{{"type": "Polygon", "coordinates": [[[{x}, 0], [{right}, 0], [{right}, 9], {top} [{x}, 9], [{x}, 0]]]}}"#
        )
    };
    let many: String = (1..9).rev().map(|x| format!("[{x}, 9],")).collect();
    let both = format!(
        r#"{{"type": "GeometryCollection", "geometries": [{}, {}]}}"#,
        square(0, &many),
        square(20, "")
    );
    let file = folder.path().join("both.geojson");
    fs::write(&file, both).expect("a file");
    let file = file.to_str().expect("UTF-8");
    let answer = mindeg(["suggest", file, "--json"]).json();
    let [many, few] = &answer["parts"].as_array().unwrap()[..] else { panic!("{answer}") };
    assert_eq!(answer["least_max_degree"], many["least_max_degree"]);
    assert!(many["least_max_degree"].as_u64() > few["least_max_degree"].as_u64(), "{answer}");
    assert!(many["limit"]["angle_limit"].is_number(), "{many}");
    let text = mindeg(["suggest", file, "--limit", "1"]);
    assert!(
        text.text().contains("\npart 1 (polygon 1): The least maximum degree is"),
        "{}",
        text.text()
    );
    assert!(text.text().contains("all 2 parts"), "{}", text.text());
    mindeg(["suggest", file, "--max-degree", "1"]).refuses(&["part 1"]);
}

/// Advice names sides that `--intervals` takes in that order, and points that are drawn stay.
#[test]
fn a_convex_ring_keeps_its_points_and_its_side() {
    // Degree 3 takes four points, and all of these stay: there is nothing to look for.
    let ring = r#"{"ring": [[0, 0], [0.3, 0], [1.7, 0], [2.2, 0], [4, 0], [4, 3], [0, 3]]}"#;
    let answer = mindeg_reading(["suggest", "-", "--json"], ring.as_bytes()).json();
    let found = ["intervals", "least_max_degree", "suggestions", "open"].map(|key| &answer[key]);
    assert_eq!(found, [&json!([7]), &json!(4), &json!([]), &json!(null)]);
    // Rings of as many points have degree 4: each is one side, which gets points.
    let frame = r#"{"ring": [[0, 0], [4, 0], [4, 4], [0, 4]], "holes": [{"ring": [[1, 1], [1, 3], [3, 3]]}]}"#;
    let answer = mindeg_reading(["suggest", "-", "--json"], frame.as_bytes()).json();
    assert_eq!(answer["suggestions"][0]["intervals"], json!([5, 5]));
    let changes = answer["suggestions"][0]["changes"].as_array().expect("a list");
    assert!(changes.iter().all(|one| one["by"].as_i64() > Some(0)), "{changes:?}");
    // Five on one line: the formula knows a change, but of sides that the ring has not.
    let long =
        r#"{"ring": [[0, 0], [1, 0], [2, 0], [3, 0], [4, 0], [5, 0], [5, 3], [4, 3], [0, 3]]}"#;
    let degree = mindeg_reading(["degree", "-"], long.as_bytes());
    assert!(!degree.text().contains("hint: add") && !degree.text().contains("hint: take"));
}

/// Where corners run the other way round, a note says how sides count, as `mesh` does.
#[test]
fn sides_of_reversed_rings_are_told_to_count_the_other_way() {
    let clockwise = r#"{"polygon": {"corners": [[0, 0], [0, 3], [4, 3], [4, 0]]},
        "sides": [{"intervals": 9}, {"intervals": 1}, {"intervals": 2}, {"intervals": 3}]}"#;
    let hole = FRAME.replace("[1, 1], [1, 3], [3, 3], [3, 1]", "[1, 1], [3, 1], [3, 3], [1, 3]");
    for (domain, ring) in [(clockwise, "the outline"), (&hole[..], "hole 1")] {
        for command in ["degree", "suggest"] {
            let note = format!("The corners of {ring} ran ");
            let text = mindeg_reading([command, "-"], domain.as_bytes()).text().to_owned();
            let lines: Vec<_> = text.lines().filter(|line| line.starts_with(&note)).collect();
            let [line] = lines[..] else { panic!("{text}") };
            assert!(line.ends_with("and sides count from the last one as given."), "{text}");
            let answer = mindeg_reading([command, "-", "--json"], domain.as_bytes()).json();
            assert_eq!(answer["notes"], json!([line]), "{command}");
        }
    }
    // The last side as given, of 3 intervals, is side 1 indeed.
    let answer = mindeg_reading(["suggest", "-", "--json"], clockwise.as_bytes()).json();
    assert_eq!(answer["intervals"], json!([3, 2, 1, 9]));
    let right_way = FRAME.as_bytes();
    assert!(mindeg_reading(["suggest", "-", "--json"], right_way).json().get("notes").is_none());
}

/// The edges of a part of a map share the name of the two regions beside them.
#[test]
fn a_name_of_several_sides_goes_with_an_index() {
    let polygons = r#"{"type": "GeometryCollection", "geometries": [
        {"type": "Polygon", "coordinates": [[[0, 0], [400, 0], [400, 100], [400, 200], [400, 300], [0, 300], [0, 0]]]},
        {"type": "Polygon", "coordinates": [[[1000, 0], [1400, 0], [1400, 300], [1300, 300], [1200, 300], [1000, 300], [1000, 0]]]}]}"#;
    let text = mindeg_reading(["suggest", "-"], polygons.as_bytes()).text().to_owned();
    assert!(text.contains(" on side ") || text.contains(" to side "), "{text}");
    for name in ["polygon 1 | outside", "polygon 2 | outside"] {
        let unnumbered = text.replace(&format!("({name})"), "");
        assert!(text.contains(&format!("({name})")) && !unnumbered.contains(name), "{text}");
    }
}
