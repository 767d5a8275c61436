//! Many triangles of a strip at a time, with no division for each.
//!
//! Nearly everywhere along a strip both chains go on to the neighbouring id and the word keeps to
//! its pattern, so that ids only go up or down by one. The few triangles where that is not so
//! come from their closed form.
//!
//! Limits: finding those few takes a fixed time, so this pays from some tens of triangles on.

use super::Strip;
use crate::word::{Letter, Runs};

impl Strip {
    /// Writes the triangles from number `first` on, as many as `out` holds. There must be so many.
    pub(crate) fn fill(&self, first: u32, out: &mut [[u32; 3]]) {
        let uneven = self.uneven_places();
        let mut done = 0;
        while done < out.len() {
            let number = first + done as u32;
            let even = number.checked_sub(1).and_then(|place| {
                uneven.iter().flatten().filter_map(|uneven| uneven.checked_sub(place)).min()
            });
            match even {
                None | Some(0) => {
                    out[done] = self.triangle(number);
                    done += 1;
                }
                Some(even) => {
                    let end = out.len().min(done + even as usize);
                    self.fill_evenly(number, &mut out[done..end]);
                    done = end;
                }
            }
        }
    }

    /// The places in the word where a letter is out of the pattern or takes its chain to an id
    /// that is not the next one; and the end of the word.
    fn uneven_places(&self) -> [Option<u32>; 7] {
        let [a, b] = self.x.uneven_steps().map(|step| self.word.place_of_x(step?));
        let [c, d] = self.y.uneven_steps().map(|step| self.word.place_of_y(step?));
        let [e, f] = self.word.swapped_places();
        [a, b, c, d, e, f, Some(self.word.len())]
    }

    /// Writes triangles from number `first` on, none of them uneven.
    fn fill_evenly(&self, first: u32, out: &mut [[u32; 3]]) {
        let place = first - 1;
        let i = self.word.xs_before(place);
        let edge = [self.x.vertex(i), self.y.vertex(place - i)];
        match self.word.runs_from(place) {
            None => alternate(edge, self.word.letter(place), out),
            Some(runs) => run_by_run(edge, runs, out),
        }
    }
}

/// X and Y in turn from edge (x, y) on, in pairs.
fn alternate([x, y]: [u32; 2], first: Letter, out: &mut [[u32; 3]]) {
    let pair = |k: u32| {
        // Of the last pair the second triangle may not exist; then its ids may wrap.
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

/// Runs of X, each followed by a Y, from an edge on.
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

/// Whole runs from edge (x, y) on, none longer than `ROOM - 1`, as long as there is room for the
/// longest and its Y. Gives the edge that follows, and what is not filled.
///
/// The processor spends longer on a loop that ends after a turn or two than on its triangles. So
/// each run is written at full length, and what is too much of it written over.
fn short_runs<'a, const ROOM: usize>(
    [mut x, mut y]: [u32; 2],
    runs: &mut Runs,
    mut out: &'a mut [[u32; 3]],
) -> ([u32; 2], &'a mut [[u32; 3]]) {
    while let Some(room) = out.first_chunk_mut::<ROOM>() {
        for (k, triangle) in (0..).zip(&mut room[..ROOM - 1]) {
            // What is too much may wrap.
            *triangle = [x.wrapping_add(k), x.wrapping_add(k + 1), y];
        }
        let run = runs.left as usize;
        x += runs.left;
        room[run] = [x, y - 1, y];
        y -= 1;
        out = &mut out[run + 1..];
        runs.advance();
    }
    ([x, y], out)
}
