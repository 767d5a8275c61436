//! The search for values that keep all rows: unit propagation, a clause from every conflict.
//!
//! A row of a vertex counts how many of its literals may still hold; when none may, the others do not. A row of which
//! exactly one holds watches two that may: most triangles that are excluded then cost nothing. A conflict is traced back
//! to the first literal of its level that implies it with those of earlier levels (the first unique implication point);
//! the clause that says so is learned, and the search goes back to where it has one free literal. Learned clauses watch
//! two of their literals, too.

use super::decision::Decision;
use super::rows::{Code, Rows};
use crate::progress::Stage;
use mindeg_mesh::Cancelled;

mod crossing;
mod heap;
mod learning;
mod propagation;
mod restarts;

use crossing::Crossing;
use heap::Heap;
use restarts::Restarts;

/// The clauses that may be learned before the first are forgotten, and how many more each time.
const FIRST_CLAUSES: usize = 4000;
const MORE_CLAUSES: usize = 1000;

/// The most words that clauses and their origins take, 64 MB and 192 MB: a refutation keeps all that it learned.
const MOST_WORDS: usize = 1 << 24;
const MOST_WORDS_OF_REFUTATION: usize = 3 << 24;

/// Conflicts from one report of progress to the next.
const REPORT: u64 = 64;

/// The first row in the lists of what watches a literal; clauses come before. A clause has a word at least.
const FIRST_ROW: u32 = 1 << 31;

/// Activities are scaled down when they exceed this.
const MOST_ACTIVITY: f64 = 1e100;

/// Whether a search expects a mesh or a proof. It decides about chords first, and about the more active of them, and tries:
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Expected {
    /// The last value, at first that of a given mesh.
    Mesh,
    /// That it is used. More follows from that, so the clauses are short.
    Refutation,
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
    /// All other literals of a row of which one holds do not.
    Least(u32),
    /// This literal excludes it: one row has both, or they are chords that cross.
    Excluded(Code),
    /// These two literals exclude each other.
    Both([Code; 2]),
}

/// Why a variable has its value, and when it was set: in which level, and where in the trail.
#[derive(Clone, Copy, Debug)]
struct Given {
    reason: Reason,
    level: u32,
    position: u32,
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

/// A search that can go on where it has stopped.
pub(crate) struct Search<'a> {
    rows: Rows<'a>,
    expected: Expected,
    /// For each variable the rows with it: twice the row, and one more where it is negated.
    row_starts: Vec<u32>,
    rows_of: Vec<u32>,
    /// For each row how many of its literals may hold beyond those of the trail up to `head`; only those of vertices are
    /// counted. A negative number is a conflict.
    rooms: Vec<i32>,
    /// The two literals of each other row that are watched.
    watched_in: Vec<[u32; 2]>,
    /// For each literal whether it holds (1), its negation (-1), or neither.
    values: Vec<i8>,
    /// For each variable that has a value why and when.
    given: Vec<Given>,
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
    /// For each literal the clauses that watch it, and the rows from [`FIRST_ROW`] on, each with another literal: while
    /// that holds, the clause or row does.
    watches: Vec<Vec<[u32; 2]>>,
    heap: Heap,
    step_of_activity: f64,
    step_of_clauses: f64,
    phases: Vec<bool>,
    /// The values of the longest trail in this calm mode, and its length.
    best: Vec<bool>,
    best_len: usize,
    is_seen: Vec<bool>,
    /// Whether the clause that is being learned is known not to imply a value.
    is_stuck: Vec<bool>,
    /// The levels that the clause joins which is being learned.
    joins: Vec<bool>,
    steps: u64,
    restarts: Restarts,
    most_clauses: usize,
    is_begun: bool,
    crossing: Crossing,
}

impl<'a> Search<'a> {
    /// A search that tries the values of a mesh first.
    pub(super) fn new(rows: Rows<'a>, expected: Expected, start: &[Vec<[u32; 3]>]) -> Self {
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
        let room = |row: u32| rows.bounds(row)[1] as i32;
        let mut watches = vec![Vec::new(); 2 * variables];
        for row in 0..count as u32 {
            if let ([1, 1], &[first, second, ..]) = (rows.bounds(row), rows.literals(row)) {
                watches[first as usize].push([FIRST_ROW + row, second]);
                watches[second as usize].push([FIRST_ROW + row, first]);
            }
        }
        let mut phases = vec![false; variables];
        for variable in rows.variables_of(start) {
            phases[variable as usize] = true;
        }
        Self {
            expected,
            row_starts,
            rows_of,
            rooms: (0..count as u32).map(room).collect(),
            watched_in: vec![[0, 1]; count],
            values: vec![0; 2 * variables],
            given: vec![Given { reason: Reason::Decided, level: 0, position: 0 }; variables],
            trail: Vec::with_capacity(variables),
            level_starts: Vec::new(),
            head: 0,
            clauses: Vec::new(),
            words: Vec::new(),
            origins: Vec::new(),
            watched: 0,
            watches,
            heap: Heap::new(variables as u32, rows.chords),
            step_of_activity: 1.0,
            step_of_clauses: 1.0,
            best: phases.clone(),
            phases,
            best_len: 0,
            is_seen: vec![false; variables],
            is_stuck: vec![false; variables],
            joins: Vec::new(),
            // Making the rows takes about as long.
            steps: rows.triangle_count() as u64,
            restarts: Restarts::new(),
            most_clauses: FIRST_CLAUSES,
            is_begun: false,
            crossing: Crossing::new(rows.chords),
            rows,
        }
    }

    /// Goes on until it has decided or the steps are used up, and takes its own off them.
    pub(crate) fn decide(
        &mut self,
        left: &mut u64,
        stage: &Stage<'_>,
    ) -> Result<Decision, Cancelled> {
        // Steps before the first call count, too.
        let before = if self.is_begun { self.steps } else { 0 };
        let decision = self.decide_until(before, before.saturating_add(*left), stage);
        // Without space it never decides.
        *left = if self.is_full() { 0 } else { left.saturating_sub(self.steps - before) };
        decision
    }

    fn is_full(&self) -> bool {
        let most = match self.expected {
            Expected::Mesh => MOST_WORDS,
            Expected::Refutation => MOST_WORDS_OF_REFUTATION,
        };
        self.words.len() + self.origins.len() > most
    }

    /// The conflict of a row that leaves no choice from the start.
    fn begin(&mut self) -> Option<Reason> {
        self.is_begun = true;
        for row in 0..self.rows.row_count() as u32 {
            match (self.rows.bounds(row), self.rows.literals(row)) {
                ([1, 1], []) => return Some(Reason::Least(row)),
                ([1, 1], &[only]) => match self.value(only) {
                    0 => self.set(only, Reason::Least(row)),
                    // Rows of one literal may contradict each other.
                    -1 => return Some(Reason::Least(row)),
                    _ => {}
                },
                ([_, 0], _) => self.fill(row),
                _ => {}
            }
        }
        None
    }

    fn decide_until(
        &mut self,
        before: u64,
        most_steps: u64,
        stage: &Stage<'_>,
    ) -> Result<Decision, Cancelled> {
        if self.is_full() {
            return Ok(Decision::Unknown);
        }
        if !self.is_begun
            && let Some(conflict) = self.begin()
        {
            return Ok(self.refuted(conflict));
        }
        loop {
            if let Some(conflict) = self.propagate() {
                if self.level_starts.is_empty() {
                    return Ok(self.refuted(conflict));
                }
                self.keep_if_best();
                let levels = self.learn(conflict);
                self.restarts.count(levels);
                if self.restarts.conflicts.is_multiple_of(REPORT) {
                    let all = (most_steps - before).max(1) as f64;
                    stage.report((self.steps - before) as f64 / all)?;
                }
                if self.steps > most_steps || self.is_full() {
                    return Ok(Decision::Unknown);
                }
                continue;
            }
            if self.restarts.begins_calm() {
                self.back_to(0);
                self.phases.copy_from_slice(&self.best);
                self.best_len = 0;
            }
            if self.restarts.is_due() {
                self.restart();
            }
            if self.watched > self.most_clauses {
                self.most_clauses += MORE_CLAUSES;
                self.forget();
            }
            let Some(variable) = self.heap.pop(|variable| self.values[2 * variable as usize] == 0)
            else {
                let holds = |variable: u32| self.values[2 * variable as usize] == 1;
                return Ok(Decision::Mesh(self.rows.mesh(holds)));
            };
            self.level_starts.push(self.trail.len() as u32);
            let is_used = self.expected == Expected::Refutation || self.phases[variable as usize];
            let is_negated = u32::from(!is_used);
            self.set(2 * variable + is_negated, Reason::Decided);
        }
    }

    /// Begins anew, but keeps the levels whose decisions would come first again.
    fn restart(&mut self) {
        let Some(next) = self.heap.pop(|variable| self.values[2 * variable as usize] == 0) else {
            return;
        };
        self.heap.put_back(next);
        let is_kept = |&&start: &&u32| self.heap.is_before(self.trail[start as usize] / 2, next);
        let kept = self.level_starts.iter().take_while(is_kept).count();
        self.back_to(kept as u32);
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
        let (level, position) = (self.level_starts.len() as u32, self.trail.len() as u32);
        self.given[variable] = Given { reason, level, position };
        self.trail.push(code);
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
            if at < self.head && code < 2 * self.rows.chords && code.is_multiple_of(2) {
                for at in self.row_starts[variable]..self.row_starts[variable + 1] {
                    self.rooms[self.rows_of[at as usize] as usize / 2] += 1;
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
