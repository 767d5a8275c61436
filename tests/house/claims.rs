//! The tests that documents name, so that no document promises a missing test.

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

/// A name as documents write it: a file or script, a test in a file, or a test in any file.
#[derive(Debug, PartialEq)]
pub(crate) enum Named<'a> {
    Script(&'a str),
    InFile { file: &'a str, test: &'a str },
    Anywhere(&'a str),
}

impl<'a> Named<'a> {
    pub(crate) fn new(name: &'a str) -> Self {
        match name.split_once(':') {
            Some((file, test)) => Self::InFile { file, test },
            None if name.contains('/') => Self::Script(name),
            None => Self::Anywhere(name),
        }
    }
}

/// The rows of tables with a column "checked by" that name nothing.
pub(crate) fn rows_without_a_test(document: &str) -> Vec<&str> {
    let tables = document.split("\n\n").filter(|paragraph| {
        let head = paragraph.lines().find(|line| line.starts_with('|'));
        head.is_some_and(|head| head.trim_end().ends_with("| checked by |"))
    });
    let rows = tables.flat_map(|table| table.lines().filter(|line| line.starts_with('|')).skip(2));
    rows.filter(|row| {
        let cell = row.trim_end_matches(['|', ' ']).rsplit('|').next().unwrap_or_default();
        quoted(cell).is_empty()
    })
    .collect()
}

/// Whether a source has a test function of this name.
pub(crate) fn has_test(source: &str, name: &str) -> bool {
    ["fn ", "def "].iter().any(|keyword| source.contains(&format!("{keyword}{name}(")))
}

#[test]
fn a_claim_without_its_test_is_found() {
    let page = "| promise | checked by |\n|---|---|\n| a | `x.rs:t` |\n| b | nothing |\n";
    assert_eq!(rows_without_a_test(page), ["| b | nothing |"]);
    assert_eq!(Vec::from_iter(named_tests(page)), ["x.rs:t"]);
    assert_eq!(Named::new("x.rs:t"), Named::InFile { file: "x.rs", test: "t" });
    assert_eq!(Named::new("tests/run"), Named::Script("tests/run"));
    assert!(has_test("#[test]\nfn t() {", "t") && !has_test("fn tt()", "t"));
}
