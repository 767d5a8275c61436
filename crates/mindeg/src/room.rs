//! Whether files fit where they are to go.
//!
//! Limits: a quota shows only once it is reached, and so does what others write meanwhile. File
//! systems that do not tell how much room they have take everything.

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
