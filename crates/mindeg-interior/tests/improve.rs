//! Improving meshes: valid in, valid out, the boundary and what is kept as they were.

use crate::checker::{assert_valid, degrees, min_angle};
use glam::DVec2;
use mindeg_interior::{Improved, Interior, InteriorError, Keep, Options, improve};
use mindeg_mesh::Progress;
use mindeg_mesh::planar::PlanarBoundary;
use proptest::prelude::*;

type Mesh = (Vec<DVec2>, Vec<[u32; 3]>);

/// The Delaunay triangulation of a square's boundary and points inside it.
fn square(side: u32, inside: &[(f64, f64)]) -> Mesh {
    let corners = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
    let mut points = Vec::new();
    for i in 0..4 {
        let along = |j| corners[i].lerp(corners[(i + 1) % 4], f64::from(j) / f64::from(side));
        points.extend((0..side).map(along));
    }
    let ring = PlanarBoundary::new(&[&points]).unwrap();
    points.extend(inside.iter().map(|(x, y)| DVec2::new(0.02 + 0.96 * x, 0.02 + 0.96 * y)));
    let inner = &points[ring.points().len()..];
    let triangles = mindeg_delaunay::triangles(&ring, inner, &[], Progress::NONE).unwrap();
    (points, triangles)
}

fn boundary(triangles: &[[u32; 3]]) -> Vec<[u32; 2]> {
    let halves: Vec<[u32; 2]> =
        triangles.iter().flat_map(|[a, b, c]| [[*a, *b], [*b, *c], [*c, *a]]).collect();
    let is_single = |[a, b]: &[u32; 2]| !halves.contains(&[*b, *a]);
    halves.iter().copied().filter(is_single).collect()
}

fn run((points, triangles): &Mesh, keep: &Keep) -> Improved {
    let found = improve(points, triangles, keep, &Options::default(), Progress::NONE).unwrap();
    let name = |v: u32| found.sources.iter().position(|s| *s == Some(v)).unwrap() as u32;
    let kept: Vec<[u32; 2]> = boundary(triangles).iter().map(|e| e.map(name)).collect();
    assert_valid(&found.points, &found.triangles, &kept);
    let fixed = kept.iter().flatten().copied().chain(keep.vertices.iter().map(|v| name(*v)));
    for v in fixed {
        let source = found.sources[v as usize].unwrap();
        assert_eq!(found.points[v as usize], points[source as usize]);
    }
    for edge in &keep.edges {
        let [a, b] = edge.map(name);
        assert!(found.triangles.iter().any(|t| t.contains(&a) && t.contains(&b)), "{edge:?}");
    }
    assert!((min_angle(&found.points, &found.triangles) - found.after.min_angle).abs() < 1e-5);
    let (after, before) = (&found.after, &found.before);
    assert!(after.violations.len() <= before.violations.len());
    if after.violations.len() == before.violations.len() {
        assert!(after.min_angle >= before.min_angle.min(35.0), "{before:?} became {after:?}");
    }
    found
}

/// A fixed sequence of numbers from 0 to 1.
fn scattered(count: u32) -> Vec<(f64, f64)> {
    let mut state = 5_u32;
    let mut next = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state >> 8) / f64::from(1 << 24)
    };
    (0..count).map(|_| (next(), next())).collect()
}

#[test]
fn scattered_points_become_a_good_mesh() {
    let mesh = square(9, &scattered(90));
    let found = run(&mesh, &Keep::default());
    assert!(found.before.violations.len() > 20, "{:?}", found.before);
    assert_eq!(found.after.violations, []);
    assert!(found.after.min_angle > 30.0, "{:?}", found.after);
    assert_eq!(degrees(found.points.len(), &found.triangles)[..36].iter().max(), Some(&5));
}

#[test]
fn a_mesh_without_inner_points_gets_new_starts() {
    // The first polygon of Rhode Island: operations alone reach 13.6 degrees.
    let ring = [
        [910.510, 182.799],
        [911.637, 182.882],
        [912.784, 186.396],
        [911.840, 187.584],
        [910.987, 185.731],
        [910.469, 183.980],
        [910.114, 184.224],
        [910.977, 187.210],
        [910.022, 187.441],
        [910.043, 188.141],
        [909.058, 188.266],
        [909.637, 185.352],
        [909.545, 184.372],
    ];
    let points = ring.map(DVec2::from).to_vec();
    let outline = PlanarBoundary::new(&[&points]).unwrap();
    let triangles = mindeg_delaunay::triangles(&outline, &[], &[], Progress::NONE).unwrap();
    let found = run(&(points, triangles), &Keep::default());
    assert_eq!(found.after.violations, []);
    assert!(found.after.min_angle > 19.0, "{:?}", found.after);
}

#[test]
fn a_good_mesh_is_no_worse() {
    let good = run(&square(9, &scattered(90)), &Keep::default());
    let again = run(&(good.points.clone(), good.triangles), &Keep::default());
    assert!(again.after.min_angle >= good.after.min_angle.min(35.0));
    assert_eq!(again.after.violations, []);
}

#[test]
fn kept_vertices_and_edges_stay() {
    let mesh = square(8, &scattered(60));
    let (a, b) = (mesh.1[40][0], mesh.1[40][1]);
    run(&mesh, &Keep { vertices: vec![35, 50, 70], edges: vec![[a, b]] });
}

/// The ends of such a line were taken for vertices inside with too few edges, and good meshes got worse to mend them.
#[test]
fn a_line_that_ends_on_the_boundary_leaves_its_ends_there() {
    let at = |x: u32, y: u32| 9 * y + x;
    let points = (0..45).map(|v| DVec2::new(f64::from(v % 9), f64::from(v / 9))).collect();
    let cells = (0..4).flat_map(|y| (0..8).map(move |x| (x, y)));
    let triangles = cells.flat_map(|(x, y)| {
        let [a, b, c, d] = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
        [[a, b, c], [a, c, d]]
    });
    let line = (0..4).map(|y| [at(4, y), at(4, y + 1)]).collect();
    let mesh = (points, triangles.collect());
    let found = run(&mesh, &Keep { vertices: Vec::new(), edges: line });
    assert_eq!((&found.before.violations[..], found.before.interior_points), (&[][..], 21));
    assert_eq!(found.triangles, mesh.1);
}

#[test]
fn unused_points_stay() {
    let mut mesh = square(4, &scattered(9));
    mesh.0.push(DVec2::new(7.0, 7.0));
    let found = run(&mesh, &Keep::default());
    assert!(found.sources.contains(&Some(25)));
}

#[test]
fn meshes_with_faults_are_refused() {
    let points: Vec<DVec2> =
        [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.5, 2.0], [f64::NAN, 0.0]]
            .map(DVec2::from)
            .to_vec();
    for (triangles, keep, expected) in [
        (vec![], Keep::default(), "0 triangles"),
        (vec![[0, 1, 9]], Keep::default(), "vertex 9 is named"),
        (vec![[0, 2, 1]], Keep::default(), "triangle 0 is flat or clockwise"),
        (vec![[0, 1, 2], [0, 1, 3]], Keep::default(), "edge 0-1 in one direction"),
        (vec![[0, 1, 2]], Keep { vertices: vec![], edges: vec![[0, 3]] }, "edge 0-3 is missing"),
    ] {
        let error = improve(&points[..5], &triangles, &keep, &Options::default(), Progress::NONE);
        let error = error.unwrap_err();
        assert!(matches!(error, InteriorError::BadMesh(_)));
        assert!(error.to_string().contains(expected), "{error}");
    }
    let error =
        improve(&points, &[[0, 1, 2]], &Keep::default(), &Options::default(), Progress::NONE);
    assert!(error.unwrap_err().to_string().contains("vertex 5"));
    // Two triangles that touch at a vertex only.
    let bow: Vec<DVec2> =
        [[0.0, 0.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0]].map(DVec2::from).to_vec();
    let error = improve(
        &bow,
        &[[0, 1, 2], [0, 3, 4]],
        &Keep::default(),
        &Options::default(),
        Progress::NONE,
    );
    assert!(error.unwrap_err().to_string().contains("more than one fan"));
    let options = Interior { target_angle: Some(50.0), ..Interior::default() }.into();
    let error = improve(&bow, &[[0, 1, 2]], &Keep::default(), &options, Progress::NONE);
    assert!(matches!(error, Err(InteriorError::TargetAboveLimit { .. })));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn any_delaunay_mesh_stays_valid(
        side in 1..9_u32,
        inside in prop::collection::vec((0.0..1.0_f64, 0.0..1.0_f64), 0..60),
        kept in prop::collection::vec(any::<prop::sample::Index>(), 0..5),
    ) {
        let mesh = square(side, &inside);
        let mut keep = Keep::default();
        for index in kept {
            let triangle = index.get(&mesh.1);
            keep.vertices.push(triangle[0]);
            keep.edges.push([triangle[1], triangle[2]]);
        }
        run(&mesh, &keep);
    }
}
