//! mindeg against Delaunay on many domains: what theory says must hold on each.

use glam::DVec2;
use mindeg::{Domain, Side, Spacing};
use mindeg_compare::DefectKind;
use mindeg_compare::{CompareOptions, Comparison, compare};
use std::thread;

/// How far an angle in degrees may be off: the cross and dot products of two edges have
/// rounding errors of at most two units each relative to the product of the lengths, and the
/// arc tangent and the conversion to degrees one each; for the two angles compared, twice that.
const ROUNDING: f64 = 12.0 * f64::EPSILON * 180.0 / std::f64::consts::PI;

/// Each is meshed with points inside, too, which takes most of the time.
const DOMAINS: usize = 24;
/// With `MINDEG_FULL`, which takes a minute.
const ALL_DOMAINS: usize = 400;

/// SplitMix64 (Steele, Lea and Flood, 2014): the same domains on every machine and in every
/// version of everything.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, bound: u64) -> u64 {
        self.next() % bound
    }

    /// In [0, 1).
    fn share(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.share()
    }
}

/// Every law in turn, mild to strong.
fn spacing(random: &mut Random, law: u64, intervals: u64) -> Spacing {
    // Over the whole side lengths change by up to a hundredfold.
    let ratio = libm::pow(100.0, random.between(-1.0, 1.0) / intervals as f64);
    match law % 7 {
        // A single interval leaves no choice of length.
        4 | 5 if intervals == 1 => Spacing::Uniform,
        0 => Spacing::Uniform,
        1 => Spacing::Geometric { ratio },
        2 => Spacing::Bump { ratio: random.between(0.1, 10.0) },
        3 => Spacing::Beta { beta: 1.0 + random.between(0.01, 1.0) },
        4 => Spacing::FirstLength(random.between(0.1, 1.0) / intervals as f64),
        5 => Spacing::LastLength(random.between(0.1, 1.0) / intervals as f64),
        _ => {
            let mut parameters: Vec<f64> = (1..intervals)
                .map(|i| (i as f64 + random.between(-0.4, 0.4)) / intervals as f64)
                .collect();
            parameters.sort_by(f64::total_cmp);
            Spacing::Parameters(parameters)
        }
    }
}

/// A polygon inscribed in an ellipse that is turned, moved and scaled.
fn domain(random: &mut Random, law: &mut u64) -> Option<Domain> {
    let sides = 3 + random.below(6) as usize;
    let gaps: Vec<f64> = (0..sides).map(|_| random.between(0.1, 1.0)).collect();
    let turn = std::f64::consts::TAU / gaps.iter().sum::<f64>();
    let axes = DVec2::new(1.0, random.between(0.05, 1.0));
    let tilt = random.between(0.0, std::f64::consts::TAU);
    let size = libm::exp2(random.between(-20.0, 20.0));
    let center = match random.below(3) {
        0 => DVec2::ZERO,
        1 => size * DVec2::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0)),
        _ => size * DVec2::new(5_000.0, 46_500.0),
    };
    let unit = |angle: f64| DVec2::new(libm::cos(angle), libm::sin(angle));
    let mut angle = 0.0;
    let corners = gaps.iter().map(|gap| {
        angle += turn * gap;
        center + size * (axes * unit(angle)).rotate(unit(tilt))
    });
    let corners: Vec<DVec2> = corners.collect();
    let most = [4, 12, 40][random.below(3) as usize];
    let dense = random.below(4 * sides as u64);
    let sides = (0..sides).map(|side| {
        *law += 1;
        let scale = if side as u64 == dense { 10 } else { 1 };
        let intervals = 1 + random.below(most * scale);
        let length = corners[(side + 1) % corners.len()].distance(corners[side]);
        let spacing = match spacing(random, *law, intervals) {
            Spacing::FirstLength(share) => Spacing::FirstLength(share * length),
            Spacing::LastLength(share) => Spacing::LastLength(share * length),
            other => other,
        };
        Side::count(intervals).spaced(spacing)
    });
    let sides = sides.collect();
    Domain::polygon(corners, sides).ok()
}

fn check(comparison: &Comparison, name: &str) {
    let methods = &comparison.report().methods;
    let [mindeg, delaunay] = [&methods[0], &methods[1]];
    assert!(mindeg.valid && delaunay.valid, "{name}: {:?}", delaunay.defects);
    for method in methods {
        assert_eq!(method.valid, method.defects.is_empty(), "{name}: {}", method.method);
    }
    // Degrees and angles have bounds on the same points; a mesh with points inside can be better.
    let points = comparison.points(mindeg.method);
    let same_points = methods.iter().filter(|method| comparison.points(method.method) == points);
    for method in same_points.filter(|method| method.valid) {
        assert!(mindeg.max_degree <= method.max_degree, "{name}: {}", method.method);
        let (smallest, limit) = (method.min_angle.unwrap(), delaunay.min_angle.unwrap());
        assert!(
            smallest <= limit + ROUNDING,
            "{name}: {} has {smallest}, above {limit}",
            method.method
        );
    }
}

fn check_one(domain: &Domain) {
    let options = CompareOptions { exact_vertices: 40, ..CompareOptions::default() };
    check(&compare(domain, &options).unwrap(), &format!("{domain:?}"));
}

#[test]
fn random_domains() {
    let count = if std::env::var_os("MINDEG_FULL").is_some() { ALL_DOMAINS } else { DOMAINS };
    let mut random = Random(2005);
    let mut law = 0;
    let (mut domains, mut refused) = (Vec::new(), 0);
    while domains.len() < count {
        match domain(&mut random, &mut law) {
            Some(domain) => domains.push(domain),
            None => refused += 1,
        }
    }
    assert!(refused <= count / 20, "{refused} refused");
    // One comparison has little to share among threads.
    thread::scope(|scope| {
        for some in domains.chunks(count / 4) {
            scope.spawn(move || some.iter().for_each(check_one));
        }
    });
}

#[test]
fn the_domains_that_come_with_the_program() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/domains");
    let mut names: Vec<_> =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    names.sort();
    assert!(!names.is_empty());
    for name in names {
        let domain = Domain::from_json(&std::fs::read_to_string(&name).unwrap()).unwrap();
        // Comparisons take convex domains with straight sides.
        if domain.convex().is_none_or(|form| form.boundary().side_count() != domain.sides().len()) {
            continue;
        }
        check(
            &compare(&domain, &CompareOptions { exact_vertices: 40, ..CompareOptions::default() })
                .unwrap(),
            &name.display().to_string(),
        );
    }
}

/// Intervals down to 1e-11 of the side's length: rounded, three points of the slanted side bulge
/// so much that the flat triangle on them is Delaunay's.
#[test]
fn flat_triangles_are_counted_and_left() {
    let corners = [[0.0, 0.0], [3.0, 1.0], [1.0, 2.0]].map(DVec2::from).to_vec();
    let graded = Side::count(94).spaced(Spacing::Geometric { ratio: 1.0 / 1.3 });
    let domain = Domain::polygon(corners, vec![graded, Side::count(9), Side::count(9)]).unwrap();
    // Points inside would take most of the time, and decide nothing here.
    let time_limit = std::time::Duration::from_millis(500);
    let options = CompareOptions { exact_vertices: 40, time_limit, ..CompareOptions::default() };
    let comparison = compare(&domain, &options).unwrap();
    let (delaunay, triangles) = comparison.methods().nth(1).unwrap();
    let flat = triangles
        .iter()
        .filter(|&&triangle| domain.convex().unwrap().boundary().is_flat(triangle))
        .count();
    assert!(flat > 0 && !delaunay.valid);
    assert_eq!(delaunay.defects[0].kind, DefectKind::FlatTriangles);
    assert_eq!(delaunay.defects[0].count, Some(flat as u64));
    assert!(comparison.report().verdict.starts_with("There is no Delaunay triangulation"));
}
