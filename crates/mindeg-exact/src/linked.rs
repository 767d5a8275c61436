//! Triangles with their neighbours.

use glam::DVec2;
use mindeg_mesh::parallel::sort_all;
use mindeg_mesh::planar::orientation;

/// No triangle: beyond the boundary.
pub(crate) const NONE: u32 = u32::MAX;

/// Whether triangles abc and bad are a strictly convex quadrilateral, so that cd may be flipped in for ab.
pub(crate) fn is_convex([a, b, c, d]: [DVec2; 4]) -> bool {
    orientation(c, a, d) > 0.0 && orientation(d, b, c) > 0.0
}

/// Triangles and their neighbours.
///
/// Edge e of a triangle is the half-edge from its corner e to its corner e + 1.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Linked {
    pub(crate) triangles: Vec<[u32; 3]>,
    /// The triangle beyond each edge, or [`NONE`].
    pub(crate) neighbours: Vec<[u32; 3]>,
}

impl Linked {
    /// Finds the neighbours. O(n log n).
    ///
    /// # Errors
    ///
    /// The two ends of a half-edge that two triangles have, or of an edge that three have.
    pub(crate) fn new(triangles: Vec<[u32; 3]>) -> Result<Self, [u32; 2]> {
        let half_edge = |index: usize| {
            let corners = triangles[index / 3];
            [corners[index % 3], corners[(index + 1) % 3]]
        };
        let mut edges: Vec<(u64, u32)> = (0..3 * triangles.len())
            .map(|index| {
                let [from, to] = half_edge(index);
                let (low, high) = (from.min(to), from.max(to));
                ((u64::from(low) << 32) | u64::from(high), index as u32)
            })
            .collect();
        sort_all(&mut edges);
        let mut neighbours = vec![[NONE; 3]; triangles.len()];
        for same in edges.chunk_by(|a, b| a.0 == b.0) {
            match *same {
                [_] => {}
                [(_, one), (_, other)] => {
                    let (one, other) = (one as usize, other as usize);
                    if half_edge(one)[0] == half_edge(other)[0] {
                        return Err(half_edge(one));
                    }
                    neighbours[one / 3][one % 3] = other as u32 / 3;
                    neighbours[other / 3][other % 3] = one as u32 / 3;
                }
                _ => return Err(half_edge(same[0].1 as usize)),
            }
        }
        Ok(Self { triangles, neighbours })
    }

    /// The index of the triangle's edge that begins at `from`, and the corner opposite that edge.
    pub(crate) fn enter(&self, triangle: u32, from: u32) -> (usize, u32) {
        let corners = &self.triangles[triangle as usize];
        let edge = corners.iter().position(|&corner| corner == from).unwrap_or(0);
        (edge, corners[(edge + 2) % 3])
    }

    /// The corners of the two triangles at an edge: a, b and c of this one, whose edge is ab, and d
    /// beyond; `None` at the boundary.
    pub(crate) fn corners_at(&self, triangle: u32, edge: usize) -> Option<[u32; 4]> {
        let corners = self.triangles[triangle as usize];
        let [a, b, c] = [corners[edge], corners[(edge + 1) % 3], corners[(edge + 2) % 3]];
        let beyond = self.neighbours[triangle as usize][edge];
        (beyond != NONE).then(|| [a, b, c, self.enter(beyond, b).1])
    }

    /// Turns an edge between two triangles into the other diagonal of their quadrilateral: edge 2 of
    /// the first and edge 0 of the second, which it gives. From abc and bad to cad and dbc.
    pub(crate) fn flip(&mut self, triangle: u32, edge: usize) -> u32 {
        let corners = self.triangles[triangle as usize];
        let [a, b, c] = [corners[edge], corners[(edge + 1) % 3], corners[(edge + 2) % 3]];
        let neighbours = self.neighbours[triangle as usize];
        let beyond = neighbours[edge];
        let (other_edge, d) = self.enter(beyond, b);
        let other_neighbours = self.neighbours[beyond as usize];
        let (over_bc, over_ca) = (neighbours[(edge + 1) % 3], neighbours[(edge + 2) % 3]);
        let (over_ad, over_db) =
            (other_neighbours[(other_edge + 1) % 3], other_neighbours[(other_edge + 2) % 3]);
        self.triangles[triangle as usize] = [c, a, d];
        self.neighbours[triangle as usize] = [over_ca, over_ad, beyond];
        self.triangles[beyond as usize] = [d, b, c];
        self.neighbours[beyond as usize] = [over_db, over_bc, triangle];
        for (moved, before, now) in [(over_ad, beyond, triangle), (over_bc, triangle, beyond)] {
            if moved != NONE
                && let Some(entry) =
                    self.neighbours[moved as usize].iter_mut().find(|entry| **entry == before)
            {
                *entry = now;
            }
        }
        beyond
    }

    /// The corners of a triangle after a corner (3 * triangle + corner), counter-clockwise.
    pub(crate) fn beside(&self, corner: u32) -> [u32; 2] {
        let (corners, at) = (self.triangles[corner as usize / 3], corner as usize % 3);
        [corners[(at + 1) % 3], corners[(at + 2) % 3]]
    }

    /// The edges without a triangle beyond, as (from, to), in the order of the triangles.
    pub(crate) fn boundary_edges(&self) -> impl Iterator<Item = [u32; 2]> + Clone + '_ {
        self.triangles.iter().zip(&self.neighbours).flat_map(|(corners, neighbours)| {
            (0..3)
                .filter(|&edge| neighbours[edge] == NONE)
                .map(|edge| [corners[edge], corners[(edge + 1) % 3]])
        })
    }
}

/// The chords at each vertex of some triangles in which each vertex is on the boundary: one fewer than its
/// triangles.
pub(crate) fn chord_counts(vertices: usize, triangles: &[[u32; 3]]) -> Vec<u32> {
    let mut counts = vec![0_u32; vertices];
    triangles.as_flattened().iter().for_each(|&vertex| counts[vertex as usize] += 1);
    counts.into_iter().map(|triangles| triangles - 1).collect()
}

/// For every vertex the corners of triangles there, as 3 * triangle + corner.
pub(crate) struct Corners {
    offsets: Vec<u32>,
    corners: Vec<u32>,
}

impl Corners {
    pub(crate) fn new(vertices: usize, triangles: &[[u32; 3]]) -> Self {
        let mut offsets = vec![0_u32; vertices + 1];
        for &vertex in triangles.as_flattened() {
            offsets[vertex as usize + 1] += 1;
        }
        for vertex in 0..vertices {
            offsets[vertex + 1] += offsets[vertex];
        }
        let mut next = offsets.clone();
        let mut corners = vec![0; 3 * triangles.len()];
        for (corner, &vertex) in (0..).zip(triangles.as_flattened()) {
            corners[next[vertex as usize] as usize] = corner;
            next[vertex as usize] += 1;
        }
        Self { offsets, corners }
    }

    /// Puts the corners of each vertex in the order of a key: of the vertex and the next corner of the
    /// triangle.
    pub(crate) fn sort_by_key(&mut self, mesh: &Linked, key: impl Fn(u32, u32) -> u32) {
        for (vertex, ends) in (0..).zip(self.offsets.windows(2)) {
            self.corners[ends[0] as usize..ends[1] as usize]
                .sort_unstable_by_key(|&corner| key(vertex, mesh.beside(corner)[0]));
        }
    }

    pub(crate) fn of(&self, vertex: u32) -> &[u32] {
        let vertex = vertex as usize;
        &self.corners[self.offsets[vertex] as usize..self.offsets[vertex + 1] as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_are_mutual() {
        let mesh = Linked::new(vec![[0, 1, 2], [0, 2, 3], [2, 4, 3]]).unwrap();
        assert_eq!(mesh.neighbours, [[NONE, NONE, 1], [0, 2, NONE], [NONE, NONE, 1]]);
        assert_eq!(mesh.enter(1, 2), (1, 0));
        let boundary: Vec<_> = mesh.boundary_edges().collect();
        assert_eq!(boundary, [[0, 1], [1, 2], [3, 0], [2, 4], [4, 3]]);
        let corners = Corners::new(5, &mesh.triangles);
        assert_eq!(corners.of(2), [2, 4, 6]);
        assert_eq!(corners.of(4), [7]);
    }

    #[test]
    fn edges_met_twice_in_one_direction_are_refused() {
        assert_eq!(Linked::new(vec![[0, 1, 2], [0, 1, 3]]), Err([0, 1]));
        let three = vec![[0, 1, 2], [1, 0, 3], [0, 1, 4]];
        assert_eq!(Linked::new(three), Err([0, 1]));
    }
}
