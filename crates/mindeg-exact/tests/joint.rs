//! Costs of vertices that several polygons share: against all triangulations of one polygon.

use crate::outlines::{Measured, Outline, Random};
use glam::DVec2;
use mindeg_exact::measure::min_angle_tangent;
use mindeg_exact::{Block, Cost, LeastWeight, Patch};
use mindeg_mesh::check;

/// Costs from a table, and triangles that cost by their shape or are not allowed.
struct Table {
    of_chords: Vec<Vec<u32>>,
    threshold: f64,
    per_cotangent: f64,
}

impl Cost for Table {
    fn vertex(&self, vertex: u32, chords: u32) -> u32 {
        self.of_chords[vertex as usize][chords as usize]
    }

    fn triangle(&self, corners: [DVec2; 3]) -> Option<u32> {
        let tangent = min_angle_tangent(corners);
        let cost = (self.per_cotangent / tangent).min(1000.0) as u32;
        (tangent >= self.threshold).then_some(cost)
    }
}

impl Table {
    /// Costs that never fall, with jumps and plateaus.
    fn random(random: &mut Random, vertices: usize) -> Self {
        let mut table = || {
            let mut cost = 0;
            let step = |_| {
                cost += [0, 0, 1, 7, random.below(50) as u32][random.below(5) as usize];
                cost
            };
            (0..vertices).map(step).collect()
        };
        let of_chords = (0..vertices).map(|_| table()).collect();
        let per_cotangent = [0.0, 3.0][random.below(2) as usize];
        Self { of_chords, threshold: 0.0, per_cotangent }
    }

    fn of(&self, points: &[DVec2], triangles: &[[u32; 3]]) -> Option<u32> {
        let degrees = Measured::new(points, triangles).degrees;
        let vertices = (0..).zip(degrees).map(|(vertex, degree)| self.vertex(vertex, degree - 2));
        let corners = triangles.iter().map(|t| t.map(|vertex| points[vertex as usize]));
        let triangles: Option<Vec<u32>> = corners.map(|corners| self.triangle(corners)).collect();
        Some(vertices.sum::<u32>() + triangles?.iter().sum::<u32>())
    }
}

fn outlines(count: usize) -> impl Iterator<Item = (Outline, Random)> {
    let mut random = Random(11);
    let next = move || {
        let corners = 4 + random.below(6) as usize;
        Outline::random(&mut random, corners, 12)
            .map(|outline| (outline, Random(random.below(1 << 40))))
    };
    std::iter::repeat_with(next).flatten().take(count)
}

#[test]
fn a_polygon_gets_the_triangulation_of_least_cost() {
    for (outline, mut random) in outlines(300) {
        let n = outline.len();
        let problem = outline.problem();
        let all = outline.triangulations();
        let mut table = Table::random(&mut random, n);
        if random.below(2) == 0 {
            let any = &all[random.below(all.len() as u64) as usize];
            table.threshold = Measured::new(&outline.points, any).tangent;
        }
        let least = all.iter().filter_map(|triangles| table.of(&outline.points, triangles)).min();
        let mut patch = Patch::new(&problem);
        let before = table.of(&outline.points, patch.triangles());
        let is_changed = patch.improve(Block { vertex: 0, skip: 0, size: n }, &table);
        let after = table.of(&outline.points, patch.triangles());
        assert_eq!(after, least, "{outline:?}");
        assert_eq!(is_changed, before != after);
        let checked = check::triangulation(&outline.boundary(), &[], patch.triangles());
        let degrees = checked.unwrap().degrees;
        assert!((0..).zip(degrees).all(|(vertex, degree)| patch.chords(vertex) + 2 == degree));
    }
}

#[test]
fn windows_never_cost_more_and_end_near_the_least() {
    let (mut reached, mut count) = (0, 0);
    for (outline, mut random) in outlines(200) {
        let n = outline.len() as u32;
        let problem = outline.problem();
        let table = Table::random(&mut random, outline.len());
        let all = outline.triangulations();
        let least = all.iter().filter_map(|triangles| table.of(&outline.points, triangles)).min();
        let mut patch = Patch::new(&problem);
        let mut cost = table.of(&outline.points, patch.triangles()).unwrap();
        for turn in 0..4 * n {
            let block = Block { vertex: turn % n, skip: turn / n, size: 4 };
            let is_changed = patch.improve(block, &table);
            let after = table.of(&outline.points, patch.triangles()).unwrap();
            assert_eq!(is_changed, after < cost);
            assert!(after <= cost);
            cost = after;
        }
        check::triangulation(&outline.boundary(), &[], patch.triangles()).unwrap();
        count += 1;
        reached += u32::from(Some(cost) == least);
    }
    assert!(2 * reached > count, "{reached} of {count}");
}

#[test]
fn the_least_weight_is_that_of_all_triangulations() {
    for (outline, mut random) in outlines(300) {
        let problem = outline.problem();
        let weights: Vec<u64> = outline.points.iter().map(|_| random.below(20)).collect();
        let all = outline.triangulations();
        let any = &all[random.below(all.len() as u64) as usize];
        let threshold = Measured::new(&outline.points, any).tangent;
        let weight = |chords: &[u32]| {
            chords
                .iter()
                .zip(&weights)
                .map(|(&count, weight)| u64::from(count) * weight)
                .sum::<u64>()
        };
        for threshold in [0.0, threshold] {
            let measured = all.iter().map(|triangles| Measured::new(&outline.points, triangles));
            let chords = measured
                .filter(|measured| measured.tangent >= threshold)
                .map(|measured| measured.degrees.iter().map(|degree| degree - 2).collect());
            let least = chords.map(|chords: Vec<u32>| weight(&chords)).min();
            let solver = LeastWeight::new(&problem, threshold).unwrap();
            let (found, chords) = solver.of(&weights).unwrap();
            assert_eq!(Some(found), least, "{outline:?}");
            assert_eq!(weight(&chords), found);
            assert!(solver.triples() > 0);
        }
        assert_eq!(LeastWeight::new(&problem, 2.0).unwrap().of(&weights), None);
    }
}
