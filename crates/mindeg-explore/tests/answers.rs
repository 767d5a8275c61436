//! Answers without sockets: what comes, in which order, and what is refused.

use std::cell::Cell;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};
use std::time::Instant;

use mindeg::{Domain, Goal, Progress, mesh};
use mindeg_explore::{KnownFiles, answer, presets};
use serde_json::{Value, json};

/// The lines of an answer.
fn lines(request: &Value) -> Vec<Value> {
    lines_of(request.to_string().as_bytes())
}

fn lines_of(body: &[u8]) -> Vec<Value> {
    let mut lines = Vec::new();
    let mut out = |line: &_| lines.push(serde_json::to_value(line).unwrap());
    answer(body, &KnownFiles::default(), Progress::NONE, &mut out).unwrap();
    lines
}

fn kinds(lines: &[Value]) -> Vec<&str> {
    lines.iter().map(|line| line["kind"].as_str().unwrap()).collect()
}

/// The last mesh of a view.
fn view<'a>(lines: &'a [Value], view: &str) -> &'a Value {
    let is_it = |line: &&Value| line["kind"] == "mesh" && line["view"] == view;
    let mesh = lines.iter().rfind(is_it).unwrap();
    assert_eq!(mesh["is_last"], true);
    mesh
}

fn preset(name: &str) -> Value {
    let preset = presets().into_iter().find(|preset| preset.name == name).unwrap();
    serde_json::from_str(preset.domain.unwrap().get()).unwrap()
}

#[test]
fn the_channel_shows_why_degree_5_beats_degree_4() {
    let goal = json!({"keep_angle": 0.95});
    let domain = preset("boundary-layer-channel");
    let lines = lines(&json!({"domain": domain, "goal": goal, "color": "min_angle"}));
    assert_eq!(lines[0]["kind"], "domain");
    assert_eq!(lines[0]["vertices"], 112);
    assert_eq!(kinds(&lines).last(), Some(&"done"));
    assert!(!kinds(&lines).contains(&"refused"));
    let figures = ["least", "wanted", "delaunay"].map(|name| {
        let mesh = view(&lines, name);
        (mesh["max_degree"].as_u64().unwrap(), mesh["min_angle"].as_f64().unwrap())
    });
    assert_eq!(figures.map(|(degree, _)| degree), [4, 5, 13]);
    for ((_, angle), expected) in figures.into_iter().zip([0.125, 2.010, 2.073]) {
        assert!((angle - expected).abs() < 5e-4, "{angle}");
    }
    let curve = lines.iter().find(|line| line["kind"] == "curve").unwrap();
    assert_eq!((&curve["advised"], &curve["points"][0]["exact"]), (&json!(5), &json!(true)));
}

#[test]
fn meshes_are_those_of_the_library() {
    for (name, goal, wanted) in [
        ("l-bracket", Goal::LeastDegree, json!("least_degree")),
        ("wing-panel", Goal::KeepAngle(0.9), json!({"keep_angle": 0.9})),
        ("step-channel", Goal::MaxDegree(6), json!({"max_degree": 6})),
    ] {
        let domain = preset(name);
        let lines = lines(&json!({"domain": domain, "goal": wanted, "show": ["wanted"]}));
        let domain = Domain::from_json(&domain.to_string()).unwrap();
        let mesh = mesh(&domain, goal, Progress::NONE).unwrap().mesh;
        let bytes: Vec<u8> = mesh.triangles().flatten().flat_map(u32::to_le_bytes).collect();
        let shown = view(&lines, "wanted");
        assert_eq!(shown["triangles"], base64(&bytes), "{name}");
        assert_eq!(shown["max_degree"], mesh.max_total_degree());
        let degrees: Vec<u8> = (0..mesh.vertex_count())
            .flat_map(|vertex| mesh.total_degree(vertex).to_le_bytes())
            .collect();
        assert_eq!(shown["degrees"], base64(&degrees), "{name}");
    }
}

fn base64(bytes: &[u8]) -> String {
    use base64::Engine;
    base64::engine::general_purpose::STANDARD.encode(bytes)
}

#[test]
fn every_preset_has_every_answer() {
    let show = [
        "wanted",
        "least",
        "delaunay",
        "interior",
        "degree",
        "limit",
        "curve",
        "suggestions",
        "command",
    ];
    for preset in presets() {
        let domain: Value = serde_json::from_str(preset.domain.unwrap().get()).unwrap();
        let lines = lines(&json!({"domain": domain, "show": show, "color": "shape"}));
        let kinds = kinds(&lines);
        for kind in ["degree", "limit", "curve", "suggestions", "command", "done"] {
            assert!(kinds.contains(&kind), "{}: no {kind}", preset.name);
        }
        assert!(!kinds.contains(&"refused"), "{}: {lines:?}", preset.name);
        let interior = view(&lines, "interior");
        let triangles = interior["bars"]["counts"].as_array().unwrap();
        let count: u64 = triangles.iter().map(|count| count.as_u64().unwrap()).sum();
        assert_eq!(
            interior["triangles"].as_str().unwrap().len() as u64,
            (12 * count).div_ceil(3) * 4
        );
    }
}

#[test]
fn suggestions_lead_to_what_they_promise() {
    let domain = json!({
        "rectangle": {"width": 4, "height": 3},
        "sides": [{"intervals": 12}, {"intervals": 9}, {"intervals": 4}, {"intervals": 4}]
    });
    let lines = lines(&json!({"domain": domain, "show": ["suggestions", "degree"]}));
    let all = lines.iter().find(|line| line["kind"] == "suggestions").unwrap();
    let all = all["suggestions"].as_array().unwrap();
    assert_eq!(all[0]["words"], "Add 2 to side 2: degree 4");
    for suggestion in all {
        let lines =
            self::lines(&json!({"domain": suggestion["domain"], "show": ["degree", "limit"]}));
        let of = |kind: &str| lines.iter().find(|line| line["kind"] == kind).unwrap();
        if let Some(degree) = suggestion["max_degree"].as_u64() {
            assert_eq!(of("degree")["at_least"], degree);
        }
        if let Some(angle) = suggestion["min_angle"].as_f64() {
            assert!((of("limit")["angle_limit"].as_f64().unwrap() - angle).abs() < 1e-9);
        }
    }
}

#[test]
fn what_is_refused_says_why_and_where() {
    let refusal = |body: &str| {
        let lines = lines_of(body.as_bytes());
        assert_eq!(kinds(&lines), ["refused"], "{body}");
        (lines[0]["message"].as_str().unwrap().to_owned(), lines[0]["path"].clone())
    };
    for (body, words) in [
        ("", "the request is not what the page sends"),
        ("[]", "the request is not what the page sends"),
        (r#"{"domain": {}, "gaol": 1}"#, "unknown field `gaol`"),
        (r#"{"domain": {}, "goal": {"keep_angle": 1.5}}"#, "give a share from 0 to 1"),
        (r#"{"domain": {}, "color": "beauty"}"#, "no measure is called \"beauty\""),
        (r#"{"domain": {}, "format": "exe"}"#, "no format \"exe\" is written here"),
        (r#"{"domain": {"rectangle": {"width": 4, "height": 3}, "size": 1e-8}}"#, "at most 100000"),
        // A domain that is not convex would store its points.
        (
            r#"{"domain": {"polygon": {"corners": [[0,0],[4,0],[1,1],[0,4]]}, "size": 1e-7}}"#,
            "at most 100000",
        ),
    ] {
        let (message, _) = refusal(body);
        assert!(message.contains(words), "{message}");
    }
    let body = r#"{"domain": {"rectangle": {"width": 4, "hight": 3}, "size": 1}}"#;
    assert_eq!(refusal(body).1, "rectangle.hight");
    let deep = format!(r#"{{"domain": {}"#, "[".repeat(100_000));
    refusal(&deep);
}

#[test]
fn impossible_parts_leave_the_others() {
    let domain = json!({"rectangle": {"width": 4, "height": 3}, "size": 1});
    let request =
        json!({"domain": domain, "goal": {"max_degree": 3}, "show": ["wanted", "degree"]});
    let lines = lines(&request);
    let refused = lines.iter().find(|line| line["kind"] == "refused").unwrap();
    assert_eq!(refused["part"], "wanted");
    assert!(kinds(&lines).contains(&"degree"));
    assert_eq!(kinds(&lines).last(), Some(&"done"));
}

#[test]
fn the_first_mesh_comes_before_the_exact_one() {
    let domain = json!({"rectangle": {"width": 4, "height": 3}, "size": 0.1});
    let request = json!({"domain": domain, "goal": {"keep_angle": 0.95}, "show": ["wanted"]});
    let lines = lines(&request);
    let meshes: Vec<_> = lines.iter().filter(|line| line["kind"] == "mesh").collect();
    assert_eq!(kinds(&lines), ["domain", "mesh", "mesh", "done"]);
    assert_eq!([&meshes[0]["is_last"], &meshes[1]["is_last"]], [false, true]);
}

#[test]
fn a_cancelled_answer_stops_within_the_step() {
    let domain = json!({"rectangle": {"width": 4, "height": 3}, "size": 0.02});
    let body = json!({"domain": domain, "goal": {"keep_angle": 0.95}}).to_string();
    for most in [0, 3, 20] {
        let steps = AtomicU32::new(0);
        let callback = |_: mindeg_mesh::Step<'_>| match steps.fetch_add(1, Relaxed) < most {
            true => ControlFlow::Continue(()),
            false => ControlFlow::Break(()),
        };
        let is_done = Cell::new(false);
        let mut out = |line: &mindeg_explore::AnswerLine| {
            is_done.set(matches!(line, mindeg_explore::AnswerLine::Done { .. }));
        };
        let progress = Progress::new(&callback);
        let answered = answer(body.as_bytes(), &KnownFiles::default(), progress, &mut out);
        assert!(answered.is_err());
        assert!(!is_done.get());
    }
}

#[test]
fn only_what_is_asked_for_comes() {
    let plate = |size: f64| json!({"rectangle": {"width": 4, "height": 3}, "size": size});
    let (small, large) = (plate(0.5), plate(0.01));
    let (least, keep) = (json!("least_degree"), json!({"keep_angle": 0.9}));
    for (domain, goal, show, expected) in [
        // A mesh for now, then the mesh of the best angle.
        (&small, &least, &["wanted"][..], &["mesh"; 2][..]),
        (&small, &keep, &["least"], &["mesh"; 2]),
        (&small, &least, &["wanted", "least"], &["mesh"; 4]),
        // The formula has no other.
        (&large, &least, &["wanted"], &["mesh"]),
        (&large, &least, &["wanted", "least"], &["mesh"; 2]),
        (&small, &keep, &["delaunay"], &["mesh"]),
        (&small, &keep, &["curve"], &["curve"]),
        (&small, &keep, &["command"], &["command"]),
        (&small, &keep, &[], &[]),
    ] {
        let lines = lines(&json!({"domain": domain, "goal": goal, "show": show}));
        let expected = [&["domain"], expected, &["done"]].concat();
        assert_eq!(kinds(&lines), expected, "{domain} {goal} {show:?}");
        // The answer lacks Delaunay's mesh, but gives its degree.
        if let Some(curve) = lines.iter().find(|line| line["kind"] == "curve") {
            assert!(curve["delaunay_max_degree"].is_u64(), "{curve}");
        }
    }
}

#[test]
fn an_answer_takes_no_longer_than_whoever_waits_for_it() {
    let start = Instant::now();
    let lines = lines(&json!({"domain": preset("gusset"), "show": ["command"]}));
    let told = lines.last().unwrap()["milliseconds"].as_f64().unwrap();
    assert!(told > 0.0 && told <= 1e3 * start.elapsed().as_secs_f64(), "{told}");
}

/// The corners of a regular polygon.
fn regular(corners: u32) -> Vec<[f64; 2]> {
    let turn = |i: u32| std::f64::consts::TAU * f64::from(i) / f64::from(corners);
    (0..corners).map(|i| [turn(i).cos(), turn(i).sin()]).collect()
}

/// The mesh with points inside is too large for the page, which says what to do before it searches others.
#[test]
fn of_a_huge_boundary_what_to_do_comes_first() {
    let request = json!({
        "domain": {"ring": regular(60_000)}, "view": "interior", "show": ["interior", "least", "command"]
    });
    let lines = lines(&request);
    assert_eq!(kinds(&lines)[..4], ["domain", "command", "refused", "mesh"]);
    assert_eq!(lines[2]["part"], "interior");
    let message = lines[2]["message"].as_str().unwrap();
    assert!(message.contains("more than the page shows. The command on this page"), "{message}");
}

#[test]
fn what_is_looked_at_comes_first_and_never_as_another_mesh() {
    let interior = json!({});
    let request = json!({
        "domain": {"ring": regular(500), "interior": interior}, "view": "interior", "show": ["interior", "least"]
    });
    let lines = lines(&request);
    let meshes: Vec<&Value> = lines.iter().filter(|line| line["kind"] == "mesh").collect();
    for (mesh, is_last) in meshes.iter().zip([false, true]) {
        assert_eq!((&mesh["view"], &mesh["is_last"]), (&json!("interior"), &json!(is_last)));
        assert_ne!(mesh["interior_points"], "");
    }
    assert_eq!(meshes[2]["view"], "least");
}

#[test]
fn drafts_alone_are_the_first_meshes_of_the_whole_answer() {
    let domain = json!({"rectangle": {"width": 4, "height": 3}, "size": 0.25});
    for goal in [json!("least_degree"), json!({"keep_angle": 0.95})] {
        let mut request = json!({
            "domain": domain, "goal": goal, "view": "interior", "show": ["interior", "wanted", "advice", "curve"],
        });
        let whole = lines(&request);
        request["drafts_only"] = json!(true);
        let drafts = lines(&request);
        assert_eq!(kinds(&drafts), ["domain", "mesh", "mesh", "done"]);
        for name in ["interior", "wanted"] {
            let first = |lines: &[Value]| {
                let is_it = |line: &&Value| line["kind"] == "mesh" && line["view"] == name;
                let mut mesh = lines.iter().find(is_it).cloned().unwrap();
                // What follows is another one.
                mesh["words"].take();
                mesh
            };
            assert_eq!(first(&drafts), first(&whole), "{name}");
        }
    }
}

#[test]
fn a_draft_of_many_points_has_fewer_inside() {
    let domain = json!({"rectangle": {"width": 4, "height": 2}, "size": 0.03});
    let mut request = json!({"domain": domain, "view": "interior", "show": ["interior"]});
    let vertices = |request: &Value| {
        let lines = lines(request);
        let mesh = lines.iter().find(|line| line["kind"] == "mesh").unwrap();
        assert_eq!(mesh["is_last"], false);
        mesh["degree_bars"].as_array().unwrap().iter().map(|bar| bar[1].as_u64().unwrap()).sum()
    };
    let first: u64 = vertices(&request);
    request["drafts_only"] = json!(true);
    let draft: u64 = vertices(&request);
    assert!(first > 9000 && (600..1500).contains(&draft), "{first} and {draft} vertices");
}
