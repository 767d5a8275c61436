//! A checker for triangulations of rings, with or without holes and interior points. Its only code in
//! common with the triangulators is the exact predicate [`robust::orient2d`].
//!
//! If all triangles are counter-clockwise, with every ring edge once in the ring's direction and
//! every other edge once in each direction, they cover every point as often as the rings wind
//! around it. If the rings bound a domain, they triangulate it.
//!
//! Limits: an interior point without a triangle is not reported.

use glam::DVec2;
use robust::{Coord, orient2d};
use thiserror::Error;

use crate::parallel::{first_of_blocks, sort_all};
use crate::planar::PlanarBoundary;

/// The degrees of a correct triangulation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Checked {
    /// The number of edges at each vertex, boundary edges included.
    pub degrees: Vec<u32>,
    /// The largest degree.
    pub max_degree: u32,
}

/// Why triangles are not a triangulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum CheckError {
    /// The number of triangles does not fit the rings. Only checked without interior points.
    #[error("found {found} triangles, expected {expected}")]
    TriangleCount {
        /// The number of triangles.
        found: usize,
        /// The number that the rings need.
        expected: usize,
    },
    /// A triangle has a vertex without a point.
    #[error("triangle {triangle} has vertex {vertex}, which does not exist")]
    NoSuchVertex {
        /// The index of the triangle.
        triangle: usize,
        /// The vertex.
        vertex: u32,
    },
    /// Two triangles on the same side of an edge, or a triangle outside a boundary edge.
    #[error("two triangles lie on the same side of edge {from}-{to}")]
    Overlap {
        /// The start of the edge.
        from: u32,
        /// The end of the edge.
        to: u32,
    },
    /// A boundary edge without a triangle, or another edge with a triangle on one side only.
    #[error("the edge from {from} to {to} has no triangle on its left")]
    Gap {
        /// The start of the edge.
        from: u32,
        /// The end of the edge.
        to: u32,
    },
    /// A triangle that is clockwise or flat; the check is exact.
    #[error("triangle {triangle} is clockwise or has no area")]
    NotCounterClockwise {
        /// Its index.
        triangle: usize,
    },
}

/// Checks that `triangles` triangulate the domain inside `boundary`. O(n log n).
///
/// `inner` are interior points; their vertices follow those of the boundary.
///
/// # Errors
///
/// The first fault, in the order of [`CheckError`].
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_mesh::check;
/// use mindeg_mesh::planar::PlanarBoundary;
///
/// let ring = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(DVec2::from);
/// let square = PlanarBoundary::new(&[ring])?;
/// let checked = check::triangulation(&square, &[], &[[0, 1, 2], [0, 2, 3]])?;
/// assert_eq!(checked.degrees, [3, 2, 3, 2]);
/// let error = check::triangulation(&square, &[], &[[0, 1, 2], [0, 3, 2]]).unwrap_err();
/// assert_eq!(error.to_string(), "two triangles lie on the same side of edge 0-3");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn triangulation(
    boundary: &PlanarBoundary,
    inner: &[DVec2],
    triangles: &[[u32; 3]],
) -> Result<Checked, CheckError> {
    triangulation_around(boundary, inner, &[], triangles)
}

/// [`triangulation`] with edges inside that have no triangle on their left, as at a hole between lines. That these bound
/// holes is not checked.
///
/// # Errors
///
/// The first fault, in the order of [`CheckError`].
pub fn triangulation_around(
    boundary: &PlanarBoundary,
    inner: &[DVec2],
    open: &[[u32; 2]],
    triangles: &[[u32; 3]],
) -> Result<Checked, CheckError> {
    let on_rings = boundary.points().len();
    let vertices = on_rings + inner.len();
    let point = |vertex: u32| match (vertex as usize).checked_sub(on_rings) {
        Some(index) => inner[index],
        None => boundary.points()[vertex as usize],
    };
    if inner.is_empty() {
        // By Euler's formula; the outer ring does not count as a hole.
        let found = triangles.len();
        let expected = (on_rings + 2 * boundary.ring_count()).saturating_sub(4);
        if found != expected {
            return Err(CheckError::TriangleCount { found, expected });
        }
    }
    let count = u32::try_from(triangles.len()).unwrap_or(u32::MAX);
    let missing = first_of_blocks(count, |range| {
        range.map(|triangle| triangle as usize).find_map(|triangle| {
            let vertex = triangles[triangle].into_iter().find(|&v| v as usize >= vertices)?;
            Some(CheckError::NoSuchVertex { triangle, vertex })
        })
    });
    if let Some(missing) = missing {
        return Err(missing);
    }
    let edges = paired(boundary, open, triangles)?;
    let turned = first_of_blocks(count, |range| {
        range.map(|triangle| triangle as usize).find(|&triangle| {
            let [a, b, c] = triangles[triangle].map(point);
            let [a, b, c] = [a, b, c].map(|point| Coord { x: point.x, y: point.y });
            // A point that is not finite fails here, too.
            let is_counter_clockwise = orient2d(a, b, c) > 0.0;
            !is_counter_clockwise
        })
    });
    if let Some(triangle) = turned {
        return Err(CheckError::NotCounterClockwise { triangle });
    }
    let mut degrees = vec![0; vertices];
    for vertex in edges.into_iter().flat_map(|edge| [(edge >> 32) as u32, edge as u32]) {
        degrees[vertex as usize] += 1;
    }
    let max_degree = degrees.iter().copied().max().unwrap_or(0);
    Ok(Checked { degrees, max_degree })
}

/// All edges, smaller end first, if each has exactly one half-edge in either direction. Half-edges
/// come from the triangles, and from the outer sides of the rings.
fn paired(
    boundary: &PlanarBoundary,
    open: &[[u32; 2]],
    triangles: &[[u32; 3]],
) -> Result<Vec<u64>, CheckError> {
    let outer = boundary.edges().map(|[from, to]| [to, from]).chain(open.iter().copied());
    let inner = triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    // Half-edges to the larger end, then half-edges to the smaller end.
    let mut halves =
        [Vec::with_capacity(2 * triangles.len()), Vec::with_capacity(2 * triangles.len())];
    for [from, to] in inner.chain(outer) {
        let key = (u64::from(from.min(to)) << 32) | u64::from(from.max(to));
        halves[usize::from(from > to)].push(key);
    }
    halves.iter_mut().for_each(|halves| sort_all(halves));
    let ends = |key: u64, is_to_larger: bool| {
        let [low, high] = [(key >> 32) as u32, key as u32];
        if is_to_larger { [low, high] } else { [high, low] }
    };
    for (halves, is_to_larger) in halves.iter().zip([true, false]) {
        if let Some(twice) = halves.windows(2).find(|pair| pair[0] == pair[1]) {
            let [from, to] = ends(twice[0], is_to_larger);
            return Err(CheckError::Overlap { from, to });
        }
    }
    let [up, down] = halves;
    if let Some(at) = (0..up.len().max(down.len())).find(|&at| up.get(at) != down.get(at)) {
        let [first_up, first_down] =
            [&up, &down].map(|halves| halves.get(at).copied().unwrap_or(u64::MAX));
        // The smaller of the two half-edges has no partner.
        let [from, to] = ends(first_up.min(first_down), first_up > first_down);
        return Err(CheckError::Gap { from, to });
    }
    Ok(up)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_error_is_found() {
        let points =
            [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (1.0, 1.0), (1.0, 2.0), (2.0, 2.0)];
        let points = points.map(DVec2::from);
        let square = [[0, 1, 2], [0, 2, 3]];
        let outer = PlanarBoundary::new(&[&points[..4]]).unwrap();
        let of_square = |triangles: &[[u32; 3]]| {
            triangulation(&outer, &[], triangles)
                .map(|checked| checked.degrees)
                .map_err(|error| error.to_string())
        };
        let fails = |triangles: &[[u32; 3]], message: &str| {
            assert_eq!(of_square(triangles), Err(message.to_owned()));
        };
        assert_eq!(of_square(&square), Ok(vec![3, 2, 3, 2]));
        fails(&[[0, 1, 2]], "found 1 triangles, expected 2");
        fails(&[[0, 1, 2], [0, 2, 9]], "triangle 1 has vertex 9, which does not exist");
        fails(&[[0, 1, 2], [0, 3, 2]], "two triangles lie on the same side of edge 0-3");
        fails(&[[0, 1, 2], [0, 0, 3]], "two triangles lie on the same side of edge 0-3");
        // All edges have their partners, and yet a triangle is flat.
        let flat = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (0.0, 1.0)].map(DVec2::from);
        let flat = PlanarBoundary::new(&[flat]).unwrap();
        let of_flat = triangulation(&flat, &[], &[[0, 1, 2], [0, 2, 3]]);
        assert_eq!(of_flat, Err(CheckError::NotCounterClockwise { triangle: 0 }));
        fails(&[[0, 1, 2], [0, 1, 3]], "two triangles lie on the same side of edge 0-1");
        fails(&[[0, 1, 2], [1, 3, 0]], "two triangles lie on the same side of edge 0-1");

        // A hole: clockwise, and nothing in it.
        let with_hole = PlanarBoundary::new(&[&points[..4], &points[4..]]).unwrap();
        let around = [[0, 1, 4], [1, 6, 4], [1, 2, 6], [2, 3, 6], [3, 5, 6], [3, 0, 5], [0, 4, 5]];
        let check = |triangles: &[[u32; 3]]| triangulation(&with_hole, &[], triangles);
        assert_eq!(check(&around).map(|checked| checked.degrees), Ok(vec![4, 4, 3, 4, 4, 4, 5]));
        let mut filled = around;
        // The triangle in the hole replaces a triangle beside it.
        filled[6] = [4, 6, 5];
        assert_eq!(check(&filled), Err(CheckError::Overlap { from: 4, to: 6 }));
        filled[6] = [0, 1, 4];
        assert_eq!(check(&filled), Err(CheckError::Overlap { from: 0, to: 1 }));

        // With an interior point the number of triangles is not checked, but the edges are.
        let with_point = |triangles: &[[u32; 3]]| triangulation(&outer, &points[4..5], triangles);
        let star = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
        assert_eq!(with_point(&star).map(|checked| checked.max_degree), Ok(4));
        assert_eq!(with_point(&star[..3]), Err(CheckError::Gap { from: 3, to: 0 }));
        assert_eq!(with_point(&star[1..]), Err(CheckError::Gap { from: 0, to: 1 }));
    }
}
