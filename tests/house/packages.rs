//! The contents of each package when it leaves this folder: a page, the licences, and all that its sources include.

use crate::{PROGRAM, assert_none, crates, files, root};
use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

/// The end of each page.
const FOOT: &str = "
This is one of the crates of mindeg. Programs name `mindeg` for meshes and `mindeg-formats` for files; the other crates
are their parts. MIT or Apache-2.0, as you like.
";

/// The packages that are published.
fn published() -> BTreeMap<String, PathBuf> {
    let is_published = |folder: &PathBuf| {
        !fs::read_to_string(folder.join("Cargo.toml")).unwrap().contains("publish = false")
    };
    crates().into_iter().filter(|(_, folder)| is_published(folder)).collect()
}

/// The page of a package: its documentation up to the end of the first example, as a page shows it.
fn page(name: &str, source: &str) -> Option<String> {
    let docs = source.lines().map_while(|line| line.strip_prefix("//!"));
    let docs: Vec<&str> = docs.map(|line| line.strip_prefix(' ').unwrap_or(line)).collect();
    let fences = || docs.iter().enumerate().filter(|(_, line)| line.starts_with("```"));
    let (first, last) = (fences().next()?.0, fences().nth(1)?.0);
    let mut page = format!("# {name}\n\n");
    for (at, line) in docs.iter().enumerate().take(last + 1) {
        let line = match at {
            at if at < first => without_links(line),
            at if at == first && *line == "```" => "```rust".to_owned(),
            // Lines that documentation hides.
            _ if line.starts_with("# ") => continue,
            _ => (*line).to_owned(),
        };
        page += &line;
        page.push('\n');
    }
    Some(page + FOOT)
}

/// A line without the links that only rustdoc can follow.
fn without_links(line: &str) -> String {
    let mut rest = line;
    let mut out = String::new();
    while let Some((before, link)) = rest.split_once("[`") {
        let Some((text, after)) = link.split_once("`]") else { break };
        out += &format!("{before}`{text}`");
        rest =
            after.strip_prefix('(').and_then(|path| path.split_once(')')).map_or(after, |it| it.1);
    }
    out + rest
}

#[test]
fn pages_of_packages_are_their_documentation() {
    let mut faults = Vec::new();
    // The program's is the page of the project.
    for (name, folder) in published().into_iter().filter(|(name, _)| name != PROGRAM) {
        let source = fs::read_to_string(folder.join("src/lib.rs")).unwrap();
        let Some(page) = page(&name, &source) else {
            faults.push(format!("{name}: its documentation has no example"));
            continue;
        };
        let path = folder.join("README.md");
        if std::env::var_os("MINDEG_BLESS").is_some() {
            fs::write(&path, page).unwrap();
        } else if fs::read_to_string(&path).ok() != Some(page) {
            faults.push(path.display().to_string());
        }
    }
    assert_none(
        &faults,
        "MINDEG_BLESS=1 cargo test -p mindeg-cli --test house pages writes them anew",
    );
}

#[test]
fn a_page_has_neither_links_of_rustdoc_nor_hidden_lines() {
    let source = "//! Use [`a`](crate::a) and [`B`].\n//!\n//! ```\n//! let x = 1;\n//! # drop(x);\n//! ```\n//! More.\n";
    let expected = "# p\n\nUse `a` and `B`.\n\n```rust\nlet x = 1;\n```\n";
    assert_eq!(page("p", source).unwrap(), format!("{expected}{FOOT}"));
    assert_eq!(page("p", "//! No example.\n"), None);
}

#[test]
fn packages_hold_their_licences_and_include_nothing_from_outside() {
    let mut faults = Vec::new();
    for (name, folder) in published() {
        for licence in ["LICENSE-APACHE", "LICENSE-MIT"] {
            if fs::read(folder.join(licence)).ok() != fs::read(root().join(licence)).ok() {
                faults.push(format!("{name}: link ../../{licence} here"));
            }
        }
        let manifest = fs::read_to_string(folder.join("Cargo.toml")).unwrap();
        for key in ["description = ", "repository.workspace = true", "keywords = ", "categories = "]
        {
            if !manifest.lines().any(|line| line.starts_with(key)) {
                faults.push(format!("{name}: its manifest has no line {key}"));
            }
        }
        for path in files(&folder.join("src"), &[".rs"]) {
            let text = fs::read_to_string(&path).unwrap();
            let depth = path.strip_prefix(&folder).unwrap().components().count();
            // The path that leaves the package, from this file.
            let outside = format!("\"{}", "../".repeat(depth));
            let includes = text.lines().zip(text.lines().skip(1)).filter(|(before, line)| {
                line.contains(&outside) && line.contains("include") && !before.contains("doctest")
            });
            faults.extend(includes.map(|(_, line)| format!("{}: {line}", path.display())));
        }
    }
    assert_none(&faults, "a package is built from its own folder alone");
}

/// The owner sets where the sources are in one place.
#[test]
fn the_repository_is_named_once() {
    let manifest = fs::read_to_string(root().join("Cargo.toml")).unwrap();
    let line = manifest.lines().find_map(|line| line.strip_prefix("repository = ")).unwrap();
    let url = line.trim_matches('"');
    assert!(url.starts_with("https://"), "{url}");
    let endings = [".toml", ".md", ".rs", ".py", ".json", ".html"];
    let named = files(&root(), &endings).into_iter().filter(|path| {
        fs::read_to_string(path).is_ok_and(|text| text.contains(url))
            && *path != root().join("Cargo.toml")
    });
    let faults: Vec<String> = named.map(|path| path.display().to_string()).collect();
    assert_none(&faults, "say `repository.workspace = true`, or leave the address out");
}

#[test]
fn the_version_is_the_same_everywhere() {
    let read = |path: &str| fs::read_to_string(root().join(path)).unwrap();
    let manifest = read("Cargo.toml");
    let version = manifest.lines().find_map(|line| line.strip_prefix("version = ")).unwrap();
    let mut faults = Vec::new();
    let own = |line: &&str| line.starts_with("mindeg") && line.contains("path = \"crates/");
    let own: Vec<&str> = manifest.lines().filter(own).collect();
    assert!(own.len() >= 10, "{own:?}");
    let differ = own.into_iter().filter(|line| !line.contains(&format!("version = {version}")));
    faults.extend(differ.map(|line| format!("Cargo.toml: {line}")));
    let citation = format!("version: {}", version.trim_matches('"'));
    for (path, line) in [
        ("blender/blender_manifest.toml", format!("version = {version}")),
        ("CITATION.cff", citation),
    ] {
        if !read(path).lines().any(|found| found == line) {
            faults.push(format!("{path}: no line {line}"));
        }
    }
    assert_none(&faults, "set the version of Cargo.toml here too");
}
