//! Writing MSH 2.2.

use std::ops::Range;

use mindeg_mesh::Mesh;

use super::entities::{Entities, Entity};
use super::parts::end_of;
use super::shapes::{LINE, POINT, TRIANGLE};
use crate::corners::{positions, segments, triangles};
use crate::numbers::Numbers;
use crate::sections::Section;

/// Nodes and elements. Each element has two tags, physical and elementary: many programs want both.
pub(super) fn add_sections<'a>(
    mesh: &'a dyn Mesh,
    entities: &Entities,
    numbers: Numbers,
    sections: &mut Vec<Section<'a>>,
) {
    sections.push(Section::bytes(format!("$Nodes\n{}\n", mesh.vertex_count())));
    sections.push(nodes(mesh, numbers));
    sections.push(end_of("Nodes", numbers));

    let segment_count = entities.segment_count();
    let elements = entities.element_count(mesh);
    sections.push(Section::bytes(format!("$Elements\n{elements}\n")));
    if segment_count > 0 {
        sections.push(head_of_block(LINE, segment_count, numbers));
    }
    for (curve, tag) in entities.curves.iter().zip(1..) {
        let before = Before { element: 0, kind: LINE, tags: [curve.physical, tag] };
        sections.push(elements_of(curve, before, numbers, move |range| segments(mesh, range)));
    }
    sections.push(head_of_block(TRIANGLE, mesh.triangle_count(), numbers));
    for (surface, tag) in entities.surfaces.iter().zip(1..) {
        let before =
            Before { element: segment_count, kind: TRIANGLE, tags: [surface.physical, tag] };
        sections.push(elements_of(surface, before, numbers, move |range| triangles(mesh, range)));
    }
    if let Ok(points @ 1..) = u32::try_from(entities.points.len()) {
        sections.push(head_of_block(POINT, points, numbers));
    }
    let first = segment_count + mesh.triangle_count();
    for (point, tag) in entities.points.iter().zip(1..) {
        let element = (first + tag as u32 - 1).wrapping_sub(point.elements.start);
        let before = Before { element, kind: POINT, tags: [point.physical, tag] };
        sections.push(elements_of(point, before, numbers, |range| range.map(|it| [it]).collect()));
    }
    sections.push(end_of("Elements", numbers));
}

/// Binary elements of one type have a head: the type, how many there are, and how many tags each
/// has.
fn head_of_block<'a>(element_type: i32, count: u32, numbers: Numbers) -> Section<'a> {
    let mut head = Vec::new();
    if numbers != Numbers::Text {
        numbers.put([element_type, count as i32, 2], &mut head);
    }
    Section::bytes(head)
}

fn nodes(mesh: &dyn Mesh, numbers: Numbers) -> Section<'_> {
    numbers.records(0..mesh.vertex_count(), move |range: Range<u32>| {
        let points = range.clone().zip(positions(mesh, range));
        points.map(|(index, point)| ([index + 1], point.to_array()))
    })
}

/// The numbers before the nodes of an entity's elements.
#[derive(Clone, Copy)]
struct Before {
    /// The number of elements of other kinds before them; less the vertex of a point.
    element: u32,
    kind: i32,
    tags: [i32; 2],
}

fn elements_of<'a, const N: usize>(
    entity: &Entity,
    before: Before,
    numbers: Numbers,
    of: impl Fn(Range<u32>) -> Vec<[u32; N]> + Sync + 'a,
) -> Section<'a> {
    numbers.records(entity.elements.clone(), move |range: Range<u32>| {
        let elements = range.clone().zip(of(range));
        // Binary elements have kind and number of tags in their head.
        let kind = (numbers == Numbers::Text).then_some([before.kind, 2]);
        elements.map(move |(index, element)| {
            (
                [before.element.wrapping_add(index) + 1],
                kind,
                before.tags,
                element.map(|vertex| vertex + 1),
            )
        })
    })
}
