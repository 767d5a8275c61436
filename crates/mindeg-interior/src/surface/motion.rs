//! How vertices move on a surface, and what their triangles cost: the optimiser's questions, answered by projection.

use crate::array_mesh::{ArrayMesh, Kind};
use crate::goal::Weights;
use crate::manifold::{Manifold, Slope};
use crate::surface::guard::Survey;
use crate::surface::reference::{CurveLabel, On, OnSurface, Site};
use crate::surface::sectors::{MOST_ON_BOUNDARY, degree};
use glam::{DVec2, DVec3};
use mindeg_surfaces::NONE;

/// The cosine of the greatest angle between a triangle and the surface at its vertices.
const AGREES: f64 = 0.2;
/// The cosine of the greatest angle by which a move turns a triangle.
const TURNS: f64 = 0.5;
/// A vertex makes steps of at most this many sizes, and lands at most so many sizes from where it was.
const STEP: f64 = 0.5;
const LANDS: f64 = 0.75;
/// A vertex on a curve keeps this share of the way to its neighbours.
const GAP: f64 = 0.1;

/// Two unit vectors; along a curve the second is zero.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TangentFrame {
    x: DVec3,
    y: DVec3,
}

impl TangentFrame {
    /// The part of a vector in the frame.
    pub(crate) fn within(&self, a: DVec3) -> DVec2 {
        DVec2::new(a.dot(self.x), a.dot(self.y))
    }
}

impl Manifold for OnSurface<'_> {
    type Frame = TangentFrame;
    type Survey = Survey;

    fn middle(
        mesh: &ArrayMesh<Self>,
        [a, b]: [u32; 2],
        CurveLabel(curve): CurveLabel,
        patch: u32,
    ) -> Option<Site> {
        let reference = mesh.space.0;
        let [from, to] = [a, b].map(|v| mesh.vertices[v as usize].at);
        if curve == NONE {
            let normal = (from.normal + to.normal).normalize_or_zero();
            let foot = reference.foot(patch, from.at.midpoint(to.at), normal, from.near);
            return Some(Site::of_foot(&foot, patch));
        }
        if reference.keeps(curve) {
            return None;
        }
        let near = |site: &Site| match site.on {
            On::Curve { t, .. } => Some(t),
            _ => None,
        };
        let first = reference.along(&from, curve, near(&to))?;
        let last = reference.along(&to, curve, near(&from).or(Some(first)))?;
        let way = reference.surface.curve(curve).way(first, last);
        Some(reference.on_curve(curve, first + 0.5 * way, from.near))
    }

    fn beside(mesh: &ArrayMesh<Self>, vertex: u32, patch: u32, offset: DVec3) -> Option<Site> {
        let from = &mesh.vertices[vertex as usize].at;
        let foot = mesh.space.0.foot(patch, from.at + offset, from.normal, from.near);
        Some(Site::of_foot(&foot, patch))
    }

    fn is_proper(&self, corners: [&Site; 3]) -> bool {
        let [a, b, c] = corners.map(|site| site.at);
        let normal = (b - a).cross(c - a);
        let length = normal.length();
        let longest = a.distance_squared(b).max(b.distance_squared(c)).max(c.distance_squared(a));
        length > 2e-9 * longest && least_cosine(normal, length, corners) > AGREES
    }

    fn check(mesh: &ArrayMesh<Self>, triangle: u32) -> Result<(), String> {
        let [a, b, c] = mesh.corners(triangle);
        match (b - a).cross(c - a) == DVec3::ZERO {
            true => Err(format!("triangle {triangle} has no area")),
            false => Ok(()),
        }
    }

    fn bend(mesh: &ArrayMesh<Self>, triangle: u32) -> f64 {
        let tolerance = mesh.space.0.tolerance;
        let sites = mesh.triangles[triangle as usize].vertices;
        let sites = sites.map(|v| &mesh.vertices[v as usize].at);
        let [a, b, c] = sites.map(|site| site.at);
        let normal = (b - a).cross(c - a).normalize_or_zero();
        let mut cost = 0.0;
        for (i, site) in sites.iter().enumerate() {
            if site.normal == DVec3::ZERO {
                continue;
            }
            let cosine = normal.dot(site.normal);
            cost += 2.0 * (1.0 - cosine) + 40.0 * (0.5 - cosine).max(0.0);
            let next = sites[(i + 1) % 3];
            if next.normal != DVec3::ZERO {
                let chord = (next.at - site.at).dot(next.normal - site.normal) / 8.0;
                cost += 0.5 * (chord / tolerance) * (chord / tolerance);
            }
        }
        cost
    }

    fn degree(mesh: &ArrayMesh<Self>, weights: &Weights, vertex: u32) -> (u32, f64) {
        let v = &mesh.vertices[vertex as usize];
        if v.kind == Kind::Free {
            let excess = weights.excess_of(mesh, vertex, v.triangles);
            return (excess, f64::from(v.triangles) - 6.0);
        }
        let of_goal = mesh.goals.get(v.goal as usize).map(|goal| goal.least..=goal.triangles);
        match &of_goal {
            Some(total) => degree(mesh, vertex, [total; 2]),
            None => degree(mesh, vertex, [&weights.interior, &(1..=MOST_ON_BOUNDARY)]),
        }
    }

    fn counts_triangles(mesh: &ArrayMesh<Self>, vertex: u32) -> bool {
        mesh.vertices[vertex as usize].kind == Kind::Free
    }

    fn frame(mesh: &ArrayMesh<Self>, vertex: u32) -> TangentFrame {
        let site = &mesh.vertices[vertex as usize].at;
        match site.on {
            On::Curve { curve, t } => {
                let x = mesh.space.0.surface.curve(curve).direction(t);
                TangentFrame { x, y: DVec3::ZERO }
            }
            _ => {
                let (x, y) = site.normal.any_orthonormal_pair();
                TangentFrame { x, y }
            }
        }
    }

    fn is_on_line(mesh: &ArrayMesh<Self>, vertex: u32) -> bool {
        mesh.vertices[vertex as usize].kind == Kind::Curve
    }

    fn slope(frame: &TangentFrame, x: DVec3, b: DVec3, c: DVec3) -> Option<Slope> {
        let (u, v) = (b - x, c - x);
        let normal = u.cross(v);
        let doubled = normal.length();
        if doubled <= 0.0 {
            return None;
        }
        Some(Slope {
            squares: u.length_squared() + v.length_squared() + b.distance_squared(c),
            doubled,
            of_squares: frame.within(-2.0 * (u + v)),
            // The area grows when x moves away from the edge b-c in the triangle's own plane.
            of_doubled: frame.within((c - b).cross(normal / doubled) * -1.0),
        })
    }

    fn moved(
        mesh: &ArrayMesh<Self>,
        vertex: u32,
        from: &Site,
        frame: &TangentFrame,
        step: DVec2,
    ) -> Option<Site> {
        let size = mesh.vertices[vertex as usize].size;
        let step = step.clamp_length_max(STEP * size);
        if !step.is_finite() {
            return None;
        }
        match from.on {
            On::Corner(_) => None,
            On::Curve { curve, t } => Some(mesh.space.0.on_curve(curve, t + step.x, from.near)),
            On::Patch(patch) => {
                let point = from.at + frame.x * step.x + frame.y * step.y;
                let foot = mesh.space.0.foot(patch, point, from.normal, from.near);
                Some(Site::of_foot(&foot, patch))
            }
        }
    }

    fn may_move(mesh: &ArrayMesh<Self>, vertex: u32, triangles: &[u32], to: &Site) -> bool {
        let v = &mesh.vertices[vertex as usize];
        if v.at.at.distance(to.at) > LANDS * v.size
            || v.kind == Kind::Curve && !is_between(mesh, vertex, triangles, to)
        {
            return false;
        }
        triangles.iter().all(|t| {
            let corners = mesh.triangles[*t as usize].vertices;
            let before = corners.map(|u| &mesh.vertices[u as usize].at);
            let after =
                corners.map(|u| if u == vertex { to } else { &mesh.vertices[u as usize].at });
            let [old, new] = [before, after].map(|sites| {
                let [a, b, c] = sites.map(|site| site.at);
                (b - a).cross(c - a)
            });
            let [was, is] = [old, new].map(|normal| normal.length());
            let agrees = || {
                let now = least_cosine(new, is, after);
                now > AGREES || now > least_cosine(old, was, before)
            };
            is > 0.0 && (was == 0.0 || old.dot(new) > TURNS * was * is) && agrees()
        })
    }

    fn survey(mesh: &ArrayMesh<Self>, vertices: &[u32], moves: bool) -> Option<Survey> {
        Survey::of(mesh, vertices, moves)
    }

    fn keeps(mesh: &ArrayMesh<Self>, survey: &Survey, vertices: &[u32]) -> bool {
        survey.is_kept(mesh, vertices)
    }
}

/// The least cosine between a triangle's normal and those of the surface at its vertices inside patches; 1 without any.
fn least_cosine(normal: DVec3, length: f64, corners: [&Site; 3]) -> f64 {
    let inside = corners.into_iter().filter(|site| site.normal != DVec3::ZERO);
    inside.map(|site| normal.dot(site.normal) / length).fold(1.0, f64::min)
}

/// True if a vertex on a curve stays between its neighbours there.
fn is_between(mesh: &ArrayMesh<OnSurface<'_>>, vertex: u32, triangles: &[u32], to: &Site) -> bool {
    let On::Curve { curve, t: goal } = to.on else { return false };
    let On::Curve { t, .. } = mesh.vertices[vertex as usize].at.on else { return false };
    let line = mesh.space.0.surface.curve(curve);
    let way = line.way(t, goal);
    neighbours_on_curve(mesh, vertex, triangles).into_iter().all(|other| {
        let site = &mesh.vertices[other as usize].at;
        let Some(end) = mesh.space.0.along(site, curve, Some(t)) else { return false };
        let gap = line.way(t, end);
        way * gap <= 0.0 || way.abs() <= (1.0 - GAP) * gap.abs()
    })
}

/// The other ends of the curve edges at a vertex with these triangles, each once.
pub(crate) fn neighbours_on_curve(
    mesh: &ArrayMesh<OnSurface<'_>>,
    vertex: u32,
    triangles: &[u32],
) -> Vec<u32> {
    let mut found = Vec::with_capacity(2);
    for t in triangles {
        let triangle = &mesh.triangles[*t as usize];
        let corner = triangle.corner(vertex);
        for i in [1, 2] {
            let other = triangle.vertices[(corner + i) % 3];
            if triangle.is_locked((corner + 3 - i) % 3) && !found.contains(&other) {
                found.push(other);
            }
        }
    }
    found
}
