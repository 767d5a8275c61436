//! Combs with many points on few lines, and spirals almost without width, turned by any angle: the checker
//! finds the same least degree from the definition.

use crate::outlines::{Outline, Random};
use glam::DVec2;
use mindeg_exact::check::CheckedOutline;
use mindeg_exact::{Progress, degree_range};
use std::slice;

fn turned(outline: &Outline, angle: f64, offset: f64) -> Outline {
    let turn = DVec2::new(libm::cos(angle), libm::sin(angle));
    let points = outline.points.iter().map(|point| turn.rotate(*point) + offset).collect();
    Outline { points, side_of: outline.side_of.clone() }
}

/// The least degree; the checker finds a triangulation of that degree, and none of less.
fn least(outline: &Outline) -> u32 {
    let problem = outline.problem();
    let range = degree_range(&problem, Progress::NONE).unwrap();
    assert!(range.is_proven(), "{outline:?}");
    let n = outline.len() as u32;
    let ring = 0..n;
    let checker = CheckedOutline {
        points: &outline.points,
        rings: slice::from_ref(&ring),
        side_of: &outline.side_of,
        keeps_clear: problem.keeps_clear(),
    };
    let is_possible = |degree: u32| {
        let chords = vec![degree - 2; n as usize];
        checker.has_triangulation(&chords, 1 << 30).unwrap()
    };
    let found = [range.max_degree - 1, range.max_degree].map(is_possible);
    assert_eq!(found, [false, true], "{} {outline:?}", range.max_degree);
    range.max_degree
}

#[test]
fn turned_combs_have_the_degree_of_straight_ones() {
    let mut random = Random(7);
    for (teeth, spine, others) in [(2, 1, 1), (3, 4, 1), (4, 2, 2), (6, 3, 1), (8, 1, 1)] {
        let comb = Outline::comb(teeth, spine, others);
        // Or each edge on a side of its own, so that only coordinates tell which points are on a line.
        let side_of = (0..comb.len() as u32).collect();
        for outline in [comb.clone(), Outline { points: comb.points, side_of }] {
            let straight = least(&outline);
            for _ in 0..8 {
                let angle = random.below(6283) as f64 / 1000.0;
                let offset = [0.0, 100.0, -12345.0][random.below(3) as usize];
                assert_eq!(least(&turned(&outline, angle, offset)), straight, "{angle} {offset}");
            }
        }
    }
}

#[test]
fn spirals_almost_without_width_have_the_degree_of_the_definition() {
    let mut random = Random(8);
    for width in [1e-1, 1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13] {
        let at = |step: u32, offset: f64| {
            let angle = std::f64::consts::TAU * f64::from(step) / 24.0;
            let radius = 1.0 + f64::from(step) / 24.0 + offset;
            (radius * libm::cos(angle), radius * libm::sin(angle))
        };
        // Three edges outside for each one inside.
        let inner = (0..9).rev().map(|step| at(3 * step, 0.0));
        let corners: Vec<_> = (0..25).map(|step| at(step, width)).chain(inner).collect();
        let spiral = Outline::new(&corners, &[1; 34]);
        assert!(spiral.is_simple());
        for _ in 0..8 {
            let outline = turned(&spiral, random.below(6283) as f64 / 1000.0, 0.0);
            if outline.is_simple() {
                least(&outline);
            }
        }
    }
}
