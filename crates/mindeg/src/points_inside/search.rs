//! The search for a surface with points inside, at the size of its rims and as smooth as the mesh around allows.
//!
//! A surface without points is where it begins. It is meshed as a surface whose other faces, those around the
//! rims, are kept edge by edge, so that the degrees of the rims count; its points then move to where the surface bends
//! least, and both are done once more, as lengths changed. A tube is meshed once, over curves from rim to rim. Where a rim waves so much that a surface that leaves it in the direction of
//! the mesh folds, the next one may bend more there, and the last bends as it likes.

use std::collections::{BTreeMap, BTreeSet};

use glam::DVec3;
use mindeg_interior::{RemeshError, RemeshOptions, Remeshed, remesh};
use mindeg_mesh::crossing::crossings;
use mindeg_mesh::quality::min_angle;
use mindeg_mesh::{Progress, edges_of, sorted};
use mindeg_surfaces::{FeatureRules, Given, Surface};

use super::fairing::{Patch, faired};
use super::no_points::NoPoints;
use super::tube::tube;

/// How often the surface is meshed and faired.
const ROUNDS: usize = 2;
/// How much the bend at a rim counts beside that inside, one after the other until nothing folds.
const AT_RIM: [f64; 3] = [1.0, 0.1, 0.0];
/// How much a tube follows the mesh at its ends, one after the other until nothing folds.
const LEAVING: [f64; 3] = [1.0, 0.5, 0.0];
/// The cosine of the turn between two triangles inside beyond which they are folded: 120°.
const FOLDED: f64 = -0.5;
/// Below this minimum angle, in degrees, the surface is meshed once more.
const THIN: f64 = 30.0;
/// The reason where each surface folds.
const FOLDS: &str = "with points inside, it would fold";
/// Groups of triangles: those around the rims, and those between.
const AROUND: u32 = 0;
const FILLING: u32 = 1;

/// The points and triangles of a tube over a strip between two rims: `points` first, as they are, then those inside.
pub(crate) fn tube_searched(
    points: &[DVec3],
    around: &[[u32; 3]],
    strip: &[[u32; 3]],
    is_first: impl Fn(u32) -> bool,
    size: f64,
    progress: Progress<'_>,
) -> Result<(Vec<DVec3>, Vec<[u32; 3]>), NoPoints> {
    for leaving in LEAVING {
        let (all, patch) = tube(points, around, strip, &is_first, leaving, size);
        let found = remeshed(&all, around, &patch, size, progress)?;
        let (points, patch) = ordered(points, &found)?;
        if !is_folded(&points, around, &patch) {
            return Ok((points, patch));
        }
    }
    Err(NoPoints::Because(FOLDS.to_owned()))
}

/// The points and triangles of a filling: `points` first, as they are, then those inside.
pub(crate) fn searched(
    points: Vec<DVec3>,
    around: &[[u32; 3]],
    plain: Vec<[u32; 3]>,
    rim: &BTreeSet<u32>,
    size: f64,
    progress: Progress<'_>,
) -> Result<(Vec<DVec3>, Vec<[u32; 3]>), NoPoints> {
    for at_rim in AT_RIM {
        let (mut points, mut patch) = (points.clone(), plain.clone());
        let known = points.len();
        for _ in 0..ROUNDS {
            let found = remeshed(&points, around, &patch, size, progress)?;
            (points, patch) = ordered(&points[..known], &found)?;
            let whole: Vec<[u32; 3]> = around.iter().chain(&patch).copied().collect();
            let of = Patch { triangles: &whole, fixed: known, rim, at_rim };
            points = faired(points, &of, progress)?;
        }
        if is_folded(&points, around, &patch) {
            continue;
        }
        // Where the points moved far, their triangles are no longer as good as they were.
        let angle = min_angle(&points, &patch);
        if angle < THIN {
            let found = remeshed(&points, around, &patch, size, progress)?;
            let (again, other) = ordered(&points[..known], &found)?;
            if min_angle(&again, &other) > angle && !is_folded(&again, around, &other) {
                return Ok((again, other));
            }
        }
        return Ok((points, patch));
    }
    Err(NoPoints::Because(FOLDS.to_owned()))
}

/// Whether triangles between the rims cross others, or turn back over those beside them.
fn is_folded(points: &[DVec3], around: &[[u32; 3]], patch: &[[u32; 3]]) -> bool {
    let normal = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|v| points[v as usize]);
        (b - a).cross(c - a).normalize_or_zero()
    };
    let mut edges: Vec<([u32; 2], DVec3)> = Vec::with_capacity(3 * patch.len());
    for triangle in patch {
        let normal = normal(triangle);
        edges.extend(edges_of(*triangle).map(|edge| (sorted(edge), normal)));
    }
    edges.sort_by_key(|(edge, _)| *edge);
    let turns_back = edges
        .chunk_by(|a, b| a.0 == b.0)
        .any(|two| matches!(two, [(_, one), (_, other)] if one.dot(*other) < FOLDED));
    let whole: Vec<[u32; 3]> = around.iter().chain(patch).copied().collect();
    turns_back || !crossings(points, &whole, around.len() as u32..whole.len() as u32).is_empty()
}

/// The filling meshed anew, the faces around it as they are.
fn remeshed(
    points: &[DVec3],
    around: &[[u32; 3]],
    patch: &[[u32; 3]],
    size: f64,
    progress: Progress<'_>,
) -> Result<Remeshed, NoPoints> {
    let triangles: Vec<[u32; 3]> = around.iter().chain(patch).copied().collect();
    let groups = [vec![AROUND; around.len()], vec![FILLING; patch.len()]].concat();
    let edges: Vec<[u32; 2]> = around.iter().copied().flat_map(edges_of).collect();
    let given = Given { groups: &groups, edges: &edges, corners: &[] };
    let rules = FeatureRules { angle_deg: 180.0, ..FeatureRules::default() };
    let surface = Surface::keeping(points, &triangles, &given, &rules)
        .map_err(|error| NoPoints::Because(error.to_string()))?;
    let options = RemeshOptions {
        size: Some(size),
        keep_boundary: true,
        keep_features: true,
        ..RemeshOptions::default()
    };
    let mut found = remesh(&surface, &options, progress).map_err(|error| match error {
        RemeshError::Cancelled => NoPoints::Cancelled,
        error => NoPoints::Because(error.to_string()),
    })?;
    let mut groups = found.patches.iter().map(|patch| surface.group(*patch));
    found.triangles.retain(|_| groups.next() == Some(FILLING));
    Ok(found)
}

/// The points and triangles of a filling, the points that stayed first and in their order.
fn ordered(stayed: &[DVec3], found: &Remeshed) -> Result<(Vec<DVec3>, Vec<[u32; 3]>), NoPoints> {
    // Adding zero turns -0 into 0.
    let bits = |point: &DVec3| (*point + DVec3::ZERO).to_array().map(f64::to_bits);
    let place: BTreeMap<[u64; 3], u32> = stayed.iter().map(bits).zip(0..).collect();
    let mut points = stayed.to_vec();
    let mut names = BTreeMap::new();
    let mut triangles = Vec::with_capacity(found.triangles.len());
    for triangle in &found.triangles {
        triangles.push(triangle.map(|v| {
            *names.entry(v).or_insert_with(|| {
                let point = found.points[v as usize];
                place.get(&bits(&point)).copied().unwrap_or_else(|| {
                    points.push(point);
                    points.len() as u32 - 1
                })
            })
        }));
    }
    match triangles.is_empty() {
        true => Err(NoPoints::Because("the filling fell apart".to_owned())),
        false => Ok((points, triangles)),
    }
}
