//! Points on the edges of a boundary that leaves little room for good triangles: when they are worth naming, how many they are, and
//! the mesh that has them.

use mindeg::interior::{
    self, AngleLimit, BoundaryDemands, Cause, ChangeKind, InteriorMesh, InteriorReport,
};
use mindeg::{Domain, Interior, Progress};

/// Below this limit in degrees a boundary is worth changing. `condition` brings it to 25, unless asked for less.
const LOW_LIMIT: f64 = 20.0;
/// Below this limit in degrees it is worth a mesh to learn what points on edges bring.
const POOR_LIMIT: f64 = 30.0;
/// Below this share of the limits of places a boundary leaves little room.
const POOR_SHARE: f64 = 0.9;

/// Whether triangles stay far below the limits of their places: the boundary leaves little room for good ones.
#[must_use]
pub fn is_tight(report: &InteriorReport) -> bool {
    report.interior_points > 0 && report.local.worst < POOR_SHARE
}

/// Whether a boundary has a low limit for another reason than the angle of a corner itself, which no point on an edge changes.
#[must_use]
pub fn is_low(limit: &AngleLimit) -> bool {
    is_below(LOW_LIMIT, limit)
}

fn is_below(bound: f64, limit: &AngleLimit) -> bool {
    let is_sharp =
        matches!(limit.cause, Cause::Corner { angle, .. } if angle < limit.min_angle * 1.01);
    limit.min_angle < bound && !is_sharp
}

/// Whether points on edges may bring better triangles than a mesh has.
#[must_use]
pub fn is_poor(found: &InteriorMesh) -> bool {
    is_tight(&found.report) || is_below(POOR_LIMIT, &found.limit)
}

/// The domains after `--condition` alone, and how many points it put on edges. `None` where it cannot be done. Time as
/// [`interior::condition_all`].
#[must_use]
pub fn with_points_on_edges(
    domains: &[Domain],
    wanted: &Interior,
    kept: &[String],
) -> Option<(Vec<Domain>, usize)> {
    let least_triangles = wanted.least_triangles();
    let demands = BoundaryDemands { least_triangles, ..BoundaryDemands::default() };
    let (new, changed) = interior::condition_all(domains, wanted, &demands, kept).ok()?;
    let changes = changed.iter().flat_map(|one| &one.changes);
    let points = changes.filter(|change| change.kind == ChangeKind::Inserted).count();
    Some((new, points))
}

/// The mesh with points inside and on edges, and how many of these there are, if there is one.
pub(crate) fn mesh_with_points_on_edges(
    domains: &[Domain],
    wanted: &Interior,
    progress: Progress<'_>,
) -> Option<(usize, InteriorMesh)> {
    let (new, points) = with_points_on_edges(domains, wanted, &[])?;
    if points == 0 {
        return None;
    }
    Some((points, interior::mesh_all(&new, wanted, progress).ok()?))
}
