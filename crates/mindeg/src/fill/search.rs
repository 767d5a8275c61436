//! The search for a filling with points inside, at the size of the rim and as smooth as the mesh around allows.
//!
//! The filling of least area is where it begins. It is meshed as a surface whose other faces, those around the
//! rim, are kept edge by edge, so that the degrees of the rim count; its points then move to where the surface bends
//! least, and both are done once more, as lengths changed.

use std::collections::{BTreeMap, BTreeSet};

use glam::DVec3;
use mindeg_interior::{RemeshError, RemeshOptions, Remeshed, remesh};
use mindeg_mesh::Progress;
use mindeg_surfaces::{FeatureRules, Given, Surface};

use super::fairing::{Patch, faired};
use super::no_points::NoPoints;

/// How often the filling is meshed and faired.
const ROUNDS: usize = 2;
/// Groups of triangles: those around the rim, and those of the filling.
const AROUND: u32 = 0;
const FILLING: u32 = 1;

/// The points and triangles of a filling: `points` first, as they are, then those inside.
pub(super) fn searched(
    mut points: Vec<DVec3>,
    around: &[[u32; 3]],
    plain: Vec<[u32; 3]>,
    rim: &BTreeSet<u32>,
    size: f64,
    progress: Progress<'_>,
) -> Result<(Vec<DVec3>, Vec<[u32; 3]>), NoPoints> {
    let (known, mut patch) = (points.len(), plain);
    for _ in 0..ROUNDS {
        let found = remeshed(&points, around, &patch, size, progress)?;
        (points, patch) = ordered(&points[..known], &found)?;
        let whole: Vec<[u32; 3]> = around.iter().chain(&patch).copied().collect();
        let of = Patch { triangles: &whole, fixed: known, rim };
        points = faired(points, &of, progress)?;
    }
    Ok((points, patch))
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
    let edges: Vec<[u32; 2]> =
        around.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
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
