//! Random boundaries of up to a million vertices: the verifier checks candidates, and the list of
//! triangles checks the closed forms.

use mindeg_core::{
    Boundary, Candidates, Certificate, Letter, Triangulation, certificate,
    least_degree_triangulation, least_max_degree, verify,
};
use proptest::prelude::*;

/// Sides of very different sizes, so that every construction occurs.
fn sides(most_sides: usize, most_intervals: u64) -> impl Strategy<Value = Vec<u64>> {
    let bits = most_intervals.ilog2();
    let side = (0..=bits).prop_flat_map(|bits| (1 << bits) / 2 + 1..=1_u64 << bits);
    let any = prop::collection::vec(side.clone(), 3..=most_sides);
    // A run of sides and a run that almost balances it.
    let nearly_balanced = (prop::collection::vec(side, 2..=most_sides - 2), 0_u64..40).prop_map(
        |(mut sides, excess)| {
            let total: u64 = sides.iter().sum();
            let half = (total + excess).div_ceil(2);
            sides.extend([half, (total + excess - half).max(1)]);
            sides
        },
    );
    prop_oneof![any, nearly_balanced]
}

/// The neighbours of every vertex, counter-clockwise, from the list of triangles alone.
fn neighbors_from_list(vertices: u32, triangulation: &Triangulation) -> Vec<Vec<u32>> {
    let mut neighbors: Vec<Vec<u32>> =
        (0..vertices).map(|v| vec![(v + 1) % vertices, (v + vertices - 1) % vertices]).collect();
    for triangle in triangulation.triangles() {
        for corner in 0..3 {
            let (from, to) = (triangle[corner], triangle[(corner + 1) % 3]);
            neighbors[from as usize].push(to);
            neighbors[to as usize].push(from);
        }
    }
    for (vertex, neighbors) in (0..vertices).zip(&mut neighbors) {
        // In a convex polygon, the neighbours in counter-clockwise order follow the ring.
        neighbors.sort_unstable_by_key(|&other| (other + vertices - vertex) % vertices);
        neighbors.dedup();
    }
    neighbors
}

proptest! {
    #[test]
    fn every_sampled_candidate_is_a_triangulation_of_the_proven_degree(sides in sides(64, 512)) {
        let boundary = Boundary::new(&sides).unwrap();
        let certificate = certificate(&boundary);
        prop_assert_eq!(certificate.check(&sides), Ok(certificate.max_degree()));
        for candidate in Candidates::new(&boundary).sample(12) {
            let verified = verify(&sides, candidate.triangles());
            let verified = verified.map_err(|defect| TestCaseError::fail(defect.to_string()))?;
            prop_assert_eq!(verified.max_degree, certificate.max_degree());
            prop_assert_eq!(verified.max_degree, candidate.max_degree());
            let degrees: Vec<u32> = (0..candidate.vertex_count()).map(|v| candidate.degree(v)).collect();
            prop_assert_eq!(&degrees, &verified.degrees);
        }
    }

    #[test]
    fn a_sample_is_as_large_as_it_may_be(sides in sides(16, 64), limit in 0_u32..40) {
        let boundary = Boundary::new(&sides).unwrap();
        let candidates = Candidates::new(&boundary);
        let sample: Vec<Triangulation> = candidates.sample(limit).collect();
        prop_assert_eq!(sample.len() as u64, candidates.count().min(u64::from(limit.max(1))));
        prop_assert_eq!(sample[0], least_degree_triangulation(&boundary));
        // The sample keeps the order of all candidates, so none occurs twice.
        let mut candidates = candidates.iter();
        prop_assert!(sample.iter().all(|one| candidates.any(|other| other == *one)));
    }

    #[test]
    fn a_certificate_proves_no_more_than_the_truth(
        of in sides(6, 8), about in sides(6, 8), degree in 2_u32..9, side in 0_usize..6
    ) {
        let optimum = least_max_degree(&Boundary::new(&about).unwrap());
        let own = certificate(&Boundary::new(&of).unwrap());
        let claimed = match own {
            Certificate::BalancedCut { cut, .. } =>
                Certificate::BalancedCut { cut, max_degree: degree },
            Certificate::LongSide { .. } =>
                Certificate::LongSide { side, max_degree: degree },
            other => other,
        };
        for certificate in [own, claimed] {
            if let Ok(proven) = certificate.check(&about) {
                prop_assert_eq!(proven, certificate.max_degree());
                prop_assert!(proven <= optimum);
            }
        }
    }

    #[test]
    fn closed_forms_describe_the_list(sides in sides(12, 64)) {
        let boundary = Boundary::new(&sides).unwrap();
        let vertices = boundary.vertex_count();
        for candidate in Candidates::new(&boundary).sample(5) {
            let from_list = neighbors_from_list(vertices, &candidate);
            for (vertex, expected) in (0_u32..).zip(&from_list) {
                let neighbors = candidate.neighbors(vertex);
                prop_assert_eq!(neighbors.len(), expected.len());
                prop_assert_eq!(&neighbors.collect::<Vec<_>>(), expected);
            }

            let mut edges: Vec<[u32; 2]> = candidate.interior_edges().collect();
            prop_assert_eq!(edges.len(), candidate.interior_edges().len());
            prop_assert_eq!(edges.len() as u32, vertices - 3);
            edges.iter_mut().for_each(|edge| edge.sort_unstable());
            edges.sort_unstable();
            edges.dedup();
            prop_assert_eq!(edges.len() as u32, vertices - 3);
            for [a, b] in edges {
                prop_assert!(from_list[a as usize].contains(&b));
                prop_assert!(b - a > 1 && b - a < vertices - 1);
            }

            let isolated: Vec<u32> = (0..vertices).filter(|&v| candidate.degree(v) == 2).collect();
            prop_assert!(isolated.len() >= 2);
            let is_corner = |&v: &u32| boundary.corner(boundary.side_of(v)) == v;
            prop_assert!(isolated.iter().all(is_corner));
            let largest = from_list.iter().map(Vec::len).max().unwrap();
            prop_assert_eq!(largest as u32, candidate.max_degree());
        }
    }

    #[test]
    fn blocks_hold_the_same_triangles_however_they_are_cut(
        sides in sides(12, 512), candidate in any::<prop::sample::Index>(),
        lens in prop::collection::vec(0_usize..150, 1..8), leap in 0_usize..300
    ) {
        let boundary = Boundary::new(&sides).unwrap();
        let candidates: Vec<Triangulation> = Candidates::new(&boundary).sample(40).collect();
        let candidate = candidate.get(&candidates);
        let count = candidate.triangle_count();
        let one_by_one: Vec<[u32; 3]> = (0..count).map(|index| candidate.triangle(index)).collect();

        let mut filled = vec![[0; 3]; count as usize];
        let (mut rest, mut index) = (&mut filled[..], 0);
        for len in lens.into_iter().chain([usize::MAX]) {
            let (block, after) = rest.split_at_mut(len.min(rest.len()));
            candidate.fill_triangles(index, block);
            (rest, index) = (after, index + block.len() as u32);
        }
        prop_assert_eq!(&filled, &one_by_one);

        prop_assert!(candidate.triangles().eq(one_by_one.iter().copied()));
        let (mut triangles, mut expected) = (candidate.triangles(), one_by_one.into_iter());
        loop {
            prop_assert_eq!(triangles.len(), expected.len());
            let triangle = triangles.nth(leap);
            prop_assert_eq!(triangle, expected.nth(leap));
            if triangle.is_none() {
                break;
            }
            prop_assert_eq!(triangles.next(), expected.next());
        }
    }

    #[test]
    fn strips_spell_the_triangles(sides in sides(8, 64)) {
        let candidate = least_degree_triangulation(&Boundary::new(&sides).unwrap());
        let from_strips: Vec<[u32; 3]> = candidate
            .strips()
            .flat_map(|strip| (0..strip.triangle_count()).map(|index| strip.triangle(index)))
            .collect();
        prop_assert_eq!(&from_strips, &candidate.triangles().collect::<Vec<_>>());
        for strip in candidate.strips() {
            let letters = (0..strip.word().len()).map(|index| strip.word().letter(index));
            let xs = letters.filter(|&letter| letter == Letter::X).count();
            prop_assert_eq!(xs as u32 + 1, strip.x().len());
            prop_assert_eq!(strip.word().ys() + 1, strip.y().len());
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn a_million_vertices_verify(sides in sides(64, 1 << 18)) {
        prop_assume!(sides.iter().sum::<u64>() <= 1_000_000);
        let boundary = Boundary::new(&sides).unwrap();
        let candidate = least_degree_triangulation(&boundary);
        let verified = verify(&sides, candidate.triangles());
        let verified = verified.map_err(|defect| TestCaseError::fail(defect.to_string()))?;
        prop_assert_eq!(verified.max_degree, certificate(&boundary).max_degree());
    }
}

/// At the limit no list is possible, but everything is still a formula.
#[test]
fn the_largest_boundaries_are_answered_at_once() {
    let limit = u64::from(mindeg_core::MAX_VERTICES);
    for (sides, max_degree) in [
        (vec![limit - 2, 1, 1], 4_294_967_293),
        (vec![1, limit - 2, 1], 4_294_967_293),
        (vec![limit / 2, limit / 2 - 1, 1], 4),
        (vec![limit / 2 + 1, limit / 2 - 3, 1, 1], 5),
        (vec![limit / 3, limit / 3, limit - 2 * (limit / 3)], 5),
        (vec![limit / 2 - 1, 2, limit / 2 - 3, 2], 5),
        (vec![limit - 1_000_000, 500_000, 500_000], 4297),
    ] {
        let boundary = Boundary::new(&sides).unwrap();
        let certificate = certificate(&boundary);
        assert_eq!(certificate.check(&sides), Ok(max_degree), "{sides:?}");
        for candidate in Candidates::new(&boundary).sample(9) {
            assert_eq!(candidate.max_degree(), max_degree, "{sides:?}");
            check_here_and_there(&boundary, &candidate);
        }
    }
}

fn check_here_and_there(boundary: &Boundary, candidate: &Triangulation) {
    const WINDOW: u32 = 200;
    let last = candidate.triangle_count() - WINDOW;
    let ends = candidate.strips().scan(0_u32, |end, strip| {
        *end += strip.triangle_count();
        Some(end.saturating_sub(WINDOW / 2).min(last))
    });
    for first in (0..last).step_by(100_000_007).chain([last]).chain(ends) {
        let mut block = [[0; 3]; WINDOW as usize];
        candidate.fill_triangles(first, &mut block);
        for (index, triangle) in (first..).zip(block) {
            assert_eq!(triangle, candidate.triangle(index), "{boundary:?}");
            assert!(!boundary.is_flat(triangle), "{boundary:?}: {triangle:?}");
            for (vertex, other) in triangle.into_iter().zip([triangle[1], triangle[2], triangle[0]])
            {
                let neighbors = candidate.neighbors(vertex);
                assert_eq!(neighbors.len() as u32, candidate.degree(vertex));
                assert!(candidate.degree(vertex) <= candidate.max_degree());
                if neighbors.len() < 1000 {
                    assert!(neighbors.into_iter().any(|neighbor| neighbor == other));
                }
            }
        }
    }
}

#[test]
fn the_table_of_known_optima() {
    for (sides, max_degree) in [
        (&[1, 1, 1][..], 2),
        (&[2, 1, 1], 3),
        (&[1, 1, 1, 1], 3),
        (&[3, 1, 1], 4),
        (&[2, 2, 2], 4),
        (&[3, 3, 3], 5),
        (&[3, 3, 2, 2], 4),
        (&[10, 10, 10, 10], 4),
        (&[8, 6, 8, 5], 4),
        (&[12, 9, 4, 4], 5),
        (&[14, 3, 5, 2], 5),
        (&[30, 2, 4, 2], 7),
        (&[1000, 3, 5, 2], 114),
        (&[1000, 1, 10, 2, 500, 1, 3, 100], 5),
        (&[100_000, 1, 1, 1], 50_002),
    ] {
        let candidate = least_degree_triangulation(&Boundary::new(sides).unwrap());
        assert_eq!(candidate.max_degree(), max_degree, "{sides:?}");
        assert_eq!(
            verify(sides, candidate.triangles()).unwrap().max_degree,
            max_degree,
            "{sides:?}"
        );
    }
}

/// The middle shift of a word comes first.
#[test]
fn the_first_mesh_of_a_dominant_side_is_symmetric() {
    for (sides, off_side) in [(&[9, 1, 1, 1, 1, 1, 1][..], 10..15), (&[9, 1, 1, 1, 1], 10..13)] {
        let candidate = least_degree_triangulation(&Boundary::new(sides).unwrap());
        let degrees: Vec<u32> = off_side.map(|vertex| candidate.degree(vertex)).collect();
        let backward: Vec<u32> = degrees.iter().rev().copied().collect();
        assert_eq!(degrees, backward, "{sides:?}");
    }
}
