//! Writing a mesh as a `.gltf` and its `.bin`, and the arrays of either container.

use super::document::{Layout, document};
use super::numbers::pretty;
use super::positions::Stored;
use crate::corners::{degrees, positions, segments, triangles};
use crate::degree_color;
use crate::options::in_box;
use crate::sections::{Section, write_sections};
use crate::{SurfaceOptions, WriteError};
use gltf_json::Root;
use mindeg_mesh::{Mesh, vertex_normals};
use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, utf8_percent_encode};
use std::io::{self, Write};

/// Writes a mesh as a JSON document, the `.gltf`, and a binary, the `.bin` beside it.
///
/// `bin_name` is the name of the binary's file as seen from the document, with `/` between
/// folders; it is escaped as the format asks. Writes are large: the writers need no buffer around
/// them. O(n) time, shared by all threads of rayon's current pool, and the memory of one block of
/// about half a MiB for each of them, and one more; a mesh that is not in a plane takes O(n) memory
/// for normals.
///
/// # Errors
///
/// Before the first byte: those of [`Stored::new`]. After it: those of the writers.
///
/// # Example
///
/// ```
/// use mindeg_formats::{SurfaceOptions, gltf, obj};
///
/// let square = obj::read("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n".as_bytes())?;
/// let (mut json, mut bin) = (Vec::new(), Vec::new());
/// let options = SurfaceOptions { normals: false, texture_coordinates: false, ..Default::default() };
/// gltf::write(&square, &options, "my plate.bin", &mut json, &mut bin)?;
/// assert!(String::from_utf8(json)?.contains(r#""uri": "my%20plate.bin""#));
/// assert_eq!(bin.len(), 4 * 12 + 2 * 6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write(
    mesh: &dyn Mesh,
    options: &SurfaceOptions,
    bin_name: &str,
    mut gltf_out: impl Write + Send,
    mut bin_out: impl Write + Send,
) -> Result<(), WriteError> {
    let stored = Stored::new(mesh, options.plane)?;
    let [document, binary] = sections(&Arrays::new(mesh, &stored, options), bin_name)?;
    write_sections(&mut gltf_out, &document)?;
    gltf_out.flush()?;
    write_sections(&mut bin_out, &binary)?;
    Ok(bin_out.flush()?)
}

/// The document and the binary, each from front to back.
pub(super) fn sections<'a>(
    arrays: &Arrays<'a>,
    bin_name: &str,
) -> io::Result<[Vec<Section<'a>>; 2]> {
    const ESCAPED: &AsciiSet =
        &NON_ALPHANUMERIC.remove(b'/').remove(b'.').remove(b'-').remove(b'_').remove(b'~');
    let uri = utf8_percent_encode(bin_name, ESCAPED).to_string();
    let mut json = pretty(&arrays.document(Some(uri)))?;
    json.push(b'\n');
    Ok([vec![Section::bytes(json)], arrays.sections()])
}

/// The arrays of the binary.
pub(super) struct Arrays<'a> {
    mesh: &'a dyn Mesh,
    stored: &'a Stored,
    options: &'a SurfaceOptions,
    pub(super) layout: Layout,
}

impl<'a> Arrays<'a> {
    pub(super) fn new(mesh: &'a dyn Mesh, stored: &'a Stored, options: &'a SurfaceOptions) -> Self {
        Self { mesh, stored, options, layout: Layout::new(mesh, options) }
    }

    pub(super) fn document(&self, uri: Option<String>) -> Root {
        document(self.mesh, &self.layout, self.stored, uri)
    }

    /// The arrays in the order of the document.
    pub(super) fn sections(&self) -> Vec<Section<'a>> {
        let Self { mesh, stored, options, layout } = *self;
        let mut sections = vec![Section::new(layout.vertices, 12, move |range, buffer| {
            for point in positions(mesh, range) {
                push_floats(buffer, stored.of(point).to_array());
            }
        })];
        if layout.normals {
            sections.push(normals(mesh, options));
        }
        if layout.texture_coordinates {
            let bounds = mesh.bounds();
            sections.push(Section::new(layout.vertices, 8, move |range, buffer| {
                for point in positions(mesh, range) {
                    let [s, t] = in_box(bounds, point).to_array();
                    push_floats(buffer, [s as f32, (1.0 - t) as f32]);
                }
            }));
        }
        if layout.degree_colors {
            sections.push(Section::new(layout.vertices, 4, move |range, buffer| {
                for degree in degrees(mesh, range) {
                    let [red, green, blue] = degree_color::linear(degree);
                    buffer.extend_from_slice(&[red, green, blue, u8::MAX]);
                }
            }));
        }
        let wide = layout.has_wide_indices();
        sections.push(Section::new(layout.triangles, 12, move |range, buffer| {
            for triangle in triangles(mesh, range) {
                push_indices(buffer, triangle, wide);
            }
        }));
        if layout.segments > 0 {
            sections.push(Section::new(layout.segments, 8, move |range, buffer| {
                for segment in segments(mesh, range) {
                    push_indices(buffer, segment, wide);
                }
            }));
        }
        sections
    }
}

/// A unit normal for each vertex.
fn normals<'a>(mesh: &'a dyn Mesh, options: &SurfaceOptions) -> Section<'a> {
    let plane = options.plane;
    if let Some(normal) = mesh.normal() {
        let normal = plane.place(normal).as_vec3().to_array().map(f32::to_le_bytes);
        return Section::repeated(mesh.vertex_count(), normal.as_flattened());
    }
    let normals = vertex_normals(mesh);
    Section::new(mesh.vertex_count(), 12, move |range, buffer| {
        for &normal in &normals[range.start as usize..range.end as usize] {
            push_floats(buffer, plane.place(normal).as_vec3().to_array());
        }
    })
}

fn push_floats<const N: usize>(buffer: &mut Vec<u8>, values: [f32; N]) {
    buffer.extend_from_slice(values.map(f32::to_le_bytes).as_flattened());
}

fn push_indices<const N: usize>(buffer: &mut Vec<u8>, vertices: [u32; N], wide: bool) {
    if wide {
        buffer.extend_from_slice(vertices.map(u32::to_le_bytes).as_flattened());
    } else {
        // Narrow indices are used only for fewer vertices.
        buffer.extend_from_slice(vertices.map(|v| (v as u16).to_le_bytes()).as_flattened());
    }
}
