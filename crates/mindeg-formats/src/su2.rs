//! SU2's native format, for meshes in the plane.
//!
//! Each line of the mesh is a marker under its name; lines of one name are one marker, since SU2 wants
//! names to differ. Blanks and percent signs in names become `_`. Elements and points count from 0.
//!
//! Limits: written, not read. Groups are not kept.

use std::ops::Range;

use mindeg_mesh::{ByName, Mesh};

use crate::corners::{positions, segments, triangles};
use crate::facts::Facts;
use crate::made_by;
use crate::names::{Names, word};
use crate::numbers::Numbers;
use crate::sections::Section;

/// VTK's numbers of the elements.
const LINE: u8 = 3;
const TRIANGLE: u8 = 5;

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
    let elements = |range: Range<u32>| {
        let corners = range.clone().zip(triangles(mesh, range));
        corners.map(|(index, corners)| ([TRIANGLE], corners, [index]))
    };
    let points = |range: Range<u32>| {
        let points = range.clone().zip(positions(mesh, range));
        points.map(|(index, point)| ([point.x, point.y], [index]))
    };
    let mut sections = vec![
        Section::bytes(format!("% {}\nNDIME= 2\nNELEM= {count}\n", made_by(mesh))),
        Numbers::Text.records(0..count, elements),
        Section::bytes(format!("NPOIN= {vertices}\n")),
        Numbers::Text.records(0..vertices, points),
    ];
    let markers = markers(mesh);
    sections.push(Section::bytes(format!("NMARK= {}\n", markers.len())));
    for (name, ranges) in markers {
        let count: u64 = ranges.iter().map(|range| range.len() as u64).sum();
        sections.push(Section::bytes(format!("MARKER_TAG= {name}\nMARKER_ELEMS= {count}\n")));
        let ends = |range| segments(mesh, range).into_iter().map(|ends| ([LINE], ends));
        sections.extend(ranges.into_iter().map(|range| Numbers::Text.records(range, ends)));
    }
    sections
}

/// The names of the lines, each with the segments of all lines of the name.
fn markers(mesh: &dyn Mesh) -> Vec<(String, Vec<Range<u32>>)> {
    let lines = mesh.lines();
    let ByName { names, of } = ByName::new(lines.iter().map(|line| &line.name));
    let mut taken = Names::default();
    // A percent sign starts a comment.
    let marker = |name: &String| taken.distinct(word(name).replace('%', "_"));
    let mut markers: Vec<_> = names.iter().map(marker).map(|name| (name, Vec::new())).collect();
    for (line, name) in lines.iter().zip(of) {
        markers[name as usize].1.push(line.segments.clone());
    }
    markers
}
