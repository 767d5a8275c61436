//! The limit of the minimum angle at an edge that stays, from the fans at both of its ends together.
//!
//! The triangle on a frozen edge has its apex somewhere. The apex divides the sectors at the edge's two ends: on the
//! other side of the triangle a fan is left at each, between the edge to the apex and the next frozen edge, and the fan limit
//! ([`limits`](crate::limits)) holds for both. The **edge limit** is the greatest over all apexes of the least of the triangle's
//! angles and the two fan limits, whatever the degrees. Where a short edge ends a narrow inlet, it is much less than each fan limit alone.
//!
//! The maximum is bounded from above by branching on the triangle's angles at the two ends and bounding what each box of them
//! allows, so the limit is proven up to rounding.

use crate::star::{Sector, Stars};
use std::f64::consts::PI;

/// The search for one edge ends when the limit is known this well, in radians, or after so many boxes: then what is left bounds it.
const TOLERANCE: f64 = 2e-4;
const MOST_BOXES: usize = 600;

/// An edge limit counts if it is less than this share of the limits at the edge's ends.
pub(crate) const TIGHTER: f64 = 0.995;

/// An edge with the sectors on one side of it.
pub(crate) struct Place {
    /// The sectors' angles at the edge's ends.
    pub(crate) angles: [f64; 2],
    /// The edge's length, then those of the next edges at its ends.
    pub(crate) length: f64,
    pub(crate) next: [f64; 2],
}

/// The triangle on an edge that takes the whole sector at one of its ends.
pub(crate) struct Ear {
    /// Its least angle.
    pub(crate) least: f64,
    /// The angle of the sector that it leaves at the other end, and the ratio of the lengths there.
    pub(crate) left: f64,
    pub(crate) ratio: f64,
}

/// Angles of the triangle at the edge's ends, from the first to the second.
#[derive(Clone, Copy)]
struct Angles([[f64; 2]; 2]);

/// The edge limit of each vertex of an outline and of lines in degrees: the least of its edges, `most` where it is more.
/// `known`: the limits that are known already.
pub(crate) fn edge_limits(stars: &Stars, most: f64, known: &[f64]) -> Vec<f64> {
    stars.least_limits(known.len(), most, |sector| {
        // The edge to the first end has the sector on its left, as it has the one at that end whose last edge it is.
        let [other, last] = sector.ends;
        // Without a second vertex the domain is a triangle.
        let at_other = stars.beside(sector)[0].filter(|own| own.ends[0] != last)?;
        let known = known[sector.vertex as usize].min(known[other as usize]).min(most);
        let limit = Place::new(sector, at_other).limit(known * (PI / 180.0)) * (180.0 / PI);
        // A vertex with a greater limit of its own is not excused by its neighbour's.
        (limit < TIGHTER * known).then(|| [sector.vertex, other].map(|vertex| (vertex, limit)))
    })
}

/// The edge that cuts off a corner of this angle between edges of two lengths: its angles with these, and its length.
pub(crate) fn cut_off(angle: f64, [first, second]: [f64; 2]) -> ([f64; 2], f64) {
    let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
    let at = |own: f64, other: f64| libm::atan2(other * sine, own - other * cosine);
    ([at(first, second), at(second, first)], libm::hypot(second * sine, first - second * cosine))
}

/// No triangle on an edge, with the fans that it leaves at both of the edge's ends, has a greater minimum angle, in degrees. `angles` are those
/// at the ends between the edge and the next edges, in radians, `next` the lengths of these. A limit of `enough` degrees or more is not searched for.
#[must_use]
pub fn edge_limit(angles: [f64; 2], length: f64, next: [f64; 2], enough: f64) -> f64 {
    let known = (enough * (PI / 180.0) / TIGHTER).min(PI / 3.0);
    Place { angles, length, next }.limit(known) * (180.0 / PI)
}

impl Place {
    fn new(at_first: &Sector, at_second: &Sector) -> Self {
        Self {
            angles: [at_first.angle, at_second.angle],
            length: at_first.lengths[0],
            next: [at_first.lengths[1], at_second.lengths[0]],
        }
    }

    /// The limit in radians, `known` if it is not clearly less.
    pub(crate) fn limit(&self, known: f64) -> f64 {
        let enough = TIGHTER * known;
        let mut reached = self.with_ear(0, known).max(self.with_ear(1, known));
        let whole = self.angles.map(|angle| [0.0, angle.min(PI)]);
        let mut boxes = vec![(self.bound(&Angles(whole)), Angles(whole))];
        for _ in 0..MOST_BOXES {
            if reached >= enough {
                return known;
            }
            let best = (0..boxes.len()).max_by(|i, j| boxes[*i].0.total_cmp(&boxes[*j].0));
            let Some(best) = best.filter(|best| boxes[*best].0 > reached + TOLERANCE) else {
                return (reached + TOLERANCE).min(known);
            };
            let (_, Angles(sides)) = boxes.swap_remove(best);
            let middles = sides.map(|[low, high]| f64::midpoint(low, high));
            reached = reached.max(self.bound(&Angles(middles.map(|middle| [middle; 2]))));
            let longer = usize::from(sides[1][1] - sides[1][0] > sides[0][1] - sides[0][0]);
            for half in 0..2 {
                let mut part = sides;
                part[longer][1 - half] = middles[longer];
                let bound = self.bound(&Angles(part));
                if bound > reached {
                    boxes.push((bound, Angles(part)));
                }
            }
        }
        boxes.iter().map(|each| each.0).fold(reached, f64::max).min(known)
    }

    /// The angle reached by the triangle that takes the whole sector at one end, with the best fan at the other.
    fn with_ear(&self, end: usize, known: f64) -> f64 {
        let Some(Ear { least, left, ratio }) = self.ear(end) else { return 0.0 };
        least.min(fan_bound([left; 2], [ratio; 2], known))
    }

    /// The triangle that takes the whole sector at one end, if something is left at the other.
    pub(crate) fn ear(&self, end: usize) -> Option<Ear> {
        let (angle, next) = (self.angles[end], self.next[end]);
        if angle >= PI {
            return None;
        }
        let ([other, _], length) = cut_off(angle, [self.length, next]);
        let left = self.angles[1 - end] - other;
        let least = angle.min(other).min(PI - angle - other);
        (left > 0.0).then(|| Ear { least, left, ratio: length / self.next[1 - end] })
    }

    /// No apex seen from the ends under these angles allows more; of one apex the angle that it allows.
    fn bound(&self, Angles([first, second]): &Angles) -> f64 {
        let third = PI - first[0] - second[0];
        let mut bound = first[1].min(second[1]).min(third);
        if bound <= 0.0 {
            return 0.0;
        }
        for end in 0..2 {
            let [own, other] = if end == 0 { [first, second] } else { [second, first] };
            let left = [self.angles[end] - own[1], self.angles[end] - own[0]];
            let lengths = apart(own, other).map(|length| length * self.length / self.next[end]);
            bound = bound.min(fan_bound(left, lengths, bound));
        }
        bound
    }
}

/// The least and the greatest distance of an apex from an end of an edge of length 1, seen from there under `own` and from the other end
/// under `other` angles: sin(other) / sin(own + other), which grows with `other`.
pub(crate) fn apart(own: &[f64; 2], other: &[f64; 2]) -> [f64; 2] {
    let sums = |other: f64| own.map(|own| own + other);
    let [low, high] = sums(other[0]);
    // The sine of the sum is greatest at a right angle.
    let greatest = match (low..=high).contains(&(PI / 2.0)) {
        true => 1.0,
        false => libm::sin(low).max(libm::sin(high)),
    };
    let least = sums(other[1]).map(libm::sin).into_iter().fold(1.0, f64::min);
    [
        if greatest > 0.0 { libm::sin(other[0]) / greatest } else { 0.0 },
        if least > 0.0 { libm::sin(other[1]) / least } else { f64::INFINITY },
    ]
}

/// No fan with an angle of this range, in radians, between edges with a ratio of lengths of that range has a greater fan limit, up to `most`.
fn fan_bound([narrow, wide]: [f64; 2], ratios: [f64; 2], most: f64) -> f64 {
    let log_ratio = log_of_nearest(ratios);
    let mut best = 0.0_f64;
    for count in 1..=u32::MAX {
        if wide <= 0.0 || wide / f64::from(count) <= best || best >= most {
            break;
        }
        best = best.max(fan_of(count, [narrow, wide], log_ratio));
    }
    best
}

/// The fewest triangles that a fan of this range has if all angles are at least `least`; `many` stands for more, too. `None` if there is no such fan.
pub(crate) fn fewest_of_fan(
    angle: [f64; 2],
    ratios: [f64; 2],
    least: f64,
    many: u32,
) -> Option<u32> {
    let log_ratio = log_of_nearest(ratios);
    let fits = |count: &u32| *count == many || fan_of(*count, angle, log_ratio) >= least;
    (1..=many).take_while(|count| angle[1] >= f64::from(*count) * least).find(fits)
}

/// The logarithm of the ratio that is nearest to 1.
fn log_of_nearest([low, high]: [f64; 2]) -> f64 {
    libm::log(if low > 1.0 { low } else { (1.0 / high).max(1.0) })
}

/// No fan of so many triangles with an angle of this range has a greater least angle.
fn fan_of(count: u32, [narrow, wide]: [f64; 2], log_ratio: f64) -> f64 {
    let share = [narrow.max(0.0), wide].map(|angle| angle / f64::from(count));
    let spokes = libm::exp(log_ratio / f64::from(count));
    // atan2(sin s, q - cos s) grows until cos s = 1 / q, and falls from there.
    let peak = libm::acos(1.0 / spokes).clamp(share[0], share[1]);
    if peak >= PI {
        return 0.0;
    }
    let reached = match peak > 0.0 {
        true => libm::atan2(libm::sin(peak), spokes - libm::cos(peak)),
        false => PI / 2.0,
    };
    share[1].min(reached)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::breaklines::Breaklines;
    use crate::goal::MOST;
    use crate::limits::fan_limit;
    use glam::DVec2;
    use mindeg_mesh::planar::PlanarBoundary;

    fn edge_limits_of(ring: &[[f64; 2]]) -> Vec<f64> {
        let ring: Vec<DVec2> = ring.iter().copied().map(DVec2::from).collect();
        let outline = PlanarBoundary::new(&[ring]).unwrap();
        let stars = Stars::new(&outline, &Breaklines::default());
        let known: Vec<f64> = (0..outline.vertex_count()).map(|v| stars.limit(v, None)).collect();
        edge_limits(&stars, MOST, &known)
    }

    /// An inlet: its end is 1 wide, its sides are 3 and 5 long.
    const INLET: [[f64; 2]; 6] =
        [[0.0, 0.0], [1.0, 0.0], [1.2, 3.0], [6.0, 8.0], [-6.0, 8.0], [-0.2, 5.0]];

    /// The angle that an apex allows, from its place.
    fn at_apex(place: &Place, x: f64, y: f64) -> f64 {
        let angles = [libm::atan2(y, x), libm::atan2(y, place.length - x)];
        let spokes = [libm::hypot(x, y), libm::hypot(place.length - x, y)];
        let fan = |end: usize| {
            let left = place.angles[end] - angles[end];
            let limit = |left| fan_limit(left, spokes[end], place.next[end], None) * (PI / 180.0);
            if left > 0.0 { limit(left) } else { 0.0 }
        };
        let triangle = angles[0].min(angles[1]).min(PI - angles[0] - angles[1]);
        triangle.min(fan(0)).min(fan(1))
    }

    #[test]
    fn no_apex_allows_more_and_one_nearly_as_much() {
        let mut below = 0;
        for i in 0..60 {
            let of = |prime: f64| libm::fmod(f64::from(i) * prime, 1.0);
            let place = Place {
                angles: [0.4 + 2.0 * of(0.37), 0.4 + 2.0 * of(0.61)],
                length: 1.0,
                next: [0.3 + 5.0 * of(0.23), 0.3 + 5.0 * of(0.83)],
            };
            let known = 1.0;
            let limit = place.limit(known);
            let mut reached = place.with_ear(0, known).max(place.with_ear(1, known));
            for j in 0..400 * 400 {
                let (x, y) = (f64::from(j % 400) / 100.0 - 1.5, f64::from(j / 400 + 1) / 100.0);
                reached = reached.max(at_apex(&place, x, y));
            }
            assert!(reached <= limit + 1e-12, "{i}: {reached} {limit}");
            assert!(limit <= reached + 0.02 || limit == known, "{i}: {reached} {limit}");
            below += usize::from(limit < 0.5);
        }
        assert!(below > 20, "{below}");
    }

    #[test]
    fn the_end_of_an_inlet_has_less_than_its_corners_allow() {
        let limits = edge_limits_of(&INLET);
        let fans = |v: u32| {
            let outline = PlanarBoundary::new(&[INLET.map(DVec2::from).to_vec()]).unwrap();
            Stars::new(&outline, &Breaklines::default()).limit(v, None)
        };
        assert!(limits[0] == limits[1] && limits[0] < 0.9 * fans(0).min(fans(1)), "{limits:?}");
    }

    #[test]
    fn a_square_of_even_edges_has_no_edge_limits() {
        let ring: Vec<[f64; 2]> = (0..16)
            .map(|i| [[i % 4, 0], [4, i % 4], [4 - i % 4, 4], [0, 4 - i % 4]][i as usize / 4])
            .map(|at| at.map(f64::from))
            .collect();
        assert_eq!(edge_limits_of(&ring), [MOST; 16]);
    }
}
