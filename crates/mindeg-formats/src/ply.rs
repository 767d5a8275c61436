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

use crate::facts::{Facts, SIGNED};
use crate::gltf::Stored;

pub use read::read;
use write::sections;

pub(crate) const FACTS: Facts = Facts {
    name: "ply",
    description: "Stanford PLY",
    extensions: &["ply"],
    first_words: &["ply"],
    read: Some(|source| read(source.input)),
    max_vertices: SIGNED,
    check: |positions, options| {
        if !options.double {
            Stored::in_place(positions, options.surface.plane)?;
        }
        Ok(None)
    },
    write: |job, files| job.write(files, [sections(job.mesh, job.options)]),
    ..Facts::NONE
};
