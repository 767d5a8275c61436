//! From the keys of a JSON text to the description of a domain.
//!
//! Limits: only what can be told from the text is checked here: keys, kinds of values, and keys
//! that exclude each other. [`build`](crate::DomainBuilder::build) checks the rest.

use super::constraint::vertex;
use super::error::DomainJsonError;
use super::interior::interior;
use super::ring::{OWN_POINTS, POLYGON, hole, outline};
use super::side::name;
use super::value::{ABOVE_0, Value};
use crate::build::DomainBuilder;
use crate::constraints::Constraints;
use crate::domain::Domain;
use crate::interior::Interior;

const DOMAIN: &str = "an object with \"rectangle\", \"polygon\" or \"ring\", and \"sides\" or \"size\"; \
                      optional: \"name\", \"holes\", \"vertices\"";
const HOLES: &str = "a list of {\"corners\": [[x, y], …], \"sides\": […]}";
const VERTICES: &str = "a list of {\"vertex\": v, \"outside_degree\": d, \"max_degree\": D}";

/// Reads the whole text: a domain to build, and its name.
pub(super) fn description(
    text: &Value<'_>,
) -> Result<(DomainBuilder, Option<String>, Option<Interior>), DomainJsonError> {
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
        ["name", "rectangle", "polygon", "ring", "holes", "size", "sides", "vertices", "interior"];
    let keys = text.object(&allowed, DOMAIN)?;
    let name = name(&keys)?;
    let size = keys.get("size").map(|size| size.number(ABOVE_0)).transpose()?;
    if let (Some(size), Some(_), None) = (keys.get("size"), keys.get("ring"), keys.get("holes")) {
        return Err(size.error(OWN_POINTS));
    }
    let (outline, (sides, mut of_sides)) = outline(text, &keys, size)?;
    let mut builder = Domain::builder(outline, sides);
    if let Some(given) = keys.get("holes") {
        for given in given.items(HOLES)? {
            let (hole, of_hole) = hole(&given, size)?;
            builder = builder.hole(hole);
            of_sides.extend(of_hole);
        }
    }
    let vertices = match keys.get("vertices") {
        Some(given) => given.items(VERTICES)?.iter().map(vertex).collect::<Result<_, _>>()?,
        None => Vec::new(),
    };
    let interior = keys.get("interior").map(interior).transpose()?;
    Ok((builder.constraints(Constraints { sides: of_sides, vertices }), name, interior))
}
