//! The optimiser on a planar mesh of any program, in any plane of space.

use std::collections::{BTreeMap, BTreeSet};

use crate::error::MeshError;
use glam::{DVec2, DVec3};
use mindeg_domain::Interior;
use mindeg_interior::{InteriorReport, Keep};
use mindeg_mesh::{
    Bounds, Group, NamedVertex, Progress, TriMesh, Triangles, edges_of, number, weld,
};

use super::plane::Plane;
use crate::regions::{interfaces, spread};

/// An improved mesh, with what it was like before and is like after.
#[derive(Clone, Debug, PartialEq)]
pub struct ImprovedMesh {
    /// The mesh. Vertices that are left keep their order, and new ones follow; groups and lines are those
    /// of the input.
    pub mesh: TriMesh,
    /// The measures before; vertices have the indices of the input, after merging.
    pub before: InteriorReport,
    /// The measures after; vertices have the indices of the result.
    pub after: InteriorReport,
    /// How many vertices were merged with an earlier one at the same place.
    pub merged: usize,
    /// How many edges inside were kept, because groups meet there or lines run along them.
    pub kept_edges: usize,
}

/// A vertex may be off the plane by this share of the mesh's size.
const FLAT: f64 = 1e-9;

/// Improves a planar triangle mesh: its boundary stays bit for bit, degrees and angles get nearer to
/// what is wanted.
///
/// The plane may be any in space. Vertices with equal coordinates are merged first. Edges between groups and
/// along lines stay, so that groups and lines do. Degrees, target and preference
/// count; wanted sizes are ignored. The result is never worse than the input.
///
/// # Errors
///
/// A mesh that is not planar or not manifold, triangles that are flat or face the other way, a
/// wish without a meaning or that is proven impossible, and a `progress` that cancels.
///
/// # Example
///
/// ```
/// use mindeg::{Interior, Progress, TriMesh, interior};
/// use mindeg::glam::DVec3;
///
/// // A square cut in four at a point near a corner.
/// let points = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.1, 0.1]];
/// let points = points.map(|[x, y]| DVec3::new(x, 7.0, -y)).to_vec();
/// let mesh = TriMesh::new(points, vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])?;
/// let found = interior::improve(&mesh, &Interior::default(), Progress::NONE)?;
/// assert!(found.before.min_angle < 4.0 && found.after.min_angle > 44.9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn improve(
    mesh: &TriMesh,
    wanted: &Interior,
    progress: Progress<'_>,
) -> Result<ImprovedMesh, MeshError> {
    let (names, positions) = merged(mesh);
    let rename = |v: u32| names[v as usize];
    let triangles: Vec<[u32; 3]> = mesh.triangles().iter().map(|t| t.map(rename)).collect();
    let segments: Vec<[u32; 2]> = mesh.segments().iter().map(|s| s.map(rename)).collect();
    let plane = plane(mesh, &positions, &triangles)?;
    let points: Vec<DVec2> = positions.iter().map(|point| plane.project(*point)).collect();

    let groups = mesh.groups();
    let group = |t: usize| groups.partition_point(|group| group.triangles.end as usize <= t);
    let mut keep = keep(&triangles, &segments, group);
    let named = mesh.named_vertices();
    keep.vertices.extend(named.iter().map(|named| rename(named.vertex)));
    let found =
        mindeg_interior::improve(&points, &triangles, &keep, &wanted.clone().into(), progress)?;

    let position = |(at, source): (&DVec2, &Option<u32>)| match source {
        Some(source) if points[*source as usize] == *at => positions[*source as usize],
        _ => plane.lift(*at),
    };
    let new_positions = found.points.iter().zip(&found.sources).map(position).collect();
    let mut new_name = vec![u32::MAX; points.len()];
    for (name, source) in (0..).zip(&found.sources) {
        if let Some(source) = source {
            new_name[*source as usize] = name;
        }
    }
    let renew = |edge: [u32; 2]| edge.map(|v| new_name[v as usize]);
    let (new_triangles, new_groups) = if groups.len() > 1 {
        // Boundary edges and those kept know the group on their left; all of them are still there.
        let is_kept: BTreeSet<[u32; 2]> =
            keep.edges.iter().flat_map(|[a, b]| [[*a, *b], [*b, *a]]).collect();
        let all: BTreeSet<[u32; 2]> = triangles.iter().flat_map(|t| edges_of(*t)).collect();
        let mut known = BTreeMap::new();
        for (index, triangle) in triangles.iter().enumerate() {
            for [a, b] in edges_of(*triangle) {
                if is_kept.contains(&[a, b]) || !all.contains(&[b, a]) {
                    known.insert(renew([a, b]), group(index));
                }
            }
        }
        grouped(&found.triangles, &spread(&found.triangles, &known), groups)
    } else {
        let mut groups = groups.to_vec();
        groups.iter_mut().for_each(|group| group.triangles = 0..found.triangles.len() as u32);
        (found.triangles, groups)
    };
    let renamed = |named: &NamedVertex| NamedVertex {
        vertex: new_name[rename(named.vertex) as usize],
        ..named.clone()
    };
    let named = named.iter().map(renamed).collect();
    let result = TriMesh::new(new_positions, new_triangles)?
        .with_groups(new_groups)
        .with_named_vertices(named)?
        .with_lines(mesh.lines().into_owned(), segments.into_iter().map(renew).collect())?;
    let result = result.called(mesh.name());
    Ok(ImprovedMesh {
        mesh: result,
        before: found.before,
        after: found.after,
        merged: mesh.positions().len() - positions.len(),
        kept_edges: keep.edges.len(),
    })
}

/// The index of each vertex once those at one position are one, and the positions.
fn merged(mesh: &TriMesh) -> (Vec<u32>, Vec<DVec3>) {
    let mut names = weld(mesh.positions(), 0.0);
    let mut positions = Vec::with_capacity(names.len());
    for v in 0..names.len() {
        // The first vertex at a position comes first.
        if names[v] as usize == v {
            names[v] = positions.len() as u32;
            positions.push(mesh.positions()[v]);
        } else {
            names[v] = names[names[v] as usize];
        }
    }
    (names, positions)
}

/// The plane of a mesh.
fn plane(mesh: &TriMesh, positions: &[DVec3], triangles: &[[u32; 3]]) -> Result<Plane, MeshError> {
    let (mut normal, mut total, mut largest) = (DVec3::ZERO, 0.0, (DVec3::ZERO, DVec3::ZERO));
    for t in triangles {
        let [a, b, c] = t.map(|v| positions[v as usize]);
        let doubled = (b - a).cross(c - a);
        normal += doubled;
        total += doubled.length();
        if doubled.length() > largest.1.length() {
            largest = (a, doubled);
        }
    }
    let used = || triangles.iter().flatten().map(|v| (*v, positions[*v as usize]));
    let none = Bounds { min: DVec3::ZERO, max: DVec3::ZERO };
    let bounds = Bounds::of_space(used().map(|(_, at)| at)).unwrap_or(none);
    let Bounds { min: low, max: high } = bounds;
    // A mesh across an axis has its normal exactly along it.
    let flat = bounds.size().to_array().map(|extent| extent == 0.0);
    let normal = match flat {
        [true, false, false] => DVec3::new(normal.x, 0.0, 0.0),
        [false, true, false] => DVec3::new(0.0, normal.y, 0.0),
        [false, false, true] => DVec3::new(0.0, 0.0, normal.z),
        _ => normal,
    };
    let tolerance = (FLAT * (high - low).max_element()).max(4.0 * mesh.rounding());
    if normal.length() < 0.5 * total || normal == DVec3::ZERO || !normal.is_finite() {
        let (at, across) = largest;
        let is_off = |at: DVec3, plane: Plane| plane.distance(at) > tolerance;
        let is_in_space = across != DVec3::ZERO
            && across.is_finite()
            && used().any(|(_, vertex)| is_off(vertex, Plane::new(at, across)));
        return Err(MeshError::refused(if is_in_space {
            "the mesh is not planar but a surface in space: mindeg remesh meshes that anew"
        } else {
            "parts of the mesh are turned over, or it has no area: give a flat mesh whose triangles face one way"
        }));
    }
    let plane = Plane::new(low.midpoint(high), normal);
    // The middle of the box need not be on a tilted plane: a vertex is.
    let plane = match flat.contains(&true) {
        true => plane,
        false => Plane::new(used().next().map_or(low, |(_, at)| at), normal),
    };
    let farthest = used()
        .map(|(vertex, at)| (plane.distance(at), vertex))
        .max_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
    match farthest {
        Some((distance, vertex)) if distance > tolerance => Err(MeshError::Refused(format!(
            "the mesh is not planar: vertex {vertex} (counted from 0) is {} off the plane of the \
             others; the tolerance is {}; mindeg remesh takes surfaces in space",
            number(distance),
            number(tolerance)
        ))),
        _ => Ok(plane),
    }
}

/// All that stays: the edges between groups and along lines, and what else lines go through.
fn keep(triangles: &[[u32; 3]], segments: &[[u32; 2]], group: impl Fn(usize) -> usize) -> Keep {
    let mut keep = Keep { vertices: Vec::new(), edges: interfaces(triangles, group) };
    if !segments.is_empty() {
        let all: BTreeSet<[u32; 2]> = triangles.iter().flat_map(|t| edges_of(*t)).collect();
        for [a, b] in segments {
            // On the boundary nothing moves anyway.
            match (all.contains(&[*a, *b]), all.contains(&[*b, *a])) {
                (true, true) => keep.edges.push([*a.min(b), *a.max(b)]),
                (false, false) => keep.vertices.extend([*a, *b]),
                _ => {}
            }
        }
        keep.edges.sort_unstable();
        keep.edges.dedup();
    }
    keep
}

/// The triangles in the order of their groups, and these.
fn grouped(
    triangles: &[[u32; 3]],
    group_of: &[usize],
    groups: &[Group],
) -> (Vec<[u32; 3]>, Vec<Group>) {
    let mut sorted = Vec::with_capacity(triangles.len());
    let mut found = Vec::with_capacity(groups.len());
    // Every region has a boundary, so every triangle has a group.
    for (index, group) in groups.iter().enumerate() {
        let start = sorted.len() as u32;
        let own = triangles.iter().zip(group_of).filter(|(_, of)| **of == index);
        sorted.extend(own.map(|(triangle, _)| *triangle));
        found.push(Group { triangles: start..sorted.len() as u32, ..group.clone() });
    }
    (sorted, found)
}
