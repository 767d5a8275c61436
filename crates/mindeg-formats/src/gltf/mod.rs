//! glTF 2.0: a `.gltf` with its `.bin`, and as [`glb`] the same in one file.
//!
//! # What is written
//!
//! One node with one mesh, both named after the mesh; if it has several groups, a child node for
//! each; on request a child node for each line. Groups in a row that differ in their materials alone
//! are primitives of one node. Materials have their names and colors, and are plain ones of the core
//! specification: not metallic, rough, and seen from both sides; with degree colors they are white. Texture coordinates count from the
//! upper left, as in glTF. Vertex colors are 8 bits a channel.
//!
//! **Indices** take 16 bits up to 65,535 vertices and 32 bits from there.
//!
//! **Coordinates** are stored as 32-bit floats. A mesh far from the origin would lose its
//! shape in them: where the range of x, y or z begins eight times its own length from the
//! origin, or farther out, positions count from the middle of the range, and the node's
//! translation moves them back; so they do wherever neighbors on a boundary would fall together
//! otherwise. Vertices that still fall together are an error that names them.
//!
//! **Limits**: a `.glb` ends at 4 GiB, and a mesh that takes more is refused before the
//! first byte; a `.bin` has no such end. Triangles so thin that 32-bit floats make them flat
//! are written as they are.

mod accessor;
mod container;
mod document;
pub mod glb;
mod json_words;
mod numbers;
mod placement;
mod positions;
mod primitive;
mod read;
mod schema;
mod write;

use crate::facts::Facts;
use crate::names::check_file_name;

pub use positions::Stored;
pub use read::read;
pub use write::write;
use write::{Arrays, sections};

pub(crate) const FACTS: Facts = Facts {
    name: "gltf",
    description: "glTF 2.0 as JSON, with a .bin file beside it",
    extensions: &["gltf"],
    files: &["gltf", "bin"],
    begins: is_document,
    fits: |text| is_document(text) || is_binary(text),
    read: Some(|source| read(source.input, source.beside)),
    check: |positions, options| Stored::new(positions, options.surface.plane).map(Some),
    write: |job, files| {
        let bin_name = files[1].0;
        check_file_name(bin_name)?;
        let arrays = Arrays::new(job.mesh, job.stored(), &job.options.surface);
        job.write(files, sections(&arrays, bin_name)?)
    },
    ..Facts::NONE
};

/// Whether a file is a `.glb`.
fn is_binary(text: &[u8]) -> bool {
    text.starts_with(b"glTF")
}

/// Whether a text is a document of glTF. A domain, or GeoJSON, has none of these keys.
fn is_document(text: &[u8]) -> bool {
    let keys = [&b"\"asset\""[..], b"\"meshes\"", b"\"accessors\"", b"\"bufferViews\""];
    text.starts_with(b"{") && keys.iter().any(|key| memchr::memmem::find(text, key).is_some())
}
