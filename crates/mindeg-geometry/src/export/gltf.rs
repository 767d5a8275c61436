//! glTF 2.0, as one `.glb` or as `.gltf` with its `.bin`.
//!
//! One node with one mesh, both named after the domain; on request a child node for each
//! side with its boundary segments. The material is a plain one of the core specification:
//! not metallic, rough, and seen from both sides. Texture coordinates count from the upper
//! left, as glTF has it. Vertex colors are 8 bits a channel.
//!
//! **Indices** take 16 bits up to 65,535 vertices and 32 bits from there.
//!
//! **Coordinates** are stored as 32-bit floats. A domain far from the origin would lose its
//! shape in them: where the range of x or of y begins eight times its own length from the
//! origin, or farther out, positions count from the middle of the range, and the node's
//! translation moves them back; so they do wherever vertices would fall together otherwise.
//! Vertices that fall together all the same are an error that names them.
//!
//! **Limits**: a `.glb` ends at 4 GiB, and a mesh that takes more is refused before the
//! first byte; a `.bin` has no such end. Triangles so thin that 32-bit floats make them flat
//! are written as they are.

mod document;
mod positions;

use self::document::{binary_len, document, has_wide_indices};
use self::positions::Positions;
use super::blocks::write_items;
use super::{ExportError, SurfaceOptions, degree_color, in_box, side_edge};
use crate::Mesh;
use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, utf8_percent_encode};
use std::io::{self, Write};

/// Writes the mesh as one binary file, a `.glb`.
///
/// Takes O(n) time in two passes over the points and the memory of one block. Writes are
/// large: `out` needs no buffer around it.
///
/// # Errors
///
/// Before the first byte: [`TooLargeForGlb`](ExportError::TooLargeForGlb),
/// [`OutOfRange`](ExportError::OutOfRange) and [`Coincident`](ExportError::Coincident).
/// After it: those of `out`.
///
/// # Example
///
/// ```
/// use mindeg_geometry::export::{SurfaceOptions, gltf};
/// use mindeg_geometry::{Domain, Mesh};
///
/// let domain = Domain::from_json(
///     r#"{"rectangle": {"width": 2, "height": 1},
///         "sides": [{"intervals": 3}, {"intervals": 1}, {"intervals": 2}, {"intervals": 1}]}"#,
/// )?;
/// let mesh = Mesh::least_degree(&domain)?;
/// let mut file = Vec::new();
/// gltf::write_glb(&mesh, &SurfaceOptions::default(), &mut file)?;
/// assert!(file.starts_with(b"glTF"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_glb(
    mesh: &Mesh,
    options: &SurfaceOptions,
    mut out: impl Write,
) -> Result<(), ExportError> {
    let binary = binary_len(mesh, options).next_multiple_of(4);
    // The points need not be looked at where the binary alone is too large.
    glb_len(0, binary)?;
    let (positions, extent) = Positions::new(mesh, options.plane)?;
    let mut json =
        document(mesh, options, &positions, extent, None).to_vec().map_err(io::Error::from)?;
    json.resize(json.len().next_multiple_of(4), b' ');
    let len = glb_len(json.len() as u64, binary)?;

    let mut head = Vec::from(*b"glTF");
    head.extend_from_slice(&2_u32.to_le_bytes());
    head.extend_from_slice(&len.to_le_bytes());
    // Neither chunk is longer than the file.
    head.extend_from_slice(&(json.len() as u32).to_le_bytes());
    head.extend_from_slice(b"JSON");
    head.extend_from_slice(&json);
    head.extend_from_slice(&(binary as u32).to_le_bytes());
    head.extend_from_slice(b"BIN\0");
    out.write_all(&head)?;
    write_binary(mesh, options, &positions, &mut out)?;
    let padding = binary - binary_len(mesh, options);
    out.write_all(&[0; 3][..padding as usize])?;
    Ok(out.flush()?)
}

/// The length of a `.glb` whose chunks have these lengths.
fn glb_len(json: u64, binary: u64) -> Result<u32, ExportError> {
    const HEADERS: u64 = 12 + 8 + 8;
    let bytes = HEADERS + json + binary;
    u32::try_from(bytes).map_err(|_| ExportError::TooLargeForGlb { bytes })
}

/// Writes the mesh as a JSON document, the `.gltf`, and a binary, the `.bin` beside it.
///
/// `bin_name` is the name of the binary's file as seen from the document, with `/` between
/// folders; it is escaped as the format asks. Takes O(n) time in two passes over the points
/// and the memory of one block. Writes are large: the writers need no buffers around them.
///
/// # Errors
///
/// Before the first byte: [`OutOfRange`](ExportError::OutOfRange) and
/// [`Coincident`](ExportError::Coincident). After it: those of the writers.
///
/// # Example
///
/// ```
/// use mindeg_geometry::export::{SurfaceOptions, gltf};
/// use mindeg_geometry::{Domain, Mesh};
///
/// let domain = Domain::from_json(
///     r#"{"rectangle": {"width": 2, "height": 1},
///         "sides": [{"intervals": 1}, {"intervals": 1}, {"intervals": 1}, {"intervals": 1}]}"#,
/// )?;
/// let mesh = Mesh::least_degree(&domain)?;
/// let (mut json, mut bin) = (Vec::new(), Vec::new());
/// let options = SurfaceOptions { normals: false, texture_coordinates: false, ..Default::default() };
/// gltf::write_gltf(&mesh, &options, "my plate.bin", &mut json, &mut bin)?;
/// assert!(String::from_utf8(json)?.contains(r#""uri": "my%20plate.bin""#));
/// assert_eq!(bin.len(), 4 * 12 + 2 * 6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_gltf(
    mesh: &Mesh,
    options: &SurfaceOptions,
    bin_name: &str,
    mut gltf_out: impl Write,
    mut bin_out: impl Write,
) -> Result<(), ExportError> {
    const ESCAPED: &AsciiSet =
        &NON_ALPHANUMERIC.remove(b'/').remove(b'.').remove(b'-').remove(b'_').remove(b'~');
    let (positions, extent) = Positions::new(mesh, options.plane)?;
    let uri = utf8_percent_encode(bin_name, ESCAPED).to_string();
    let mut json = document(mesh, options, &positions, extent, Some(uri))
        .to_vec_pretty()
        .map_err(io::Error::from)?;
    json.push(b'\n');
    gltf_out.write_all(&json)?;
    gltf_out.flush()?;
    write_binary(mesh, options, &positions, &mut bin_out)?;
    Ok(bin_out.flush()?)
}

/// The arrays in the order of the document.
fn write_binary(
    mesh: &Mesh,
    options: &SurfaceOptions,
    positions: &Positions,
    out: &mut impl Write,
) -> io::Result<()> {
    let vertices = mesh.vertex_count();
    write_items(out, vertices, |range, buffer| {
        range.for_each(|v| push_floats(buffer, &positions.of(mesh.point(v)).to_array()));
    })?;
    if options.normals {
        let normal = options.plane.normal().as_vec3().to_array();
        write_items(out, vertices, |range, buffer| {
            range.for_each(|_| push_floats(buffer, &normal));
        })?;
    }
    if options.texture_coordinates {
        let bounds = mesh.placement().bounds();
        write_items(out, vertices, |range, buffer| {
            for v in range {
                let [s, t] = in_box(bounds, mesh.point(v)).to_array();
                push_floats(buffer, &[s as f32, (1.0 - t) as f32]);
            }
        })?;
    }
    if options.degree_colors {
        write_items(out, vertices, |range, buffer| {
            for v in range {
                let [red, green, blue] = degree_color::linear(mesh.degree(v));
                buffer.extend_from_slice(&[red, green, blue, u8::MAX]);
            }
        })?;
    }
    let wide = has_wide_indices(mesh);
    write_items(out, mesh.triangle_count(), |range, buffer| {
        range.for_each(|i| push_indices(buffer, &mesh.triangle(i), wide));
    })?;
    if options.boundary_lines {
        for side in 0..mesh.boundary().side_count() {
            write_items(out, mesh.boundary().intervals(side), |range, buffer| {
                range.for_each(|i| {
                    push_indices(buffer, &side_edge(mesh.boundary(), side, i), wide);
                });
            })?;
        }
    }
    Ok(())
}

fn push_floats(buffer: &mut Vec<u8>, values: &[f32]) {
    values.iter().for_each(|value| buffer.extend_from_slice(&value.to_le_bytes()));
}

fn push_indices(buffer: &mut Vec<u8>, vertices: &[u32], wide: bool) {
    for &vertex in vertices {
        if wide {
            buffer.extend_from_slice(&vertex.to_le_bytes());
        } else {
            // There are no more vertices than that.
            buffer.extend_from_slice(&(vertex as u16).to_le_bytes());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_glb_ends_where_its_length_does() {
        assert_eq!(glb_len(1000, (1 << 32) - 1032).unwrap(), u32::MAX - 3);
        let error = glb_len(1000, (1 << 32) - 1028).unwrap_err();
        assert_eq!(
            error.to_string(),
            "a .glb holds 4 GiB at most, and this mesh would take at least 4294967296 bytes; write \
             a .gltf with its .bin, which may be larger, or leave out normals and texture \
             coordinates"
        );
    }
}
