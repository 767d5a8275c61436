//! Finds the files of a crate that use each other, by their paths within the crate.
//!
//! `pub use` only passes a name on, so it does not make an arrow: the arrow goes from the file that uses the
//! name to the file that defines it. Limits: methods and names from macros are not seen.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// Segments from the root of the crate; empty for `lib.rs` or `main.rs`.
type Module = Vec<String>;
/// For each file, its paths and the names that its `use` lines give them.
type Paths = BTreeMap<Module, Vec<Used>>;

struct Used {
    path: Vec<String>,
    name: Option<String>,
    is_public: bool,
}

/// The arrows that lie on circles or between circles, as text. `sources` are the files, by their
/// path below `src`, without their tests.
pub(crate) fn circles(sources: &[(PathBuf, String)]) -> Vec<String> {
    let paths: Paths = sources.iter().map(|(path, code)| (module(path), used(code))).collect();
    let mut arrows = BTreeSet::new();
    for (from, all) in &paths {
        let to = all.iter().filter(|used| !used.is_public);
        let to = to.filter_map(|used| resolve(&paths, from, &used.path, 0));
        arrows.extend(to.filter(|to| to != from).map(|to| (from.clone(), to)));
    }
    loop {
        let before = arrows.len();
        let all = arrows.clone();
        arrows.retain(|(from, to)| {
            all.iter().any(|a| a.1 == *from) && all.iter().any(|a| a.0 == *to)
        });
        if arrows.len() == before {
            let name = |module: &Module| format!("crate::{}", module.join("::"));
            return arrows.iter().map(|(a, b)| format!("{} -> {}", name(a), name(b))).collect();
        }
    }
}

fn module(path: &Path) -> Module {
    let path = path.with_extension("");
    let segments = path.iter().map(|segment| segment.to_string_lossy().into_owned());
    segments.filter(|segment| !["lib", "main", "mod"].contains(&segment.as_str())).collect()
}

/// The file that a path in `from` leads to; `None` for a path out of the crate.
fn resolve(paths: &Paths, from: &Module, path: &[String], depth: u32) -> Option<Module> {
    let mut at = from.clone();
    for (index, segment) in path.iter().enumerate() {
        match segment.as_str() {
            "crate" => at.clear(),
            "super" => drop(at.pop()),
            "self" => {}
            _ => {
                at.push(segment.clone());
                if paths.contains_key(&at) {
                    continue;
                }
                at.pop();
                let mut named =
                    paths.get(&at)?.iter().filter(|used| used.name.as_ref() == Some(segment));
                let defined = named.find_map(|used| match depth {
                    0..8 => resolve(paths, &at, &used.path, depth + 1),
                    _ => None,
                });
                return defined.or((index > 0).then_some(at));
            }
        }
    }
    Some(at)
}

/// The paths of `use` lines, and those in the middle of code.
fn used(code: &str) -> Vec<Used> {
    let segments = |path: &str| path.split("::").map(|s| s.trim().to_owned()).collect::<Vec<_>>();
    let code: Vec<&str> = code.lines().map(|line| line.split("//").next().unwrap_or("")).collect();
    let mut used = Vec::new();
    for statement in code.join(" ").split(';') {
        let (before, tree) = statement.rsplit_once("use ").unwrap_or((statement, ""));
        let is_public = before.trim_end().ends_with("pub") || before.trim_end().ends_with(')');
        for path in flatten(tree).iter().filter(|path| !path.is_empty()) {
            let (path, name) = path.split_once(" as ").unwrap_or((path, path));
            used.push(Used { path: segments(path), name: segments(name).pop(), is_public });
        }
        let words = before.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == ':'));
        for path in words.filter(|word| word.contains("::") && !word.starts_with("::")) {
            used.push(Used { path: segments(path), name: None, is_public: false });
        }
    }
    used
}

/// `a::{b, c::{d, e}}` as `a::b`, `a::c::d` and `a::c::e`.
fn flatten(tree: &str) -> Vec<String> {
    let Some((prefix, rest)) = tree.split_once('{') else { return vec![tree.to_owned()] };
    let inside = rest.rsplit_once('}').map_or(rest, |(inside, _)| inside);
    let mut depth = 0;
    let parts = inside.split(|c| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        c == ',' && depth == 0
    });
    parts.flat_map(flatten).map(|part| format!("{prefix}{}", part.trim())).collect()
}

#[test]
fn a_circle_through_a_passed_on_name_is_found() {
    let source = |path: &str, code: &str| (PathBuf::from(path), code.to_owned());
    let lib = source("lib.rs", "mod a; mod b; mod c; pub use a::{A, other as O}; pub use b::B;");
    let c = source("c.rs", "use crate::{A, B}; // crate::c");
    let b = source("b/mod.rs", "use std::fmt; fn f() { crate::O::new() }");
    let a = source("a.rs", "use crate::{B as X, c};");
    let found = circles(&[lib.clone(), a, b.clone(), c.clone()]);
    let arrows = ["a -> crate::b", "a -> crate::c", "b -> crate::a", "c -> crate::a"];
    assert!(arrows.iter().all(|a| found.contains(&format!("crate::{a}"))), "{found:?}");
    let a = source("a.rs", "use super::nothing; struct A;");
    assert_eq!(circles(&[lib, a, b, c]), Vec::<String>::new());
}
