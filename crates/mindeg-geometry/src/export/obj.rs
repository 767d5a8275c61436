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

mod numbers;

use self::numbers::{CornerNames, Decimals};
use super::sections::{self, Section, write_sections};
use super::{GENERATOR, SurfaceOptions, boundary_edge, degree_color, in_box, mesh_name, side_name};
use crate::{Domain, Mesh};
use std::io::{self, Write};

/// Writes the mesh as OBJ.
///
/// Takes O(n) time, shared by all threads of rayon's current pool, and the memory of one block of
/// about half a MiB for each of them, and one more. Writes are large: `out` needs no buffer
/// around it. The bytes do not depend on the threads.
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
    write_sections(&mut out, &sections(mesh, options))?;
    out.flush()
}

/// About how many bytes [`write()`] will write for a mesh of the domain, whichever it is.
///
/// Takes a millisecond at most: some thousand lines are formatted. On the domains tried, from tens
/// of bytes to gigabytes, evenly spaced and graded, it was off by half a percent at most.
///
/// # Example
///
/// ```
/// use mindeg_geometry::export::{SurfaceOptions, obj};
/// use mindeg_geometry::{Domain, Mesh, Side};
///
/// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(1000); 4])?;
/// let options = SurfaceOptions::default();
/// let estimate = obj::estimated_len(&domain, &options);
/// let mut file = Vec::new();
/// obj::write(&Mesh::least_degree(&domain)?, &options, &mut file)?;
/// assert!((estimate as f64 / file.len() as f64 - 1.0).abs() < 0.01);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn estimated_len(domain: &Domain, options: &SurfaceOptions) -> u64 {
    sections::estimated_len(&sections(&Mesh::first(domain), options))
}

/// The file from front to back.
fn sections<'a>(mesh: &'a Mesh, options: &'a SurfaceOptions) -> Vec<Section<'a>> {
    let mut sections = vec![header(mesh), coordinates(mesh, options)];
    if options.texture_coordinates {
        sections.push(texture_coordinates(mesh));
    }
    if options.normals {
        let [x, y, z] = options.plane.normal().to_array();
        let line = format!("vn {x} {y} {z}\n").into_bytes();
        sections.push(Section::new(mesh.vertex_count(), 9, move |range, buffer| {
            range.for_each(|_| buffer.extend_from_slice(&line));
        }));
    }
    sections.push(Section::new(mesh.triangle_count(), 80, |range, buffer| {
        let mut names = CornerNames::new(options);
        mesh.triangles_of(range).for_each(|triangle| names.push_face(triangle, buffer));
    }));
    if options.boundary_lines {
        sections.push(lines(mesh));
    }
    sections
}

fn header(mesh: &Mesh) -> Section<'_> {
    Section::bytes(format!(
        "# {GENERATOR}\n# {} vertices, {} triangles, maximum degree {}\no {}\n",
        mesh.vertex_count(),
        mesh.triangle_count(),
        mesh.max_degree(),
        object_name(mesh_name(mesh.domain())),
    ))
}

fn coordinates<'a>(mesh: &'a Mesh, options: &'a SurfaceOptions) -> Section<'a> {
    Section::new(mesh.vertex_count(), 32, |range, buffer| {
        let mut decimals = [0; 3].map(|_| Decimals::new());
        let mut levels = [0; 3].map(|_| Decimals::new());
        for (vertex, point) in range.clone().zip(mesh.placement().points_of(range)) {
            buffer.push(b'v');
            for (decimals, value) in decimals.iter_mut().zip(options.plane.place(point).to_array())
            {
                decimals.push(value, buffer);
            }
            if options.degree_colors {
                // A thousandth is enough to tell 256 levels apart.
                let thousandths = |level: u8| (1000 * u32::from(level) + 127) / 255;
                let color = degree_color::srgb(mesh.degree(vertex)).map(thousandths);
                for (decimals, value) in levels.iter_mut().zip(color) {
                    decimals.push(value as f32 / 1000.0, buffer);
                }
            }
            buffer.push(b'\n');
        }
    })
}

fn texture_coordinates(mesh: &Mesh) -> Section<'_> {
    let bounds = mesh.placement().bounds();
    Section::new(mesh.vertex_count(), 24, move |range, buffer| {
        let mut decimals = [0; 2].map(|_| Decimals::new());
        for point in mesh.placement().points_of(range) {
            buffer.extend_from_slice(b"vt");
            let place = in_box(bounds, point).as_vec2().to_array();
            for (decimals, value) in decimals.iter_mut().zip(place) {
                decimals.push(value, buffer);
            }
            buffer.push(b'\n');
        }
    })
}

/// The sides, each as an object of line segments.
fn lines(mesh: &Mesh) -> Section<'_> {
    let boundary = mesh.boundary();
    Section::new(mesh.vertex_count(), 20, move |range, buffer| {
        let mut digits = itoa::Buffer::new();
        for start in range {
            if boundary.is_corner(start) {
                let name = side_name(mesh.domain(), boundary.side_of(start));
                buffer.extend_from_slice(format!("o {}\n", object_name(&name)).as_bytes());
            }
            buffer.push(b'l');
            for vertex in boundary_edge(boundary, start) {
                buffer.push(b' ');
                buffer.extend_from_slice(digits.format(vertex + 1).as_bytes());
            }
            buffer.push(b'\n');
        }
    })
}

/// A name as an OBJ can hold it: many readers end it at the first white space. Names of
/// domains and sides are not blank and have no control characters.
fn object_name(name: &str) -> String {
    name.split_whitespace().collect::<Vec<_>>().join("_")
}
