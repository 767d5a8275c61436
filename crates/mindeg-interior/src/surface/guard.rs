//! What keeps the mesh near the surface, and the surface near the mesh: no operation and no move makes either worse.

use crate::array_mesh::ArrayMesh;
use crate::surface::reference::OnSurface;
use glam::DVec3;
use mindeg_mesh::Bounds;

/// A triangle faces the surface if the cosine between their normals is greater.
const FACES: f64 = 0.1;
/// A move is looked at where normals turn by more than about 53 degrees, or
const BENDS: f64 = 0.6;
/// where edges are farther from the surface than this share of the tolerance.
const CHORD: f64 = 0.4;

/// What is so before a change.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Survey {
    /// How many triangles are farther than the tolerance from their patch, or do not face it.
    far: usize,
    /// The witnesses that are near the triangles.
    near: Vec<u32>,
}

impl Survey {
    /// A survey of the triangles at some vertices; `None` where a move can change little.
    pub(crate) fn of(
        mesh: &ArrayMesh<OnSurface<'_>>,
        vertices: &[u32],
        moves: bool,
    ) -> Option<Self> {
        let region = region(mesh, vertices);
        if moves && !bends(mesh, &region) {
            return None;
        }
        let reference = mesh.space.0;
        let corners = region.iter().flat_map(|t| mesh.corners(*t));
        let none = Bounds { min: DVec3::INFINITY, max: DVec3::NEG_INFINITY };
        let bounds = corners.fold(none, |b, p| Bounds { min: b.min.min(p), max: b.max.max(p) });
        let by = DVec3::splat(reference.tolerance);
        let mut near = Vec::new();
        reference.witnesses_in(Bounds { min: bounds.min - by, max: bounds.max + by }, &mut near);
        near.retain(|w| is_near(mesh, &region, *w));
        Some(Self { far: far(mesh, &region), near })
    }

    /// True if all witnesses are still near, and no more triangles are far.
    pub(crate) fn is_kept(&self, mesh: &ArrayMesh<OnSurface<'_>>, vertices: &[u32]) -> bool {
        let region = region(mesh, vertices);
        self.near.iter().all(|w| is_near(mesh, &region, *w)) && far(mesh, &region) <= self.far
    }
}

/// The triangles at some vertices, each once.
fn region(mesh: &ArrayMesh<OnSurface<'_>>, vertices: &[u32]) -> Vec<u32> {
    let (mut star, mut region) = (Vec::new(), Vec::new());
    for v in vertices {
        if mesh.vertices[*v as usize].triangles > 0 {
            mesh.star(*v, &mut star);
            region.extend_from_slice(&star);
        }
    }
    region.sort_unstable();
    region.dedup();
    region
}

/// True if a witness is within the tolerance of the triangles of its patch.
fn is_near(mesh: &ArrayMesh<OnSurface<'_>>, region: &[u32], witness: u32) -> bool {
    let reference = mesh.space.0;
    let witness = reference.witnesses[witness as usize];
    let most = reference.tolerance * reference.tolerance;
    region.iter().any(|t| {
        mesh.triangles[*t as usize].patch == witness.patch
            && squared_distance(witness.at, mesh.corners(*t)) <= most
    })
}

/// How many triangles are farther than the tolerance from their patch, or do not face it.
fn far(mesh: &ArrayMesh<OnSurface<'_>>, region: &[u32]) -> usize {
    region.iter().filter(|t| is_far(mesh, **t)).count()
}

/// True if a triangle is far from its patch at its centroid or at the middle of an edge, or does not face it there.
pub(crate) fn is_far(mesh: &ArrayMesh<OnSurface<'_>>, t: u32) -> bool {
    let reference = mesh.space.0;
    let triangle = &mesh.triangles[t as usize];
    let [a, b, c] = mesh.corners(t);
    let normal = (b - a).cross(c - a).normalize_or_zero();
    let near = mesh.vertices[triangle.vertices[0] as usize].at.near;
    [(a + b + c) / 3.0, a.midpoint(b), b.midpoint(c), c.midpoint(a)].into_iter().any(|point| {
        let foot = reference.surface.nearest(triangle.patch, point, Some(normal), near);
        foot.distance > reference.tolerance || foot.normal.dot(normal) <= FACES
    })
}

/// True if the surface bends between the corners of these triangles.
fn bends(mesh: &ArrayMesh<OnSurface<'_>>, region: &[u32]) -> bool {
    let chord = 8.0 * CHORD * mesh.space.0.tolerance;
    region.iter().any(|t| {
        let sites = mesh.triangles[*t as usize].vertices.map(|v| &mesh.vertices[v as usize].at);
        let [a, b, c] = sites.map(|site| site.at);
        let normal = (b - a).cross(c - a);
        let turned = BENDS * normal.length();
        (0..3).any(|i| {
            let (one, other) = (sites[i], sites[(i + 1) % 3]);
            let is_inside = |normal: DVec3| normal != DVec3::ZERO;
            let is_turned = is_inside(one.normal) && one.normal.dot(normal) < turned;
            let is_pair = is_inside(one.normal) && is_inside(other.normal);
            let off = (other.at - one.at).dot(other.normal - one.normal).abs();
            is_turned || is_pair && (off > chord || one.normal.dot(other.normal) < BENDS)
        })
    })
}

/// The squared distance from a point to a triangle.
pub(crate) fn squared_distance(p: DVec3, [a, b, c]: [DVec3; 3]) -> f64 {
    let (ab, ac, ap) = (b - a, c - a, p - a);
    let normal = ab.cross(ac);
    let square = normal.length_squared();
    // Inside all three edges: the distance to the plane.
    let left = |from: DVec3, to: DVec3| (to - from).cross(p - from).dot(normal) >= 0.0;
    if square > 0.0 && left(a, b) && left(b, c) && left(c, a) {
        let height = ap.dot(normal);
        return height * height / square;
    }
    let to_edge = |from: DVec3, to: DVec3| {
        let edge = to - from;
        let share = ((p - from).dot(edge) / edge.length_squared()).clamp(0.0, 1.0);
        p.distance_squared(from + edge * share)
    };
    to_edge(a, b).min(to_edge(b, c)).min(to_edge(c, a))
}
