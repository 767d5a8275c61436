//! Boundaries before and after.

use crate::ANY;
use glam::DVec2;
use mindeg_condition::{
    BoundaryDemands, ChangeKind, Conditioned, Hold, Left, Reason, Why, condition, condition_map,
};
use mindeg_interior::limits::fan_limit;
use mindeg_interior::{Options, generate};
use mindeg_mesh::planar::{PlanarBoundary, orientation};
use mindeg_mesh::{Progress, Random};

fn ring(points: &[[f64; 2]]) -> Vec<DVec2> {
    points.iter().copied().map(DVec2::from).collect()
}

fn conditioned(rings: &[Vec<DVec2>], demands: &BoundaryDemands) -> Conditioned {
    condition(&PlanarBoundary::new(rings).unwrap(), demands, |_| Hold::Free).unwrap()
}

fn count(conditioned: &Conditioned, kind: ChangeKind) -> usize {
    conditioned.changes.iter().filter(|change| change.kind == kind).count()
}

/// The distance of a point from rings of points.
fn distance(point: DVec2, rings: &[Vec<DVec2>]) -> f64 {
    let edges = rings
        .iter()
        .flat_map(|ring| (0..ring.len()).map(move |i| [ring[i], ring[(i + 1) % ring.len()]]));
    let to = |[a, b]: [DVec2; 2]| {
        let share = (point - a).dot(b - a) / a.distance_squared(b);
        point.distance(a.lerp(b, share.clamp(0.0, 1.0)))
    };
    edges.map(to).fold(f64::INFINITY, f64::min)
}

/// The largest distance between two boundaries, by many points of the edges of both.
fn apart(old: &[Vec<DVec2>], new: &[Vec<DVec2>]) -> f64 {
    let samples = |rings: &[Vec<DVec2>]| -> Vec<DVec2> {
        let along = |ring: &Vec<DVec2>, i: usize| {
            let [a, b] = [ring[i], ring[(i + 1) % ring.len()]];
            (0..8).map(move |k| a.lerp(b, f64::from(k) / 8.0)).collect::<Vec<_>>()
        };
        rings.iter().flat_map(|ring| (0..ring.len()).flat_map(move |i| along(ring, i))).collect()
    };
    let one = |from: &[Vec<DVec2>], to: &[Vec<DVec2>]| {
        samples(from).into_iter().map(|point| distance(point, to)).fold(0.0, f64::max)
    };
    one(old, new).max(one(new, old))
}

/// Whether a place is one whose triangles together are too small, which its limits do not tell.
fn is_narrow(left: &Left) -> bool {
    left.reason == Reason::Narrow
}

fn places(conditioned: &Conditioned) -> Vec<Vec<DVec2>> {
    let ring = |ring: &Vec<mindeg_condition::Point>| ring.iter().map(|point| point.at).collect();
    conditioned.rings.iter().map(ring).collect()
}

/// A coast by chance: a ring whose radius changes from point to point, with a rock in it.
fn coast(points: u32, roughness: f64, seed: u64) -> Vec<Vec<DVec2>> {
    let mut random = Random::new(seed);
    let mut ring = |center: DVec2, radius: f64, points: u32| -> Vec<DVec2> {
        let at = |i: u32| {
            let angle =
                (f64::from(i) + 0.8 * random.unit()) / f64::from(points) * std::f64::consts::TAU;
            let length = radius * (1.0 + roughness * (random.unit() - 0.5));
            center + length * DVec2::from_angle(angle)
        };
        (0..points).map(at).collect()
    };
    let outer = ring(DVec2::ZERO, 100.0, points);
    let mut rock = ring(DVec2::new(10.0, 5.0), 20.0, points / 4 + 3);
    rock.reverse();
    vec![outer, rock]
}

#[test]
fn what_is_good_stays_bit_for_bit() {
    let square = ring(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]);
    let found = conditioned(
        std::slice::from_ref(&square),
        &BoundaryDemands { within: 1.0, ..BoundaryDemands::default() },
    );
    assert_eq!(places(&found), [square]);
    assert!(found.changes.is_empty() && found.left.is_empty() && found.moved == 0.0);
    let of: Vec<_> = found.rings[0].iter().map(|point| point.of).collect();
    assert_eq!(of, [Some(0), Some(1), Some(2), Some(3)]);
}

/// Sizes grow from the left of a square: its edges are no longer, and points go where longer edges are wanted.
#[test]
fn edges_have_the_sizes_of_their_places() {
    let square = ring(&[[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]]);
    let boundary = PlanarBoundary::new(std::slice::from_ref(&square)).unwrap();
    let size_at = |place: DVec2| 0.25 + 0.25 * place.x;
    let found = |boundary: &PlanarBoundary, demands| {
        let free = |_| Hold::Free;
        condition_map(boundary, demands, free, |_| [true, false], |_| false, &size_at, &[]).unwrap()
    };
    let demands = BoundaryDemands { growth: 0.0, ..BoundaryDemands::of_size(4.0) };
    let new = places(&found(&boundary, &demands));
    let edges = |ring: &[DVec2]| -> Vec<[DVec2; 2]> {
        (0..ring.len()).map(|i| [ring[i], ring[(i + 1) % ring.len()]]).collect()
    };
    for [a, b] in edges(&new[0]) {
        let size = size_at(a.midpoint(b));
        assert!(a.distance(b) <= 4.0 / 3.0 * size && a.distance(b) > size / 3.0, "{a} {b} {size}");
    }
    // Many points become as few as these sizes want.
    let fine: Vec<DVec2> = edges(&square)
        .into_iter()
        .flat_map(|[a, b]| (0..64).map(move |i| a.lerp(b, f64::from(i) / 64.0)))
        .collect();
    let fewer = places(&found(&PlanarBoundary::new(&[fine]).unwrap(), &demands));
    let ratio = fewer[0].len() as f64 / new[0].len() as f64;
    assert!((0.6..1.5).contains(&ratio), "{} {}", fewer[0].len(), new[0].len());
}

#[test]
fn a_strait_gets_shorter_edges_and_moves_nowhere() {
    let strait = ring(&[[0.0, 0.0], [10.0, 0.0], [10.0, 0.5], [0.0, 0.5]]);
    let found = conditioned(
        std::slice::from_ref(&strait),
        &BoundaryDemands { angle: 30.0, ..BoundaryDemands::default() },
    );
    assert!(found.before < 6.0 && found.after >= 30.0 && found.left.is_empty(), "{found:?}");
    assert!(count(&found, ChangeKind::Inserted) >= 8 && count(&found, ChangeKind::Dropped) == 0);
    assert!(apart(&[strait], &places(&found)) < 1e-12);
}

#[test]
fn a_tip_is_cut_as_far_as_is_allowed_and_named_if_that_is_not_at_all() {
    let wedge = ring(&[[0.0, 0.0], [10.0, -1.0], [10.0, 1.0]]);
    let found = conditioned(std::slice::from_ref(&wedge), &BoundaryDemands::default());
    assert_eq!(found.left.len(), 1);
    assert_eq!((found.left[0].at, found.left[0].reason), (DVec2::ZERO, Reason::Sharp));
    assert!((found.left[0].limit - 11.42).abs() < 0.01);
    let found = conditioned(
        std::slice::from_ref(&wedge),
        &BoundaryDemands { within: 0.5, ..BoundaryDemands::default() },
    );
    assert_eq!(count(&found, ChangeKind::Cut), 1);
    assert!(found.after >= 25.0 && found.left.iter().all(is_narrow), "{found:?}");
    assert!(
        found.moved <= 0.5
            && (apart(std::slice::from_ref(&wedge), &places(&found)) - 0.5).abs() < 0.01
    );
    // A corner is cut as others are, and not dropped.
    let boundary = PlanarBoundary::new(std::slice::from_ref(&wedge)).unwrap();
    let demands = BoundaryDemands { within: 0.5, ..BoundaryDemands::default() };
    let corner = condition(&boundary, &demands, |_| Hold::Corner).unwrap();
    assert_eq!((count(&corner, ChangeKind::Cut), count(&corner, ChangeKind::Dropped)), (1, 0));
    // A point that stays keeps its tip.
    let boundary = PlanarBoundary::new(&[wedge]).unwrap();
    let found =
        condition(&boundary, &BoundaryDemands { within: 0.5, ..BoundaryDemands::default() }, |v| {
            if v == 0 { Hold::Point } else { Hold::Free }
        })
        .unwrap();
    assert_eq!(found.left.iter().map(|left| left.reason).collect::<Vec<_>>(), [Reason::Kept]);
}

#[test]
fn a_corner_for_two_triangles_is_cut_below_twice_the_angle() {
    let rings = [wedge(40.0)];
    let usual = BoundaryDemands { within: 0.5, ..BoundaryDemands::default() };
    let found = conditioned(&rings, &usual);
    assert_eq!(count(&found, ChangeKind::Cut), 0);
    let demands = BoundaryDemands { least_triangles: 2, ..usual };
    let found = conditioned(&rings, &demands);
    assert_eq!(count(&found, ChangeKind::Cut), 1);
    assert!(found.before <= 20.0 + 1e-9 && found.after >= 25.0, "{found:?}");
    let kept = conditioned(&rings, &BoundaryDemands { within: 0.0, ..demands });
    assert!(kept.after <= 20.0 + 1e-9 && kept.left.len() == 1, "{kept:?}");
}

#[test]
fn a_corner_that_is_too_sharp_gets_edges_for_the_angle_that_it_has() {
    let corner = 16.0_f64;
    let far = 20.0 * DVec2::from_angle(corner.to_radians());
    let wedge = vec![DVec2::ZERO, DVec2::new(3.0, 0.0), DVec2::new(12.0, -9.0), far];
    let found = conditioned(std::slice::from_ref(&wedge), &BoundaryDemands::default());
    // Of three triangles, since one would have a long side and a short one.
    assert!((found.before - corner / 3.0).abs() < 1e-6, "{}", found.before);
    assert!((found.after - corner).abs() < 1e-6, "{}", found.after);
    assert_eq!((found.left[0].at, found.left[0].reason), (DVec2::ZERO, Reason::Sharp));
    assert!(apart(&[wedge], &places(&found)) < 1e-12);
}

#[test]
fn small_holes_are_dropped_and_kept_edges_stay_whole() {
    let square = ring(&[[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]]);
    let hole = |x: f64, size: f64| ring(&[[x, 5.0], [x, 5.0 + size], [x + size, 5.0]]);
    let rings = [square, hole(2.0, 0.01), hole(6.0, 1.0)];
    let found =
        conditioned(&rings, &BoundaryDemands { least_hole: 0.1, ..BoundaryDemands::default() });
    assert_eq!((found.rings.len(), count(&found, ChangeKind::HoleDropped)), (2, 1));
    assert_eq!(found.rings[1].iter().find_map(|point| point.of), Some(7));
    let boundary = PlanarBoundary::new(&rings).unwrap();
    let found = condition(
        &boundary,
        &BoundaryDemands { least_hole: 0.1, size: Some(0.5), ..BoundaryDemands::default() },
        |v| if v < 7 { Hold::Edge } else { Hold::Free },
    );
    let found = found.unwrap();
    assert_eq!(found.rings.len(), 3);
    assert!(found.rings[..2].iter().flatten().all(|point| point.of.is_some()));
    assert!(
        found.left.iter().all(|left| left.reason == Reason::Kept || is_narrow(left))
            && !found.left.is_empty()
    );
}

/// The tent of a side that stays whole meets the hole: no length of the hole's edges makes room, and there is no end of dividing them.
#[test]
fn edges_beside_a_side_that_stays_whole_are_not_divided_for_ever() {
    let square = ring(&[[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]]);
    let hole = ring(&[[6.0, 5.0], [6.0, 6.0], [7.0, 5.0]]);
    let boundary = PlanarBoundary::new(&[square, hole]).unwrap();
    for (size, most) in [(None, 3), (Some(0.5), 12)] {
        let demands = BoundaryDemands { size, angle: 40.0, ..BoundaryDemands::default() };
        let hold = |v| if v < 4 { Hold::Edge } else { Hold::Free };
        let found = condition(&boundary, &demands, hold).unwrap();
        assert!((3..=most).contains(&found.rings[1].len()), "{found:?}");
        assert!(found.left.iter().any(|left| left.reason == Reason::Kept), "{found:?}");
        // A place that a mesh shows is told once.
        let narrow = found.left.iter().filter(|left| left.reason == Reason::Narrow);
        let mut places: Vec<_> = narrow.map(|left| left.at.to_array().map(f64::to_bits)).collect();
        places.sort_unstable();
        assert!(places.windows(2).all(|both| both[0] != both[1]), "{places:?}");
    }
}

/// In a wedge below the angle tents meet up to the tip, however short the edges are: dividing them came near it without end.
#[test]
fn a_corner_that_stays_sharp_draws_no_points_without_end() {
    let wedge = |points: usize| {
        let arm =
            |y: f64| (0..points).map(move |i| [10.0, y].map(|c| c * i as f64 / points as f64));
        let back = arm(1.0).skip(1).collect::<Vec<_>>().into_iter().rev();
        let ends = [[10.0, -1.0], [10.0, 1.0]];
        ring(&arm(-1.0).chain(ends).chain(back).collect::<Vec<_>>())
    };
    for points in [1, 5, 20] {
        for size in [None, Some(0.5)] {
            let demands = BoundaryDemands { size, ..BoundaryDemands::default() };
            let found = conditioned(&[wedge(points)], &demands);
            let new = &places(&found)[0];
            let shortest = new.windows(2).map(|ends| ends[0].distance(ends[1]));
            assert!(shortest.fold(f64::INFINITY, f64::min) > 0.05, "{points}: {found:?}");
        }
    }
}

#[test]
fn coasts_by_chance_reach_the_angle_within_the_distance() {
    let (mut reached, mut all) = (0, 0);
    // Nearly every place of the thirteenth is a strait whose changes are tried by meshes, which takes longer than a test may.
    for seed in (0..16).filter(|seed| *seed != 13) {
        let rings = coast(40 + 7 * (seed as u32 % 20), 0.05 * (seed % 7) as f64, seed);
        let Ok(boundary) = PlanarBoundary::new(&rings) else { continue };
        for size in [None, Some(4.0)] {
            let within = [0.0, 0.5, 3.0][(seed % 3) as usize];
            let demands = BoundaryDemands {
                angle: 25.0,
                within,
                size,
                growth: if seed % 2 == 0 { 0.5 } else { 0.0 },
                ..BoundaryDemands::default()
            };
            let found = condition(&boundary, &demands, |_| Hold::Free).unwrap();
            let new = places(&found);
            assert!(
                apart(&rings, &new) <= within + 1e-9,
                "seed {seed} {size:?}: {} {within} {:?}",
                apart(&rings, &new),
                found.moved
            );
            assert!(found.moved <= within, "seed {seed}: {} {within}", found.moved);
            assert_eq!(
                found.after >= 25.0,
                found.left.iter().all(is_narrow),
                "seed {seed} {within} {size:?} {} {:?}",
                found.after,
                found.left
            );
            assert!(found.after >= found.before.min(25.0) - 1e-9, "seed {seed}: {found:?}");
            for point in found.rings.iter().flatten() {
                if let Some(of) = point.of {
                    assert_eq!(point.at, boundary.point(of));
                }
            }
            if let Some(size) = size {
                let longest = new.iter().flat_map(|ring| {
                    (0..ring.len()).map(move |i| ring[i].distance(ring[(i + 1) % ring.len()]))
                });
                assert!(longest.fold(0.0, f64::max) <= 4.0 / 3.0 * size + 1e-9);
            }
            all += 1;
            reached += usize::from(found.left.is_empty());
            let is_sharp = |left: &Left| left.reason == Reason::Sharp;
            let is_known = |left: &Left| is_narrow(left) || within == 0.0 && is_sharp(left);
            assert!(found.left.iter().all(is_known), "seed {seed}: {:?}", found.left);
        }
    }
    assert!(all > 24 && 2 * reached > all, "{reached} of {all}");
}

/// A triangle with two sides of length 5 and edges of about 1.
fn wedge(degrees: f64) -> Vec<DVec2> {
    let corners =
        [DVec2::ZERO, DVec2::new(5.0, 0.0), 5.0 * DVec2::from_angle(degrees.to_radians())];
    let side = |i: usize| {
        let [from, to] = [corners[i], corners[(i + 1) % 3]];
        let edges = from.distance(to).round() as u32;
        (0..edges).map(move |edge| from.lerp(to, f64::from(edge) / f64::from(edges)))
    };
    (0..3).flat_map(side).collect()
}

/// The lengths of all edges, from the shortest on.
fn lengths(rings: &[Vec<DVec2>]) -> Vec<f64> {
    let of = |ring: &Vec<DVec2>, i: usize| ring[i].distance(ring[(i + 1) % ring.len()]);
    let all = rings.iter().flat_map(|ring| (0..ring.len()).map(move |i| of(ring, i)));
    let mut lengths: Vec<f64> = all.collect();
    lengths.sort_by(f64::total_cmp);
    lengths
}

#[test]
fn narrow_water_is_opened_so_that_no_edge_is_short() {
    // A spike of a hundredth at its root and 30 units deep, and a strait of a tenth between two basins.
    let spike = ring(&[
        [0.0, 0.0],
        [40.0, 0.0],
        [40.3, 20.0],
        [70.0, 20.0],
        [39.8, 20.01],
        [40.0, 40.0],
        [0.0, 40.0],
    ]);
    let strait = ring(&[
        [0.0, 0.0],
        [40.0, 0.0],
        [40.3, 20.0],
        [70.0, 20.0],
        [70.0, 0.0],
        [110.0, 0.0],
        [110.0, 40.0],
        [70.0, 40.0],
        [70.4, 20.1],
        [39.7, 20.1],
        [40.0, 40.0],
        [0.0, 40.0],
    ]);
    for rings in [[spike], [strait]] {
        let found = conditioned(&rings, &BoundaryDemands::of_size(4.0));
        let new = places(&found);
        assert!(found.after >= 25.0 && found.left.is_empty(), "{:?}", found.left);
        assert!(found.moved <= 0.5 && apart(&rings, &new) <= 0.5 + 1e-9, "{}", found.moved);
        let lengths = lengths(&new);
        assert!(lengths[0] > 0.45, "{:?} {:?}", &lengths[..9], found.changes);
        let opened = found.changes.iter().filter(|change| change.why == Why::Near);
        assert!(opened.clone().count() >= 2 && opened.clone().all(|it| it.moved > Some(0.2)));
    }
}

#[test]
fn edges_of_coasts_by_chance_are_a_fifth_of_most_at_least() {
    for seed in (0..16).filter(|seed| *seed != 13) {
        let rings = coast(40 + 7 * (seed as u32 % 20), 0.05 * (seed % 7) as f64, seed);
        let size = [4.0, 8.0, 12.0][(seed % 3) as usize];
        let found = conditioned(&rings, &BoundaryDemands::of_size(size));
        let lengths = lengths(&places(&found));
        assert!(lengths[0] > lengths[lengths.len() / 2] / 5.0, "{seed}: {:?}", &lengths[..9]);
    }
}

#[test]
fn what_was_conditioned_stays_as_it_is() {
    let mut all = 0;
    for seed in 0..12 {
        let rings = coast(40 + 7 * (seed as u32 % 20), 0.05 * (seed % 9) as f64, seed);
        let demands = BoundaryDemands::of_size([4.0, 8.0, 12.0][(seed % 3) as usize]);
        let first = conditioned(&rings, &demands);
        assert!(!first.changes.is_empty());
        if first.left.is_empty() {
            let again = conditioned(&places(&first), &demands);
            assert_eq!((&again.changes[..], again.moved), (&[][..], 0.0), "{seed}");
            all += 1;
        }
    }
    assert!(all > 6, "{all}");
    // Nor does one edge that is a seventh of the size, among lengths that change gradually, move anything.
    let uneven = [4.0, 4.0, 3.0, 2.0, 1.3, 0.8, 0.6, 0.8, 1.3, 2.0, 3.0, 4.0, 4.0, 4.0];
    let even = [4.0; 60];
    let (mut at, mut fine) = (DVec2::ZERO, Vec::new());
    for (way, lengths) in
        [(DVec2::X, &uneven[..]), (DVec2::Y, &even), (-DVec2::X, &uneven), (-DVec2::Y, &even)]
    {
        for length in lengths {
            fine.push(at);
            at += way * *length;
        }
    }
    let fine = conditioned(&[fine], &BoundaryDemands::of_size(4.0));
    assert!(fine.before > 25.0 && fine.changes.is_empty(), "{}: {:?}", fine.before, fine.changes);
}

#[test]
fn a_short_edge_goes_where_only_points_on_edges_mend_what_that_leaves() {
    // A notch between two islands that overlap, in kilometres: two edges of 52 and 145 metres between two of 3 kilometres.
    let notch = [[2.245, -1.37], [0.0, 0.0], [-0.0214, 0.0477], [-0.0949, -0.0768]];
    let island = ring(&[&notch[..], &[[-2.635, -1.927], [-3.0, 2.0], [3.0, 2.0]]].concat());
    let sea = ring(&[[-9.0, -9.0], [9.0, -9.0], [9.0, 5.0], [-9.0, 5.0]]);
    let rings = [sea, island];
    let found = conditioned(&rings, &BoundaryDemands::of_size(4.0));
    let new = places(&found);
    assert!(found.after >= 25.0 && apart(&rings, &new) <= 0.5);
    assert!(lengths(&new)[0] > 0.25, "{:?}", &lengths(&new)[..5]);
}

#[test]
fn the_end_of_a_straight_side_goes_along_it_and_the_side_stays_straight() {
    // The east side is straight up to a coast that begins with a short edge, the west side from one on.
    let sea = ring(&[
        [0.0, 0.0],
        [10.0, 0.0],
        [10.0, 3.0],
        [10.0, 5.0],
        [9.96, 5.02],
        [7.0, 6.5],
        [3.0, 6.4],
        [0.03, 5.05],
        [0.0, 5.0],
        [0.0, 2.0],
    ]);
    let is_straight = |edge: u32| ![3, 4, 5, 6, 7].contains(&edge);
    let boundary = PlanarBoundary::new(&[sea]).unwrap();
    let run = |hold: Hold| {
        let hold = |edge| match edge {
            3 | 8 => hold,
            0 | 1 => Hold::Corner,
            4 | 7 => Hold::Point,
            _ => Hold::Free,
        };
        let domain = |_| [true, false];
        let demands = BoundaryDemands::of_size(2.0);
        condition_map(&boundary, &demands, hold, domain, is_straight, &ANY, &[]).unwrap()
    };
    assert!(lengths(&places(&run(Hold::Corner)))[0] < 0.1);
    let found = run(Hold::End);
    let new = &found.rings[0];
    assert!(lengths(&places(&found))[0] > 0.125, "{new:?}");
    let mut on_box = 0;
    for (index, point) in new.iter().enumerate() {
        let next = new[(index + 1) % new.len()].at;
        let is_on_box = [point.at, next].iter().all(|at| at.x == 10.0)
            || [point.at, next].iter().all(|at| at.x == 0.0)
            || [point.at, next].iter().all(|at| at.y == 0.0);
        assert_eq!(is_straight(point.edge), is_on_box, "{point:?} {next}");
        on_box += usize::from(is_on_box);
    }
    assert!(on_box > 6);
}

#[test]
fn edges_at_a_corner_are_in_no_strait() {
    // Shorter edges beside a corner that is too sharp lift nothing; nor do they where there is only little room.
    for (degrees, growth, left) in [(12.0, 0.0, 1), (30.0, 0.5, 0)] {
        let demands = BoundaryDemands { growth, within: 0.0, ..BoundaryDemands::default() };
        let found = conditioned(&[wedge(degrees)], &demands);
        // One lets the triangles of the tip have 25 degrees.
        assert!(count(&found, ChangeKind::Inserted) < 2 - left, "{degrees}");
        assert_eq!(found.left.len(), left, "{degrees}: {:?}", found.left);
    }
}

#[test]
fn an_inlet_one_edge_wide_gets_room_for_its_triangles() {
    // A creek of Natural Earth's coast, in metres: no vertex and no two edges of it forbid 26 degrees, but its triangles have 20.
    let creek = ring(&[
        [-4000.0, -6000.0],
        [4000.0, -6000.0],
        [2993.0, -2018.0],
        [1427.0, -1998.0],
        [820.0, -491.0],
        [1778.0, 996.0],
        [1494.0, 3249.0],
        [538.0, 1949.0],
        [-124.0, -853.0],
        [-1399.0, -2524.0],
        [-2935.0, -348.0],
    ]);
    let creek = std::slice::from_ref(&creek);
    let demands = |within| BoundaryDemands { within, ..BoundaryDemands::default() };
    let found = conditioned(creek, &demands(500.0));
    assert!(found.after >= 25.0 && found.left.is_empty(), "{:?}", found.left);
    let changed = count(&found, ChangeKind::Shifted) + count(&found, ChangeKind::Inserted);
    assert!((1..6).contains(&changed), "{:?}", found.changes);
    assert!(found.moved <= 500.0 && apart(creek, &places(&found)) <= found.moved + 1e-6);
    // Where it may not move, points on its edges are enough here.
    let found = conditioned(creek, &demands(0.0));
    assert!(found.after >= 25.0 && found.left.is_empty(), "{:?}", found.left);
    assert!(count(&found, ChangeKind::Inserted) > 0 && apart(creek, &places(&found)) < 1e-9);
    // Points that stay are not moved.
    let boundary = PlanarBoundary::new(creek).unwrap();
    let kept = condition(&boundary, &demands(500.0), |_| Hold::Point).unwrap();
    assert_eq!(count(&kept, ChangeKind::Shifted) + count(&kept, ChangeKind::Dropped), 0);
}

/// Conditions and meshes some of the straits by chance: two bays, and between them a strait with uneven shores, each of
/// which alone allows the angle. Gives how many points were moved.
fn straits_by_chance(cases: std::ops::Range<u32>, demands: &BoundaryDemands) -> usize {
    let mut random = Random::new(7);
    let mut shifted = 0;
    for case in 0..cases.end {
        let mut off = |most: f64| most * (2.0 * random.unit() - 1.0);
        let mut shore = |x: f64, ys: [f64; 4]| ys.map(|y| [x + off(0.3), y + off(0.45)]).to_vec();
        let east = shore(0.45, [-1.5, -0.5, 0.5, 1.5]);
        let west = shore(-0.45, [1.5, 0.5, -0.5, -1.5]);
        if case < cases.start {
            continue;
        }
        let north = [[1.5, 2.2], [1.5, 3.5], [0.0, 4.0], [-1.5, 3.5], [-1.5, 2.2]];
        let south = north.map(|[x, y]| [-x, -y]);
        let strait = ring(&[&south[..], &east, &north, &west].concat());
        let found = conditioned(std::slice::from_ref(&strait), demands);
        assert!(found.moved <= demands.within);
        shifted += count(&found, ChangeKind::Shifted);
        let outline = PlanarBoundary::new(&places(&found)).unwrap();
        let mesh = generate(&outline, &Options::default(), Progress::NONE).unwrap();
        let angle = mesh.report.min_angle;
        // Neither in silence nor by a false alarm.
        assert_eq!(angle >= 25.0, found.left.is_empty(), "{case}: {angle} {:?}", found.left);
    }
    shifted
}

#[test]
fn meshes_of_straits_one_edge_wide_have_the_angle_or_their_places_are_told() {
    let demands = BoundaryDemands { within: 0.3, ..BoundaryDemands::default() };
    straits_by_chance(0..12, &demands);
}

#[test]
fn meshes_of_other_straits_have_the_angle_or_their_places_are_told() {
    let demands = BoundaryDemands { within: 0.3, growth: 0.0, ..BoundaryDemands::default() };
    assert!(straits_by_chance(12..24, &demands) > 0);
}

#[test]
fn a_rock_in_a_bay_keeps_the_bay() {
    let bay = ring(&[
        [0.0, 0.0],
        [4.0, 0.0],
        [5.0, -0.4],
        [6.0, 0.0],
        [10.0, 0.0],
        [10.0, 5.0],
        [0.0, 5.0],
    ]);
    let rock = ring(&[[4.9, -0.2], [5.0, -0.1], [5.1, -0.2]]);
    let demands = BoundaryDemands { within: 1.0, size: Some(8.0), ..BoundaryDemands::default() };
    let without = conditioned(std::slice::from_ref(&bay), &demands);
    assert!(without.rings[0].iter().all(|point| point.of != Some(2)), "{without:?}");
    let with = conditioned(&[bay, rock], &demands);
    // Its tip may move away from the rock.
    assert!(with.rings[0].iter().any(|point| point.at.y < -0.2), "{with:?}");
    assert_eq!(with.rings.len(), 2);
}

#[test]
fn lengths_change_gradually_where_that_is_asked() {
    let rings = coast(120, 0.3, 5);
    let demands = BoundaryDemands { growth: 0.5, within: 1.0, ..BoundaryDemands::default() };
    let found = conditioned(&rings, &demands);
    let edges: Vec<[DVec2; 2]> = places(&found)
        .iter()
        .flat_map(|ring| (0..ring.len()).map(move |i| [ring[i], ring[(i + 1) % ring.len()]]))
        .collect();
    for [a, b] in &edges {
        for [c, d] in &edges {
            let apart = a.midpoint(*b).distance(c.midpoint(*d));
            assert!(a.distance(*b) <= 4.0 / 3.0 * (c.distance(*d) + 0.5 * apart) + 1e-9);
        }
    }
}

#[test]
fn demands_out_of_range_are_refused() {
    let boundary = PlanarBoundary::new(&[ring(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])]).unwrap();
    let bad = [
        BoundaryDemands { angle: 0.0, ..BoundaryDemands::default() },
        BoundaryDemands { angle: f64::NAN, ..BoundaryDemands::default() },
        BoundaryDemands { angle: 41.0, ..BoundaryDemands::default() },
        BoundaryDemands { within: -1.0, ..BoundaryDemands::default() },
        BoundaryDemands { size: Some(0.0), ..BoundaryDemands::default() },
        BoundaryDemands { growth: 0.2, ..BoundaryDemands::default() },
        BoundaryDemands { growth: f64::NAN, ..BoundaryDemands::default() },
        BoundaryDemands { least_hole: f64::INFINITY, ..BoundaryDemands::default() },
    ];
    for demands in bad {
        assert!(condition(&boundary, &demands, |_| Hold::Free).is_err(), "{demands:?}");
    }
}

/// Found with a map of Alaska: the middle of an edge is rounded, and a corner was between it and the edge.
#[test]
fn an_edge_that_a_corner_nearly_touches_stays_whole() {
    let mut cases = 0;
    for step in 0..200 {
        let a = DVec2::new(480_000.1, 410_000.3);
        let b = a + DVec2::new(100.0 + 0.37 * f64::from(step), 31.0 + 0.11 * f64::from(step));
        let [along, middle] = [a.lerp(b, 0.4), a.midpoint(b)];
        let near = [-1.0, 0.0, 1.0, 2.0].map(|ulps| along + DVec2::Y * ulps * 2_f64.powi(-34));
        let is_between =
            |at: &DVec2| orientation(a, b, *at) > 0.0 && orientation(a, middle, *at) <= 0.0;
        for at in near.into_iter().filter(is_between) {
            cases += 1;
            let top = a.y + 300.0;
            let outer = vec![a, b, DVec2::new(b.x, top), DVec2::new(a.x, top)];
            let hole = vec![at, at + DVec2::new(-10.0, 90.0), at + DVec2::new(10.0, 90.0)];
            let demands = BoundaryDemands { size: Some(20.0), ..BoundaryDemands::default() };
            let found = conditioned(&[outer, hole], &demands);
            assert!(found.rings.concat().len() > 40, "{}", found.rings.concat().len());
        }
    }
    assert!(cases > 10, "{cases}");
}

/// A square whose middle line has a step that is too short.
#[test]
fn a_line_between_two_regions_is_changed_once_for_both() {
    let square = ring(&[[0.0, 0.0], [4.0, 0.0], [8.0, 0.0], [8.0, 8.0], [4.0, 8.0], [0.0, 8.0]]);
    let inner = ring(&[[4.0, 4.0], [4.01, 4.0]]);
    let line = vec![1, 6, 7, 4];
    let (map, _) = PlanarBoundary::map(&[square], &inner, &[line]).unwrap();
    let still = condition(&map, &BoundaryDemands::default(), |_| Hold::Free).unwrap();
    assert!(still.before < 7.0 && still.after >= 25.0, "{still:?}");
    assert!(count(&still, ChangeKind::Inserted) > 4 && still.lines[0].len() > 6);
    let demands = BoundaryDemands { within: 0.02, ..BoundaryDemands::default() };
    let found = condition(&map, &demands, |_| Hold::Free).unwrap();
    assert!(found.after >= 25.0 && found.left.is_empty(), "{found:?}");
    assert_eq!(count(&found, ChangeKind::Dropped), 1);
    assert!(found.moved > 0.0 && found.moved <= 0.02);
    // The ends are where they were.
    let ends = [found.lines[0].first(), found.lines[0].last()].map(|end| end.unwrap().of);
    assert_eq!(ends, [Some(1), Some(4)]);
    // A mark between the old line and the new one keeps the old.
    let mark = [DVec2::new(4.005, 4.0)];
    let has_domain = |edge: u32| [true, edge >= map.vertex_count()];
    let marked =
        condition_map(&map, &demands, |_| Hold::Free, has_domain, |_| false, &ANY, &mark).unwrap();
    assert_eq!(count(&marked, ChangeKind::Dropped), 0);
}

#[test]
fn lines_that_meet_too_sharply_are_named_and_end_no_edges() {
    let square = ring(&[[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]]);
    let inner = ring(&[[4.0, 0.2], [4.0, 0.4], [1.3, 0.065], [2.9, 0.29]]);
    let lines = [vec![0, 6, 4], vec![0, 7, 5]];
    let (map, _) = PlanarBoundary::map(&[square], &inner, &lines).unwrap();
    let found =
        condition(&map, &BoundaryDemands { within: 1.0, ..BoundaryDemands::default() }, |_| {
            Hold::Free
        })
        .unwrap();
    assert!(found.left.iter().any(|left| left.at == DVec2::ZERO && left.reason == Reason::Meeting));
    assert!(
        found.lines.iter().flatten().count() < 30,
        "{} {found:?}",
        found.lines.iter().flatten().count()
    );
}

/// Borders by chance: a grid of regions, each border a walk.
fn borders(cells: u32, steps: u32, roughness: f64, seed: u64) -> PlanarBoundary {
    let mut random = Random::new(seed);
    let corner = |x: u32, y: u32| DVec2::new(f64::from(x), f64::from(y)) * 10.0;
    let side =
        |i: u32| [corner(i, 0), corner(cells, i), corner(cells - i, cells), corner(0, cells - i)];
    let outer: Vec<DVec2> =
        (0..4).flat_map(|which| (0..cells).map(move |i| side(i)[which])).collect();
    let mut inner: Vec<DVec2> = Vec::new();
    let index = |x: u32, y: u32, inner: &mut Vec<DVec2>| {
        let at = corner(x, y);
        let known = outer.iter().chain(&*inner).position(|point| *point == at);
        known.unwrap_or_else(|| {
            inner.push(at);
            outer.len() + inner.len() - 1
        }) as u32
    };
    let mut lines = Vec::new();
    for x in 0..=cells {
        for y in 0..=cells {
            for (dx, dy) in [(1, 0), (0, 1)] {
                let is_inside = x + dx <= cells
                    && y + dy <= cells
                    && (if dx == 1 { y } else { x }) % cells != 0;
                if !is_inside {
                    continue;
                }
                let ends = [index(x, y, &mut inner), index(x + dx, y + dy, &mut inner)];
                let [from, to] = [corner(x, y), corner(x + dx, y + dy)];
                let mut line = vec![ends[0]];
                for step in 1..steps {
                    let along = (f64::from(step) + 0.7 * (random.unit() - 0.5)) / f64::from(steps);
                    let across = roughness * along * (1.0 - along) * (random.unit() - 0.5);
                    inner.push(from.lerp(to, along) + (to - from).perp() * across);
                    line.push((outer.len() + inner.len() - 1) as u32);
                }
                line.push(ends[1]);
                lines.push(line);
            }
        }
    }
    PlanarBoundary::map(&[&outer], &inner, &lines).unwrap().0
}

/// The limit at a point of a line: seven triangles, shared by both sides in the best way.
fn both_sides(points: &[mindeg_condition::Point]) -> f64 {
    let [before, after] = [0, 2].map(|i| points[i].at - points[1].at);
    let left = after.angle_to(before).rem_euclid(std::f64::consts::TAU);
    let fan = |angle: f64, triangles: u32| {
        fan_limit(angle, before.length(), after.length(), Some(triangles))
    };
    let share = |own: u32| fan(left, own).min(fan(std::f64::consts::TAU - left, 7 - own));
    (1..7).map(share).fold(0.0, f64::max)
}

#[test]
fn maps_by_chance_reach_the_angle_within_the_distance() {
    let (mut reached, mut all) = (0, 0);
    for seed in 0..40 {
        let map =
            borders(2 + seed as u32 % 3, 4 + seed as u32 % 9, 0.1 + 0.4 * (seed % 3) as f64, seed);
        for size in [None, Some(2.0)] {
            let within = [0.0, 0.2, 1.0][(seed % 3) as usize];
            let growth = if seed % 2 == 0 { 0.4 } else { 0.0 };
            let demands = BoundaryDemands { within, size, growth, ..BoundaryDemands::default() };
            let has_domain = |edge: u32| [true, edge >= map.vertex_count()];
            let found =
                condition_map(&map, &demands, |_| Hold::Free, has_domain, |_| false, &ANY, &[])
                    .unwrap();
            assert_eq!(found.lines.len(), map.line_count());
            assert!(found.moved <= within, "seed {seed}: {} {within}", found.moved);
            // Every old point is near its new line.
            for (line, new) in found.lines.iter().enumerate() {
                let new: Vec<DVec2> = new.iter().map(|point| point.at).collect();
                let to_line = |point: DVec2| {
                    let to = |ends: &[DVec2]| {
                        let (a, b) = (ends[0], ends[1]);
                        let share = (point - a).dot(b - a) / a.distance_squared(b);
                        point.distance(a.lerp(b, share.clamp(0.0, 1.0)))
                    };
                    new.windows(2).map(to).fold(f64::INFINITY, f64::min)
                };
                let old = map.line(line).iter().flatten().map(|v| map.point(*v));
                assert!(old.map(to_line).fold(0.0, f64::max) <= within + 1e-9, "seed {seed}");
            }
            assert_eq!(found.after >= 25.0, found.left.is_empty(), "seed {seed}: {:?}", found.left);
            for points in found.lines.iter().flat_map(|line| line.windows(3)) {
                assert!(both_sides(points) >= found.after - 1e-9, "seed {seed}");
            }
            all += 1;
            reached += usize::from(found.left.is_empty());
        }
    }
    assert!(3 * reached > all, "{reached} of {all}");
}

#[test]
fn a_shore_whose_last_point_is_dropped_beside_a_mouth_has_an_end() {
    // Four rough islands: a change at one drops a point that ends another one's surroundings.
    let mut state = 10_u64;
    let mut random = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64 / 2_f64.powi(31)
    };
    let mut rings =
        vec![[[0.0, 0.0], [2e3, 0.0], [2e3, 2e3], [0.0, 2e3]].map(DVec2::from).to_vec()];
    for island in 0..4 {
        let center = 1e3 * DVec2::new(f64::from(island / 2) + 0.5, f64::from(island % 2) + 0.5);
        let corner = |i: i32| {
            let radius = 200.0 * (1.0 + 0.3 * random());
            center + radius * DVec2::from_angle(-std::f64::consts::TAU * f64::from(i) / 24.0)
        };
        rings.push((0..24).map(corner).collect());
    }
    let boundary = PlanarBoundary::new(&rings).unwrap();
    let demands = BoundaryDemands { within: 10.0, ..BoundaryDemands::default() };
    let conditioned = condition(&boundary, &demands, |_| Hold::Free).unwrap();
    assert!(conditioned.moved <= 10.0 && conditioned.rings.len() == 5);
}
