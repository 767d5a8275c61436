//! The mesh of the least degree that is found, where the angle comes second.

use mindeg_exact::{Reached, degree_range};
use mindeg_mesh::Progress;

use crate::error::MeshError;
use crate::meshed::{FoundBy, Meshed};
use crate::posed::Posed;
use crate::searched::Searched;
use crate::windowed::{SHARES, within};

/// Up to so many vertices the largest angle is looked for though windows reached the degree: about a tenth of a second.
const FEW: u32 = 150;

/// The mesh of the least degree that is found, with an angle that costs little to find: no mesh that windows reach at this degree
/// has a larger one.
pub(crate) fn degree_first(posed: &Posed<'_>, progress: Progress<'_>) -> Result<Meshed, MeshError> {
    let range =
        degree_range(&posed.problem, progress).map_err(|error| posed.unsolved(error, progress))?;
    let is_searched = match range.reached_by {
        Reached::Search | Reached::Strip | Reached::Descent => true,
        Reached::Windows => posed.domain().rings().vertex_count() <= FEW,
        _ => false,
    };
    // The mesh that the trade-off has at this degree.
    if is_searched && let Some(searched) = Searched::of_range(posed, range.clone(), progress)? {
        return searched.max_degree(range.max_degree);
    }
    let own = Meshed {
        least_max_degree: range.lower_bound,
        is_least_proven: range.is_proven(),
        found_by: match range.reached_by {
            Reached::Windows => FoundBy::Windows { share: 0.0 },
            Reached::ZigZag(_) => FoundBy::ZigZag,
            _ => FoundBy::Exhaustive,
        },
        delaunay_min_angle: posed.delaunay_min_angle,
        mesh: posed.mesh(range.triangles)?,
    };
    // The search for a degree takes the first mesh that has it, and so the first share of the angle.
    let windowed = within(posed, SHARES, range.max_degree, progress)?;
    let angle = |meshed: &Meshed| meshed.mesh.angle_range().min;
    Ok(match windowed {
        Some(windowed) if angle(&windowed) > angle(&own) => windowed.with_bound_of(&own),
        _ => own,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::windowed::windowed;
    use mindeg_domain::Domain;
    use std::f64::consts::TAU;

    /// A ring with two waves that do not fit each other, and with a hole like it.
    fn wavy(points: u32, hole: u32) -> Domain {
        let ring = |count: u32, scale: f64| {
            (0..count).map(move |index| {
                let at = TAU * f64::from(index) / f64::from(count);
                let wave = 0.3 * libm::sin(3.0 * at + 0.4) + 0.2 * libm::sin(17.0 * at);
                let radius = scale * (1.0 + wave + 0.02 * libm::sin(f64::from(index * index)));
                [radius * libm::cos(at), radius * libm::sin(at)]
            })
        };
        let rings = [ring(points, 1.0).collect::<Vec<_>>(), ring(hole, 0.2).collect()];
        Domain::from_rings(rings.into_iter().take(if hole > 0 { 2 } else { 1 })).unwrap()
    }

    #[test]
    fn windows_have_no_larger_angle_at_the_same_degree() {
        for (points, hole) in [(300, 0), (500, 0), (900, 0), (250, 40), (400, 120), (700, 100)] {
            let domain = wavy(points, hole);
            let posed = Posed::new(&domain, Progress::NONE).unwrap();
            let found = degree_first(&posed, Progress::NONE).unwrap();
            let angle = |meshed: &Meshed| meshed.mesh.angle_range().min;
            for share in SHARES {
                let other = windowed(&posed, share, Progress::NONE).unwrap();
                let is_lower = other.mesh.max_total_degree() <= found.mesh.max_total_degree();
                assert!(
                    !is_lower || angle(&other) <= angle(&found) * (1.0 + 1e-9),
                    "{points} and {hole} points, share {share}: {} beats {}",
                    angle(&other),
                    angle(&found)
                );
            }
        }
    }
}
