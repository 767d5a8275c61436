//! Delaunay by flips: a lower bound on the largest minimum angle.

use crate::linked::{Linked, is_convex};
use crate::sides::Sides;
use glam::DVec2;
use robust::{Coord, incircle};

/// Flips edges until the triangulation is constrained Delaunay, except for forbidden chords; or
/// until 1000 flips a vertex, which leaves some other triangulation.
pub(crate) fn make_delaunay(mesh: &mut Linked, points: &[DVec2], sides: &Sides) {
    let mut flips_left = 1000 * points.len();
    let mut open: Vec<(u32, usize)> =
        (0..mesh.triangles.len() as u32).flat_map(|t| (0..3).map(move |edge| (t, edge))).collect();
    while let Some((triangle, edge)) = open.pop() {
        let Some(corners @ [a, b, c, d]) = mesh.corners_at(triangle, edge) else { continue };
        let at = |vertex: u32| points[vertex as usize];
        let coord = |vertex: u32| Coord { x: at(vertex).x, y: at(vertex).y };
        let is_better = incircle(coord(a), coord(b), coord(c), coord(d)) > 0.0
            && !sides.forbids(points, [c, d, a, b])
            && is_convex(corners.map(at));
        if !is_better || flips_left == 0 {
            continue;
        }
        flips_left -= 1;
        let beyond = mesh.flip(triangle, edge);
        open.extend([(triangle, 0), (triangle, 1), (beyond, 0), (beyond, 1)]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::least_tangent;
    use mindeg_core::Boundary;

    #[test]
    fn a_fan_becomes_delaunay() {
        let point = |index: u32| {
            let angle = 0.4 * f64::from(index) + 0.05 * f64::from(index % 3);
            DVec2::new(3.0 * libm::cos(angle), libm::sin(angle))
        };
        let points: Vec<DVec2> = (0..15).map(point).collect();
        let fan = (1..14).map(|vertex| [0, vertex, vertex + 1]).collect();
        let mut mesh = Linked::new(fan).unwrap();
        let sides = Sides::of_boundary(&Boundary::new(&[1; 15]).unwrap());
        let before = least_tangent(&points, &mesh.triangles);
        make_delaunay(&mut mesh, &points, &sides);
        assert_eq!(mesh.triangles.len(), 13);
        assert!(least_tangent(&points, &mesh.triangles) > 2.0 * before);
        let coord =
            |vertex: u32| Coord { x: points[vertex as usize].x, y: points[vertex as usize].y };
        for &[a, b, c] in &mesh.triangles {
            let area = (points[b as usize] - points[a as usize])
                .perp_dot(points[c as usize] - points[a as usize]);
            assert!(area > 0.0);
            for other in (0..15).filter(|other| ![a, b, c].contains(other)) {
                assert!(incircle(coord(a), coord(b), coord(c), coord(other)) <= 0.0);
            }
        }
    }
}
