//! Normals of a mesh that is not in a plane.

use glam::DVec3;

use crate::mesh::{Mesh, filled};

/// A unit normal for each vertex: the sum of the normals of its triangles, each as long as the
/// triangle is large. A vertex without a triangle that has an area gets +Z. O(n) time and memory.
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
#[must_use]
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
