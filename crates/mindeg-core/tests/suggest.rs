//! Compares suggestions with every change of counts of the same cost or less.

use mindeg_core::{Boundary, Suggestion, least_max_degree, suggest, suggestions};
use proptest::prelude::*;
use std::cmp::Reverse;

/// Calls `visit` with all counts, each at least 1, whose total distance from `sides` is at most
/// `cost`.
fn for_each_change(sides: &[u64], cost: u64, visit: &mut dyn FnMut(&[u64])) {
    fn go(sides: &[u64], counts: &mut Vec<u64>, cost: u64, visit: &mut dyn FnMut(&[u64])) {
        let Some(&side) = sides.get(counts.len()) else { return visit(counts) };
        for count in side.saturating_sub(cost).max(1)..=side + cost {
            counts.push(count);
            go(sides, counts, cost - count.abs_diff(side), visit);
            counts.pop();
        }
    }
    go(sides, &mut Vec::new(), cost, visit);
}

fn optimum(sides: &[u64]) -> u32 {
    least_max_degree(&Boundary::new(sides).unwrap())
}

/// The order of preference among changes, the best first.
fn preference(sides: &[u64], counts: &[u64]) -> impl Ord + std::fmt::Debug + use<> {
    let pairs = || sides.iter().zip(counts);
    let cost: u64 = pairs().map(|(a, b)| a.abs_diff(*b)).sum();
    let removed: u64 = pairs().map(|(a, b)| a.saturating_sub(*b)).sum();
    let touched = pairs().filter(|(a, b)| a != b).count();
    (cost, removed, touched, Reverse(counts.to_vec()))
}

/// Checks all targets below the optimum of `sides`.
fn check(sides: &[u64]) {
    let boundary = Boundary::new(sides).unwrap();
    for target in 0..=optimum(sides) {
        // No degree is below 2, and only 3 or 4 intervals allow a degree below 4.
        let is_possible = target >= if sides.len() <= 4 { sides.len() as u32 - 1 } else { 4 };
        let Some(suggestion) = suggest(&boundary, target) else {
            assert!(!is_possible, "{sides:?}: {target}");
            continue;
        };
        let suggested = suggestion.intervals(&boundary);
        assert_eq!(optimum(&suggested), suggestion.max_degree, "{sides:?}: {target}");
        assert!(suggestion.max_degree <= target, "{sides:?}: {target}");
        let changed: u64 = sides.iter().zip(&suggested).map(|(a, b)| a.abs_diff(*b)).sum();
        assert_eq!(suggestion.cost(), changed, "{sides:?}: {target}");
        let mut best = preference(sides, &suggested);
        for_each_change(sides, suggestion.cost(), &mut |counts| {
            let other = preference(sides, counts);
            if other < best && optimum(counts) <= target {
                best = other;
            }
        });
        assert_eq!(best, preference(sides, &suggested), "{sides:?}: {target}");
    }
}

/// Every boundary of `sides` sides with at most `most` intervals, whatever the rotation.
fn check_all(sides: usize, most: u64) {
    let ones = vec![1; sides];
    for_each_change(&ones, most - sides as u64, &mut check);
}

#[test]
fn no_change_of_a_small_boundary_is_better() {
    check_all(3, 20);
    check_all(4, 14);
    check_all(5, 12);
    check_all(6, 12);
}

#[test]
fn the_table_descends() {
    for sides in [&[1000, 1, 1][..], &[30, 2, 4, 2], &[3, 500, 2, 2, 7], &[2, 2, 2], &[9, 9, 9]] {
        let boundary = Boundary::new(sides).unwrap();
        let table: Vec<Suggestion> = suggestions(&boundary).collect();
        let mut degree = optimum(sides);
        for row in &table {
            for target in row.max_degree..degree {
                assert_eq!(suggest(&boundary, target).as_ref(), Some(row), "{sides:?}");
            }
            degree = row.max_degree;
        }
        assert_eq!(suggest(&boundary, degree - 1), None, "{sides:?}");
        assert!(table.is_sorted_by_key(Suggestion::cost), "{sides:?}");
    }
}

proptest! {
    #[test]
    fn a_suggestion_does_what_it_says(
        sides in prop::collection::vec(1_u64..400, 3..20), long in 0_u64..100_000, target in 0_u32..40
    ) {
        let mut sides = sides;
        sides[0] += long;
        let boundary = Boundary::new(&sides).unwrap();
        if let Some(suggestion) = suggest(&boundary, target) {
            let counts = suggestion.intervals(&boundary);
            prop_assert_eq!(optimum(&counts), suggestion.max_degree);
            prop_assert!(suggestion.max_degree <= target);
            prop_assert!(suggestion.changes.iter().all(|change| change.by != 0));
            prop_assert!(suggestion.changes.is_sorted_by_key(|change| change.side));
            prop_assert_eq!(suggestion.changes.is_empty(), optimum(&sides) <= target);
        } else {
            prop_assert!(target < 4);
        }
    }
}
