//! The published schema of `report.json` is that of the types. Whether reports keep to it,
//! tests/formats/schemas.py asks another library.

use mindeg_compare::report_schema;
use serde_json::Value;

const PUBLISHED: &str = include_str!("../../../docs/report.schema.json");

#[test]
fn the_published_schema_is_that_of_the_types() {
    let published: Value = serde_json::from_str(PUBLISHED).unwrap();
    assert!(
        published == serde_json::from_str::<Value>(&report_schema()).unwrap(),
        "docs/report.schema.json is out of date; run\n\
         cargo run -p mindeg-compare --example report_schema > docs/report.schema.json"
    );
}
