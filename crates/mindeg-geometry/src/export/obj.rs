//! Wavefront OBJ.
//!
//! One object for the surface; on request one more for each side, holding the boundary
//! segments `l a b` of that side, since readers take a surface that shares its object with
//! lines for lines. A vertex has a normal and texture coordinates of its own under its own
//! number, so that `f i/i/i` never makes a reader split a vertex. Numbers are the shortest
//! decimals that read back as the same `f64` (`f32` for texture coordinates and colors, of
//! which no reader keeps more); negative zero is written `0`. Vertex numbers
//! start at 1 in the file and nowhere else.
//!
//! Limits: an OBJ has no units and no up axis. Vertex colors, on request, follow the
//! coordinates as `v x y z r g b`, a common extension that some readers reject.

use super::blocks::write_items;
use super::{GENERATOR, SurfaceOptions, degree_color, in_box, mesh_name, side_edge, side_name};
use crate::Mesh;
use std::io::{self, Write};

/// Writes the mesh as OBJ.
///
/// Takes O(n) time and the memory of one block. Writes are large: `out` needs no buffer
/// around it.
///
/// # Errors
///
/// Those of `out`; what was written until then is part of the file.
///
/// # Example
///
/// ```
/// use mindeg_geometry::export::{SurfaceOptions, obj};
/// use mindeg_geometry::{Domain, Mesh};
///
/// let domain = Domain::from_json(
///     r#"{"name": "plate", "rectangle": {"width": 2, "height": 1},
///         "sides": [{"intervals": 1}, {"intervals": 1}, {"intervals": 1}, {"intervals": 1}]}"#,
/// )?;
/// let mesh = Mesh::least_degree(&domain)?;
/// let mut file = Vec::new();
/// obj::write(&mesh, &SurfaceOptions::default(), &mut file)?;
/// assert!(String::from_utf8(file)?.contains("\no plate\nv 0 0 0\nv 2 0 0\nv 2 1 0\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write(mesh: &Mesh, options: &SurfaceOptions, mut out: impl Write) -> io::Result<()> {
    let out = &mut out;
    let (vertices, triangles) = (mesh.vertex_count(), mesh.triangle_count());
    let header = format!(
        "# {GENERATOR}\n# {vertices} vertices, {triangles} triangles, maximum degree {}\no {}\n",
        mesh.max_degree(),
        object_name(mesh_name(mesh)),
    );
    out.write_all(header.as_bytes())?;
    write_items(out, vertices, |range, buffer| {
        for v in range {
            let place = options.plane.place(mesh.point(v));
            push_numbers(buffer, "v", &place.to_array());
            if options.degree_colors {
                // A thousandth is enough to tell 256 levels apart.
                let thousandths = |level: u8| (1000 * u32::from(level) + 127) / 255;
                let color = degree_color::srgb(mesh.degree(v)).map(thousandths);
                push_values(buffer, &color.map(|value| value as f32 / 1000.0));
            }
            buffer.push(b'\n');
        }
    })?;
    if options.texture_coordinates {
        let bounds = mesh.placement().bounds();
        write_items(out, vertices, |range, buffer| {
            for v in range {
                let [s, t] = in_box(bounds, mesh.point(v)).as_vec2().to_array();
                push_numbers(buffer, "vt", &[s, t]);
                buffer.push(b'\n');
            }
        })?;
    }
    if options.normals {
        let mut line = Vec::new();
        push_numbers(&mut line, "vn", &options.plane.normal().to_array());
        line.push(b'\n');
        write_items(out, vertices, |range, buffer| {
            range.for_each(|_| buffer.extend_from_slice(&line));
        })?;
    }
    write_items(out, triangles, |range, buffer| {
        for i in range {
            buffer.push(b'f');
            for v in mesh.triangle(i) {
                push_corner(buffer, v, options);
            }
            buffer.push(b'\n');
        }
    })?;
    if options.boundary_lines {
        write_boundary(mesh, out)?;
    }
    out.flush()
}

fn write_boundary(mesh: &Mesh, out: &mut impl Write) -> io::Result<()> {
    for side in 0..mesh.boundary().side_count() {
        let header = format!("o {}\n", object_name(&side_name(mesh, side)));
        out.write_all(header.as_bytes())?;
        write_items(out, mesh.boundary().intervals(side), |range, buffer| {
            for i in range {
                buffer.push(b'l');
                for v in side_edge(mesh.boundary(), side, i) {
                    buffer.push(b' ');
                    push_number_of(buffer, v);
                }
                buffer.push(b'\n');
            }
        })?;
    }
    Ok(())
}

/// A corner of a face: the vertex with its texture coordinates and normal, where there are any.
fn push_corner(buffer: &mut Vec<u8>, vertex: u32, options: &SurfaceOptions) {
    buffer.push(b' ');
    let mut digits = itoa::Buffer::new();
    let number = digits.format(vertex + 1).as_bytes();
    buffer.extend_from_slice(number);
    let more: &[&[u8]] = match (options.texture_coordinates, options.normals) {
        (true, true) => &[b"/", number, b"/", number],
        (true, false) => &[b"/", number],
        (false, true) => &[b"//", number],
        (false, false) => &[],
    };
    more.iter().for_each(|bytes| buffer.extend_from_slice(bytes));
}

fn push_number_of(buffer: &mut Vec<u8>, vertex: u32) {
    let mut digits = itoa::Buffer::new();
    buffer.extend_from_slice(digits.format(vertex + 1).as_bytes());
}

fn push_numbers(buffer: &mut Vec<u8>, keyword: &str, values: &[impl zmij::Float]) {
    buffer.extend_from_slice(keyword.as_bytes());
    push_values(buffer, values);
}

fn push_values(buffer: &mut Vec<u8>, values: &[impl zmij::Float]) {
    let mut digits = zmij::Buffer::new();
    for &value in values {
        buffer.push(b' ');
        let number = digits.format_finite(value);
        let number = number.strip_suffix(".0").unwrap_or(number);
        buffer.extend_from_slice(number.as_bytes());
    }
}

/// A name as an OBJ can hold it: many readers end it at the first white space. Names of
/// domains and sides are not blank and have no control characters.
fn object_name(name: &str) -> String {
    name.split_whitespace().collect::<Vec<_>>().join("_")
}
