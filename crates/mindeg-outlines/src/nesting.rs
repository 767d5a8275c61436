//! From closed rings in any order to polygons with holes.
//!
//! A file that only draws closed curves does not say which of them are holes. The fill rule does,
//! as in SVG: a point is inside if the rings wind around it an odd number of times, or not zero
//! times. Rings that separate inside from inside or outside from outside bound nothing.
//!
//! Limits: rings must not cross; crossings are found later, when the domain is made. Curves are
//! compared by their points every 15 degrees.

use glam::DVec2;
use mindeg_mesh::Bounds;
use mindeg_mesh::planar::{doubled_area, orientation};

use super::outline::{DrawnRing, Feature, FillRule, Outlines, Shape};
use crate::error::OutlineError;

/// The most comparisons of a point with an edge, which take some seconds: 90,000 squares beside each
/// other, or 40,000 inside each other.
const MOST_COMPARISONS: u64 = 4_000_000_000;

/// A ring of points that crosses no other.
pub(super) struct Loop {
    pub(super) points: Vec<DVec2>,
    doubled_area: f64,
    bounds: Bounds,
}

impl Loop {
    pub(super) fn new(points: Vec<DVec2>) -> Self {
        let (doubled_area, bounds) = (doubled_area(&points), box_around(&points));
        Self { points, doubled_area, bounds }
    }
}

/// The rings of a polygon.
pub(super) fn loops(rings: &[DrawnRing]) -> Vec<Loop> {
    rings.iter().map(|ring| Loop::new(ring.flattened())).collect()
}

/// Whether a point lies in a polygon: within its first ring and no other one.
pub(super) fn is_in(rings: &[Loop], point: DVec2) -> bool {
    let is_in_ring = |ring: &Loop| smallest_around([(0, ring)], &[point]).is_some();
    match rings {
        [outer, holes @ ..] => is_in_ring(outer) && !holes.iter().any(is_in_ring),
        [] => false,
    }
}

/// The index of the smallest of some loops that contains a ring of points, or a single point.
pub(super) fn smallest_around<'a>(
    loops: impl IntoIterator<Item = (usize, &'a Loop)>,
    points: &[DVec2],
) -> Option<usize> {
    let own = box_around(points);
    let is_around = |(_, around): &(usize, &Loop)| {
        is_within(own, around.bounds) && contains(&around.points, points)
    };
    let size = |(_, around): &(usize, &Loop)| around.doubled_area.abs();
    let found = loops.into_iter().filter(is_around);
    found.min_by(|a, b| size(a).total_cmp(&size(b))).map(|(index, _)| index)
}

/// A ring with its place among others.
struct Nested {
    /// Its index among the rings as given.
    index: usize,
    own: Loop,
    /// The position of the smallest ring around it.
    parent: Option<usize>,
    /// How many times the rings wind around the points just inside.
    winding: i64,
    /// How many rings are around it.
    depth: usize,
}

impl Outlines {
    /// The polygons that rings bound by the even-odd rule.
    pub(super) fn of_rings(
        rings: Vec<DrawnRing>,
        notes: Vec<String>,
    ) -> Result<Self, OutlineError> {
        let mut outlines = Self { notes, ..Self::default() };
        outlines.add(rings, FillRule::EvenOdd, None)?;
        Ok(outlines)
    }

    /// Adds the polygons that rings bound, and tells how many rings bound nothing.
    pub(super) fn add(
        &mut self,
        rings: Vec<DrawnRing>,
        rule: FillRule,
        name: Option<&str>,
    ) -> Result<usize, OutlineError> {
        let (features, without_effect) = polygons(rings, rule, name)?;
        self.features.extend(features);
        let count = without_effect.len();
        let end = self.features.len();
        self.shapes.push(Shape { end, rule, is_of_polygons: false, without_effect });
        Ok(count)
    }
}

/// The polygons that the rings bound, in the order of their outer rings, and the rings that bound
/// nothing.
pub(super) fn polygons(
    rings: Vec<DrawnRing>,
    rule: FillRule,
    name: Option<&str>,
) -> Result<(Vec<Feature>, Vec<DrawnRing>), OutlineError> {
    let loops = nested(&rings)?;
    let is_inside = |at: Option<usize>| match (at, rule) {
        (None, _) => false,
        (Some(at), FillRule::EvenOdd) => loops[at].depth % 2 == 0,
        (Some(at), FillRule::NonZero) => loops[at].winding != 0,
    };
    // The loop, outward from `at`, that bounds the inside there.
    let boundary_around = |mut at: usize| {
        while let Some(parent) = loops[at].parent.filter(|&parent| is_inside(Some(parent))) {
            at = parent;
        }
        at
    };
    let mut holes: Vec<Vec<usize>> = vec![Vec::new(); rings.len()];
    let mut outers = Vec::new();
    for (at, one) in loops.iter().enumerate() {
        match (is_inside(one.parent), is_inside(Some(at))) {
            (false, true) => outers.push(one.index),
            (true, false) => {
                let parent = one.parent.map_or(at, boundary_around);
                holes[loops[parent].index].push(one.index);
            }
            _ => {}
        }
    }
    drop(loops);
    outers.sort_unstable();
    let mut rings: Vec<Option<DrawnRing>> = rings.into_iter().map(Some).collect();
    let feature = |outer: usize| {
        let mut indices = std::mem::take(&mut holes[outer]);
        indices.sort_unstable();
        indices.insert(0, outer);
        let rings = indices.into_iter().filter_map(|index| rings[index].take()).collect();
        Feature { name: name.map(str::to_owned), rings, ..Feature::default() }
    };
    let features = outers.into_iter().map(feature).collect();
    Ok((features, rings.into_iter().flatten().collect()))
}

/// The rings, larger ones first, each with its parent.
fn nested(rings: &[DrawnRing]) -> Result<Vec<Nested>, OutlineError> {
    let mut loops: Vec<Nested> = rings
        .iter()
        .enumerate()
        .map(|(index, ring)| {
            let own = Loop::new(ring.flattened());
            Nested { index, own, parent: None, winding: 0, depth: 0 }
        })
        .collect();
    let size = |one: &Nested| one.own.doubled_area.abs();
    loops.sort_by(|a, b| size(b).total_cmp(&size(a)).then(a.index.cmp(&b.index)));
    let mut budget = MOST_COMPARISONS;
    for at in 0..loops.len() {
        let (larger, rest) = loops.split_at(at);
        let one = &rest[0].own;
        let mut parent = None;
        // From the smallest up: the first that contains it is its parent.
        for (other_at, Nested { own: other, .. }) in larger.iter().enumerate().rev() {
            let is_around = is_within(one.bounds, other.bounds);
            let cost = if is_around { 1 + other.points.len() as u64 } else { 1 };
            budget = budget
                .checked_sub(cost)
                .ok_or_else(|| OutlineError::place("the whole file", too_deep(rings.len())))?;
            if is_around && contains(&other.points, &one.points) {
                parent = Some(other_at);
                break;
            }
        }
        let (winding, depth) = parent.map_or((0, 0), |at| (loops[at].winding, loops[at].depth + 1));
        let turn = if loops[at].own.doubled_area > 0.0 { 1 } else { -1 };
        loops[at].parent = parent;
        loops[at].depth = depth;
        loops[at].winding = winding + turn;
    }
    Ok(loops)
}

/// The message for more closed curves than can be sorted in some seconds.
pub(super) fn too_deep(rings: usize) -> String {
    format!(
        "{rings} closed curves lie too deep in each other to be sorted; split them into several files"
    )
}

/// The box around some points; at 0 without any.
pub(super) fn box_around(points: &[DVec2]) -> Bounds {
    let nowhere = Bounds { min: DVec2::ZERO, max: DVec2::ZERO };
    Bounds::of(points.iter().copied()).unwrap_or(nowhere)
}

/// Whether a box lies in another.
pub(super) fn is_within(inner: Bounds, outer: Bounds) -> bool {
    outer.min.cmple(inner.min).all() && outer.max.cmpge(inner.max).all()
}

/// Whether a ring of points contains another one that does not cross it.
pub(super) fn contains(ring: &[DVec2], other: &[DVec2]) -> bool {
    // A few points may lie on the ring: the rings may touch.
    other.iter().take(64).find_map(|&point| side(ring, point)).unwrap_or(false)
}

/// Whether a ring of points that does not cross another one lies in it, or runs along all of it.
pub(super) fn fits_in(other: &[DVec2], ring: &[DVec2]) -> bool {
    other.iter().find_map(|&point| side(ring, point)).unwrap_or(true)
}

/// Whether a point is inside a ring; `None` if it lies on it. O(n), exact.
fn side(ring: &[DVec2], point: DVec2) -> Option<bool> {
    let mut inside = false;
    let next = ring.iter().cycle().skip(1);
    for (&a, &b) in ring.iter().zip(next) {
        if (a.y > point.y) == (b.y > point.y) {
            let on_level = a.y == point.y && b.y == point.y;
            if point == a || on_level && (a.x <= point.x) != (b.x <= point.x) {
                return None;
            }
            continue;
        }
        let turn = orientation(a, b, point);
        if turn == 0.0 {
            return None;
        }
        // The ray to the right crosses the edge if the point is left of it, looking up.
        if (turn > 0.0) == (b.y > a.y) {
            inside = !inside;
        }
    }
    Some(inside)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square about the origin of this half size; clockwise if it is negative.
    fn square(half: f64) -> DrawnRing {
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        DrawnRing::of_points(corners.map(|[x, y]| DVec2::new(x * half, y * half.abs())))
    }

    /// For each polygon the half sizes of its rings.
    fn sizes(halves: &[f64], rule: FillRule) -> Vec<Vec<f64>> {
        let rings = halves.iter().map(|&half| square(half)).collect();
        let (features, _) = polygons(rings, rule, None).unwrap();
        let half = |ring: &DrawnRing| -ring.pieces[0].start.x;
        features.iter().map(|feature| feature.rings.iter().map(half).collect()).collect()
    }

    #[test]
    fn the_fill_rule_tells_holes() {
        use FillRule::{EvenOdd, NonZero};
        assert_eq!(sizes(&[2.0, 4.0, 1.0, 3.0], EvenOdd), [vec![2.0, 1.0], vec![4.0, 3.0]]);
        assert_eq!(sizes(&[2.0, 4.0, 1.0, 3.0], NonZero), [[4.0]]);
        assert_eq!(sizes(&[4.0, -3.0, 2.0], NonZero), [vec![4.0, -3.0], vec![2.0]]);
        // Wound twice, then once, then not at all.
        assert_eq!(sizes(&[4.0, 3.0, -2.0, -1.0], NonZero), [[4.0, -1.0]]);
        assert_eq!(sizes(&[-4.0, 3.0], NonZero), [[-4.0, 3.0]]);
        assert_eq!(sizes(&[1.0], EvenOdd), [[1.0]]);
        assert_eq!(sizes(&[], EvenOdd), [[0.0; 0]; 0]);
    }

    #[test]
    fn rings_may_touch_at_a_point_and_lie_beside_each_other() {
        let outer = square(4.0);
        let hole = DrawnRing::of_points([[-4.0, 0.0], [0.0, -1.0], [0.0, 1.0]].map(DVec2::from));
        let beside = DrawnRing::of_points([[4.0, 0.0], [6.0, -1.0], [6.0, 1.0]].map(DVec2::from));
        let rings = vec![hole.clone(), beside.clone(), outer.clone()];
        let (features, _) = polygons(rings, FillRule::EvenOdd, Some("x")).unwrap();
        let found: Vec<&[DrawnRing]> = features.iter().map(|feature| &*feature.rings).collect();
        assert_eq!(found, [&[beside][..], &[outer, hole]]);
    }

    #[test]
    fn points_on_the_ring_are_neither_inside_nor_outside() {
        let ring = square(1.0).flattened();
        for (point, expected) in [
            ([0.0, 0.0], Some(true)),
            ([2.0, 0.0], Some(false)),
            ([-2.0, 1.0], Some(false)),
            ([-2.0, -1.0], Some(false)),
            ([1.0, 0.5], None),
            ([1.0, 1.0], None),
            ([0.5, 1.0], None),
            ([0.5, -1.0], None),
            ([-1.0, -1.0], None),
        ] {
            assert_eq!(side(&ring, point.into()), expected, "{point:?}");
        }
    }
}
