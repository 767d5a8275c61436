//! PLY, the Stanford polygon format.
//!
//! Written as binary, little-endian, with 32-bit coordinates: every program reads that, and Gmsh
//! no 64-bit ones. Lists are `property list uchar int vertex_indices`, the one form that all
//! readers know.
//!
//! Limits: groups, names and lines are not kept. Triangle strips are not read.

mod header;
mod read;
mod write;

pub use read::read;
pub(crate) use write::sections;
pub use write::{check, write};
