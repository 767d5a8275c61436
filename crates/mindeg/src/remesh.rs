//! Surfaces in space meshed anew: 5 to 7 edges at every vertex off the boundary, features kept, the distance proven.
//!
//! [`remesh`] takes any manifold mesh, a [`Remesh`] says what is wanted. The result is judged by
//! [`verify::surface()`](crate::verify::surface()), which shares no code with what made it.
//!
//! ```
//! use mindeg::remesh::{Remesh, remesh};
//! use mindeg::{Progress, TriMesh, glam::DVec3};
//!
//! // A cube: bits 0 to 2 of a vertex are its x, y and z.
//! let at = |v: u32| DVec3::from([v & 1, v >> 1 & 1, v >> 2].map(f64::from));
//! let sides = [[0, 2, 1, 3], [4, 5, 6, 7], [0, 1, 4, 5], [2, 6, 3, 7], [0, 4, 2, 6], [1, 3, 5, 7]];
//! let triangles = sides.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [b, d, c]]).collect();
//! let part = TriMesh::new((0..8).map(at).collect(), triangles)?;
//! let found = remesh(&part, &Remesh { size: Some(0.25), ..Remesh::default() }, Progress::NONE)?;
//! assert!(found.reached.off_degree.is_empty() && found.defects().next().is_none());
//! assert!(found.verified.to_part.upper < 1e-9 && found.verified.from_part.upper < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Limits: manifold surfaces whose triangles face the same way. Degrees and angles come from a search; what is proven
//! is the distance.

use std::collections::BTreeSet;

use glam::DVec3;
pub use mindeg_interior::{CornerLimit, OffDegree, RemeshError, RemeshOptions, RemeshReport};
use mindeg_interior::{Remeshed, remesh as search};
use mindeg_mesh::distance::{DistanceBound, distance_bound};
use mindeg_mesh::{Bounds, Cancelled, Group, Progress, TriMesh, TriMeshError};
use mindeg_surfaces::{FeatureRules, SizeRules, Spot, Surface};
pub use mindeg_surfaces::{SurfaceError, SurfaceFault};

use crate::verify::{self, MeshDefect, SurfaceRules, VerifiedSurface, short};

/// What is wanted of a remesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Remesh {
    /// The edge length where neither curvature nor near features ask for less, in units of length. `None`: the lesser of
    /// the part's mean edge and a twentieth of its diagonal.
    pub size: Option<f64>,
    /// About this many vertices, instead of a size.
    pub vertices: Option<u32>,
    /// How far the surfaces may be apart, both ways, in units of length. `None`: as near as the size allows.
    pub tolerance: Option<f64>,
    /// Edges that turn by more than this angle, in degrees, are features; at 180 none is.
    pub feature_angle: f64,
    /// The minimum angle aimed at, in degrees, 0 to 60. `None`: 35.
    pub target_angle: Option<f64>,
    /// Whether the edges of the boundary stay bit for bit.
    pub keep_boundary: bool,
    /// The same for all other features.
    pub keep_features: bool,
}

impl Default for Remesh {
    /// Features from 40°; all else as the part suggests.
    fn default() -> Self {
        Self {
            size: None,
            vertices: None,
            tolerance: None,
            feature_angle: 40.0,
            target_angle: None,
            keep_boundary: false,
            keep_features: false,
        }
    }
}

/// A mesh of a surface, and what it is like.
#[derive(Clone, Debug, PartialEq)]
pub struct RemeshedPart {
    /// The mesh. Its groups are those of the part.
    pub mesh: TriMesh,
    /// What the search reached: degrees, angles, and the corners that limit them.
    pub reached: RemeshReport,
    /// What the checker found.
    pub verified: VerifiedSurface,
    /// How far feature curves of the part are from those of the mesh, and back; `None` without curves.
    pub curves: Option<[DistanceBound; 2]>,
    /// The feature curves and corners of the part, and the patches between them.
    pub features: FeatureCounts,
    /// The contents of the part that the mesh lacks, one phrase each.
    pub dropped: Vec<&'static str>,
    /// The tolerance that was asked for, with what rounding may add.
    tolerance: Option<f64>,
}

/// The features of a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FeatureCounts {
    /// The curves, those of the boundary among them.
    pub curves: usize,
    /// The corners.
    pub corners: usize,
    /// The patches between curves.
    pub patches: usize,
}

impl RemeshedPart {
    /// Why the mesh may not take the place of the part: it is too far, crosses itself, or is turned over. Degrees and
    /// angles do not count.
    pub fn defects(&self) -> impl Iterator<Item = MeshDefect> + '_ {
        let defects = self.verified.defects.iter().filter(|defect| defect.kind != "degree");
        let curves = self.curves.iter().flatten();
        let farthest = curves.map(|bound| bound.upper).fold(0.0, f64::max);
        let is_far = |tolerance: &f64| farthest > *tolerance;
        let curves = self.tolerance.filter(is_far).map(|tolerance| {
            let message = format!(
                "feature curves are off by up to {}; the tolerance is {}",
                short(farthest),
                short(tolerance)
            );
            MeshDefect::new("features", message)
        });
        defects.cloned().chain(curves)
    }

    /// The farthest that any point is off, both ways, curves included: no point is farther.
    #[must_use]
    pub fn distance(&self) -> f64 {
        let VerifiedSurface { to_part, from_part, boundaries, .. } = &self.verified;
        let lines = [boundaries, &self.curves].into_iter().flatten().flatten();
        lines.chain([to_part, from_part]).map(|bound| bound.upper).fold(0.0, f64::max)
    }
}

/// Why a part was not meshed anew.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PartError {
    /// The part is no manifold surface.
    #[error("the part is no surface: {0}")]
    NoSurface(#[from] SurfaceError),
    /// A wish has no meaning.
    #[error("{0}")]
    BadOption(String),
    /// The search failed. This is a defect of mindeg.
    #[error(transparent)]
    Search(#[from] RemeshError),
    /// The result has more points than a mesh.
    #[error(transparent)]
    TooLarge(#[from] TriMeshError),
    /// The callback broke.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// The size without another wish is at most this share of the diagonal.
const SHARE: f64 = 0.05;
/// Lines of sharp edges that end somewhere and have fewer sizes than this are no features.
const SHORTEST: f64 = 3.0;
/// The search aims at this share of the tolerance: it samples, the checker bounds.
const AIM: f64 = 0.8;
/// The search has this share of the vertices that sizes ask for: 0.89 to 0.94 on five models.
const REACHED: f64 = 0.93;
/// A tolerance makes edges no shorter than this share of the size: more vertices than that nobody asked for.
const SHRINK: f64 = 0.3;
/// How often the search is done with a stricter aim.
const REPEATS: u32 = 4;
/// Distances below this share of the diagonal count as none; see [`SurfaceRules::tolerance`].
const NOTHING: f64 = 1e-8;

/// Meshes a part anew.
///
/// Where a tolerance is asked for and the result does not keep it, the search is repeated with shorter edges, unless that
/// takes edges shorter than 0.3 sizes; the last result is returned, and [`RemeshedPart::defects`] says what it lacks. Equal input gives equal bytes.
///
/// # Errors
///
/// A part that is no manifold surface, with all places; a wish without a meaning; and a `progress` that cancels.
pub fn remesh(
    part: &TriMesh,
    wish: &Remesh,
    progress: Progress<'_>,
) -> Result<RemeshedPart, PartError> {
    let bounds = Bounds::of_space(part.positions().iter().copied());
    let diagonal = bounds.map_or(0.0, |bounds| bounds.size().length());
    check(wish)?;
    let mut size = match (wish.size, wish.vertices) {
        (Some(size), _) => size,
        (None, Some(count)) => size_of(area(part), count),
        (None, None) => mean_edge(part).min(SHARE * diagonal),
    };
    let rules = FeatureRules {
        angle_deg: wish.feature_angle,
        shortest: SHORTEST * size,
        ..FeatureRules::default()
    };
    let group_of: Vec<u32> = (0_u32..)
        .zip(part.groups())
        .flat_map(|(index, group)| group.triangles.clone().map(move |_| index))
        .collect();
    let surface = Surface::new(part.positions(), part.triangles(), &group_of, &rules)?;
    if let (None, Some(count)) = (wish.size, wish.vertices) {
        size = size_for(&surface, count, size, progress)?;
    }
    let tolerance = wish.tolerance.map(|tolerance| tolerance + NOTHING * diagonal);
    let mut options = RemeshOptions {
        size: Some(size),
        tolerance: wish.tolerance.map(|tolerance| AIM * tolerance),
        target_angle: wish.target_angle,
        keep_boundary: wish.keep_boundary,
        keep_features: wish.keep_features,
    };
    // A tolerance of zero is for surfaces of planes, which need no aim.
    options.tolerance = options.tolerance.filter(|aim| *aim > NOTHING * diagonal);
    let mut repeat = 0;
    loop {
        repeat += 1;
        let found = search(&surface, &options, progress)?;
        let judged = judged(part, &surface, found, wish, tolerance, progress)?;
        let distance = judged.distance();
        let Some(tolerance) = tolerance.filter(|tolerance| distance > *tolerance) else {
            return Ok(judged);
        };
        let factor = (tolerance / distance).min(0.9);
        // An edge across a bend is as far off as it is long; one on a curved surface as its square.
        let shorter = if repeat > 1 { factor } else { factor.sqrt() };
        let next = options.size.map(|old| old * shorter).filter(|next| *next >= SHRINK * size);
        if next.is_none() || options.tolerance.is_none() || repeat == REPEATS {
            return Ok(judged);
        }
        options.size = next;
        options.tolerance = options.tolerance.map(|aim| aim * factor);
    }
}

fn check(wish: &Remesh) -> Result<(), PartError> {
    let Remesh { size, vertices, tolerance, feature_angle, target_angle, .. } = wish;
    let refused = |words: String| Err(PartError::BadOption(words));
    match (size, vertices, tolerance, target_angle) {
        (Some(_), Some(_), ..) => {
            refused("give a size or a number of vertices, not both".to_owned())
        }
        (Some(size), ..) if !(*size > 0.0 && size.is_finite()) => {
            refused(format!("the size is {size}; give a length above 0"))
        }
        (_, Some(0..4), ..) => refused("a surface has 4 vertices at least".to_owned()),
        (_, _, Some(tolerance), _) if !(*tolerance >= 0.0 && tolerance.is_finite()) => {
            refused(format!("the tolerance is {tolerance}; give a length, 0 or more"))
        }
        (.., Some(angle)) if !(*angle > 0.0 && *angle < 60.0) => {
            refused(format!("the target angle is {angle}; give degrees between 0 and 60"))
        }
        _ if !(0.0..=180.0).contains(feature_angle) => {
            refused(format!("the feature angle is {feature_angle}; give degrees from 0 to 180"))
        }
        _ => Ok(()),
    }
}

fn corners(part: &TriMesh) -> impl Iterator<Item = [DVec3; 3]> {
    part.triangles().iter().map(|t| t.map(|v| part.positions()[v as usize]))
}

fn area(part: &TriMesh) -> f64 {
    corners(part).map(|[a, b, c]| 0.5 * (b - a).cross(c - a).length()).sum()
}

fn mean_edge(part: &TriMesh) -> f64 {
    let sum: f64 =
        corners(part).map(|[a, b, c]| a.distance(b) + b.distance(c) + c.distance(a)).sum();
    sum / (3 * part.triangles().len()) as f64
}

/// The edge length at which equilateral triangles on an area have this many vertices.
fn size_of(area: f64, vertices: u32) -> f64 {
    (area / (f64::from(vertices) * 0.5 * 3.0_f64.sqrt())).sqrt()
}

/// The size at which the sizes of a surface ask for this many vertices.
fn size_for(
    surface: &Surface,
    vertices: u32,
    start: f64,
    progress: Progress<'_>,
) -> Result<f64, Cancelled> {
    let mut size = start;
    for _ in 0..4 {
        let fine = surface.refined(&SizeRules::of_size(size), progress)?;
        let share = |corners: &[u32; 3]| {
            let [a, b, c] = corners.map(|v| fine.points()[v as usize]);
            let mean = corners.iter().map(|v| fine.size(*v)).sum::<f64>() / 3.0;
            (b - a).cross(c - a).length() / (3.0_f64.sqrt() * mean * mean)
        };
        let expected = REACHED * fine.triangles().iter().map(share).sum::<f64>();
        size *= (expected / f64::from(vertices)).sqrt();
    }
    Ok(size)
}

/// The mesh in groups, with what the checker finds.
fn judged(
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
    let mesh = match mindeg_mesh::Triangles::name(part) {
        Some(name) => mesh.named(name),
        None => mesh,
    };
    let rules = SurfaceRules {
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
        ("lines", part.segments().is_empty()),
        ("names of points", mindeg_mesh::Triangles::named_vertices(part).is_empty()),
        ("faces with more than three corners", part.polygons().is_none()),
    ];
    let dropped =
        dropped.into_iter().filter(|(_, is_kept)| !is_kept).map(|(what, _)| what).collect();
    Ok(RemeshedPart { mesh, reached: found.report, verified, curves, features, dropped, tolerance })
}

/// The ends of a segment by their bits, the lesser first.
fn bits(&[from, _, to]: &[DVec3; 3]) -> [[u64; 3]; 2] {
    // Adding zero turns -0 into 0.
    let mut ends = [from, to].map(|end| (end + DVec3::ZERO).to_array().map(f64::to_bits));
    ends.sort_unstable();
    ends
}
