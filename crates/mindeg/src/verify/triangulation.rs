//! The check of a mesh against a domain.

use std::collections::BTreeSet;

use glam::DVec3;
use mindeg_domain::{Domain, Interior};
use mindeg_mesh::TriMesh;
use mindeg_mesh::check;

use super::defect::MeshDefect;
use super::fault;
use super::joint::joined_degrees;
use super::map::MapLines;
use super::matching::{MatchedPlane, VerifiedMesh, matched, tolerance_of};
use super::together::Frozen;

/// Checks that a mesh is a triangulation of a domain: that it has a vertex at every boundary point, and
/// that its triangles cover the domain once and lie edge to edge. Other vertices are interior points.
/// O(n log n).
///
/// Vertices count as one if they are at one position or belong to one boundary point. A vertex belongs to the
/// nearest boundary point that is no farther than `tolerance`, in units of length; without one,
/// [`DEFAULT_TOLERANCE`](super::DEFAULT_TOLERANCE) of the domain's extent, or what 32-bit floats round its
/// coordinates by, whichever is larger, but no more than a quarter of the shortest interval. Where a vertex
/// is at the very place of a boundary point, others near it are interior points.
/// A mesh in degrees is projected as its domain was.
///
/// # Errors
///
/// The first defect: of the vertices, then of single triangles, then of edges.
pub fn triangulation(
    mesh: &TriMesh,
    domain: &Domain,
    tolerance: Option<f64>,
) -> Result<VerifiedMesh, MeshDefect> {
    let larger = mesh.non_triangles();
    let larger_faces = larger.quads + larger.polygons;
    if larger_faces > 0 {
        let (faces, them) = match larger_faces {
            1 => ("1 face has".to_owned(), "it"),
            count => (format!("{count} faces have"), "them"),
        };
        let message =
            format!("{faces} more than three corners; mindeg convert cuts {them} into triangles");
        return Err(MeshDefect::new("larger_faces", message));
    }
    let projected = in_plane_of(mesh, domain);
    let mesh = projected.as_ref().unwrap_or(mesh);
    let tolerance = tolerance_of(mesh, domain, tolerance)?;
    let mut first_defect = None;
    for plane in MatchedPlane::ALL {
        match matched(mesh, domain, plane, tolerance).and_then(|found| checked(found, domain, mesh))
        {
            Ok(verified) => return Ok(verified),
            Err(defect) => {
                // The plane in which the mesh comes nearest to the domain has the defect that matters.
                let is_nearer = |other: &MeshDefect| defect.step() > other.step();
                if first_defect.as_ref().is_none_or(is_nearer) {
                    first_defect = Some(defect);
                }
            }
        }
    }
    Err(first_defect.expect("there are planes"))
}

/// A mesh in degrees in the plane of its domain: one whose vertices, projected as the domain was, all lie at the domain.
fn in_plane_of(mesh: &TriMesh, domain: &Domain) -> Option<TriMesh> {
    /// Rounded degrees may be beyond the domain by this share of its extent.
    const MARGIN: f64 = 0.01;
    let projection = domain.projection()?;
    let bounds = domain.placement().bounds();
    let margin = MARGIN * (bounds.max - bounds.min);
    let place = |at: &DVec3| {
        let place = projection.to_plane(at.truncate());
        let is_in = place.cmpge(bounds.min - margin) & place.cmple(bounds.max + margin);
        is_in.all().then(|| place.extend(at.z))
    };
    let places = mesh.positions().iter().map(place).collect::<Option<Vec<_>>>()?;
    mesh.clone().with_positions(places).ok()
}

/// Checks a mesh that is matched to the domain's points, and adds its degrees.
fn checked(
    mut mesh: VerifiedMesh,
    domain: &Domain,
    given: &TriMesh,
) -> Result<VerifiedMesh, MeshDefect> {
    mesh.is_reversed = fault::all_clockwise(&mesh.points, &mesh.triangles);
    if mesh.is_reversed {
        mesh.triangles.iter_mut().for_each(|corners| corners.swap(1, 2));
    }
    let boundary = domain.boundary().map_err(|faults| {
        let message = format!("the domain's boundary is not simple once it is rounded: {faults}");
        MeshDefect::new("boundary", message)
    })?;
    let lines = MapLines::new(domain, &boundary, &mesh)?;
    let has_holes = domain.inside().regions.iter().any(|region| region.hole);
    let open = if has_holes { &lines.open[..] } else { &[] };
    let VerifiedMesh { points, vertex_of, triangles, .. } = &mesh;
    let inner = &points[boundary.points().len()..];
    let is_flat = fault::flat_triangle(&boundary, triangles).is_some()
        || fault::passing_triangle(domain, points, triangles).is_some();
    mesh.degrees = match check::triangulation_around(&boundary, inner, open, triangles) {
        Ok(checked) if !is_flat => checked.degrees,
        failed => {
            let boundary = &*boundary;
            let search = fault::Search { domain, boundary, points, vertex_of, triangles };
            return Err(search.first_defect(failed.err()));
        }
    };
    if has_holes {
        lines.check_holes(domain, &mesh)?;
    }
    if !domain.inside().regions.is_empty() {
        lines.check_groups(domain, given, &mesh)?;
    }
    if domain.periodic().is_some() {
        mesh.degrees = joined_degrees(domain, &mesh.triangles, mesh.points.len());
    }
    if mesh.interior_points > 0 {
        let wanted = domain.interior().map_or_else(Default::default, Interior::clone);
        let range = wanted.interior_degree();
        let inside = boundary.points().len() as u32..mesh.points.len() as u32;
        let at_holes: BTreeSet<u32> = open.as_flattened().iter().copied().collect();
        let periodic = domain.periodic();
        let joined = (0..domain.rings().vertex_count()).filter(|&vertex| {
            periodic.is_some_and(|own| own.vertex(vertex) == vertex && own.is_inside(vertex))
        });
        for vertex in joined.chain(inside).filter(|vertex| !at_holes.contains(vertex)) {
            let degree = mesh.degrees[vertex as usize];
            if degree > 0 && !range.contains(&degree) {
                mesh.out_of_range.push(vertex);
                if lines.exceeds(&mesh, vertex, *range.end()) {
                    mesh.certified.push(vertex);
                }
            }
        }
        let above = mesh.out_of_range.iter().filter(|v| !mesh.certified.contains(v));
        let above = above.filter(|v| mesh.degrees[**v as usize] > *range.end());
        let above: Vec<u32> = above.copied().collect();
        if !above.is_empty() && domain.periodic().is_none() {
            mesh.together = Frozen::new(&boundary, &lines, &mesh).excused(&above, *range.end());
        }
    }
    if domain.is_constrained() {
        for vertex in 0..domain.rings().vertex_count() {
            let degree = &mut mesh.degrees[vertex as usize];
            *degree = degree.saturating_add(domain.external_degree(vertex));
            if domain.degree_limit(vertex).is_some_and(|limit| *degree > limit) {
                mesh.above_limit.push(vertex);
            }
        }
    }
    mesh.max_degree = mesh.degrees.iter().copied().max().unwrap_or(0);
    Ok(mesh)
}
