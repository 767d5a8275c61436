//! The tests that documents name, so that none promises a test that does not exist.

use std::collections::BTreeSet;

/// The names in backquotes after each "Checked by:", up to the end of the paragraph, and those in the last
/// cell of each row of a table with a column "checked by".
pub(crate) fn named_tests(document: &str) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    for paragraph in document.split("\n\n") {
        if let Some((_, list)) = paragraph.split_once("Checked by:") {
            names.extend(quoted(list));
        }
        let mut rows = paragraph.lines().filter(|line| line.starts_with('|'));
        if rows.next().is_some_and(|head| head.trim_end().ends_with("| checked by |")) {
            let last_cell =
                |row: &str| row.trim_end_matches(['|', ' ']).rsplit('|').next().map(quoted);
            names.extend(rows.filter_map(last_cell).flatten());
        }
    }
    names
}

fn quoted(text: &str) -> Vec<String> {
    text.split('`').skip(1).step_by(2).map(str::to_owned).collect()
}

/// Whether a source has a test function of this name.
pub(crate) fn has_test(source: &str, name: &str) -> bool {
    ["fn ", "def "].iter().any(|keyword| source.contains(&format!("{keyword}{name}(")))
}
