//! The straight sides of vertices: no chord joins two vertices of one side.
//!
//! Points of a slanted side are rounded, and sides may bend by less than a billionth of a radian. So a
//! triangulation can have a chord within a side, behind which the boundary bulges by a hair.
//! [`Sides::of_triangulation`] flips such a chord; where it cannot, the side is not straight: then each
//! of its edges is a side of its own. After that the given triangulation uses no chord that is
//! forbidden, and what is proven of all others holds beside it.

use crate::triangulation::{NONE, Triangulation, is_convex};
use glam::DVec2;
use mindeg_core::Boundary;
use std::collections::BTreeSet;

/// The one or two straight sides of every vertex.
#[derive(Clone, Debug)]
pub(crate) struct Sides {
    /// The sides of the boundary edges before and after each vertex.
    of: Vec<[u32; 2]>,
}

impl Sides {
    /// The sides of a convex polygon's vertices.
    pub(crate) fn of_boundary(boundary: &Boundary) -> Self {
        let sides = (0..).zip(boundary.sides());
        let after: Vec<u32> = sides.flat_map(|(side, len)| (0..len).map(move |_| side)).collect();
        let before = |vertex: usize| after[vertex.checked_sub(1).unwrap_or(after.len() - 1)];
        Self { of: (0..after.len()).map(|vertex| [before(vertex), after[vertex]]).collect() }
    }

    /// The sides of a triangulated domain's vertices; `side_of` names the side of the boundary edge
    /// that begins at each vertex. Flips edges of the triangulation until none is within a side, and
    /// breaks the sides where that leaves some. O(n), and O(n) more for each round of flips.
    pub(crate) fn of_triangulation(
        mesh: &mut Triangulation,
        points: &[DVec2],
        side_of: &[u32],
    ) -> Self {
        let sides = Self::of_boundary_edges(mesh, side_of);
        let mut within = sides.chords_within(mesh);
        while sides.flip_out(mesh, points, &within) {
            within = sides.chords_within(mesh);
        }
        if within.is_empty() {
            return sides;
        }
        let broken: BTreeSet<u32> = within
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
        Self::of_boundary_edges(mesh, &side_of)
    }

    fn of_boundary_edges(mesh: &Triangulation, side_of: &[u32]) -> Self {
        let mut of = vec![[u32::MAX; 2]; side_of.len()];
        for [from, to] in mesh.boundary_edges() {
            of[from as usize][1] = side_of[from as usize];
            of[to as usize][0] = side_of[from as usize];
        }
        Self { of }
    }

    /// The edges between two triangles that join vertices of one side, each with one of the two.
    fn chords_within(&self, mesh: &Triangulation) -> Vec<(u32, usize)> {
        let is_within = |&(triangle, edge): &(u32, usize)| {
            let corners = mesh.triangles[triangle as usize];
            let beyond = mesh.neighbours[triangle as usize][edge];
            beyond != NONE
                && triangle < beyond
                && self.has_both(corners[edge], corners[(edge + 1) % 3])
        };
        let edges = (0..mesh.triangles.len() as u32).flat_map(|t| (0..3).map(move |e| (t, e)));
        edges.filter(is_within).collect()
    }

    /// Flips those of these chords that may be flipped to one between two sides; whether it flipped any.
    fn flip_out(
        &self,
        mesh: &mut Triangulation,
        points: &[DVec2],
        within: &[(u32, usize)],
    ) -> bool {
        let mut has_flipped = false;
        for &(triangle, edge) in within {
            let Some(corners @ [a, b, c, d]) = mesh.corners_at(triangle, edge) else { continue };
            // An earlier flip may have turned this triangle into another one.
            let is_within = self.has_both(a, b) && !self.has_both(c, d);
            if is_within && is_convex(corners.map(|corner| points[corner as usize])) {
                mesh.flip(triangle, edge);
                has_flipped = true;
            }
        }
        has_flipped
    }

    /// Whether one side has both vertices.
    pub(crate) fn has_both(&self, i: u32, j: u32) -> bool {
        let [a, b] = self.of[i as usize];
        let [c, d] = self.of[j as usize];
        a == c || a == d || b == c || b == d
    }
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
        let mut mesh = Triangulation::new(triangles.to_vec()).unwrap();
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
}
