//! The interval dynamic program: finds triangulations of each piece that can belong to a best one.
//!
//! A chord (i, j) cuts off the piece of boundary from i to j. The rest of the polygon depends on
//! the piece only through its numbers of edges at i and j, and through its [`Merit`]. So a front
//! represents the piece: for each pair of end degrees, the merit of the best triangulation, without
//! those that another one beats in all three respects.
//!
//! ```text
//!         k          the piece of (i, j) = the triangle (i, k, j)
//!        / \                            + the piece of (i, k)
//!       /   \                           + the piece of (k, j),  i < k < j
//!      i-----j
//! ```
//!
//! A piece does not count the edge of its own chord; the pieces that contain it do.

use crate::chords::Chords;
use crate::front::{Grid, State};
use crate::fronts::{Fronts, unfold};
use crate::limits::Capacity;
use crate::measure::min_angle_tangent;
use crate::merit::Merit;
use glam::DVec2;
use mindeg_mesh::Cancelled;
use mindeg_mesh::parallel::map_chunks;
use std::ops::{ControlFlow, Range};

/// The conditions on a triangulation.
#[derive(Clone, Debug)]
pub(crate) struct Rules<'a> {
    pub(crate) points: &'a [DVec2],
    /// The least tangent of an angle.
    pub(crate) threshold: f64,
    /// The capacity of each vertex. Fronts stay small where it is unlimited.
    pub(crate) capacities: Vec<Capacity>,
}

/// The fronts of all pieces.
pub(crate) struct Pieces<'a, M> {
    rules: Rules<'a>,
    vertices: usize,
    fronts: Fronts<State<M>>,
    /// The largest tangent of a triangle that the threshold left out.
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

/// Above this many pairs of degrees at the ends of a piece, it looks which of them occur.
const MANY_CELLS: u64 = 4096;

/// With fewer chords, one thread does all.
const FEW: usize = 4096;

impl<'a, M: Merit> Pieces<'a, M> {
    /// Solves all pieces. O(triples of chords) time, times the product of the fronts' lengths; in
    /// parallel over the chords of each span, with the same result on any number of threads.
    ///
    /// Pieces without a triangulation take no further time. `report` gets the share that is done.
    pub(crate) fn solve(
        rules: Rules<'a>,
        chords: &Chords,
        report: impl Fn(f64) -> Result<(), Cancelled>,
    ) -> Result<Self, Cancelled> {
        let vertices = chords.vertex_count();
        let fronts = Fronts::new(chords, State { at_i: 0, at_j: 0, merit: M::EMPTY });
        let mut pieces = Self { rules, vertices, fronts, left_out: f64::NEG_INFINITY };
        let are_few = chords.len() < FEW;
        let mut grid = Grid::new();
        for span in 2..vertices {
            report(span as f64 / vertices as f64)?;
            let starts = chords.of_span(span);
            if starts.is_empty() {
                continue;
            }
            if are_few || starts.len() <= BATCH {
                for &i in starts {
                    let ends = [i as usize, i as usize + span];
                    let left_out = pieces.fill(&mut grid, ends);
                    pieces.left_out = pieces.left_out.max(left_out);
                    pieces.fronts.put(ends, |states| grid.append_front(states));
                }
                continue;
            }
            let batch = |range: Range<usize>| pieces.batch(&starts[range], span);
            let batches = map_chunks(0..starts.len(), BATCH, batch);
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
            let left_out = self.fill(&mut grid, [start as usize, start as usize + span]);
            grid.append_front(&mut batch.states);
            batch.lens.push((batch.states.len() - before) as u32);
            batch.left_out = batch.left_out.max(left_out);
        }
        batch
    }

    fn add(&mut self, starts: &[u32], span: usize, batch: Batch<M>) {
        let mut rest = &batch.states[..];
        for (&i, len) in starts.iter().zip(batch.lens) {
            let (front, others) = rest.split_at(len as usize);
            rest = others;
            let ends = [i as usize, i as usize + span];
            self.fronts.put(ends, |states| states.extend_from_slice(front));
        }
        self.left_out = self.left_out.max(batch.left_out);
    }

    /// Puts the best merits of the piece from `i` to `j` on the grid of end degrees, and returns
    /// the largest tangent of a triangle that the threshold left out.
    fn fill(&self, grid: &mut Grid<M>, [i, j]: [usize; 2]) -> f64 {
        let [capacity_i, capacity_j] = [i, j].map(|vertex| self.rules.capacities[vertex]);
        // The chord (i, j) itself takes a place beside those of its piece.
        let is_chord = u32::from(j - i < self.vertices - 1);
        let most = |capacity: Capacity| capacity.most().checked_sub(is_chord * capacity.step());
        let window = match (most(capacity_i), most(capacity_j)) {
            (Some(most_at_i), Some(most_at_j)) => self.window([i, j], [most_at_i, most_at_j]),
            _ => None,
        };
        let Some([low, most]) = window else {
            grid.clear([0; 2], [0; 2]);
            return f64::NEG_INFINITY;
        };
        grid.clear(low, most);
        let mut left_out = f64::NEG_INFINITY;
        let mut visit = |apex: usize, pieces: [&[State<M>]; 2]| {
            let triangle = [i, apex, j];
            let fits = |state: State<M>| state.at_i <= most[0] && state.at_j <= most[1];
            if M::ALL_EQUAL {
                // Few triangles add anything, and only these are measured.
                let mut is_new = false;
                self.join(triangle, pieces, |_, _, state| {
                    is_new |= fits(state) && !grid.has(state.at_i, state.at_j);
                });
                if !is_new {
                    return false;
                }
            }
            let corners = self.corners(triangle);
            if self.rules.threshold > 0.0 {
                let tangent = min_angle_tangent(corners);
                if tangent < self.rules.threshold {
                    left_out = left_out.max(tangent);
                    return false;
                }
            }
            let own = M::of_triangle(corners);
            self.join(triangle, pieces, |_, _, state| {
                if fits(state) {
                    grid.offer(State { merit: state.merit.plus(own), ..state });
                }
            });
            // Between the first apex and the last both ends take a chord, and no more is best.
            M::ALL_EQUAL && grid.has(capacity_i.step(), capacity_j.step())
        };
        let mut last_seen = i;
        let flow = self.fronts.meet([i, j], |apex, pieces| {
            last_seen = apex;
            if visit(apex, pieces) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        if flow.is_break()
            && last_seen < j - 1
            && let Some(pieces) = self.fronts.before_last([i, j])
        {
            visit(j - 1, pieces);
        }
        left_out
    }

    /// The least and the largest degrees at the ends of the piece from `i` to `j`, no larger than `most`;
    /// none if there are none. Where all degrees up to `most` are few, it takes these.
    fn window(&self, [i, j]: [usize; 2], most: [u32; 2]) -> Option<[[u32; 2]; 2]> {
        if (u64::from(most[0]) + 1) * (u64::from(most[1]) + 1) <= MANY_CELLS {
            return Some([[0; 2], most]);
        }
        let [step_i, step_j] = [i, j].map(|vertex| self.rules.capacities[vertex].step());
        let (mut low, mut high) = ([u32::MAX; 2], [0; 2]);
        // It visits all.
        let _ = self.fronts.meet([i, j], |apex, [left, right]| {
            let steps = [u32::from(apex > i + 1) * step_i, u32::from(j > apex + 1) * step_j];
            let at_i = left.iter().map(|state| (0, state.at_i));
            let at_j = right.iter().map(|state| (1, state.at_j));
            for (end, chords) in at_i.chain(at_j) {
                let chords = chords + steps[end];
                low[end] = low[end].min(chords);
                high[end] = high[end].max(chords.min(most[end]));
            }
            ControlFlow::Continue(())
        });
        (low[0] <= most[0] && low[1] <= most[1]).then_some([low, high])
    }

    fn corners(&self, triangle: [usize; 3]) -> [DVec2; 3] {
        triangle.map(|vertex| self.rules.points[vertex])
    }

    /// Visits every pair of a state of (i, apex) and a state of (apex, j) that the capacity of the
    /// apex allows, and the state of both together, without the triangle's own merit.
    fn join(
        &self,
        [i, apex, j]: [usize; 3],
        [lefts, rights]: [&[State<M>]; 2],
        mut visit: impl FnMut(State<M>, State<M>, State<M>),
    ) {
        let capacities = &self.rules.capacities;
        let is_left_chord = u32::from(apex > i + 1);
        let is_right_chord = u32::from(j > apex + 1);
        let capacity = capacities[apex];
        for &left in lefts {
            let at_apex = left.at_j + (is_left_chord + is_right_chord) * capacity.step();
            if at_apex > capacity.most() {
                continue;
            }
            for &right in rights {
                let at_apex = at_apex + right.at_i;
                if at_apex > capacity.most() {
                    // Fronts are sorted.
                    break;
                }
                let mut merit = left.merit.plus(right.merit);
                if capacity == Capacity::Limited(at_apex) {
                    merit = merit.with_full_vertex();
                }
                let at_i = left.at_i + is_left_chord * capacities[i].step();
                let at_j = right.at_j + is_right_chord * capacities[j].step();
                visit(left, right, State { at_i, at_j, merit });
            }
        }
    }

    /// The best triangulation of the whole polygon, the piece of the boundary edge (0, n-1), and
    /// its merit; of equals, that with the fewest edges at the ends.
    fn best(&self) -> Option<(State<M>, M)> {
        let last = self.vertices - 1;
        let mut best: Option<(State<M>, M)> = None;
        for &state in self.fronts.whole() {
            let mut merit = state.merit;
            for (vertex, chords) in [(0, state.at_i), (last, state.at_j)] {
                if self.rules.capacities[vertex] == Capacity::Limited(chords) {
                    merit = merit.with_full_vertex();
                }
            }
            if best.is_none_or(|(_, best)| merit > best) {
                best = Some((state, merit));
            }
        }
        best
    }

    /// A best triangulation, every triangle before those beneath it, and its merit; none if the
    /// rules allow none. Of equally good apexes, that with the smallest index. O(n²) times the
    /// product of the fronts' lengths.
    pub(crate) fn triangles(&self) -> Option<(Vec<[u32; 3]>, M)> {
        let (root, merit) = self.best()?;
        Some((unfold(self.vertices, root, |ends, state| self.split(ends, state)), merit))
    }

    /// The first apex of the piece from `i` to `j`, and the states beside it, that make up `whole`.
    fn split(&self, [i, j]: [usize; 2], whole: State<M>) -> Option<(usize, [State<M>; 2])> {
        let mut found = None;
        // It breaks where it has found something.
        let _ = self.fronts.meet([i, j], |apex, pieces| {
            let triangle = [i, apex, j];
            let corners = self.corners(triangle);
            if min_angle_tangent(corners) < self.rules.threshold {
                return ControlFlow::Continue(());
            }
            let own = M::of_triangle(corners);
            self.join(triangle, pieces, |left, right, state| {
                if found.is_none() && (State { merit: state.merit.plus(own), ..state }) == whole {
                    found = Some((apex, [left, right]));
                }
            });
            if found.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        found
    }

    /// The largest tangent of a triangle that the threshold alone left out. If the rules allow no
    /// triangulation, then none of these chords and capacities has a larger minimum tangent.
    ///
    /// Proof: take a triangulation and, of its triangles below the threshold, one with none
    /// beneath it. The fronts of the pieces beneath are as good, so `fill` measured the triangle; or
    /// it had a triangulation of the piece before, with as few chords at the ends. Then that one may
    /// replace this one, and fewer triangles are below the threshold.
    pub(crate) fn left_out(&self) -> f64 {
        self.left_out
    }
}
