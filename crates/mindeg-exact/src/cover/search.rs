//! The search for values that keep all rows: unit propagation, a clause from every conflict.
//!
//! A row counts how many of its literals hold and how many do not; when one of the counts reaches its bound, the
//! others follow. A conflict is traced back to the first literal of its level that implies it with those of
//! earlier levels (the first unique implication point); the clause that says so is learned, and the search goes
//! back to where it has one free literal. Learned clauses watch two of their literals.

use super::decision::Decision;
use super::rows::{Code, Rows};
use crate::progress::Stage;
use mindeg_mesh::Cancelled;

mod heap;
mod learning;
mod restarts;

use heap::Heap;
use restarts::Restarts;

/// The clauses that may be learned before the first are forgotten, and how many more each time.
const FIRST_CLAUSES: usize = 4000;
const MORE_CLAUSES: usize = 1000;

/// The most words that clauses and their origins take: 256 MB.
const MOST_WORDS: usize = 1 << 26;

/// Conflicts from one report of progress to the next.
const REPORT: u64 = 64;

/// Activities are scaled down when they exceed this.
const MOST_ACTIVITY: f64 = 1e100;

/// The variables that the search decides first. Chords first mostly takes fewer steps, but now and then far more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Order {
    /// Chords, the more active before others.
    Chords,
    /// The more active ones, chord or triangle.
    Active,
}

/// Looks for values that keep all rows, at first those of a mesh; takes its steps off those that are left.
pub(super) fn run(
    rows: &Rows<'_>,
    order: Order,
    start: &[Vec<[u32; 3]>],
    left: &mut u64,
    stage: &Stage<'_>,
) -> Result<Decision, Cancelled> {
    let mut search = Search::new(rows, order);
    for variable in rows.variables_of(start) {
        search.phases[variable as usize] = true;
    }
    let most = *left;
    let decision = search.decide(most, stage);
    *left = most.saturating_sub(search.steps);
    decision
}

/// Why a variable has its value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Reason {
    /// The search has decided so.
    Decided,
    /// All other literals of a learned clause are false.
    Clause(u32),
    /// As many literals of a row hold as may.
    Most(u32),
    /// As many literals of a row do not hold as may not.
    Least(u32),
}

/// A learned clause.
struct Clause {
    start: u32,
    len: u32,
    /// Where the clauses and facts from which it was learned begin; they end where those of the next begin.
    origins: u32,
    activity: f64,
    /// The levels that it joined when it was learned.
    levels: u32,
    is_watched: bool,
}

struct Search<'a> {
    rows: &'a Rows<'a>,
    /// For each variable the rows with it: twice the row, and one more where it is negated.
    row_starts: Vec<u32>,
    rows_of: Vec<u32>,
    /// For each row the literals that hold, and those that do not, of the trail up to `head`.
    counts: Vec<[u32; 2]>,
    /// For each literal whether it holds (1), its negation (-1), or neither.
    values: Vec<i8>,
    reasons: Vec<Reason>,
    levels: Vec<u32>,
    positions: Vec<u32>,
    /// The literals that hold, in order.
    trail: Vec<Code>,
    level_starts: Vec<u32>,
    head: usize,
    clauses: Vec<Clause>,
    /// The literals of all clauses ever learned.
    words: Vec<Code>,
    /// Their origins: twice a clause, or twice a variable and one more.
    origins: Vec<u32>,
    watched: usize,
    /// For each literal the clauses that watch it.
    watches: Vec<Vec<u32>>,
    heap: Heap,
    step_of_activity: f64,
    step_of_clauses: f64,
    phases: Vec<bool>,
    /// The values of the longest trail in this calm mode, and its length.
    best: Vec<bool>,
    best_len: usize,
    is_seen: Vec<bool>,
    steps: u64,
}

impl<'a> Search<'a> {
    fn new(rows: &'a Rows<'a>, order: Order) -> Self {
        let (variables, count) = (rows.variable_count(), rows.row_count());
        let mut row_starts = vec![0_u32; variables + 1];
        for row in 0..count as u32 {
            rows.literals(row).iter().for_each(|code| row_starts[*code as usize / 2 + 1] += 1);
        }
        for variable in 0..variables {
            row_starts[variable + 1] += row_starts[variable];
        }
        let mut next = row_starts.clone();
        let mut rows_of = vec![0; row_starts[variables] as usize];
        for row in 0..count as u32 {
            for code in rows.literals(row) {
                let at = &mut next[*code as usize / 2];
                rows_of[*at as usize] = 2 * row + code % 2;
                *at += 1;
            }
        }
        Self {
            rows,
            row_starts,
            rows_of,
            counts: vec![[0; 2]; count],
            values: vec![0; 2 * variables],
            reasons: vec![Reason::Decided; variables],
            levels: vec![0; variables],
            positions: vec![0; variables],
            trail: Vec::with_capacity(variables),
            level_starts: Vec::new(),
            head: 0,
            clauses: Vec::new(),
            words: Vec::new(),
            origins: Vec::new(),
            watched: 0,
            watches: vec![Vec::new(); 2 * variables],
            heap: Heap::new(variables as u32, if order == Order::Chords { rows.chords } else { 0 }),
            step_of_activity: 1.0,
            step_of_clauses: 1.0,
            phases: vec![false; variables],
            best: vec![false; variables],
            best_len: 0,
            is_seen: vec![false; variables],
            steps: 0,
        }
    }

    fn decide(&mut self, most_steps: u64, stage: &Stage<'_>) -> Result<Decision, Cancelled> {
        for row in 0..self.rows.row_count() as u32 {
            let [least, most] = self.rows.bounds(row);
            let len = self.rows.literals(row).len() as u32;
            if len < least {
                return Ok(self.refuted(Reason::Least(row)));
            }
            if most == 0 {
                self.complete(row, false);
            }
            if len == least {
                self.complete(row, true);
            }
            // Rows of one literal may contradict each other.
        }
        let mut restarts = Restarts::new();
        let mut most_clauses = FIRST_CLAUSES;
        loop {
            if let Some(conflict) = self.propagate() {
                if self.level_starts.is_empty() {
                    return Ok(self.refuted(conflict));
                }
                self.keep_if_best();
                restarts.count(self.learn(conflict));
                if restarts.conflicts.is_multiple_of(REPORT) {
                    stage.report(self.steps as f64 / most_steps.max(1) as f64)?;
                }
                if self.steps > most_steps || self.words.len() + self.origins.len() > MOST_WORDS {
                    return Ok(Decision::Unknown);
                }
                continue;
            }
            if restarts.begins_calm() {
                self.back_to(0);
                self.phases.copy_from_slice(&self.best);
                self.best_len = 0;
            }
            if restarts.is_due() {
                self.back_to(0);
            }
            if self.watched > most_clauses {
                most_clauses += MORE_CLAUSES;
                self.forget();
            }
            let Some(variable) = self.heap.pop(|variable| self.values[2 * variable as usize] == 0)
            else {
                let holds = |variable: u32| self.values[2 * variable as usize] == 1;
                return Ok(Decision::Mesh(self.rows.mesh(holds)));
            };
            self.level_starts.push(self.trail.len() as u32);
            let is_negated = u32::from(!self.phases[variable as usize]);
            self.set(2 * variable + is_negated, Reason::Decided);
        }
    }

    /// Keeps the values of the trail if it is the longest.
    fn keep_if_best(&mut self) {
        if self.trail.len() > self.best_len {
            self.best_len = self.trail.len();
            for &code in &self.trail {
                self.best[code as usize / 2] = code.is_multiple_of(2);
            }
        }
    }

    fn value(&self, code: Code) -> i8 {
        self.values[code as usize]
    }

    fn set(&mut self, code: Code, reason: Reason) {
        let variable = code as usize / 2;
        self.values[code as usize] = 1;
        self.values[code as usize ^ 1] = -1;
        self.reasons[variable] = reason;
        self.levels[variable] = self.level_starts.len() as u32;
        self.positions[variable] = self.trail.len() as u32;
        self.trail.push(code);
    }

    /// Sets what is left of a row: all to hold, or none.
    fn complete(&mut self, row: u32, holds: bool) {
        let rows = self.rows;
        let literals = rows.literals(row);
        self.steps += literals.len() as u64;
        let reason = if holds { Reason::Least(row) } else { Reason::Most(row) };
        for &code in literals {
            if self.value(code) == 0 {
                self.set(code ^ u32::from(!holds), reason);
            }
        }
    }

    /// Sets what follows; the row or clause that is broken, if one is.
    fn propagate(&mut self) -> Option<Reason> {
        while let Some(&code) = self.trail.get(self.head) {
            self.head += 1;
            let rows = self.row_starts[code as usize / 2]..self.row_starts[code as usize / 2 + 1];
            self.steps += 1 + rows.len() as u64;
            let mut broken = None;
            for at in rows.clone() {
                let entry = self.rows_of[at as usize];
                let (row, is_lost) = (entry / 2, (entry ^ code) & 1);
                self.counts[row as usize][is_lost as usize] += 1;
                let ([held, lost], [least, most]) =
                    (self.counts[row as usize], self.rows.bounds(row));
                if held > most {
                    broken = Some(Reason::Most(row));
                } else if self.rows.literals(row).len() as u32 - lost < least {
                    broken = Some(Reason::Least(row));
                }
            }
            if broken.is_some() {
                return broken;
            }
            for at in rows {
                let entry = self.rows_of[at as usize];
                let (row, is_lost) = (entry / 2, (entry ^ code) & 1 == 1);
                let ([held, lost], [least, most]) =
                    (self.counts[row as usize], self.rows.bounds(row));
                let len = self.rows.literals(row).len() as u32;
                if held + lost == len {
                    continue;
                }
                if !is_lost && held == most {
                    self.complete(row, false);
                } else if is_lost && len - lost == least {
                    self.complete(row, true);
                }
            }
            let broken = self.propagate_clauses(code ^ 1);
            if broken.is_some() {
                return broken;
            }
        }
        None
    }

    /// Sets what follows from the clauses that watch a literal that has become false.
    fn propagate_clauses(&mut self, code: Code) -> Option<Reason> {
        let mut watching = std::mem::take(&mut self.watches[code as usize]);
        let (mut kept, mut broken) = (0, None);
        for at in 0..watching.len() {
            let index = watching[at];
            watching[kept] = index;
            kept += 1;
            if broken.is_some() {
                continue;
            }
            let Clause { start, len, .. } = self.clauses[index as usize];
            let literals = &mut self.words[start as usize..(start + len) as usize];
            if literals[0] == code {
                literals.swap(0, 1);
            }
            self.steps += 2;
            let first = literals[0];
            if self.values[first as usize] == 1 {
                continue;
            }
            let other = literals[2..].iter().position(|&other| self.values[other as usize] != -1);
            if let Some(other) = other {
                literals.swap(1, other + 2);
                self.steps += other as u64;
                self.watches[literals[1] as usize].push(index);
                kept -= 1;
                continue;
            }
            self.steps += u64::from(len);
            if self.values[first as usize] == -1 {
                broken = Some(Reason::Clause(index));
            } else {
                self.set(first, Reason::Clause(index));
            }
        }
        watching.truncate(kept);
        self.watches[code as usize] = watching;
        broken
    }

    fn raise(&mut self, variable: u32) {
        if self.heap.raise(variable, self.step_of_activity) > MOST_ACTIVITY {
            self.heap.scale(1.0 / MOST_ACTIVITY);
            self.step_of_activity /= MOST_ACTIVITY;
        }
    }

    fn raise_clause(&mut self, index: u32) {
        let clause = &mut self.clauses[index as usize];
        clause.activity += self.step_of_clauses;
        if clause.activity > MOST_ACTIVITY {
            self.clauses.iter_mut().for_each(|clause| clause.activity /= MOST_ACTIVITY);
            self.step_of_clauses /= MOST_ACTIVITY;
        }
    }

    /// Takes back all values of later levels.
    fn back_to(&mut self, level: u32) {
        let Some(&start) = self.level_starts.get(level as usize) else { return };
        self.level_starts.truncate(level as usize);
        for at in (start as usize..self.trail.len()).rev() {
            let code = self.trail[at];
            let variable = code as usize / 2;
            if at < self.head {
                for row in self.row_starts[variable]..self.row_starts[variable + 1] {
                    let entry = self.rows_of[row as usize];
                    self.counts[entry as usize / 2][((entry ^ code) & 1) as usize] -= 1;
                }
            }
            self.values[code as usize] = 0;
            self.values[code as usize ^ 1] = 0;
            self.phases[variable] = code.is_multiple_of(2);
            self.heap.put_back(variable as u32);
        }
        self.trail.truncate(start as usize);
        self.head = self.head.min(start as usize);
    }
}
