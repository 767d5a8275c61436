//! The guard of the distances between mesh and surface, both ways: no operation and no move makes either worse.

use crate::array_mesh::{ArrayMesh, Kind};
use crate::surface::reference::{OnSurface, Reference, Witness};
use crate::surface::walk::squared_distance;
use glam::DVec3;
use mindeg_mesh::Bounds;

/// A triangle faces the surface if the cosine between their normals is greater.
const FACES: f64 = 0.1;
/// Where a surface bends: normals turn by more than the angle of this cosine, or edges are farther from the surface than a
/// share of the tolerance. Moves change less than operations.
const BENDS_FOR_MOVES: [f64; 2] = [0.6, 0.4];
const BENDS_FOR_OPERATIONS: [f64; 2] = [0.9, 0.25];

/// The state before a change. What was far then is told from what is far afterwards: mostly nothing is.
#[derive(Debug, Clone)]
pub(crate) struct Survey {
    before: Region,
    /// The witnesses that may have been near the triangles.
    witnesses: Vec<u32>,
}

impl Survey {
    /// A survey of the triangles at some vertices; `None` where a move can change little.
    pub(crate) fn of(
        mesh: &ArrayMesh<OnSurface<'_>>,
        vertices: &[u32],
        moves: bool,
    ) -> Option<Self> {
        let mut before = Region::of(mesh, vertices);
        let is_inside = |v: &u32| mesh.vertices[*v as usize].kind == Kind::Free;
        let limits = if moves { BENDS_FOR_MOVES } else { BENDS_FOR_OPERATIONS };
        // A cavity that ends at a curve may cut its corners even where the surface is flat.
        if (moves || vertices.iter().all(is_inside)) && !before.bends(mesh, limits) {
            return None;
        }
        let reference = mesh.space.0;
        let by = DVec3::splat(reference.tolerance);
        let bounds = before.parts.iter().map(|part| part.bounds).reduce(Bounds::union)?;
        let mut witnesses = Vec::new();
        let bounds = Bounds { min: bounds.min - by, max: bounds.max + by };
        reference.witnesses_in(bounds, &mut witnesses);
        before.find_bends(mesh);
        Some(Self { before, witnesses })
    }

    /// True if all witnesses that were near still are, and no more triangles are far.
    pub(crate) fn is_kept(&self, mesh: &ArrayMesh<OnSurface<'_>>, vertices: &[u32]) -> bool {
        let mut now = Region::of(mesh, vertices);
        let reference = mesh.space.0;
        let is_lost = |w: &u32| !now.is_near(reference, *w) && self.before.is_near(reference, *w);
        if self.witnesses.iter().any(is_lost) {
            return false;
        }
        now.find_bends(mesh);
        let far = now.far(reference);
        far == 0 || far <= self.before.far(reference)
    }
}

/// The triangles at some vertices, each once.
#[derive(Debug, Clone)]
struct Region {
    parts: Vec<Part>,
}

#[derive(Debug, Clone)]
struct Part {
    triangle: u32,
    patch: u32,
    corners: [DVec3; 3],
    /// Of the corners.
    bounds: Bounds<DVec3>,
    /// A triangle of the surface near a corner.
    near: u32,
    /// Whether the surface bends there, as [`Region::find_bends`] has found.
    is_bent: bool,
}

impl Region {
    fn of(mesh: &ArrayMesh<OnSurface<'_>>, vertices: &[u32]) -> Self {
        let (mut star, mut triangles) = (Vec::new(), Vec::new());
        for v in vertices {
            if mesh.vertices[*v as usize].triangles > 0 {
                mesh.star(*v, &mut star);
                triangles.extend_from_slice(&star);
            }
        }
        triangles.sort_unstable();
        triangles.dedup();
        Self { parts: triangles.into_iter().map(|triangle| Part::of(mesh, triangle)).collect() }
    }

    /// True if a witness is within the tolerance of the triangles of its patch.
    fn is_near(&self, reference: &Reference, witness: u32) -> bool {
        let Witness { at, patch } = reference.witnesses[witness as usize];
        let most = reference.tolerance * reference.tolerance;
        self.parts.iter().any(|part| {
            let beyond = (part.bounds.min - at).max(at - part.bounds.max).max(DVec3::ZERO);
            part.patch == patch
                && beyond.length_squared() <= most
                && squared_distance(at, part.corners) <= most
        })
    }

    /// Looks where the surface bends: only there triangles can be far.
    fn find_bends(&mut self, mesh: &ArrayMesh<OnSurface<'_>>) {
        for part in &mut self.parts {
            part.is_bent = bends(mesh, part.triangle, BENDS_FOR_OPERATIONS);
        }
    }

    /// How many triangles are farther than the tolerance from their patch, or do not face it.
    fn far(&self, reference: &Reference) -> usize {
        self.parts.iter().filter(|part| part.is_bent && part.is_far(reference)).count()
    }

    /// True if the surface bends between the corners of a triangle.
    fn bends(&self, mesh: &ArrayMesh<OnSurface<'_>>, limits: [f64; 2]) -> bool {
        self.parts.iter().any(|part| bends(mesh, part.triangle, limits))
    }
}

impl Part {
    fn of(mesh: &ArrayMesh<OnSurface<'_>>, triangle: u32) -> Self {
        let corners @ [a, b, c] = mesh.corners(triangle);
        let bounds = Bounds { min: a.min(b).min(c), max: a.max(b).max(c) };
        let of = &mesh.triangles[triangle as usize];
        let near = mesh.vertices[of.vertices[0] as usize].at.near;
        Self { triangle, patch: of.patch, corners, bounds, near, is_bent: false }
    }

    /// True if it is far from its patch at its centroid or at the middle of an edge, or does not face it there.
    fn is_far(&self, reference: &Reference) -> bool {
        let [a, b, c] = self.corners;
        let normal = (b - a).cross(c - a).normalize_or_zero();
        [(a + b + c) / 3.0, a.midpoint(b), b.midpoint(c), c.midpoint(a)].into_iter().any(|point| {
            let foot = reference.foot(self.patch, point, normal, self.near);
            foot.distance > reference.tolerance || foot.normal.dot(normal) <= FACES
        })
    }
}

/// True if a triangle is far from its patch at its centroid or at the middle of an edge, or does not face it there.
pub(crate) fn is_far(mesh: &ArrayMesh<OnSurface<'_>>, t: u32) -> bool {
    Part::of(mesh, t).is_far(mesh.space.0)
}

/// True if the surface bends between the corners of a triangle, or if they do not tell.
fn bends(mesh: &ArrayMesh<OnSurface<'_>>, t: u32, [cosine, share]: [f64; 2]) -> bool {
    let chord = share * mesh.space.0.tolerance;
    let sites = mesh.triangles[t as usize].vertices.map(|v| &mesh.vertices[v as usize].at);
    let [a, b, c] = sites.map(|site| site.at);
    let normal = (b - a).cross(c - a);
    let turned = cosine * normal.length();
    let mut is_known = false;
    (0..3).any(|i| {
        let (one, other) = (sites[i], sites[(i + 1) % 3]);
        let edge = other.at - one.at;
        let [here, there] = [one, other].map(|site| site.normal != DVec3::ZERO);
        is_known |= here;
        // In the middle of an arc; of one end alone, the other leans as much the other way.
        let off = match (here, there) {
            (true, true) => edge.dot(other.normal - one.normal) / 8.0,
            (true, false) => edge.dot(one.normal) / 4.0,
            (false, true) => edge.dot(other.normal) / 4.0,
            (false, false) => 0.0,
        };
        here && one.normal.dot(normal) < turned || off.abs() > chord
    }) || !is_known
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stage::Stage;
    use crate::surface::passes::passes;
    use crate::surface::reference::Site;
    use crate::surface::work::tests::{mesh, reference, weights};
    use mindeg_mesh::Progress;

    #[test]
    fn a_tip_that_is_cut_off_is_noticed() {
        let reference = reference("spike", 1.0);
        let mut stage = Stage::new(Progress::NONE, "meshing");
        let mut mesh = passes(mesh(&reference), &weights(), &mut stage).unwrap().unwrap();
        let height = |v: &u32| mesh.at(*v).z;
        let tip = (0..mesh.vertices.len() as u32).max_by(|a, b| height(a).total_cmp(&height(b)));
        let tip = tip.unwrap();
        let survey = Survey::of(&mesh, &[tip], true).unwrap();
        assert!(survey.is_kept(&mesh, &[tip]));
        let site = mesh.vertices[tip as usize].at;
        let low = site.at - 2.0 * reference.tolerance * DVec3::Z;
        mesh.move_to(tip, Site { at: low, ..site });
        assert!(!survey.is_kept(&mesh, &[tip]));
    }

    #[test]
    fn a_triangle_that_leaves_the_surface_is_noticed_though_others_did_before() {
        let reference = reference("sphere", 1.0);
        let mut mesh = mesh(&reference);
        let (here, far) = (0, mesh.vertices.len() as u32 / 2);
        let lift = |mesh: &mut ArrayMesh<OnSurface<'_>>, v: u32| {
            let site = mesh.vertices[v as usize].at;
            mesh.move_to(v, Site { at: site.at * 1.2, ..site });
        };
        lift(&mut mesh, far);
        let survey = Survey::of(&mesh, &[here, far], false).unwrap();
        assert!(survey.before.far(&reference) > 0 && survey.is_kept(&mesh, &[here, far]));
        lift(&mut mesh, here);
        assert!(!survey.is_kept(&mesh, &[here, far]));
    }

    #[test]
    fn moves_in_flat_parts_need_no_survey() {
        let reference = reference("cube", 2.0);
        let mesh = mesh(&reference);
        let inside = mesh.vertices.iter().position(|v| v.kind == Kind::Free).unwrap() as u32;
        assert!(Survey::of(&mesh, &[inside], true).is_none());
        let on_curve = mesh.vertices.iter().position(|v| v.kind == Kind::Curve).unwrap() as u32;
        assert!(Survey::of(&mesh, &[on_curve], false).is_some());
    }
}
