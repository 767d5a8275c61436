//! VTU, VTK's XML format for unstructured grids.
//!
//! Written: version 1.0, one piece; numbers raw in an appended part (`header_type` UInt64),
//! or inline as text. Connectivity and offsets are both Int64, which all versions of ParaView read.
//! With data fields, the segments of all sides are cells after the triangles; `degree` is point data;
//! `min_angle` (degrees; 60 for a segment) and `side` (the index of the side; -1 for a triangle) are
//! cell data, and so is `group` where the mesh has several. Their names are in the field data
//! `side_names` and `group_names`: UTF-8 bytes, each name ended by a zero, since readers such as
//! meshio stop at strings.
//!
//! Read: inline text and base64, appended base64 and raw, of either byte order, as they are
//! or compressed by zlib, in any number of pieces.

mod array;
mod read;
mod write;
mod xml;

use crate::facts::Facts;

pub use self::read::read;
pub(crate) use self::read::read_values;
use self::write::sections;

pub(crate) const FACTS: Facts = Facts {
    name: "vtu",
    description: "VTK's XML unstructured grid",
    extensions: &["vtu"],
    begins: |text| text.starts_with(b"<") && memchr::memmem::find(text, b"<VTKFile").is_some(),
    read: Some(|source| read(source.input)),
    write: |job, files| job.write(files, [sections(job.mesh, job.options)]),
    ..Facts::NONE
};
