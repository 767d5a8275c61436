//! NPZ: arrays of numpy in a zip archive.
//!
//! `points` has a row of three 64-bit floats for each vertex, `triangles` a row of three indices from
//! 0 for each triangle (`uint32`); where asked for, `degrees` (`uint32`) and `min_angles` (degrees,
//! `float64`) follow. Nothing is compressed or pickled: `numpy.load(file)` reads it as it is.
//!
//! Lines are `segments` (a row of two indices each), `segment_groups` (the index of the name of each, `int32`) and
//! `segment_names`; groups `triangle_groups` and `triangle_names`; named vertices `named_points` and `point_names`. They
//! are there if the mesh has any, and read again; -1 is no name.
//!
//! Compressed arrays (`numpy.savez_compressed`) are read, too.
//!
//! Limits: materials and the name of the mesh are not in it.

mod array;
mod read;
mod rows;
mod write;
mod zip;

use crate::facts::Facts;

pub(crate) use array::MAGIC;
pub use read::read;
pub(crate) use read::read_raster;
pub(crate) use rows::read_rows;
use write::write;

pub(crate) const FACTS: Facts = Facts {
    name: "npz",
    description: "arrays of numpy",
    extensions: &["npz"],
    begins: |text| text.starts_with(b"PK\x03\x04"),
    read: Some(|source| read(source.input)),
    write: |job, files| {
        write(job.mesh, job.options.fields, &mut files[0].1)?;
        Ok(Vec::new())
    },
    ..Facts::NONE
};
