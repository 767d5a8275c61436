//! SU2's native format, for meshes in the plane.
//!
//! Each line of the mesh is a marker under its name; lines of one name are one marker, since SU2 wants
//! names to differ. Blanks and percent signs in names become `_`. Elements and points count from 0.
//!
//! Limits: written, not read. Groups are not kept.

use std::ops::Range;

use mindeg_mesh::Mesh;

use crate::GENERATOR;
use crate::corners::{positions, segments, triangles};
use crate::decimals::{Decimals, push_integer};
use crate::facts::Facts;
use crate::names::{Names, word};
use crate::sections::Section;

/// VTK's numbers of the elements.
const LINE: u8 = b'3';
const TRIANGLE: u8 = b'5';

pub(crate) const FACTS: Facts = Facts {
    name: "su2",
    description: "SU2",
    extensions: &["su2"],
    has_boundary: true,
    first_words: &["NDIME"],
    in_plane: true,
    write: |job, files| job.write(files, [sections(job.mesh)]),
    ..Facts::NONE
};

/// The file from front to back.
fn sections(mesh: &dyn Mesh) -> Vec<Section<'_>> {
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
    Section::of(of_line, 24, move |range, buffer| {
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
