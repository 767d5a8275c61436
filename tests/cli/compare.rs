use crate::mesh::{content, domains, text};
use crate::run::mindeg;
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
    assert!(run.errors.contains("114"), "the verdict is on standard error: {run:?}");
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

#[test]
fn gates_look_at_the_least_degree_mesh_once_the_report_is_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let report = folder.path().join("report.json");
    let run = |gate: &[&str]| {
        let plate = ["compare", "--rectangle", "4x3", "--intervals", "12,9,4,4", "-q", "-o"];
        mindeg(plate.iter().chain(&[text(&report)]).chain(gate))
    };
    let failed = run(&["--fail-above-degree", "4"]);
    assert_eq!(failed.code, Some(3), "{failed:?}");
    assert!(failed.errors.contains("has 5 edges"), "{failed:?}");
    assert!(report.exists());
    assert_eq!(run(&["--fail-above-degree", "5", "--fail-below-angle", "1"]).code, Some(0));
    assert_eq!(run(&["--fail-below-angle", "30"]).code, Some(3));
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
