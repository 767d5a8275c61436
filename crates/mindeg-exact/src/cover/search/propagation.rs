//! Sets what follows from rows, chords that cross, and clauses.

use super::{Clause, Code, FIRST_ROW, Reason, Search};

impl Search<'_> {
    /// Sets all that is left of the row of a vertex not to hold.
    pub(super) fn fill(&mut self, row: u32) {
        let len = self.rows.literals(row).len();
        self.steps += len as u64;
        for at in 0..len {
            let code = self.rows.literals(row)[at];
            if self.value(code) == 0 {
                self.set(code ^ 1, Reason::Most(row));
            }
        }
    }

    /// Sets what follows; the row or clause that is broken, if one is.
    pub(super) fn propagate(&mut self) -> Option<Reason> {
        while let Some(&code) = self.trail.get(self.head) {
            self.head += 1;
            // One to set it, one to take it back.
            self.steps += 2;
            let is_chord = code < 2 * self.rows.chords;
            let is_used = code.is_multiple_of(2);
            let mut broken = None;
            if is_chord && is_used {
                broken = self.count(code).or_else(|| self.exclude_crossing(code / 2));
            } else if is_chord || is_used {
                broken = self.exclude_others(code);
            }
            broken = broken.or_else(|| self.propagate_watches(code ^ 1));
            if broken.is_some() {
                return broken;
            }
        }
        None
    }

    /// Counts a chord that is used at its vertices.
    fn count(&mut self, code: Code) -> Option<Reason> {
        let rows = self.row_starts[code as usize / 2]..self.row_starts[code as usize / 2 + 1];
        let mut broken = None;
        // The literals of its sides are counted, too: all are taken back alike.
        for at in rows.clone() {
            let entry = self.rows_of[at as usize];
            self.rooms[entry as usize / 2] -= 1;
            if entry.is_multiple_of(2) && self.rooms[entry as usize / 2] < 0 {
                broken = Some(Reason::Most(entry / 2));
            }
        }
        if broken.is_some() {
            return broken;
        }
        for at in rows {
            let entry = self.rows_of[at as usize];
            if entry.is_multiple_of(2) && self.rooms[entry as usize / 2] == 0 {
                self.fill(entry / 2);
            }
        }
        None
    }

    /// Excludes the others of rows of which this literal is the one that holds; the conflict if another does.
    fn exclude_others(&mut self, code: Code) -> Option<Reason> {
        for at in self.row_starts[code as usize / 2]..self.row_starts[code as usize / 2 + 1] {
            let entry = self.rows_of[at as usize];
            if (entry ^ code) & 1 == 1 {
                continue;
            }
            let len = self.rows.literals(entry / 2).len();
            self.steps += len as u64;
            for at in 0..len {
                let other = self.rows.literals(entry / 2)[at];
                match self.value(other) {
                    0 => self.set(other ^ 1, Reason::Excluded(code)),
                    1 if other != code => return Some(Reason::Both([code, other])),
                    _ => {}
                }
            }
        }
        None
    }

    /// Sets what follows from the rows and clauses that watch a literal that has become false.
    fn propagate_watches(&mut self, code: Code) -> Option<Reason> {
        if self.watches[code as usize].is_empty() {
            return None;
        }
        let mut watching = std::mem::take(&mut self.watches[code as usize]);
        self.steps += watching.len() as u64;
        let (mut kept, mut broken) = (0, None);
        for at in 0..watching.len() {
            let [index, other] = watching[at];
            watching[kept] = watching[at];
            kept += 1;
            if broken.is_some() || self.values[other as usize] == 1 {
                continue;
            }
            let (other, next) = match index.checked_sub(FIRST_ROW) {
                Some(row) => self.watch_next_of_row(row, code),
                None => self.watch_next_of_clause(index, code),
            };
            watching[kept - 1] = [index, other];
            if let Some(next) = next {
                self.watches[next as usize].push([index, other]);
                kept -= 1;
                continue;
            }
            let reason = match index.checked_sub(FIRST_ROW) {
                Some(row) => Reason::Least(row),
                None => Reason::Clause(index),
            };
            match self.values[other as usize] {
                0 => self.set(other, reason),
                -1 => broken = Some(reason),
                _ => {}
            }
        }
        watching.truncate(kept);
        self.watches[code as usize] = watching;
        broken
    }

    /// The other literal that a row watches beside a false one, and another that it now watches in place of that; none if
    /// the other one holds, or no third may.
    fn watch_next_of_row(&mut self, row: u32, code: Code) -> (Code, Option<Code>) {
        let literals = self.rows.literals(row);
        let [first, second] = self.watched_in[row as usize].map(|at| at as usize);
        let (own, place) = if literals[first] == code { (first, 0) } else { (second, 1) };
        let other = literals[first + second - own];
        if self.values[other as usize] == 1 {
            return (other, None);
        }
        let may_hold =
            |&at: &usize| literals[at] != other && self.values[literals[at] as usize] != -1;
        // Round the row from the one that was watched.
        let next = (own + 1..literals.len()).chain(0..own).find(may_hold);
        let seen = next.map_or(literals.len(), |next| next.wrapping_sub(own) % literals.len());
        self.steps += seen as u64 / 4;
        if let Some(next) = next {
            self.watched_in[row as usize][place] = next as u32;
        }
        (other, next.map(|next| literals[next]))
    }

    /// The same of a clause, whose first two literals are watched.
    fn watch_next_of_clause(&mut self, index: u32, code: Code) -> (Code, Option<Code>) {
        let Clause { start, len, .. } = self.clauses[index as usize];
        let literals = &mut self.words[start as usize..(start + len) as usize];
        if literals[0] == code {
            literals.swap(0, 1);
        }
        self.steps += 2;
        let first = literals[0];
        if self.values[first as usize] == 1 {
            return (first, None);
        }
        let next = literals[2..].iter().position(|&other| self.values[other as usize] != -1);
        self.steps += next.unwrap_or(len as usize) as u64;
        if let Some(next) = next {
            literals.swap(1, next + 2);
        }
        (first, next.map(|_| literals[1]))
    }

    /// Excludes the chords that cross one; the conflict if one of them is used.
    pub(super) fn exclude_crossing(&mut self, chord: u32) -> Option<Reason> {
        let known = self.crossing.lists[chord as usize].take();
        let all = known.unwrap_or_else(|| {
            self.steps += u64::from(self.rows.chords) / 4;
            let found = if self.crossing.left > 0 { self.rows.crossing(chord) } else { Vec::new() };
            self.crossing.left = self.crossing.left.saturating_sub(found.len());
            found
        });
        self.steps += all.len() as u64 / 2;
        let mut broken = None;
        for &other in &all {
            match self.value(2 * other) {
                0 => self.set(2 * other + 1, Reason::Excluded(2 * chord)),
                1 => {
                    broken = Some(Reason::Both([2 * chord, 2 * other]));
                    break;
                }
                _ => {}
            }
        }
        self.crossing.lists[chord as usize] = Some(all);
        broken
    }
}
