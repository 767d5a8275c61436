//! Convex hulls of consecutive vertices, which tell whether any of them is on one side of a line without
//! a look at each. Exact. O(n log n) to build, O(log² n) for each question.

use glam::DVec2;
use mindeg_mesh::planar::orientation;
use std::ops::Range;

/// The vertices of the smallest hulls.
const BLOCK: usize = 16;

/// The hulls of blocks of vertices, of pairs of these, and so on up to that of all.
pub(crate) struct Hulls<'a> {
    points: &'a [DVec2],
    /// The hulls of `BLOCK << level` vertices, one after the other.
    levels: Vec<Vec<Hull>>,
    /// The largest coordinate.
    largest: f64,
}

/// The lower and the upper hull of some points, each from left to right.
type Hull = [Vec<u32>; 2];

/// Which one of several vertices.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Which {
    First,
    Last,
}

impl<'a> Hulls<'a> {
    pub(crate) fn new(points: &'a [DVec2]) -> Self {
        let all: Vec<u32> = (0..points.len() as u32).collect();
        let of_block = |block: &[u32]| hull(points, block.to_vec());
        let mut levels = vec![all.chunks(BLOCK).map(of_block).collect::<Vec<Hull>>()];
        while let Some(last) = levels.last().filter(|last| last.len() > 1) {
            let both = last.chunks(2).map(|pair| hull(points, pair.as_flattened().concat()));
            levels.push(both.collect());
        }
        let largest = points.iter().map(|point| point.abs().max_element()).fold(0.0, f64::max);
        Self { points, levels, largest }
    }

    /// The first or last of these vertices that is on the left of the line; the range may go on from the
    /// last vertex to 0.
    pub(crate) fn left_of(
        &self,
        line: [DVec2; 2],
        vertices: Range<u32>,
        which: Which,
    ) -> Option<u32> {
        let (start, end) = (vertices.start as usize, vertices.end as usize);
        let mut parts = match start <= end {
            true => [start..end, end..end],
            false => [start..self.points.len(), 0..end],
        };
        if which == Which::Last {
            parts.reverse();
        }
        let root = self.levels.len() - 1;
        parts.iter().find_map(|part| self.find(line, part, [root, 0], which)).map(|v| v as u32)
    }

    /// The vertex among those of one hull.
    fn find(
        &self,
        line: [DVec2; 2],
        vertices: &Range<usize>,
        [level, index]: [usize; 2],
        which: Which,
    ) -> Option<usize> {
        let hull = self.levels[level].get(index)?;
        let len = BLOCK << level;
        let (start, end) = (index * len, self.points.len().min((index + 1) * len));
        let is_apart = end <= vertices.start || vertices.end <= start;
        let is_whole = vertices.start <= start && end <= vertices.end;
        if is_apart || (is_whole && !self.is_any_left(line, hull)) {
            return None;
        }
        if level > 0 {
            let mut halves = [2 * index, 2 * index + 1];
            if which == Which::Last {
                halves.reverse();
            }
            return halves
                .iter()
                .find_map(|&half| self.find(line, vertices, [level - 1, half], which));
        }
        let [from, to] = line;
        let mut own = start.max(vertices.start)..end.min(vertices.end);
        let is_left = |&vertex: &usize| orientation(from, to, self.points[vertex]) > 0.0;
        if which == Which::First { own.find(is_left) } else { own.rfind(is_left) }
    }

    /// Whether one of the vertices beside a segment, no farther from it than `distance`, has a property.
    /// O(log² n), and O(log² n) more for each block of vertices with one of them.
    pub(crate) fn any_beside(
        &self,
        [from, to]: [DVec2; 2],
        distance: f64,
        is: impl Fn(u32) -> bool,
    ) -> bool {
        let along = to - from;
        let across = along.perp();
        // Twice the distance, and the rounding of a coordinate: it may find more, never less.
        let aside =
            across.normalize_or_zero() * (2.0 * distance + 4.0 * f64::EPSILON * self.largest);
        // All these are on the left of each of four lines.
        let lines = [
            [from - aside, to - aside],
            [to + aside, from + aside],
            [from, from - across],
            [to, to + across],
        ];
        let mut open = vec![[self.levels.len() - 1, 0]];
        while let Some([level, index]) = open.pop() {
            let Some(hull) = self.levels[level].get(index) else { continue };
            if !lines.iter().all(|&line| self.is_any_left(line, hull)) {
                continue;
            }
            if level > 0 {
                open.extend([[level - 1, 2 * index], [level - 1, 2 * index + 1]]);
            } else {
                let mut own = index * BLOCK..self.points.len().min((index + 1) * BLOCK);
                if own.any(|vertex| is(vertex as u32)) {
                    return true;
                }
            }
        }
        false
    }

    /// Whether one of the points of a hull is on the left.
    fn is_any_left(&self, [from, to]: [DVec2; 2], hull: &Hull) -> bool {
        let along = to - from;
        let chain = &hull[usize::from(along.x > 0.0)];
        let at = |index: usize| self.points[chain[index] as usize];
        let left = |index: usize| along.perp_dot(at(index) - from);
        // Along the chain the distance from the line rises, then falls.
        let (mut low, mut high) = (0, chain.len() - 1);
        while low < high {
            let middle = low + (high - low) / 2;
            if along.perp_dot(at(middle + 1) - at(middle)) > 0.0 {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        // Rounding may have missed the farthest point by a little, and its sign.
        let rounding = 16.0 * f64::EPSILON * along.abs().element_sum() * self.largest;
        let is_left = |index: usize| orientation(from, to, at(index)) > 0.0;
        let is_near = |&index: &usize| left(index) > -rounding;
        (0..=low).rev().take_while(is_near).any(is_left)
            || (low + 1..chain.len()).take_while(is_near).any(is_left)
    }
}

/// The hull of these points.
fn hull(points: &[DVec2], mut vertices: Vec<u32>) -> Hull {
    let at = |vertex: u32| points[vertex as usize];
    vertices.sort_unstable_by(|&a, &b| {
        at(a).x.total_cmp(&at(b).x).then(at(a).y.total_cmp(&at(b).y)).then(a.cmp(&b))
    });
    vertices.dedup();
    [1.0, -1.0].map(|side| {
        let mut chain: Vec<u32> = Vec::new();
        for &vertex in &vertices {
            while let [.., a, b] = chain[..]
                && side * orientation(at(a), at(b), at(vertex)) <= 0.0
            {
                chain.pop();
            }
            chain.push(vertex);
        }
        chain
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers in no order, below `most`.
    fn scattered(seed: u32, most: u32) -> u32 {
        (seed + 1).wrapping_mul(0x9e37_79b9).rotate_left(15).wrapping_mul(0x85eb_ca6b) % most
    }

    #[test]
    fn the_points_beside_a_segment_are_found() {
        // Neighbours are near each other, so that whole blocks are apart from most segments.
        let point = |v: u32| DVec2::new(f64::from(v), f64::from(v * v) / 100.0);
        let points: Vec<DVec2> = (0..300).map(point).collect();
        let hulls = Hulls::new(&points);
        let mut found = 0;
        for seed in 0..3000 {
            let [from, to] = [0, 1].map(|of| points[scattered(2 * seed + of, 300) as usize]);
            let along = (to - from).normalize_or_zero();
            let is_beside = |p: DVec2, distance: f64| {
                (p - from).dot(to - from) > 0.0
                    && (p - to).dot(from - to) > 0.0
                    && along.perp_dot(p - from).abs() <= distance
            };
            let distance = f64::from(scattered(seed, 7));
            let some = |p: &DVec2| (p.x as u32).is_multiple_of(20);
            let is = |v: u32| some(&points[v as usize]) && is_beside(points[v as usize], distance);
            let any = points.iter().any(|p| some(p) && is_beside(*p, distance));
            assert_eq!(hulls.any_beside([from, to], distance, is), any, "{seed}");
            found += u32::from(any);
        }
        assert!((100..2900).contains(&found), "{found}");
    }

    #[test]
    fn the_hulls_tell_what_all_points_do() {
        for size in [5, 1000] {
            // Many points on lines, and many at one position.
            let point = |v: u32| [2 * v, 2 * v + 1].map(|v| f64::from(scattered(v, size)));
            let points: Vec<DVec2> = (0..300).map(|v| DVec2::from(point(v))).collect();
            let hulls = Hulls::new(&points);
            for seed in 0..3000 {
                let at = |of: u32, most: u32| scattered(4 * seed + of, most);
                let [from, to] = [at(0, 300), at(1, 300)].map(|vertex| points[vertex as usize]);
                let (start, end) = (at(2, 300), at(3, 301));
                let all: Vec<u32> = match start <= end {
                    true => (start..end).collect(),
                    false => (start..300).chain(0..end).collect(),
                };
                let is_left = |&v: &u32| orientation(from, to, points[v as usize]) > 0.0;
                let line = [from, to];
                let find = |which| hulls.left_of(line, start..end, which);
                assert_eq!(find(Which::First), all.iter().copied().find(is_left), "{seed}");
                assert_eq!(find(Which::Last), all.iter().copied().rfind(is_left), "{seed}");
            }
        }
    }
}
