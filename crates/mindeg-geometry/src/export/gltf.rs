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
use super::sections::{Section, write_sections};
use super::{ExportError, SurfaceOptions, boundary_edge, degree_color, in_box};
use crate::{Domain, Mesh};
use mindeg_core::Boundary;
use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, utf8_percent_encode};
use std::io::{self, Write};

/// Writes the mesh as one binary file, a `.glb`: a [`Glb`] that is made and written.
///
/// # Errors
///
/// Before the first byte: those of [`Glb::new`]. After it: those of `out`.
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
    out: impl Write,
) -> Result<(), ExportError> {
    Ok(Glb::new(mesh.domain(), options)?.write(mesh, out)?)
}

/// A `.glb` of which everything is known but the large arrays: what is known of a domain before
/// there is a mesh, and the same for all its meshes.
///
/// # Example
///
/// ```
/// use mindeg_geometry::export::{SurfaceOptions, gltf::Glb};
/// use mindeg_geometry::{Domain, Mesh, Side};
///
/// let domain = Domain::rectangle(4.0, 3.0, [3, 3, 2, 2].map(Side::count).into())?;
/// let options = SurfaceOptions::default();
/// let glb = Glb::new(&domain, &options)?;
/// let mut file = Vec::new();
/// glb.write(&Mesh::least_degree(&domain)?, &mut file)?;
/// assert_eq!(file.len() as u64, glb.file_len());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Glb<'a> {
    arrays: Arrays<'a>,
    /// What goes before the arrays.
    head: Vec<u8>,
}

impl<'a> Glb<'a> {
    /// Looks at the points of a domain. O(n) time, shared by all threads of rayon's current pool;
    /// next to no memory.
    ///
    /// # Errors
    ///
    /// [`TooLargeForGlb`](ExportError::TooLargeForGlb), [`OutOfRange`](ExportError::OutOfRange)
    /// and [`Coincident`](ExportError::Coincident).
    pub fn new(domain: &'a Domain, options: &'a SurfaceOptions) -> Result<Self, ExportError> {
        check_glb_size(domain.boundary(), options)?;
        let (positions, extent) = Positions::new(domain.placement(), options.plane)?;
        let document = document(domain, options, &positions, extent, None);
        let mut json = document.to_vec().map_err(io::Error::from)?;
        json.resize(json.len().next_multiple_of(4), b' ');
        let binary = binary_len(domain.boundary(), options).next_multiple_of(4);
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
        Ok(Self { arrays: Arrays { domain, options, positions }, head })
    }

    /// The length of the file in bytes. O(1).
    #[must_use]
    pub fn file_len(&self) -> u64 {
        self.head.len() as u64 + self.arrays.len().next_multiple_of(4)
    }

    /// Writes the file of a mesh of the domain.
    ///
    /// Takes O(n) time, shared by all threads of rayon's current pool, and the memory of one block
    /// of about half a MiB for each of them, and one more. Writes are large: `out` needs no buffer
    /// around it. The bytes do not depend on the threads.
    ///
    /// # Errors
    ///
    /// Those of `out`; what was written until then is part of the file. Before the first byte, a
    /// mesh of another domain.
    pub fn write(&self, mesh: &Mesh, mut out: impl Write) -> io::Result<()> {
        let mut sections = vec![Section::bytes(&*self.head)];
        sections.extend(self.arrays.sections(mesh)?);
        let len = self.arrays.len();
        let padding = len.next_multiple_of(4) - len;
        sections.push(Section::bytes(&[0; 3][..padding as usize]));
        write_sections(&mut out, &sections)?;
        out.flush()
    }
}

/// Refuses a boundary whose meshes would take more than a `.glb` holds, before there is a mesh.
/// O(1).
///
/// # Errors
///
/// [`TooLargeForGlb`](ExportError::TooLargeForGlb). What passes here can be refused by a few
/// bytes all the same when names and numbers are known ([`Glb::new`]).
pub fn check_glb_size(boundary: &Boundary, options: &SurfaceOptions) -> Result<(), ExportError> {
    glb_len(0, binary_len(boundary, options).next_multiple_of(4)).map(|_| ())
}

/// The length of a `.glb` whose chunks have these lengths.
fn glb_len(json: u64, binary: u64) -> Result<u32, ExportError> {
    const HEADERS: u64 = 12 + 8 + 8;
    let bytes = HEADERS + json + binary;
    u32::try_from(bytes).map_err(|_| ExportError::TooLargeForGlb { bytes })
}

/// Writes the mesh as a JSON document, the `.gltf`, and a binary, the `.bin` beside it: a [`Gltf`]
/// that is made and written.
///
/// # Errors
///
/// Before the first byte: those of [`Gltf::new`]. After it: those of the writers.
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
    gltf_out: impl Write,
    bin_out: impl Write,
) -> Result<(), ExportError> {
    Ok(Gltf::new(mesh.domain(), options, bin_name)?.write(mesh, gltf_out, bin_out)?)
}

/// A `.gltf` with its `.bin`, of which everything is known but the large arrays, as of a [`Glb`].
///
/// # Example
///
/// ```
/// use mindeg_geometry::export::{SurfaceOptions, gltf::Gltf};
/// use mindeg_geometry::{Domain, Mesh, Side};
///
/// let domain = Domain::rectangle(4.0, 3.0, [3, 3, 2, 2].map(Side::count).into())?;
/// let options = SurfaceOptions::default();
/// let gltf = Gltf::new(&domain, &options, "plate.bin")?;
/// let (mut json, mut bin) = (Vec::new(), Vec::new());
/// gltf.write(&Mesh::least_degree(&domain)?, &mut json, &mut bin)?;
/// assert_eq!([json.len() as u64, bin.len() as u64], gltf.file_lens());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Gltf<'a> {
    arrays: Arrays<'a>,
    document: Vec<u8>,
}

impl<'a> Gltf<'a> {
    /// Looks at the points of a domain. `bin_name` is the name of the binary's file as seen from
    /// the document, with `/` between folders; it is escaped as the format asks.
    ///
    /// O(n) time, shared by all threads of rayon's current pool; next to no memory.
    ///
    /// # Errors
    ///
    /// [`OutOfRange`](ExportError::OutOfRange) and [`Coincident`](ExportError::Coincident).
    pub fn new(
        domain: &'a Domain,
        options: &'a SurfaceOptions,
        bin_name: &str,
    ) -> Result<Self, ExportError> {
        const ESCAPED: &AsciiSet =
            &NON_ALPHANUMERIC.remove(b'/').remove(b'.').remove(b'-').remove(b'_').remove(b'~');
        let (positions, extent) = Positions::new(domain.placement(), options.plane)?;
        let uri = utf8_percent_encode(bin_name, ESCAPED).to_string();
        let mut document = document(domain, options, &positions, extent, Some(uri))
            .to_vec_pretty()
            .map_err(io::Error::from)?;
        document.push(b'\n');
        Ok(Self { arrays: Arrays { domain, options, positions }, document })
    }

    /// The lengths of the document and of the binary in bytes. O(1).
    #[must_use]
    pub fn file_lens(&self) -> [u64; 2] {
        [self.document.len() as u64, self.arrays.len()]
    }

    /// Writes the files of a mesh of the domain, as [`Glb::write`] does.
    ///
    /// # Errors
    ///
    /// Those of the writers; what was written until then is part of the files. Before the first
    /// byte, a mesh of another domain.
    pub fn write(
        &self,
        mesh: &Mesh,
        mut gltf_out: impl Write,
        mut bin_out: impl Write,
    ) -> io::Result<()> {
        let arrays = self.arrays.sections(mesh)?;
        gltf_out.write_all(&self.document)?;
        gltf_out.flush()?;
        write_sections(&mut bin_out, &arrays)?;
        bin_out.flush()
    }
}

/// What the binary holds.
#[derive(Debug)]
struct Arrays<'a> {
    domain: &'a Domain,
    options: &'a SurfaceOptions,
    positions: Positions,
}

impl Arrays<'_> {
    fn len(&self) -> u64 {
        binary_len(self.domain.boundary(), self.options)
    }

    /// The arrays of a mesh in the order of the document.
    fn sections<'m>(&'m self, mesh: &'m Mesh) -> io::Result<Vec<Section<'m>>> {
        let Self { domain, options, positions } = self;
        if mesh.domain() != *domain {
            let message = "the mesh is of another domain than the file was prepared for";
            return Err(io::Error::new(io::ErrorKind::InvalidInput, message));
        }
        let (placement, vertices) = (mesh.placement(), mesh.vertex_count());
        let mut sections = vec![Section::new(vertices, 12, move |range, buffer| {
            for point in placement.points_of(range) {
                push_floats(buffer, positions.of(point).to_array());
            }
        })];
        if options.normals {
            let normal = options.plane.normal().as_vec3().to_array();
            sections.push(Section::new(vertices, 12, move |range, buffer| {
                range.for_each(|_| push_floats(buffer, normal));
            }));
        }
        if options.texture_coordinates {
            let bounds = placement.bounds();
            sections.push(Section::new(vertices, 8, move |range, buffer| {
                for point in placement.points_of(range) {
                    let [s, t] = in_box(bounds, point).to_array();
                    push_floats(buffer, [s as f32, (1.0 - t) as f32]);
                }
            }));
        }
        if options.degree_colors {
            sections.push(Section::new(vertices, 4, |range, buffer| {
                for vertex in range {
                    let [red, green, blue] = degree_color::linear(mesh.degree(vertex));
                    buffer.extend_from_slice(&[red, green, blue, u8::MAX]);
                }
            }));
        }
        let wide = has_wide_indices(mesh.boundary());
        sections.push(Section::new(mesh.triangle_count(), 12, move |range, buffer| {
            mesh.triangles_of(range).for_each(|triangle| push_indices(buffer, triangle, wide));
        }));
        if options.boundary_lines {
            let boundary = mesh.boundary();
            sections.push(Section::new(vertices, 8, move |range, buffer| {
                range.for_each(|start| push_indices(buffer, boundary_edge(boundary, start), wide));
            }));
        }
        Ok(sections)
    }
}

fn push_floats<const N: usize>(buffer: &mut Vec<u8>, values: [f32; N]) {
    buffer.extend_from_slice(values.map(f32::to_le_bytes).as_flattened());
}

fn push_indices<const N: usize>(buffer: &mut Vec<u8>, vertices: [u32; N], wide: bool) {
    if wide {
        buffer.extend_from_slice(vertices.map(u32::to_le_bytes).as_flattened());
    } else {
        // There are no more vertices than that.
        buffer.extend_from_slice(vertices.map(|v| (v as u16).to_le_bytes()).as_flattened());
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
             a .gltf with its .bin or an OBJ, which may be larger, or use fewer intervals"
        );
    }
}
