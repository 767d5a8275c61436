//! Meshes as VTK's unstructured grids: what VTU and legacy VTK share.
//!
//! The cells are the triangles, then the segments of all sides, so that sides are cells as well.

mod read;
mod write;

pub(crate) use read::{CellData, Cells, Grid};
pub(crate) use write::{Arrays, Field, text_of_names};
