//! Learns a clause from a conflict; a conflict at the root of the search ends the proof.

use super::{Clause, Code, Expected, FIRST_ROW, Reason, Search};
use crate::cover::decision::{Decision, Refutation};

/// How activities of variables fall with every conflict: a refutation stays at one place of the domain until that is done.
const DECAY: f64 = 0.95;
const REFUTATION_DECAY: f64 = 0.75;

/// How activities of clauses fall.
const CLAUSE_DECAY: f64 = 0.999;

/// Clauses that join no more levels than this are never forgotten.
const KEPT_LEVELS: u32 = 2;

/// A clause from which another was learned, or a variable that has its value at the root of the search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Origin {
    Clause(u32),
    Fact(u32),
}

impl Search<'_> {
    /// The literals that hold and together imply `implied`, or break the row or clause if that is none.
    fn causes(&mut self, reason: Reason, implied: Option<Code>, causes: &mut Vec<Code>) {
        causes.clear();
        let before = implied.map_or(u32::MAX, |code| self.given[code as usize / 2].position);
        let more = usize::from(implied.is_none());
        let (row, wanted, sign) = match reason {
            Reason::Decided => return,
            Reason::Clause(index) => {
                let Clause { start, len, .. } = self.clauses[index as usize];
                self.steps += u64::from(len);
                let literals = &self.words[start as usize..(start + len) as usize];
                causes.extend(
                    literals.iter().filter(|&&code| Some(code) != implied).map(|code| code ^ 1),
                );
                return;
            }
            Reason::Excluded(by) => return causes.push(by),
            Reason::Both(codes) => return causes.extend(codes),
            Reason::Most(row) => (row, self.rows.bounds(row)[1] as usize + more, 0),
            Reason::Least(row) => (row, self.rows.literals(row).len() + more - 1, 1),
        };
        let literals = self.rows.literals(row);
        self.steps += literals.len() as u64;
        let of_row = literals.iter().map(|code| code ^ sign);
        causes.extend(of_row.filter(|&code| {
            self.values[code as usize] == 1 && self.given[code as usize / 2].position < before
        }));
        // The earliest causes suffice.
        if causes.len() > wanted {
            causes.sort_unstable_by_key(|&code| self.given[code as usize / 2].position);
            causes.truncate(wanted);
        }
    }

    /// Learns a clause from a conflict, goes back to where it has one free literal, and sets that; the number of levels
    /// that the clause joins.
    pub(super) fn learn(&mut self, conflict: Reason) -> u32 {
        let level = self.level_starts.len() as u32;
        // The first literal is that of this level, at last.
        let mut clause: Vec<Code> = vec![0];
        let mut marked: Vec<u32> = Vec::new();
        let mut causes = Vec::new();
        let origins = self.origins.len() as u32;
        let (mut reason, mut implied) = (conflict, None);
        let (mut open, mut at) = (0_u32, self.trail.len());
        loop {
            if let Reason::Clause(index) = reason {
                self.origins.push(2 * index);
                self.raise_clause(index);
            }
            self.causes(reason, implied, &mut causes);
            for &code in &causes {
                let variable = code / 2;
                if self.is_seen[variable as usize] {
                    continue;
                }
                self.is_seen[variable as usize] = true;
                marked.push(variable);
                match self.given[variable as usize].level {
                    0 => self.origins.push(2 * variable + 1),
                    of if of == level => {
                        open += 1;
                        self.raise(variable);
                    }
                    _ => {
                        clause.push(code ^ 1);
                        self.raise(variable);
                    }
                }
            }
            let code = loop {
                at -= 1;
                let code = self.trail[at];
                if self.is_seen[code as usize / 2] && self.given[code as usize / 2].level == level {
                    break code;
                }
            };
            open -= 1;
            if open == 0 {
                clause[0] = code ^ 1;
                break;
            }
            (reason, implied) = (self.given[code as usize / 2].reason, Some(code));
        }
        self.shorten(&mut clause, &mut marked);
        for variable in marked {
            self.is_seen[variable as usize] = false;
        }
        // Of the others, one of the latest level comes second: it is watched.
        let latest = (1..clause.len()).max_by_key(|&at| self.given[clause[at] as usize / 2].level);
        let back = latest.map_or(0, |at| {
            clause.swap(1, at);
            self.given[clause[1] as usize / 2].level
        });
        self.back_to(back);
        let index = self.clauses.len() as u32;
        let is_watched = clause.len() > 1;
        if is_watched {
            self.watches[clause[0] as usize].push([index, clause[1]]);
            self.watches[clause[1] as usize].push([index, clause[0]]);
            self.watched += 1;
        }
        let (start, len) = (self.words.len() as u32, clause.len() as u32);
        let level = |code: &Code| self.given[*code as usize / 2].level;
        let mut levels: Vec<u32> = clause.iter().map(level).collect();
        levels.sort_unstable();
        levels.dedup();
        let levels = levels.len() as u32;
        self.words.extend(&clause);
        let activity = self.step_of_clauses;
        self.clauses.push(Clause { start, len, origins, activity, levels, is_watched });
        self.set(clause[0], Reason::Clause(index));
        self.step_of_activity /= match self.expected {
            Expected::Mesh => DECAY,
            Expected::Refutation => REFUTATION_DECAY,
        };
        self.step_of_clauses /= CLAUSE_DECAY;
        levels
    }

    /// Leaves out the literals of a clause that its others imply, directly or by others that they imply.
    fn shorten(&mut self, clause: &mut Vec<Code>, marked: &mut Vec<u32>) {
        self.joins.resize(self.level_starts.len() + 1, false);
        let levels: Vec<u32> = clause[1..].iter().map(|code| self.level(*code)).collect();
        levels.iter().for_each(|&level| self.joins[level as usize] = true);
        let (mut kept, mut stuck) = (1, Vec::new());
        for at in 1..clause.len() {
            if !self.is_implied(clause[at], marked, &mut stuck) {
                clause[kept] = clause[at];
                kept += 1;
            }
        }
        levels.iter().for_each(|&level| self.joins[level as usize] = false);
        stuck.iter().for_each(|&variable| self.is_stuck[variable as usize] = false);
        clause.truncate(kept);
    }

    /// Whether the marked literals, which hold, imply the negation of one that does not; if so, it marks those between
    /// and takes note of what they follow from. If not, it takes note of those between that they do not imply, either.
    fn is_implied(&mut self, code: Code, marked: &mut Vec<u32>, stuck: &mut Vec<u32>) -> bool {
        let (first_mark, first_origin) = (marked.len(), self.origins.len());
        // The literals on the way, each with the one that it came from; the first came from itself.
        let mut way = vec![(code ^ 1, 0)];
        let mut open = vec![0];
        let mut causes = Vec::new();
        while let Some(at) = open.pop() {
            let implied = way[at].0;
            let reason = self.given[implied as usize / 2].reason;
            if let Reason::Clause(index) = reason {
                self.origins.push(2 * index);
            }
            self.causes(reason, Some(implied), &mut causes);
            let mut is_stuck = reason == Reason::Decided;
            for &cause in &causes {
                let variable = cause / 2;
                if self.is_seen[variable as usize] {
                    continue;
                }
                let level = self.given[variable as usize].level;
                if level == 0 {
                    self.origins.push(2 * variable + 1);
                } else if self.is_stuck[variable as usize]
                    || self.given[variable as usize].reason == Reason::Decided
                    || !self.joins[level as usize]
                {
                    is_stuck = true;
                    break;
                } else {
                    open.push(way.len());
                    way.push((cause, at));
                }
                self.is_seen[variable as usize] = true;
                marked.push(variable);
            }
            if is_stuck {
                for variable in marked.drain(first_mark..) {
                    self.is_seen[variable as usize] = false;
                }
                self.origins.truncate(first_origin);
                let mut at = at;
                while at != 0 {
                    let (code, from) = way[at];
                    self.is_stuck[code as usize / 2] = true;
                    stuck.push(code / 2);
                    at = from;
                }
                return false;
            }
        }
        true
    }

    fn level(&self, code: Code) -> u32 {
        self.given[code as usize / 2].level
    }

    /// Takes half of the clauses away that imply no value now: those that join most levels, and of equals the less
    /// active ones.
    pub(super) fn forget(&mut self) {
        let is_free = |(index, clause): &(u32, &Clause)| {
            let first = self.words[clause.start as usize];
            let implies = self.value(first) == 1
                && self.given[first as usize / 2].reason == Reason::Clause(*index);
            clause.is_watched && clause.levels > KEPT_LEVELS && !implies
        };
        let mut free: Vec<u32> =
            (0..).zip(&self.clauses).filter(is_free).map(|(index, _)| index).collect();
        free.sort_by(|&a, &b| {
            let [a, b] = [a, b].map(|index| &self.clauses[index as usize]);
            b.levels.cmp(&a.levels).then(a.activity.total_cmp(&b.activity))
        });
        free.truncate(free.len() / 2);
        for &index in &free {
            self.clauses[index as usize].is_watched = false;
        }
        self.watched -= free.len();
        for list in &mut self.watches {
            list.retain(|&[index, _]| {
                index >= FIRST_ROW || self.clauses[index as usize].is_watched
            });
        }
    }

    /// The clauses that a conflict at the root needs, in order, and the empty one.
    pub(super) fn refuted(&mut self, conflict: Reason) -> Decision {
        let mut is_needed = vec![false; self.clauses.len()];
        let mut open: Vec<Origin> = Vec::new();
        let mut causes = Vec::new();
        let open_causes =
            |search: &mut Self, reason, implied, open: &mut Vec<Origin>, causes: &mut Vec<Code>| {
                if let Reason::Clause(index) = reason {
                    open.push(Origin::Clause(index));
                }
                search.causes(reason, implied, causes);
                open.extend(causes.iter().map(|code| Origin::Fact(code / 2)));
            };
        open_causes(self, conflict, None, &mut open, &mut causes);
        while let Some(origin) = open.pop() {
            match origin {
                Origin::Clause(index) if !is_needed[index as usize] => {
                    is_needed[index as usize] = true;
                    let index = index as usize;
                    let end = self
                        .clauses
                        .get(index + 1)
                        .map_or(self.origins.len(), |c| c.origins as usize);
                    let own = &self.origins[self.clauses[index].origins as usize..end];
                    open.extend(own.iter().map(|&origin| match origin % 2 {
                        0 => Origin::Clause(origin / 2),
                        _ => Origin::Fact(origin / 2),
                    }));
                }
                Origin::Fact(variable) if !self.is_seen[variable as usize] => {
                    self.is_seen[variable as usize] = true;
                    let reason = self.given[variable as usize].reason;
                    let code = 2 * variable + u32::from(self.value(2 * variable) == -1);
                    open_causes(self, reason, Some(code), &mut open, &mut causes);
                }
                _ => {}
            }
        }
        let needed = self.clauses.iter().zip(is_needed).filter(|(_, is_needed)| *is_needed);
        let mut clauses: Vec<_> = needed
            .map(|(clause, _)| {
                let literals =
                    &self.words[clause.start as usize..(clause.start + clause.len) as usize];
                literals.iter().map(|&code| self.rows.literal(code)).collect()
            })
            .collect();
        clauses.push(Vec::new());
        Decision::Refuted(Refutation { clauses })
    }
}
