//! Whether files fit where they are to go.
//!
//! Limits: a quota shows only once it is reached, and so does what others write meanwhile. File
//! systems that do not tell how much room they have take everything, and those that compress are
//! taken at their word.

use crate::failure::Failure;
use indicatif::DecimalBytes;
use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::Path;

/// A file to be, with the folder that it will take room in.
pub(crate) struct Planned<'a> {
    pub(crate) name: &'a Path,
    pub(crate) folder: &'a Path,
    /// It will take so many bytes or more.
    pub(crate) least_len: u64,
}

/// Refuses files that together take more than is free in their file system, and says what to do
/// instead.
pub(crate) fn check<'a>(
    files: impl IntoIterator<Item = Planned<'a>>,
    way_out: &str,
) -> Result<(), Failure> {
    let mut by_file_system = BTreeMap::<_, Vec<Planned<'_>>>::new();
    for file in files {
        // What cannot be asked is not refused: if there is something wrong, writing will tell.
        if let Ok(file_system) = file_system(file.folder) {
            by_file_system.entry(file_system).or_default().push(file);
        }
    }
    for files in by_file_system.values() {
        let Some(free) = files.iter().find_map(|file| free(file.folder)) else { continue };
        let needed: u64 = files.iter().map(|file| file.least_len).sum();
        if needed > free {
            let names: Vec<_> = files.iter().map(|file| file.name.display().to_string()).collect();
            return Err(Failure::Io(format!(
                "{} would take {} or more, and {} are free where {}; {way_out}",
                names.join(" and "),
                DecimalBytes(needed),
                DecimalBytes(free),
                if names.len() == 1 { "it goes" } else { "they go" },
            )));
        }
    }
    Ok(())
}

/// What tells the file system of a folder from others.
#[cfg(unix)]
fn file_system(folder: &Path) -> io::Result<u64> {
    use std::os::unix::fs::MetadataExt;
    Ok(fs::metadata(folder)?.dev())
}

/// The folder itself: several of them in one file system are not added up.
#[cfg(not(unix))]
fn file_system(folder: &Path) -> io::Result<std::path::PathBuf> {
    fs::canonicalize(folder)
}

/// The bytes that may still be written in a folder, if its file system tells.
fn free(folder: &Path) -> Option<u64> {
    let space = fs4::statvfs(folder).ok()?;
    // Some that are no disks say that they have no room at all.
    (space.total_space() > 0).then(|| space.available_space())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_goes_to_one_file_system_is_added_up() {
        let folder = tempfile::tempdir().expect("a folder");
        let other = folder.path().join("other");
        fs::create_dir(&other).expect("a folder");
        let Some(free) = free(folder.path()) else { return };
        let planned =
            |name, folder, least_len| Planned { name: Path::new(name), folder, least_len };
        let most = free / 4 * 3;
        let first = || planned("a.obj", folder.path(), most);
        assert!(check([first(), planned("b.obj", &other, 0)], "").is_ok());
        // Of a folder that is not there nothing is known.
        let missing = folder.path().join("missing");
        assert!(check([planned("c.obj", &missing, u64::MAX)], "").is_ok());
        if cfg!(unix) {
            let failure = check([first(), planned("b.obj", &other, most)], "buy one");
            let failure = failure.expect_err("half as much again as there is");
            let message = failure.message().expect("it says why").to_owned();
            assert!(message.starts_with("a.obj and b.obj would take "), "{message}");
            assert!(message.ends_with(" are free where they go; buy one"), "{message}");
        }
        let failure = check([planned("a.obj", folder.path(), u64::MAX)], "buy one");
        let message = failure.expect_err("no disk takes that").message().map(str::to_owned);
        assert!(message.is_some_and(|message| message.ends_with("where it goes; buy one")));
    }
}
