//! The answers against solvers that are slow and plainly right.

use crate::plain::{Instance, Rank, instances, regular};
use mindeg_exact::{Progress, Unsolved, best_angle, least_max_degree, trade_off};
use proptest::prelude::*;

/// Checks the answers for every limit up to one above the degrees there can be.
fn check(instance: &Instance, best: impl Fn(&Instance, u32) -> Option<Rank>) {
    let problem = instance.problem();
    let outside = instance.outside.iter().max().unwrap();
    let largest = instance.boundary.vertex_count() + outside;
    let ranks: Vec<Option<Rank>> = (0..=largest).map(|limit| best(instance, limit)).collect();
    let least = ranks.iter().position(Option::is_some);

    let refused = |max_degree| match least {
        Some(least) => Unsolved::Infeasible { max_degree, least: least as u32 },
        None => Unsolved::VertexLimits,
    };
    for (max_degree, rank) in (0..).zip(&ranks) {
        match (best_angle(&problem, max_degree, Progress::NONE), *rank) {
            (Ok(optimum), Some(rank)) => instance.check(&optimum, max_degree, rank),
            (answer, _) => assert_eq!(answer, Err(refused(max_degree)), "{instance:?}"),
        }
    }
    let Some(least) = least else {
        assert_eq!(trade_off(&problem, Progress::NONE), Err(Unsolved::VertexLimits));
        return;
    };
    assert_eq!(least_max_degree(&problem, Progress::NONE), Ok(least as u32), "{instance:?}");

    let trade_off = trade_off(&problem, Progress::NONE).unwrap();
    let tangent = |limit: usize| ranks[limit].unwrap().0;
    let last = (least..).find(|&limit| tangent(limit) == tangent(largest as usize)).unwrap();
    assert_eq!(trade_off.optima.len(), last - least + 1, "{instance:?}");
    for (max_degree, optimum) in (least..).zip(&trade_off.optima) {
        instance.check(optimum, max_degree as u32, ranks[max_degree].unwrap());
    }
    let unlimited = Instance::new(&instance.sides, instance.points.clone());
    let (tangent, _, _) = best(&unlimited, largest).unwrap();
    assert_eq!(trade_off.unlimited_min_angle, libm::atan(tangent).to_degrees());
}

#[test]
fn small_symmetric_domains_agree_with_all_triangulations() {
    for sides in [
        &[1, 1, 1][..],
        &[2, 1, 1],
        &[2, 2, 2],
        &[4, 4, 4],
        &[7, 1, 1],
        &[1, 1, 1, 1],
        &[2, 2, 2, 2],
        &[3, 3, 3, 3],
        &[5, 1, 5, 1],
        &[3, 3, 2, 2],
        &[8, 2, 1, 1],
        &[2, 2, 2, 2, 2],
        &[1, 1, 1, 1, 1, 1, 1, 1, 1],
        &[2, 1, 2, 1, 2, 1],
    ] {
        check(&Instance::uniform(&regular(sides.len(), 1.0), sides), Instance::best_of_all);
    }
}

/// Degrees so large that most vertices are not counted at first.
#[test]
fn large_degrees_agree_with_a_plain_table() {
    for (sides, ratio) in [
        (&[16, 1, 1][..], 1.0),
        (&[18, 1, 3], 1.3),
        (&[14, 2, 1, 2], 0.9),
        (&[12, 1, 2, 1, 2], 1.0),
        (&[7, 6, 5, 1], 0.6),
        (&[9, 8, 2], 1.5),
    ] {
        let graded = |_, place: f64| place / (place + ratio * (1.0 - place)).powi(3);
        let corners = regular(sides.len(), 1.4);
        check(&Instance::spaced(&corners, sides, graded), Instance::best_by_table);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn agrees_with_all_triangulations(instance in instances(9)) {
        check(&instance, Instance::best_of_all);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    #[test]
    fn agrees_with_all_triangulations_of_twelve_vertices(instance in instances(12)) {
        prop_assume!(instance.points.len() == 12);
        let limit = mindeg_core::least_max_degree(&instance.boundary) + 1;
        let best = instance.best_of_all(limit);
        match best_angle(&instance.problem(), limit, Progress::NONE) {
            Ok(optimum) => instance.check(&optimum, limit, best.unwrap()),
            Err(_) => prop_assert_eq!(best, None),
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn agrees_with_a_plain_table(instance in instances(14)) {
        check(&instance, Instance::best_by_table);
    }
}
