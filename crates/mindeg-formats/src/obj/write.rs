//! Writing OBJ.

use super::library::NamedMaterials;
use super::numbers::CornerNames;
use crate::corners::{self, positions};
use crate::materials::is_same_object;
use crate::names::{Names, word};
use crate::numbers::Numbers;
use crate::options::in_box;
use crate::sections::{Section, write_sections};
use crate::{SurfaceOptions, degree_color, made_by, mesh_name};
use glam::Vec3;
use mindeg_mesh::{ByName, Mesh, vertex_normals};
use std::io::{self, Write};
use std::ops::Range;
use std::sync::Arc;

/// Writes a mesh as OBJ. Of materials it holds the names; [`Writer`](crate::Writer) writes their
/// colors beside it.
///
/// Takes O(n) time, shared by all threads of rayon's current pool, and the memory of one block of
/// about half a MiB for each of them, and one more; a mesh that is not in a plane takes O(n) memory
/// for normals. Writes are large: `out` needs no buffer around it. The bytes do not depend on the
/// threads.
///
/// # Errors
///
/// Errors of `out`; what was written until then is part of the file.
///
/// # Example
///
/// ```
/// use mindeg_formats::{SurfaceOptions, obj};
/// use mindeg::{BoundaryMesh, Domain};
///
/// let domain = Domain::from_json(
///     r#"{"name": "plate", "rectangle": {"width": 2, "height": 1},
///         "sides": [{"intervals": 1}, {"intervals": 1}, {"intervals": 1}, {"intervals": 1}]}"#,
/// )?;
/// let mesh = BoundaryMesh::least_degree(&domain)?;
/// let mut file = Vec::new();
/// obj::write(&mesh, &SurfaceOptions::default(), &mut file)?;
/// assert!(String::from_utf8(file)?.contains("\no plate\nv 0 0 0\nv 2 0 0\nv 2 1 0\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write(
    mesh: &dyn Mesh,
    options: &SurfaceOptions,
    mut out: impl Write + Send,
) -> io::Result<()> {
    write_sections(&mut out, &sections(mesh, options, None).object)?;
    out.flush()
}

/// An OBJ and its material library, each from front to back.
pub(crate) struct Files<'a> {
    pub(crate) object: Vec<Section<'a>>,
    pub(crate) library: Vec<Section<'a>>,
}

/// The files of a mesh; `library` is the name under which the OBJ finds its material library.
pub(crate) fn sections<'a>(
    mesh: &'a dyn Mesh,
    options: &'a SurfaceOptions,
    library: Option<&str>,
) -> Files<'a> {
    let normal = mesh.normal();
    // Only a mesh in a plane has a box to lay an image over.
    let texture = options.texture_coordinates && normal.is_some();
    let mut names = Names::default();
    let mut object = |name: &str| format!("o {}\n", names.distinct(word(name)));
    let surface = object(mesh_name(mesh));
    let materials = NamedMaterials::of(mesh);
    let library = library.filter(|_| !materials.is_empty());
    let mtllib = library.map_or_else(String::new, |name| format!("mtllib {name}\n"));
    let mut sections = vec![header(mesh, &mtllib, &surface), coordinates(mesh, options)];
    if texture {
        sections.push(texture_coordinates(mesh));
    }
    if options.normals {
        sections.push(normals(mesh, options));
    }
    let groups = mesh.groups();
    if groups.is_empty() {
        sections.push(faces(mesh, 0..mesh.triangle_count(), texture, options.normals));
    }
    let mut index = 0;
    for parts in groups.chunk_by(is_same_object) {
        if parts.len() < groups.len() {
            let unnamed = format!("group {}", index + 1);
            let name = if parts[0].name.is_empty() { &unnamed } else { &parts[0].name };
            sections.push(Section::bytes(object(name)));
        }
        for part in parts {
            if let Some(material) = materials.of_group(index) {
                sections.push(Section::bytes(format!("usemtl {material}\n")));
            }
            sections.push(faces(mesh, part.triangles.clone(), texture, options.normals));
            index += 1;
        }
    }
    if options.boundary_lines {
        let lines = mesh.lines();
        let by_name = ByName::new(lines.iter().map(|line| &line.name));
        for (name, of_name) in by_name.names.iter().zip(by_name.items()) {
            sections.push(Section::bytes(object(name)));
            let ranges = of_name.into_iter().map(|line| lines[line].segments.clone());
            sections.extend(ranges.map(|range| segments(mesh, range)));
        }
    }
    Files { object: sections, library: vec![Section::bytes(materials.library())] }
}

fn faces(mesh: &dyn Mesh, triangles: Range<u32>, texture: bool, normals: bool) -> Section<'_> {
    Section::of(triangles, 80, move |range, buffer| {
        let mut names = CornerNames::new(texture, normals);
        for triangle in corners::triangles(mesh, range) {
            names.push_face(triangle, buffer);
        }
    })
}

fn header<'a>(mesh: &dyn Mesh, mtllib: &str, surface: &str) -> Section<'a> {
    let triangles = if mesh.triangle_count() == 1 { "triangle" } else { "triangles" };
    Section::bytes(format!(
        "# {}\n# {} vertices, {} {triangles}, maximum degree {}\n{mtllib}{surface}",
        made_by(mesh),
        mesh.vertex_count(),
        mesh.triangle_count(),
        mesh.max_degree(),
    ))
}

fn coordinates<'a>(mesh: &'a dyn Mesh, options: &'a SurfaceOptions) -> Section<'a> {
    // A thousandth is enough to tell 256 levels apart.
    let thousandths = |level: u8| ((1000 * u32::from(level) + 127) / 255) as f32 / 1000.0;
    Numbers::Text.records(0..mesh.vertex_count(), move |range: Range<u32>| {
        let colors = degree_color::of_vertices(mesh, range.clone(), options.degree_colors);
        let colors = colors.map(move |color| color.map(|color| color.map(thousandths)));
        let points = positions(mesh, range).zip(colors);
        points.map(|(point, color)| ("v", options.plane.place(point).to_array(), color))
    })
}

fn texture_coordinates(mesh: &dyn Mesh) -> Section<'_> {
    let bounds = mesh.bounds();
    Numbers::Text.records(0..mesh.vertex_count(), move |range| {
        let points = positions(mesh, range);
        points.map(move |point| ("vt", in_box(bounds, point).as_vec2().to_array()))
    })
}

/// A unit normal for each vertex.
fn normals<'a>(mesh: &'a dyn Mesh, options: &SurfaceOptions) -> Section<'a> {
    let plane = options.plane;
    if let Some(normal) = mesh.normal() {
        let [x, y, z] = plane.place(normal).to_array();
        return Section::repeated(mesh.vertex_count(), format!("vn {x} {y} {z}\n").as_bytes());
    }
    let normals = Arc::new(vertex_normals(mesh));
    Numbers::Text.records(0..mesh.vertex_count(), move |range: Range<u32>| {
        let normals = Arc::clone(&normals);
        // Adding zero turns -0 into 0.
        let normal = move |vertex| plane.place(normals[vertex as usize]).as_vec3() + Vec3::ZERO;
        range.map(move |vertex| ("vn", normal(vertex).to_array()))
    })
}

fn segments(mesh: &dyn Mesh, segments: Range<u32>) -> Section<'_> {
    Numbers::Text.records(segments, |range| {
        let segments = corners::segments(mesh, range).into_iter();
        segments.map(|ends| ("l", ends.map(|vertex| vertex + 1)))
    })
}
