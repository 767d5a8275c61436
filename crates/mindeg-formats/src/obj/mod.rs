//! Wavefront OBJ.
//!
//! One object for the surface; on request one more for each side, holding the boundary
//! segments `l a b` of that side, since readers take a surface that shares its object with
//! lines for lines. A vertex has a normal and texture coordinates of its own under its own
//! number, so that `f i/i/i` never makes a reader split a vertex. Numbers are the shortest
//! decimals that read back as the same `f64` (`f32` for texture coordinates and colors, of
//! which no reader keeps more); negative zero is written `0`. Vertex numbers
//! start at 1 in the file and nowhere else.
//!
//! A group is an object. Where groups have materials, each material is used by `usemtl`, and a library
//! beside the file, the `.mtl`, has their colors; groups in a row of one name are one object.
//!
//! Names of objects are made distinct: the second `side_2` becomes `side_2_2`.
//!
//! Limits: an OBJ has no units and no up axis. Vertex colors, on request, follow the
//! coordinates as `v x y z r g b`, a common extension that some readers reject.

mod library;
mod numbers;
mod read;
mod references;
mod write;

pub use read::{read, read_with_libraries};
pub(crate) use write::sections;
pub use write::{estimated_len, write};
