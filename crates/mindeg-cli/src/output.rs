//! Files that appear whole or not at all.
//!
//! A run stages all its outputs, each in a temporary file beside its target, and renames them
//! only when every one of them is complete. An error, a panic or Ctrl-C before that leaves
//! neither a target touched nor a temporary file behind.
//!
//! What is not a regular file (a device, a pipe) cannot be replaced and is written to directly, and
//! so is what was opened for this process by others.
//!
//! Limits: a rename that fails leaves the files renamed before it. A process that runs out of
//! memory cleans nothing up.

use crate::failure::Failure;
use crate::interrupt::temporary;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
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
}

impl Outputs {
    /// Opens `path` for writing; until [`finish`](Self::finish), what is written goes beside it.
    pub(crate) fn create(&mut self, path: &Path) -> Result<File, Failure> {
        let failed = |error: io::Error| cannot_write(path, &error);
        let refused = |why| Failure::Io(format!("cannot write {}: it is {why}", path.display()));
        if names_descriptor(path) {
            return File::options().append(true).open(path).map_err(failed);
        }
        let (target, permissions) = match fs::metadata(path) {
            Ok(metadata) if metadata.is_dir() => return Err(refused("a folder")),
            Ok(metadata) if !metadata.is_file() => {
                return File::options().write(true).open(path).map_err(failed);
            }
            Ok(metadata) if metadata.permissions().readonly() => return Err(refused("read-only")),
            // A link is followed, so that what it points to is replaced and not the link.
            Ok(metadata) => (fs::canonicalize(path).map_err(failed)?, Some(metadata.permissions())),
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                (new_file(path).map_err(failed)?, None)
            }
            Err(error) => return Err(failed(error)),
        };
        if let Some(other) = self.staged.iter().find(|other| other.target == target) {
            let (other, path) = (other.name.display(), path.display());
            return Err(Failure::Input(format!("{other} and {path} are the same file")));
        }
        let (file, temporary) = stage(&target, permissions).map_err(failed)?;
        self.staged.push(Staged { temporary, name: path.to_path_buf(), target });
        Ok(file)
    }

    /// Writes `path` with `write`, which need not write much at a time.
    pub(crate) fn write(
        &mut self,
        path: &Path,
        write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<(), Failure> {
        let mut file = BufWriter::new(self.create(path)?);
        write(&mut file).and_then(|()| file.flush()).map_err(|error| cannot_write(path, &error))
    }

    /// Gives every file its name.
    pub(crate) fn finish(self) -> Result<(), Failure> {
        // An interrupt now finds all files renamed, or none.
        let _all_or_none = temporary();
        // What can be seen to fail fails before the first of them.
        if let Some(folder) = self.staged.iter().find(|file| file.target.is_dir()) {
            let error = io::ErrorKind::IsADirectory.into();
            return Err(cannot_write(&folder.name, &error));
        }
        for Staged { temporary, name, target, .. } in self.staged {
            temporary.persist(target).map_err(|error| cannot_write(&name, &error.error))?;
        }
        Ok(())
    }
}

/// Whether a path stands for a descriptor of this process. Whoever opened it may have written to
/// what is behind it: so that is never replaced, not even if it is a file.
fn names_descriptor(path: &Path) -> bool {
    path == Path::new("/dev/stderr")
        || path.starts_with("/dev/fd")
        || path.starts_with("/proc/self/fd")
}

/// Where a file is made under a name that does not exist, or is a link to one that does not.
fn new_file(path: &Path) -> io::Result<PathBuf> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    let folder = fs::canonicalize(folder.unwrap_or(Path::new(".")))?;
    let target = folder.join(path.file_name().ok_or(io::ErrorKind::NotFound)?);
    match fs::read_link(&target) {
        Ok(link) => new_file(&folder.join(link)),
        Err(_) => Ok(target),
    }
}

/// A temporary file beside `target`, with the permissions of the file that it replaces.
fn stage(target: &Path, permissions: Option<fs::Permissions>) -> io::Result<(File, TempPath)> {
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
    if let Some(permissions) = permissions {
        made.as_file().set_permissions(permissions)?;
    }
    Ok(made.into_parts())
}

/// The failure of writing to the file that the user named.
pub(crate) fn cannot_write(path: &Path, error: &io::Error) -> Failure {
    if error.kind() == io::ErrorKind::BrokenPipe {
        return Failure::ClosedPipe;
    }
    Failure::Io(format!("cannot write {}: {error}", path.display()))
}
