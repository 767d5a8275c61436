//! A checker for triangulations of any polygon, with or without holes; it shares nothing with
//! the solver but the predicate [`robust::orient2d`].
//!
//! Triangles that are all counter-clockwise, that have every ring edge once in the ring's direction
//! and every other edge once in each direction, cover every point as often as the rings wind
//! around it: where the rings bound a domain, they are a triangulation of it.

use glam::DVec2;
use robust::{Coord, orient2d};
use std::collections::BTreeMap;
use thiserror::Error;

/// The degrees of a correct triangulation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Checked {
    /// The number of edges at each vertex, boundary edges included.
    pub degrees: Vec<u32>,
    /// The largest of them.
    pub max_degree: u32,
}

/// Why triangles are not a triangulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum CheckError {
    /// A ring or a triangle has a vertex without a point.
    #[error("vertex {vertex} has no point")]
    NoSuchVertex {
        /// The vertex.
        vertex: u32,
    },
    /// A triangle that is clockwise or has no area, exactly.
    #[error("triangle {triangle} is clockwise or has no area")]
    NotCounterClockwise {
        /// Its index.
        triangle: usize,
    },
    /// An edge of a ring that is not the edge of one triangle.
    #[error("the boundary edge from {from} to {to} has {triangles} triangles, expected 1")]
    BoundaryEdge {
        /// Where it begins.
        from: u32,
        /// Where it ends.
        to: u32,
        /// The number of triangles that have it, in either direction.
        triangles: usize,
    },
    /// Another edge that is not the edge of one triangle on either side.
    #[error(
        "the edge from {from} to {to} has {left} triangles on the left and {right} on the right"
    )]
    InnerEdge {
        /// The smaller end.
        from: u32,
        /// The larger end.
        to: u32,
        /// The triangles on the left.
        left: usize,
        /// The triangles on the right.
        right: usize,
    },
}

/// Checks that `triangles` triangulate the domain on the left of `rings`. O(n log n).
///
/// The outer ring is counter-clockwise, holes are clockwise. The check assumes that rings do not
/// cross.
///
/// # Errors
///
/// The first fault, in the order of [`CheckError`].
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_exact::check;
///
/// let points = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(DVec2::from);
/// let ring = vec![0, 1, 2, 3];
/// let checked = check::triangulation(&points, &[ring.clone()], &[[0, 1, 2], [0, 2, 3]])?;
/// assert_eq!(checked.degrees, [3, 2, 3, 2]);
/// let error = check::triangulation(&points, &[ring], &[[0, 1, 2]]).unwrap_err();
/// assert_eq!(error.to_string(), "the boundary edge from 2 to 3 has 0 triangles, expected 1");
/// # Ok::<(), check::CheckError>(())
/// ```
pub fn triangulation(
    points: &[DVec2],
    rings: &[Vec<u32>],
    triangles: &[[u32; 3]],
) -> Result<Checked, CheckError> {
    let vertices = rings.iter().flatten().chain(triangles.as_flattened());
    if let Some(&vertex) = vertices.into_iter().find(|&&vertex| vertex as usize >= points.len()) {
        return Err(CheckError::NoSuchVertex { vertex });
    }
    for (triangle, corners) in triangles.iter().enumerate() {
        let [a, b, c] = corners.map(|corner| points[corner as usize]);
        let [a, b, c] = [a, b, c].map(|point| Coord { x: point.x, y: point.y });
        // A point that is not finite makes this fail, too.
        if orient2d(a, b, c) > 0.0 {
            continue;
        }
        return Err(CheckError::NotCounterClockwise { triangle });
    }
    // For every edge from its smaller to its larger end the triangles on the left and on the right.
    let mut edges = BTreeMap::<(u32, u32), [usize; 2]>::new();
    for &[a, b, c] in triangles {
        for (from, to) in [(a, b), (b, c), (c, a)] {
            let is_backward = usize::from(from > to);
            edges.entry((from.min(to), from.max(to))).or_default()[is_backward] += 1;
        }
    }
    let mut degrees = vec![0; points.len()];
    for ring in rings {
        for (index, &from) in ring.iter().enumerate() {
            let to = ring[(index + 1) % ring.len()];
            let [left, right] = edges.remove(&(from.min(to), from.max(to))).unwrap_or_default();
            let as_it_should = if from < to { (1, 0) } else { (0, 1) };
            if (left, right) != as_it_should {
                return Err(CheckError::BoundaryEdge { from, to, triangles: left + right });
            }
            degrees[from as usize] += 1;
            degrees[to as usize] += 1;
        }
    }
    for (&(from, to), &[left, right]) in &edges {
        if (left, right) != (1, 1) {
            return Err(CheckError::InnerEdge { from, to, left, right });
        }
        degrees[from as usize] += 1;
        degrees[to as usize] += 1;
    }
    let max_degree = degrees.iter().copied().max().unwrap_or(0);
    Ok(Checked { degrees, max_degree })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_error_is_found() {
        let points =
            [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (1.0, 1.0), (1.0, 2.0), (2.0, 2.0)];
        let points = points.map(DVec2::from);
        let outer = [vec![0, 1, 2, 3]];
        let check = |rings: &[Vec<u32>], triangles: &[[u32; 3]]| {
            triangulation(&points, rings, triangles).map(|checked| checked.degrees)
        };
        let square = [[0, 1, 2], [0, 2, 3]];
        assert_eq!(check(&outer, &square), Ok(vec![3, 2, 3, 2, 0, 0, 0]));
        assert_eq!(check(&[vec![0, 9]], &square), Err(CheckError::NoSuchVertex { vertex: 9 }));
        let clockwise = [[0, 1, 2], [0, 3, 2]];
        let error = CheckError::NotCounterClockwise { triangle: 1 };
        assert_eq!(check(&outer, &clockwise), Err(error));
        let flat = [[0, 6, 2]];
        let error = CheckError::NotCounterClockwise { triangle: 0 };
        assert_eq!(check(&outer, &flat), Err(error));
        let crossing = [[0, 1, 2], [0, 1, 3]];
        let error = CheckError::BoundaryEdge { from: 0, to: 1, triangles: 2 };
        assert_eq!(check(&outer, &crossing), Err(error));
        let one_more = [[0, 1, 2], [0, 2, 3], [4, 6, 5]];
        let error = CheckError::InnerEdge { from: 4, to: 5, left: 0, right: 1 };
        assert_eq!(check(&outer, &one_more), Err(error));

        // A hole: clockwise, and nothing in it.
        let hole = vec![4, 5, 6];
        let around = [[0, 1, 4], [1, 6, 4], [1, 2, 6], [2, 3, 6], [3, 5, 6], [3, 0, 5], [0, 4, 5]];
        let degrees = Ok(vec![4, 4, 3, 4, 4, 4, 5]);
        assert_eq!(check(&[outer[0].clone(), hole], &around), degrees);
        assert!(check(&[outer[0].clone(), vec![4, 6, 5]], &around).is_err());
    }
}
