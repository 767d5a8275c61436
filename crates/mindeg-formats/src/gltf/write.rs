//! Writing a mesh as a `.gltf` and its `.bin`, and the arrays of either container.

use super::document::{Layout, document};
use super::numbers::pretty;
use super::positions::Stored;
use crate::corners::{degrees, positions, segments, triangles};
use crate::degree_color;
use crate::numbers::Numbers;
use crate::options::in_box;
use crate::sections::{Section, write_sections};
use crate::{MeshPlane, SurfaceOptions, WriteError};
use gltf_json::Root;
use mindeg_mesh::{Mesh, vertex_normals};
use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, utf8_percent_encode};
use std::io::{self, Write};
use std::ops::Range;
use std::sync::Arc;

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
        let (bytes, vertices) = (Numbers::LittleEndian, 0..layout.vertices);
        let points = move |range| positions(mesh, range).map(|point| stored.of(point).to_array());
        let mut sections = vec![bytes.records(vertices.clone(), points)];
        if layout.normals {
            sections.push(normals(mesh, options.plane));
        }
        if layout.texture_coordinates {
            let bounds = mesh.bounds();
            sections.push(bytes.records(vertices.clone(), move |range| {
                let places = positions(mesh, range).map(move |point| in_box(bounds, point));
                places.map(|place| [place.x as f32, (1.0 - place.y) as f32])
            }));
        }
        if layout.degree_colors {
            sections.push(bytes.records(vertices, move |range| {
                let colors = degrees(mesh, range).into_iter().map(degree_color::linear);
                colors.map(|color| (color, [u8::MAX]))
            }));
        }
        let wide = layout.has_wide_indices();
        sections.push(indices(layout.triangles, wide, move |range| triangles(mesh, range)));
        if layout.segments > 0 {
            sections.push(indices(layout.segments, wide, move |range| segments(mesh, range)));
        }
        sections
    }
}

/// A unit normal for each vertex.
fn normals(mesh: &dyn Mesh, plane: MeshPlane) -> Section<'_> {
    let placed = move |normal| plane.place(normal).as_vec3().to_array();
    if let Some(normal) = mesh.normal() {
        return Numbers::LittleEndian.repeated(mesh.vertex_count(), placed(normal));
    }
    let normals = Arc::new(vertex_normals(mesh));
    Numbers::LittleEndian.records(0..mesh.vertex_count(), move |range: Range<u32>| {
        let normals = Arc::clone(&normals);
        range.map(move |vertex| placed(normals[vertex as usize]))
    })
}

fn indices<'a, const N: usize>(
    count: u32,
    wide: bool,
    of: impl Fn(Range<u32>) -> Vec<[u32; N]> + Sync + 'a,
) -> Section<'a> {
    if wide {
        return Numbers::LittleEndian.records(0..count, move |range| of(range).into_iter());
    }
    // Narrow indices are used only for fewer vertices.
    let narrow = |vertices: [u32; N]| vertices.map(|vertex| vertex as u16);
    Numbers::LittleEndian.records(0..count, move |range| of(range).into_iter().map(narrow))
}
