use i_overlay::core::fill_rule::FillRule as OtherRule;
use i_overlay::float::simplify::SimplifyShape;
use mindeg_mesh::planar::doubled_area;

use super::super::choice::labelled;
use super::super::outline::{FillRule, Outlines};
use super::super::sides::Division;
use super::crossings::parted;
use super::*;

type Points = Vec<[f64; 2]>;

fn ring(points: &[[f64; 2]]) -> DrawnRing {
    DrawnRing::of_points(points.iter().copied().map(DVec2::from))
}

fn points(ring: &DrawnRing) -> Points {
    ring.flattened().iter().map(|point| point.to_array()).collect()
}

fn laid(rings: &[DrawnRing], rule: FillRule) -> Overlay {
    overlay(&[Layer { rings: rings.iter().collect(), rule }], |inside| inside[0]).unwrap()
}

/// The area of polygons, whose holes may run either way round.
fn area<'a>(polygons: impl IntoIterator<Item = &'a [DrawnRing]>) -> f64 {
    let of = |ring: &DrawnRing| ring.doubled_area().abs() / 2.0;
    polygons.into_iter().map(|rings| of(&rings[0]) - rings[1..].iter().map(of).sum::<f64>()).sum()
}

#[test]
fn edges_get_vertices_where_they_meet() {
    for (given, expected, added) in [
        (&[[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]][..], &[[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]][..], 0),
        (
            &[[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 4.0]],
            &[[0.0, 0.0], [2.0, 2.0], [4.0, 4.0], [4.0, 0.0], [2.0, 2.0], [0.0, 4.0]],
            2,
        ),
        // A vertex on an edge.
        (
            &[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 0.0], [0.0, 4.0]],
            &[[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 0.0], [0.0, 4.0]],
            1,
        ),
    ] {
        let mut vertices = Vertices::new(DVec2::ZERO, 1e-12);
        let ring = ring(given);
        let (chords, _) =
            chords(&[Layer { rings: vec![&ring], rule: FillRule::EvenOdd }], &mut vertices);
        let edges =
            chords.iter().zip(0..).map(|(it, chord)| Edge { ends: it.ends, chord }).collect();
        let (edges, found) = parted(edges, &mut vertices).unwrap();
        let starts = edges.iter().map(|edge| vertices.points[edge.ends[0] as usize].to_array());
        assert_eq!((starts.collect::<Points>(), found), (expected.to_vec(), added));
    }
}

#[test]
fn rings_that_meet_nothing_keep_their_points_and_curves() {
    use super::super::curve::EllipseArc;
    let circle = |radius: f64, sweep: f64| {
        let arc = EllipseArc {
            center: DVec2::ZERO,
            axes: [DVec2::X * radius, DVec2::Y * radius],
            start: 0.0,
            sweep,
        };
        DrawnRing {
            pieces: vec![Piece { curve: PieceCurve::Arc(arc), ..Piece::line(DVec2::X * radius) }],
        }
    };
    let mut square = ring(&[[-0.0, -9.1], [9.0, 0.3], [0.1, 9.0], [-9.0, -0.0]]);
    square.pieces[2].side = Some("wall".into());
    square.pieces[3].begins_side = true;
    let tau = std::f64::consts::TAU;
    for rings in
        [vec![square.clone(), circle(2.0, tau)], vec![circle(3.0, -tau), circle(2.0, -tau)]]
    {
        let found = laid(&rings, FillRule::EvenOdd);
        assert_eq!(found.polygons, [(rings, Some(0))]);
        assert_eq!((found.added, found.repeated, found.dropped), (0, 0, 0));
    }
    // -0 stays -0.
    let found = laid(&[square], FillRule::NonZero);
    assert!(found.polygons[0].0[0].pieces[0].start.x.is_sign_negative());
}

#[test]
fn curves_that_meet_something_become_chords_and_others_stay() {
    let svg = "<svg><path d='M0 0h4v4c0 3-2 3-2 0s-2 3-2 0zM3 3h4v2h-4z'/></svg>";
    let outlines = super::super::svg::read(svg.as_bytes()).unwrap().repaired(None).unwrap();
    let ring = &outlines.features[0].rings[0];
    let curves: Vec<PieceCurve> = ring.pieces.iter().map(|piece| piece.curve).collect();
    let is_curve = |curve: &&PieceCurve| **curve != PieceCurve::Line;
    assert_eq!((outlines.features.len(), curves.iter().filter(is_curve).count()), (1, 1));
}

#[test]
fn each_rule_gives_its_area_without_overlap() {
    let twice = ring(&[[0.0, 5.0], [2.0, 0.0], [0.0, 2.0], [1.0, 5.0], [1.0, 1.0]]);
    for (rule, expected) in [(FillRule::EvenOdd, 2.350_6), (FillRule::NonZero, 2.925_3)] {
        let found = laid(std::slice::from_ref(&twice), rule);
        let found = area(found.polygons.iter().map(|it| &*it.0));
        assert!((found - expected).abs() < 1e-4, "{rule:?}: {found}");
    }
}

/// Numbers that look random.
struct Random(u64);

impl Random {
    fn below(&mut self, end: u64) -> u64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % end
    }
}

/// Rings of 4 to 7 points on a small grid, which meet in all ways that there are; every tenth time two
/// rings of up to 30 points anywhere.
fn random_rings(random: &mut Random, round: u64) -> Vec<DrawnRing> {
    let (rings, least, more, grid, size) = if round % 10 == 9 {
        (2, 8, 23, 1 << 30, 1e-7)
    } else {
        (1, 4, 4, [4, 6][round as usize % 2], 1.0)
    };
    let ring = |_| {
        let count = least + random.below(more);
        let mut point = |_| [0; 2].map(|_: u64| random.below(grid) as f64 * size);
        ring(&(0..count).map(&mut point).collect::<Points>())
    };
    (0..rings).map(ring).collect()
}

/// Against i_overlay: the area is that of the rule, the polygons do not overlap, and they are domains.
/// `MINDEG_FULL` tries all 10,000 rings.
#[test]
fn random_rings_have_the_area_of_another_library() {
    let rounds = if std::env::var_os("MINDEG_FULL").is_some() { 10_000 } else { 1000 };
    let mut random = Random(1);
    for round in 0..rounds {
        let rings = random_rings(&mut random, round);
        for (rule, other) in
            [(FillRule::EvenOdd, OtherRule::EvenOdd), (FillRule::NonZero, OtherRule::NonZero)]
        {
            let expected = other_area(&rings, other);
            let found = laid(&rings, rule);
            let found = area(found.polygons.iter().map(|it| &*it.0));
            assert!(
                (found - expected).abs() <= 1e-7 * (1.0 + expected),
                "{rings:?} {rule:?}: {found}, {expected}"
            );

            let repaired = Outlines::of_rings(rings.clone(), Vec::new())
                .unwrap()
                .repaired(Some(rule))
                .unwrap();
            let sum = area(repaired.features.iter().map(|feature| &*feature.rings));
            // Polygons with their holes laid over each other cover what they sum up to.
            let oriented =
                repaired.features.iter().flat_map(|feature| feature.rings.iter().enumerate());
            let oriented: Vec<DrawnRing> =
                oriented.map(|(index, ring)| turned(ring, index == 0)).collect();
            let covered = other_area(&oriented, OtherRule::NonZero);
            assert!(
                (sum - covered).abs() <= 1e-7 * (1.0 + sum),
                "{rings:?} {rule:?}: {sum}, {covered}"
            );
            let mut of_domains = 0.0;
            for polygon in labelled(repaired.features.clone()) {
                match polygon.domain(&Division::default()) {
                    Ok(domain) => of_domains += domain.area(),
                    Err(error) => panic!("{rings:?} {rule:?}: {polygon:?}: {error}"),
                }
            }
            assert!(
                (of_domains - expected).abs() <= 1e-7 * (1.0 + expected),
                "{rings:?} {rule:?}: {of_domains}, {expected}"
            );
            for feature in repaired.with_parted_holes(f64::INFINITY).features {
                let domain = feature.domain(&Division::default());
                assert!(domain.is_ok(), "{rings:?} {rule:?}: {feature:?}: {domain:?}");
            }
        }
    }
}

/// The same through a drawing: rings whose area with signs is 0 are shapes, too.
#[test]
fn random_paths_of_svg_have_the_area_of_another_library() {
    let mut random = Random(2);
    for round in 0..300 {
        let rings = random_rings(&mut random, round);
        for (word, other) in [("evenodd", OtherRule::EvenOdd), ("nonzero", OtherRule::NonZero)] {
            let path = |ring: &DrawnRing| {
                let points = ring.flattened();
                points.iter().map(|it| format!("{} {} ", it.x, it.y)).collect::<String>()
            };
            let paths: String = rings.iter().map(|ring| format!("M{}z", path(ring))).collect();
            let text = format!("<svg><path fill-rule='{word}' d='{paths}'/></svg>");
            let expected = other_area(&rings, other);
            let found = match super::super::svg::read(text.as_bytes()) {
                Ok(outlines) => {
                    let of_polygons = outlines.features.iter().flat_map(|feature| &feature.rings);
                    let others = outlines.shapes.iter().flat_map(|shape| &shape.without_effect);
                    let kept: Vec<DrawnRing> = of_polygons.chain(others).cloned().collect();
                    let found = laid(&kept, outlines.shapes[0].rule);
                    area(found.polygons.iter().map(|it| &*it.0))
                }
                // All is on a line.
                Err(error) => {
                    assert!(error.to_string().contains("line without area"), "{text}: {error}");
                    0.0
                }
            };
            assert!(
                (found - expected).abs() <= 1e-7 * (1.0 + expected),
                "{text}: {found}, {expected}"
            );
        }
    }
}

/// A ring that runs counter-clockwise, or clockwise.
fn turned(ring: &DrawnRing, is_left: bool) -> DrawnRing {
    let mut points = ring.flattened();
    if turns_left(&points) != is_left {
        points.reverse();
    }
    DrawnRing::of_points(points)
}

fn other_area(rings: &[DrawnRing], rule: OtherRule) -> f64 {
    let contours: Vec<Points> = rings.iter().map(points).collect();
    let shapes = contours.simplify_shape_as::<i64>(rule);
    let of = |contour: &Points| {
        doubled_area(&contour.iter().copied().map(DVec2::from).collect::<Vec<_>>()) / 2.0
    };
    shapes.iter().map(|shape| shape.iter().map(of).sum::<f64>().abs()).sum()
}
