//! Cuts of the ring of sides, and the zig-zag condition.
//!
//! A cut splits the sides into two runs of consecutive sides. The imbalance of the most balanced
//! cut decides the least maximum degree: this is the paper's zig-zag condition (Theorem 5 for
//! rectangles, Theorem 10 for convex polygons), with the imbalance as a number.
//!
//! Limits: a cut goes through two corners. A cut elsewhere would have a flat ear, inside a side.

use crate::Boundary;

/// Two runs of consecutive sides that together are the whole boundary.
///
/// # Example
///
/// ```
/// use mindeg_core::{Boundary, Cut, best_cuts};
///
/// // The last side and the first against the other two.
/// let cut = best_cuts(&Boundary::new(&[12, 9, 4, 4])?).next().unwrap();
/// assert_eq!(cut, Cut { first_side: 3, side_count: 2, larger: 16, smaller: 13 });
/// assert_eq!(cut.imbalance(), 3);
/// assert!(!cut.is_balanced());
/// # Ok::<(), mindeg_core::Defect>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cut {
    /// The first side of the larger run, counted from 0. If the runs are equal, the larger run is
    /// the one without the last side.
    pub first_side: usize,
    /// The number of sides of the larger run, in `1..=k-1`; the run may wrap past the last side.
    pub side_count: usize,
    /// The number of intervals of the larger run.
    pub larger: u32,
    /// The number of intervals of the smaller run.
    pub smaller: u32,
}

impl Cut {
    /// The difference of the runs, in intervals; it has the parity of the vertex count.
    pub fn imbalance(&self) -> u32 {
        self.larger.abs_diff(self.smaller)
    }

    /// Whether the runs differ by at most one interval, so that a zig-zag can join them.
    pub fn is_balanced(&self) -> bool {
        self.imbalance() <= 1
    }

    /// The cut through the corners `from` and `to`, `from < to < k`.
    fn between(boundary: &Boundary, from: usize, to: usize) -> Self {
        let inner = boundary.corner(to) - boundary.corner(from);
        let outer = boundary.vertex_count() - inner;
        if inner >= outer {
            Self { first_side: from, side_count: to - from, larger: inner, smaller: outer }
        } else {
            let side_count = boundary.side_count() - (to - from);
            Self { first_side: to, side_count, larger: outer, smaller: inner }
        }
    }
}

/// The least imbalance `e*` over all cuts, in intervals. O(k), by two pointers.
///
/// ```
/// # use mindeg_core::{Boundary, least_imbalance};
/// let boundary = Boundary::new(&[5, 3, 1, 1])?;
/// assert_eq!(least_imbalance(&boundary), 0);
/// # Ok::<(), mindeg_core::Defect>(())
/// ```
pub fn least_imbalance(boundary: &Boundary) -> u32 {
    most_balanced_cuts(boundary).map(|cut| cut.imbalance()).min().expect("three sides have cuts")
}

/// Every cut with the least imbalance, each once, in the order of the first of its two corners.
/// O(k) for all.
///
/// ```
/// # use mindeg_core::{Boundary, best_cuts};
/// let boundary = Boundary::new(&[2, 2, 2, 2])?;
/// assert_eq!(best_cuts(&boundary).count(), 2);
/// # Ok::<(), mindeg_core::Defect>(())
/// ```
pub fn best_cuts(boundary: &Boundary) -> impl Iterator<Item = Cut> + '_ {
    let least = least_imbalance(boundary);
    most_balanced_cuts(boundary).filter(move |cut| cut.imbalance() == least)
}

/// For each corner, the most balanced cuts from it to a later corner: at most two, one on each
/// side of an equal split. Every cut of least imbalance is among them.
fn most_balanced_cuts(boundary: &Boundary) -> impl Iterator<Item = Cut> + '_ {
    let sides = boundary.side_count();
    let half_reached = move |from: usize, to: usize| {
        let run = u64::from(boundary.corner(to) - boundary.corner(from));
        2 * run >= u64::from(boundary.vertex_count())
    };
    // A run of half the intervals is not empty, so `to` stays ahead of `from`.
    let mut to = 1;
    (0..sides).flat_map(move |from| {
        while to < sides && !half_reached(from, to) {
            to += 1;
        }
        [to - 1, to]
            .into_iter()
            .filter(move |&to| from < to && to < sides)
            .map(move |to| Cut::between(boundary, from, to))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec::Vec;
    use proptest::prelude::*;

    /// All cuts, by trying every pair of corners.
    fn all_cuts(boundary: &Boundary) -> Vec<Cut> {
        let sides = boundary.side_count();
        (0..sides)
            .flat_map(|from| (from + 1..sides).map(move |to| (from, to)))
            .map(|(from, to)| Cut::between(boundary, from, to))
            .collect()
    }

    /// Small, medium and huge sides in every order, with the largest possible sums.
    #[test]
    fn the_best_cuts_of_the_largest_boundaries_do_not_overflow() {
        const MOST: u64 = crate::MAX_VERTICES as u64;
        let sizes = [1, 2, 3, 1 << 16, MOST / 4, MOST / 3, MOST / 2 - 1, MOST / 2, MOST / 2 + 1];
        let mut tried = 0;
        for a in sizes {
            for b in sizes {
                for c in sizes {
                    for total in MOST - 2..=MOST {
                        let Some(rest) = total.checked_sub(a + b + c).filter(|&rest| rest > 0)
                        else {
                            continue;
                        };
                        for sides in [[a, b, c, rest], [a, rest, b, c], [rest, a, b, c]] {
                            check_largest(&sides);
                            tried += 1;
                        }
                    }
                }
            }
        }
        assert!(tried > 4000, "{tried}");
    }

    fn check_largest(sides: &[u64; 4]) {
        let boundary = Boundary::new(sides).unwrap();
        let total: u64 = sides.iter().sum();
        let runs = (0..4).flat_map(|from| (1..4).map(move |count| (from, count)));
        let sum = |(from, count): (usize, usize)| -> u64 {
            (from..from + count).map(|side| sides[side % 4]).sum()
        };
        let least = runs.clone().map(|run| (2 * sum(run)).abs_diff(total)).min().unwrap();
        assert_eq!(u64::from(least_imbalance(&boundary)), least, "{sides:?}");
        for cut in best_cuts(&boundary) {
            let larger = sum((cut.first_side, cut.side_count));
            assert_eq!((u64::from(cut.larger), u64::from(cut.smaller)), (larger, total - larger));
            assert!(cut.larger >= cut.smaller);
        }
    }

    #[test]
    fn a_cut_names_its_larger_run() {
        let boundary = Boundary::new(&[1, 2, 3, 4]).unwrap();
        let cuts: Vec<Cut> = best_cuts(&boundary).collect();
        assert_eq!(
            cuts,
            [Cut { first_side: 1, side_count: 2, larger: 5, smaller: 5 }],
            "2 + 3 against 4 + 1"
        );
        let boundary = Boundary::new(&[9, 1, 1, 9]).unwrap();
        assert!(best_cuts(&boundary).all(|cut| cut.larger == 10 && cut.smaller == 10));
        let boundary = Boundary::new(&[1, 1, 9]).unwrap();
        let cuts: Vec<Cut> = best_cuts(&boundary).collect();
        assert_eq!(cuts, [Cut { first_side: 2, side_count: 1, larger: 9, smaller: 2 }]);
    }

    proptest! {
        #[test]
        fn the_best_cuts_are_the_best_of_all(
            sides in prop::collection::vec(1_u64..12, 3..12)
        ) {
            let boundary = Boundary::new(&sides).unwrap();
            let all = all_cuts(&boundary);
            let least = all.iter().map(Cut::imbalance).min().unwrap();
            prop_assert_eq!(least_imbalance(&boundary), least);
            let mut expected: Vec<Cut> =
                all.into_iter().filter(|cut| cut.imbalance() == least).collect();
            let mut found: Vec<Cut> = best_cuts(&boundary).collect();
            for cuts in [&mut expected, &mut found] {
                cuts.sort_by_key(|cut| (cut.first_side, cut.side_count));
            }
            prop_assert_eq!(found, expected);
        }
    }
}
