//! The sizes of a mesh with interior points, and where the boundary contradicts those asked for.

use crate::names::listed;
use crate::numbers::{coordinate, number, percent};
use mindeg::interior::{CoarseSide, InteriorMesh, InteriorReport};

/// The edges beside the sizes wanted, in a sentence; none without interior points.
#[must_use]
pub fn sizes(report: &InteriorReport) -> Option<String> {
    let sizes = report.sizes.as_ref().filter(|_| report.interior_points > 0)?;
    let near = percent(sizes.near);
    let [least, greatest] = [sizes.least, sizes.greatest].map(number);
    Some(format!(
        "{near} of the edges inside are 0.7 to 1.4 times as long as wanted, all {least} to {greatest} times."
    ))
}

/// The sides and lines that contradict the sizes asked for, and the way out, if there are any; or the reason why there
/// are no interior points.
#[must_use]
pub fn coarse_sides(found: &InteriorMesh) -> Option<String> {
    if let Some((problem, least)) = too_coarse(found) {
        return Some(format!(
            "warning: {problem}. Give these sides more intervals, or all of them --size {least}."
        ));
    }
    (found.report.interior_points == 0).then(|| {
        "No point fits inside: the boundary is never divided. --size S divides its sides into intervals of length S."
            .to_owned()
    })
}

/// The sides and lines that contradict the sizes asked for, in words, and a size that would do for all.
#[must_use]
pub fn too_coarse(found: &InteriorMesh) -> Option<(String, String)> {
    let place = |side: &CoarseSide| {
        let [x, y] = side.at.to_array().map(coordinate);
        let [length, size] = [side.length, side.size].map(number);
        let intervals = |count: u64| match count {
            1 => "1 interval".to_owned(),
            count => format!("{count} intervals"),
        };
        format!(
            "{} has an edge {length} long at ({x}, {y}) where the size asked for is {size}, which takes {} on it, not {}",
            side.name,
            intervals(side.wanted_intervals),
            side.intervals,
        )
    };
    if found.coarse_sides.is_empty() {
        return None;
    }
    let places = listed(found.coarse_sides.iter().map(place), "; ");
    let least = found.coarse_sides.iter().map(|side| side.size).fold(f64::INFINITY, f64::min);
    let problem = format!(
        "the boundary and lines are never divided, and too coarse for the sizes asked for: {places}"
    );
    Some((problem, number(least)))
}
