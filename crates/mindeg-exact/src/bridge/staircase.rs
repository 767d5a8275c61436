//! The best closed staircase on a torus whose runs keep limits.
//!
//! Step X from the edge (i, j) leads to (i + 1, j), step Y to (i, j + 1); p steps X and q steps Y
//! lead round. Each closed staircase comes to j = 0 by a step Y, at one i: so all of them start
//! there, one start after the other. The run of steps Y in which a start lies is cut in two. Its
//! part before the cut is guessed, from one step up; in the end the real one may not be longer.
//!
//! All steps X in one run, then all steps Y, would come to the same edge twice. Limits on runs
//! exclude that; without limits, the state is how often the kind of step has changed.

use mindeg_mesh::{Cancelled, Progress};

/// The cost of a step that is not allowed, and of no staircase.
pub(super) const BLOCKED: u64 = u64::MAX;

/// The number of states without limits on runs.
const UNLIMITED: usize = 5;

/// The cost of each step.
pub(super) struct Steps {
    p: usize,
    q: usize,
    /// Steps X, then steps Y, each at i q + j.
    costs: [Vec<u64>; 2],
}

impl Steps {
    pub(super) fn blocked(p: usize, q: usize) -> Self {
        Self { p, q, costs: [vec![BLOCKED; p * q], vec![BLOCKED; p * q]] }
    }

    pub(super) fn set(&mut self, is_x: bool, i: usize, j: usize, cost: u64) {
        self.costs[usize::from(!is_x)][i * self.q + j] = cost;
    }

    /// These steps, where those of others cost no more than `most`; elsewhere none.
    pub(super) fn only_where(&self, others: &Self, most: u64) -> Self {
        let costs = [0, 1].map(|kind| {
            let pairs = self.costs[kind].iter().zip(&others.costs[kind]);
            pairs.map(|(&own, &other)| if other <= most { own } else { BLOCKED }).collect()
        });
        Self { costs, ..*self }
    }

    fn cost(&self, kind: usize, i: usize, j: usize) -> u64 {
        self.costs[kind][i * self.q + j]
    }
}

/// The longest runs: of steps Y at each i, of steps X at each j.
pub(super) struct Capacities {
    pub(super) x: Vec<u32>,
    pub(super) y: Vec<u32>,
    /// Whether each vertex may have its first edge.
    pub(super) is_possible: bool,
}

/// A closed staircase.
#[derive(Clone, Debug)]
pub(super) struct Path {
    pub(super) cost: u64,
    /// It starts from the edge (start, 0).
    start: usize,
    /// Whether each step is X.
    steps: Vec<bool>,
}

impl Path {
    /// The edges that the steps start from, as vertices; those of the y ring follow the x ring's.
    pub(super) fn edges(&self, p: usize, q: usize) -> impl Iterator<Item = [usize; 2]> {
        let (mut i, mut j) = (self.start, 0);
        self.steps.iter().map(move |&is_x| {
            let edge = [i, p + j];
            if is_x {
                i = (i + 1) % p;
            } else {
                j = (j + 1) % q;
            }
            edge
        })
    }

    pub(super) fn triangles(&self, p: usize, q: usize) -> Vec<[u32; 3]> {
        let steps = self.edges(p, q).zip(&self.steps);
        let triangle = |([x, y], &is_x): ([usize; 2], &bool)| {
            if is_x { [x, (x + 1) % p, y] } else { [x, p + (y - p + 1) % q, y] }
        };
        steps.map(|step| triangle(step).map(|vertex| vertex as u32)).collect()
    }
}

/// A search for the staircase of least cost.
pub(super) struct Search<'a> {
    pub(super) steps: &'a Steps,
    /// None for runs of any length.
    pub(super) capacities: Option<&'a Capacities>,
    /// The starts, in the order in which they are tried.
    pub(super) starts: &'a [u32],
    /// Whether costs add up; else the largest counts.
    pub(super) add: bool,
}

impl Search<'_> {
    /// The numbers of states after a step Y and after a step X: with limits, the lengths of the
    /// current run, from 1; without, see [`next`](Self::next).
    fn widths(&self) -> [usize; 2] {
        let longest = |runs: &[u32]| runs.iter().copied().max().unwrap_or(1).max(1) as usize;
        self.capacities
            .map_or([3, 2], |capacities| [longest(&capacities.x), longest(&capacities.y)])
    }

    /// The number of states that are kept.
    pub(super) fn table_len(&self) -> u64 {
        let [ys, xs] = self.widths();
        (self.steps.p as u64 + 1) * (self.steps.q as u64 + 1) * (ys + xs) as u64
    }

    /// The number of states that could be visited.
    pub(super) fn most_steps(&self) -> u64 {
        let cuts = self.capacities.map_or(self.steps.p as u64, |capacities| {
            capacities.x.iter().map(|&run| u64::from(run)).sum()
        });
        self.table_len().saturating_mul(cuts)
    }

    /// The first staircase of least cost, if there is one.
    pub(super) fn best(&self, progress: Progress<'_>) -> Result<Option<Path>, Cancelled> {
        if self.capacities.is_some_and(|capacities| !capacities.is_possible) {
            return Ok(None);
        }
        let len = usize::try_from(self.table_len()).expect("longer tables are refused before");
        let mut table = vec![BLOCKED; len];
        let mut best = (BLOCKED, None);
        for (done, &start) in self.starts.iter().enumerate() {
            progress.report("looking for a strip", done as u64, self.starts.len() as u64)?;
            let start = start as usize;
            for before in 1..=self.capacities.map_or(1, |capacities| capacities.x[start] as usize) {
                if let Some((cost, _)) = self.best_from(start, before, best.0, &mut table) {
                    best = (cost, Some((start, before)));
                }
            }
        }
        Ok(best.1.and_then(|(start, before)| {
            let (cost, end) = self.best_from(start, before, best.0 + 1, &mut table)?;
            Some(Path { cost, start, steps: self.steps_back(start, before, end, &table) })
        }))
    }

    /// The least cost below `bound` of a staircase from a start with `before` steps Y behind it,
    /// and the state in which it ends. Sets the reached entries of the table.
    fn best_from(
        &self,
        start: usize,
        before: usize,
        bound: u64,
        table: &mut [u64],
    ) -> Option<(u64, usize)> {
        let (p, q) = (self.steps.p, self.steps.q);
        let [ys, xs] = self.widths();
        let width = ys + xs;
        let row = (q + 1) * width;
        table[..row].fill(BLOCKED);
        table[before - 1] = 0;
        for di in 0..=p {
            let i = (start + di) % p;
            let (rows, rest) = table[di * row..].split_at_mut(row);
            if di < p {
                rest[..row].fill(BLOCKED);
            }
            let mut is_reached = false;
            for dj in 0..=q {
                let j = dj % q;
                // Of runs of one kind, a longer one must cost less to be of use.
                let mut least = [bound; UNLIMITED];
                for state in 0..width {
                    let cost = rows[dj * width + state];
                    let kind = match self.capacities {
                        Some(_) => usize::from(state >= ys),
                        None => state,
                    };
                    if cost >= least[kind] {
                        continue;
                    }
                    least[kind] = cost;
                    is_reached = true;
                    if di < p
                        && let Some(next) = self.next(state, true, i, j)
                    {
                        let whole = self.join(cost, self.steps.cost(0, i, j));
                        let place = &mut rest[dj * width + next];
                        *place = whole.min(*place);
                    }
                    if dj < q
                        && let Some(next) = self.next(state, false, i, j)
                    {
                        let whole = self.join(cost, self.steps.cost(1, i, j));
                        let place = &mut rows[(dj + 1) * width + next];
                        *place = whole.min(*place);
                    }
                }
            }
            if !is_reached {
                return None;
            }
        }
        let end = p * row + q * width;
        let ends = if self.capacities.is_some() { 0..before.min(ys) } else { 2..3 };
        let ends = ends.map(|state| (table[end + state], state));
        ends.min().filter(|&(cost, _)| cost < bound)
    }

    /// The state after a step, if runs may be so long.
    ///
    /// With limits, states are the lengths of runs of steps Y from 1, then those of steps X.
    /// Without, they are: in the first run of steps Y; in the second; in a later one; in the first
    /// run of steps X; in a later one. A staircase ends in the third of these, or its steps X were
    /// all in one run.
    fn next(&self, state: usize, is_x: bool, i: usize, j: usize) -> Option<usize> {
        let [ys, _] = self.widths();
        let Some(capacities) = self.capacities else {
            let [after_y, after_x] = [[0, 1, 2, 1, 2], [3, 4, 4, 3, 4]];
            return Some(if is_x { after_x[state] } else { after_y[state] });
        };
        let (first, capacity) = if is_x { (ys, capacities.y[j]) } else { (0, capacities.x[i]) };
        let goes_on = (state >= ys) == is_x;
        let run = if goes_on { state - first + 2 } else { 1 };
        (run <= capacity as usize).then(|| first + run - 1)
    }

    fn join(&self, a: u64, b: u64) -> u64 {
        if self.add { a.saturating_add(b) } else { a.max(b) }
    }

    /// The steps of the staircase that ends in a state, from the table of its start.
    fn steps_back(&self, start: usize, before: usize, end: usize, table: &[u64]) -> Vec<bool> {
        let (p, q) = (self.steps.p, self.steps.q);
        let width = self.widths().iter().sum::<usize>();
        let at = |di: usize, dj: usize, state: usize| table[(di * (q + 1) + dj) * width + state];
        let (mut di, mut dj, mut state) = (p, q, end);
        let mut steps = Vec::with_capacity(p + q);
        while (di, dj, state) != (0, 0, before - 1) {
            let cost = at(di, dj, state);
            let mut found = None;
            for is_x in [true, false] {
                let Some(from_i) = di.checked_sub(usize::from(is_x)) else { continue };
                let Some(from_j) = dj.checked_sub(usize::from(!is_x)) else { continue };
                let (i, j) = ((start + from_i) % p, from_j % q);
                let step = self.steps.cost(usize::from(!is_x), i, j);
                let leads_here = |from: &usize| {
                    let before = at(from_i, from_j, *from);
                    before != BLOCKED
                        && self.next(*from, is_x, i, j) == Some(state)
                        && self.join(before, step) == cost
                };
                found =
                    found.or((0..width).find(leads_here).map(|from| (is_x, from_i, from_j, from)));
            }
            // Each cost in the table came from such a state.
            let Some((is_x, from_i, from_j, from)) = found else { break };
            steps.push(is_x);
            (di, dj, state) = (from_i, from_j, from);
        }
        steps.reverse();
        steps
    }
}
