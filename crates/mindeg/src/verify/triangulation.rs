//! The check of a mesh against a domain.

use glam::DVec2;
use mindeg_domain::Domain;
use mindeg_mesh::TriMesh;
use mindeg_mesh::check::{self, Checked};

use super::defect::MeshDefect;
use super::fault;
use super::matching::{Matched, MatchedPlane, matched, tolerance_of};

/// A mesh that is a triangulation of a domain.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct VerifiedMesh {
    /// The domain's boundary points as the domain has them, then the others as the mesh has them.
    pub points: Vec<DVec2>,
    /// The vertex of the mesh at each of these: the first, if several are there.
    pub vertex_of: Vec<u32>,
    /// The triangles of the mesh, in its order, by these points and counter-clockwise.
    pub triangles: Vec<[u32; 3]>,
    /// How many points are not on the boundary.
    pub interior_points: usize,
    /// How many vertices of the mesh no triangle uses.
    pub unused_vertices: usize,
    /// The number of edges at each point, the domain's external degrees included.
    pub degrees: Vec<u32>,
    /// The largest of them.
    pub max_degree: u32,
    /// The boundary points with more edges than the domain allows there.
    pub above_limit: Vec<u32>,
    /// How the mesh lies in space.
    pub plane: MatchedPlane,
    /// Whether all triangles of the mesh are clockwise.
    pub is_reversed: bool,
    /// How far a vertex may be from its boundary point, in units of length.
    pub tolerance: f64,
    /// How far the farthest one is.
    pub farthest: f64,
}

/// Checks that a mesh is a triangulation of a domain: that it has a vertex at every boundary point, and
/// that its triangles cover the domain once and lie edge to edge. Other vertices are interior points.
/// O(n log n).
///
/// Vertices count as one if they are at one position or belong to one boundary point. A vertex belongs to the
/// nearest boundary point that is no farther than `tolerance`, in units of length; without one,
/// [`DEFAULT_TOLERANCE`](super::DEFAULT_TOLERANCE) of the domain's extent, or what 32-bit floats round its
/// coordinates by, whichever is larger, but no more than a quarter of the shortest interval. Where a vertex
/// is at the very place of a boundary point, others near it are interior points.
///
/// # Errors
///
/// The first defect, in the order of [`MeshDefect`].
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
        let message = format!("{faces} more than three corners; cut {them} into triangles first");
        return Err(MeshDefect::new("larger_faces", message));
    }
    let tolerance = tolerance_of(mesh, domain, tolerance)?;
    let mut first_defect = None;
    for plane in MatchedPlane::ALL {
        match matched(mesh, domain, plane, tolerance).and_then(|found| checked(found, domain)) {
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

fn checked(found: Matched, domain: &Domain) -> Result<VerifiedMesh, MeshDefect> {
    let Matched { points, vertex_of, mut triangles, unused_vertices, plane, tolerance, farthest } =
        found;
    let is_reversed = fault::all_clockwise(&points, &triangles);
    if is_reversed {
        triangles.iter_mut().for_each(|corners| corners.swap(1, 2));
    }
    let boundary = domain.boundary().map_err(|faults| {
        let message = format!("the domain's boundary is not simple once it is rounded: {faults}");
        MeshDefect::new("boundary", message)
    })?;
    let inner = &points[boundary.points().len()..];
    let is_flat = fault::flat_triangle(&boundary, &triangles).is_some()
        || fault::passing_triangle(domain, &points, &triangles).is_some();
    let Checked { mut degrees, .. } = match check::triangulation(&boundary, inner, &triangles) {
        Ok(checked) if !is_flat => checked,
        failed => {
            let search = fault::Search {
                domain,
                boundary: &boundary,
                points: &points,
                vertex_of: &vertex_of,
                triangles: &triangles,
            };
            return Err(search.first_defect(failed.err()));
        }
    };
    let boundary_points = domain.rings().vertex_count();
    let mut above_limit = Vec::new();
    if domain.is_constrained() {
        for vertex in 0..boundary_points {
            let degree = &mut degrees[vertex as usize];
            *degree = degree.saturating_add(domain.external_degree(vertex));
            if domain.degree_limit(vertex).is_some_and(|limit| *degree > limit) {
                above_limit.push(vertex);
            }
        }
    }
    let max_degree = degrees.iter().copied().max().unwrap_or(0);
    let interior_points = points.len() - boundary_points as usize;
    Ok(VerifiedMesh {
        points,
        vertex_of,
        triangles,
        interior_points,
        unused_vertices,
        degrees,
        max_degree,
        above_limit,
        plane,
        is_reversed,
        tolerance,
        farthest,
    })
}
