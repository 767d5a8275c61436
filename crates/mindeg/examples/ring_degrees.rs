//! The least maximum degree of rings of points, each in a text file with a line "x y" for each point,
//! as `benches/outlines/rings.py` writes them; with the time and what proves the answer.
//!
//! `cargo run --release -p mindeg --example ring_degrees -- target/outlines/*.txt`

use mindeg::Progress;
use mindeg::exact::degree_of_boundary;
use mindeg::exact::{DegreeBound, LowerBound, Reached};
use mindeg::glam::DVec2;
use mindeg_mesh::planar::PlanarBoundary;
use std::error::Error;
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    for path in std::env::args().skip(1) {
        let text = std::fs::read_to_string(&path)?;
        let mut points = Vec::new();
        for line in text.lines() {
            let (x, y) = line.split_once(' ').ok_or("a line is not \"x y\"")?;
            points.push(DVec2::new(x.parse()?, y.parse()?));
        }
        let count = points.len();
        let start = Instant::now();
        let boundary = PlanarBoundary::new(&[points])?;
        match degree_of_boundary(&boundary, mindeg_exact::MAX_TRIPLES, Progress::NONE) {
            Ok(answer) => println!(
                "{path}: {count} points, degree {} ({}), at least {} ({}), {:.2} s",
                answer.reached,
                match answer.reached_by {
                    Reached::ZigZag(_) => "zig-zag",
                    Reached::Windows => "windows",
                    _ => "search",
                },
                answer.at_least,
                match answer.bounded_by {
                    DegreeBound::Map { .. } => "joint",
                    DegreeBound::Polygon(LowerBound::BlockedZigZags(_)) => "blocked zig-zags",
                    DegreeBound::Polygon(LowerBound::Apexes(_)) => "apexes",
                    DegreeBound::Polygon(LowerBound::Counting) => "counting",
                    _ => "search",
                },
                start.elapsed().as_secs_f64()
            ),
            Err(error) => println!("{path}: {count} points: {error}"),
        }
    }
    Ok(())
}
