//! glTF 2.0 in one binary file, a `.glb`.

use super::document::Layout;
use super::numbers::compact;
use super::positions::Stored;
use super::write::Arrays;
use crate::facts::Facts;
use crate::sections::{Section, write_sections};
use crate::{SurfaceOptions, WriteError};
use mindeg_mesh::Mesh;
use std::io::Write;

pub use super::read::read;

pub(crate) const FACTS: Facts = Facts {
    name: "glb",
    description: "glTF 2.0 in one binary file",
    extensions: &["glb"],
    begins: super::is_binary,
    fits: super::FACTS.fits,
    read: super::FACTS.read,
    check_size: |options, vertices, triangles| check_size(vertices, triangles, &options.surface),
    check: super::FACTS.check,
    write: |job, files| {
        let arrays = Arrays::new(job.mesh, job.stored(), &job.options.surface);
        job.write(files, [sections(&arrays)?])
    },
    ..Facts::NONE
};

/// Writes a mesh as one binary file. Time and memory are those of
/// [`gltf::write`](super::write()).
///
/// # Errors
///
/// Before the first byte: those of [`Stored::new`], and
/// More bytes than 32 bits count. After it: errors of `out`.
///
/// # Example
///
/// ```
/// use mindeg_formats::{SurfaceOptions, glb, obj};
///
/// let mesh = obj::read("v 0 0 0\nv 2 0 0\nv 2 1 0\nf 1 2 3\n".as_bytes())?;
/// let mut file = Vec::new();
/// glb::write(&mesh, &SurfaceOptions::default(), &mut file)?;
/// assert!(file.starts_with(b"glTF"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write(
    mesh: &dyn Mesh,
    options: &SurfaceOptions,
    mut out: impl Write + Send,
) -> Result<(), WriteError> {
    let stored = Stored::new(mesh, options.plane)?;
    write_sections(&mut out, &sections(&Arrays::new(mesh, &stored, options))?)?;
    Ok(out.flush()?)
}

/// The file from front to back.
fn sections<'a>(arrays: &Arrays<'a>) -> Result<Vec<Section<'a>>, WriteError> {
    let len = arrays.layout.binary_len();
    let mut sections = vec![Section::bytes(head(arrays)?)];
    sections.extend(arrays.sections());
    let padding: &[u8] = match len % 4 {
        0 => &[],
        1 => &[0; 3],
        2 => &[0; 2],
        _ => &[0],
    };
    sections.push(Section::bytes(padding));
    Ok(sections)
}

/// Refuses a mesh in the plane that takes more than a `.glb` holds, lines apart. O(1); the mesh
/// need not exist yet.
///
/// # Errors
///
/// More bytes than 32 bits count. A mesh that passes here can be refused by a few
/// bytes all the same when names and numbers are known.
fn check_size(vertices: u32, triangles: u32, options: &SurfaceOptions) -> Result<(), WriteError> {
    let layout = Layout::in_plane(vertices, triangles, options);
    len(0, layout.binary_len().next_multiple_of(4)).map(|_| ())
}

/// The bytes before the arrays.
fn head(arrays: &Arrays<'_>) -> Result<Vec<u8>, WriteError> {
    let mut json = compact(&arrays.document(None))?;
    json.resize(json.len().next_multiple_of(4), b' ');
    let binary = arrays.layout.binary_len().next_multiple_of(4);
    let len = len(json.len() as u64, binary)?;

    let mut head = Vec::from(*b"glTF");
    head.extend_from_slice(&2_u32.to_le_bytes());
    head.extend_from_slice(&len.to_le_bytes());
    // Neither chunk is longer than the file.
    head.extend_from_slice(&(json.len() as u32).to_le_bytes());
    head.extend_from_slice(b"JSON");
    head.extend_from_slice(&json);
    head.extend_from_slice(&(binary as u32).to_le_bytes());
    head.extend_from_slice(b"BIN\0");
    Ok(head)
}

/// The length of a `.glb` whose chunks have these lengths.
fn len(json: u64, binary: u64) -> Result<u32, WriteError> {
    const HEADERS: u64 = 12 + 8 + 8;
    let bytes = HEADERS + json + binary;
    u32::try_from(bytes).map_err(|_| {
        WriteError::Refused(format!(
            "a .glb holds 4 GiB at most, and this mesh would take at least {bytes} bytes; write a \
             .gltf with its .bin or an OBJ, which may be larger, or use fewer intervals"
        ))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_glb_ends_where_its_length_does() {
        assert_eq!(len(1000, (1 << 32) - 1032).unwrap(), u32::MAX - 3);
        let error = len(1000, (1 << 32) - 1028).unwrap_err();
        assert_eq!(
            error.to_string(),
            "a .glb holds 4 GiB at most, and this mesh would take at least 4294967296 bytes; write \
             a .gltf with its .bin or an OBJ, which may be larger, or use fewer intervals"
        );
    }
}
