//! A checker for any list of triangles on a boundary, from any source.
//!
//! It uses the interval counts and the list alone and shares no code with the constructions, so
//! that it can find their faults.
//!
//! Limits: it ignores positions. A list that passes can fold over in the plane if the polygon is
//! not convex.

use alloc::vec::Vec;
use core::fmt;

/// The degrees of a correct triangulation; see [`verify`].
///
/// # Example
///
/// ```
/// # use mindeg_core::{Defect, Verified, verify};
/// let Verified { max_degree, degrees } = verify(&[1, 1, 1, 1], [[0, 1, 3], [1, 2, 3]])?;
/// assert_eq!(max_degree, 3);
/// assert_eq!(degrees, [2, 3, 2, 3]);
/// # Ok::<(), Defect>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Verified {
    /// The largest number of edges at a vertex, boundary edges included.
    pub max_degree: u32,
    /// The number of edges at every vertex, boundary edges included.
    pub degrees: Vec<u32>,
}

/// The first defect in a list of triangles.
///
/// A triangle is its index in the list, counted from 0.
///
/// # Example
///
/// ```
/// use mindeg_core::{Defect, verify};
///
/// let defect = verify(&[1, 1, 1, 1], [[0, 1, 3], [1, 2, 0]]).unwrap_err();
/// assert_eq!(defect, Defect::MissingBoundaryEdge { edge: [2, 3] });
/// assert_eq!(defect.to_string(), "the boundary edge from 2 to 3 has no triangle");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Defect {
    /// The interval counts do not describe a polygon: too few sides, a side without intervals, or
    /// too many vertices. [`Boundary::new`](crate::Boundary::new) reports which.
    NoPolygon,
    /// The list does not have n - 2 triangles.
    WrongCount {
        /// n - 2.
        expected: u64,
        /// The length of the list.
        found: u64,
    },
    /// A vertex index is not below n.
    NoSuchVertex {
        /// The triangle.
        triangle: u64,
        /// The vertex.
        vertex: u32,
    },
    /// A triangle has a vertex twice.
    RepeatedVertex {
        /// The triangle.
        triangle: u64,
        /// The vertex.
        vertex: u32,
    },
    /// A triangle is clockwise.
    Clockwise {
        /// The triangle.
        triangle: u64,
    },
    /// A triangle has all vertices on one side, so it has no area.
    Flat {
        /// The triangle.
        triangle: u64,
        /// The side, counted from 0.
        side: usize,
    },
    /// More than one triangle has an edge in this direction.
    RepeatedEdge {
        /// The edge, in the direction that occurs more than once.
        edge: [u32; 2],
    },
    /// An interior edge has only one triangle.
    OpenEdge {
        /// The edge, in the direction that occurs.
        edge: [u32; 2],
    },
    /// A boundary edge has no triangle.
    MissingBoundaryEdge {
        /// The edge, counter-clockwise.
        edge: [u32; 2],
    },
}

impl fmt::Display for Defect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NoPolygon => f.write_str(
                "the interval counts do not describe a polygon: use at least 3 sides, at least 1 \
                 interval on each and at most 4294967294 in total",
            ),
            Self::WrongCount { expected, found } => {
                write!(f, "found {found} triangles, expected {expected}")
            }
            Self::NoSuchVertex { triangle, vertex } => {
                write!(f, "triangle {triangle} has vertex {vertex}, which does not exist")
            }
            Self::RepeatedVertex { triangle, vertex } => {
                write!(f, "triangle {triangle} has vertex {vertex} twice")
            }
            Self::Clockwise { triangle } => {
                write!(f, "triangle {triangle} is clockwise; reverse its vertices")
            }
            Self::Flat { triangle, side } => {
                write!(f, "triangle {triangle} is flat: all its vertices lie on side {}", side + 1)
            }
            Self::RepeatedEdge { edge: [from, to] } => {
                write!(f, "more than one triangle has the edge from {from} to {to}")
            }
            Self::OpenEdge { edge: [from, to] } => {
                write!(f, "the interior edge from {from} to {to} has one triangle, not two")
            }
            Self::MissingBoundaryEdge { edge: [from, to] } => {
                write!(f, "the boundary edge from {from} to {to} has no triangle")
            }
        }
    }
}

impl core::error::Error for Defect {}

/// Checks that `triangles` triangulate the boundary with these interval counts.
///
/// The requirements are: n-2 triangles, each counter-clockwise and none flat; every boundary edge
/// once; every interior edge twice, in opposite directions. O(n log n) time, O(n) memory.
///
/// These requirements suffice. In a convex polygon, a counter-clockwise triangle of three boundary
/// vertices that are not all on one side has positive area. If every interior edge occurs once in
/// each direction, the outlines of the triangles cancel except for the outline of the polygon, so
/// the triangles cover every inner point exactly once, whatever the positions.
///
/// # Errors
///
/// The first defect. The checks run over the triangles in the given order, then over boundary
/// edges from vertex 0 on, then over interior edges in the order of their smaller vertex.
///
/// # Example
///
/// ```
/// use mindeg_core::{Defect, verify};
///
/// let fan = [[0, 1, 3], [1, 2, 3]];
/// assert_eq!(verify(&[1, 1, 1, 1], fan)?.max_degree, 3);
/// // On (2,1,1) vertices 0, 1 and 2 lie on one side.
/// let flat = verify(&[2, 1, 1], [[0, 1, 2], [0, 2, 3]]);
/// assert_eq!(flat, Err(Defect::Flat { triangle: 0, side: 0 }));
/// # Ok::<(), Defect>(())
/// ```
pub fn verify(
    intervals: &[u64],
    triangles: impl IntoIterator<Item = [u32; 3]>,
) -> Result<Verified, Defect> {
    let sides = Sides::new(intervals)?;
    let vertices = sides.starts[intervals.len()];
    let expected = vertices - 2;

    let mut edges = Vec::new();
    let mut found = 0;
    for triangle in triangles {
        if found < expected {
            sides.check(found, triangle)?;
            let [a, b, c] = triangle;
            edges.extend([[a, b], [b, c], [c, a]]);
        }
        found += 1;
    }
    if found != expected {
        return Err(Defect::WrongCount { expected, found });
    }
    // This brings both directions of an edge together.
    edges.sort_unstable_by_key(|&[a, b]| (a.min(b), a.max(b), a));
    let degrees = check_edges(&edges, vertices)?;
    let max_degree = degrees.iter().copied().max().unwrap_or(0);
    Ok(Verified { max_degree, degrees })
}

/// The first vertex of every side, then n.
struct Sides {
    starts: Vec<u64>,
}

impl Sides {
    fn new(intervals: &[u64]) -> Result<Self, Defect> {
        let mut starts: Vec<u64> = alloc::vec![0];
        for &count in intervals {
            let end = starts[starts.len() - 1].checked_add(count);
            let end = end.filter(|&end| count > 0 && end <= u64::from(u32::MAX - 1));
            starts.push(end.ok_or(Defect::NoPolygon)?);
        }
        if intervals.len() < 3 { Err(Defect::NoPolygon) } else { Ok(Self { starts }) }
    }

    fn check(&self, index: u64, triangle: [u32; 3]) -> Result<(), Defect> {
        let vertices = self.starts[self.starts.len() - 1];
        let exists = |vertex: u32| u64::from(vertex) < vertices;
        if let Some(&vertex) = triangle.iter().find(|&&vertex| !exists(vertex)) {
            return Err(Defect::NoSuchVertex { triangle: index, vertex });
        }
        let [a, b, c] = triangle;
        if a == b || a == c {
            return Err(Defect::RepeatedVertex { triangle: index, vertex: a });
        }
        if b == c {
            return Err(Defect::RepeatedVertex { triangle: index, vertex: b });
        }
        // In a -> b -> c -> a, one step descends if the triangle is counter-clockwise, two if not.
        let descents = u32::from(b < a) + u32::from(c < b) + u32::from(a < c);
        if descents != 1 {
            return Err(Defect::Clockwise { triangle: index });
        }
        let [low, middle, high] = {
            let mut sorted = triangle.map(u64::from);
            sorted.sort_unstable();
            sorted
        };
        // The side of the middle vertex. If that is a corner, the side that starts there.
        let last = self.starts.len() - 2;
        let side = self.starts.partition_point(|&start| start <= middle) - 1;
        let holds = |side: usize| self.starts[side] <= low && high <= self.starts[side + 1];
        if holds(side) {
            return Err(Defect::Flat { triangle: index, side });
        }
        // The last side ends at vertex 0.
        if low == 0 && middle >= self.starts[last] {
            return Err(Defect::Flat { triangle: index, side: last });
        }
        Ok(())
    }
}

/// Checks the sorted directed edges of all triangles and counts the edges at every vertex.
fn check_edges(edges: &[[u32; 2]], vertices: u64) -> Result<Vec<u32>, Defect> {
    let next = |vertex: u32| if u64::from(vertex) + 1 == vertices { 0 } else { vertex + 1 };
    let is_boundary_edge = |[from, to]: [u32; 2]| next(from) == to;

    let mut has_boundary_edge = alloc::vec![false; vertices as usize];
    for &edge in edges.iter().filter(|&&edge| is_boundary_edge(edge)) {
        has_boundary_edge[edge[0] as usize] = true;
    }
    if let Some((vertex, _)) = (0_u32..).zip(&has_boundary_edge).find(|&(_, &has)| !has) {
        return Err(Defect::MissingBoundaryEdge { edge: [vertex, next(vertex)] });
    }

    let mut degrees = alloc::vec![2_u32; vertices as usize];
    for same in edges.chunk_by(|&[a, b], &edge| edge == [a, b] || edge == [b, a]) {
        if let Some(pair) = same.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(Defect::RepeatedEdge { edge: pair[0] });
        }
        // The edge now has one direction or both. A counter-clockwise triangle never has a boundary
        // edge backwards.
        let [from, to] = same[0];
        if is_boundary_edge(same[0]) {
            continue;
        }
        if same.len() == 1 {
            return Err(Defect::OpenEdge { edge: same[0] });
        }
        degrees[from as usize] += 1;
        degrees[to as usize] += 1;
    }
    Ok(degrees)
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::string::ToString;

    /// The zig-zag of (3,3,2,2): ears at vertices 3 and 8.
    const GOOD: [[u32; 3]; 8] =
        [[3, 4, 2], [4, 1, 2], [4, 5, 1], [5, 0, 1], [5, 6, 0], [6, 9, 0], [6, 7, 9], [7, 8, 9]];

    fn with(index: usize, triangle: [u32; 3]) -> Vec<[u32; 3]> {
        let mut triangles = GOOD.to_vec();
        triangles[index] = triangle;
        triangles
    }

    #[test]
    fn accepts_a_triangulation_and_counts_its_degrees() {
        let verified = verify(&[3, 3, 2, 2], GOOD).unwrap();
        assert_eq!(verified.degrees, [4, 4, 3, 2, 4, 4, 4, 3, 2, 4]);
        assert_eq!(verified.max_degree, 4);
    }

    #[test]
    fn names_the_first_defect() {
        let triangle = 2;
        for (triangles, defect) in [
            (GOOD[1..].to_vec(), Defect::WrongCount { expected: 8, found: 7 }),
            ([&GOOD[..], &GOOD[..1]].concat(), Defect::WrongCount { expected: 8, found: 9 }),
            ([&GOOD[..], &[[0, 99, 1]]].concat(), Defect::WrongCount { expected: 8, found: 9 }),
            (with(2, [4, 10, 1]), Defect::NoSuchVertex { triangle, vertex: 10 }),
            (with(2, [4, 4, 1]), Defect::RepeatedVertex { triangle, vertex: 4 }),
            (with(2, [4, 1, 4]), Defect::RepeatedVertex { triangle, vertex: 4 }),
            (with(2, [1, 4, 4]), Defect::RepeatedVertex { triangle, vertex: 4 }),
            (with(2, [5, 4, 1]), Defect::Clockwise { triangle }),
            (with(2, [0, 1, 3]), Defect::Flat { triangle, side: 0 }),
            (with(2, [6, 3, 4]), Defect::Flat { triangle, side: 1 }),
            (with(2, [8, 9, 0]), Defect::Flat { triangle, side: 3 }),
            (with(2, [4, 1, 2]), Defect::MissingBoundaryEdge { edge: [4, 5] }),
            (with(0, [5, 6, 1]), Defect::MissingBoundaryEdge { edge: [2, 3] }),
            (with(5, [6, 0, 1]), Defect::MissingBoundaryEdge { edge: [9, 0] }),
            (with(2, [4, 5, 2]), Defect::OpenEdge { edge: [4, 1] }),
            (with(6, [7, 9, 5]), Defect::MissingBoundaryEdge { edge: [6, 7] }),
            (with(1, [4, 5, 1]), Defect::MissingBoundaryEdge { edge: [1, 2] }),
        ] {
            assert_eq!(verify(&[3, 3, 2, 2], triangles), Err(defect));
        }
        // The triangle in the middle has no boundary edge to miss.
        let ears = [[0, 1, 5], [1, 2, 3], [3, 4, 5]];
        assert_eq!(verify(&[2, 2, 2], [&ears[..], &[[1, 3, 5]]].concat()).unwrap().max_degree, 4);
        for (middle, defect) in [
            ([1, 2, 3], Defect::RepeatedEdge { edge: [1, 2] }),
            ([1, 3, 4], Defect::OpenEdge { edge: [4, 1] }),
        ] {
            assert_eq!(verify(&[2, 2, 2], [&ears[..], &[middle]].concat()), Err(defect));
        }
        for intervals in [&[1, 1][..], &[1, 0, 2], &[1, u64::MAX, 2], &[1, 4_294_967_293, 1]] {
            assert_eq!(verify(intervals, []), Err(Defect::NoPolygon));
        }
    }

    #[test]
    fn messages_say_what_and_where() {
        let (triangle, vertex, edge) = (7, 5, [2, 3]);
        for (defect, message) in [
            (
                Defect::NoPolygon,
                "the interval counts do not describe a polygon: use at least 3 sides, at least 1 \
                 interval on each and at most 4294967294 in total",
            ),
            (Defect::WrongCount { expected: 8, found: 9 }, "found 9 triangles, expected 8"),
            (
                Defect::NoSuchVertex { triangle, vertex },
                "triangle 7 has vertex 5, which does not exist",
            ),
            (Defect::RepeatedVertex { triangle, vertex }, "triangle 7 has vertex 5 twice"),
            (Defect::Clockwise { triangle }, "triangle 7 is clockwise; reverse its vertices"),
            (
                Defect::Flat { triangle, side: 0 },
                "triangle 7 is flat: all its vertices lie on side 1",
            ),
            (Defect::RepeatedEdge { edge }, "more than one triangle has the edge from 2 to 3"),
            (Defect::OpenEdge { edge }, "the interior edge from 2 to 3 has one triangle, not two"),
            (Defect::MissingBoundaryEdge { edge }, "the boundary edge from 2 to 3 has no triangle"),
        ] {
            assert_eq!(defect.to_string(), message);
        }
    }
}
