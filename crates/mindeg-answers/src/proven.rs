//! Degree limits that no mesh keeps, with their proofs.

use crate::condition::placed;
use crate::names::listed;
use crate::numbers::percent;
use mindeg::Projection;
use mindeg::interior::{CertifiedVertex, InteriorReport, TogetherBound};
use serde::Serialize;

/// Vertices on the boundary and on lines that are above their degree limits by as many edges, in all, as in every mesh with such angles.
#[derive(Clone, Debug, Serialize)]
pub struct TogetherAnswer {
    vertices: Vec<u32>,
    /// Where the first one is.
    position: [f64; 2],
    /// So many edges more than their limits they have in all, at least.
    more: u32,
    /// The share of the angles of this mesh that other meshes must have there for that.
    share: f64,
    /// These angles.
    angles: Vec<AngleThere>,
}

/// An angle that all triangles at a vertex have.
#[derive(Clone, Debug, Serialize)]
struct AngleThere {
    vertex: u32,
    min_angle: f64,
}

impl From<&TogetherBound> for TogetherAnswer {
    fn from(bound: &TogetherBound) -> Self {
        let angles = bound.angles.iter();
        let there = angles.map(|&(vertex, min_angle)| AngleThere { vertex, min_angle });
        let (vertices, position) = (bound.vertices.clone(), bound.at.to_array());
        let (more, share) = (bound.more, bound.share);
        Self { vertices, position, more, share, angles: there.collect() }
    }
}

/// The groups of vertices that no mesh brings nearer to their limits at such angles, if there are any.
pub(crate) fn together(report: &InteriorReport, projection: Option<&Projection>) -> Option<String> {
    let place = |bound: &TogetherBound| {
        let at = placed(projection, bound.at);
        let names: Vec<String> = bound.vertices.iter().map(u32::to_string).collect();
        let vertices = if names.len() == 1 { "vertex" } else { "vertices" };
        let (names, share) = (names.join(" and "), percent(bound.share));
        format!("{} at {vertices} {names} at {at} (with {share})", bound.more)
    };
    if report.together.is_empty() {
        return None;
    }
    let places = listed(report.together.iter().map(place), ", ");
    Some(format!(
        "No mesh with so much of the angles there has fewer edges above the limits: {places}"
    ))
}

/// The vertices whose degree limit no mesh keeps, if there are any.
pub(crate) fn certified(
    report: &InteriorReport,
    projection: Option<&Projection>,
) -> Option<String> {
    let place = |certified: &CertifiedVertex| {
        let CertifiedVertex { vertex, at, edges, degree_limit, least_degree } = certified;
        let at = placed(projection, *at);
        format!(
            "vertex {vertex} at {at}, where {} edges meet that stay, has {least_degree} or more (limit \
             {degree_limit})",
            edges.len()
        )
    };
    let limits = match report.certified.len() {
        0 => return None,
        1 => "the degree limit of 1 vertex".to_owned(),
        count => format!("the degree limits of {count} vertices"),
    };
    Some(format!("No mesh keeps {limits}: {}", listed(report.certified.iter().map(place), ", ")))
}
