//! Whole meshes: valid, with the boundary as it was, and as good as promised.
#![allow(clippy::cloned_ref_to_slice_refs)]

#[path = "../examples/corpus/polygons.rs"]
#[allow(dead_code)]
mod polygons;

use crate::checker::{assert_valid, degrees, min_angle};
use glam::DVec2;
use mindeg_interior::{
    Generated, Interior, InteriorError, Options, Prefer, Size, SizeAt, generate,
};
use mindeg_mesh::planar::PlanarBoundary;
use mindeg_mesh::{Progress, Step};
use polygons::{Random, domains, random_polygon, ring};
use std::ops::ControlFlow;
use std::sync::Mutex;

fn points(list: &[[f64; 2]]) -> Vec<DVec2> {
    list.iter().copied().map(DVec2::from).collect()
}

/// Points inside, and lines between two vertices each: of the boundary, then these points.
#[derive(Clone, Debug, Default)]
struct Fixed {
    points: Vec<DVec2>,
    segments: Vec<[u32; 2]>,
    is_divisible: bool,
}

impl Fixed {
    fn boundary(&self, rings: &[Vec<DVec2>]) -> Result<PlanarBoundary, InteriorError> {
        let lines: Vec<Vec<u32>> = self.segments.iter().map(|ends| ends.to_vec()).collect();
        Ok(PlanarBoundary::map(rings, &self.points, &lines)?.0)
    }
}

fn try_mesh(
    rings: &[Vec<DVec2>],
    fixed: &Fixed,
    options: &Options,
) -> Result<Generated, InteriorError> {
    let divisible = vec![fixed.is_divisible; fixed.segments.len()];
    let options = Options { divisible, ..options.clone() };
    generate(&fixed.boundary(rings)?, &options, Progress::NONE)
}

/// Meshes, and checks everything that must hold whatever was reached.
fn mesh(rings: &[Vec<DVec2>], fixed: &Fixed, options: &Options) -> Generated {
    let mesh = try_mesh(rings, fixed, options).unwrap();
    let outline = PlanarBoundary::new(rings).unwrap();
    let boundary: Vec<[u32; 2]> = outline.edges().collect();
    let given: Vec<DVec2> = rings.concat();
    let bits = |p: &DVec2| p.to_array().map(f64::to_bits);
    let same = given.iter().zip(&mesh.points).all(|(a, b)| bits(a) == bits(b));
    assert!(same, "the boundary is as it was, bit for bit");
    assert_valid(&mesh.points, &mesh.triangles, &boundary);
    let start = given.len();
    assert_eq!(mesh.points[start..start + fixed.points.len()], fixed.points[..]);
    let r = &mesh.report;
    assert_eq!(r.triangles, mesh.triangles.len());
    let degrees = degrees(mesh.points.len(), &mesh.triangles);
    assert_eq!(degrees[..start].iter().max(), Some(r.boundary_degree.end()));
    assert_eq!(degrees[start..].iter().max(), r.interior_degree.as_ref().map(|d| d.end()));
    assert_eq!(degrees[start..].iter().min(), r.interior_degree.as_ref().map(|d| d.start()));
    assert!((min_angle(&mesh.points, &mesh.triangles) - r.min_angle).abs() < 1e-5);
    assert!(r.min_angle <= r.limits.angle_at_any_degree() + 1e-9);
    if r.violations.is_empty() {
        assert!(r.min_angle <= r.limits.angle() + 1e-9, "a proven limit is exceeded");
    }
    if !fixed.is_divisible {
        assert_eq!(mesh.line_edges, fixed.segments);
    }
    for [a, b] in &mesh.line_edges {
        assert!(mesh.triangles.iter().any(|t| t.contains(a) && t.contains(b)), "edge {a}-{b}");
    }
    mesh
}

fn plain(rings: &[Vec<DVec2>]) -> Generated {
    mesh(rings, &Fixed::default(), &Options::default())
}

fn share(mesh: &Generated) -> f64 {
    mesh.report.min_angle / mesh.report.limits.angle().min(35.0)
}

fn plate() -> Vec<Vec<DVec2>> {
    let outer = points(&[[0.0, 0.0], [10.0, 0.0], [10.0, 4.0], [6.0, 4.0], [6.0, 8.0], [0.0, 8.0]]);
    let hole = points(&[[2.0, 2.0], [2.0, 4.0], [4.0, 4.0], [4.0, 2.0]]);
    vec![ring(&outer, &[20, 8, 8, 8, 12, 16]), ring(&hole, &[5, 5, 5, 5])]
}

#[test]
fn the_domains_have_no_violation_and_nearly_the_best_angles() {
    for (name, ring) in domains() {
        // The long search of dominated-side is measured by the example.
        let found = plain(&[ring]);
        assert_eq!(found.report.violations, [], "{name}");
        assert!(share(&found) >= 0.95, "{name}: {}", share(&found));
    }
}

#[test]
fn random_polygons_have_no_violation() {
    let mut random = Random(99);
    for i in 0..12 {
        let found = plain(&[random_polygon(&mut random)]);
        assert_eq!(found.report.violations, [], "{i}");
        assert!(share(&found) >= 0.8, "{i}: {}", share(&found));
    }
}

/// A corner of 3 degrees between very unequal intervals had 6 edges.
#[test]
fn a_corner_where_degree_and_angle_pull_apart_keeps_its_degree() {
    let domain = mindeg_domain::Domain::from_json(include_str!("multiscale-side.json")).unwrap();
    let found = plain(&[domain.boundary().unwrap().points().to_vec()]);
    assert_eq!(found.report.violations, []);
    assert!(found.report.local.worst > 0.0 && found.report.local.worst <= 1.0);
}

#[test]
fn two_runs_give_the_same_bytes() {
    let rings = plate();
    let (first, second) = (plain(&rings), plain(&rings));
    let bytes = |mesh: &Generated| -> Vec<u64> {
        mesh.points.iter().flat_map(|p| p.to_array().map(f64::to_bits)).collect()
    };
    assert_eq!(bytes(&first), bytes(&second));
    assert_eq!(first, second);
}

#[test]
fn holes_and_reflex_corners_are_meshed() {
    let found = plain(&plate());
    assert_eq!(found.report.violations, []);
    assert!(share(&found) > 0.9, "{:?}", found.report);

    // A comb: long teeth, eight reflex corners.
    let mut corners = vec![[0.0, 0.0], [9.0, 0.0]];
    for tooth in (0..5).rev() {
        let x = f64::from(tooth) * 2.0;
        corners.extend([[x + 1.0, 6.0], [x, 6.0]]);
        if tooth > 0 {
            corners.extend([[x, 1.0], [x - 1.0, 1.0]]);
        }
    }
    corners[2] = [9.0, 6.0];
    let count = |i: usize| {
        let (a, b) = (DVec2::from(corners[i]), DVec2::from(corners[(i + 1) % corners.len()]));
        (a.distance(b) * 3.0).round() as u32
    };
    let intervals: Vec<u32> = (0..corners.len()).map(count).collect();
    let found = plain(&[ring(&points(&corners), &intervals)]);
    assert_eq!(found.report.violations, []);
    assert!(share(&found) > 0.9, "{:?}", found.report);

    // A ring of two circles.
    let circle = |radius: f64, count: u32, sign: f64| -> Vec<DVec2> {
        let at = |i: u32| sign * std::f64::consts::TAU * f64::from(i) / f64::from(count);
        (0..count).map(|i| DVec2::from_angle(at(i)) * radius).collect()
    };
    let found = plain(&[circle(5.0, 90, 1.0), circle(1.0, 30, -1.0)]);
    assert_eq!(found.report.violations, []);
    assert!(share(&found) > 0.95, "{:?}", found.report);
}

#[test]
fn fixed_points_and_segments_stay() {
    let square = ring(&points(&[[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]]), &[10; 4]);
    let fixed = Fixed {
        points: points(&[[2.0, 2.0], [6.0, 5.5], [4.0, 6.1], [4.1, 1.3], [4.2, 1.3]]),
        // Two fixed points, and a boundary vertex.
        segments: vec![[40, 41], [41, 15], [42, 41]],
        is_divisible: true,
    };
    let found = mesh(&[square], &fixed, &Options::default());
    assert!(found.line_edges.len() > 6, "segments are divided");
    // Each piece is on its segment.
    let at = |v: u32| found.points[v as usize];
    for [a, b] in &found.line_edges {
        let middle = at(*a).midpoint(at(*b));
        let on = fixed.segments.iter().any(|[c, d]| {
            let (c, d) = (at(*c), at(*d));
            ((middle - c).perp_dot(d - c) / c.distance(d)).abs() < 1e-9
        });
        assert!(on, "{a}-{b}");
    }
    assert_eq!(found.report.violations, []);
    assert!(found.report.min_angle > 20.0, "{:?}", found.report);
}

#[test]
fn sizes_are_kept() {
    let square = ring(&points(&[[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]]), &[8; 4]);
    let count = |options: &Options| {
        let found = mesh(&[square.clone()], &Fixed::default(), options);
        assert_eq!(found.report.violations, []);
        found.report.triangles
    };
    let plain = count(&Options::default());
    let of_size = |size| Interior { size_inside: Some(size), ..Interior::default() }.into();
    let (coarse, fine) = (count(&of_size(2.0)), count(&of_size(0.4)));
    assert!(coarse < plain * 9 / 10 && fine > plain * 3, "{coarse} {plain} {fine}");
    let place = Size::At(SizeAt { at: DVec2::new(3.0, 5.0), size: 0.1 });
    let local = count(&Interior { sizes: vec![place], ..Interior::default() }.into());
    assert!(local > plain * 5 / 4, "{local} {plain}");
}

#[test]
fn other_limits_on_degrees_are_kept() {
    let square = ring(&points(&[[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]]), &[8, 11, 14, 9]);
    for (interior_degree, boundary_degree) in [(4..=8, 6), (5..=8, 5), (5..=7, 4)] {
        let (interior_degree, boundary_degree) = (Some(interior_degree), Some(boundary_degree));
        let wanted = Interior { interior_degree, boundary_degree, ..Interior::default() };
        let options = Options::from(wanted);
        let found = mesh(&[square.clone()], &Fixed::default(), &options);
        assert_eq!(found.report.violations, [], "{options:?}");
    }
}

#[test]
fn a_vertex_may_have_a_limit_of_its_own() {
    // On a side, three triangles meet where nothing limits them.
    let square = ring(&points(&[[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]]), &[8; 4]);
    let degree = |degree_limits| {
        let options = Options { degree_limits, ..Options::default() };
        let found = mesh(&[square.clone()], &Fixed::default(), &options);
        assert_eq!(found.report.violations, []);
        degrees(found.points.len(), &found.triangles)[4]
    };
    assert_eq!((degree([].into()), degree([(4, 3)].into())), (4, 3));
    let options = Options { degree_limits: [(3, 1)].into(), ..Options::default() };
    let error = try_mesh(&[square.clone()], &Fixed::default(), &options).unwrap_err();
    assert!(error.to_string().starts_with("vertex 3 has a degree limit of 1"), "{error}");
}

#[test]
fn preferred_angles_exceed_the_limit_that_degrees_set() {
    // At the first corner an edge of 20 meets one of 0.25.
    let corners = points(&[[0.0, 0.0], [40.0, 0.0], [40.0, 40.0], [0.0, 40.0]]);
    let rings = [ring(&corners, &[160, 2, 2, 2])];
    let best = |prefer| {
        let options = Interior { prefer: Some(prefer), ..Interior::default() }.into();
        mesh(&rings, &Fixed::default(), &options).report
    };
    let (degree, angle) = (best(Prefer::Degree), best(Prefer::Angle));
    assert_eq!(degree.violations, []);
    assert!(degree.min_angle < degree.limits.angle());
    assert!(angle.min_angle > angle.limits.angle() + 0.5, "{angle:?}");
    assert!(!angle.violations.is_empty());
}

#[test]
fn far_from_the_origin_and_at_other_scales_it_is_the_same() {
    let corners = points(&[[0.0, 0.0], [8.0, 0.0], [9.0, 6.0], [1.0, 7.0]]);
    let home = plain(&[ring(&corners, &[9, 7, 12, 8])]);
    for scale in [1e-30, 1e-12, 1e9, 1e40] {
        let scaled: Vec<DVec2> = corners.iter().map(|p| *p * scale).collect();
        let found = plain(&[ring(&scaled, &[9, 7, 12, 8])]);
        assert_eq!(found.report.violations, []);
        assert!((share(&found) - share(&home)).abs() < 0.05);
    }
    let moved: Vec<DVec2> = corners.iter().map(|p| *p + DVec2::new(5e8, -3e8)).collect();
    let found = plain(&[ring(&moved, &[9, 7, 12, 8])]);
    assert_eq!(found.report.violations, []);
    assert!((share(&found) - share(&home)).abs() < 0.05);
}

#[test]
fn bad_options_are_refused_with_what_to_do() {
    let square = ring(&points(&[[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]]), &[8, 4, 8, 4]);
    let default = Interior::default;
    let place = |x: f64, size: f64| vec![Size::At(SizeAt { at: DVec2::new(x, 1.0), size })];
    for (wanted, expected) in [
        (Interior { growth: Some(0.0), ..default() }, "growth is 0;"),
        (Interior { growth: Some(f64::NAN), ..default() }, "growth is NaN;"),
        (Interior { size_inside: Some(0.0), ..default() }, "the size inside is 0;"),
        (Interior { size_inside: Some(-1.0), ..default() }, "the size inside is -1;"),
        (Interior { sizes: place(1.0, 0.0), ..default() }, "size 0 is 0;"),
        (
            Interior { sizes: place(9.0, 1.0), ..default() },
            "entry 1 of sizes at (9, 1) is not inside",
        ),
        (Interior { interior_degree: Some(7..=9), ..default() }, "7 to 9"),
        (Interior { boundary_degree: Some(3), ..default() }, "boundary degree of 3"),
        (Interior { boundary_corners: Some(1), ..default() }, "give 2 or 3"),
        (Interior { target_angle: Some(0.0), ..default() }, "target angle 0"),
        (Interior { target_angle: Some(46.0), ..default() }, "at most "),
        (
            Interior { size_inside: Some(0.01), max_points: Some(1000), ..default() },
            "more than 1000 points",
        ),
    ] {
        let error = try_mesh(&[square.clone()], &Fixed::default(), &wanted.into()).unwrap_err();
        assert!(error.to_string().contains(expected), "{error}");
    }
}

/// As states on a map: short edges across a square, none of which is divided, though the size asks for it.
#[test]
fn lines_that_stay_are_not_divided() {
    let square = ring(&points(&[[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]]), &[16; 4]);
    let inner = points(&[[2.0, 1.7], [3.1, 3.0], [4.0, 4.1], [5.2, 5.0], [6.1, 6.3], [4.0, 6.0]]);
    let segments =
        vec![[0, 64], [64, 65], [65, 66], [66, 67], [67, 68], [68, 32], [66, 69], [69, 40]];
    let fixed = Fixed { points: inner, segments, is_divisible: false };
    let found = mesh(&[square], &fixed, &Options::default());
    assert_eq!(found.report.violations, []);
    assert!(found.report.min_angle > 10.0, "{:?}", found.report);
}

/// The search had too little time for each of the vertices between edges of unequal length: 34 violations.
#[test]
fn lines_of_uneven_edges_keep_their_degrees() {
    let lengths = [9.0, 1.0, 7.0, 12.0, 2.0, 9.0, 0.7, 6.0];
    let width = 6.0 + 3.0 * lengths.iter().sum::<f64>();
    let corners = points(&[[0.0, 0.0], [width, 0.0], [width, 132.0], [0.0, 132.0]]);
    let rings = [ring(&corners, &[24, 22, 24, 22])];
    let mut fixed = Fixed::default();
    for line in 0..10 {
        let mut x = 3.0;
        for vertex in 0..=24 {
            let y = 12.0 * (line as f64 + 1.0) + 0.3 * f64::from(vertex % 2);
            fixed.points.push(DVec2::new(x, y));
            x += lengths[(vertex as usize + 3 * line) % 8];
            if vertex > 0 {
                let end = 92 + fixed.points.len() as u32 - 1;
                fixed.segments.push([end - 1, end]);
            }
        }
    }
    let found = mesh(&rings, &fixed, &Options::default());
    assert_eq!(found.report.violations, []);
    assert_eq!(found.report.certified, []);
}

#[test]
fn only_the_vertex_where_too_many_lines_meet_breaks_its_degree() {
    let corners = points(&[[0.0, 0.0], [60.0, 0.0], [60.0, 60.0], [0.0, 60.0]]);
    let rings = [ring(&corners, &[60; 4])];
    let center = DVec2::new(30.0, 31.0);
    let ends = (0..9).map(|i| center + 2.0 * DVec2::from_angle(f64::from(i) * 0.698));
    let fixed = Fixed {
        points: [center].into_iter().chain(ends).collect(),
        segments: (241..250).map(|end| [240, end]).collect(),
        is_divisible: false,
    };
    let report = mesh(&rings, &fixed, &Options::default()).report;
    let broken: Vec<u32> = report.violations.iter().map(|violation| violation.vertex).collect();
    assert_eq!(broken, [240]);
    let [proof] = &report.certified[..] else { panic!("{:?}", report.certified) };
    assert_eq!(
        (proof.vertex, proof.at, proof.degree_limit, proof.least_degree),
        (240, center, 7, 9)
    );
    let mut edges = proof.edges.clone();
    let first = edges.iter().position(|end| *end == 241).unwrap();
    edges.rotate_left(first);
    assert_eq!(edges, (241..250).collect::<Vec<u32>>());
}

#[test]
fn a_reachable_target_is_aimed_at() {
    let square = ring(&points(&[[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]]), &[12; 4]);
    let options = Interior { target_angle: Some(36.0), ..Interior::default() }.into();
    let found = mesh(&[square], &Fixed::default(), &options);
    assert!(found.report.min_angle >= 36.0, "{:?}", found.report);
}

#[test]
fn progress_rises_to_the_end_and_can_cancel() {
    let outline = PlanarBoundary::new(&[plate()[0].clone()]).unwrap();
    let seen = Mutex::new(Vec::new());
    let run = |most: u64| {
        let callback = |step: Step<'_>| {
            seen.lock().unwrap().push((step.stage.to_owned(), step.done, step.total));
            if step.done > most { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        generate(&outline, &Options::default(), Progress::new(&callback))
    };
    assert!(matches!(run(10), Err(InteriorError::Cancelled(_))));
    seen.lock().unwrap().clear();
    run(u64::MAX).unwrap();
    let seen = seen.lock().unwrap();
    assert!(seen.iter().all(|(stage, done, total)| !stage.is_empty() && done <= total));
    assert_eq!(seen.last().map(|(_, done, total)| done == total), Some(true));
    // One bar, whatever works inside.
    assert!(seen.windows(2).all(|p| p[0].0 == p[1].0 && p[0].1 <= p[1].1), "{seen:?}");
    assert!(seen.iter().any(|(_, done, total)| (1..total / 2).contains(done)), "{seen:?}");
}

/// A polygon round the origin with a corner in each direction, at random distances.
fn star_shaped(radii: &[f64], intervals: &[u32]) -> Vec<DVec2> {
    let turn = std::f64::consts::TAU / radii.len() as f64;
    let corner = |(i, r): (usize, &f64)| DVec2::from_angle(turn * i as f64) * *r;
    let corners: Vec<DVec2> = radii.iter().enumerate().map(corner).collect();
    ring(&corners, intervals)
}

proptest::proptest! {
    #![proptest_config(proptest::test_runner::Config::with_cases(8))]

    /// Whatever the shape, the mesh is valid, with the boundary and what is fixed as they were.
    #[test]
    fn any_outline_gives_a_valid_mesh(
        sides in proptest::collection::vec((2.0..9.0_f64, 1..12_u32), 3..9),
        hole in proptest::option::of(proptest::collection::vec((0.1..0.9_f64, 1..6_u32), 3..6)),
        fixed in proptest::collection::vec((0.0..std::f64::consts::TAU, 0.91..0.97_f64), 0..6),
        growth in 0.1..2.0_f64,
    ) {
        let split = |sides: &[(f64, u32)]| -> (Vec<f64>, Vec<u32>) { sides.iter().copied().unzip() };
        let (radii, intervals) = split(&sides);
        let mut rings = vec![star_shaped(&radii, &intervals)];
        // With three sides the outline comes nearest to the origin, at half the least radius.
        if let Some((radii, intervals)) = hole.as_deref().map(split) {
            let mut hole = star_shaped(&radii, &intervals);
            hole.reverse();
            rings.push(hole);
        }
        // Points between hole and outline; a segment through the first two if it is free.
        let points: Vec<DVec2> =
            fixed.iter().map(|(turn, r)| DVec2::from_angle(*turn) * *r).collect();
        let first = rings.concat().len() as u32;
        let segments = if points.len() > 1 { vec![[first, first + 1]] } else { vec![] };
        let options = Interior { growth: Some(growth), ..Interior::default() }.into();
        let fixed = Fixed { points, segments, is_divisible: growth > 1.0 };
        match try_mesh(&rings, &fixed, &options) {
            Ok(_) => drop(mesh(&rings, &fixed, &options)),
            Err(InteriorError::Boundary(_)) => {
                if PlanarBoundary::new(&rings).is_ok() {
                    drop(mesh(&rings, &Fixed::default(), &options));
                }
            }
            Err(error) => panic!("{error}"),
        }
    }
}

/// Found by hand: the packing never ended where coordinates hold no point between two others.
#[test]
fn coordinates_without_room_for_points_end_at_once() {
    let far = [[0.0, 0.0], [4.0, 0.0], [1e16, 3.0], [0.0, 3.0]];
    let hole = [[1.0, 1.0], [1.0, 2.0], [2.0, 2.0], [2.0, 1.0]];
    let exact = [[11.0, 3.0], [11.0, 9.0], [0.0, 9.0], [1.0, 7.0], [9.0, 2.0], [5.0, 5.0]];
    let exact_hole = [[5.0, 7.0], [10.0, 6.0], [7.0, 6.0]];
    let shift = |ring: &[[f64; 2]]| {
        ring.iter().map(|&[x, y]| DVec2::new(x, y) + 4_503_599_627_370_496.0).collect()
    };
    // Spikes that are thinner than the rounding far from where they begin.
    let spikes = [
        [4503599627370498.0, 4503599627370497.0],
        [4503600361299855.0, 4503600227620048.0],
        [4503599627370494.5, 4503599627370496.0],
        [4503600166350139.0, 4503599072922979.0],
        [4503599627376695.0, 4503599627365181.0],
        [4503599627376925.0, 4503599627365947.0],
    ];
    let with_holes = [vec![points(&far), points(&hole)], vec![shift(&exact), shift(&exact_hole)]];
    for rings in with_holes.into_iter().chain([vec![points(&spikes)]]) {
        let outline = PlanarBoundary::oriented(&rings).unwrap().0;
        let start = std::time::Instant::now();
        let in_time = |_: Step<'_>| match start.elapsed().as_secs() {
            0..20 => ControlFlow::Continue(()),
            _ => ControlFlow::Break(()),
        };
        let found = generate(&outline, &Options::default(), Progress::new(&in_time));
        // A mesh without points inside needs no room for them.
        match found {
            Ok(found) => assert_eq!(found.report.interior_points, 0),
            Err(error) => assert!(error.to_string().starts_with("no point fits at ("), "{error}"),
        }
    }
}

/// The point over an edge was refused where sizes grow fast from it: nothing was packed, and the minimum angle was 0.3°.
#[test]
fn sizes_may_grow_fast_from_a_fine_boundary() {
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let outline = ring(&points(&corners), &[80; 4]);
    for growth in [0.3, 0.4, 0.7, 1.0, 2.0] {
        let wanted =
            Interior { size_inside: Some(0.2), growth: Some(growth), ..Interior::default() };
        let found = mesh(std::slice::from_ref(&outline), &Fixed::default(), &wanted.into());
        let least = found.report.min_angle;
        assert!(least > 25.0 && found.report.violations.is_empty(), "{growth}: {least}");
    }
}

/// With a size of 0.06 at a place, the edges at the vertex nearest to it were 0.12 to 0.18 long.
#[test]
fn no_edge_at_a_place_is_longer_than_its_size() {
    let corners = [[0.0, 0.0], [6.0, 0.0], [6.0, 2.0], [2.0, 2.0], [2.0, 5.0], [0.0, 5.0]];
    let outline = ring(&points(&corners), &[12, 4, 8, 6, 4, 10]);
    let mut random = Random(7);
    let mut worst = Vec::new();
    for (index, size) in [0.06, 0.12, 0.2, 0.06, 0.3, 0.1, 0.04, 0.15].into_iter().enumerate() {
        let at = match index {
            0 => DVec2::new(0.69, 0.63),
            _ => DVec2::new(0.4 + 1.2 * random.unit(), 0.4 + 4.2 * random.unit()),
        };
        let sizes = vec![Size::At(SizeAt { at, size })];
        let options = Interior { sizes, ..Interior::default() }.into();
        let found = mesh(std::slice::from_ref(&outline), &Fixed::default(), &options);
        let distance = |v: &u32| found.points[*v as usize].distance(at);
        let nearest =
            (0..found.points.len() as u32).min_by(|a, b| distance(a).total_cmp(&distance(b)));
        let nearest = nearest.unwrap();
        let own = found.triangles.iter().filter(|t| t.contains(&nearest)).flatten();
        let longest = own
            .map(|v| found.points[*v as usize].distance(found.points[nearest as usize]))
            .fold(0.0, f64::max);
        worst.push((longest / size, found.report.violations.len(), found.triangles.len()));
    }
    assert!(worst.iter().all(|(share, ..)| *share <= 1.0), "{worst:.2?}");
}

#[test]
fn each_triangle_has_a_corner_inside_where_that_is_wanted() {
    let wanted = Interior { boundary_corners: Some(2), ..Interior::default() };
    let options = Options::from(wanted);
    let mut random = Random(5);
    // A corner of 30 degrees, whose two triangles have 15; then polygons by chance.
    let spike =
        ring(&points(&[[0.0, 0.0], [8.0, 0.0], [8.0, 4.618_802_153_517_006]]), &[16, 9, 18]);
    let by_chance = (0..8).map(|_| random_polygon(&mut random));
    let mut corners_alone = 0;
    for (index, outline) in std::iter::once(spike).chain(by_chance).enumerate() {
        let on_boundary = outline.len() as u32;
        let all_at_boundary = |triangle: &&[u32; 3]| triangle.iter().all(|v| *v < on_boundary);
        let usual = mesh(&[outline.clone()], &Fixed::default(), &Options::default());
        corners_alone += usual.triangles.iter().filter(all_at_boundary).count();
        assert_eq!(usual.report.outside, 0, "nobody wants it");
        let found = mesh(&[outline], &Fixed::default(), &options);
        let outside = found.triangles.iter().filter(all_at_boundary).count();
        assert_eq!((outside, found.report.outside), (0, 0), "{index}");
        if index == 0 {
            assert!((found.report.limits.angle() - 15.0).abs() < 0.1, "{:?}", found.report.limits);
            assert!(found.report.share_of_limit > 0.98, "{}", found.report.share_of_limit);
        }
    }
    assert!(corners_alone > 5, "{corners_alone}");
}
