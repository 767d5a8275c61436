//! The smallest degree that keeps a share of Delaunay's minimum angle.
//!
//! Within the budget of the exact solver it is found. Beyond, and with holes, windows of a Delaunay
//! triangulation are retriangulated: the share of the angle is guaranteed, and the degree is what
//! was reached, between a lower bound and Delaunay's.

use mindeg_domain::Domain;
use mindeg_mesh::Progress;

use crate::error::MeshError;
use crate::exact;
use crate::meshed::Meshed;
use crate::posed::Posed;
use crate::searched::Searched;
use crate::windowed::{SHARES, windowed, within};

/// The mesh with the smallest maximum degree that has `share` of the largest minimum angle there is,
/// 0 to 1.
pub(crate) fn keep_angle(
    domain: &Domain,
    share: f64,
    progress: Progress<'_>,
) -> Result<Meshed, MeshError> {
    let posed = Posed::of_any_size(domain, progress)?;
    if let Some(searched) = Searched::new(&posed, progress)? {
        return searched.keep_angle(share);
    }
    if !posed.has_best_angles(progress)? {
        let kept = windowed(&posed, share, progress)?;
        // The same degree may keep more.
        let more = SHARES.into_iter().filter(|&more| more > share);
        let best = within(&posed, more, kept.mesh.max_total_degree(), progress)?;
        return Ok(best.unwrap_or(kept));
    }
    let is_kept = |min_angle, most| exact::keeps(min_angle, share, most);
    let trade_off = exact::exact_trade_off(&posed, is_kept, progress)?;
    Ok(trade_off.last())
}
