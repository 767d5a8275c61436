//! Outlines for tests.

use glam::DVec2;
use mindeg_mesh::planar::PlanarBoundary;

/// A convex polygon with equal intervals on each side.
pub(crate) fn polygon(corners: &[[f64; 2]], intervals: &[u32]) -> PlanarBoundary {
    PlanarBoundary::new(&[ring(corners, intervals)]).unwrap()
}

pub(crate) fn ring(corners: &[[f64; 2]], intervals: &[u32]) -> Vec<DVec2> {
    let mut points = Vec::new();
    for (i, count) in intervals.iter().enumerate() {
        let (a, b) = (DVec2::from(corners[i]), DVec2::from(corners[(i + 1) % corners.len()]));
        points.extend((0..*count).map(|j| a + (b - a) * (f64::from(j) / f64::from(*count))));
    }
    points
}

pub(crate) fn rectangle(width: f64, height: f64, intervals: [u32; 4]) -> PlanarBoundary {
    polygon(&[[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]], &intervals)
}

/// A plate of 10 by 8 with a square hole, and a reflex corner at (6, 4).
pub(crate) fn plate_with_hole() -> PlanarBoundary {
    let outer = ring(
        &[[0.0, 0.0], [10.0, 0.0], [10.0, 4.0], [6.0, 4.0], [6.0, 8.0], [0.0, 8.0]],
        &[20, 8, 8, 8, 12, 16],
    );
    let hole = ring(&[[2.0, 2.0], [2.0, 4.0], [4.0, 4.0], [4.0, 2.0]], &[5, 5, 5, 5]);
    PlanarBoundary::new(&[outer, hole]).unwrap()
}
