//! Writing STL.

use crate::corners::{Corners, triangles};
use crate::gltf::Stored;
use crate::sections::{Section, write_sections};
use crate::{GENERATOR, Plane, WriteError};
use glam::{DVec3, Vec3};
use mindeg_mesh::{Mesh, Positions};
use std::io::Write;

/// Writes a mesh as binary STL.
///
/// O(n) time, shared by all threads of rayon's current pool, and the memory of one block of about
/// half a MiB for each of them, and one more. Writes are large: `out` needs no buffer around it.
///
/// # Errors
///
/// Before the first byte: those of [`check`]. After it: those of `out`.
///
/// # Example
///
/// ```
/// use mindeg_formats::{Plane, obj, stl};
///
/// let square = obj::read("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n".as_bytes())?;
/// let mut file = Vec::new();
/// stl::write(&square, Plane::Xy, &mut file)?;
/// assert_eq!(file.len(), 84 + 2 * 50);
/// let read = stl::read(&file[..])?;
/// assert_eq!((read.positions(), read.triangles()), (square.positions(), square.triangles()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write(mesh: &dyn Mesh, plane: Plane, mut out: impl Write) -> Result<(), WriteError> {
    check(mesh, plane)?;
    write_sections(&mut out, &sections(mesh, plane))?;
    Ok(out.flush()?)
}

/// Refuses positions that 32-bit floats do not hold. O(n).
///
/// # Errors
///
/// [`OutOfRange`](WriteError::OutOfRange) and, for vertices round a boundary,
/// [`Coincident`](WriteError::Coincident).
pub fn check(positions: &dyn Positions, plane: Plane) -> Result<(), WriteError> {
    Stored::in_place(positions, plane).map(drop)
}

/// The file from front to back.
pub(crate) fn sections(mesh: &dyn Mesh, plane: Plane) -> Vec<Section<'_>> {
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
