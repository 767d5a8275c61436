//! The smallest change of interval counts that lowers the optimum.
//!
//! Limits: a suggestion considers counts alone, not the lengths of the intervals. It may add so
//! many intervals that [`Boundary::new`] refuses the result, if the boundary is near
//! [`MAX_VERTICES`](crate::MAX_VERTICES).

use crate::{Boundary, Certificate, best_cuts, certificate, least_max_degree};
use alloc::vec::Vec;

/// The smallest change of interval counts that lowers the optimum; see [`suggest`].
///
/// # Example
///
/// ```
/// use mindeg_core::{Boundary, Change, suggest};
///
/// let boundary = Boundary::new(&[30, 2, 4, 2])?;
/// let suggestion = suggest(&boundary, 5).unwrap();
/// assert_eq!(suggestion.changes, [Change { side: 1, by: 7 }]);
/// assert_eq!(suggestion.cost(), 7);
/// assert_eq!(suggestion.intervals(&boundary), [30, 9, 4, 2]);
/// # Ok::<(), mindeg_core::Defect>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Suggestion {
    /// The sides to change, in ascending order. Empty if no change is needed.
    pub changes: Vec<Change>,
    /// The least possible maximum degree after the changes.
    pub max_degree: u32,
}

/// A change of one side; see [`Suggestion`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Change {
    /// The side, counted from 0.
    pub side: usize,
    /// The number of intervals to add, or to remove if negative. Never 0.
    pub by: i64,
}

impl Suggestion {
    /// The total number of intervals to add or remove.
    pub fn cost(&self) -> u64 {
        self.changes.iter().map(|change| change.by.unsigned_abs()).sum()
    }

    /// The number of intervals of each side after the changes. `boundary` is the one that the
    /// suggestion was made for.
    pub fn intervals(&self, boundary: &Boundary) -> Vec<u64> {
        let mut intervals: Vec<u64> = boundary.sides().map(u64::from).collect();
        for change in &self.changes {
            if let Some(count) = intervals.get_mut(change.side) {
                *count = count.saturating_add_signed(change.by);
            }
        }
        intervals
    }
}

/// The smallest change of interval counts after which the optimum is at most `target`, or none
/// if no change achieves this. O(k).
///
/// The smallest change adds or removes the fewest intervals in total; every side keeps at least
/// one. Ties are decided in this order: remove the fewest intervals, because adding never coarsens
/// a mesh; change the fewest sides; leave the first side with the most intervals, then the second,
/// and so on. The new optimum may be below the target, because some degrees do not occur while a
/// side grows. Only boundaries of three or four intervals have an optimum below 4.
///
/// # Why it is the smallest
///
/// - **Target 5 or more.** An optimum above 5 is Theorem 4's, `(a-2)/(r-1)` rounded up plus 3,
///   for a side of a intervals and r intervals on the other sides. With `λ = target - 3`, that
///   side must satisfy `a - 2 <= λ (r-1)`. Each interval of change raises the right-hand side by
///   at most λ, or lowers the left-hand side by 1. So at least `((a-2) - λ (r-1)) / λ` intervals,
///   rounded up, must change. To add that many to any other side is enough: side a stays the
///   largest.
/// - **Target 4.** Some cut must become balanced. Its imbalance is at least `e*`, and each interval
///   of change moves it by 1, so at least `e* - 1` intervals must change. To add that many to a
///   side of the smaller run of a best cut is enough. (2,2,2), which needs no balanced cut, is
///   always farther away: its three cuts have imbalance 2, and the first change away from it
///   lowers one of them to 1. So a boundary at distance d from it has `e* <= d`.
/// - **Target 3 or 2.** Only boundaries of 4 or 3 intervals have such an optimum.
///
/// # Example
///
/// ```
/// use mindeg_core::{Boundary, Change, suggest};
///
/// let boundary = Boundary::new(&[12, 9, 4, 4])?;
/// let suggestion = suggest(&boundary, 4).unwrap();
/// assert_eq!(suggestion.changes, [Change { side: 1, by: 2 }]); // 12 + 4 against 11 + 4
/// assert_eq!(suggest(&boundary, 2), None);
/// # Ok::<(), mindeg_core::Defect>(())
/// ```
pub fn suggest(boundary: &Boundary, target: u32) -> Option<Suggestion> {
    let certificate = certificate(boundary);
    if certificate.max_degree() <= target {
        return Some(Suggestion { changes: Vec::new(), max_degree: certificate.max_degree() });
    }
    match (target, certificate) {
        (0..=3, _) => fewest_intervals(boundary, target),
        (4, _) => Some(balance_a_cut(boundary)),
        (_, Certificate::LongSide { side, .. }) => Some(relieve_long_side(boundary, side, target)),
        // All other boundaries have an optimum of at most 5.
        _ => None,
    }
}

/// The smallest change for each lower optimum that a smallest change reaches: degrees decrease,
/// costs do not.
///
/// The first is [`suggest`] for the current optimum minus 1, the next is [`suggest`] for the
/// degree of the first minus 1, and so on. O(k) for each.
///
/// ```
/// use mindeg_core::{Boundary, suggestions};
///
/// let boundary = Boundary::new(&[30, 2, 4, 2])?; // its optimum is 7
/// let table: Vec<(u32, u64)> =
///     suggestions(&boundary).map(|one| (one.max_degree, one.cost())).collect();
/// assert_eq!(table, [(6, 3), (5, 7), (4, 21), (3, 34)]);
/// # Ok::<(), mindeg_core::Defect>(())
/// ```
pub fn suggestions(boundary: &Boundary) -> impl Iterator<Item = Suggestion> + '_ {
    let mut degree = least_max_degree(boundary);
    core::iter::from_fn(move || {
        let suggestion = suggest(boundary, degree - 1)?;
        degree = suggestion.max_degree;
        Some(suggestion)
    })
}

fn relieve_long_side(boundary: &Boundary, long_side: usize, target: u32) -> Suggestion {
    let long = boundary.intervals(long_side);
    let others = boundary.vertex_count() - long;
    let others_needed = (long - 2).div_ceil(target - 3) + 1;
    let side = usize::from(long_side == 0);
    Suggestion {
        changes: [Change { side, by: i64::from(others_needed - others) }].into(),
        max_degree: (long - 2).div_ceil(others_needed - 1) + 3,
    }
}

fn balance_a_cut(boundary: &Boundary) -> Suggestion {
    let sides = boundary.side_count();
    // The smaller run starts where the larger one ends. It may wrap past the last side.
    let first_of_smaller = best_cuts(boundary).map(|cut| {
        let end = cut.first_side + cut.side_count;
        if end < sides && cut.first_side > 0 { 0 } else { end % sides }
    });
    let side = first_of_smaller.min().expect("three sides have a cut");
    let by = i64::from(crate::least_imbalance(boundary)) - 1;
    Suggestion { changes: [Change { side, by }].into(), max_degree: 4 }
}

/// Tries every boundary of three or four intervals.
fn fewest_intervals(boundary: &Boundary, target: u32) -> Option<Suggestion> {
    // In order of preference.
    let candidates: &[&[i64]] = match (boundary.side_count(), target) {
        (3, 2) => &[&[1, 1, 1]],
        (3, 3) => &[&[2, 1, 1], &[1, 2, 1], &[1, 1, 2]],
        (4, 3) => &[&[1, 1, 1, 1]],
        _ => return None,
    };
    let changes_to = |counts: &[i64]| -> Vec<Change> {
        let by = counts.iter().zip(boundary.sides()).map(|(count, side)| count - i64::from(side));
        let changes = by.enumerate().map(|(side, by)| Change { side, by });
        changes.filter(|change| change.by != 0).collect()
    };
    candidates
        .iter()
        .map(|counts| Suggestion { changes: changes_to(counts), max_degree: target })
        .min_by_key(|suggestion| {
            let removed: u64 = suggestion.changes.iter().map(|c| c.by.min(0).unsigned_abs()).sum();
            (suggestion.cost(), removed, suggestion.changes.len())
        })
}
