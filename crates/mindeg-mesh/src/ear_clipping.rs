//! Cuts a polygon in space into triangles, by ears.
//!
//! An ear is a corner whose triangle with its two neighbors lies inside the polygon, with no other
//! corner in it. Ear clipping (Meisters 1975) cuts off one ear after another; every polygon that
//! does not touch itself has an ear.

use glam::{DVec2, DVec3};

use crate::planar::orientation;

/// Cuts a polygon into triangles, and adds them to `triangles`: always k - 2 for k corners, each in
/// the direction of the polygon; nothing for fewer than three corners.
///
/// The polygon is seen along the axis nearest to its Newell normal. If all triangles of the fan
/// from its first corner are counter-clockwise there, as for every convex polygon without straight
/// corners, the result is that fan. All other polygons are cut by ears: then no triangle is flat or
/// inverted, as long as the polygon does not cross itself. It may touch itself, like a polygon with
/// a bridge to its hole. A polygon that crosses itself gets some k - 2 triangles, a polygon without
/// area gets the fan.
///
/// O(k) for a fan. Else O(k² r) at worst for k corners, r of which do not turn to the left, and
/// about O(k log k) if ears are small.
///
/// Decisions are exact (`robust`) for coordinates, other than zeros, down to 1e-140 of the largest.
///
/// # Panics
///
/// If a corner is not an index of `positions`.
///
/// # Example
///
/// ```
/// use glam::DVec3;
/// use mindeg_mesh::ear_clipping::cut_polygon;
///
/// // A dart: the fan from its first corner, 1, would leave it.
/// let positions = [[0.0, 3.0], [-2.0, 0.0], [0.0, 1.0], [2.0, 0.0]];
/// let positions = positions.map(|[x, y]| DVec3::new(x, y, 5.0));
/// let mut triangles = Vec::new();
/// cut_polygon(&[1, 2, 3, 0], &positions, &mut triangles);
/// assert_eq!(triangles, [[0, 1, 2], [0, 2, 3]]);
/// ```
pub fn cut_polygon(corners: &[u32], positions: &[DVec3], triangles: &mut Vec<[u32; 3]>) {
    let fan =
        |corners: &[u32]| (1..corners.len().saturating_sub(1)).map(|i| [0, i, i + 1]).collect();
    let cut: Vec<[usize; 3]> = match corners.len() {
        0..=3 => fan(corners),
        _ => match in_plane(corners, positions) {
            Some(points) if !is_fan(&points) => Ears::new(&points).clip(),
            _ => fan(corners),
        },
    };
    triangles.extend(cut.into_iter().map(|triangle| triangle.map(|corner| corners[corner])));
}

/// The corners in the coordinate plane in which the polygon covers the largest area, turned so that
/// it runs counter-clockwise; `None` if it has no area.
fn in_plane(corners: &[u32], positions: &[DVec3]) -> Option<Vec<DVec2>> {
    let points = || corners.iter().map(|&corner| positions[corner as usize]);
    let largest = points().map(|p| p.abs().max_element()).fold(0.0, f64::max);
    // A power of two, so that no product overflows and no digit changes.
    let exponent = libm::frexp(largest).1;
    let points: Vec<DVec3> =
        points().map(|p| p.to_array().map(|x| libm::ldexp(x, -exponent)).into()).collect();
    let next = points.iter().cycle().skip(1);
    let normal: DVec3 =
        points.iter().zip(next).map(|(&a, &b)| (a - points[0]).cross(b - points[0])).sum();
    let size = normal.abs();
    let (axes, along) = if size.z >= size.x && size.z >= size.y {
        ([0, 1], normal.z)
    } else if size.x >= size.y {
        ([1, 2], normal.x)
    } else {
        ([2, 0], normal.y)
    };
    let [x, y] = if along < 0.0 { [axes[1], axes[0]] } else { axes };
    // Also refuses NaN.
    (along.abs() > 0.0).then(|| points.iter().map(|p| DVec2::new(p[x], p[y])).collect())
}

/// Whether all triangles of the fan from the first point are counter-clockwise.
fn is_fan(points: &[DVec2]) -> bool {
    points[1..].windows(2).all(|edge| orientation(points[0], edge[0], edge[1]) > 0.0)
}

/// A polygon while its ears are cut off.
struct Ears<'a> {
    points: &'a [DVec2],
    /// The remaining corner before and after each.
    before: Vec<usize>,
    after: Vec<usize>,
    is_cut: Vec<bool>,
    /// The corners that did not turn to the left at first, in ascending order of x. Only they can
    /// be in the way of an ear.
    obstacles: Vec<usize>,
    triangles: Vec<[usize; 3]>,
}

impl<'a> Ears<'a> {
    fn new(points: &'a [DVec2]) -> Self {
        let count = points.len();
        let mut ears = Self {
            points,
            before: (0..count).map(|i| (i + count - 1) % count).collect(),
            after: (0..count).map(|i| (i + 1) % count).collect(),
            is_cut: vec![false; count],
            obstacles: Vec::new(),
            triangles: Vec::with_capacity(count - 2),
        };
        let mut obstacles: Vec<usize> = (0..count).filter(|&i| ears.turn(i) <= 0.0).collect();
        obstacles.sort_by(|&i, &j| points[i].x.total_cmp(&points[j].x));
        ears.obstacles = obstacles;
        ears
    }

    fn clip(mut self) -> Vec<[usize; 3]> {
        let count = self.points.len();
        let mut waiting: Vec<usize> = (0..count).rev().collect();
        let mut cut_in_round = 0;
        while self.triangles.len() < count - 3 {
            let Some(corner) = waiting.pop() else {
                // The corner that blocked an ear may be cut by now.
                waiting.extend((0..count).rev().filter(|&i| !self.is_cut[i]));
                if cut_in_round == 0 {
                    self.cut_without_ear(&waiting);
                }
                cut_in_round = 0;
                continue;
            };
            if !self.is_cut[corner] && self.is_ear(corner) {
                self.cut(corner);
                cut_in_round += 1;
                // The corner after it first: ears in a row form a fan.
                waiting.extend([self.before[corner], self.after[corner]]);
            }
        }
        if let Some(last) = (0..count).find(|&i| !self.is_cut[i]) {
            self.cut(last);
        }
        self.triangles
    }

    /// Cuts a corner off a polygon that touches or crosses itself and so has no ear: a straight
    /// corner if possible, else the first that turns to the left, else the first.
    fn cut_without_ear(&mut self, corners: &[usize]) {
        let first = |turns: fn(f64) -> bool| {
            corners.iter().rev().copied().find(|&corner| turns(self.turn(corner)))
        };
        let corner = first(|turn| turn == 0.0).or_else(|| first(|turn| turn > 0.0));
        if let Some(corner) = corner.or(corners.last().copied()) {
            self.cut(corner);
        }
    }

    fn corners_at(&self, i: usize) -> [usize; 3] {
        [self.before[i], i, self.after[i]]
    }

    fn turn(&self, i: usize) -> f64 {
        let [a, b, c] = self.corners_at(i).map(|i| self.points[i]);
        orientation(a, b, c)
    }

    /// Whether a corner turns to the left, with no other corner in its triangle or on its edges. A
    /// corner at the same position as a corner of the triangle does not count.
    fn is_ear(&self, i: usize) -> bool {
        let corners = self.corners_at(i);
        let [a, b, c] = corners.map(|i| self.points[i]);
        if orientation(a, b, c) <= 0.0 {
            return false;
        }
        let [min, max] = [a.min(b).min(c), a.max(b).max(c)];
        let start = self.obstacles.partition_point(|&other| self.points[other].x < min.x);
        let mut near = self.obstacles[start..]
            .iter()
            .copied()
            .take_while(|&other| self.points[other].x <= max.x)
            .filter(|&other| (min.y..=max.y).contains(&self.points[other].y));
        !near.any(|other| {
            let p = self.points[other];
            !self.is_cut[other]
                && ![a, b, c].contains(&p)
                && self.turn(other) <= 0.0
                && [(a, b), (b, c), (c, a)].iter().all(|&(a, b)| orientation(a, b, p) >= 0.0)
        })
    }

    fn cut(&mut self, i: usize) {
        let [before, _, after] = self.corners_at(i);
        self.triangles.push(self.corners_at(i));
        self.is_cut[i] = true;
        self.after[before] = after;
        self.before[after] = before;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quality::TriangleQuality;
    use proptest::prelude::*;
    use std::f64::consts::TAU;

    fn cut(points: &[DVec3]) -> Vec<[u32; 3]> {
        let corners: Vec<u32> = (0..points.len() as u32).collect();
        let mut triangles = Vec::new();
        cut_polygon(&corners, points, &mut triangles);
        triangles
    }

    fn area(points: &[DVec3], triangles: &[[u32; 3]]) -> f64 {
        let corners = triangles.iter().map(|t| t.map(|i| points[i as usize]));
        corners.map(|[a, b, c]| TriangleQuality::in_space(a, b, c).area).sum()
    }

    fn in_xy(points: &[[f64; 2]]) -> Vec<DVec3> {
        points.iter().map(|&[x, y]| DVec3::new(x, y, 0.0)).collect()
    }

    /// All rotations of the axes, so that each plane and direction occurs.
    fn turned(points: &[DVec3]) -> impl Iterator<Item = Vec<DVec3>> {
        let turns: [fn(DVec3) -> DVec3; 6] = [
            |p| p,
            |p| DVec3::new(p.z, p.x, p.y),
            |p| DVec3::new(p.y, p.z, p.x),
            |p| DVec3::new(p.y, p.x, p.z),
            |p| DVec3::new(p.x, p.z, p.y),
            |p| DVec3::new(0.6 * p.x, p.y, -0.8 * p.x),
        ];
        turns.into_iter().map(|turn| points.iter().map(|&p| turn(p)).collect())
    }

    #[test]
    fn concave_polygons_keep_their_area() {
        let hole = [
            [0.0, 0.0],
            [4.0, 0.0],
            [4.0, 4.0],
            [0.0, 4.0],
            [0.0, 0.0],
            [1.0, 1.0],
            [1.0, 2.0],
            [2.0, 2.0],
            [2.0, 1.0],
            [1.0, 1.0],
        ];
        for (name, polygon, expected) in [
            (
                "an L",
                &[[3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0], [0.0, 0.0]][..],
                5.0,
            ),
            (
                "a comb",
                &[
                    [0.0, 0.0],
                    [5.0, 0.0],
                    [5.0, 2.0],
                    [4.0, 2.0],
                    [4.0, 1.0],
                    [3.0, 1.0],
                    [3.0, 2.0],
                    [2.0, 2.0],
                    [2.0, 1.0],
                    [1.0, 1.0],
                    [1.0, 2.0],
                    [0.0, 2.0],
                ],
                8.0,
            ),
            ("a square with a hole", &hole, 15.0),
            (
                "a square with points on its sides",
                &[
                    [1.0, 0.0],
                    [2.0, 0.0],
                    [2.0, 1.0],
                    [2.0, 2.0],
                    [1.0, 2.0],
                    [0.0, 2.0],
                    [0.0, 1.0],
                    [0.0, 0.0],
                ],
                4.0,
            ),
            (
                "a triangle with points on one side",
                &[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0], [0.0, 3.0]],
                4.5,
            ),
        ] {
            for points in turned(&in_xy(polygon)) {
                let triangles = cut(&points);
                assert_eq!(triangles.len(), polygon.len() - 2, "{name}");
                assert!((area(&points, &triangles) / expected - 1.0).abs() < 1e-14, "{name}");
                let flat = |t: &&[u32; 3]| {
                    let [a, b, c] = t.map(|i| points[i as usize]);
                    (b - a).cross(c - a) == DVec3::ZERO
                };
                assert_eq!(triangles.iter().find(flat), None, "{name}");
            }
        }
    }

    #[test]
    fn convex_polygons_are_fans_from_the_first_corner() {
        let circle: Vec<DVec3> = (0..12)
            .map(|i| TAU * f64::from(i) / 12.0)
            .map(|angle| DVec3::new(libm::cos(angle), 1.0, -libm::sin(angle)))
            .collect();
        let fan: Vec<_> = (1..11).map(|i| [0, i, i + 1]).collect();
        assert_eq!(cut(&circle), fan);
        // A quad that is not in a plane is convex as seen from above.
        let mut quad = in_xy(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
        quad[3].z = 0.4;
        assert_eq!(cut(&quad), [[0, 1, 2], [0, 2, 3]]);
    }

    #[test]
    fn the_unit_of_length_does_not_matter() {
        let l = [[3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0], [0.0, 0.0]];
        for points in turned(&in_xy(&l)) {
            let expected = cut(&points);
            for unit in [2.0_f64.powi(-900), 2.0_f64.powi(900)] {
                let points: Vec<DVec3> = points.iter().map(|&point| point * unit).collect();
                assert_eq!(cut(&points), expected, "{points:?}");
            }
        }
    }

    #[test]
    fn what_is_no_polygon_still_has_its_triangles() {
        let [o, x, y, far] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1e308, -1e308]];
        for points in [
            &[][..],
            &[o],
            &[o, x],
            &[o, x, y],
            &[o; 7],
            &[o, x, [2.0, 0.0], [3.0, 0.0], [1.5, 0.0]],
            &[o, [1.0, 1.0], x, y],
            &[o, x, o, y, o, x, o, y],
            &[o, [2.0, 1.0], [1.0, -1.0], [0.0, 1.0], [2.0, -1.0]],
            &[far, o, [-1e308, 1e308], [1e-308, 1.0], x],
        ] {
            assert_eq!(cut(&in_xy(points)).len(), points.len().saturating_sub(2), "{points:?}");
        }
    }

    proptest! {
        /// Star-shaped polygons with whole coordinates: areas are exact.
        #[test]
        fn triangles_fill_the_polygon(
            radii in prop_oneof![
                prop::collection::vec(1..1000_i32, 3..60),
                prop::collection::vec(1..6_i32, 3..16),
            ],
            shift in any::<prop::sample::Index>(),
        ) {
            let count = radii.len();
            let point = |i: usize| {
                let (angle, radius) = (TAU * i as f64 / count as f64, f64::from(radii[i]));
                DVec2::new((radius * libm::cos(angle)).round(), (radius * libm::sin(angle)).round())
            };
            let mut points: Vec<DVec2> = (0..count).map(point).collect();
            points.dedup();
            let shift = shift.index(points.len());
            points.rotate_left(shift);
            let double = |a: DVec2, b: DVec2| a.perp_dot(b);
            let around: f64 = (0..points.len())
                .map(|i| double(points[i], points[(i + 1) % points.len()]))
                .sum();
            // Rounding may invert a very flat triangle.
            let mut edges = (0..points.len()).map(|i| [points[i], points[(i + 1) % points.len()]]);
            prop_assume!(points.len() > 2 && edges.all(|[a, b]| double(a, b) > 0.0));
            let in_space: Vec<DVec3> = points.iter().map(|p| p.extend(0.0)).collect();
            let triangles = cut(&in_space);
            prop_assert_eq!(triangles.len(), points.len() - 2);
            let mut sum = 0.0;
            for [a, b, c] in triangles.iter().map(|t| t.map(|i| points[i as usize])) {
                let area = (b - a).perp_dot(c - a);
                prop_assert!(area > 0.0, "{a} {b} {c}");
                sum += area;
            }
            prop_assert_eq!(sum, around);
        }

        #[test]
        fn any_points_are_cut(
            points in prop::collection::vec(prop::array::uniform3(prop::num::f64::ANY), 0..20),
            small in prop::collection::vec(prop::array::uniform2(-3..3_i8), 0..20),
        ) {
            let points: Vec<DVec3> = points.into_iter().map(DVec3::from).collect();
            prop_assert_eq!(cut(&points).len(), points.len().saturating_sub(2));
            let small: Vec<[f64; 2]> = small.into_iter().map(|p| p.map(f64::from)).collect();
            prop_assert_eq!(cut(&in_xy(&small)).len(), small.len().saturating_sub(2));
        }
    }
}
