//! Writing MSH: what both versions share.

use std::ops::Range;

use mindeg_mesh::Mesh;

use super::entities::Entities;
use super::record::{Record, end_of};
use super::{write2, write4};
use crate::corners::{degrees, min_angles};
use crate::sections::Section;
use crate::{Encoding, MshVersion, WriteOptions};

/// The best minimum angle.
const EQUILATERAL: f64 = 60.0;

/// The file from front to back.
pub(crate) fn sections<'a>(mesh: &'a dyn Mesh, options: &WriteOptions) -> Vec<Section<'a>> {
    let is_binary = options.encoding == Encoding::Binary;
    let entities = Entities::of(mesh);
    let mut head = Vec::new();
    let version = match options.msh_version {
        MshVersion::V4 => "4.1",
        MshVersion::V2 => "2.2",
    };
    let kind = u8::from(is_binary);
    head.extend_from_slice(format!("$MeshFormat\n{version} {kind} 8\n").as_bytes());
    if is_binary {
        Record::new(true, &mut head).int(1);
        head.push(b'\n');
    }
    head.extend_from_slice(b"$EndMeshFormat\n$PhysicalNames\n");
    head.extend_from_slice(format!("{}\n", entities.physical_names.len()).as_bytes());
    for (dimension, tag, name) in &entities.physical_names {
        head.extend_from_slice(format!("{dimension} {tag} \"{name}\"\n").as_bytes());
    }
    head.extend_from_slice(b"$EndPhysicalNames\n");
    let mut sections = vec![Section::bytes(head)];
    match options.msh_version {
        MshVersion::V4 => write4::add_sections(mesh, &entities, is_binary, &mut sections),
        MshVersion::V2 => write2::add_sections(mesh, &entities, is_binary, &mut sections),
    }
    if options.fields {
        let on_elements = options.msh_version == MshVersion::V4;
        add_fields(mesh, &entities, is_binary, on_elements, &mut sections);
    }
    sections
}

fn add_fields<'a>(
    mesh: &'a dyn Mesh,
    entities: &Entities,
    is_binary: bool,
    on_elements: bool,
    sections: &mut Vec<Section<'a>>,
) {
    let vertices = mesh.vertex_count();
    let segments = entities.curves.last().map_or(0, |curve| curve.elements.end);
    // Tags in data are 32 bits with a sign.
    let elements = u64::from(mesh.triangle_count()) + u64::from(segments);
    if let Ok(count) = i32::try_from(vertices) {
        let degree = move |range: Range<u32>| degrees(mesh, range).into_iter().map(f64::from);
        sections.push(head_of_field("NodeData", "degree", count));
        sections.push(values(vertices, 1, is_binary, degree));
        sections.push(end_of("NodeData", is_binary));
    }
    if let Ok(count) = i32::try_from(elements)
        && on_elements
    {
        let none = |range: Range<u32>| std::iter::repeat_n(EQUILATERAL, range.len());
        sections.push(head_of_field("ElementData", "min_angle", count));
        sections.push(values(segments, 1, is_binary, none));
        let angle = move |range| min_angles(mesh, range);
        sections.push(values(mesh.triangle_count(), segments + 1, is_binary, angle));
        sections.push(end_of("ElementData", is_binary));
    }
}

/// The head of data with one number for each of `count` nodes or elements.
fn head_of_field<'a>(kind: &str, name: &str, count: i32) -> Section<'a> {
    // One string, the name; one number, the time; three counts: the step, the numbers at each, and
    // of how many. They are text in binary files too.
    Section::bytes(format!("${kind}\n1\n\"{name}\"\n1\n0.0\n3\n0\n1\n{count}\n"))
}

/// A tag, counted from `first`, and a number for each of `count` nodes or elements.
fn values<'a, I: Iterator<Item = f64> + 'a>(
    count: u32,
    first: u32,
    is_binary: bool,
    of: impl Fn(Range<u32>) -> I + Sync + 'a,
) -> Section<'a> {
    Section::new(count, if is_binary { 12 } else { 30 }, move |range, buffer| {
        let tags = range.clone().map(|index| first + index);
        if is_binary {
            for (tag, value) in tags.zip(of(range)) {
                buffer.extend_from_slice(&tag.to_le_bytes());
                buffer.extend_from_slice(&value.to_le_bytes());
            }
        } else {
            let mut digits = itoa::Buffer::new();
            let mut decimals = crate::decimals::Decimals::new();
            for (tag, value) in tags.zip(of(range)) {
                buffer.extend_from_slice(digits.format(tag).as_bytes());
                decimals.push(value, buffer);
                buffer.push(b'\n');
            }
        }
    })
}
