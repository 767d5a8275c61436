//! The files that one run has read and is writing.

use crate::error::FileError;
use crate::recipe::Recipe;
use std::ffi::OsString;
use std::fs::{self, Metadata};
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The name of standard input.
const STANDARD_INPUT: &str = "standard input";

/// The files of one run: those that it has read, which no output may replace, and the temporary files
/// of outputs that are not complete.
#[derive(Debug)]
pub struct Session {
    inputs: Mutex<Vec<Noted>>,
    temporary: Mutex<Vec<PathBuf>>,
    /// The prefix of options in messages: `--` on a command line.
    dashes: &'static str,
}

/// A file that was opened for reading.
#[derive(Debug)]
struct Noted {
    /// As the user named it.
    name: String,
    /// Its kind in messages: "domain".
    what: &'static str,
    /// `None` for what can be read once: a pipe.
    identity: Option<Identity>,
}

/// The same for all names of a file: the device, and the file's number on it.
#[cfg(unix)]
type Identity = (u64, u64);

/// The same for all names of a file but hard links: the path without links.
#[cfg(not(unix))]
type Identity = PathBuf;

impl Session {
    /// A run that has read and written nothing. Where messages name an option, it begins with
    /// `dashes`: `--` on a command line, nothing for keyword arguments.
    #[must_use]
    pub const fn new(dashes: &'static str) -> Self {
        Self { inputs: Mutex::new(Vec::new()), temporary: Mutex::new(Vec::new()), dashes }
    }

    /// The temporary files of outputs that are not complete, for whoever ends the process.
    ///
    /// While this lock is held, no file is created and no set of files is renamed.
    pub fn temporary(&self) -> MutexGuard<'_, Vec<PathBuf>> {
        self.temporary.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// An option as a message names it.
    pub(crate) fn option(&self, name: &str) -> String {
        format!("{}{name}", self.dashes)
    }

    /// The prefix of options.
    pub(crate) fn dashes(&self) -> &'static str {
        self.dashes
    }

    /// Notes that the file at `path` is read as a `what`, such as "domain": from then on no output may
    /// replace it.
    pub fn note(&self, path: &Path, what: &'static str) {
        if let Ok(metadata) = fs::metadata(path) {
            self.note_file(path.display().to_string(), what, path, &metadata);
        }
    }

    /// All of standard input, which is noted as a `what`.
    pub(crate) fn standard_input(&self, what: &'static str) -> io::Result<Vec<u8>> {
        let stdin = io::stdin().lock();
        #[cfg(unix)]
        let metadata = stream_metadata(&stdin);
        #[cfg(not(unix))]
        let metadata: Option<Metadata> = None;
        match &metadata {
            Some(metadata) => {
                self.note_file(STANDARD_INPUT.to_owned(), what, Path::new("-"), metadata);
            }
            None => {
                self.inputs().push(Noted { name: STANDARD_INPUT.to_owned(), what, identity: None });
            }
        }
        whole(stdin, metadata.is_some_and(|it| it.is_file()))
    }

    fn note_file(&self, name: String, what: &'static str, path: &Path, metadata: &Metadata) {
        let identity = identity(path, metadata).filter(|_| metadata.is_file());
        self.inputs().push(Noted { name, what, identity });
    }

    fn inputs(&self) -> MutexGuard<'_, Vec<Noted>> {
        self.inputs.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The recipe of the run: its arguments, the files read so far with their digests as they are now, and the outputs.
    ///
    /// # Errors
    ///
    /// An input that is no file of its own name, such as standard input; two that differ under one name; words that are
    /// not UTF-8 text or lead to another folder than a file of theirs.
    pub fn recipe(&self, arguments: &[OsString], outputs: &[PathBuf]) -> Result<Recipe, FileError> {
        let inputs = self.inputs();
        if let Some(once) =
            inputs.iter().find(|input| input.identity.is_none() || input.name == STANDARD_INPUT)
        {
            return Err(FileError::wrong(format!(
                "a recipe names the files that a mesh is made from, and {} is none; give the path of a file",
                once.name
            )));
        }
        let inputs: Vec<PathBuf> = inputs.iter().map(|input| PathBuf::from(&input.name)).collect();
        Recipe::new(arguments, &inputs, outputs)
    }

    /// Fails if `path` is a file that was read.
    ///
    /// # Errors
    ///
    /// Which file it is.
    pub fn refuse_input(&self, path: &Path) -> Result<(), FileError> {
        match fs::metadata(path) {
            Ok(metadata) => self.refuse(&path.display().to_string(), path, &metadata),
            // A missing file was not read; other errors show when it is opened.
            Err(_) => Ok(()),
        }
    }

    /// Fails if standard output is a file that was read.
    pub(crate) fn refuse_input_as_standard_output(&self) -> Result<(), FileError> {
        #[cfg(unix)]
        if let Some(metadata) = stream_metadata(&io::stdout()) {
            return self.refuse("standard output", Path::new("-"), &metadata);
        }
        Ok(())
    }

    fn refuse(&self, name: &str, path: &Path, metadata: &Metadata) -> Result<(), FileError> {
        let Some(identity) = identity(path, metadata) else { return Ok(()) };
        let inputs = self.inputs();
        let Some(input) = inputs.iter().find(|input| input.identity.as_ref() == Some(&identity))
        else {
            return Ok(());
        };
        let what = input.what;
        let itself =
            if input.name == name { String::new() } else { format!(" that {} names", input.name) };
        Err(FileError::wrong(format!("{name} is the {what} itself{itself}; give another output")))
    }
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

/// The most bytes that are read of what has no length of its own, such as a pipe or a device: it may never end.
const MOST_WITHOUT_LENGTH: u64 = 1 << 30;

/// All bytes of a source: of what may never end no more than a gigabyte, and none where it begins as no file does.
pub(crate) fn whole(mut source: impl Read, is_file: bool) -> io::Result<Vec<u8>> {
    if !is_file {
        return at_most(source, MOST_WITHOUT_LENGTH);
    }
    let mut bytes = Vec::new();
    source.read_to_end(&mut bytes)?;
    Ok(bytes)
}

fn at_most(mut source: impl Read, most: u64) -> io::Result<Vec<u8>> {
    /// No format begins with so many zeros.
    const BEGIN: u64 = 4096;
    let mut bytes = Vec::new();
    source.by_ref().take(BEGIN).read_to_end(&mut bytes)?;
    if bytes.len() as u64 == BEGIN && bytes.iter().all(|&byte| byte == 0) {
        return Err(no_file(format!("its first {BEGIN} bytes are 0; it is no text and no mesh")));
    }
    source.take((most + 1).saturating_sub(BEGIN)).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most {
        return Err(no_file(format!(
            "it goes on after {most} bytes, the most that are read of a pipe or a device; save it as a file"
        )));
    }
    Ok(bytes)
}

/// An error of the content, and not of the system.
fn no_file(problem: String) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, problem)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_never_ends_is_refused() {
        let error = |source: io::Repeat| at_most(source, 1 << 16).unwrap_err().to_string();
        assert!(error(io::repeat(0)).starts_with("its first 4096 bytes are 0"));
        assert!(error(io::repeat(b'1')).starts_with("it goes on after 65536 bytes"));
        for len in [0, 1, 4095, 4097, 1 << 16] {
            assert_eq!(at_most(io::repeat(b' ').take(len), 1 << 16).unwrap().len() as u64, len);
        }
    }
}
