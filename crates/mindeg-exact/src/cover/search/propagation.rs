//! Sets what follows from rows, chords that cross, and clauses.

use super::{Clause, Code, Reason, Search};

impl Search<'_> {
    /// Sets what is left of a row: all to hold, or none.
    pub(super) fn complete(&mut self, row: u32, holds: bool) {
        let len = self.rows.literals(row).len();
        self.steps += len as u64;
        let reason = if holds { Reason::Least(row) } else { Reason::Most(row) };
        for at in 0..len {
            let code = self.rows.literals(row)[at];
            if self.value(code) == 0 {
                self.set(code ^ u32::from(!holds), reason);
            }
        }
    }

    /// Sets what follows; the row or clause that is broken, if one is.
    pub(super) fn propagate(&mut self) -> Option<Reason> {
        while let Some(&code) = self.trail.get(self.head) {
            self.head += 1;
            let rows = self.row_starts[code as usize / 2]..self.row_starts[code as usize / 2 + 1];
            self.steps += 1 + rows.len() as u64;
            let mut broken = None;
            self.full.clear();
            for &entry in &self.rows_of[rows.start as usize..rows.end as usize] {
                let is_lost = (entry ^ code) & 1;
                let room = &mut self.rooms[entry as usize / 2][is_lost as usize];
                *room -= 1;
                if *room < 0 {
                    broken = Some(match is_lost {
                        0 => Reason::Most(entry / 2),
                        _ => Reason::Least(entry / 2),
                    });
                } else if *room == 0 {
                    self.full.push(2 * (entry / 2) + is_lost);
                }
            }
            if broken.is_some() {
                return broken;
            }
            for at in 0..self.full.len() {
                let (row, is_lost) = (self.full[at] / 2, self.full[at] % 2 == 1);
                let [may_hold, may_not] = self.rooms[row as usize];
                let [least, most] = self.rows.bounds(row);
                // Else all its literals have values.
                if (may_hold + may_not) as u32 != most - least {
                    self.complete(row, is_lost);
                }
            }
            if code < 2 * self.rows.chords && code.is_multiple_of(2) {
                let broken = self.exclude_crossing(code / 2);
                if broken.is_some() {
                    return broken;
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
            let [index, other] = watching[at];
            watching[kept] = watching[at];
            kept += 1;
            if broken.is_some() {
                continue;
            }
            self.steps += 1;
            if self.values[other as usize] == 1 {
                continue;
            }
            let Clause { start, len, .. } = self.clauses[index as usize];
            let literals = &mut self.words[start as usize..(start + len) as usize];
            if literals[0] == code {
                literals.swap(0, 1);
            }
            self.steps += 2;
            let first = literals[0];
            watching[kept - 1] = [index, first];
            if self.values[first as usize] == 1 {
                continue;
            }
            let other = literals[2..].iter().position(|&other| self.values[other as usize] != -1);
            if let Some(other) = other {
                literals.swap(1, other + 2);
                self.steps += other as u64;
                self.watches[literals[1] as usize].push([index, first]);
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
                0 => self.set(2 * other + 1, Reason::Crossing([chord, other])),
                1 => {
                    broken = Some(Reason::Crossing([chord, other]));
                    break;
                }
                _ => {}
            }
        }
        self.crossing.lists[chord as usize] = Some(all);
        broken
    }
}
