//! Positions of the corners of triangles, and measures at them.
//!
//! Limits: the cache is small, and made for triangles whose corners lie in few runs of vertices,
//! as in a strip. Any other order works too, and takes longer.

use std::ops::Range;

use glam::DVec3;
use mindeg_mesh::quality::TriangleQuality;
use mindeg_mesh::{Mesh, filled};

/// Vertices to a run.
const RUN: u32 = 64;

/// How many runs are kept: a power of two.
const KEPT: usize = 16;

/// The positions of vertices in any order, with some of them kept.
pub(crate) struct Corners<'a> {
    mesh: &'a dyn Mesh,
    kept: Vec<(u32, Vec<DVec3>)>,
}

impl<'a> Corners<'a> {
    pub(crate) fn new(mesh: &'a dyn Mesh) -> Self {
        Self { mesh, kept: vec![(u32::MAX, Vec::new()); KEPT] }
    }

    /// Where a vertex is.
    pub(crate) fn position(&mut self, vertex: u32) -> DVec3 {
        let run = vertex / RUN;
        let (kept, positions) = &mut self.kept[run as usize % KEPT];
        if *kept != run {
            let start = run * RUN;
            let len = RUN.min(self.mesh.vertex_count() - start);
            positions.resize(len as usize, DVec3::ZERO);
            self.mesh.fill_positions(start, positions);
            *kept = run;
        }
        positions[(vertex % RUN) as usize]
    }

    /// Where the corners of a triangle are.
    pub(crate) fn positions(&mut self, triangle: [u32; 3]) -> [DVec3; 3] {
        triangle.map(|vertex| self.position(vertex))
    }
}

/// The minimum angles of some triangles, in degrees; 0 for one without area.
pub(crate) fn min_angles(mesh: &dyn Mesh, range: Range<u32>) -> impl Iterator<Item = f64> + '_ {
    let mut corners = Corners::new(mesh);
    let triangles = filled(range, [0; 3], |first, out| mesh.fill_triangles(first, out));
    triangles.into_iter().map(move |triangle| min_angle(corners.positions(triangle)))
}

/// The minimum angle of a triangle, in degrees.
///
/// [`TriangleQuality`] has it too, among slower measures. It is used where products of
/// coordinates leave the range of floats.
fn min_angle([a, b, c]: [DVec3; 3]) -> f64 {
    let [x, y, z] = [c - b, a - c, b - a];
    // The length of the cross product is twice the area at all three corners; at the maximum angle
    // it loses least to rounding.
    let dots = [-y.dot(z), -z.dot(x), -x.dot(y)];
    let [least, greatest] = [dots[0].min(dots[1]).min(dots[2]), dots[0].max(dots[1]).max(dots[2])];
    let cross = if dots[0] == least {
        y.cross(z)
    } else if dots[1] == least {
        z.cross(x)
    } else {
        x.cross(y)
    };
    let square = cross.length_squared();
    if !(1e-250..1e250).contains(&square) {
        return TriangleQuality::in_space(a, b, c).min_angle;
    }
    libm::atan2(square.sqrt(), greatest).to_degrees()
}

/// The degrees of some vertices.
pub(crate) fn degrees(mesh: &dyn Mesh, range: Range<u32>) -> Vec<u32> {
    filled(range, 0, |first, out| mesh.fill_degrees(first, out))
}

/// The positions of some vertices, none with a negative zero.
pub(crate) fn positions(mesh: &dyn Mesh, range: Range<u32>) -> impl Iterator<Item = DVec3> {
    let positions = filled(range, DVec3::ZERO, |first, out| mesh.fill_positions(first, out));
    // Adding zero turns -0 into 0.
    positions.into_iter().map(|position| position + DVec3::ZERO)
}

/// Some triangles by their vertices.
pub(crate) fn triangles(mesh: &dyn Mesh, range: Range<u32>) -> Vec<[u32; 3]> {
    filled(range, [0; 3], |first, out| mesh.fill_triangles(first, out))
}

/// Some segments by their vertices.
pub(crate) fn segments(mesh: &dyn Mesh, range: Range<u32>) -> Vec<[u32; 2]> {
    filled(range, [0; 2], |first, out| mesh.fill_segments(first, out))
}

#[cfg(test)]
mod tests {
    use super::*;
    use mindeg_mesh::TriMesh;

    #[test]
    fn corners_in_any_order_are_where_the_mesh_has_them() {
        let count = 5 * RUN * KEPT as u32 + 7;
        let points: Vec<_> = (0..count).map(|i| DVec3::new(f64::from(i), 1.0, 0.0)).collect();
        let mesh = TriMesh::new(points.clone(), vec![[0, 1, count - 1]]).unwrap();
        let mut corners = Corners::new(&mesh);
        for i in 0..4 * count {
            let vertex = i.wrapping_mul(0x9e37_79b9) % count;
            assert_eq!(corners.position(vertex), points[vertex as usize]);
        }
    }

    #[test]
    fn minimum_angles_are_in_degrees() {
        let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [2.0, 0.0]];
        let points = points.map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec();
        let mesh = TriMesh::new(points, vec![[0, 1, 2], [0, 1, 3]]).unwrap();
        let angles: Vec<f64> = min_angles(&mesh, 0..2).collect();
        assert!((angles[0] - 45.0).abs() < 1e-12 && angles[1] == 0.0, "{angles:?}");
    }

    #[test]
    fn minimum_angles_are_those_of_the_quality() {
        let mut state = 1_u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 40) as f64 / f64::from(1 << 24)
        };
        for exponent in [-300, -120, -3, 0, 100, 300] {
            let scale = 10_f64.powi(exponent);
            for flatness in [1.0, 1e-3, 1e-7] {
                for _ in 0..200 {
                    let corner = |_| DVec3::new(next(), flatness * next(), flatness * next());
                    let [a, b, c] = [0; 3].map(corner).map(|corner| corner * scale);
                    let [expected, found] =
                        [TriangleQuality::in_space(a, b, c).min_angle, min_angle([a, b, c])];
                    // Rounding of corners as flat as that takes digits off both.
                    let close = (found - expected).abs() <= 1e-9 / flatness * expected + 1e-300;
                    assert!(close, "{found}, expected {expected}: {a} {b} {c}");
                }
            }
        }
    }
}
