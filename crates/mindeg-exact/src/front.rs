//! The front of a piece: its triangulations that no other one beats, each as a state.

use crate::merit::Merit;

/// All that the rest of the polygon needs to know of one triangulation of a piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct State<M> {
    /// Chords counted at the lower end.
    pub(crate) at_i: u32,
    /// Chords counted at the upper end.
    pub(crate) at_j: u32,
    pub(crate) merit: M,
}

/// The best merit of one piece for every pair of end degrees in a window.
pub(crate) struct Grid<M> {
    /// The smallest degrees of the window.
    low: [u32; 2],
    width: usize,
    cells: Vec<Option<M>>,
    /// Entry b: the best merit so far with at most `low[1]` + b chords at the upper end.
    best_below: Vec<Option<M>>,
}

impl<M: Merit> Grid<M> {
    pub(crate) fn new() -> Self {
        Self { low: [0; 2], width: 0, cells: Vec::new(), best_below: Vec::new() }
    }

    /// Empties it for degrees from `low` to `high`.
    pub(crate) fn clear(&mut self, low: [u32; 2], high: [u32; 2]) {
        let [height, width] = [0, 1].map(|end| (high[end] - low[end]) as usize + 1);
        (self.low, self.width) = (low, width);
        self.cells.clear();
        self.cells.resize(height * width, None);
    }

    /// Notes a state of the window.
    pub(crate) fn offer(&mut self, state: State<M>) {
        let (at_i, at_j) =
            ((state.at_i - self.low[0]) as usize, (state.at_j - self.low[1]) as usize);
        if !M::ALL_EQUAL {
            let cell = &mut self.cells[at_i * self.width + at_j];
            *cell = (*cell).max(Some(state.merit));
        } else if !self.has(state.at_i, state.at_j) {
            // All that it beats, too, so that nobody offers that again.
            for row in self.cells.chunks_mut(self.width).skip(at_i) {
                row[at_j..].fill(Some(state.merit));
            }
        }
    }

    /// Whether the piece has a triangulation with these chords at the ends, or, where all are equal,
    /// with no more.
    pub(crate) fn has(&self, at_i: u32, at_j: u32) -> bool {
        let last = [self.cells.len() / self.width - 1, self.width - 1];
        let (Some(at_i), Some(at_j)) =
            (at_i.checked_sub(self.low[0]), at_j.checked_sub(self.low[1]))
        else {
            return false;
        };
        let (at_i, at_j) = (last[0].min(at_i as usize), last[1].min(at_j as usize));
        self.cells[at_i * self.width + at_j].is_some()
    }

    /// Appends the states that no other one beats, that is, equals with as few chords at either end
    /// and as much merit.
    pub(crate) fn append_front(&mut self, states: &mut Vec<State<M>>) {
        self.best_below.clear();
        self.best_below.resize(self.width, None);
        for (at_i, row) in (self.low[0]..).zip(self.cells.chunks(self.width)) {
            let mut best = None;
            for (at_j, (cell, below)) in (self.low[1]..).zip(row.iter().zip(&mut self.best_below)) {
                best = best.max(*below);
                if let Some(merit) = *cell
                    && best < Some(merit)
                {
                    states.push(State { at_i, at_j, merit });
                    best = Some(merit);
                }
                *below = best;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::merit::TieBreak;

    /// Where all triangulations are equal, the front has those with the fewest chords.
    fn check_equal(offers: &[(u32, u32, u64)]) {
        let mut grid = Grid::<()>::new();
        grid.clear([0; 2], [2; 2]);
        offers.iter().for_each(|&(at_i, at_j, _)| grid.offer(State { at_i, at_j, merit: () }));
        let mut front = Vec::new();
        grid.append_front(&mut front);
        for (at_i, at_j) in (0..3).flat_map(|a| (0..3).map(move |b| (a, b))) {
            let beats = |a: u32, b: u32| a <= at_i && b <= at_j;
            let is_beaten = offers.iter().any(|&(a, b, _)| beats(a, b) && (a, b) != (at_i, at_j));
            let is_offered = offers.iter().any(|&(a, b, _)| (a, b) == (at_i, at_j));
            let state = State { at_i, at_j, merit: () };
            assert_eq!(front.contains(&state), is_offered && !is_beaten, "{offers:?}");
            assert_eq!(grid.has(at_i, at_j), is_offered || is_beaten, "{offers:?}");
        }
    }

    #[test]
    fn a_front_has_only_what_nothing_beats() {
        let merit = |shape| TieBreak { full_vertices: 0, shape };
        let state = |(at_i, at_j, shape)| State { at_i, at_j, merit: merit(shape) };
        let mut grid = Grid::new();
        let mut front = Vec::new();
        for (offers, expected) in [
            (&[][..], &[][..]),
            (&[(0, 0, 5), (0, 2, 5), (1, 0, 4), (2, 2, 5)], &[(0, 0, 5)]),
            (&[(1, 1, 7), (0, 2, 5), (2, 0, 6)], &[(0, 2, 5), (1, 1, 7), (2, 0, 6)]),
            (&[(0, 1, 5), (1, 0, 6), (1, 1, 6), (2, 2, 7)], &[(0, 1, 5), (1, 0, 6), (2, 2, 7)]),
            (&[(0, 0, 5), (0, 0, 6), (0, 0, 4)], &[(0, 0, 6)]),
        ] {
            check_equal(offers);
            grid.clear([0; 2], [2; 2]);
            offers.iter().for_each(|&offer| grid.offer(state(offer)));
            front.clear();
            grid.append_front(&mut front);
            assert!(front.iter().copied().eq(expected.iter().map(|&it| state(it))), "{offers:?}");
        }
    }
}
