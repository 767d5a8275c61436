//! How long it takes to place points, to choose a candidate, and to visit every triangle.
//!
//! A rectangle of 4 by 3 with the same number of intervals on all sides: the zig-zag has more
//! candidates to choose from than any other construction. Graded sides show what a spacing law costs.

#![expect(clippy::unwrap_used, reason = "a benchmark may panic")]

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use mindeg::{BoundaryMesh, Domain, Side, Spacing};

fn main() {
    divan::main();
}

/// Vertices, and whether sides are graded.
const INPUTS: [(u32, bool); 4] =
    [(10_000, false), (1_000_000, false), (1_000_000, true), (10_000_000, false)];

fn domain((vertices, is_graded): (u32, bool)) -> Domain {
    let spacing = if is_graded { Spacing::Bump { ratio: 0.3 } } else { Spacing::Uniform };
    let side = || Side::count(u64::from(vertices) / 4).spaced(spacing.clone());
    Domain::rectangle(4.0, 3.0, (0..4).map(|_| side()).collect()).unwrap()
}

#[divan::bench(args = INPUTS)]
fn points(bencher: Bencher<'_, '_>, input: (u32, bool)) {
    let domain = domain(input);
    bencher.counter(ItemsCount::new(input.0)).bench_local(|| {
        domain.placement().points().for_each(|point| {
            black_box(point);
        });
    });
}

#[divan::bench(args = INPUTS, sample_count = 10)]
fn least_degree(bencher: Bencher<'_, '_>, input: (u32, bool)) {
    let domain = domain(input);
    bencher.counter(ItemsCount::new(input.0)).bench_local(|| BoundaryMesh::least_degree(&domain));
}

#[divan::bench(args = INPUTS, sample_count = 10)]
fn angle_range(bencher: Bencher<'_, '_>, input: (u32, bool)) {
    let mesh = BoundaryMesh::least_degree(&domain(input)).unwrap();
    bencher.counter(ItemsCount::new(input.0)).bench_local(|| mesh.angle_range());
}
