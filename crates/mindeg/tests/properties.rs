//! Properties of every domain, whatever its outline and its spacing laws.

use std::f64::consts::TAU;

use glam::DVec2;
use mindeg::quality::{QualitySummary, TriangleQuality};
use mindeg::{BoundaryMesh, Domain, Intervals, Outline, Side, Spacing};
use mindeg_core::{Candidates, verify};
use proptest::num::f64::ANY;
use proptest::prelude::*;

/// Convex polygons of 3 to 9 sides, anywhere from next to the origin to survey coordinates:
/// corners on an ellipse, in order. No side is so short, no corner so blunt, that a spacing law
/// from below would be refused on it.
fn corners() -> impl Strategy<Value = Vec<DVec2>> {
    let gaps = proptest::collection::vec(0.2..1.0_f64, 3..10);
    let origin = (-1e5..1e5_f64, -1e5..1e5_f64, any::<bool>());
    (gaps, 0.2..1.0_f64, 0.0..TAU, origin).prop_map(|(gaps, height, rotation, (x, y, is_far))| {
        let total: f64 = gaps.iter().sum();
        let origin = if is_far { DVec2::new(x, y) } else { DVec2::ZERO };
        let mut angle = 0.0;
        gaps.iter()
            .map(|gap| {
                angle += gap / total * TAU;
                let on_ellipse = DVec2::from_angle(angle) * DVec2::new(1.0, height);
                origin + DVec2::from_angle(rotation).rotate(on_ellipse)
            })
            .collect()
    })
}

fn spacing() -> impl Strategy<Value = Spacing> {
    prop_oneof![
        Just(Spacing::Uniform),
        (0.8..1.25_f64).prop_map(|ratio| Spacing::Geometric { ratio }),
        (0.05..20.0_f64).prop_map(|ratio| Spacing::Bump { ratio }),
        (1.01..3.0_f64).prop_map(|beta| Spacing::Beta { beta }),
        (1.01..3.0_f64).prop_map(|beta| Spacing::Beta { beta: -beta }),
        (1e-3..1e-2_f64).prop_map(Spacing::FirstLength),
        proptest::collection::btree_set(1..200_u32, 1..20).prop_map(|points| {
            Spacing::Parameters(points.into_iter().map(|t| f64::from(t) / 200.0).collect())
        }),
    ]
}

fn side() -> impl Strategy<Value = Side> {
    (1..25_u64, spacing()).prop_map(|(intervals, spacing)| match spacing {
        Spacing::Parameters(given) => Side::parameters(given),
        // A single interval has no first one that is shorter.
        Spacing::FirstLength(_) => Side::count(intervals + 1).spaced(spacing),
        _ => Side::count(intervals).spaced(spacing),
    })
}

fn outline_and_sides() -> impl Strategy<Value = (Vec<DVec2>, Vec<Side>)> {
    corners().prop_flat_map(|corners| {
        let sides = proptest::collection::vec(side(), corners.len());
        (Just(corners), sides)
    })
}

/// The minimum angle of a list of triangles, in degrees.
fn minimum_angle(mesh: &BoundaryMesh, triangles: impl Iterator<Item = [u32; 3]>) -> f64 {
    triangles
        .map(|triangle| {
            let [a, b, c] = triangle.map(|vertex| mesh.point(vertex));
            TriangleQuality::of(a, b, c).min_angle
        })
        .fold(180.0, f64::min)
}

proptest! {
    #[test]
    fn points_are_in_order_between_exact_corners((corners, sides) in outline_and_sides()) {
        let domain = Domain::polygon(corners.clone(), sides).unwrap();
        let (boundary, placement) = (domain.convex().unwrap().boundary(), domain.placement());
        let points: Vec<DVec2> = placement.points().collect();
        prop_assert_eq!(points.len() as u32, boundary.vertex_count());
        for (side, &start) in corners.iter().enumerate() {
            let end = corners[(side + 1) % corners.len()];
            let first = boundary.corner(side) as usize;
            prop_assert_eq!(points[first], start);
            let mut before = 0.0;
            for i in 1..boundary.intervals(side) as usize {
                prop_assert_eq!(points[first + i], placement.point((first + i) as u32));
                let along = (points[first + i] - start).dot((end - start).normalize());
                prop_assert!(along > before);
                before = along;
            }
            prop_assert!(before < start.distance(end));
        }
    }

    #[test]
    fn meshes_cover_the_domain((corners, sides) in outline_and_sides()) {
        let domain = Domain::polygon(corners, sides).unwrap();
        let mesh = BoundaryMesh::least_degree(&domain).unwrap();
        let intervals: Vec<u64> = domain.rings().sides().map(u64::from).collect();
        let verified = verify(&intervals, mesh.triangles());
        prop_assert_eq!(verified.map(|verified| verified.max_degree), Ok(mesh.max_degree()));

        prop_assert!(mesh.qualities().all(|quality| quality.area > 0.0));
        let summary = QualitySummary::of(mesh.qualities()).unwrap();
        let area = domain.placement().area();
        prop_assert!((summary.area - area).abs() < 1e-9 * area, "{} of {}", summary.area, area);
        let angles = mesh.angle_range();
        for (angle, expected) in [
            (angles.min, summary.metric("min_angle").unwrap().min),
            (angles.max, summary.metric("max_angle").unwrap().max),
        ] {
            prop_assert!((angle - expected).abs() < 1e-9 * expected, "{} of {}", angle, expected);
        }
    }

    #[test]
    fn no_other_candidate_has_a_larger_minimum_angle((corners, sides) in outline_and_sides()) {
        let domain = Domain::polygon(corners, sides).unwrap();
        let mesh = BoundaryMesh::least_degree(&domain).unwrap();
        let chosen = minimum_angle(&mesh, mesh.triangles());
        let candidates = Candidates::new(domain.convex().unwrap().boundary());
        for candidate in candidates.sample(64) {
            prop_assert!(chosen >= minimum_angle(&mesh, candidate.triangles()) * (1.0 - 2e-9));
        }
        prop_assert!(candidates.sample(64).any(|other| other.triangles().eq(mesh.triangles())));
    }

    #[test]
    fn listing_a_domain_clockwise_changes_nothing((corners, sides) in outline_and_sides()) {
        let forth = Domain::polygon(corners.clone(), sides.clone()).unwrap();
        let mut clockwise = corners;
        clockwise[1..].reverse();
        let turned = |side: &Side| side.clone().spaced(side.spacing.reversed());
        let back = Domain::polygon(clockwise, sides.iter().rev().map(turned).collect()).unwrap();
        prop_assert!(back.was_reversed() && !forth.was_reversed());
        prop_assert_eq!(forth.rings(), back.rings());
        for (there, here) in forth.placement().points().zip(back.placement().points()) {
            prop_assert!(there.distance(here) < 1e-9);
        }
    }

    /// Numbers of any size at all: an error or a mesh, never a panic or a NaN.
    #[test]
    fn any_numbers_give_an_error_or_a_mesh(
        corners in proptest::collection::vec((ANY, ANY), 3..5),
        scale in ANY,
        value in prop_oneof![ANY, -3.0..3.0_f64],
        law in 0..6,
        intervals in prop_oneof![
            (0..9_u64).prop_map(Intervals::Count),
            ANY.prop_map(Intervals::Size),
        ],
    ) {
        let spacing = match law {
            0 => Spacing::Geometric { ratio: value },
            1 => Spacing::Bump { ratio: value },
            2 => Spacing::Beta { beta: value },
            3 => Spacing::FirstLength(value),
            4 => Spacing::LastLength(value),
            _ => Spacing::Uniform,
        };
        let side = Side { intervals, ..Side::count(1) }.spaced(spacing);
        let count = corners.len();
        let any: Vec<DVec2> = corners.into_iter().map(DVec2::from).collect();
        let [x, y] = [DVec2::X, DVec2::Y].map(|axis| axis * scale);
        for corners in [any, vec![DVec2::ZERO, x, x + y, y][..count].to_vec()] {
            let sides = vec![side.clone(); count];
            let Ok(domain) = Domain::new(Outline::Polygon(corners), sides) else { continue };
            if domain.rings().vertex_count() > 10_000 {
                continue;
            }
            let Ok(mesh) = BoundaryMesh::least_degree(&domain) else { continue };
            let angles = mesh.angle_range();
            prop_assert!(angles.min > 0.0 && angles.max < 180.0);
            prop_assert!(mesh.points().all(DVec2::is_finite));
        }
    }
}
