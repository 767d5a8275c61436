//! The best angle with a given edge, degrees aside: an upper bound that prunes the exact work.

use crate::chords::{Chords, Sides};
use crate::measure::min_angle_tangent;
use crate::progress::Stopped;
use glam::DVec2;
use mindeg_core::Boundary;
use rayon::prelude::*;

/// For every edge the largest minimum angle of a triangulation that contains it, as a tangent.
pub(crate) struct Bottleneck {
    vertices: usize,
    /// For the edge from i to i + span, at `span * vertices + i`.
    values: Vec<f64>,
}

impl Bottleneck {
    /// The bounds for all edges. O(n³) time, in parallel, and O(n²) memory.
    ///
    /// An edge splits the polygon into two pieces, and either piece is an interval of the ring:
    /// so it takes the best angle of every interval, an interval being split at the apex of the
    /// triangle on its edge.
    pub(crate) fn new(
        boundary: &Boundary,
        points: &[DVec2],
        mut watch: impl FnMut(f64) -> Result<(), Stopped>,
    ) -> Result<Self, Stopped> {
        const CHUNK: usize = 256;
        let vertices = points.len();
        let sides = Sides::new(boundary);
        // For the piece of `span` boundary edges from i on, at `span * width + i`. Every row
        // comes twice in a row, so that i + span never wraps. Pieces that cannot be
        // triangulated have the maximum over nothing.
        let width = 2 * vertices;
        let mut pieces = vec![f64::NEG_INFINITY; vertices * width];
        pieces[width..2 * width].fill(f64::INFINITY);
        for span in 2..vertices {
            let share = span as f64 / vertices as f64;
            watch(share * share)?;
            let (done, rest) = pieces.split_at_mut(span * width);
            let row = &mut rest[..vertices];
            row.par_chunks_mut(CHUNK).enumerate().for_each(|(chunk, best)| {
                let start = chunk * CHUNK;
                let count = best.len();
                for apex in 1..span {
                    let before = &done[apex * width + start..][..count];
                    let after = &done[(span - apex) * width + start + apex..][..count];
                    improve(best, before, after, |offset| {
                        let at = |step: usize| points[(start + offset + step) % vertices];
                        min_angle_tangent([at(0), at(apex), at(span)])
                    });
                }
                for (offset, best) in best.iter_mut().enumerate() {
                    let i = start + offset;
                    if span < vertices - 1 && sides.has_both(i, (i + span) % vertices) {
                        *best = f64::NEG_INFINITY;
                    }
                }
            });
            rest.copy_within(0..vertices, vertices);
        }
        let mut values = vec![f64::NEG_INFINITY; vertices * vertices];
        for span in 1..vertices {
            let inside = &pieces[span * width..][..vertices];
            let outside = &pieces[(vertices - span) * width + span..][..vertices];
            let both = inside.iter().zip(outside).map(|(a, b)| a.min(*b));
            let row = values[span * vertices..][..vertices - span].iter_mut();
            row.zip(both).for_each(|(value, both)| *value = both);
        }
        Ok(Self { vertices, values })
    }

    /// The largest minimum angle of all triangulations, as a tangent.
    pub(crate) fn of_all(&self) -> f64 {
        self.values[self.vertices]
    }

    /// The edges whose bound is at least `threshold`, and the largest bound below it.
    pub(crate) fn edges_from(&self, threshold: f64) -> (Chords, f64) {
        let mut below = f64::NEG_INFINITY;
        let chords = Chords::new(self.vertices, |i, span| {
            let value = self.values[span * self.vertices + i];
            if value < threshold {
                below = below.max(value);
            }
            value >= threshold
        });
        (chords, below)
    }
}

/// Raises every `best` to the least of what is before the apex, after it, and the triangle.
fn improve(best: &mut [f64], before: &[f64], after: &[f64], triangle: impl Fn(usize) -> f64) {
    // Most apexes improve nothing, and that is seen without branches.
    let improves = best
        .iter()
        .zip(before.iter().zip(after))
        .fold(false, |any, (best, (before, after))| any | (before.min(*after) > *best));
    if improves {
        for (offset, best) in best.iter_mut().enumerate() {
            let pieces = before[offset].min(after[offset]);
            if pieces > *best {
                *best = best.max(pieces.min(triangle(offset)));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let bottleneck = Bottleneck::new(&boundary, &points, |_| Ok(())).unwrap();
        let mut best = vec![vec![f64::NEG_INFINITY; n]; n];
        visit(&boundary, &points, &mut vec![(0, n - 1)], &mut vec![], f64::INFINITY, &mut best);

        let chords = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
        for (i, j) in chords.clone() {
            assert_eq!(bottleneck.values[(j - i) * n + i], best[i][j], "{i}, {j}");
        }
        assert_eq!(bottleneck.of_all(), best[0][n - 1]);

        let threshold = best[1][5];
        let (edges, below) = bottleneck.edges_from(threshold);
        let is_below = |&(i, j): &(usize, usize)| best[i][j] < threshold;
        for (i, j) in chords.clone() {
            let has = edges.of_span(j - i).contains(&(i as u32));
            assert_ne!(has, is_below(&(i, j)), "{i}, {j}");
        }
        let expected = chords.filter(is_below).map(|(i, j)| best[i][j]);
        assert_eq!(below, expected.fold(f64::NEG_INFINITY, f64::max));
        assert!(below > 0.0);
    }

    #[test]
    fn a_watch_can_stop_it() {
        let boundary = Boundary::new(&SIDES).unwrap();
        let mut shares = Vec::new();
        let stopped = Bottleneck::new(&boundary, &points(), |share| {
            shares.push(share);
            if shares.len() == 3 { Err(Stopped) } else { Ok(()) }
        });
        assert!(stopped.is_err() && shares.is_sorted() && shares.len() == 3);
    }
}
