//! Writing MSH 4.1.

use std::ops::Range;

use mindeg_mesh::{Bounds, Mesh};

use super::entities::{Entities, Entity, bounds_of_line};
use super::parts::end_of;
use super::shapes::{LINE, POINT, TRIANGLE};
use crate::corners::{Corners, positions, segments, triangles};
use crate::numbers::Numbers;
use crate::sections::Section;
use crate::tables::from_one;
use glam::DVec3;

/// Entities, nodes and elements.
pub(super) fn add_sections<'a>(
    mesh: &'a dyn Mesh,
    entities: &Entities,
    numbers: Numbers,
    sections: &mut Vec<Section<'a>>,
) {
    sections.push(Section::bytes(entity_list(mesh, entities, numbers)));
    sections.push(end_of("Entities", numbers));

    let mut head = b"$Nodes\n".to_vec();
    let count = u64::from(mesh.vertex_count());
    // All in one block, on the first surface.
    numbers.put([1, count, 1, count], &mut head);
    numbers.end_line(&mut head);
    put_head(&mut head, [2, 1, 0], count, numbers);
    sections.push(Section::bytes(head));
    let vertices = 0..mesh.vertex_count();
    let tags = |range: Range<u32>| range.map(|index| [u64::from(index) + 1]);
    sections.push(numbers.records(vertices.clone(), tags));
    let points = move |range| positions(mesh, range).map(|point| point.to_array());
    sections.push(numbers.records(vertices, points));
    sections.push(end_of("Nodes", numbers));

    let elements = entities.element_count(mesh);
    let blocks = entities.curves.len() + entities.surfaces.len() + entities.points.len();
    let mut head = b"$Elements\n".to_vec();
    numbers.put([blocks as u64, elements, 1, elements], &mut head);
    numbers.end_line(&mut head);
    sections.push(Section::bytes(head));
    for (curve, tag) in entities.curves.iter().zip(1..) {
        push_block([1, tag, LINE], curve, 0, numbers, move |range| segments(mesh, range), sections);
    }
    let before = entities.segment_count();
    for (surface, tag) in entities.surfaces.iter().zip(1..) {
        let kinds = [2, tag, TRIANGLE];
        push_block(kinds, surface, before, numbers, move |range| triangles(mesh, range), sections);
    }
    let first = u64::from(before) + u64::from(mesh.triangle_count());
    for (point, tag) in entities.points.iter().zip(1..) {
        let mut block = Vec::new();
        put_head(&mut block, [0, tag, POINT], 1, numbers);
        numbers.put([first + tag as u64, u64::from(point.elements.start) + 1], &mut block);
        numbers.end_line(&mut block);
        sections.push(Section::bytes(block));
    }
    sections.push(end_of("Elements", numbers));
}

/// The elements of an entity, of which others come before.
fn push_block<'a, const N: usize>(
    kinds: [i32; 3],
    entity: &Entity,
    before: u32,
    numbers: Numbers,
    of: impl Fn(Range<u32>) -> Vec<[u32; N]> + Sync + 'a,
    sections: &mut Vec<Section<'a>>,
) {
    let mut head = Vec::new();
    put_head(&mut head, kinds, entity.elements.len() as u64, numbers);
    sections.push(Section::bytes(head));
    sections.push(numbers.records(entity.elements.clone(), move |range: Range<u32>| {
        let elements = range.clone().zip(of(range));
        elements.map(move |(index, element)| {
            ([u64::from(before) + u64::from(index) + 1], from_one(element))
        })
    }));
}

/// The head of a block: dimension, entity and kind, and the number of what follows.
fn put_head(head: &mut Vec<u8>, kinds: [i32; 3], count: u64, numbers: Numbers) {
    numbers.put(kinds, head);
    numbers.put([count], head);
    numbers.end_line(head);
}

/// All entities with their boxes and physical tags. Gmsh refuses elements without them.
fn entity_list(mesh: &dyn Mesh, entities: &Entities, numbers: Numbers) -> Vec<u8> {
    let mut list = b"$Entities\n".to_vec();
    let Entities { points, curves, surfaces, .. } = entities;
    let lines = mesh.lines();
    numbers.put([points.len() as u64, curves.len() as u64, surfaces.len() as u64, 0], &mut list);
    numbers.end_line(&mut list);
    let mut corners = Corners::new(mesh);
    for (point, tag) in points.iter().zip(1_i32..) {
        let at = corners.position(point.elements.start) + DVec3::ZERO;
        numbers.put(([tag], at.to_array(), [1_u64], [point.physical]), &mut list);
        numbers.end_line(&mut list);
    }
    let mut put = |tag: i32, bounds: Bounds<DVec3>, physical: i32| {
        numbers.put([tag], &mut list);
        for corner in [bounds.min, bounds.max] {
            // Adding zero turns -0 into 0.
            numbers.put((corner + DVec3::ZERO).to_array(), &mut list);
        }
        // One physical tag and no bounding entities.
        numbers.put([1_u64], &mut list);
        numbers.put([physical], &mut list);
        numbers.put([0_u64], &mut list);
        numbers.end_line(&mut list);
    };
    for ((curve, tag), line) in curves.iter().zip(1..).zip(lines.iter()) {
        put(tag, bounds_of_line(mesh, line), curve.physical);
    }
    let bounds = mesh.bounds();
    for (surface, tag) in surfaces.iter().zip(1..) {
        put(tag, bounds, surface.physical);
    }
    list
}
