//! Filling an index buffer, next to filling it with a constant.
//!
//! The buffer has been written before, so that no page faults are counted. The constant is three
//! different ids, as a triangle is; with all threads it is written by as few or as many of them
//! as are fastest.

use crate::clock::rounds;
use crate::{CONSTRUCTIONS, rectangle, table};
use mindeg_geometry::Mesh;
use rayon::prelude::*;
use std::cell::RefCell;
use std::hint::black_box;
use std::time::Instant;

pub(crate) fn print() {
    let columns = [
        "triangles",
        "construction",
        "constant, 1 thread",
        "filled",
        "ratio (aim 2)",
        "constant, all threads",
        "filled",
        "ratio (aim 1.5)",
        "`triangle(i)`",
    ];
    table::head("Index buffer, ns a triangle", &columns);
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    for count in [10_000, 1_000_000, 100_000_000] {
        let mut buffer = vec![[1; 3]; count as usize];
        for (name, percent) in CONSTRUCTIONS {
            let mesh = Mesh::least_degree(&rectangle(count, percent)).unwrap();
            one.install(|| mesh.fill_triangles(0, &mut buffer));
            let by_one = checksum(&buffer);
            mesh.fill_triangles(0, &mut buffer);
            assert_eq!(checksum(&buffer), by_one, "threads show");

            let often = (100_000_000 / count as u32).clamp(7, 1000);
            let parts = count.div_ceil(rayon::current_num_threads() as u64) as usize;
            // Each needs the buffer for itself, one at a time.
            let [constant, filled] = one.install(|| {
                let buffer = RefCell::new(&mut buffer[..]);
                rounds(
                    often,
                    [
                        &mut || black_box(&mut *buffer.borrow_mut()).fill(black_box([1, 2, 3])),
                        &mut || mesh.fill_triangles(0, black_box(*buffer.borrow_mut())),
                    ],
                )
            });
            let buffer = RefCell::new(&mut buffer[..]);
            let [constant_by_parts, filled_by_all] = rounds(
                often,
                [
                    &mut || {
                        let constant = black_box([1, 2, 3]);
                        let mut buffer = buffer.borrow_mut();
                        let parts = black_box(&mut **buffer).par_chunks_mut(parts);
                        parts.for_each(|part| part.fill(constant));
                    },
                    &mut || mesh.fill_triangles(0, black_box(*buffer.borrow_mut())),
                ],
            );
            let constant_by_all = constant.min(constant_by_parts);
            let each = |seconds: f64| format!("{:.2}", seconds * 1e9 / count as f64);
            table::row(&[
                table::count(count),
                name.to_owned(),
                each(constant),
                each(filled),
                table::at_most(filled / constant, 2.0),
                each(constant_by_all),
                each(filled_by_all),
                table::at_most(filled_by_all / constant_by_all, 1.5),
                format!("{:.0}", at_random(&mesh)),
            ]);
        }
    }
}

/// Tells buffers apart.
fn checksum(triangles: &[[u32; 3]]) -> u64 {
    let add = |sum: u64, &id: &u32| sum.wrapping_mul(31).wrapping_add(u64::from(id));
    triangles.as_flattened().iter().fold(0, add)
}

/// Nanoseconds for a triangle by its number, in an order that no cache foresees.
fn at_random(mesh: &Mesh) -> f64 {
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
