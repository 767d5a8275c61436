//! Where a Delaunay triangulation is one of several.
//!
//! An interior edge whose two triangles lie on one circle can be exchanged for the other
//! diagonal, and the result is as Delaunay as before, with the same minimum angle but other
//! degrees. Equally spaced boundary points are full of such ties.
//!
//! Points are rounded, so ties are seldom exact: what counts is whether moving the points by
//! their rounding can bring all four onto one circle. The in-circle determinant of a, b, c, d
//! is twice the area of abc times `r² - |d - o|²`, with o the center and r the radius of their
//! circle. Near a tie its derivative by d is therefore `2r` times twice the area of abc, and
//! likewise for the other three; the four areas add up to twice the quadrilateral's.
//!
//! Limits: `triangles` must be a triangulation, else the count means nothing.

use glam::DVec2;
use robust::{Coord, incircle};

/// How far a coordinate may be from where the point should be, in units of the rounding of
/// the largest coordinate: a few operations lie between a side's ends and a point on it.
const ROUNDINGS: f64 = 4.0;

/// The number of interior edges with all four vertices of their two triangles on one circle,
/// up to the rounding of coordinates. O(n log n).
///
/// It is the same for every Delaunay triangulation of the same points.
///
/// # Example
///
/// ```
/// use glam::DVec2;
///
/// let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(DVec2::from);
/// assert_eq!(mindeg_compare::tie_count(&square, &[[0, 1, 2], [0, 2, 3]]), 1);
/// ```
///
/// # Panics
///
/// When a triangle names a vertex that has no point.
#[must_use]
pub fn tie_count(points: &[DVec2], triangles: &[[u32; 3]]) -> u32 {
    let largest = points.iter().map(|point| point.abs().max_element()).fold(0.0, f64::max);
    let rounding = ROUNDINGS * f64::EPSILON * largest;
    // Every edge with its opposite vertex; the two triangles of an edge are neighbours in the list.
    let mut edges: Vec<[u32; 3]> = triangles
        .iter()
        .flat_map(|&[a, b, c]| [[a, b, c], [b, c, a], [c, a, b]])
        .map(|[a, b, across]| [a.min(b), a.max(b), across])
        .collect();
    edges.sort_unstable();
    let ties = edges.windows(2).filter(|pair| {
        let ([a, b, c], [a2, b2, d]) = (pair[0], pair[1]);
        [a, b] == [a2, b2] && is_tie([a, b, c, d].map(|vertex| points[vertex as usize]), rounding)
    });
    ties.count() as u32
}

/// Whether a, b and the vertices c and d opposite the edge ab are on one circle.
fn is_tie([a, b, c, d]: [DVec2; 4], rounding: f64) -> bool {
    let doubled_area = |p: DVec2, q: DVec2, r: DVec2| (q - p).perp_dot(r - p).abs();
    let coordinates = |point: DVec2| Coord { x: point.x, y: point.y };
    let determinant = incircle(coordinates(a), coordinates(b), coordinates(c), coordinates(d));
    let area = doubled_area(a, b, c);
    let radius = a.distance(b) * b.distance(c) * c.distance(a) / (2.0 * area);
    let quadrilateral = area + doubled_area(a, b, d);
    determinant.abs() <= 2.0 * radius * rounding * 2.0 * quadrilateral
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Reference;
    use mindeg::{Domain, Outline, Rectangle, Side};
    use std::time::Duration;

    fn ties(rectangle: Rectangle, sides: [u64; 4]) -> u32 {
        let sides = sides.map(Side::count).to_vec();
        let domain = Domain::new(Outline::Rectangle(rectangle), sides).unwrap();
        let boundary = domain.boundary().unwrap();
        let limit = Duration::from_secs(60);
        let timed = Reference::Delaunay.triangulate(&domain, &boundary, limit).unwrap();
        tie_count(boundary.points(), &timed.triangles)
    }

    #[test]
    fn rounding_neither_hides_ties_nor_makes_them() {
        let rectangle = Rectangle::new(4.0, 3.0);
        let turned = Rectangle { rotation: 33.0, ..rectangle };
        let far = Rectangle { origin: DVec2::new(500_000.0, 4_650_000.0), ..turned };
        let tiny = Rectangle { width: 4e-20, height: 3e-20, ..turned };
        // Counted with rational arithmetic: for every circle through m points with none inside,
        // m - 3.
        for (sides, expected) in [
            ([1, 1, 1, 1], 1),
            ([2, 2, 2, 2], 0),
            ([8, 6, 8, 6], 10),
            ([8, 6, 8, 5], 7),
            ([10, 10, 10, 10], 2),
            ([14, 3, 5, 2], 0),
        ] {
            for rectangle in [rectangle, turned, far, tiny] {
                assert_eq!(ties(rectangle, sides), expected, "{sides:?} {rectangle:?}");
            }
        }
    }
}
