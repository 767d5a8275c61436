//! Writing PLY.

use crate::corners::{degrees, positions, triangles};
use crate::sections::Section;
use crate::{GENERATOR, WriteOptions, degree_color};
use mindeg_mesh::Mesh;

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
        "ply\nformat binary_little_endian 1.0\ncomment {GENERATOR}\n\
         element vertex {}\n{properties}\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        mesh.vertex_count(),
        mesh.triangle_count(),
    ))
}

fn vertices<'a>(mesh: &'a dyn Mesh, options: &'a WriteOptions) -> Section<'a> {
    let len =
        if options.double { 24 } else { 12 } + if options.surface.degree_colors { 3 } else { 0 };
    Section::new(mesh.vertex_count(), len, move |range, buffer| {
        let degrees =
            if options.surface.degree_colors { degrees(mesh, range.clone()) } else { Vec::new() };
        for (i, point) in positions(mesh, range).enumerate() {
            let point = options.surface.plane.place(point);
            if options.double {
                buffer.extend_from_slice(point.to_array().map(f64::to_le_bytes).as_flattened());
            } else {
                // Rounding can make a zero negative; adding zero undoes it.
                let point = point.as_vec3() + glam::Vec3::ZERO;
                buffer.extend_from_slice(point.to_array().map(f32::to_le_bytes).as_flattened());
            }
            if let Some(&degree) = degrees.get(i) {
                buffer.extend_from_slice(&degree_color::srgb(degree));
            }
        }
    })
}

fn faces(mesh: &dyn Mesh) -> Section<'_> {
    Section::new(mesh.triangle_count(), 13, |range, buffer| {
        for triangle in triangles(mesh, range) {
            let [a, b, c] = triangle.map(u32::to_le_bytes);
            let mut face = [3; 13];
            face[1..5].copy_from_slice(&a);
            face[5..9].copy_from_slice(&b);
            face[9..].copy_from_slice(&c);
            buffer.extend_from_slice(&face);
        }
    })
}
