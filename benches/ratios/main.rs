//! Compares mindeg's speed with the limits of memory, disks and its libraries.
//!
//! `cargo bench -p mindeg-cli --bench ratios` prints the tables of `benches/results` that are
//! about this; names after `--` pick some of them, such as `-- indices writers`. Everything is
//! measured beside its floor in the same process, in turns, and the best of several rounds
//! counts; see [`rounds`](clock::rounds).
//!
//! Takes 4 GB of memory; 2 GB in `/dev/shm` or, if it is set, in the folder that
//! `MINDEG_BENCH_FOLDER` names; and 13 GB in the target folder.
//!
//! Limits: on a busy machine, work shared among all threads looks worse than it is.

#![expect(clippy::unwrap_used, reason = "a benchmark may panic")]

mod choice;
mod clock;
mod indices;
mod memory;
mod readers;
mod table;
mod writers;

use mindeg::{BoundaryMesh, Domain, Side};

fn main() {
    let parts: [(&str, fn()); 5] = [
        ("indices", indices::print),
        ("choice", choice::print),
        ("writers", writers::print),
        ("memory", memory::print),
        ("readers", readers::print),
    ];
    let named: Vec<String> =
        std::env::args().skip(1).filter(|name| !name.starts_with('-')).collect();
    for (name, print) in parts {
        if named.is_empty() || named.iter().any(|named| named == name) {
            print();
        }
    }
}

/// Sides in per cent of all intervals, for each of the constructions.
const CONSTRUCTIONS: [(&str, [u64; 4]); 4] = [
    ("zig-zag", [25, 25, 25, 25]),
    ("dominant side", [97, 1, 1, 1]),
    ("dominant side, runs of 1 and 2", [60, 20, 10, 10]),
    ("corner removal", [40, 30, 20, 10]),
];

/// A rectangle of 4 by 3 with so many triangles.
fn rectangle(triangles: u64, percent: [u64; 4]) -> Domain {
    let mut sides = percent.map(|percent| percent * triangles / 100);
    // Two more vertices than triangles, and an even zig-zag.
    sides[0] += 1;
    sides[2] += 1;
    Domain::rectangle(4.0, 3.0, sides.map(Side::count).into()).unwrap()
}

fn even(triangles: u64) -> BoundaryMesh {
    BoundaryMesh::least_degree(&rectangle(triangles, [25; 4])).unwrap()
}
