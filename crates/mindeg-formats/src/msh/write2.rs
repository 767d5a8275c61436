//! Writing MSH 2.2.

use mindeg_mesh::Mesh;

use super::entities::{Entities, Entity};
use super::record::{Record, end_of};
use super::shapes::{LINE, TRIANGLE};
use crate::corners::{positions, segments, triangles};
use crate::decimals::Decimals;
use crate::sections::Section;

/// Nodes and elements. Each element has two tags, physical and elementary: many programs want both.
pub(super) fn add_sections<'a>(
    mesh: &'a dyn Mesh,
    entities: &Entities,
    is_binary: bool,
    sections: &mut Vec<Section<'a>>,
) {
    sections.push(Section::bytes(format!("$Nodes\n{}\n", mesh.vertex_count())));
    sections.push(nodes(mesh, is_binary));
    sections.push(end_of("Nodes", is_binary));

    let segment_count = entities.curves.last().map_or(0, |curve| curve.elements.end);
    let elements = u64::from(segment_count) + u64::from(mesh.triangle_count());
    sections.push(Section::bytes(format!("$Elements\n{elements}\n")));
    if segment_count > 0 {
        sections.push(head_of_block(LINE, segment_count, is_binary));
    }
    for (curve, tag) in entities.curves.iter().zip(1..) {
        let before = Before { element: 0, tags: [curve.physical, tag] };
        let of = move |range| segments(mesh, range);
        sections.push(elements_of(curve, LINE, before, is_binary, of));
    }
    sections.push(head_of_block(TRIANGLE, mesh.triangle_count(), is_binary));
    for (surface, tag) in entities.surfaces.iter().zip(1..) {
        let before = Before { element: segment_count, tags: [surface.physical, tag] };
        let of = move |range| triangles(mesh, range);
        sections.push(elements_of(surface, TRIANGLE, before, is_binary, of));
    }
    sections.push(end_of("Elements", is_binary));
}

/// Binary elements of one type have a head: the type, how many there are, and how many tags each
/// has.
fn head_of_block<'a>(element_type: i32, count: u32, is_binary: bool) -> Section<'a> {
    let mut head = Vec::new();
    if is_binary {
        Record::new(true, &mut head).int(element_type).int(count as i32).int(2);
    }
    Section::bytes(head)
}

fn nodes(mesh: &dyn Mesh, is_binary: bool) -> Section<'_> {
    Section::new(mesh.vertex_count(), if is_binary { 28 } else { 48 }, move |range, buffer| {
        let numbers = range.start + 1..;
        if is_binary {
            for (number, position) in numbers.zip(positions(mesh, range)) {
                buffer.extend_from_slice(&number.to_le_bytes());
                let bytes = position.to_array().map(f64::to_le_bytes);
                buffer.extend_from_slice(bytes.as_flattened());
            }
        } else {
            let mut digits = itoa::Buffer::new();
            let mut axes = [0; 3].map(|_| Decimals::new());
            for (number, position) in numbers.zip(positions(mesh, range)) {
                buffer.extend_from_slice(digits.format(number).as_bytes());
                for (decimals, value) in axes.iter_mut().zip(position.to_array()) {
                    decimals.push(value, buffer);
                }
                buffer.push(b'\n');
            }
        }
    })
}

/// The numbers before the nodes of an entity's elements.
#[derive(Clone, Copy)]
struct Before {
    /// The number of elements of other kinds before them.
    element: u32,
    tags: [i32; 2],
}

fn elements_of<'a, const N: usize>(
    entity: &Entity,
    element_type: i32,
    before: Before,
    is_binary: bool,
    of: impl Fn(std::ops::Range<u32>) -> Vec<[u32; N]> + Sync + 'a,
) -> Section<'a> {
    let len = if is_binary { 4 * (3 + N) } else { 20 + 11 * N };
    Section::of(entity.elements.clone(), len as u32, move |range, buffer| {
        let numbers = before.element + range.start + 1..;
        if is_binary {
            let tags = before.tags.map(i32::to_le_bytes);
            for (number, element) in numbers.zip(of(range)) {
                buffer.extend_from_slice(&number.to_le_bytes());
                buffer.extend_from_slice(tags.as_flattened());
                let nodes = element.map(|vertex| (vertex + 1).to_le_bytes());
                buffer.extend_from_slice(nodes.as_flattened());
            }
        } else {
            let [physical, elementary] = before.tags;
            let tags = format!(" {element_type} 2 {physical} {elementary}");
            let mut digits = itoa::Buffer::new();
            for (number, element) in numbers.zip(of(range)) {
                buffer.extend_from_slice(digits.format(number).as_bytes());
                buffer.extend_from_slice(tags.as_bytes());
                for vertex in element {
                    buffer.push(b' ');
                    buffer.extend_from_slice(digits.format(vertex + 1).as_bytes());
                }
                buffer.push(b'\n');
            }
        }
    })
}
