//! Reading a mesh of any program from a file.

use crate::bar::{Bar, Counting, Unit};
use crate::failure::{Failure, plain, plainly};
use crate::input;
use mindeg_formats::ReadError;
use mindeg_mesh::TriMesh;
use std::fs::{File, Metadata};
use std::io::{self, ErrorKind, Read};
use std::path::{Component, Path, PathBuf};

/// Reads a mesh by the extension of its file or its content, and lets the bar count the bytes. No output
/// may replace the file from then on, and what takes more memory than there is, is refused.
pub(crate) fn read(path: &Path, bar: &Bar) -> Result<TriMesh, Failure> {
    input::note(path, "mesh");
    let open = || -> Result<Counting<'_, File>, ReadError> {
        let file = File::open(path)?;
        let len = file.metadata()?.len();
        bar.stage("reading", len, Unit::Bytes);
        Ok(bar.counting(file, len))
    };
    let mut beside = Beside { path, read: Vec::new() };
    let mesh = open()
        .and_then(|file| mindeg_formats::read(path, file, |name| beside.read(name).map_err(plain)));
    mesh.map_err(|error| match error {
        ReadError::Io(error) => {
            Failure::Io(format!("cannot read {}: {}", path.display(), plainly(&error)))
        }
        // A name that is refused is a mistake in the file that has it.
        ReadError::External { ref source, .. } if source.kind() != ErrorKind::InvalidInput => {
            Failure::Io(format!("{}: {error}", path.display()))
        }
        error => Failure::Input(format!("{}: {error}", path.display())),
    })
}

/// The files that another names, such as a .gltf.
struct Beside<'a> {
    /// The one that names them.
    path: &'a Path,
    /// Those that were read.
    read: Vec<PathBuf>,
}

impl Beside<'_> {
    /// Reads a file by its name relative to the one that names it. A mesh has no business elsewhere, and
    /// it may come from anywhere: so the file must be a regular one in the same folder, also where links
    /// lead to it, and it is read once, so that memory is that of the files there are.
    fn read(&mut self, name: &str) -> io::Result<Vec<u8>> {
        let refused = |problem| Err(io::Error::new(ErrorKind::InvalidInput, problem));
        const OUTSIDE: &str =
            "it is not in the folder of the file that names it, and no other is looked into";
        let name = Path::new(name);
        let stays = |part: Component<'_>| matches!(part, Component::Normal(_) | Component::CurDir);
        if !name.components().all(stays) {
            return refused(OUTSIDE);
        }
        let folder = self.path.with_file_name("");
        let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { &folder };
        let file = folder.join(name).canonicalize()?;
        if !file.starts_with(folder.canonicalize()?) {
            return refused(OUTSIDE);
        }
        // Looked at before it is opened, since opening a pipe waits for somebody to write to it.
        check_regular(&file.metadata()?)?;
        if self.read.contains(&file) {
            return refused("it is named a second time; a file is read for one buffer");
        }
        input::note(&file, "mesh's data");
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
