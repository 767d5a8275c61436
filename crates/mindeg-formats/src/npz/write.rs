//! Writing NPZ.

use super::array::head;
use super::zip::Archive;
use crate::corners::{degrees, min_angles, positions, triangles};
use crate::sections::{Section, write_sections};
use mindeg_mesh::Mesh;
use std::io::{self, Write};
use std::ops::Range;

/// Writes a mesh as NPZ, with `degrees` and `min_angles` if `fields` are asked for.
pub(super) fn write(mesh: &dyn Mesh, fields: bool, out: impl Write + Send) -> io::Result<()> {
    let mut archive = Archive::new(out);
    for Array { name, head, rows, row_len, format } in arrays(mesh, fields) {
        let len = len(&head, rows, row_len);
        let sections = [Section::bytes(head), Section::new(rows, row_len, format)];
        archive.entry(name, len, |mut out| write_sections(&mut out, &sections))?;
    }
    archive.finish()
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
