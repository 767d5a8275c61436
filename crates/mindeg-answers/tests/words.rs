//! The words about degrees, with numbers that can be counted by hand.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use mindeg::{Domain, Goal, Progress, mesh};
use mindeg_answers::degree::{DegreeProof, DegreeReport};
use mindeg_answers::{mesh as words, numbers};

fn report(domain: &str) -> DegreeReport {
    DegreeReport::of(&Domain::from_json(domain).unwrap(), Progress::NONE).unwrap()
}

fn degree(domain: &str) -> String {
    report(domain).words
}

#[test]
fn every_proof_has_its_name_and_its_places() {
    let rectangle = r#"{"rectangle": {"width": 4, "height": 3}, "size": 0.5}"#;
    let DegreeReport { certificate, at_least, reached, .. } = report(rectangle);
    assert!(matches!(certificate, DegreeProof::BalancedCut { .. }));
    assert_eq!((at_least, reached), (4, 4), "the formula has both, too");
    let limited = r#"{"rectangle": {"width": 4, "height": 3}, "size": 0.5,
        "vertices": [{"vertex": 0, "outside_degree": 9}]}"#;
    let DegreeReport { certificate, at_least, .. } = report(limited);
    assert!(matches!(certificate, DegreeProof::Counting) && at_least == 11);

    // An L, in which a zig-zag of degree 4 needs chords beyond it.
    let bent = r#"{"polygon": {"corners": [[0,0],[4,0],[4,2],[2,2],[2,4],[0,4]]}, "sides": [
        {"intervals": 13}, {"intervals": 6}, {"intervals": 6}, {"intervals": 6},
        {"intervals": 6}, {"intervals": 13}]}"#;
    let certificate = report(bent).certificate;
    assert!(matches!(certificate, DegreeProof::BlockedZigZags { chords } if chords.len() == 50));

    // A U: few vertices see the 60 intervals of its floor.
    let deep = r#"{"polygon": {"corners": [[0,0],[6,0],[6,4],[4,4],[4,2],[2,2],[2,4],[0,4]]},
        "sides": [{"intervals": 2}, {"intervals": 2}, {"intervals": 2}, {"intervals": 2},
        {"intervals": 60}, {"intervals": 2}, {"intervals": 2}, {"intervals": 2}]}"#;
    let DegreeReport { certificate, reached, .. } = report(deep);
    assert_eq!(reached, 23);
    assert!(matches!(certificate, DegreeProof::Apexes { apexes, .. } if !apexes.is_empty()));
}

#[test]
fn the_sides_of_the_formula_are_explained_where_they_are_others() {
    let is_explained = |domain: &str| degree(domain).contains("Sides on one line count as one");
    assert!(!is_explained(r#"{"rectangle": {"width": 4, "height": 3}, "size": 0.5}"#));
    let halved = r#"{"polygon": {"corners": [[0,0],[2,0],[4,0],[4,3],[0,3]]}, "size": 0.5}"#;
    assert!(is_explained(halved));
    // As many sides, but others: one fewer below, and one more of the arc's two edges.
    let arched = r#"{"polygon": {"corners": [[2,0],[4,0],[4,3],[0,3],[0,0]]}, "size": 0.5,
        "sides": [{}, {}, {"intervals": 2, "arc": {"through": [2, 4]}}, {}, {}]}"#;
    assert!(is_explained(arched));
}

#[test]
fn the_reasons_have_the_numbers_of_the_domain() {
    let bent = |counts: [u32; 6]| {
        let sides = counts.map(|count| format!(r#"{{"intervals": {count}}}"#)).join(", ");
        let corners = "[[0,0], [4,0], [4,2], [2,2], [2,4], [0,4]]";
        degree(&format!(r#"{{"polygon": {{"corners": {corners}}}, "sides": [{sides}]}}"#))
    };
    // 69 triangles: 71 edges and 68 chords.
    assert_eq!(
        degree(include_str!("../../../assets/domains/l-bracket.json")),
        "No mesh has less than 4: the 139 edges of every mesh have two ends each, at 71 vertices, so \
         that one of these\nhas 4 or more.\n\
         Degree 4 is reached by the zig-zag from vertex 20 on.\n"
    );
    let words = bent([13, 6, 6, 6, 6, 13]);
    assert!(
        words.starts_with(
            "No mesh has less than 5: from 7 vertices on, a mesh of degree 4 is one of 50 zig-zags"
        ),
        "{words}"
    );
    // The triangles of a ring are as many as its vertices.
    let frame = r#"{"polygon": {"corners": [[0,0], [4,0], [4,4], [0,4]]}, "size": 0.4, "holes":
        [{"corners": [[1,1], [1,3], [3,3], [3,1]], "size": 0.4}]}"#;
    assert_eq!(
        degree(frame),
        "No mesh has less than 5: with a hole, a mesh of degree 4 is a strip between two rings of as many \
         vertices,\nand no strip here lies inside (theorem 21 of docs/theory.md).\n\
         Degree 5 is reached by windows of a Delaunay triangulation, each triangulated anew.\n"
    );
    assert!(
        degree(r#"{"ring": [[0, -4112], [25, 625], [-22, 484]], "holes": [
            {"ring": [[5, -1856], [3, -2013], [4, -1392], [10, -1980]]},
            {"ring": [[17, -494], [12, 120], [15, 86], [15, 63], [14, -14]]}]}"#)
        .starts_with(
            "No mesh has less than 6: degree 5 is refuted by 2 clauses, checked\n(theorem 23 of docs/theory.md).\n"
        )
    );
    let rings = Domain::from_json(frame).unwrap();
    assert_eq!(rings.rings().triangle_count(), 60);
}

#[test]
fn the_words_name_the_share_that_a_mesh_keeps() {
    let text = r#"{"rectangle": {"width": 4, "height": 3}, "size": 0.5}"#;
    let domain = Domain::from_json(text).unwrap();
    let goal = Goal::KeepAngle(0.5);
    let meshed = mesh(&domain, goal, Progress::NONE).unwrap();
    let min_angle = meshed.mesh.angle_range().min;
    let share = numbers::percent(min_angle / meshed.delaunay_min_angle.unwrap());
    let said = words::standing(&meshed, goal, min_angle).unwrap();
    assert!(said.starts_with(&format!("It has {share} of Delaunay's minimum angle, ")), "{said}");
    assert!(said.ends_with(". No smaller degree keeps 50%."), "{said}");
}
