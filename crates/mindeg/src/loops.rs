//! The boundary loops of a mesh, as filling and bridging take them.
//!
//! Vertices with equal coordinates count as one, the first of them: so the seams of a file are no
//! boundary. Loops run in the direction of the faces. A loop that comes through a vertex twice is
//! taken apart there, so that no loop touches itself and a vertex between two holes becomes a
//! sound one when both are closed. A vertex in which two parts of the mesh touch, each with a loop
//! of its own, stays such a vertex.
//!
//! Limits: no tolerance joins vertices that are only near each other.

use crate::error::MeshError;
use glam::DVec3;
use mindeg_mesh::{TriMesh, edges_of, weld};
use std::collections::{BTreeMap, BTreeSet};
use thiserror::Error;

/// A boundary loop.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshLoop {
    /// The vertices in the direction of the faces, each once, from the least on.
    pub vertices: Vec<u32>,
    /// Why it cannot be filled or bridged, if so.
    pub defect: Option<LoopDefect>,
    /// Whether it is the rim of a flat sheet: all faces along it lie in its plane, inside it, so that a filling would lie on
    /// them. Up to a millionth of its extent counts as flat.
    pub is_rim: bool,
}

/// Why a loop cannot be filled or bridged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum LoopDefect {
    /// The chain is not a closed loop.
    #[error("it is not closed: at vertex {vertex} it runs into an edge with three faces or more")]
    Open {
        /// Where it ends.
        vertex: u32,
    },
    /// Faces along it do not agree in orientation.
    #[error(
        "its faces do not agree in orientation: at edge {}-{} they turn over",
        edge[0], edge[1]
    )]
    Disagreeing {
        /// The first edge that runs against the others.
        edge: [u32; 2],
    },
    /// It is the boundary of one triangle: the filling would be the same triangle turned over.
    #[error("it is the boundary of a single triangle")]
    SingleTriangle,
}

/// All boundary loops of a mesh, and what is around them.
#[derive(Clone, Debug)]
pub struct Loops {
    loops: Vec<MeshLoop>,
    /// For each vertex the first with the same coordinates.
    pub(crate) same: Vec<u32>,
    /// The degree of each vertex; vertices with equal coordinates count as one.
    pub(crate) degrees: Vec<u32>,
    /// Edges between vertices of loops, in both directions, sorted.
    edges: Vec<[u32; 2]>,
    /// The edges that were added, also in both directions.
    added: BTreeSet<[u32; 2]>,
}

impl Loops {
    /// The boundary loops of a mesh, in the order of their first vertices. O(n log n).
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg::{Loops, TriMesh, glam::DVec3};
    ///
    /// let square = vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
    /// let loops = Loops::of(&TriMesh::new(square, vec![[0, 1, 2], [0, 2, 3]])?);
    /// assert_eq!(loops.list()[0].vertices, [0, 1, 2, 3]);
    /// # Ok::<(), mindeg::TriMeshError>(())
    /// ```
    pub fn of(mesh: &TriMesh) -> Self {
        let same = weld(mesh.positions(), 0.0);
        let merged = |corners: &[u32; 3]| corners.map(|vertex| same[vertex as usize]);
        let triangles: Vec<[u32; 3]> = mesh.triangles().iter().map(merged).collect();
        // Positions and counts are those of a mesh.
        let whole = TriMesh::new(mesh.positions().to_vec(), triangles);
        let (boundary, degrees) = match &whole {
            Ok(whole) => (whole.boundary_loops(), whole.degrees().to_vec()),
            Err(_) => (Vec::new(), vec![0; same.len()]),
        };
        let triangles = whole.as_ref().map_or(&[][..], TriMesh::triangles);

        let mut is_on_loop = vec![false; same.len()];
        for &vertex in boundary.iter().flat_map(|found| &found.vertices) {
            is_on_loop[vertex as usize] = true;
        }
        let is_on_loop = |vertex: u32| is_on_loop[vertex as usize];
        let proper = triangles.iter().filter(|[a, b, c]| a != b && b != c && c != a);
        // Each with the corner of its triangle that is not on it.
        let mut directed = Vec::new();
        let mut whole_on_loops = Vec::new();
        for &[a, b, c] in proper {
            let edges = [[a, b, c], [b, c, a], [c, a, b]];
            directed
                .extend(edges.into_iter().filter(|edge| edge[..2].iter().all(|&v| is_on_loop(v))));
            if [a, b, c].into_iter().all(is_on_loop) {
                let mut corners = [a, b, c];
                corners.sort_unstable();
                whole_on_loops.push(corners);
            }
        }
        directed.sort_unstable();
        whole_on_loops.sort_unstable();

        let mut loops: Vec<MeshLoop> = Vec::new();
        for found in boundary {
            if !found.closed {
                let vertex = found.vertices.last().copied().unwrap_or(0);
                let defect = Some(LoopDefect::Open { vertex });
                loops.push(MeshLoop { vertices: found.vertices, defect, is_rim: false });
                continue;
            }
            for mut vertices in simple_loops(&found.vertices) {
                let at = |from, to| directed.binary_search_by(|edge| edge[..2].cmp(&[from, to]));
                let runs = |from: u32, to: u32| at(from, to).is_ok();
                if edges(&vertices).all(|[from, to]| runs(to, from) && !runs(from, to)) {
                    vertices.reverse();
                }
                let least = (0..vertices.len()).min_by_key(|&i| vertices[i]).unwrap_or(0);
                vertices.rotate_left(least);
                let against =
                    edges(&vertices).find(|&[from, to]| !runs(from, to) || runs(to, from));
                let mut corners = vertices.clone();
                corners.sort_unstable();
                let is_single =
                    whole_on_loops.binary_search_by(|whole| whole[..].cmp(&corners)).is_ok();
                let defect = match against {
                    Some(edge) => Some(LoopDefect::Disagreeing { edge }),
                    None => is_single.then_some(LoopDefect::SingleTriangle),
                };
                let apexes: Option<Vec<u32>> = edges(&vertices)
                    .map(|[from, to]| Some(directed[at(from, to).ok()?][2]))
                    .collect();
                let is_rim = defect.is_none()
                    && apexes.is_some_and(|apexes| is_rim(mesh.positions(), &vertices, &apexes));
                loops.push(MeshLoop { vertices, defect, is_rim });
            }
        }
        loops.sort_by(|a, b| a.vertices.cmp(&b.vertices));
        let mut edges: Vec<[u32; 2]> =
            directed.iter().flat_map(|&[from, to, _]| [[from, to], [to, from]]).collect();
        edges.sort_unstable();
        edges.dedup();
        Self { loops, same, degrees, edges, added: BTreeSet::new() }
    }

    /// The loops, in the order of their first vertices.
    pub fn list(&self) -> &[MeshLoop] {
        &self.loops
    }

    /// The index of the first loop through a vertex, or through one with the same coordinates.
    pub fn through(&self, vertex: u32) -> Option<usize> {
        let same = *self.same.get(vertex as usize)?;
        self.loops.iter().position(|found| found.vertices.contains(&same))
    }

    pub(crate) fn get(&self, index: usize) -> Result<&MeshLoop, MeshError> {
        let (number, loops) = (index + 1, self.loops.len());
        let missing = || format!("there is no loop {number}; the mesh has {loops} boundary loops");
        self.loops.get(index).ok_or_else(|| MeshError::refused(missing()))
    }

    /// The triangles of a mesh with vertices of the same coordinates as one.
    pub(crate) fn merged(&self, triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
        triangles.iter().map(|t| t.map(|vertex| self.same[vertex as usize])).collect()
    }

    /// Adds the edges of new triangles to degrees and edges.
    pub(crate) fn add(&mut self, triangles: &[[u32; 3]]) {
        let edges = triangles.iter().copied().flat_map(edges_of);
        for edge in edges.flat_map(|[a, b]| [[a, b], [b, a]]) {
            if self.edges.binary_search(&edge).is_err() && self.added.insert(edge) {
                self.degrees[edge[0] as usize] += 1;
            }
        }
    }

    /// The vertices that an edge joins to a vertex of a loop.
    pub(crate) fn neighbors(&self, vertex: u32) -> impl Iterator<Item = u32> {
        let start = self.edges.partition_point(|edge| edge[0] < vertex);
        let own = self.edges[start..].iter().take_while(move |edge| edge[0] == vertex);
        own.chain(self.added.range([vertex, 0]..=[vertex, u32::MAX])).map(|edge| edge[1])
    }
}

impl MeshLoop {
    /// The mean of its points.
    pub fn center(&self, positions: &[DVec3]) -> DVec3 {
        let share = 1.0 / self.vertices.len() as f64;
        self.vertices.iter().map(|&vertex| positions[vertex as usize] * share).sum()
    }
}

/// Whether the triangles along a loop, with these apexes, lie in its plane and inside it.
fn is_rim(positions: &[DVec3], vertices: &[u32], apexes: &[u32]) -> bool {
    const FLAT: f64 = 1e-6;
    let at = |vertex: u32| positions[vertex as usize];
    let start = at(vertices[0]);
    let normal: DVec3 =
        edges(vertices).map(|[from, to]| (at(from) - start).cross(at(to) - start)).sum();
    let normal = normal.normalize_or_zero();
    let extent = vertices.iter().map(|&vertex| (at(vertex) - start).length()).fold(0.0, f64::max);
    let is_flat = |vertex: &u32| (at(*vertex) - start).dot(normal).abs() <= FLAT * extent;
    let faces_along = |([from, to], apex): ([u32; 2], &u32)| {
        (at(to) - at(from)).cross(at(*apex) - at(from)).dot(normal) > 0.0
    };
    normal != DVec3::ZERO
        && vertices.iter().chain(apexes).all(is_flat)
        && edges(vertices).zip(apexes).all(faces_along)
}

/// The edges of a closed loop.
fn edges(vertices: &[u32]) -> impl Iterator<Item = [u32; 2]> {
    let next = vertices.iter().cycle().skip(1);
    vertices.iter().zip(next).map(|(&from, &to)| [from, to])
}

/// A closed loop, taken apart where it comes to a vertex again. O(n log n).
fn simple_loops(vertices: &[u32]) -> Vec<Vec<u32>> {
    let mut loops = Vec::new();
    let mut path: Vec<u32> = Vec::new();
    let mut places = BTreeMap::new();
    for &vertex in vertices {
        if let Some(place) = places.get(&vertex).copied() {
            let rest: Vec<u32> = path.drain(place..).collect();
            places.retain(|_, &mut at| at < place);
            loops.push(rest);
        }
        places.insert(vertex, path.len());
        path.push(vertex);
    }
    loops.push(path);
    loops
}

#[cfg(test)]
mod tests {
    use super::*;

    fn loops(points: &[[i32; 2]], triangles: &[[u32; 3]]) -> Vec<MeshLoop> {
        let points = points.iter().map(|&[x, y]| DVec3::new(x.into(), y.into(), 0.0)).collect();
        Loops::of(&TriMesh::new(points, triangles.to_vec()).unwrap()).list().to_vec()
    }

    #[test]
    fn a_loop_that_touches_itself_becomes_two() {
        assert_eq!(simple_loops(&[0, 1, 2, 3]), [[0, 1, 2, 3]]);
        assert_eq!(simple_loops(&[0, 1, 2, 3, 1, 4]), [vec![1, 2, 3], vec![0, 1, 4]]);
        assert_eq!(simple_loops(&[5, 1, 2, 5, 3, 4]), [[5, 1, 2], [5, 3, 4]]);
    }

    #[test]
    fn loops_run_with_the_faces_and_name_their_defects() {
        let points = [[0, 0], [4, 0], [4, 4], [0, 4], [2, -3], [9, 9]];
        for (triangles, expected) in [
            (&[[0, 1, 2], [0, 2, 3]][..], vec![(vec![0, 1, 2, 3], None)]),
            (&[[1, 0, 2], [2, 0, 3]], vec![(vec![0, 3, 2, 1], None)]),
            (&[[0, 1, 2]], vec![(vec![0, 1, 2], Some(LoopDefect::SingleTriangle))]),
            (
                &[[0, 1, 2], [0, 3, 2]],
                vec![(vec![0, 1, 2, 3], Some(LoopDefect::Disagreeing { edge: [2, 3] }))],
            ),
            (
                &[[0, 1, 2], [1, 0, 4], [0, 1, 3]],
                vec![
                    (vec![0, 4, 1], Some(LoopDefect::Open { vertex: 1 })),
                    (vec![1, 2, 0], Some(LoopDefect::Open { vertex: 0 })),
                    (vec![1, 3, 0], Some(LoopDefect::Open { vertex: 0 })),
                ],
            ),
        ] {
            let found = loops(&points, triangles);
            let found: Vec<_> = found.into_iter().map(|l| (l.vertices, l.defect)).collect();
            assert_eq!(found, expected, "{triangles:?}");
        }
    }

    /// A frame of squares round a hole, flat or with its inner edges lifted.
    fn frame(height: f64) -> Vec<MeshLoop> {
        let outer = [[0, 0], [3, 0], [3, 3], [0, 3]].map(|[x, y]: [i32; 2]| (x, y, 0.0));
        let inner = [[1, 1], [2, 1], [2, 2], [1, 2]].map(|[x, y]: [i32; 2]| (x, y, height));
        let points = outer.iter().chain(&inner).map(|&(x, y, z)| DVec3::new(x.into(), y.into(), z));
        let sides = (0..4).flat_map(|i| {
            let j = (i + 1) % 4;
            [[i, j, 4 + j], [i, 4 + j, 4 + i]]
        });
        Loops::of(&TriMesh::new(points.collect(), sides.collect()).unwrap()).list().to_vec()
    }

    #[test]
    fn the_rim_of_a_flat_sheet_is_none_of_its_holes() {
        let rims = |height| frame(height).iter().map(|found| found.is_rim).collect::<Vec<_>>();
        assert_eq!(rims(0.0), [true, false]);
        // A frustum has two holes.
        assert_eq!(rims(1.0), [false, false]);
    }

    #[test]
    fn seams_are_no_boundary() {
        let points = [[0, 0], [4, 0], [4, 4], [0, 0], [4, 4], [0, 4]];
        let found = loops(&points, &[[0, 1, 2], [3, 4, 5]]);
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].vertices, [0, 1, 2, 5]);
    }
}
