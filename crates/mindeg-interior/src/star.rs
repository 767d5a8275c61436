//! The limit of the minimum angle where frozen edges meet.
//!
//! Each of the sectors between them is a fan ([`limits`](crate::limits)): with k_i triangles in sector i, the
//! **star limit** is the greatest over all k_1 + … + k_m within the degree of the least fan limit of the sectors.

use crate::array_mesh::{ArrayMesh, NONE};
use crate::goal::Goal;
use crate::limits::fan_limit;
use glam::DVec2;

/// The star limit in degrees of a vertex, from the ends of frozen edges counter-clockwise: with at most so
/// many triangles. 0 where there are more sectors. `is_closed`: the last end and the first bound a sector, too.
fn star_limit(at: DVec2, ends: &[DVec2], is_closed: bool, max_triangles: u32) -> f64 {
    let most = max_triangles as usize;
    // best[k]: the greatest least fan limit of the sectors so far with k triangles in all.
    let mut best = vec![0.0; most + 1];
    best[0] = f64::INFINITY;
    let sectors = if is_closed { ends.len() } else { ends.len() - 1 };
    for sector in 0..sectors {
        let (from, to) = (ends[sector] - at, ends[(sector + 1) % ends.len()] - at);
        let mut angle = libm::atan2(from.perp_dot(to), from.dot(to));
        if angle <= 0.0 {
            angle += std::f64::consts::TAU;
        }
        let mut next = vec![0.0_f64; most + 1];
        for own in 1..=most {
            let limit = fan_limit(angle, from.length(), to.length(), Some(own as u32));
            for before in 0..=most - own {
                next[before + own] = next[before + own].max(best[before].min(limit));
            }
        }
        best = next;
    }
    best.into_iter().fold(0.0, f64::max)
}

/// Gives the vertices with frozen edges inside the mesh their star limits. `inside`: the goal of an inner vertex.
pub(crate) fn limit_stars(mesh: &mut ArrayMesh, inside: Goal) {
    let mut vertices: Vec<u32> = mesh.locked_edges().into_flattened();
    vertices.sort_unstable();
    vertices.dedup();
    let mut star = Vec::new();
    for v in vertices {
        let is_closed = mesh.star(v, &mut star);
        let mut ends = Vec::new();
        for (index, t) in star.iter().enumerate() {
            let triangle = &mesh.triangles[*t as usize];
            let [_, next, last] = [0, 1, 2].map(|i| (triangle.corner(v) + i) % 3);
            if triangle.locked >> last & 1 == 1 || !is_closed && index == 0 {
                ends.push(mesh.at(triangle.vertices[next]));
            }
            if !is_closed && index + 1 == star.len() {
                ends.push(mesh.at(triangle.vertices[last]));
            }
        }
        let vertex = &mut mesh.vertices[v as usize];
        if vertex.goal == NONE {
            vertex.goal = mesh.goals.len() as u32;
            mesh.goals.push(inside);
        }
        let (at, goal) = (vertex.at, &mut mesh.goals[vertex.goal as usize]);
        let limit = goal.limit.min(star_limit(at, &ends, is_closed, goal.triangles));
        *goal = Goal { limit, ..*goal }.aimed();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sectors_share_the_triangles_of_a_star() {
        let turn = |degrees: f64| DVec2::from_angle(degrees.to_radians());
        // Six sectors of 60 degrees; three of 120 with six triangles; of 7 triangles one is of no use.
        let six: Vec<DVec2> = (0..6).map(|i| turn(60.0 * f64::from(i))).collect();
        let three: Vec<DVec2> = six.iter().step_by(2).copied().collect();
        for (ends, most, limit) in [
            (&six, 6, 60.0),
            (&six, 7, 60.0),
            (&six, 5, 0.0),
            (&three, 6, 60.0),
            (&three, 7, 60.0),
            (&three, 5, 30.0),
        ] {
            assert!((star_limit(DVec2::ZERO, ends, true, most) - limit).abs() < 1e-9, "{most}");
        }
        // A sector of 20 degrees decides.
        let ends = [turn(0.0), turn(20.0), turn(180.0)];
        assert!((star_limit(DVec2::ZERO, &ends, true, 7) - 20.0).abs() < 1e-9);
        // At a straight boundary with an edge inside: one triangle of 60 degrees, and two.
        let ends = [turn(0.0), turn(60.0), turn(180.0)];
        assert!((star_limit(DVec2::ZERO, &ends, false, 3) - 60.0).abs() < 1e-9);
        assert!((star_limit(DVec2::ZERO, &ends, false, 2) - 30.0).abs() < 1e-9);
    }
}
