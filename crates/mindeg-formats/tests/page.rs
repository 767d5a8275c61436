//! The page of formats says what the formats are.

use mindeg_formats::Format;
use std::fs;
use std::path::Path;

#[test]
fn the_table_lists_each_format_as_it_is() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let page = fs::read_to_string(root.join("docs/formats.md")).unwrap();
    let rows: Vec<Vec<&str>> = page
        .lines()
        .filter(|line| line.starts_with("| ") && !line.starts_with("| format "))
        .map(|line| line.split('|').map(str::trim).collect())
        .collect();
    let mut listed = Vec::new();
    for row in &rows {
        let [_, name, extensions, ways, ..] = row[..] else { panic!("a row is short: {row:?}") };
        for extension in extensions.split(", ") {
            let format = Format::of_path(format!("a{extension}").as_ref());
            let format = format.unwrap_or_else(|| panic!("{name}: {extension} is no format"));
            let expected = if Format::READ.contains(&format) { "out, in" } else { "out" };
            assert_eq!(ways, expected, "{name}");
            listed.push(extension);
        }
    }
    for format in Format::WRITTEN {
        for extension in format.extensions() {
            let dotted = format!(".{extension}");
            assert!(listed.contains(&&*dotted), "docs/formats.md does not list {dotted}");
        }
    }
}
