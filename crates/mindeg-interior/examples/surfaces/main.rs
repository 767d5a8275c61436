//! Meshes surfaces anew and prints what is reached: models of its own making, or files.
//!
//! `cargo run --release --example surfaces [-- NAME|FILE.obj|FILE.off [SIZE]]`; with SURFACES_OUT set, meshes are written
//! there as OBJ; with SURFACES_KEEP set, samples of features stay; SURFACES_ANGLE is the
//! feature angle in degrees.

mod files;
mod models;

use glam::DVec3;
use mindeg_interior::{RemeshOptions, Remeshed, remesh};
use mindeg_mesh::Progress;
use mindeg_surfaces::{FeatureRules, Surface};
use std::fmt::Write;
use std::time::Instant;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let size = arguments.get(1).and_then(|text| text.parse::<f64>().ok());
    println!(
        "{:<14} {:>7} {:>7} {:>22} {:>4} {:>7} {:>5} {:>8} {:>6} {:>7}",
        "model",
        "input",
        "points",
        "degrees 4- 5 6 7 8+",
        "off",
        "angle",
        "<30",
        "corners",
        "far",
        "s"
    );
    let models = match arguments.first() {
        Some(path) if path.contains('.') => vec![(path.clone(), files::read(path))],
        wanted => {
            let all = models::all().into_iter();
            all.filter(|model| wanted.is_none_or(|name| *name == model.0)).collect()
        }
    };
    for (name, (points, triangles, own)) in models {
        let mut rules = FeatureRules::default();
        if let Some(angle) = std::env::var("SURFACES_ANGLE").ok().and_then(|a| a.parse().ok()) {
            (rules.angle_deg, rules.weak_angle_deg) = (angle, angle);
        }
        let surface = match Surface::new(&points, &triangles, &[], &rules) {
            Ok(surface) => surface,
            Err(error) => {
                println!("{name}: {error}");
                continue;
            }
        };
        let keep = std::env::var_os("SURFACES_KEEP").is_some();
        let options = RemeshOptions {
            size: size.or(own),
            keep_boundary: keep,
            keep_features: keep,
            ..RemeshOptions::default()
        };
        let start = Instant::now();
        match remesh(&surface, &options, Progress::NONE) {
            Ok(mesh) => {
                print(&name, points.len(), &mesh, start.elapsed().as_secs_f64());
                let there = farthest((&mesh.points, &mesh.triangles), (&points, &triangles));
                let back = farthest((&points, &triangles), (&mesh.points, &mesh.triangles));
                println!(
                    "    farthest samples, % of the diagonal: {there:.3} there, {back:.3} back"
                );
            }
            Err(error) => println!("{name}: {error}"),
        }
    }
}

fn print(name: &str, input: usize, mesh: &Remeshed, seconds: f64) {
    let mut edges: Vec<[u32; 2]> = Vec::new();
    let mut small = 0;
    for &[a, b, c] in &mesh.triangles {
        edges.extend([[a, b], [b, c], [c, a]].map(|[a, b]| [a.min(b), a.max(b)]));
        small += usize::from(min_angle([a, b, c].map(|v| mesh.points[v as usize])) < 30.0);
    }
    edges.sort_unstable();
    edges.dedup();
    let mut degrees = vec![0; mesh.points.len()];
    edges.iter().flatten().for_each(|v| degrees[*v as usize] += 1);
    let count = |low: i32, high: i32| degrees.iter().filter(|d| (low..=high).contains(*d)).count();
    let spread =
        format!("{} {} {} {} {}", count(0, 4), count(5, 5), count(6, 6), count(7, 7), count(8, 99));
    let report = &mesh.report;
    let name = name.rsplit('/').next().unwrap_or(name);
    println!(
        "{name:<14} {input:>7} {:>7} {spread:>22} {:>4} {:>7.2} {small:>5} {:>8} {:>6} {seconds:>7.2}",
        mesh.points.len(),
        report.off_degree.len(),
        report.min_angle,
        report.corner_limits.len(),
        report.far_triangles,
    );
    if report.min_angle < 30.0 {
        println!("    {} {:?}", report.min_angle_at, report.corner_limits.first());
    }
    for off in report.off_degree.iter().take(5) {
        println!("    {off:?}");
    }
    if let Some(folder) = std::env::var_os("SURFACES_OUT") {
        let mut text = String::new();
        for p in &mesh.points {
            let _ = writeln!(text, "v {} {} {}", p.x, p.y, p.z);
        }
        for [a, b, c] in &mesh.triangles {
            let _ = writeln!(text, "f {} {} {}", a + 1, b + 1, c + 1);
        }
        let path = std::path::Path::new(&folder).join(format!("{name}.obj"));
        if let Err(error) = std::fs::write(&path, text) {
            println!("{}: {error}", path.display());
        }
    }
}

/// How far samples of a mesh are from another, in percent of the diagonal.
fn farthest(from: (&[DVec3], &[[u32; 3]]), to: (&[DVec3], &[[u32; 3]])) -> f64 {
    let rules = FeatureRules { angle_deg: 180.0, weak_angle_deg: 180.0, ..FeatureRules::default() };
    let Ok(other) = Surface::new(to.0, to.1, &[], &rules) else { return f64::NAN };
    let (low, high) =
        from.0.iter().fold((from.0[0], from.0[0]), |(l, h), p| (l.min(*p), h.max(*p)));
    let distance = |point: DVec3| {
        let feet =
            (0..other.patch_count()).map(|patch| other.nearest(patch, point, None, 0).distance);
        feet.fold(f64::INFINITY, f64::min)
    };
    let samples = from.1.iter().flat_map(|t| {
        let [a, b, c] = t.map(|v| from.0[v as usize]);
        [a, (a + b + c) / 3.0, a.midpoint(b), b.midpoint(c), c.midpoint(a)]
    });
    samples.map(distance).fold(0.0, f64::max) / low.distance(high) * 100.0
}

fn min_angle([a, b, c]: [DVec3; 3]) -> f64 {
    let angle = |a: DVec3, b: DVec3, c: DVec3| {
        libm::atan2((b - a).cross(c - a).length(), (b - a).dot(c - a)).to_degrees()
    };
    angle(a, b, c).min(angle(b, c, a)).min(angle(c, a, b))
}
