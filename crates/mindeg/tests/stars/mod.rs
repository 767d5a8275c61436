//! Star-shaped outlines with star-shaped holes, by chance: the hard domains of the search with holes.

use glam::DVec2;
use mindeg_mesh::Random;
use mindeg_mesh::planar::PlanarBoundary;

/// The share of the points that holes have, as a divisor, and how much radii differ: one of each for a seed.
const SHARES: [u32; 3] = [2, 5, 3];
const ROUGHNESS: [f64; 4] = [0.05, 0.2, 0.35, 0.5];

/// A domain of `points` in all, with some `holes` of equally many points.
pub(crate) fn star(points: u32, holes: u32, seed: u64) -> PlanarBoundary {
    let mut random =
        Random::new(seed.wrapping_mul(1_000_003) ^ (u64::from(points) << 20) ^ u64::from(holes));
    let of_hole = (points / SHARES[(seed / 2 % 3) as usize] / holes).max(3);
    let roughness = ROUGHNESS[(seed % 4) as usize];
    let size = 45.0 / (f64::from(holes) + 1.0).sqrt();
    loop {
        let outer = ring(&mut random, DVec2::ZERO, 100.0, points - of_hole * holes, roughness);
        let mut rings = vec![outer];
        // A hole that touches another ring is drawn again, elsewhere.
        for _ in 0..2000 {
            if rings.len() > holes as usize {
                break;
            }
            let center = DVec2::new(random.unit(), random.unit()) * 160.0 - DVec2::splat(80.0);
            let radius = size * (0.5 + random.unit());
            let mut hole = ring(&mut random, center, radius, of_hole, roughness);
            hole.reverse();
            rings.push(hole);
            if PlanarBoundary::new(&rings).is_err() {
                rings.pop();
            }
        }
        if rings.len() > holes as usize
            && let Ok(boundary) = PlanarBoundary::new(&rings)
        {
            return boundary;
        }
    }
}

fn ring(
    random: &mut Random,
    center: DVec2,
    radius: f64,
    points: u32,
    roughness: f64,
) -> Vec<DVec2> {
    let at = |point: u32| {
        let angle = (f64::from(point) + 0.5 * random.unit()) / f64::from(points);
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * angle);
        let length = radius * (1.0 - roughness + 2.0 * roughness * random.unit());
        center + DVec2::new(cos, sin) * length
    };
    (0..points).map(at).collect()
}
