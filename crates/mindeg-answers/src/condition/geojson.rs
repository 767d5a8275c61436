//! Boundaries as GeoJSON, in degrees if they were projected.

use super::ConditionAnswer;
use super::places::place;
use mindeg::Domain;
use mindeg_mesh::Line;
use serde_json::{Value, json};
use std::iter::once;

/// Domains as outlines that mindeg reads again: a polygon each under its name, lines and points inside, and a line with `kind`
/// and `name` for each stretch of sides that are open water, land or island. In degrees if the domains were projected; the foreign
/// member `mindeg` then says in which plane edges are straight, so that they get no points when they are projected again. Names of
/// sides without a kind are left out; so is what a domain has for a mesh. `None` of those that [have regions](has_regions). O(n log n).
///
/// # Example
///
/// ```
/// use mindeg::{Domain, OpenWater};
/// use mindeg_answers::condition::as_geojson;
///
/// let bay = Domain::from_rings([[[0.0, 0.0], [4.0, 0.0], [3.0, 2.0], [1.0, 1.5]]])?;
/// let (bay, _) = bay.with_open_water(&[OpenWater::Box], None)?;
/// let outlines = as_geojson(&[bay]).expect("no regions");
/// assert_eq!(outlines["features"][0]["geometry"]["type"], "Polygon");
/// assert_eq!(outlines["features"][1]["properties"]["kind"], "open");
/// # Ok::<(), mindeg::DomainError>(())
/// ```
#[must_use]
pub fn as_geojson(domains: &[Domain]) -> Option<Value> {
    if has_regions(domains) {
        return None;
    }
    let mut features = Vec::new();
    for domain in domains {
        // A part of a map has the name of its only region.
        let region = domain.inside().regions.first().and_then(|region| region.name.as_deref());
        let name = region.or(domain.name());
        let properties = name.map_or(json!({}), |name| json!({"name": name}));
        features.push(feature(properties, &polygon(domain)));
        features.extend(kinds(domain));
        let lines = lines(domain).into_iter();
        features.extend(lines.map(|(name, line)| feature(json!({"name": name}), &line)));
        for point in &domain.inside().points {
            features.push(at_point(place(domain, point.at), json!({"name": point.name})));
        }
    }
    let mut outlines = collection(features);
    if let Some(projection) = domains.first().and_then(Domain::projection) {
        outlines["mindeg"] = json!({"straight_in": projection.to_string()});
    }
    Some(outlines)
}

/// Whether lines divide one of some domains into regions, which the outlines of [`as_geojson`] cannot have.
#[must_use]
pub fn has_regions(domains: &[Domain]) -> bool {
    domains.iter().any(|domain| domain.faces().is_some_and(|faces| faces.count > 1))
}

impl ConditionAnswer {
    /// Both boundaries, all changes and the places that are left as GeoJSON, to draw them on a map: polygons with the
    /// property `boundary`, which is `before` or `after`, lines inside in the same way, and points with the properties of their rows and the number of a change, counted from 1. In degrees if the domain
    /// was projected.
    #[must_use]
    pub fn drawn(&self, before: &[Domain], after: &[Domain]) -> Value {
        let changes = (1..).zip(&self.changes).map(|(number, row): (u32, _)| {
            at_point(
                row.degrees.unwrap_or(row.at),
                json!({
                    "kind": row.kind,
                    "number": number,
                    "ring": row.ring,
                    "side": row.side,
                    "moved": row.moved,
                    "reason": row.reason,
                }),
            )
        });
        let left = self.left.iter().map(|row| {
            let properties =
                json!({"kind": "left", "angle_limit": row.angle_limit, "is_proven": row.is_proven, "reason": row.reason});
            at_point(row.degrees.unwrap_or(row.at), properties)
        });
        let narrow = self.narrow.iter().map(|row| {
            let properties = json!({"kind": "narrow", "width": row.width, "reason": row.reason});
            at_point(row.degrees.unwrap_or(row.at), properties)
        });
        let drawn = |name: &str, domains: &[Domain]| -> Vec<Value> {
            let of = |domain: &Domain| -> Vec<Value> {
                let lines = lines(domain).into_iter().map(|(_, line)| line);
                once(polygon(domain)).chain(lines).collect()
            };
            let all = domains.iter().flat_map(of);
            all.map(|geometry| feature(json!({"boundary": name}), &geometry)).collect()
        };
        let boundaries = [drawn("before", before), drawn("after", after)].concat().into_iter();
        let features = boundaries.chain(changes).chain(left).chain(narrow).collect();
        collection(features)
    }
}

fn feature(properties: Value, geometry: &Value) -> Value {
    json!({"type": "Feature", "properties": properties, "geometry": geometry})
}

fn at_point(at: [f64; 2], properties: Value) -> Value {
    feature(properties, &json!({"type": "Point", "coordinates": at}))
}

fn collection(features: Vec<Value>) -> Value {
    json!({"type": "FeatureCollection", "features": features})
}

/// The rings of a domain.
fn polygon(domain: &Domain) -> Value {
    let rings = domain.rings().rings().map(|range| {
        let closed = range.clone().chain([range.start]);
        closed.map(|vertex| place(domain, domain.placement().point(vertex))).collect::<Vec<_>>()
    });
    json!({"type": "Polygon", "coordinates": rings.collect::<Vec<_>>()})
}

/// The lines inside a domain, with their names.
fn lines(domain: &Domain) -> Vec<(String, Value)> {
    let Ok(all) = domain.boundary() else { return Vec::new() };
    let line = |(line, _): (Line, _)| {
        let segments = line.segments.start as usize..line.segments.end as usize;
        let segments = &domain.inner_segments()[segments];
        let ends = segments.iter().map(|ends| ends[0]);
        let ends = ends.chain(segments.last().map(|ends| ends[1]));
        let points: Vec<_> = ends.map(|vertex| place(domain, all.point(vertex))).collect();
        (line.name, json!({"type": "LineString", "coordinates": points}))
    };
    domain.inner_lines().into_iter().map(line).collect()
}

/// The stretches of sides with a kind, each of one name.
fn kinds(domain: &Domain) -> Vec<Value> {
    let rings = domain.rings();
    let told = |side: usize| (domain.side_name(side), domain.sides()[side].kind);
    let mut found: Vec<Value> = Vec::new();
    for ring in 0..rings.ring_count() {
        let sides: Vec<usize> = rings.ring_sides(ring).collect();
        for stretch in sides.chunk_by(|a, b| told(*a) == told(*b)) {
            let (name, Some(kind)) = told(stretch[0]) else { continue };
            let (first, last) = (stretch[0], stretch[stretch.len() - 1]);
            let start = rings.corner(first);
            let end = rings.corner(last) + rings.intervals(last);
            let ends = once(start).chain((start..end).map(|vertex| rings.next(vertex)));
            let points: Vec<_> =
                ends.map(|vertex| place(domain, domain.placement().point(vertex))).collect();
            let line = json!({"type": "LineString", "coordinates": points});
            found.push(feature(json!({"kind": kind.name(), "name": name}), &line));
        }
    }
    found
}
