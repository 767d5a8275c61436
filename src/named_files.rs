//! A file for each polygon: the pattern gives names of files that do not exist yet.

use crate::failure::Failure;
use mindeg_files::{Polygon, cannot_write, is_standard_output};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Whether an output stands for a file for each polygon: a folder, or a name with `{name}` or
/// `{index}`.
pub(crate) fn is_pattern(path: &Path) -> bool {
    is_folder(path) || path.to_str().is_some_and(|text| PLACES.iter().any(|it| text.contains(it)))
}

/// The placeholders of a pattern.
const PLACES: [&str; 2] = ["{name}", "{index}"];

fn is_folder(path: &Path) -> bool {
    path.is_dir() || path.as_os_str().to_string_lossy().ends_with(std::path::is_separator)
}

/// The file of each polygon. Names differ, also where case does not count.
///
/// `extension` is for folders. A name that no file can have gets other characters.
pub(crate) fn names(pattern: &Path, polygons: &[Polygon], extension: &str) -> Vec<PathBuf> {
    let in_folder = is_folder(pattern);
    let pattern_text = pattern.to_string_lossy();
    let mut taken = BTreeSet::new();
    let name = |polygon: &Polygon| {
        let stem = file_stem(&polygon.name());
        let index = polygon.index.to_string();
        let fill = |name: &str| {
            if in_folder {
                pattern.join(format!("{name}.{extension}"))
            } else {
                PathBuf::from(pattern_text.replace("{name}", name).replace("{index}", &index))
            }
        };
        let path = fill(&stem);
        if taken.insert(path.to_string_lossy().to_lowercase()) {
            return path;
        }
        // Indices are unique, so a name with its index is unique.
        let path = fill(&format!("{stem}-{index}"));
        taken.insert(path.to_string_lossy().to_lowercase());
        path
    };
    polygons.iter().map(name).collect()
}

/// Makes the folders of files that are to be new, and refuses if one of them exists.
pub(crate) fn prepare(files: &[PathBuf]) -> Result<(), Failure> {
    let mut seen = BTreeSet::new();
    for file in files {
        if is_standard_output(file) {
            continue;
        }
        if fs::symlink_metadata(file).is_ok() {
            return Err(Failure::Io(format!(
                "{} exists; a file for each polygon overwrites none: remove it, or give another \
                 folder",
                file.display()
            )));
        }
        if !seen.insert(file) {
            return Err(Failure::Input(format!(
                "two polygons would write {}; put {{name}} or {{index}} into the name",
                file.display()
            )));
        }
    }
    let folders: BTreeSet<&Path> = files.iter().filter_map(|file| file.parent()).collect();
    for folder in folders.into_iter().filter(|folder| !folder.as_os_str().is_empty()) {
        fs::create_dir_all(folder).map_err(|error| cannot_write(folder, &error))?;
    }
    Ok(())
}

/// All failures of several as one: it is one of reading or writing if any of them is.
pub(crate) fn summed_up(failures: Vec<Failure>, of: usize, what: &str) -> Result<(), Failure> {
    if failures.is_empty() {
        return Ok(());
    }
    let lines: Vec<&str> = failures.iter().filter_map(Failure::message).collect();
    let message = format!("{} of {of} {what}\n{}", failures.len(), lines.join("\n"));
    let is = |wanted: fn(&Failure) -> bool| failures.iter().any(wanted);
    Err(if is(|failure| matches!(failure, Failure::Io(_) | Failure::ClosedPipe)) {
        Failure::Io(message)
    } else if is(|failure| matches!(failure, Failure::Input(_) | Failure::Domain { .. })) {
        Failure::Input(message)
    } else {
        Failure::Gate(message)
    })
}

/// A name as that of a file on any system: letters, digits, dots, dashes and underscores; blanks
/// become dashes.
fn file_stem(name: &str) -> String {
    /// Names longer than 255 bytes are refused by most systems.
    const LONGEST: usize = 50;
    let safe = |c: char| match c {
        c if c.is_alphanumeric() || matches!(c, '.' | '-' | '_') => c,
        c if c.is_whitespace() => '-',
        _ => '_',
    };
    let stem: String = name.trim().chars().map(safe).take(LONGEST).collect();
    // A leading dot hides a file; dots at the end are lost on Windows.
    let stem = stem.trim_matches('.');
    if stem.is_empty() { "polygon".to_owned() } else { stem.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_files_are_safe() {
        for (name, stem) in [
            ("Chile", "Chile"),
            ("Côte d'Ivoire 2", "Côte-d_Ivoire-2"),
            ("../../etc/passwd", "_.._etc_passwd"),
            ("..", "polygon"),
            ("a\\b:c*?\u{0}", "a_b_c___"),
            ("", "polygon"),
        ] {
            assert_eq!(file_stem(name), stem);
        }
        assert_eq!(file_stem(&"ä".repeat(500)).chars().count(), 50);
    }
}
