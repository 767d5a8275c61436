//! The sizes of a mesh with interior points, and where the boundary contradicts those asked for.

use crate::condition::placed;
use crate::names::listed;
use crate::numbers::{coordinate, number, percent};
use mindeg::interior::{CoarseSide, InteriorMesh, InteriorReport};
use mindeg::{Domain, Projection, Size};
use mindeg_mesh::Bounds;

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
pub fn coarse_sides(found: &InteriorMesh, projection: Option<&Projection>) -> Option<String> {
    if let Some((problem, least)) = too_coarse(found, projection) {
        return Some(format!(
            "warning: {problem}. Give these sides more intervals, or all of them --size {least}; or add \
             --condition, which divides edges down to --min-size."
        ));
    }
    (found.report.interior_points == 0).then(|| {
        "No point fits inside: the boundary is never divided. --size S divides its sides into intervals of length S."
            .to_owned()
    })
}

/// The sizes between points of which none is on a domain, if there are such: most often they have other coordinates.
///
/// ```
/// use mindeg_answers::sizes::sizes_beside;
/// use mindeg::{Domain, Size, SizeBetween};
///
/// let square = Domain::from_json(r#"{"rectangle": {"width": 4, "height": 4}, "size": 1}"#)?;
/// let grid = |x: f64| SizeBetween::grid([x, 0.0].into(), [1.0, 1.0].into(), 2, &[0.1; 4]).map(Size::Between);
/// let said = |x| sizes_beside(std::slice::from_ref(&square), &grid(x).into_iter().collect::<Vec<_>>());
/// assert_eq!(said(3.0), None);
/// assert!(said(5.0).is_some_and(|words| words.contains("x from 5 to 6 and y from 0 to 1")));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn sizes_beside(domains: &[Domain], sizes: &[Size]) -> Option<String> {
    let corners = |domain: &Domain| {
        let bounds = domain.placement().bounds();
        [bounds.min, bounds.max]
    };
    let whole = Bounds::of(domains.iter().flat_map(corners))?;
    let of_points = |size: &Size| match size {
        Size::Between(between) => Bounds::of(between.points.iter().map(|point| point.at)),
        _ => None,
    };
    let is_beside = |own: &Bounds| own.max.cmplt(whole.min).any() || own.min.cmpgt(whole.max).any();
    let beside = sizes.iter().filter_map(of_points).find(is_beside)?;
    let range = |bounds: Bounds| {
        let [low, high] = [bounds.min, bounds.max].map(|at| at.to_array().map(coordinate));
        format!("x from {} to {} and y from {} to {}", low[0], high[0], low[1], high[1])
    };
    Some(format!(
        "warning: a grid or background mesh of sizes lies beside the domain: it has {}, the domain {}. Give both in the same coordinates.",
        range(beside),
        range(whole)
    ))
}

/// The sides and lines that contradict the sizes asked for, in words, and a size that would do for all.
#[must_use]
pub fn too_coarse(
    found: &InteriorMesh,
    projection: Option<&Projection>,
) -> Option<(String, String)> {
    let place = |side: &CoarseSide| {
        let [length, size] = [side.length, side.size].map(number);
        let intervals = |count: u64| match count {
            1 => "1 interval".to_owned(),
            count => format!("{count} intervals"),
        };
        format!(
            "{} has an edge {length} long at {} where the size asked for is {size}, which takes {} on it, not {}",
            side.name,
            placed(projection, side.at),
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
