//! How far triangles, or segments, are from others at most: a bound that is proven, not sampled.
//!
//! The distance from a point to a triangle is convex: on a convex piece it is greatest at a corner of the piece. So a
//! piece whose corners are within d of one triangle lies within d of it. Pieces start as whole triangles. Where the
//! bound is not good enough, a piece is cut along the borders of the region over the triangle nearest to its middle;
//! where such a cut changes nothing, through its middle.
//!
//! The bound holds for the given coordinates, up to rounding: [`DistanceBound::upper`] has a margin for it.

use glam::DVec3;

use crate::box_tree::BoxTree;
use crate::parallel::{map_chunks, sort_all};
use crate::quality::area_in_space;
use crate::{Bounds, Cancelled, Progress};

/// How far the points of one set are from another set at most, in units of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DistanceBound {
    /// The distance of one point: the greatest distance is at least this.
    pub lower: f64,
    /// No point is farther than this. Infinity if the other set is empty.
    pub upper: f64,
    /// The point whose distance is `lower`.
    pub place: DVec3,
}

/// Upper and lower bound may differ by this share.
const GAP: f64 = 0.02;
/// Below this share of the extent, distances count as none.
const NOTHING: f64 = 1e-9;
/// The most that rounding changes, as a share of the greatest coordinate.
const ROUNDING: f64 = 1e-14;
/// Pieces that a triangle may be cut into, apart from its share of the other set's triangles.
const PIECES: usize = 1 << 10;
/// Pieces for each triangle of the other set that a triangle may lie over.
const PIECES_OVER_ONE: f64 = 100.0;

/// A bound of the greatest distance from a point of `from` to the set `to`.
///
/// Both sets are triangles, given by their corners; a segment has its second end twice, a point three times. Bounds
/// differ by 2 %, unless the work grows out of proportion. About O((m + n) log n) for surfaces of m and n triangles
/// that lie near each other; shared by all threads.
///
/// # Errors
///
/// [`Cancelled`], if the callback breaks.
///
/// # Example
///
/// ```
/// use glam::DVec3;
/// use mindeg_mesh::Progress;
/// use mindeg_mesh::distance::distance_bound;
///
/// let corner = |x: f64, y: f64, z: f64| DVec3::new(x, y, z);
/// let floor = [[corner(0.0, 0.0, 0.0), corner(4.0, 0.0, 0.0), corner(0.0, 4.0, 0.0)]];
/// let tilted = [[corner(0.0, 0.0, 0.0), corner(1.0, 0.0, 0.0), corner(0.0, 1.0, 0.5)]];
/// let bound = distance_bound(&tilted, &floor, Progress::NONE)?;
/// assert!(bound.lower == 0.5 && bound.upper < 0.51);
/// // The other way the farthest point is a corner of the floor.
/// assert!(distance_bound(&floor, &tilted, Progress::NONE)?.lower > 3.0);
/// # Ok::<(), mindeg_mesh::Cancelled>(())
/// ```
pub fn distance_bound(
    from: &[[DVec3; 3]],
    to: &[[DVec3; 3]],
    progress: Progress<'_>,
) -> Result<DistanceBound, Cancelled> {
    let Some(bounds) = Bounds::of_space(from.iter().chain(to).flatten().copied()) else {
        return Ok(DistanceBound { lower: 0.0, upper: 0.0, place: DVec3::ZERO });
    };
    if from.is_empty() || to.is_empty() {
        let upper = if from.is_empty() { 0.0 } else { f64::INFINITY };
        return Ok(DistanceBound { lower: upper, upper, place: bounds.center() });
    }
    let target = Target::new(to);
    let first = farthest_sample(from, &target, progress)?;
    let areas: f64 = from.iter().map(|corners| area_in_space(*corners)).sum();
    let search = Search {
        target: &target,
        enough: NOTHING * bounds.size().length(),
        fine: 1e-3 * NOTHING * bounds.size().length(),
        pieces_to_area: PIECES_OVER_ONE * to.len() as f64 / areas.max(f64::MIN_POSITIVE),
    };
    let counter = progress.counter("bounding distances", from.len() as u64);
    let found = map_chunks(0..from.len(), CHUNK, |chunk| {
        let mut bound = first;
        let count = chunk.len();
        let mut work = Vec::new();
        for triangle in &from[chunk] {
            let of_one = search.bound(triangle, first, &mut work);
            bound =
                DistanceBound { upper: bound.upper.max(of_one.upper), ..farther(bound, of_one) };
        }
        counter.add(count).map(|()| bound)
    });
    let mut all = first;
    for bound in found {
        let bound = bound?;
        all = DistanceBound { upper: all.upper.max(bound.upper), ..farther(all, bound) };
    }
    let largest = bounds.min.abs().max(bounds.max.abs()).max_element();
    Ok(DistanceBound { upper: all.upper + ROUNDING * largest, ..all })
}

/// Triangles that one thread takes at a time.
const CHUNK: usize = 64;

/// The bound whose lower bound is greater, the first if they are equal.
fn farther(a: DistanceBound, b: DistanceBound) -> DistanceBound {
    if b.lower > a.lower { b } else { a }
}

/// The set that distances lead to.
struct Target<'a> {
    triangles: &'a [[DVec3; 3]],
    tree: BoxTree,
}

impl<'a> Target<'a> {
    fn new(triangles: &'a [[DVec3; 3]]) -> Self {
        let around =
            |&[a, b, c]: &[DVec3; 3]| Bounds { min: a.min(b).min(c), max: a.max(b).max(c) };
        Self { triangles, tree: BoxTree::new(triangles.iter().map(around).collect()) }
    }

    /// The nearest triangle to a point, and the distance. `hint` is a triangle that may be near.
    fn nearest(&self, point: DVec3, hint: u32) -> (u32, f64) {
        let squared = |t: u32| {
            let distance = distance_to(point, &self.triangles[t as usize]);
            distance * distance
        };
        let found = self.tree.nearest(point, squared(hint), squared);
        let triangle = found.map_or(hint, |(triangle, _)| triangle);
        (triangle, distance_to(point, &self.triangles[triangle as usize]))
    }
}

/// The farthest corner or middle of a triangle.
fn farthest_sample(
    from: &[[DVec3; 3]],
    target: &Target<'_>,
    progress: Progress<'_>,
) -> Result<DistanceBound, Cancelled> {
    // Each point once, and in an order in which neighbours are near: the last nearest triangle is a good guess.
    let mut corners: Vec<[u64; 3]> =
        from.iter().flatten().map(|p| p.to_array().map(order)).collect();
    sort_all(&mut corners);
    corners.dedup();
    let middles = from.iter().map(|[a, b, c]| (a + b + c) / 3.0);
    let mut points: Vec<DVec3> = corners.into_iter().map(|p| DVec3::from(p.map(value))).collect();
    points.extend(middles);
    let counter = progress.counter("measuring distances", points.len() as u64);
    let found = map_chunks(0..points.len(), 16 * CHUNK, |chunk| {
        let mut hint = 0;
        let mut bound = DistanceBound { lower: 0.0, upper: 0.0, place: points[chunk.start] };
        let count = chunk.len();
        for &place in &points[chunk] {
            let (triangle, lower) = target.nearest(place, hint);
            hint = triangle;
            bound = farther(bound, DistanceBound { lower, upper: lower, place });
        }
        counter.add(count).map(|()| bound)
    });
    let mut farthest = DistanceBound { lower: 0.0, upper: 0.0, place: points[0] };
    for bound in found {
        farthest = farther(farthest, bound?);
    }
    Ok(farthest)
}

/// Integers in the order of numbers.
fn order(value: f64) -> u64 {
    let bits = value.to_bits();
    if bits >> 63 == 1 { !bits } else { bits | 1 << 63 }
}

fn value(order: u64) -> f64 {
    f64::from_bits(if order >> 63 == 1 { order & !(1 << 63) } else { !order })
}

struct Search<'a> {
    target: &'a Target<'a>,
    /// Smaller distances need no better bound.
    enough: f64,
    /// A corner this near to a plane counts as in it: rounding must not cut slivers off for ever.
    fine: f64,
    pieces_to_area: f64,
}

/// A convex piece of a triangle, by its corners in order; a segment has two.
type Piece = Vec<DVec3>;

impl Search<'_> {
    /// The bound of one triangle; pieces below the lower bound of `known` are not looked at closer.
    fn bound(
        &self,
        triangle: &[DVec3; 3],
        known: DistanceBound,
        work: &mut Vec<(Piece, u32)>,
    ) -> DistanceBound {
        let mut best = DistanceBound { upper: 0.0, ..known };
        let mut left = PIECES + (self.pieces_to_area * area_in_space(*triangle)) as usize;
        work.clear();
        work.push((without_repeats(triangle.to_vec()), 0));
        while let Some((mut piece, hint)) = work.pop() {
            let middle = middle(&piece);
            let (over, distance) = self.target.nearest(middle, hint);
            if distance > best.lower {
                best = DistanceBound { lower: distance, place: middle, ..best };
            }
            let region = &self.target.triangles[over as usize];
            let radius = piece.iter().map(|p| p.distance(middle)).fold(0.0, f64::max);
            let upper = self.at_corners(&piece, region, over, &mut best).min(distance + radius);
            if left == 0 || self.is_enough(upper, best.lower) {
                best.upper = best.upper.max(upper);
                continue;
            }
            left -= 1;
            let count = work.len();
            for (point, normal) in borders(region) {
                let [inside, outside] = cut(&piece, point, normal, self.fine);
                if inside.is_empty() || outside.is_empty() {
                    continue;
                }
                work.push((outside, over));
                piece = inside;
            }
            if work.len() == count {
                // No border of the region cuts the piece.
                let (point, normal) = across(&piece);
                let halves = cut(&piece, point, normal, 0.0);
                if halves.iter().any(Vec::is_empty) {
                    best.upper = best.upper.max(upper);
                    continue;
                }
                work.extend(halves.map(|half| (half, over)));
            } else {
                work.push((piece, over));
            }
        }
        best
    }

    fn is_enough(&self, upper: f64, lower: f64) -> bool {
        upper <= self.enough.max(lower * (1.0 + GAP))
    }

    /// The greatest distance from a corner of a piece to one triangle. Where it is too great, the distance of that
    /// corner to the whole set may raise the lower bound.
    fn at_corners(
        &self,
        piece: &[DVec3],
        region: &[DVec3; 3],
        over: u32,
        best: &mut DistanceBound,
    ) -> f64 {
        let distances = piece.iter().map(|&place| (distance_to(place, region), place));
        let Some((upper, place)) = distances.reduce(|a, b| if b.0 > a.0 { b } else { a }) else {
            return 0.0;
        };
        if !self.is_enough(upper, best.lower) {
            let (_, lower) = self.target.nearest(place, over);
            if lower > best.lower {
                *best = DistanceBound { lower, place, ..*best };
            }
        }
        upper
    }
}

fn middle(piece: &[DVec3]) -> DVec3 {
    piece.iter().sum::<DVec3>() / piece.len() as f64
}

fn without_repeats(mut piece: Piece) -> Piece {
    piece.dedup();
    while piece.len() > 1 && piece.first() == piece.last() {
        piece.pop();
    }
    piece
}

/// Planes around the region over a triangle or segment, as a point and a normal that points out.
fn borders(&[a, b, c]: &[DVec3; 3]) -> impl Iterator<Item = (DVec3, DVec3)> {
    let normal = (b - a).cross(c - a);
    let is_flat = normal == DVec3::ZERO;
    let edges = [(a, b), (b, c), (c, a)];
    edges.into_iter().map(move |(from, to)| match is_flat {
        false => (from, (to - from).cross(normal)),
        // A segment: planes across its ends.
        true => (to, to - from),
    })
}

/// A plane through the middle of a piece, across its longest extent.
fn across(piece: &[DVec3]) -> (DVec3, DVec3) {
    let pairs =
        piece.iter().enumerate().flat_map(|(i, p)| piece[i + 1..].iter().map(move |q| q - p));
    let longest = pairs.reduce(|a, b| if b.length_squared() > a.length_squared() { b } else { a });
    (middle(piece), longest.unwrap_or(DVec3::ZERO))
}

/// The parts of a piece behind and before a plane; corners no farther than `fine` from it are in it.
fn cut(piece: &[DVec3], point: DVec3, normal: DVec3, fine: f64) -> [Piece; 2] {
    let normal = normal.normalize_or_zero();
    let side = |p: &DVec3| Some((p - point).dot(normal)).filter(|side| side.abs() > fine);
    let sides: Vec<f64> = piece.iter().map(|p| side(p).unwrap_or(0.0)).collect();
    let mut parts = [Vec::new(), Vec::new()];
    if sides.iter().all(|side| *side <= 0.0) {
        parts[0] = piece.to_vec();
        return parts;
    }
    if sides.iter().all(|side| *side >= 0.0) {
        parts[1] = piece.to_vec();
        return parts;
    }
    for i in 0..piece.len() {
        let next = (i + 1) % piece.len();
        let [here, there] = [sides[i], sides[next]];
        if here <= 0.0 {
            parts[0].push(piece[i]);
        }
        if here >= 0.0 {
            parts[1].push(piece[i]);
        }
        if here * there < 0.0 {
            let crossing = piece[i].lerp(piece[next], here / (here - there));
            parts.iter_mut().for_each(|part| part.push(crossing));
        }
    }
    parts.map(without_repeats)
}

/// The distance from a point to a triangle, or to a segment or point given as one.
///
/// It is the distance to a point of the triangle, so rounding in a narrow triangle never makes it too small.
pub fn distance_to(point: DVec3, triangle: &[DVec3; 3]) -> f64 {
    let [a, b, c] = *triangle;
    let to_edge = |from: DVec3, to: DVec3| {
        let edge = to - from;
        let squared = edge.length_squared();
        let along = if squared > 0.0 { (point - from).dot(edge) / squared } else { 0.0 };
        (from + along.clamp(0.0, 1.0) * edge).distance_squared(point)
    };
    let rim = to_edge(a, b).min(to_edge(b, c)).min(to_edge(c, a));
    let normal = (b - a).cross(c - a);
    // Twice the areas over each edge, as seen along the normal.
    let turns =
        [(b, c), (c, a), (a, b)].map(|(from, to)| (from - point).cross(to - point).dot(normal));
    let sum = turns[0] + turns[1] + turns[2];
    if sum > 0.0 && turns.iter().all(|turn| *turn >= 0.0) {
        let foot = (turns[0] * a + turns[1] * b + turns[2] * c) / sum;
        return rim.min(foot.distance_squared(point)).sqrt();
    }
    rim.sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn bound(from: &[[DVec3; 3]], to: &[[DVec3; 3]]) -> DistanceBound {
        distance_bound(from, to, Progress::NONE).unwrap()
    }

    /// A height over the unit square, on a grid.
    fn field(n: u32, height: impl Fn(f64, f64) -> f64) -> Vec<[DVec3; 3]> {
        let at = |i: u32, j: u32| {
            let [x, y] = [i, j].map(|k| f64::from(k) / f64::from(n));
            DVec3::new(x, y, height(x, y))
        };
        let quad = |i: u32, j: u32| {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            [[a, b, c], [a, c, d]]
        };
        (0..n).flat_map(|i| (0..n).flat_map(move |j| quad(i, j))).collect()
    }

    #[test]
    fn one_plane_in_different_triangles_is_no_distance() {
        let slope = |x: f64, y: f64| 0.25 * x - 0.5 * y;
        for (m, n) in [(1, 1), (1, 13), (13, 1), (5, 7)] {
            let found = bound(&field(m, slope), &field(n, slope));
            assert!(found.upper < 1e-9 && found.lower < 1e-12, "{m} {n} {found:?}");
        }
    }

    #[test]
    fn bounds_of_known_distances_are_near() {
        // A plane above a plane; a roof above its floor; a floor below a roof, which is nearer than straight up.
        let roof = |x: f64, _: f64| 0.5 - (x - 0.5).abs();
        let flat = |z: f64| move |_: f64, _: f64| z;
        for (from, to, expected) in [
            (field(3, flat(0.125)), field(4, flat(0.0)), 0.125),
            (field(4, roof), field(7, flat(0.0)), 0.5),
            (field(7, flat(0.0)), field(4, roof), 0.5 * 0.5_f64.sqrt()),
            (field(5, flat(0.0)), field(2, |x, y| 10.0 * x * y), 1.0),
        ] {
            let found = bound(&from, &to);
            assert!(found.lower <= found.upper && found.upper <= 1.03 * found.lower, "{found:?}");
            if expected < 1.0 {
                assert!(found.lower <= expected + 1e-12 && found.upper >= expected - 1e-12);
            }
        }
        let nothing = bound(&field(1, flat(0.0)), &[]);
        assert_eq!((nothing.lower, nothing.upper), (f64::INFINITY, f64::INFINITY));
        assert_eq!(bound(&[], &field(1, flat(0.0))).upper, 0.0);
    }

    #[test]
    fn segments_have_distances_too() {
        let segment = |a: [f64; 3], b: [f64; 3]| [a, b, b].map(DVec3::from);
        let line = [segment([0.0; 3], [1.0, 0.0, 0.0]), segment([1.0, 0.0, 0.0], [3.0, 0.0, 0.0])];
        let parts = [segment([0.0; 3], [2.0, 0.0, 0.0]), segment([2.0, 0.0, 0.0], [3.0, 0.0, 0.0])];
        assert!(bound(&line, &parts).upper < 1e-9);
        let bent = [segment([0.0; 3], [1.5, 0.3, 0.0]), segment([1.5, 0.3, 0.0], [3.0, 0.0, 0.0])];
        let found = bound(&bent, &line);
        assert!((found.lower - 0.3).abs() < 1e-12 && found.upper < 0.31, "{found:?}");
        let found = bound(&line, &bent);
        // The middle is nearest to the slanted lines.
        let expected = 0.3 * 1.5 / 1.5_f64.hypot(0.3);
        assert!(found.lower <= expected + 1e-12 && found.upper >= expected, "{found:?}");
        assert!(found.upper < 1.03 * expected);
    }

    proptest! {
        /// No sample is farther than the upper bound; the lower bound is the distance of its place.
        #[test]
        fn samples_are_within_the_bound(
            from in prop::collection::vec(prop::array::uniform3(prop::array::uniform3(-1.0..1.0_f64)), 1..6),
            to in prop::collection::vec(prop::array::uniform3(prop::array::uniform3(-1.0..1.0_f64)), 1..12),
            weights in prop::collection::vec(prop::array::uniform3(0.0..1.0_f64), 20),
        ) {
            let corners = |all: Vec<[[f64; 3]; 3]>| -> Vec<[DVec3; 3]> {
                all.into_iter().map(|t| t.map(DVec3::from)).collect()
            };
            let (from, to) = (corners(from), corners(to));
            let found = bound(&from, &to);
            prop_assert!(found.lower <= found.upper);
            prop_assert!(found.upper <= found.lower * (1.0 + 2.0 * GAP) + 1e-9);
            let distance = |p: DVec3| to.iter().map(|t| distance_to(p, t)).fold(f64::INFINITY, f64::min);
            prop_assert!((distance(found.place) - found.lower).abs() < 1e-12);
            for [a, b, c] in from {
                for [u, v, w] in &weights {
                    let sample = (*u * a + *v * b + *w * c) / (u + v + w).max(1e-9);
                    if u + v + w > 1e-6 {
                        prop_assert!(distance(sample) <= found.upper);
                    }
                }
            }
        }

        /// The distance to a triangle is that of the nearest of many of its points.
        #[test]
        fn the_distance_to_a_triangle_is_right(
            corners in prop::array::uniform3(prop::array::uniform3(-1.0..1.0_f64)),
            point in prop::array::uniform3(-2.0..2.0_f64),
        ) {
            let triangle = corners.map(DVec3::from);
            let [a, b, c] = triangle;
            let point = DVec3::from(point);
            let found = distance_to(point, &triangle);
            let mut nearest = f64::INFINITY;
            const STEPS: u32 = 60;
            for i in 0..=STEPS {
                for j in 0..=STEPS - i {
                    let [u, v] = [i, j].map(|k| f64::from(k) / f64::from(STEPS));
                    nearest = nearest.min((u * a + v * b + (1.0 - u - v) * c).distance(point));
                }
            }
            prop_assert!(found <= nearest + 1e-12 && nearest <= found + 0.1, "{} {}", found, nearest);
        }
    }
}
