//! From the keys of a JSON text to the description of a domain.
//!
//! Limits: only what can be told from the text is checked here: keys, kinds of values, and keys
//! that exclude each other. [`Domain::constrained`](crate::Domain::constrained) checks the rest.

use glam::DVec2;

use super::error::DomainJsonError;
use super::interior::interior;
use super::value::{Object, Value};
use crate::constraints::{Constraints, ExternalDegree, SideConstraint, VertexConstraint};
use crate::interior::Interior;
use crate::outline::{Outline, Ring};
use crate::rectangle::Rectangle;
use crate::side::{Intervals, Side};
use crate::spacing::Spacing;

/// A domain as its JSON describes it.
pub(super) struct Description {
    pub(super) name: Option<String>,
    pub(super) outline: Outline,
    pub(super) sides: Vec<Side>,
    pub(super) holes: Vec<Ring>,
    pub(super) constraints: Constraints,
    pub(super) interior: Option<Interior>,
}

const DOMAIN: &str = "an object with \"rectangle\" or \"polygon\", and \"sides\" or \"size\"; \
                      optional: \"name\", \"holes\", \"vertices\"";
const RECTANGLE: &str =
    "{\"width\": w, \"height\": h}; optional: \"origin\": [x, y], \"rotation\": degrees";
const POLYGON: &str = "{\"corners\": [[x, y], …]}";
const HOLES: &str = "a list of {\"corners\": [[x, y], …], \"sides\": […]}";
const HOLE: &str = "an object such as {\"corners\": [[x, y], …], \"sides\": [{\"intervals\": 3}, …]}; \
                    optional: \"size\"";
pub(super) const CORNERS: &str = "a list of [x, y] pairs of numbers";
const PAIR: &str = "a pair [x, y] of numbers";
pub(super) const ABOVE_0: &str = "a number above 0";
const SIDES: &str = "a list with one object for each side, such as {\"intervals\": 3}";
const SIDE: &str = "an object such as {\"intervals\": 3} or {\"size\": 0.5}; optional: \"spacing\", \
                    \"name\", \"outside_degree\", \"max_degree\"";
const SPACING: &str = "\"uniform\", {\"geometric\": {\"ratio\": r}}, {\"bump\": {\"ratio\": c}}, \
                       {\"beta\": {\"beta\": b}}, {\"first_length\": h}, {\"last_length\": h} or \
                       {\"parameters\": [t1, t2, …]}";
const EXTERNAL_DEGREE: &str = "a whole number, or for a side a list of one whole number for each \
                               vertex from its first corner to its last";
const DEGREE_LIMIT: &str = "a whole number, at least 2";
const VERTICES: &str = "a list of {\"vertex\": v, \"outside_degree\": d, \"max_degree\": D}";
const VERTEX: &str = "an object such as {\"vertex\": 7, \"max_degree\": 6} or {\"vertex\": 7, \"outside_degree\": 3}";

/// Reads the whole text.
pub(super) fn description(text: &Value<'_>) -> Result<Description, DomainJsonError> {
    if let Some(format) = text.other_format() {
        return Err(text.error(format!("this looks like {format}; a domain is {DOMAIN}")));
    }
    if text.is_list() {
        return Err(text.error(format!(
            "found a list; a domain is {DOMAIN}; the corners of a polygon go into \"polygon\": \
             {POLYGON}"
        )));
    }
    let allowed =
        ["name", "rectangle", "polygon", "holes", "size", "sides", "vertices", "interior"];
    let keys = text.object(&allowed, DOMAIN)?;
    let name = name(&keys)?;
    let outline = outline(text, &keys)?;
    let side_count = match &outline {
        Outline::Rectangle(_) => 4,
        Outline::Polygon(corners) => corners.len(),
    };
    let size = keys.get("size").map(|size| size.number(ABOVE_0)).transpose()?;
    let missing = || {
        text.error(
            "the sides are missing; give \"sides\": [{\"intervals\": n}, …], or a target interval \
             length \"size\" for all",
        )
    };
    let (sides, mut of_sides) = sides(&keys, side_count, size)?.ok_or_else(missing)?;
    let mut holes = Vec::new();
    if let Some(given) = keys.get("holes") {
        for given in given.items(HOLES)? {
            let (hole, of_hole) = hole(&given, size)?;
            holes.push(hole);
            of_sides.extend(of_hole);
        }
    }
    let vertices = match keys.get("vertices") {
        Some(given) => given.items(VERTICES)?.iter().map(vertex).collect::<Result<_, _>>()?,
        None => Vec::new(),
    };
    let interior = keys.get("interior").map(interior).transpose()?;
    let constraints = Constraints { sides: of_sides, vertices };
    Ok(Description { name, outline, sides, holes, constraints, interior })
}

/// The sides of a ring, if they are given or a size says it all.
fn sides(
    keys: &Object<'_>,
    count: usize,
    size: Option<f64>,
) -> Result<Option<(Vec<Side>, Vec<SideConstraint>)>, DomainJsonError> {
    let sides = match (keys.get("sides"), size) {
        (Some(given), _) => {
            let given = given.items(SIDES)?;
            given.iter().map(|given| side(given, size)).collect::<Result<Vec<_>, _>>()?
        }
        (None, Some(size)) => vec![(Side::size(size), SideConstraint::default()); count],
        (None, None) => return Ok(None),
    };
    Ok(Some(sides.into_iter().unzip()))
}

fn hole(
    given: &Value<'_>,
    default_size: Option<f64>,
) -> Result<(Ring, Vec<SideConstraint>), DomainJsonError> {
    let keys = given.object(&["corners", "sides", "size"], HOLE)?;
    let corners = corners(keys.need("corners")?)?;
    let size = keys.get("size").map(|size| size.number(ABOVE_0)).transpose()?.or(default_size);
    let missing = || {
        given.error(
            "the sides are missing; give \"sides\": [{\"intervals\": n}, …], or a target interval \
             length \"size\" for all",
        )
    };
    let (sides, of_sides) = sides(&keys, corners.len(), size)?.ok_or_else(missing)?;
    Ok((Ring { corners, sides }, of_sides))
}

fn corners(given: &Value<'_>) -> Result<Vec<DVec2>, DomainJsonError> {
    given.items(CORNERS)?.iter().map(pair).collect()
}

fn name(keys: &Object<'_>) -> Result<Option<String>, DomainJsonError> {
    keys.get("name").map(|name| name.text("a text in double quotes")).transpose()
}

fn outline(text: &Value<'_>, keys: &Object<'_>) -> Result<Outline, DomainJsonError> {
    match (keys.get("rectangle"), keys.get("polygon")) {
        (Some(given), None) => Ok(Outline::Rectangle(rectangle(given)?)),
        (None, Some(given)) => {
            Ok(Outline::Polygon(corners(given.object(&["corners"], POLYGON)?.need("corners")?)?))
        }
        (None, None) => Err(text.error(
            "the outline is missing; give \"rectangle\": {\"width\": w, \"height\": h} or \
             \"polygon\": {\"corners\": [[x, y], …]}",
        )),
        (Some(_), Some(given)) => {
            Err(given.error("a domain is either a \"rectangle\" or a \"polygon\"; drop one"))
        }
    }
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

pub(super) fn pair(given: &Value<'_>) -> Result<DVec2, DomainJsonError> {
    match &given.items(PAIR)?[..] {
        [x, y] => Ok(DVec2::new(x.number("a number")?, y.number("a number")?)),
        items => {
            let values = if items.len() == 1 { "value" } else { "values" };
            Err(given.error(format!("found a list of {} {values}, expected {PAIR}", items.len())))
        }
    }
}

fn side(
    given: &Value<'_>,
    default_size: Option<f64>,
) -> Result<(Side, SideConstraint), DomainJsonError> {
    let allowed = ["intervals", "size", "spacing", "name", "outside_degree", "max_degree"];
    let keys = given.object(&allowed, SIDE)?;
    let spacing = keys.get("spacing").map_or(Ok(Spacing::Uniform), spacing)?;
    let count = keys.get("intervals").map(|n| n.whole("a whole number, at least 1")).transpose()?;
    let size = keys.get("size").map(|size| size.number(ABOVE_0)).transpose()?;
    let external_degree = keys.get("outside_degree").map(external_degree).transpose()?;
    let constraint = SideConstraint {
        external_degree: external_degree.unwrap_or_default(),
        degree_limit: degree_limit(&keys)?,
    };
    let name = name(&keys)?;
    let intervals = match (count, size, &spacing) {
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
    };
    Ok((Side { intervals, spacing, name }, constraint))
}

fn external_degree(given: &Value<'_>) -> Result<ExternalDegree, DomainJsonError> {
    if !given.is_list() {
        return given.whole(EXTERNAL_DEGREE).map(ExternalDegree::Inside);
    }
    let degrees = given.items(EXTERNAL_DEGREE)?;
    let degrees = degrees.iter().map(|degree| degree.whole("a whole number"));
    degrees.collect::<Result<_, _>>().map(ExternalDegree::Each)
}

fn degree_limit(keys: &Object<'_>) -> Result<Option<u32>, DomainJsonError> {
    keys.get("max_degree").map(|limit| limit.whole(DEGREE_LIMIT)).transpose()
}

pub(super) fn spacing(given: &Value<'_>) -> Result<Spacing, DomainJsonError> {
    if !given.is_object() {
        return match given.text(SPACING)?.as_str() {
            "uniform" => Ok(Spacing::Uniform),
            law => Err(given.error(format!("found the text {law:?}, expected {SPACING}"))),
        };
    }
    let laws = ["geometric", "bump", "beta", "first_length", "last_length", "parameters"];
    let keys = given.object(&laws, SPACING)?;
    let mut named = laws.into_iter().filter_map(|law| Some((law, keys.get(law)?)));
    let (Some((law, value)), None) = (named.next(), named.next()) else {
        return Err(given.error(format!("give exactly one spacing law: {SPACING}")));
    };
    let parameter = |key, wanted| value.object(&[key], wanted)?.need(key)?.number("a number");
    Ok(match law {
        "geometric" => Spacing::Geometric { ratio: parameter("ratio", "{\"ratio\": r}")? },
        "bump" => Spacing::Bump { ratio: parameter("ratio", "{\"ratio\": c}")? },
        "beta" => Spacing::Beta { beta: parameter("beta", "{\"beta\": b}")? },
        "first_length" => Spacing::FirstLength(value.number(ABOVE_0)?),
        "last_length" => Spacing::LastLength(value.number(ABOVE_0)?),
        _ => {
            let list = value.items("a list of numbers above 0 and below 1")?;
            Spacing::Parameters(
                list.iter().map(|t| t.number("a number")).collect::<Result<_, _>>()?,
            )
        }
    })
}

fn vertex(given: &Value<'_>) -> Result<VertexConstraint, DomainJsonError> {
    let keys = given.object(&["vertex", "outside_degree", "max_degree"], VERTEX)?;
    let vertex = keys.need("vertex")?.whole("a whole number, the index of a vertex in the mesh")?;
    let external_degree =
        keys.get("outside_degree").map(|degree| degree.whole("a whole number")).transpose()?;
    let degree_limit = degree_limit(&keys)?;
    if external_degree.is_none() && degree_limit.is_none() {
        return Err(given.error(
            "give \"outside_degree\" (edges on the other side of the boundary) or \"max_degree\" \
             (a degree limit), or drop the vertex",
        ));
    }
    Ok(VertexConstraint { vertex, external_degree: external_degree.unwrap_or(0), degree_limit })
}
