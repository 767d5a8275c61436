//! Writes many triangles of a strip at a time, with no division for each triangle.
//!
//! Along most of a strip both chains continue to the neighbouring id and the word repeats its
//! pattern, so each id changes by one. The few irregular triangles come from their closed form.
//!
//! Limits: to find the irregular triangles takes a constant time, so this is worth its cost from
//! some tens of triangles on.

use super::Strip;
use crate::word::{Letter, Runs};

impl Strip {
    /// Fills `out` with the triangles from index `first` on. The strip must have that many.
    pub(crate) fn fill(&self, first: u32, out: &mut [[u32; 3]]) {
        let irregular = self.irregular_letters();
        let mut done = 0;
        while done < out.len() {
            let index = first + done as u32;
            let regular = index.checked_sub(1).and_then(|letter| {
                irregular.iter().flatten().filter_map(|other| other.checked_sub(letter)).min()
            });
            match regular {
                None | Some(0) => {
                    out[done] = self.triangle(index);
                    done += 1;
                }
                Some(regular) => {
                    let end = out.len().min(done + regular as usize);
                    self.fill_regular(index, &mut out[done..end]);
                    done = end;
                }
            }
        }
    }

    /// The indices in the word of the letters that break the pattern or move their chain to an
    /// id that is not the neighbouring one; and the end of the word.
    fn irregular_letters(&self) -> [Option<u32>; 7] {
        let [a, b] = self.x.irregular_steps().map(|step| self.word.index_of_x(step?));
        let [c, d] = self.y.irregular_steps().map(|step| self.word.index_of_y(step?));
        let [e, f] = self.word.swapped_letters();
        [a, b, c, d, e, f, Some(self.word.len())]
    }

    /// Fills `out` with the triangles from index `first` on, none of them irregular.
    fn fill_regular(&self, first: u32, out: &mut [[u32; 3]]) {
        let letter = first - 1;
        let i = self.word.xs_before(letter);
        let edge = [self.x.vertex(i), self.y.vertex(letter - i)];
        match self.word.runs_from(letter) {
            None => alternate(edge, self.word.letter(letter), out),
            Some(runs) => run_by_run(edge, runs, out),
        }
    }
}

/// X and Y in turn from edge (x, y) on, in pairs.
fn alternate([x, y]: [u32; 2], first: Letter, out: &mut [[u32; 3]]) {
    let pair = |k: u32| {
        // The second triangle of the last pair may not exist; then its ids may wrap.
        let (x, y) = (x.wrapping_add(k), y.wrapping_sub(k));
        let (next_x, next_y) = (x.wrapping_add(1), y.wrapping_sub(1));
        match first {
            Letter::X => [[x, next_x, y], [next_x, next_y, y]],
            Letter::Y => [[x, next_y, y], [x, next_x, next_y]],
        }
    };
    let (pairs, rest) = out.as_chunks_mut::<2>();
    if let [one] = rest {
        [*one, _] = pair(pairs.len() as u32);
    }
    for (k, two) in (0..).zip(pairs) {
        *two = pair(k);
    }
}

/// Runs of X from edge (x, y) on, with a Y after each.
fn run_by_run(edge: [u32; 2], mut runs: Runs, out: &mut [[u32; 3]]) {
    let ([mut x, mut y], mut rest) = match runs.longest() {
        2 => short_runs::<3>(edge, &mut runs, out),
        3 => short_runs::<4>(edge, &mut runs, out),
        _ => (edge, out),
    };
    loop {
        let run = rest.len().min(runs.left as usize);
        let (fan, after) = rest.split_at_mut(run);
        for triangle in fan {
            *triangle = [x, x + 1, y];
            x += 1;
        }
        let Some((next, after)) = after.split_first_mut() else { return };
        *next = [x, y - 1, y];
        y -= 1;
        rest = after;
        runs.advance();
    }
}

/// Writes whole runs from edge (x, y) on while `out` has capacity for the longest run and its Y,
/// which are `CAPACITY` triangles. Returns the edge that follows and the rest of `out`.
///
/// A loop that ends after one or two turns costs the processor more than the triangles in it. So
/// this writes each run at full length, and the next run overwrites the excess.
fn short_runs<'a, const CAPACITY: usize>(
    [mut x, mut y]: [u32; 2],
    runs: &mut Runs,
    mut out: &'a mut [[u32; 3]],
) -> ([u32; 2], &'a mut [[u32; 3]]) {
    while let Some(block) = out.first_chunk_mut::<CAPACITY>() {
        for (k, triangle) in (0..).zip(&mut block[..CAPACITY - 1]) {
            // The excess may wrap.
            *triangle = [x.wrapping_add(k), x.wrapping_add(k + 1), y];
        }
        let run = runs.left as usize;
        x += runs.left;
        block[run] = [x, y - 1, y];
        y -= 1;
        out = &mut out[run + 1..];
        runs.advance();
    }
    ([x, y], out)
}
