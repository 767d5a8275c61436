//! The smallest degree that keeps a share of Delaunay's minimum angle.
//!
//! Within the budget of the exact solver it is found. Beyond, and with holes, windows of a Delaunay
//! triangulation are retriangulated: the share of the angle is guaranteed, and the degree is what
//! was reached, between a lower bound and Delaunay's.

use mindeg_domain::Domain;
use mindeg_exact::lower_bound;
use mindeg_mesh::Progress;

use crate::exact;
use crate::exact_error::ExactError;
use crate::meshed::{FoundBy, Meshed};
use crate::posed::Posed;

/// The mesh with the smallest maximum degree that has `share` of the largest minimum angle there is,
/// 0 to 1.
pub(crate) fn keep_angle(
    domain: &Domain,
    share: f64,
    progress: Progress<'_>,
) -> Result<Meshed, ExactError> {
    let posed = Posed::of_any_size(domain, progress)?;
    if !posed.has_best_angles(progress)? {
        let kept = windowed(&posed, share, progress)?;
        // The same degree may keep more.
        let more = SHARES.into_iter().filter(|&more| more > share);
        let best = within(&posed, more, kept.mesh.max_total_degree(), progress)?;
        return Ok(best.unwrap_or(kept));
    }
    let is_kept = |min_angle, most| exact::keeps(min_angle, share, most);
    let trade_off = exact::exact_trade_off(&posed, is_kept, progress)?;
    Ok(Meshed::last_of(&trade_off))
}

/// The shares of Delaunay's minimum angle that windows try to keep: from the largest to the smallest one, the
/// degree falls. Every goal and the trade-off choose among these meshes, so that a degree has one mesh.
pub(crate) const SHARES: [f64; 9] = [1.0, 0.95, 0.9, 0.8, 0.6, 0.4, 0.2, 0.1, 0.0];

/// The mesh with the largest share of these that windows reach within a degree limit.
pub(crate) fn within(
    posed: &Posed<'_>,
    shares: impl IntoIterator<Item = f64>,
    limit: u32,
    progress: Progress<'_>,
) -> Result<Option<Meshed>, ExactError> {
    for share in shares {
        match windowed(posed, share, progress) {
            Ok(meshed) if meshed.mesh.max_total_degree() <= limit => return Ok(Some(meshed)),
            Ok(_) | Err(ExactError::LimitsNotReached) => {}
            Err(error) => return Err(error),
        }
    }
    Ok(None)
}

/// The mesh that windows reach: with `share` of Delaunay's minimum angle, and as few edges at a vertex as can
/// be.
fn windowed(posed: &Posed<'_>, share: f64, progress: Progress<'_>) -> Result<Meshed, ExactError> {
    let (least_max_degree, is_known) = match posed.domain().convex() {
        Some(form) if !posed.domain().is_constrained() => {
            (mindeg_core::least_max_degree(form.boundary()), true)
        }
        _ => (lower_bound(&posed.problem).0, false),
    };
    let mesh = posed.windows(share, least_max_degree, progress)?;
    let mesh = mesh.ok_or(ExactError::LimitsNotReached)?;
    Ok(Meshed {
        is_least_proven: is_known || mesh.max_total_degree() == least_max_degree,
        mesh,
        least_max_degree,
        found_by: FoundBy::Windows { share },
        delaunay_min_angle: posed.delaunay_min_angle,
        higher_degree: None,
    })
}
