//! Other platforms: what needs no machine of their kind to be seen.

use crate::{assert_none, crates, files, root, without_tests};
use std::collections::BTreeSet;
use std::fs;
use std::process::Command;

/// The one file with `unsafe` code, and how many blocks of it there are.
const UNSAFE: (&str, usize) = ("crates/mindeg-c/src/exported.rs", 6);

/// C names functions by symbols and gives arrays by addresses. The workspace's lints forbid `unsafe` everywhere else.
#[test]
fn unsafe_code_is_in_the_c_interface_alone() {
    let mut faults = Vec::new();
    for (name, folder) in crates() {
        let manifest = fs::read_to_string(folder.join("Cargo.toml")).unwrap();
        let lint = match &*name {
            "mindeg-c" => "[lints.rust]\nunsafe_code = \"deny\"\n",
            _ => "[lints]\nworkspace = true\n",
        };
        if !manifest.contains(lint) {
            faults.push(format!("{name}: its manifest has no {lint:?}"));
        }
    }
    let (file, most) = UNSAFE;
    let text = fs::read_to_string(root().join(file)).unwrap();
    assert_none(&faults, "only C needs another lint");
    let blocks = text.matches("unsafe {").count();
    assert_eq!(blocks, most, "{file}: count each new block, and say why it is safe");
    assert_eq!(text.matches("// SAFETY: ").count(), most, "{file}: each block says why it is safe");
    let expecting = files(&root().join("crates"), &[".rs"]).into_iter().filter(|path| {
        let text = fs::read_to_string(path).unwrap();
        ["expect", "allow"].iter().any(|word| text.contains(&format!("{word}(unsafe_code")))
    });
    assert_eq!(expecting.collect::<Vec<_>>(), [root().join(file)]);
}

/// The header has the name and the words of each function; cbindgen, which takes minutes to build, compares the rest
/// (`tests/c/run --header`).
#[test]
fn the_header_of_c_says_what_the_functions_say() {
    let source = fs::read_to_string(root().join(UNSAFE.0)).unwrap();
    let header = fs::read_to_string(root().join("crates/mindeg-c/mindeg.h")).unwrap();
    let mut faults = Vec::new();
    let (exported, _) = source.split_once("\n/// The rings of points.").unwrap();
    for line in exported.lines() {
        let name = line.split_once("extern \"C\" fn ").and_then(|(_, rest)| rest.split_once('('));
        let words = line.strip_prefix("///").map(str::trim_end);
        let wanted = name.map(|(name, _)| format!("{name}(")).or(words.map(str::to_owned));
        faults.extend(wanted.filter(|wanted| !header.contains(wanted)));
    }
    assert_eq!(exported.matches("extern \"C\" fn ").count(), header.matches("(const").count() + 2);
    assert_none(&faults, "MINDEG_BLESS=1 tests/c/run LIBRARY --header writes mindeg.h anew");
}

/// WebAssembly has no threads, files, clock or processes: `mindeg` without features must ask for none.
#[test]
fn the_library_without_features_needs_no_system() {
    const SYSTEM: [&str; 10] = [
        "std::thread",
        "std::fs",
        "std::time",
        "std::env",
        "std::process",
        "std::net",
        "std::os",
        "println!",
        "stdout()",
        "rayon",
    ];
    let options = ["tree", "--package", "mindeg", "--no-default-features", "--edges", "normal"];
    let tree = Command::new(env!("CARGO"))
        .args(options)
        .args(["--prefix", "none", "--format", "{p}", "--offline", "--locked"])
        .current_dir(root())
        .output()
        .unwrap();
    assert!(tree.status.success(), "{}", String::from_utf8_lossy(&tree.stderr));
    let text = String::from_utf8(tree.stdout).unwrap();
    let names: BTreeSet<&str> = text.lines().filter_map(|line| line.split(' ').next()).collect();
    assert!(names.contains("mindeg-exact") && names.contains("spade"), "{names:?}");
    let mut faults = Vec::new();
    for name in ["rayon", "tempfile", "getrandom", "tokio", "serde_json"] {
        if names.contains(name) {
            faults.push(format!("{name} is built in"));
        }
    }
    for (name, folder) in crates().iter().filter(|(name, _)| names.contains(&***name)) {
        for path in files(&folder.join("src"), &[".rs"]) {
            let code = without_tests(&path);
            let behind_a_feature = code.contains("feature = \"parallel\"");
            let lines = code.lines().filter(|line| !line.trim_start().starts_with("//"));
            for line in lines {
                let found = SYSTEM.iter().find(|word| line.contains(**word));
                if let Some(word) = found.filter(|_| !behind_a_feature) {
                    faults.push(format!("{name}: {}: {word}", path.display()));
                }
            }
        }
    }
    assert_none(&faults, "put it behind a feature, or leave it to the caller");
}

/// A file for Unix alone says what happens elsewhere.
#[test]
fn code_for_unix_has_a_counterpart() {
    /// Permissions of new files, which other systems take from the folder.
    const NONE_NEEDED: [&str; 1] = ["PermissionsExt"];
    let mut faults = Vec::new();
    for path in crates().values().flat_map(|folder| files(&folder.join("src"), &[".rs"])) {
        let code = without_tests(&path);
        let here = code.matches("#[cfg(unix)]").count()
            - NONE_NEEDED.iter().filter(|word| code.contains(**word)).count();
        if here > 0 && !code.contains("#[cfg(not(unix))]") {
            faults.push(path.display().to_string());
        }
    }
    assert_none(&faults, "add #[cfg(not(unix))]");
}

/// Numbers in files have the order of bytes of their format, not that of the machine.
#[test]
fn no_bytes_are_in_the_order_of_the_machine() {
    let mut faults = Vec::new();
    for path in crates().values().flat_map(|folder| files(&folder.join("src"), &[".rs"])) {
        let text = fs::read_to_string(&path).unwrap();
        let words = ["to_ne_bytes", "from_ne_bytes", "target_endian", "transmute"];
        faults.extend(
            words
                .iter()
                .filter(|word| text.contains(**word))
                .map(|word| format!("{}: {word}", path.display())),
        );
    }
    assert_none(&faults, "say to_le_bytes or to_be_bytes");
}
