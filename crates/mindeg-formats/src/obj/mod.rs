//! Wavefront OBJ.
//!
//! One object for the surface; on request one more for each side, holding the boundary
//! segments `l a b` of that side, since readers take a surface that shares its object with
//! lines for lines. A vertex has a normal and texture coordinates of its own under its own
//! number, so that `f i/i/i` never makes a reader split a vertex. Numbers are the shortest
//! decimals that read back as the same `f64` (`f32` for texture coordinates and colors, of
//! which no reader keeps more); negative zero is written `0`. Vertex numbers
//! start at 1 in the file and nowhere else.
//!
//! A group is an object. Where groups have materials, each material is used by `usemtl`, and a library
//! beside the file, the `.mtl`, has their colors; groups in a row of one name are one object.
//!
//! Names of objects are made distinct: the second `side_2` becomes `side_2_2`.
//!
//! Limits: an OBJ has no units and no up axis. Vertex colors, on request, follow the
//! coordinates as `v x y z r g b`, a common extension that some readers reject.

mod library;
mod numbers;
mod read;
mod references;
mod words;
mod write;

use crate::facts::Facts;
use crate::names::check_file_name;

pub use read::{read, read_lines, read_with_libraries};
use write::sections;
pub use write::write;

pub(crate) const FACTS: Facts = Facts {
    name: "obj",
    description: "Wavefront OBJ",
    extensions: &["obj"],
    library: Some("mtl"),
    first_words: &["v", "vn", "vt", "o", "g", "f", "mtllib", "usemtl"],
    read: Some(|source| read_with_libraries(source.input, source.beside)),
    write: |job, files| {
        let library = files.get(1).map(|(name, _)| *name);
        if let Some(name) = library {
            check_file_name(name)?;
        }
        let written = sections(job.mesh, &job.options.surface, library);
        job.write(files, [written.object, written.library])
    },
    ..Facts::NONE
};
