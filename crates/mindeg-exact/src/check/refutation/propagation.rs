//! Consequences of suppositions.

use super::table::{Code, Row, Table, Watch};

impl Table<'_> {
    /// Sets what the rows leave no choice for.
    pub(super) fn set_all_that_has_no_choice(&mut self) {
        for row in 0..self.rows.len() {
            if self.rows[row].room == 0 {
                self.complete(row);
            }
        }
        self.is_broken |= !self.follow();
    }

    /// Whether a clause follows: if all its literals are false, a row or clause is broken. From then on it is kept,
    /// without the literals that this does not need.
    pub(super) fn follows(&mut self, clause: &[Code]) -> bool {
        let is_shared = |(code, _): &&(Code, usize)| clause.contains(code);
        let shared = self.supposed.iter().take_while(is_shared).count();
        self.back_to(shared);
        let mut is_kept = self.keep_last() && self.follow();
        let mut literals = clause.iter().copied();
        while is_kept {
            let Some(code) = literals.find(|&code| !self.holds[code as usize ^ 1]) else {
                return self.is_broken;
            };
            if self.holds[code as usize] {
                let level = self.levels[code as usize / 2] as usize;
                self.last.extend(self.supposed[..level].iter().map(|&(code, _)| code));
                self.last.push(code);
                return true;
            }
            self.supposed.push((code, self.held.len()));
            is_kept = self.set(code ^ 1) && self.follow();
        }
        self.last.extend(self.supposed.iter().map(|&(code, _)| code));
        match self.supposed.len().checked_sub(1) {
            Some(level) => self.back_to(level),
            None => self.is_broken = true,
        }
        true
    }

    /// Keeps the clause that followed last, and sets what follows from it: nothing is supposed now that was not when it
    /// was found, and of its literals only the last one may be without a value while the one before is false.
    fn keep_last(&mut self) -> bool {
        let clause = std::mem::take(&mut self.last);
        let Some((&last, before)) = clause.split_last() else { return true };
        let Some(&second) = before.last() else { return self.set(last) };
        let (start, len) = (self.words.len() as u32, clause.len() as u32);
        self.words.extend(clause.iter().rev());
        self.watched_by[last as usize].push(Watch { start, len, other: second });
        self.watched_by[second as usize].push(Watch { start, len, other: last });
        !self.holds[second as usize ^ 1] || self.set(last)
    }

    /// Sets what follows from what holds; whether no row or clause is broken.
    fn follow(&mut self) -> bool {
        let mut full = Vec::new();
        while let Some(&code) = self.held.get(self.counted) {
            self.counted += 1;
            let mut is_kept = true;
            for at in self.row_starts[code as usize]..self.row_starts[code as usize + 1] {
                let index = self.rows_of[at as usize] as usize;
                let row = &mut self.rows[index];
                row.room -= 1;
                row.rest ^= code;
                is_kept &= row.room >= 0;
                if row.room == 0 {
                    full.push(index);
                }
            }
            if !is_kept {
                return false;
            }
            full.drain(..).for_each(|row| self.complete(row));
            if !self.exclude_crossing(code) || !self.follow_clauses(code ^ 1) {
                return false;
            }
        }
        true
    }

    /// Sets the rest of a full row to false.
    fn complete(&mut self, row: usize) {
        let &Row { start, len, most, rest, .. } = &self.rows[row];
        if len - most == 1 {
            self.set(rest ^ 1);
            return;
        }
        for at in start..start + len {
            let code = self.literals[at as usize];
            if !self.holds[code as usize] {
                self.set(code ^ 1);
            }
        }
    }

    /// Sets what follows from the clauses that watch a literal that has become false; whether none is broken.
    fn follow_clauses(&mut self, lost: Code) -> bool {
        let mut watching = std::mem::take(&mut self.watched_by[lost as usize]);
        let mut is_kept = true;
        let mut at = 0;
        while is_kept && let Some(&Watch { start, len, other }) = watching.get(at) {
            at += 1;
            if self.holds[other as usize] {
                continue;
            }
            let clause = &mut self.words[start as usize..(start + len) as usize];
            if clause[0] == lost {
                clause.swap(0, 1);
            }
            let first = clause[0];
            let is_open = |code: &Code| !self.holds[*code as usize ^ 1];
            if !self.holds[first as usize]
                && let Some(open) = clause[2..].iter().position(is_open)
            {
                clause.swap(1, open + 2);
                self.watched_by[clause[1] as usize].push(Watch { start, len, other: first });
                at -= 1;
                watching.swap_remove(at);
                continue;
            }
            watching[at - 1].other = first;
            is_kept = self.set(first);
        }
        self.watched_by[lost as usize] = watching;
        is_kept
    }

    /// Lets a literal hold; false if its negation does.
    pub(super) fn set(&mut self, code: Code) -> bool {
        let [holds, is_false] = [code, code ^ 1].map(|code| self.holds[code as usize]);
        if !holds && !is_false {
            self.holds[code as usize] = true;
            self.levels[code as usize / 2] = self.supposed.len() as u32;
            self.held.push(code);
        }
        !is_false
    }

    /// Takes back all suppositions but the first ones, and what follows from them.
    pub(super) fn back_to(&mut self, level: usize) {
        let Some(&(_, root)) = self.supposed.get(level) else { return };
        self.supposed.truncate(level);
        for (at, code) in (root..).zip(self.held.drain(root..)) {
            self.holds[code as usize] = false;
            if at < self.counted {
                let rows = self.row_starts[code as usize]..self.row_starts[code as usize + 1];
                for &row in &self.rows_of[rows.start as usize..rows.end as usize] {
                    let row = &mut self.rows[row as usize];
                    row.room += 1;
                    row.rest ^= code;
                }
            }
        }
        self.counted = root;
    }
}

#[cfg(test)]
mod tests {
    use super::super::by_use;
    use super::super::candidates::CheckedFace;
    use super::*;
    use crate::check::CheckedOutline;
    use crate::cover::{Element, Literal};
    use glam::DVec2;
    use mindeg_mesh::Random;
    use std::ops::Range;

    const CORNERS: u32 = 7;

    /// The triangulations of a convex polygon whose vertices are a range.
    fn triangulations(corners: Range<u32>) -> Vec<Vec<[u32; 3]>> {
        let (first, last) = (corners.start, corners.end - 1);
        if last - first < 2 {
            return vec![Vec::new()];
        }
        let with_apex = |apex: u32| {
            let after = triangulations(apex..last + 1);
            triangulations(first..apex + 1).into_iter().flat_map(move |before| {
                after
                    .clone()
                    .into_iter()
                    .map(move |after| [&before[..], &after, &[[first, apex, last]]].concat())
            })
        };
        (first + 1..last).flat_map(with_apex).collect()
    }

    /// Whether a clause follows from rows and clauses, by setting what has no choice left until nothing changes.
    fn follows_plainly(table: &Table<'_>, clauses: &[Vec<Code>], clause: &[Code]) -> bool {
        let mut holds = vec![false; table.code_count()];
        clause.iter().for_each(|code| holds[*code as usize ^ 1] = true);
        let crossing = table.chords[0].clone().flat_map(|chord| {
            table.find_crossing(chord).into_iter().map(move |other| (vec![2 * chord, other], 1))
        });
        let rows = table.rows.iter().map(|row| {
            let own = row.start as usize..(row.start + row.len) as usize;
            (table.literals[own].to_vec(), row.most as usize)
        });
        let kept = clauses.iter().map(|clause| {
            (clause.iter().map(|code| code ^ 1).collect::<Vec<_>>(), clause.len() - 1)
        });
        let rows: Vec<_> = crossing.chain(rows).chain(kept).collect();
        loop {
            let before = holds.clone();
            for (row, most) in &rows {
                let count = row.iter().filter(|&&code| holds[code as usize]).count();
                if count > *most {
                    return true;
                }
                for &code in row {
                    if count == *most && !holds[code as usize] {
                        holds[code as usize ^ 1] = true;
                    }
                }
            }
            if (0..holds.len()).any(|code| holds[code] && holds[code ^ 1]) {
                return true;
            }
            if holds == before {
                return false;
            }
        }
    }

    /// Clauses by chance: each that follows plainly is taken, and each that is taken holds in all triangulations.
    #[test]
    fn what_follows_is_taken_and_what_is_taken_holds() {
        let at = |corner: u32| {
            DVec2::from_angle(f64::from(corner) * std::f64::consts::TAU / f64::from(CORNERS))
        };
        let points: Vec<DVec2> = (0..CORNERS).map(at).collect();
        let vertices: Vec<u32> = (0..CORNERS).collect();
        let (points, side_of) = (&points[..], &vertices[..]);
        let rings = std::slice::from_ref(&(0..CORNERS));
        let outline = CheckedOutline { points, rings, side_of, keeps_clear: true };
        let faces = [CheckedFace { outline, vertices: &vertices, least_tangent: 0.0 }];
        let (mut taken, mut refused) = (0, 0);
        for seed in 0..60 {
            let mut random = Random::new(seed);
            let most: Vec<u32> = vertices.iter().map(|_| 1 + random.below(3) as u32).collect();
            let mut table = Table::new(&faces, &most);
            let code = |element, is_used| {
                table.codes(&[Literal { face: 0, element, is_used }]).unwrap()[0]
            };
            let keeps = |mesh: &Vec<[u32; 3]>| {
                let mut used = vec![false; table.code_count()];
                let mut chords = vec![0; vertices.len()];
                for &[a, b, c] in mesh {
                    used[code(Element::Triangle([a, b, c]), true) as usize] = true;
                    if c - a != CORNERS - 1 {
                        used[code(Element::Chord([a, c]), true) as usize] = true;
                        [a, c].iter().for_each(|&end| chords[end as usize] += 1);
                    }
                }
                let holds = (0..used.len()).map(|code| used[code & !1] == (code % 2 == 0));
                let is_within = chords.iter().zip(&most).all(|(chords, most)| chords <= most);
                is_within.then(|| holds.collect::<Vec<bool>>())
            };
            let meshes: Vec<_> = triangulations(0..CORNERS).iter().filter_map(keeps).collect();
            if meshes.is_empty() {
                continue;
            }
            table.set_all_that_has_no_choice();
            // Neighbours are alike.
            let codes = table.code_count();
            let mut clause: Vec<Code> = Vec::new();
            let mut next = |_| {
                if random.below(4) == 0 {
                    clause.clear();
                }
                while clause.len() > random.below(8) {
                    clause.remove(random.below(clause.len()));
                }
                let added = 1 + random.below(3);
                clause.extend((0..added).map(|_| random.below(codes) as Code));
                clause.clone()
            };
            let clauses = by_use((0..500).map(&mut next).collect(), codes);
            let mut kept: Vec<Vec<Code>> = Vec::new();
            for clause in clauses {
                let follows = follows_plainly(&table, &kept, &clause);
                let is_taken = table.follows(&clause);
                assert!(is_taken || !follows, "{seed}: {clause:?}");
                if is_taken {
                    let holds = |mesh: &Vec<bool>| clause.iter().any(|&code| mesh[code as usize]);
                    assert!(meshes.iter().all(holds), "{seed}: {clause:?}");
                    kept.push(clause);
                    taken += 1;
                } else {
                    refused += 1;
                }
            }
        }
        assert!(taken > 500 && refused > 500, "{taken}, {refused}");
    }
}
