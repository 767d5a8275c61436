//! Writing MSH: what both versions share.

use std::ops::Range;

use mindeg_mesh::Mesh;

use super::entities::Entities;
use super::parts::end_of;
use super::periodic::links;
use super::{write2, write4};
use crate::corners::{degrees, min_angles};
use crate::numbers::Numbers;
use crate::sections::Section;
use crate::{MshVersion, WriteOptions};

/// The best minimum angle.
const EQUILATERAL: f64 = 60.0;

/// The file from front to back.
pub(crate) fn sections<'a>(mesh: &'a dyn Mesh, options: &WriteOptions) -> Vec<Section<'a>> {
    let numbers = Numbers::of(options.encoding);
    let is_binary = numbers != Numbers::Text;
    let entities = Entities::of(mesh);
    let version = match options.msh_version {
        MshVersion::V4 => "4.1",
        MshVersion::V2 => "2.2",
    };
    let mut head = format!("$MeshFormat\n{version} {} 8\n", u8::from(is_binary)).into_bytes();
    if is_binary {
        numbers.put([1], &mut head);
        head.push(b'\n');
    }
    let count = entities.physical_names.len();
    let names = entities.physical_names.iter();
    let names = names.map(|(dimension, tag, name)| format!("{dimension} {tag} \"{name}\"\n"));
    let names: String = names.collect();
    head.extend_from_slice(b"$EndMeshFormat\n");
    head.extend(format!("$PhysicalNames\n{count}\n{names}$EndPhysicalNames\n").into_bytes());
    if let Some(made_by) = mesh.made_by() {
        head.extend(format!("$Comments\n{made_by}\n$EndComments\n").into_bytes());
    }
    let mut sections = vec![Section::bytes(head)];
    match options.msh_version {
        MshVersion::V4 => write4::add_sections(mesh, &entities, numbers, &mut sections),
        MshVersion::V2 => write2::add_sections(mesh, &entities, numbers, &mut sections),
    }
    let periodic = mesh.periodic_lines();
    if !periodic.is_empty() {
        sections.push(Section::bytes(links(&periodic, options.msh_version, numbers)));
        sections.push(end_of("Periodic", numbers));
    }
    if options.fields {
        let on_elements = options.msh_version == MshVersion::V4;
        add_fields(mesh, &entities, numbers, on_elements, &mut sections);
    }
    sections
}

fn add_fields<'a>(
    mesh: &'a dyn Mesh,
    entities: &Entities,
    numbers: Numbers,
    on_elements: bool,
    sections: &mut Vec<Section<'a>>,
) {
    // Tags in data are 32 bits with a sign.
    if let Ok(count) = i32::try_from(mesh.vertex_count()) {
        let degree = move |range: Range<u32>| degrees(mesh, range).into_iter().map(f64::from);
        sections.push(head_of_field("NodeData", "degree", count));
        sections.push(values(mesh.vertex_count(), 1, numbers, degree));
        sections.push(end_of("NodeData", numbers));
    }
    if let Ok(count) = i32::try_from(entities.element_count(mesh))
        && on_elements
    {
        let segments = entities.segment_count();
        let none = |range: Range<u32>| std::iter::repeat_n(EQUILATERAL, range.len());
        sections.push(head_of_field("ElementData", "min_angle", count));
        sections.push(values(segments, 1, numbers, none));
        let angle = move |range| min_angles(mesh, range);
        sections.push(values(mesh.triangle_count(), segments + 1, numbers, angle));
        let points = entities.points.len() as u32;
        let first = segments + mesh.triangle_count() + 1;
        sections.push(values(points, first, numbers, none));
        sections.push(end_of("ElementData", numbers));
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
    numbers: Numbers,
    of: impl Fn(Range<u32>) -> I + Sync + 'a,
) -> Section<'a> {
    numbers.records(0..count, move |range: Range<u32>| {
        range.clone().zip(of(range)).map(move |(index, value)| ([first + index], [value]))
    })
}
