//! `fort.14`, the grid of ADCIRC, which SWAN and other coastal models read too; SCHISM calls it `hgrid.gr3`.
//!
//! Vertices and triangles count from 1 without gaps, as SWAN asks. The lines of the mesh are boundary
//! segments: open, land or island by their kind. Where that is not known, a hole is an island, and
//! all else is land. An island is a whole ring; its lines become one segment. A line with triangles on both sides is
//! no boundary, and is left out.
//!
//! Limits: for meshes in the plane. Barriers with heights (boundary types 3, 4, 5 and those 10 and 20
//! above) are read as land, without their heights.

mod read;
mod write;

use crate::boundary::MarkedChains;
use crate::facts::{Facts, SIGNED};

use read::fits;
pub use read::read;
use write::sections;

pub(crate) const FACTS: Facts = Facts {
    name: "fort14",
    description: "ADCIRC fort.14 or SCHISM hgrid.gr3",
    extensions: &["14", "grd", "gr3"],
    leaves_out_depths: false,
    has_boundary: true,
    in_degrees: true,
    fits,
    read: Some(|source| read(source.input)),
    max_vertices: SIGNED,
    in_plane: true,
    write: |job, files| {
        let mut boundary = MarkedChains::of(job.mesh);
        let left_out = boundary.leave_out_inner();
        job.write(files, [sections(job.mesh, boundary)])?;
        Ok(left_out)
    },
    ..Facts::NONE
};
