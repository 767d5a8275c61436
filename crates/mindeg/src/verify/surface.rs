//! Whether a mesh is a remesh of a part: its degrees, its distance from the part, and what it must keep.
//!
//! Nothing here is shared with what makes such meshes: topology is that of [`mindeg_mesh::inspection`], distances are
//! bounded by [`mindeg_mesh::distance`], crossings found by [`mindeg_mesh::crossing`].

use std::collections::BTreeSet;

use glam::DVec3;
use mindeg_mesh::crossing::crossings;
use mindeg_mesh::distance::{DistanceBound, distance_bound, distance_to};
use mindeg_mesh::inspection::{Inspection, InspectionOptions, VertexDegree};
use mindeg_mesh::parallel::map_chunks;
use mindeg_mesh::quality::TriangleQuality;
use mindeg_mesh::{Bounds, BoxTree, Cancelled, Progress, TriMesh, number};

use super::defect::{MeshDefect, in_space};
use super::degrees::{Degrees, ProvenDegree};
use super::rules::SurfaceRules;
use super::sides::{Sides, check_kept};

/// Distances below this share of the part's diagonal count as none.
const NOTHING: f64 = 1e-8;

/// The figures of a mesh beside the part it was made from. Vertices and triangles have the indices of the mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct VerifiedSurface {
    /// The number of vertices that triangles use; those in one place count as one.
    pub vertices: usize,
    /// The number of triangles.
    pub triangles: usize,
    /// The least and greatest degree off the boundary; `None` without such a vertex.
    pub inside: Option<[u32; 2]>,
    /// The least and greatest degree on the boundary.
    pub boundary: Option<[u32; 2]>,
    /// The vertices with another degree than the rules ask for, ascending.
    pub out_of_range: Vec<VertexDegree>,
    /// The vertices with a degree that is proven to be as it should at a corner of the part, though out of the range of
    /// the others, ascending.
    pub proven: Vec<ProvenDegree>,
    /// The minimum angle, in degrees, and its triangle.
    pub min_angle: (f64, u32),
    /// How far points of the mesh are from the part.
    pub to_part: DistanceBound,
    /// How far points of the part are from the mesh.
    pub from_part: DistanceBound,
    /// The same for their boundaries, if one of them has a boundary: from the mesh's, and from the part's.
    pub boundaries: Option<[DistanceBound; 2]>,
    /// How far sharp edges of the part are from sharp edges of the mesh, if the rules ask.
    pub features: Option<DistanceBound>,
    /// Pairs of triangles that cross; if the part has some, too, they are no defect.
    pub crossings: Vec<[u32; 2]>,
    /// The number of triangles of the part that cross others.
    pub part_crossings: usize,
    /// All that is wrong; empty if the mesh keeps every rule.
    pub defects: Vec<MeshDefect>,
}

/// Compares a mesh with a part.
///
/// Distances are bounds that hold for all points, not for samples; a distance whose lower bound keeps the tolerance and
/// whose upper bound does not counts as too large. O(n log n) for meshes near the part; shared by all threads.
///
/// # Errors
///
/// [`Cancelled`], if the callback breaks.
///
/// # Example
///
/// ```
/// use mindeg::verify::{self, SurfaceRules};
/// use mindeg::{Progress, TriMesh, glam::DVec3};
///
/// let points = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
/// let part = TriMesh::new(points, vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])?;
/// let rules = SurfaceRules { inside: 3..=7, ..SurfaceRules::within(0.0) };
/// let found = verify::surface(&part, &part, &rules, Progress::NONE)?;
/// assert_eq!((found.inside, found.defects.len()), (Some([3, 3]), 0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn surface(
    mesh: &TriMesh,
    part: &TriMesh,
    rules: &SurfaceRules,
    progress: Progress<'_>,
) -> Result<VerifiedSurface, Cancelled> {
    let is_single = mesh.rounding() > 2.0 * f64::EPSILON * largest(mesh);
    let part = &Sides::of(part);
    let own = &Sides::of(mesh);
    let tolerance = rules.tolerance
        + NOTHING
            * Bounds::of_space(part.corners.iter().flatten().copied())
                .map_or(0.0, |bounds| bounds.size().length());
    let mut defects = Vec::new();
    let inspection = Inspection::of(&own.mesh, &InspectionOptions::default());
    check_topology(&inspection, [own, part], is_single, &mut defects);
    let min_angle = min_angle(own);
    let degrees = Degrees::of(own, part, rules, min_angle.0, is_single);
    degrees.check(own, rules, &mut defects);

    let to_part = distance_bound(&own.corners, &part.corners, progress)?;
    let from_part = distance_bound(&part.corners, &own.corners, progress)?;
    let mut check = |kind, what: &str, bound: &DistanceBound| {
        if bound.upper > tolerance {
            let place = in_space(bound.place);
            let message = match bound.lower > tolerance {
                true => format!(
                    "{what} by {}, at {place}; the tolerance is {}",
                    number(bound.lower),
                    number(rules.tolerance)
                ),
                false => format!(
                    "{what} by at most {}, near {place}; that it keeps the tolerance of {} is not proven",
                    number(bound.upper),
                    number(rules.tolerance)
                ),
            };
            defects.push(MeshDefect::new(kind, message));
        }
    };
    check("distance", "the mesh is off the part", &to_part);
    check("distance_from_part", "the part is off the mesh", &from_part);
    let boundaries = match own.boundary.is_empty() && part.boundary.is_empty() {
        true => None,
        false => {
            let [own, part] = [own, part].map(|sides| sides.segments(&sides.boundary));
            let there = distance_bound(&own, &part, progress)?;
            let back = distance_bound(&part, &own, progress)?;
            check("boundary", "the boundary of the mesh is off that of the part", &there);
            check("boundary", "the boundary of the part is off that of the mesh", &back);
            Some([there, back])
        }
    };
    let features = match rules.feature_angle {
        Some(angle) => {
            let [sharp, found] = [part.sharp(angle), own.sharp(0.5 * angle)];
            let bound = distance_bound(&part.segments(&sharp), &own.segments(&found), progress)?;
            check("features", "sharp edges of the part are off those of the mesh", &bound);
            if rules.keep_features {
                check_kept(
                    "features_changed",
                    "sharp edges",
                    [part, own],
                    [&sharp, &own.edges],
                    is_single,
                    &mut defects,
                );
            }
            Some(bound)
        }
        None => None,
    };
    if rules.keep_boundary {
        let kind = "boundary_changed";
        check_kept(
            kind,
            "boundary edges",
            [part, own],
            [&part.boundary, &own.boundary],
            is_single,
            &mut defects,
        );
        if own.boundary.len() > part.boundary.len() {
            let message = format!(
                "the mesh has {} boundary edges, the part {}",
                own.boundary.len(),
                part.boundary.len()
            );
            defects.push(MeshDefect::new(kind, message));
        }
    }
    check_flips(own, part, tolerance, &mut defects);
    let [crossed, part_crossings] = [own, part].map(|sides| {
        crossings(sides.mesh.positions(), sides.mesh.triangles(), 0..sides.corners.len() as u32)
    });
    if let (Some([a, b]), true) = (crossed.first(), part_crossings.is_empty()) {
        let message = format!(
            "{} triangles cross others, the first are {a} and {b}; no triangles of the part do",
            crossed.len()
        );
        defects.push(MeshDefect::new("crossing", message));
    }
    Ok(VerifiedSurface {
        vertices: degrees.vertices,
        triangles: own.corners.len(),
        inside: degrees.inside,
        boundary: degrees.boundary,
        out_of_range: degrees.out_of_range,
        proven: degrees.proven,
        min_angle,
        to_part,
        from_part,
        boundaries,
        features,
        crossings: crossed,
        part_crossings: part_crossings.len(),
        defects,
    })
}

fn largest(mesh: &TriMesh) -> f64 {
    mesh.positions().iter().map(|p| p.abs().max_element()).fold(0.0, f64::max)
}

fn check_topology(
    inspection: &Inspection,
    [own, part]: [&Sides; 2],
    is_single: bool,
    defects: &mut Vec<MeshDefect>,
) {
    let mut defect = |kind, count: usize, what: &str| {
        if count > 0 {
            defects.push(MeshDefect::new(kind, format!("{count} {what}")));
        }
    };
    let edge = |edges: &[[u32; 2]]| match edges {
        [] => String::new(),
        [[a, b], ..] => format!(", the first at vertices {a} and {b}"),
    };
    let first = |items: &[u32]| {
        items.first().map_or(String::new(), |item| format!(", the first is {item}"))
    };
    let Inspection { non_manifold_edges, inconsistent_edges, .. } = inspection;
    let what = format!("edges have three triangles or more{}", edge(non_manifold_edges));
    defect("not_manifold", non_manifold_edges.len(), &what);
    let mut fans = inspection.non_manifold_vertices.clone();
    if !fans.is_empty() {
        // Where the part touches itself in a point, so does the mesh.
        let of_part = Inspection::of(&part.mesh, &InspectionOptions::default());
        let places = of_part.non_manifold_vertices.iter();
        let touches: BTreeSet<_> = places.map(|v| part.place(*v, is_single)).collect();
        fans.retain(|v| !touches.contains(&own.place(*v, is_single)));
    }
    defect("not_manifold", fans.len(), &format!("vertices have several fans{}", first(&fans)));
    let what = format!("edges have triangles that face opposite ways{}", edge(inconsistent_edges));
    defect("inconsistent", inconsistent_edges.len(), &what);
    let flat = &inspection.zero_area_triangles;
    defect("no_area", flat.len(), &format!("triangles have no area{}", first(flat)));
}

/// A triangle is turned over if no triangle of the part near its middle faces the same way.
fn check_flips(own: &Sides, part: &Sides, tolerance: f64, defects: &mut Vec<MeshDefect>) {
    let around = |&[a, b, c]: &[DVec3; 3]| Bounds { min: a.min(b).min(c), max: a.max(b).max(c) };
    let tree = BoxTree::new(part.corners.iter().map(around).collect());
    let normal = |&[a, b, c]: &[DVec3; 3]| (b - a).cross(c - a);
    let found = map_chunks(0..own.corners.len(), 256, |chunk| {
        let is_flipped = |t: &usize| {
            let [a, b, c] = own.corners[*t];
            let (middle, facing) = ((a + b + c) / 3.0, normal(&own.corners[*t]));
            let squared = |other: u32| {
                let distance = distance_to(middle, &part.corners[other as usize]);
                distance * distance
            };
            let of_facing = |other: u32| match normal(&part.corners[other as usize]).dot(facing) {
                cosine if cosine > 0.0 => squared(other),
                _ => f64::INFINITY,
            };
            let nearest = tree.nearest(middle, f64::INFINITY, squared);
            let nearest = nearest.map_or(0.0, |(_, squared)| squared.sqrt());
            let reach = tolerance.max(nearest) * (1.0 + 1e-9);
            // The nearest that faces the same way: of all within reach there may be very many.
            tree.nearest(middle, reach * reach, of_facing).is_none()
        };
        chunk.filter(is_flipped).collect::<Vec<usize>>()
    });
    let flipped = found.concat();
    if let Some(first) = flipped.first() {
        let count = flipped.len();
        let message = format!("{count} triangles are turned over, the first is {first}");
        defects.push(MeshDefect::new("turned_over", message));
    }
}

/// The minimum angle and its triangle.
fn min_angle(sides: &Sides) -> (f64, u32) {
    let angles = (0_u32..)
        .zip(&sides.corners)
        .map(|(t, &[a, b, c])| (TriangleQuality::in_space(a, b, c).min_angle, t));
    angles.reduce(|a, b| if b.0 < a.0 { b } else { a }).unwrap_or((0.0, 0))
}
