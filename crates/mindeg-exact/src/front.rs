//! The front of a piece: its triangulations that no other one beats, each as a state.

use crate::merit::Merit;

/// What the rest of the polygon needs to know of one triangulation of a piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct State<M> {
    /// Chords counted at the lower end.
    pub(crate) at_i: u16,
    /// Chords counted at the upper end.
    pub(crate) at_j: u16,
    pub(crate) merit: M,
}

/// The best merit of one piece for every pair of end degrees.
pub(crate) struct Grid<M> {
    width: usize,
    cells: Vec<Option<M>>,
    /// Entry b: the best merit so far with at most b chords at the upper end.
    best_below: Vec<Option<M>>,
}

impl<M: Merit> Grid<M> {
    pub(crate) fn new() -> Self {
        Self { width: 0, cells: Vec::new(), best_below: Vec::new() }
    }

    pub(crate) fn clear(&mut self, most_at_i: u16, most_at_j: u16) {
        self.width = usize::from(most_at_j) + 1;
        self.cells.clear();
        self.cells.resize((usize::from(most_at_i) + 1) * self.width, None);
    }

    pub(crate) fn offer(&mut self, state: State<M>) {
        let cell = &mut self.cells[usize::from(state.at_i) * self.width + usize::from(state.at_j)];
        *cell = (*cell).max(Some(state.merit));
    }

    pub(crate) fn has(&self, at_i: u16, at_j: u16) -> bool {
        let (at_i, at_j) = (usize::from(at_i), usize::from(at_j));
        at_j < self.width && self.cells.get(at_i * self.width + at_j).is_some_and(Option::is_some)
    }

    /// Appends the states that no other one beats, that is, equals with as few chords at either end
    /// and as much merit.
    pub(crate) fn append_front(&mut self, states: &mut Vec<State<M>>) {
        self.best_below.clear();
        self.best_below.resize(self.width, None);
        for (at_i, row) in (0..).zip(self.cells.chunks(self.width)) {
            let mut best = None;
            for (at_j, (cell, below)) in (0..).zip(row.iter().zip(&mut self.best_below)) {
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
            grid.clear(2, 2);
            offers.iter().for_each(|&offer| grid.offer(state(offer)));
            front.clear();
            grid.append_front(&mut front);
            assert!(front.iter().copied().eq(expected.iter().map(|&it| state(it))), "{offers:?}");
        }
    }
}
