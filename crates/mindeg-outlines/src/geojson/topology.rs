//! TopoJSON: polygons whose borders are shared arcs, so that neighbours have the same points, bit for bit.

use glam::DVec2;
use serde_json::{Map, Value};

use super::reader::{Path, Reader, each_part, items, kind, list};
use crate::error::OutlineError;
use crate::outline::DrawnRing;
use crate::text::quoted;

/// The most points of all rings: a small file can name an arc many times.
const MOST_POINTS: usize = 50_000_000;

/// The arcs of a document.
struct Topology {
    arcs: Vec<Vec<DVec2>>,
    /// The scale and the shift of quantized positions.
    transform: Option<(DVec2, DVec2)>,
    /// How many points rings may still have.
    budget: usize,
}

/// Reads the polygons of one object of a topology: the one of this name, or the only one.
pub(super) fn read(
    document: &Value,
    layer: Option<&str>,
    reader: &mut Reader<'_>,
) -> Result<(), OutlineError> {
    let start = Path::Start;
    let objects = document.get("objects");
    let objects = objects.ok_or_else(|| start.error("\"objects\" is missing"))?;
    let of_objects = Path::Key(&start, "objects");
    let objects = objects.as_object().ok_or_else(|| {
        of_objects.error(format!("found {}, expected objects by name", kind(objects)))
    })?;
    let names = || objects.keys().map(|name| quoted(name)).collect::<Vec<_>>().join(", ");
    let object = match (layer, objects.len()) {
        (Some(layer), _) => objects.get(layer).ok_or_else(|| {
            start.error(format!("no layer is {}; the file has {}", quoted(layer), names()))
        })?,
        (None, 0) => return Err(of_objects.error("there is no object")),
        (None, 1) => &objects[objects.keys().next().map_or("", String::as_str)],
        (None, _) => {
            return Err(
                start.error(format!("the file has several layers; choose one of {}", names()))
            );
        }
    };
    let transform = transform(document)?;
    let arcs = arcs(document, transform, reader)?;
    let mut topology = Topology { arcs, transform, budget: MOST_POINTS };
    topology.geometry(object, &of_objects, reader)
}

/// The scale and the shift of positions that are whole numbers.
fn transform(document: &Value) -> Result<Option<(DVec2, DVec2)>, OutlineError> {
    let start = Path::Start;
    let path = Path::Key(&start, "transform");
    let pair = |of: &Map<String, Value>, key: &'static str| {
        let numbers = list(of, key, &path)?.iter().map(Value::as_f64).collect::<Option<Vec<_>>>();
        match numbers.as_deref() {
            Some(&[x, y]) => Ok(DVec2::new(x, y)),
            _ => Err(Path::Key(&path, key).error("expected two numbers")),
        }
    };
    match document.get("transform") {
        None | Some(Value::Null) => Ok(None),
        Some(Value::Object(it)) => Ok(Some((pair(it, "scale")?, pair(it, "translate")?))),
        Some(other) => Err(path.error(format!("found {}, expected an object", kind(other)))),
    }
}

/// The points of all arcs.
fn arcs(
    document: &Value,
    transform: Option<(DVec2, DVec2)>,
    reader: &mut Reader<'_>,
) -> Result<Vec<Vec<DVec2>>, OutlineError> {
    let start = Path::Start;
    let Some(top) = document.as_object() else { return Ok(Vec::new()) };
    let path = Path::Key(&start, "arcs");
    let arc = |(index, arc): (usize, &Value)| {
        let path = Path::Item(&path, index);
        let mut sum = DVec2::ZERO;
        let points = items(arc, "positions", &path)?.iter().enumerate().map(|(index, position)| {
            let path = &Path::Item(&path, index);
            let point = reader.pair(items(position, "two numbers", path)?, path)?;
            let point = match transform {
                None => point,
                Some((scale, translate)) => {
                    sum += point;
                    sum * scale + translate
                }
            };
            match point.is_finite() {
                true => Ok(point),
                false => Err(path.error("the coordinate is too large")),
            }
        });
        points.collect()
    };
    list(top, "arcs", &start)?.iter().enumerate().map(arc).collect()
}

impl Topology {
    /// Reads a geometry, which has the properties of a feature.
    fn geometry(
        &mut self,
        value: &Value,
        path: &Path<'_>,
        reader: &mut Reader<'_>,
    ) -> Result<(), OutlineError> {
        let Some(object) = value.as_object() else {
            return Err(path.error(format!("found {}, expected a geometry", kind(value))));
        };
        match object.get("type") {
            Some(Value::Null) => reader.skip("geometry of no type"),
            Some(Value::String(kind)) => match &**kind {
                "GeometryCollection" => {
                    let geometries = Path::Key(path, "geometries");
                    for (index, geometry) in list(object, "geometries", path)?.iter().enumerate() {
                        self.geometry(geometry, &Path::Item(&geometries, index), reader)?;
                    }
                }
                "Polygon" | "MultiPolygon" => {
                    let name = reader.own_name(object);
                    each_part(object, kind, "arcs", "rings", path, |rings, path| {
                        self.polygon(rings, path, name.as_deref(), reader)
                    })?;
                    reader.outlines.end_shape();
                }
                "LineString" | "MultiLineString" => {
                    let name = reader.own_name(object);
                    each_part(object, kind, "arcs", "arcs", path, |arcs, path| {
                        let points = self.points(arcs, path, reader)?;
                        reader.outlines.inside.add_line(&points, name.as_deref());
                        Ok(())
                    })?;
                }
                "Point" | "MultiPoint" => {
                    let name = reader.own_name(object);
                    each_part(
                        object,
                        kind,
                        "coordinates",
                        "two numbers",
                        path,
                        |numbers, path| {
                            let at = reader.pair(numbers, path)?;
                            let placed = |(scale, translate)| at * scale + translate;
                            let at = self.transform.map_or(at, placed);
                            reader.measure(at);
                            reader.outlines.inside.add_point(at, name.as_deref());
                            Ok(())
                        },
                    )?;
                }
                other => {
                    let problem = format!("the type {} is none of TopoJSON", quoted(other));
                    return Err(path.error(problem));
                }
            },
            _ => return Err(path.error("\"type\" is missing, such as \"type\": \"Polygon\"")),
        }
        Ok(())
    }

    fn polygon(
        &mut self,
        rings: &[Value],
        path: &Path<'_>,
        name: Option<&str>,
        reader: &mut Reader<'_>,
    ) -> Result<(), OutlineError> {
        if rings.is_empty() {
            reader.skip("empty polygon");
            return Ok(());
        }
        let mut drawn = Vec::with_capacity(rings.len());
        for (index, ring) in rings.iter().enumerate() {
            let path = &Path::Item(path, index);
            let points = self.points(items(ring, "arcs", path)?, path, reader)?;
            if points.is_empty() {
                return Err(path.error("the ring has no positions; drop it"));
            }
            drawn.push(DrawnRing::of_points(points));
        }
        reader.add(name, drawn);
        Ok(())
    }

    /// The points of a ring or a line: each arc begins where the one before ends.
    fn points(
        &mut self,
        indices: &[Value],
        path: &Path<'_>,
        reader: &mut Reader<'_>,
    ) -> Result<Vec<DVec2>, OutlineError> {
        let mut points: Vec<DVec2> = Vec::new();
        for (at, value) in indices.iter().enumerate() {
            // -1 is the first arc from its end to its start.
            let arc = value.as_i64().and_then(|index| {
                let is_reversed = index < 0;
                let arc = self.arcs.get(usize::try_from(index ^ (index >> 63)).ok()?)?;
                Some((arc, is_reversed))
            });
            let Some((arc, is_reversed)) = arc else {
                let (found, count) = (kind(value), self.arcs.len());
                let problem = format!("found {found}, expected the index of one of {count} arcs");
                return Err(Path::Item(path, at).error(problem));
            };
            self.budget = self.budget.checked_sub(arc.len()).ok_or_else(|| {
                path.error(format!("the rings have more than {MOST_POINTS} points in all"))
            })?;
            points.pop();
            if is_reversed {
                points.extend(arc.iter().rev());
            } else {
                points.extend(arc);
            }
        }
        points.iter().for_each(|&point| reader.measure(point));
        Ok(points)
    }
}
