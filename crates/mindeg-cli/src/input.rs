//! The files that were read: no output may replace one of them, whatever its name.

use crate::failure::Failure;
use std::fs::{self, Metadata};
use std::io::{self, Read};
use std::path::Path;
use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};

/// A regular file that was opened for reading.
#[derive(Debug)]
struct Input {
    /// As the user named it.
    name: String,
    /// Such as "domain".
    what: &'static str,
    identity: Identity,
}

/// What all names of a file have in common: the device, and the file's number on it.
#[cfg(unix)]
type Identity = (u64, u64);

/// What all names of a file but hard links have in common: the path without links.
#[cfg(not(unix))]
type Identity = std::path::PathBuf;

static INPUTS: Mutex<Vec<Input>> = Mutex::new(Vec::new());

fn inputs() -> MutexGuard<'static, Vec<Input>> {
    INPUTS.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Notes that the file at `path` is read as a `what`, such as "domain". To be called before any
/// output is opened.
pub(crate) fn note(path: &Path, what: &'static str) {
    if let Ok(metadata) = fs::metadata(path) {
        note_file(path.display().to_string(), what, path, &metadata);
    }
}

/// What messages call the file at `path`.
pub(crate) fn name_of(path: &Path) -> String {
    if path == Path::new("-") { "standard input".to_owned() } else { path.display().to_string() }
}

/// All of standard input, which is read once and noted as a `what`.
pub(crate) fn standard_input(what: &'static str) -> io::Result<&'static [u8]> {
    static BYTES: OnceLock<Vec<u8>> = OnceLock::new();
    if let Some(bytes) = BYTES.get() {
        return Ok(bytes);
    }
    note_standard_input(what);
    let mut bytes = Vec::new();
    io::stdin().lock().read_to_end(&mut bytes)?;
    Ok(BYTES.get_or_init(|| bytes))
}

/// Notes that standard input is read, which can be a file.
pub(crate) fn note_standard_input(what: &'static str) {
    let name = "standard input".to_owned();
    #[cfg(unix)]
    if let Some(metadata) = stream_metadata(&std::io::stdin()) {
        note_file(name, what, Path::new("-"), &metadata);
    }
    #[cfg(not(unix))]
    let _ = (name, what);
}

fn note_file(name: String, what: &'static str, path: &Path, metadata: &Metadata) {
    if metadata.is_file()
        && let Some(identity) = identity(path, metadata)
    {
        inputs().push(Input { name, what, identity });
    }
}

/// Fails if `path` is a file that was read.
pub(crate) fn refuse_as_output(path: &Path) -> Result<(), Failure> {
    match fs::metadata(path) {
        Ok(metadata) => refuse(&path.display().to_string(), path, &metadata),
        // What does not exist was not read; what else is wrong shows when it is opened.
        Err(_) => Ok(()),
    }
}

/// Fails if standard output is a file that was read.
pub(crate) fn refuse_as_standard_output() -> Result<(), Failure> {
    #[cfg(unix)]
    if let Some(metadata) = stream_metadata(&std::io::stdout()) {
        return refuse("standard output", Path::new("-"), &metadata);
    }
    Ok(())
}

fn refuse(name: &str, path: &Path, metadata: &Metadata) -> Result<(), Failure> {
    let Some(identity) = identity(path, metadata) else { return Ok(()) };
    let inputs = inputs();
    let Some(input) = inputs.iter().find(|input| input.identity == identity) else {
        return Ok(());
    };
    let what = input.what;
    let itself =
        if input.name == name { String::new() } else { format!(" that {} names", input.name) };
    Err(Failure::Input(format!("{name} is the {what} itself{itself}; give another output")))
}

#[cfg(unix)]
fn identity(_: &Path, metadata: &Metadata) -> Option<Identity> {
    use std::os::unix::fs::MetadataExt;
    Some((metadata.dev(), metadata.ino()))
}

#[cfg(not(unix))]
fn identity(path: &Path, _: &Metadata) -> Option<Identity> {
    fs::canonicalize(path).ok()
}

#[cfg(unix)]
fn stream_metadata(stream: &impl std::os::fd::AsFd) -> Option<Metadata> {
    let descriptor = stream.as_fd().try_clone_to_owned().ok()?;
    fs::File::from(descriptor).metadata().ok()
}
