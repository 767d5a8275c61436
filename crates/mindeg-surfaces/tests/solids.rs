//! The features, patches, sizes and feet of solids whose answers are known.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use glam::DVec3;
use mindeg_mesh::Progress;
use mindeg_surfaces::{FeatureRules, NONE, SizeRules, Spot, Surface};
use proptest::prelude::*;

type Solid = (Vec<DVec3>, Vec<[u32; 3]>);

/// A box with n by n quads, each in two triangles, to a side; points repeat at edges, as in an STL.
fn cuboid(n: u32, extent: DVec3) -> Solid {
    let (mut points, mut triangles) = (Vec::new(), Vec::new());
    for side in 0..6 {
        let (axis, is_high) = (side / 2, side % 2 == 1);
        let first = points.len() as u32;
        for i in 0..=n {
            for j in 0..=n {
                let [u, v] = [i, j].map(|k| f64::from(k) / f64::from(n));
                let mut p = [0.0; 3];
                p[axis] = f64::from(u8::from(is_high));
                (p[(axis + 1) % 3], p[(axis + 2) % 3]) = (u, v);
                points.push(DVec3::from(p) * extent);
            }
        }
        for i in 0..n {
            for j in 0..n {
                let at = |i: u32, j: u32| first + i * (n + 1) + j;
                let quad = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                let quad = if is_high { quad } else { [quad[0], quad[3], quad[2], quad[1]] };
                triangles.extend([[quad[0], quad[1], quad[2]], [quad[0], quad[2], quad[3]]]);
            }
        }
    }
    (points, triangles)
}

/// A cylinder of radius 1 between z = 0 and z = height, with n facets; open without `caps`.
fn cylinder(n: u32, height: f64, caps: bool) -> Solid {
    let turn = |i: u32| std::f64::consts::TAU * f64::from(i % n) / f64::from(n);
    let at = |i: u32, z: f64| DVec3::new(turn(i).cos(), turn(i).sin(), z);
    let mut points: Vec<DVec3> = (0..n).flat_map(|i| [at(i, 0.0), at(i, height)]).collect();
    points.extend([DVec3::ZERO, height * DVec3::Z]);
    let mut triangles = Vec::new();
    for i in 0..n {
        let [a, b] = [2 * i, 2 * ((i + 1) % n)];
        triangles.extend([[a, b, b + 1], [a, b + 1, a + 1]]);
        if caps {
            triangles.extend([[b, a, 2 * n], [a + 1, b + 1, 2 * n + 1]]);
        }
    }
    (points, triangles)
}

fn surface((points, triangles): &Solid, rules: FeatureRules) -> Surface {
    Surface::new(points, triangles, &[], &rules).unwrap()
}

#[test]
fn a_box_has_twelve_curves_eight_corners_and_six_patches() {
    let box_ = surface(&cuboid(4, DVec3::new(1.0, 2.0, 3.0)), FeatureRules::default());
    assert_eq!((box_.patch_count(), box_.curves().len()), (6, 12));
    assert_eq!(box_.points().len(), 6 * 16 + 2);
    let corners = (0..box_.points().len() as u32).filter(|v| box_.spot(*v) == Spot::Corner);
    assert_eq!(corners.count(), 8);
    let mut lengths: Vec<f64> = box_.curves().iter().map(|curve| curve.length()).collect();
    lengths.sort_by(f64::total_cmp);
    assert_eq!(lengths, [1.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 2.0, 3.0, 3.0, 3.0, 3.0]);
    assert!(box_.curves().iter().all(|curve| !curve.is_closed() && !curve.is_boundary()));
    for t in 0..box_.triangles().len() as u32 {
        assert!((0..3).all(|i| box_.corner_normal(t, i) == box_.face_normal(t)));
    }
    let round = surface(
        &cuboid(4, DVec3::ONE),
        FeatureRules { angle_deg: 180.0, ..FeatureRules::default() },
    );
    assert_eq!((round.patch_count(), round.curves().len()), (1, 0));
    assert!((0..98).all(|v| round.spot(v) == Spot::Inside { patch: 0 }));
}

#[test]
fn a_cylinder_has_closed_curves_that_repeat() {
    for (caps, patches) in [(true, 3), (false, 1)] {
        let cylinder = surface(&cylinder(24, 2.0, caps), FeatureRules::default());
        assert_eq!((cylinder.patch_count(), cylinder.curves().len()), (patches, 2));
        for curve in cylinder.curves() {
            assert!(curve.is_closed() && curve.is_boundary() != caps && curve.ends().is_none());
            let length = 48.0 * (std::f64::consts::PI / 24.0).sin();
            assert!((curve.length() - length).abs() < 1e-12);
            assert_eq!(curve.points().len(), 25);
            let t = 0.3 * length;
            assert!(curve.at(t).distance(curve.at(t - length)) < 1e-12);
            assert!((curve.way(0.9 * length, 0.1 * length) - 0.2 * length).abs() < 1e-12);
            assert!((curve.way(0.1 * length, 0.9 * length) + 0.2 * length).abs() < 1e-12);
            let step = curve.at(t + 1e-6) - curve.at(t);
            assert!((step / 1e-6).distance(curve.direction(t)) < 1e-6);
        }
        // At the rim the wall's normals lie in the plane, the caps' along the axis.
        for t in 0..cylinder.triangles().len() as u32 {
            let is_cap = cylinder.face_normal(t).z.abs() > 0.5;
            for i in 0..3 {
                let expected = if is_cap { 1.0 } else { 0.0 };
                assert!((cylinder.corner_normal(t, i).z.abs() - expected).abs() < 1e-12);
            }
        }
    }
}

#[test]
fn a_tip_is_a_corner_and_groups_have_borders() {
    // A cone over 16 points whose tip has a defect of 1.84, open below.
    let turn = |i: u32| std::f64::consts::TAU * f64::from(i % 16) / 16.0;
    let mut points: Vec<DVec3> =
        (0..16).map(|i| DVec3::new(turn(i).cos(), turn(i).sin(), 0.0)).collect();
    points.push(DVec3::Z);
    let triangles: Vec<[u32; 3]> = (0..16).map(|i| [i, (i + 1) % 16, 16]).collect();
    let cone = Surface::new(&points, &triangles, &[], &FeatureRules::default()).unwrap();
    assert_eq!((cone.curves().len(), cone.spot(16)), (1, Spot::Corner));
    points[16].z = 0.5;
    let flat = Surface::new(&points, &triangles, &[], &FeatureRules::default()).unwrap();
    assert_eq!(flat.spot(16), Spot::Inside { patch: 0 });
    // A needle's tip is one at any angle.
    let smooth = FeatureRules { angle_deg: 180.0, ..FeatureRules::default() };
    for (height, spot) in [(1.0, Spot::Inside { patch: 0 }), (6.0, Spot::Corner)] {
        points[16].z = height;
        assert_eq!(Surface::new(&points, &triangles, &[], &smooth).unwrap().spot(16), spot);
    }
    points[16].z = 0.5;
    // Two groups: their border turns at the tip, and ends at the rim.
    let groups: Vec<u32> = (0..16).map(|i| 7 + i / 8).collect();
    let halves = Surface::new(&points, &triangles, &groups, &FeatureRules::default()).unwrap();
    assert_eq!((halves.patch_count(), halves.curves().len()), (2, 4));
    assert_eq!([halves.group(0), halves.group(1)], [7, 8]);
}

#[test]
fn gaps_are_closed_and_short_ends_dropped() {
    // A roof of 30 quads along y whose ridge turns by 60°, except for a gap that turns by 30°.
    let ridge = |gap: std::ops::Range<u32>, end: u32| {
        let mut points = Vec::new();
        for row in 0..=30 {
            let slope = if gap.contains(&row) { 0.268 } else { 0.577 };
            let slope = slope * (1.0 - 0.1 * f64::from(row.saturating_sub(end))).max(0.0);
            let y = f64::from(row);
            points.extend([-1.0, 0.0, 1.0].map(|x: f64| DVec3::new(x, y, -slope * x.abs())));
        }
        let quad = |row: u32, side: u32| {
            let [a, b] = [3 * row + side, 3 * row + side + 1];
            [[a, b, b + 3], [a, b + 3, a + 3]]
        };
        let triangles = (0..30).flat_map(|row| [quad(row, 0), quad(row, 1)]).flatten();
        (points, triangles.collect::<Vec<_>>())
    };
    let rules = FeatureRules { weak_angle_deg: 20.0, shortest: 6.0, ..FeatureRules::default() };
    let inner = |surface: &Surface| {
        let inner = surface.curves().iter().filter(|curve| !curve.is_boundary());
        inner.map(|curve| curve.length()).collect::<Vec<f64>>()
    };
    // Whole: the ridge goes from end to end.
    assert_eq!(inner(&surface(&ridge(0..0, 30), rules)), [30.0]);
    // A gap of four edges is closed, one of nine is not.
    assert_eq!(inner(&surface(&ridge(12..15, 30), rules)), [30.0]);
    assert_eq!(inner(&surface(&ridge(12..20, 30), rules)).len(), 2);
    // Without hysteresis the gap stays.
    let strict = FeatureRules { weak_angle_deg: 40.0, ..rules };
    assert_eq!(inner(&surface(&ridge(12..15, 30), strict)).len(), 2);
    // A ridge that ends in the plane is kept when it is long.
    for (end, expected) in [(20, true), (1, false)] {
        let longest = inner(&surface(&ridge(0..0, end), rules)).into_iter().fold(0.0, f64::max);
        assert_eq!(longest >= 3.0, expected, "{end}: {longest}");
    }
}

#[test]
fn faults_are_listed_with_their_places() {
    let points = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z, -DVec3::Y, 2.0 * DVec3::X];
    for (triangles, expected) in [
        (&[][..], &["the surface has no triangle"][..]),
        (&[[0, 1, 2], [1, 0, 3], [1, 0, 4]], &["3 triangles share an edge (0, 1, 2)"]),
        (&[[0, 1, 2], [0, 1, 3]], &["triangles 0 and 1 share an edge and face opposite ways"]),
        (&[[0, 1, 5], [0, 1, 2]], &["triangle 0 has no area", "share an edge and face"]),
        (&[[0, 1, 2], [2, 1, 0]], &["triangles 0 and 1 cover each other"]),
        (&[[0, 1, 6]], &["triangle 0 names point 6, and there are 6"]),
    ] {
        let error = Surface::new(&points, triangles, &[], &FeatureRules::default()).unwrap_err();
        assert_eq!(error.faults.len(), expected.len(), "{error}");
        for (fault, expected) in error.faults.iter().zip(expected) {
            assert!(fault.what.contains(expected), "{error}");
        }
    }
    let infinite = [DVec3::ZERO, DVec3::X, DVec3::new(0.0, f64::NAN, 0.0)];
    let error = Surface::new(&infinite, &[[0, 1, 2]], &[], &FeatureRules::default()).unwrap_err();
    assert!(error.to_string().starts_with("point 2 has a coordinate that is not below"), "{error}");
}

#[test]
fn a_point_of_two_fans_becomes_two_vertices() {
    // Two triangles that share a corner only.
    let points = [DVec3::ZERO, DVec3::X, DVec3::Y, -DVec3::X, -DVec3::Y];
    let surface =
        Surface::new(&points, &[[0, 1, 2], [0, 3, 4]], &[], &FeatureRules::default()).unwrap();
    assert_eq!((surface.points().len(), surface.split_vertices()), (6, 1));
    assert_eq!(surface.inputs(), [0, 0, 1, 2, 3, 4]);
    assert_eq!(surface.triangles(), [[0, 2, 3], [1, 4, 5]]);
}

/// The invariants of every surface: neighbours know each other, spans and patches agree on both sides.
fn check(surface: &Surface) {
    for (t, around) in (0_u32..).zip(surface.neighbours()) {
        let corners = surface.triangles()[t as usize];
        for (i, &u) in around.iter().enumerate() {
            let [a, b] = [corners[(i + 1) % 3], corners[(i + 2) % 3]];
            let span = surface.span(t, i);
            if let Some(span) = span {
                assert!(span.vertices == [a, b] || span.vertices == [b, a]);
                for (v, at) in span.vertices.into_iter().zip(span.range) {
                    let on = surface.curve(span.curve).at(at);
                    let closed = surface.curve(span.curve).is_closed();
                    assert!(
                        on.distance(surface.points()[v as usize]) < 1e-12 || closed && at > 0.0
                    );
                    if let Spot::Curve { curve, t } = surface.spot(v) {
                        assert_eq!(curve, span.curve);
                        assert!(surface.curve(curve).way(t, at).abs() < 1e-12);
                    }
                }
            }
            if u == NONE {
                assert!(span.is_some());
                continue;
            }
            let other = surface.triangles()[u as usize];
            let j = (0..3).find(|j| other[(j + 1) % 3] == b && other[(j + 2) % 3] == a).unwrap();
            assert_eq!(surface.neighbours()[u as usize][j], t);
            assert_eq!(surface.span(u, j), span);
            assert!(span.is_some() || surface.patch(t) == surface.patch(u));
        }
    }
}

#[test]
fn refining_keeps_the_surface_and_its_features() {
    let plate = DVec3::new(4.0, 4.0, 0.1);
    for (solid, size) in [
        (cuboid(1, DVec3::ONE), 0.2),
        (cuboid(3, plate), 0.5),
        (cylinder(24, 2.0, true), 0.3),
        (cylinder(7, 9.0, false), 0.4),
    ] {
        let coarse = surface(&solid, FeatureRules::default());
        let rules = SizeRules::of_size(size);
        let fine = coarse.refined(&rules, Progress::NONE).unwrap();
        check(&coarse);
        check(&fine);
        assert_eq!(fine.curves(), coarse.curves());
        assert_eq!(fine.patch_count(), coarse.patch_count());
        let area = |surface: &Surface, t: u32| {
            let [a, b, c] = surface.triangles()[t as usize].map(|v| surface.points()[v as usize]);
            0.5 * (b - a).cross(c - a).length()
        };
        let mut areas = vec![0.0; coarse.triangles().len()];
        for t in 0..fine.triangles().len() as u32 {
            let origin = fine.origin(t);
            areas[origin as usize] += area(&fine, t);
            assert_eq!(fine.patch(t), coarse.patch(origin));
            assert!(fine.face_normal(t).distance(coarse.face_normal(origin)) < 1e-9);
        }
        for (t, sum) in (0_u32..).zip(areas) {
            assert!((sum - area(&coarse, t)).abs() < 1e-12);
        }
        let mut longest = 0.0_f64;
        for &corners in fine.triangles() {
            for i in 0..3 {
                let [a, b] = [corners[i], corners[(i + 1) % 3]];
                let [p, q] = [a, b].map(|v| fine.points()[v as usize]);
                assert!(p.distance(q) <= size);
                longest = longest.max(p.distance(q));
                let growth = (fine.size(a) - fine.size(b)).abs() / p.distance(q);
                assert!(growth <= rules.growth * (1.0 + 1e-9));
            }
        }
        assert!(longest > 0.4 * size, "{longest}");
    }
}

#[test]
fn sizes_shrink_where_features_are_near_and_surfaces_bend() {
    let sizes = |solid: &Solid, size: f64| {
        let fine = surface(solid, FeatureRules::default());
        let fine = fine.refined(&SizeRules::of_size(size), Progress::NONE).unwrap();
        let all: Vec<f64> = (0..fine.points().len() as u32).map(|v| fine.size(v)).collect();
        (fine, all)
    };
    // A cube has room for its size everywhere, except for its own edges.
    let (_, cube) = sizes(&cuboid(2, DVec3::ONE), 0.3);
    assert!(cube.iter().all(|size| *size == 0.3));
    let (_, short) = sizes(&cuboid(2, DVec3::ONE), 3.0);
    assert!(short.iter().all(|size| *size <= 1.0 + 0.4 * 0.71), "{short:?}");
    // The rim of a plate of thickness 0.2 asks for 0.22, and 0.2 at its corners; its middle for the size.
    let (plate, of_plate) = sizes(&cuboid(4, DVec3::new(6.0, 6.0, 0.2)), 0.5);
    for (v, size) in (0_u32..).zip(of_plate) {
        let [x, y, _] = plate.points()[v as usize].to_array();
        let inside = [x, y, 6.0 - x, 6.0 - y].into_iter().fold(f64::INFINITY, f64::min);
        if inside == 0.0 && !matches!(plate.spot(v), Spot::Inside { .. }) {
            // Where the way round the corner is short, the distance between the rims does not count.
            let at_corner = [x, y].into_iter().all(|x| !(0.4..=5.6).contains(&x));
            assert!((0.2..=if at_corner { 0.32 } else { 0.2201 }).contains(&size), "{size}");
        } else if inside > 1.0 {
            assert_eq!(size, 0.5);
        }
    }
    // A rod of radius 1 has five edges round its rim, whatever the size.
    let (rod, of_rod) = sizes(&cylinder(48, 4.0, true), 3.0);
    let most = rod.curve(0).length() / 5.0;
    assert!(of_rod.iter().all(|size| *size <= most + 0.4 * 2.0));
}

proptest! {
    /// The nearest point is that of all triangles, whatever the hint.
    #[test]
    fn the_nearest_point_is_that_of_a_full_search(
        from in prop::array::uniform3(-2.0..3.0_f64),
        facing in prop::option::of(prop::array::uniform3(-1.0..1.0_f64)),
        hint in 0_u32..400,
    ) {
        let solids = [cuboid(4, DVec3::ONE), cylinder(24, 2.0, true)];
        for solid in &solids {
            let surface = surface(solid, FeatureRules::default());
            let (from, facing) = (DVec3::from(from), facing.map(DVec3::from));
            for patch in 0..surface.patch_count() {
                let foot = surface.nearest(patch, from, facing, hint);
                prop_assert_eq!(surface.patch(foot.triangle), patch);
                prop_assert_eq!(surface.nearest(patch, from, facing, NONE), foot);
                prop_assert!((foot.point.distance(from) - foot.distance).abs() < 1e-12);
                let of_patch = (0..surface.triangles().len() as u32).filter(|t| surface.patch(*t) == patch);
                let (facing_any, all): (Vec<u32>, Vec<u32>) = (
                    of_patch.clone().filter(|t| facing.is_none_or(|to| surface.face_normal(*t).dot(to) > 0.0)).collect(),
                    of_patch.collect(),
                );
                let counted = if facing_any.is_empty() { all } else { facing_any };
                prop_assert!(counted.contains(&foot.triangle));
                // Samples of all triangles that count: none is nearer.
                for t in counted {
                    let [a, b, c] = surface.triangles()[t as usize].map(|v| surface.points()[v as usize]);
                    for i in 0..=8 {
                        for j in 0..=8 - i {
                            let [u, v] = [i, j].map(|k| f64::from(k) / 8.0);
                            let sample = u * a + v * b + (1.0 - u - v) * c;
                            prop_assert!(sample.distance(from) >= foot.distance - 1e-12);
                        }
                    }
                }
            }
        }
    }
}
