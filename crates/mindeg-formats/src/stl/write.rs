//! Writing STL.

use crate::corners::{Corners, triangles};
use crate::numbers::Numbers;
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
    let facets = move |range| {
        let mut corners = Corners::new(mesh);
        // Rounding can make a zero negative; adding zero undoes it.
        let store = move |point| plane.place(point).as_vec3() + Vec3::ZERO;
        triangles(mesh, range).into_iter().map(move |triangle| {
            let [a, b, c] = corners.positions(triangle).map(store);
            let [normal, a, b, c] = [normal([a, b, c]), a, b, c].map(|it| it.to_array());
            (normal, (a, b, c), [0_u16])
        })
    };
    let facets = Numbers::LittleEndian.records(0..count, facets);
    vec![Section::bytes(header), facets]
}

/// The unit normal; zero for a triangle without area.
fn normal(corners: [Vec3; 3]) -> Vec3 {
    let [a, b, c] = corners.map(Vec3::as_dvec3);
    let normal: DVec3 = (b - a).cross(c - a);
    normal.normalize_or_zero().as_vec3() + Vec3::ZERO
}
