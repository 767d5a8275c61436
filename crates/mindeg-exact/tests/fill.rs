//! Loops in space beside all triangulations there are.

use glam::DVec3;
use mindeg_exact::{
    Cancelled, LoopLimit, LoopProblem, LoopTriangulation, Progress, Unsolved, fill_loop,
};
use proptest::prelude::*;
use std::ops::ControlFlow;

/// All triangulations of the piece from i to j.
fn triangulations(i: u32, j: u32) -> Vec<Vec<[u32; 3]>> {
    if j - i == 1 {
        return vec![vec![]];
    }
    let mut all = Vec::new();
    for k in i + 1..j {
        for left in triangulations(i, k) {
            for right in triangulations(k, j) {
                all.push([&left[..], &right, &[[i, k, j]]].concat());
            }
        }
    }
    all
}

#[derive(Debug)]
struct Case {
    points: Vec<DVec3>,
    external: Vec<u32>,
    excluded: Vec<[u32; 2]>,
}

impl Case {
    fn problem(&self) -> LoopProblem {
        LoopProblem::new(&self.points, &self.external, self.excluded.iter().copied()).unwrap()
    }

    fn area(&self, triangles: &[[u32; 3]]) -> f64 {
        let at = |v: u32| self.points[v as usize];
        triangles.iter().map(|&[a, b, c]| (at(b) - at(a)).cross(at(c) - at(a)).length() / 2.0).sum()
    }

    fn degrees(&self, triangles: &[[u32; 3]]) -> Vec<u32> {
        let n = self.points.len() as u32;
        let mut degrees = self.external.clone();
        for (a, b) in chords(triangles, n) {
            degrees[a as usize] += 1;
            degrees[b as usize] += 1;
        }
        degrees
    }

    fn is_allowed(&self, triangles: &[[u32; 3]]) -> bool {
        let n = self.points.len() as u32;
        let is_excluded = |&(a, b): &(u32, u32)| {
            self.excluded.iter().any(|&[c, d]| (a, b) == (c.min(d), c.max(d)))
        };
        !chords(triangles, n).iter().any(is_excluded)
    }

    fn keeps(&self, triangles: &[[u32; 3]], limit: u32) -> bool {
        let degrees = self.degrees(triangles);
        degrees.iter().zip(&self.external).all(|(&d, &own)| d <= limit.max(own))
    }

    #[track_caller]
    fn check(&self, filled: &LoopTriangulation) {
        let n = self.points.len();
        assert_eq!(filled.triangles.len(), n - 2);
        assert_eq!(chords(&filled.triangles, n as u32).len(), n - 3);
        assert!(self.is_allowed(&filled.triangles));
        assert_eq!(self.degrees(&filled.triangles).into_iter().max(), Some(filled.max_degree));
        assert!((self.area(&filled.triangles) - filled.area).abs() < 1e-12 * (1.0 + filled.area));
        assert!(self.keeps(&filled.triangles, filled.limit), "{filled:?}");
    }
}

const LEAST_FROM_6: LoopLimit = LoopLimit::LeastWithin { from: 6, extra_area: f64::INFINITY };

/// The edges that are not edges of the loop, each once.
fn chords(triangles: &[[u32; 3]], n: u32) -> Vec<(u32, u32)> {
    let mut edges: Vec<(u32, u32)> = triangles
        .iter()
        .flat_map(|&[a, b, c]| [(a, b), (b, c), (a, c)])
        .map(|(a, b)| (a.min(b), a.max(b)))
        .filter(|&(a, b)| b - a > 1 && (a, b) != (0, n - 1))
        .collect();
    edges.sort_unstable();
    edges.dedup();
    edges
}

fn cases() -> impl Strategy<Value = Case> {
    (3_usize..=10).prop_flat_map(|n| {
        let points = prop::collection::vec(prop::array::uniform3(-8_i32..8), n);
        let external = prop::collection::vec(2_u32..7, n);
        let pair = [0..n as u32, 0..n as u32];
        let excluded = prop::collection::vec(pair, 0..n / 2);
        (points, external, excluded, any::<bool>()).prop_map(
            |(points, external, excluded, flat)| {
                let point = |p: [i32; 3]| {
                    // Coordinates that are not round, and often planes.
                    let [x, y, z] = p.map(|x| f64::from(x) + 0.1 * f64::from(x * x));
                    DVec3::new(x, y, if flat { 0.0 } else { z })
                };
                Case {
                    points: points.into_iter().map(point).collect(),
                    external,
                    excluded: excluded.into_iter().filter(|[a, b]| a != b).collect(),
                }
            },
        )
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn no_triangulation_within_the_limit_has_less_area(case in cases()) {
        let n = case.points.len();
        let all = triangulations(0, n as u32 - 1);
        let allowed: Vec<_> =
            all.iter().filter(|triangles| case.is_allowed(triangles)).collect();
        let solve = |limit| fill_loop(&case.problem(), limit, Progress::NONE);
        if allowed.is_empty() {
            prop_assert_eq!(solve(LoopLimit::AtMost(1000)), Err(Unsolved::Excluded));
            prop_assert_eq!(solve(LoopLimit::AtMost(9)), Err(Unsolved::Excluded));
            return Ok(());
        }
        // Flat triangles are avoided before area, so only loops without any tell areas.
        let is_flat = |&[a, b, c]: &[u32; 3]| {
            let [a, b, c] = [a, b, c].map(|v| case.points[v as usize]);
            (b - a).cross(c - a).length() < 1e-8
        };
        let flat = |triangles: &[[u32; 3]]| triangles.iter().filter(|t| is_flat(t)).count();
        let fewest_flat = allowed.iter().map(|t| flat(t)).min().unwrap();
        let least = |limit: u32, flats: Option<usize>| {
            let kept = allowed.iter().filter(|t| case.keeps(t, limit));
            let kept: Vec<_> = kept.filter(|t| flats.is_none_or(|most| flat(t) <= most)).collect();
            let fewest = kept.iter().map(|t| flat(t)).min()?;
            let best = kept.iter().filter(|t| flat(t) == fewest).map(|t| case.area(t));
            best.min_by(f64::total_cmp)
        };
        let is_least = |area: f64, least: f64| (area - least).abs() <= 1e-8 * (1.0 + least);

        let free = solve(LoopLimit::AtMost(1000)).unwrap();
        case.check(&free);
        prop_assert!(is_least(free.area, least(1000, None).unwrap()));
        let mut least_limit = None;
        for limit in 2..12 {
            match (solve(LoopLimit::AtMost(limit)), least(limit, None)) {
                (Ok(filled), Some(least)) => {
                    case.check(&filled);
                    prop_assert_eq!(filled.limit, limit);
                    prop_assert!(is_least(filled.area, least), "{} {least}", filled.area);
                    prop_assert_eq!(filled.without_limit, (free.area, free.max_degree));
                    least_limit = least_limit.or(Some(limit));
                }
                (Err(Unsolved::Infeasible { max_degree: asked, least: told }), None) => {
                    prop_assert_eq!(asked, limit);
                    let possible = (limit..).find(|&limit| least(limit, None).is_some());
                    prop_assert_eq!(Some(told), possible);
                }
                other => prop_assert!(false, "{other:?}"),
            }
        }
        let default = solve(LEAST_FROM_6).unwrap();
        case.check(&default);
        let expected = (6..).find(|&limit| least(limit, Some(fewest_flat)).is_some());
        prop_assert_eq!(Some(default.limit), expected);
        prop_assert!(is_least(default.area, least(expected.unwrap(), None).unwrap()));
        prop_assert_eq!(default.least_limit, None);
        // Within an area: the least limit whose area is small enough; the first one is told.
        for extra_area in [0.0, 0.02, 0.2] {
            let within = solve(LoopLimit::LeastWithin { from: 6, extra_area }).unwrap();
            case.check(&within);
            let most = (1.0 + extra_area) * free.area;
            let is_near = |area: f64| (area / most - 1.0).abs() < 1e-9;
            let fits = |limit: &u32| {
                least(*limit, Some(fewest_flat)).is_some_and(|area| area <= most || is_near(area))
            };
            let limit = (6..).find(fits).unwrap();
            prop_assert!(within.limit == limit || is_near(least(limit, None).unwrap()));
            prop_assert!(within.area <= most * (1.0 + 1e-9));
            if within.limit == default.limit {
                prop_assert_eq!(within.least_limit, None);
            } else {
                prop_assert_eq!(within.least_limit.map(|it| it.0), Some(default.limit));
            }
        }
    }
}

/// A wavy loop on a cylinder.
fn wavy(n: usize) -> Vec<DVec3> {
    let point = |i: usize| {
        let angle = std::f64::consts::TAU * i as f64 / n as f64;
        DVec3::new(libm::cos(angle), libm::sin(angle), 0.4 * libm::cos(6.0 * angle))
    };
    (0..n).map(point).collect()
}

#[test]
fn any_number_of_threads_gives_the_same_triangles() {
    let points = wavy(70);
    let solve = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let problem = LoopProblem::new(&points, &[3; 70], [[0, 35]]).unwrap();
        pool.install(|| fill_loop(&problem, LEAST_FROM_6, Progress::NONE).unwrap())
    };
    let one = solve(1);
    assert_eq!(one.limit, 6);
    for threads in [2, 7] {
        assert_eq!(solve(threads), one);
    }
}

#[test]
fn work_is_cancelled() {
    let problem = LoopProblem::new(&wavy(40), &[4; 40], []).unwrap();
    for last in ["least area", "least area under degree limit 6"] {
        let cancel = |step: mindeg_mesh::Step<'_>| {
            if step.stage == last { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let found = fill_loop(&problem, LEAST_FROM_6, Progress::new(&cancel));
        assert_eq!(found, Err(Unsolved::Cancelled(Cancelled)), "{last}");
    }
}

#[test]
fn large_loops_and_huge_coordinates_are_refused_or_solved() {
    let error = LoopProblem::new(&wavy(2001), &[2; 2001], []).unwrap_err();
    assert_eq!(error.to_string(), "the loop has 2001 vertices; the maximum is 2000");
    for size in [1e300, 1e-300, 0.0] {
        let points: Vec<DVec3> = wavy(12).into_iter().map(|point| point * size).collect();
        let problem = LoopProblem::new(&points, &[2; 12], []).unwrap();
        let filled = fill_loop(&problem, LEAST_FROM_6, Progress::NONE).unwrap();
        assert_eq!((filled.triangles.len(), filled.limit), (10, 6), "{size}");
    }
    // All on one line: each triangle is flat, and the loop closes all the same.
    let line: Vec<DVec3> = (0..9).map(|i| DVec3::X * f64::from(i)).collect();
    let problem = LoopProblem::new(&line, &[2; 9], []).unwrap();
    let filled = fill_loop(&problem, LEAST_FROM_6, Progress::NONE).unwrap();
    assert_eq!((filled.area, filled.triangles.len()), (0.0, 7));
}
