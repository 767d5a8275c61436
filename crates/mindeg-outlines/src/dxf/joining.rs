//! Finds the ends of a drawing's lines that meet.

use glam::DVec2;

use super::super::loops::Link;
use super::super::nesting::box_around;
use super::super::vertices::Vertices;
use super::entities::Entity;
use crate::error::OutlineError;

/// How far apart ends may be that meet, as a share of the drawing's size.
const TOLERANCE: f64 = 1e-6;

/// The lines of the entities, between points.
pub(super) fn links(entities: &[Entity]) -> Result<(Vec<DVec2>, Vec<Link>), OutlineError> {
    let ends: Vec<DVec2> =
        entities.iter().flat_map(|entity| entity.points.iter().copied()).collect();
    let Some((points, indices)) = merged(&ends) else {
        return Err(OutlineError::place(
            "the section ENTITIES",
            "a coordinate is too large for a 64-bit float",
        ));
    };
    let mut links = Vec::new();
    let mut first = 0;
    for entity in entities {
        let count = entity.points.len();
        let last = if entity.is_closed { count } else { count.saturating_sub(1) };
        for index in 0..last {
            let ends = [index, (index + 1) % count].map(|point| indices[first + point]);
            // A line as short as the tolerance would be a loop of its own.
            if ends[0] != ends[1] || count == 1 {
                let (curve, side) = (entity.curve(index), entity.layer.clone());
                links.push(Link { ends, curve, side, part_of: 0 });
            }
        }
        first += count;
    }
    Ok((points, links))
}

/// The points without those near an earlier one, and for each point as given its index among them;
/// `None` if a point is not finite.
fn merged(points: &[DVec2]) -> Option<(Vec<DVec2>, Vec<u32>)> {
    let bounds = box_around(points);
    let tolerance = TOLERANCE * bounds.size().max_element();
    if !tolerance.is_finite() || points.iter().any(|point| !point.is_finite()) {
        return None;
    }
    let mut vertices = Vertices::new(bounds.min, tolerance);
    let indices = points.iter().map(|&point| vertices.index_near(point)).collect();
    Some((vertices.points, indices))
}
