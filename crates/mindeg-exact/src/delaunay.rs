//! Delaunay by flips: a lower bound on the largest minimum angle.

use crate::chords::Sides;
use crate::measure::min_angle_tangent;
use crate::triangulation::{NONE, Triangulation, orientation};
use glam::DVec2;
use robust::{Coord, incircle};

/// Flips edges until the triangulation is constrained Delaunay, except for chords within a side; or
/// until 1000 flips a vertex, which leaves some other triangulation.
pub(crate) fn make_delaunay(mesh: &mut Triangulation, points: &[DVec2], sides: &Sides) {
    let mut flips_left = 1000 * points.len();
    let mut open: Vec<(u32, usize)> =
        (0..mesh.triangles.len() as u32).flat_map(|t| (0..3).map(move |edge| (t, edge))).collect();
    while let Some((triangle, edge)) = open.pop() {
        let beyond = mesh.neighbours[triangle as usize][edge];
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
        let neighbours = mesh.neighbours[triangle as usize];
        let other_neighbours = mesh.neighbours[beyond as usize];
        let (over_bc, over_ca) = (neighbours[(edge + 1) % 3], neighbours[(edge + 2) % 3]);
        let (over_ad, over_db) =
            (other_neighbours[(other_edge + 1) % 3], other_neighbours[(other_edge + 2) % 3]);
        mesh.triangles[triangle as usize] = [c, a, d];
        mesh.neighbours[triangle as usize] = [over_ca, over_ad, beyond];
        mesh.triangles[beyond as usize] = [d, b, c];
        mesh.neighbours[beyond as usize] = [over_db, over_bc, triangle];
        for (moved, before, now) in [(over_ad, beyond, triangle), (over_bc, triangle, beyond)] {
            if moved != NONE
                && let Some(entry) =
                    mesh.neighbours[moved as usize].iter_mut().find(|entry| **entry == before)
            {
                *entry = now;
            }
        }
        open.extend([(triangle, 0), (triangle, 1), (beyond, 0), (beyond, 1)]);
    }
}

/// The tangent of the minimum angle, 0 if an edge joins two vertices of one side.
pub(crate) fn least_tangent(mesh: &Triangulation, points: &[DVec2], sides: &Sides) -> f64 {
    let tangents = mesh.triangles.iter().zip(&mesh.neighbours).map(|(&corners, neighbours)| {
        let is_within_side = (0..3).any(|edge| {
            neighbours[edge] != NONE && sides.has_both(corners[edge], corners[(edge + 1) % 3])
        });
        let at = corners.map(|corner| points[corner as usize]);
        if is_within_side { 0.0 } else { min_angle_tangent(at) }
    });
    tangents.fold(f64::INFINITY, f64::min)
}
