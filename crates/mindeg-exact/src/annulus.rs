//! Degree 4 with a hole: a domain of one hole has it if and only if both rings have as many vertices and one of as
//! many strips between them, which alternate, is admissible.
//!
//! The degrees of n vertices add up to 4n, so with degree 4 every vertex has two chords, no triangle is an ear,
//! and each of the n triangles has one boundary edge. So no chord joins two vertices of one ring, and the
//! triangles are a strip around the hole, in which each vertex has one triangle that moves on along the other
//! ring: it alternates, as drawn here with the outer ring x, the inner one y and the shift s.
//!
//! ```text
//!     x0----x1----x2---
//!      | \   | \   | \
//!     ys---y(s+1)-y(s+2)
//! ```

use crate::linked::{Corners, Linked};
use crate::problem::Problem;
use crate::visibility::sees;
use glam::DVec2;
use mindeg_mesh::planar::orientation;

/// The admissible strip of a domain of one hole, the only kind of triangulation of degree 4.
pub(crate) fn strip(problem: &Problem, mesh: &Linked) -> Option<Vec<[u32; 3]>> {
    let points = problem.points();
    let [outer, inner] = two_rings(points, &problem.next())?;
    let count = outer.len();
    if inner.len() != count {
        return None;
    }
    // The quadrilateral of a step: x and y, and the next of both.
    let corners_at = |shift: usize, step: usize| {
        let of = |ring: &[u32], at: usize| ring[at % count];
        [
            of(&outer, step),
            of(&outer, step + 1),
            of(&inner, step + shift),
            of(&inner, step + shift + 1),
        ]
    };
    let is_left = |corners: [u32; 3]| {
        let [a, b, c] = corners.map(|vertex| points[vertex as usize]);
        orientation(a, b, c) > 0.0
    };
    let turns_left = |&shift: &usize| {
        (0..count)
            .map(|step| corners_at(shift, step))
            .all(|[x, next_x, y, next_y]| is_left([x, next_x, y]) && is_left([next_x, next_y, y]))
    };
    // The triangles cover the domain, but its chords may pass vertices by less than the tolerance.
    let corners = Corners::new(points.len(), &mesh.triangles);
    let sides = problem.sides();
    let is_clear = sides.clear.is_some();
    let is_admissible = |a: u32, b: u32| {
        !sides.has_both(a, b) && sees(mesh, points, &corners, [a, b], is_clear, &mut 0)
    };
    let passes_none = |&shift: &usize| {
        (0..count)
            .map(|step| corners_at(shift, step))
            .all(|[x, next_x, y, _]| is_admissible(x, y) && is_admissible(next_x, y))
    };
    let shift = (0..count).filter(turns_left).find(passes_none)?;
    let triangles = |step: usize| {
        let [x, next_x, y, next_y] = corners_at(shift, step);
        [[x, next_x, y], [next_x, next_y, y]]
    };
    Some((0..count).flat_map(triangles).collect())
}

/// The outer and the inner ring, both counter-clockwise, of a domain of one hole.
fn two_rings(points: &[DVec2], next: &[u32]) -> Option<[Vec<u32>; 2]> {
    let order = |a: &u32, b: &u32| {
        let [a, b] = [a, b].map(|&vertex| points[vertex as usize]);
        a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y))
    };
    let ring = |start: u32| {
        let after = |vertex: &u32| Some(next[*vertex as usize]).filter(|&vertex| vertex != start);
        Vec::from_iter(std::iter::successors(Some(start), after))
    };
    let outer = ring((0..points.len() as u32).min_by(order)?);
    let mut is_outer = vec![false; points.len()];
    outer.iter().for_each(|&vertex| is_outer[vertex as usize] = true);
    let mut inner = ring((0..points.len() as u32).find(|&vertex| !is_outer[vertex as usize])?);
    inner.reverse();
    (outer.len() + inner.len() == points.len()).then_some([outer, inner])
}
