//! The boundary of a mesh, from its triangles alone.

use super::SurfaceMesh;

/// Consecutive boundary edges of a mesh, as they run in their triangles: with the surface on
/// the left, seen from where the triangles are counter-clockwise.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BoundaryLoop {
    /// The vertices in order. A closed loop does not repeat its first vertex at the end, and
    /// a vertex in which the surface touches itself may come more than once.
    pub vertices: Vec<u32>,
    /// Whether the last vertex is followed by the first. In a mesh whose triangles agree in
    /// orientation and meet two at an edge at most, every loop is closed.
    pub closed: bool,
}

impl SurfaceMesh {
    /// The loops of edges that belong to one triangle only.
    ///
    /// At a vertex, a loop goes on with the boundary edge found by turning through the
    /// triangles, so that loops which touch in a vertex stay apart. Loops start at their
    /// least vertex and come in the order of these. Takes O(m log m) time for m triangles.
    #[must_use]
    pub fn boundary_loops(&self) -> Vec<BoundaryLoop> {
        let edges = DirectedEdges::new(self.triangles());
        // In ascending order, so that the first unused edge starts at its loop's least vertex.
        let boundary: Vec<[u32; 2]> = edges.boundary().collect();
        let mut used = vec![false; boundary.len()];
        let mut loops = Vec::new();
        for start in 0..boundary.len() {
            if used[start] {
                continue;
            }
            let mut vertices = Vec::new();
            let mut at = start;
            let closed = loop {
                used[at] = true;
                let [from, to] = boundary[at];
                vertices.push(from);
                match edges.next_on_boundary(from, to).and_then(|e| boundary.binary_search(&e).ok())
                {
                    Some(next) if next == start => break true,
                    Some(next) if !used[next] => at = next,
                    _ => {
                        vertices.push(to);
                        break false;
                    }
                }
            };
            loops.push(BoundaryLoop { vertices, closed });
        }
        loops
    }
}

/// The edges of all triangles as they run, each with the third vertex of its triangle, in
/// ascending order.
struct DirectedEdges(Vec<[u32; 3]>);

impl DirectedEdges {
    fn new(triangles: &[[u32; 3]]) -> Self {
        let around = |&[a, b, c]: &[u32; 3]| [[a, b, c], [b, c, a], [c, a, b]];
        let mut edges: Vec<_> = triangles.iter().flat_map(around).collect();
        edges.sort_unstable();
        Self(edges)
    }

    /// The third vertices of the triangles through which the edge runs in this direction.
    fn apexes(&self, from: u32, to: u32) -> impl Iterator<Item = u32> {
        let first = self.0.partition_point(|&[a, b, _]| [a, b] < [from, to]);
        self.0[first..].iter().take_while(move |&&[a, b, _]| [a, b] == [from, to]).map(|e| e[2])
    }

    /// The third vertex, where it is the only one.
    fn apex(&self, from: u32, to: u32) -> Option<u32> {
        let mut apexes = self.apexes(from, to);
        apexes.next().filter(|_| apexes.next().is_none())
    }

    fn is_boundary(&self, from: u32, to: u32) -> bool {
        self.apex(from, to).is_some() && self.apexes(to, from).next().is_none()
    }

    /// The edges of one triangle only, in ascending order.
    fn boundary(&self) -> impl Iterator<Item = [u32; 2]> {
        self.0
            .iter()
            .map(|&[from, to, _]| [from, to])
            .filter(|&[from, to]| self.is_boundary(from, to))
    }

    /// The boundary edge that follows a boundary edge: turning about its second vertex from
    /// triangle to triangle, as long as one triangle lies across.
    ///
    /// Ends: a step from one edge to another can be taken back in one way only, and none
    /// leads to the edge it starts with.
    fn next_on_boundary(&self, from: u32, to: u32) -> Option<[u32; 2]> {
        let mut spoke = self.apex(from, to)?;
        while !self.is_boundary(to, spoke) {
            self.apex(to, spoke)?;
            spoke = self.apex(spoke, to)?;
        }
        Some([to, spoke])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;
    use proptest::prelude::*;

    fn loops(triangles: &[[u32; 3]]) -> Vec<(Vec<u32>, bool)> {
        let last = triangles.iter().flatten().max().unwrap();
        let mesh = SurfaceMesh::new(vec![DVec3::ZERO; *last as usize + 1], triangles.to_vec());
        mesh.unwrap().boundary_loops().into_iter().map(|l| (l.vertices, l.closed)).collect()
    }

    #[test]
    fn follows_every_boundary() {
        for (triangles, expected) in [
            // One triangle, and one that starts elsewhere.
            (&[[0, 1, 2]][..], vec![(vec![0, 1, 2], true)]),
            (&[[2, 0, 1]], vec![(vec![0, 1, 2], true)]),
            // A tetrahedron has none.
            (&[[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]], vec![]),
            // Two triangles that touch in vertex 0 stay two loops, in the order of the least.
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
            // Two triangles of opposite orientation: no loop closes.
            (
                &[[0, 1, 2], [1, 2, 3]],
                vec![(vec![0, 1], false), (vec![2, 0], false), (vec![2, 3, 1], false)],
            ),
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
        #[test]
        fn every_boundary_edge_once_whatever_the_triangles(
            triangles in prop::collection::vec(prop::array::uniform3(0_u32..8), 1..20)
        ) {
            let mut walked = Vec::new();
            for (vertices, closed) in loops(&triangles) {
                walked.extend(vertices.windows(2).map(|e| [e[0], e[1]]));
                if closed {
                    walked.push([vertices[vertices.len() - 1], vertices[0]]);
                }
            }
            walked.sort_unstable();
            let runs = |from, to| triangles.iter().filter(|[a, b, c]| [[a, b], [b, c], [c, a]].contains(&[&from, &to])).count();
            let expected: Vec<_> = (0..8)
                .flat_map(|a| (0..8).map(move |b| [a, b]))
                .filter(|&[a, b]| runs(a, b) == 1 && runs(b, a) == 0)
                .collect();
            prop_assert_eq!(walked, expected);
        }
    }
}
