//! Reading a mesh in any format.

use std::io::{self, BufRead, BufReader, ErrorKind, Read};
use std::path::Path;

use mindeg_mesh::TriMesh;

use crate::bytes::has_more;
use crate::detect::format_of;
use crate::{
    Format, ReadError, fort14, gltf, msh, npz, obj, off, ply, sms2dm, stl, triangle, vtk, vtu,
};

/// How much of a file is looked at for its format.
const HEAD: usize = 1 << 16;

/// Reads a mesh in the format that the extension of its name says, or else its content.
///
/// Only the name's last part counts. `beside` is asked for further files, by names relative to this
/// one: those that a `.gltf` names, the material libraries of an `.obj`, or the `.ele` beside a `.node`. They are to be trusted no more
/// than the file is.
///
/// O(n) time but for polygons that are cut, and memory for the file and the mesh, whatever the
/// file says about its own size.
///
/// # Errors
///
/// [`ReadError::Format`] if the name and the content do not agree, or tell no format; those of
/// the format's own reader, with the line or offset; those of the input.
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
    let format = format.map_err(|unknown| ReadError::Format { problem: unknown.problem() })?;
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
    input: impl BufRead,
    beside: impl FnMut(&str) -> io::Result<Vec<u8>>,
) -> Result<TriMesh, ReadError> {
    match format {
        Format::Obj => obj::read_with_libraries(input, beside),
        Format::Glb | Format::Gltf => gltf::read(input, beside),
        Format::Ply => ply::read(input),
        Format::Stl => stl::read(input),
        Format::Off => off::read(input),
        Format::Sms2dm => sms2dm::read(input),
        Format::Fort14 => fort14::read(input),
        Format::Msh => msh::read(input),
        Format::Vtu => vtu::read(input),
        Format::Vtk => vtk::read(input),
        Format::Node => read_triangle(name, input, beside),
        Format::Npz => npz::read(input),
        Format::Su2 | Format::Inp | Format::Svg | Format::Png => {
            let problem = format!("{} is not read as a mesh", format.description());
            Err(ReadError::Format { problem })
        }
    }
}

/// Reads one of Triangle's files and those beside it; the .poly may be missing.
fn read_triangle(
    name: &Path,
    mut input: impl BufRead,
    mut beside: impl FnMut(&str) -> io::Result<Vec<u8>>,
) -> Result<TriMesh, ReadError> {
    let mut own = Vec::new();
    input.read_to_end(&mut own)?;
    let files = Format::Node.files(Path::new(name.file_name().unwrap_or_default()));
    let mut own = Some(own);
    let mut file = |index: usize| {
        let extension = |path: &Path| path.extension().map(|name| name.to_ascii_lowercase());
        // A name without an extension is that of the vertices.
        let is_own = extension(&files[index]) == extension(name)
            || (index == 0 && Format::of_path(name) != Some(Format::Node));
        if is_own && let Some(own) = own.take() {
            return Ok(own);
        }
        let uri = files[index].to_string_lossy().into_owned();
        beside(&uri).map_err(|source| ReadError::External { uri, source })
    };
    let (node, ele) = (file(0)?, file(1)?);
    let poly = match file(2) {
        Err(ReadError::External { source, .. }) if source.kind() == ErrorKind::NotFound => None,
        poly => Some(poly?),
    };
    triangle::read(&node[..], &ele[..], poly.as_deref())
}
