//! Constraints on degrees, of sides and of single vertices.

use super::error::DomainJsonError;
use super::value::{Object, Value};
use crate::constraints::{ExternalDegree, SideConstraint, VertexConstraint};

const EXTERNAL_DEGREE: &str = "a whole number, or for a side a list of one whole number for each \
                               vertex from its first corner to its last";
const DEGREE_LIMIT: &str = "a whole number, at least 2";
const VERTEX: &str = "an object such as {\"vertex\": 7, \"max_degree\": 6} or {\"vertex\": 7, \"outside_degree\": 3}";

/// The constraint among the keys of a side.
pub(super) fn side_constraint(keys: &Object<'_>) -> Result<SideConstraint, DomainJsonError> {
    let external_degree = keys.get("outside_degree").map(external_degree).transpose()?;
    Ok(SideConstraint {
        external_degree: external_degree.unwrap_or_default(),
        degree_limit: degree_limit(keys)?,
    })
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

pub(super) fn vertex(given: &Value<'_>) -> Result<VertexConstraint, DomainJsonError> {
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
