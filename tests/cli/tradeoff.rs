use crate::mesh::{content, domains, text};
use crate::run::{mindeg, mindeg_reading};
use mindeg_core::{Verified, verify};
use mindeg_formats::obj;
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// The minimum angle for every degree from the first on, on a rectangle of 4 by 3 with equal spacing.
const ANGLES: [(&str, u64, &[&str]); 4] = [
    ("10,10,10,10", 4, &["2.936", "6.340"]),
    ("12,9,4,4", 5, &["5.528", "6.340"]),
    ("8,6,8,5", 4, &["5.194", "9.462"]),
    ("14,3,5,2", 5, &["5.314", "5.394", "5.413"]),
];

fn rectangle<'a>(command: &'a str, intervals: &'a str) -> Vec<&'a str> {
    vec![command, "--rectangle", "4x3", "--intervals", intervals]
}

fn keys(value: &Value) -> Vec<&String> {
    value.as_object().expect("an object").keys().collect()
}

#[test]
fn json_has_the_angle_that_each_degree_buys() {
    for (intervals, least, angles) in ANGLES {
        let answer = mindeg([rectangle("tradeoff", intervals), vec!["--json"]].concat()).json();
        assert_eq!(keys(&answer), ["advice", "advised", "angle_limit", "points"]);
        let points = answer["points"].as_array().expect("a list");
        assert_eq!(points.len(), angles.len(), "{intervals}");
        for (degree, (point, angle)) in (least..).zip(points.iter().zip(angles)) {
            assert_eq!(keys(point), ["exact", "max_degree", "min_angle", "share_of_limit"]);
            assert_eq!((&point["max_degree"], &point["exact"]), (&json!(degree), &json!(true)));
            let seen = point["min_angle"].as_f64().expect("an angle");
            assert_eq!(format!("{seen:.3}"), *angle, "{intervals}");
        }
        assert_eq!(points.last().expect("a point")["min_angle"], answer["angle_limit"]);
    }
}

#[test]
fn the_table_is_for_reading() {
    let run = mindeg(rectangle("tradeoff", "12,9,4,4"));
    assert_eq!(
        run.text(),
        "maximum degree   minimum angle  of Delaunay's\n\
         \x20            5          5.528°          87.2%\n\
         \x20            6          6.340°           100%  for a patch\n\
         \x20            7         34.600°         545.7%  with points inside\n\
         For a solver, put points inside: minimum angle 34.600°, 5.457 times what the boundary points alone allow; at \
         most 7 edges at a vertex.\n\
         For a patch that must keep its points, take degree 6: minimum angle 6.340°, all of what its points allow.\n"
    );
    assert_eq!((run.code, run.errors.as_str()), (Some(0), ""));
    // The row that is advised is that of the sentence below.
    let first = |purpose: &str| {
        let run = mindeg([rectangle("tradeoff", "12,9,4,4"), vec!["--for", purpose]].concat());
        run.text().lines().nth(1).unwrap_or_default().to_owned()
    };
    assert!(first("fewest").ends_with("87.2%  fewest edges"), "{}", first("fewest"));
    assert!(first("solver").ends_with("87.2%"), "{}", first("solver"));
}

#[test]
fn a_long_table_keeps_the_first_the_advised_and_the_last() {
    let table = |limit| {
        let run = mindeg([rectangle("tradeoff", "90,3,5,2"), vec!["--limit", limit]].concat());
        run.text().to_owned()
    };
    let all = table("0");
    let rows: Vec<&str> =
        all.lines().skip(1).filter(|row| row.contains('%') && row.starts_with(' ')).collect();
    let (inside, rows) = rows.split_last().expect("rows");
    assert!(inside.ends_with("%  with points inside"), "{all}");
    assert!(rows.len() > 5, "{all}");
    let advised =
        *rows.iter().find(|row| row.ends_with("%  for a patch")).expect("an advised degree");
    let short = table("3");
    let shown: Vec<&str> = short.lines().skip(1).collect();
    assert_eq!(shown[..3], [rows[0], advised, rows[rows.len() - 1]]);
    assert_eq!(shown[3], *inside);
    assert!(shown[4].ends_with(" points on edges, too"), "{short}");
    assert_eq!(shown[5], format!("3 of {} rows, spread evenly; --limit 0 prints all.", rows.len()));
}

#[test]
fn reports_come_in_every_format() {
    let folder = tempfile::tempdir().expect("a folder");
    let files = ["curve.html", "curve.svg", "curve.json"].map(|name| folder.path().join(name));
    let mut arguments = [rectangle("tradeoff", "14,3,5,2"), vec!["--json"]].concat();
    files.iter().for_each(|file| arguments.extend(["-o", text(file)]));
    let answer = mindeg(arguments).json();

    assert_eq!(content(folder.path()), ["curve.html", "curve.json", "curve.svg"]);
    let read = |path: &Path| fs::read_to_string(path).expect("the file was written");
    let [html, svg, figures] = files.each_ref().map(|file| read(file));
    assert_eq!(serde_json::from_str::<Value>(&figures).expect("it is JSON"), answer);
    for degree in [5, 6, 7] {
        assert!(html.contains(&format!("href=\"#degree-{degree}\"")), "{degree}");
        assert!(html.contains(&format!("id=\"degree-{degree}\"")), "{degree}");
        assert!(svg.contains(&format!(">degree {degree} · 5.")), "{degree}");
    }
    assert!(
        html.contains("script-src 'unsafe-inline'")
            && !html.contains("http://")
            && !html.contains("https://")
    );
}

/// The degrees in an OBJ, once the triangles are verified on the boundary.
fn verified(obj: &[u8], intervals: &[u64]) -> Verified {
    let mesh = obj::read(obj).expect("the OBJ reads back");
    verify(intervals, mesh.triangles().iter().copied()).expect("a triangulation")
}

#[test]
fn the_mesh_of_every_point_can_be_had() {
    for (intervals, least, angles) in ANGLES {
        let counts: Vec<u64> = intervals.split(',').map(|n| n.parse().expect("a count")).collect();
        for (degree, angle) in (least..).zip(angles) {
            let folder = tempfile::tempdir().expect("a folder");
            let file = folder.path().join("mesh.obj");
            let cap = degree.to_string();
            let mut arguments = rectangle("mesh", intervals);
            arguments.extend(["--optimize", "angle", "--json", "-o", text(&file)]);
            if degree > least {
                // Without a limit, it is the least.
                arguments.extend(["--max-degree", &cap]);
            }
            let summary = mindeg(arguments).json();
            assert_eq!(
                (&summary["max_degree"], &summary["least_max_degree"]),
                (&json!(degree), &json!(least))
            );
            let seen = summary["min_angle"].as_f64().expect("an angle");
            assert_eq!(format!("{seen:.3}"), *angle, "{intervals}");
            let obj = fs::read(&file).expect("the file was written");
            assert_eq!(u64::from(verified(&obj, &counts).max_degree), degree, "{intervals}");
        }
    }
}

#[test]
fn no_domain_loses_by_it() {
    let summary = |domain: &Path, more: &[&str]| {
        let common = ["mesh", text(domain), "-o", "/dev/null", "--format", "glb", "--json"];
        mindeg(common.iter().chain(more)).json()
    };
    for domain in domains() {
        let [plain, optimized] = [&[][..], &["--optimize", "angle"]].map(|o| summary(&domain, o));
        assert_eq!(optimized["max_degree"], plain["max_degree"], "{domain:?}");
        let angle = |summary: &Value| summary["min_angle"].as_f64().expect("an angle");
        // The solver compares values rounded to 36 bits.
        assert!(angle(&optimized) >= angle(&plain) * (1.0 - 1e-10), "{domain:?}");
    }
}

#[test]
fn caps_that_cannot_be_kept_are_refused_with_the_least_that_can() {
    let capped = |cap| {
        let optimize = ["--max-degree", cap, "-o", "x.obj"];
        mindeg(rectangle("mesh", "12,9,4,4").into_iter().chain(optimize))
    };
    capped("4").refuses(&["degree 4", "least is 5"]);
    capped("0").refuses(&["least is 5"]);
    let domain = |sides: &str| {
        format!(r#"{{"rectangle": {{"width": 4, "height": 3}}, "size": 1, "sides": [{sides}]}}"#)
    };
    let all_three = domain(r#"{"max_degree": 3}, {"max_degree": 3}, {"max_degree": 3}, {}"#);
    for command in [&["mesh", "-", "-o", "x.obj"][..], &["tradeoff", "-"]] {
        mindeg_reading(command, all_three.as_bytes())
            .refuses(&["degree limits of vertices", "raise max_degree"]);
    }
    let no_room = domain(r#"{"outside_degree": 3, "max_degree": 4}, {}, {}, {}"#);
    mindeg_reading(["tradeoff", "-"], no_room.as_bytes()).refuses(&[
        "line 1",
        "sides[0].max_degree",
        "3 outside",
        "6 or more",
    ]);
    assert!(!Path::new("x.obj").exists());
}

#[test]
fn a_gate_is_on_total_degrees() {
    let domain = br#"{"rectangle": {"width": 4, "height": 3}, "size": 1, "sides": [
        {}, {}, {"outside_degree": 3}, {}]}"#;
    let mesh = |cap: &str| {
        let arguments = [
            "mesh",
            "-",
            "-q",
            "-o",
            "-",
            "--format",
            "obj",
            "--keep-angle",
            "1%",
            "--max-degree",
            cap,
        ];
        mindeg_reading(arguments, domain)
    };
    assert_eq!(mesh("6").code, Some(0));
    let failed = mesh("5");
    assert_eq!((failed.code, failed.output.len()), (Some(3), 0));
    assert!(failed.errors.contains("6 edges, more than the maximum degree of 5"), "{failed:?}");
}

#[test]
fn what_is_too_large_for_exact_work_is_refused_with_the_way_out() {
    let large = "1025,1025,1025,1025";
    // Limits and shares are reached by windows, or by the formula; the summary says so.
    for (goal, found_by) in [
        (["--optimize", "angle"], "the formula did"),
        (["--max-degree", "6"], "of Delaunay's minimum angle"),
        (["--keep-angle", "95%"], "with 95% is not known"),
    ] {
        let to_nowhere = ["-o", "-", "--format", "obj"];
        let run = mindeg(rectangle("mesh", large).into_iter().chain(goal).chain(to_nowhere));
        assert_eq!(run.code, Some(0), "{}", run.errors);
        assert!(run.errors.contains(found_by), "{goal:?}: {}", run.errors);
    }
    // A limit that no mesh keeps is refused for that reason at any size.
    let too_low = ["--max-degree", "3", "-o", "x.obj"];
    mindeg(rectangle("mesh", large).into_iter().chain(too_low)).refuses(&["the least is 4"]);
    let capped = br#"{"rectangle": {"width": 4, "height": 3}, "size": 0.003, "sides": [
        {}, {"max_degree": 9}, {}, {}]}"#;
    mindeg_reading(["mesh", "-", "-o", "x.obj"], capped)
        .refuses(&["4096", "leave out outside_degree and max_degree"]);
    mindeg_reading(["tradeoff", "-"], capped).refuses(&["4096", "mindeg mesh"]);
    assert!(!Path::new("x.obj").exists());
    mindeg(rectangle("tradeoff", "3,3,2,2").into_iter().chain(["-o", "x.pdf"]))
        .refuses(&["x.pdf", ".html"]);
}

/// A rectangle with its lower left corner at (left, 0), meshed.
struct Plate {
    summary: Value,
    obj: Vec<u8>,
}

impl Plate {
    fn new(left: u32, intervals: [u64; 4], outside_degree: &[u32]) -> Self {
        let mut sides = intervals.map(|intervals| json!({"intervals": intervals}));
        if !outside_degree.is_empty() {
            sides[3]["outside_degree"] = json!(outside_degree);
        }
        let rectangle = json!({"width": 4, "height": 3, "origin": [left, 0]});
        let domain = json!({"rectangle": rectangle, "sides": sides}).to_string();
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("plate.obj");
        let run = mindeg_reading(["mesh", "-", "--json", "-o", text(&file)], domain.as_bytes());
        Self { summary: run.json(), obj: fs::read(&file).expect("the file was written") }
    }

    fn max_degree(&self) -> u64 {
        self.summary["max_degree"].as_u64().expect("a degree")
    }
}

/// The largest number of edges at a point of two meshes together.
fn joint_max_degree(plates: [&Plate; 2]) -> u64 {
    let mut edges = BTreeSet::new();
    for plate in plates {
        let mesh = obj::read(&plate.obj[..]).expect("the OBJ reads back");
        let point = |vertex: u32| mesh.positions()[vertex as usize].to_array().map(f64::to_bits);
        for [a, b, c] in mesh.triangles().iter().map(|triangle| triangle.map(point)) {
            edges.extend([[a, b], [b, c], [c, a]].map(|[from, to]| [from.min(to), from.max(to)]));
        }
    }
    let mut degrees = BTreeMap::new();
    for end in edges.into_iter().flatten() {
        *degrees.entry(end).or_insert(0) += 1;
    }
    degrees.into_values().max().expect("a mesh has edges")
}

#[test]
fn two_plates_keep_their_joint_maximum_when_the_second_knows_the_first() {
    for (left, right, untold, joint) in [
        ([12, 8, 5, 8], [8, 4, 8, 8], 7, 6),
        ([30, 4, 2, 2], [2, 4, 30, 4], 12, 8),
        ([6, 8, 6, 8], [6, 8, 6, 8], 6, 6),
    ] {
        let first = Plate::new(0, left, &[]);
        assert_eq!(joint_max_degree([&first, &Plate::new(4, right, &[])]), untold, "{left:?}");

        // The right side of the first runs upwards, the left side of the second downwards.
        let degrees = verified(&first.obj, &left).degrees;
        let (start, end) = (left[0] as usize, (left[0] + left[1]) as usize);
        let outside: Vec<u32> = (start..=end)
            .rev()
            .map(|vertex| degrees[vertex] - if [start, end].contains(&vertex) { 1 } else { 2 })
            .collect();
        let second = Plate::new(4, right, &outside);
        assert_eq!(second.summary["least_max_degree"], json!(joint));
        assert_eq!(second.max_degree(), joint);
        assert_eq!(joint_max_degree([&first, &second]), joint, "{left:?}");
        assert!(first.max_degree() <= joint);
    }
}

#[test]
fn single_vertices_keep_to_their_caps() {
    let domain = |vertices: &str| {
        format!(
            r#"{{"rectangle": {{"width": 4, "height": 3}}, "vertices": {vertices},
                "sides": [{{"intervals": 10}}, {{"intervals": 10}},
                          {{"intervals": 10}}, {{"intervals": 10}}]}}"#
        )
    };
    let run = |vertices: &str| {
        let arguments = ["mesh", "-", "-q", "-o", "-", "--format", "obj"];
        mindeg_reading(arguments, domain(vertices).as_bytes())
    };
    let free = verified(&run("[]").output, &[10; 4]).degrees;
    assert_eq!((free[5], free[20]), (4, 2));
    let capped = run(r#"[{"vertex": 20, "max_degree": 2}, {"vertex": 5, "max_degree": 3}]"#);
    let capped = verified(&capped.output, &[10; 4]).degrees;
    assert_eq!((capped[5], capped[20]), (3, 2));
    // Without an edge inside, a vertex would join its neighbours: on one side, that is flat.
    run(r#"[{"vertex": 5, "max_degree": 2}]"#)
        .refuses(&["vertex 5 has a max_degree of 2 and needs 3"]);
}

#[cfg(unix)]
#[test]
fn an_interrupt_leaves_nothing_behind() {
    use crate::run::{Running, hearing_signals};
    use std::os::unix::process::ExitStatusExt;
    use std::process::Stdio;
    use std::time::Duration;
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("curve.html");
    let mut command = hearing_signals(env!("CARGO_BIN_EXE_mindeg"));
    command
        .args(rectangle("tradeoff", "1000,1000,1000,1000"))
        .args(["-o", text(&file)])
        .stdout(Stdio::null());
    let mut child = Running::start(&mut command);
    std::thread::sleep(Duration::from_millis(500));
    child.send(2);
    let status = child.status();
    assert_eq!(status.signal(), Some(2));
    assert!(content(folder.path()).is_empty());
}

/// Each mesh of the page stands beside the command that makes it, and the page says how it was made.
#[test]
fn the_page_has_the_command_of_every_mesh() {
    let folder = tempfile::tempdir().expect("a folder");
    let domain = domains().into_iter().find(|path| path.ends_with("wing-panel.json"));
    let domain = domain.expect("an example");
    let page = folder.path().join("curve.html");
    let run = mindeg(["tradeoff", text(&domain), "--json", "-o", text(&page)]);
    let points = run.json()["points"].as_array().expect("points").clone();
    let page = fs::read_to_string(&page).expect("the page");
    assert!(page.contains(&format!("with <code>mindeg tradeoff {} --json", text(&domain))));
    assert!(page.contains("--interior -o wing-panel-points-inside.obj</code>"));
    // The curve has the mesh with points inside, too, and leads to it.
    assert!(page.contains("<a href=\"#points-inside\" aria-label=\"points inside: degree "));
    for point in points {
        let (degree, angle) = (&point["max_degree"], point["min_angle"].as_f64());
        let options = ["--max-degree".to_owned(), degree.to_string()];
        let command = format!(
            "<code>mindeg mesh {} {} -o wing-panel-max-degree-{degree}.obj</code>",
            text(&domain),
            options.join(" ")
        );
        assert!(page.contains(&command), "{command}");
        let out = folder.path().join("mesh.obj");
        let mut words = vec!["mesh", text(&domain), "--json", "-o", text(&out)];
        words.extend(options.iter().map(String::as_str));
        let made = mindeg(words).json();
        assert_eq!(&made["max_degree"], degree);
        // Another mesh of that angle, rounded to 36 bits, may be shown.
        let (made, angle) =
            (made["min_angle"].as_f64().expect("an angle"), angle.expect("an angle"));
        assert!((made / angle - 1.0).abs() < 1e-9, "{made} {angle}");
    }
}

/// The mesh with points inside, which comes first on the page, has degrees that no other has.
#[test]
fn the_legend_has_the_degrees_of_all_meshes_on_the_page() {
    let folder = tempfile::tempdir().expect("a folder");
    let domain = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/domains/plate-with-holes.json");
    let page = folder.path().join("curve.html");
    let run = mindeg(["tradeoff", domain, "-q", "-o", text(&page)]);
    assert_eq!(run.code, Some(0), "{run:?}");
    let page = fs::read_to_string(&page).expect("the page");
    let (_, legend) = page.split_once("<div class=\"legend\">degree ").expect("a legend");
    let (legend, _) = legend.split_once("</div>").expect("its end");
    assert!(legend.contains("</span>6</span>") && legend.contains("</span>7</span>"), "{legend}");
}

/// The mesh of the fewest edges is the one that the table has at its degree, where searches and windows find it.
#[test]
fn the_fewest_edges_of_a_domain_with_holes_are_the_first_row() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("mesh.obj").display().to_string();
    let file = format!("{}/assets/outlines/part.dxf", env!("CARGO_MANIFEST_DIR"));
    let answer = mindeg(["tradeoff", &file, "--json"]).json();
    let first = &answer["points"][0];
    let limit = first["max_degree"].to_string();
    let angle = first["min_angle"].as_f64().expect("a number");
    assert_eq!(answer["advice"]["fewest"]["max_degree"], first["max_degree"]);
    let best: &[&str] = &["--max-degree", &limit, "--optimize", "angle"];
    for options in [&["--for", "fewest"], best, &["--optimize", "angle"]] {
        let words = [&["mesh", &file, "--json", "-o", &*out], options].concat();
        let made = mindeg(words).json()["min_angle"].as_f64().expect("a number");
        assert!((made - angle).abs() < 1e-9, "{options:?}: {made} {angle}");
    }
}

/// Beyond the size of exact work a convex domain has a trade-off by windows, from the formula's least degree on.
#[test]
fn a_large_rectangle_has_a_trade_off_and_a_hint_with_figures() {
    let domain = ["--rectangle", "4x3", "--intervals", "1300,1100,1300,1100"];
    let found = mindeg([&["tradeoff"], &domain[..], &["--json"]].concat()).json();
    let points = found["points"].as_array().expect("rows");
    assert!(points.len() >= 2 && points[0]["max_degree"] == 4, "{found}");
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("mesh.obj").display().to_string();
    let run = mindeg([&["mesh"], &domain[..], &["-o", &out]].concat());
    let patch = found["advice"]["patch"]["min_angle"].as_f64().expect("an angle");
    let words = format!("take degree {}: minimum angle", found["advised"]);
    assert!(run.errors.contains(&words) && patch > 0.0, "{}", run.errors);
    let made =
        mindeg([&["mesh"], &domain[..], &["--optimize", "angle", "-o", &out, "--json"]].concat());
    let angle = |value: &serde_json::Value| value["min_angle"].as_f64().expect("an angle");
    assert!((angle(&made.json()) - angle(&points[0])).abs() < 1e-9, "{found}");
}
