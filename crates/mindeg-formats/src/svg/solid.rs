//! Which triangles of a mesh in space are seen, and in which order they are drawn.

use super::view::View;
use glam::DVec3;

/// The triangles that are drawn, the farthest first.
pub(super) struct Order {
    pub(super) triangles: Vec<Seen>,
    /// The last of these triangles at each vertex; [`NONE`] at a vertex without any.
    pub(super) last_of_vertex: Vec<u32>,
}

/// No triangle.
const NONE: u32 = u32::MAX;

/// A triangle that is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Seen {
    pub(super) triangle: u32,
    /// Whether it faces the eye.
    pub(super) is_front: bool,
}

impl Order {
    /// `None` if all triangles face the same way: then only folds hide triangles.
    ///
    /// Of a closed mesh whose triangles face outwards, those that face the eye are drawn; of any
    /// other, all. O(n log n).
    pub(super) fn of(
        positions: &[DVec3],
        triangles: &[[u32; 3]],
        view: View,
        is_closed: bool,
    ) -> Option<Self> {
        let corners = |triangle: [u32; 3]| triangle.map(|vertex| positions[vertex as usize]);
        let facing = |triangle: [u32; 3]| {
            let [a, b, c] = corners(triangle);
            let flat = [a, b, c].map(|corner| view.of_point(corner));
            (flat[1] - flat[0]).perp_dot(flat[2] - flat[0])
        };
        let nearness = |triangle: [u32; 3]| {
            corners(triangle).into_iter().map(|corner| view.nearness(corner)).sum::<f64>()
        };
        let all_facing: Vec<f64> = triangles.iter().map(|&triangle| facing(triangle)).collect();
        let is_flat =
            positions.windows(2).all(|two| view.nearness(two[0]) == view.nearness(two[1]));
        let one_way = all_facing.iter().all(|&facing| facing >= 0.0)
            || all_facing.iter().all(|&it| it <= 0.0);
        if is_flat || one_way {
            return None;
        }
        // Six times the volume.
        let volume: f64 =
            triangles.iter().map(|&it| corners(it)).map(|[a, b, c]| a.dot(b.cross(c))).sum();
        let hides_backs = is_closed && volume > 0.0;
        let mut order: Vec<(f64, Seen)> = (0..)
            .zip(triangles)
            .zip(&all_facing)
            .filter(|&(_, &facing)| facing > 0.0 || facing < 0.0 && !hides_backs)
            .map(|((triangle, &corners), &facing)| {
                (nearness(corners), Seen { triangle, is_front: facing > 0.0 })
            })
            .collect();
        order.sort_by(|a, b| a.0.total_cmp(&b.0));
        let drawn: Vec<Seen> = order.into_iter().map(|(_, seen)| seen).collect();
        let mut last_of_vertex = vec![NONE; positions.len()];
        for seen in &drawn {
            for vertex in triangles[seen.triangle as usize] {
                last_of_vertex[vertex as usize] = seen.triangle;
            }
        }
        Some(Self { triangles: drawn, last_of_vertex })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A box from 0 to 1, triangles facing outwards; the two of z = 1 come last.
    fn cube() -> (Vec<DVec3>, Vec<[u32; 3]>) {
        let point = |i: u32| DVec3::new(f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2));
        let triangles = vec![
            [0, 2, 3],
            [0, 3, 1],
            [0, 1, 5],
            [0, 5, 4],
            [1, 3, 7],
            [1, 7, 5],
            [3, 2, 6],
            [3, 6, 7],
            [2, 0, 4],
            [2, 4, 6],
            [4, 5, 7],
            [4, 7, 6],
        ];
        ((0..8).map(point).collect(), triangles)
    }

    fn drawn(order: &Order) -> Vec<(u32, bool)> {
        order.triangles.iter().map(|seen| (seen.triangle, seen.is_front)).collect()
    }

    #[test]
    fn backs_of_closed_solids_are_left_out() {
        let (points, triangles) = cube();
        let order = Order::of(&points, &triangles, View::Z, true).unwrap();
        assert_eq!(drawn(&order), [(10, true), (11, true)]);
        assert_eq!(order.last_of_vertex, [NONE, NONE, NONE, NONE, 11, 10, 11, 11]);
        for (view, front) in [(View::X, [4, 5]), (View::Y, [2, 3])] {
            let order = Order::of(&points, &triangles, view, true).unwrap();
            assert_eq!(drawn(&order).iter().map(|it| it.0).collect::<Vec<_>>(), front);
        }
        // Inside out, the outside would vanish; so all are drawn.
        let inside_out: Vec<_> = triangles.iter().map(|&[a, b, c]| [a, c, b]).collect();
        let order = Order::of(&points, &inside_out, View::Z, true).unwrap();
        assert_eq!(drawn(&order), [(0, true), (1, true), (10, false), (11, false)]);
    }

    #[test]
    fn through_an_opening_the_inside_is_seen_behind() {
        let (points, mut triangles) = cube();
        triangles.truncate(11);
        let order = Order::of(&points, &triangles, View::Z, false).unwrap();
        assert_eq!(drawn(&order), [(0, false), (1, false), (10, true)]);
    }

    #[test]
    fn what_hides_nothing_is_drawn_flat() {
        let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.2], [0.0, 1.0, 0.1]].map(DVec3::from_array);
        assert!(Order::of(&points, &[[0, 1, 2]], View::Z, false).is_none());
        // Two triangles of a plane that do not agree.
        let flat = points.map(|point| point.with_z(0.0));
        assert!(Order::of(&flat, &[[0, 1, 2], [0, 2, 1]], View::Z, false).is_none());
    }
}
