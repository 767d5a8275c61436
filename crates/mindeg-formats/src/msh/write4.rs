//! Writing MSH 4.1.

use std::ops::Range;

use mindeg_mesh::{Bounds, Mesh};

use super::entities::{Entities, bounds_of_line};
use super::record::{Record, end_of};
use super::shapes::{LINE, TRIANGLE};
use crate::corners::{positions, segments, triangles};
use crate::decimals::Decimals;
use crate::sections::Section;
use glam::DVec3;

/// Entities, nodes and elements.
pub(super) fn add_sections<'a>(
    mesh: &'a dyn Mesh,
    entities: &Entities,
    is_binary: bool,
    sections: &mut Vec<Section<'a>>,
) {
    sections.push(Section::bytes(entity_list(mesh, entities, is_binary)));
    let vertices = mesh.vertex_count();

    let mut head = b"$Nodes\n".to_vec();
    let count = u64::from(vertices);
    // All in one block, on the first surface.
    let mut record = Record::new(is_binary, &mut head);
    record.size(1).size(count).size(1).size(count).end();
    record.int(2).int(1).int(0).size(count).end();
    sections.push(Section::bytes(head));
    sections.push(tags(vertices, is_binary));
    sections.push(coordinates(mesh, is_binary));
    sections.push(end_of("Nodes", is_binary));

    let segment_count = entities.curves.last().map_or(0, |curve| curve.elements.end);
    let elements = u64::from(segment_count) + u64::from(mesh.triangle_count());
    let blocks = entities.curves.len() + entities.surfaces.len();
    let mut head = b"$Elements\n".to_vec();
    Record::new(is_binary, &mut head)
        .size(blocks as u64)
        .size(elements)
        .size(1)
        .size(elements)
        .end();
    sections.push(Section::bytes(head));
    for (curve, tag) in entities.curves.iter().zip(1..) {
        let elements = curve.elements.clone();
        sections.push(head_of_block(1, tag, LINE, elements.len(), is_binary));
        sections.push(elements_of(elements, 0, is_binary, move |range| segments(mesh, range)));
    }
    for (surface, tag) in entities.surfaces.iter().zip(1..) {
        let elements = surface.elements.clone();
        sections.push(head_of_block(2, tag, TRIANGLE, elements.len(), is_binary));
        let of = move |range| triangles(mesh, range);
        sections.push(elements_of(elements, segment_count, is_binary, of));
    }
    sections.push(end_of("Elements", is_binary));
}

/// All entities with their boxes and physical tags. Gmsh refuses elements without them.
fn entity_list(mesh: &dyn Mesh, entities: &Entities, is_binary: bool) -> Vec<u8> {
    let mut list = b"$Entities\n".to_vec();
    let Entities { curves, surfaces, .. } = entities;
    let lines = mesh.lines();
    let mut record = Record::new(is_binary, &mut list);
    record.size(0).size(curves.len() as u64).size(surfaces.len() as u64).size(0).end();
    for ((curve, tag), line) in curves.iter().zip(1..).zip(lines.iter()) {
        put_entity(&mut record, tag, bounds_of_line(mesh, line), curve.physical);
    }
    let bounds = mesh.bounds();
    for (surface, tag) in surfaces.iter().zip(1..) {
        put_entity(&mut record, tag, bounds, surface.physical);
    }
    if is_binary {
        list.push(b'\n');
    }
    list.extend_from_slice(b"$EndEntities\n");
    list
}

fn put_entity(record: &mut Record<'_>, tag: i32, bounds: Bounds<DVec3>, physical: i32) {
    record.int(tag);
    for corner in [bounds.min, bounds.max] {
        for coordinate in corner.to_array() {
            record.double(coordinate);
        }
    }
    // One physical tag; what bounds the entity is not told.
    record.size(1).int(physical).size(0).end();
}

fn head_of_block<'a>(
    dimension: i32,
    tag: i32,
    element_type: i32,
    count: usize,
    is_binary: bool,
) -> Section<'a> {
    let mut head = Vec::new();
    let mut record = Record::new(is_binary, &mut head);
    record.int(dimension).int(tag).int(element_type).size(count as u64).end();
    Section::bytes(head)
}

/// The tags 1 to `count`.
fn tags<'a>(count: u32, is_binary: bool) -> Section<'a> {
    Section::new(count, if is_binary { 8 } else { 11 }, move |range, buffer| {
        let mut digits = itoa::Buffer::new();
        for tag in range.map(|index| u64::from(index) + 1) {
            if is_binary {
                buffer.extend_from_slice(&tag.to_le_bytes());
            } else {
                buffer.extend_from_slice(digits.format(tag).as_bytes());
                buffer.push(b'\n');
            }
        }
    })
}

fn coordinates(mesh: &dyn Mesh, is_binary: bool) -> Section<'_> {
    Section::new(mesh.vertex_count(), if is_binary { 24 } else { 40 }, move |range, buffer| {
        if is_binary {
            for position in positions(mesh, range) {
                let bytes = position.to_array().map(f64::to_le_bytes);
                buffer.extend_from_slice(bytes.as_flattened());
            }
        } else {
            let [mut x, mut y, mut z] = [0; 3].map(|_| Decimals::new());
            for position in positions(mesh, range) {
                x.push_first(position.x, buffer);
                y.push(position.y, buffer);
                z.push(position.z, buffer);
                buffer.push(b'\n');
            }
        }
    })
}

/// Elements with tags that follow `before`, each its tag and its nodes.
fn elements_of<'a, const N: usize>(
    elements: Range<u32>,
    before: u32,
    is_binary: bool,
    of: impl Fn(Range<u32>) -> Vec<[u32; N]> + Sync + 'a,
) -> Section<'a> {
    let len = if is_binary { 8 * (1 + N) } else { 11 * (1 + N) };
    Section::of(elements, len as u32, move |range, buffer| {
        let first = u64::from(before) + u64::from(range.start) + 1;
        if is_binary {
            for (tag, element) in (first..).zip(of(range)) {
                buffer.extend_from_slice(&tag.to_le_bytes());
                let nodes = element.map(|vertex| (u64::from(vertex) + 1).to_le_bytes());
                buffer.extend_from_slice(nodes.as_flattened());
            }
        } else {
            let mut digits = itoa::Buffer::new();
            for (tag, element) in (first..).zip(of(range)) {
                buffer.extend_from_slice(digits.format(tag).as_bytes());
                for vertex in element {
                    buffer.push(b' ');
                    buffer.extend_from_slice(digits.format(u64::from(vertex) + 1).as_bytes());
                }
                buffer.push(b'\n');
            }
        }
    })
}
