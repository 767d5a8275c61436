//! The JSON half of a glTF: what the bytes of the binary mean.

use super::positions::{Extent, Positions};
use crate::Domain;
use crate::export::{GENERATOR, SurfaceOptions, mesh_name, side_name};
use glam::Vec3;
use gltf_json::accessor::{ComponentType, GenericComponentType, Type};
use gltf_json::buffer::{Target, View};
use gltf_json::material::{PbrBaseColorFactor, PbrMetallicRoughness, StrengthFactor};
use gltf_json::mesh::{Mode, Primitive, Semantic};
use gltf_json::validation::Checked::{self, Valid};
use gltf_json::validation::USize64;
use gltf_json::{Accessor, Asset, Buffer, Index, Material, Node, Root, Scene, Value};
use mindeg_core::Boundary;
use std::collections::BTreeMap;

/// Surface and line colors in linear light: a pale steel that shades well, and near black.
const SURFACE: [f32; 4] = [0.6, 0.68, 0.8, 1.0];
const LINE: [f32; 4] = [0.02, 0.02, 0.02, 1.0];
const WHITE: [f32; 4] = [1.0; 4];

/// Whether indices take 32 bits: the largest 16-bit number restarts primitives, and so may
/// not be an index.
pub(super) fn has_wide_indices(boundary: &Boundary) -> bool {
    boundary.vertex_count() > u32::from(u16::MAX)
}

/// The bytes a vertex takes in each of the arrays that go before the indices: position,
/// normal, texture coordinates, color. All are multiples of four, so that arrays laid one
/// after the other are aligned.
pub(super) fn vertex_sizes(options: &SurfaceOptions) -> [u64; 4] {
    let size = |wanted, size| if wanted { size } else { 0 };
    [
        12,
        size(options.normals, 12),
        size(options.texture_coordinates, 8),
        size(options.degree_colors, 4),
    ]
}

/// The length of the binary in bytes, without building it.
pub(super) fn binary_len(boundary: &Boundary, options: &SurfaceOptions) -> u64 {
    let vertices = u64::from(boundary.vertex_count());
    let segments = if options.boundary_lines { vertices } else { 0 };
    let indices = 3 * (vertices - 2) + 2 * segments;
    let index_size = if has_wide_indices(boundary) { 4 } else { 2 };
    vertices * vertex_sizes(options).iter().sum::<u64>() + indices * index_size
}

/// The document for the meshes of a domain whose binary is at `uri`, or in the same file.
pub(super) fn document(
    domain: &Domain,
    options: &SurfaceOptions,
    positions: &Positions,
    extent: Extent,
    uri: Option<String>,
) -> Root {
    let mut document = Document::default();
    let attributes = document.vertex_arrays(domain, options, extent);
    let indices = document.index_view(domain, options);

    let triangles = 3 * (u64::from(domain.boundary().vertex_count()) - 2);
    let accessor = document.indices(domain, indices, 0, triangles);
    let material = document.material(if options.degree_colors { WHITE } else { SURFACE });
    let primitive = primitive(Mode::Triangles, attributes.clone(), accessor, material);
    let mut surface = document.node(mesh_name(domain), primitive);
    surface.translation = positions.translation();
    if options.boundary_lines {
        let sides = document.sides(domain, attributes, indices, triangles);
        surface.children = Some(sides);
    }
    document.finish(surface, uri)
}

type Attributes = BTreeMap<Checked<Semantic>, Index<Accessor>>;

/// A document under construction.
#[derive(Default)]
struct Document {
    root: Root,
    /// The bytes of the binary that have a meaning so far.
    binary_len: u64,
}

impl Document {
    /// An array that follows what is in the binary so far.
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

    /// The arrays with an entry for every vertex, in the order of [`vertex_sizes`].
    fn vertex_arrays(
        &mut self,
        domain: &Domain,
        options: &SurfaceOptions,
        extent: Extent,
    ) -> Attributes {
        let kinds = [
            (Semantic::Positions, Type::Vec3, ComponentType::F32),
            (Semantic::Normals, Type::Vec3, ComponentType::F32),
            (Semantic::TexCoords(0), Type::Vec2, ComponentType::F32),
            (Semantic::Colors(0), Type::Vec4, ComponentType::U8),
        ];
        let count = u64::from(domain.boundary().vertex_count());
        let mut attributes = Attributes::new();
        for ((semantic, type_, component), size) in kinds.into_iter().zip(vertex_sizes(options)) {
            if size > 0 {
                let view = self.view(size * count, Target::ArrayBuffer);
                let accessor = self.accessor(view, (0, count), (type_, component));
                attributes.insert(Valid(semantic), accessor);
            }
        }
        // Positions are the first array there is.
        if let Some(positions) = self.root.accessors.first_mut() {
            positions.min = Some(numbers(extent.min));
            positions.max = Some(numbers(extent.max));
        }
        attributes
    }

    /// The array of all indices.
    fn index_view(&mut self, domain: &Domain, options: &SurfaceOptions) -> Index<View> {
        let len = binary_len(domain.boundary(), options) - self.binary_len;
        self.view(len, Target::ElementArrayBuffer)
    }

    fn indices(
        &mut self,
        domain: &Domain,
        view: Index<View>,
        first: u64,
        count: u64,
    ) -> Index<Accessor> {
        let component = if has_wide_indices(domain.boundary()) {
            ComponentType::U32
        } else {
            ComponentType::U16
        };
        let offset = first * component.size() as u64;
        self.accessor(view, (offset, count), (Type::Scalar, component))
    }

    /// A node for each side, with the boundary segments whose indices start at `first`.
    fn sides(
        &mut self,
        domain: &Domain,
        mut attributes: Attributes,
        indices: Index<View>,
        mut first: u64,
    ) -> Vec<Index<Node>> {
        attributes.retain(|semantic, _| *semantic == Valid(Semantic::Positions));
        let material = self.material(LINE);
        let mut nodes = Vec::new();
        for (side, intervals) in domain.boundary().sides().enumerate() {
            let count = 2 * u64::from(intervals);
            let accessor = self.indices(domain, indices, first, count);
            let primitive = primitive(Mode::Lines, attributes.clone(), accessor, material);
            let node = self.node(&side_name(domain, side), primitive);
            nodes.push(self.root.push(node));
            first += count;
        }
        nodes
    }

    fn material(&mut self, color: [f32; 4]) -> Index<Material> {
        self.root.push(Material {
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

    fn node(&mut self, name: &str, primitive: Primitive) -> Node {
        let mesh = self.root.push(gltf_json::Mesh {
            name: Some(name.to_owned()),
            primitives: vec![primitive],
            weights: None,
            extensions: None,
            extras: None,
        });
        Node { name: Some(name.to_owned()), mesh: Some(mesh), ..Default::default() }
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
        self.root.asset = Asset { generator: Some(GENERATOR.to_owned()), ..Default::default() };
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
