//! The judgement of a remesh, by code that the search does not use.

use std::collections::BTreeSet;

use glam::DVec3;
use mindeg_interior::Remeshed;
use mindeg_mesh::distance::distance_bound;
use mindeg_mesh::{Group, Progress, TriMesh};
use mindeg_surfaces::{Spot, Surface};

use super::found::{FeatureCounts, PartError, RemeshedPart};
use super::lines;
use super::wish::Remesh;
use crate::verify::{self, MeshDefect, SurfaceRules};

/// The mesh in groups, with its lines, names, and what the checker finds.
pub(super) fn judged(
    part: &TriMesh,
    surface: &Surface,
    found: Remeshed,
    wish: &Remesh,
    tolerance: Option<f64>,
    progress: Progress<'_>,
) -> Result<RemeshedPart, PartError> {
    let mut order: Vec<usize> = (0..found.triangles.len()).collect();
    let group = |t: &usize| surface.group(found.patches[*t]);
    order.sort_by_key(group);
    let triangles = order.iter().map(|t| found.triangles[*t]).collect();
    let mesh = TriMesh::new(found.points, triangles)?;
    let mut groups = Vec::new();
    for of_group in order.chunk_by(|a, b| group(a) == group(b)) {
        let first = groups.last().map_or(0, |group: &Group| group.triangles.end);
        let own = &part.groups()[group(&of_group[0]) as usize];
        groups.push(Group { triangles: first..first + of_group.len() as u32, ..own.clone() });
    }
    let mesh = mesh.with_groups(groups);
    let (mesh, kept) = lines::carried_over(part, surface, &found.curves, mesh)?;
    let mesh = mesh.called(mindeg_mesh::Triangles::name(part));
    let defaults = SurfaceRules::within(0.0);
    let rules = SurfaceRules {
        least_angle: wish.target_angle.unwrap_or(defaults.least_angle),
        keep_boundary: wish.keep_boundary,
        ..SurfaceRules::within(wish.tolerance.unwrap_or(f64::INFINITY))
    };
    let mut verified = verify::surface(&mesh, part, &rules, progress)?;
    let segments = |ends: [DVec3; 2]| [ends[0], ends[1], ends[1]];
    let wanted: Vec<[DVec3; 3]> = surface
        .spans()
        .iter()
        .map(|span| segments(span.vertices.map(|v| surface.points()[v as usize])))
        .collect();
    let own: Vec<[DVec3; 3]> = found
        .curves
        .iter()
        .flat_map(|curve| &curve.edges)
        .map(|edge| segments(edge.map(|v| mesh.positions()[v as usize])))
        .collect();
    if wish.keep_features {
        let found: BTreeSet<_> = own.iter().map(bits).collect();
        let missing = wanted.iter().filter(|edge| !found.contains(&bits(edge))).count();
        if missing > 0 {
            let message = format!("{missing} feature edges of the part are none of the mesh");
            verified.defects.push(MeshDefect::new("features_changed", message));
        }
    }
    let curves = match wanted.is_empty() {
        true => None,
        false => Some([
            distance_bound(&wanted, &own, progress)?,
            distance_bound(&own, &wanted, progress)?,
        ]),
    };
    let corners = (0..surface.points().len() as u32).filter(|v| surface.spot(*v) == Spot::Corner);
    let features = FeatureCounts {
        curves: surface.curves().len(),
        corners: corners.count(),
        patches: surface.patch_count() as usize,
    };
    let dropped = [
        ("lines off the edges of triangles", kept.lines),
        ("names of points off all triangles", kept.names),
        ("faces with more than three corners", part.polygons().is_none()),
    ];
    let dropped =
        dropped.into_iter().filter(|(_, is_kept)| !is_kept).map(|(what, _)| what).collect();
    let repairs = None;
    Ok(RemeshedPart {
        mesh,
        reached: found.report,
        verified,
        curves,
        features,
        repairs,
        dropped,
        tolerance,
    })
}

/// The ends of a segment by their bits, the lesser first.
fn bits(&[from, _, to]: &[DVec3; 3]) -> [[u64; 3]; 2] {
    // Adding zero turns -0 into 0.
    let mut ends = [from, to].map(|end| (end + DVec3::ZERO).to_array().map(f64::to_bits));
    ends.sort_unstable();
    ends
}
