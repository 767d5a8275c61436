//! Fillings with points inside: a filling of least area with the faces around its rim goes to the search of `search.rs`, and what
//! comes back is named and judged.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use glam::DVec3;
use mindeg_mesh::{Positions, Progress, TriMesh};

use super::no_points::NoPoints;
#[cfg(feature = "interior")]
use super::search::searched;
use crate::loops::{Loops, MeshLoop};

/// The edges that a vertex of the filling or of its rim should have.
const DEGREES: [u32; 2] = [5, 7];

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

/// The triangles at the vertices of loops.
pub(super) struct Around(BTreeMap<u32, Vec<[u32; 3]>>);

impl Around {
    /// The surroundings of loops in a mesh, with vertices of equal coordinates as one. O(n log n).
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
        let points: Vec<DVec3> = known.iter().map(|v| at(*v)).collect();
        let (mut points, patch) = searched(points, &around, named(plain), &is_rim, size, progress)?;
        let new = |v: u32| v - known.len() as u32 + next as u32;
        let name = |v: u32| known.get(v as usize).copied().unwrap_or_else(|| new(v));
        let triangles = patch.iter().map(|t| t.map(name)).collect();
        Ok(Filling { points: points.split_off(known.len()), triangles })
    }
}

/// Without the feature there is no search.
#[cfg(not(feature = "interior"))]
fn searched(
    _points: Vec<DVec3>,
    _around: &[[u32; 3]],
    _plain: Vec<[u32; 3]>,
    _rim: &BTreeSet<u32>,
    _size: f64,
    _progress: Progress<'_>,
) -> Result<(Vec<DVec3>, Vec<[u32; 3]>), NoPoints> {
    Err(NoPoints::Because(
        "this build has no points inside: it lacks the feature interior".to_owned(),
    ))
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
