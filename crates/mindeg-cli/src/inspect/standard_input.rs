//! A mesh from standard input.

use crate::failure::Failure;
use mindeg_formats::{Format, ReadError, gltf, obj};
use mindeg_mesh::TriMesh;
use std::io::{self, Read};

/// Reads all of standard input as a mesh, in a format or in the one that its content tells.
pub(super) fn read(format: Option<Format>) -> Result<TriMesh, Failure> {
    let mut bytes = Vec::new();
    let read = io::stdin().lock().read_to_end(&mut bytes);
    read.map_err(|error| Failure::Io(format!("cannot read standard input: {error}")))?;
    let mesh = match format.unwrap_or_else(|| format_of(&bytes)) {
        Format::Glb | Format::Gltf => gltf::read(&bytes[..], |_| {
            let problem = "standard input has no folder where it could be";
            Err(io::Error::new(io::ErrorKind::InvalidInput, problem))
        }),
        _ => obj::read(&bytes[..]),
    };
    mesh.map_err(|error| match error {
        ReadError::Io(error) => Failure::Io(format!("cannot read standard input: {error}")),
        error => Failure::Input(format!("standard input: {error}")),
    })
}

/// The format of a file: a .glb starts with a word of its own, a .gltf is an object of JSON, and
/// all else may be an OBJ.
fn format_of(bytes: &[u8]) -> Format {
    let text = bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes).trim_ascii_start();
    match text {
        _ if bytes.starts_with(b"glTF") => Format::Glb,
        [b'{', ..] => Format::Gltf,
        _ => Format::Obj,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn content_tells_the_format() {
        for (content, format) in [
            (&b"glTF\x02"[..], Format::Glb),
            (b" \n{\"asset\": {}}", Format::Gltf),
            ("\u{feff}{}".as_bytes(), Format::Gltf),
            (b"# a comment\nv 0 0 0\n", Format::Obj),
            (b"", Format::Obj),
        ] {
            assert_eq!(format_of(content), format, "{content:?}");
        }
    }
}
