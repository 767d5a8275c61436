//! Whether two triangles cross, exactly.

use glam::DVec3;
use robust::{Coord, Coord3D, orient2d, orient3d};

/// Whether two triangles have a common point besides the corners and edges that they share; see the
/// [module](crate::crossing).
///
/// # Panics
///
/// If a triangle names a vertex that does not exist.
pub fn cross(positions: &[DVec3], a: [u32; 3], b: [u32; 3]) -> bool {
    let at = |vertex: u32| positions[vertex as usize];
    let [p, q] = [a.map(at), b.map(at)];
    let (Some(plane_p), Some(plane_q)) = (Plane::of(p), Plane::of(q)) else { return false };
    let shared = |vertex: &u32| b.contains(vertex);
    match a.iter().filter(|vertex| shared(vertex)).count() {
        0 => {
            edges(q).iter().any(|&edge| meets(plane_p, p, edge))
                || edges(p).iter().any(|&edge| meets(plane_q, q, edge))
        }
        1 => {
            let [i, j] = [
                a.iter().position(shared).unwrap_or(0),
                b.iter().position(|vertex| a.contains(vertex)).unwrap_or(0),
            ];
            let [p, q] = [turned(p, i), turned(q, j)];
            at_corner(plane_p, p, q) || at_corner(plane_q, q, p)
        }
        2 => {
            let apex = |own: [u32; 3], other: [u32; 3]| {
                own.into_iter().find(|vertex| !other.contains(vertex)).unwrap_or(own[0])
            };
            let [i, j] = [apex(a, b), apex(b, a)].map(at);
            let ends: Vec<DVec3> = a.iter().filter(|v| shared(v)).map(|&v| at(v)).collect();
            side_of([p[0], p[1], p[2]], j) == 0.0
                && plane_p.orient(ends[0], ends[1], i) * plane_p.orient(ends[0], ends[1], j) > 0.0
        }
        _ => true,
    }
}

/// Whether triangles p and q, which share their first corner, have another common point on the edge
/// of q opposite to that corner, or, in one plane, on an edge of q from that corner.
fn at_corner(plane: Plane, p: [DVec3; 3], q: [DVec3; 3]) -> bool {
    if meets(plane, p, [q[1], q[2]]) {
        return true;
    }
    // In one plane: an edge of q from the corner runs within the angle of p there.
    let turn = plane.orient(p[0], p[1], p[2]);
    let is_within = |end: DVec3| {
        turn * plane.orient(p[0], p[1], end) >= 0.0 && turn * plane.orient(p[0], end, p[2]) >= 0.0
    };
    side_of(p, q[1]) == 0.0 && side_of(p, q[2]) == 0.0 && (is_within(q[1]) || is_within(q[2]))
}

/// Whether a segment has a point in a triangle, edges and corners included.
fn meets(plane: Plane, triangle: [DVec3; 3], [from, to]: [DVec3; 2]) -> bool {
    let sides = [from, to].map(|point| side_of(triangle, point));
    if sides[0] * sides[1] > 0.0 {
        return false;
    }
    if sides == [0.0; 2] {
        return plane.meets(triangle, [from, to]);
    }
    // The line through the segment has all edges on one side, or touches them.
    let turns = edges(triangle).map(|[a, b]| orient([from, to, a, b]));
    turns.iter().all(|&turn| turn >= 0.0) || turns.iter().all(|&turn| turn <= 0.0)
}

/// A coordinate plane in which the projection of a triangle has area.
#[derive(Clone, Copy)]
struct Plane {
    axes: [usize; 2],
}

impl Plane {
    /// `None` for a flat triangle.
    fn of([a, b, c]: [DVec3; 3]) -> Option<Self> {
        let planes = [[0, 1], [1, 2], [2, 0]].map(|axes| Self { axes });
        planes.into_iter().find(|plane| plane.orient(a, b, c) != 0.0)
    }

    /// The sign gives the direction in which the projections of three points turn.
    fn orient(self, a: DVec3, b: DVec3, c: DVec3) -> f64 {
        let on = |point: DVec3| Coord { x: point[self.axes[0]], y: point[self.axes[1]] };
        sign(orient2d(on(a), on(b), on(c)))
    }

    /// Whether a segment in the plane of a triangle has a point in the triangle.
    fn meets(self, triangle: [DVec3; 3], [from, to]: [DVec3; 2]) -> bool {
        let [a, b, c] = triangle;
        let turn = self.orient(a, b, c);
        let holds =
            |point| edges(triangle).iter().all(|&[a, b]| turn * self.orient(a, b, point) >= 0.0);
        holds(from) || edges(triangle).iter().any(|&edge| self.segments_meet(edge, [from, to]))
    }

    /// Whether two segments have a point in common.
    fn segments_meet(self, [a, b]: [DVec3; 2], [c, d]: [DVec3; 2]) -> bool {
        let [at_a, at_b] = [a, b].map(|end| self.orient(c, d, end));
        let [at_c, at_d] = [c, d].map(|end| self.orient(a, b, end));
        if [at_a, at_b, at_c, at_d] == [0.0; 4] {
            // On one line: compare their boxes.
            let apart = |axis: usize| {
                a[axis].max(b[axis]) < c[axis].min(d[axis])
                    || c[axis].max(d[axis]) < a[axis].min(b[axis])
            };
            return !self.axes.into_iter().any(apart);
        }
        at_a * at_b <= 0.0 && at_c * at_d <= 0.0
    }
}

/// The sign gives the side of a triangle's plane that a point is on; 0 is in the plane.
fn side_of([a, b, c]: [DVec3; 3], point: DVec3) -> f64 {
    orient([a, b, c, point])
}

fn orient(points: [DVec3; 4]) -> f64 {
    let [a, b, c, d] = points.map(|point| Coord3D { x: point.x, y: point.y, z: point.z });
    sign(orient3d(a, b, c, d))
}

/// -1, 0 or 1: products of signs do not underflow.
fn sign(value: f64) -> f64 {
    if value > 0.0 {
        1.0
    } else if value < 0.0 {
        -1.0
    } else {
        0.0
    }
}

fn edges([a, b, c]: [DVec3; 3]) -> [[DVec3; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

/// The triangle from its corner `first` on.
fn turned(corners: [DVec3; 3], first: usize) -> [DVec3; 3] {
    [0, 1, 2].map(|i| corners[(first + i) % 3])
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn points<const N: usize>(points: [[i32; 3]; N]) -> [DVec3; N] {
        points.map(|point| DVec3::from(point.map(f64::from)))
    }

    #[track_caller]
    fn assert_cross(corners: &[DVec3], a: [u32; 3], b: [u32; 3], expected: bool) {
        for a in [a, [a[1], a[2], a[0]], [a[0], a[2], a[1]]] {
            for b in [b, [b[2], b[0], b[1]], [b[1], b[0], b[2]]] {
                assert_eq!(cross(corners, a, b), expected, "{a:?}, {b:?}");
                assert_eq!(cross(corners, b, a), expected, "{b:?}, {a:?}");
            }
        }
    }

    #[test]
    fn triangles_without_common_corners() {
        let base = [[0, 0, 0], [8, 0, 0], [0, 8, 0]];
        for (other, expected) in [
            // Through the inside, through an edge, beside.
            ([[1, 1, -1], [1, 1, 1], [9, 9, 0]], true),
            ([[4, -1, 1], [4, 1, -1], [4, -9, -9]], true),
            ([[5, 5, -1], [5, 5, 1], [9, 9, 0]], false),
            // Touching with a corner, with an edge, along an edge.
            ([[1, 1, 0], [1, 1, 5], [2, 1, 5]], true),
            ([[1, 1, 0], [2, 1, 0], [2, 1, 5]], true),
            ([[2, 0, 0], [6, 0, 0], [4, 0, 5]], true),
            ([[9, 0, 0], [12, 0, 0], [10, 0, 5]], false),
            // Above, parallel.
            ([[1, 1, 1], [2, 1, 1], [1, 2, 1]], false),
            // In the same plane: within, around, across, touching, apart.
            ([[1, 1, 0], [2, 1, 0], [1, 2, 0]], true),
            ([[-9, -9, 0], [40, -9, 0], [-9, 40, 0]], true),
            ([[-1, 2, 0], [9, 2, 0], [4, -3, 0]], true),
            ([[4, 4, 0], [9, 9, 0], [4, 9, 0]], true),
            ([[5, 5, 0], [9, 9, 0], [4, 9, 0]], false),
            // Flat triangles cross nothing.
            ([[1, 1, -1], [1, 1, 0], [1, 1, 1]], false),
        ] {
            let corners = points([base[0], base[1], base[2], other[0], other[1], other[2]]);
            assert_cross(&corners, [0, 1, 2], [3, 4, 5], expected);
        }
    }

    #[test]
    fn triangles_with_a_common_corner() {
        let base = [[0, 0, 0], [8, 0, 0], [0, 8, 0]];
        for (other, expected) in [
            // In space: through the inside, only touching, along the line beyond.
            ([[3, 3, -1], [3, 3, 1]], true),
            ([[9, -9, -1], [9, -9, 9]], false),
            ([[9, 9, -1], [9, 9, 1]], true),
            ([[-3, -3, -1], [-3, -3, 1]], false),
            // Along an edge.
            ([[4, 0, 0], [4, 0, 4]], true),
            ([[-4, 0, 0], [4, 0, 4]], false),
            // In the plane: within, around, beside, along an edge.
            ([[1, 2, 0], [2, 1, 0]], true),
            ([[-1, 9, 0], [9, -1, 0]], true),
            ([[-1, 9, 0], [-9, -1, 0]], false),
            ([[0, 3, 0], [-9, -1, 0]], true),
        ] {
            let corners = points([base[0], base[1], base[2], other[0], other[1]]);
            assert_cross(&corners, [0, 1, 2], [0, 3, 4], expected);
        }
    }

    #[test]
    fn triangles_with_a_common_edge() {
        for (other, expected) in
            [([3, -3, 0], false), ([3, 3, 0], true), ([3, 3, 1], false), ([3, -3, 1], false)]
        {
            let corners = points([[0, 0, 0], [8, 0, 0], [0, 8, 0], other]);
            assert_cross(&corners, [0, 1, 2], [1, 0, 3], expected);
        }
        let corners = points([[0, 0, 0], [8, 0, 0], [0, 8, 0]]);
        assert_cross(&corners, [0, 1, 2], [2, 1, 0], true);
    }

    /// Whether two triangles have a common point, besides corners and edges that they share, whose
    /// barycentric coordinates are 24ths in both. This proves crossings, but does not find all of
    /// them.
    fn have_common_grid_point(p: [[i64; 3]; 3], q: [[i64; 3]; 3], shared: &[[i64; 3]]) -> bool {
        const N: i64 = 24;
        let grid = |t: [[i64; 3]; 3]| {
            let mut found = std::collections::BTreeSet::new();
            for i in 0..=N {
                for j in 0..=N - i {
                    let weights = [i, j, N - i - j];
                    let point =
                        [0, 1, 2].map(|x| (0..3).map(|c| weights[c] * t[c][x]).sum::<i64>());
                    found.insert(point);
                }
            }
            found
        };
        let shared: Vec<_> = shared.iter().map(|point| point.map(|x| x * N)).collect();
        // Points on the line through two shared corners are on the shared edge.
        let on_shared_edge = |point: &[i64; 3]| match shared[..] {
            [a] => *point == a,
            [a, b] => {
                let [u, v] = [[0, 1, 2].map(|x| b[x] - a[x]), [0, 1, 2].map(|x| point[x] - a[x])];
                (0..3).all(|x| u[x] * v[(x + 1) % 3] == u[(x + 1) % 3] * v[x])
            }
            _ => false,
        };
        grid(p).intersection(&grid(q)).any(|point| !on_shared_edge(point))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(512))]

        /// Common points that are found on a grid are crossings.
        #[test]
        fn common_points_are_crossings(
            p in prop::array::uniform6(prop::array::uniform3(0_i64..4)), shared in 0_usize..3
        ) {
            let corners = p.map(|point| DVec3::from(point.map(|x| x as f64)));
            let (a, b) = match shared {
                0 => ([0, 1, 2], [3, 4, 5]),
                1 => ([0, 1, 2], [0, 3, 4]),
                _ => ([0, 1, 2], [0, 1, 3]),
            };
            let is_flat = |t: [u32; 3]| Plane::of(t.map(|v| corners[v as usize])).is_none();
            prop_assume!(!is_flat(a) && !is_flat(b));
            let at = |t: [u32; 3]| t.map(|v| p[v as usize]);
            let common: Vec<_> = p[..shared].to_vec();
            if have_common_grid_point(at(a), at(b), &common) {
                prop_assert!(cross(&corners, a, b));
            }
            prop_assert_eq!(cross(&corners, a, b), cross(&corners, b, a));
        }
    }
}
