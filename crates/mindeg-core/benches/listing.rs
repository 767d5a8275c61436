//! The time to list triangles, beside the time to fill the same buffer with a constant.
//!
//! `MINDEG_BENCH_LARGE=1` in the environment adds 10⁸ triangles, which take 1.2 GB. The benchmark
//! `ratios` of the package `mindeg-cli` measures the two in turns and gives their ratio.
//!
//! Bias: the buffer was written before, so the times exclude page faults. The constant has three
//! different indices, like a triangle.

use divan::{Bencher, black_box, counter::ItemsCount};
use mindeg_core::{Boundary, Triangulation, least_degree_triangulation};
use std::fmt;

fn main() {
    divan::main();
}

/// A triangulation, with the name of its construction and the number of its triangles.
struct Input {
    name: &'static str,
    triangles: u64,
    triangulation: Triangulation,
}

impl fmt::Display for Input {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, {} triangles", self.name, self.triangles)
    }
}

fn inputs() -> Vec<Input> {
    let mut sizes = vec![10_000, 1_000_000];
    if std::env::var_os("MINDEG_BENCH_LARGE").is_some() {
        sizes.push(100_000_000);
    }
    let percent = [
        ("zig-zag", [25, 25, 25, 25]),
        ("dominant side", [97, 1, 1, 1]),
        ("dominant side, runs of 1 and 2", [60, 20, 10, 10]),
        ("corner removal", [40, 30, 20, 10]),
    ];
    let input = |triangles, (name, percent): (&'static str, [u64; 4])| {
        let mut sides = percent.map(|percent| percent * triangles / 100);
        // Two more vertices than triangles, and equal runs for the zig-zag.
        sides[0] += 1;
        sides[2] += 1;
        let boundary = Boundary::new(&sides).expect("four sides within the limit");
        Input { name, triangles, triangulation: least_degree_triangulation(&boundary) }
    };
    sizes.into_iter().flat_map(|size| percent.map(|percent| input(size, percent))).collect()
}

fn buffer(input: &Input) -> Vec<[u32; 3]> {
    // Not zero: the allocator could provide zeroed pages without touching them.
    vec![[1; 3]; input.triangulation.triangle_count() as usize]
}

fn fill_with_constant(out: &mut [[u32; 3]]) {
    out.fill(black_box([1, 2, 3]));
}

#[divan::bench(args = inputs())]
fn constant(bencher: Bencher<'_, '_>, input: &Input) {
    let mut out = buffer(input);
    bencher.counter(ItemsCount::new(input.triangles)).bench_local(|| {
        fill_with_constant(black_box(&mut out));
    });
}

#[divan::bench(args = inputs())]
fn fill_triangles(bencher: Bencher<'_, '_>, input: &Input) {
    let mut out = buffer(input);
    bencher.counter(ItemsCount::new(input.triangles)).bench_local(|| {
        input.triangulation.fill_triangles(0, black_box(&mut out));
    });
}

#[divan::bench(args = inputs())]
fn triangles(bencher: Bencher<'_, '_>, input: &Input) {
    bencher.counter(ItemsCount::new(input.triangles)).bench_local(|| {
        input.triangulation.triangles().for_each(|triangle| {
            black_box(triangle);
        });
    });
}

/// Indices below `count` in an order that no cache predicts.
fn scattered(count: u32) -> impl Iterator<Item = u32> {
    let mut state = 1_u64;
    (0..1000).map(move |_| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (((state >> 32) * u64::from(count)) >> 32) as u32
    })
}

#[divan::bench(args = inputs())]
fn a_thousand_triangles(bencher: Bencher<'_, '_>, input: &Input) {
    let indices: Vec<u32> = scattered(input.triangulation.triangle_count()).collect();
    bencher.counter(ItemsCount::of_iter(&indices)).bench_local(|| {
        for &index in &indices {
            black_box(input.triangulation.triangle(index));
        }
    });
}

#[divan::bench(args = inputs())]
fn a_thousand_degrees(bencher: Bencher<'_, '_>, input: &Input) {
    let vertices: Vec<u32> = scattered(input.triangulation.vertex_count()).collect();
    bencher.counter(ItemsCount::of_iter(&vertices)).bench_local(|| {
        for &vertex in &vertices {
            black_box(input.triangulation.degree(vertex));
        }
    });
}
