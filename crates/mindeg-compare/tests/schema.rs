//! The published schema of `report.json` is that of the types, and holds for real reports.
#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use mindeg::{Domain, Side};
use mindeg_compare::{CompareOptions, compare, report_schema};
use serde_json::{Value, json};
use std::time::Duration;

const PUBLISHED: &str = include_str!("../../../docs/report.schema.json");

fn published() -> Value {
    serde_json::from_str(PUBLISHED).unwrap()
}

fn report(sides: [u64; 3], time_limit: Duration) -> Value {
    let corners = [[0.0, 0.0], [4.0, 0.0], [1.0, 3.0]].map(glam::DVec2::from).to_vec();
    let domain = Domain::polygon(corners, sides.map(Side::count).to_vec()).unwrap();
    let comparison =
        compare(&domain, &CompareOptions { time_limit, ..CompareOptions::default() }).unwrap();
    serde_json::to_value(comparison.report()).unwrap()
}

#[test]
fn the_published_schema_is_that_of_the_types() {
    assert!(
        published() == serde_json::from_str::<Value>(&report_schema()).unwrap(),
        "docs/report.schema.json is out of date; run\n\
         cargo run -p mindeg-compare --example report_schema > docs/report.schema.json"
    );
}

#[test]
fn reports_hold_to_it() {
    jsonschema::meta::validate(&published()).unwrap();
    let validator = jsonschema::validator_for(&published()).unwrap();
    let minute = Duration::from_secs(60);
    // A plain one; one in which the fan is missing; one in which nothing was in time.
    for (sides, limit) in [([2, 1, 1], minute), ([8, 8, 8], minute), ([8, 8, 8], Duration::ZERO)] {
        let report = report(sides, limit);
        let errors: Vec<String> = validator.iter_errors(&report).map(|e| e.to_string()).collect();
        assert_eq!(errors, [""; 0]);
    }
}

#[test]
fn what_is_no_report_does_not_hold() {
    let validator = jsonschema::validator_for(&published()).unwrap();
    let good = report([8, 8, 8], Duration::from_secs(60));
    for (pointer, bad) in [
        ("/verdict", json!(null)),
        ("/domain/vertices", json!(-1)),
        ("/methods/0/degree_histogram", json!([0, 0, 3])),
        ("/methods/0/metrics/shape/p99", json!("1")),
        ("/methods/0/defects", json!([{"kind": "ugly", "count": null, "message": "…"}])),
        ("/methods/0", json!({})),
    ] {
        let mut report = good.clone();
        *report.pointer_mut(pointer).unwrap() = bad;
        assert!(!validator.is_valid(&report), "{pointer}");
    }
    for (parent, key) in [("", "domain"), ("/methods/0", "seconds"), ("/methods/0", "defects")] {
        let mut report = good.clone();
        report.pointer_mut(parent).unwrap().as_object_mut().unwrap().remove(key).unwrap();
        assert!(!validator.is_valid(&report), "{parent}/{key}");
    }
}
