//! A mesh from standard input.

use crate::failure::Failure;
use mindeg_formats::{Format, ReadError, read_as};
use mindeg_mesh::TriMesh;
use std::io::{self, Read};

/// Reads all of standard input as a mesh, in a format or in the one that its content tells; what
/// tells none may be an OBJ.
pub(super) fn read(format: Option<Format>) -> Result<TriMesh, Failure> {
    let mut bytes = Vec::new();
    let read = io::stdin().lock().read_to_end(&mut bytes);
    read.map_err(|error| Failure::Io(format!("cannot read standard input: {error}")))?;
    let format = format.or_else(|| Format::of_content(&bytes)).unwrap_or(Format::Obj);
    let mesh = read_as(format, "-".as_ref(), &bytes[..], |_| {
        let problem = "standard input has no folder where it could be";
        Err(io::Error::new(io::ErrorKind::InvalidInput, problem))
    });
    mesh.map_err(|error| match error {
        ReadError::Io(error) => Failure::Io(format!("cannot read standard input: {error}")),
        error => Failure::Input(format!("standard input: {error}")),
    })
}
