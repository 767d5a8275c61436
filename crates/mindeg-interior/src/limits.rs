//! Limits of the minimum angle at a fixed boundary, whatever the interior points.
//!
//! # Fan limit
//!
//! At a boundary vertex of interior angle t, the boundary edges have lengths l <= L. Let k
//! triangles meet there, all with angles of at least a. In a triangle whose angle at the vertex is s,
//! the angle at the end of the longer spoke is at least a, so by the law of sines the spokes'
//! ratio is at most sin(s + a) / sin(a). The ratios multiply to at least L / l. log sin(s + a) is
//! concave in s, so their product is greatest for equal s = t / k. Hence
//! (sin(t/k + a) / sin a)^k >= L / l and a <= t / k. Solved for a, the limit is the
//! minimum angle of the triangle with sides 1 and q = (L / l)^(1/k) that enclose t / k: atan2(sin(t/k),
//! q - cos(t/k)), or t / k. The fan limit is the greatest of these over the allowed k. Nothing here
//! asks for a convex corner, so it holds at reflex corners and on holes, too.
//!
//! # Tent limit
//!
//! Edges that face each other limit angles too: see [`TentLimit`].
//!
//! Lines and points inside have limits of their own, which are left out here: the limits stay true,
//! but are less tight.

pub use crate::tents::{TentLimit, tent_limit, tents_below};

use mindeg_mesh::planar::PlanarBoundary;
use std::f64::consts::PI;

/// The limit at one boundary vertex.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FanLimit {
    /// No mesh has a greater minimum angle, in degrees.
    pub angle: f64,
    /// The boundary vertex that decides.
    pub vertex: u32,
}

/// Proven upper bounds of the minimum angle of any mesh with this boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// With any number of triangles at a boundary vertex.
    pub any_degree: FanLimit,
    /// With the boundary vertices' degree limits.
    pub with_degree_limit: FanLimit,
    /// From edges that face each other, where that is below both fan limits.
    pub tent: Option<TentLimit>,
}

impl Limits {
    /// The limit for any mesh whose boundary vertices keep their degree limits, in degrees.
    #[must_use]
    pub fn angle(&self) -> f64 {
        self.tent.map_or(f64::INFINITY, |tent| tent.angle).min(self.with_degree_limit.angle)
    }

    /// The limit for any mesh at all, in degrees.
    #[must_use]
    pub fn angle_at_any_degree(&self) -> f64 {
        self.tent.map_or(f64::INFINITY, |tent| tent.angle).min(self.any_degree.angle)
    }

    /// The boundary vertex that decides [`Limits::angle`]: of a tent, the first edge's first vertex.
    #[must_use]
    pub fn vertex(&self) -> u32 {
        self.decides(self.with_degree_limit)
    }

    /// The boundary vertex that decides [`Limits::angle_at_any_degree`].
    #[must_use]
    pub fn vertex_at_any_degree(&self) -> u32 {
        self.decides(self.any_degree)
    }

    fn decides(&self, fan: FanLimit) -> u32 {
        match self.tent {
            Some(tent) if tent.angle < fan.angle => tent.edges[0],
            _ => fan.vertex,
        }
    }
}

/// The degree limit of a boundary vertex in edges: `edges`, or at a reflex corner
/// 2 + round(angle / 60 degrees) where that is more. `angle` is in radians.
///
/// ```
/// # use mindeg_interior::limits::degree_limit;
/// assert_eq!(degree_limit(90_f64.to_radians(), 5), 5);
/// assert_eq!(degree_limit(300_f64.to_radians(), 5), 7);
/// ```
#[must_use]
pub fn degree_limit(angle: f64, edges: u32) -> u32 {
    // A hair beyond straight is a rounded point of a straight side.
    if angle > PI * (1.0 + 1e-9) {
        // Added: 270 degrees, rounded either way, are 4.5 times 60 and round up.
        edges.max(2 + libm::round(angle / (PI / 3.0) + 1e-9) as u32)
    } else {
        edges
    }
}

/// The fan limit in degrees of a boundary vertex between edges of lengths `short` and `long`
/// that enclose `angle` radians, with at most `max_triangles` triangles (any number if `None`).
///
/// O(number of triangles tried), about 60 at most.
///
/// ```
/// # use mindeg_interior::limits::fan_limit;
/// // A right angle between edges of one length: two triangles of 45 degrees, or one.
/// let limit = fan_limit(90_f64.to_radians(), 1.0, 1.0, None);
/// assert!((limit - 45.0).abs() < 1e-9);
/// ```
#[must_use]
pub fn fan_limit(angle: f64, short: f64, long: f64, max_triangles: Option<u32>) -> f64 {
    fan_limit_from(1, angle, [short, long], max_triangles)
}

/// [`fan_limit`] with at least so many triangles.
#[must_use]
pub fn fan_limit_from(
    least: u32,
    angle: f64,
    [short, long]: [f64; 2],
    max_triangles: Option<u32>,
) -> f64 {
    let ratio = (long / short).max(short / long);
    let log_ratio = libm::log(ratio);
    let mut best = 0.0_f64;
    for triangles in least..=max_triangles.unwrap_or(u32::MAX) {
        let share = angle / f64::from(triangles);
        if share <= best {
            break;
        }
        if share < PI {
            let spokes = libm::exp(log_ratio / f64::from(triangles));
            let (sine, cosine) = (libm::sin(share), libm::cos(share));
            best = best.max(share.min(libm::atan2(sine, spokes - cosine)));
        }
    }
    best * (180.0 / PI)
}

/// The fan limit in degrees at a vertex of an outline, with at least so many triangles.
pub(crate) fn fan_limit_at(
    outline: &PlanarBoundary,
    vertex: u32,
    least: u32,
    max_triangles: Option<u32>,
) -> f64 {
    let lengths = [outline.length(vertex), outline.length(outline.previous(vertex))];
    fan_limit_from(least, outline.angle(vertex), lengths, max_triangles)
}

/// The limits of a whole outline, if each boundary vertex has at least so many triangles, and at most the edges that
/// `degree_limit` gives it.
///
/// O(n log n) where edges are short beside the domain.
#[must_use]
pub fn limits(
    outline: &PlanarBoundary,
    triangles: u32,
    degree_limit: impl Fn(u32) -> u32,
) -> Limits {
    let least = |max_triangles: &dyn Fn(u32) -> Option<u32>| {
        let mut least = FanLimit { angle: f64::INFINITY, vertex: 0 };
        for vertex in 0..outline.vertex_count() {
            let angle = fan_limit_at(outline, vertex, triangles, max_triangles(vertex));
            if angle < least.angle {
                least = FanLimit { angle, vertex };
            }
        }
        least
    };
    let any_degree = least(&|_| None);
    let with_degree_limit = least(&|v| Some((degree_limit(v).max(2) - 1).max(triangles)));
    let tent = tent_limit(outline, any_degree.angle.max(with_degree_limit.angle));
    Limits { any_degree, with_degree_limit, tent }
}

/// The star limit in degrees: the greatest minimum angle of so many triangles in sectors that edges keep apart, each given by its angle in
/// radians and the lengths of its edges; 0 with fewer triangles than sectors.
///
/// ```
/// # use mindeg_interior::limits::star_limit;
/// // Three sectors of 120 degrees: two triangles each, and of the seventh nothing is gained.
/// let sector = (120_f64.to_radians(), [1.0, 1.0]);
/// assert!((star_limit(&[sector; 3], 7) - 60.0).abs() < 1e-9);
/// assert!((star_limit(&[sector; 3], 5) - 30.0).abs() < 1e-9);
/// assert_eq!(star_limit(&[sector; 3], 2), 0.0);
/// ```
#[must_use]
pub fn star_limit(sectors: &[(f64, [f64; 2])], triangles: u32) -> f64 {
    let fan = |i: usize, most: u32| {
        let (angle, [short, long]) = sectors[i];
        fan_limit(angle, short, long, Some(most))
    };
    let Some(counts) = shared_out(sectors.len(), triangles, fan) else { return 0.0 };
    counts.into_iter().enumerate().map(|(i, count)| fan(i, count)).fold(60.0, f64::min)
}

/// How so many sectors share so many triangles, so that the least limit, which `limit` tells of a sector, is greatest; `None` where there are
/// more sectors.
///
/// A fan limit never falls if more triangles are allowed: each goes where the limit is least.
pub(crate) fn shared_out(
    sectors: usize,
    triangles: u32,
    limit: impl Fn(usize, u32) -> f64,
) -> Option<Vec<u32>> {
    let mut counts = vec![1; sectors];
    let mut limits: Vec<f64> = (0..sectors).map(|i| limit(i, 1)).collect();
    for _ in 0..triangles.checked_sub(sectors as u32)? {
        let least = (0..sectors).min_by(|a, b| limits[*a].total_cmp(&limits[*b]));
        least.into_iter().for_each(|i| {
            counts[i] += 1;
            limits[i] = limit(i, counts[i]);
        });
    }
    Some(counts)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples;
    use glam::DVec2;
    use proptest::prelude::*;

    /// The greatest minimum angle of a fan by bisection on the condition of the proof.
    fn fan_by_bisection(angle: f64, ratio: f64, triangles: u32) -> f64 {
        let share = angle / f64::from(triangles);
        let holds = |a: f64| {
            a <= share
                && share + a < PI
                && (libm::sin(share + a) / libm::sin(a)).powi(triangles as i32) >= ratio
        };
        let (mut low, mut high) = (0.0, PI);
        for _ in 0..80 {
            let middle = (low + high) / 2.0;
            if holds(middle) { low = middle } else { high = middle }
        }
        low.to_degrees()
    }

    proptest! {
        #[test]
        fn the_formula_solves_the_condition(
            angle in 0.05..6.2_f64, ratio in 1.0..300.0_f64, most in 2..7_u32,
        ) {
            let brute = (1..=most).map(|k| fan_by_bisection(angle, ratio, k)).fold(0.0, f64::max);
            let limit = fan_limit(angle, 1.0, ratio, Some(most));
            prop_assert!((limit - brute).abs() < 1e-7, "{limit} {brute}");
        }

        /// No fan of triangles, however its spokes lie, is better than the limit.
        #[test]
        fn no_fan_is_better(
            angle in 0.2..6.2_f64, ratio in 1.0..40.0_f64,
            parts in prop::collection::vec((0.2..1.0_f64, 0.1..1.5_f64), 2..7),
        ) {
            let total: f64 = parts.iter().map(|p| p.0).sum();
            prop_assume!(parts.iter().all(|part| part.0 / total * angle < 3.1));
            let mut spokes = vec![DVec2::X];
            let mut turned = 0.0;
            for (share, length) in &parts[..parts.len() - 1] {
                turned += share / total * angle;
                spokes.push(DVec2::from_angle(turned) * ratio.powf(*length));
            }
            spokes.push(DVec2::from_angle(angle) * ratio);
            let least = spokes
                .windows(2)
                .map(|ends| crate::triangle::min_angle([DVec2::ZERO, ends[0], ends[1]]))
                .fold(180.0, f64::min);
            let limit = fan_limit(angle, ratio, 1.0, Some(parts.len() as u32));
            prop_assert!(least <= limit + 1e-9, "{least} {limit}");
        }
    }

    /// The limits with so many edges at each boundary vertex.
    fn limits(outline: &PlanarBoundary, edges: u32) -> Limits {
        super::limits(outline, 1, |v| degree_limit(outline.angle(v), edges))
    }

    #[test]
    fn known_domains_have_known_limits() {
        let fin = samples::rectangle(40.0, 0.2, [100, 1, 100, 1]);
        let found = limits(&fin, 5);
        assert!((found.angle() - 26.565_051).abs() < 1e-6, "{found:?}");
        assert!(found.tent.is_some());

        let figure = samples::rectangle(3.0, 2.0, [3, 3, 2, 2]);
        let dominated = samples::rectangle(100.0, 40.0, [1000, 3, 5, 2]);
        let hexagon = samples::polygon(
            &[[0.0, 0.0], [6.0, 0.0], [8.0, 3.0], [6.5, 6.0], [2.0, 7.0], [-1.0, 4.0]],
            &[12, 3, 5, 9, 2, 7],
        );
        for (outline, any, with_limit) in
            [(figure, 41.7, 41.7), (dominated.clone(), 11.25, 7.68), (hexagon, 37.6, 37.6)]
        {
            let found = limits(&outline, 5);
            assert!((found.angle_at_any_degree() - any).abs() < 0.06, "{found:?}");
            assert!((found.angle() - with_limit).abs() < 0.06, "{found:?}");
        }
        assert!((limits(&dominated, 4).angle() - 5.73).abs() < 0.01);
        assert_eq!(limits(&dominated, 5).vertex(), 0);
    }

    #[test]
    fn tents_of_a_hole_press_on_the_outer_ring() {
        // A gap of 0.1 between edges of length 1.
        let outer = samples::ring(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]], &[4; 4]);
        let hole = samples::ring(&[[1.0, 0.1], [1.0, 2.0], [2.0, 2.0], [2.0, 0.1]], &[1; 4]);
        let expected = libm::atan(0.1).to_degrees();
        // In any unit of length.
        for unit in [1e-3, 1.0, 1e3] {
            let rings = [&outer, &hole].map(|ring| ring.iter().map(|p| *p * unit).collect());
            let rings: [Vec<DVec2>; 2] = rings;
            let found = limits(&PlanarBoundary::new(&rings).unwrap(), 5);
            assert!((found.angle() - expected).abs() < 1e-6, "{unit}: {found:?} {expected}");
        }
    }

    #[test]
    fn a_reflex_corner_may_have_more_edges() {
        // 2 and the nearest number of angles of 60 degrees; 4.5 of them round up.
        for (degrees, limit) in [
            (60.0, 4),
            (180.0, 4),
            (181.0, 5),
            (209.0, 5),
            (211.0, 6),
            (270.0, 7),
            (330.0, 8),
            (359.0, 8),
        ] {
            assert_eq!(degree_limit(f64::to_radians(degrees), 4), limit, "{degrees}");
            assert_eq!(degree_limit(f64::to_radians(degrees), 9), 9, "{degrees}");
        }
    }
}
