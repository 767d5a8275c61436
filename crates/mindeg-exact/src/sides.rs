//! The chords that no triangulation has: chords that join two vertices of one straight side, and chords
//! that pass a vertex.
//!
//! Points of a slanted side are rounded, and sides may bend by less than a billionth of a radian. So a
//! triangulation can have a chord within a side, behind which the boundary bulges by a hair. As well, a
//! chord may pass a reflex corner by a hair, through rounding: whether it does must not depend on how
//! the domain is turned. [`passes`] has one tolerance for both.
//!
//! [`Sides::of_triangulation`] flips such edges of a given triangulation. Where it cannot flip one within
//! a side, the side is not straight: then each of its edges is a side of its own. Where it cannot flip one
//! that passes a vertex, the domain is as thin as the tolerance: then a chord passes only what it touches,
//! exactly. After that the given triangulation has no forbidden chord, and what is proven of all others
//! holds beside it.

use crate::linked::{Linked, is_convex};
use glam::DVec2;
use mindeg_core::Boundary;
use mindeg_mesh::planar::{LEAST_TURN, passes};
use std::collections::BTreeSet;

/// The one or two straight sides of every vertex, and how near chords may pass other vertices.
#[derive(Clone, Debug)]
pub(crate) struct Sides {
    /// The sides of the boundary edges before and after each vertex.
    of: Vec<[u32; 2]>,
    /// Chords keep the tolerance of [`passes`]. Seen from the end of a chord that does not, the vertex is
    /// in the direction of its other end, up to this angle.
    pub(crate) clear: Option<f64>,
}

impl Sides {
    /// The sides of a convex polygon's vertices.
    pub(crate) fn of_boundary(boundary: &Boundary) -> Self {
        let sides = (0..).zip(boundary.sides());
        let after: Vec<u32> = sides.flat_map(|(side, len)| (0..len).map(move |_| side)).collect();
        let before = |vertex: usize| after[vertex.checked_sub(1).unwrap_or(after.len() - 1)];
        let of = (0..after.len()).map(|vertex| [before(vertex), after[vertex]]).collect();
        // Beyond a corner, chords turn by as much as the sides.
        Self { of, clear: None }
    }

    /// The sides of a triangulated domain's vertices; `side_of` names the side of the boundary edge
    /// that begins at each vertex. Flips edges of the triangulation until none is forbidden, and breaks
    /// the sides, or lets chords pass vertices, where that leaves some. O(n), and O(n) more for each round
    /// of flips.
    pub(crate) fn of_triangulation(mesh: &mut Linked, points: &[DVec2], side_of: &[u32]) -> Self {
        let mut sides = Self::of_boundary_edges(mesh, side_of);
        sides.clear = Some(largest_angle(mesh, points));
        let mut forbidden = sides.forbidden(mesh, points);
        while sides.flip_out(mesh, points, &forbidden) {
            forbidden = sides.forbidden(mesh, points);
        }
        if forbidden.is_empty() {
            return sides;
        }
        let broken: BTreeSet<u32> = forbidden
            .iter()
            .flat_map(|&(triangle, edge)| {
                let corners = mesh.triangles[triangle as usize];
                let [a, b] = [edge, (edge + 1) % 3].map(|at| sides.of[corners[at] as usize]);
                a.into_iter().filter(move |side| b.contains(side))
            })
            .collect();
        let kept: BTreeSet<u32> = side_of.iter().copied().filter(|s| !broken.contains(s)).collect();
        let kept = Vec::from_iter(kept);
        let of_edge = |(vertex, side)| match kept.binary_search(side) {
            Ok(rank) => rank as u32,
            Err(_) => kept.len() as u32 + vertex,
        };
        let side_of: Vec<u32> = (0..).zip(side_of).map(of_edge).collect();
        let broken = Self::of_boundary_edges(mesh, &side_of);
        let sides = Self { clear: sides.clear, ..broken };
        if sides.forbidden(mesh, points).is_empty() { sides } else { Self { clear: None, ..sides } }
    }

    fn of_boundary_edges(mesh: &Linked, side_of: &[u32]) -> Self {
        let mut of = vec![[u32::MAX; 2]; side_of.len()];
        for [from, to] in mesh.boundary_edges() {
            of[from as usize][1] = side_of[from as usize];
            of[to as usize][0] = side_of[from as usize];
        }
        Self { of, clear: None }
    }

    /// The edges between two triangles that are forbidden, each with one of the two.
    fn forbidden(&self, mesh: &Linked, points: &[DVec2]) -> Vec<(u32, usize)> {
        let is_forbidden = |&(triangle, edge): &(u32, usize)| {
            triangle < mesh.neighbours[triangle as usize][edge]
                && mesh
                    .corners_at(triangle, edge)
                    .is_some_and(|corners| self.forbids(points, corners))
        };
        let edges = (0..mesh.triangles.len() as u32).flat_map(|t| (0..3).map(move |e| (t, e)));
        edges.filter(is_forbidden).collect()
    }

    /// Flips those of these chords that may be flipped to one that is not forbidden; whether it flipped
    /// any.
    fn flip_out(&self, mesh: &mut Linked, points: &[DVec2], forbidden: &[(u32, usize)]) -> bool {
        let mut has_flipped = false;
        for &(triangle, edge) in forbidden {
            let Some(corners @ [a, b, c, d]) = mesh.corners_at(triangle, edge) else { continue };
            // An earlier flip may have turned this triangle into another one.
            let is_better = self.forbids(points, corners) && !self.forbids(points, [c, d, a, b]);
            if is_better && is_convex(corners.map(|corner| points[corner as usize])) {
                mesh.flip(triangle, edge);
                has_flipped = true;
            }
        }
        has_flipped
    }

    /// Whether no triangulation has the chord ab, beside which there are triangles with c and d.
    pub(crate) fn forbids(&self, points: &[DVec2], [a, b, c, d]: [u32; 4]) -> bool {
        let [from, to, c, d] = [a, b, c, d].map(|vertex| points[vertex as usize]);
        let passes = |vertex| passes([from, to], vertex);
        self.has_both(a, b) || (self.clear.is_some() && (passes(c) || passes(d)))
    }

    /// Whether one side has both vertices.
    pub(crate) fn has_both(&self, i: u32, j: u32) -> bool {
        let [a, b] = self.of[i as usize];
        let [c, d] = self.of[j as usize];
        a == c || a == d || b == c || b == d
    }
}

/// The largest angle by which, from the end of a chord, a vertex that it passes is beside its other end.
///
/// A vertex at height h above a chord, r and s from its ends, turns it by h / r + h / s. It is passed if that
/// is less than [`LEAST_TURN`], or if h is less than the rounding of a coordinate. From either end the
/// angle is less than that turn, and not above h / r.
fn largest_angle(mesh: &Linked, points: &[DVec2]) -> f64 {
    let edges = mesh.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let lengths = edges.map(|[a, b]| points[a as usize].distance(points[b as usize]));
    let shortest = lengths.fold(f64::INFINITY, f64::min);
    let largest = points.iter().map(|point| point.abs().max_element()).fold(0.0, f64::max);
    2.0 * (2.0 * f64::EPSILON * largest / shortest).clamp(LEAST_TURN, 1e-3)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sides(
        points: &[[f64; 2]],
        side_of: &[u32],
        triangles: &[[u32; 3]],
    ) -> (Sides, Vec<[u32; 3]>) {
        let points: Vec<DVec2> = points.iter().copied().map(DVec2::from).collect();
        let mut mesh = Linked::new(triangles.to_vec()).unwrap();
        let sides = Sides::of_triangulation(&mut mesh, &points, side_of);
        (sides, mesh.triangles)
    }

    #[test]
    fn a_chord_within_a_side_is_flipped() {
        let points = [[0.0, 0.0], [1.0, -1e-12], [2.0, 0.0], [1.0, 1.0]];
        let (sides, triangles) = sides(&points, &[0, 0, 1, 2], &[[0, 1, 2], [0, 2, 3]]);
        assert!(sides.has_both(0, 2));
        assert_eq!(triangles, [[1, 2, 3], [3, 0, 1]]);
        assert!(!sides.has_both(1, 3));
    }

    /// Every vertex is on the side, so whatever chord there is joins two of its vertices.
    #[test]
    fn a_side_that_needs_a_chord_is_broken() {
        let points = [[4.0, 4.0], [4.0, 5.0], [0.0, 30.0], [0.0, 0.0]];
        let triangles = [[0, 1, 3], [1, 2, 3]];
        for side_of in [[0, 0, 1, 0], [u32::MAX, u32::MAX, 1, u32::MAX]] {
            let (sides, kept) = sides(&points, &side_of, &triangles);
            assert_eq!(kept, triangles);
            assert!(!sides.has_both(1, 3) && !sides.has_both(0, 2));
            assert!((0..4).all(|v| sides.has_both(v, (v + 1) % 4)));
        }
    }

    #[test]
    fn a_chord_that_passes_a_vertex_is_flipped() {
        let points = [[0.0, 0.0], [1.0, -1e-3], [2.0, 0.0], [1.0, 1e-11]];
        let (sides, triangles) = sides(&points, &[0, 1, 2, 3], &[[0, 1, 2], [0, 2, 3]]);
        assert_eq!(triangles, [[1, 2, 3], [3, 0, 1]]);
        assert!(sides.clear.is_some());
    }

    /// Every triangulation of it has chords that pass vertices.
    #[test]
    fn a_corridor_thinner_than_the_tolerance_is_taken_without_it() {
        let points = [[0.0, 0.0], [4.0, 0.0], [3.0, 1e-12], [2.0, 1e-12], [1.0, 1e-12]];
        let (sides, _) = sides(&points, &[0, 1, 2, 3, 4], &[[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
        assert!(sides.clear.is_none() && !sides.has_both(0, 2));
    }
}
