//! Files that appear whole or not at all.
//!
//! A run stages all its outputs, each in a temporary file beside its target, and renames them
//! only when every one of them is complete. An error, a panic or Ctrl-C before that leaves
//! neither a target touched nor a temporary file behind.
//!
//! A device or a pipe cannot be replaced and is written to directly, and
//! so is what was opened for this process by others. Links are refused: replacing a link, or one of a
//! file's names, would leave a second file with the old content.
//!
//! Limits: a rename that fails leaves the files renamed before it. A process that runs out of
//! memory cleans nothing up.

use crate::error::{FileError, plainly};
use crate::session::Session;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use tempfile::TempPath;

/// The outputs of one run.
#[derive(Debug)]
pub struct Outputs<'a> {
    session: &'a Session,
    staged: Vec<Staged>,
}

#[derive(Debug)]
struct Staged {
    temporary: TempPath,
    /// As the user named it.
    name: PathBuf,
    target: PathBuf,
}

impl<'a> Outputs<'a> {
    /// No outputs as yet.
    #[must_use]
    pub fn new(session: &'a Session) -> Self {
        Self { session, staged: Vec::new() }
    }

    /// Opens `path` for writing, or standard output where it names that; until
    /// [`finish`](Self::finish), what is written to a file goes beside it.
    ///
    /// # Errors
    ///
    /// An output that cannot be written, is a link, a folder or read-only, or is a file that was read.
    pub fn open(&mut self, path: &Path) -> Result<Box<dyn Write + Send>, FileError> {
        if !is_standard_output(path) {
            return Ok(Box::new(self.create(path)?));
        }
        self.session.refuse_input_as_standard_output()?;
        if standard_output_is_closed() {
            let message = "cannot write to standard output: it is closed";
            return Err(FileError::system(message, io::ErrorKind::NotConnected));
        }
        Ok(Box::new(io::stdout()))
    }

    fn create(&mut self, path: &Path) -> Result<File, FileError> {
        let failed = |error: io::Error| cannot_write(path, &error);
        let refused = |why| {
            let message = format!("cannot write {}: it is {why}", path.display());
            FileError::system(message, io::ErrorKind::AlreadyExists)
        };
        self.session.refuse_input(path)?;
        let last = path.as_os_str().as_encoded_bytes().last();
        if last.is_some_and(|byte| std::path::is_separator(char::from(*byte))) {
            return Err(refused("the name of a folder; name a file in it"));
        }
        if names_descriptor(path) {
            return File::options().append(true).open(path).map_err(failed);
        }
        let (target, permissions) = match fs::symlink_metadata(path) {
            // Whether the link is meant or what it leads to is for the user to say.
            Ok(metadata) if metadata.is_symlink() => {
                return Err(refused("a link; name the file that it leads to, or remove the link"));
            }
            Ok(metadata) if metadata.is_dir() => return Err(refused("a folder")),
            Ok(metadata) if !metadata.is_file() => {
                return File::options().write(true).open(path).map_err(failed);
            }
            Ok(metadata) if metadata.permissions().readonly() => return Err(refused("read-only")),
            Ok(metadata) if has_other_names(&metadata) => {
                return Err(refused(
                    "a file with a second name, a hard link, which would keep the old content; \
                     remove this name, or give another output",
                ));
            }
            Ok(metadata) => (fs::canonicalize(path).map_err(failed)?, Some(metadata.permissions())),
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                (new_file(path).map_err(|error| cannot_create(path, &error))?, None)
            }
            Err(error) => return Err(failed(error)),
        };
        if let Some(other) = self.staged.iter().find(|other| other.target == target) {
            return Err(FileError::wrong(same_file(&other.name, path)));
        }
        let staged = self.stage(&target, permissions);
        let (file, temporary) = staged.map_err(|error| cannot_create(path, &error))?;
        self.staged.push(Staged { temporary, name: path.to_path_buf(), target });
        Ok(file)
    }

    /// A temporary file beside `target`, with the permissions of the file that it replaces.
    fn stage(
        &self,
        target: &Path,
        permissions: Option<fs::Permissions>,
    ) -> io::Result<(File, TempPath)> {
        let mut builder = tempfile::Builder::new();
        builder.prefix(".mindeg-").suffix(".part");
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            // As any new file: what the user's mask leaves of this.
            builder.permissions(fs::Permissions::from_mode(0o666));
        }
        // Held while the file is made, so that an interrupt finds it listed.
        let mut listed = self.session.temporary();
        let made = builder.tempfile_in(target.parent().unwrap_or(Path::new(".")))?;
        listed.push(made.path().to_path_buf());
        if let Some(permissions) = permissions {
            made.as_file().set_permissions(permissions)?;
        }
        Ok(made.into_parts())
    }

    /// Gives every file its name.
    ///
    /// # Errors
    ///
    /// A name that has become a folder's meanwhile, or that the system refuses.
    pub fn finish(self) -> Result<(), FileError> {
        // An interrupt now finds all files renamed, or none.
        let _all_or_none = self.session.temporary();
        // Check what can be checked before renaming the first file.
        if let Some(folder) = self.staged.iter().find(|file| file.target.is_dir()) {
            let error = io::ErrorKind::IsADirectory.into();
            return Err(cannot_write(&folder.name, &error));
        }
        for Staged { temporary, name, target } in self.staged {
            temporary.persist(target).map_err(|error| cannot_write(&name, &error.error))?;
        }
        Ok(())
    }
}

/// Whether a path stands for standard output.
#[must_use]
pub fn is_standard_output(path: &Path) -> bool {
    ["-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"].map(Path::new).contains(&path)
}

/// Whether this process was started without a standard output.
///
/// Rust then opens `/dev/null` in its place, for reading and writing. Whoever sends standard output
/// there on purpose opens it for writing; a program that opens it for both, as Python's
/// `subprocess.DEVNULL` does, cannot be told from none.
fn standard_output_is_closed() -> bool {
    let is_null = fs::read_link("/proc/self/fd/1").is_ok_and(|path| path == Path::new("/dev/null"));
    let information = fs::read_to_string("/proc/self/fdinfo/1").unwrap_or_default();
    let flags = information.lines().find_map(|line| line.strip_prefix("flags:"));
    // In octal; O_RDWR is 2 of the lowest two bits.
    is_null && flags.is_some_and(|flags| flags.ends_with('2'))
}

/// Whether a path stands for a descriptor of this process. Whoever opened it may have written to
/// what is behind it: so that is never replaced, not even if it is a file.
fn names_descriptor(path: &Path) -> bool {
    let is_numbered = |folder: &str| {
        let number = path.strip_prefix(folder).ok().and_then(Path::to_str);
        number.is_some_and(|number| number.parse::<u32>().is_ok())
    };
    path == Path::new("/dev/stderr") || is_numbered("/dev/fd") || is_numbered("/proc/self/fd")
}

#[cfg(test)]
#[test]
fn descriptors_have_numbers_and_nothing_behind_them() {
    for (path, expected) in [
        ("/dev/fd/1", true),
        ("/proc/self/fd/12", true),
        ("/dev/stderr", true),
        ("/dev/fd/../../tmp/x.obj", false),
        ("/dev/fd/1/../../../tmp/x.obj", false),
        ("/dev/fd", false),
        ("fd/1", false),
    ] {
        assert_eq!(names_descriptor(Path::new(path)), expected, "{path}");
    }
}

/// Where a file is made under a name that does not exist.
fn new_file(path: &Path) -> io::Result<PathBuf> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    let folder = fs::canonicalize(folder.unwrap_or(Path::new(".")))?;
    Ok(folder.join(path.file_name().ok_or(io::ErrorKind::NotFound)?))
}

/// Whether a file has hard links.
#[cfg(unix)]
fn has_other_names(metadata: &fs::Metadata) -> bool {
    std::os::unix::fs::MetadataExt::nlink(metadata) > 1
}

/// Nothing tells.
#[cfg(not(unix))]
fn has_other_names(_: &fs::Metadata) -> bool {
    false
}

/// Two outputs are one file: says so, and how, where the user named only one of them.
fn same_file(first: &Path, second: &Path) -> String {
    let of_gltf = |path: &Path| match path.extension() {
        Some(name) if name.eq_ignore_ascii_case("bin") => " (a .gltf has a .bin beside it)",
        _ => "",
    };
    if first == second {
        let path = first.display();
        return format!("two outputs would write {path}{}", of_gltf(first));
    }
    format!("{} and {} are the same file{}", first.display(), second.display(), of_gltf(first))
}

/// Writes to the output opened for `path`; `write` need not write much at a time.
///
/// # Errors
///
/// The errors of `write`, with the name of the file.
pub fn write_to(
    path: &Path,
    out: Box<dyn Write + Send>,
    write: impl FnOnce(&mut (dyn Write + Send)) -> io::Result<()>,
) -> Result<(), FileError> {
    let mut out = BufWriter::new(out);
    write(&mut out).and_then(|()| out.flush()).map_err(|error| cannot_write(path, &error))
}

/// The failure of making a file in the folder where the user wants one.
fn cannot_create(path: &Path, error: &io::Error) -> FileError {
    let advice = match error.kind() {
        io::ErrorKind::PermissionDenied => "; its folder takes no new files",
        io::ErrorKind::NotFound => "; its folder does not exist",
        _ => "",
    };
    let message = format!("cannot write {}: {}{advice}", path.display(), plainly(error));
    FileError::system(message, error.kind())
}

/// The failure of writing to the file that the user named.
#[must_use]
pub fn cannot_write(path: &Path, error: &io::Error) -> FileError {
    let name = if is_standard_output(path) {
        "to standard output".to_owned()
    } else {
        path.display().to_string()
    };
    FileError::system(format!("cannot write {name}: {}", plainly(error)), error.kind())
}
