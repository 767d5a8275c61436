//! Which ends of a drawing's lines meet.

use glam::DVec2;

use super::super::loops::{self, Link};
use super::super::outline::{Ring, key};
use super::super::text::shown;
use super::entities::Entity;
use crate::error::ReadError;

/// How far apart ends may be that meet, as a share of the drawing's size.
const TOLERANCE: f64 = 1e-6;

/// The rings that the entities form, and a note on open lines.
pub(super) fn rings(entities: Vec<Entity>) -> Result<(Vec<Ring>, Option<String>), ReadError> {
    let ends: Vec<DVec2> =
        entities.iter().flat_map(|entity| entity.points.iter().copied()).collect();
    let Some((points, indices)) = merged(&ends) else {
        return Err(ReadError::place(
            "the section ENTITIES",
            "a coordinate is too large for a 64-bit float",
        ));
    };
    let mut links = Vec::new();
    let mut first = 0;
    for entity in &entities {
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
    if links.is_empty() {
        return Ok((Vec::new(), None));
    }
    loops::rings(&points, &links, |point| format!("the point {}", shown(points[point as usize])))
}

/// The points without those near an earlier one, and for each point as given its index among them;
/// none if a point is not finite.
///
/// Points are sorted by x, and each joins the first point kept within the tolerance. O(n log n) but
/// for many points of one x within the tolerance.
fn merged(points: &[DVec2]) -> Option<(Vec<DVec2>, Vec<u32>)> {
    let start = points.first().copied().unwrap_or_default();
    let (min, max) = points.iter().fold((start, start), |(min, max), &p| (min.min(p), max.max(p)));
    let tolerance = TOLERANCE * (max - min).max_element();
    if !tolerance.is_finite() || points.iter().any(|point| !point.is_finite()) {
        return None;
    }
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    let cell = |point: DVec2| {
        // Cells twice as large as the tolerance, from the lowest point.
        let size = if tolerance > 0.0 { 2.0 * tolerance } else { 1.0 };
        ((point - min) / size).floor()
    };
    let cell_of = |index: u32| key(cell(points[index as usize]));
    order.sort_unstable_by_key(|&index| (cell_of(index), index));
    let in_cell = |wanted: DVec2| {
        let wanted = key(wanted);
        let from = order.partition_point(|&index| cell_of(index) < wanted);
        order[from..].iter().copied().take_while(move |&index| cell_of(index) == wanted)
    };
    let mut indices = vec![u32::MAX; points.len()];
    let mut kept = Vec::new();
    for (at, &point) in points.iter().enumerate() {
        if indices[at] != u32::MAX {
            continue;
        }
        let index = kept.len() as u32;
        kept.push(point);
        let cell = cell(point);
        for dx in [-1.0, 0.0, 1.0] {
            for dy in [-1.0, 0.0, 1.0] {
                for other in in_cell(cell + DVec2::new(dx, dy)) {
                    let near = (points[other as usize] - point).abs().max_element() <= tolerance;
                    if near && indices[other as usize] == u32::MAX {
                        indices[other as usize] = index;
                    }
                }
            }
        }
    }
    Some((kept, indices))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_within_the_tolerance_are_one() {
        let points = [
            [0.0, 0.0],
            [100.0, 0.0],
            [100.00005, 0.00009],
            [0.0, 1.0],
            [0.00005, 0.0],
            [50.0, 0.0002],
        ];
        let (kept, indices) = merged(&points.map(DVec2::from)).unwrap();
        assert_eq!(indices, [0, 1, 1, 2, 0, 3]);
        assert_eq!(kept.len(), 4);
        assert_eq!(merged(&[DVec2::ONE, DVec2::ONE]).unwrap().1, [0, 0]);
        assert!(merged(&[]).unwrap().1.is_empty());
        assert_eq!(merged(&[DVec2::new(-1e308, 0.0), DVec2::new(1e308, 0.0)]), None);
    }
}
