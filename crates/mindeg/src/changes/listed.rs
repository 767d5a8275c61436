//! All changes of one size, and what counting excludes among them.

use std::cmp::Reverse;

use mindeg_core::Change;

use super::Tries;
use super::side::own_points;

/// The most changes of one size that are looked at before they are tried.
const MOST_LISTED: usize = 100_000;

impl Tries<'_> {
    /// The size that a change to `target` has at least: two rings of as many vertices for degree 4, and enough
    /// vertices for the sum of the degrees.
    pub(super) fn least_size(&self, target: u32) -> u64 {
        if self.domain.is_map() {
            return 0;
        }
        let rings = self.domain.rings();
        let vertices = u64::from(rings.vertex_count());
        match (rings.ring_count() as u64, target) {
            (2, 4) => {
                rings.rings().map(|ring| ring.len() as u64).reduce(u64::abs_diff).unwrap_or(0)
            }
            (ring_count @ 3.., 5..) => {
                (6 * (ring_count - 2)).div_ceil(u64::from(target) - 4).saturating_sub(vertices)
            }
            _ => 0,
        }
    }

    /// Whether counting excludes `target` after a change.
    pub(super) fn is_excluded(&self, target: u32, by: &[Change]) -> bool {
        let rings = self.domain.rings();
        let vertices = |ring: usize| {
            let own = by.iter().filter(|change| rings.ring_sides(ring).contains(&change.side));
            rings.ring(ring).len() as i64 + own.map(|change| change.by).sum::<i64>()
        };
        match (rings.ring_count(), target) {
            _ if self.domain.is_map() => false,
            (2, 4) => vertices(0) != vertices(1),
            (count @ 3.., 5..) => {
                let all: i64 = (0..count).map(vertices).sum();
                (i64::from(target) - 4) * all < 6 * (count as i64 - 2)
            }
            _ => false,
        }
    }

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
            if !self.is_excluded(target, change) {
                all.push(change.clone());
            }
            return;
        }
        for side in from..self.counts.len() {
            if *listed > MOST_LISTED {
                return;
            }
            *listed += 1;
            let keeps = own_points(&self.domain.sides()[side]).is_some_and(|own| !own.is_empty());
            let removable = if keeps { 0 } else { left.min(self.counts[side] as i64 - 1) };
            for by in (-removable..=left).filter(|&by| by != 0) {
                change.push(Change { side, by });
                self.list(target, left - by.abs(), side + 1, change, listed, all);
                change.pop();
            }
        }
    }
}
