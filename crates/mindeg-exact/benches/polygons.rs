//! Costs of degree, angle and windows on polygons that are not convex.
//!
//! - `cargo bench -p mindeg-exact --bench polygons`: up to some thousand vertices.
//! - `cargo bench -p mindeg-exact --bench polygons -- --include-ignored`: windows up to 10^6.
//!
//! The bias: the coast is a circle with waves of many lengths, so that its middle sees almost
//! everything; real coastlines have fewer chords. spade makes the Delaunay triangulations before the
//! clock starts.

#![expect(clippy::unwrap_used, reason = "a benchmark may panic")]

#[path = "../tests/outlines/mod.rs"]
mod outlines;

use divan::Bencher;
use glam::DVec2;
use mindeg_exact::{Problem, Progress, degree_range, measure, trade_off, windows};
use outlines::{Outline, Random, turn};
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation};

fn main() {
    divan::main();
}

/// A circle with waves of many lengths and uneven steps.
fn coast(vertices: u32) -> Outline {
    let mut random = Random(1);
    let lengths = std::iter::successors(Some(2.0), |waves: &f64| Some(waves * 1.37));
    let waves: Vec<(f64, f64, f64)> = lengths
        .take_while(|&waves| waves < f64::from(vertices) / 4.0)
        .map(|waves| (waves.floor(), 0.25 / libm::pow(waves, 0.75), random.below(1000) as f64))
        .collect();
    let points = (0..vertices).map(|vertex| {
        let step = f64::from(vertex) + 0.4 * random.below(1000) as f64 / 1000.0;
        let angle = std::f64::consts::TAU * step / f64::from(vertices);
        let heights =
            waves.iter().map(|(waves, height, at)| height * libm::sin(waves * angle + at));
        let radius = (1.0 + heights.sum::<f64>()).max(0.1);
        DVec2::new(libm::cos(angle), libm::sin(angle)) * radius
    });
    Outline { points: points.collect(), side_of: (0..vertices).collect() }
}

fn l_shape(vertices: u32) -> Outline {
    let short = vertices / 8;
    Outline::l_shape([2 * short, short, short, short, short, 2 * short])
}

/// The problem with a Delaunay triangulation, and the tangent of its minimum angle.
fn problem(outline: &Outline) -> (Problem, f64) {
    let points = &outline.points;
    let n = points.len();
    let delaunay = ConstrainedDelaunayTriangulation::<Point2<f64>>::bulk_load_cdt(
        points.iter().map(|point| Point2::new(point.x, point.y)).collect(),
        (0..n).map(|from| [from, (from + 1) % n]).collect(),
    );
    let corners = |triangle: &[u32; 3]| triangle.map(|vertex| points[vertex as usize]);
    let triangles = delaunay.unwrap();
    let triangles = triangles.inner_faces().map(|face| {
        let mut triangle = face.vertices().map(|vertex| vertex.index() as u32);
        let least = (0..3).min_by_key(|&corner| triangle[corner]).unwrap();
        triangle.rotate_left(least);
        triangle
    });
    // Outside the polygon the ring runs the other way around a triangle.
    let is_inside = |triangle: &[u32; 3]| {
        let [a, b, c] = corners(triangle);
        triangle[1] < triangle[2] && turn(a, b, c) > 0.0
    };
    let triangles: Vec<[u32; 3]> = triangles.filter(is_inside).collect();
    let tangents = triangles.iter().map(|triangle| measure::min_angle_tangent(corners(triangle)));
    let least = tangents.fold(f64::INFINITY, f64::min);
    (Problem::triangulated(&outline.boundary(), &triangles).unwrap(), least)
}

#[divan::bench(args = [500, 2000], sample_count = 3)]
fn degree_of_coast(bencher: Bencher, vertices: u32) {
    let (problem, _) = problem(&coast(vertices));
    bencher.bench(|| degree_range(&problem, Progress::NONE).unwrap());
}

#[divan::bench(args = [200, 1000, 2000], sample_count = 3)]
fn degree_of_l(bencher: Bencher, vertices: u32) {
    let (problem, _) = problem(&l_shape(vertices));
    bencher.bench(|| degree_range(&problem, Progress::NONE).unwrap());
}

#[divan::bench(args = [200, 1000], sample_count = 3)]
fn trade_off_of_l(bencher: Bencher, vertices: u32) {
    let (problem, _) = problem(&l_shape(vertices));
    bencher.bench(|| trade_off(&problem, Progress::NONE).unwrap());
}

#[divan::bench(args = [500], sample_count = 3)]
fn trade_off_of_coast(bencher: Bencher, vertices: u32) {
    let (problem, _) = problem(&coast(vertices));
    bencher.bench(|| trade_off(&problem, Progress::NONE).unwrap());
}

/// At nine tenths of Delaunay's angle.
#[divan::bench(args = [2000, 20_000], sample_count = 3)]
fn windows_of_coast(bencher: Bencher, vertices: u32) {
    let (problem, tangent) = problem(&coast(vertices));
    bencher.bench(|| windows(&problem, 0, 0.9 * tangent, Progress::NONE).unwrap());
}

#[divan::bench(args = [1_000_000], sample_count = 1, ignore)]
fn windows_of_coast_large(bencher: Bencher, vertices: u32) {
    windows_of_coast(bencher, vertices);
}
