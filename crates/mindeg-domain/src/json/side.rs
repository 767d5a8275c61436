//! Sides: how they run, how they are divided, what they are called.

use glam::DVec2;

use super::constraint::side_constraint;
use super::error::DomainJsonError;
use super::point::{pair, points};
use super::spacing::spacing;
use super::value::{ABOVE_0, Object, Value};
use crate::constraints::SideConstraint;
use crate::curve::{Arc, Curve};
use crate::side::{Intervals, Side};
use crate::spacing::Spacing;
use mindeg_mesh::LineKind;

const SIDE: &str = "an object such as {\"intervals\": 3} or {\"size\": 0.5}; optional: \"spacing\", \
                    \"name\", \"kind\", \"outside_degree\", \"max_degree\", and one of \"points\", \
                    \"polyline\", \"arc\", \"bezier\"";
const RING_SIDE: &str =
    "an object; optional: \"name\", \"kind\", \"outside_degree\", \"max_degree\"";
const ARC: &str = "{\"through\": [x, y]} or {\"center\": [x, y]}; optional: \"clockwise\": true";
const BEZIER: &str = "a list of two control points [x, y]";

/// A side of a ring that has corners.
pub(super) fn side(
    given: &Value<'_>,
    default_size: Option<f64>,
) -> Result<(Side, SideConstraint), DomainJsonError> {
    let allowed = [
        "intervals",
        "size",
        "spacing",
        "name",
        "kind",
        "outside_degree",
        "max_degree",
        "points",
        "polyline",
        "arc",
        "bezier",
    ];
    let keys = given.object(&allowed, SIDE)?;
    let curve = curve(given, &keys)?;
    let spacing = keys.get("spacing").map_or(Ok(Spacing::Uniform), spacing)?;
    let (described, constraint) = (described(&keys)?, side_constraint(&keys)?);
    let intervals = intervals(given, &keys, &spacing, default_size)?;
    Ok((Side { curve, intervals, spacing, ..described }, constraint))
}

/// The one side of a ring of points.
pub(super) fn ring_side(
    given: &Value<'_>,
    own: Vec<DVec2>,
) -> Result<(Side, SideConstraint), DomainJsonError> {
    let keys = given.object(&["name", "kind", "outside_degree", "max_degree"], RING_SIDE)?;
    let Side { name, kind, .. } = described(&keys)?;
    Ok((Side { name, kind, ..Side::points(own) }, side_constraint(&keys)?))
}

/// A side with what says nothing of its points.
fn described(keys: &Object<'_>) -> Result<Side, DomainJsonError> {
    let kind = keys.get("kind").map(kind).transpose()?;
    Ok(Side { name: name(keys)?, kind, ..Side::count(1) })
}

/// The value of "name".
pub(super) fn name(keys: &Object<'_>) -> Result<Option<String>, DomainJsonError> {
    keys.get("name").map(|name| name.text("a text in double quotes")).transpose()
}

fn kind(given: &Value<'_>) -> Result<LineKind, DomainJsonError> {
    const KINDS: &str = "\"open\", \"land\" or \"island\"";
    match given.text(KINDS)?.as_str() {
        "open" => Ok(LineKind::Open),
        "land" => Ok(LineKind::Land),
        "island" => Ok(LineKind::Island),
        other => Err(given.error(format!("found the text {other:?}, expected {KINDS}"))),
    }
}

fn intervals(
    given: &Value<'_>,
    keys: &Object<'_>,
    spacing: &Spacing,
    default_size: Option<f64>,
) -> Result<Intervals, DomainJsonError> {
    if keys.get("points").is_some() {
        if let Some(key) =
            ["intervals", "size", "spacing"].into_iter().find(|key| keys.get(key).is_some())
        {
            let message = format!("\"points\" say how many intervals there are; drop {key:?}");
            return Err(given.error(message));
        }
        return Ok(Intervals::Points);
    }
    let count = keys.get("intervals").map(|n| n.whole("a whole number, at least 1")).transpose()?;
    let size = keys.get("size").map(|size| size.number(ABOVE_0)).transpose()?;
    Ok(match (count, size, spacing) {
        (Some(_), Some(_), _) => {
            return Err(given.error("give either \"intervals\" or \"size\", not both"));
        }
        (None, Some(_), Spacing::Parameters(_)) => {
            let message = "\"parameters\" say how many intervals there are; drop \"size\"";
            return Err(given.error(message));
        }
        (Some(count), None, _) => Intervals::Count(count),
        (None, Some(size), _) => Intervals::Size(size),
        (None, None, Spacing::Parameters(given)) => Intervals::Count(given.len() as u64 + 1),
        (None, None, _) => Intervals::Size(default_size.ok_or_else(|| {
            given
                .error("give \"intervals\" (a whole number) or \"size\" (a target interval length)")
        })?),
    })
}

fn curve(given: &Value<'_>, keys: &Object<'_>) -> Result<Curve, DomainJsonError> {
    let mut curves = ["points", "polyline", "arc", "bezier"]
        .into_iter()
        .filter_map(|key| Some((key, keys.get(key)?)));
    let Some((key, value)) = curves.next() else { return Ok(Curve::Line) };
    if let Some((other, _)) = curves.next() {
        return Err(given.error(format!("a side runs one way: give either {key:?} or {other:?}")));
    }
    Ok(match key {
        "arc" => Curve::Arc(arc(value)?),
        "bezier" => match points(value)?[..] {
            [first, second] => Curve::Cubic([first, second]),
            ref found => {
                let count = found.len();
                return Err(value.error(format!("found {count} points, expected {BEZIER}")));
            }
        },
        _ => Curve::Polyline(points(value)?),
    })
}

fn arc(given: &Value<'_>) -> Result<Arc, DomainJsonError> {
    let keys = given.object(&["through", "center", "clockwise"], ARC)?;
    let clockwise = keys.get("clockwise");
    match (keys.get("through"), keys.get("center")) {
        (Some(through), None) => match clockwise {
            None => Ok(Arc::Through(pair(through)?)),
            Some(clockwise) => {
                Err(clockwise.error("\"through\" says which way the arc runs; drop \"clockwise\""))
            }
        },
        (None, Some(center)) => {
            let is_clockwise = clockwise.map(|value| value.truth("true or false")).transpose()?;
            Ok(Arc::Center { center: pair(center)?, is_clockwise: is_clockwise.unwrap_or(false) })
        }
        _ => Err(given.error(format!("give exactly one of \"through\" and \"center\": {ARC}"))),
    }
}
