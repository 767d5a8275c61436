//! Writing PLY.

use crate::corners::{positions, triangles};
use crate::numbers::Numbers;
use crate::sections::Section;
use crate::{WriteOptions, degree_color, made_by};
use glam::{DVec3, Vec3};
use mindeg_mesh::Mesh;
use std::ops::Range;

/// The file from front to back.
pub(crate) fn sections<'a>(mesh: &'a dyn Mesh, options: &'a WriteOptions) -> Vec<Section<'a>> {
    vec![header(mesh, options), vertices(mesh, options), faces(mesh)]
}

fn header<'a>(mesh: &dyn Mesh, options: &WriteOptions) -> Section<'a> {
    let float = if options.double { "double" } else { "float" };
    let mut properties: String =
        ["x", "y", "z"].map(|axis| format!("property {float} {axis}\n")).concat();
    if options.surface.degree_colors {
        properties += &["red", "green", "blue"].map(|c| format!("property uchar {c}\n")).concat();
    }
    Section::bytes(format!(
        "ply\nformat binary_little_endian 1.0\ncomment {}\n\
         element vertex {}\n{properties}\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        made_by(mesh),
        mesh.vertex_count(),
        mesh.triangle_count(),
    ))
}

fn vertices<'a>(mesh: &'a dyn Mesh, options: &'a WriteOptions) -> Section<'a> {
    let (vertices, bytes) = (0..mesh.vertex_count(), Numbers::LittleEndian);
    let points = move |range: Range<u32>| {
        let has_colors = options.surface.degree_colors;
        let colors = degree_color::of_vertices(mesh, range.clone(), has_colors);
        positions(mesh, range).map(|point| options.surface.plane.place(point)).zip(colors)
    };
    if options.double {
        let row = |(point, color): (DVec3, _)| (point.to_array(), color);
        return bytes.records(vertices, move |range| points(range).map(row));
    }
    // Rounding can make a zero negative; adding zero undoes it.
    let row = |(point, color): (DVec3, _)| ((point.as_vec3() + Vec3::ZERO).to_array(), color);
    bytes.records(vertices, move |range| points(range).map(row))
}

fn faces(mesh: &dyn Mesh) -> Section<'_> {
    Numbers::LittleEndian.records(0..mesh.triangle_count(), |range| {
        triangles(mesh, range).into_iter().map(|corners| ([3_u8], corners))
    })
}
