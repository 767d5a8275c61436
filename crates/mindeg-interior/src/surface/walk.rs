//! The foot of a point on a patch by a walk over its triangles: for points that moved a little, much less work than a search
//! of the whole patch.

use glam::DVec3;
use mindeg_surfaces::{Foot, NONE, Surface};

/// A walk that is longer has lost its way.
const LONGEST: usize = 40;

/// The shares of a triangle's corners at its point nearest to `p`.
pub(crate) fn nearest_shares(p: DVec3, [a, b, c]: [DVec3; 3]) -> [f64; 3] {
    let normal = (b - a).cross(c - a);
    let square = normal.length_squared();
    let part = |from: DVec3, to: DVec3| (to - from).cross(p - from).dot(normal) / square;
    let [u, v, w] = [part(b, c), part(c, a), part(a, b)];
    if u >= 0.0 && v >= 0.0 && w >= 0.0 {
        let sum = u + v + w;
        return [u / sum, v / sum, w / sum];
    }
    let along = |from: DVec3, to: DVec3| {
        let edge = to - from;
        let share = ((p - from).dot(edge) / edge.length_squared()).clamp(0.0, 1.0);
        (p.distance_squared(from + edge * share), share)
    };
    let [ab, bc, ca] = [along(a, b), along(b, c), along(c, a)];
    if ab.0 <= bc.0 && ab.0 <= ca.0 {
        [1.0 - ab.1, ab.1, 0.0]
    } else if bc.0 <= ca.0 {
        [0.0, 1.0 - bc.1, bc.1]
    } else {
        [ca.1, 0.0, 1.0 - ca.1]
    }
}

/// The squared distance from a point to a triangle.
pub(crate) fn squared_distance(p: DVec3, corners @ [a, b, c]: [DVec3; 3]) -> f64 {
    let [u, v, w] = nearest_shares(p, corners);
    p.distance_squared(a * u + b * v + c * w)
}

/// The foot of a point, found from a triangle of the patch that is near. `None` if the walk ends at a vertex, where it does not
/// know all triangles; farther than `most`; or on a triangle that does not face `facing`.
pub(crate) fn walk(
    surface: &Surface,
    patch: u32,
    point: DVec3,
    facing: DVec3,
    near: u32,
    most: f64,
) -> Option<Foot> {
    let corners = |t: u32| surface.triangles()[t as usize].map(|v| surface.points()[v as usize]);
    let foot = |t: u32| {
        let corners @ [a, b, c] = corners(t);
        let shares @ [u, v, w] = nearest_shares(point, corners);
        let at = a * u + b * v + c * w;
        (point.distance_squared(at), shares, at)
    };
    if surface.triangles().get(near as usize).is_none() || surface.patch(near) != patch {
        return None;
    }
    let (mut t, mut best) = (near, foot(near));
    for _ in 0..LONGEST {
        // Across the edges that the foot is on.
        let mut next = None;
        for i in (0..3).filter(|i| best.1[*i] == 0.0) {
            let u = surface.neighbours()[t as usize][i];
            if u != NONE && surface.patch(u) == patch {
                let other = foot(u);
                if other.0 < next.map_or(best.0, |(_, (square, ..)): (u32, (f64, _, _))| square) {
                    next = Some((u, other));
                }
            }
        }
        let Some(found) = next else { break };
        (t, best) = found;
    }
    let (square, weights, at) = best;
    let is_at_vertex = weights.iter().filter(|share| **share == 0.0).count() > 1;
    if is_at_vertex || square > most * most {
        return None;
    }
    let [a, b, c] = corners(t);
    if facing != DVec3::ZERO && (b - a).cross(c - a).dot(facing) <= 0.0 {
        return None;
    }
    let smooth = |i: usize| weights[i] * surface.corner_normal(t, i);
    let normal = (smooth(0) + smooth(1) + smooth(2)).try_normalize()?;
    Some(Foot { point: at, normal, triangle: t, weights, distance: square.sqrt() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::work::tests::reference;
    use proptest::prelude::*;

    fn vector(range: f64) -> impl Strategy<Value = DVec3> {
        [-range..range, -range..range, -range..range].prop_map(DVec3::from)
    }

    proptest! {
        /// No other point of the triangle is nearer.
        #[test]
        fn the_nearest_point_is_the_nearest(
            p in vector(2.0), a in vector(1.0), b in vector(1.0), c in vector(1.0),
        ) {
            prop_assume!((b - a).cross(c - a).length() > 1e-3);
            let [u, v, w] = nearest_shares(p, [a, b, c]);
            prop_assert!(u >= 0.0 && v >= 0.0 && w >= 0.0 && (u + v + w - 1.0).abs() < 1e-12);
            let square = squared_distance(p, [a, b, c]);
            for i in 0..=20 {
                for j in 0..=20 - i {
                    let [s, t] = [i, j].map(|k| f64::from(k) / 20.0);
                    let other = a * s + b * t + c * (1.0 - s - t);
                    prop_assert!(p.distance_squared(other) >= square - 1e-12);
                }
            }
        }
    }

    #[test]
    fn a_walk_finds_the_foot_that_a_search_finds() {
        let reference = reference("torus", 1.0);
        let surface = &reference.surface;
        let count = surface.triangles().len() as u32;
        let mut found = 0;
        for t in 0..count {
            let [a, b, c] = surface.triangles()[t as usize].map(|v| surface.points()[v as usize]);
            // Beyond an edge, and off the surface.
            let normal = surface.face_normal(t);
            let point = a.lerp(b, 0.4) + (a - c) * 0.3 + normal * 0.02;
            let search = surface.nearest(0, point, Some(normal), t);
            if let Some(foot) = walk(surface, 0, point, normal, t, 0.1) {
                found += 1;
                assert!((foot.distance - search.distance).abs() < 1e-9, "{t}");
                assert!(foot.point.distance(search.point) < 1e-6);
                assert!(foot.normal.distance(search.normal) < 1e-4);
            }
            // Too far, or facing the other way.
            assert_eq!(walk(surface, 0, point + normal, normal, t, 0.1), None);
            assert_eq!(walk(surface, 0, point, -normal, t, 0.1), None);
        }
        assert!(found > count * 9 / 10, "{found} of {count}");
    }
}
