//! Delaunay by flips: a triangulation whose angles bound what there is from below.

use crate::chords::Sides;
use crate::measure::min_angle_tangent;
use crate::triangulation::{NONE, Triangulation, orientation};
use glam::DVec2;
use robust::{Coord, incircle};

/// Flips edges until the triangulation is constrained Delaunay, apart from chords within a side;
/// or until it has taken 1000 flips a vertex, which leaves some other triangulation.
pub(crate) fn make_delaunay(mesh: &mut Triangulation, points: &[DVec2], sides: &Sides) {
    let mut flips_left = 1000 * points.len();
    let mut open: Vec<(u32, usize)> =
        (0..mesh.triangles.len() as u32).flat_map(|t| (0..3).map(move |edge| (t, edge))).collect();
    while let Some((triangle, edge)) = open.pop() {
        let beyond = mesh.across[triangle as usize][edge];
        if beyond == NONE {
            continue;
        }
        let corners = mesh.triangles[triangle as usize];
        let [a, b, c] = [corners[edge], corners[(edge + 1) % 3], corners[(edge + 2) % 3]];
        let (other_edge, d) = mesh.enter(beyond, b);
        let at = |vertex: u32| points[vertex as usize];
        let coord = |vertex: u32| Coord { x: at(vertex).x, y: at(vertex).y };
        let is_better = incircle(coord(a), coord(b), coord(c), coord(d)) > 0.0
            && !sides.has_both(c, d)
            && orientation(at(c), at(a), at(d)) > 0.0
            && orientation(at(d), at(b), at(c)) > 0.0;
        if !is_better || flips_left == 0 {
            continue;
        }
        flips_left -= 1;
        // From abc and bad to cad and dbc, whose common edge is cd.
        let across = mesh.across[triangle as usize];
        let other_across = mesh.across[beyond as usize];
        let (over_bc, over_ca) = (across[(edge + 1) % 3], across[(edge + 2) % 3]);
        let (over_ad, over_db) =
            (other_across[(other_edge + 1) % 3], other_across[(other_edge + 2) % 3]);
        mesh.triangles[triangle as usize] = [c, a, d];
        mesh.across[triangle as usize] = [over_ca, over_ad, beyond];
        mesh.triangles[beyond as usize] = [d, b, c];
        mesh.across[beyond as usize] = [over_db, over_bc, triangle];
        for (moved, before, now) in [(over_ad, beyond, triangle), (over_bc, triangle, beyond)] {
            if moved != NONE
                && let Some(entry) =
                    mesh.across[moved as usize].iter_mut().find(|entry| **entry == before)
            {
                *entry = now;
            }
        }
        open.extend([(triangle, 0), (triangle, 1), (beyond, 0), (beyond, 1)]);
    }
}

/// The tangent of the smallest angle of all triangles, 0 where an edge joins two vertices of one side.
pub(crate) fn least_tangent(mesh: &Triangulation, points: &[DVec2], sides: &Sides) -> f64 {
    let tangents = mesh.triangles.iter().zip(&mesh.across).map(|(&corners, across)| {
        let is_within_side = (0..3).any(|edge| {
            across[edge] != NONE && sides.has_both(corners[edge], corners[(edge + 1) % 3])
        });
        let at = corners.map(|corner| points[corner as usize]);
        if is_within_side { 0.0 } else { min_angle_tangent(at) }
    });
    tangents.fold(f64::INFINITY, f64::min)
}
