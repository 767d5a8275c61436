//! When a search begins anew from its root, and in which mode it is.
//!
//! The modes alternate: calm runs of Luby's lengths find meshes, and restarts whenever the recent clauses join more
//! levels than usual find refutations.

/// The conflicts of the shortest calm run.
const RUN: u64 = 100;

/// The fewest conflicts of a run that is not calm.
const SHORT_RUN: u64 = 10;

/// The conflicts of the first mode; each calm one is half as long again as the one before.
const FIRST_MODE: u64 = 1000;

/// The clauses over which the recent and the usual number of levels are averaged.
const RECENT: f64 = 32.0;
const USUAL: f64 = 8192.0;

/// By how much the recent number of levels exceeds the usual one where a run ends.
const EXCESS: f64 = 1.1;

pub(super) struct Restarts {
    pub(super) conflicts: u64,
    is_calm: bool,
    /// The length of the present mode, and the conflict with which it ends.
    mode: u64,
    mode_end: u64,
    /// Calm runs of this mode, and the conflict with which the present one ends.
    runs: u64,
    run_end: u64,
    last: u64,
    recent: f64,
    usual: f64,
}

impl Restarts {
    pub(super) fn new() -> Self {
        Self {
            conflicts: 0,
            is_calm: true,
            mode: FIRST_MODE,
            mode_end: FIRST_MODE,
            runs: 1,
            run_end: RUN,
            last: 0,
            recent: 0.0,
            usual: 0.0,
        }
    }

    /// Takes note of a conflict, whose clause joins so many levels.
    pub(super) fn count(&mut self, levels: u32) {
        self.conflicts += 1;
        let levels = f64::from(levels);
        self.recent += (levels - self.recent) / RECENT;
        self.usual += (levels - self.usual) / USUAL.min(self.conflicts as f64);
    }

    /// Changes the mode if it has lasted long enough; whether a calm one begins.
    pub(super) fn begins_calm(&mut self) -> bool {
        if self.conflicts < self.mode_end {
            return false;
        }
        self.is_calm = !self.is_calm;
        if self.is_calm {
            self.mode += self.mode / 2;
        }
        self.mode_end = self.conflicts + self.mode;
        (self.runs, self.run_end) = (0, self.conflicts + RUN);
        self.is_calm
    }

    /// Whether a run ends now.
    pub(super) fn is_due(&mut self) -> bool {
        let is_due = if self.is_calm {
            self.conflicts >= self.run_end
        } else {
            self.conflicts >= self.last + SHORT_RUN && self.recent > EXCESS * self.usual
        };
        if is_due {
            self.runs += 1;
            self.run_end = self.conflicts + RUN * luby(self.runs);
            self.last = self.conflicts;
        }
        is_due
    }
}

/// The i-th number of 1, 1, 2, 1, 1, 2, 4, …, from 1 on.
fn luby(index: u64) -> u64 {
    let (mut index, mut size) = (index, 1_u64);
    while size < index {
        size = 2 * size + 1;
    }
    while size != index {
        size /= 2;
        if index > size {
            index -= size;
        }
    }
    size.div_ceil(2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_grow_as_lubys_numbers() {
        let first: Vec<u64> = (1..=15).map(luby).collect();
        assert_eq!(first, [1, 1, 2, 1, 1, 2, 4, 1, 1, 2, 1, 1, 2, 4, 8]);
    }

    #[test]
    fn modes_alternate_and_runs_end_where_clauses_grow_worse() {
        let mut restarts = Restarts::new();
        let mut due = Vec::new();
        for conflict in 1..=2000 {
            // From 1500 on, clauses join more levels.
            restarts.count(if conflict < 1500 { 5 } else { 9 });
            assert_eq!(restarts.begins_calm(), conflict == 2000, "{conflict}");
            if restarts.is_due() {
                due.push(conflict);
            }
        }
        let calm: Vec<u64> = due.iter().copied().filter(|&at| at < 1000).collect();
        assert_eq!(calm, [100, 200, 400, 500, 600, 800]);
        assert!(due[6..].iter().all(|&at| (1500..2000).contains(&at)), "{due:?}");
        assert!(due.len() > 20, "{due:?}");
    }
}
