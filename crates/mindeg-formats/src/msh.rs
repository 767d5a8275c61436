//! Gmsh's MSH, versions 4.1 and 2.2, in text and binary.
//!
//! Sides are physical groups of dimension 1 under their names, groups of triangles physical
//! groups of dimension 2, and named vertices of dimension 0, so that a solver finds all. Sides of one name are one physical group. All
//! physical tags differ, also between dimensions, since some programs forget the dimension. A group that is called by a number, such as
//! `marker 7` of Triangle, has it for its tag, unless one before it has. Vertices
//! and elements count from 1; the elements are the segments of all sides, then the triangles, then the named vertices.
//!
//! With data fields, `degree` is node data. In 4.1 `min_angle` is element data in degrees: that of the
//! triangle, and 60, the best there is, for a segment, since meshio wants a value for every element;
//! in 2.2 meshio cannot read element data of a mesh with segments, so 2.2 files have none. Tags in data are 32 bits, also in 4.1: Gmsh reads only these, whatever its
//! manual says.
//!
//! Limits: names end at a line's end and have no `"`. The reader takes nodes, triangles,
//! quadrilaterals, lines, entities, periodic curves and physical names, and skips data and parametric
//! coordinates. Elements of higher order are taken by their corners.

mod entities;
mod parts;
mod periodic;
mod read;
mod shapes;
mod surfaces;
mod write;
mod write2;
mod write4;

use crate::facts::{Facts, SIGNED};
use crate::{MshVersion, WriteError, WriteOptions};

pub(crate) use self::read::values::read_values;
pub use self::read::{read, read_lines};
use self::write::sections;

pub(crate) const FACTS: Facts = Facts {
    name: "msh",
    description: "Gmsh MSH",
    extensions: &["msh"],
    has_boundary: true,
    begins: |text| text.starts_with(b"$") && memchr::memmem::find(text, b"$MeshFormat").is_some(),
    read: Some(|source| read(source.input)),
    check_size: |options, vertices, triangles| {
        check_count(options, "vertices", vertices.into())?;
        check_count(options, "triangles", triangles.into())
    },
    write: |job, files| {
        let segments = job.mesh.lines().last().map_or(0, |line| line.segments.end);
        let points = job.mesh.named_vertices().len() as u64;
        let elements = u64::from(job.mesh.triangle_count()) + u64::from(segments) + points;
        check_count(job.options, "elements", elements)?;
        job.write(files, [sections(job.mesh, job.options)])
    },
    ..Facts::NONE
};

/// Version 2.2 counts in 31 bits.
fn check_count(options: &WriteOptions, what: &str, count: u64) -> Result<(), WriteError> {
    match options.msh_version {
        MshVersion::V2 => WriteError::unless_at_most(SIGNED, (FACTS.description, what), count),
        MshVersion::V4 => Ok(()),
    }
}
