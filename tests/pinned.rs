//! Tables of inputs with the whole answer to each, in files that one command writes anew:
//!
//! ```sh
//! MINDEG_BLESS=1 cargo test --workspace pinned
//! ```
//!
//! Read the difference before it goes in. A table has `<` before each line of an input and `>` before each line of its
//! answer; all other lines are for its readers.

use std::fs;
use std::path::Path;

/// Compares the answers in the file below this package with those of `answer`.
#[track_caller]
pub(crate) fn check(file: &str, answer: impl Fn(&str) -> String) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    let table = fs::read_to_string(&path).expect("the table is there");
    let (found, count) = answered(&table, answer);
    assert!(count >= 25, "{file} has only {count} inputs");
    if std::env::var_os("MINDEG_BLESS").is_some() {
        return fs::write(&path, found).expect("the table can be written");
    }
    let differences: Vec<String> = table
        .lines()
        .zip(found.lines())
        .filter(|(old, new)| old != new)
        .map(|(old, new)| format!("{old}\n  is now\n{new}\n"))
        .collect();
    assert!(table == found, "{file}: MINDEG_BLESS=1 writes it anew\n{}", differences.join("\n"));
}

/// Each input of a table.
pub(crate) fn inputs(table: &str) -> Vec<String> {
    let inputs = std::cell::RefCell::new(Vec::new());
    answered(table, |input| {
        inputs.borrow_mut().push(input.to_owned());
        String::new()
    });
    inputs.into_inner()
}

/// The table with these answers, and how many there are.
fn answered(table: &str, answer: impl Fn(&str) -> String) -> (String, usize) {
    let (mut found, mut count) = (String::new(), 0);
    let mut lines = table.lines().filter(|line| !line.starts_with('>')).peekable();
    let mut input: Vec<&str> = Vec::new();
    while let Some(line) = lines.next() {
        found += line;
        found.push('\n');
        let Some(text) = line.strip_prefix("< ") else { continue };
        input.push(text);
        if lines.peek().is_none_or(|next| !next.starts_with("< ")) {
            count += 1;
            for line in answer(&input.join("\n")).lines() {
                found += format!("> {line}").trim_end();
                found.push('\n');
            }
            input.clear();
        }
    }
    (found, count)
}

#[test]
fn pinned_answers_are_replaced_and_the_rest_stays() {
    let table = "title\n< a\n< b\n> old\n> lines\n\n< c\n";
    let (found, count) = answered(table, |input| format!("{}!\n\n?", input.replace('\n', "+")));
    assert_eq!(found, "title\n< a\n< b\n> a+b!\n>\n> ?\n\n< c\n> c!\n>\n> ?\n");
    assert_eq!((count, inputs(table)), (2, vec!["a\nb".to_owned(), "c".to_owned()]));
}
