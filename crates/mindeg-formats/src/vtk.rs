//! VTK's legacy format, `.vtk`.
//!
//! Written: an unstructured grid in the layout of version 4.2, which all readers know; binary
//! numbers are big-endian. With data fields, the segments of all sides are cells after the triangles;
//! `degree` is point data; `min_angle` (degrees; 60 for a segment) and `side` (the index of the side;
//! -1 for a triangle) are cell data, and so is `group` where the mesh has several. The second line is
//! the mesh's name.
//!
//! Read: unstructured grids and polygonal data, in text and binary, up to version 5.1.
//!
//! Limits: 31 bits for vertices. Names of sides and groups are not kept: field data before the points,
//! where they would be, is more than Gmsh reads. Gmsh 4.15 reads such files as text only.

mod read;
mod write;

use crate::facts::{Facts, SIGNED};

pub use self::read::read;
use self::write::sections;

pub(crate) const FACTS: Facts = Facts {
    name: "vtk",
    description: "legacy VTK",
    extensions: &["vtk"],
    // The title is the name of the mesh.
    has_remarks: false,
    begins: |text| text.starts_with(b"# vtk DataFile"),
    read: Some(|source| read(source.input)),
    max_vertices: SIGNED,
    write: |job, files| job.write(files, [sections(job.mesh, job.options)]),
    ..Facts::NONE
};
