//! Files that appear whole or not at all.
//!
//! A run stages all its outputs, each in a temporary file beside its target, and renames them
//! only when every one of them is complete. An error, a panic or Ctrl-C before that leaves
//! neither a target touched nor a temporary file behind.
//!
//! What is not a regular file (a device, a pipe) cannot be replaced and is written to directly.

use crate::failure::Failure;
use crate::interrupt::temporary;
use crate::room::{self, Planned};
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use tempfile::TempPath;

/// The outputs of one run.
#[derive(Debug, Default)]
pub(crate) struct Outputs {
    staged: Vec<Staged>,
}

#[derive(Debug)]
struct Staged {
    temporary: TempPath,
    /// As the user named it.
    name: PathBuf,
    target: PathBuf,
    least_len: u64,
}

impl Outputs {
    /// Opens `path` for writing `least_len` bytes or more; until [`finish`](Self::finish), what is
    /// written goes beside it.
    pub(crate) fn create(&mut self, path: &Path, least_len: u64) -> Result<File, Failure> {
        let failed = |error: io::Error| cannot_write(path, &error);
        let target = match fs::metadata(path) {
            Ok(metadata) if metadata.is_dir() => {
                return Err(Failure::Io(format!(
                    "cannot write {}: it is a folder",
                    path.display()
                )));
            }
            // A link is followed, so that what it points to is replaced and not the link.
            Ok(metadata) if metadata.is_file() => fs::canonicalize(path).map_err(failed)?,
            Ok(_) => return File::options().write(true).open(path).map_err(failed),
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
                let folder = fs::canonicalize(folder.unwrap_or(Path::new("."))).map_err(failed)?;
                folder.join(path.file_name().ok_or(error).map_err(failed)?)
            }
            Err(error) => return Err(failed(error)),
        };
        if let Some(other) = self.staged.iter().find(|other| other.target == target) {
            let (other, path) = (other.name.display(), path.display());
            return Err(Failure::Input(format!("{other} and {path} are the same file")));
        }
        let (file, temporary) = stage(&target).map_err(failed)?;
        self.staged.push(Staged { temporary, name: path.to_path_buf(), target, least_len });
        Ok(file)
    }

    /// Refuses files that do not fit where they are to go, and says what to do instead.
    pub(crate) fn check_room(&self, way_out: &str) -> Result<(), Failure> {
        let planned = self.staged.iter().map(|Staged { temporary, name, least_len, .. }| {
            let folder = temporary.parent().unwrap_or(Path::new("."));
            Planned { name, folder, least_len: *least_len }
        });
        room::check(planned, way_out)
    }

    /// Gives every file its name.
    pub(crate) fn finish(self) -> Result<(), Failure> {
        // An interrupt now finds all files renamed, or none.
        let _all_or_none = temporary();
        for Staged { temporary, name, target, .. } in self.staged {
            temporary.persist(target).map_err(|error| cannot_write(&name, &error.error))?;
        }
        Ok(())
    }
}

/// A temporary file beside `target`.
fn stage(target: &Path) -> io::Result<(File, TempPath)> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".mindeg-").suffix(".part");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // As any new file: what the user's mask leaves of this.
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    // Held while the file is made, so that an interrupt finds it listed.
    let mut listed = temporary();
    let made = builder.tempfile_in(target.parent().unwrap_or(Path::new(".")))?;
    listed.push(made.path().to_path_buf());
    Ok(made.into_parts())
}

/// The failure of writing to the file that the user named.
pub(crate) fn cannot_write(path: &Path, error: &io::Error) -> Failure {
    if error.kind() == io::ErrorKind::BrokenPipe {
        return Failure::ClosedPipe;
    }
    Failure::Io(format!("cannot write {}: {error}", path.display()))
}
