//! The commands of README.md and docs/, run in their order as a reader runs them, page by page.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::run::{mindeg, shell};
use std::fs;
use std::path::Path;

/// Commands that run elsewhere, by their first words: builds, other programs' package managers, and a
/// server that waits for its reader.
const ELSEWHERE: [&str; 10] = [
    "cargo build",
    "cc ",
    "cargo test",
    "cargo bench",
    "cargo install",
    "cargo run --release -p mindeg-cli --features explore",
    "benches/",
    "fuzz/",
    "pip ",
    "blender/",
];

/// A command of a page, and the lines that the page shows below it, if it shows any.
#[derive(Debug, PartialEq)]
struct Example {
    line: usize,
    command: String,
    output: Vec<String>,
}

/// The commands in ```sh blocks, one a line or several with a `\` at the end, and those after `$ ` in
/// ```console blocks. A block marked ```sh together runs as one script.
fn examples(page: &str) -> Vec<Example> {
    let mut found: Vec<Example> = Vec::new();
    let mut kind = "";
    for (index, text) in page.lines().enumerate() {
        let line = index + 1;
        if let Some(fence) = text.strip_prefix("```") {
            kind = if kind.is_empty() { fence } else { "" };
            if kind == "sh together" {
                found.push(Example { line, command: String::new(), output: Vec::new() });
            }
            continue;
        }
        let last = found.last_mut();
        match kind {
            "sh" => match last {
                Some(last) if last.command.ends_with('\\') => {
                    last.command = format!("{}\n{text}", last.command);
                }
                _ if text.trim().is_empty() => {}
                _ => found.push(Example { line, command: text.to_owned(), output: Vec::new() }),
            },
            "sh together" => {
                let last = last.expect("the block began with an example");
                last.command = format!("{}{text}\n", last.command);
            }
            "console" => match (text.strip_prefix("$ "), last) {
                (Some(command), _) => {
                    let command = command.to_owned();
                    found.push(Example { line, command, output: Vec::new() });
                }
                // Without a command it is the output of the one before.
                (None, Some(last)) => last.output.push(text.to_owned()),
                (None, None) => {}
            },
            _ => {}
        }
    }
    found
}

/// Whether a text is as a page shows it, but for white space: pages wrap lines. An ellipsis stands for any text.
fn is_shown(shown: &str, printed: &str) -> bool {
    let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let (shown, printed) = (words(shown), words(printed));
    let Some((first, others)) = shown.split_once('…') else { return shown == printed };
    let Some(mut rest) = printed.strip_prefix(first.trim_end()) else { return false };
    let (middle, last) = others.rsplit_once('…').unwrap_or(("", others));
    for piece in middle.split('…').map(str::trim) {
        let Some(at) = rest.find(piece) else { return false };
        rest = &rest[at + piece.len()..];
    }
    rest.ends_with(last.trim_start())
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap().map(Result::unwrap) {
        let target = to.join(entry.file_name());
        match entry.path().is_dir() {
            true => copy(&entry.path(), &target),
            false => drop(fs::copy(entry.path(), target).unwrap()),
        }
    }
}

/// The errors in the examples of a page, and the number of examples that ran.
fn faults(page: &Path) -> (Vec<String>, usize) {
    let folder = tempfile::tempdir().unwrap();
    let bin = folder.path().join("bin");
    fs::create_dir(&bin).unwrap();
    std::os::unix::fs::symlink(env!("CARGO_BIN_EXE_mindeg"), bin.join("mindeg")).unwrap();
    copy(&root().join("assets"), &folder.path().join("assets"));
    fs::create_dir(folder.path().join("target")).unwrap();

    let text = fs::read_to_string(page).unwrap();
    let name = page.file_name().unwrap().display();
    let (mut faults, mut count) = (Vec::new(), 0);
    for Example { line, command, output } in examples(&text) {
        let is_left_out = command.contains("mindeg explore") && !cfg!(feature = "explore");
        if is_left_out || ELSEWHERE.iter().any(|words| command.starts_with(words)) {
            continue;
        }
        count += 1;
        let program = command.replace("cargo run --release -p mindeg-cli --", "mindeg");
        let run = shell(folder.path(), &format!("PATH=\"$PWD/bin:$PATH\"\n( {program}\n) 2>&1"));
        if run.code != Some(0) {
            faults.push(format!("{name}:{line}: {command}\n{}", run.text()));
        } else if !output.is_empty() && !is_shown(&output.join("\n"), run.text()) {
            faults.push(format!("{name}:{line}: {command}\nprints\n{}", run.text()));
        }
    }
    (faults, count)
}

#[test]
fn the_picture_of_the_readme_is_what_its_command_makes() {
    let picture = root().join("assets/images/plate-interior.svg");
    let domain = root().join("assets/domains/plate-with-holes.json");
    let domain = domain.to_str().unwrap();
    let run = mindeg(["mesh", domain, "--interior", "-q", "--format", "svg", "-o", "-"]);
    assert_eq!(run.code, Some(0), "{}", run.errors);
    if std::env::var_os("MINDEG_BLESS").is_some() {
        return fs::write(picture, run.output).unwrap();
    }
    let is_same = fs::read(picture).unwrap() == run.output;
    assert!(is_same, "MINDEG_BLESS=1 writes the picture anew; look at it");
}

#[test]
fn the_picture_of_changes_is_what_its_command_makes() {
    let picture = root().join("assets/images/changes.svg");
    let coast = root().join("assets/outlines/saronic.geojson");
    let folder = tempfile::tempdir().unwrap();
    let new = folder.path().join("changes.svg");
    let wanted = "--project auto --size 2km --narrowest 800m -q --changes";
    let arguments = ["condition", coast.to_str().unwrap()].into_iter().chain(wanted.split(' '));
    mindeg(arguments.chain([new.to_str().unwrap()]).collect::<Vec<_>>()).text();
    let new = fs::read(new).unwrap();
    if std::env::var_os("MINDEG_BLESS").is_some() {
        return fs::write(picture, new).unwrap();
    }
    assert!(
        fs::read(picture).unwrap() == new,
        "MINDEG_BLESS=1 writes the picture anew; look at it"
    );
}

#[test]
fn examples_are_found_with_their_output() {
    let page = "```console\n$ a b\nx\n…\n```\ntext\n```console\ny\n```\n```sh\nc \\\n d\n\ne\n```\n```text\n$ f\n```\n";
    let example = |line, command: &str, output: &[&str]| Example {
        line,
        command: command.to_owned(),
        output: output.iter().map(|line| line.to_string()).collect(),
    };
    let all =
        [example(2, "a b", &["x", "…", "y"]), example(11, "c \\\n d", &[]), example(14, "e", &[])];
    assert_eq!(examples(page), all);
    assert!(
        is_shown(
            "a … c
…
e",
            "a b
c d e"
        ) && is_shown("a …", "a b c")
            && is_shown(
                "a
b", "a b"
            )
    );
    assert!(!is_shown("a", "a b") && !is_shown("a … c", "a b") && !is_shown("a … b", "a b c"));
}

#[test]
fn commands_of_the_pages_run_in_order_and_print_what_the_pages_show() {
    let mut pages = vec![root().join("README.md")];
    pages.extend(fs::read_dir(root().join("docs")).unwrap().map(|entry| entry.unwrap().path()));
    pages.retain(|page| page.extension().is_some_and(|extension| extension == "md"));
    pages.sort();
    let (mut all, mut total) = (Vec::new(), 0);
    for page in pages {
        let (faults, count) = faults(&page);
        all.extend(faults);
        total += count;
    }
    assert!(all.is_empty(), "{}", all.join("\n\n"));
    assert!(total >= 25, "only {total} commands were found");
}
