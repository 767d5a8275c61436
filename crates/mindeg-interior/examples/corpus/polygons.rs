//! Boundaries to measure on: the project's eight domains and a seeded corpus of convex polygons.

use glam::DVec2;

/// SplitMix64.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// From 0 up to but not 1.
    pub(crate) fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: u32, high: u32) -> u32 {
        low + (self.unit() * f64::from(high - low + 1)) as u32
    }
}

/// The points of a polygon with equal intervals on each side.
pub(crate) fn ring(corners: &[DVec2], intervals: &[u32]) -> Vec<DVec2> {
    let spread = |side: usize, i: u32| f64::from(i) / f64::from(intervals[side]);
    spaced(corners, intervals, &spread)
}

fn spaced(corners: &[DVec2], intervals: &[u32], at: &dyn Fn(usize, u32) -> f64) -> Vec<DVec2> {
    let mut points = Vec::new();
    for (side, count) in intervals.iter().enumerate() {
        let (a, b) = (corners[side], corners[(side + 1) % corners.len()]);
        points.extend((0..*count).map(|i| a + (b - a) * at(side, i)));
    }
    points
}

/// A random convex polygon of 3 to 8 sides on an ellipse, with 3 to 60 intervals on each side.
pub(crate) fn random_polygon(random: &mut Random) -> Vec<DVec2> {
    let sides = random.between(3, 8) as usize;
    let flat = 0.4 + 0.6 * random.unit();
    let corners = loop {
        let mut turns: Vec<f64> = (0..sides).map(|_| random.unit()).collect();
        turns.sort_by(f64::total_cmp);
        let gap = |i: usize| (turns[(i + 1) % sides] - turns[i]).rem_euclid(1.0);
        if (0..sides).all(|i| gap(i) > 0.3 / sides as f64 && gap(i) < 0.45) {
            let at = |turn: &f64| {
                let angle = turn * std::f64::consts::TAU;
                DVec2::new(10.0 * libm::cos(angle), 10.0 * flat * libm::sin(angle))
            };
            break turns.iter().map(at).collect::<Vec<_>>();
        }
    };
    let intervals: Vec<u32> = (0..sides).map(|_| random.between(3, 60)).collect();
    ring(&corners, &intervals)
}

/// A polygon with reflex corners round the origin, 5 to 12 sides, with a square hole.
pub(crate) fn random_star(random: &mut Random) -> [Vec<DVec2>; 2] {
    let sides = random.between(5, 12);
    let corner = |i: u32| {
        let angle = std::f64::consts::TAU * f64::from(i) / f64::from(sides);
        DVec2::new(libm::cos(angle), libm::sin(angle)) * (4.0 + 6.0 * random.unit())
    };
    let corners: Vec<DVec2> = (0..sides).map(corner).collect();
    let intervals: Vec<u32> = (0..sides).map(|_| random.between(6, 40)).collect();
    let hole = [[-1.0, -1.0], [-1.0, 1.0], [1.0, 1.0], [1.0, -1.0]].map(DVec2::from);
    let around: Vec<u32> = (0..4).map(|_| random.between(4, 12)).collect();
    [ring(&corners, &intervals), ring(&hole, &around)]
}

/// Shares of a side with intervals in geometric ratio.
fn geometric(ratio: f64, count: u32) -> Vec<f64> {
    let lengths: Vec<f64> = (0..count).map(|i| ratio.powi(i as i32)).collect();
    shares(&lengths)
}

/// Shares of a side whose intervals shrink (or grow) towards both ends: end over middle is `ratio`.
fn bump(ratio: f64, count: u32) -> Vec<f64> {
    let half = f64::from(count - 1) / 2.0;
    let length = |i: u32| libm::pow(ratio, (f64::from(i) - half).abs() / half);
    shares(&(0..count).map(length).collect::<Vec<_>>())
}

fn shares(lengths: &[f64]) -> Vec<f64> {
    let total: f64 = lengths.iter().sum();
    let mut at = 0.0;
    lengths
        .iter()
        .map(|length| {
            at += length / total;
            at - length / total
        })
        .collect()
}

/// The domains of `assets/domains`, by name.
pub(crate) fn domains() -> Vec<(&'static str, Vec<DVec2>)> {
    let points = |list: &[[f64; 2]]| list.iter().copied().map(DVec2::from).collect::<Vec<_>>();
    let box_of = |w: f64, h: f64| points(&[[0.0, 0.0], [w, 0.0], [w, h], [0.0, h]]);
    let sized = |corners: &[DVec2], size: f64| {
        let count = |i: usize| {
            let length = corners[i].distance(corners[(i + 1) % corners.len()]);
            (length / size - 1e-9).ceil().max(1.0) as u32
        };
        let intervals: Vec<u32> = (0..corners.len()).map(count).collect();
        ring(corners, &intervals)
    };
    let channel = {
        let (out, back) = (geometric(1.25, 16), geometric(0.8, 16));
        let at = |side: usize, i: u32| match side {
            1 => out[i as usize],
            3 => back[i as usize],
            _ => f64::from(i) / 40.0,
        };
        spaced(&box_of(0.4, 0.05), &[40, 16, 40, 16], &at)
    };
    let wing = {
        let rib = bump(0.25, 16);
        let at = |side: usize, i: u32| {
            if side.is_multiple_of(2) { rib[i as usize] } else { f64::from(i) / 20.0 }
        };
        let corners = points(&[[0.0, 0.0], [2.4, 0.0], [2.0, 4.0], [0.9, 4.0]]);
        spaced(&corners, &[16, 20, 16, 20], &at)
    };
    let parcel = points(&[
        [500_012.37, 4_650_008.12],
        [500_058.91, 4_650_003.44],
        [500_071.26, 4_650_031.87],
        [500_044.05, 4_650_052.60],
        [500_008.74, 4_650_037.95],
    ]);
    let hexagon =
        points(&[[0.0, 0.0], [6.0, 0.0], [8.0, 3.0], [6.5, 6.0], [2.0, 7.0], [-1.0, 4.0]]);
    vec![
        ("boundary-layer-channel", channel),
        ("dominated-side", ring(&box_of(100.0, 40.0), &[1000, 3, 5, 2])),
        ("figure-1", ring(&box_of(3.0, 2.0), &[3, 3, 2, 2])),
        ("gusset", sized(&points(&[[0.0, 0.0], [120.0, 0.0], [0.0, 80.0]]), 10.0)),
        ("slender-fin", sized(&box_of(40.0, 0.2), 0.4)),
        ("survey-parcel", sized(&parcel, 2.0)),
        ("unequal-hexagon", ring(&hexagon, &[12, 3, 5, 9, 2, 7])),
        ("wing-panel", wing),
    ]
}
