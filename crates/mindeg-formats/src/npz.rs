//! NPZ: arrays of numpy in a zip archive.
//!
//! `points` has a row of three 64-bit floats for each vertex, `triangles` a row of three indices from
//! 0 for each triangle (`uint32`); where asked for, `degrees` (`uint32`) and `min_angles` (degrees,
//! `float64`) follow. Nothing is compressed or pickled: `numpy.load(file)` reads it as it is.
//!
//! Compressed arrays (`numpy.savez_compressed`) are read, too.
//!
//! Limits: names, groups and lines are not kept.

mod array;
mod read;
mod write;
mod zip;

pub use read::read;
pub use write::{file_len, write};
