//! Costs of the whole trade-off as the number of vertices grows.
//!
//! - `cargo bench -p mindeg-exact --bench cost`: up to 400 vertices.
//! - `cargo bench -p mindeg-exact --bench cost -- --include-ignored`: up to 2,000.
//!
//! The bias: a 4 by 3 rectangle with equal intervals, where two or three degrees have an angle of
//! their own; `graded` has a ratio of 1.02 from each interval to the next, and more such degrees.
//! Memory is what is allocated at the same time.

#![expect(clippy::unwrap_used, reason = "a benchmark may panic")]

use divan::{AllocProfiler, Bencher};
use glam::DVec2;
use mindeg_core::Boundary;
use mindeg_exact::{Problem, Progress, best_angle, least_max_degree, trade_off};

#[global_allocator]
static ALLOCATOR: AllocProfiler = AllocProfiler::system();

fn main() {
    divan::main();
}

/// A rectangle of 4 by 3 with this number of vertices, shared out as 10:10:10:10 or 12:9:4:4.
fn rectangle(vertices: u64, is_even: bool, ratio: f64) -> Problem {
    let shares = if is_even { [5, 5, 5, 5] } else { [8, 6, 3, 3] };
    // Halves are rounded up on the first and third side, down on the others.
    let round_up = [19, 0, 19, 0];
    let sides = [0, 1, 2, 3].map(|side| (vertices * shares[side] + round_up[side]) / 20);
    let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)].map(DVec2::from);
    let mut points = Vec::new();
    for (side, &intervals) in sides.iter().enumerate() {
        let lengths = || std::iter::successors(Some(1.0), |length| Some(length * ratio));
        let total: f64 = lengths().take(intervals as usize).sum();
        let mut place = 0.0;
        for length in lengths().take(intervals as usize) {
            points.push(corners[side].lerp(corners[(side + 1) % 4], place / total));
            place += length;
        }
    }
    Problem::new(&Boundary::new(&sides).unwrap(), &points).unwrap()
}

#[divan::bench(args = [50, 100, 200, 400], sample_count = 10)]
fn even_counts(bencher: Bencher, vertices: u64) {
    let problem = rectangle(vertices, true, 1.0);
    bencher.bench(|| trade_off(&problem, Progress::NONE).unwrap());
}

#[divan::bench(args = [50, 100, 200, 400], sample_count = 10)]
fn uneven_counts(bencher: Bencher, vertices: u64) {
    let problem = rectangle(vertices, false, 1.0);
    bencher.bench(|| trade_off(&problem, Progress::NONE).unwrap());
}

#[divan::bench(args = [50, 100, 200, 400], sample_count = 10)]
fn graded(bencher: Bencher, vertices: u64) {
    let problem = rectangle(vertices, true, 1.02);
    bencher.bench(|| trade_off(&problem, Progress::NONE).unwrap());
}

/// One point of the curve: the least degree.
#[divan::bench(args = [50, 100, 200, 400], sample_count = 10)]
fn least_degree_only(bencher: Bencher, vertices: u64) {
    let problem = rectangle(vertices, false, 1.0);
    let least = least_max_degree(&problem, Progress::NONE).unwrap();
    bencher.bench(|| best_angle(&problem, least, Progress::NONE).unwrap());
}

#[divan::bench(args = [800, 2000], sample_count = 1, ignore)]
fn even_counts_large(bencher: Bencher, vertices: u64) {
    even_counts(bencher, vertices);
}

#[divan::bench(args = [800, 2000], sample_count = 1, ignore)]
fn uneven_counts_large(bencher: Bencher, vertices: u64) {
    uneven_counts(bencher, vertices);
}
