//! The files that another names, such as the .bin of a .gltf.

use crate::session::Session;
use std::fs::{File, Metadata};
use std::io::{self, ErrorKind, Read};
use std::path::{Component, Path, PathBuf};

/// The files in the folder of one that names them.
///
/// A file has no business in other folders, and it may come from anywhere: so what it names must be a
/// regular file in its own folder, also where links lead to it, and is read once, so that memory is that
/// of the files there are.
pub(crate) struct Beside<'a> {
    session: &'a Session,
    /// The one that names them.
    path: &'a Path,
    what: &'static str,
    read: Vec<PathBuf>,
}

impl<'a> Beside<'a> {
    pub(crate) fn new(session: &'a Session, path: &'a Path, what: &'static str) -> Self {
        Self { session, path, what, read: Vec::new() }
    }

    /// Reads a file by its name relative to the one that names it. The kind of an error is
    /// [`InvalidInput`](ErrorKind::InvalidInput) for a name that is never read.
    pub(crate) fn read(&mut self, name: &str) -> io::Result<Vec<u8>> {
        let refused = |problem| Err(io::Error::new(ErrorKind::InvalidInput, problem));
        const OUTSIDE: &str =
            "it is not in the folder of the file that names it, and no other is looked into";
        let stays = |part: Component<'_>| matches!(part, Component::Normal(_) | Component::CurDir);
        if !Path::new(name).components().all(stays) {
            return refused(OUTSIDE);
        }
        let named = self.path.with_file_name(name);
        let folder = self.path.with_file_name("");
        let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { &folder };
        let file = named.canonicalize()?;
        if !file.starts_with(folder.canonicalize()?) {
            return refused(OUTSIDE);
        }
        // Looked at before it is opened, since opening a pipe waits for somebody to write to it.
        check_regular(&file.metadata()?)?;
        if self.read.contains(&file) {
            return refused("it is named a second time; a file is read for one buffer");
        }
        self.session.note(&named, self.what);
        let mut open = File::open(&file)?;
        self.read.push(file);
        let metadata = open.metadata()?;
        check_regular(&metadata)?;
        let mut bytes = Vec::new();
        bytes.try_reserve_exact(usize::try_from(metadata.len()).unwrap_or(usize::MAX))?;
        open.by_ref().take(metadata.len()).read_to_end(&mut bytes)?;
        Ok(bytes)
    }
}

fn check_regular(metadata: &Metadata) -> io::Result<()> {
    if metadata.is_file() {
        return Ok(());
    }
    let kind = if metadata.is_dir() { "it is a folder" } else { "it is a pipe or a device" };
    Err(io::Error::other(format!("{kind}; only regular files are read")))
}
