//! Which way three points turn, exactly.

use glam::DVec2;
use robust::{Coord, orient2d};

/// Positive if `a`, `b`, `c` turn left, negative if they turn right, 0 if they lie on one line.
pub(crate) fn orientation(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    let [a, b, c] = [a, b, c].map(|DVec2 { x, y }| Coord { x, y });
    orient2d(a, b, c)
}
