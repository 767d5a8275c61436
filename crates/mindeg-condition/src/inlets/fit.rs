//! The greatest minimum angle of triangles whose corners are the shores of an inlet or of a strait.

use crate::chains::Chains;
use crate::stars::angle_to;
use glam::DVec2;
use mindeg_interior::{Options, edge_limit, generate};
use mindeg_mesh::Progress;
use mindeg_mesh::planar::PlanarBoundary;

/// The mouth is at most so many edges of the shore further in on each side.
const INWARD: usize = 2;

/// The most shores whose mouths are looked for further in.
const MOST_SHORES: usize = 3;

/// The greatest minimum angle of the triangles between shores, closed at their mouths, and of what lies outside beside these, in degrees.
pub(super) fn angle_of(chains: &Chains, shores: &[Vec<u32>]) -> f64 {
    Water::new(chains, shores).best(0).0
}

/// The same if the mouths may be a little further in, and the shores up to these.
pub(super) fn angle_further_in(chains: &Chains, shores: &[Vec<u32>]) -> (f64, Vec<Vec<u32>>) {
    let (angle, ends) = Water::new(chains, shores).best(INWARD);
    let within = shores.iter().zip(ends).map(|(shore, [from, to])| shore[from..=to].to_vec());
    (angle, within.collect())
}

/// The same as [`angle_of`] with a point put on the edge that begins at a vertex.
pub(super) fn angle_with_point(chains: &Chains, shores: &[Vec<u32>], edge: u32, at: DVec2) -> f64 {
    let mut water = Water::new(chains, shores);
    for (shore, points) in shores.iter().zip(&mut water.shores) {
        if let Some(index) = shore.iter().position(|v| *v == edge) {
            points.insert(index + 1, at);
        }
    }
    water.best(0).0
}

/// The angle that a mesh of what is between shores with points inside has, closed at the mouths, and of what lies outside beside these.
pub(super) fn meshed_angle(chains: &Chains, shores: &[Vec<u32>]) -> f64 {
    let water = Water::new(chains, shores);
    let Some(outside) = water.outside(&water.all()) else { return 0.0 };
    let mesh = PlanarBoundary::new(&[water.shores.concat()])
        .ok()
        .and_then(|outline| generate(&outline, &Options::default(), Progress::NONE).ok());
    mesh.map_or(0.0, |mesh| mesh.report.min_angle.min(outside))
}

/// The points of shores, and those before and after each on its ring.
struct Water {
    shores: Vec<Vec<DVec2>>,
    beyond: Vec<[DVec2; 2]>,
}

/// The first and the last point of each shore that is taken.
type Ends = Vec<[usize; 2]>;

impl Water {
    fn new(chains: &Chains, shores: &[Vec<u32>]) -> Self {
        let ends = |shore: &Vec<u32>| {
            let [first, last] = [shore[0], shore[shore.len() - 1]];
            [chains.at(chains.previous(first)), chains.at(chains.next(last))]
        };
        let points = |shore: &Vec<u32>| shore.iter().map(|v| chains.at(*v)).collect();
        Self {
            shores: shores.iter().map(points).collect(),
            beyond: shores.iter().map(ends).collect(),
        }
    }

    /// All points.
    fn all(&self) -> Ends {
        self.shores.iter().map(|shore| [0, shore.len() - 1]).collect()
    }

    /// The greatest minimum angle with each mouth at most so many edges of a shore further in, and where the mouths are then.
    fn best(&self, inward: usize) -> (f64, Ends) {
        let mut best = (0.0_f64, self.all());
        if self.shores.len() == 1 || inward == 0 || self.shores.len() > MOST_SHORES {
            let inward = if self.shores.len() == 1 { inward } else { 0 };
            self.best_around(&self.all(), inward, &mut best);
            return best;
        }
        // All mouths but that between the last shore and the first, each by two digits.
        let steps = inward + 1;
        let digits = 2 * (self.shores.len() - 1);
        for number in 0..steps.pow(digits as u32) {
            let digit = |at: usize| number / steps.pow(at as u32) % steps;
            let mut ends = self.all();
            for mouth in 0..self.shores.len() - 1 {
                ends[mouth][1] = ends[mouth][1].saturating_sub(digit(2 * mouth));
                ends[mouth + 1][0] += digit(2 * mouth + 1);
            }
            if ends
                .iter()
                .zip(&self.shores)
                .all(|([from, to], shore)| from <= to && *to < shore.len())
            {
                self.best_around(&ends, inward, &mut best);
            }
        }
        best
    }

    /// The same where only the mouth between the last shore and the first is free.
    fn best_around(&self, ends: &Ends, inward: usize, best: &mut (f64, Ends)) {
        let last = ends.len() - 1;
        let taken = ends.iter().zip(&self.shores).map(|([from, to], shore)| &shore[*from..=*to]);
        let points: Vec<DVec2> = taken.collect::<Vec<_>>().concat();
        let angles = best_angles(&points);
        let end = points.len() - 1;
        for (from, of_mouths) in angles.iter().enumerate().take(inward + 1) {
            for (to, own) in of_mouths.iter().enumerate().skip(end.saturating_sub(inward)) {
                let mut ends = ends.clone();
                ends[0][0] += from;
                ends[last][1] = ends[last][1].saturating_sub(end - to);
                if from + 2 <= to
                    && *own > best.0
                    && ends[0][0] <= ends[0][1]
                    && ends[last][0] <= ends[last][1]
                    && let Some(outside) = self.outside(&ends)
                    && own.min(outside) > best.0
                {
                    *best = (own.min(outside), ends);
                }
            }
        }
    }

    /// The least limit outside at the mouths, from the fans at their ends; none if a shore is in the way.
    fn outside(&self, ends: &Ends) -> Option<f64> {
        let mut least = 60.0_f64;
        for (index, own) in ends.iter().enumerate() {
            // From the end of this shore to the start of the next, counter-clockwise round what is between.
            let after = (index + 1) % ends.len();
            let (to, from) = (own[1], ends[after][0]);
            let (this, next) = (&self.shores[index], &self.shores[after]);
            let rest = [&next[..=from], &this[to..]].concat();
            if rest.len() > 2 && best_angles(&rest)[0][rest.len() - 1] == 0.0 {
                return None;
            }
            let before = if from == 0 { self.beyond[after][0] } else { next[from - 1] };
            let beyond = if to + 1 == this.len() { self.beyond[index][1] } else { this[to + 1] };
            // Counter-clockwise from the first to the second.
            let fan = |center: DVec2, first: DVec2, second: DVec2| {
                angle_to(first - center, second - center)
            };
            let [a, b] = [next[from], this[to]];
            let angles = [fan(a, b, before), fan(b, beyond, a)];
            let lengths = [a.distance(before), b.distance(beyond)];
            least = least.min(edge_limit(angles, a.distance(b), lengths));
        }
        Some(least)
    }
}

/// For every two points of a polygon the greatest minimum angle of the triangulations between them, in degrees; 0 if there are none.
/// By the apex of the triangle on the edge between the two.
fn best_angles(points: &[DVec2]) -> Vec<Vec<f64>> {
    let count = points.len();
    let mut best = vec![vec![60.0_f64; count]; count];
    for steps in 2..count {
        for from in 0..count - steps {
            let to = from + steps;
            let mut own = 0.0_f64;
            for apex in from + 1..to {
                let parts = best[from][apex].min(best[apex][to]);
                if parts > own {
                    own = own.max(parts.min(least_angle([points[from], points[apex], points[to]])));
                }
            }
            best[from][to] = own;
        }
    }
    best
}

/// The least angle of a counter-clockwise triangle in degrees; 0 of another one.
fn least_angle(corners: [DVec2; 3]) -> f64 {
    let sides = [0, 1, 2].map(|i| corners[(i + 2) % 3] - corners[(i + 1) % 3]);
    let doubled = (corners[1] - corners[0]).perp_dot(corners[2] - corners[0]);
    if doubled <= 0.0 {
        return 0.0;
    }
    // Opposite the shortest side.
    let lengths = sides.map(DVec2::length_squared);
    let shortest = (0..3).min_by(|a, b| lengths[*a].total_cmp(&lengths[*b])).unwrap_or(0);
    let beside = -sides[(shortest + 1) % 3].dot(sides[(shortest + 2) % 3]);
    libm::atan2(doubled, beside).to_degrees()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn the_best_triangulation_is_found() {
        // A hexagon has triangulations of 30 degrees, and none better.
        let hexagon: Vec<DVec2> =
            (0..6).map(|i| DVec2::from_angle(f64::from(i) * TAU / 6.0)).collect();
        assert!((best_angles(&hexagon)[0][5] - 30.0).abs() < 1e-9);
        // Two squares: 45 degrees. Clockwise there is nothing.
        let strip = [[0.0, 1.0], [0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0]];
        let mut strip = strip.map(DVec2::from);
        assert!((best_angles(&strip)[0][5] - 45.0).abs() < 1e-9);
        strip.reverse();
        assert_eq!(best_angles(&strip)[0][5], 0.0);
    }
}
