//! Reading glTF 2.0, binary or JSON.

use super::accessor::Arrays;
use super::container::{self, Container};
use super::placement::placed_nodes;
use super::primitive::{Lines, Mode, Part};
use super::schema::{self, Document, Mesh, Node, Primitive, Real, named};
use crate::ReadError;
use glam::{DMat4, DVec3};
use mindeg_mesh::{Group, Line, Material, NonTriangles, TriMesh, TriMeshError};
use std::collections::HashMap;
use std::io::{self, Read};
use std::ops::Range;
use std::sync::Arc;

/// Reads the surface of a `.glb` or a `.gltf`; which of the two, the first bytes tell.
///
/// Every node of the scene that has triangles becomes a group, moved to where the node puts it; a
/// mesh used by several nodes is there several times. Primitives of one node with different materials
/// are groups of one name. Of a material the name and the base color are read; one without a name is
/// passed over. Transforms are computed in 64 bits; positions
/// in the file have 32 or fewer (`KHR_mesh_quantization`). Primitives that have the same positions
/// in the same place share their vertices. Lists, strips and fans of triangles are read, with
/// indices of any width or none, also from sparse accessors. Lines between vertices of triangles are
/// kept under the name of their node; other lines, and points, are counted.
///
/// `resolve` gives the files that the document names, with their escapes undone:
/// relative to the document, and to be trusted no more than the document is. Data in the
/// document itself is not asked for, and URIs with a scheme such as `http:` are refused.
///
/// O(n) time; memory for the file and the mesh, which has no more vertices, triangles and lines than 100
/// for each byte of the file and its buffers.
///
/// Limits: triangles compressed by Draco or meshopt are refused by name, as is any extension that
/// a file requires unless it is known not to touch triangles. Skins and morph targets are left at
/// rest; a node with instances is there once.
///
/// # Errors
///
/// Errors of the input and of `resolve`, a malformed document or binary, an unsupported feature (see Limits),
/// too little memory, positions that are not finite, and a file without
/// triangles.
///
/// # Example
///
/// ```
/// use mindeg::{BoundaryMesh, Domain};
/// use mindeg_formats::{SurfaceOptions, glb};
///
/// let domain = Domain::from_json(
///     r#"{"rectangle": {"width": 2, "height": 1},
///         "sides": [{"intervals": 3}, {"intervals": 1}, {"intervals": 2}, {"intervals": 1}]}"#,
/// )?;
/// let mesh = BoundaryMesh::least_degree(&domain)?;
/// let mut file = Vec::new();
/// glb::write(&mesh, &SurfaceOptions::default(), &mut file)?;
///
/// // A .glb of this kind needs no other file.
/// let no_files = |_: &str| Err(std::io::ErrorKind::Unsupported.into());
/// let read = glb::read(file.as_slice(), no_files)?;
/// assert!(read.triangles().iter().copied().eq(mesh.triangles()));
/// assert!(read.boundary_loops()[0].vertices.iter().copied().eq(0..7));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read(
    mut input: impl Read,
    resolve: impl FnMut(&str) -> io::Result<Vec<u8>>,
) -> Result<TriMesh, ReadError> {
    let mut file = Vec::new();
    input.read_to_end(&mut file)?;
    let Container { json, binary } = Container::split(&file)?;
    let document = Document::parse(json)?;
    let buffers = container::buffers(&document, binary, resolve)?;
    let nodes = placed_nodes(&document)?;
    let bytes = file.len() + buffers.iter().flatten().map(|buffer| buffer.len()).sum::<usize>();
    let mut surface = Surface::new(Arrays { document: &document, buffers: &buffers }, bytes);
    for &(index, to_scene) in &nodes {
        surface.add_triangles_of(index, to_scene)?;
    }
    for &(index, to_scene) in &nodes {
        surface.add_lines_of(index, to_scene)?;
    }
    let mesh = TriMesh::new(surface.positions, surface.triangles)?
        .with_groups(surface.groups)
        .with_lines(surface.lines, surface.segments)?
        .with_non_triangles(surface.non_triangles)
        .with_notes(surface.notes.list())
        .with_dropped(surface.notes.dropped);
    // A transform that overflows f64 gives no finite position.
    Ok(mesh.with_rounding(surface.rounding.min(f64::MAX)))
}

/// The features of nodes that are not read.
#[derive(Default)]
struct Notes {
    skins: usize,
    morphs: usize,
    instances: usize,
    /// The kinds of values at vertices that are not read.
    dropped: Vec<&'static str>,
}

impl Notes {
    fn list(&self) -> Vec<String> {
        let kinds = [
            (self.skins, "skins are not read; meshes that have one are at rest"),
            (self.morphs, "morph targets are not read; meshes that have some are at rest"),
            (
                self.instances,
                "instances (EXT_mesh_gpu_instancing) are not read; each mesh is there once",
            ),
        ];
        let found = kinds.into_iter().filter(|(count, _)| *count > 0);
        found.map(|(count, what)| format!("{what}; nodes concerned: {count}")).collect()
    }
}

/// Positions in a place: an accessor, and the bits of what moves it there.
type PlacedPositions = (usize, [u64; 16]);

/// How many vertices, triangles and lines a file may have for each of its bytes. A file that stores each of
/// them has 10 bytes and more; but an accessor without bytes has any length it declares, and a mesh has as many
/// copies as nodes.
const MOST_PER_BYTE: u64 = 100;

/// A mesh as it is put together, node by node.
struct Surface<'a> {
    arrays: Arrays<'a>,
    /// How many vertices, triangles and lines there may still be.
    room: u64,
    positions: Vec<DVec3>,
    /// The vertices that positions have become.
    vertices: HashMap<PlacedPositions, Range<usize>>,
    triangles: Vec<[u32; 3]>,
    groups: Vec<Group>,
    segments: Vec<[u32; 2]>,
    lines: Vec<Line>,
    non_triangles: NonTriangles,
    notes: Notes,
    rounding: f64,
    /// The materials of the document that have a name.
    materials: Vec<Option<Arc<Material>>>,
}

impl<'a> Surface<'a> {
    /// An empty surface of a file of this length.
    fn new(arrays: Arrays<'a>, bytes: usize) -> Self {
        Self {
            arrays,
            room: MOST_PER_BYTE.saturating_mul(bytes as u64),
            positions: Vec::new(),
            vertices: HashMap::new(),
            triangles: Vec::new(),
            groups: Vec::new(),
            segments: Vec::new(),
            lines: Vec::new(),
            non_triangles: NonTriangles::default(),
            notes: Notes::default(),
            rounding: 0.0,
            materials: arrays.document.materials.iter().map(material).collect(),
        }
    }

    /// Rejects an accessor without a buffer view whose declared length does not fit in memory. One with bytes
    /// is not longer than they are.
    fn check_zeros(&mut self, accessor: usize) -> Result<(), ReadError> {
        let source = &self.arrays.document.accessors[accessor];
        if source.buffer_view.is_some() || source.count.0 <= self.room {
            return Ok(());
        }
        self.take_room(source.count.0, || format!("accessors[{accessor}]"))
    }

    /// Reserves memory for a number of items.
    fn take_room(&mut self, count: u64, place: impl FnOnce() -> String) -> Result<(), ReadError> {
        let Some(room) = self.room.checked_sub(count) else {
            let problem = format!(
                "makes more vertices, triangles and lines than {MOST_PER_BYTE} for each byte of the \
                 file and its buffers; export fewer copies of the mesh"
            );
            return Err(ReadError::place(place(), problem));
        };
        self.room = room;
        Ok(())
    }

    /// A node, and its mesh with its index.
    fn mesh_of(&self, index: usize) -> Result<Option<(&'a Node, usize, &'a Mesh)>, ReadError> {
        let document = self.arrays.document;
        let node = &document.nodes[index];
        let Some(mesh) = node.mesh else { return Ok(None) };
        let (mesh_index, mesh) =
            named(("meshes", &document.meshes), mesh, || format!("nodes[{index}].mesh"))?;
        Ok(Some((node, mesh_index, mesh)))
    }

    fn add_triangles_of(&mut self, index: usize, to_scene: DMat4) -> Result<(), ReadError> {
        let Some((node, mesh_index, mesh)) = self.mesh_of(index)? else { return Ok(()) };
        self.notes.skins += usize::from(node.skin.is_some());
        self.notes.instances += usize::from(node.extensions.instancing.is_some());
        for kind in mesh.primitives.iter().flat_map(|it| it.attributes.dropped()) {
            if !self.notes.dropped.contains(&kind) {
                self.notes.dropped.push(kind);
            }
        }
        let has_targets = |primitive: &Primitive| !primitive.targets.is_empty();
        self.notes.morphs += usize::from(mesh.primitives.iter().any(has_targets));
        let first_triangle = self.triangles.len();
        let mut group = Group::new(name_of(node, mesh), first_triangle as u32..0);
        for part in parts(mesh_index, mesh, self.arrays) {
            let part = part?;
            if let Mode::Triangles(layout) = part.mode {
                let material = match part.material {
                    Some(index) => self.materials[index].clone(),
                    None => None,
                };
                if material != group.material {
                    let next = Group::new(&*group.name, self.triangles.len() as u32..0);
                    self.end_group(std::mem::replace(&mut group, next.of_material(material)));
                }
                let vertices = self.placed(part.positions, to_scene)?;
                self.check_zeros(part.corner_accessor())?;
                part.push_triangles(layout, &vertices, self.arrays, &mut self.triangles)?;
                self.take_room(part.count(self.arrays), || format!("nodes[{index}]"))?;
            }
        }
        if to_scene.determinant() < 0.0 {
            // A mirror turns triangles over, and readers are to turn them back.
            self.triangles[first_triangle..].iter_mut().for_each(|t| t.swap(1, 2));
        }
        self.end_group(group);
        Ok(())
    }

    fn end_group(&mut self, mut group: Group) {
        // A mesh of more triangles is refused.
        group.triangles.end = self.triangles.len() as u32;
        self.groups.push(group);
    }

    /// Counts the lines and points of a node, and keeps the lines whose vertices triangles have.
    fn add_lines_of(&mut self, index: usize, to_scene: DMat4) -> Result<(), ReadError> {
        let Some((node, mesh_index, mesh)) = self.mesh_of(index)? else { return Ok(()) };
        let start = self.segments.len() as u32;
        for part in parts(mesh_index, mesh, self.arrays) {
            let part = part?;
            let count = part.count(self.arrays);
            let lines = match part.mode {
                Mode::Triangles(_) => continue,
                Mode::Points => {
                    self.non_triangles.points += count;
                    continue;
                }
                Mode::Lines(lines) => lines,
            };
            self.non_triangles.line_segments += match lines {
                Lines::List => count / 2,
                Lines::Strip => count.saturating_sub(1),
                Lines::Loop => count,
            };
            let vertices = self.vertices.get(&(part.positions, bits(to_scene))).cloned();
            if let Some(vertices) = vertices {
                self.check_zeros(part.corner_accessor())?;
                part.push_segments(lines, &vertices, self.arrays, &mut self.segments)?;
                self.take_room(count, || format!("nodes[{index}]"))?;
            }
        }
        let Ok(end) = u32::try_from(self.segments.len()) else {
            let problem = "has more lines than can be numbered in 32 bits";
            return Err(ReadError::place(format!("nodes[{index}]"), problem));
        };
        if start < end {
            let name = name_of(node, mesh);
            let name = if name.is_empty() { "line".to_owned() } else { name };
            self.lines.push(Line { name, segments: start..end, is_straight: false });
        }
        Ok(())
    }

    /// The vertices of positions in their place; new ones, if there are none yet.
    fn placed(&mut self, accessor: usize, to_scene: DMat4) -> Result<Range<usize>, ReadError> {
        let placed = (accessor, bits(to_scene));
        if let Some(vertices) = self.vertices.get(&placed) {
            return Ok(vertices.clone());
        }
        self.check_zeros(accessor)?;
        let (mut positions, rounding) = self.arrays.positions(accessor)?;
        self.take_room(positions.len() as u64, || format!("accessors[{accessor}]"))?;
        let axes = [to_scene.x_axis, to_scene.y_axis, to_scene.z_axis];
        let scale = axes.map(|axis| axis.truncate().length()).into_iter().fold(0.0, f64::max);
        self.rounding = self.rounding.max(rounding * scale);
        positions.iter_mut().for_each(|point| *point = to_scene.transform_point3(*point));
        let start = self.positions.len();
        if start == 0 {
            self.positions = positions;
        } else {
            self.positions.try_reserve(positions.len())?;
            self.positions.append(&mut positions);
        }
        let vertices = start..self.positions.len();
        if u32::try_from(vertices.end).is_err() {
            return Err(TriMeshError::too_many("vertices", vertices.end).into());
        }
        self.vertices.insert(placed, vertices.clone());
        Ok(vertices)
    }
}

/// The primitives of a mesh.
fn parts(
    index: usize,
    mesh: &Mesh,
    arrays: Arrays<'_>,
) -> impl Iterator<Item = Result<Part, ReadError>> {
    mesh.primitives.iter().enumerate().map(move |(number, primitive)| {
        Part::new(primitive, format!("meshes[{index}].primitives[{number}]"), arrays)
    })
}

/// A material, if it has a name.
fn material(given: &schema::Material) -> Option<Arc<Material>> {
    let name = given.name.clone().filter(|name| !name.trim().is_empty())?;
    let channel = |Real(value): Real| value.clamp(0.0, 1.0) as f32;
    let color = given.pbr_metallic_roughness.base_color_factor.map(|color| color.map(channel));
    // The format's default is white.
    Some(Arc::new(Material { name, color: color.or(Some([1.0; 4])) }))
}

fn name_of(node: &Node, mesh: &Mesh) -> String {
    node.name.as_ref().or(mesh.name.as_ref()).cloned().unwrap_or_default()
}

fn bits(matrix: DMat4) -> [u64; 16] {
    matrix.to_cols_array().map(f64::to_bits)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three points of 32-bit floats, up to 4 from the origin, with this node and this primitive.
    fn mesh(node: &str, primitive: &str) -> TriMesh {
        let document = format!(
            r#"{{"asset": {{"version": "2.0"}}, "nodes": [{{"mesh": 0{node}}}],
                "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}{primitive}}}]}}],
                "accessors": [{{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}}],
                "bufferViews": [{{"buffer": 0, "byteLength": 36}}],
                "buffers": [{{"byteLength": 36, "uri": "points"}}]}}"#
        );
        let points = [0.0, 0.0, 0.0, -4.0, 0.0, 0.0, 0.0, 1.0, 0.0_f32];
        let bytes: Vec<u8> = points.into_iter().flat_map(f32::to_le_bytes).collect();
        let resolve = |_: &str| Ok(bytes.clone());
        read(document.as_bytes(), resolve).unwrap()
    }

    #[test]
    fn what_is_not_read_is_told() {
        for (node, primitive, note) in [
            ("", "", None),
            (r#", "skin": 0"#, "", Some("skins are not read; meshes that have one are at rest")),
            (
                "",
                r#", "targets": [{"POSITION": 0}]"#,
                Some("morph targets are not read; meshes that have some are at rest"),
            ),
            (
                r#", "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {}}}"#,
                "",
                Some("instances (EXT_mesh_gpu_instancing) are not read; each mesh is there once"),
            ),
        ] {
            let expected: Vec<_> =
                note.into_iter().map(|note| format!("{note}; nodes concerned: 1")).collect();
            assert_eq!(mesh(node, primitive).notes(), expected);
        }
    }

    #[test]
    fn rounding_grows_with_the_scale_of_the_node() {
        let unit = 1.0 / f64::from(1 << 22);
        assert_eq!(mesh("", "").rounding(), unit);
        let node = r#", "scale": [1, 3, 1], "translation": [1e9, 0, 0]"#;
        assert_eq!(mesh(node, "").rounding(), 3.0 * unit);
    }
}
