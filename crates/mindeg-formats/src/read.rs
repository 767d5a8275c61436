//! Reading a mesh in any format.

use std::io::{self, BufRead, BufReader, Read};
use std::path::Path;

use mindeg_mesh::TriMesh;

use crate::bytes::has_more;
use crate::detect::format_of;
use crate::facts::Source;
use crate::{Format, ReadError};

/// How much of a file is looked at for its format.
const HEAD: usize = 1 << 16;

/// Reads a mesh in the format that the extension of its name says, or else its content.
///
/// Only the name's last part counts. `beside` gives further files, by names relative to this
/// one: those that a `.gltf` names, the material libraries of an `.obj`, or the `.ele` beside a `.node`. They are to be trusted no more
/// than the file is.
///
/// O(n) time but for polygons that are cut, and memory for the file and the mesh, whatever the
/// file says about its own size.
///
/// # Errors
///
/// The name and the content do not agree, or tell no format; those of the format's own reader, with
/// the line or offset; those of the input.
///
/// # Example
///
/// ```
/// let file = "v 0 0 0\nv 4 0 0\nv 4 3 0\nf 1 2 3\n";
/// let no_files = |_: &str| Err(std::io::ErrorKind::NotFound.into());
/// let mesh = mindeg_formats::read("roof.obj".as_ref(), file.as_bytes(), no_files)?;
/// assert_eq!(mesh.triangles(), [[0, 1, 2]]);
///
/// let error = mindeg_formats::read("roof.ply".as_ref(), "$MeshFormat\n".as_bytes(), no_files);
/// assert!(error.unwrap_err().to_string().ends_with("rename the file to end in .msh"));
/// # Ok::<(), mindeg_formats::ReadError>(())
/// ```
pub fn read(
    name: &Path,
    input: impl Read,
    beside: impl FnMut(&str) -> io::Result<Vec<u8>>,
) -> Result<TriMesh, ReadError> {
    let mut input = BufReader::with_capacity(HEAD, input);
    let head = if has_more(&mut input)? { input.fill_buf()? } else { &[] };
    let format = format_of(name, head);
    let format = format.map_err(|problem| ReadError::place("", problem))?;
    read_as(format, name, input, beside)
}

/// [`read()`], in a format that is known.
///
/// # Errors
///
/// As [`read()`], but the name and the content need not agree.
pub fn read_as(
    format: Format,
    name: &Path,
    mut input: impl BufRead,
    mut beside: impl FnMut(&str) -> io::Result<Vec<u8>>,
) -> Result<TriMesh, ReadError> {
    let Some(reader) = format.facts().read else {
        let problem = format!("{} is not read as a mesh", format.description());
        return Err(ReadError::place("", problem));
    };
    reader(Source { name, input: &mut input, beside: &mut beside })
}
