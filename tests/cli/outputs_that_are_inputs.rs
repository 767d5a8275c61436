//! An output that is an input is refused before anything is written, whatever its name.

use crate::run::{Run, shell};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

const DOMAIN: &str = r#"{"rectangle": {"width": 4, "height": 3}, "size": 1}"#;

/// Everything in a folder, with its content where it is a file.
fn content(folder: &Path) -> BTreeMap<String, Option<Vec<u8>>> {
    let entries = fs::read_dir(folder).expect("the folder is there");
    let names = entries.map(|entry| entry.expect("it can be read").path());
    names.map(|path| (path.display().to_string(), fs::read(&path).ok())).collect()
}

/// Runs a script in a folder with domains under several names, and meshes.
fn run(script: &str) -> (Run, bool) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name);
    for name in ["d.json", "dom.bin", "out.html", "other.json"] {
        fs::write(path(name), DOMAIN).expect("a file");
    }
    fs::create_dir(path("sub")).expect("a folder");
    std::os::unix::fs::symlink("d.json", path("link.json")).expect("a link");
    std::os::unix::fs::symlink("../d.json", path("sub/link.html")).expect("a link");
    fs::hard_link(path("d.json"), path("hard.json")).expect("a link");
    let meshes = "\"$MINDEG\" mesh d.json -q -o a.obj -o a.gltf";
    assert_eq!(shell(folder.path(), meshes).code, Some(0));
    let before = content(folder.path());
    let run = shell(folder.path(), script);
    (run, content(folder.path()) == before)
}

#[test]
fn every_alias_of_an_input_is_refused() {
    for (script, message) in [
        ("\"$MINDEG\" compare d.json -o d.json", "d.json is the domain itself;"),
        ("\"$MINDEG\" tradeoff d.json -o d.json", "d.json is the domain itself;"),
        ("\"$MINDEG\" tradeoff d.json -o new.svg -o d.json", "d.json is the domain itself;"),
        ("\"$MINDEG\" compare d.json -o ./d.json", "./d.json is the domain itself that d.json"),
        ("\"$MINDEG\" compare d.json -o sub/../d.json", "is the domain itself"),
        ("\"$MINDEG\" compare d.json -o \"$PWD/d.json\"", "is the domain itself"),
        ("\"$MINDEG\" compare d.json -o link.json", "link.json is the domain itself"),
        ("\"$MINDEG\" compare link.json -o d.json", "d.json is the domain itself"),
        ("\"$MINDEG\" compare d.json -o hard.json", "hard.json is the domain itself"),
        ("\"$MINDEG\" compare - -o d.json < d.json", "itself that standard input names"),
        ("\"$MINDEG\" mesh d.json -o - --format obj >> d.json", "standard output is the domain"),
        ("\"$MINDEG\" mesh d.json -o /dev/stdout --format obj >> d.json", "is the domain itself"),
        ("\"$MINDEG\" mesh d.json -o /dev/fd/7 --format obj 7>> d.json", "is the domain itself"),
        ("\"$MINDEG\" mesh dom.bin -o dom.gltf", "dom.bin is the domain itself"),
        ("\"$MINDEG\" tradeoff out.html -o out.html", "out.html is the domain itself"),
        ("\"$MINDEG\" compare out.html -o .", "out.html is the domain itself"),
        ("\"$MINDEG\" compare other.json d.json out.html -o ./", "out.html is the domain itself"),
        (
            "mv sub/link.html link.html; ln -sf d.json link.html; \"$MINDEG\" compare d.json \
          -o link.html; code=$?; mv link.html sub/; exit $code",
            "link.html is the domain itself",
        ),
        ("\"$MINDEG\" convert a.obj -o a.obj", "a.obj is the mesh itself"),
        ("\"$MINDEG\" fill a.obj -o a.obj", "a.obj is the mesh itself"),
        ("\"$MINDEG\" bridge a.obj a.gltf -o a.obj", "a.obj is the mesh itself"),
        ("\"$MINDEG\" convert a.gltf -o new.obj -o ./a.gltf", "a.bin is the mesh's data itself"),
        ("\"$MINDEG\" convert a.gltf -o a.gltf", "the mesh's data itself"),
        (
            "cp a.gltf sub/b.gltf; cp a.bin sub; ln sub/b.gltf b.gltf; \"$MINDEG\" convert \
          sub/b.gltf -o b.gltf; code=$?; rm b.gltf sub/b.gltf sub/a.bin; exit $code",
            "the mesh itself",
        ),
        ("\"$MINDEG\" convert a.gltf -o a.bin --format obj", "a.bin is the mesh's data itself"),
        (
            "mv a.obj a.html; ln a.html a.obj; \"$MINDEG\" view a.obj -o a.html; code=$?; rm a.html; \
          exit $code",
            "a.html is the mesh itself that a.obj names",
        ),
        (
            "ln a.bin b.html; \"$MINDEG\" view a.gltf -o b.html; code=$?; rm b.html; exit $code",
            "b.html is the mesh's data itself",
        ),
        ("\"$MINDEG\" view d.json -o sub/link.html", "sub/link.html is the domain itself"),
    ] {
        let (run, unchanged) = run(script);
        assert_eq!(run.code, Some(2), "{script}: {run:?}");
        assert!(run.errors.contains(message), "{script}: {run:?}");
        assert!(unchanged, "{script} changed the folder");
    }
}

#[test]
fn outputs_beside_an_input_are_written() {
    for script in [
        "\"$MINDEG\" mesh d.json -o d.obj",
        "\"$MINDEG\" compare d.json -o d.html",
        "\"$MINDEG\" view d.json -o d.html",
        "\"$MINDEG\" view a.obj -o a.html",
        "\"$MINDEG\" compare d.json other.json -o sub/",
        "\"$MINDEG\" convert a.obj -o b.obj",
        "\"$MINDEG\" mesh - -o d.obj < d.json",
    ] {
        let (run, _) = run(script);
        assert_eq!(run.code, Some(0), "{script}: {run:?}");
    }
}
