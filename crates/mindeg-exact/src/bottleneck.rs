//! The best angle with a given edge, degrees aside: an upper bound that prunes the exact work.

use crate::chords::{Chords, Lists, meet};
use crate::measure::min_angle_tangent;
use crate::progress::Stopped;
use glam::DVec2;
use rayon::prelude::*;
use std::cmp::Ordering;
use std::ops::ControlFlow;

/// For every edge the largest minimum angle of a triangulation that contains it, as a tangent.
pub(crate) struct Bottleneck {
    /// The edges whose bound is at least the floor.
    chords: Chords,
    /// Their bounds.
    values: Vec<f64>,
}

/// An edge at one of its ends.
#[derive(Clone, Copy, Default)]
struct End {
    other: u32,
    index: u32,
}

const BATCH: usize = 64;

impl Bottleneck {
    /// The bounds of all edges whose bound is at least `floor`, which must be reached by some
    /// triangulation of `chords`. O(triples of chords that reach the floor) time, in parallel.
    ///
    /// An edge splits the polygon into two pieces. It takes the best angle of the piece inside
    /// every edge, from short edges to long ones, a piece being split at the apex of the triangle on
    /// its edge; then that of the piece outside, from long ones to short ones.
    pub(crate) fn new(
        chords: &Chords,
        points: &[DVec2],
        floor: f64,
        mut watch: impl FnMut(f64) -> Result<(), Stopped>,
    ) -> Result<Self, Stopped> {
        let vertices = chords.vertex_count();
        let at = |vertex: u32| points[vertex as usize];
        let [mut up, mut down] = chords.end_counts().map(|counts| Lists::<End>::new(&counts));
        let mut inside = vec![f64::NEG_INFINITY; chords.len()];
        for span in 1..vertices {
            watch(span as f64 / vertices as f64 / 2.0)?;
            let range = chords.indices(span);
            let (done, rest) = inside.split_at_mut(range.start);
            let best_inside = |i: u32| {
                if span == 1 {
                    return f64::INFINITY;
                }
                let j = i + span as u32;
                let mut best = f64::NEG_INFINITY;
                meet(
                    up.of(i),
                    down.of(j),
                    |end| end.other,
                    |left, right| {
                        let pieces = done[left.index as usize].min(done[right.index as usize]);
                        if pieces > best {
                            let triangle = [at(i), at(left.other), at(j)];
                            best = best.max(pieces.min(min_angle_tangent(triangle)));
                        }
                        ControlFlow::Continue(())
                    },
                );
                best
            };
            each_of_span(chords.of_span(span), &mut rest[..range.len()], best_inside);
            for (index, &i) in range.zip(chords.of_span(span)) {
                if inside[index] >= floor {
                    let j = i + span as u32;
                    up.push(i, End { other: j, index: index as u32 });
                    down.push(j, End { other: i, index: index as u32 });
                }
            }
        }
        let mut outside = vec![f64::NEG_INFINITY; chords.len()];
        for span in (1..vertices).rev() {
            watch(1.0 - span as f64 / vertices as f64 / 2.0)?;
            let range = chords.indices(span);
            let (rest, done) = outside.split_at_mut(range.end);
            let outside_of = |end: &End| done[end.index as usize - range.end];
            let best_outside = |i: u32| {
                if span == vertices - 1 {
                    return f64::INFINITY;
                }
                let j = i + span as u32;
                let mut best = f64::NEG_INFINITY;
                let mut improve = |pieces: f64, apex: u32| {
                    if pieces > best && pieces >= floor {
                        // Beyond the edge, so that i, j, apex turn the same way.
                        let triangle = [at(i), at(j), at(apex)];
                        best = best.max(pieces.min(min_angle_tangent(triangle)));
                    }
                };
                let beyond = up.of(i);
                let beyond = &beyond[beyond.partition_point(|end| end.other <= j)..];
                both(
                    beyond,
                    up.of(j),
                    |end| end.other,
                    |long, short| {
                        improve(outside_of(long).min(inside[short.index as usize]), long.other);
                    },
                );
                let before = down.of(j);
                let before = &before[before.partition_point(|end| end.other >= i)..];
                both(
                    before,
                    down.of(i),
                    |end| u32::MAX - end.other,
                    |long, short| {
                        improve(outside_of(long).min(inside[short.index as usize]), long.other);
                    },
                );
                best
            };
            each_of_span(chords.of_span(span), &mut rest[range.start..], best_outside);
        }
        let bounds: Vec<f64> = inside.iter().zip(&outside).map(|(a, b)| a.min(*b)).collect();
        let kept = chords.filtered(|index| bounds[index] >= floor);
        let mut values = Vec::with_capacity(kept.len());
        for span in 1..vertices {
            let is_boundary = span == 1 || span == vertices - 1;
            let bounds = bounds[chords.indices(span)].iter();
            values.extend(bounds.filter(|&&bound| is_boundary || bound >= floor));
        }
        Ok(Self { chords: kept, values })
    }

    /// The largest minimum angle of all triangulations, as a tangent; minus infinity where none
    /// reaches the floor.
    pub(crate) fn of_all(&self) -> f64 {
        self.values[self.values.len() - 1]
    }

    /// The edges whose bound is at least `threshold`, and the largest bound below it; no
    /// threshold may be below the floor.
    pub(crate) fn edges_from(&self, threshold: f64) -> (Chords, f64) {
        let below = self.values.iter().copied().filter(|&value| value < threshold);
        let below = below.fold(f64::NEG_INFINITY, f64::max);
        (self.chords.filtered(|index| self.values[index] >= threshold), below)
    }
}

/// Fills in the values of the edges of one span.
fn each_of_span(starts: &[u32], values: &mut [f64], value: impl Fn(u32) -> f64 + Sync) {
    if starts.len() <= BATCH {
        values.iter_mut().zip(starts).for_each(|(out, &i)| *out = value(i));
    } else {
        values.par_chunks_mut(BATCH).zip(starts.par_chunks(BATCH)).for_each(|(out, starts)| {
            out.iter_mut().zip(starts).for_each(|(out, &i)| *out = value(i));
        });
    }
}

/// Visits the entries of equal key of two lists, both by ascending key.
fn both<T>(a: &[T], b: &[T], key: impl Fn(&T) -> u32, mut visit: impl FnMut(&T, &T)) {
    let (mut x, mut y) = (0, 0);
    while x < a.len() && y < b.len() {
        match key(&a[x]).cmp(&key(&b[y])) {
            Ordering::Less => x += 1,
            Ordering::Greater => y += 1,
            Ordering::Equal => {
                visit(&a[x], &b[y]);
                x += 1;
                y += 1;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chords::Sides;
    use mindeg_core::Boundary;

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

    /// Notes for every edge the smallest tangent of each triangulation that has it.
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
    fn bounds_are_those_of_all_triangulations_with_the_edge() {
        let (boundary, points) = (Boundary::new(&SIDES).unwrap(), points());
        let n = points.len();
        let all = Chords::all(n, &Sides::of_boundary(&boundary));
        let bottleneck = Bottleneck::new(&all, &points, f64::NEG_INFINITY, |_| Ok(())).unwrap();
        let mut best = vec![vec![f64::NEG_INFINITY; n]; n];
        visit(&boundary, &points, &mut vec![(0, n - 1)], &mut vec![], f64::INFINITY, &mut best);

        let chords = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
        for ([i, j], value) in all.ends().zip(&bottleneck.values) {
            assert_eq!(*value, best[i as usize][j as usize], "{i}, {j}");
        }
        assert_eq!(bottleneck.of_all(), best[0][n - 1]);

        let threshold = best[1][5];
        let (edges, below) = bottleneck.edges_from(threshold);
        let is_below = |&(i, j): &(usize, usize)| best[i][j] < threshold;
        for (i, j) in chords.clone() {
            let is_boundary = j == i + 1 || j == i + n - 1;
            let has = edges.has(i as u32, j as u32);
            assert_eq!(has, is_boundary || !is_below(&(i, j)), "{i}, {j}");
        }
        let expected = chords.filter(is_below).map(|(i, j)| best[i][j]);
        assert_eq!(below, expected.fold(f64::NEG_INFINITY, f64::max));
        assert!(below > 0.0);

        for floor in [best[1][5], best[0][n - 1]] {
            let pruned = Bottleneck::new(&all, &points, floor, |_| Ok(())).unwrap();
            assert!(pruned.chords.len() < all.len());
            for ([i, j], value) in pruned.chords.ends().zip(&pruned.values) {
                assert_eq!(*value, best[i as usize][j as usize], "{i}, {j}");
            }
            let kept = bottleneck.edges_from(floor).0;
            assert!(pruned.chords.ends().eq(kept.ends()));
        }
        let too_high = Bottleneck::new(&all, &points, best[0][n - 1] + 0.1, |_| Ok(())).unwrap();
        assert!(too_high.of_all() < best[0][n - 1] + 0.1);
    }

    #[test]
    fn a_watch_can_stop_it() {
        let boundary = Boundary::new(&SIDES).unwrap();
        let mut shares = Vec::new();
        let chords = Chords::all(9, &Sides::of_boundary(&boundary));
        let stopped = Bottleneck::new(&chords, &points(), 0.0, |share| {
            shares.push(share);
            if shares.len() == 3 { Err(Stopped) } else { Ok(()) }
        });
        assert!(stopped.is_err() && shares.is_sorted() && shares.len() == 3);
    }
}
