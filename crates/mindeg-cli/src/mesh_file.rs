//! Reading a mesh of any program from a file.

use crate::bar::{Bar, Counting, Unit};
use crate::failure::{Failure, plainly};
use crate::input;
use crate::memory;
use mindeg_formats::ReadError;
use mindeg_mesh::TriMesh;
use std::fs::{File, Metadata};
use std::io::{self, ErrorKind, Read};
use std::path::{Component, Path};

/// Reads a mesh by the extension of its file or its content, and lets the bar count the bytes. No output
/// may replace the file from then on, and what takes more memory than there is, is refused.
pub(crate) fn read(path: &Path, bar: &Bar) -> Result<TriMesh, Failure> {
    input::note(path, "mesh");
    memory::require_to_read(path)?;
    let open = || -> Result<Counting<'_, File>, ReadError> {
        let file = File::open(path)?;
        let len = file.metadata()?.len();
        bar.stage("reading", len, Unit::Bytes);
        Ok(bar.counting(file, len))
    };
    let mesh =
        open().and_then(|file| mindeg_formats::read(path, file, |name| read_beside(path, name)));
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

/// Reads a file that another names, such as a .gltf, relative to it. A mesh has no business
/// elsewhere, and it may come from anywhere: so the file must be a regular one in the same folder,
/// also where links lead to it.
fn read_beside(path: &Path, name: &str) -> io::Result<Vec<u8>> {
    let outside = || {
        let problem =
            "it is not in the folder of the file that names it, and no other is looked into";
        io::Error::new(ErrorKind::InvalidInput, problem)
    };
    let name = Path::new(name);
    let stays = |part: Component<'_>| matches!(part, Component::Normal(_) | Component::CurDir);
    if !name.components().all(stays) {
        return Err(outside());
    }
    let folder = path.with_file_name("");
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { &folder };
    let file = folder.join(name).canonicalize()?;
    if !file.starts_with(folder.canonicalize()?) {
        return Err(outside());
    }
    // Looked at before it is opened, since opening a pipe waits for somebody to write to it.
    check_regular(&file.metadata()?)?;
    input::note(&file, "mesh's data");
    let mut file = File::open(file)?;
    let metadata = file.metadata()?;
    check_regular(&metadata)?;
    let mut bytes = Vec::new();
    bytes.try_reserve_exact(usize::try_from(metadata.len()).unwrap_or(usize::MAX))?;
    file.by_ref().take(metadata.len()).read_to_end(&mut bytes)?;
    Ok(bytes)
}

fn check_regular(metadata: &Metadata) -> io::Result<()> {
    if metadata.is_file() {
        return Ok(());
    }
    let kind = if metadata.is_dir() { "it is a folder" } else { "it is a pipe or a device" };
    Err(io::Error::other(format!("{kind}; only regular files are read")))
}
