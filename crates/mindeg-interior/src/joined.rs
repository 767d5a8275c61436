//! The degrees of boundary vertices that periodic sides make one, in the report of a mesh: what counts is their sum.

use crate::options::Options;
use crate::report::{CertifiedVertex, InteriorReport, Violation, around};
use crate::star::Stars;
use glam::DVec2;
use mindeg_mesh::planar::PlanarBoundary;
use std::collections::BTreeSet;

/// Puts the degrees of vertices that are one in place of their own into the report of a mesh that has the boundary's
/// vertices first.
pub(crate) fn report_joined(
    report: &mut InteriorReport,
    outline: &PlanarBoundary,
    stars: &Stars,
    options: &Options,
    found: (&[DVec2], &[[u32; 3]]),
) {
    if options.joined.is_empty() {
        return;
    }
    let (points, triangles) = found;
    let on_rings = outline.vertex_count();
    let mut counts = vec![0_u32; on_rings as usize];
    let corners = triangles.as_flattened().iter();
    corners.filter(|v| **v < on_rings).for_each(|v| counts[*v as usize] += 1);
    let one: BTreeSet<u32> =
        options.joined.iter().flat_map(|one| one.vertices.iter().copied()).collect();
    report.violations.retain(|own| !one.contains(&own.vertex));
    report.certified.retain(|own| !one.contains(&own.vertex));
    report.corners.retain(|own| !one.contains(&own.vertex));
    // Its sectors are counted apart.
    report.together.retain(|own| !own.vertices.iter().any(|vertex| one.contains(vertex)));
    let alone = (0..on_rings).filter(|vertex| !one.contains(vertex));
    let alone = alone.map(|vertex| counts[vertex as usize] + 1);
    let mut boundary = alone.map(|degree| degree..=degree).reduce(|a, b| around(&a, &b));
    for one in &options.joined {
        let range = options.triangles_of(outline, one);
        let more = u32::from(!one.is_inside);
        let sum = |of: &dyn Fn(u32) -> u32| one.vertices.iter().map(|&vertex| of(vertex)).sum();
        let triangles: u32 = sum(&|vertex| counts[vertex as usize]);
        let least: u32 = sum(&|vertex| stars.least(vertex));
        let (vertex, degree) = (one.vertices[0], triangles + more);
        let at = points[vertex as usize];
        let of_kind = if one.is_inside { &mut report.interior_degree } else { &mut boundary };
        let own = degree..=degree;
        *of_kind = Some(of_kind.as_ref().map_or(own.clone(), |all| around(all, &own)));
        report.at_least = report.at_least.max(least + more);
        if !range.contains(&triangles) {
            let is_boundary = !one.is_inside;
            report.violations.push(Violation { vertex, at, degree, is_boundary });
        }
        if least > *range.end() {
            let (degree_limit, least_degree) = (range.end() + more, least + more);
            let edges = stars.ends(vertex);
            report.certified.push(CertifiedVertex {
                vertex,
                at,
                edges,
                degree_limit,
                least_degree,
            });
        }
    }
    report.boundary_degree = boundary.unwrap_or(0..=0);
    report.violations.sort_by_key(|own| own.vertex);
    report.certified.sort_by_key(|own| own.vertex);
}
