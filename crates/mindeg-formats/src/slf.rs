//! SELAFIN, the geometry of TELEMAC: `.slf`, and `.cli` of the same stem with a line for each boundary point.
//!
//! Coordinates have 64 bits (`SERAFIND`), and the bytes of a number run from the most significant on. The depths of the
//! mesh are the variable `BOTTOM`, which counts upwards. Boundary points count as TELEMAC asks: the outer boundary
//! counter-clockwise from the point with the least x + y, then each hole clockwise. The two ends of a segment of
//! an open line have a prescribed elevation and a free velocity (5 4 4), all others are solid (2 2 2).
//!
//! Limits: for meshes in the plane whose boundary passes each point once; names of groups and of lines are not kept,
//! but stand behind their points in the `.cli`, which is not read. Of the variables that are read, BOTTOM of the
//! first time is the depth.

mod read;
mod write;

use crate::facts::Facts;

use read::begins;
pub use read::read;

/// The most bytes of a record of 8-byte numbers, whose length has 31 bits.
const MAX_VERTICES: u32 = i32::MAX as u32 / 8;
/// Three indices of 4 bytes each.
const MAX_TRIANGLES: u32 = i32::MAX as u32 / 12;
pub(crate) const FACTS: Facts = Facts {
    name: "slf",
    description: "TELEMAC SELAFIN",
    extensions: &["slf"],
    leaves_out_depths: false,
    files: &["slf", "cli"],
    has_boundary: true,
    // 80 bytes are too few.
    has_remarks: false,
    begins,
    read: Some(|source| read(source.input)),
    max_vertices: MAX_VERTICES,
    in_plane: true,
    check_size: |_, _, triangles| {
        let what = ("SELAFIN", "triangles");
        crate::WriteError::unless_at_most(MAX_TRIANGLES, what, triangles.into())
    },
    write: |job, files| job.write(files, write::sections(job.mesh)?),
    ..Facts::NONE
};
