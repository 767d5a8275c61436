//! The objects of GeoJSON, and what those of TopoJSON have in common with them.

use std::collections::{BTreeMap, BTreeSet};

use glam::DVec2;
use mindeg_mesh::LineKind;
use serde_json::{Map, Value};

use crate::error::OutlineError;
use crate::kinds::MarkedLine;
use crate::outline::{DrawnRing, Feature, Outlines};
use crate::text::{counted, counted_all, quoted};

/// The most properties that a message lists.
const MOST_PROPERTIES: usize = 12;

#[derive(Default)]
pub(super) struct Reader<'a> {
    pub(super) outlines: Outlines,
    /// The property that names features, instead of the usual ones.
    pub(super) name_by: Option<&'a str>,
    /// The properties of features that lack that one, and how many lack it.
    other_properties: BTreeSet<String>,
    unnamed: usize,
    skipped: BTreeMap<String, usize>,
    heights: bool,
    /// Lines with a kind of boundary.
    marked: Vec<MarkedLine>,
    /// The largest absolute values of the first and the second coordinate.
    largest: [f64; 2],
}

/// Where a value is in the document.
pub(super) enum Path<'a> {
    Start,
    Key(&'a Path<'a>, &'static str),
    Item(&'a Path<'a>, usize),
}

impl Path<'_> {
    fn text(&self) -> String {
        match self {
            Self::Start => String::new(),
            Self::Key(Self::Start, key) => (*key).to_owned(),
            Self::Key(outer, key) => format!("{}.{key}", outer.text()),
            Self::Item(outer, index) => format!("{}[{index}]", outer.text()),
        }
    }

    pub(super) fn error(&self, problem: impl Into<String>) -> OutlineError {
        OutlineError::place(self.text(), problem)
    }
}

impl Reader<'_> {
    /// Reads an object by its type; features inside carry the name of the one around them.
    pub(super) fn object(
        &mut self,
        value: &Value,
        path: &Path<'_>,
        name: Option<&str>,
    ) -> Result<(), OutlineError> {
        let Some(object) = value.as_object() else {
            return Err(path.error(format!("found {}, expected a GeoJSON object", kind(value))));
        };
        let Some(kind) = object.get("type").and_then(Value::as_str) else {
            return Err(path.error("\"type\" is missing, such as \"type\": \"Polygon\""));
        };
        match kind {
            "FeatureCollection" => self.each(object, "features", path, None),
            "GeometryCollection" => self.each(object, "geometries", path, name),
            "Feature" => {
                let own = self.own_name(object);
                match object.get("geometry") {
                    None | Some(Value::Null) => {
                        self.skip("feature without geometry");
                        Ok(())
                    }
                    Some(geometry)
                        if self.marks(object, geometry, &Path::Key(path, "geometry"))? =>
                    {
                        Ok(())
                    }
                    Some(geometry) => {
                        self.object(geometry, &Path::Key(path, "geometry"), own.as_deref())
                    }
                }
            }
            "Polygon" | "MultiPolygon" => {
                each_part(object, kind, "coordinates", "rings", path, |rings, path| {
                    self.polygon(rings, path, name)
                })?;
                self.outlines.end_shape();
                Ok(())
            }
            "Point" | "MultiPoint" if list(object, "coordinates", path)?.is_empty() => {
                self.skip("geometry without positions");
                Ok(())
            }
            "Point" | "MultiPoint" => {
                each_part(object, kind, "coordinates", "two numbers", path, |numbers, path| {
                    let at = self.position(numbers, path)?;
                    self.outlines.inside.add_point(at, name);
                    Ok(())
                })
            }
            "LineString" | "MultiLineString" => {
                each_part(object, kind, "coordinates", "positions", path, |positions, path| {
                    let points = self.positions(positions, path)?;
                    self.outlines.inside.add_line(&points, name);
                    Ok(())
                })
            }
            other => Err(path.error(format!(
                "the type {} is none of GeoJSON; expected \"FeatureCollection\", \"Feature\", \
                 \"Polygon\" or \"MultiPolygon\"",
                quoted(other)
            ))),
        }
    }

    /// Reads a line that has a kind of boundary; whether it is one.
    fn marks(
        &mut self,
        feature: &Map<String, Value>,
        geometry: &Value,
        path: &Path<'_>,
    ) -> Result<bool, OutlineError> {
        let property = |key: &str| feature.get("properties")?.get(key)?.as_str();
        let Some(kind) = property("kind").and_then(LineKind::named) else { return Ok(false) };
        let Some(geometry) = geometry.as_object() else { return Ok(false) };
        let Some(shape @ ("LineString" | "MultiLineString")) =
            geometry.get("type").and_then(Value::as_str)
        else {
            return Ok(false);
        };
        let name = property("name").or_else(|| property("line"));
        each_part(geometry, shape, "coordinates", "positions", path, |positions, path| {
            let points = self.positions(positions, path)?;
            let (name, place) = (name.map(str::to_owned), path.text());
            self.marked.push(MarkedLine { points, name, kind, place });
            Ok(())
        })?;
        Ok(true)
    }

    fn each(
        &mut self,
        object: &Map<String, Value>,
        key: &'static str,
        path: &Path<'_>,
        name: Option<&str>,
    ) -> Result<(), OutlineError> {
        let values = list(object, key, path)?;
        let path = &Path::Key(path, key);
        let mut values = values.iter().enumerate();
        values.try_for_each(|(index, value)| self.object(value, &Path::Item(path, index), name))
    }

    pub(super) fn skip(&mut self, what: &str) {
        *self.skipped.entry(what.to_owned()).or_default() += 1;
    }

    fn polygon(
        &mut self,
        rings: &[Value],
        path: &Path<'_>,
        name: Option<&str>,
    ) -> Result<(), OutlineError> {
        if rings.is_empty() {
            self.skip("empty polygon");
            return Ok(());
        }
        let rings = rings.iter().enumerate().map(|(index, ring)| {
            let path = &Path::Item(path, index);
            let points = self.positions(items(ring, "positions", path)?, path)?;
            if points.is_empty() {
                return Err(path.error("the ring has no positions; drop it"));
            }
            Ok(DrawnRing::of_points(points))
        });
        let rings = rings.collect::<Result<_, _>>()?;
        self.add(name, rings);
        Ok(())
    }

    pub(super) fn add(&mut self, name: Option<&str>, rings: Vec<DrawnRing>) {
        self.outlines.features.push(Feature {
            name: name.map(str::to_owned),
            rings,
            ..Feature::default()
        });
    }

    fn positions(&mut self, values: &[Value], path: &Path<'_>) -> Result<Vec<DVec2>, OutlineError> {
        let points = values.iter().enumerate().map(|(index, value)| {
            let path = &Path::Item(path, index);
            self.position(items(value, "two numbers", path)?, path)
        });
        points.collect()
    }

    fn position(&mut self, numbers: &[Value], path: &Path<'_>) -> Result<DVec2, OutlineError> {
        let point = self.pair(numbers, path)?;
        self.measure(point);
        Ok(point)
    }

    /// The numbers of a position, which in TopoJSON may be those of no place.
    pub(super) fn pair(
        &mut self,
        numbers: &[Value],
        path: &Path<'_>,
    ) -> Result<DVec2, OutlineError> {
        let [x, y, rest @ ..] = numbers else {
            return Err(path.error("a position needs two numbers, such as [4.5, 52.1]"));
        };
        self.heights |= !rest.is_empty();
        let number = |value: &Value| {
            value.as_f64().filter(|number| number.is_finite()).ok_or_else(|| {
                path.error(format!("found {} in a position, expected a number", kind(value)))
            })
        };
        Ok(DVec2::new(number(x)?, number(y)?))
    }

    pub(super) fn measure(&mut self, point: DVec2) {
        self.largest = [self.largest[0].max(point.x.abs()), self.largest[1].max(point.y.abs())];
    }

    /// The property that was chosen, or `properties.name` in any case, else `id`.
    pub(super) fn own_name(&mut self, feature: &Map<String, Value>) -> Option<String> {
        let properties = feature.get("properties").and_then(Value::as_object);
        let by_key = |wanted: &str| properties.and_then(|properties| properties.get(wanted));
        let id = || as_name(feature.get("id")?);
        let Some(wanted) = self.name_by else {
            let named = ["name", "NAME", "Name"].into_iter().find_map(|key| as_name(by_key(key)?));
            return named.or_else(id);
        };
        let name = by_key(wanted).and_then(as_name);
        let name = name.or_else(|| if wanted == "id" { id() } else { None });
        if name.is_none() {
            self.unnamed += 1;
            self.other_properties.extend(properties.into_iter().flat_map(Map::keys).cloned());
        }
        name
    }

    /// Takes the reference system that the member `crs` of a document names: GeoJSON of 2008 had it, and GDAL writes it.
    fn take_crs(&mut self, document: &Value) {
        let is_in_degrees = self.is_in_degrees();
        if let Some(name) = document.pointer("/crs/properties/name").and_then(Value::as_str) {
            self.outlines.take_reference_system("\"crs\"", name, is_in_degrees);
        }
        // `mindeg condition` writes this member.
        let plane = document.pointer("/mindeg/straight_in").and_then(Value::as_str);
        self.outlines.straight_in = plane.and_then(|plane| plane.parse().ok());
    }

    fn is_in_degrees(&self) -> bool {
        self.largest[0] < 180.0 + 1e-9 && self.largest[1] <= 90.0
    }

    pub(super) fn end(mut self, document: &Value) -> Result<Outlines, OutlineError> {
        self.take_crs(document);
        self.outlines.is_geographic = self.is_in_degrees();
        self.outlines.inside.drop_repeated_points();
        let marked = std::mem::take(&mut self.marked);
        if !self.outlines.features.is_empty() {
            self.outlines.mark(marked)?;
        }
        if self.outlines.features.is_empty() && !self.outlines.inside.is_empty() {
            return Err(Path::Start.error("no Polygon or MultiPolygon, only lines or points"));
        }
        let notes = &mut self.outlines.notes;
        if !self.skipped.is_empty() {
            let skipped = counted_all(&self.skipped);
            if self.outlines.features.is_empty() {
                let problem = format!("no Polygon or MultiPolygon, only {skipped}");
                return Err(Path::Start.error(problem));
            }
            notes.push(format!("left out {skipped}"));
        }
        if self.heights {
            notes.push("left out the heights of positions".to_owned());
        }
        if self.largest[0] <= 90.0 && (90.0..=180.0).contains(&self.largest[1]) {
            notes.push(format!(
                "the second coordinates go up to {}, and latitudes to 90: GeoJSON has longitude first",
                self.largest[1]
            ));
        }
        if self.outlines.features.is_empty() {
            return Err(Path::Start.error("no Polygon or MultiPolygon; the collection is empty"));
        }
        if let Some(wanted) = self.name_by.filter(|_| self.unnamed > 0) {
            let is_any = self.outlines.features.iter().any(|feature| feature.name.is_some());
            let mut others =
                self.other_properties.iter().map(|key| quoted(key)).collect::<Vec<_>>();
            others.truncate(MOST_PROPERTIES);
            let others = if others.is_empty() { "none".to_owned() } else { others.join(", ") };
            let wanted = quoted(wanted);
            if !is_any {
                let problem = format!("no feature has the property {wanted}; they have {others}");
                return Err(Path::Start.error(problem));
            }
            let unnamed = counted(self.unnamed, "feature");
            notes.push(format!("{unnamed} without the property {wanted}"));
        }
        Ok(self.outlines)
    }
}

fn as_name(value: &Value) -> Option<String> {
    match value {
        Value::String(text) if !text.trim().is_empty() => Some(text.clone()),
        Value::Number(number) => Some(number.to_string()),
        _ => None,
    }
}

pub(super) fn list<'a>(
    object: &'a Map<String, Value>,
    key: &'static str,
    path: &Path<'_>,
) -> Result<&'a [Value], OutlineError> {
    let Some(value) = object.get(key) else {
        return Err(path.error(format!("{key:?} is missing")));
    };
    items(value, key, &Path::Key(path, key))
}

/// Reads what a geometry of a kind has under a key: one list of `what`, or each of several where the kind is a multiple.
pub(super) fn each_part(
    geometry: &Map<String, Value>,
    kind: &str,
    key: &'static str,
    what: &str,
    path: &Path<'_>,
    mut read: impl FnMut(&[Value], &Path<'_>) -> Result<(), OutlineError>,
) -> Result<(), OutlineError> {
    let parts = list(geometry, key, path)?;
    let path = &Path::Key(path, key);
    if !kind.starts_with("Multi") {
        return read(parts, path);
    }
    parts.iter().enumerate().try_for_each(|(index, part)| {
        let path = &Path::Item(path, index);
        read(items(part, what, path)?, path)
    })
}

pub(super) fn items<'a>(
    value: &'a Value,
    what: &str,
    path: &Path<'_>,
) -> Result<&'a [Value], OutlineError> {
    let items = value.as_array().map(Vec::as_slice);
    items.ok_or_else(|| path.error(format!("found {}, expected a list of {what}", kind(value))))
}

/// The kind of a value, for messages.
pub(super) fn kind(value: &Value) -> String {
    match value {
        Value::Null => "null".to_owned(),
        Value::Bool(it) => it.to_string(),
        Value::Number(number) => format!("the number {number}"),
        Value::String(text) => format!("the text {}", quoted(text)),
        Value::Array(_) => "a list".to_owned(),
        Value::Object(_) => "an object".to_owned(),
    }
}
