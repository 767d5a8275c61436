//! The JSON of a model: its keys for reading and for the schema.

use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;

use glam::DVec3;
use mindeg_mesh::Material;
use schemars::JsonSchema;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserializer, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Serialize};

use super::side::intervals;
use crate::error::{DomainError, Place};
use crate::model::{Model, ModelEdge, ModelFace, ModelParts};
use crate::name;
use crate::side::Side;
use crate::spacing::Spacing;

/// A model as JSON describes it, or any other format that serde reads: corners, and faces between them;
/// [`model`](Self::model) is the model that it describes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ModelDescription {
    /// The model's name
    name: Option<String>,
    /// The position of each corner, `[x, y, z]`
    #[schemars(with = "Vec<[f64; 3]>")]
    corners: Vec<DVec3>,
    /// The faces: each a loop of corners, counter-clockwise seen from outside, or an object with that
    /// loop, holes, names and a material
    faces: Vec<FaceKeys>,
    /// The target interval length of every edge that gives neither `intervals` nor `size` nor
    /// `parameters`
    #[schemars(extend("exclusiveMinimum" = 0))]
    size: Option<f64>,
    /// Edges of faces with a division of their own
    edges: Option<Vec<EdgeKeys>>,
    /// The colors of materials; one that is not in this list has no color
    materials: Option<Vec<MaterialKeys>>,
    /// How far a corner may be off the plane of its face, in units of length
    #[schemars(extend("exclusiveMinimum" = 0))]
    planar_tolerance: Option<f64>,
}

/// A face
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
enum FaceKeys {
    /// Its outer loop alone
    Loop(Vec<u32>),
    /// Its loop and what it is called
    Named(NamedFace),
}

/// A face with holes, names or a material
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct NamedFace {
    /// The outer loop of corners, by their indices
    corners: Vec<u32>,
    /// Loops of corners inside, either way round
    holes: Option<Vec<Vec<u32>>>,
    /// Its own name
    name: Option<String>,
    /// The group that it belongs to; without one, its name
    group: Option<String>,
    /// The name of its material
    material: Option<String>,
}

/// An edge
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct EdgeKeys {
    /// The indices of its two corners
    corners: [u32; 2],
    /// The number of intervals, at least 1
    #[schemars(range(min = 1))]
    intervals: Option<u64>,
    /// Instead: a target interval length above 0
    #[schemars(extend("exclusiveMinimum" = 0))]
    size: Option<f64>,
    /// How its points are spread, from the first of its two corners on
    spacing: Option<Spacing>,
    /// Its name
    name: Option<String>,
}

/// A material
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct MaterialKeys {
    /// The name by which faces name it
    name: String,
    /// Its base color: red, green, blue, and opacity unless it is 1; from 0 to 1 in linear light
    #[schemars(length(min = 3, max = 4), inner(range(min = 0, max = 1)))]
    color: Option<Vec<f64>>,
}

impl<'de> Deserialize<'de> for FaceKeys {
    fn deserialize<D: Deserializer<'de>>(given: D) -> Result<Self, D::Error> {
        struct Either;

        impl<'de> Visitor<'de> for Either {
            type Value = FaceKeys;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(
                    "a loop of corners such as [0, 1, 2, 3], or {\"corners\": [0, 1, 2, 3]}",
                )
            }

            fn visit_seq<A: SeqAccess<'de>>(self, corners: A) -> Result<FaceKeys, A::Error> {
                Deserialize::deserialize(SeqAccessDeserializer::new(corners)).map(FaceKeys::Loop)
            }

            fn visit_map<A: MapAccess<'de>>(self, keys: A) -> Result<FaceKeys, A::Error> {
                Deserialize::deserialize(MapAccessDeserializer::new(keys)).map(FaceKeys::Named)
            }
        }

        given.deserialize_any(Either)
    }
}

/// The materials that a model names.
type Materials = BTreeMap<String, Arc<Material>>;

impl ModelDescription {
    /// Builds the described model.
    ///
    /// # Errors
    ///
    /// Keys that exclude each other, and what [`Model::new`] refuses.
    pub fn model(self) -> Result<Model, DomainError> {
        let Self { name, corners, faces, size, edges, materials, planar_tolerance } = self;
        let mut known = Materials::new();
        for (index, given) in materials.unwrap_or_default().into_iter().enumerate() {
            given.add_to(&mut known, &Place::key("materials").then(index))?;
        }
        let edge = |(index, given): (usize, EdgeKeys)| given.edge(index, size);
        let edges = edges.unwrap_or_default().into_iter().enumerate().map(edge);
        let model = Model::new(ModelParts {
            corners,
            faces: faces.into_iter().map(|given| given.face(&mut known)).collect(),
            edges: edges.collect::<Result<_, _>>()?,
            other_edges: size.map(Side::size),
            planar_tolerance,
        })?;
        Ok(match name {
            Some(name) => {
                name::check(&name, Place::key("name"), "the model")?;
                model.named(name)
            }
            None => model,
        })
    }
}

impl MaterialKeys {
    fn add_to(self, known: &mut Materials, place: &Place) -> Result<(), DomainError> {
        let Self { name, color: given } = self;
        name::check(&name, place.clone().then("name"), "the material")?;
        let mut color = None;
        if let Some(given) = given {
            if !(3..=4).contains(&given.len()) || !given.iter().all(|c| (0.0..=1.0).contains(c)) {
                return Err(place.clone().then("color").error(
                    "a color is a list of red, green and blue, and opacity if it is not 1, each \
                     from 0 to 1",
                ));
            }
            let channel = |index: usize| given.get(index).map_or(1.0, |value| *value as f32);
            color = Some([0, 1, 2, 3].map(channel));
        }
        let material = Arc::new(Material { name: name.clone(), color });
        match known.insert(name, material) {
            None => Ok(()),
            Some(first) => Err(place
                .clone()
                .then("name")
                .error(format!("the list has two materials {:?}; drop one", first.name))),
        }
    }
}

impl FaceKeys {
    fn face(self, materials: &mut Materials) -> ModelFace {
        let face = match self {
            Self::Loop(corners) => NamedFace { corners, ..NamedFace::default() },
            Self::Named(face) => face,
        };
        let NamedFace { corners, holes, name, group, material } = face;
        let loops = [vec![corners], holes.unwrap_or_default()].concat();
        // A material that is not in the list has no color.
        let material = material.map(|name| {
            let without = || Arc::new(Material { name: name.clone(), color: None });
            Arc::clone(materials.entry(name.clone()).or_insert_with(without))
        });
        ModelFace { loops, name, group, material }
    }
}

impl EdgeKeys {
    fn edge(self, index: usize, default_size: Option<f64>) -> Result<ModelEdge, DomainError> {
        let spacing = self.spacing.unwrap_or_default();
        let given = (self.intervals, self.size);
        let place = Place::key("edges").then(index);
        let intervals = intervals(&place, given, &spacing, default_size)?;
        let side = Side { intervals, spacing, name: self.name, ..Side::count(1) };
        Ok(ModelEdge { corners: self.corners, side })
    }
}
