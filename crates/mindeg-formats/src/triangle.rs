//! The files of Jonathan Shewchuk's *Triangle*: `.node`, `.ele` and `.poly` of one stem.
//!
//! The `.node` has the vertices, the `.ele` the triangles, and the `.poly` the boundary segments, a
//! point in each hole, and no vertices of its own, which refers to the `.node`. All count from 1
//! without gaps. The marker of a vertex or segment is the index of its line, from 1; 0 is inside.
//! Comments name the lines, and the reader takes the names from there. Groups are attributes.
//!
//! Limits: for meshes in the plane; names of groups are not kept.

mod read;
mod write;

pub use read::read;
pub(crate) use write::sections;
pub use write::{Files, check, write};
