//! Writing PLY.

use crate::gltf::Stored;
use crate::sections::{Section, write_sections};
use crate::{Format, GENERATOR, WriteError, WriteOptions, degree_color};
use glam::DVec3;
use mindeg_mesh::{Mesh, Positions, filled};
use std::io::Write;

/// Writes a mesh as binary PLY. Of the options, it takes the precision, the degree colors and the
/// plane.
///
/// O(n) time, shared by all threads of rayon's current pool, and the memory of one block of about
/// half a MiB for each of them, and one more. Writes are large: `out` needs no buffer around it.
///
/// # Errors
///
/// Before the first byte: those of [`check`]. After it: those of `out`.
///
/// # Example
///
/// ```
/// use mindeg_formats::{WriteOptions, obj, ply};
///
/// let square = obj::read("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n".as_bytes())?;
/// let options = WriteOptions { double: true, ..WriteOptions::default() };
/// let mut file = Vec::new();
/// ply::write(&square, &options, &mut file)?;
/// let read = ply::read(&file[..])?;
/// assert_eq!((read.positions(), read.triangles()), (square.positions(), square.triangles()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write(
    mesh: &dyn Mesh,
    options: &WriteOptions,
    mut out: impl Write,
) -> Result<(), WriteError> {
    check(mesh, options)?;
    write_sections(&mut out, &sections(mesh, options))?;
    Ok(out.flush()?)
}

/// Refuses positions that the format cannot hold. O(n) for 32-bit coordinates, else O(1).
///
/// # Errors
///
/// More vertices than an `int` counts; and for 32-bit coordinates
/// [`OutOfRange`](WriteError::OutOfRange) and, for vertices round a boundary,
/// [`Coincident`](WriteError::Coincident).
pub fn check(positions: &dyn Positions, options: &WriteOptions) -> Result<(), WriteError> {
    WriteError::unless_numbered(Format::Ply, positions)?;
    if !options.double {
        Stored::in_place(positions, options.surface.plane)?;
    }
    Ok(())
}

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
        let degrees = if options.surface.degree_colors {
            filled(range.clone(), 0, |first, out| mesh.fill_degrees(first, out))
        } else {
            Vec::new()
        };
        let points = filled(range, DVec3::ZERO, |first, out| mesh.fill_positions(first, out));
        for (i, point) in points.into_iter().enumerate() {
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
        for triangle in filled(range, [0; 3], |first, out| mesh.fill_triangles(first, out)) {
            let [a, b, c] = triangle.map(u32::to_le_bytes);
            let mut face = [3; 13];
            face[1..5].copy_from_slice(&a);
            face[5..9].copy_from_slice(&b);
            face[9..].copy_from_slice(&c);
            buffer.extend_from_slice(&face);
        }
    })
}
