//! A triangulation of least cost, where every vertex costs more the more chords it has.
//!
//! The interval dynamic program of [`pieces`](crate::pieces), with costs in place of limits. The
//! state of a piece (i, j) is the number of chords at i and at j; its value is the least cost of
//! all vertices inside and of all triangles. An apex becomes an inner vertex when its two pieces are
//! joined; then all its chords are known, and its cost is final. States that another one beats in
//! both numbers and in cost are left out, which is exact, since no vertex costs less for more
//! chords; so are states that cannot end at or below a known cost.

use crate::chords::Chords;
use crate::fronts::{Fronts, unfold};
use glam::DVec2;
use std::ops::ControlFlow;

/// The largest cost, which no sum of two exceeds in 32 bits.
pub(crate) const MOST: u32 = u32::MAX / 4;

/// The cost of a triangulation.
pub(crate) struct Costs {
    /// No more than this is looked for, [`MOST`] at most.
    pub(crate) bound: u32,
    /// For each vertex, where its costs begin.
    starts: Vec<u32>,
    /// The costs of 0, 1, 2, … chords, up to the bound; that of 0 chords is 0.
    values: Vec<u32>,
}

impl Costs {
    /// The costs of vertices, up to `most[v]` chords each: `cost(v, chords)`, never falling.
    pub(crate) fn new(bound: u32, most: &[u32], cost: impl Fn(usize, u32) -> u32) -> Self {
        let mut costs =
            Self { bound, starts: Vec::with_capacity(most.len() + 1), values: Vec::new() };
        costs.starts.push(0);
        for (vertex, &most) in most.iter().enumerate() {
            let none = cost(vertex, 0);
            let values = (0..=most).map(|chords| cost(vertex, chords).saturating_sub(none));
            costs.values.extend(values.take_while(|&value| value <= bound));
            costs.starts.push(costs.values.len() as u32);
        }
        costs
    }

    fn of(&self, vertex: usize) -> &[u32] {
        &self.values[self.starts[vertex] as usize..self.starts[vertex + 1] as usize]
    }
}

#[derive(Clone, Copy)]
struct State {
    at_i: u16,
    at_j: u16,
    cost: u32,
}

/// The cost of a triangle; `None` if the triangle is not allowed.
pub(crate) type TriangleCost<'a> = &'a dyn Fn([DVec2; 3]) -> Option<u32>;

/// The conditions and costs, and what was solved so far.
struct Pieces<'a> {
    points: &'a [DVec2],
    costs: &'a Costs,
    triangle_cost: TriangleCost<'a>,
    fronts: Fronts<State>,
    /// Pairs of states that were joined: the measure of work.
    steps: u64,
}

/// The triangles of a triangulation of these chords that costs least, each before those beneath it,
/// with its cost; `None` if all cost more than the bound. The first of equals, by ascending apex.
/// `steps` counts the work.
///
/// O(triples of chords), times the square of the number of states.
pub(crate) fn least_cost(
    chords: &Chords,
    points: &[DVec2],
    costs: &Costs,
    triangle_cost: TriangleCost<'_>,
    steps: &mut u64,
) -> Option<(Vec<[u32; 3]>, u32)> {
    let n = chords.vertex_count();
    let fronts = Fronts::new(chords, State { at_i: 0, at_j: 0, cost: 0 });
    let mut pieces = Pieces { points, costs, triangle_cost, fronts, steps: 0 };
    let mut grid = Vec::new();
    for span in 2..n {
        for &i in chords.of_span(span) {
            pieces.solve(&mut grid, i as usize, i as usize + span);
        }
    }
    *steps += pieces.steps;
    pieces.triangles(n)
}

impl Pieces<'_> {
    /// Visits every state of the piece (i, j) with the two states that it is joined from and the
    /// apex, until `visit` breaks. Returns the number of pairs.
    fn join(
        &self,
        [i, j]: [usize; 2],
        mut visit: impl FnMut(usize, [State; 2], State) -> ControlFlow<()>,
    ) -> u64 {
        let mut steps = 0;
        // The number of steps is wanted, whether it breaks or not.
        let _ = self.fronts.meet([i, j], |apex, [lefts, rights]| {
            let corners = [i, apex, j].map(|vertex| self.points[vertex]);
            let Some(own) = (self.triangle_cost)(corners) else {
                return ControlFlow::Continue(());
            };
            let [is_left, is_right] = [apex > i + 1, j > apex + 1].map(u16::from);
            let at_apex = self.costs.of(apex);
            for &left in lefts {
                let before = left.cost.saturating_add(own);
                for &right in rights {
                    steps += 1;
                    let chords = left.at_j + right.at_i + is_left + is_right;
                    let Some(cost) = at_apex.get(usize::from(chords)) else {
                        // The states are sorted by their chords at the apex.
                        break;
                    };
                    let cost = before.saturating_add(right.cost).saturating_add(*cost);
                    let (at_i, at_j) = (left.at_i + is_left, right.at_j + is_right);
                    let state = State { at_i, at_j, cost };
                    if cost <= self.costs.bound {
                        visit(apex, [left, right], state)?;
                    }
                }
            }
            ControlFlow::Continue(())
        });
        steps
    }

    /// Solves the piece (i, j), when all shorter ones are.
    fn solve(&mut self, grid: &mut Vec<u32>, i: usize, j: usize) {
        let is_chord = usize::from(j - i < self.points.len() - 1);
        let costs = self.costs;
        let (costs_i, costs_j) = (costs.of(i), costs.of(j));
        // The chord itself takes a place beside those of its piece.
        let (rows, columns) =
            (costs_i.len().saturating_sub(is_chord), costs_j.len().saturating_sub(is_chord));
        if rows == 0 || columns == 0 {
            return;
        }
        grid.clear();
        grid.resize(rows * columns, u32::MAX);
        let steps = self.join([i, j], |_, _, state| {
            let (row, column) = (usize::from(state.at_i), usize::from(state.at_j));
            if row < rows && column < columns {
                let cell = &mut grid[row * columns + column];
                *cell = state.cost.min(*cell);
            }
            ControlFlow::Continue(())
        });
        self.steps += steps;
        self.fronts.put([i, j], |states| {
            for row in 0..rows {
                let mut least = u32::MAX;
                for column in 0..columns {
                    let at = row * columns + column;
                    let above = if row > 0 { grid[at - columns] } else { u32::MAX };
                    let beside = above.min(least);
                    let cost = grid[at];
                    let (ends_i, ends_j) = (costs_i[row + is_chord], costs_j[column + is_chord]);
                    let whole = cost.saturating_add(ends_i).saturating_add(ends_j);
                    if cost < beside && whole <= costs.bound {
                        let (at_i, at_j) = (row as u16, column as u16);
                        states.push(State { at_i, at_j, cost });
                    }
                    // From now on, the least cost with at most as many chords at both ends.
                    grid[at] = cost.min(beside);
                    least = grid[at];
                }
            }
        });
    }

    fn triangles(&self, n: usize) -> Option<(Vec<[u32; 3]>, u32)> {
        let last = n - 1;
        let total = |state: &State| {
            let (at_first, at_last) = (self.costs.of(0), self.costs.of(last));
            state
                .cost
                .saturating_add(at_first[usize::from(state.at_i)])
                .saturating_add(at_last[usize::from(state.at_j)])
        };
        let root = *self.fronts.whole().iter().min_by_key(|state| total(state))?;
        let triangles = unfold(n, root, |ends, whole| {
            let mut found = None;
            self.join(ends, |apex, pair, state| {
                let is_same = [state.at_i, state.at_j] == [whole.at_i, whole.at_j];
                if is_same && state.cost == whole.cost {
                    found = Some((apex, pair));
                    return ControlFlow::Break(());
                }
                ControlFlow::Continue(())
            });
            found
        });
        Some((triangles, total(&root)))
    }
}
