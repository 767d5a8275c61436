//! All changes of one size that counting does not exclude.

use std::cmp::Reverse;

use mindeg_core::Change;

use super::{Divided, Tries};

/// The most changes of one size that are looked at before they are tried.
const MOST_LISTED: usize = 100_000;

impl<T: Divided> Tries<'_, T> {
    /// All changes of this many intervals that counting does not exclude; none if they are too many.
    pub(super) fn changes(&self, target: u32, size: u64) -> Option<Vec<Vec<Change>>> {
        let (mut all, mut listed) = (Vec::new(), 0);
        let mut change = Vec::new();
        self.list(target, size as i64, 0, &mut change, &mut listed, &mut all);
        if listed > MOST_LISTED {
            return None;
        }
        // The intervals that it takes away, its sides, and then more on the first side before more on the next.
        all.sort_by_key(|by| {
            let removed: i64 = by.iter().map(|change| change.by.min(0).abs()).sum();
            let mut dense = vec![0; self.counts.len()];
            by.iter().for_each(|&Change { side, by }| dense[side] = by);
            (removed, by.len(), Reverse(dense))
        });
        Some(all)
    }

    /// Lists the changes of `left` intervals from a side on.
    fn list(
        &self,
        target: u32,
        left: i64,
        from: usize,
        change: &mut Vec<Change>,
        listed: &mut usize,
        all: &mut Vec<Vec<Change>>,
    ) {
        if left == 0 {
            if !self.subject.is_excluded(target, change) {
                all.push(change.clone());
            }
            return;
        }
        for side in from..self.counts.len() {
            if *listed > MOST_LISTED {
                return;
            }
            *listed += 1;
            let removable = if self.subject.keeps_points(side) {
                0
            } else {
                left.min(self.counts[side] as i64 - 1)
            };
            for by in (-removable..=left).filter(|&by| by != 0) {
                change.push(Change { side, by });
                self.list(target, left - by.abs(), side + 1, change, listed, all);
                change.pop();
            }
        }
    }
}
