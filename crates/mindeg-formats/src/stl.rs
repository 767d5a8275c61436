//! STL, for stereolithography: triangles by the coordinates of their corners.
//!
//! Written as binary. Coordinates are 32-bit floats, without indices: a reader finds
//! again which corners are one vertex. So vertices that would become one point are refused.
//!
//! Limits: names, groups, lines, colors and vertices without triangle are not kept.

mod read;
mod write;

use crate::facts::Facts;
use crate::gltf::Stored;

pub use read::read;
use write::sections;

pub(crate) const FACTS: Facts = Facts {
    name: "stl",
    description: "stereolithography STL",
    extensions: &["stl"],
    // 80 bytes are too few.
    has_remarks: false,
    // A binary STL must not begin so, though some do: the reader looks at its length.
    first_words: &["solid"],
    fits: has_binary_length,
    read: Some(|source| read(source.input)),
    check: |positions, options| Stored::in_place(positions, options.surface.plane).map(|_| None),
    write: |job, files| job.write(files, [sections(job.mesh, job.options.surface.plane)]),
    ..Facts::NONE
};

/// Whether a file is as long as a binary STL of the number of triangles that it gives.
fn has_binary_length(bytes: &[u8]) -> bool {
    let count = bytes.get(80..84).and_then(|count| count.try_into().ok()).map(u32::from_le_bytes);
    count.is_some_and(|count| count > 0 && bytes.len() as u64 == 84 + 50 * u64::from(count))
}
