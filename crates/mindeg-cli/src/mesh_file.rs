//! Reading a mesh of any program from a file.

use crate::bar::{Bar, Counting, Unit};
use crate::failure::{Failure, plainly};
use crate::input;
use mindeg_formats::{Format, ReadError, gltf, obj};
use mindeg_mesh::TriMesh;
use std::fs::{self, File};
use std::io::{self, BufReader};
use std::path::{Component, Path};

/// Reads a mesh by the extension of its file, and lets the bar count the bytes.
pub(crate) fn read(path: &Path, bar: &Bar) -> Result<TriMesh, Failure> {
    let open = || -> Result<Counting<'_, File>, ReadError> {
        let file = File::open(path)?;
        let len = file.metadata()?.len();
        bar.stage("reading", len, Unit::Bytes);
        Ok(bar.counting(file, len))
    };
    let mesh = match Format::of_path(path) {
        Some(Format::Obj) => {
            open().and_then(|file| obj::read(BufReader::with_capacity(1 << 16, file)))
        }
        Some(Format::Glb | Format::Gltf) => {
            open().and_then(|file| gltf::read(file, |name| read_beside(path, name)))
        }
        Some(Format::Svg) | None => {
            return Err(Failure::Input(format!(
                "{}: the name tells no format that can be read; it must end in .obj, .glb or \
                 .gltf",
                path.display()
            )));
        }
    };
    mesh.map_err(|error| match error {
        ReadError::Io(error) => {
            Failure::Io(format!("cannot read {}: {}", path.display(), plainly(&error)))
        }
        ReadError::External { ref source, .. } if source.kind() != io::ErrorKind::InvalidInput => {
            Failure::Io(format!("{}: {error}", path.display()))
        }
        error => Failure::Input(format!("{}: {error}", path.display())),
    })
}

/// Reads a file that a .gltf names, relative to it. A mesh has no business elsewhere, and it
/// may come from anywhere.
fn read_beside(path: &Path, name: &str) -> io::Result<Vec<u8>> {
    let name = Path::new(name);
    let stays = |part: Component<'_>| matches!(part, Component::Normal(_) | Component::CurDir);
    if !name.components().all(stays) {
        let problem = "it is not in the folder of the .gltf, and no other is looked into";
        return Err(io::Error::new(io::ErrorKind::InvalidInput, problem));
    }
    let path = path.with_file_name("").join(name);
    input::note(&path, "mesh's data");
    fs::read(path)
}
