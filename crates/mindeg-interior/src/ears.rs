//! The limit of the minimum angle behind a sharp corner.
//!
//! The sector of angle t between two frozen edges has several triangles, one of them with an angle of at most t / 2, or a single one, its
//! ear. The edge of the ear that is opposite the corner takes a part of the sectors at its two ends. For the rest of each the fan limit
//! ([`limits`](crate::limits)) holds, and for both together the limit of that edge ([`edge_limits`](crate::edge_limits)). So the triangles
//! at the corner and at such an end have no more than the greater of t / 2 and the **ear limit**, nor have those at all three and that
//! edge's. The ends get it as their limit: corners keep their angles, and who halves one may have more beside it.

use crate::edge_limits::{Place, TIGHTER, cut_off};
use crate::limits::fan_limit_from;
use crate::star::{Sector, Stars};
use std::f64::consts::PI;

/// The limits behind a corner, in degrees.
#[derive(Debug, Clone, Copy)]
struct Behind {
    ends: [u32; 2],
    /// For the corner and each end.
    fans: [f64; 2],
    /// For all three.
    all: f64,
}

/// The ear limit of each vertex of an outline and of lines in degrees: the least of its corners', `most` where it is more.
/// `known`: the limits that are known already.
pub(crate) fn ear_limits(stars: &Stars, most: f64, known: &[f64]) -> Vec<f64> {
    stars.least_limits(known.len(), most, |sector| {
        let Behind { ends, fans, all } = behind(stars, sector, known)?;
        Some([0, 1].map(|end| {
            let (vertex, limit) = (ends[end], fans[end].min(all));
            let is_tighter = limit < TIGHTER * known[vertex as usize];
            (vertex, if is_tighter { limit } else { most })
        }))
    })
}

/// The limits behind the corner of a sector, unless the sector's halves have as much as is known of its ends.
fn behind(stars: &Stars, sector: &Sector, known: &[f64]) -> Option<Behind> {
    let &Sector { ends: [next, previous], angle, lengths: [to_next, to_previous], .. } = sector;
    let ends = [previous, next];
    let half = angle.to_degrees() / 2.0;
    let of_ends = ends.map(|end| known[end as usize]);
    if sector.least > 1 || half >= of_ends[0].max(of_ends[1]) {
        return None;
    }
    let [Some(at_next), Some(at_previous)] = stars.beside(sector) else { return None };
    // A face of four edges may be two triangles.
    if at_previous.ends[1] == at_next.ends[0] || at_previous.ends[1] == next {
        return None;
    }
    let (taken, length) = cut_off(angle, [to_previous, to_next]);
    let place = Place {
        angles: [at_previous.angle - taken[0], at_next.angle - taken[1]],
        length,
        next: [at_previous.lengths[1], at_next.lengths[0]],
    };
    if place.angles.iter().any(|left| *left <= 0.0) {
        return None;
    }
    let fans = [0, 1]
        .map(|end| fan_limit_from(1, place.angles[end], [length, place.next[end]], None).max(half));
    let known = of_ends.into_iter().chain(fans).fold(60.0, f64::min);
    let of_edge = place.limit(known * (PI / 180.0)).to_degrees().max(half);
    // An end with a greater limit of its own is not excused by the other one's.
    let all = if of_edge < TIGHTER * known { of_edge } else { f64::INFINITY };
    Some(Behind { ends, fans, all })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::breaklines::Breaklines;
    use crate::generate;
    use crate::goal::MOST;
    use crate::limits::fan_limit;
    use crate::options::Options;
    use crate::triangle::min_angle;
    use glam::DVec2;
    use mindeg_mesh::Progress;
    use mindeg_mesh::planar::PlanarBoundary;

    /// A wedge of 5 degrees below a long wall.
    const WEDGE: [[f64; 2]; 6] =
        [[0.0, 0.0], [10.0, 0.0], [60.0, 0.0], [60.0, 60.0], [9.0, 60.0], [9.0, 0.8]];

    #[test]
    fn what_is_left_beside_an_ear_limits_its_ends() {
        let outline = PlanarBoundary::new(&[WEDGE.map(DVec2::from).to_vec()]).unwrap();
        let stars = Stars::new(&outline, &Breaklines::default());
        let known: Vec<f64> = (0..6).map(|vertex| stars.limit(vertex, None).min(MOST)).collect();
        let Behind { ends, fans, all } = behind(&stars, &stars.at(0)[0], &known).unwrap();
        assert_eq!(ends, [5, 1]);
        // At (10, 0) the ear takes 38.66 of 180 degrees.
        let fan = fan_limit((180.0 - 38.66_f64).to_radians(), 1_f64.hypot(0.8), 50.0, None);
        assert!((fans[1] - fan).abs() < 0.01 && all < fan, "{fans:?} {fan} {all}");
        let limits = ear_limits(&stars, MOST, &known);
        assert_eq!(limits, [MOST, all, MOST, MOST, MOST, all]);
    }

    #[test]
    fn no_mesh_has_more_at_a_corner_and_behind_it() {
        let (mut tight, mut seen) = (0, 0);
        for i in 0..120 {
            let of = |prime: f64| libm::fmod(f64::from(i) * prime, 1.0);
            let (far, up) = (4.0 + 20.0 * of(0.37), 0.3 + 4.0 * of(0.61));
            let ring = [
                [0.0, 0.0],
                [2.0 + 6.0 * of(0.23), 0.0],
                [far + 8.0, -4.0 * of(0.83)],
                [far, up + 8.0],
                [1.0 + 6.0 * of(0.47), up],
            ];
            let Ok(outline) = PlanarBoundary::new(&[ring.map(DVec2::from).to_vec()]) else {
                continue;
            };
            let found = generate(&outline, &Options::default(), Progress::NONE).unwrap();
            let mut angles = [60.0_f64; 5];
            for triangle in &found.triangles {
                let angle = min_angle(triangle.map(|v| found.points[v as usize]));
                for v in triangle.iter().map(|v| *v as usize).filter(|v| *v < 5) {
                    angles[v] = angles[v].min(angle);
                }
            }
            let stars = Stars::new(&outline, &Breaklines::default());
            for corner in 0..5 {
                let found = behind(&stars, &stars.at(corner)[0], &[60.0; 5]);
                let Some(Behind { ends, fans, all }) = found else { continue };
                let own = [corner, ends[0], ends[1]].map(|vertex| angles[vertex as usize]);
                let one = |end: usize| (own[0].min(own[end]), fans[end - 1]);
                for (reached, limit) in [one(1), one(2), (own[0].min(own[1]).min(own[2]), all)] {
                    assert!(reached <= limit + 1e-9, "{i}: {corner} {reached} {limit}");
                    seen += usize::from(limit < 60.0);
                    tight += usize::from(reached > 0.97 * limit);
                }
            }
        }
        assert!(seen > 200 && tight > 5, "{seen} {tight}");
    }
}
