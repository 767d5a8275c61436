//! STL, for stereolithography: triangles by the coordinates of their corners.
//!
//! Written as binary. Coordinates are 32-bit floats, and there are no indices: who reads it finds
//! again which corners are one vertex. So vertices that would become one point are refused.
//!
//! Limits: names, groups, lines, colors and vertices without triangle are not kept.

mod read;
mod write;

pub use read::read;
pub(crate) use write::sections;
pub use write::{check, write};
