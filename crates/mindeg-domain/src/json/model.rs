//! Models as JSON text.

use std::collections::BTreeMap;
use std::sync::Arc;

use glam::DVec3;
use mindeg_mesh::Material;

use super::error::DomainJsonError;
use super::spacing::spacing;
use super::value::{ABOVE_0, Step, Value};
use crate::model::{Model, ModelEdge, ModelError, ModelFace, ModelParts, check_name};
use crate::side::{Intervals, Side};
use crate::spacing::Spacing;

const MODEL: &str = "an object with \"corners\", \"faces\", and \"size\" or \"edges\"; optional: \
                     \"name\", \"materials\"";
const MATERIALS: &str =
    "a list of objects such as {\"name\": \"steel\", \"color\": [0.6, 0.6, 0.65]}";
const MATERIAL: &str = "an object such as {\"name\": \"steel\", \"color\": [0.6, 0.6, 0.65]}";
const COLOR: &str = "a list of red, green and blue, and opacity if it is not 1, each from 0 to 1";
const CORNERS: &str = "a list of [x, y, z] triples of numbers";
const TRIPLE: &str = "a triple [x, y, z] of numbers";
const EDGES: &str = "a list of objects such as {\"corners\": [0, 1], \"intervals\": 3}";
const EDGE: &str = "an object such as {\"corners\": [0, 1], \"intervals\": 3} or {\"corners\": \
                    [0, 1], \"size\": 0.5}; optional: \"spacing\", \"name\"";
const ENDS: &str = "a pair of corners, such as [0, 1]";
const FACES: &str = "a list of faces, each a loop of corners such as [0, 1, 2, 3]";
const FACE: &str = "a loop of corners such as [0, 1, 2, 3], or {\"corners\": [0, 1, 2, 3]}; \
                    optional: \"holes\", \"name\", \"group\", \"material\"";
const LOOP: &str = "a loop of corners, such as [0, 1, 2, 3]";
const HOLES: &str = "a list of loops of corners, such as [[4, 5, 6]]";
const CORNER: &str = "the index of a corner, from 0";

impl Model {
    /// Whether a JSON text is an object with the key `faces`, which makes it a model.
    #[must_use]
    pub fn is_model_json(text: &str) -> bool {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        Value::document(text).is_ok_and(|value| value.at(&[Step::Key("faces")]).is_some())
    }

    /// Reads a model from JSON text.
    ///
    /// ```json
    /// {
    ///   "name": "wedge",
    ///   "corners": [[0, 0, 0], [4, 0, 0], [0, 3, 0], [0, 0, 2]],
    ///   "size": 0.5,
    ///   "materials": [{"name": "steel", "color": [0.6, 0.6, 0.65]}],
    ///   "edges": [
    ///     {"corners": [0, 1], "intervals": 8, "spacing": {"geometric": {"ratio": 1.2}}, "name": "toe"}
    ///   ],
    ///   "faces": [
    ///     [0, 2, 1], [0, 1, 3], [1, 2, 3],
    ///     {"corners": [0, 3, 2], "name": "back", "group": "walls", "material": "steel"}
    ///   ]
    /// }
    /// ```
    ///
    /// | key | value |
    /// |---|---|
    /// | `name` | optional: the model's name |
    /// | `corners` | positions, `[x, y, z]` |
    /// | `faces` | each a loop of corners, counter-clockwise seen from outside; or an object with `corners` (that loop), `holes` (a list of loops), `name`, `group` and `material` (the name of one), all but `corners` optional |
    /// | `materials` | optional: each with its `name` and its base color, `color`: red, green, blue, and opacity unless it is 1; from 0 to 1 in linear light. A material that is not in this list has no color |
    /// | `size` | optional: the target interval length of every edge that gives neither `intervals` nor `size` nor `parameters` |
    /// | `edges` | optional: edges of faces, each with `corners`, and optionally `intervals` or `size`, `spacing` (as in a domain, from the first of the two corners on), `name` |
    /// | `planar_tolerance` | optional: how far a corner may be off the plane of its face, in units of length |
    ///
    /// The value `null` counts as left out.
    ///
    /// # Errors
    ///
    /// Text that is no JSON, keys or values that are not the format's, and everything that
    /// [`Model::new`] refuses; each with its path, line and column.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_domain::Model;
    ///
    /// let model = Model::from_json(
    ///     r#"{"corners": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
    ///         "faces": [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]], "size": 0.25}"#,
    /// )?;
    /// assert!(model.is_closed());
    /// assert_eq!(model.face_size(0), 4 + 4 + 6);
    /// # Ok::<(), mindeg_domain::DomainJsonError>(())
    /// ```
    pub fn from_json(text: &str) -> Result<Self, DomainJsonError> {
        let text = Value::document(text.strip_prefix('\u{feff}').unwrap_or(text))?;
        let allowed =
            ["name", "corners", "faces", "size", "edges", "materials", "planar_tolerance"];
        let keys = text.object(&allowed, MODEL)?;
        let size = keys.get("size").map(|size| size.number(ABOVE_0)).transpose()?;
        let corners = keys.need("corners")?.items(CORNERS)?;
        let faces = keys.need("faces")?.items(FACES)?;
        let edges = keys.get("edges").map_or(Ok(Vec::new()), |edges| edges.items(EDGES))?;
        let mut materials = Materials::default();
        if let Some(given) = keys.get("materials") {
            given.items(MATERIALS)?.iter().try_for_each(|material| materials.add(material))?;
        }
        let tolerance = keys.get("planar_tolerance").map(|length| length.number(ABOVE_0));
        let parts = ModelParts {
            corners: corners.iter().map(triple).collect::<Result<_, _>>()?,
            faces: faces
                .iter()
                .map(|given| face(given, &mut materials))
                .collect::<Result<_, _>>()?,
            edges: edges.iter().map(|given| edge(given, size)).collect::<Result<_, _>>()?,
            other_edges: size.map(Side::size),
            planar_tolerance: tolerance.transpose()?,
        };
        let name = keys.get("name").map(|name| name.text("a text in double quotes")).transpose()?;
        match Self::new(parts) {
            Ok(model) => Ok(match name {
                Some(name) => {
                    check_name(Some(&name), || "the model".to_owned())
                        .map_err(|error| located(&text, &[Step::Key("name")], &error))?;
                    model.named(name)
                }
                None => model,
            }),
            Err(error) => Err(located(&text, &path(&error, &edges), &error)),
        }
    }
}

fn located(text: &Value<'_>, path: &[Step], error: &ModelError) -> DomainJsonError {
    text.at(path).unwrap_or_else(|| text.clone()).error(error.to_string())
}

/// The path of the value that an error is about.
fn path(error: &ModelError, edges: &[Value<'_>]) -> Vec<Step> {
    use Step::{Index, Key};
    let of_edge = |wanted: [u32; 2]| {
        let has = |given: &Value<'_>| {
            ends(given).is_ok_and(|[a, b]| [a.min(b), a.max(b)] == [wanted[0], wanted[1]])
        };
        // The last one: of two, the first was right until then.
        match edges.iter().rposition(has) {
            Some(index) => vec![Key("edges"), Index(index)],
            None => vec![Key("size")],
        }
    };
    match *error {
        ModelError::NoFaces => vec![Key("faces")],
        ModelError::NotFinite { corner } => vec![Key("corners"), Index(corner as usize)],
        ModelError::NoSuchCorner { what: "edge", index, .. }
        | ModelError::NoSuchEdge { index, .. } => vec![Key("edges"), Index(index)],
        ModelError::NoSuchCorner { index: face, .. }
        | ModelError::TooFewCorners { face, .. }
        | ModelError::RepeatedCorner { face, .. }
        | ModelError::Spike { face, .. }
        | ModelError::NoArea { face }
        | ModelError::NotPlanar { face, .. }
        | ModelError::Crossing { face, .. }
        | ModelError::Touch { face, .. }
        | ModelError::HoleOutside { face, .. }
        | ModelError::FaceTwice { second: face, .. } => vec![Key("faces"), Index(face)],
        ModelError::CoincidentCorners { corners: [_, corner] } => {
            vec![Key("corners"), Index(corner as usize)]
        }
        ModelError::TwoCounts { corners, .. }
        | ModelError::EdgeTwice { corners }
        | ModelError::NoIntervals { corners }
        | ModelError::Edge { corners, .. }
        | ModelError::IntervalTooShort { corners, .. } => of_edge(corners),
        _ => vec![],
    }
}

fn triple(given: &Value<'_>) -> Result<DVec3, DomainJsonError> {
    match &given.items(TRIPLE)?[..] {
        [x, y, z] => {
            Ok(DVec3::new(x.number("a number")?, y.number("a number")?, z.number("a number")?))
        }
        items => {
            let values = if items.len() == 1 { "value" } else { "values" };
            let count = items.len();
            Err(given.error(format!("found a list of {count} {values}, expected {TRIPLE}")))
        }
    }
}

fn corner_loop(given: &Value<'_>) -> Result<Vec<u32>, DomainJsonError> {
    given.items(LOOP)?.iter().map(|corner| corner.whole(CORNER)).collect()
}

/// The materials that a model names.
#[derive(Default)]
struct Materials(BTreeMap<String, Arc<Material>>);

impl Materials {
    fn add(&mut self, given: &Value<'_>) -> Result<(), DomainJsonError> {
        let keys = given.object(&["name", "color"], MATERIAL)?;
        let name = keys.need("name")?;
        let color = keys.get("color").map(color).transpose()?;
        let text = name.text("a text in double quotes")?;
        check_name(Some(&text), || "the material".to_owned())
            .map_err(|error| name.error(error.to_string()))?;
        let material = Arc::new(Material { name: text.clone(), color });
        match self.0.insert(text, material) {
            None => Ok(()),
            Some(first) => {
                Err(name.error(format!("the list has two materials {:?}; drop one", first.name)))
            }
        }
    }

    /// The material of a name; without a color, if the list does not have it.
    fn named(&mut self, name: String) -> Arc<Material> {
        let without = || Arc::new(Material { name: name.clone(), color: None });
        Arc::clone(self.0.entry(name.clone()).or_insert_with(without))
    }
}

fn color(given: &Value<'_>) -> Result<[f32; 4], DomainJsonError> {
    let items = given.items(COLOR)?;
    if !(3..=4).contains(&items.len()) {
        return Err(given.error(format!("found a list of {}, expected {COLOR}", items.len())));
    }
    let mut color = [1.0; 4];
    for (channel, item) in color.iter_mut().zip(&items) {
        let value = item.number("a number from 0 to 1")?;
        if !(0.0..=1.0).contains(&value) {
            return Err(item.error(format!("found {value}, expected a number from 0 to 1")));
        }
        *channel = value as f32;
    }
    Ok(color)
}

fn face(given: &Value<'_>, materials: &mut Materials) -> Result<ModelFace, DomainJsonError> {
    if given.is_list() {
        return Ok(ModelFace { loops: vec![corner_loop(given)?], ..ModelFace::default() });
    }
    let keys = given.object(&["corners", "holes", "name", "group", "material"], FACE)?;
    let mut loops = vec![corner_loop(keys.need("corners")?)?];
    if let Some(holes) = keys.get("holes") {
        for hole in holes.items(HOLES)? {
            loops.push(corner_loop(&hole)?);
        }
    }
    let text = |key| keys.get(key).map(|text| text.text("a text in double quotes")).transpose();
    let material = text("material")?.map(|name| materials.named(name));
    Ok(ModelFace { loops, name: text("name")?, group: text("group")?, material })
}

fn ends(given: &Value<'_>) -> Result<[u32; 2], DomainJsonError> {
    let keys = given.object(&["corners", "intervals", "size", "spacing", "name"], EDGE)?;
    let corners = keys.need("corners")?;
    match &corners.items(ENDS)?[..] {
        [a, b] => Ok([a.whole(CORNER)?, b.whole(CORNER)?]),
        items => {
            let count = items.len();
            Err(corners.error(format!("found a list of {count}, expected {ENDS}")))
        }
    }
}

fn edge(given: &Value<'_>, default_size: Option<f64>) -> Result<ModelEdge, DomainJsonError> {
    let corners = ends(given)?;
    let keys = given.object(&["corners", "intervals", "size", "spacing", "name"], EDGE)?;
    let spacing = keys.get("spacing").map_or(Ok(Spacing::Uniform), spacing)?;
    let count = keys.get("intervals").map(|n| n.whole("a whole number, at least 1")).transpose()?;
    let size = keys.get("size").map(|size| size.number(ABOVE_0)).transpose()?;
    let name = keys.get("name").map(|name| name.text("a text in double quotes")).transpose()?;
    let intervals = match (count, size, &spacing) {
        (Some(_), Some(_), _) => {
            return Err(given.error("give either \"intervals\" or \"size\", not both"));
        }
        (Some(count), None, _) => Intervals::Count(count),
        (None, None, Spacing::Parameters(given)) => Intervals::Count(given.len() as u64 + 1),
        (None, size, _) => Intervals::Size(size.or(default_size).ok_or_else(|| {
            given
                .error("give \"intervals\" (a whole number) or \"size\" (a target interval length)")
        })?),
    };
    Ok(ModelEdge { corners, side: Side { intervals, spacing, name, ..Side::count(1) } })
}
