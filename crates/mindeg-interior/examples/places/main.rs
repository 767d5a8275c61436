//! Measures meshes with interior points of the domains in folders: violations, shares of limits, quality, time.
//!
//! `cargo run --release -p mindeg-interior --example places -- [-q] FOLDER_OR_FILE…`: `-q` leaves out the line of each
//! domain. `benches/peers/interior/outlines.py FOLDER` writes folders of domains to measure on.

use mindeg_domain::Domain;
use mindeg_interior::{Generated, Interior, InteriorError, Options, generate};
use mindeg_mesh::Progress;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Angles up to this one count, in degrees.
const ENOUGH: f64 = 35.0;

/// The sums over domains.
#[derive(Default)]
struct Sums {
    domains: usize,
    failed: usize,
    clean: usize,
    good: usize,
    violations: usize,
    shares: Vec<f64>,
    low: usize,
    triangles: usize,
    eta: f64,
    seconds: f64,
}

fn main() {
    let mut paths: Vec<String> = std::env::args().skip(1).collect();
    let is_quiet = paths.first().is_some_and(|first| first == "-q");
    if is_quiet {
        paths.remove(0);
    }
    for path in paths {
        let mut files = files(Path::new(&path));
        files.sort();
        let mut sums = Sums::default();
        for file in files {
            let name = file.file_stem().map_or_else(String::new, |s| s.to_string_lossy().into());
            let start = clock();
            let found = mesh(&file);
            let seconds = clock() - start;
            match found {
                Ok(Some((mesh, boundary))) => {
                    let line = sums.add(&mesh, boundary, seconds);
                    if !is_quiet {
                        println!("{name:<32} {line}");
                    }
                }
                Ok(None) => {}
                Err(error) => {
                    sums.failed += 1;
                    println!("{name:<32} FAILED: {error}");
                }
            }
        }
        sums.print(&path);
    }
}

fn files(path: &Path) -> Vec<PathBuf> {
    let Ok(entries) = std::fs::read_dir(path) else { return vec![path.to_owned()] };
    let files = entries.filter_map(|entry| entry.ok().map(|entry| entry.path()));
    files.filter(|file| file.extension().is_some_and(|end| end == "json")).collect()
}

/// The processor's seconds of this process's first thread, or the clock's where these are not told.
fn clock() -> f64 {
    static START: std::sync::OnceLock<Instant> = std::sync::OnceLock::new();
    let start = *START.get_or_init(Instant::now);
    let told = std::fs::read_to_string("/proc/self/schedstat").ok();
    let nanoseconds = told.and_then(|text| text.split(' ').next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| start.elapsed().as_secs_f64(), |n| n * 1e-9)
}

/// The mesh of a domain and its number of boundary points; none for a file without a domain.
fn mesh(file: &Path) -> Result<Option<(Generated, usize)>, InteriorError> {
    let Ok(text) = std::fs::read_to_string(file) else { return Ok(None) };
    let Ok(domain) = Domain::from_json(&text) else { return Ok(None) };
    let outline = domain.boundary()?;
    let wanted = domain.interior().cloned().unwrap_or_else(Interior::default);
    let mut options = Options::from(wanted);
    options.divisible = domain.divisible_segments();
    for vertex in 0..domain.rings().vertex_count() {
        if let Some(limit) = domain.degree_limit(vertex) {
            let limit = limit.saturating_sub(domain.external_degree(vertex)).max(2);
            options.degree_limits.insert(vertex, limit);
        }
    }
    let mesh = generate(&outline, &options, Progress::NONE)?;
    Ok(Some((mesh, outline.points().len())))
}

impl Sums {
    fn add(&mut self, mesh: &Generated, boundary: usize, seconds: f64) -> String {
        let r = &mesh.report;
        let share = (r.min_angle / r.angle_limit.min(ENOUGH)).min(1.0);
        let low = r.local.below;
        let eta: f64 = mesh
            .triangles
            .iter()
            .map(|t| {
                let [a, b, c] = t.map(|v| mesh.points[v as usize]);
                let sum = a.distance_squared(b) + b.distance_squared(c) + c.distance_squared(a);
                2.0 * 3_f64.sqrt() * (b - a).perp_dot(c - a) / sum
            })
            .sum::<f64>()
            / r.triangles as f64;
        self.domains += 1;
        self.clean += usize::from(r.violations.is_empty());
        self.good += usize::from(share >= 0.98);
        self.violations += r.violations.len();
        self.shares.push(share);
        self.low += low;
        self.triangles += r.triangles;
        self.eta += eta;
        self.seconds += seconds;
        format!(
            "n {boundary:>5} limit {:>7.3} angle {:>7.3} share {share:.3} viol {:>3} low {low:>4} worst {:.2} p1 {:.3} tri {:>7} eta {eta:.4} s {seconds:.3}",
            r.angle_limit,
            r.min_angle,
            r.violations.len(),
            r.local.worst,
            r.local.percentile,
            r.triangles,
        )
    }

    fn print(mut self, path: &str) {
        self.shares.sort_by(f64::total_cmp);
        let count = self.domains.max(1) as f64;
        println!(
            "{path}: {} domains, {} failed, {} clean, {} at 0.98; violations {}, share mean {:.4} worst {:.3}, low {}, triangles {}, eta {:.4}, CPU {:.2} s",
            self.domains,
            self.failed,
            self.clean,
            self.good,
            self.violations,
            self.shares.iter().sum::<f64>() / count,
            self.shares.first().copied().unwrap_or(0.0),
            self.low,
            self.triangles,
            self.eta / count,
            self.seconds,
        );
    }
}
