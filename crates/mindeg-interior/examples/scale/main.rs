//! Measures time against size: squares with equal and with graded intervals, 10^4 to 10^6 triangles.
//!
//! `cargo run --release --example scale [-- equal|graded [TRIANGLES]]`

use glam::DVec2;
use mindeg_interior::{Options, generate};
use mindeg_mesh::planar::PlanarBoundary;
use mindeg_mesh::{Progress, Step};
use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

/// The boundary of the unit square; each side's intervals are `counts`, the first side's towards a corner.
fn square(counts: [u32; 4]) -> Vec<DVec2> {
    let corners = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
    let mut points = Vec::new();
    for (side, count) in counts.into_iter().enumerate() {
        let (a, b) = (corners[side], corners[(side + 1) % 4]);
        points.extend((0..count).map(|i| a + (b - a) * (f64::from(i) / f64::from(count))));
    }
    points
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let wanted = arguments.get(1).and_then(|n| n.parse::<f64>().ok());
    for (name, shape, triangles_of) in
        [("equal", [1.0, 1.0, 1.0, 1.0], 2.31), ("graded", [3.0, 1.0, 1.5, 0.5], 4.1)]
    {
        if arguments.first().is_some_and(|wanted| wanted != name) {
            continue;
        }
        let mut last: Option<(f64, f64)> = None;
        for aim in [1e4, 1e5, 1e6].into_iter().filter(|aim| wanted.is_none_or(|w| w == *aim)) {
            let unit = f64::sqrt(aim / triangles_of);
            let ring = square(shape.map(|s| (s * unit).round() as u32));
            let start = Instant::now();
            let outline = match PlanarBoundary::new(&[&ring]) {
                Ok(outline) => outline,
                Err(error) => return println!("{error}"),
            };
            // When each stage begins.
            let marks = Mutex::new(Vec::<(String, f64)>::new());
            let callback = |step: Step<'_>| {
                let mut marks = marks.lock().unwrap_or_else(PoisonError::into_inner);
                if marks.last().is_none_or(|(stage, _)| stage != step.stage) {
                    marks.push((step.stage.to_owned(), start.elapsed().as_secs_f64()));
                }
                ControlFlow::Continue(())
            };
            let options = Options::default();
            let mesh = generate(&outline, &options, Progress::new(&callback));
            let seconds = start.elapsed().as_secs_f64();
            match mesh {
                Err(error) => println!("{name} {aim}: {error}"),
                Ok(mesh) => {
                    let r = &mesh.report;
                    let count = r.triangles as f64;
                    let exponent =
                        last.map_or(f64::NAN, |(n, s)| (seconds / s).ln() / (count / n).ln());
                    println!(
                        "{name:<7} {:>8} triangles {seconds:>7.3} s, exponent {exponent:.3}, angle {:.3} of {:.3}, {} violations",
                        r.triangles,
                        r.min_angle,
                        r.limits.angle(),
                        r.violations.len(),
                    );
                    println!("{:.3?}", marks.lock().unwrap_or_else(PoisonError::into_inner));
                    last = Some((count, seconds));
                }
            }
        }
    }
}
