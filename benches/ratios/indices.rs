//! Filling an index buffer, next to filling it with a constant.
//!
//! The buffer has been written before, so that no page faults are counted. There are two
//! constants: a triangle, which `fill` writes one by one, and a single number, which it writes as
//! fast as memory takes it. With all threads a constant is written by one of them or by all,
//! whichever is faster.

use crate::clock::rounds;
use crate::{CONSTRUCTIONS, rectangle, table};
use mindeg::BoundaryMesh;
use rayon::prelude::*;
use std::cell::RefCell;
use std::hint::black_box;
use std::time::Instant;

pub(crate) fn print() {
    let columns = [
        "triangles",
        "construction",
        "filled, 1 thread",
        "/ constant triangle (aim 2)",
        "/ constant number",
        "filled, all threads",
        "/ constant triangle (aim 1.5)",
        "/ constant number",
        "`triangle(i)`",
    ];
    table::head("Index buffer, ns a triangle, and times as long as a constant", &columns);
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    for count in [10_000, 1_000_000, 100_000_000] {
        let mut buffer = vec![[1; 3]; count as usize];
        for (name, percent) in CONSTRUCTIONS {
            let mesh = BoundaryMesh::least_degree(&rectangle(count, percent)).unwrap();
            one.install(|| mesh.fill_triangles(0, &mut buffer));
            let by_one = checksum(&buffer);
            mesh.fill_triangles(0, &mut buffer);
            assert_eq!(checksum(&buffer), by_one, "threads show");

            let often = (100_000_000 / count as u32).clamp(7, 1000);
            let by_one = one.install(|| times(&mesh, &mut buffer, often));
            let by_all = times(&mesh, &mut buffer, often);
            let each = |seconds: f64| format!("{:.2}", seconds * 1e9 / count as f64);
            table::row(&[
                table::count(count),
                name.to_owned(),
                each(by_one.filled),
                table::at_most(by_one.filled / by_one.triangle, 2.0),
                format!("{:.2}", by_one.filled / by_one.number),
                each(by_all.filled),
                table::at_most(by_all.filled / by_all.triangle.min(by_one.triangle), 1.5),
                format!("{:.2}", by_all.filled / by_all.number.min(by_one.number)),
                format!("{:.0}", at_random(&mesh)),
            ]);
        }
    }
}

/// Seconds for the whole buffer.
struct Times {
    filled: f64,
    triangle: f64,
    number: f64,
}

/// The times with all threads of the current pool.
fn times(mesh: &BoundaryMesh, buffer: &mut [[u32; 3]], often: u32) -> Times {
    let part = buffer.len().div_ceil(rayon::current_num_threads());
    // Each needs the buffer for itself, one at a time.
    let buffer = RefCell::new(buffer);
    let [filled, triangle, number] = rounds(
        often,
        [
            &mut || mesh.fill_triangles(0, black_box(*buffer.borrow_mut())),
            &mut || {
                let constant = black_box([1, 2, 3]);
                let mut buffer = buffer.borrow_mut();
                black_box(&mut **buffer).par_chunks_mut(part).for_each(|part| part.fill(constant));
            },
            &mut || {
                let constant = black_box(1);
                let mut buffer = buffer.borrow_mut();
                let parts = black_box(&mut **buffer).par_chunks_mut(part);
                parts.for_each(|part| part.as_flattened_mut().fill(constant));
            },
        ],
    );
    Times { filled, triangle, number }
}

/// Tells buffers apart.
fn checksum(triangles: &[[u32; 3]]) -> u64 {
    let add = |sum: u64, &id: &u32| sum.wrapping_mul(31).wrapping_add(u64::from(id));
    triangles.as_flattened().iter().fold(0, add)
}

/// Nanoseconds for a triangle by its number, in an order that no cache foresees.
fn at_random(mesh: &BoundaryMesh) -> f64 {
    const CALLS: u32 = 100_000;
    let count = u64::from(mesh.triangle_count());
    let mut state = 1_u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (((state >> 32) * count) >> 32) as u32
    };
    let numbers: Vec<u32> = (0..CALLS).map(|_| next()).collect();
    let best = (0..5).map(|_| {
        let start = Instant::now();
        for &number in &numbers {
            black_box(mesh.triangle(number));
        }
        start.elapsed().as_secs_f64()
    });
    best.fold(f64::INFINITY, f64::min) * 1e9 / f64::from(CALLS)
}
