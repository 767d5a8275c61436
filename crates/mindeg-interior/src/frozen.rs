//! The edges of a mesh that stay: its boundary, and fixed edges inside.

use crate::array_mesh::{ArrayMesh, NONE};

impl ArrayMesh {
    /// The fixed edges inside, once or twice each.
    pub(crate) fn locked_edges(&self) -> Vec<[u32; 2]> {
        let alive = self.triangles.iter().filter(|triangle| triangle.is_alive());
        alive
            .flat_map(|t| (0..3).filter(|i| t.locked >> i & 1 == 1).map(move |i| (t, i)))
            .map(|(t, i)| [1, 2].map(|j| t.vertices[(i + j) % 3]))
            .collect()
    }

    /// The rings of boundary edges, the mesh on their left.
    pub(crate) fn rings(&self) -> Vec<Vec<u32>> {
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
