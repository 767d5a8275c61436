//! Checks the sources themselves: the arrows of ARCHITECTURE.md, sizes and words.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

mod claims;
mod modules;
mod packages;
mod pages;
mod platforms;

use claims::Named;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The most lines of a file without its tests.
const MOST_LINES: usize = 400;

/// Phrases that a mesh engineer must read twice. Write subject, verb, object instead.
const RETIRED: [&str; 10] = [
    "cannot be had",
    "can be had",
    "hears of",
    "looks away",
    "said of",
    "is served",
    "are served",
    "so many are",
    "smallest angle",
    "busiest vertex",
];

/// The crate whose folder is the root.
const PROGRAM: &str = "mindeg-cli";

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).canonicalize().unwrap()
}

/// All files below `folder` with one of the endings, in the order of their paths.
fn files(folder: &Path, endings: &[&str]) -> Vec<PathBuf> {
    let mut entries: Vec<PathBuf> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    entries.sort();
    let mut found = Vec::new();
    for path in entries {
        let name = path.file_name().unwrap().to_string_lossy();
        if path.is_dir() {
            if !name.starts_with('.') && name != "target" && name != "node_modules" {
                found.extend(files(&path, endings));
            }
        } else if endings.iter().any(|ending| name.ends_with(ending)) {
            found.push(path);
        }
    }
    found
}

/// The folder of each crate, by its name.
fn crates() -> BTreeMap<String, PathBuf> {
    let manifests = files(&root().join("crates"), &["Cargo.toml"]);
    let folders = manifests.iter().map(|path| path.parent().unwrap().to_owned());
    folders
        .map(|path| (path.file_name().unwrap().to_string_lossy().into_owned(), path))
        .chain([(PROGRAM.to_owned(), root())])
        .collect()
}

/// The lines of a file before its tests.
fn without_tests(path: &Path) -> String {
    // A module of tests in a file of its own.
    if path.ends_with("tests.rs") {
        return String::new();
    }
    let text = fs::read_to_string(path).unwrap();
    let lines = text.lines().take_while(|line| *line != "#[cfg(test)]");
    lines.flat_map(|line| [line, "\n"]).collect()
}

fn assert_none(faults: &[String], what_to_do: &str) {
    assert!(faults.is_empty(), "{what_to_do}:\n  {}", faults.join("\n  "));
}

#[test]
fn arrows_between_crates_are_those_of_the_architecture_page() {
    let page = fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    let arrows = page.lines().filter_map(|line| line.split_once(" -> "));
    let drawn: BTreeMap<&str, BTreeSet<&str>> = arrows
        .map(|(from, to)| (from.trim(), to.split(',').map(str::trim).collect()))
        .map(|(from, to): (_, BTreeSet<&str>)| (from, &to - &["nothing"].into()))
        .collect();
    let mut faults = Vec::new();
    let crates = crates();
    for (name, folder) in &crates {
        let manifest = fs::read_to_string(folder.join("Cargo.toml")).unwrap();
        let mut section = "";
        let mut real = BTreeSet::new();
        for line in manifest.lines() {
            section = if line.starts_with('[') { line } else { section };
            let key = line.split(['.', ' ', '=']).next().unwrap_or("");
            if section.ends_with("dependencies]")
                && !section.contains("dev-")
                && !section.contains("workspace")
                && crates.contains_key(key)
            {
                real.insert(key);
            }
        }
        if drawn.get(name.as_str()) != Some(&real) {
            faults.push(format!(
                "{name}: the manifest has {real:?}, the page {:?}",
                drawn.get(&**name)
            ));
        }
    }
    let gone = drawn.keys().filter(|name| !crates.contains_key(**name));
    faults.extend(gone.map(|name| format!("{name}: the page has it, the workspace has not")));
    assert_none(&faults, "correct the arrows in ARCHITECTURE.md or the manifests");
}

#[test]
fn every_file_of_tests_is_in_its_program() {
    let mut left_out = Vec::new();
    for folder in crates().values().map(|folder| folder.join("tests")) {
        // The programs that cargo finds by itself need no list.
        let Ok(listed) = fs::read_to_string(folder.join("main.rs")) else { continue };
        for file in fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()) {
            let name = file.file_stem().unwrap().to_string_lossy();
            if file.extension().is_some_and(|ending| ending == "rs")
                && name != "main"
                && !listed.contains(&format!("mod {name};"))
            {
                left_out.push(file.display().to_string());
            }
        }
    }
    assert_none(&left_out, "name these in tests/main.rs, or they are never run");
}

#[test]
fn no_file_is_long() {
    let mut faults = Vec::new();
    for path in crates().values().flat_map(|folder| files(&folder.join("src"), &[".rs"])) {
        let lines = without_tests(&path).lines().count();
        if lines > MOST_LINES {
            faults.push(format!("{}: {lines} lines", path.strip_prefix(root()).unwrap().display()));
        }
    }
    assert_none(&faults, &format!("split files above {MOST_LINES} lines without tests"));
}

#[test]
fn no_crate_has_more_than_22_percent_of_the_lines() {
    let lines = |folder: &PathBuf| -> usize {
        let files = files(&folder.join("src"), &[".rs"]);
        files.iter().map(|path| fs::read_to_string(path).unwrap().lines().count()).sum()
    };
    let sizes: Vec<(String, usize)> =
        crates().iter().map(|(name, folder)| (name.clone(), lines(folder))).collect();
    let all: usize = sizes.iter().map(|(_, lines)| lines).sum();
    let large = sizes.iter().filter(|(_, lines)| 100 * lines > 22 * all);
    let faults: Vec<String> =
        large.map(|(name, lines)| format!("{name}: {lines} of {all} lines")).collect();
    assert_none(&faults, "split the crate");
}

#[test]
fn no_two_public_types_share_a_name() {
    let mut homes: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for path in crates().values().flat_map(|folder| files(&folder.join("src"), &[".rs"])) {
        for line in without_tests(&path).lines() {
            let line = line.trim_start();
            let kinds = ["pub struct ", "pub enum ", "pub trait ", "pub type "];
            let Some(rest) = kinds.iter().find_map(|kind| line.strip_prefix(kind)) else {
                continue;
            };
            let end = rest.find(|c: char| !c.is_alphanumeric()).unwrap_or(rest.len());
            let home = path.strip_prefix(root()).unwrap().display().to_string();
            homes.entry(rest[..end].to_owned()).or_default().insert(home);
        }
    }
    homes.retain(|_, files| files.len() > 1);
    let faults: Vec<String> = homes
        .iter()
        .map(|(name, files)| {
            format!("{name}: {}", Vec::from_iter(files.iter().map(String::as_str)).join(", "))
        })
        .collect();
    assert_none(
        &faults,
        "one concept, one type: use the one that is there, or name the other by what it is",
    );
}

#[test]
fn no_modules_of_a_crate_use_each_other_in_a_circle() {
    let mut faults = Vec::new();
    for (name, folder) in crates() {
        let src = folder.join("src");
        let source =
            |path: PathBuf| (path.strip_prefix(&src).unwrap().to_owned(), without_tests(&path));
        let sources: Vec<_> = files(&src, &[".rs"]).into_iter().map(source).collect();
        let circles = modules::circles(&sources);
        faults.extend(circles.iter().map(|arrow| format!("{name}: {arrow}")));
    }
    assert_none(&faults, "break the circles that these arrows form");
}

#[test]
fn no_phrase_is_retired() {
    let root = root();
    let mut faults = Vec::new();
    for path in files(&root, &[".rs", ".md", ".py"]) {
        if path.ends_with("tests/house/main.rs") {
            continue;
        }
        // A phrase may go on in the next line of a comment.
        let text = fs::read_to_string(&path).unwrap().to_lowercase();
        let words =
            text.split_whitespace().filter(|word| !["//", "///", "//!", "#"].contains(word));
        let text = words.collect::<Vec<_>>().join(" ");
        for phrase in RETIRED.iter().filter(|phrase| text.contains(**phrase)) {
            faults.push(format!("{}: {phrase:?}", path.strip_prefix(&root).unwrap().display()));
        }
    }
    assert_none(&faults, "write these sentences in plain words");
}

/// A format is added in `mindeg-formats` alone: no other crate lists extensions of meshes.
#[test]
fn no_extensions_are_listed_outside_the_formats() {
    const ENOUGH_FOR_A_LIST: usize = 4;
    let formats = mindeg_formats::Format::WRITTEN;
    let extensions: BTreeSet<&str> =
        formats.iter().flat_map(|format| format.extensions()).copied().collect();
    let mut faults = Vec::new();
    for (name, folder) in crates() {
        if name == "mindeg-formats" {
            continue;
        }
        for path in files(&folder.join("src"), &[".rs"]) {
            let code = without_tests(&path);
            let lines: Vec<&str> = code.lines().collect();
            for (index, window) in lines.windows(3).enumerate() {
                let text = window.join(" ");
                let words = text.split(|letter: char| {
                    !letter.is_ascii_alphanumeric() && letter != '.' && letter != '"'
                });
                let is_listed = |word: &&str| {
                    let bare = word.trim_matches('"');
                    let is_quoted = bare.len() + 2 == word.len();
                    let dotted = word.strip_prefix('.').map(|word| word.trim_end_matches('.'));
                    (is_quoted && extensions.contains(bare))
                        || dotted.is_some_and(|word| extensions.contains(word))
                };
                let found: BTreeSet<&str> = words.filter(is_listed).collect();
                if found.len() >= ENOUGH_FOR_A_LIST {
                    faults.push(format!("{}:{}: {found:?}", path.display(), index + 1));
                }
            }
        }
    }
    assert_none(&faults, "use mindeg_formats::extensions, or Format::of_path");
}

#[test]
fn documents_name_tests_that_exist() {
    let root = root();
    let mut faults = Vec::new();
    let tests = [root.join("crates"), root.join("tests")];
    let sources: Vec<String> = tests
        .iter()
        .flat_map(|folder| files(folder, &[".rs", ".py"]))
        .map(|path| fs::read_to_string(path).unwrap())
        .collect();
    for page in files(&root.join("docs"), &[".md"]) {
        let text = fs::read_to_string(&page).unwrap();
        let named = page.strip_prefix(&root).unwrap().display();
        for row in claims::rows_without_a_test(&text) {
            faults.push(format!("{named}: no test in {row}"));
        }
        for name in claims::named_tests(&text) {
            let exists = match Named::new(&name) {
                Named::Script(path) => root.join(path).exists(),
                Named::InFile { file, test } => [root.clone(), root.join("crates")]
                    .iter()
                    .filter_map(|folder| fs::read_to_string(folder.join(file)).ok())
                    // A page whose examples are compiled is named by its file.
                    .any(|text| {
                        claims::has_test(&text, test) || text.contains(&format!("/{test}\")"))
                    }),
                Named::Anywhere(test) => {
                    sources.iter().any(|source| claims::has_test(source, test))
                }
            };
            if !exists {
                faults.push(format!("{named}: {name}"));
            }
        }
    }
    assert_none(&faults, "name tests that exist, or write them");
}

#[test]
fn every_fuzz_target_is_listed_described_and_has_seeds() {
    let fuzz = root().join("fuzz");
    let listed = |file: &str, before: &str, after: &str| -> BTreeSet<String> {
        let text = fs::read_to_string(fuzz.join(file)).unwrap();
        let lines = text.lines().filter_map(|line| line.strip_prefix(before)?.split_once(after));
        lines.map(|(name, _)| name.to_owned()).collect()
    };
    let folders = fs::read_dir(fuzz.join("seeds")).unwrap();
    let folders: BTreeSet<String> =
        folders.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    assert_eq!(listed("src/lib.rs", "    (\"", "\""), folders);
    assert_eq!(listed("README.md", "| `", "`"), folders);
}
