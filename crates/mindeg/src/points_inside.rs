//! Points inside surfaces that go from rim to rim: the filling of a loop, the tube between two. A surface without any, with the faces
//! around its rims, goes to the search of `search.rs`, and what comes back is named and judged.

#[cfg(feature = "interior")]
mod fairing;
mod no_points;
#[cfg(feature = "interior")]
mod search;
#[cfg(feature = "interior")]
mod tube;

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use glam::DVec3;
use mindeg_mesh::{Positions, Progress, TriMesh};

pub(crate) use self::no_points::NoPoints;
#[cfg(feature = "interior")]
use self::search::{searched, tube_searched};
use crate::error::MeshError;
use crate::loops::Loops;

/// The edges that a vertex inside or on a rim should have.
const DEGREES: [u32; 2] = [5, 7];

/// The points inside, and the degrees that they and the rims have.
#[derive(Clone, Debug, PartialEq)]
pub struct PointsInside {
    /// The vertices that were added, by their indices in the mesh.
    pub vertices: Range<u32>,
    /// The least and the greatest total degree of the vertices inside and on the rims.
    pub degrees: [u32; 2],
    /// Vertices with other degrees than 5 to 7, with their degrees; on a rim, those that have more than 7 or fewer than 5
    /// edges now and are not on another boundary.
    pub off_degree: Vec<[u32; 2]>,
}

/// New points, and triangles that name them after all vertices of the mesh.
pub(crate) struct Filling {
    pub(crate) points: Vec<DVec3>,
    pub(crate) triangles: Vec<[u32; 3]>,
}

/// Points inside a surface between rims in space, which is given without a mesh.
///
/// `rims` are the rims' points one after the other, of which two are the ends of a tube, `plain` the triangles between them, by the indices of these points, and `around`
/// the triangles of the mesh beside the rims, by their corners; a corner is on a rim if it has the coordinates of a rim's point. Gives the
/// new points and the triangles, which name them after those of the rims.
///
/// # Errors
///
/// Why there are none, in a sentence; and a `progress` that cancels.
///
/// # Example
///
/// ```
/// use mindeg::{Progress, fill::points_between, glam::DVec3};
///
/// let turn = |i: u32| std::f64::consts::TAU * f64::from(i) / 24.0;
/// let rim: Vec<DVec3> = (0..24).map(|i| DVec3::new(turn(i).cos(), turn(i).sin(), 0.0)).collect();
/// let fan: Vec<[u32; 3]> = (1..23).map(|i| [0, i, i + 1]).collect();
/// let (points, triangles) = points_between(&[&rim], &fan, &[], Progress::NONE)?;
/// assert_eq!(triangles.len(), 22 + 2 * points.len());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn points_between(
    rims: &[&[DVec3]],
    plain: &[[u32; 3]],
    around: &[[DVec3; 3]],
    progress: Progress<'_>,
) -> Result<(Vec<DVec3>, Vec<[u32; 3]>), MeshError> {
    let mut points: Vec<DVec3> = rims.concat();
    let rim: BTreeSet<u32> = (0..points.len() as u32).collect();
    // Adding zero turns -0 into 0.
    let bits = |point: DVec3| (point + DVec3::ZERO).to_array().map(f64::to_bits);
    let mut names: BTreeMap<[u64; 3], u32> = points.iter().map(|p| bits(*p)).zip(0..).collect();
    let mut named = |corner: DVec3| {
        *names.entry(bits(corner)).or_insert_with(|| {
            points.push(corner);
            points.len() as u32 - 1
        })
    };
    let around: Vec<[u32; 3]> = around.iter().map(|corners| corners.map(&mut named)).collect();
    let known = points.len();
    let size = rims.iter().map(|rim| mean_edge(rim)).fold(0.0, f64::max);
    let first = rims.first().map_or(0, |rim| rim.len() as u32);
    let found = match rims.len() {
        2 => tube_searched(&points, &around, plain, |v| v < first, size, progress),
        _ => searched(points, &around, plain.to_vec(), &rim, size, progress),
    };
    let (mut points, triangles) = found.map_err(|none| match none {
        NoPoints::Cancelled => MeshError::Cancelled(mindeg_mesh::Cancelled),
        NoPoints::Because(reason) => MeshError::Refused(reason),
    })?;
    // The points of the mesh beside the rims go.
    let gone = (known - rim.len()) as u32;
    let inside = points.split_off(known);
    let name = |v: u32| if (v as usize) < rim.len() { v } else { v - gone };
    Ok((inside, triangles.iter().map(|t| t.map(name)).collect()))
}

/// The mean length of the edges of a closed ring.
fn mean_edge(ring: &[DVec3]) -> f64 {
    let lengths = (0..ring.len()).map(|i| ring[i].distance(ring[(i + 1) % ring.len()]));
    lengths.sum::<f64>() / ring.len() as f64
}

/// The triangles at some vertices.
pub(crate) struct Around(BTreeMap<u32, Vec<[u32; 3]>>);

impl Around {
    /// The surroundings of vertices in a mesh, with vertices of equal coordinates as one. O(n log n).
    pub(crate) fn of(
        mesh: &TriMesh,
        loops: &Loops,
        vertices: impl IntoIterator<Item = u32>,
    ) -> Self {
        let mut around = Self(vertices.into_iter().map(|v| (v, Vec::new())).collect());
        if !around.0.is_empty() {
            around.add(&loops.merged(mesh.triangles()));
        }
        around
    }

    /// The same with further triangles.
    pub(crate) fn add(&mut self, triangles: &[[u32; 3]]) {
        for triangle in triangles {
            for vertex in triangle {
                if let Some(own) = self.0.get_mut(vertex) {
                    own.push(*triangle);
                }
            }
        }
    }

    /// A surface between rims with points inside. `plain` is one without; new points are named from `next` on.
    pub(crate) fn meshed(
        &self,
        mesh: &TriMesh,
        rims: &[&[u32]],
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
        let points_of = |rim: &&[u32]| rim.iter().map(|v| at(*v)).collect::<Vec<DVec3>>();
        // Beside a rim of shorter edges they stay short.
        let size = rims.iter().map(|rim| mean_edge(&points_of(rim))).fold(0.0, f64::max);
        let rim = || rims.iter().copied().flatten();
        let mut around: Vec<[u32; 3]> = rim().flat_map(|v| &self.0[v]).copied().collect();
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
        let is_rim: BTreeSet<u32> = rim().map(local).collect();
        let points: Vec<DVec3> = known.iter().map(|v| at(*v)).collect();
        let found = match rims {
            [first, _] => {
                let first: BTreeSet<u32> = first.iter().map(local).collect();
                let is_first = |v: u32| first.contains(&v);
                tube_searched(&points, &around, &named(plain), is_first, size, progress)
            }
            _ => searched(points, &around, named(plain), &is_rim, size, progress),
        };
        let (mut points, patch) = found?;
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

/// Nor for tubes.
#[cfg(not(feature = "interior"))]
fn tube_searched(
    points: &[DVec3],
    around: &[[u32; 3]],
    strip: &[[u32; 3]],
    _is_first: impl Fn(u32) -> bool,
    size: f64,
    progress: Progress<'_>,
) -> Result<(Vec<DVec3>, Vec<[u32; 3]>), NoPoints> {
    searched(points.to_vec(), around, strip.to_vec(), &BTreeSet::new(), size, progress)
}

impl PointsInside {
    /// Before its degrees are known.
    pub(crate) fn of(vertices: Range<u32>) -> Self {
        Self { vertices, degrees: [0; 2], off_degree: Vec::new() }
    }

    /// Finds its degrees. `degree` gives the total degree of a vertex, and whether it is on a boundary.
    pub(crate) fn judge(&mut self, rims: &[&[u32]], degree: impl Fn(u32) -> (u32, bool)) {
        let [low, high] = DEGREES;
        let (mut least, mut most) = (u32::MAX, 0);
        for vertex in rims.iter().copied().flatten().copied().chain(self.vertices.clone()) {
            let (degree, is_open) = degree(vertex);
            (least, most) = (least.min(degree), most.max(degree));
            if degree > high || degree < low && !is_open {
                self.off_degree.push([vertex, degree]);
            }
        }
        self.degrees = [least, most];
    }
}
