//! The interval dynamic program: which triangulations of each piece can be part of a best one.
//!
//! A chord (i, j) cuts off the piece of boundary from i to j. What is beyond the chord sees the
//! piece only through the number of edges it has at i and at j, and through its [`Merit`]. So a
//! piece is represented by a front: of the triangulations with each pair of end degrees the
//! merit of the best, without those that another one beats in all three respects.
//!
//! The chord's own edge is counted by the pieces that it is part of, not by its own.

use crate::chords::{Chords, Lists, meet};
use crate::measure::min_angle_tangent;
use crate::merit::Merit;
use crate::progress::Stopped;
use glam::DVec2;
use rayon::prelude::*;
use std::ops::ControlFlow;

/// What a triangulation must keep to.
#[derive(Clone, Debug)]
pub(crate) struct Rules<'a> {
    pub(crate) points: &'a [DVec2],
    /// The least tangent of an angle.
    pub(crate) threshold: f64,
    /// Of each vertex, how many chords it may have, and whether they are counted at all.
    /// Not counting at vertices that can never have too many keeps fronts small.
    pub(crate) rooms: Vec<Room>,
}

/// How many chords a vertex may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Room {
    For(u16),
    Unlimited,
}

impl Room {
    /// What one more chord adds to the count.
    fn step(self) -> u16 {
        u16::from(self != Self::Unlimited)
    }

    /// The largest count.
    fn most(self) -> u16 {
        if let Self::For(chords) = self { chords } else { 0 }
    }
}

/// One triangulation of a piece, as the rest sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct State<M> {
    /// Chords counted at the lower end.
    at_i: u16,
    /// Chords counted at the upper end.
    at_j: u16,
    merit: M,
}

/// Where the front of the piece between a vertex and `other` is in the list of all states.
#[derive(Clone, Copy, Default)]
struct Front {
    other: u32,
    start: u32,
    len: u32,
}

/// The fronts of all pieces.
pub(crate) struct Pieces<'a, M> {
    rules: Rules<'a>,
    vertices: usize,
    states: Vec<State<M>>,
    /// Of each vertex the pieces that begin there and can be triangulated, by ascending end.
    up: Lists<Front>,
    /// Of each vertex the pieces that end there and can be triangulated, by descending begin.
    down: Lists<Front>,
    /// The largest tangent below the threshold of a triangle that was left out for it.
    left_out: f64,
}

/// The work on some chords of one span.
struct Batch<M> {
    lens: Vec<u32>,
    states: Vec<State<M>>,
    left_out: f64,
}

/// How many chords make a batch: enough to be worth handing to a thread.
const BATCH: usize = 16;

/// So few chords are not worth it at all.
const FEW: usize = 4096;

impl<'a, M: Merit> Pieces<'a, M> {
    /// Solves all pieces. O(triples of chords) time, times the product of the fronts' lengths; in
    /// parallel over the chords of each span, with the same result on any number of threads.
    ///
    /// Pieces that cannot be triangulated take no further time.
    pub(crate) fn solve(
        rules: Rules<'a>,
        chords: &Chords,
        mut watch: impl FnMut(f64) -> Result<(), Stopped>,
    ) -> Result<Self, Stopped> {
        let vertices = chords.vertex_count();
        let states = vec![State { at_i: 0, at_j: 0, merit: M::EMPTY }];
        let [up, down] = chords.end_counts().map(|counts| Lists::new(&counts));
        let mut pieces = Self { rules, vertices, states, up, down, left_out: f64::NEG_INFINITY };
        for i in 0..vertices as u32 - 1 {
            pieces.put_front(i, i + 1, 0, 1);
        }
        let are_few = chords.len() < FEW;
        let mut grid = Grid::new();
        for span in 2..vertices {
            watch(span as f64 / vertices as f64)?;
            let starts = chords.of_span(span);
            if starts.is_empty() {
                continue;
            }
            if are_few || starts.len() <= BATCH {
                for &i in starts {
                    let j = i + span as u32;
                    let left_out = pieces.fill(&mut grid, i as usize, j as usize);
                    pieces.left_out = pieces.left_out.max(left_out);
                    let start = pieces.states.len();
                    grid.append_front(&mut pieces.states);
                    let len = pieces.states.len() - start;
                    if len > 0 {
                        pieces.put_front(i, j, start as u32, len as u32);
                    }
                }
                continue;
            }
            let work = |starts: &[u32]| pieces.batch(starts, span);
            let batches: Vec<Batch<M>> = starts.par_chunks(BATCH).map(work).collect();
            for (starts, batch) in starts.chunks(BATCH).zip(batches) {
                pieces.add(starts, span, batch);
            }
        }
        Ok(pieces)
    }

    fn batch(&self, starts: &[u32], span: usize) -> Batch<M> {
        let mut grid = Grid::new();
        let mut batch = Batch { lens: Vec::new(), states: Vec::new(), left_out: f64::NEG_INFINITY };
        for &start in starts {
            let before = batch.states.len();
            let (i, j) = (start as usize, start as usize + span);
            let left_out = self.fill(&mut grid, i, j);
            grid.append_front(&mut batch.states);
            batch.lens.push((batch.states.len() - before) as u32);
            batch.left_out = batch.left_out.max(left_out);
        }
        batch
    }

    fn add(&mut self, starts: &[u32], span: usize, batch: Batch<M>) {
        let mut start = self.states.len() as u32;
        for (&i, len) in starts.iter().zip(batch.lens) {
            if len > 0 {
                self.put_front(i, i + span as u32, start, len);
            }
            start += len;
        }
        self.states.extend(batch.states);
        self.left_out = self.left_out.max(batch.left_out);
    }

    fn put_front(&mut self, i: u32, j: u32, start: u32, len: u32) {
        self.up.push(i, Front { other: j, start, len });
        self.down.push(j, Front { other: i, start, len });
    }

    fn states(&self, front: &Front) -> &[State<M>] {
        &self.states[front.start as usize..][..front.len as usize]
    }

    /// Puts the best merits of the piece from `i` to `j` on the grid of end degrees, and gives
    /// the largest tangent of a triangle left out.
    fn fill(&self, grid: &mut Grid<M>, i: usize, j: usize) -> f64 {
        let [room_i, room_j] = [i, j].map(|vertex| self.rules.rooms[vertex]);
        // A chord has to fit beside those of its piece.
        let is_chord = u16::from(j - i < self.vertices - 1);
        let most = |room: Room| room.most().checked_sub(is_chord * room.step());
        let (Some(most_at_i), Some(most_at_j)) = (most(room_i), most(room_j)) else {
            grid.clear(0, 0);
            return f64::NEG_INFINITY;
        };
        grid.clear(most_at_i, most_at_j);
        let mut left_out = f64::NEG_INFINITY;
        let mut visit = |left: &Front, right: &Front| {
            let apex = left.other as usize;
            let corners = self.corners([i, apex, j]);
            let tangent = min_angle_tangent(corners);
            if tangent < self.rules.threshold {
                left_out = left_out.max(tangent);
                return false;
            }
            let own = M::of_triangle(corners);
            let pieces = [self.states(left), self.states(right)];
            self.join([i, apex, j], pieces, |_, _, state| {
                if state.at_i <= most_at_i && state.at_j <= most_at_j {
                    grid.offer(State { merit: state.merit.plus(own), ..state });
                }
            });
            // Between the first apex and the last both ends take a chord, and no more is best.
            M::ALL_EQUAL && grid.has(room_i.step(), room_j.step())
        };
        let (up, down) = (self.up.of(i as u32), self.down.of(j as u32));
        let mut last_seen = i;
        let mut is_settled = false;
        meet(
            up,
            down,
            |front| front.other,
            |left, right| {
                last_seen = left.other as usize;
                is_settled = visit(left, right);
                if is_settled { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            },
        );
        if is_settled
            && last_seen < j - 1
            && let (Some(left), Some(right)) = (up.last(), down.first())
            && left.other as usize == j - 1
        {
            visit(left, right);
        }
        left_out
    }

    fn corners(&self, triangle: [usize; 3]) -> [DVec2; 3] {
        triangle.map(|vertex| self.rules.points[vertex])
    }

    /// Visits every pair of a state of (i, apex) and a state of (apex, j) that leave the apex
    /// within its room, and what they make together, the triangle's own merit aside.
    fn join(
        &self,
        [i, apex, j]: [usize; 3],
        [lefts, rights]: [&[State<M>]; 2],
        mut visit: impl FnMut(State<M>, State<M>, State<M>),
    ) {
        let rooms = &self.rules.rooms;
        let is_left_chord = u16::from(apex > i + 1);
        let is_right_chord = u16::from(j > apex + 1);
        let room = rooms[apex];
        for &left in lefts {
            let at_apex = left.at_j + (is_left_chord + is_right_chord) * room.step();
            if at_apex > room.most() {
                continue;
            }
            for &right in rights {
                let at_apex = at_apex + right.at_i;
                if at_apex > room.most() {
                    // Fronts are sorted.
                    break;
                }
                let mut merit = left.merit.plus(right.merit);
                if room == Room::For(at_apex) {
                    merit = merit.with_full_vertex();
                }
                let at_i = left.at_i + is_left_chord * rooms[i].step();
                let at_j = right.at_j + is_right_chord * rooms[j].step();
                visit(left, right, State { at_i, at_j, merit });
            }
        }
    }

    /// The best whole triangulation as the piece of all but one boundary edge, and its merit;
    /// of equals the one with the fewest edges at the ends.
    fn best(&self) -> Option<(State<M>, M)> {
        let last = self.vertices - 1;
        let whole = self.up.of(0).last().filter(|front| front.other as usize == last)?;
        let mut best: Option<(State<M>, M)> = None;
        for &state in self.states(whole) {
            let mut merit = state.merit;
            for (vertex, chords) in [(0, state.at_i), (last, state.at_j)] {
                if self.rules.rooms[vertex] == Room::For(chords) {
                    merit = merit.with_full_vertex();
                }
            }
            if best.is_none_or(|(_, best)| merit > best) {
                best = Some((state, merit));
            }
        }
        best
    }

    /// A best triangulation, every triangle before those beneath it, and its merit; none where the rules
    /// allow none. Of equally good apexes the one with the smallest index is taken. O(n²)
    /// times the product of the fronts' lengths.
    pub(crate) fn triangles(&self) -> Option<(Vec<[u32; 3]>, M)> {
        let (root, merit) = self.best()?;
        let mut triangles = Vec::with_capacity(self.vertices - 2);
        let mut open = vec![(0, self.vertices - 1, root)];
        while let Some((i, j, state)) = open.pop() {
            if j == i + 1 {
                continue;
            }
            let (apex, left, right) =
                self.split(i, j, state).expect("a state of a piece comes from one of its apexes");
            triangles.push([i, apex, j].map(|vertex| vertex as u32));
            open.extend([(apex, j, right), (i, apex, left)]);
        }
        Some((triangles, merit))
    }

    /// The first apex of the piece from `i` to `j`, and the states beside it, that make up `whole`.
    fn split(&self, i: usize, j: usize, whole: State<M>) -> Option<(usize, State<M>, State<M>)> {
        let mut found = None;
        let (up, down) = (self.up.of(i as u32), self.down.of(j as u32));
        // The lists have pieces of larger spans, too, by now.
        let up = &up[..up.partition_point(|front| (front.other as usize) < j)];
        let down = &down[..down.partition_point(|front| front.other as usize > i)];
        meet(
            up,
            down,
            |front| front.other,
            |left, right| {
                let triangle = [i, left.other as usize, j];
                let corners = self.corners(triangle);
                if min_angle_tangent(corners) < self.rules.threshold {
                    return ControlFlow::Continue(());
                }
                let own = M::of_triangle(corners);
                let pieces = [self.states(left), self.states(right)];
                self.join(triangle, pieces, |left, right, state| {
                    if found.is_none() && (State { merit: state.merit.plus(own), ..state }) == whole
                    {
                        found = Some((triangle[1], left, right));
                    }
                });
                if found.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            },
        );
        found
    }

    /// The largest tangent below the threshold of a triangle that only the threshold kept out;
    /// where there is no triangulation, none of these chords within these rooms has all angles
    /// larger than that.
    ///
    /// For take one, and of its triangles below the threshold one with none beneath it. The
    /// pieces beneath have fronts here that are as good, so the triangle was looked at; or else
    /// its piece was settled before with as few chords at the ends, and may be exchanged for
    /// that, which leaves fewer triangles to take.
    pub(crate) fn left_out(&self) -> f64 {
        self.left_out
    }
}

/// The best merit for every pair of end degrees of one piece.
struct Grid<M> {
    width: usize,
    cells: Vec<Option<M>>,
    /// Entry b: the best merit so far with at most b chords at the upper end.
    best_below: Vec<Option<M>>,
}

impl<M: Merit> Grid<M> {
    fn new() -> Self {
        Self { width: 0, cells: Vec::new(), best_below: Vec::new() }
    }

    fn clear(&mut self, most_at_i: u16, most_at_j: u16) {
        self.width = usize::from(most_at_j) + 1;
        self.cells.clear();
        self.cells.resize((usize::from(most_at_i) + 1) * self.width, None);
    }

    fn offer(&mut self, state: State<M>) {
        let cell = &mut self.cells[usize::from(state.at_i) * self.width + usize::from(state.at_j)];
        *cell = (*cell).max(Some(state.merit));
    }

    fn has(&self, at_i: u16, at_j: u16) -> bool {
        let (at_i, at_j) = (usize::from(at_i), usize::from(at_j));
        at_j < self.width && self.cells.get(at_i * self.width + at_j).is_some_and(Option::is_some)
    }

    /// Appends the states that no other one beats: with as few chords at either end and as
    /// much merit.
    fn append_front(&mut self, states: &mut Vec<State<M>>) {
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
