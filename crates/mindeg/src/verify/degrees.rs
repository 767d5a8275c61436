//! The degrees of a remesh, and those that the corners of its part force.
//!
//! The curves of a part that meet at a corner divide the triangles there into sectors. In a triangle without an angle
//! below `a` degrees the angle at the corner is between `a` and 180 - 2a, so the number of triangles in a sector of angle
//! T is between T / (180 - 2a) and T / a, and off the boundary there are three at least. At a needle's tip not even three such
//! fit. There `a` is the minimum angle of the mesh: no mesh with as great a minimum angle has more triangles at the tip.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use mindeg_mesh::DisjointSets;
use mindeg_mesh::inspection::VertexDegree;

use super::defect::{MeshDefect, in_space};
use super::rules::SurfaceRules;
use super::sides::Sides;

/// A vertex of a remesh at a corner of its part that allows no degree of the usual range.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "json", derive(serde::Serialize))]
pub struct ProvenDegree {
    /// The vertex.
    pub vertex: u32,
    /// The number of edges at the vertex.
    pub degree: u32,
    /// Whether it lies on the boundary.
    #[cfg_attr(feature = "json", serde(skip))]
    pub on_boundary: bool,
    /// The least and greatest degree that the sectors of the corner allow.
    pub allowed: [u32; 2],
    /// The angles between the curves of the part that meet there, in degrees.
    pub sectors: Vec<f64>,
}

/// The degrees of a mesh.
pub(super) struct Degrees {
    /// The vertices with an edge.
    pub(super) vertices: usize,
    pub(super) inside: Option<[u32; 2]>,
    pub(super) boundary: Option<[u32; 2]>,
    pub(super) out_of_range: Vec<VertexDegree>,
    pub(super) proven: Vec<ProvenDegree>,
}

/// Edges that turn by more than this angle, in degrees, divide sectors where the rules name none.
const SHARP: f64 = 40.0;
/// Angles are sums of rounded ones: so much counts as nothing, as a share of the number of triangles.
const ROUNDING: f64 = 1e-9;

impl Degrees {
    /// `min_angle`: of the mesh, in degrees. `is_single`: whether the points of the mesh are those of the part in 32 bits.
    pub(super) fn of(
        own: &Sides,
        part: &Sides,
        rules: &SurfaceRules,
        min_angle: f64,
        is_single: bool,
    ) -> Self {
        let mut on_boundary = vec![false; own.mesh.positions().len()];
        own.boundary.iter().flatten().for_each(|&v| on_boundary[v as usize] = true);
        let mut degrees = vec![0_u32; on_boundary.len()];
        own.edges.iter().flatten().for_each(|&v| degrees[v as usize] += 1);
        let (mut inside, mut boundary) = (None, None);
        let (mut vertices, mut out_of_range) = (0, Vec::new());
        for ((vertex, degree), on_boundary) in (0..).zip(degrees).zip(on_boundary) {
            if degree == 0 {
                continue;
            }
            vertices += 1;
            let range: &mut Option<[u32; 2]> =
                if on_boundary { &mut boundary } else { &mut inside };
            let [least, most] = range.unwrap_or([degree; 2]);
            *range = Some([least.min(degree), most.max(degree)]);
            if !wanted(rules, on_boundary).contains(&degree) {
                out_of_range.push(VertexDegree { vertex, degree, on_boundary });
            }
        }
        let proven = proven(&out_of_range, [own, part], rules, min_angle, is_single);
        let is_proven = |v: &VertexDegree| {
            proven.binary_search_by_key(&v.vertex, |proven| proven.vertex).is_ok()
        };
        out_of_range.retain(|v| !is_proven(v));
        Self { vertices, inside, boundary, out_of_range, proven }
    }

    pub(super) fn check(&self, sides: &Sides, rules: &SurfaceRules, defects: &mut Vec<MeshDefect>) {
        for on_boundary in [false, true] {
            let of_kind = || self.out_of_range.iter().filter(|v| v.on_boundary == on_boundary);
            let Some(VertexDegree { vertex, degree, .. }) = of_kind().next() else { continue };
            let (place, range) = match on_boundary {
                true => ("on the boundary", format!("at most {}", rules.boundary_degree)),
                false => (
                    "off the boundary",
                    format!("{} to {}", rules.inside.start(), rules.inside.end()),
                ),
            };
            let message = format!(
                "{} vertices {place} have another degree than {range}, the first is vertex {vertex} with {degree}, at {}",
                of_kind().count(),
                in_space(sides.mesh.positions()[*vertex as usize])
            );
            defects.push(MeshDefect::new("degree", message));
        }
    }
}

/// The degrees that a vertex should have.
fn wanted(rules: &SurfaceRules, on_boundary: bool) -> RangeInclusive<u32> {
    if on_boundary { 0..=rules.boundary_degree } else { rules.inside.clone() }
}

/// The vertices out of range whose degrees the corners of the part force.
fn proven(
    out_of_range: &[VertexDegree],
    [own, part]: [&Sides; 2],
    rules: &SurfaceRules,
    min_angle: f64,
    is_single: bool,
) -> Vec<ProvenDegree> {
    let place = |sides: &Sides, v: u32| sides.place(v, is_single);
    let wanted_places: BTreeMap<_, u32> =
        out_of_range.iter().map(|v| (place(own, v.vertex), v.vertex)).collect();
    // The vertex of the part at the place of each.
    let mut corner_of = BTreeMap::new();
    for v in 0..part.mesh.positions().len() as u32 {
        if let Some(vertex) = wanted_places.get(&place(part, v)) {
            // Triangles use the first of equal points.
            corner_of.entry(*vertex).or_insert(v);
        }
    }
    let angle = rules.feature_angle.unwrap_or(SHARP);
    let mut of_part = sectors(part, corner_of.values().copied(), angle);
    // Edges of the mesh turn by more than half the angle along curves of the part.
    let mut of_own = sectors(own, corner_of.keys().copied(), 0.5 * angle);
    let mut proven = Vec::new();
    for &VertexDegree { vertex, degree, on_boundary } in out_of_range {
        let sectors = corner_of.get(&vertex).and_then(|corner| of_part.remove(corner));
        let (Some(sectors), Some(found)) = (sectors, of_own.remove(&vertex)) else { continue };
        let is_needle = !on_boundary && sectors.len() == 1 && sectors[0] < 3.0 * rules.least_angle;
        let least = if is_needle { rules.least_angle.min(min_angle) } else { rules.least_angle };
        let allowed = allowed(&sectors, least)
            .map(|count| if on_boundary { count + 1 } else { count.max(3) });
        let wanted = wanted(rules, on_boundary);
        let is_forced = allowed[1] < *wanted.start() || allowed[0] > *wanted.end();
        if is_forced && found.len() >= sectors.len() && (allowed[0]..=allowed[1]).contains(&degree)
        {
            proven.push(ProvenDegree { vertex, degree, on_boundary, allowed, sectors });
        }
    }
    proven
}

/// How many triangles sectors have that have no angle below `least`, in degrees.
fn allowed(sectors: &[f64], least: f64) -> [u32; 2] {
    sectors.iter().fold([0, 0], |[low, high], angle| {
        let fewest = libm::ceil(angle / (180.0 - 2.0 * least) - ROUNDING).max(1.0) as u32;
        let most = libm::floor(angle / least + ROUNDING) as u32;
        [low + fewest, high + most.max(fewest)]
    })
}

/// The sectors at some vertices, as their angles in degrees: between edges that turn by more than an angle, lie on the
/// boundary or between groups, or have three triangles.
fn sectors(
    sides: &Sides,
    vertices: impl Iterator<Item = u32>,
    sharp: f64,
) -> BTreeMap<u32, Vec<f64>> {
    let mut stars: BTreeMap<u32, Vec<u32>> = vertices.map(|v| (v, Vec::new())).collect();
    for (t, corners) in (0_u32..).zip(sides.mesh.triangles()) {
        for v in corners {
            if let Some(star) = stars.get_mut(v) {
                star.push(t);
            }
        }
    }
    let group = |t: u32| sides.mesh.groups().partition_point(|group| group.triangles.end <= t);
    let cosine = libm::cos(sharp.to_radians());
    let sectors_of = |(v, star): (u32, Vec<u32>)| {
        let corners = |t: u32| sides.mesh.triangles()[t as usize];
        let mut sets = DisjointSets::new(star.len());
        let mut spokes: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for (i, &t) in (0_u32..).zip(&star) {
            corners(t).into_iter().filter(|other| *other != v).for_each(|other| {
                spokes.entry(other).or_default().push(i);
            });
        }
        for at_spoke in spokes.values() {
            let &[a, b] = at_spoke.as_slice() else { continue };
            let [t, u] = [a, b].map(|i| star[i as usize]);
            let turn = sides.normal(t).dot(sides.normal(u));
            if group(t) == group(u) && turn >= cosine {
                sets.join(a, b);
            }
        }
        let mut angles = BTreeMap::new();
        for (i, &t) in (0_u32..).zip(&star) {
            let at = corners(t).map(|v| sides.mesh.positions()[v as usize]);
            let corner = corners(t).iter().position(|other| *other == v).unwrap_or(0);
            let [x, a, b] = [0, 1, 2].map(|i| at[(corner + i) % 3]);
            let (p, q) = (a - x, b - x);
            let angle = libm::atan2(p.cross(q).length(), p.dot(q)).to_degrees();
            *angles.entry(sets.least(i)).or_insert(0.0) += angle;
        }
        (v, angles.into_values().collect())
    };
    stars.into_iter().map(sectors_of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_allow_what_their_sectors_do() {
        assert_eq!(allowed(&[60.0; 3], 35.0), [3, 3]);
        assert_eq!(allowed(&[90.0; 3], 35.0), [3, 6]);
        assert_eq!(allowed(&[45.0; 8], 35.0), [8, 8]);
        assert_eq!(allowed(&[220.0, 110.0 + 1e-9], 35.0), [3, 9]);
        // Sharper than the angle: one triangle all the same.
        assert_eq!(allowed(&[20.0], 35.0), [1, 1]);
    }
}
