//! From counts to the plan chosen, and what else looks at every triangle.
//!
//! Beside it, for scale: the points of all vertices one by one as a user gets them, written to
//! memory that was written before, with one thread.

use crate::clock::rounds;
use crate::{CONSTRUCTIONS, rectangle, table};
use mindeg::{BoundaryMesh, Domain, Side, Spacing};
use std::hint::black_box;

pub(crate) fn print() {
    let columns = [
        "10⁷ vertices",
        "plan, 1 thread",
        "plan, all threads",
        "speed-up",
        "angles",
        "`points()`, 1 thread",
    ];
    table::head("From counts to the plan chosen, ms (aim: all threads below 800)", &columns);
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let even =
        CONSTRUCTIONS.map(|(name, percent)| (name.to_owned(), rectangle(10_000_000, percent)));
    let laws = [
        ("zig-zag, bump", Spacing::Bump { ratio: 0.3 }),
        ("zig-zag, geometric", Spacing::Geometric { ratio: 1.000_000_1 }),
        ("zig-zag, beta", Spacing::Beta { beta: 1.2 }),
    ];
    let graded = laws.map(|(name, spacing)| {
        let side = || Side::count(2_500_000).spaced(spacing.clone());
        let sides = (0..4).map(|_| side()).collect();
        (name.to_owned(), Domain::rectangle(4.0, 3.0, sides).unwrap())
    });
    for (name, domain) in even.into_iter().chain(graded) {
        let mesh = BoundaryMesh::least_degree(&domain).unwrap();
        let mut points = Vec::with_capacity(mesh.vertex_count() as usize);
        let [with_one, with_all, angles, all_points] = rounds(
            3,
            [
                &mut || drop(black_box(one.install(|| BoundaryMesh::least_degree(&domain)))),
                &mut || drop(black_box(BoundaryMesh::least_degree(&domain))),
                &mut || {
                    black_box(mesh.angle_range());
                },
                &mut || {
                    points.clear();
                    points.extend(black_box(&domain).placement().points());
                },
            ],
        );
        let ms = |seconds: f64| format!("{:.0}", seconds * 1e3);
        table::row(&[
            name,
            ms(with_one),
            table::marked(ms(with_all), with_all < 0.8),
            format!("{:.1}", with_one / with_all),
            ms(angles),
            ms(all_points),
        ]);
    }
}
