//! The greatest minimum angle of triangles whose corners are an inlet's shore.

use crate::chains::Chains;
use crate::stars::angle_to;
use glam::DVec2;
use mindeg_interior::{Options, edge_limit, generate};
use mindeg_mesh::Progress;
use mindeg_mesh::planar::PlanarBoundary;

/// The mouth is at most so many edges of the shore further in on each side.
const INWARD: usize = 2;

/// The greatest minimum angle of an inlet's triangles, closed at its mouth, and of what lies outside beside that, in degrees.
pub(super) fn angle_of(chains: &Chains, shore: &[u32]) -> f64 {
    let points: Vec<DVec2> = shore.iter().map(|v| chains.at(*v)).collect();
    angle_within(chains, shore, &points, 0)
}

/// The same if the mouth may be a little further in.
pub(super) fn angle_further_in(chains: &Chains, shore: &[u32]) -> f64 {
    let points: Vec<DVec2> = shore.iter().map(|v| chains.at(*v)).collect();
    angle_within(chains, shore, &points, INWARD)
}

/// The same with a point put on the edge that begins at a vertex.
pub(super) fn angle_with_point(chains: &Chains, shore: &[u32], edge: u32, at: DVec2) -> f64 {
    let Some(index) = shore.iter().position(|v| *v == edge) else { return 0.0 };
    let mut points: Vec<DVec2> = shore.iter().map(|v| chains.at(*v)).collect();
    points.insert(index + 1, at);
    angle_within(chains, shore, &points, 0)
}

/// The angle that a mesh of an inlet with points inside has, closed at its mouth, and of what lies outside beside that.
pub(super) fn meshed_angle(chains: &Chains, shore: &[u32]) -> f64 {
    let ring: Vec<DVec2> = shore.iter().map(|v| chains.at(*v)).collect();
    let Some(outside) = outside(chains, shore, &ring, [0, ring.len() - 1]) else { return 0.0 };
    let mesh = PlanarBoundary::new(&[ring])
        .ok()
        .and_then(|outline| generate(&outline, &Options::default(), Progress::NONE).ok());
    mesh.map_or(0.0, |mesh| mesh.report.min_angle.min(outside))
}

fn angle_within(chains: &Chains, shore: &[u32], points: &[DVec2], inward: usize) -> f64 {
    let angles = best_angles(points);
    let last = points.len() - 1;
    let mut best = 0.0_f64;
    for (from, of_mouths) in angles.iter().enumerate().take(inward + 1) {
        for (to, own) in of_mouths.iter().enumerate().skip(last.saturating_sub(inward)) {
            if from + 2 <= to
                && *own > best
                && let Some(outside) = outside(chains, shore, points, [from, to])
            {
                best = best.max(own.min(outside));
            }
        }
    }
    best
}

/// The limit outside at an edge between two points of a shore, from the fans at both; none if the shore is in its way.
fn outside(
    chains: &Chains,
    shore: &[u32],
    points: &[DVec2],
    [from, to]: [usize; 2],
) -> Option<f64> {
    let last = points.len() - 1;
    let before = chains.at(chains.previous(*shore.first()?));
    let after = chains.at(chains.next(*shore.last()?));
    let rest = [&points[..=from], &points[to..]].concat();
    if rest.len() > 2 && best_angles(&rest)[0][rest.len() - 1] == 0.0 {
        return None;
    }
    let before = if from == 0 { before } else { points[from - 1] };
    let after = if to == last { after } else { points[to + 1] };
    // Counter-clockwise from the first to the second.
    let fan =
        |center: DVec2, first: DVec2, second: DVec2| angle_to(first - center, second - center);
    let [a, b] = [points[from], points[to]];
    let angles = [fan(a, b, before), fan(b, after, a)];
    Some(edge_limit(angles, a.distance(b), [a.distance(before), b.distance(after)]))
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
