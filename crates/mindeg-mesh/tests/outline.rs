//! Outlines from rounded coordinates: the right outline or none.

use glam::{DQuat, DVec2, DVec3};
use mindeg_mesh::TriMesh;
use mindeg_mesh::inspection::{FoundOutline, Inspection, InspectionOptions, NoConvexOutline};
use proptest::prelude::*;
use std::f64::consts::TAU;

fn outline(points: &[DVec3], rounding: f64, angle: f64) -> Result<FoundOutline, NoConvexOutline> {
    let fan = (1..points.len() as u32 - 1).map(|i| [0, i, i + 1]).collect();
    let mesh = TriMesh::new(points.to_vec(), fan).unwrap().with_rounding(rounding);
    let options = InspectionOptions { corner_angle: angle, ..InspectionOptions::default() };
    Inspection::of(&mesh, &options).outline
}

/// The points of a polygon, from the parameters of the points on each side.
fn points(corners: &[DVec2], sides: &[Vec<f64>]) -> Vec<DVec3> {
    let side = |i: usize| {
        let [start, end] = [corners[i], corners[(i + 1) % corners.len()]];
        let parameters = [0.0].into_iter().chain(sides[i].iter().copied());
        parameters.map(move |t| (start + (end - start) * t).extend(0.0))
    };
    (0..corners.len()).flat_map(side).collect()
}

fn even(intervals: u32) -> Vec<f64> {
    (1..intervals).map(|i| f64::from(i) / f64::from(intervals)).collect()
}

/// The points as 32-bit floats, with the largest error of that rounding.
fn rounded(points: &[DVec3]) -> (Vec<DVec3>, f64) {
    let largest = points.iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
    let points = points.iter().map(|p| p.as_vec3().as_dvec3()).collect();
    (points, largest * libm::ldexp(1.0, -24))
}

#[test]
fn thin_rectangles_are_recognized_or_too_thin_to_tell() {
    for exponent in 0..40 {
        let height = 10.0_f64.powi(-exponent);
        for origin in [DVec2::ZERO, DVec2::new(-3.7, 12.0)] {
            let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, height], [0.0, height]];
            let corners = corners.map(|corner| DVec2::from(corner) + origin);
            let points = points(&corners, &[even(4), even(2), even(4), even(3)]);
            let found = outline(&points, 0.0, 1.0);
            let limit = if origin == DVec2::ZERO { 11 } else { 10 };
            match found {
                Ok(found) => assert_eq!(found.intervals, [4, 2, 4, 3], "{exponent}"),
                Err(NoConvexOutline::TooThin | NoConvexOutline::TooFine) => {
                    assert!(exponent > limit, "{exponent}: {found:?}");
                }
                // Rounding has merged vertices.
                Err(NoConvexOutline::NotADisk) => assert!(exponent > 15),
                other => panic!("{exponent}: {other:?}"),
            }
        }
    }
}

#[test]
fn corners_that_rounding_may_have_moved_are_too_fine_to_tell() {
    // A triangle of 3, 8 and 3 intervals whose side of 8 starts with an interval of 1e-5: 32-bit
    // floats gave 4, 7 and 3.
    let corners = [
        [-200.06209578396403, 149.03416137923696],
        [-297.8174489286897, -24.081040154789186],
        [264.19810801890065, -94.74963434519486],
    ];
    let corners = corners.map(DVec2::from);
    let mut side: Vec<f64> = even(8);
    side[0] = 1e-5 / (corners[2] - corners[1]).length();
    let points = points(&corners, &[even(3), side, even(3)]);
    assert_eq!(outline(&points, 0.0, 1.0).unwrap().intervals, [3, 8, 3]);
    let (single, rounding) = rounded(&points);
    assert_eq!(outline(&single, rounding, 1.0), Err(NoConvexOutline::TooFine));
}

#[test]
fn a_larger_angle_of_corners_allows_shorter_intervals() {
    let corners = [[0.0, 0.0], [1.0, 0.1], [0.9, 1.0], [0.1, 0.8]].map(DVec2::from);
    let mut side = even(5);
    side[0] = 2e-6;
    let points = points(&corners, &[side, even(2), even(3), even(1)]);
    let (single, rounding) = rounded(&points);
    assert_eq!(outline(&single, rounding, 1.0), Err(NoConvexOutline::TooFine));
    assert_eq!(outline(&single, rounding, 20.0).unwrap().intervals, [5, 2, 3, 1]);
}

#[test]
fn the_largest_coordinates_have_an_outline() {
    let at = |x: f64, y: f64| DVec3::new(x, y, 0.0);
    let triangle = [at(1e308, 0.0), at(0.0, 1e308), at(-1e308, 0.0)];
    assert_eq!(outline(&triangle, 0.0, 1.0).unwrap().intervals, [1, 1, 1]);
}

/// A convex polygon on an ellipse, and the parameters of its points: some sides start with a very
/// short interval, some polygons are thin, some have very short sides.
fn polygons() -> impl Strategy<Value = (Vec<DVec2>, Vec<Vec<f64>>)> {
    let first = prop_oneof![2 => Just(None), 3 => (-9.0..-1.0_f64).prop_map(Some)];
    let gap = prop_oneof![3 => 0.2..1.0_f64, 1 => (-8.0..-0.5_f64).prop_map(|e| 10.0_f64.powf(e))];
    let side = (gap, 1_u32..9, first, any::<bool>());
    (prop::collection::vec(side, 3..8), (-8.0..0.5_f64), 0.0..TAU, any::<bool>()).prop_map(
        |(sides, thickness, turn, is_thin)| {
            let all: f64 = sides.iter().map(|side| side.0).sum();
            let thickness = if is_thin { 10.0_f64.powf(thickness) } else { 1.0 };
            let turn = DVec2::from_angle(turn);
            let mut angle = 0.0;
            let mut corners = Vec::new();
            for side in &sides {
                let on_ellipse = DVec2::new(libm::cos(angle), thickness * libm::sin(angle));
                corners.push(turn.rotate(on_ellipse));
                angle += TAU * side.0 / all;
            }
            let parameters = sides.iter().map(|&(_, intervals, first, from_end)| {
                let mut parameters = even(intervals);
                if let (Some(exponent), Some(start)) = (first, parameters.first_mut()) {
                    *start = 10.0_f64.powf(exponent).min(*start);
                }
                if from_end {
                    parameters.iter_mut().for_each(|t| *t = 1.0 - *t);
                    parameters.reverse();
                }
                parameters
            });
            (corners, parameters.collect())
        },
    )
}

/// The turns at the corners of a polygon, in floats that are accurate enough.
fn turns(corners: &[DVec2]) -> Vec<f64> {
    let count = corners.len();
    let turn = |i: usize| {
        let [a, b, c] = [i + count - 1, i, i + 1].map(|i| corners[i % count]);
        libm::atan2((b - a).perp_dot(c - b), (b - a).dot(c - b)).to_degrees()
    };
    (0..count).map(turn).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { max_global_rejects: 100_000, ..ProptestConfig::with_cases(2000) })]

    #[test]
    fn intervals_are_right_or_not_told(
        (corners, sides) in polygons(),
        origin in prop::array::uniform2(prop_oneof![Just(0.0), -5.0..5.0_f64]),
        turn in prop::array::uniform4(-1.0..1.0_f64),
        in_space in any::<bool>(),
        angle in prop_oneof![3 => Just(1.0), 1 => 0.0..5.0_f64],
    ) {
        // A polygon with corners below the angle is another polygon by definition.
        prop_assume!(turns(&corners).iter().all(|&turn| turn > angle.max(1e-3) + 1e-6));
        prop_assume!(!in_space || DQuat::from_array(turn).length() > 0.1);
        let turn = if in_space { DQuat::from_array(turn).normalize() } else { DQuat::IDENTITY };
        let origin = DVec2::from(origin).extend(0.0);
        let points = points(&corners, &sides);
        let placed: Vec<DVec3> = points.iter().map(|&p| turn * (p + origin)).collect();
        let (single, rounding) = rounded(&placed);
        let expected: Vec<u32> = sides.iter().map(|side| side.len() as u32 + 1).collect();
        for (points, rounding) in [(&placed, 0.0), (&single, rounding)] {
            // Rounding can put a vertex on another: then it is another mesh.
            let mut sorted: Vec<_> = points.iter().map(|p| p.to_array().map(f64::to_bits)).collect();
            sorted.sort_unstable();
            sorted.dedup();
            if sorted.len() < points.len() {
                continue;
            }
            match outline(points, rounding, angle) {
                Ok(found) => prop_assert_eq!(&found.intervals, &expected),
                Err(NoConvexOutline::TooThin | NoConvexOutline::TooFine) => {}
                Err(other) => prop_assert!(false, "{other:?}"),
            }
        }
    }

    #[test]
    fn ordinary_polygons_are_recognized(
        sides in prop::collection::vec((0.3..1.0_f64, 1_u32..20), 3..9),
        exponent in -30..30_i32,
    ) {
        let all: f64 = sides.iter().map(|side| side.0).sum();
        let ends = sides.iter().scan(0.0, |angle, side| {
            *angle += TAU * side.0 / all;
            Some(*angle)
        });
        let corners: Vec<DVec2> =
            ends.map(|a| DVec2::new(libm::cos(a), libm::sin(a)) * libm::ldexp(1.0, exponent)).collect();
        let expected: Vec<u32> = sides.iter().map(|side| side.1).collect();
        let parameters: Vec<Vec<f64>> = expected.iter().map(|&n| even(n)).collect();
        let (single, rounding) = rounded(&points(&corners, &parameters));
        let angle = turns(&corners).into_iter().fold(1.0, f64::min) * 0.9;
        prop_assert_eq!(outline(&single, rounding, angle).unwrap().intervals, expected);
    }
}
