//! Vertex normals of a mesh that is not planar.

use glam::DVec3;

use crate::mesh::{Mesh, filled};

/// A unit normal for each vertex: the sum of the normals of its triangles, weighted by area. A
/// vertex without a triangle of nonzero area gets +Z. O(n) time and memory.
///
/// # Example
///
/// ```
/// use glam::DVec3;
/// use mindeg_mesh::{TriMesh, vertex_normals};
///
/// let wall = vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Z];
/// let mesh = TriMesh::new(wall, vec![[0, 1, 2]])?;
/// assert_eq!(vertex_normals(&mesh), [-DVec3::Y; 3]);
/// # Ok::<(), mindeg_mesh::TriMeshError>(())
/// ```
pub fn vertex_normals(mesh: &dyn Mesh) -> Vec<DVec3> {
    /// Triangles asked for at a time.
    const BLOCK: u32 = 1 << 12;
    let vertices = 0..mesh.vertex_count();
    let points =
        filled(vertices.clone(), DVec3::ZERO, |first, out| mesh.fill_positions(first, out));
    let mut normals = vec![DVec3::ZERO; vertices.len()];
    let count = mesh.triangle_count();
    for start in (0..count).step_by(BLOCK as usize) {
        let block = start..start.saturating_add(BLOCK).min(count);
        for triangle in filled(block, [0; 3], |first, out| mesh.fill_triangles(first, out)) {
            let [a, b, c] = triangle.map(|vertex| points[vertex as usize]);
            let normal = (b - a).cross(c - a);
            triangle.into_iter().for_each(|vertex| normals[vertex as usize] += normal);
        }
    }
    normals.into_iter().map(|normal| normal.try_normalize().unwrap_or(DVec3::Z)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TriMesh;

    #[test]
    fn a_vertex_has_the_normals_of_its_triangles_by_their_areas() {
        // The first triangle lies flat; the second stands on the x axis and has twice the area.
        let points = vec![DVec3::ZERO, DVec3::X, DVec3::Y, 2.0 * DVec3::Z, 9.0 * DVec3::ONE];
        let mesh = TriMesh::new(points, vec![[0, 1, 2], [1, 0, 3]]).unwrap();
        let shared = DVec3::new(0.0, 2.0, 1.0).normalize();
        let normals = vertex_normals(&mesh);
        // The last is in no triangle.
        for (normal, expected) in normals.iter().zip([shared, shared, DVec3::Z, DVec3::Y, DVec3::Z])
        {
            assert!(normal.abs_diff_eq(expected, 1e-12), "{normals:?}");
        }
        assert_eq!(normals.len(), 5);
    }
}
