//! Checkers for what proves a least maximum degree, from the points and rings alone; they share nothing
//! with the solver but the predicate [`robust::orient2d`]. [`mindeg_mesh::check`] checks the
//! triangulation that reaches the degree.
//!
//! A chord is admissible if it lies inside, passes no vertex on its way, and no straight side has both
//! of its ends. The checkers test that against every boundary edge. Whether a chord [passes](is_passed) a
//! vertex has the tolerance by which the points of a side are on a line.
//!
//! Limits: an exhaustive search leaves nothing to check but its repetition
//! ([`CheckedOutline::has_triangulation`]), which is for hundreds of vertices.

pub mod refutation;
mod search;

use crate::apex::ApexBound;
use glam::DVec2;
use robust::{Coord, orient2d};
use std::ops::Range;

/// Rings of points, and the straight side of the boundary edge that begins at each vertex.
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_exact::check::CheckedOutline;
///
/// // An L of six corners.
/// let points = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)];
/// let points = points.map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)));
/// let side_of = [0, 1, 2, 3, 4, 5];
/// let outline = CheckedOutline { points: &points, rings: &[0..6], side_of: &side_of, keeps_clear: true };
/// assert!(outline.is_admissible([3, 0]));
/// assert!(!outline.is_admissible([2, 4]));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct CheckedOutline<'a> {
    /// The points, by vertex.
    pub points: &'a [DVec2],
    /// The vertices of each ring in its order, with the domain on the left.
    pub rings: &'a [Range<u32>],
    /// The straight side of the boundary edge that begins at each vertex.
    pub side_of: &'a [u32],
    /// Chords keep the tolerance: those of a domain that is as thin as it pass only what they touch
    /// ([`Problem::keeps_clear`](crate::Problem::keeps_clear)).
    pub keeps_clear: bool,
}

/// Whether a chord passes a vertex: a boundary from one of its ends by the vertex to the other one turns there
/// by less than a billionth of a radian, or by less than the rounding of the coordinates, half a unit in the
/// last place of the largest one for either end of an edge, and by less than a thousandth.
#[must_use]
pub fn is_passed(vertex: DVec2, [from, to]: [DVec2; 2]) -> bool {
    let (to_from, to_to) = (from - vertex, to - vertex);
    // Most vertices are elsewhere.
    if to_from.perp_dot(to_to).abs() > -0.01 * to_from.dot(to_to) {
        return false;
    }
    let straight = std::f64::consts::PI;
    let angle = libm::atan2(to_from.perp_dot(to_to), to_from.dot(to_to)).abs();
    let largest = [from, to, vertex].map(|point| point.abs().max_element());
    let largest = largest.into_iter().fold(0.0, f64::max);
    let of_edge = |edge: DVec2| f64::EPSILON * largest / edge.length();
    let rounding = of_edge(to_from) + of_edge(to_to);
    straight - angle < rounding.clamp(1e-9, 1e-3)
}

impl CheckedOutline<'_> {
    /// Whether these chords prove that a polygon of one ring has no triangulation of maximum degree 4:
    /// none of them is admissible, and every one of the n zig-zags has one of them. O(n * chords).
    ///
    /// The zig-zags of n vertices are the sets of all chords whose ends add up to s or s + 1, modulo n,
    /// for s from 0 to n - 1. From n = 7 on, a triangulation of degree 4 is one of them.
    #[must_use]
    pub fn blocks_all_zigzags(&self, blocked: &[[u32; 2]]) -> bool {
        let n = self.points.len() as u32;
        if self.rings.len() != 1 || n < 7 {
            return false;
        }
        let mut is_blocked = vec![false; n as usize];
        for &[a, b] in blocked {
            let is_chord = a < n && b < n && a != b && self.next(a) != b && self.next(b) != a;
            if !is_chord || self.is_admissible([a, b]) {
                return false;
            }
            let sum = ((u64::from(a) + u64::from(b)) % u64::from(n)) as u32;
            is_blocked[sum as usize] = true;
            is_blocked[((sum + n - 1) % n) as usize] = true;
        }
        is_blocked.into_iter().all(|is_blocked| is_blocked)
    }

    /// Whether a bound by apexes holds: no edge is the side of an ear, and no vertex but its apexes sees
    /// both ends of one of them. O(n² * edges).
    #[must_use]
    pub fn bounds_apexes(&self, bound: &ApexBound) -> bool {
        let n = self.points.len() as u32;
        let joins = |a: u32, b: u32| {
            a != b && (self.next(a) == b || self.next(b) == a || self.is_admissible([a, b]))
        };
        let is_distinct = |vertices: &[u32]| {
            let mut sorted = vertices.to_vec();
            sorted.sort_unstable();
            sorted.dedup();
            sorted.len() == vertices.len() && sorted.iter().all(|&vertex| vertex < n)
        };
        is_distinct(&bound.edges)
            && is_distinct(&bound.apexes)
            && bound.edges.iter().all(|&from| {
                let to = self.next(from);
                let others = (0..n).filter(|vertex| !bound.apexes.contains(vertex));
                !joins(self.previous(from), to)
                    && !joins(from, self.next(to))
                    && others
                        .filter(|&v| v != from && v != to)
                        .all(|v| !joins(v, from) || !joins(v, to))
            })
    }

    /// Whether no strip between the two rings of a domain with one hole is a triangulation of maximum degree 4:
    /// the rings differ in their number of vertices, or each strip has a triangle that is not
    /// counter-clockwise or a chord that is not admissible (Theorem 21 of docs/theory.md). O(n²).
    ///
    /// # Example
    ///
    /// ```
    /// # use glam::DVec2;
    /// # use mindeg_exact::check::CheckedOutline;
    /// // A square in a square: the strip without a shift has degree 4. Then a hole with a notch, which no strip fits.
    /// let ring = |half: f64| [(-half, -half), (-half, half), (half, half), (half, -half)];
    /// let outer = ring(3.0).map(|(x, y)| DVec2::new(y, x));
    /// let blocks = |inner: [(f64, f64); 4]| {
    ///     let points: Vec<DVec2> = outer.into_iter().chain(inner.map(DVec2::from)).collect();
    ///     let side_of = [0, 1, 2, 3, 4, 5, 6, 7];
    ///     CheckedOutline { points: &points, rings: &[0..4, 4..8], side_of: &side_of, keeps_clear: true }
    ///         .blocks_all_strips()
    /// };
    /// assert!(!blocks(ring(1.0)));
    /// assert!(blocks([(-1.0, 0.0), (1.0, 2.0), (1.0, 0.0), (0.9, 0.2)]));
    /// ```
    #[must_use]
    pub fn blocks_all_strips(&self) -> bool {
        let [outer, inner] = self.rings else { return false };
        let count = outer.end - outer.start;
        // The hole is clockwise.
        let x = |step: u32| outer.start + step % count;
        let y = |step: u32| inner.end - 1 - step % count;
        let is_strip = |shift: u32| {
            let is_counter_clockwise = |step: u32| {
                let (from, to) = (y(step + shift), y(step + shift + 1));
                self.turn(x(step), x(step + 1), from) > 0.0
                    && self.turn(x(step + 1), to, from) > 0.0
            };
            let is_joined = |step: u32| {
                let end = y(step + shift);
                self.is_admissible([x(step), end]) && self.is_admissible([x(step + 1), end])
            };
            (0..count).all(is_counter_clockwise) && (0..count).all(is_joined)
        };
        inner.end - inner.start != count || !(0..count).any(is_strip)
    }

    /// The maximum degree that counting proves to be necessary, where vertices have external edges
    /// besides: Theorems 3 and 15 of docs/theory.md, and two edges more than the external ones of any
    /// vertex. O(n).
    ///
    /// # Example
    ///
    /// ```
    /// # use glam::DVec2;
    /// # use mindeg_exact::check::CheckedOutline;
    /// # let points = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)];
    /// # let points = points.map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)));
    /// let side_of = [0, 1, 2, 3, 4, 5];
    /// let outline = CheckedOutline { points: &points, rings: &[0..6], side_of: &side_of, keeps_clear: true };
    /// assert_eq!(outline.counting_bound(|_| 0), 4);
    /// assert_eq!(outline.counting_bound(|vertex| if vertex == 2 { 7 } else { 0 }), 9);
    /// ```
    #[must_use]
    pub fn counting_bound(&self, external: impl Fn(u32) -> u32) -> u32 {
        let n = self.points.len() as u64;
        let holes = self.rings.len().saturating_sub(1) as u64;
        let triangles = (n + 2 * holes).saturating_sub(2);
        let (mut ends, mut most) = (3 * triangles + n, 0);
        for vertex in 0..n as u32 {
            ends += u64::from(external(vertex));
            most = most.max(external(vertex));
        }
        let small = match (holes, n) {
            (0, 3) => 2,
            (0, 4) => 3,
            (0, _) => 4,
            _ => 2,
        };
        (ends.div_ceil(n.max(1)) as u32).max(most + 2).max(small)
    }

    /// Whether a triangulation may have this chord. O(n).
    #[must_use]
    pub fn is_admissible(&self, chord: [u32; 2]) -> bool {
        self.may_join(chord) && !self.edges().any(|edge| self.is_in_the_way(edge, chord))
    }

    /// Whether no straight side has both ends of a chord, and the chord begins inside.
    fn may_join(&self, [a, b]: [u32; 2]) -> bool {
        let sides = |v: u32| [self.side_of[self.previous(v) as usize], self.side_of[v as usize]];
        let is_on_one_side = sides(a).iter().any(|side| sides(b).contains(side));
        !is_on_one_side && self.starts_inside(a, b)
    }

    /// The boundary edges.
    fn edges(&self) -> impl Iterator<Item = [u32; 2]> {
        self.rings.iter().flat_map(|ring| {
            let next = move |v: u32| if v + 1 == ring.end { ring.start } else { v + 1 };
            ring.clone().map(move |v| [v, next(v)])
        })
    }

    /// Whether the segment from a to b begins within the interior angle at a.
    fn starts_inside(&self, a: u32, b: u32) -> bool {
        let (before, after) = (self.previous(a), self.next(a));
        let is_left_of_after = self.turn(a, after, b) > 0.0;
        let is_right_of_before = self.turn(a, b, before) > 0.0;
        if self.turn(before, a, after) > 0.0 {
            is_left_of_after && is_right_of_before
        } else {
            is_left_of_after || is_right_of_before
        }
    }

    /// Whether the open segment from a to b meets a boundary edge, or passes its first end.
    fn is_in_the_way(&self, [c, d]: [u32; 2], [a, b]: [u32; 2]) -> bool {
        let [p, q, r, s] = [a, b, c, d].map(|vertex| self.points[vertex as usize]);
        // Most edges are elsewhere. All that a chord passes is within less than a thousandth of its length.
        let near = 0.01 * (p - q).abs().max_element();
        if (r.max(s) + near).cmplt(p.min(q)).any() || (r.min(s) - near).cmpgt(p.max(q)).any() {
            return false;
        }
        if self.keeps_clear && c != a && c != b && is_passed(r, [p, q]) {
            return true;
        }
        let (at_c, at_d) = (self.turn(a, b, c), self.turn(a, b, d));
        let is_between = |vertex: u32| {
            let point = self.points[vertex as usize];
            vertex != a && vertex != b && (point - p).dot(point - q) < 0.0
        };
        if (at_c == 0.0 && is_between(c)) || (at_d == 0.0 && is_between(d)) {
            return true;
        }
        let are_opposite = |x: f64, y: f64| (x > 0.0 && y < 0.0) || (x < 0.0 && y > 0.0);
        are_opposite(at_c, at_d) && are_opposite(self.turn(c, d, a), self.turn(c, d, b))
    }

    fn turn(&self, a: u32, b: u32, c: u32) -> f64 {
        let [a, b, c] = [a, b, c].map(|vertex| self.points[vertex as usize]);
        let [a, b, c] = [a, b, c].map(|point| Coord { x: point.x, y: point.y });
        orient2d(a, b, c)
    }

    fn ring(&self, vertex: u32) -> Range<u32> {
        let after = self.rings.partition_point(|ring| ring.start <= vertex);
        self.rings[after.saturating_sub(1)].clone()
    }

    fn next(&self, vertex: u32) -> u32 {
        let ring = self.ring(vertex);
        if vertex + 1 == ring.end { ring.start } else { vertex + 1 }
    }

    fn previous(&self, vertex: u32) -> u32 {
        let ring = self.ring(vertex);
        if vertex == ring.start { ring.end - 1 } else { vertex - 1 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{LowerBound, Problem, Progress, ZigZag, degree_range};
    use mindeg_mesh::planar::PlanarBoundary;

    /// The checker's zig-zags are zig-zags.
    #[test]
    fn the_chords_of_a_zigzag_have_two_sums() {
        for n in 7..20 {
            let mut sums = Vec::new();
            for zigzag in ZigZag::all(n) {
                let mut of_chords: Vec<u32> = zigzag.chords().map(|[a, b]| (a + b) % n).collect();
                of_chords.sort_unstable();
                of_chords.dedup();
                let [low, high] = of_chords[..] else { panic!("{zigzag:?}: {of_chords:?}") };
                assert!(low + 1 == high || (low, high) == (0, n - 1), "{zigzag:?}");
                sums.push(if low + 1 == high { low } else { high });
                let of_sum = |sum: u32| {
                    let pairs = (0..n).flat_map(|a| (a + 2..n).map(move |b| [a, b]));
                    pairs.filter(|[a, b]| b - a < n - 1 && (a + b) % n == sum).count()
                };
                assert_eq!(of_sum(low) + of_sum(high), n as usize - 3);
            }
            sums.sort_unstable();
            assert!(sums.into_iter().eq(0..n));
        }
    }

    #[test]
    fn wrong_proofs_are_refused() {
        // A star of six points, and its ring of tips and notches.
        let at = |corner: u32| {
            let radius = if corner.is_multiple_of(2) { 3.0 } else { 1.0 };
            let angle = f64::from(corner) * std::f64::consts::PI / 6.0;
            DVec2::new(libm::cos(angle), libm::sin(angle)) * radius
        };
        let points: Vec<DVec2> = (0..12).map(at).collect();
        let side_of: Vec<u32> = (0..12).collect();
        let rings = std::slice::from_ref(&(0..12));
        let star = CheckedOutline { points: &points, rings, side_of: &side_of, keeps_clear: true };
        let tips = (0..6).map(|tip| [(2 * tip + 11) % 12, 2 * tip, 2 * tip + 1]);
        let within = [[1, 3, 5], [1, 5, 7], [1, 7, 9], [1, 9, 11]];
        let triangles: Vec<_> = tips.chain(within).collect();
        let boundary = PlanarBoundary::new(&[&points]).unwrap();
        let problem = Problem::triangulated(&boundary, &triangles).unwrap();
        let range = degree_range(&problem, Progress::NONE).unwrap();
        let LowerBound::BlockedZigZags(blocked) = range.bounded_by else { panic!("not 4") };
        assert!(star.blocks_all_zigzags(&blocked));
        let mut needed: Vec<[u32; 2]> = blocked.clone();
        needed.sort_unstable();
        needed.dedup();
        let is_needed = |left_out: &&[u32; 2]| {
            let rest: Vec<_> = needed.iter().filter(|chord| chord != left_out).copied().collect();
            !star.blocks_all_zigzags(&rest)
        };
        assert!(needed.iter().filter(is_needed).count() > 0);
        // Two notches see each other; neighbours have no chord.
        for other in [[1, 3], [1, 2], [4, 4], [0, 12]] {
            assert!(!star.blocks_all_zigzags(&[&blocked[..], &[other]].concat()), "{other:?}");
        }

        // Every edge is the side of an ear.
        let bound = ApexBound { edges: vec![0], apexes: (0..12).collect() };
        assert!(!star.bounds_apexes(&bound));
    }
}
