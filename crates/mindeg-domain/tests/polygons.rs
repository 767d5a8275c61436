//! Random polygons with holes: valid ones are accepted unchanged, damaged ones refused with the
//! right reason.

use glam::DVec2;
use mindeg_domain::{Curve, Domain, Ring, Side};
use proptest::prelude::*;

/// A star-shaped ring about a center: radii at even angles.
fn star(center: DVec2, radii: &[f64]) -> Vec<DVec2> {
    let angle = |i: usize| std::f64::consts::TAU * i as f64 / radii.len() as f64;
    let arm = |i: usize| DVec2::new(libm::cos(angle(i)), libm::sin(angle(i)));
    radii.iter().enumerate().map(|(i, radius)| center + radius * arm(i)).collect()
}

/// An outline of radius 10 to 14 and some holes, each in its own square of a grid in the outline.
fn rings() -> impl Strategy<Value = Vec<Vec<DVec2>>> {
    let outline = prop::collection::vec(10.0..14.0_f64, 5..40);
    let hole = (0..16_usize, prop::collection::vec(0.2..1.4_f64, 3..12), any::<bool>());
    (outline, prop::collection::vec(hole, 0..6), any::<bool>()).prop_map(
        |(radii, holes, turned)| {
            let turn = |mut ring: Vec<DVec2>, turned: bool| {
                if turned {
                    ring[1..].reverse();
                }
                ring
            };
            let mut rings = vec![turn(star(DVec2::ZERO, &radii), turned)];
            let mut taken = [false; 16];
            for (cell, radii, turned) in holes {
                if !std::mem::replace(&mut taken[cell], true) {
                    let center = DVec2::new((cell % 4) as f64 - 1.5, (cell / 4) as f64 - 1.5) * 3.0;
                    rings.push(turn(star(center, &radii), turned));
                }
            }
            rings
        },
    )
}

fn signed_area(ring: &[DVec2]) -> f64 {
    let next = |i: usize| ring[(i + 1) % ring.len()];
    (0..ring.len()).map(|i| ring[i].perp_dot(next(i))).sum::<f64>() / 2.0
}

/// The message about rings that meet.
fn refusal(rings: Vec<Vec<DVec2>>) -> String {
    match Domain::from_rings(rings).map(|domain| domain.placement().area()) {
        Err(error) if error.is_touch => error.message,
        other => unreachable!("the damage is not found: {other:?}"),
    }
}

fn says(message: &str, any_of: &[&str]) -> bool {
    any_of.iter().any(|words| message.contains(words))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn rings_of_points_come_back(rings in rings()) {
        // Radii of 10 and more at 72° keep 8 from the center, and the holes stay within 8.
        let domain = Domain::from_rings(rings.clone()).unwrap();
        let points: Vec<DVec2> = domain.placement().points().collect();
        let mut vertices = points.into_iter();
        for (ring, given) in rings.iter().enumerate() {
            let found: Vec<DVec2> = vertices.by_ref().take(given.len()).collect();
            let area = signed_area(&found);
            prop_assert!((area > 0.0) == (ring == 0), "ring {} has area {}", ring, area);
            let mut same = given.clone();
            if signed_area(given) * area < 0.0 {
                same[1..].reverse();
                prop_assert!(domain.notes().iter().any(|note| note.contains("reversed")));
            }
            prop_assert_eq!(found, same);
        }
        let area = signed_area(&rings[0]).abs()
            - rings[1..].iter().map(|ring| signed_area(ring).abs()).sum::<f64>();
        prop_assert!((domain.placement().area() - area).abs() < 1e-9 * area);
        // The domain's own sides describe it again.
        let again = domain.with_sides(domain.sides().to_vec()).unwrap();
        prop_assert!(again.placement().points().eq(domain.placement().points()));
        prop_assert_eq!((again.sides(), again.notes()), (domain.sides(), domain.notes()));
    }

    /// The same rings, as corners with sides between them, give the same corners and area.
    #[test]
    fn corners_are_kept_whatever_is_between(rings in rings(), count in 1..5_u64) {
        let sides = |ring: &Vec<DVec2>| vec![Side::count(count); ring.len()];
        let described: Vec<Ring> =
            rings.iter().map(|ring| Ring::new(ring.iter().copied(), sides(ring))).collect();
        let domain = Domain::of_rings(described).unwrap();
        let plain = Domain::from_rings(rings).unwrap();
        prop_assert!(domain.placement().corners().iter().copied().eq(plain.placement().points()));
        let area = plain.placement().area();
        prop_assert!((domain.placement().area() - area).abs() < 1e-12 * area);
        let runs = domain.straight_runs();
        for side in 0..domain.rings().side_count() {
            let first = domain.rings().corner(side);
            let on_side = first..first + domain.rings().intervals(side);
            prop_assert!(on_side.clone().all(|v| runs[v as usize] == runs[first as usize]));
        }
    }

    #[test]
    fn a_repeated_point_is_refused(rings in rings(), from in any::<prop::sample::Index>(), to in any::<prop::sample::Index>()) {
        let all: Vec<DVec2> = rings.concat();
        let (from, to) = (from.index(all.len()), to.index(all.len()));
        prop_assume!(from != to);
        let mut damaged = rings;
        let mut left = to;
        for ring in &mut damaged {
            if left < ring.len() {
                ring[left] = all[from];
                break;
            }
            left -= ring.len();
        }
        // The moved point makes edges cross or fold too; its repetition is reported before crossings.
        let error = refusal(damaged);
        prop_assert!(says(&error, &["passes each point once", "folds back"]), "{}", error);
    }

    #[test]
    fn a_hole_across_the_outline_is_refused(rings in rings(), radii in prop::collection::vec(1.0..1.4_f64, 3..9), at in any::<prop::sample::Index>()) {
        let on_outline = rings[0][at.index(rings[0].len())];
        let mut damaged = rings;
        damaged.push(star(on_outline, &radii));
        let error = refusal(damaged);
        prop_assert!(says(&error, &[" cross near "]), "{}", error);
    }

    #[test]
    fn holes_must_nest(rings in rings(), radii in prop::collection::vec(0.01..0.05_f64, 3..9)) {
        let mut outside = rings.clone();
        outside.push(star(DVec2::new(40.0, 0.0), &radii));
        let hole = outside.len() - 1;
        let error = refusal(outside);
        let words = format!("hole {hole} lies outside the outline");
        prop_assert!(says(&error, &[&words]), "{}", error);

        let mut around = rings.clone();
        around.push(star(DVec2::ZERO, &[40.0; 7]));
        let error = refusal(around);
        let words = format!("the outline lies inside hole {hole};");
        prop_assert!(says(&error, &[&words]), "{}", error);

        if rings.len() > 1 {
            let mut nested = rings.clone();
            // The center of a star is inside it.
            let center = star_center(&rings[1]);
            nested.push(star(center, &radii));
            let error = refusal(nested);
            let words = format!("hole {hole} lies inside hole 1,");
            prop_assert!(says(&error, &[&words]), "{}", error);
        }
    }

    #[test]
    fn two_points_in_the_wrong_order_are_refused(
        count in 5..60_usize, at in any::<prop::sample::Index>(),
    ) {
        let mut ring = star(DVec2::ZERO, &vec![12.0; count]);
        let at = at.index(count);
        ring.swap(at, (at + 1) % count);
        let error = refusal(vec![ring]);
        prop_assert!(says(&error, &[" cross near "]), "{}", error);
    }

    #[test]
    fn a_point_on_an_edge_is_refused(rings in rings(), at in any::<prop::sample::Index>()) {
        let mut damaged = rings;
        let count = damaged[0].len();
        let at = at.index(count);
        // Half way, on a grid where this is exact.
        for point in damaged.iter_mut().flatten() {
            *point = (*point * 1024.0).round();
        }
        let middle = damaged[0][at].midpoint(damaged[0][(at + 1) % count]);
        let inside = middle * 0.9;
        damaged.truncate(1);
        damaged.push(vec![middle, inside + DVec2::new(5.0, 0.0), inside - DVec2::new(5.0, 0.0)]);
        let error = refusal(damaged);
        prop_assert!(says(&error, &["may not lie on an edge", " cross near ", "folds back"]), "{}", error);
    }
}

/// The center of the grid cell that contains a hole.
fn star_center(ring: &[DVec2]) -> DVec2 {
    let near = |x: f64| ((x / 3.0 + 1.5).round() - 1.5) * 3.0;
    DVec2::new(near(ring[0].x), near(ring[0].y))
}

/// A convex polygon with given points on its straight sides still uses the formulas.
#[test]
fn own_points_on_straight_sides_keep_the_convex_form() {
    let sides = vec![
        Side::points([[1.0, 0.0], [1.5, 1e-10]].map(DVec2::from).to_vec()),
        Side::count(2),
        Side::points(vec![DVec2::new(2.0, 2.5)]),
        Side::count(1),
    ];
    let corners = [[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [0.0, 2.0]];
    let domain = Domain::polygon(corners, sides).unwrap();
    let form = domain.convex().unwrap();
    // The third side is a corner of its own.
    assert!(form.boundary().sides().eq([3, 2, 1, 1, 1]));
    assert_eq!(domain.straight_runs(), [0, 0, 0, 1, 1, 2, 3, 4]);
}

/// Beside a corner with an angle of a thousandth, points are a hundred apart in a million.
#[test]
fn a_large_slender_triangle_is_taken() {
    let corners = [[0.0, 0.0], [1e6, 0.0], [1e6, 1e3]].map(DVec2::from).to_vec();
    let domain = Domain::polygon(corners, vec![Side::count(10); 3]).unwrap();
    assert!(domain.convex().is_some());
}

#[test]
fn a_domain_may_have_as_many_vertices_as_are_allowed() {
    let build = |most| {
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(DVec2::from).to_vec();
        let outline = mindeg_domain::Outline::Polygon(corners);
        let sides = vec![Side::count(4); 3];
        Domain::builder(outline, sides).max_vertices(most).build()
    };
    assert!(build(12).is_ok());
    assert!(build(11).is_err());
}

#[test]
fn a_circle_is_convex_and_each_of_its_edges_a_side() {
    let center = DVec2::new(3.0, 4.0);
    let circle = Curve::Arc(mindeg_domain::Arc::Center { center, is_clockwise: true });
    let ring = Ring::new([[8.0, 4.0]], vec![Side::count(1000).along(circle)]);
    let domain = Domain::of_rings(vec![ring]).unwrap();
    assert!(domain.was_reversed());
    assert!(domain.convex().unwrap().boundary().sides().eq([1; 1000]));
    let area = domain.placement().area();
    let expected = 1000.0 * 25.0 * libm::sin(std::f64::consts::TAU / 1000.0) / 2.0;
    assert!((area / expected - 1.0).abs() < 1e-12);
    assert!(
        (domain.placement().side_length(0) / (10.0 * std::f64::consts::PI) - 1.0).abs() < 1e-15
    );
}
