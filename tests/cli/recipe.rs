//! `mesh --recipe`, and `verify --reproduce`.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::run::{Run, mindeg, mindeg_reading};
use mindeg_formats::Format;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};

const DOMAIN: &str =
    r#"{"rectangle": {"width": 4, "height": 3}, "size": 0.5, "interior": {"size_inside": 0.5}}"#;

fn written(format: &Format) -> bool {
    format.has_remarks()
}

fn path(folder: &Path, name: &str) -> PathBuf {
    folder.join(name)
}

#[track_caller]
fn mesh(folder: &Path, words: &[&str], output: &str) -> PathBuf {
    let (domain, output) = (path(folder, "my plate.json"), path(folder, output));
    fs::write(&domain, DOMAIN).unwrap();
    let mut all: Vec<&OsStr> = vec!["mesh".as_ref(), domain.as_ref(), "--recipe".as_ref()];
    all.extend(words.iter().map(OsStr::new));
    all.extend(["-q".as_ref(), "-o".as_ref(), output.as_os_str()]);
    let run = mindeg(all);
    assert_eq!(run.code, Some(0), "{}", run.errors);
    output
}

#[track_caller]
fn reproduce(file: &Path) -> Run {
    mindeg(["verify".as_ref(), "--reproduce".as_ref(), file.as_os_str()])
}

#[test]
fn every_format_with_a_place_for_it_can_be_made_anew() {
    let folder = tempfile::tempdir().unwrap();
    for format in Format::WRITTEN.iter().filter(|format| written(format)) {
        let file = mesh(folder.path(), &[], &format!("plate.{}", format.extension()));
        let run = reproduce(&file);
        assert_eq!(run.code, Some(0), "{format:?}: {}", run.errors);
        assert!(run.text().contains("bytes are the same"), "{}", run.text());
        assert!(run.text().contains("mesh my plate.json --recipe -o plate."), "{}", run.text());
        // No folder of this machine is in it.
        let bytes = fs::read(&file).unwrap();
        let place = folder.path().to_str().unwrap().as_bytes();
        assert!(!bytes.windows(place.len()).any(|window| window == place), "{format:?}");
    }
    let other =
        mindeg(["mesh", "--rectangle", "4x3", "--size", "1", "--recipe", "-o", "never.stl"]);
    other.refuses(&["never.stl: a .stl has no place for a recipe"]);
}

#[test]
fn a_file_without_the_option_is_as_it_was() {
    let folder = tempfile::tempdir().unwrap();
    let with = fs::read_to_string(mesh(folder.path(), &[], "with.obj")).unwrap();
    let domain = path(folder.path(), "my plate.json");
    let plain = mindeg([
        "mesh".as_ref(),
        domain.as_os_str(),
        "-q".as_ref(),
        "-o".as_ref(),
        "-".as_ref(),
        "--format".as_ref(),
        "obj".as_ref(),
    ]);
    let plain = plain.text();
    assert!(plain.starts_with("# mindeg ") && !plain.contains("made by"), "{plain}");
    // One line differs.
    let lines = |text: &str| text.lines().skip(1).map(str::to_owned).collect::<Vec<_>>();
    assert_eq!(lines(&with), lines(plain));
}

#[test]
fn two_outputs_and_words_that_reach_no_byte_have_one_recipe() {
    let folder = tempfile::tempdir().unwrap();
    let obj = path(folder.path(), "a.obj");
    mesh(folder.path(), &["--json", "-o", obj.to_str().unwrap()], "b.vtu");
    assert_eq!(reproduce(&obj).code, Some(0));
    assert!(!fs::read_to_string(&obj).unwrap().contains("--json"));
    // Under another name it is the only one of its format.
    let renamed = path(folder.path(), "renamed.obj");
    fs::rename(&obj, &renamed).unwrap();
    assert_eq!(reproduce(&renamed).code, Some(0));
}

#[test]
fn what_was_changed_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let file = mesh(folder.path(), &[], "plate.obj");
    let text = fs::read_to_string(&file).unwrap();
    fs::write(&file, text.replacen("\nf ", "\nf  ", 1)).unwrap();
    let run = reproduce(&file);
    assert_eq!(run.code, Some(3), "{run:?}");
    let at = text.find("\nf ").unwrap() + 3;
    assert!(run.errors.contains(&format!("differs from byte {at} on")), "{}", run.errors);
    let json =
        mindeg(["verify".as_ref(), "--reproduce".as_ref(), "--json".as_ref(), file.as_os_str()]);
    let json: serde_json::Value = serde_json::from_str(json.text()).unwrap();
    assert_eq!((&json["differs_at"], &json["passed"]), (&at.into(), &false.into()));
    assert_eq!(json["inputs"][0], "my plate.json");

    fs::write(&file, text.replacen("mindeg 0.", "mindeg 7.", 1)).unwrap();
    assert!(reproduce(&file).errors.contains("made it, and this is mindeg 0."));

    fs::write(&file, &text).unwrap();
    fs::write(path(folder.path(), "my plate.json"), DOMAIN.replace("0.5", "0.6")).unwrap();
    let run = reproduce(&file);
    assert_eq!(run.code, Some(3), "{run:?}");
    assert!(
        run.errors.contains("made from a file my plate.json with other bytes"),
        "{}",
        run.errors
    );

    fs::remove_file(path(folder.path(), "my plate.json")).unwrap();
    reproduce(&file).refuses(&["was made from my plate.json, which is neither beside it"]);
}

/// A file may come from anywhere: its recipe makes one mesh in a folder of its own, and nothing else.
#[test]
fn a_recipe_reaches_no_other_file() {
    let folder = tempfile::tempdir().unwrap();
    let target = path(folder.path(), "victim.obj");
    let shown = target.display();
    for words in [
        format!("mesh --rectangle 4x3 --size 1 -o {shown}"),
        format!("mesh --rectangle 4x3 --size 1 --output={shown}"),
        "mesh --rectangle 4x3 --size 1 -o ../victim.obj".to_owned(),
        "mesh --rectangle 4x3 --size 1 -o ..%2Fvictim.obj".to_owned(),
        "condition plate.json --limit 20 --within 1 -o victim.obj".to_owned(),
        "degree 12,9,4,4 --proof victim.obj".to_owned(),
        "mesh --help -o victim.obj".to_owned(),
        "mesh --rectangle 4x3 --size 1 -o other.vtu".to_owned(),
    ] {
        let file = path(folder.path(), "plate.obj");
        fs::write(&file, format!("# mindeg 0.1.0 made by: mindeg {words}; no input\nv 0 0 0\n"))
            .unwrap();
        reproduce(&file).refuses(&["so it is not run"]);
        assert!(!target.exists(), "{words}");
    }
    let plain = path(folder.path(), "plain.obj");
    fs::write(&plain, "v 0 0 0\n").unwrap();
    reproduce(&plain).refuses(&["does not say how it was made"]);
}

#[test]
fn a_recipe_needs_files_with_names() {
    let run =
        mindeg_reading(["mesh", "-", "--recipe", "-o", "-", "--format", "obj"], DOMAIN.as_bytes());
    run.refuses(&["standard input is none; give the path of a file"]);
}
