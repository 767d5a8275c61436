//! Remeshes that are right pass, and each kind of defect is found.

use mindeg::glam::DVec3;
use mindeg::verify::{self, SurfaceRules, VerifiedSurface};
use mindeg::{Progress, TriMesh};

/// An icosahedron on the unit sphere whose triangles are cut in four `levels` times.
fn sphere(levels: u32) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let golden = 0.5 * (1.0 + 5.0_f64.sqrt());
    let mut points = Vec::new();
    for (a, b) in [(1.0, golden), (-1.0, golden), (1.0, -golden), (-1.0, -golden)] {
        points.extend([DVec3::new(0.0, a, b), DVec3::new(a, b, 0.0), DVec3::new(b, 0.0, a)]);
    }
    let edge = |a: u32, b: u32| points[a as usize].distance(points[b as usize]) < 2.1;
    let mut triangles = Vec::new();
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if edge(a, b) && edge(b, c) && edge(a, c) {
                    let [p, q, r] = [a, b, c].map(|v| points[v as usize]);
                    let is_right = (q - p).cross(r - p).dot(p) > 0.0;
                    triangles.push(if is_right { [a, b, c] } else { [a, c, b] });
                }
            }
        }
    }
    points.iter_mut().for_each(|p| *p = p.normalize());
    for _ in 0..levels {
        (points, triangles) = quartered(&points, &triangles);
        points.iter_mut().for_each(|p| *p = p.normalize());
    }
    (points, triangles)
}

/// Each triangle in four; points repeat.
fn quartered(points: &[DVec3], triangles: &[[u32; 3]]) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let (mut finer, mut cut) = (Vec::new(), Vec::new());
    for t in triangles {
        let [a, b, c] = t.map(|v| points[v as usize]);
        let first = finer.len() as u32;
        finer.extend([a, b, c, a.midpoint(b), b.midpoint(c), c.midpoint(a)]);
        let quarters = [[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]];
        cut.extend(quarters.map(|t: [u32; 3]| t.map(|v| first + v)));
    }
    (finer, cut)
}

fn mesh((points, triangles): (Vec<DVec3>, Vec<[u32; 3]>)) -> TriMesh {
    TriMesh::new(points, triangles).unwrap()
}

fn cube(extent: f64) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let points = (0..8_u32).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(f64::from));
    let quads =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    (points.map(|p| extent * DVec3::from(p)).collect(), triangles)
}

fn verified(mesh: &TriMesh, part: &TriMesh, rules: &SurfaceRules) -> VerifiedSurface {
    verify::surface(mesh, part, rules, Progress::NONE).unwrap()
}

fn kinds(found: &VerifiedSurface) -> Vec<&'static str> {
    found.defects.iter().map(|defect| defect.kind).collect()
}

#[test]
fn a_coarser_sphere_passes_within_its_distance() {
    let (part, coarse) = (mesh(sphere(4)), mesh(sphere(2)));
    let found = verified(&coarse, &part, &SurfaceRules::within(0.03));
    assert_eq!(found.defects, []);
    assert_eq!((found.vertices, found.inside, found.boundary), (162, Some([5, 6]), None));
    // The middle of a triangle is the farthest point, and the distance is that of its plane.
    assert!((0.01..0.03).contains(&found.to_part.lower), "{found:?}");
    assert!(found.from_part.upper < 1.03 * found.from_part.lower);
    let strict = verified(&coarse, &part, &SurfaceRules::within(0.5 * found.from_part.lower));
    assert_eq!(kinds(&strict), ["distance", "distance_from_part"]);
}

#[test]
fn a_mesh_that_is_off_at_one_place_fails() {
    let part = mesh(sphere(3));
    let (mut points, triangles) = sphere(3);
    let tip = points[0];
    points.iter_mut().filter(|p| **p == tip).for_each(|p| *p *= 1.1);
    let found = verified(&mesh((points, triangles)), &part, &SurfaceRules::within(0.05));
    assert_eq!(kinds(&found), ["distance", "distance_from_part"]);
    assert!(
        (found.to_part.lower - 0.1).abs() < 2e-3 && found.to_part.place.distance(1.1 * tip) < 1e-12
    );
    assert!(found.defects[0].message.contains("the tolerance is 0.05"), "{:?}", found.defects);
}

#[test]
fn turned_and_missing_and_crossing_triangles_are_found() {
    let part = mesh(sphere(3));
    let rules = SurfaceRules::within(0.01);
    let (points, mut triangles) = sphere(3);
    triangles[7].swap(0, 1);
    let one = verified(&mesh((points.clone(), triangles.clone())), &part, &rules);
    assert_eq!(kinds(&one), ["inconsistent", "turned_over"]);
    triangles.iter_mut().for_each(|t| t.swap(0, 1));
    let all = verified(&mesh((points.clone(), triangles.clone())), &part, &rules);
    assert_eq!(kinds(&all), ["inconsistent", "turned_over"]);
    assert!(all.defects[1].message.starts_with("1279 triangles"), "{:?}", all.defects);
    let (points, mut triangles) = sphere(3);
    triangles.pop();
    let open = verified(&mesh((points, triangles)), &part, &rules);
    assert!(kinds(&open).contains(&"boundary") && kinds(&open).contains(&"distance_from_part"));
    // Two spheres apart, and moved into each other.
    let pair = |by: f64| {
        let (mut points, mut triangles) = sphere(2);
        let count = points.len() as u32;
        points.extend(points.clone().iter().map(|p| p + by * DVec3::new(1.0, 0.1, 0.2)));
        triangles.extend(triangles.clone().iter().map(|t| t.map(|v| v + count)));
        mesh((points, triangles))
    };
    let crossed = verified(&pair(1.9), &pair(2.1), &SurfaceRules::within(0.3));
    assert_eq!(kinds(&crossed), ["crossing"]);
    let both = verified(&pair(1.9), &pair(1.8), &SurfaceRules::within(0.3));
    assert_eq!((kinds(&both).len(), both.part_crossings > 0), (0, true));
}

#[test]
fn degrees_and_kept_edges_are_checked() {
    let part = mesh(cube(1.0));
    let rules = SurfaceRules { feature_angle: Some(40.0), ..SurfaceRules::within(0.0) };
    let same = verified(&part, &part, &rules);
    let rounding = SurfaceRules { inside: 3..=6, keep_features: true, ..rules.clone() };
    assert_eq!(kinds(&verified(&part, &part, &rounding)), [""; 0]);
    assert_eq!(kinds(&same), ["degree"]);
    // Edges that are cut in two are others, at the same place.
    let (points, triangles) = cube(1.0);
    let finer = mesh(quartered(&points, &triangles));
    let cut = verified(&finer, &part, &rounding);
    assert_eq!(kinds(&cut), ["features_changed"]);
    assert!(cut.defects[0].message.starts_with("12 sharp edges"), "{:?}", cut.defects);
    let loose = SurfaceRules { keep_features: false, ..rounding.clone() };
    assert_eq!(kinds(&verified(&finer, &part, &loose)), [""; 0]);
    // A sphere in a cube has no sharp edges.
    let round =
        verified(&mesh(sphere(3)), &mesh(cube(2.0)), &SurfaceRules { tolerance: 10.0, ..loose });
    assert_eq!(kinds(&round), ["features"]);
    // The boundary of an open box, kept and cut.
    let open = |(points, mut triangles): (Vec<DVec3>, Vec<[u32; 3]>), left| {
        triangles.truncate(left);
        mesh((points, triangles))
    };
    let box_ = open(cube(1.0), 10);
    let rules = SurfaceRules { keep_boundary: true, inside: 3..=7, ..SurfaceRules::within(0.0) };
    assert_eq!(kinds(&verified(&box_, &box_, &rules)), [""; 0]);
    let finer = open(quartered(&points, &triangles), 40);
    let kinds_of_finer = kinds(&verified(&finer, &box_, &rules));
    assert_eq!(kinds_of_finer, ["boundary_changed", "boundary_changed"]);
    let loose = SurfaceRules { keep_boundary: false, ..rules };
    assert_eq!(kinds(&verified(&finer, &box_, &loose)), [""; 0]);
}

/// A regular tetrahedron.
fn tetrahedron() -> TriMesh {
    let points = [[0.0; 3], [1.0, 1.0, 0.0], [0.0, 1.0, 1.0], [1.0, 0.0, 1.0]].map(DVec3::from);
    mesh((points.to_vec(), vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]))
}

/// Pyramids up and down on a ring of points in turn 1 and `inner` from the middle.
fn star(points: u32, inner: f64) -> TriMesh {
    let count = 2 * points;
    let ring = |i: u32| {
        let turn = std::f64::consts::TAU * f64::from(i) / f64::from(count);
        let radius = if i.is_multiple_of(2) { 1.0 } else { inner };
        DVec3::new(radius * turn.cos(), radius * turn.sin(), 0.0)
    };
    let tips = [1.0, -1.0].map(|z| DVec3::new(0.0, 0.0, z));
    let next = |i: u32| (i + 1) % count;
    let sides = (0..count).flat_map(|i| [[i, next(i), count], [next(i), i, count + 1]]).collect();
    mesh(((0..count).map(ring).chain(tips).collect(), sides))
}

/// A cone of height 6 over the corners of a regular polygon on the unit circle, its tip first.
fn needle(count: u32) -> TriMesh {
    let ring = |i: u32| {
        let (sin, cos) = (f64::from(i) / f64::from(count) * std::f64::consts::TAU).sin_cos();
        DVec3::new(cos, sin, 0.0)
    };
    let next = |i: u32| 2 + (i + 1) % count;
    let sides = (0..count).flat_map(|i| [[0, 2 + i, next(i)], [1, next(i), 2 + i]]).collect();
    mesh(([6.0 * DVec3::Z, DVec3::ZERO].into_iter().chain((0..count).map(ring)).collect(), sides))
}

/// Where no three triangles of 35° fit, a mesh may have as few edges as its minimum angle needs.
#[test]
fn needles_prove_few_edges_at_their_tips() {
    let part = needle(12);
    let rules = SurfaceRules::within(1.0);
    let tip = |mesh: &TriMesh| {
        let found = verified(mesh, &part, &rules);
        found.proven.iter().find(|tip| tip.vertex == 0).map(|tip| (tip.degree, tip.allowed))
    };
    assert_eq!(tip(&needle(3)), Some((3, [3, 3])));
    assert_eq!(tip(&needle(4)), Some((4, [3, 4])));
    // With twelve the minimum angle is so small that five edges fit.
    assert_eq!(tip(&part), None);
}

#[test]
fn corners_prove_degrees_out_of_the_usual_range() {
    let part = tetrahedron();
    let rules = SurfaceRules::within(0.0);
    let found = verified(&part, &part, &rules);
    assert_eq!((kinds(&found), found.out_of_range.len()), (vec![], 0));
    let tips: Vec<_> =
        found.proven.iter().map(|tip| (tip.vertex, tip.degree, tip.allowed)).collect();
    assert_eq!(tips, [0, 1, 2, 3].map(|v| (v, 3, [3, 3])));
    assert!(found.proven[0].sectors.iter().all(|angle| (angle - 60.0).abs() < 1e-9));
    // At 30° a sector of 60° has room for two triangles.
    let lower = SurfaceRules { least_angle: 30.0, ..rules.clone() };
    let found = verified(&part, &part, &lower);
    assert_eq!((kinds(&found), found.proven.len()), (vec!["degree"], 0));
    // Eight sharp edges at a tip are eight edges; the points of the star have other degrees without reason.
    let part = star(4, 0.3);
    let found = verified(&part, &part, &rules);
    let tips: Vec<_> = found.proven.iter().filter(|tip| tip.degree == 8).collect();
    assert_eq!(
        tips.iter().map(|tip| (tip.vertex, tip.allowed)).collect::<Vec<_>>(),
        [8, 9].map(|v| (v, [8, 8]))
    );
    // A vertex at the place of a corner whose sharp edges the mesh lacks.
    let octahedron = star(2, 1.0);
    assert_eq!(verified(&octahedron, &octahedron, &rules).proven.len(), 6);
    let rim = [DVec3::X, DVec3::Y, -DVec3::X, -DVec3::Y].map(|p| p + DVec3::Z);
    let points = rim.into_iter().chain([DVec3::Z]).collect();
    let flat = mesh((points, vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]));
    let found = verified(&flat, &octahedron, &rules);
    assert_eq!((found.proven.len(), found.out_of_range.len()), (0, 1));
}
