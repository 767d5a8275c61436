//! Meshes by windows of a Delaunay triangulation: beyond the budget of the exact solver, and with holes.

use mindeg_exact::lower_bound;
use mindeg_mesh::Progress;

use crate::error::MeshError;
use crate::meshed::{FoundBy, Meshed};
use crate::posed::Posed;

/// The shares of Delaunay's minimum angle that windows try to keep: from the largest to the smallest one, the
/// degree falls. Every goal and the trade-off choose among these meshes, so that a degree has one mesh.
pub(crate) const SHARES: [f64; 9] = [1.0, 0.95, 0.9, 0.8, 0.6, 0.4, 0.2, 0.1, 0.0];

/// The mesh with the largest share of these that windows reach within a degree limit.
pub(crate) fn within(
    posed: &Posed<'_>,
    shares: impl IntoIterator<Item = f64>,
    limit: u32,
    progress: Progress<'_>,
) -> Result<Option<Meshed>, MeshError> {
    for share in shares {
        match windowed(posed, share, progress) {
            Ok(meshed) if meshed.mesh.max_total_degree() <= limit => return Ok(Some(meshed)),
            Ok(_) | Err(MeshError::LimitsNotReached) => {}
            Err(error) => return Err(error),
        }
    }
    Ok(None)
}

/// The mesh that windows reach: with `share` of Delaunay's minimum angle, and as few edges at a vertex as can
/// be.
pub(crate) fn windowed(
    posed: &Posed<'_>,
    share: f64,
    progress: Progress<'_>,
) -> Result<Meshed, MeshError> {
    let (least_max_degree, is_known) = match posed.domain().convex() {
        Some(form) if !posed.domain().is_constrained() => {
            (mindeg_core::least_max_degree(form.boundary()), true)
        }
        _ => (lower_bound(&posed.problem).0, false),
    };
    let mesh = posed.windows(share, least_max_degree, progress)?;
    let mesh = mesh.ok_or(MeshError::LimitsNotReached)?;
    Ok(Meshed {
        is_least_proven: is_known || mesh.max_total_degree() == least_max_degree,
        mesh,
        least_max_degree,
        found_by: FoundBy::Windows { share },
        delaunay_min_angle: posed.delaunay_min_angle,
    })
}
