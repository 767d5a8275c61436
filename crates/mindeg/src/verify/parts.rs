//! Meshes of several domains that lie beside each other: each part of the mesh against its domain.
//!
//! Limits: parts are told apart by the edges that they share, and matched to domains by the boxes around them.

use std::collections::BTreeMap;

use glam::DVec2;
use mindeg_domain::Domain;
use mindeg_mesh::{Bounds, DisjointSets, Group, TriMesh, weld};

use super::defect::MeshDefect;
use super::map::sides;
use super::matching::{MatchedPlane, VerifiedMesh};
use super::triangulation::triangulation;

/// Checks that a mesh is a triangulation of domains that share no edge, such as `interior::mesh_all`
/// makes: it has one part for each, and each part is a [`triangulation`] of its domain.
///
/// The results are in the order of the domains. Vertices have the numbers of the whole mesh; a result says nothing of vertices
/// in no triangle. O(n log n) for each part of a mesh of n triangles.
///
/// # Errors
///
/// The first defect, with the index of its domain; none if the number of parts is another. Triangles are counted within the part.
pub fn triangulations(
    mesh: &TriMesh,
    domains: &[Domain],
    tolerance: Option<f64>,
) -> Result<Vec<VerifiedMesh>, (Option<usize>, MeshDefect)> {
    let parts = parts(mesh);
    if parts.len() != domains.len() {
        let message = format!(
            "the mesh has {} (which share no edge), and the domain has {}",
            counted(parts.len()),
            counted(domains.len())
        );
        return Err((None, MeshDefect::new("parts", message)));
    }
    let order = matched(mesh, &parts, domains);
    let verify = |(index, (domain, part)): (usize, (&Domain, usize))| {
        let part = part_of(mesh, &parts[part]);
        let verified = triangulation(&part, domain, tolerance);
        verified
            .map(|verified| VerifiedMesh { unused_vertices: 0, ..verified })
            .map_err(|defect| (Some(index), defect))
    };
    domains.iter().zip(order).enumerate().map(verify).collect()
}

fn counted(parts: usize) -> String {
    if parts == 1 { "1 part".to_owned() } else { format!("{parts} parts") }
}

/// The triangles of each part, in the order of their first triangles.
fn parts(mesh: &TriMesh) -> Vec<Vec<u32>> {
    let first = weld(mesh.positions(), 0.0);
    let mut sets = DisjointSets::new(mesh.triangles().len());
    let mut beside: BTreeMap<[u32; 2], u32> = BTreeMap::new();
    for (index, triangle) in (0..).zip(mesh.triangles()) {
        for [a, b] in sides(triangle.map(|vertex| first[vertex as usize])) {
            sets.join(*beside.entry([a.min(b), a.max(b)]).or_insert(index), index);
        }
    }
    let mut parts: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for triangle in 0..mesh.triangles().len() as u32 {
        parts.entry(sets.least(triangle)).or_default().push(triangle);
    }
    parts.into_values().collect()
}

/// The part of each domain: that whose box is nearest to the domain's, in the plane where they are the nearest.
fn matched(mesh: &TriMesh, parts: &[Vec<u32>], domains: &[Domain]) -> Vec<usize> {
    let in_plane = |plane: MatchedPlane| {
        let point = |vertex: u32| plane.place(mesh.positions()[vertex as usize]).0;
        let bounds = |part: &Vec<u32>| {
            let corners = part.iter().flat_map(|&triangle| mesh.triangles()[triangle as usize]);
            Bounds::of(corners.map(point))
        };
        let boxes: Vec<Option<Bounds>> = parts.iter().map(bounds).collect();
        let mut is_free = vec![true; parts.len()];
        let mut order = Vec::with_capacity(domains.len());
        let mut farthest = 0.0_f64;
        for domain in domains {
            let own = domain.placement().bounds();
            let off = |part: &usize| {
                let far = |a: DVec2, b: DVec2| (a - b).abs().max_element();
                boxes[*part].as_ref().map_or(f64::INFINITY, |found| {
                    far(found.min, own.min).max(far(found.max, own.max))
                })
            };
            let free = (0..parts.len()).filter(|part| is_free[*part]);
            let nearest = free.min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or(0);
            is_free[nearest] = false;
            farthest = farthest.max(off(&nearest));
            order.push(nearest);
        }
        (farthest, order)
    };
    let planes = MatchedPlane::ALL.map(in_plane);
    let nearest = planes.into_iter().min_by(|a, b| a.0.total_cmp(&b.0));
    nearest.map(|(_, order)| order).unwrap_or_default()
}

/// Some triangles of a mesh as a mesh of its vertices.
fn part_of(mesh: &TriMesh, part: &[u32]) -> TriMesh {
    let triangles = part.iter().map(|&triangle| mesh.triangles()[triangle as usize]).collect();
    let mut groups: Vec<Group> = Vec::new();
    for group in mesh.groups() {
        let at = |triangle: u32| part.partition_point(|&own| own < triangle) as u32;
        let triangles = at(group.triangles.start)..at(group.triangles.end);
        if !triangles.is_empty() {
            groups.push(Group { triangles, ..group.clone() });
        }
    }
    let part = TriMesh::new(mesh.positions().to_vec(), triangles);
    part.expect("positions and triangles are those of a mesh").with_groups(groups)
}
