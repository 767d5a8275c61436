//! The greatest minimum angle of triangles whose corners are the shores of an inlet or of a strait.

use super::step::Step;
use crate::chains::Chains;
use crate::stars::angle_to;
use glam::DVec2;
use mindeg_interior::{edge_limit, least_angle};

/// The greatest minimum angle of the triangles between shores after a change, closed at their mouths, and of what lies outside beside these, in degrees; if it is
/// `enough`, that or more.
pub(super) fn angle_of(
    chains: &Chains<'_>,
    shores: &[Vec<u32>],
    step: Option<Step>,
    enough: f64,
) -> f64 {
    Water::new(chains, shores, step).best(enough)
}

/// The points of shores, and those before and after each on its ring.
struct Water {
    shores: Vec<Vec<DVec2>>,
    beyond: Vec<[DVec2; 2]>,
}

impl Water {
    fn new(chains: &Chains<'_>, shores: &[Vec<u32>], step: Option<Step>) -> Self {
        let at = |v: u32| match step {
            Some(Step::Shift { vertex, to }) if vertex == v => to,
            _ => chains.at(v),
        };
        let points = |v: &u32| match step {
            Some(Step::Drop { vertex }) if vertex == *v => [None, None],
            Some(Step::Insert { edge, at: new }) if edge == *v => [Some(at(*v)), Some(new)],
            _ => [Some(at(*v)), None],
        };
        let ends = |shore: &Vec<u32>| {
            let [first, last] = [shore[0], shore[shore.len() - 1]];
            [at(chains.previous(first)), at(chains.next(last))]
        };
        let points = |shore: &Vec<u32>| shore.iter().flat_map(points).flatten().collect();
        Self {
            shores: shores.iter().map(points).collect(),
            beyond: shores.iter().map(ends).collect(),
        }
    }

    /// The greatest minimum angle; if it is `enough`, that or more.
    fn best(&self, enough: f64) -> f64 {
        let points: Vec<DVec2> = self.shores.concat();
        let last = points.len() - 1;
        let inside = best_angles(&points)[0][last];
        inside.min(self.outside(inside.min(enough)))
    }

    /// The least limit outside at the mouths, from the fans at their ends, or `enough` if that is less.
    fn outside(&self, enough: f64) -> f64 {
        let mut least = enough;
        for (index, this) in self.shores.iter().enumerate() {
            // From the end of this shore to the start of the next, counter-clockwise round what is between.
            let after = (index + 1) % self.shores.len();
            let next = &self.shores[after];
            // Counter-clockwise from the first to the second.
            let fan = |center: DVec2, first: DVec2, second: DVec2| {
                angle_to(first - center, second - center)
            };
            let [a, b] = [next[0], this[this.len() - 1]];
            let [before, beyond] = [self.beyond[after][0], self.beyond[index][1]];
            let angles = [fan(a, b, before), fan(b, beyond, a)];
            let lengths = [a.distance(before), b.distance(beyond)];
            least = least.min(edge_limit(angles, a.distance(b), lengths, least));
        }
        least
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
