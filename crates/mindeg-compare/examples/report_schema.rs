//! Prints the JSON Schema of `report.json`, as `docs/report.schema.json` holds it.

fn main() {
    print!("{}", mindeg_compare::report_schema());
}
