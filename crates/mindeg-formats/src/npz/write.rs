//! Writing NPZ.

use super::array::head;
use super::zip::{Archive, archive_len};
use crate::corners::{degrees, min_angles, positions, triangles};
use crate::sections::{Section, write_sections};
use mindeg_mesh::Mesh;
use std::io::{self, Write};
use std::ops::Range;

/// Writes a mesh as NPZ, with `degrees` and `min_angles` if `fields` are asked for.
///
/// O(n) time, shared by all threads of rayon's current pool, and the memory of one block of about
/// half a MiB for each of them, and one more. Writes are large: `out` needs no buffer around it.
///
/// # Errors
///
/// Those of `out`.
///
/// # Example
///
/// ```
/// use mindeg_formats::{npz, obj};
///
/// let mesh = obj::read("v 0 0 0\nv 2 0 0\nv 2 1 0\nf 1 2 3\n".as_bytes())?;
/// let mut file = Vec::new();
/// npz::write(&mesh, true, &mut file)?;
/// assert_eq!(file.len() as u64, npz::file_len(&mesh, true));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write(mesh: &dyn Mesh, fields: bool, out: impl Write) -> io::Result<()> {
    let mut archive = Archive::new(out);
    for Array { name, head, rows, row_len, format } in arrays(mesh, fields) {
        let len = len(&head, rows, row_len);
        let sections = [Section::bytes(head), Section::new(rows, row_len, format)];
        archive.entry(name, len, |mut out| write_sections(&mut out, &sections))?;
    }
    archive.finish()
}

/// How many bytes [`write()`] writes. O(1).
#[must_use]
pub fn file_len(mesh: &dyn Mesh, fields: bool) -> u64 {
    let arrays = arrays(mesh, fields);
    archive_len(
        arrays.iter().map(|array| (array.name, len(&array.head, array.rows, array.row_len))),
    )
}

fn len(head: &[u8], rows: u32, row_len: u32) -> u64 {
    head.len() as u64 + u64::from(rows) * u64::from(row_len)
}

/// Appends the numbers of a range of rows.
type Rows<'a> = Box<dyn Fn(Range<u32>, &mut Vec<u8>) + Sync + 'a>;

/// An array of the file.
struct Array<'a> {
    name: &'static str,
    head: Vec<u8>,
    rows: u32,
    row_len: u32,
    format: Rows<'a>,
}

fn arrays(mesh: &dyn Mesh, fields: bool) -> Vec<Array<'_>> {
    let (vertices, count) = (mesh.vertex_count(), mesh.triangle_count());
    let mut arrays = vec![
        Array {
            name: "points.npy",
            head: head("<f8", vertices, Some(3)),
            rows: vertices,
            row_len: 24,
            format: Box::new(move |range, buffer| {
                for point in positions(mesh, range) {
                    buffer.extend_from_slice(point.to_array().map(f64::to_le_bytes).as_flattened());
                }
            }),
        },
        Array {
            name: "triangles.npy",
            head: head("<u4", count, Some(3)),
            rows: count,
            row_len: 12,
            format: Box::new(move |range, buffer| {
                for triangle in triangles(mesh, range) {
                    buffer.extend_from_slice(triangle.map(u32::to_le_bytes).as_flattened());
                }
            }),
        },
    ];
    if fields {
        arrays.push(Array {
            name: "degrees.npy",
            head: head("<u4", vertices, None),
            rows: vertices,
            row_len: 4,
            format: Box::new(move |range, buffer| {
                for degree in degrees(mesh, range) {
                    buffer.extend_from_slice(&degree.to_le_bytes());
                }
            }),
        });
        arrays.push(Array {
            name: "min_angles.npy",
            head: head("<f8", count, None),
            rows: count,
            row_len: 8,
            format: Box::new(move |range, buffer| {
                for angle in min_angles(mesh, range) {
                    buffer.extend_from_slice(&angle.to_le_bytes());
                }
            }),
        });
    }
    arrays
}
