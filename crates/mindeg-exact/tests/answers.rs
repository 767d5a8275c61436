//! Known answers, and what must hold of every answer.

use glam::DVec2;
use mindeg_core::{Boundary, verify};
use mindeg_exact::{
    Cancelled, LowerBound, Problem, Progress, Unsolved, best_angle, least_max_degree, lower_bound,
    measure, trade_off,
};
use mindeg_mesh::Step;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::ControlFlow;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// A rectangle with equal intervals on each side, its lower left corner at `x`, 0.
fn rectangle(x: f64, sides: &[u64; 4]) -> (Boundary, Vec<DVec2>) {
    let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)].map(DVec2::from);
    let mut points = Vec::new();
    for (side, &intervals) in sides.iter().enumerate() {
        let (from, to) = (corners[side], corners[(side + 1) % 4]);
        for step in 0..intervals {
            let point = from + (to - from) * (step as f64 / intervals as f64);
            points.push(point + DVec2::new(x, 0.0));
        }
    }
    (Boundary::new(sides).unwrap(), points)
}

fn rectangle_problem(sides: &[u64; 4]) -> Problem {
    let (boundary, points) = rectangle(0.0, sides);
    Problem::new(&boundary, &points).unwrap()
}

fn placed(sides: &[u64], points: &[(f64, f64)]) -> Problem {
    let points: Vec<DVec2> = points.iter().copied().map(DVec2::from).collect();
    Problem::new(&Boundary::new(sides).unwrap(), &points).unwrap()
}

/// The minimum angle in degrees, by the law of cosines.
fn min_angle(points: &[DVec2], triangles: &[[u32; 3]]) -> f64 {
    let angles = triangles.iter().flat_map(|&[a, b, c]| {
        [[a, b, c], [b, c, a], [c, a, b]].map(|corners| {
            let [at, left, right] = corners.map(|vertex| points[vertex as usize]);
            (left - at).normalize().dot((right - at).normalize()).acos().to_degrees()
        })
    });
    angles.fold(f64::INFINITY, f64::min)
}

#[test]
fn the_angles_of_the_4_by_3_rectangle() {
    for (sides, least, angles, unlimited) in [
        (&[10, 10, 10, 10], 4, &[2.936, 6.340][..], 6.340),
        (&[12, 9, 4, 4], 5, &[5.528, 6.340], 6.340),
        (&[8, 6, 8, 5], 4, &[5.194, 9.462], 9.462),
        (&[14, 3, 5, 2], 5, &[5.314, 5.394, 5.413], 5.413),
    ] {
        let problem = rectangle_problem(sides);
        let trade_off = trade_off(&problem, Progress::NONE).unwrap();
        let to_three_decimals = |angle: f64| (angle * 1000.0).round() / 1000.0;
        assert_eq!(to_three_decimals(trade_off.unlimited_min_angle), unlimited, "{sides:?}");
        assert_eq!(trade_off.optima.len(), angles.len(), "{sides:?}");
        for ((limit, optimum), &angle) in (least..).zip(&trade_off.optima).zip(angles) {
            assert_eq!(optimum.max_degree, limit);
            assert_eq!(to_three_decimals(optimum.min_angle), angle, "{sides:?}, {limit}");
            let measured = min_angle(problem.points(), &optimum.triangles);
            assert!((measured / optimum.min_angle - 1.0).abs() < 1e-10, "{sides:?}, {limit}");
            let verified = verify(sides, optimum.triangles.iter().copied()).unwrap();
            assert!(verified.max_degree <= limit, "{sides:?}, {limit}");
            let at_limit = verified.degrees.iter().filter(|&&degree| degree == limit).count();
            assert_eq!(optimum.vertices_at_limit, at_limit as u32, "{sides:?}, {limit}");
        }
        // Above the last limit nothing is to be gained.
        let above = best_angle(&problem, 100, Progress::NONE).unwrap();
        assert_eq!(above.min_angle, trade_off.optima.last().unwrap().min_angle);
        let refused = Unsolved::Infeasible { max_degree: least - 1, least };
        assert_eq!(best_angle(&problem, least - 1, Progress::NONE), Err(refused));
    }
}

#[test]
fn limits_that_conflict_are_refused() {
    let mut problem = rectangle_problem(&[12, 9, 4, 4]);
    let refusal = |problem: &Problem, max_degree| {
        best_angle(problem, max_degree, Progress::NONE).unwrap_err().to_string()
    };
    let at_least_5 = "no triangulation here has maximum degree 4; the least is 5";
    assert_eq!(refusal(&problem, 4), at_least_5);
    assert_eq!(refusal(&problem, 0), "no triangulation here has maximum degree 0; the least is 5");

    // Vertex 5 is inside the first side: with no chord at it, its neighbours would be joined.
    problem.set_degree_limit(5, 2);
    let vertex_limits = "no triangulation keeps the degree limits of single vertices, whatever its \
                         maximum degree; raise these limits";
    assert_eq!(refusal(&problem, 100), vertex_limits);
    assert_eq!(least_max_degree(&problem, Progress::NONE), Err(Unsolved::VertexLimits));
    assert_eq!(trade_off(&problem, Progress::NONE), Err(Unsolved::VertexLimits));

    problem.set_degree_limit(5, 3);
    assert_eq!(least_max_degree(&problem, Progress::NONE), Ok(5));
    problem.set_external_degree(9, 30);
    assert_eq!(
        refusal(&problem, 31),
        "no triangulation here has maximum degree 31; the least is 33"
    );
    problem.set_external_degree(9, u32::MAX);
    assert_eq!(least_max_degree(&problem, Progress::NONE), Err(Unsolved::VertexLimits));
}

#[test]
fn a_vertex_keeps_to_its_own_limit() {
    let sides = [8, 6, 8, 5];
    let mut problem = rectangle_problem(&sides);
    let free = best_angle(&problem, 5, Progress::NONE).unwrap();
    let degrees = verify(&sides, free.triangles).unwrap().degrees;
    let vertex = (0..).zip(&degrees).find(|&(_, &degree)| degree == 5).unwrap().0;
    for (own_limit, expected) in [(5, true), (4, false), (3, false)] {
        problem.set_degree_limit(vertex, own_limit);
        let optimum = best_angle(&problem, 5, Progress::NONE).unwrap();
        let degrees = verify(&sides, optimum.triangles.iter().copied()).unwrap().degrees;
        assert!(degrees[vertex as usize] <= own_limit);
        assert_eq!(degrees[vertex as usize] == 5, expected);
    }
}

/// The largest number of edges at a point of meshes that share points and edges.
fn joint_max_degree(meshes: [(&[DVec2], &[[u32; 3]]); 2]) -> usize {
    let mut edges = BTreeSet::new();
    for (points, triangles) in meshes {
        let key = |vertex: u32| points[vertex as usize].to_array().map(f64::to_bits);
        for &[a, b, c] in triangles {
            edges.extend([[a, b], [b, a], [b, c], [c, b], [c, a], [a, c]].map(|e| e.map(key)));
        }
    }
    let mut ends = edges.iter().map(|&[from, _]| from).collect::<Vec<_>>();
    ends.sort_unstable();
    ends.chunk_by(|a, b| a == b).map(<[_]>::len).max().unwrap()
}

#[test]
fn a_second_rectangle_told_of_the_first_keeps_the_joint_maximum() {
    let (left_sides, right_sides) = ([8, 6, 8, 5], [9, 6, 9, 6]);
    let (left_boundary, left_points) = rectangle(0.0, &left_sides);
    let (right_boundary, right_points) = rectangle(4.0, &right_sides);
    let left = Problem::new(&left_boundary, &left_points).unwrap();
    let left = best_angle(&left, 5, Progress::NONE).unwrap();
    let degrees = verify(&left_sides, left.triangles.iter().copied()).unwrap().degrees;

    let mut right = Problem::new(&right_boundary, &right_points).unwrap();
    let untold = best_angle(&right, 5, Progress::NONE).unwrap();
    // The left one's second side is the right one's fourth, backwards.
    for step in 0..=6 {
        let on_left = left_boundary.corner(1) + step;
        let on_right = (right_boundary.vertex_count() - step) % right_boundary.vertex_count();
        assert_eq!(left_points[on_left as usize], right_points[on_right as usize]);
        let shared = if step == 0 || step == 6 { 1 } else { 2 };
        right.set_external_degree(on_right, degrees[on_left as usize] - shared);
    }
    let least = least_max_degree(&right, Progress::NONE).unwrap();
    let joint = |triangles: &[[u32; 3]]| {
        joint_max_degree([(&left_points, &left.triangles), (&right_points, triangles)])
    };
    assert!(joint(&untold.triangles) > least as usize);
    let trade_off = trade_off(&right, Progress::NONE).unwrap();
    assert_eq!(trade_off.optima[0].max_degree, least);
    for optimum in &trade_off.optima {
        let right_alone = verify(&right_sides, optimum.triangles.iter().copied());
        assert!(right_alone.is_ok());
        assert!(joint(&optimum.triangles) <= optimum.max_degree as usize);
    }
    assert_eq!(joint(&trade_off.optima[0].triangles), least as usize);
}

/// 2n - 3 edges have 4n - 6 ends, and each vertex has one more outside: 5 - 6/n on average.
#[test]
fn edges_outside_count_towards_the_bound_of_a_convex_polygon() {
    let mut problem = rectangle_problem(&[4, 3, 4, 3]);
    (0..14).for_each(|vertex| problem.set_external_degree(vertex, 1));
    assert_eq!(lower_bound(&problem), (5, LowerBound::Counting));
}

#[test]
fn the_answer_does_not_depend_on_the_number_of_threads() {
    let mut problem = rectangle_problem(&[60, 45, 20, 20]);
    problem.set_external_degree(17, 2);
    let solve = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| trade_off(&problem, Progress::NONE)).unwrap()
    };
    let one = solve(1);
    assert!(one.optima.len() > 1);
    for threads in [2, 4] {
        assert_eq!(solve(threads), one, "{threads} threads");
    }
}

#[test]
fn triangles_without_area_have_no_angle_and_do_not_win() {
    // A square whose lower side has a corner in the middle that rounding has flattened or
    // pushed in.
    for (y, has_area) in [(-1e-3, true), (0.0, false), (1e-18, false)] {
        let points = [(0.0, 0.0), (1.0, y), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)];
        let problem = placed(&[1, 1, 1, 1, 1], &points);
        let corners = [0, 1, 2].map(|vertex| problem.points()[vertex]);
        assert_eq!(measure::min_angle_tangent(corners) > 0.0, has_area);
        let optimum = best_angle(&problem, 4, Progress::NONE).unwrap();
        assert!(optimum.min_angle > 26.0, "{y}");
        assert!(!optimum.triangles.contains(&[0, 1, 2]), "{y}");
    }
    // Nothing has any area here, or it is beyond f64: still a triangulation, of angle 0.
    for scale in [0.0, 1e-200, 1e200] {
        let points = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (0.0, 2.0)];
        let points = points.map(|(x, y)| (x * scale, y * scale));
        let trade_off = trade_off(&placed(&[2, 1, 1], &points), Progress::NONE).unwrap();
        assert_eq!(trade_off.optima.len(), 1, "{scale}");
        assert_eq!(trade_off.optima[0].min_angle, 0.0, "{scale}");
        assert_eq!(trade_off.optima[0].triangles, [[0, 1, 3], [1, 2, 3]], "{scale}");
    }
}

#[test]
fn progress_never_falls_within_a_stage() {
    let mut problem = rectangle_problem(&[14, 3, 5, 2]);
    problem.set_external_degree(3, 1);
    let most_done = Mutex::new(BTreeMap::new());
    let watch = |Step { stage, done, total }: Step<'_>| {
        assert!(done <= total && total == 1000, "{stage}: {done} of {total}");
        let mut most_done = most_done.lock().unwrap();
        let before = most_done.insert(stage.to_owned(), done).unwrap_or(0);
        assert!(before <= done, "{stage}: {before}, {done}");
        ControlFlow::Continue(())
    };
    let trade_off = trade_off(&problem, Progress::new(&watch)).unwrap();
    let least = trade_off.optima[0].max_degree;
    let most_done = most_done.into_inner().unwrap();
    for stage in [
        "bounding the angles".to_owned(),
        format!("is degree {} possible?", least - 1),
        format!("degree {least}: the best angle"),
        format!("degree {least}: the best mesh"),
    ] {
        assert!(most_done.contains_key(&stage), "{stage}: {most_done:?}");
    }
    assert!(most_done.keys().any(|stage| stage.starts_with("taking edges off vertices of degree")));
}

#[test]
fn a_break_cancels_the_work_wherever_it_comes() {
    let mut problem = rectangle_problem(&[5, 3, 4, 2]);
    problem.set_external_degree(3, 1);
    let reports = |cancel_at: usize| {
        let reports = AtomicUsize::new(0);
        let watch = |_: Step<'_>| {
            let count = reports.fetch_add(1, Relaxed) + 1;
            if count == cancel_at { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let answer = trade_off(&problem, Progress::new(&watch));
        (reports.into_inner(), answer)
    };
    let (all, answer) = reports(usize::MAX);
    assert!(answer.is_ok());
    for cancel_at in 1..=all {
        assert_eq!(reports(cancel_at), (cancel_at, Err(Unsolved::Cancelled(Cancelled))));
    }
}

#[test]
fn too_many_vertices_are_refused_at_once() {
    let boundary = Boundary::new(&[1 << 30, 1, 1]).unwrap();
    let error = Problem::new(&boundary, &[]).unwrap_err();
    assert!(error.to_string().starts_with("found 1073741826 boundary vertices; "));
}
