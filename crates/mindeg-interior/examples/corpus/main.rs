//! Measures the pipeline on the project's domains, on 200 seeded random convex polygons (`corpus`), and on 60 with reflex
//! corners and a hole (`star`).
//!
//! `cargo run --release --example corpus [-- --prefer-angle] [-- PART…]`: names or numbers of boundaries, all by default.

mod polygons;

use glam::DVec2;
use mindeg_interior::{Options, Prefer, generate};
use mindeg_mesh::Progress;
use mindeg_mesh::planar::PlanarBoundary;
use polygons::{Random, domains, random_polygon, random_star};
use std::time::Instant;

fn main() {
    let mut wanted: Vec<String> = std::env::args().skip(1).collect();
    let mut options = Options::default();
    if let Some(at) = wanted.iter().position(|w| w == "--prefer-angle") {
        wanted.remove(at);
        options.wanted.prefer = Some(Prefer::Angle);
    }
    let mut random = Random(12);
    let mut all: Vec<(String, Vec<Vec<DVec2>>)> =
        domains().into_iter().map(|(name, ring)| (name.to_owned(), vec![ring])).collect();
    all.extend((0..200).map(|i| (format!("corpus-{i:03}"), vec![random_polygon(&mut random)])));
    all.extend((0..60).map(|i| (format!("star-{i:03}"), random_star(&mut random).to_vec())));
    all.retain(|(name, _)| wanted.is_empty() || wanted.iter().any(|w| name.contains(w.as_str())));
    let (mut shares, mut clean, mut triangles, mut failed) = (Vec::new(), 0, 0, 0);
    let (mut good, mut allow, mut thirty) = (0, 0, 0);
    let start = Instant::now();
    println!(
        "{:<24} {:>5} {:>7} {:>7} {:>6} {:>6} {:>5} {:>3} {:>3} {:>7} {:>6} {:>6}",
        "name", "n", "limit", "angle", "share", "degree", "bound", "bad", "", "triang", "p99", "s"
    );
    for (name, rings) in &all {
        let begin = Instant::now();
        let result = PlanarBoundary::new(rings)
            .map_err(Into::into)
            .and_then(|outline| generate(&outline, &options, Progress::NONE));
        let mesh = match result {
            Ok(mesh) => mesh,
            Err(error) => {
                println!("{name:<24} FAILED: {error}");
                failed += 1;
                continue;
            }
        };
        let ring = rings.concat();
        assert_eq!(mesh.points[..ring.len()], ring[..]);
        let r = &mesh.report;
        let share = r.min_angle / r.limits.angle().min(35.0);
        shares.push(share.min(1.0));
        clean += usize::from(r.violations.is_empty());
        good += usize::from(share >= 0.95);
        if r.limits.angle() >= 30.0 {
            allow += 1;
            thirty += usize::from(r.min_angle >= 30.0);
        }
        triangles += r.triangles;
        println!(
            "{name:<24} {:>5} {:>7.3} {:>7.3} {share:>6.3} {:>6} {:>5} {:>3} {:>3} {:>7} {:>6.3} {:>6.3}",
            ring.len(),
            r.limits.angle(),
            r.min_angle,
            r.interior_degree.as_ref().map_or("-".into(), |d| format!(
                "{}..{}",
                d.start(),
                d.end()
            )),
            r.boundary_degree.end(),
            r.violations.len(),
            "",
            r.triangles,
            r.grading_p99,
            begin.elapsed().as_secs_f64(),
        );
    }
    shares.sort_by(f64::total_cmp);
    let mean = shares.iter().sum::<f64>() / shares.len() as f64;
    println!(
        "{} meshes, {failed} failed, {clean} without violation; share of min(limit, 35): mean {mean:.4}, worst {:.3}, 5th percentile {:.3}, {good} at 0.95 or more; 30 degrees on {thirty} of {allow}; {triangles} triangles in {:.2} s",
        shares.len(),
        shares.first().copied().unwrap_or(0.0),
        shares.get(shares.len() / 20).copied().unwrap_or(0.0),
        start.elapsed().as_secs_f64(),
    );
}
