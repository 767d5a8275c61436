//! The edges of a mesh that stay: its boundary, and fixed edges inside.

use crate::array_mesh::{ArrayMesh, Kind, NONE};
use crate::breaklines::Breaklines;
use glam::DVec2;
use mindeg_mesh::planar::PlanarBoundary;
use mindeg_mesh::sorted;

impl ArrayMesh {
    /// The rings of boundary edges as an outline, the fixed vertices and edges inside, and the index in this mesh of the
    /// outline's vertices, then of fixed ones.
    pub(crate) fn frozen(&self) -> (PlanarBoundary, Breaklines, Vec<u32>) {
        let rings = self.rings();
        let positions: Vec<Vec<DVec2>> =
            rings.iter().map(|ring| ring.iter().map(|v| self.at(*v)).collect()).collect();
        let outline = PlanarBoundary::of_mesh(&positions);
        let mut names = rings.concat();
        let mut index = vec![NONE; self.vertices.len()];
        (0..).zip(&names).for_each(|(i, v)| index[*v as usize] = i);
        // A line may end on a ring: its end is the ring's vertex.
        for (v, vertex) in (0..).zip(&self.vertices) {
            let own = &mut index[v as usize];
            if vertex.kind == Kind::Fixed && vertex.triangles > 0 && *own == NONE {
                *own = names.len() as u32;
                names.push(v);
            }
        }
        let locked = self.locked_edges().into_iter().map(|edge| edge.map(|v| index[v as usize]));
        let mut edges: Vec<[u32; 2]> = locked.map(sorted).collect();
        edges.sort_unstable();
        edges.dedup();
        let points = names[outline.points().len()..].iter().map(|v| self.at(*v)).collect();
        (outline, Breaklines { points, edges }, names)
    }

    /// The fixed edges inside, once or twice each.
    pub(crate) fn locked_edges(&self) -> Vec<[u32; 2]> {
        let alive = self.triangles.iter().filter(|triangle| triangle.is_alive());
        alive
            .flat_map(|t| (0..3).filter(|i| t.is_locked(*i)).map(move |i| (t, i)))
            .map(|(t, i)| [1, 2].map(|j| t.vertices[(i + j) % 3]))
            .collect()
    }

    /// The rings of boundary edges, the mesh on their left.
    fn rings(&self) -> Vec<Vec<u32>> {
        let mut next = vec![NONE; self.vertices.len()];
        for triangle in self.triangles.iter().filter(|triangle| triangle.is_alive()) {
            for i in (0..3).filter(|i| triangle.neighbours[*i] == NONE) {
                next[triangle.vertices[(i + 1) % 3] as usize] = triangle.vertices[(i + 2) % 3];
            }
        }
        let mut rings = Vec::new();
        for start in 0..next.len() {
            let mut ring = Vec::new();
            let mut v = start as u32;
            while next[v as usize] != NONE {
                ring.push(v);
                v = std::mem::replace(&mut next[v as usize], NONE);
            }
            if !ring.is_empty() {
                rings.push(ring);
            }
        }
        rings
    }
}
