//! The mesh of the least degree that is found, where the angle comes second.

use mindeg_exact::{Reached, degree_range};
use mindeg_mesh::Progress;

use crate::error::MeshError;
use crate::meshed::{FoundBy, Meshed};
use crate::posed::Posed;
use crate::searched::Searched;

/// The shares of Delaunay's angle that windows try to keep at degree 4.
const SHARES: [f64; 2] = [0.9, 0.5];

/// Up to so many vertices the largest angle is looked for though windows reached the degree: about a tenth of a second.
const FEW: u32 = 150;

/// The mesh of the least degree that is found, with an angle that costs little to find.
pub(crate) fn degree_first(posed: &Posed<'_>, progress: Progress<'_>) -> Result<Meshed, MeshError> {
    let range =
        degree_range(&posed.problem, progress).map_err(|error| posed.unsolved(error, progress))?;
    let meshed = |mesh, found_by| Meshed {
        mesh,
        least_max_degree: range.lower_bound,
        is_least_proven: range.is_proven(),
        found_by,
        delaunay_min_angle: posed.delaunay_min_angle,
    };
    let found_by = match range.reached_by {
        Reached::Search | Reached::Strip | Reached::Descent => {
            // The mesh that the trade-off has at this degree.
            if let Some(searched) = Searched::of_range(posed, range.clone(), progress)? {
                return searched.max_degree(range.max_degree);
            }
            FoundBy::Exhaustive
        }
        Reached::Windows => {
            if posed.domain().rings().vertex_count() <= FEW
                && let Some(searched) = Searched::of_range(posed, range.clone(), progress)?
            {
                return searched.max_degree(range.max_degree);
            }
            FoundBy::Windows { share: 0.0 }
        }
        Reached::ZigZag(_) => FoundBy::ZigZag,
        _ => FoundBy::Exhaustive,
    };
    if let FoundBy::ZigZag = found_by {
        for share in SHARES {
            if let Some(mesh) = posed.windows(share, range.max_degree, progress)?
                && mesh.max_total_degree() <= range.max_degree
            {
                return Ok(meshed(mesh, FoundBy::Windows { share }));
            }
        }
    }
    Ok(meshed(posed.mesh(range.triangles.clone())?, found_by))
}
