//! glTF 2.0, binary or JSON, read with the gltf crate.
//!
//! Every node of the scene that has a mesh becomes a group, moved to where the node puts it;
//! a mesh used by several nodes is there several times. Primitives of one node that share
//! their positions share their vertices. Lists, strips and fans of triangles are read, with
//! indices of any width or none; lines and points are counted and left out.
//!
//! Before the gltf crate looks at an accessor, its type and its bounds are checked here, since
//! the crate takes both for granted.
//!
//! Limits: compressed and quantized geometry (Draco, meshopt, `KHR_mesh_quantization`) is
//! refused by name, as is any extension a file requires unless it is known not to touch geometry.
//! Skins and morph targets are left at rest. A sparse accessor needs a buffer view to start from.

use super::accessor::{self, Buffers};
use crate::ReadError;
use base64::Engine;
use glam::{DMat4, DQuat, DVec3};
use gltf::mesh::Mode;
use gltf::scene::Transform;
use gltf::{Document, Node, Semantic};
use mindeg_mesh::{Group, NonTriangles, TriMesh};
use std::borrow::Cow;
use std::io::{self, Read};
use std::ops::Range;

/// Reads the surface of a `.glb` or a `.gltf`; which of the two, the first bytes tell.
///
/// `resolve` is asked for the files that the document names, with their escapes undone:
/// relative to the document, and to be trusted no more than the document is. Data in the
/// document itself is not asked for. O(n) time; memory for the file and the mesh.
///
/// # Errors
///
/// Those of the input and of `resolve`, a document or binary that is not as the format has
/// it, what the module's limits name, positions that are not finite, and a file without
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
    mut resolve: impl FnMut(&str) -> io::Result<Vec<u8>>,
) -> Result<TriMesh, ReadError> {
    let mut file = Vec::new();
    input.read_to_end(&mut file)?;
    let Container { json, binary } = split(&file)?;
    let document = document(&json)?;
    let mut buffers = Vec::new();
    for buffer in document.buffers() {
        let bytes = match buffer.source() {
            gltf::buffer::Source::Bin => binary.clone(),
            gltf::buffer::Source::Uri(uri) => Some(Cow::Owned(load(uri, &mut resolve)?)),
        };
        let (length, index) = (buffer.length(), buffer.index());
        let found = bytes.as_ref().map_or(0, |bytes| bytes.len());
        if found < length {
            let problem = format!("is {length} bytes long, of which {found} are there");
            return Err(place(format!("buffers[{index}]"), problem));
        }
        buffers.push(bytes.unwrap_or_default());
    }
    let mut surface = Surface {
        buffers: &buffers,
        positions: Vec::new(),
        rounding: 0.0,
        triangles: Vec::new(),
        groups: Vec::new(),
        non_triangles: NonTriangles::default(),
    };
    for (node, to_scene) in placed_nodes(&document)? {
        surface.add_node(&node, to_scene)?;
    }
    let mesh = TriMesh::new(surface.positions, surface.triangles)?;
    let mesh = mesh.with_groups(surface.groups).with_non_triangles(surface.non_triangles);
    // One that is beyond f64 is none of a finite position.
    Ok(mesh.with_rounding(surface.rounding.min(f64::MAX)))
}

pub(super) fn place(place: impl Into<String>, problem: impl Into<String>) -> ReadError {
    ReadError::Place { place: place.into(), problem: problem.into() }
}

/// The bytes of a document, and of the binary in the same file.
struct Container<'a> {
    json: Cow<'a, [u8]>,
    binary: Option<Cow<'a, [u8]>>,
}

fn split(file: &[u8]) -> Result<Container<'_>, ReadError> {
    if !file.starts_with(b"glTF") {
        return Ok(Container { json: file.into(), binary: None });
    }
    let header_problem = || place("the .glb header", "the file ends before its header does");
    let length = file.get(8..12).ok_or_else(header_problem)?;
    // The gltf crate subtracts the header from the length without looking.
    if u32::from_le_bytes([length[0], length[1], length[2], length[3]]) < 12 {
        return Err(place("the .glb header", "the file claims to be shorter than its header"));
    }
    let glb = gltf::Glb::from_slice(file)
        .map_err(|error| place("the .glb container", error.to_string()))?;
    Ok(Container { json: glb.json, binary: glb.bin })
}

/// The document, in which every index is in range.
fn document(json: &[u8]) -> Result<Document, ReadError> {
    /// Extensions that say nothing about where triangles are.
    const HARMLESS: [&str; 6] = [
        "KHR_materials_",
        "KHR_texture_",
        "KHR_lights_",
        "EXT_texture_",
        "MSFT_texture_",
        "KHR_xmp",
    ];
    let mut root = gltf::json::Root::from_slice(json)
        .map_err(|error| place("the JSON document", error.to_string()))?;
    root.extensions_required.retain(|name| !HARMLESS.iter().any(|known| name.starts_with(known)));
    // The crate's own validation looks this one up before it has validated it.
    for (m, mesh) in root.meshes.iter().enumerate() {
        for (p, primitive) in mesh.primitives.iter().enumerate() {
            if primitive.attributes.values().any(|index| index.value() >= root.accessors.len()) {
                let place_name = format!("meshes[{m}].primitives[{p}].attributes");
                return Err(place(place_name, "names an accessor that the document does not have"));
            }
        }
    }
    Document::from_json(root).map_err(|error| match error {
        gltf::Error::Validation(errors) => match errors.into_iter().next() {
            Some((path, error)) => place(path.to_string(), error.to_string()),
            None => place("the JSON document", "is not valid"),
        },
        other => place("the JSON document", other.to_string()),
    })
}

/// The bytes behind a URI: in it, or in a file.
fn load(
    uri: &str,
    resolve: &mut impl FnMut(&str) -> io::Result<Vec<u8>>,
) -> Result<Vec<u8>, ReadError> {
    if let Some(data) = uri.strip_prefix("data:") {
        let (_, data) = data
            .split_once(";base64,")
            .ok_or_else(|| place("a data URI", "is not in base64, which is all that is read"))?;
        return base64::engine::general_purpose::STANDARD
            .decode(data)
            .map_err(|error| place("a data URI", error.to_string()));
    }
    let name = percent_encoding::percent_decode_str(uri).decode_utf8_lossy();
    resolve(&name).map_err(|source| ReadError::External { uri: name.into_owned(), source })
}

/// The nodes of the scene with what moves them to it, parents before children.
fn placed_nodes(document: &Document) -> Result<Vec<(Node<'_>, DMat4)>, ReadError> {
    let scene = document.default_scene().or_else(|| document.scenes().next());
    let mut waiting: Vec<(Node, DMat4)> = match scene {
        Some(scene) => scene.nodes().map(|node| (node, DMat4::IDENTITY)).collect(),
        None => {
            let mut is_child = vec![false; document.nodes().len()];
            document.nodes().flat_map(|n| n.children()).for_each(|c| is_child[c.index()] = true);
            let roots = document.nodes().filter(|node| !is_child[node.index()]);
            roots.map(|node| (node, DMat4::IDENTITY)).collect()
        }
    };
    waiting.reverse();
    let mut seen = vec![false; document.nodes().len()];
    let mut placed = Vec::new();
    while let Some((node, parent)) = waiting.pop() {
        if std::mem::replace(&mut seen[node.index()], true) {
            let problem = "is reached twice, and nodes must form trees";
            return Err(place(format!("nodes[{}]", node.index()), problem));
        }
        let to_scene = parent * matrix(&node);
        let children: Vec<_> = node.children().map(|child| (child, to_scene)).collect();
        waiting.extend(children.into_iter().rev());
        placed.push((node, to_scene));
    }
    Ok(placed)
}

/// What moves a node to its parent, computed in `f64` since a translation may be far.
fn matrix(node: &Node) -> DMat4 {
    match node.transform() {
        Transform::Matrix { matrix } => {
            DMat4::from_cols_array_2d(&matrix.map(|column| column.map(f64::from)))
        }
        Transform::Decomposed { translation, rotation, scale } => {
            DMat4::from_scale_rotation_translation(
                DVec3::from_array(scale.map(f64::from)),
                DQuat::from_array(rotation.map(f64::from)).normalize(),
                DVec3::from_array(translation.map(f64::from)),
            )
        }
    }
}

/// A mesh as it is put together, node by node.
struct Surface<'a> {
    buffers: &'a Buffers<'a>,
    positions: Vec<DVec3>,
    /// How far a coordinate may be from the one that was rounded to 32 bits.
    rounding: f64,
    triangles: Vec<[u32; 3]>,
    groups: Vec<Group>,
    non_triangles: NonTriangles,
}

impl Surface<'_> {
    fn add_node(&mut self, node: &Node, to_scene: DMat4) -> Result<(), ReadError> {
        let Some(mesh) = node.mesh() else { return Ok(()) };
        let first_triangle = self.triangles.len();
        // The accessors read for this node, and which vertices they have become.
        let mut read: Vec<(usize, Range<usize>)> = Vec::new();
        for primitive in mesh.primitives() {
            let place_name =
                || format!("meshes[{}].primitives[{}]", mesh.index(), primitive.index());
            let accessor = primitive
                .get(&Semantic::Positions)
                .ok_or_else(|| place(place_name(), "has no positions"))?;
            let count = match primitive.indices() {
                Some(indices) => indices.count(),
                None => accessor.count(),
            };
            if self.skip(primitive.mode(), count as u64) {
                continue;
            }
            let vertices = match read.iter().find(|(index, _)| *index == accessor.index()) {
                Some((_, vertices)) => vertices.clone(),
                None => {
                    let start = self.positions.len();
                    let positions = accessor::positions(&accessor, self.buffers)?;
                    let mut largest = DVec3::ZERO;
                    self.positions.extend(positions.map(|[x, y, z]| {
                        let position = DVec3::new(x.into(), y.into(), z.into());
                        largest = largest.max(position.abs());
                        to_scene.transform_point3(position)
                    }));
                    let axes = [to_scene.x_axis, to_scene.y_axis, to_scene.z_axis];
                    let moved: DVec3 = axes.map(|axis| axis.truncate().abs()).into_iter().sum();
                    let rounding = largest.max_element() * 0.5 * f64::from(f32::EPSILON);
                    self.rounding = self.rounding.max(rounding * moved.max_element());
                    let vertices = start..self.positions.len();
                    read.push((accessor.index(), vertices.clone()));
                    vertices
                }
            };
            let indices = match primitive.indices() {
                Some(indices) => accessor::indices(&indices, self.buffers)?,
                None => (0..).take(count).collect(),
            };
            self.add_triangles(primitive.mode(), &indices, &vertices)
                .map_err(|problem| place(place_name(), problem))?;
        }
        if to_scene.determinant() < 0.0 {
            // A mirror turns triangles over, and readers are to turn them back.
            self.triangles[first_triangle..].iter_mut().for_each(|t| t.swap(1, 2));
        }
        let name = node.name().or(mesh.name()).unwrap_or_default().to_owned();
        // A mesh of more triangles is refused.
        let triangles = first_triangle as u32..self.triangles.len() as u32;
        self.groups.push(Group { name, triangles });
        Ok(())
    }

    /// Counts a primitive of lines or points; whether it was one.
    fn skip(&mut self, mode: Mode, indices: u64) -> bool {
        let skipped = &mut self.non_triangles;
        match mode {
            Mode::Points => skipped.points += indices,
            Mode::Lines => skipped.line_segments += indices / 2,
            Mode::LineStrip => skipped.line_segments += indices.saturating_sub(1),
            Mode::LineLoop => skipped.line_segments += indices,
            Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan => return false,
        }
        true
    }

    fn add_triangles(
        &mut self,
        mode: Mode,
        indices: &[u32],
        vertices: &Range<usize>,
    ) -> Result<(), String> {
        if let Some(index) = indices.iter().find(|&&index| index as usize >= vertices.len()) {
            return Err(format!("has the index {index}, and {} vertices", vertices.len()));
        }
        let first = u32::try_from(vertices.end).map(|_| vertices.start as u32);
        let first = first.map_err(|_| "has too many vertices to be numbered in 32 bits")?;
        let at = |i: usize| first + indices[i];
        let triangles = indices.len().saturating_sub(2);
        match mode {
            Mode::TriangleStrip => {
                // Triangles alternate in orientation; one with a repeated vertex joins strips.
                let strip = (0..triangles).map(|i| [at(i), at(i + 1 + i % 2), at(i + 2 - i % 2)]);
                self.triangles.extend(strip.filter(|[a, b, c]| a != b && b != c && c != a));
            }
            Mode::TriangleFan => {
                self.triangles.extend((0..triangles).map(|i| [at(i + 1), at(i + 2), at(0)]));
            }
            _ if indices.len().is_multiple_of(3) => {
                self.triangles
                    .extend((0..indices.len()).step_by(3).map(|i| [at(i), at(i + 1), at(i + 2)]));
            }
            _ => {
                let count = indices.len();
                return Err(format!(
                    "is a list of triangles with {count} indices, no multiple of 3"
                ));
            }
        }
        Ok(())
    }
}
