//! Polygons that are not convex: against all triangulations, and known answers.

use crate::outlines::{Measured, Outline, Random, Rank};
use glam::DVec2;
use mindeg_exact::{
    Cancelled, DegreeRange, LowerBound, Problem, Progress, Reached, Unsolved, best_angle,
    check::CheckedOutline as Rings, degree_range, least_max_degree, trade_off, windows,
};
use mindeg_mesh::planar::PlanarBoundary;
use mindeg_mesh::{Step, check};
use std::ops::ControlFlow;
use std::ops::Range;
use std::slice;

/// Compares the answers under every limit with the best of all triangulations.
fn compare(outline: &Outline, outside: &[u32], own: &[Option<u32>]) {
    let n = outline.len() as u32;
    let mut problem = outline.problem();
    for (vertex, (&outside, &own)) in (0..).zip(outside.iter().zip(own)) {
        problem.set_external_degree(vertex, outside);
        if let Some(own) = own {
            problem.set_degree_limit(vertex, own);
        }
    }
    let all = outline.triangulations();
    let all: Vec<Measured> = all.iter().map(|t| Measured::new(&outline.points, t)).collect();
    assert!(!all.is_empty(), "{outline:?}");
    let limits =
        |limit: u32| own.iter().map(|own| own.unwrap_or(limit).min(limit)).collect::<Vec<_>>();
    let best = |limit: u32| -> Option<Rank> {
        let limits = limits(limit);
        let ranks = all.iter().filter_map(|it| it.rank(&limits, outside));
        ranks.max_by(|a, b| a.partial_cmp(b).unwrap())
    };
    let most = n + outside.iter().max().unwrap();
    let least = (0..=most).find(|&limit| best(limit).is_some());
    let Some(least) = least else {
        assert_eq!(least_max_degree(&problem, Progress::NONE), Err(Unsolved::VertexLimits));
        return;
    };
    assert_eq!(least_max_degree(&problem, Progress::NONE), Ok(least), "{outline:?}");
    let check = |optimum: &mindeg_exact::Optimum, limit: u32| {
        let checked = check::triangulation(&outline.boundary(), &[], &optimum.triangles);
        let measured = Measured::new(&outline.points, &optimum.triangles);
        assert_eq!(checked.unwrap().degrees, measured.degrees);
        let rank = measured.rank(&limits(limit), outside);
        assert_eq!(rank, best(limit), "{outline:?}, {limit}");
        assert_eq!(optimum.vertices_at_limit, rank.unwrap().1.0);
        assert_eq!(optimum.min_angle, libm::atan(measured.tangent).to_degrees());
    };
    let trade_off = trade_off(&problem, Progress::NONE).unwrap();
    let free = best(u32::MAX).unwrap().0;
    for (limit, optimum) in (least..).zip(&trade_off.optima) {
        check(optimum, limit);
        assert_eq!(
            best(limit).unwrap().0 == free,
            limit == least + trade_off.optima.len() as u32 - 1
        );
    }
    for limit in [least - 1, least, least + 1, most] {
        match best_angle(&problem, limit, Progress::NONE) {
            Ok(optimum) => check(&optimum, limit),
            Err(error) => {
                assert_eq!(limit, least - 1, "{outline:?}");
                assert_eq!(error, Unsolved::Infeasible { max_degree: limit, least });
            }
        }
    }
}

/// Calls `test` with random simple polygons, as many as asked for.
fn for_random(seed: u64, count: usize, most: usize, mut test: impl FnMut(&Outline, &mut Random)) {
    let mut random = Random(seed);
    let mut done = 0;
    while done < count {
        let corners = 3 + random.below(most as u64 - 4) as usize;
        let Some(outline) = Outline::random(&mut random, corners, most) else { continue };
        if outline.len() >= 4 {
            test(&outline, &mut random);
            done += 1;
        }
    }
}

#[test]
fn random_polygons_agree_with_all_triangulations() {
    for_random(1, 600, 11, |outline, _| {
        let n = outline.len();
        compare(outline, &vec![0; n], &vec![None; n]);
    });
}

#[test]
fn limits_of_single_vertices_agree_with_all_triangulations() {
    for_random(2, 300, 9, |outline, random| {
        let n = outline.len();
        let outside: Vec<u32> = (0..n).map(|_| random.below(3) as u32).collect();
        let own = |_| (random.below(4) == 0).then(|| 2 + random.below(5) as u32);
        let own: Vec<_> = (0..n).map(own).collect();
        compare(outline, &outside, &own);
    });
}

#[test]
fn known_least_degrees() {
    for (name, outline, least) in [
        ("L 50", Outline::l_shape([13, 6, 6, 6, 6, 13]), 5),
        ("L 102", Outline::l_shape([25, 13, 13, 13, 13, 25]), 5),
        ("L 200", Outline::l_shape([50, 25, 25, 25, 25, 50]), 4),
        ("U inner floor", Outline::u_shape([2, 2, 2, 2, 60, 2, 2, 2]), 23),
        ("U outer floor", Outline::u_shape([90, 2, 2, 2, 2, 2, 2, 2]), 14),
        ("L first side", Outline::l_shape([60, 2, 2, 2, 2, 2]), 11),
        ("comb", Outline::comb(8, 200, 1), 11),
        ("spiral", Outline::spiral(5), 4),
    ] {
        assert!(outline.is_simple(), "{name}");
        let problem = outline.problem();
        let range = degree_range(&problem, Progress::NONE).unwrap();
        assert_eq!((range.max_degree, range.lower_bound), (least, least), "{name}");
        check_range(&outline, &range);
        assert_eq!(matches!(range.reached_by, Reached::ZigZag(_)), least == 4, "{name}");
        assert_eq!(matches!(range.bounded_by, LowerBound::Apexes(_)), name == "U inner floor");
    }
}

#[test]
fn windows_never_go_below_the_least_and_keep_the_angle() {
    let mut reached = 0;
    for_random(3, 300, 11, |outline, random| {
        let problem = outline.problem();
        let all = outline.triangulations();
        let all: Vec<Measured> = all.iter().map(|t| Measured::new(&outline.points, t)).collect();
        let start = Measured::new(&outline.points, &outline.ears());
        let min_tangent = if random.below(2) == 0 { 0.0 } else { start.tangent };
        let least = all
            .iter()
            .filter(|it| it.tangent >= min_tangent)
            .map(|it| it.degrees.iter().copied().max().unwrap())
            .min();
        let windowed = windows(&problem, 0, min_tangent, Progress::NONE).unwrap();
        let checked = check::triangulation(&outline.boundary(), &[], &windowed.triangles).unwrap();
        assert_eq!(checked.max_degree, windowed.max_degree);
        let measured = Measured::new(&outline.points, &windowed.triangles);
        assert!(measured.tangent >= min_tangent, "{outline:?}");
        // Ears may join vertices of one side, which no window does.
        if let Some(least) = least {
            reached += u32::from(windowed.max_degree == least);
        }
    });
    assert!(reached > 290, "{reached}");
}

/// The answer is a triangulation, and what proves it holds.
fn check_range(outline: &Outline, range: &DegreeRange) {
    let n = outline.len() as u32;
    let rings = [0..n, n..n];
    let rings = &rings[..1];
    let checked = check::triangulation(&outline.boundary(), &[], &range.triangles).unwrap();
    assert_eq!(checked.max_degree, range.max_degree);
    assert!(range.lower_bound <= range.max_degree);
    let rings =
        Rings { points: &outline.points, rings, side_of: &outline.side_of, keeps_clear: true };
    match &range.bounded_by {
        LowerBound::BlockedZigZags(blocked) => {
            assert_eq!((range.lower_bound, blocked.len()), (5, n as usize));
            assert!(rings.blocks_all_zigzags(blocked), "{outline:?}");
        }
        LowerBound::Apexes(bound) => {
            assert_eq!(bound.max_degree(), range.lower_bound);
            assert!(rings.bounds_apexes(bound), "{outline:?}");
        }
        _ => {}
    }
}

#[test]
fn degree_ranges_are_right_and_their_proofs_hold() {
    for_random(4, 400, 11, |outline, _| {
        let all = outline.triangulations();
        let degree =
            |t: &Vec<[u32; 3]>| *Measured::new(&outline.points, t).degrees.iter().max().unwrap();
        let least = all.iter().map(degree).min().unwrap();
        let problem = outline.problem();
        let range = degree_range(&problem, Progress::NONE).unwrap();
        assert_eq!((range.max_degree, range.lower_bound), (least, least), "{outline:?}");
        check_range(outline, &range);
        // With no exact work allowed, nothing wrong is said.
        let mut problem = problem;
        problem.set_max_triples(0);
        let range = degree_range(&problem, Progress::NONE).unwrap();
        assert!(range.lower_bound <= least && least <= range.max_degree);
        check_range(outline, &range);
    });
}

/// A frame between two squares, with equal numbers of edges to a side outside and inside.
fn frame(outer: u32, inner: u32) -> (Outline, [Range<u32>; 2], Vec<[u32; 3]>) {
    let square = |half: f64| [(-half, -half), (half, -half), (half, half), (-half, half)];
    let around = Outline::new(&square(2.0), &[outer; 4]);
    let hole = Outline::new(&square(1.0), &[inner; 4]);
    let (n, m) = (around.len() as u32, hole.len() as u32);
    // Clockwise: the domain is on the left.
    let index = |step: u32| n + (m - step % m) % m;
    let mut points = around.points.clone();
    points.push(hole.points[0]);
    points.extend(hole.points[1..].iter().rev());
    let mut side_of = around.side_of.clone();
    side_of.extend((0..m).map(|v| 4 + (m - 1 - v) / inner));
    // A fan at every corner of the hole, from the corner of the outside and its two sides' halves.
    let mut triangles = Vec::new();
    for corner in 0..4 {
        let (tip, next) = (index(corner * inner), index((corner + 1) * inner));
        let from = corner * outer;
        // The whole outer side to the hole's corner where it begins.
        triangles.extend((0..outer).map(|step| [from + step, (from + step + 1) % n, tip]));
        // The hole's side to the outer corner where it ends.
        let end = (from + outer) % n;
        let steps = (0..inner)
            .map(|step| [end, index(corner * inner + step + 1), index(corner * inner + step)]);
        triangles.extend(steps);
        assert_eq!(next, index(corner * inner + inner));
    }
    (Outline { points, side_of }, [0..n, n..n + m], triangles)
}

#[test]
fn windows_take_domains_with_holes() {
    for (outer, inner) in [(1, 1), (4, 2), (10, 5), (100, 50)] {
        let (Outline { points, side_of }, rings, triangles) = frame(outer, inner);
        let slices: Vec<_> =
            rings.iter().map(|r| &points[r.start as usize..r.end as usize]).collect();
        let boundary = PlanarBoundary::new(&slices).unwrap().with_sides(Vec::new(), side_of);
        let before = check::triangulation(&boundary, &[], &triangles).unwrap();
        let problem = Problem::triangulated(&boundary, &triangles).unwrap();
        let range = degree_range(&problem, Progress::NONE).unwrap();
        let after = check::triangulation(&boundary, &[], &range.triangles).unwrap();
        assert_eq!((range.max_degree, range.lower_bound), (after.max_degree, after.max_degree));
        assert!(after.max_degree <= before.max_degree);
        // Degree 4 takes as many vertices around the hole as around the outside.
        assert_eq!(after.max_degree, if outer == inner { 4 } else { 5 });
        assert_eq!(least_max_degree(&problem, Progress::NONE), Ok(after.max_degree));
        assert_eq!(best_angle(&problem, 9, Progress::NONE), Err(Unsolved::NotAPolygon));
    }
}

#[test]
fn every_stage_can_be_cancelled() {
    let mut problem = Outline::l_shape([9, 5, 4, 3, 4, 5]).problem();
    for vertex in 0..problem.points().len() as u32 {
        problem.set_degree_limit(vertex, 5);
    }
    for cancelled in [
        "finding chords",
        "counting triples of vertices",
        "keeping the degree limits of vertices",
        "is degree 4 possible?",
        "bounding the angles",
        "degree 5: the best angle",
        "degree 5: the best mesh",
    ] {
        let watch = |step: Step<'_>| {
            if step.stage == cancelled { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let answer = trade_off(&problem, Progress::new(&watch));
        assert_eq!(answer, Err(Unsolved::Cancelled(Cancelled)), "{cancelled}");
    }
}

#[test]
fn answers_do_not_depend_on_the_number_of_threads() {
    let outlines = [Outline::l_shape([60, 30, 30, 30, 30, 60]), Outline::gear(12, 6)];
    for outline in outlines {
        let problem = outline.problem();
        let solve = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| {
                (
                    trade_off(&problem, Progress::NONE).unwrap(),
                    degree_range(&problem, Progress::NONE).unwrap(),
                    windows(&problem, 0, 1e-6, Progress::NONE).unwrap(),
                )
            })
        };
        let one = solve(1);
        assert_eq!(solve(2), one);
        assert_eq!(solve(5), one);
    }
}

#[test]
fn other_triangles_than_a_triangulation_are_refused() {
    let points = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0), (1.0, 1.0)].map(DVec2::from);
    let refusal = |count: usize, triangles: &[[u32; 3]]| {
        let boundary = PlanarBoundary::of_mesh(&[&points[..count]]);
        Problem::triangulated(&boundary, triangles).unwrap_err().to_string()
    };
    for (count, triangles, message) in [
        (4, &[[0, 1, 4]][..], "triangle 0 has vertex 4, but the vertices are 0 to 3"),
        (
            4,
            &[[0, 1, 2], [0, 3, 2]],
            "triangle 1 is clockwise or has no area; give counter-clockwise triangles",
        ),
        (
            4,
            &[[0, 1, 2], [0, 1, 3]],
            "the edge from 0 to 1 has two triangles on the same side; remove one of them",
        ),
        (
            5,
            &[[0, 1, 2], [0, 2, 3]],
            "the triangles have another boundary than the domain; give a triangulation of it",
        ),
    ] {
        assert_eq!(refusal(count, triangles), message);
    }
}

/// Counting and searching as the checker does it, against every triangulation.
#[test]
fn the_checkers_bounds_are_those_of_all_triangulations() {
    for_random(11, 300, 10, |outline, random| {
        let n = outline.len() as u32;
        let rings = slice::from_ref(&(0..n)).to_vec();
        let problem = outline.problem();
        let checker = Rings {
            points: &outline.points,
            rings: &rings,
            side_of: &outline.side_of,
            keeps_clear: true,
        };
        let external: Vec<u32> = (0..n).map(|_| random.below(3) as u32).collect();
        let all = outline.triangulations();
        let all: Vec<Measured> = all.iter().map(|t| Measured::new(&outline.points, t)).collect();
        let total = |measured: &Measured| {
            measured
                .degrees
                .iter()
                .zip(&external)
                .map(|(degree, more)| degree + more)
                .max()
                .unwrap()
        };
        let least = all.iter().map(total).min().unwrap();
        assert!(checker.counting_bound(|vertex| external[vertex as usize]) <= least);
        let chords = |limit: u32| -> Option<Vec<u32>> {
            external.iter().map(|&external| limit.checked_sub(external + 2)).collect()
        };
        let is_possible = |limit: u32| match chords(limit) {
            Some(chords) => checker.has_triangulation(&chords, 1 << 30).unwrap(),
            None => false,
        };
        assert!(is_possible(least) && !is_possible(least - 1), "{outline:?}, {external:?}");
        assert_eq!(problem.points().len(), n as usize);
    });
}

/// Found by fuzzing: runs of sides that leave no chord between different ones.
#[test]
fn a_polygon_that_only_chords_along_sides_triangulate_has_them() {
    let points = [(4.0, 4.0), (4.0, 5.0), (0.0, 30.0), (0.0, 0.0)].map(DVec2::from);
    let boundary = PlanarBoundary::of_mesh(&[points]).with_sides(Vec::new(), vec![0, 0, 1, 0]);
    let problem = Problem::triangulated(&boundary, &[[0, 1, 3], [1, 2, 3]]).unwrap();
    let answer = trade_off(&problem, Progress::NONE).unwrap();
    assert_eq!(answer.optima[0].max_degree, 3);
    assert!(best_angle(&problem, 9, Progress::NONE).is_ok());
}

/// Found by fuzzing: the given triangulation had a chord that the sides forbid, and degree 4, below
/// what was proven of all triangulations without it.
#[test]
fn a_chord_behind_a_bulge_of_one_unit_is_no_proof_of_less() {
    let x = 4.428571428571428_f64;
    let points = [
        (x, x),
        (x.next_up(), 3.714285714285714),
        (x.next_up(), 9.0),
        (2.1428571428571423, 4.285714285714285),
        (1.5714285714285716, 2.9999999999999996),
        (4.0, x.next_up()),
        (x, x.next_up().next_up()),
    ]
    .map(DVec2::from);
    let start = [[2, 6, 1], [3, 4, 5], [0, 1, 6], [5, 6, 2], [5, 2, 3]];
    let sides = vec![0, 1, 2, 3, 4, 5, 0];
    let boundary = PlanarBoundary::of_mesh(&[points]).with_sides(Vec::new(), sides);
    let problem = Problem::triangulated(&boundary, &start).unwrap();
    let range = degree_range(&problem, Progress::NONE).unwrap();
    assert!(range.is_proven(), "{range:?}");
}
