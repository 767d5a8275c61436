//! Exact answers about positions, where rounding must not decide.

use glam::DVec2;
use mindeg_mesh::planar::orientation;

/// True if segments `a`-`b` and `c`-`d` have a point in common.
pub(crate) fn meet(a: DVec2, b: DVec2, c: DVec2, d: DVec2) -> bool {
    let sides = |p: DVec2, q: DVec2, r: DVec2, s: DVec2| {
        let (first, second) = (orientation(p, q, r), orientation(p, q, s));
        first > 0.0 && second > 0.0 || first < 0.0 && second < 0.0
    };
    if sides(a, b, c, d) || sides(c, d, a, b) {
        return false;
    }
    // On one line, boxes decide; otherwise boxes of crossing segments overlap anyway.
    a.min(b).cmple(c.max(d)).all() && c.min(d).cmple(a.max(b)).all()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn segments_meet_or_do_not() {
        let point = |[x, y]: [f64; 2]| DVec2::new(x, y);
        for (ends, expected) in [
            ([[0.0, 0.0], [2.0, 2.0], [0.0, 2.0], [2.0, 0.0]], true),
            ([[0.0, 0.0], [2.0, 0.0], [1.0, 0.0], [1.0, 5.0]], true),
            ([[0.0, 0.0], [2.0, 0.0], [1.0, 0.1], [1.0, 5.0]], false),
            ([[0.0, 0.0], [2.0, 0.0], [1.0, 0.0], [3.0, 0.0]], true),
            ([[0.0, 0.0], [2.0, 0.0], [3.0, 0.0], [4.0, 0.0]], false),
            ([[0.0, 0.0], [2.0, 2.0], [3.0, 3.0], [4.0, 4.0]], false),
        ] {
            let [a, b, c, d] = ends.map(point);
            assert_eq!(meet(a, b, c, d), expected, "{ends:?}");
            assert_eq!(meet(d, c, a, b), expected, "{ends:?}");
        }
    }
}
