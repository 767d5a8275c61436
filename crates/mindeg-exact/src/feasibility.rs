//! Whether some triangulation keeps degree limits, whatever its angles.

use crate::chords::Chords;
use crate::pieces::{Pieces, Rules};
use crate::problem::Problem;
use crate::progress::Stage;
use crate::unsolved::Unsolved;
use mindeg_mesh::{Cancelled, Progress};

/// A triangulation of these chords that keeps the degree limit for all vertices and those of
/// single ones, and has no tangent below `threshold`, if there is one.
pub(crate) fn any_triangulation(
    problem: &Problem,
    chords: &Chords,
    max_degree: u32,
    threshold: f64,
    progress: Progress<'_>,
) -> Result<Option<Vec<[u32; 3]>>, Cancelled> {
    let Some(limits) = problem.degree_limits(max_degree) else { return Ok(None) };
    let stage = Stage::new(progress, format!("is degree {max_degree} possible?"));
    let capacities = limits.capacities(chords, |chords, most| chords > most);
    let rules = Rules { points: problem.points(), threshold, capacities };
    let pieces = Pieces::<()>::solve(rules, chords, |share| stage.report(share))?;
    Ok(pieces.triangles().map(|(triangles, ())| triangles))
}

/// The least maximum degree and a triangulation that reaches it, by search alone.
pub(crate) fn least_by_search(
    problem: &Problem,
    chords: &Chords,
    progress: Progress<'_>,
) -> Result<(u32, Vec<[u32; 3]>), Unsolved> {
    let any = |max_degree| any_triangulation(problem, chords, max_degree, 0.0, progress);
    let none = problem.no_limit();
    let mut found = any(none)?.ok_or(Unsolved::VertexLimits)?;
    // Up in growing steps, then down by halves, since small limits take the least time.
    let least = 4.min(problem.points().len() as u32 - 1);
    let (mut too_small, mut enough) = (least - 1, least.min(none));
    while enough < none {
        if let Some(triangles) = any(enough)? {
            found = triangles;
            break;
        }
        let step = enough - too_small;
        (too_small, enough) = (enough, enough.saturating_add(2 * step).min(none));
    }
    while enough - too_small > 1 {
        let middle = too_small + (enough - too_small) / 2;
        match any(middle)? {
            Some(triangles) => (enough, found) = (middle, triangles),
            None => too_small = middle,
        }
    }
    Ok((enough, found))
}
