//! The parts of a document that place triangles.
//!
//! These are the names and shapes of the glTF 2.0 specification; what triangles do not depend on
//! is passed over. Whole numbers keep 64 bits, and so do the others: a node's translation may be
//! far away. The structures of the gltf crate keep 32 bits of both.

use super::json_words;
use crate::ReadError;
use crate::dropped;
use serde::de::{Error, IgnoredAny, Unexpected, Visitor};
use serde::{Deserialize, Deserializer};
use std::borrow::Cow;
use std::fmt;

/// A whole number that is not negative: an index, an offset, a count or a code.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Whole(pub(super) u64);

impl<'de> Deserialize<'de> for Whole {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct OfWhole;
        impl Visitor<'_> for OfWhole {
            type Value = Whole;

            fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
                out.write_str("a whole number that is not negative")
            }

            fn visit_u64<E>(self, value: u64) -> Result<Whole, E> {
                Ok(Whole(value))
            }

            /// The format allows a fraction of zero.
            fn visit_f64<E: Error>(self, value: f64) -> Result<Whole, E> {
                const END: f64 = (1_u64 << 53) as f64;
                if value.trunc() == value && (0.0..END).contains(&value) {
                    return Ok(Whole(value as u64));
                }
                Err(E::invalid_value(Unexpected::Float(value), &self))
            }
        }
        deserializer.deserialize_any(OfWhole)
    }
}

/// Any number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Real(pub(super) f64);

impl<'de> Deserialize<'de> for Real {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct OfReal;
        impl Visitor<'_> for OfReal {
            type Value = Real;

            fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
                out.write_str("a number")
            }

            fn visit_f64<E>(self, value: f64) -> Result<Real, E> {
                Ok(Real(value))
            }

            fn visit_i64<E>(self, value: i64) -> Result<Real, E> {
                Ok(Real(value as f64))
            }

            fn visit_u64<E>(self, value: u64) -> Result<Real, E> {
                Ok(Real(value as f64))
            }
        }
        deserializer.deserialize_any(OfReal)
    }
}

/// A text; it is copied only if it has escapes.
#[derive(Deserialize)]
pub(super) struct Text<'a>(#[serde(borrow)] pub(super) Cow<'a, str>);

#[derive(Deserialize)]
#[serde(rename_all = "camelCase", expecting = "an object")]
pub(super) struct Document<'a> {
    asset: Asset,
    #[serde(default)]
    extensions_required: Vec<String>,
    #[serde(default)]
    extensions_used: Vec<String>,
    pub(super) scene: Option<Whole>,
    #[serde(default)]
    pub(super) scenes: Vec<Scene>,
    #[serde(default)]
    pub(super) nodes: Vec<Node>,
    #[serde(default)]
    pub(super) meshes: Vec<Mesh>,
    #[serde(default)]
    pub(super) materials: Vec<Material>,
    #[serde(default)]
    pub(super) accessors: Vec<Accessor>,
    #[serde(default)]
    pub(super) buffer_views: Vec<BufferView>,
    #[serde(default, borrow)]
    pub(super) buffers: Vec<Buffer<'a>>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase", expecting = "an object")]
struct Asset {
    version: String,
    min_version: Option<String>,
}

#[derive(Deserialize)]
#[serde(expecting = "an object")]
pub(super) struct Scene {
    #[serde(default)]
    pub(super) nodes: Vec<Whole>,
}

#[derive(Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub(super) struct Node {
    pub(super) name: Option<String>,
    pub(super) children: Vec<Whole>,
    pub(super) mesh: Option<Whole>,
    pub(super) skin: Option<IgnoredAny>,
    pub(super) matrix: Option<[Real; 16]>,
    pub(super) translation: Option<[Real; 3]>,
    pub(super) rotation: Option<[Real; 4]>,
    pub(super) scale: Option<[Real; 3]>,
    pub(super) extensions: Extensions,
}

/// The extensions that change where triangles are, of whatever has them.
#[derive(Default, Deserialize)]
#[serde(expecting = "an object")]
pub(super) struct Extensions {
    #[serde(rename = "EXT_mesh_gpu_instancing")]
    pub(super) instancing: Option<IgnoredAny>,
    #[serde(rename = "KHR_draco_mesh_compression")]
    pub(super) draco: Option<IgnoredAny>,
    #[serde(rename = "EXT_meshopt_compression", alias = "KHR_meshopt_compression")]
    pub(super) meshopt: Option<IgnoredAny>,
}

#[derive(Deserialize)]
#[serde(expecting = "an object")]
pub(super) struct Mesh {
    pub(super) name: Option<String>,
    pub(super) primitives: Vec<Primitive>,
}

#[derive(Deserialize)]
#[serde(expecting = "an object")]
pub(super) struct Primitive {
    pub(super) attributes: Attributes,
    pub(super) indices: Option<Whole>,
    pub(super) mode: Option<Whole>,
    pub(super) material: Option<Whole>,
    #[serde(default)]
    pub(super) targets: Vec<IgnoredAny>,
    #[serde(default)]
    pub(super) extensions: Extensions,
}

#[derive(Deserialize)]
#[serde(expecting = "an object")]
pub(super) struct Attributes {
    #[serde(rename = "POSITION")]
    pub(super) position: Option<Whole>,
    #[serde(rename = "TEXCOORD_0")]
    texture: Option<IgnoredAny>,
    #[serde(rename = "TEXCOORD_1")]
    second_texture: Option<IgnoredAny>,
    #[serde(rename = "NORMAL")]
    normal: Option<IgnoredAny>,
    #[serde(rename = "TANGENT")]
    tangent: Option<IgnoredAny>,
    #[serde(rename = "COLOR_0")]
    color: Option<IgnoredAny>,
    #[serde(rename = "JOINTS_0")]
    joints: Option<IgnoredAny>,
}

impl Attributes {
    /// The kinds of values that are there and not read.
    pub(super) fn dropped(&self) -> Vec<&'static str> {
        dropped::found([
            (dropped::TEXTURE, self.texture.is_some()),
            (dropped::SECOND_TEXTURE, self.second_texture.is_some()),
            (dropped::NORMALS, self.normal.is_some()),
            (dropped::TANGENTS, self.tangent.is_some()),
            (dropped::COLORS, self.color.is_some()),
            (dropped::SKINS, self.joints.is_some()),
        ])
    }
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase", expecting = "an object")]
pub(super) struct Material {
    pub(super) name: Option<String>,
    #[serde(default)]
    pub(super) pbr_metallic_roughness: Surface,
}

#[derive(Default, Deserialize)]
#[serde(rename_all = "camelCase", expecting = "an object")]
pub(super) struct Surface {
    pub(super) base_color_factor: Option<[Real; 4]>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase", expecting = "an object")]
pub(super) struct Accessor {
    pub(super) buffer_view: Option<Whole>,
    #[serde(default)]
    pub(super) byte_offset: Whole,
    pub(super) component_type: Whole,
    #[serde(default)]
    pub(super) normalized: bool,
    pub(super) count: Whole,
    #[serde(rename = "type")]
    pub(super) kind: String,
    pub(super) sparse: Option<Sparse>,
}

#[derive(Deserialize)]
#[serde(expecting = "an object")]
pub(super) struct Sparse {
    pub(super) count: Whole,
    pub(super) indices: SparseIndices,
    pub(super) values: SparseValues,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase", expecting = "an object")]
pub(super) struct SparseIndices {
    pub(super) buffer_view: Whole,
    #[serde(default)]
    pub(super) byte_offset: Whole,
    pub(super) component_type: Whole,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase", expecting = "an object")]
pub(super) struct SparseValues {
    pub(super) buffer_view: Whole,
    #[serde(default)]
    pub(super) byte_offset: Whole,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase", expecting = "an object")]
pub(super) struct BufferView {
    pub(super) buffer: Whole,
    #[serde(default)]
    pub(super) byte_offset: Whole,
    pub(super) byte_length: Whole,
    pub(super) byte_stride: Option<Whole>,
    #[serde(default)]
    pub(super) extensions: Extensions,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase", expecting = "an object")]
pub(super) struct Buffer<'a> {
    pub(super) byte_length: Whole,
    #[serde(borrow)]
    pub(super) uri: Option<Text<'a>>,
}

impl<'a> Document<'a> {
    /// The document that a JSON text holds.
    pub(super) fn parse(json: &'a [u8]) -> Result<Self, ReadError> {
        let json = json.strip_prefix(b"\xef\xbb\xbf").unwrap_or(json);
        // The parser's memory goes to objects and lists: a few hundred bytes for an object.
        // Too little memory for that is an error here, where it would end the process there.
        let count = |byte| json.iter().filter(|&&b| b == byte).count();
        Vec::<u8>::new().try_reserve_exact(512 * count(b'{') + 32 * count(b','))?;
        let mut parser = serde_json::Deserializer::from_slice(json);
        let parsed = serde_path_to_error::deserialize(&mut parser);
        let document: Self = parsed.map_err(|error| {
            let place = match error.path().to_string() {
                path if matches!(&*path, "." | "?") => "the JSON document".to_owned(),
                path => path,
            };
            ReadError::place(place, json_words::problem(error.inner()))
        })?;
        parser
            .end()
            .map_err(|error| ReadError::place("the JSON document", json_words::problem(&error)))?;
        document.check_version()?;
        document.check_extensions()?;
        Ok(document)
    }

    /// Whether this reader knows the version, by the rules of the specification.
    fn check_version(&self) -> Result<(), ReadError> {
        let Asset { version, min_version } = &self.asset;
        let (place, version, known) = match min_version {
            Some(version) => ("asset.minVersion", version, version == "2.0"),
            None => ("asset.version", version, version.starts_with("2.")),
        };
        if known {
            return Ok(());
        }
        Err(ReadError::place(place, format!("is {version:?}; only glTF 2.0 is read")))
    }

    fn check_extensions(&self) -> Result<(), ReadError> {
        /// Extensions that say nothing about where triangles are.
        const HARMLESS: [&str; 6] = [
            "KHR_materials_",
            "KHR_texture_",
            "KHR_lights_",
            "EXT_texture_",
            "MSFT_texture_",
            "KHR_xmp",
        ];
        for (index, name) in self.extensions_required.iter().enumerate() {
            if name == QUANTIZATION || HARMLESS.iter().any(|known| name.starts_with(known)) {
                continue;
            }
            let what = match name.as_str() {
                "KHR_draco_mesh_compression" => " (triangles compressed by Draco)",
                "EXT_meshopt_compression" | "KHR_meshopt_compression" => {
                    " (triangles compressed by meshopt)"
                }
                "EXT_mesh_gpu_instancing" => " (many instances of a mesh)",
                _ => "",
            };
            let problem = format!("{name}{what} is not read; export the file without it");
            return Err(ReadError::place(format!("extensionsRequired[{index}]"), problem));
        }
        Ok(())
    }

    /// Whether positions may be integers.
    pub(super) fn is_quantized(&self) -> bool {
        self.extensions_required.iter().chain(&self.extensions_used).any(|it| it == QUANTIZATION)
    }
}

const QUANTIZATION: &str = "KHR_mesh_quantization";

/// The item of a list that another part of the document names; `list` is the name of the list.
pub(super) fn named<'d, T>(
    list: (&str, &'d [T]),
    index: Whole,
    named_at: impl FnOnce() -> String,
) -> Result<(usize, &'d T), ReadError> {
    let (name, list) = list;
    let item = usize::try_from(index.0).ok().and_then(|i| list.get(i).map(|item| (i, item)));
    item.ok_or_else(|| {
        let (index, count) = (index.0, list.len());
        let problem = format!("names {name}[{index}], which does not exist; the file has {count}");
        ReadError::place(named_at(), problem)
    })
}
