//! The pages of docs/: all in the book, and not too many words.

use crate::{assert_none, files, root};
use std::fs;
use std::path::PathBuf;

/// The most words of prose in all pages: what a reader reads, without code and tables.
const MOST_WORDS: usize = 20_000;

/// The most words of README.md, code and tables among them.
const MOST_IN_README: usize = 700;

/// The words of a page outside code blocks and tables.
fn words(page: &str) -> usize {
    let mut is_code = false;
    let mut count = 0;
    for line in page.lines() {
        if line.starts_with("```") {
            is_code = !is_code;
        } else if !is_code && !line.starts_with('|') {
            count += line.split_whitespace().count();
        }
    }
    count
}

#[test]
fn code_and_tables_are_no_prose() {
    assert_eq!(words("# A b\n\n```sh\nls -l\n```\n| a | b |\nc d e\n"), 6);
}

#[test]
fn the_pages_can_be_read() {
    let pages = files(&root().join("docs"), &[".md"]);
    // The paper and the table of contents are read by themselves; the names of Python are looked up.
    let is_page = |path: &&PathBuf| {
        !path.starts_with(root().join("docs/paper"))
            && !["SUMMARY.md", "python-api.md"].iter().any(|name| path.ends_with(name))
    };
    let pages = pages.iter().filter(is_page);
    let counts: Vec<(String, usize)> = pages
        .map(|path| (path.display().to_string(), words(&fs::read_to_string(path).unwrap())))
        .collect();
    let all: usize = counts.iter().map(|(_, count)| count).sum();
    assert!(all <= MOST_WORDS, "{all} words of prose; at most {MOST_WORDS}: {counts:#?}");
}

#[test]
fn the_readme_is_short() {
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let count = readme.split_whitespace().count();
    assert!(
        count <= MOST_IN_README,
        "{count} words with code and tables; at most {MOST_IN_README}"
    );
}

#[test]
fn every_page_is_in_the_book_once() {
    let docs = root().join("docs");
    let summary = fs::read_to_string(docs.join("SUMMARY.md")).unwrap();
    let faults: Vec<String> = fs::read_dir(&docs)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| name.ends_with(".md") && name != "SUMMARY.md")
        .filter(|name| summary.matches(&format!("]({name})")).count() != 1)
        .collect();
    assert_none(&faults, "list the page once in docs/SUMMARY.md");
}
