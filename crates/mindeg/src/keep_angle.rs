//! The smallest degree that keeps a share of Delaunay's minimum angle.
//!
//! Up to [`MAX_VERTICES`] boundary vertices the exact solver finds it. Beyond, windows of a Delaunay
//! triangulation are retriangulated: the share of the angle is guaranteed, and the degree is what
//! was reached, between the least maximum degree and Delaunay's.

use glam::DVec2;
use mindeg_domain::Domain;
use mindeg_exact::measure::min_angle_tangent;
use mindeg_exact::{MAX_VERTICES, Problem, WindowGoal, windows};
use mindeg_mesh::Progress;

use crate::boundary_mesh::{BoundaryMesh, convex};
use crate::exact::{self, ExactError};
use crate::meshed::{FoundBy, Meshed};

/// The mesh with the smallest maximum degree that has `share` of the largest minimum angle there is,
/// 0 to 1.
pub(crate) fn keep_angle(
    domain: &Domain,
    share: f64,
    progress: Progress<'_>,
) -> Result<Meshed, ExactError> {
    if domain.rings().vertex_count() > MAX_VERTICES {
        return Delaunay::new(domain, progress)?.windows(share, 0, progress);
    }
    // Angles are compared to 36 bits; the last of them decides nothing.
    let is_kept = |min_angle, most| min_angle >= share * most * (1.0 - 1e-10);
    let trade_off = exact::trade_off_until(domain, is_kept, progress)?;
    Ok(Meshed::last_of(&trade_off))
}

/// A domain with a Delaunay triangulation, in which windows start.
pub(crate) struct Delaunay<'a> {
    domain: &'a Domain,
    problem: Problem,
    /// In degrees.
    min_angle: f64,
}

impl<'a> Delaunay<'a> {
    pub(crate) fn new(domain: &'a Domain, progress: Progress<'_>) -> Result<Self, ExactError> {
        let boundary = convex(domain)?;
        let mut points = vec![DVec2::ZERO; boundary.vertex_count() as usize];
        domain.placement().fill_points(0, &mut points);
        let corners: Vec<u32> =
            (0..boundary.side_count()).map(|side| boundary.corner(side)).collect();
        let triangles = mindeg_delaunay::of_boundary(&points, &corners, progress)?;
        let tangent = |triangle: &[u32; 3]| min_angle_tangent(triangle.map(|v| points[v as usize]));
        let least_tangent = triangles.iter().map(tangent).fold(f64::INFINITY, f64::min);

        let sides: Vec<u32> = (0..)
            .zip(boundary.sides())
            .flat_map(|(side, intervals)| std::iter::repeat_n(side, intervals as usize))
            .collect();
        let mut problem = Problem::triangulated(&points, &sides, &triangles)?;
        exact::constrain(&mut problem, domain);
        Ok(Self { domain, problem, min_angle: libm::atan(least_tangent).to_degrees() })
    }

    /// The mesh that windows reach: with `share` of Delaunay's minimum angle, and no vertex above
    /// `max_degree` if that can be reached, else as few edges as can be.
    pub(crate) fn windows(
        &self,
        share: f64,
        max_degree: u32,
        progress: Progress<'_>,
    ) -> Result<Meshed, ExactError> {
        let least_max_degree = mindeg_core::least_max_degree(convex(self.domain)?);
        let min_tangent = libm::tan((share * self.min_angle).to_radians());
        let goal = WindowGoal { max_degree: max_degree.max(least_max_degree), min_tangent };
        let windowed = windows(&self.problem, goal, progress)?;
        Ok(Meshed {
            mesh: BoundaryMesh::with_triangles(self.domain, windowed.triangles)?,
            least_max_degree,
            found_by: FoundBy::Windows { share },
            delaunay_min_angle: Some(self.min_angle),
            higher_degree: None,
        })
    }
}
