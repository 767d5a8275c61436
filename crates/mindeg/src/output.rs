//! Files that appear whole or not at all.
//!
//! A run stages all its outputs, each in a temporary file beside its target, and renames them
//! only when every one of them is complete. An error, a panic or Ctrl-C before that leaves
//! neither a target touched nor a temporary file behind.
//!
//! What is not a regular file (a device, a pipe) cannot be replaced and is written to directly.

use crate::failure::Failure;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use tempfile::TempPath;

/// The temporary files to delete when the process is told to stop.
static TEMPORARY: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// From here on, Ctrl-C and its like delete the temporary files before they end the process.
pub(crate) fn clean_up_on_interrupt() -> Result<(), Failure> {
    ctrlc::set_handler(|| {
        for path in TEMPORARY.lock().unwrap_or_else(PoisonError::into_inner).iter() {
            // A file renamed or deleted meanwhile is no longer there under this name.
            let _ = fs::remove_file(path);
        }
        // What shells report for a program that SIGINT ended.
        std::process::exit(130);
    })
    .map_err(|error| Failure::Io(format!("cannot listen for Ctrl-C: {error}")))
}

/// The outputs of one run.
#[derive(Debug, Default)]
pub(crate) struct Outputs {
    staged: Vec<(TempPath, PathBuf)>,
}

impl Outputs {
    /// Opens `path` for writing; until [`finish`](Self::finish), what is written goes beside it.
    pub(crate) fn create(&mut self, path: &Path) -> Result<File, Failure> {
        let failed = |error: io::Error| cannot_write(path, &error);
        match fs::metadata(path) {
            Ok(metadata) if metadata.is_dir() => {
                Err(Failure::Io(format!("cannot write {}: it is a folder", path.display())))
            }
            // A link is followed, so that what it points to is replaced and not the link.
            Ok(metadata) if metadata.is_file() => {
                self.stage(fs::canonicalize(path).map_err(failed)?).map_err(failed)
            }
            Ok(_) => File::options().write(true).open(path).map_err(failed),
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                self.stage(path.to_path_buf()).map_err(failed)
            }
            Err(error) => Err(failed(error)),
        }
    }

    fn stage(&mut self, target: PathBuf) -> io::Result<File> {
        let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty());
        let mut builder = tempfile::Builder::new();
        builder.prefix(".mindeg-").suffix(".part");
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            // As any new file: what the user's mask leaves of this.
            builder.permissions(fs::Permissions::from_mode(0o666));
        }
        // Locked while the file is made, so that an interrupt finds it listed.
        let mut listed = TEMPORARY.lock().unwrap_or_else(PoisonError::into_inner);
        let made = builder.tempfile_in(folder.unwrap_or(Path::new(".")))?;
        listed.push(made.path().to_path_buf());
        let (file, temporary) = made.into_parts();
        self.staged.push((temporary, target));
        Ok(file)
    }

    /// Gives every file its name.
    pub(crate) fn finish(self) -> Result<(), Failure> {
        for (temporary, target) in self.staged {
            temporary.persist(&target).map_err(|error| cannot_write(&target, &error.error))?;
        }
        Ok(())
    }
}

/// The failure of writing to the file that the user named.
pub(crate) fn cannot_write(path: &Path, error: &io::Error) -> Failure {
    if error.kind() == io::ErrorKind::BrokenPipe {
        return Failure::ClosedPipe;
    }
    Failure::Io(format!("cannot write {}: {error}", path.display()))
}
