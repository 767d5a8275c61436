//! Writing NPZ.

use super::array::head;
use super::zip::Archive;
use crate::corners::{degrees, min_angles, positions, segments, triangles};
use crate::numbers::Numbers;
use crate::sections::{Section, write_sections};
use crate::tables::NamedRuns;
use mindeg_mesh::Mesh;
use std::io::{self, Write};
use std::ops::Range;

/// Writes a mesh as NPZ, with `degrees` and `min_angles` if `fields` are asked for.
pub(super) fn write(mesh: &dyn Mesh, fields: bool, out: impl Write + Send) -> io::Result<()> {
    let mut archive = Archive::new(out);
    let (vertices, count) = (mesh.vertex_count(), mesh.triangle_count());
    let numbers = Numbers::LittleEndian;
    let points = |range| positions(mesh, range).map(|point| point.to_array());
    let corners = |range| triangles(mesh, range).into_iter();
    let mut arrays = vec![
        ("points.npy", head("<f8", vertices, Some(3)), numbers.records(0..vertices, points)),
        ("triangles.npy", head("<u4", count, Some(3)), numbers.records(0..count, corners)),
    ];
    let lines = NamedRuns::of_lines(mesh);
    let segment_count = mesh.lines().last().map_or(0, |line| line.segments.end);
    if segment_count > 0 {
        let ends = |range| segments(mesh, range).into_iter();
        let kept = lines.clone();
        let indices = move |range| kept.of(range).map(|index| [index]);
        arrays.extend([
            (
                "segments.npy",
                head("<u4", segment_count, Some(2)),
                numbers.records(0..segment_count, ends),
            ),
            (
                "segment_groups.npy",
                head("<i4", segment_count, None),
                numbers.records(0..segment_count, indices),
            ),
            text_array("segment_names.npy", &lines.names),
        ]);
    }
    let groups = NamedRuns::of_groups(mesh);
    if groups.names.iter().any(|name| !name.is_empty()) {
        let kept = groups.clone();
        let indices = move |range| kept.of(range).map(|index| [index]);
        arrays.extend([
            ("triangle_groups.npy", head("<i4", count, None), numbers.records(0..count, indices)),
            text_array("triangle_names.npy", &groups.names),
        ]);
    }
    let named = mesh.named_vertices();
    if !named.is_empty() {
        let names: Vec<String> = named.iter().map(|one| one.name.clone()).collect();
        let vertices: Vec<u32> = named.iter().map(|one| one.vertex).collect();
        let count = vertices.len() as u32;
        let of = move |range: Range<u32>| {
            let own: Vec<_> = range.map(|index| [vertices[index as usize]]).collect();
            own.into_iter()
        };
        arrays.extend([
            ("named_points.npy", head("<u4", count, None), numbers.records(0..count, of)),
            text_array("point_names.npy", &names),
        ]);
    }
    if let Some(made_by) = mesh.made_by() {
        // Bytes, so that they can be read in the file.
        let head = head(&format!("|S{}", made_by.len()), 1, None);
        arrays.push(("made_by.npy", head, Section::bytes(made_by)));
    }
    if fields {
        let degrees = |range| degrees(mesh, range).into_iter().map(|degree| [degree]);
        let degrees = numbers.records(0..vertices, degrees);
        arrays.push(("degrees.npy", head("<u4", vertices, None), degrees));
        let angles = |range| min_angles(mesh, range).map(|angle| [angle]);
        let angles = numbers.records(0..count, angles);
        arrays.push(("min_angles.npy", head("<f8", count, None), angles));
    }
    for (name, head, rows) in arrays {
        let sections = [Section::bytes(head), rows];
        let len = sections.iter().map(Section::byte_len).sum();
        archive.entry(name, len, |mut out| write_sections(&mut out, &sections))?;
    }
    archive.finish()
}

/// Names as an array of text: letters of 32 bits, each name filled up with zeros.
fn text_array<'a>(file: &'static str, names: &[String]) -> (&'static str, Vec<u8>, Section<'a>) {
    let longest = names.iter().map(|name| name.chars().count()).max().unwrap_or(0).max(1);
    let filled = |name: &String| {
        let letters = name.chars().map(u32::from).chain(std::iter::repeat(0)).take(longest);
        letters.flat_map(u32::to_le_bytes).collect::<Vec<_>>()
    };
    let bytes: Vec<u8> = names.iter().flat_map(filled).collect();
    (file, head(&format!("<U{longest}"), names.len() as u32, None), Section::bytes(bytes))
}
