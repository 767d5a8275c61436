//! The JSON half of a glTF: what the bytes of the binary mean.

use super::positions::Stored;
use crate::materials::{Materials, is_same_object};
use crate::names::Names;
use crate::{SurfaceOptions, made_by, mesh_name};
use glam::{DVec3, Vec3};
use gltf_json::accessor::{ComponentType, GenericComponentType, Type};
use gltf_json::buffer::{Target, View};
use gltf_json::material::{AlphaMode, PbrBaseColorFactor, PbrMetallicRoughness, StrengthFactor};
use gltf_json::mesh::{Mode, Primitive, Semantic};
use gltf_json::validation::Checked::{self, Valid};
use gltf_json::validation::USize64;
use gltf_json::{Accessor, Buffer, Index, Material, Node, Root, Scene, Value};
use mindeg_mesh::{Bounds, ByName, Group, Mesh};
use std::collections::BTreeMap;

/// Surface and line colors in linear light: a pale steel that shades well, and near black.
const SURFACE: [f32; 4] = [0.6, 0.68, 0.8, 1.0];
const LINE: [f32; 4] = [0.02, 0.02, 0.02, 1.0];
const WHITE: [f32; 4] = [1.0; 4];

/// Which arrays the binary has, and how long they are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Layout {
    pub(super) vertices: u32,
    pub(super) triangles: u32,
    /// 0 unless lines are wanted.
    pub(super) segments: u32,
    pub(super) normals: bool,
    pub(super) texture_coordinates: bool,
    pub(super) degree_colors: bool,
}

impl Layout {
    pub(super) fn new(mesh: &dyn Mesh, options: &SurfaceOptions) -> Self {
        let layout = Self::in_plane(mesh.vertex_count(), mesh.triangle_count(), options);
        let segments = mesh.lines().last().map_or(0, |line| line.segments.end);
        Self {
            segments: if options.boundary_lines { segments } else { 0 },
            texture_coordinates: layout.texture_coordinates && mesh.normal().is_some(),
            ..layout
        }
    }

    /// The layout of a mesh in the plane, without lines.
    pub(super) fn in_plane(vertices: u32, triangles: u32, options: &SurfaceOptions) -> Self {
        let SurfaceOptions { normals, texture_coordinates, degree_colors, .. } = *options;
        Self { vertices, triangles, segments: 0, normals, texture_coordinates, degree_colors }
    }

    /// Whether indices take 32 bits: the largest 16-bit number restarts primitives, and so may
    /// not be an index.
    pub(super) fn has_wide_indices(&self) -> bool {
        self.vertices > u32::from(u16::MAX)
    }

    /// The bytes a vertex takes in each of the arrays that go before the indices: position,
    /// normal, texture coordinates, color. All are multiples of four, so that arrays laid one
    /// after the other are aligned.
    fn vertex_sizes(&self) -> [u64; 4] {
        let size = |wanted, size| if wanted { size } else { 0 };
        let Self { normals, texture_coordinates, degree_colors, .. } = *self;
        [12, size(normals, 12), size(texture_coordinates, 8), size(degree_colors, 4)]
    }

    /// The length of the binary in bytes, without building it.
    pub(super) fn binary_len(&self) -> u64 {
        let indices = 3 * u64::from(self.triangles) + 2 * u64::from(self.segments);
        let index_size = if self.has_wide_indices() { 4 } else { 2 };
        u64::from(self.vertices) * self.vertex_sizes().iter().sum::<u64>() + indices * index_size
    }
}

/// The document of a mesh whose binary is at `uri`, or in the same file.
pub(super) fn document(
    mesh: &dyn Mesh,
    layout: &Layout,
    stored: &Stored,
    uri: Option<String>,
) -> Root {
    let (root, names) = (Root::default(), Names::default());
    let mut document = Document { layout: *layout, root, binary_len: 0, names };
    let name = document.names.distinct(mesh_name(mesh).to_owned());
    let attributes = document.vertex_arrays(stored.range);
    let indices = document.index_view();
    let material_of_group = document.materials(mesh);

    let whole = [Group::new("", 0..layout.triangles)];
    let groups = if mesh.groups().is_empty() { &whole } else { mesh.groups() };
    let mut children = Vec::new();
    let mut surface = Node { name: Some(name.clone()), ..Default::default() };
    let mut index = 0;
    for parts in groups.chunk_by(is_same_object) {
        let unnamed = format!("group {}", index + 1);
        let mut primitives = Vec::new();
        for part in parts {
            let count = 3 * part.triangles.len() as u64;
            let accessor = document.indices(indices, 3 * u64::from(part.triangles.start), count);
            let material = material_of_group[index];
            primitives.push(primitive(Mode::Triangles, attributes.clone(), accessor, material));
            index += 1;
        }
        if parts.len() == groups.len() {
            surface = document.node(name.clone(), primitives);
        } else {
            let name = if parts[0].name.is_empty() { &unnamed } else { &parts[0].name };
            let name = document.names.distinct(name.clone());
            let node = document.node(name, primitives);
            children.push(document.root.push(node));
        }
    }
    surface.translation = stored.translation();
    if layout.segments > 0 {
        children.extend(document.lines(mesh, attributes, indices));
    }
    surface.children = (!children.is_empty()).then_some(children);
    document.root.asset.generator = Some(made_by(mesh).to_owned());
    document.finish(surface, uri)
}

type Attributes = BTreeMap<Checked<Semantic>, Index<Accessor>>;

/// A document under construction.
struct Document {
    layout: Layout,
    root: Root,
    /// The bytes of the binary that have a meaning so far.
    binary_len: u64,
    names: Names,
}

impl Document {
    /// An array at the present end of the binary.
    fn view(&mut self, len: u64, target: Target) -> Index<View> {
        let byte_offset = Some(USize64(self.binary_len));
        self.binary_len += len;
        self.root.push(View {
            buffer: Index::new(0),
            byte_length: USize64(len),
            byte_offset,
            byte_stride: None,
            name: None,
            target: Some(Valid(target)),
            extensions: None,
            extras: None,
        })
    }

    fn accessor(
        &mut self,
        view: Index<View>,
        (offset, count): (u64, u64),
        (type_, component): (Type, ComponentType),
    ) -> Index<Accessor> {
        self.root.push(Accessor {
            buffer_view: Some(view),
            byte_offset: Some(USize64(offset)),
            count: USize64(count),
            component_type: Valid(GenericComponentType(component)),
            type_: Valid(type_),
            // Colors are the one array of bytes, and they stand for fractions.
            normalized: component == ComponentType::U8,
            min: None,
            max: None,
            name: None,
            sparse: None,
            extensions: None,
            extras: None,
        })
    }

    /// The arrays with an entry for every vertex, in the order of [`Layout::vertex_sizes`].
    fn vertex_arrays(&mut self, range: Bounds<DVec3>) -> Attributes {
        let kinds = [
            (Semantic::Positions, Type::Vec3, ComponentType::F32),
            (Semantic::Normals, Type::Vec3, ComponentType::F32),
            (Semantic::TexCoords(0), Type::Vec2, ComponentType::F32),
            (Semantic::Colors(0), Type::Vec4, ComponentType::U8),
        ];
        let count = u64::from(self.layout.vertices);
        let mut attributes = Attributes::new();
        for ((semantic, type_, component), size) in
            kinds.into_iter().zip(self.layout.vertex_sizes())
        {
            if size > 0 {
                let view = self.view(size * count, Target::ArrayBuffer);
                let accessor = self.accessor(view, (0, count), (type_, component));
                attributes.insert(Valid(semantic), accessor);
            }
        }
        // Positions are the first array there is.
        if let Some(positions) = self.root.accessors.first_mut() {
            positions.min = Some(numbers(range.min.as_vec3()));
            positions.max = Some(numbers(range.max.as_vec3()));
        }
        attributes
    }

    /// The array of all indices.
    fn index_view(&mut self) -> Index<View> {
        let len = self.layout.binary_len() - self.binary_len;
        self.view(len, Target::ElementArrayBuffer)
    }

    fn indices(&mut self, view: Index<View>, first: u64, count: u64) -> Index<Accessor> {
        let wide = self.layout.has_wide_indices();
        let component = if wide { ComponentType::U32 } else { ComponentType::U16 };
        let offset = first * component.size() as u64;
        self.accessor(view, (offset, count), (Type::Scalar, component))
    }

    /// A node for each name of lines. Segments follow the triangles.
    fn lines(
        &mut self,
        mesh: &dyn Mesh,
        mut attributes: Attributes,
        indices: Index<View>,
    ) -> Vec<Index<Node>> {
        attributes.retain(|semantic, _| *semantic == Valid(Semantic::Positions));
        let material = self.material(None, LINE);
        let after_triangles = 3 * u64::from(self.layout.triangles);
        let mut nodes = Vec::new();
        let lines = mesh.lines();
        let by_name = ByName::new(lines.iter().map(|line| &line.name));
        for (name, of_name) in by_name.names.iter().zip(by_name.items()) {
            let mut primitives = Vec::new();
            for line in of_name {
                let segments = lines[line].segments.clone();
                let first = after_triangles + 2 * u64::from(segments.start);
                let accessor = self.indices(indices, first, 2 * segments.len() as u64);
                primitives.push(primitive(Mode::Lines, attributes.clone(), accessor, material));
            }
            let name = self.names.distinct(name.clone());
            let node = self.node(name, primitives);
            nodes.push(self.root.push(node));
        }
        nodes
    }

    /// The material of each group; of the whole mesh, if it has none.
    fn materials(&mut self, mesh: &dyn Mesh) -> Vec<Index<Material>> {
        let plain = if self.layout.degree_colors { WHITE } else { SURFACE };
        let mut materials = Materials::of(mesh);
        if materials.of_group.is_empty() {
            materials.of_group.push(None);
        }
        let has_plain = materials.of_group.contains(&None);
        let plain_material = has_plain.then(|| self.material(None, plain));
        let named = materials.list.iter().map(|material| {
            // The colors of vertices are multiplied by that of the material.
            let color = material.color.filter(|_| !self.layout.degree_colors);
            self.material(Some(&material.name), color.unwrap_or(plain))
        });
        let named: Vec<_> = named.collect();
        let of_group = |index: &Option<usize>| match index {
            Some(index) => named[*index],
            None => plain_material.unwrap_or(Index::new(0)),
        };
        materials.of_group.iter().map(of_group).collect()
    }

    fn material(&mut self, name: Option<&str>, color: [f32; 4]) -> Index<Material> {
        let is_opaque = color[3] >= 1.0;
        self.root.push(Material {
            name: name.map(str::to_owned),
            alpha_mode: Valid(if is_opaque { AlphaMode::Opaque } else { AlphaMode::Blend }),
            double_sided: true,
            pbr_metallic_roughness: PbrMetallicRoughness {
                base_color_factor: PbrBaseColorFactor(color),
                metallic_factor: StrengthFactor(0.0),
                roughness_factor: StrengthFactor(1.0),
                ..Default::default()
            },
            ..Default::default()
        })
    }

    fn node(&mut self, name: String, primitives: Vec<Primitive>) -> Node {
        let mesh = self.root.push(gltf_json::Mesh {
            name: Some(name.clone()),
            primitives,
            weights: None,
            extensions: None,
            extras: None,
        });
        Node { name: Some(name), mesh: Some(mesh), ..Default::default() }
    }

    fn finish(mut self, node: Node, uri: Option<String>) -> Root {
        let node = self.root.push(node);
        let scene = Scene { nodes: vec![node], name: None, extensions: None, extras: None };
        self.root.scene = Some(self.root.push(scene));
        self.root.push(Buffer {
            byte_length: USize64(self.binary_len),
            uri,
            name: None,
            extensions: None,
            extras: None,
        });
        self.root
    }
}

fn primitive(
    mode: Mode,
    attributes: Attributes,
    indices: Index<Accessor>,
    material: Index<Material>,
) -> Primitive {
    Primitive {
        attributes,
        indices: Some(indices),
        material: Some(material),
        mode: Valid(mode),
        targets: None,
        extensions: None,
        extras: None,
    }
}

/// The three numbers as JSON: whole ones without a fraction, and the rest as the exact value
/// of the 32-bit float.
fn numbers(vector: Vec3) -> Value {
    let number = |value: f32| {
        let whole = value as i64;
        if whole as f32 == value { Value::from(whole) } else { Value::from(value) }
    };
    vector.to_array().map(number).to_vec().into()
}
