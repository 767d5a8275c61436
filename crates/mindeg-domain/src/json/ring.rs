//! Rings: the outline and the holes, with their sides.

use glam::DVec2;

use super::error::DomainJsonError;
use super::point::{pair, points};
use super::side::{ring_side, side};
use super::value::{ABOVE_0, Object, Value};
use crate::constraints::SideConstraint;
use crate::outline::{Outline, Ring};
use crate::rectangle::Rectangle;
use crate::side::Side;

const RECTANGLE: &str =
    "{\"width\": w, \"height\": h}; optional: \"origin\": [x, y], \"rotation\": degrees";
pub(super) const POLYGON: &str = "{\"corners\": [[x, y], …]}";
const HOLE: &str = "{\"corners\": [[x, y], …], \"sides\": [{\"intervals\": 3}, …]} or {\"ring\": [[x, y], \
                    …]}; optional: \"size\"";
const SIDES: &str = "a list with one object for each side, such as {\"intervals\": 3}";

/// The sides of a ring, and their constraints.
pub(super) type Sides = (Vec<Side>, Vec<SideConstraint>);

/// The outline of a domain and its sides, with the size for all.
pub(super) fn outline(
    text: &Value<'_>,
    keys: &Object<'_>,
    size: Option<f64>,
) -> Result<(Outline, Sides), DomainJsonError> {
    let mut outlines =
        ["rectangle", "polygon", "ring"].into_iter().filter_map(|key| Some((key, keys.get(key)?)));
    let Some((key, given)) = outlines.next() else {
        return Err(text.error(format!(
            "the outline is missing; give \"rectangle\": {{\"width\": w, \"height\": h}}, \"polygon\": \
             {POLYGON} or \"ring\": [[x, y], …]"
        )));
    };
    if let Some((other, given)) = outlines.next() {
        return Err(given.error(format!("a domain has one outline; drop {key:?} or {other:?}")));
    }
    Ok(match key {
        "rectangle" => {
            let rectangle = rectangle(given)?;
            (Outline::Rectangle(rectangle), sides(text, keys, 4, size)?)
        }
        "polygon" => {
            let corners = points(given.object(&["corners"], POLYGON)?.need("corners")?)?;
            let sides = sides(text, keys, corners.len(), size)?;
            (Outline::Polygon(corners), sides)
        }
        _ => {
            let (corners, sides) = ring(given, keys)?;
            (Outline::Polygon(corners), sides)
        }
    })
}

pub(super) fn hole(
    given: &Value<'_>,
    default_size: Option<f64>,
) -> Result<(Ring, Vec<SideConstraint>), DomainJsonError> {
    let keys = given.object(&["corners", "ring", "sides", "size"], HOLE)?;
    let (corners, (sides, constraints)) = match (keys.get("corners"), keys.get("ring")) {
        (Some(corners), None) => {
            let corners = points(corners)?;
            let size = keys.get("size").map(|size| size.number(ABOVE_0)).transpose()?;
            let sides = sides(given, &keys, corners.len(), size.or(default_size))?;
            (corners, sides)
        }
        (None, Some(points)) => match keys.get("size") {
            Some(size) => return Err(size.error(OWN_POINTS)),
            None => ring(points, &keys)?,
        },
        (Some(_), Some(_)) => {
            return Err(given.error("a hole has either \"corners\" or a \"ring\"; drop one"));
        }
        (None, None) => {
            let message = format!("the key \"corners\" or \"ring\" is missing; expected {HOLE}");
            return Err(given.error(message));
        }
    };
    Ok((Ring { corners, sides }, constraints))
}

/// What a size has no say in.
pub(super) const OWN_POINTS: &str = "a \"ring\" has its own points; drop \"size\"";

/// A ring of points: its first point, and the one side.
fn ring(given: &Value<'_>, keys: &Object<'_>) -> Result<(Vec<DVec2>, Sides), DomainJsonError> {
    let mut own = points(given)?;
    if own.len() < 3 {
        let count = own.len();
        let points = if count == 1 { "point" } else { "points" };
        return Err(given.error(format!("found {count} {points}; a ring needs at least 3")));
    }
    let first = own.remove(0);
    let (side, constraint) = match keys.get("sides") {
        None => (Side::points(own), SideConstraint::default()),
        Some(sides) => match &sides.items(SIDES)?[..] {
            [side] => ring_side(side, own)?,
            found => {
                let count = found.len();
                return Err(sides.error(format!(
                    "found {count} sides; a \"ring\" is one side; for several, give corners and the \
                     \"points\" of each side"
                )));
            }
        },
    };
    Ok((vec![first], (vec![side], vec![constraint])))
}

/// The sides of a ring with corners: as given, or as a size makes them.
fn sides(
    ring: &Value<'_>,
    keys: &Object<'_>,
    count: usize,
    size: Option<f64>,
) -> Result<Sides, DomainJsonError> {
    let sides = match (keys.get("sides"), size) {
        (Some(given), _) => {
            let given = given.items(SIDES)?;
            given.iter().map(|given| side(given, size)).collect::<Result<Vec<_>, _>>()?
        }
        (None, Some(size)) => vec![(Side::size(size), SideConstraint::default()); count],
        (None, None) => {
            return Err(ring.error(
                "the sides are missing; give \"sides\": [{\"intervals\": n}, …], or a target \
                 interval length \"size\" for all",
            ));
        }
    };
    Ok(sides.into_iter().unzip())
}

fn rectangle(given: &Value<'_>) -> Result<Rectangle, DomainJsonError> {
    let keys = given.object(&["width", "height", "origin", "rotation"], RECTANGLE)?;
    Ok(Rectangle {
        width: keys.need("width")?.number(ABOVE_0)?,
        height: keys.need("height")?.number(ABOVE_0)?,
        origin: keys.get("origin").map_or(Ok(DVec2::ZERO), pair)?,
        rotation: keys.get("rotation").map_or(Ok(0.0), |r| r.number("a number, in degrees"))?,
    })
}
