//! Checks of the array mesh's invariants, which [`array_mesh`](crate::array_mesh) states.

#[cfg(debug_assertions)]
use crate::array_mesh::Kind;
use crate::array_mesh::{ArrayMesh, NONE};
use crate::manifold::Manifold;

impl<S: Manifold> ArrayMesh<S> {
    /// Checks the invariants round some vertices.
    #[cfg(debug_assertions)]
    pub(crate) fn check_near(&self, vertices: &[u32]) {
        let mut star = Vec::new();
        for v in vertices {
            let vertex = self.vertices[*v as usize];
            // One on a curve goes with the triangles on its only side.
            if vertex.kind == Kind::Curve && vertex.anchor == NONE {
                continue;
            }
            assert_ne!(vertex.anchor, NONE, "vertex {v} of the rim is dead");
            let is_closed = self.star(*v, &mut star);
            assert_eq!(star.len() as u32, vertex.triangles, "fan of vertex {v}");
            assert!(!S::IS_PLANE || is_closed != (vertex.kind == Kind::Boundary), "kind of {v}");
            star.iter()
                .for_each(|t| self.check_triangle(*t).unwrap_or_else(|e| unreachable!("{e}")));
        }
    }

    /// Checks all invariants; for tests and at the end of a run.
    pub(crate) fn check(&self) -> Result<(), String> {
        let mut counts = vec![0; self.vertices.len()];
        for t in 0..self.triangles.len() as u32 {
            if self.triangles[t as usize].is_alive() {
                self.check_triangle(t)?;
                for v in self.triangles[t as usize].vertices {
                    counts[v as usize] += 1;
                }
            }
        }
        let wrong = (0..counts.len()).find(|v| counts[*v] != self.vertices[*v].triangles);
        wrong.map_or(Ok(()), |v| Err(format!("vertex {v} counts its triangles wrongly")))
    }

    fn check_triangle(&self, t: u32) -> Result<(), String> {
        let triangle = self.triangles[t as usize];
        S::check(self, t)?;
        for i in 0..3 {
            let neighbour = triangle.neighbours[i];
            if neighbour == NONE {
                if !S::IS_PLANE && !triangle.is_locked(i) {
                    return Err(format!("triangle {t} has a boundary edge on no curve"));
                }
                continue;
            }
            let other = self.triangles[neighbour as usize];
            let (from, to) = (triangle.vertices[(i + 1) % 3], triangle.vertices[(i + 2) % 3]);
            let knows = (0..3).any(|j| {
                other.neighbours[j] == t
                    && (other.vertices[(j + 1) % 3], other.vertices[(j + 2) % 3]) == (to, from)
                    && other.labels[j] == triangle.labels[i]
            });
            if !knows {
                return Err(format!("triangles {t} and {neighbour} disagree"));
            }
        }
        Ok(())
    }
}
