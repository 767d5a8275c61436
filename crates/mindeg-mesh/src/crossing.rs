//! Finds triangles that cross others.
//!
//! Two triangles cross if they have a common point besides the corners and edges that they share.
//! So triangles that only touch count, and so do triangles that cover each other in a plane.
//! Corners are shared if they are the same vertex. Flat triangles cross nothing.
//!
//! Predicates are exact (Shewchuk's, from `robust`), as long as products of three coordinates
//! neither overflow nor underflow.

mod triangles;

use crate::Bounds;
use crate::box_tree::BoxTree;
use crate::parallel::blocks;
use glam::DVec3;
use std::ops::Range;
pub use triangles::cross;

/// For each triangle of a range that crosses another triangle of the mesh, the pair: the triangle
/// of the range and the first triangle that it crosses. In order. O(n log n) for n triangles, plus,
/// for each triangle of the range, the tests of all triangles whose boxes meet its box; shared by
/// all threads.
///
/// # Panics
///
/// If the range exceeds the triangles, or a triangle names a vertex that does not exist.
///
/// # Example
///
/// ```
/// use glam::DVec3;
/// use mindeg_mesh::crossing::crossings;
///
/// let points = [(0, 0, 0), (4, 0, 0), (0, 4, 0), (1, 1, -1), (1, 1, 1), (9, 9, 0)];
/// let points = points.map(|(x, y, z)| DVec3::new(x.into(), y.into(), z.into()));
/// assert_eq!(crossings(&points, &[[0, 1, 2], [3, 4, 5]], 1..2), [[1, 0]]);
/// assert_eq!(crossings(&points, &[[0, 1, 2], [1, 5, 2]], 1..2), [[0; 2]; 0]);
/// ```
pub fn crossings(positions: &[DVec3], triangles: &[[u32; 3]], range: Range<u32>) -> Vec<[u32; 2]> {
    let around = |corners: &[u32; 3]| {
        let [a, b, c] = corners.map(|vertex| positions[vertex as usize]);
        Bounds { min: a.min(b).min(c), max: a.max(b).max(c) }
    };
    let tree = BoxTree::new(triangles.iter().map(around).collect());
    let found = blocks(range.len() as u32, |block| {
        let mut near = Vec::new();
        let mut found = Vec::new();
        for index in block {
            let triangle = range.start + index;
            near.clear();
            tree.meet_item(triangle, &mut near);
            near.sort_unstable();
            let corners = triangles[triangle as usize];
            let crossed = near.iter().find(|&&other| {
                other != triangle && cross(positions, corners, triangles[other as usize])
            });
            found.extend(crossed.map(|&other| [triangle, other]));
        }
        found
    });
    found.concat()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// The tree finds the same crossings as a comparison of all pairs.
        #[test]
        fn the_tree_misses_nothing(
            points in prop::collection::vec(prop::array::uniform3(0_i8..6), 8),
            triangles in prop::collection::vec(prop::array::uniform3(0_u32..8), 1..40),
            start in 0_u32..40,
        ) {
            let points: Vec<DVec3> =
                points.into_iter().map(|p| DVec3::from(p.map(f64::from))).collect();
            let count = triangles.len() as u32;
            let start = start.min(count);
            let all = |t: u32| (0..count).filter(move |&other| other != t);
            let expected: Vec<[u32; 2]> = (start..count)
                .filter_map(|t| {
                    let own = triangles[t as usize];
                    all(t).find(|&o| cross(&points, own, triangles[o as usize])).map(|o| [t, o])
                })
                .collect();
            prop_assert_eq!(crossings(&points, &triangles, start..count), expected);
        }
    }
}
