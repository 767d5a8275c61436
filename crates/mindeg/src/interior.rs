//! Meshes with interior points: the boundary stays bit for bit, degrees get within their limits, and the
//! minimum angle near its proven limit.
//!
//! [`mesh`] meshes a domain, [`angle_limit`] says beforehand which minimum angle no mesh of its boundary
//! can exceed and what decides that, [`lift`] which counts to change for more, and [`improve`] applies
//! the optimiser to a planar mesh of any program.
//!
//! ```
//! use mindeg::{Domain, Interior, Progress, Side, Triangles, interior};
//!
//! let domain = Domain::rectangle(4.0, 3.0, [12, 9, 4, 4].map(Side::count).into())?;
//! let limit = interior::angle_limit(&domain, &Interior::default())?;
//! let found = interior::mesh(&domain, &Interior::default(), Progress::NONE)?;
//! assert!(found.report.violations.is_empty());
//! assert!(found.report.min_angle > 0.95 * limit.min_angle.min(35.0));
//! assert_eq!(found.mesh.lines()[0].name, "side 1");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Limits are proven; degrees and angles are reached by a search without a guarantee, and the [`InteriorReport`]
//! says what was reached. How it works: [`mindeg_interior`].

mod improve;
mod lift;
mod limit;
mod plane;
mod posed;
mod regions;

pub use improve::{ImprovedMesh, improve};
pub use lift::{Lift, lift};
pub use limit::{AngleLimit, Cause, angle_limit};
pub use mindeg_interior::limits::{FanLimit, Limits, TentLimit, degree_limit};
pub use mindeg_interior::{InteriorError, InteriorReport, Violation};
use posed::{boundary, options};

use crate::boundary_mesh::lines;
use mindeg_domain::{Domain, Interior};
use mindeg_interior::{Fixed, generate};
use mindeg_mesh::{Line, Progress, TriMesh};

/// A mesh with interior points, and what it is like.
#[derive(Clone, Debug, PartialEq)]
pub struct InteriorMesh {
    /// The mesh: the boundary vertices in their order, the fixed points, then the others. Its lines are
    /// the sides of the domain, then the fixed lines.
    pub mesh: TriMesh,
    /// The measures of the mesh that was reached.
    pub report: InteriorReport,
    /// The minimum angle that no mesh of the boundary can exceed.
    pub limit: AngleLimit,
}

/// Meshes a domain with interior points.
///
/// Where the domain gives a boundary vertex a degree limit, that holds instead of
/// [`Interior::boundary_degree`], and external degrees count. Equal input gives equal bytes on every machine. O(n log n) for n
/// points, besides what is spent where degrees or angles need mending.
///
/// # Errors
///
/// A wish without a meaning or that is proven impossible, fixed points or lines outside, more points than
/// allowed, boundary points too close to triangulate, and a `progress` that cancels.
pub fn mesh(
    domain: &Domain,
    wanted: &Interior,
    progress: Progress<'_>,
) -> Result<InteriorMesh, InteriorError> {
    let boundary = boundary(domain)?;
    let fixed = Fixed::of_lines(&boundary, &wanted.fixed)?;
    let found = generate(&boundary, &fixed, &options(domain, wanted), progress)?;
    let limit = AngleLimit::new(domain, &boundary, &found.report.limits);
    let points = found.points.iter().map(|point| point.extend(0.0)).collect();
    let (rings, mut lines) = (domain.rings(), lines(domain));
    let mut segments: Vec<_> = (0..rings.vertex_count()).map(|v| [v, rings.next(v)]).collect();
    let mut pieces = found.fixed_edges.iter().copied();
    let mut rest = fixed.segments.iter();
    for (index, ends) in wanted.fixed.lines.iter().enumerate() {
        let start = segments.len() as u32;
        for [_, end] in rest.by_ref().take(ends.len().saturating_sub(1)) {
            for piece in pieces.by_ref() {
                segments.push(piece);
                if piece[1] == *end {
                    break;
                }
            }
        }
        if segments.len() as u32 > start {
            let name = free_name(&lines, &format!("fixed line {}", index + 1));
            lines.push(Line { name, segments: start..segments.len() as u32, is_straight: false });
        }
    }
    let mut kinds: Vec<_> = domain.sides().iter().map(|side| side.kind).collect();
    kinds.resize(lines.len(), None);
    let mesh = TriMesh::new(points, found.triangles)
        .and_then(|mesh| mesh.with_lines(lines, segments))
        .map(|mesh| mesh.with_line_kinds(kinds))
        .map_err(|error| InteriorError::NotFilled(error.to_string()))?;
    let mesh = match domain.name() {
        Some(name) => mesh.named(name),
        None => mesh,
    };
    Ok(InteriorMesh { mesh, report: found.report, limit })
}

/// A name that no line has.
fn free_name(lines: &[Line], wanted: &str) -> String {
    let mut name = wanted.to_owned();
    while lines.iter().any(|line| line.name == name) {
        name.push('\'');
    }
    name
}

#[cfg(test)]
mod tests {
    use super::*;
    use mindeg_domain::{Arc, Curve, Outline, Side};
    use mindeg_mesh::Triangles;

    /// The points of a curved side of one interval are on a line, whichever mesh of the domain has it.
    #[test]
    fn sides_are_straight_in_both_kinds_of_meshes_alike() {
        let arc = |intervals| {
            let curve = Curve::Arc(Arc::Through([1.0, -0.5].into()));
            let sides = vec![Side::count(intervals).along(curve), Side::count(2), Side::count(2)];
            Domain::new(
                Outline::Polygon([[0.0, 0.0], [2.0, 0.0], [1.0, 2.0]].map(Into::into).into()),
                sides,
            )
            .unwrap()
        };
        for intervals in [1, 2, 5] {
            let domain = arc(intervals);
            let boundary = crate::mesh(&domain, crate::Goal::LeastDegree, Progress::NONE).unwrap();
            let filled = mesh(&domain, &Interior::default(), Progress::NONE).unwrap();
            let straight = |lines: &[Line]| -> Vec<bool> {
                lines.iter().map(|line| line.is_straight).collect()
            };
            let expected = [intervals == 1, true, true];
            assert_eq!(straight(&boundary.mesh.lines()), expected, "{intervals}");
            assert_eq!(straight(&filled.mesh.lines()), expected, "{intervals}");
        }
    }
}
