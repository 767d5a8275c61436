//! Writing STL.

use crate::corners::{Corners, triangles};
use crate::sections::Section;
use crate::{GENERATOR, MeshPlane};
use glam::{DVec3, Vec3};
use mindeg_mesh::Mesh;

/// The file from front to back.
pub(crate) fn sections(mesh: &dyn Mesh, plane: MeshPlane) -> Vec<Section<'_>> {
    let count = mesh.triangle_count();
    // The first word must not be "solid", which is how a text begins.
    let mut header = GENERATOR.as_bytes().to_vec();
    header.resize(80, b' ');
    header.extend_from_slice(&count.to_le_bytes());
    let facets = Section::new(count, 50, move |range, buffer| {
        let mut corners = Corners::new(mesh);
        for triangle in triangles(mesh, range) {
            // Rounding can make a zero negative; adding zero undoes it.
            let store = |point| plane.place(point).as_vec3() + Vec3::ZERO;
            let [a, b, c] = corners.positions(triangle).map(store);
            let facet = [normal([a, b, c]), a, b, c].map(|p| p.to_array().map(f32::to_le_bytes));
            buffer.extend_from_slice(facet.as_flattened().as_flattened());
            buffer.extend_from_slice(&[0, 0]);
        }
    });
    vec![Section::bytes(header), facets]
}

/// The unit normal; zero for a triangle without area.
fn normal(corners: [Vec3; 3]) -> Vec3 {
    let [a, b, c] = corners.map(Vec3::as_dvec3);
    let normal: DVec3 = (b - a).cross(c - a);
    normal.normalize_or_zero().as_vec3() + Vec3::ZERO
}
