//! The triangulations of each piece of a loop that keep degree limits and that no other one beats.

use super::problem::{LoopProblem, MAX_STATES};
use crate::fronts::unfold;
use crate::space::{Cost, cost};
use crate::unsolved::Unsolved;
use glam::DVec3;
use mindeg_mesh::Progress;
use mindeg_mesh::parallel::map_chunks;

/// One triangulation of a piece: what the rest of the loop needs to know of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct State {
    /// Chords within the piece at its first vertex.
    at_i: u16,
    /// Chords within the piece at its last vertex.
    at_j: u16,
    cost: Cost,
}

impl State {
    fn beats(&self, other: &Self) -> bool {
        self.at_i <= other.at_i && self.at_j <= other.at_j && self.cost <= other.cost
    }
}

/// The fronts of all pieces.
pub(super) struct Limited<'a> {
    problem: &'a LoopProblem,
    capacities: &'a [u16],
    /// Entry s: the pieces of s edges.
    spans: Vec<Span>,
}

/// The fronts of all pieces of the same number of edges, one after the other.
#[derive(Default)]
struct Span {
    /// Where the front of each piece starts, and the number of states at the end.
    starts: Vec<usize>,
    states: Vec<State>,
}

/// Pieces that one thread takes at a time.
const CHUNK: usize = 8;

impl<'a> Limited<'a> {
    pub(super) fn solve(
        problem: &'a LoopProblem,
        points: &[DVec3],
        capacities: &'a [u16],
        limit: u32,
        progress: Progress<'_>,
    ) -> Result<Self, Unsolved> {
        let n = points.len();
        let stage = format!("least area under degree limit {limit}");
        let mut all = Self { problem, capacities, spans: vec![Span::default()] };
        let edge = State { at_i: 0, at_j: 0, cost: Cost::NONE };
        all.spans.push(Span { starts: (0..n).collect(), states: vec![edge; n - 1] });
        let mut count = n;
        for span in 2..n {
            progress.report(&stage, span as u64, n as u64)?;
            let chunks = map_chunks(0..n - span, CHUNK, |starts| {
                let mut found = Span::default();
                let mut front = Vec::new();
                for i in starts {
                    found.starts.push(found.states.len());
                    all.set_front(points, i, i + span, &mut front);
                    found.states.extend_from_slice(&front);
                }
                found
            });
            let mut whole = Span::default();
            for chunk in chunks {
                let before = whole.states.len();
                whole.starts.extend(chunk.starts.iter().map(|start| before + start));
                whole.states.extend(chunk.states);
            }
            count += whole.states.len();
            if count > MAX_STATES {
                return Err(Unsolved::Refused(format!(
                    "under degree limit {limit} the search needs more memory than it may take ({} MB); \
                     give another limit",
                    MAX_STATES / 62500
                )));
            }
            whole.starts.push(whole.states.len());
            all.spans.push(whole);
        }
        Ok(all)
    }

    /// The least cost of the whole loop, if any triangulation keeps the limits.
    pub(super) fn best(&self) -> Option<Cost> {
        self.best_state().map(|state| state.cost)
    }

    fn best_state(&self) -> Option<State> {
        let n = self.capacities.len();
        self.front(0, n - 1).iter().copied().min_by_key(|state| state.cost)
    }

    /// A triangulation of least cost; empty if no triangulation exists.
    pub(super) fn triangles(&self, points: &[DVec3]) -> Vec<[u32; 3]> {
        let Some(best) = self.best_state() else { return Vec::new() };
        unfold(self.capacities.len(), best, |[i, j], state| {
            let mut found = None;
            for k in i + 1..j {
                self.combine(points, [i, k, j], Cost::INFINITE, |whole, left, right| {
                    if found.is_none() && whole == state {
                        found = Some((k, [left, right]));
                    }
                });
                if found.is_some() {
                    break;
                }
            }
            found
        })
    }

    fn front(&self, i: usize, j: usize) -> &[State] {
        let span = &self.spans[j - i];
        &span.states[span.starts[i]..span.starts[i + 1]]
    }

    /// The front of the piece from i to j, sorted.
    fn set_front(&self, points: &[DVec3], i: usize, j: usize, front: &mut Vec<State>) {
        front.clear();
        if self.problem.is_excluded(i, j) {
            return;
        }
        for k in i + 1..j {
            // A triangulation with as few chords at the ends as this corner allows, and no more
            // cost than the parts alone, beats all with this corner.
            let low = [usize::from(k - i > 1), usize::from(j - k > 1)].map(|count| count as u16);
            let enough = front
                .iter()
                .filter(|state| state.at_i <= low[0] && state.at_j <= low[1])
                .map(|state| state.cost)
                .min();
            self.combine(points, [i, k, j], enough.unwrap_or(Cost::INFINITE), |whole, _, _| {
                if !front.iter().any(|state| state.beats(&whole)) {
                    front.retain(|state| !whole.beats(state));
                    front.push(whole);
                }
            });
        }
        front.sort_unstable_by_key(|state| (state.at_i, state.at_j));
    }

    /// Calls `take` with each triangulation of the piece from i to j whose triangle at ij has the
    /// third corner k, that keeps the limits, and whose parts cost less than `enough`; and with its
    /// parts.
    fn combine(
        &self,
        points: &[DVec3],
        [i, k, j]: [usize; 3],
        enough: Cost,
        mut take: impl FnMut(State, State, State),
    ) {
        let (lefts, rights) = (self.front(i, k), self.front(k, j));
        if lefts.is_empty() || rights.is_empty() {
            return;
        }
        let is_chord = |a: usize, b: usize| b - a > 1 && (a, b) != (0, self.capacities.len() - 1);
        let [own, left_chord, right_chord] =
            [(i, j), (i, k), (k, j)].map(|(a, b)| u16::from(is_chord(a, b)));
        let at = |vertex: usize| self.capacities[vertex];
        // The chord ij itself takes a place at both of its ends.
        let (Some(most_i), Some(most_j)) = (at(i).checked_sub(own), at(j).checked_sub(own)) else {
            return;
        };
        let mut triangle = None;
        for left in lefts.iter().filter(|left| left.at_i + left_chord <= most_i) {
            for right in rights.iter().filter(|right| right.at_j + right_chord <= most_j) {
                let sides = left.cost.plus(right.cost);
                if left.at_j + right.at_i + left_chord + right_chord > at(k) || sides >= enough {
                    continue;
                }
                let triangle =
                    *triangle.get_or_insert_with(|| cost(points[i], points[k], points[j]));
                let whole = State {
                    at_i: left.at_i + left_chord,
                    at_j: right.at_j + right_chord,
                    cost: sides.plus(triangle),
                };
                take(whole, *left, *right);
            }
        }
    }
}
