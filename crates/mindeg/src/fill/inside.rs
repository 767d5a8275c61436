//! Fillings with points inside: meshed at the size of the rim, and as smooth as the mesh around allows.
//!
//! The filling of least area is where the search begins. It is meshed as a surface whose other faces, those around the
//! rim, are kept edge by edge, so that the degrees of the rim count; its points then move to where the surface bends
//! least, and both are done once more, as lengths changed.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use glam::DVec3;
use mindeg_interior::{RemeshError, RemeshOptions, Remeshed, remesh};
use mindeg_mesh::{Cancelled, Positions, Progress, TriMesh};
use mindeg_surfaces::{FeatureRules, Given, Surface};

use super::fairing::{Patch, faired};
use crate::loops::{Loops, MeshLoop};

/// How often the filling is meshed and faired.
const ROUNDS: usize = 2;
/// The edges that a vertex of the filling or of its rim should have.
const DEGREES: [u32; 2] = [5, 7];
/// Groups of triangles: those around the rim, and those of the filling.
const AROUND: u32 = 0;
const FILLING: u32 = 1;

/// The points inside a filled loop, and the degrees that they and the rim have.
#[derive(Clone, Debug, PartialEq)]
pub struct PointsInside {
    /// The vertices that were added, by their indices in the mesh.
    pub vertices: Range<u32>,
    /// The least and the greatest total degree of the vertices inside and on the rim.
    pub degrees: [u32; 2],
    /// Vertices with other degrees than 5 to 7, with their degrees; on the rim, those that have more than 7 or fewer than 5
    /// edges now and are not on another boundary.
    pub off_degree: Vec<[u32; 2]>,
}

/// A filling: new points, and triangles that name them after all vertices of the mesh.
pub(super) struct Filling {
    pub(super) points: Vec<DVec3>,
    pub(super) triangles: Vec<[u32; 3]>,
}

/// Why a filling has no points inside.
pub(super) enum NoPoints {
    Cancelled,
    Because(String),
}

impl From<Cancelled> for NoPoints {
    fn from(_: Cancelled) -> Self {
        Self::Cancelled
    }
}

/// The triangles at the vertices of loops.
pub(super) struct Around(BTreeMap<u32, Vec<[u32; 3]>>);

impl Around {
    /// Those of a mesh, with vertices of equal coordinates as one. O(n log n).
    pub(super) fn of(mesh: &TriMesh, loops: &Loops, all: &[MeshLoop]) -> Self {
        let vertices = all.iter().flat_map(|found| &found.vertices);
        let mut around = Self(vertices.map(|v| (*v, Vec::new())).collect());
        if !around.0.is_empty() {
            around.add(&loops.merged(mesh.triangles()));
        }
        around
    }

    /// The same with further triangles.
    pub(super) fn add(&mut self, triangles: &[[u32; 3]]) {
        for triangle in triangles {
            for vertex in triangle {
                if let Some(own) = self.0.get_mut(vertex) {
                    own.push(*triangle);
                }
            }
        }
    }

    /// A filling with points inside. `plain` is that of least area; new points are named from `next` on.
    pub(super) fn meshed(
        &self,
        mesh: &TriMesh,
        rim: &[u32],
        plain: &[[u32; 3]],
        next: usize,
        progress: Progress<'_>,
    ) -> Result<Filling, NoPoints> {
        if mesh.has_depths() {
            let reason =
                "points inside would have no depths; mindeg stitch fills the gap of such a mesh";
            return Err(NoPoints::Because(reason.to_owned()));
        }
        let at = |v: u32| mesh.positions()[v as usize];
        let lengths = (0..rim.len()).map(|i| at(rim[i]).distance(at(rim[(i + 1) % rim.len()])));
        let size = lengths.sum::<f64>() / rim.len() as f64;
        let mut around: Vec<[u32; 3]> = rim.iter().flat_map(|v| &self.0[v]).copied().collect();
        around.sort_unstable();
        around.dedup();
        // The vertices in hand, by their indices in the mesh.
        let known: BTreeSet<u32> = around.iter().chain(plain).flatten().copied().collect();
        let known: Vec<u32> = known.into_iter().collect();
        let local = |v: &u32| known.partition_point(|other| other < v) as u32;
        let named = |triangles: &[[u32; 3]]| -> Vec<[u32; 3]> {
            triangles.iter().map(|t| t.each_ref().map(local)).collect()
        };
        let around = named(&around);
        let is_rim: BTreeSet<u32> = rim.iter().map(local).collect();
        let mut points: Vec<DVec3> = known.iter().map(|v| at(*v)).collect();
        let mut patch = named(plain);
        for _ in 0..ROUNDS {
            let found = remeshed(&points, &around, &patch, size, progress)?;
            (points, patch) = ordered(&points[..known.len()], &found)?;
            let whole: Vec<[u32; 3]> = around.iter().chain(&patch).copied().collect();
            let of = Patch { triangles: &whole, fixed: known.len(), rim: &is_rim };
            points = faired(points, &of, progress)?;
        }
        let new = |v: u32| v - known.len() as u32 + next as u32;
        let name = |v: u32| known.get(v as usize).copied().unwrap_or_else(|| new(v));
        let triangles = patch.iter().map(|t| t.map(name)).collect();
        Ok(Filling { points: points.split_off(known.len()), triangles })
    }
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

impl PointsInside {
    /// Before its degrees are known.
    pub(super) fn of(vertices: Range<u32>) -> Self {
        Self { vertices, degrees: [0; 2], off_degree: Vec::new() }
    }

    /// Finds its degrees. `degree` gives the total degree of a vertex, and whether it is on a boundary.
    pub(super) fn judge(&mut self, rim: &[u32], degree: impl Fn(u32) -> (u32, bool)) {
        let [low, high] = DEGREES;
        let (mut least, mut most) = (u32::MAX, 0);
        for vertex in rim.iter().copied().chain(self.vertices.clone()) {
            let (degree, is_open) = degree(vertex);
            (least, most) = (least.min(degree), most.max(degree));
            if degree > high || degree < low && !is_open {
                self.off_degree.push([vertex, degree]);
            }
        }
        self.degrees = [least, most];
    }
}
