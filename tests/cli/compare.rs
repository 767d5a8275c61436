use crate::mesh::{content, domains, text};
use crate::run::{mindeg, mindeg_reading};
use mindeg_core::verify;
use mindeg_formats::obj;
use serde_json::Value;
use std::fs;
use std::path::Path;

#[test]
fn a_report_comes_in_every_format() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name);
    let [html, json, markdown] = ["report.html", "report.json", "report.md"].map(file);
    let run = mindeg([
        "compare",
        "--rectangle",
        "4x3",
        "--intervals",
        "1000,3,5,2",
        "-o",
        text(&html),
        "-o",
        text(&json),
        "-o",
        text(&markdown),
    ]);
    assert_eq!(run.code, Some(0), "{run:?}");
    assert!(
        run.errors.contains("take degree 137: minimum angle 0.07139°"),
        "the verdict is on standard error: {run:?}"
    );
    assert_eq!(content(folder.path()), ["report.html", "report.json", "report.md"]);

    let read = |path: &Path| fs::read_to_string(path).expect("the report was written");
    assert!(read(&html).starts_with("<!doctype html>"));
    assert!(read(&markdown).contains("| "));
    let report: Value = serde_json::from_str(&read(&json)).expect("the report is JSON");
    let methods = report["methods"].as_array().expect("a list");
    assert_eq!(methods[0]["name"], "mindeg");
    assert_eq!(methods[0]["max_degree"], 114);
    for method in methods {
        for key in [
            "name",
            "max_degree",
            "degree_histogram",
            "min_angle",
            "max_angle",
            "metrics",
            "valid",
            "defects",
            "seconds",
        ] {
            assert!(method.get(key).is_some(), "{key} of {}", method["name"]);
        }
    }
    assert!(report["verdict"].is_string() && report["domain"].is_object());
}

/// Angles have three decimals, those below a tenth of a degree four digits; times have one unit.
#[test]
fn every_table_of_a_report_has_the_same_digits() {
    let folder = tempfile::tempdir().expect("a folder");
    let [report, curve] = ["report.html", "curve.html"].map(|name| folder.path().join(name));
    mindeg(["compare", "assets/domains/plate-with-holes.json", "--interior", "-o", text(&report)]);
    mindeg(["tradeoff", "assets/domains/wing-panel.json", "-o", text(&curve)]);
    for page in [report, curve].map(|path| fs::read_to_string(path).expect("a report")) {
        let cells = page.split("</td>").filter_map(|cell| Some(cell.rsplit_once('>')?.1));
        let angles: Vec<&str> = cells.filter_map(|cell| cell.strip_suffix('°')).collect();
        assert!(angles.len() > 7, "{angles:?}");
        for angle in angles {
            let decimals = angle.split_once('.').map_or(0, |(_, decimals)| decimals.len());
            assert!(decimals == 3 || angle.starts_with("0.0"), "{angle}");
        }
        assert!(!page.contains("µs"));
    }
}

#[test]
fn the_curve_of_a_report_has_the_mesh_with_points_inside() {
    let folder = tempfile::tempdir().expect("a folder");
    let report = folder.path().join("report.html");
    mindeg(["compare", "assets/domains/l-bracket.json", "-o", text(&report)]);
    let page = fs::read_to_string(report).expect("a report");
    let (_, curve) = page.split_once("<svg class=\"plot").expect("a curve");
    let (curve, _) = curve.split_once("</svg>").expect("it ends");
    assert!(curve.contains("points inside: degree "), "{curve}");
}

/// Pages told what points on edges bring, and no command that puts them there.
#[test]
fn points_on_edges_stand_beside_their_command() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name).display().to_string();
    let domain = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/domains/boundary-layer-channel.json");
    let [page, report, curve] = ["page.html", "report.md", "curve.html"].map(at);
    assert_eq!(mindeg(["compare", domain, "-o", &page, "-o", &report]).code, Some(0));
    assert_eq!(mindeg(["tradeoff", domain, "-o", &curve]).code, Some(0));
    let command = format!("mindeg mesh {domain} --interior --condition -o ");
    for file in [page, report, curve] {
        let read = fs::read_to_string(&file).expect("a report");
        let told = "have 14 points more, condition it: minimum angle 40.316°";
        assert!(read.contains(told) && read.contains(&command), "{file}");
    }
    let out = at("mesh.obj");
    let made = mindeg(["mesh", domain, "--interior", "--condition", "--json", "-o", &out]).json();
    let angle = made["min_angle"].as_f64().expect("an angle");
    assert_eq!(format!("{angle:.3}"), "40.316");
}

#[test]
fn many_domains_make_a_folder_with_an_index() {
    let folder = tempfile::tempdir().expect("a folder");
    let bad = folder.path().join("bad.json");
    fs::write(&bad, r#"{"rectangle": {"width": 0, "height": 1}, "size": 1}"#).expect("a file");
    let out = folder.path().join("out");
    let target = format!("{}/", text(&out));
    let domains = domains();
    let files = domains.iter().map(|path| text(path)).chain([text(&bad)]);
    let run = mindeg(["compare", "-o", &target].into_iter().chain(files));

    assert_eq!(run.code, Some(2), "{run:?}");
    assert!(run.errors.contains("1 of 9 domains"), "{run:?}");
    let mut pages: Vec<String> = domains
        .iter()
        .map(|path| path.file_stem().expect("a name").to_string_lossy().into_owned() + ".html")
        .chain(["index.html".to_owned()])
        .collect();
    pages.sort();
    assert_eq!(content(&out), pages);
    let index = fs::read_to_string(out.join("index.html")).expect("the index was written");
    for page in pages.iter().filter(|page| *page != "index.html") {
        assert!(index.contains(&format!("href=\"{page}\"")), "{page}");
    }
    assert!(index.contains("width"), "the index says what is wrong with bad.json");
}

/// It was read twice, and the second time it was empty.
#[test]
fn standard_input_makes_a_folder_too() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = text(&folder.path().join("out")).to_owned() + "/";
    let domain = br#"{"rectangle": {"width": 4, "height": 3}, "size": 1}"#;
    let run = mindeg_reading(["compare", "-", "-o", &out], domain);
    assert_eq!(run.code, Some(0), "{run:?}");
    assert_eq!(content(Path::new(&out)), ["domain.html", "index.html"]);
}

#[test]
fn what_cannot_be_read_or_written_in_a_folder_ends_with_1() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| text(&folder.path().join(name)).to_owned();
    let small = r#"{"rectangle": {"width": 4, "height": 3}, "size": 1}"#;
    fs::write(path("small.json"), small).expect("a file");
    fs::write(path("bad.json"), "{").expect("a file");
    let compare = |files: &[&str], out: &str| {
        let files = files.iter().map(|file| path(file));
        mindeg(["compare".to_owned(), "-o".to_owned(), path(out)].into_iter().chain(files))
    };
    let missing = compare(&["none.json", "small.json"], "out/");
    assert_eq!(missing.code, Some(1), "{missing:?}");
    assert!(missing.errors.contains("1 of 2 domains") && missing.errors.contains("cannot read"));
    fs::create_dir_all(path("taken/small.html")).expect("a folder");
    let taken = compare(&["small.json"], "taken/");
    assert_eq!(taken.code, Some(1), "{taken:?}");
    assert!(taken.errors.contains("it is a folder"), "{taken:?}");
    assert_eq!(compare(&["bad.json", "small.json"], "out/").code, Some(2));
    assert_eq!(compare(&["bad.json", "none.json"], "out/").code, Some(1));
    assert_eq!(compare(&["small.json"], "out/").code, Some(0));
    compare(&["small.json", "../x/Small.json"], "out/").refuses(&["another Small.html"]);
}

#[test]
fn a_report_goes_to_standard_output() {
    let plate = ["compare", "--rectangle", "4x3", "--intervals", "12,9,4,4"];
    let run = |more: &[&str]| mindeg(plate.iter().chain(more));
    let report = run(&["--json"]);
    assert_eq!(report.json()["methods"][0]["name"], "mindeg");
    assert!(report.errors.contains("Delaunay"), "{report:?}");
    let same = run(&["-o", "-", "--format", "json", "-q"]);
    assert_eq!(
        (same.json()["verdict"].clone(), same.errors.as_str()),
        (report.json()["verdict"].clone(), "")
    );
    assert!(run(&["-o", "-", "--format", "html"]).text().starts_with("<!doctype html>"));
    assert!(run(&["-o", "-", "--format", "md"]).text().contains("| "));
    run(&["-o", "-", "--format", "md", "--json"]).refuses(&["standard output takes one report"]);
    run(&["-o", "/tmp/", "--json"]).refuses(&["/tmp/ is a folder", "no --json"]);
}

#[test]
fn every_method_s_mesh_is_saved() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| text(&folder.path().join(name)).to_owned();
    let plate = ["compare", "--rectangle", "4x3", "--intervals", "12,9,4,4"];
    let (report, meshes) = (path("report.json"), path("meshes"));
    let run = mindeg(plate.iter().chain(&["-o", &report, "--save-meshes", &meshes]));
    assert_eq!(run.code, Some(0), "{run:?}");
    // A fan from a vertex of this plate would have flat triangles: that method gives no mesh.
    let names = [
        "delaunay",
        "ear-clipping",
        "exact-degree-5",
        "exact-degree-6",
        "mindeg-points-inside",
        "mindeg",
    ];
    assert_eq!(content(Path::new(&meshes)), names.map(|name| format!("{name}.obj")));
    assert!(run.errors.contains("wrote ") && run.errors.contains("exact-degree-6.obj"), "{run:?}");
    let report = fs::read_to_string(report).expect("it is there");
    let report: Value = serde_json::from_str(&report).expect("it is JSON");
    let methods = report["methods"].as_array().expect("a list");
    assert_eq!(methods.len(), 7);
    for method in methods.iter().filter(|method| !method["max_degree"].is_null()) {
        let name = method["name"].as_str().expect("a name");
        let file = name.to_lowercase().replace(", ", "-").replace(' ', "-");
        let mesh = fs::read(folder.path().join("meshes").join(file + ".obj")).expect(name);
        let mesh = obj::read(&mesh[..]).expect("the OBJ reads back");
        assert_eq!(mesh.groups()[0].name, name.replace(' ', "_"));
        if name == "mindeg, points inside" {
            assert!(mesh.positions().len() > 29, "{name}");
            continue;
        }
        let verified = verify(&[12, 9, 4, 4], mesh.triangles().iter().copied()).expect(name);
        assert_eq!(u64::from(verified.max_degree), method["max_degree"], "{name}");
    }

    // With a folder of reports, each domain has its own.
    let domains = ["figure-1.json", "gusset.json"]
        .map(|name| text(&domains()[0].with_file_name(name)).to_owned());
    let (pages, meshes) = (path("pages/"), path("all"));
    let arguments =
        ["compare", &domains[0], &domains[1], "-q", "-o", &pages, "--save-meshes", &meshes];
    let run = mindeg(arguments);
    assert_eq!(run.code, Some(0), "{run:?}");
    assert_eq!(content(Path::new(&meshes)), ["figure-1", "gusset"]);
    assert!(Path::new(&meshes).join("gusset/delaunay.obj").exists());
}

#[test]
fn gates_look_at_the_least_degree_mesh_once_the_report_is_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let report = folder.path().join("report.json");
    let run = |gate: &[&str]| {
        let plate = ["compare", "--rectangle", "4x3", "--intervals", "12,9,4,4", "-q", "-o"];
        mindeg(plate.iter().chain(&[text(&report)]).chain(gate))
    };
    let failed = run(&["--max-degree", "4"]);
    assert_eq!(failed.code, Some(3), "{failed:?}");
    assert!(failed.errors.contains("has 5 edges"), "{failed:?}");
    assert!(report.exists());
    assert_eq!(run(&["--max-degree", "5", "--target-angle", "1"]).code, Some(0));
    assert_eq!(run(&["--target-angle", "30"]).code, Some(3));
}

#[test]
fn bad_input_is_refused() {
    let size = ["compare", "--rectangle", "4x3", "--size", "1"];
    let with = |more: &[&str]| mindeg(size.iter().chain(more));
    with(&["-o", "x.pdf"]).refuses(&["x.pdf", ".html"]);
    with(&["-o", "x.html", "--time-limit", "-1"]).refuses(&["time-limit"]);
    with(&["-o", "x.html", "-o", "/tmp/"]).refuses(&["/tmp/", "folder"]);
    mindeg(["compare", "a.json", "b.json", "-o", "x.html"]).refuses(&["folder"]);
    mindeg(["compare", "-o", "x.html"]).refuses(&["domain"]);
    assert!(!Path::new("x.html").exists());
}
