//! Strips between rings beside all strips there are.

use glam::DVec3;
use mindeg_core::RingStrip;
use mindeg_exact::{Bridge, BridgeProblem, Cancelled, Progress, Unsolved, bridge_rings};
use proptest::prelude::*;
use std::ops::ControlFlow;

/// All strips between rings of p and q vertices: each start on the y ring for vertex 0 of the x
/// ring, and each word after it that begins with X. All X in one run, then all Y, have an edge twice.
fn strips(p: u32, q: u32) -> Vec<Vec<[u32; 3]>> {
    let mut all = Vec::new();
    for start in 0..q {
        for word in 0..1_u32 << (p + q) {
            // The first letter X leaves vertex 0, so each cyclic word is there once.
            if word.count_ones() != p || word & 1 == 0 {
                continue;
            }
            let changes =
                (0..p + q).filter(|&l| (word >> l ^ word >> ((l + 1) % (p + q))) & 1 == 1);
            if changes.count() == 2 {
                continue;
            }
            let (mut i, mut j) = (0, start);
            let triangles = (0..p + q).map(|letter| {
                if word >> letter & 1 == 1 {
                    let from = i;
                    i = (i + 1) % p;
                    [from, i, p + j]
                } else {
                    let from = j;
                    j = (j + 1) % q;
                    [i, p + j, p + from]
                }
            });
            all.push(triangles.collect());
        }
    }
    all
}

#[derive(Debug)]
struct Case {
    rings: [Vec<DVec3>; 2],
    external: [Vec<u32>; 2],
    excluded: Vec<[u32; 2]>,
}

impl Case {
    fn problem(&self) -> BridgeProblem {
        let points = [&self.rings[0][..], &self.rings[1]];
        let external = [&self.external[0][..], &self.external[1]];
        BridgeProblem::new(points, external, self.excluded.iter().copied()).unwrap()
    }

    fn p(&self) -> u32 {
        self.rings[0].len() as u32
    }

    fn point(&self, vertex: u32) -> DVec3 {
        self.rings.iter().flatten().nth(vertex as usize).copied().unwrap()
    }

    /// The edges between the rings.
    fn edges(&self, triangles: &[[u32; 3]]) -> Vec<[u32; 2]> {
        let p = self.p();
        let mut edges: Vec<[u32; 2]> = triangles
            .iter()
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
            .map(|[a, b]| [a.min(b), a.max(b)])
            .filter(|&[a, b]| a < p && b >= p)
            .collect();
        edges.sort_unstable();
        edges.dedup();
        edges
    }

    fn max_degree(&self, triangles: &[[u32; 3]]) -> u32 {
        let mut degrees = self.external.concat();
        for edge in self.edges(triangles) {
            edge.into_iter().for_each(|vertex| degrees[vertex as usize] += 1);
        }
        degrees.into_iter().max().unwrap()
    }

    fn min_angle(&self, triangles: &[[u32; 3]]) -> f64 {
        let angle = |&[a, b, c]: &[u32; 3]| {
            let [a, b, c] = [a, b, c].map(|vertex| self.point(vertex));
            let at = |a: DVec3, b: DVec3, c: DVec3| (b - a).angle_between(c - a).to_degrees();
            at(a, b, c).min(at(b, c, a)).min(at(c, a, b))
        };
        triangles.iter().map(angle).min_by(f64::total_cmp).unwrap()
    }

    fn is_allowed(&self, triangles: &[[u32; 3]]) -> bool {
        let p = self.p();
        self.edges(triangles).iter().all(|&[i, j]| !self.excluded.contains(&[i, j - p]))
    }

    fn least_and_best(&self, strips: &[Vec<[u32; 3]>]) -> Option<(u32, Vec<(u32, f64)>)> {
        let mut best: Vec<(u32, f64)> = Vec::new();
        for strip in strips.iter().filter(|strip| self.is_allowed(strip)) {
            best.push((self.max_degree(strip), self.min_angle(strip)));
        }
        let least = best.iter().map(|&(degree, _)| degree).min()?;
        Some((least, best))
    }
}

fn solve(case: &Case, limit: Option<u32>) -> Result<Bridge, Unsolved> {
    bridge_rings(&case.problem(), limit, Progress::NONE)
}

fn best_under(all: &[(u32, f64)], limit: u32) -> Option<f64> {
    let kept = all.iter().filter(|&&(degree, _)| degree <= limit).map(|&(_, angle)| angle);
    kept.max_by(f64::total_cmp)
}

fn ring(n: usize, radius: f64, z: f64, turn: f64) -> Vec<DVec3> {
    let point = |i: usize| {
        let angle = std::f64::consts::TAU * i as f64 / n as f64 + turn;
        DVec3::new(radius * libm::cos(angle), radius * libm::sin(angle), z)
    };
    (0..n).map(point).collect()
}

fn cases() -> impl Strategy<Value = Case> {
    (3_usize..=6, 3_usize..=6).prop_flat_map(|(p, q)| {
        let noise = || prop::collection::vec(prop::array::uniform3(-0.4..0.4_f64), p + q);
        let external = prop::collection::vec(2_u32..5, p + q);
        let pair = [0..p as u32, 0..q as u32];
        let excluded = prop::collection::vec(pair, 0..4);
        (noise(), external, excluded).prop_map(move |(noise, external, excluded)| {
            let mut x = ring(p, 2.0, 0.0, 0.1);
            let mut y = ring(q, 1.5, 1.0, 0.4);
            x.iter_mut()
                .chain(&mut y)
                .zip(&noise)
                .for_each(|(point, &by)| *point += DVec3::from(by));
            let (a, b) = external.split_at(p);
            Case { rings: [x, y], external: [a.to_vec(), b.to_vec()], excluded }
        })
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn no_strip_within_the_limit_has_a_larger_minimum_angle(case in cases()) {
        let [p, q] = [0, 1].map(|ring| case.rings[ring].len() as u32);
        let strips = strips(p, q);
        let Some((least, all)) = case.least_and_best(&strips) else {
            prop_assert_eq!(solve(&case, None).unwrap_err(), Unsolved::Excluded);
            return Ok(());
        };
        let default = solve(&case, None).unwrap();
        prop_assert_eq!(default.least_max_degree, least);
        prop_assert_eq!(default.max_degree, least);
        prop_assert!(default.lower_bound <= least);
        for limit in least - 1..least + 4 {
            let Some(best) = best_under(&all, limit) else {
                let error = solve(&case, Some(limit)).unwrap_err();
                prop_assert_eq!(error, Unsolved::Infeasible { max_degree: limit, least });
                continue;
            };
            let found = solve(&case, Some(limit)).unwrap();
            prop_assert!((found.min_angle - best).abs() < 1e-7, "{} {best}", found.min_angle);
            prop_assert!((case.min_angle(&found.triangles) - best).abs() < 1e-7);
            prop_assert_eq!(case.max_degree(&found.triangles), found.max_degree);
            prop_assert!(found.max_degree <= limit && case.is_allowed(&found.triangles));
            prop_assert_eq!(found.triangles.len() as u32, p + q);
            let mut sorted = found.triangles.clone();
            sorted.sort_unstable();
            let is_strip = strips.iter().any(|strip| {
                let mut strip = strip.clone();
                strip.sort_unstable();
                strip == sorted
            });
            prop_assert!(is_strip);
            let next = best_under(&all, limit + 1).unwrap();
            prop_assert_eq!(found.next_min_angle.is_some(), next > best + 1e-9, "{} {}", next, best);
            let free = best_under(&all, u32::MAX).unwrap();
            prop_assert!((found.without_limit.0 - free).abs() < 1e-7);
        }
    }
}

#[test]
fn the_closed_form_is_reached_in_space() {
    for p in 3..=9 {
        for q in 3..=9 {
            let case = Case {
                rings: [ring(p, 2.0, 0.0, 0.0), ring(q, 2.0, 1.0, 0.2)],
                external: [vec![2; p], vec![2; q]],
                excluded: vec![],
            };
            let found = solve(&case, None).unwrap();
            let closed = RingStrip::new(p as u32, q as u32).unwrap().max_degree();
            let degrees = (found.least_max_degree, found.lower_bound, found.max_degree);
            assert_eq!(degrees, (closed, closed, closed), "{p}, {q}");
        }
    }
}

#[test]
fn in_a_plane_the_strip_covers_the_annulus_once() {
    let circle = |n: usize, radius: f64| ring(n, radius, 0.0, 0.0);
    let area = |ring: &[DVec3]| -> f64 {
        let next = ring.iter().cycle().skip(1);
        ring.iter().zip(next).map(|(a, b)| a.truncate().perp_dot(b.truncate()) / 2.0).sum()
    };
    // A hole that is near one side, and a star whose inner corners hide what is behind them.
    let shifted: Vec<DVec3> = circle(7, 0.3).into_iter().map(|p| p + DVec3::X * 0.6).collect();
    let mut star = circle(24, 1.0);
    star.iter_mut().step_by(2).for_each(|point| *point *= 0.55);
    for (outer, inner) in
        [(circle(24, 1.0), circle(9, 0.4)), (circle(24, 1.0), shifted), (star, circle(30, 0.5))]
    {
        for swap in [false, true] {
            let [mut x, mut y] = [outer.clone(), inner.clone()];
            if swap {
                std::mem::swap(&mut x, &mut y);
            }
            let external = [vec![2; x.len()], vec![2; y.len()]];
            let case = Case { rings: [x, y], external, excluded: vec![] };
            let found = solve(&case, None).unwrap();
            assert!(found.is_planar);
            let sign = if swap { -1.0 } else { 1.0 };
            let areas = found.triangles.iter().map(|&[a, b, c]| {
                let [a, b, c] = [a, b, c].map(|vertex| case.point(vertex).truncate());
                sign * (b - a).perp_dot(c - a) / 2.0
            });
            let areas: Vec<f64> = areas.collect();
            assert!(areas.iter().all(|&area| area > 0.0));
            let sum: f64 = areas.iter().sum();
            assert!((sum - area(&outer) + area(&inner)).abs() < 1e-12);
        }
    }
    // Side by side, one clockwise, and one that nobody sees all round.
    let beside: Vec<DVec3> = circle(9, 0.4).into_iter().map(|p| p + DVec3::X * 3.0).collect();
    let clockwise: Vec<DVec3> = circle(9, 0.4).into_iter().rev().collect();
    for inner in [beside, clockwise] {
        let external = [vec![2; 24], vec![2; 9]];
        let case = Case { rings: [circle(24, 1.0), inner], external, excluded: vec![] };
        let refused = solve(&case, None).unwrap_err().to_string();
        assert!(refused.starts_with("both loops lie in one plane"), "{refused}");
    }
}

#[test]
fn work_is_cancelled_and_wrong_rings_are_refused() {
    let case = Case {
        rings: [ring(9, 2.0, 0.0, 0.0), ring(5, 2.0, 1.0, 0.2)],
        external: [vec![2; 9], vec![2; 5]],
        excluded: vec![],
    };
    let cancel = |_: mindeg_mesh::Step<'_>| ControlFlow::Break(());
    let found = bridge_rings(&case.problem(), None, Progress::new(&cancel));
    assert_eq!(found, Err(Unsolved::Cancelled(Cancelled)));
    let line = [DVec3::ZERO, DVec3::X];
    let refused = BridgeProblem::new([&case.rings[0], &line], [&[2; 9], &[2; 2]], []);
    assert_eq!(refused.unwrap_err().to_string(), "a ring has 2 vertices; the minimum is 3");
    // All in one point: degree still has its least, angles have none.
    let case = Case {
        rings: [vec![DVec3::ONE; 5], vec![DVec3::ONE; 4]],
        external: [vec![2; 5], vec![2; 4]],
        excluded: vec![],
    };
    let found = solve(&case, None).unwrap();
    assert_eq!((found.max_degree, found.min_angle), (5, 0.0));
}
