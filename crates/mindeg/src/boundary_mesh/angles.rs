//! The triangles of a strip on actual points, and the cotangents of their minimum and maximum angles.
//!
//! Why this is not [`TriangleQuality`](mindeg_mesh::quality::TriangleQuality), which measures angles
//! for people: the choice among candidates must be the same on every machine, so it compares by the
//! four basic operations alone, and it visits every triangle of up to 64 candidates, so it leaves out
//! the arcs and roots. A cotangent falls where its angle grows, so the greatest cotangent is that
//! of the minimum angle.
//!
//! Limits: cotangents only compare angles; degrees come from one arctangent at the end.

use glam::DVec2;

/// The positions of the vertices of some triangles, in order.
///
/// Each is asked for once as long as consecutive triangles share it, as in a strip: nearly every
/// one once or twice in all.
pub(super) fn placed<T: ExactSizeIterator<Item = [u32; 3]>>(
    triangles: T,
    mut point: impl FnMut(u32) -> DVec2,
) -> impl ExactSizeIterator<Item = [DVec2; 3]> {
    let mut last = ([u32::MAX; 3], [DVec2::ZERO; 3]);
    triangles.map(move |vertices| {
        let (known, known_points) = last;
        let points = vertices.map(|vertex| match known.iter().position(|&v| v == vertex) {
            Some(index) => known_points[index],
            None => point(vertex),
        });
        last = (vertices, points);
        points
    })
}

/// The cotangents of a triangle's minimum and maximum angles; infinite for a triangle that is not
/// counter-clockwise.
pub(super) fn cotangents([a, b, c]: [DVec2; 3]) -> [f64; 2] {
    let [x, y, z] = [c - b, a - c, b - a];
    // A cotangent is the dot product of the edges at the vertex over their cross product, and
    // that is twice the area at all three.
    let dots = [-y.dot(z), -z.dot(x), -x.dot(y)];
    let [least, greatest] = [dots[0].min(dots[1]).min(dots[2]), dots[0].max(dots[1]).max(dots[2])];
    // At the maximum angle, the cross product cancels least.
    let cross = if dots[0] == least {
        y.perp_dot(z)
    } else if dots[1] == least {
        z.perp_dot(x)
    } else {
        x.perp_dot(y)
    };
    if cross > 0.0 { [greatest / cross, least / cross] } else { [f64::INFINITY, f64::NEG_INFINITY] }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cotangents_of_the_minimum_and_the_maximum_angle() {
        let of = |triangle: [[f64; 2]; 3]| cotangents(triangle.map(DVec2::from));
        let infinite = [f64::INFINITY, f64::NEG_INFINITY];
        for (triangle, expected) in [
            ([[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]], [4.0 / 3.0, 0.0]),
            ([[0.0, 3.0], [0.0, 0.0], [4.0, 0.0]], [4.0 / 3.0, 0.0]),
            ([[0.0, 0.0], [1.0, 0.0], [2.0, 1.0]], [3.0, -1.0]),
            ([[0.0, 0.0], [0.0, 3.0], [4.0, 0.0]], infinite),
            ([[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]], infinite),
        ] {
            assert_eq!(of(triangle), expected, "{triangle:?}");
        }
    }
}
