//! Where operations failed: there they are tried again once something near by has changed.

use crate::array_mesh::ArrayMesh;
use crate::space::{Space, Vector};

/// A vertex that moved by a larger share of its size has changed.
const MOVED: f64 = 0.05;

/// The vertices at which all operations of some kind failed.
pub(crate) struct Failed<V> {
    /// By the kind of operations, then by the vertex.
    has: [Vec<bool>; 3],
    /// Where each vertex was, and how many triangles it had.
    seen: Vec<(V, u32)>,
}

impl<V: Vector> Failed<V> {
    /// Nothing was tried yet.
    pub(crate) fn new() -> Self {
        Self { has: [const { Vec::new() }; 3], seen: Vec::new() }
    }

    /// Looks which vertices have changed. O(n).
    pub(crate) fn look<S: Space<Vector = V>>(&mut self, mesh: &ArrayMesh<S>) {
        self.has.iter_mut().for_each(|has| has.resize(mesh.vertices.len(), false));
        let (known, mut has_changed) = (self.seen.len(), Vec::new());
        for (v, vertex) in mesh.vertices.iter().enumerate() {
            let now = (S::position(&vertex.at), vertex.triangles);
            if v >= known {
                self.seen.push(now);
            }
            let (at, triangles) = self.seen[v];
            let far = MOVED * vertex.size;
            let is_new = v >= known || triangles != now.1 || at.distance_squared(now.0) > far * far;
            if is_new {
                self.seen[v] = now;
            }
            has_changed.push(is_new);
        }
        for triangle in mesh.triangles.iter().filter(|triangle| triangle.is_alive()) {
            if triangle.vertices.iter().any(|v| has_changed[*v as usize]) {
                self.forget(&triangle.vertices);
            }
        }
    }

    /// True if all operations of a kind failed at a vertex, and nothing near by has changed.
    pub(crate) fn has(&self, kind: usize, vertex: u32) -> bool {
        self.has[kind].get(vertex as usize).is_some_and(|has| *has)
    }

    /// All operations of a kind failed at a vertex.
    pub(crate) fn add(&mut self, kind: usize, vertex: u32) {
        let has = &mut self.has[kind];
        if has.len() <= vertex as usize {
            has.resize(vertex as usize + 1, false);
        }
        has[vertex as usize] = true;
    }

    /// The mesh has changed at these vertices.
    pub(crate) fn forget(&mut self, vertices: &[u32]) {
        for has in &mut self.has {
            vertices
                .iter()
                .for_each(|v| has.get_mut(*v as usize).into_iter().for_each(|has| *has = false));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::array_mesh::tests::grid;

    #[test]
    fn a_failure_counts_until_something_near_by_changes() {
        let mut mesh = grid(6);
        let mut failed = Failed::new();
        failed.look(&mesh);
        let all = 0..mesh.vertices.len() as u32;
        all.clone().for_each(|v| failed.add(1, v));
        assert!(all.clone().all(|v| failed.has(1, v) && !failed.has(0, v)));
        let middle = 24;
        let mut star = Vec::new();
        mesh.star(middle, &mut star);
        let near: Vec<u32> =
            star.iter().flat_map(|t| mesh.triangles[*t as usize].vertices).collect();
        for (step, changes) in [(0.03, false), (0.03, true)] {
            // Steps add up.
            mesh.vertices[middle as usize].at.x += step * mesh.vertices[middle as usize].size;
            failed.look(&mesh);
            for v in all.clone() {
                assert_eq!(failed.has(1, v), !(changes && near.contains(&v)), "{v}");
            }
        }
        all.clone().for_each(|v| failed.add(0, v));
        failed.forget(&[3]);
        assert!(all.clone().all(|v| failed.has(0, v) == (v != 3)));
        mesh.vertices[middle as usize].triangles += 1;
        failed.look(&mesh);
        assert!(!failed.has(0, middle) && failed.has(0, 0));
    }
}
