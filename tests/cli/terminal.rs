//! Help, colors, line widths and shells.

use crate::run::{mindeg, output_of};
use std::process::Command;

/// Prints a verdict of several sentences.
#[cfg(target_os = "linux")]
const COMPARE: &str = "compare --rectangle 4x3 --intervals 12,9,4,4 --json > /dev/null";

#[test]
fn own_errors_are_colored_as_the_parser_s_are() {
    let errors =
        |arguments: &[&str], color| mindeg(arguments.iter().chain(&["--color", color])).errors;
    let own = &["mesh", "-o", "x.obj"][..];
    let of_parser = &["mesh", "--wrong"][..];
    let colored = "\u{1b}[1m\u{1b}[31merror:\u{1b}[0m ";
    for arguments in [own, of_parser] {
        assert!(
            errors(arguments, "always").starts_with(colored),
            "{:?}",
            errors(arguments, "always")
        );
        assert!(errors(arguments, "never").starts_with("error: "));
        // Standard error is not a terminal here.
        assert!(errors(arguments, "auto").starts_with("error: "));
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_terminal_has_colors_unless_they_are_not_wanted() {
    let on_terminal = |before: &str, arguments: &str| {
        let script = format!("stty rows 40 cols 60; {before} \"$MINDEG\" {arguments}; true");
        let mut command = Command::new("script");
        command.args(["-qec", &script, "/dev/null"]).stdin(std::process::Stdio::null());
        command.env("MINDEG", env!("CARGO_BIN_EXE_mindeg")).env("TERM", "xterm");
        command.env_remove("NO_COLOR");
        let output = output_of(&mut command);
        String::from_utf8_lossy(&output.stdout).replace('\r', "")
    };
    assert!(on_terminal("", "mesh -o x.obj").starts_with("\u{1b}[1m\u{1b}[31merror:"));
    assert!(on_terminal("NO_COLOR=1", "mesh -o x.obj").starts_with("error: "));
    assert!(on_terminal("", "mesh -o x.obj --color never").starts_with("error: "));

    for arguments in ["mesh -o x.obj", "mesh --help", "compare -h", COMPARE] {
        let shown = on_terminal("NO_COLOR=1", arguments);
        assert!(shown.lines().count() > 1, "{shown}");
        for line in shown.lines() {
            let width = line.chars().count();
            // An example is a command to copy, and stays in one piece.
            assert!(width <= 60 || line.trim_start().starts_with("mindeg "), "{width}: {line}");
        }
    }
}

/// A name that breaks the line could put a sentence of its own into mindeg's mouth.
#[test]
fn a_line_break_in_a_name_stays_in_its_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let mesh = folder.path().join("a\nerror: b.obj");
    std::fs::write(&mesh, "v 0 0 0\nv 4 0 0\nv 0 3 0\nf 1 2 3\n").expect("it can be written");
    let path = mesh.to_str().expect("it is text");
    let missing = folder.path().join("none\nsuch.json");
    let html = folder.path().join("a.html");
    for (arguments, escaped) in [
        (vec!["inspect", missing.to_str().expect("it is text")], "none\\nsuch.json"),
        (vec!["fill", path, "-o", "-", "--format", "obj", "--loop", "7"], "a\\nerror: b.obj"),
        (
            vec!["view", path, "--size", "1", "-o", html.to_str().expect("it is text")],
            "a\\nerror: b.obj",
        ),
        (vec!["inspect", path], "a\\nerror: b.obj"),
    ] {
        let run = mindeg(&arguments);
        let text = format!("{}{}", run.errors, String::from_utf8_lossy(&run.output));
        assert!(text.contains(escaped) && !text.contains("\nerror: b"), "{arguments:?}: {text}");
    }
}

#[test]
fn help_goes_to_standard_output_with_examples() {
    for command in [
        "degree", "suggest", "mesh", "tradeoff", "compare", "view", "inspect", "convert", "fill",
        "bridge",
    ] {
        let run = mindeg([command, "--help"]);
        assert_eq!((run.code, run.errors.as_str()), (Some(0), ""));
        assert!(run.text().contains(&format!("Examples:\n  mindeg {command} ")), "{}", run.text());
        assert!(run.text().contains("Exit codes:"), "{}", run.text());
    }
    let mesh = mindeg(["mesh", "--help"]);
    for words in ["last-length:LENGTH", "MeshLab cannot open such a .glb", "a .gltf is two"] {
        let text = mesh.text().split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(text.contains(words), "{words}: {text}");
    }
}

#[cfg(unix)]
#[test]
fn examples_of_the_help_work() {
    let folder = tempfile::tempdir().expect("a folder");
    let assets = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("assets");
    std::os::unix::fs::symlink(
        assets.canonicalize().expect("it is there"),
        folder.path().join("assets"),
    )
    .expect("a link");
    let mut count = 0;
    // The examples of view, inspect, convert, fill, bridge and verify name meshes that the reader has.
    for (name, content) in [
        ("lower.obj", crate::fill::cone(12, 1.0, 0.0)),
        ("upper.obj", crate::fill::cone(7, 2.0, 3.0)),
        ("both.obj", crate::fill::cones()),
        ("part.obj", crate::fill::cone(9, 1.0, 0.0)),
    ] {
        std::fs::write(folder.path().join(name), content).expect("a file");
    }
    let part = "\"$MINDEG\" convert part.obj -q -o part.glb -o part.gltf";
    let verified = "\"$MINDEG\" mesh assets/domains/wing-panel.json -q -o wing-panel.obj && \
                    \"$MINDEG\" mesh assets/domains/wing-panel.json --keep-angle 95% -q -o wing.glb && \
                    \"$MINDEG\" mesh --rectangle 4x3 --size 0.5 -q -o plate.stl";
    let remeshed = "\"$MINDEG\" mesh assets/models/cube.json -q -o part.stl && \
                    cp part.stl dirty.stl && \"$MINDEG\" convert part.stl -o scan.ply && \
                    \"$MINDEG\" remesh part.stl --size 4 -q -o remeshed.stl";
    for made in [part, verified, remeshed] {
        assert_eq!(crate::run::shell(folder.path(), made).code, Some(0), "{made}");
    }
    std::fs::copy(
        folder.path().join("assets/domains/figure-1.json"),
        folder.path().join("domain.json"),
    )
    .expect("a copy");
    for command in [
        "degree",
        "suggest",
        "mesh",
        "tradeoff",
        "compare",
        "view",
        "inspect",
        "convert",
        "fill",
        "bridge",
        "verify",
        "condition",
        "remesh",
    ] {
        let help = mindeg([command, "--help"]);
        let (_, examples) = help.text().split_once("Examples:\n").expect("examples");
        for example in examples.lines().take_while(|line| !line.is_empty()) {
            // Pipes to other programs are theirs.
            let example = example.split(" | ").next().unwrap_or_default();
            let script = example.replace("mindeg ", "\"$MINDEG\" ");
            let run = crate::run::shell(folder.path(), &script);
            assert!(
                matches!(run.code, Some(0)) || example.contains("--target-angle"),
                "{example}: {run:?}"
            );
            count += 1;
        }
    }
    assert!(count >= 20, "{count}");
}

#[test]
fn every_shell_has_completions() {
    for (shell, word) in [
        ("bash", "complete -F _mindeg"),
        ("zsh", "#compdef mindeg"),
        ("fish", "complete -c mindeg"),
        ("powershell", "Register-ArgumentCompleter"),
        ("elvish", "edit:completion"),
    ] {
        let run = mindeg(["completions", shell]);
        assert_eq!(run.code, Some(0), "{run:?}");
        assert!(run.text().contains(word) && run.text().contains("target-angle"), "{shell}");
    }
}

#[test]
fn the_schemas_of_domains_and_models_are_printed() {
    for (options, key) in [(&["schema"][..], "rectangle"), (&["schema", "--model"], "faces")] {
        let schema = mindeg(options).json();
        assert_eq!(schema["additionalProperties"], false, "{options:?}");
        assert!(schema["properties"][key]["description"].is_string(), "{options:?}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn output_that_is_lost_is_an_error() {
    let folder = tempfile::tempdir().expect("a folder");
    for (script, code) in [
        ("\"$MINDEG\" --help > /dev/full", 1),
        ("\"$MINDEG\" mesh --help > /dev/full", 1),
        ("\"$MINDEG\" --version > /dev/full", 1),
        ("\"$MINDEG\" degree 3,3,3 > /dev/full", 1),
        ("\"$MINDEG\" completions bash > /dev/full", 1),
        ("\"$MINDEG\" mesh --rectangle 4x3 --size 1 -o - --format obj >&-", 1),
        ("\"$MINDEG\" compare --rectangle 4x3 --size 1 -o - --format md >&-", 1),
        ("\"$MINDEG\" mesh --rectangle 4x3 --size 1 -o - --format obj > /dev/null", 0),
        ("\"$MINDEG\" --help > /dev/null", 0),
        ("\"$MINDEG\" --help | true", 0),
    ] {
        let run = crate::run::shell(folder.path(), script);
        assert_eq!(run.code, Some(code), "{script}: {run:?}");
        assert_eq!(run.errors.contains("cannot write to standard output"), code == 1, "{run:?}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn no_number_of_threads_holds_a_run_up() {
    let folder = tempfile::tempdir().expect("a folder");
    let script =
        "RAYON_NUM_THREADS=20000 timeout 60 \"$MINDEG\" mesh --rectangle 4x3 --size 1 -o x.obj";
    let run = crate::run::shell(folder.path(), script);
    assert_eq!(run.code, Some(0), "{run:?}");
}

/// Where no terminal tells its width, a table has at most 80 letters a line.
#[test]
fn the_list_of_formats_fits_a_screen() {
    let run = mindeg(["formats"]);
    let lines = || run.text().lines();
    assert!(lines().all(|line| line.chars().count() <= 80), "{}", run.text());
    // The rest of a long cell stands below its beginning.
    let first = lines().position(|line| line.starts_with("  adcirc  ")).expect("a preset");
    let next = lines().nth(first + 1).expect("a line");
    assert!(next.starts_with("          ") && next.trim_start().len() > 9, "{next}");
}

#[test]
fn a_format_that_is_not_built_is_listed_as_such() {
    let run = mindeg(["formats"]);
    let words = run.text().split_whitespace().collect::<Vec<_>>().join(" ");
    let is_missing = words.contains("a picture in pixels; not in this build");
    assert_eq!(is_missing, !cfg!(feature = "png"), "{}", run.text());
}
