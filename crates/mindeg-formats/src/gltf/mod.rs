//! glTF 2.0: a `.gltf` with its `.bin`, and as [`glb`] the same in one file.
//!
//! # What is written
//!
//! One node with one mesh, both named after the mesh; if it has several groups, a child node for
//! each; on request a child node for each line. Groups in a row that differ in their materials alone
//! are primitives of one node. Materials have their names and colors, and are plain ones of the core
//! specification: not metallic, rough, and seen from both sides; with degree colors they are white. Texture coordinates count from the
//! upper left, as glTF has it. Vertex colors are 8 bits a channel.
//!
//! **Indices** take 16 bits up to 65,535 vertices and 32 bits from there.
//!
//! **Coordinates** are stored as 32-bit floats. A mesh far from the origin would lose its
//! shape in them: where the range of x, y or z begins eight times its own length from the
//! origin, or farther out, positions count from the middle of the range, and the node's
//! translation moves them back; so they do wherever neighbors on a boundary would fall together
//! otherwise. Those that fall together all the same are an error that names them.
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

pub use positions::Stored;
pub use read::read;
pub use write::{file_lens, write, write_stored};
