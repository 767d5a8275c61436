//! Every small boundary: compares the closed form of the optimum, the certificate and every
//! candidate with the exact solver and the verifier.

use mindeg_core::{
    Boundary, Candidates, Certificate, best_cuts, bound, certificate, least_max_degree, verify,
};
use std::collections::HashSet;

/// Every way to divide `vertices` intervals among `sides` sides, one for each class under
/// rotation and reflection.
fn boundaries(sides: usize, vertices: u64) -> Vec<Vec<u64>> {
    fn extend(prefix: &mut Vec<u64>, sides: usize, left: u64, found: &mut Vec<Vec<u64>>) {
        if prefix.len() == sides - 1 {
            prefix.push(left);
            if is_least_of_its_class(prefix) {
                found.push(prefix.clone());
            }
            prefix.pop();
            return;
        }
        let to_come = (sides - prefix.len() - 1) as u64;
        for count in 1..=left - to_come {
            prefix.push(count);
            extend(prefix, sides, left - count, found);
            prefix.pop();
        }
    }
    fn is_least_of_its_class(sides: &[u64]) -> bool {
        let twice = sides.repeat(2);
        let mirrored: Vec<u64> = twice.iter().rev().copied().collect();
        let classmates = [&twice, &mirrored];
        classmates.iter().all(|ring| ring.windows(sides.len()).all(|other| sides <= other))
    }
    let mut found = Vec::new();
    extend(&mut Vec::new(), sides, vertices, &mut found);
    found
}

/// Checks one boundary and counts its candidates.
fn check(sides: &[u64]) -> usize {
    let boundary = Boundary::new(sides).unwrap();
    let optimum = crate::exact::least_max_degree(&boundary);
    assert_eq!(least_max_degree(&boundary), optimum, "{sides:?}");
    let certificate = certificate(&boundary);
    assert_eq!(certificate.check(sides), Ok(optimum), "{sides:?}");
    check_bounds(&boundary, optimum);

    let mut seen = HashSet::new();
    let candidates = Candidates::new(&boundary);
    for candidate in candidates.iter() {
        let mut triangles: Vec<[u32; 3]> = candidate.triangles().collect();
        let verified = verify(sides, triangles.iter().copied())
            .unwrap_or_else(|defect| panic!("{sides:?}: {defect} in {candidate:?}"));
        assert_eq!(verified.max_degree, optimum, "{sides:?}: {candidate:?}");
        assert_eq!(candidate.max_degree(), optimum, "{sides:?}");
        for triangle in &mut triangles {
            let least = (0..3).min_by_key(|&corner| triangle[corner]).unwrap();
            triangle.rotate_left(least);
        }
        triangles.sort_unstable();
        assert!(seen.insert(triangles), "{sides:?}: {candidate:?} occurs twice");
    }
    assert!(!seen.is_empty() && seen.len() as u64 == candidates.count());
    seen.len()
}

/// Checks each statement of the paper.
fn check_bounds(boundary: &Boundary, optimum: u32) {
    assert!(bound::counting_bound(boundary) <= optimum, "{boundary:?}");
    let side_bounds = (0..boundary.side_count()).map(|side| bound::side_bound(boundary, side));
    assert!(side_bounds.max().unwrap() <= optimum, "{boundary:?}");
    let has_degree_four = best_cuts(boundary).next().is_some_and(|cut| cut.is_balanced());
    assert_eq!(
        has_degree_four || bound::is_medial_exception(boundary),
        optimum <= 4,
        "{boundary:?}"
    );
}

/// Up to how many vertices, and how many candidates there are: of some boundaries, and of all that `MINDEG_FULL` asks for, which
/// take half a minute of processor time. The numbers of all were found separately: by every variant of a construction at every
/// corner, without the ones that fail or occur twice.
fn check_all(sides: usize, some: (u64, usize), all: (u64, usize)) {
    let (largest, count) = if std::env::var_os("MINDEG_FULL").is_some() { all } else { some };
    let boundaries = (sides as u64..=largest).flat_map(|vertices| boundaries(sides, vertices));
    assert_eq!(boundaries.map(|boundary| check(&boundary)).sum::<usize>(), count);
}

#[test]
fn every_triangle() {
    check_all(3, (32, 4_486), (40, 10_473));
}

#[test]
fn every_rectangle() {
    check_all(4, (28, 14_188), (34, 35_910));
}

#[test]
fn every_pentagon() {
    check_all(5, (26, 34_973), (32, 116_446));
}

#[test]
fn every_hexagon() {
    check_all(6, (23, 41_873), (28, 184_870));
}

#[test]
fn every_heptagon() {
    check_all(7, (21, 37_340), (26, 274_556));
}

#[test]
fn every_octagon() {
    check_all(8, (20, 41_250), (24, 260_876));
}

/// The enumeration is complete: the number of its classes is the known one.
#[test]
fn boundaries_are_enumerated_up_to_symmetry() {
    // Partitions of n into 3 parts: the integer nearest to n²/12.
    for (vertices, count) in [(3, 1), (6, 3), (12, 12), (20, 33)] {
        assert_eq!(boundaries(3, vertices).len(), count, "{vertices}");
    }
    assert_eq!(boundaries(4, 5), [[1, 1, 1, 2]]);
    assert_eq!(boundaries(4, 6), [[1, 1, 1, 3], [1, 1, 2, 2], [1, 2, 1, 2]]);
}

#[test]
fn every_kind_of_certificate_occurs() {
    let mut kinds = [false; 4];
    for sides in boundaries(3, 6).into_iter().chain(boundaries(3, 20)) {
        let kind = match certificate(&Boundary::new(&sides).unwrap()) {
            Certificate::BalancedCut { .. } => 0,
            Certificate::MedialTriangle => 1,
            Certificate::LongSide { .. } => 2,
            Certificate::NoBalancedCut { .. } => 3,
        };
        kinds[kind] = true;
    }
    assert_eq!(kinds, [true; 4]);
}
