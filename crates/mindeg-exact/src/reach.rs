//! The edges of the triangulations whose angles are all large enough, whatever their degrees: the
//! dynamic program needs only these few.

use crate::chords::Chords;
use crate::measure::min_angle_tangent;
use crate::rows::gallop;
use glam::DVec2;
use mindeg_mesh::Cancelled;
use mindeg_mesh::parallel::map_chunks;
use std::ops::Range;

/// The fewest edges of a batch, unless it is the only one: enough work for one thread.
const BATCH: usize = 64;

/// The edges of `chords` that are in some triangulation of them without a tangent below
/// `threshold`; `None` if no such triangulation exists. `report` gets the share that is done.
///
/// An edge splits the polygon into two pieces. A first pass goes over the inner pieces, from short
/// edges to long ones: one is good if some good triangle on the edge has two good pieces beneath.
/// A second pass goes over the outer pieces, from long edges to short ones.
pub(crate) fn reaching(
    chords: &Chords,
    points: &[DVec2],
    threshold: f64,
    report: impl Fn(f64) -> Result<(), Cancelled>,
) -> Result<Option<Chords>, Cancelled> {
    let vertices = chords.vertex_count();
    let is_good = |a: usize, b: usize, c: usize| {
        let corners = [points[a], points[b], points[c]];
        // Even a triangle that rounding has turned over has a tangent of 0.
        threshold <= 0.0
            || (is_roughly(corners, threshold) && min_angle_tangent(corners) >= threshold)
    };
    let mut inside = Pairs::new(chords);
    for span in 1..vertices {
        report(span as f64 / vertices as f64 / 2.0)?;
        let starts = chords.of_span(span);
        let is_inside = |&i: &u32| {
            let (i, j) = (i as usize, i as usize + span);
            span == 1 || inside.any_common(&inside, i, j, i + 1..j, |apex| is_good(i, apex, j))
        };
        for (&i, is_in) in starts.iter().zip(each(starts, is_inside)) {
            if is_in {
                inside.insert(i as usize, i as usize + span);
            }
        }
    }
    if !inside.has(0, vertices - 1) {
        return Ok(None);
    }
    let mut both = inside.emptied();
    for span in (1..vertices).rev() {
        report(1.0 - span as f64 / vertices as f64 / 2.0)?;
        let starts = chords.of_span(span);
        let is_both = |&i: &u32| {
            let (i, j) = (i as usize, i as usize + span);
            let is_good = |apex| is_good(i, j, apex);
            span == vertices - 1
                || (inside.has(i, j)
                    && (both.any_common(&inside, i, j, j + 1..vertices, is_good)
                        || inside.any_common(&both, i, j, 0..i, is_good)))
        };
        for (&i, is_in) in starts.iter().zip(each(starts, is_both)) {
            if is_in {
                both.insert(i as usize, i as usize + span);
            }
        }
    }
    Ok(Some(chords.filtered(|i, j| both.has(i as usize, j as usize))))
}

/// Whether the minimum angle may have a tangent of `threshold`: a quick test, which errs on the
/// side of yes.
fn is_roughly([a, b, c]: [DVec2; 3], threshold: f64) -> bool {
    let squares = [(b - a).length_squared(), (c - b).length_squared(), (a - c).length_squared()];
    let [x, y, z] = squares;
    let sum = x + y + z;
    let longer = sum - 2.0 * x.min(y).min(z);
    // The measure starts from another corner, where rounding is another: of an area, it is a part of the
    // longest edge's square.
    let area = 2.0 * (b - a).perp_dot(c - a) + 32.0 * f64::EPSILON * sum;
    let excess = area - threshold * longer * (1.0 - 1e-9);
    excess >= 0.0 || excess.is_nan()
}

/// The answers for all edges of one span.
fn each(starts: &[u32], answer: impl Fn(&u32) -> bool + Send + Sync) -> Vec<bool> {
    // Even batches: the cost of a short last one is that of another thread.
    let batches = (starts.len() / BATCH).max(1);
    let batch = |range: Range<usize>| starts[range].iter().map(&answer).collect::<Vec<bool>>();
    map_chunks(0..starts.len(), starts.len().div_ceil(batches).max(1), batch).concat()
}

/// A set of pairs of vertices that are edges, as bits: of each vertex the 64-bit words in which it has
/// an edge.
struct Pairs {
    /// Where the words of each vertex begin.
    starts: Vec<u32>,
    /// Word w is of the vertices 64 * w to 64 * w + 63; ascending for each vertex.
    words: Vec<u32>,
    bits: Vec<u64>,
}

impl Pairs {
    /// An empty set, with space for these edges.
    fn new(chords: &Chords) -> Self {
        let mut words = vec![Vec::new(); chords.vertex_count()];
        // By ascending length, so from the nearest word to the farthest one in either direction.
        for [i, j] in chords.ends() {
            for (vertex, word) in [(i, j / 64), (j, i / 64)] {
                let of: &mut Vec<u32> = &mut words[vertex as usize];
                if !of.iter().rev().take(2).any(|&known| known == word) {
                    of.push(word);
                }
            }
        }
        let mut starts = vec![0];
        for of in &mut words {
            of.sort_unstable();
            of.dedup();
            starts.push(starts[starts.len() - 1] + of.len() as u32);
        }
        let words = words.concat();
        Self { starts, bits: vec![0; words.len()], words }
    }

    /// None, with room for the same edges.
    fn emptied(&self) -> Self {
        let bits = vec![0; self.bits.len()];
        Self { starts: self.starts.clone(), words: self.words.clone(), bits }
    }

    fn insert(&mut self, i: usize, j: usize) {
        for (vertex, other) in [(i, j), (j, i)] {
            let at = self.from(vertex, other / 64);
            self.bits[at] |= 1 << (other % 64);
        }
    }

    /// Whether the set has this edge.
    fn has(&self, i: usize, j: usize) -> bool {
        self.bits[self.from(i, j / 64)] >> (j % 64) & 1 == 1
    }

    /// Where the words of a vertex from `word` on begin.
    fn from(&self, vertex: usize, word: usize) -> usize {
        let (start, end) = (self.starts[vertex] as usize, self.starts[vertex + 1] as usize);
        start + self.words[start..end].partition_point(|&other| (other as usize) < word)
    }

    /// Whether one of these vertices that is paired with i here and with j in `other` passes.
    fn any_common(
        &self,
        other: &Self,
        i: usize,
        j: usize,
        range: Range<usize>,
        passes: impl Fn(usize) -> bool,
    ) -> bool {
        if range.is_empty() {
            return false;
        }
        let (first, last) = (range.start, range.end - 1);
        let words = |vertex| self.from(vertex, first / 64)..self.from(vertex, last / 64 + 1);
        let (mut of_i, mut of_j) = (words(i), words(j));
        while !of_i.is_empty() && !of_j.is_empty() {
            let [word, beside] = [of_i.start, of_j.start].map(|at| self.words[at] as usize);
            if word != beside {
                // The rows of a comb's back have thousands of words more than those of its teeth.
                let behind = if word < beside { &mut of_i } else { &mut of_j };
                let rest = &self.words[behind.start..behind.end];
                behind.start += gallop(rest, |&other| (other as usize) < word.max(beside));
                continue;
            }
            let mut bits = self.bits[of_i.start] & other.bits[of_j.start];
            if word == first / 64 {
                bits &= u64::MAX << (first % 64);
            }
            if word == last / 64 {
                bits &= u64::MAX >> (63 - last % 64);
            }
            while bits != 0 {
                if passes(word * 64 + bits.trailing_zeros() as usize) {
                    return true;
                }
                bits &= bits - 1;
            }
            (of_i.start, of_j.start) = (of_i.start + 1, of_j.start + 1);
        }
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sides::Sides;
    use mindeg_core::Boundary;
    use std::cell::RefCell;

    const SIDES: [u64; 4] = [3, 2, 1, 3];

    /// The points of a trapezoid with these intervals on its sides.
    fn points() -> Vec<DVec2> {
        let corners = [(0.0, 0.0), (5.0, 0.0), (4.0, 2.0), (1.0, 3.0)].map(DVec2::from);
        let mut points = Vec::new();
        for (side, intervals) in SIDES.into_iter().enumerate() {
            let place = |step| step as f64 / intervals as f64;
            let ends = (corners[side], corners[(side + 1) % 4]);
            points.extend((0..intervals).map(|step| ends.0.lerp(ends.1, place(step))));
        }
        points
    }

    /// Notes for every edge the largest minimum tangent of the triangulations that have it.
    fn visit(
        boundary: &Boundary,
        points: &[DVec2],
        open: &mut Vec<(usize, usize)>,
        edges: &mut Vec<(usize, usize)>,
        smallest: f64,
        best: &mut [Vec<f64>],
    ) {
        let Some((i, j)) = open.pop() else {
            for &(i, j) in &*edges {
                best[i][j] = best[i][j].max(smallest);
            }
            return;
        };
        edges.push((i, j));
        if j == i + 1 {
            visit(boundary, points, open, edges, smallest, best);
        }
        for apex in i + 1..j {
            let triangle = [i, apex, j];
            if !boundary.is_flat(triangle.map(|vertex| vertex as u32)) {
                let len = open.len();
                open.extend([(i, apex), (apex, j)]);
                let tangent = min_angle_tangent(triangle.map(|vertex| points[vertex]));
                visit(boundary, points, open, edges, smallest.min(tangent), best);
                open.truncate(len);
            }
        }
        edges.pop();
        open.push((i, j));
    }

    #[test]
    fn the_edges_are_those_of_all_triangulations_with_such_angles() {
        let (boundary, points) = (Boundary::new(&SIDES).unwrap(), points());
        let n = points.len();
        let all = Chords::all(n, &Sides::of_boundary(&boundary));
        let mut best = vec![vec![f64::NEG_INFINITY; n]; n];
        visit(&boundary, &points, &mut vec![(0, n - 1)], &mut vec![], f64::INFINITY, &mut best);

        let mut thresholds: Vec<f64> =
            all.ends().map(|[i, j]| best[i as usize][j as usize]).collect();
        thresholds.sort_by(f64::total_cmp);
        thresholds.dedup();
        assert!(thresholds.len() > 3);
        let largest = best[0][n - 1];
        for threshold in thresholds.into_iter().flat_map(|t| [t, t.next_up()]) {
            let kept = reaching(&all, &points, threshold, |_| Ok(())).unwrap();
            assert_eq!(kept.is_some(), threshold <= largest);
            if let Some(kept) = kept {
                let reach = |i: u32, j: u32| best[i as usize][j as usize] >= threshold;
                assert!(all.ends().all(|[i, j]| kept.has(i, j) == reach(i, j)), "{threshold}");
            }
        }
    }

    /// From 40,000 vertices on, all edges counted as edges that reach any angle; the search then found none.
    #[test]
    fn a_large_polygon_does_not_reach_what_it_cannot() {
        let n = 40_002_u32;
        let fan: Vec<_> = (2..n - 1).map(|j| [0, j]).collect();
        let chords = Chords::new(n as usize, &[fan]);
        let at = |v: u32| DVec2::from_angle(f64::from(v) * std::f64::consts::TAU / f64::from(n));
        let points: Vec<DVec2> = (0..n).map(at).collect();
        let reaching = |threshold| reaching(&chords, &points, threshold, |_| Ok(())).unwrap();
        assert_eq!(reaching(1e-5).map(|kept| kept.len()), Some(chords.len()));
        assert!(reaching(1e-3).is_none());
    }

    #[test]
    fn progress_can_cancel_it() {
        let boundary = Boundary::new(&SIDES).unwrap();
        let shares = RefCell::new(Vec::new());
        let chords = Chords::all(9, &Sides::of_boundary(&boundary));
        let answer = reaching(&chords, &points(), 0.0, |share| {
            shares.borrow_mut().push(share);
            if shares.borrow().len() == 3 { Err(Cancelled) } else { Ok(()) }
        });
        let shares = shares.into_inner();
        assert!(answer.is_err() && shares.is_sorted() && shares.len() == 3);
    }
}
