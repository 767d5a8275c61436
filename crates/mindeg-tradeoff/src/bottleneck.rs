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
