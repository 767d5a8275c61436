//! The words about degrees, with numbers that can be counted by hand.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use mindeg::{Domain, Goal, Progress, exact, mesh};
use mindeg_answers::words;

fn degree(domain: &str) -> String {
    let domain = Domain::from_json(domain).unwrap();
    let answer = exact::degree(&domain, Progress::NONE).unwrap();
    words::degree(&domain, &answer)
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
        [{"corners": [[1,1], [3,1], [3,3], [1,3]], "size": 0.4}]}"#;
    assert_eq!(
        degree(frame),
        "No mesh has less than 4: the 120 edges of every mesh have two ends each, at 60 vertices, so \
         that one of these\nhas 4 or more.\n\
         Degree 5 is reached by windows of a Delaunay triangulation, each triangulated anew.\n\
         Whether degree 4 is possible is not known: with holes, not all meshes are searched.\n"
    );
    let rings = Domain::from_json(frame).unwrap();
    assert_eq!(words::triangle_count(rings.rings()), 60);
}

#[test]
fn the_hint_names_the_degree_and_the_option() {
    let channel = include_str!("../../../assets/domains/boundary-layer-channel.json");
    let domain = Domain::from_json(channel).unwrap();
    let meshed = mesh(&domain, Goal::LeastDegree, Progress::NONE).unwrap();
    let min_angle = meshed.mesh.angle_range().min;
    let higher = meshed.higher_degree.unwrap();
    assert_eq!(
        words::higher_degree(min_angle, &higher),
        "Hint: degree 5 has a minimum angle of 2.010°, 16.1 times as much: add --max-degree 5"
    );
}

#[test]
fn the_words_name_the_share_that_a_mesh_keeps() {
    let text = r#"{"rectangle": {"width": 4, "height": 3}, "size": 0.5}"#;
    let domain = Domain::from_json(text).unwrap();
    let goal = Goal::KeepAngle(0.5);
    let meshed = mesh(&domain, goal, Progress::NONE).unwrap();
    let min_angle = meshed.mesh.angle_range().min;
    let share = (100.0 * min_angle / meshed.delaunay_min_angle.unwrap()).round();
    let said = words::standing(&meshed, goal, min_angle).unwrap();
    assert!(said.starts_with(&format!("It has {share}% of Delaunay's minimum angle, ")), "{said}");
    assert!(said.ends_with(". No smaller degree keeps 50%."), "{said}");
}
