//! The boundary of a mesh, computed from its faces.

use super::stars::{Star, Stars};

/// Consecutive boundary edges of a mesh.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BoundaryLoop {
    /// The vertices in order. Where the faces agree in orientation, the surface is on the left,
    /// seen from where they are counter-clockwise. A closed loop does not repeat its first vertex
    /// at the end. A vertex at which the surface touches itself may occur several times.
    pub vertices: Vec<u32>,
    /// Whether the last vertex is followed by the first. In a mesh whose faces meet two at an
    /// edge at most, every loop is closed.
    pub closed: bool,
}

/// The edges with only one face, each seen from both its ends.
#[derive(Default)]
pub(crate) struct BoundaryEdges {
    /// The first index in `half_edges` of the edges of each added vertex.
    starts: Vec<usize>,
    /// In ascending order of `from`, then `to`.
    half_edges: Vec<BoundaryHalfEdge>,
}

/// A boundary edge, seen from one end.
struct BoundaryHalfEdge {
    from: u32,
    to: u32,
    /// Whether the face runs this way.
    is_outgoing: bool,
    /// The end of the next boundary edge after this one at `from`.
    next: Option<u32>,
}

impl BoundaryEdges {
    /// The boundary of a mesh, from the stars of its vertices.
    pub(crate) fn new(stars: &Stars<'_>) -> Self {
        let mut boundary = Self::default();
        stars.for_each(0..stars.count(), |vertex, star| boundary.add(vertex, star));
        boundary
    }

    /// Adds the boundary edges at a vertex. Add every vertex from 0 on, in order, here or to a
    /// block that is [appended](Self::append) later.
    pub(crate) fn add(&mut self, vertex: u32, star: &Star) {
        self.starts.push(self.half_edges.len());
        for edge in star.edges() {
            if let [half] = *edge {
                let next = star.next_boundary_edge(half);
                let is_outgoing = half.is_outgoing;
                let to = half.end;
                self.half_edges.push(BoundaryHalfEdge { from: vertex, to, is_outgoing, next });
            }
        }
    }

    /// Adds the edges of the block of vertices that follows.
    pub(crate) fn append(&mut self, next: Self) {
        let before = self.half_edges.len();
        self.starts.extend(next.starts.into_iter().map(|start| before + start));
        self.half_edges.extend(next.half_edges);
    }

    /// The number of boundary edges.
    pub(crate) fn edge_count(&self) -> usize {
        self.half_edges.len() / 2
    }

    /// The loops, in the order of their first vertices; each boundary edge is in one of them. A
    /// closed loop starts at its least vertex. O(b log b) for b edges.
    pub(crate) fn loops(&self) -> Vec<BoundaryLoop> {
        let mut used = vec![false; self.half_edges.len()];
        let mut loops = Vec::new();
        // Open loops are followed from one of their ends; all other loops are closed.
        for (start, half) in self.half_edges.iter().enumerate() {
            if half.next.is_none() && !used[start] {
                let mut vertices = self.follow(start, &mut used);
                if !half.is_outgoing {
                    vertices.reverse();
                }
                loops.push(BoundaryLoop { vertices, closed: false });
            }
        }
        for (mut start, half) in self.half_edges.iter().enumerate() {
            if !used[start] {
                if let (false, Some(next)) = (half.is_outgoing, half.next) {
                    start = self.half(half.from, next);
                }
                let mut vertices = self.follow(start, &mut used);
                vertices.pop();
                loops.push(BoundaryLoop { vertices, closed: true });
            }
        }
        loops.sort_by_key(|boundary_loop| boundary_loop.vertices[0]);
        loops
    }

    /// The vertices from a half-edge on, up to the end of an open loop or back to the start.
    fn follow(&self, start: usize, used: &mut [bool]) -> Vec<u32> {
        let mut vertices = vec![self.half_edges[start].from];
        let mut at = start;
        loop {
            let BoundaryHalfEdge { from, to, .. } = self.half_edges[at];
            let back = self.half(to, from);
            used[at] = true;
            used[back] = true;
            vertices.push(to);
            match self.half_edges[back].next.map(|end| self.half(to, end)) {
                Some(next) if next != start => at = next,
                _ => return vertices,
            }
        }
    }

    /// The index of a half-edge that exists.
    fn half(&self, from: u32, to: u32) -> usize {
        let vertex = from as usize;
        let start = self.starts[vertex];
        let end = self.starts.get(vertex + 1).map_or(self.half_edges.len(), |&end| end);
        start + self.half_edges[start..end].partition_point(|half| half.to < to)
    }
}

#[cfg(test)]
mod tests {
    use crate::tri_mesh::TriMesh;
    use glam::DVec3;
    use proptest::prelude::*;

    fn loops(triangles: &[[u32; 3]]) -> Vec<(Vec<u32>, bool)> {
        let last = triangles.iter().flatten().max().unwrap();
        let mesh = TriMesh::new(vec![DVec3::ZERO; *last as usize + 1], triangles.to_vec());
        mesh.unwrap().boundary_loops().into_iter().map(|l| (l.vertices, l.closed)).collect()
    }

    #[test]
    fn follows_every_boundary() {
        for (triangles, expected) in [
            // One triangle, and one that starts at another vertex.
            (&[[0, 1, 2]][..], vec![(vec![0, 1, 2], true)]),
            (&[[2, 0, 1]], vec![(vec![0, 1, 2], true)]),
            // A tetrahedron has no boundary.
            (&[[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]], vec![]),
            // Two triangles that touch in vertex 0 stay two loops, in order of their least vertices.
            (&[[0, 3, 4], [0, 1, 2]], vec![(vec![0, 1, 2], true), (vec![0, 3, 4], true)]),
            // A square ring: outside, and the hole the other way round.
            (
                &[
                    [0, 1, 4],
                    [1, 5, 4],
                    [1, 2, 5],
                    [2, 6, 5],
                    [2, 3, 6],
                    [3, 7, 6],
                    [3, 0, 7],
                    [0, 4, 7],
                ],
                vec![(vec![0, 1, 2, 3], true), (vec![4, 7, 6, 5], true)],
            ),
            // Two triangles of opposite orientation.
            (&[[0, 1, 2], [1, 2, 3]], vec![(vec![0, 1, 3, 2], true)]),
            (&[[0, 2, 1], [1, 3, 2]], vec![(vec![0, 2, 3, 1], true)]),
            // A repeated triangle has no boundary, in either direction.
            (&[[0, 1, 2], [1, 2, 0]], vec![]),
            (&[[0, 1, 2], [0, 2, 1]], vec![]),
            // Two that meet in two vertices, and are closed up by others to a bow with a hole.
            (&[[0, 1, 2], [0, 3, 1], [0, 2, 4], [0, 4, 3]], vec![(vec![1, 2, 4, 3], true)]),
            // Three triangles at the edge 0-1.
            (
                &[[0, 1, 2], [1, 0, 3], [0, 1, 4]],
                vec![(vec![0, 3, 1], false), (vec![1, 2, 0], false), (vec![1, 4, 0], false)],
            ),
            // A triangle with a repeated vertex has no boundary of its own.
            (&[[0, 1, 2], [3, 3, 4]], vec![(vec![0, 1, 2], true)]),
        ] {
            assert_eq!(loops(triangles), expected, "{triangles:?}");
        }
    }

    proptest! {
        /// Open or closed, the loops consist of the edges that are in one triangle.
        #[test]
        fn every_boundary_edge_once_whatever_the_triangles(
            triangles in prop::collection::vec(prop::array::uniform3(0_u32..8), 1..20)
        ) {
            let mut walked = Vec::new();
            for (vertices, closed) in loops(&triangles) {
                walked.extend(vertices.windows(2).map(|e| [e[0].min(e[1]), e[0].max(e[1])]));
                if closed {
                    let [first, last] = [vertices[0], vertices[vertices.len() - 1]];
                    prop_assert_eq!(vertices.iter().min(), Some(&first));
                    walked.push([first, last]);
                }
            }
            walked.sort_unstable();
            let with = |a, b| {
                let proper = triangles.iter().filter(|[a, b, c]| a != b && b != c && c != a);
                proper.filter(|t| t.contains(&a) && t.contains(&b)).count()
            };
            let expected: Vec<_> = (0..8)
                .flat_map(|a| (a + 1..8).map(move |b| [a, b]))
                .filter(|&[a, b]| with(a, b) == 1)
                .collect();
            prop_assert_eq!(walked, expected);
        }
    }
}
