//! SU2's native format, for meshes in the plane.
//!
//! Each line of the mesh is a marker under its name; lines of one name are one marker, since SU2 wants
//! names to differ. Blanks and percent signs in names become `_`. Elements and points count from 0.
//!
//! Limits: written, not read. Groups are not kept.

use std::io::Write;
use std::ops::Range;

use mindeg_mesh::{Mesh, Positions};

use crate::corners::{positions, segments, triangles};
use crate::decimals::{Decimals, push_integer};
use crate::names::{Names, word};
use crate::sections::{Section, write_sections};
use crate::{Format, GENERATOR, WriteError};

/// VTK's numbers of the elements.
const LINE: u8 = b'3';
const TRIANGLE: u8 = b'5';

/// Writes a mesh in the plane for SU2. Decimals are the shortest that read back as the same f64.
///
/// O(n) time, shared by all threads of rayon's current pool, and the memory of one block of about
/// half a MiB for each of them, and one more. Writes are large: `out` needs no buffer around it.
///
/// # Errors
///
/// Those of [`check`] before the first byte, and those of `out`.
///
/// # Example
///
/// ```
/// use mindeg_formats::{obj, su2};
///
/// let mesh = obj::read("v 0 0 0\nv 2 0 0\nv 2 1 0\nf 1 2 3\no wall\nl 1 2\n".as_bytes())?;
/// let mut file = Vec::new();
/// su2::write(&mesh, &mut file)?;
/// let file = String::from_utf8(file)?;
/// assert!(file.contains("\nNELEM= 1\n5 0 1 2 0\nNPOIN= 3\n0 0 0\n2 0 1\n2 1 2\n"));
/// assert!(file.ends_with("NMARK= 1\nMARKER_TAG= wall\nMARKER_ELEMS= 1\n3 0 1\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write(mesh: &dyn Mesh, mut out: impl Write) -> Result<(), WriteError> {
    check(mesh)?;
    write_sections(&mut out, &sections(mesh))?;
    Ok(out.flush()?)
}

/// Refuses positions that do not all have the same z. O(n).
///
/// # Errors
///
/// [`NotInPlane`](WriteError::NotInPlane).
pub fn check(positions: &dyn Positions) -> Result<(), WriteError> {
    WriteError::unless_in_plane(Format::Su2, positions)
}

/// The file from front to back.
pub(crate) fn sections(mesh: &dyn Mesh) -> Vec<Section<'_>> {
    let (vertices, count) = (mesh.vertex_count(), mesh.triangle_count());
    let mut sections = vec![
        Section::bytes(format!("% {GENERATOR}\nNDIME= 2\nNELEM= {count}\n")),
        Section::new(count, 36, move |range, buffer| {
            for (index, triangle) in range.clone().zip(triangles(mesh, range)) {
                buffer.push(TRIANGLE);
                triangle.into_iter().for_each(|vertex| push_integer(vertex, buffer));
                push_integer(index, buffer);
                buffer.push(b'\n');
            }
        }),
        Section::bytes(format!("NPOIN= {vertices}\n")),
        Section::new(vertices, 44, move |range, buffer| {
            let [mut x, mut y] = [0; 2].map(|_| Decimals::new());
            for (vertex, point) in range.clone().zip(positions(mesh, range)) {
                x.push_first(point.x, buffer);
                y.push(point.y, buffer);
                push_integer(vertex, buffer);
                buffer.push(b'\n');
            }
        }),
    ];
    let markers = markers(mesh);
    sections.push(Section::bytes(format!("NMARK= {}\n", markers.len())));
    for (name, ranges) in markers {
        let count: u64 = ranges.iter().map(|range| range.len() as u64).sum();
        sections.push(Section::bytes(format!("MARKER_TAG= {name}\nMARKER_ELEMS= {count}\n")));
        sections.extend(ranges.into_iter().map(|range| marker_elements(mesh, range)));
    }
    sections
}

fn marker_elements(mesh: &dyn Mesh, of_line: Range<u32>) -> Section<'_> {
    Section::new(of_line.len() as u32, 24, move |range, buffer| {
        let range = of_line.start + range.start..of_line.start + range.end;
        for segment in segments(mesh, range) {
            buffer.push(LINE);
            segment.into_iter().for_each(|vertex| push_integer(vertex, buffer));
            buffer.push(b'\n');
        }
    })
}

/// The names of the lines, each with the segments of all lines of the name.
fn markers(mesh: &dyn Mesh) -> Vec<(String, Vec<Range<u32>>)> {
    let mut markers: Vec<(String, Vec<Range<u32>>)> = Vec::new();
    let mut indices = std::collections::HashMap::new();
    let mut names = Names::default();
    for line in mesh.lines().iter() {
        // A percent sign starts a comment.
        let name = names.of(&line.name, |name| word(name).replace('%', "_"));
        let index = *indices.entry(name.clone()).or_insert(markers.len());
        if index == markers.len() {
            markers.push((name, Vec::new()));
        }
        markers[index].1.push(line.segments.clone());
    }
    markers
}
