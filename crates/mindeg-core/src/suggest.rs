//! Which interval counts to change, and by how little, for a lower optimum.
//!
//! Limits: a suggestion looks at counts alone, not at how long the intervals become. Additions
//! to a boundary near [`MAX_VERTICES`](crate::MAX_VERTICES) may pass that limit, which
//! [`Boundary::new`] then says.

use crate::{Boundary, Certificate, best_cuts, certificate, least_max_degree};
use alloc::vec::Vec;

/// The least change of interval counts that brings the optimum down; see [`suggest`].
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
/// # Ok::<(), mindeg_core::BoundaryError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Suggestion {
    /// The sides to change, in ascending order. Empty where no change is needed.
    pub changes: Vec<Change>,
    /// The least possible maximum degree after the changes.
    pub max_degree: u32,
}

/// How to change one side; see [`Suggestion`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Change {
    /// The side, counted from 0.
    pub side: usize,
    /// The intervals to add, or with a minus to take away. Not 0.
    pub by: i64,
}

impl Suggestion {
    /// How many intervals are added or taken away in all.
    #[must_use]
    pub fn cost(&self) -> u64 {
        self.changes.iter().map(|change| change.by.unsigned_abs()).sum()
    }

    /// The interval counts of all sides after the changes, for the boundary they were made for.
    #[must_use]
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

/// The least change of interval counts after which the optimum is at most `target`, or none
/// where no change can bring that about. O(k).
///
/// Least means the fewest intervals added or taken away in all; every side keeps at least one. Of
/// several such changes it is the one that takes the fewest intervals away, as adding never
/// coarsens a mesh; then the one that touches the fewest sides; then the one that leaves the first
/// side with the most intervals, then the second, and so on. The optimum may come out below the
/// target: it does not pass through all degrees as a side grows. Below 4 there are only the
/// boundaries of three or four intervals.
///
/// # Why it is least
///
/// - **Target 5 or more.** An optimum above 5 is Theorem 4's, `(a-2)/(r-1)` rounded up plus 3,
///   for a side of a intervals and r on the other sides. With `λ = target - 3`, that side must
///   come to `a - 2 <= λ (r-1)`. A unit of change raises the right side by at most λ, or lowers
///   the left by 1, so it takes at least `((a-2) - λ (r-1)) / λ` units, rounded up. As many added
///   to any other side are enough: side a stays the largest.
/// - **Target 4.** Some cut must become balanced. Its imbalance was at least `e*`, and a unit of
///   change moves it by 1, so it takes at least `e* - 1` units. As many added to a side of the
///   smaller run of a best cut are enough. (2,2,2), which needs no balanced cut, is always
///   farther: its three cuts have imbalance 2, the first unit of change away from it moves one of
///   them down to 1, and so `e* <= d` for a boundary d units away.
/// - **Target 3 or 2.** Only boundaries with 4 or 3 intervals have such an optimum.
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
/// # Ok::<(), mindeg_core::BoundaryError>(())
/// ```
#[must_use]
pub fn suggest(boundary: &Boundary, target: u32) -> Option<Suggestion> {
    let certificate = certificate(boundary);
    if certificate.max_degree() <= target {
        return Some(Suggestion { changes: Vec::new(), max_degree: certificate.max_degree() });
    }
    match (target, certificate) {
        (0..=3, _) => fewest_intervals(boundary, target),
        (4, _) => Some(balance_a_cut(boundary)),
        (_, Certificate::LongSide { side, .. }) => Some(relieve_long_side(boundary, side, target)),
        // All others have an optimum of 5 at most.
        _ => None,
    }
}

/// For each optimum below today's that a least change leads to, that change: degrees descend,
/// costs do not.
///
/// Each is what [`suggest`] answers for the degree before it less one, and for every target down
/// to its own degree. O(k) for each.
///
/// ```
/// use mindeg_core::{Boundary, suggestions};
///
/// let boundary = Boundary::new(&[30, 2, 4, 2])?; // today's optimum is 7
/// let table: Vec<(u32, u64)> =
///     suggestions(&boundary).map(|one| (one.max_degree, one.cost())).collect();
/// assert_eq!(table, [(6, 3), (5, 7), (4, 21), (3, 34)]);
/// # Ok::<(), mindeg_core::BoundaryError>(())
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
    // The smaller run starts where the larger one ends, and may wrap past the last side.
    let first_of_smaller = best_cuts(boundary).map(|cut| {
        let end = cut.first_side + cut.side_count;
        if end < sides && cut.first_side > 0 { 0 } else { end % sides }
    });
    let side = first_of_smaller.min().expect("three sides have a cut");
    let by = i64::from(crate::least_imbalance(boundary)) - 1;
    Suggestion { changes: [Change { side, by }].into(), max_degree: 4 }
}

/// The boundaries with three or four intervals are few enough to try.
fn fewest_intervals(boundary: &Boundary, target: u32) -> Option<Suggestion> {
    // Of equally good ones the first is preferred.
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
