//! Narrow water and land.

use crate::ANY;
use glam::DVec2;
use mindeg_condition::{
    BoundaryDemands, ChangeKind, Conditioned, Hold, NarrowReason, condition, condition_map,
};
use mindeg_mesh::Random;
use mindeg_mesh::planar::PlanarBoundary;
use proptest::prelude::*;

const WIDE: BoundaryDemands = BoundaryDemands {
    angle: 25.0,
    within: 0.0,
    size: None,
    growth: 0.0,
    least_hole: 0.0,
    least_triangles: 1,
    narrowest: 1.0,
};

fn ring(points: &[[f64; 2]]) -> Vec<DVec2> {
    points.iter().copied().map(DVec2::from).collect()
}

fn widened(rings: &[Vec<DVec2>]) -> Conditioned {
    condition(&PlanarBoundary::new(rings).unwrap(), &WIDE, |_| Hold::Free).unwrap()
}

fn count(found: &Conditioned, kind: ChangeKind) -> usize {
    found.changes.iter().filter(|change| change.kind == kind).count()
}

/// Inlets, straits, basins and spits.
fn counts(found: &Conditioned) -> [usize; 4] {
    [
        ChangeKind::InletClosed,
        ChangeKind::StraitClosed,
        ChangeKind::BasinDropped,
        ChangeKind::SpitCut,
    ]
    .map(|kind| count(found, kind))
}

fn area(ring: &[mindeg_condition::Point]) -> f64 {
    let at = |i: usize| ring[i % ring.len()].at;
    (0..ring.len()).map(|i| at(i).perp_dot(at(i + 1))).sum::<f64>() / 2.0
}

/// A square of 10 with an arm of a width and a length at its right side.
fn with_arm(width: f64, length: f64) -> Vec<DVec2> {
    let (low, high) = (5.0 - width / 2.0, 5.0 + width / 2.0);
    ring(&[
        [0.0, 0.0],
        [10.0, 0.0],
        [10.0, low],
        [10.0 + length, low],
        [10.0 + length, high],
        [10.0, high],
        [10.0, 10.0],
        [0.0, 10.0],
    ])
}

#[test]
fn a_narrow_inlet_is_closed_and_a_wide_or_shallow_one_stays() {
    let found = widened(&[with_arm(0.5, 3.0)]);
    assert_eq!((counts(&found), found.narrow.len()), ([1, 0, 0, 0], 0));
    assert!((area(&found.rings[0]) - 100.0).abs() < 1e-9, "{}", area(&found.rings[0]));
    let place = found.changes[0].at;
    assert!((10.0..=13.0).contains(&place.x) && (place.y - 5.0).abs() < 0.3, "{place}");
    // The points that stay are the old ones, bit for bit.
    let of: Vec<u32> = found.rings[0].iter().filter_map(|point| point.of).collect();
    assert!([0, 1, 2, 5, 6, 7].iter().all(|of_old| of.contains(of_old)), "{of:?}");
    for [width, length] in [[1.5, 3.0], [0.5, 0.4]] {
        let found = widened(&[with_arm(width, length)]);
        assert_eq!((counts(&found), found.narrow.len()), ([0; 4], 0), "{width} {length}");
    }
}

#[test]
fn an_inlet_that_gets_narrower_is_closed_where_it_is_as_narrow() {
    let wedge =
        [[0.0, 0.0], [10.0, 0.0], [10.0, 4.0], [30.0, 5.0], [10.0, 6.0], [10.0, 10.0], [0.0, 10.0]];
    let found = widened(&[ring(&wedge)]);
    assert_eq!(counts(&found), [1, 0, 0, 0]);
    // Its width is 1 at x = 20.
    let most = found.rings[0].iter().map(|point| point.at.x).fold(0.0, f64::max);
    assert!((18.0..=22.0).contains(&most), "{most}");
    // The new points are on the old shores.
    let new = found.rings[0].iter().filter(|point| point.of.is_none());
    assert!(new.clone().count() > 0);
    for point in new {
        let from_axis = (30.0 - point.at.x) / 20.0;
        let is_on_shore = ((point.at.y - 5.0).abs() - from_axis).abs() < 1e-9;
        assert!(is_on_shore || point.at.x == 10.0, "{}", point.at);
    }
}

#[test]
fn a_spit_of_land_is_cut_off_and_a_cape_stays() {
    // Land from the right side to the middle.
    let spit = |width: f64, length: f64| {
        let (low, high) = (5.0 - width / 2.0, 5.0 + width / 2.0);
        ring(&[
            [0.0, 0.0],
            [10.0, 0.0],
            [10.0, low],
            [10.0 - length, low],
            [10.0 - length, high],
            [10.0, high],
            [10.0, 10.0],
            [0.0, 10.0],
        ])
    };
    let found = widened(&[spit(0.5, 4.0)]);
    assert_eq!((counts(&found), found.narrow.len()), ([0, 0, 0, 1], 0));
    assert!((area(&found.rings[0]) - 100.0).abs() < 1e-9);
    for [width, length] in [[0.5, 0.4], [2.0, 4.0]] {
        assert_eq!(counts(&widened(&[spit(width, length)])), [0; 4], "{width} {length}");
    }
}

/// A square of 10 with a square island of 2 at a distance from its right side.
fn with_island(distance: f64) -> [Vec<DVec2>; 2] {
    let [left, right] = [8.0 - distance, 10.0 - distance];
    let island = ring(&[[left, 4.0], [left, 6.0], [right, 6.0], [right, 4.0]]);
    [ring(&[[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]]), island]
}

#[test]
fn an_island_behind_a_narrow_strait_joins_the_mainland() {
    let found = widened(&with_island(0.5));
    assert_eq!((counts(&found), found.rings.len()), ([0, 1, 0, 0], 1));
    let left = area(&found.rings[0]);
    assert!((94.0..=95.1).contains(&left), "{left}");
    let found = widened(&with_island(1.5));
    assert_eq!((counts(&found), found.rings.len()), ([0; 4], 2));
}

/// Two squares, of 10 and of 6, with a strait between them.
fn basins(width: f64) -> Vec<DVec2> {
    let (low, high) = (5.0 - width / 2.0, 5.0 + width / 2.0);
    ring(&[
        [0.0, 0.0],
        [10.0, 0.0],
        [10.0, low],
        [13.0, low],
        [13.0, 2.0],
        [19.0, 2.0],
        [19.0, 8.0],
        [13.0, 8.0],
        [13.0, high],
        [10.0, high],
        [10.0, 10.0],
        [0.0, 10.0],
    ])
}

#[test]
fn what_a_closed_strait_cuts_off_is_dropped_and_told() {
    let found = widened(&[basins(0.5)]);
    assert_eq!(counts(&found), [0, 1, 1, 0]);
    assert!((area(&found.rings[0]) - 100.0).abs() < 1e-9);
    let basin = found.changes.iter().find(|change| change.kind == ChangeKind::BasinDropped);
    assert!(basin.unwrap().at.x > 13.0);
    assert_eq!(counts(&widened(&[basins(1.2)])), [0; 4]);
}

#[test]
fn what_is_to_stay_keeps_its_strait() {
    let boundary = PlanarBoundary::new(&[basins(0.5)]).unwrap();
    // Vertex 6 is in the basin; edge 3 to 4 is one of its shores; a mark is in it, or in the strait.
    for hold in [Hold::Corner, Hold::Point, Hold::Edge] {
        let held = |edge| if edge == 6 { hold } else { Hold::Free };
        let found = condition(&boundary, &WIDE, held).unwrap();
        assert_eq!(counts(&found), [0; 4], "{hold:?}");
        assert_eq!(found.narrow[0].reason, NarrowReason::Kept);
        assert!((found.narrow[0].width - 0.5).abs() < 1e-9, "{:?}", found.narrow);
    }
    for mark in [[16.0, 5.3], [11.5, 5.1]] {
        let domain = |_| [true, false];
        let free = |_| Hold::Free;
        let found =
            condition_map(&boundary, &WIDE, free, domain, |_| false, &ANY, &[mark.into()]).unwrap();
        assert_eq!((counts(&found), found.narrow.len()), ([0; 4], 1), "{mark:?}");
    }
}

#[test]
fn land_between_two_waters_and_islands_that_are_nowhere_wide_stay_and_are_told() {
    // An island of two squares with a neck between them, and a thin one.
    let neck = [
        [4.0, 4.0],
        [4.0, 7.0],
        [7.0, 7.0],
        [7.0, 5.7],
        [9.0, 5.7],
        [9.0, 7.0],
        [12.0, 7.0],
        [12.0, 4.0],
        [9.0, 4.0],
        [9.0, 5.3],
        [7.0, 5.3],
        [7.0, 4.0],
    ];
    let thin = [[4.0, 14.0], [4.0, 14.2], [9.0, 14.2], [9.0, 14.0]];
    let outer = ring(&[[0.0, 0.0], [20.0, 0.0], [20.0, 20.0], [0.0, 20.0]]);
    let found = widened(&[outer, ring(&neck), ring(&thin)]);
    assert_eq!((counts(&found), found.rings.len()), ([0; 4], 3));
    let reasons: Vec<_> = found.narrow.iter().map(|narrow| narrow.reason).collect();
    assert!(reasons.contains(&NarrowReason::Between), "{reasons:?}");
    assert!(reasons.contains(&NarrowReason::Everywhere), "{reasons:?}");
    assert_eq!(reasons.len(), 2);
}

/// A border between two regions, which begins and ends on the coast, and an inlet of the upper one.
#[test]
fn an_inlet_of_one_region_of_a_map_is_closed_and_the_border_stays() {
    let outer = with_arm(0.5, 3.0);
    let (boundary, turned) =
        PlanarBoundary::map(&[outer], &[DVec2::new(5.0, 2.0)], &[vec![0, 8, 1]]).unwrap();
    assert!(turned.is_empty());
    let domain = |edge| [true, edge >= 8];
    let found =
        condition_map(&boundary, &WIDE, |_| Hold::Free, domain, |_| false, &ANY, &[]).unwrap();
    assert_eq!(counts(&found), [1, 0, 0, 0]);
    let line: Vec<_> = found.lines[0].iter().map(|point| (point.of, point.at)).collect();
    assert!(line.contains(&(Some(8), DVec2::new(5.0, 2.0))), "{line:?}");
    assert_eq!((line[0].0, line.last().unwrap().0), (Some(0), Some(1)));
    assert!(found.lines[0].iter().all(|point| point.edge >= 8));
    // The border in the mouth keeps the inlet.
    let through = [[1.0, 5.0], [12.0, 5.0]].map(DVec2::from);
    let (boundary, _) =
        PlanarBoundary::map(&[with_arm(0.5, 3.0)], &through, &[vec![8, 9]]).unwrap();
    let found =
        condition_map(&boundary, &WIDE, |_| Hold::Free, domain, |_| false, &ANY, &[]).unwrap();
    assert_eq!(counts(&found), [0; 4]);
    assert!(found.narrow.iter().all(|narrow| narrow.reason == NarrowReason::Kept));
}

/// A rough coast with rocks.
fn coast(points: u32, seed: u64) -> Vec<Vec<DVec2>> {
    let mut random = Random::new(seed);
    let mut around = |center: DVec2, radius: f64, points: u32| -> Vec<DVec2> {
        let at = |i: u32| {
            let angle =
                (f64::from(i) + 0.8 * random.unit()) / f64::from(points) * std::f64::consts::TAU;
            center + radius * (1.0 + 0.9 * (random.unit() - 0.5)) * DVec2::from_angle(angle)
        };
        (0..points).map(at).collect()
    };
    let mut rings = vec![around(DVec2::ZERO, 15.0, points)];
    for center in [[3.0, 1.0], [-3.5, 1.5], [0.0, -4.0]] {
        let mut rock = around(center.into(), 1.7, points / 6 + 3);
        rock.reverse();
        rings.push(rock);
    }
    rings
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    /// The exact sweep passes, points that stay are the old ones, held ones are all there, and a second run changes nothing.
    #[test]
    fn rough_coasts_stay_sound(points in 8_u32..90, seed in any::<u64>(), width in 0.3..3.0) {
        let rings = coast(points, seed);
        let Ok(boundary) = PlanarBoundary::new(&rings) else { return Ok(()) };
        // With a large angle, most time goes to thin places that this is not about.
        let demands = BoundaryDemands { angle: 10.0, narrowest: width, ..WIDE };
        let hold = |edge: u32| if edge.is_multiple_of(7) { Hold::Point } else { Hold::Free };
        let found = condition(&boundary, &demands, hold).unwrap();
        let of: Vec<u32> = found.rings.iter().flatten().filter_map(|point| point.of).collect();
        for point in found.rings.iter().flatten() {
            if let Some(of) = point.of {
                prop_assert_eq!(point.at, boundary.point(of));
            }
        }
        let dropped = |vertex: &u32| vertex.is_multiple_of(7) && !of.contains(vertex);
        prop_assert_eq!((0..boundary.vertex_count()).filter(dropped).count(), 0);
        let new: Vec<Vec<DVec2>> =
            found.rings.iter().map(|ring| ring.iter().map(|point| point.at).collect()).collect();
        let again = PlanarBoundary::new(&new).unwrap();
        let kept: Vec<bool> = found.rings.iter().flatten().map(|point| point.of.is_some_and(|of| of.is_multiple_of(7))).collect();
        let hold = |edge: u32| if kept[edge as usize] { Hold::Point } else { Hold::Free };
        let again = condition(&again, &demands, hold).unwrap();
        prop_assert_eq!(counts(&again), [0; 4], "{:?}", again.changes);
        if found.left.is_empty() {
            prop_assert_eq!(&again.changes[..], &[][..]);
        }
    }
}

/// A coast whose limit is lifted has other shores, which makes other places narrow.
#[test]
fn a_coast_of_a_size_without_narrow_places_stays_as_it_is() {
    let mut changed = 0;
    for seed in 0..10 {
        let Ok(boundary) = PlanarBoundary::new(&coast(80, seed)) else { continue };
        let demands = BoundaryDemands { narrowest: 1.2, ..BoundaryDemands::of_size(2.0) };
        let found = condition(&boundary, &demands, |_| Hold::Free).unwrap();
        if !found.left.is_empty() {
            continue;
        }
        assert!(found.moved <= demands.within, "{seed}: {}", found.moved);
        let places =
            |ring: &Vec<mindeg_condition::Point>| ring.iter().map(|point| point.at).collect();
        let new: Vec<Vec<DVec2>> = found.rings.iter().map(places).collect();
        let again = PlanarBoundary::new(&new).unwrap();
        let again = condition(&again, &demands, |_| Hold::Free).unwrap();
        assert_eq!((&again.changes[..], again.moved), (&[][..], 0.0), "{seed}");
        changed += 1;
    }
    assert!(changed > 3, "{changed}");
}

#[test]
fn a_creek_in_a_shallow_bay_is_closed_and_the_bay_stays() {
    let bay = [
        [0.0, 0.0],
        [10.0, 0.0],
        [10.0, 4.6],
        [10.2, 4.6],
        [10.2, 4.9],
        [12.0, 4.9],
        [12.0, 5.0],
        [10.2, 5.0],
        [10.2, 5.4],
        [10.0, 5.4],
        [10.0, 10.0],
        [0.0, 10.0],
    ];
    let found = widened(&[ring(&bay)]);
    assert_eq!(counts(&found), [1, 0, 0, 0]);
    let left = area(&found.rings[0]);
    assert!((100.1..100.2).contains(&left), "{left}");
}
