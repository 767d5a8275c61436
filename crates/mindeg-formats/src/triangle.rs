//! The files of Jonathan Shewchuk's *Triangle*: `.node`, `.ele` and `.poly` of one stem.
//!
//! The `.node` has the vertices, the `.ele` the triangles, and the `.poly` the boundary segments, a
//! point in each hole, and no vertices of its own, which refers to the `.node`. All count from 1
//! without gaps. The marker of a vertex or segment is the number that its line is called by, such as `marker 7`, or the least
//! left from 1; 0 is inside. Comments name the other lines, and the reader takes the names from there. Groups are attributes.
//!
//! Limits: for meshes in the plane; names of groups are not kept.

mod read;
mod write;

use crate::facts::{Facts, SIGNED};
use crate::words::{number, words};

use read::{EXTENSIONS, read_files};
pub use read::{PolyFaces, PolyRegion, read, read_lines};
use write::sections;

pub(crate) const FACTS: Facts = Facts {
    name: "node",
    description: "Triangle's .node, with .ele and .poly beside it",
    extensions: &EXTENSIONS,
    files: &EXTENSIONS,
    has_boundary: true,
    fits: counts_vertices,
    read: Some(read_files),
    max_vertices: SIGNED,
    in_plane: true,
    write: |job, files| job.write(files, sections(job.mesh)),
    ..Facts::NONE
};

/// Whether the first line after comments is that of a `.node`: a number of vertices in two
/// dimensions.
fn counts_vertices(bytes: &[u8]) -> bool {
    let mut lines = bytes.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii);
    let first = lines.find(|line| !matches!(line, [] | [b'#', ..])).unwrap_or_default();
    let bare = first.split(|&byte| byte == b'#').next().unwrap_or_default();
    let numbers: Vec<Option<u32>> = words(bare).map(number).collect();
    matches!(numbers[..], [Some(_), Some(2), Some(_), Some(0 | 1)])
}
