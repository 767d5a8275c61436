//! A checker for any list of triangles on a boundary, from any source.
//!
//! It uses the interval counts and the list alone and shares no code with the constructions, so
//! that it can find their faults.
//!
//! Limits: it ignores positions. A list that passes can fold over in the plane if the polygon is
//! not convex.

use crate::Defect;
use alloc::format;
use alloc::vec::Vec;

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

fn no_polygon() -> Defect {
    Defect::new(
        "the interval counts do not describe a polygon: use at least 3 sides, at least 1 interval on \
         each and at most 4294967294 in total",
    )
}

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
/// let flat = verify(&[2, 1, 1], [[0, 1, 2], [0, 2, 3]]).unwrap_err();
/// assert_eq!(flat.to_string(), "triangle 0 is flat: all its vertices lie on side 1");
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
        return Err(Defect::new(format!("found {found} triangles, expected {expected}")));
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
            starts.push(end.ok_or_else(no_polygon)?);
        }
        if intervals.len() < 3 { Err(no_polygon()) } else { Ok(Self { starts }) }
    }

    fn check(&self, index: u64, triangle: [u32; 3]) -> Result<(), Defect> {
        let vertices = self.starts[self.starts.len() - 1];
        let error = |is: &str| Err(Defect::new(format!("triangle {index} {is}")));
        let exists = |vertex: u32| u64::from(vertex) < vertices;
        if let Some(vertex) = triangle.iter().find(|&&vertex| !exists(vertex)) {
            return error(&format!("has vertex {vertex}, which does not exist"));
        }
        let [a, b, c] = triangle;
        if a == b || b == c || c == a {
            let twice = if b == c { b } else { a };
            return error(&format!("has vertex {twice} twice"));
        }
        // In a -> b -> c -> a, one step descends if the triangle is counter-clockwise, two if not.
        let descents = u32::from(b < a) + u32::from(c < b) + u32::from(a < c);
        if descents != 1 {
            return error("is clockwise; reverse its vertices");
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
        // The last side ends at vertex 0.
        let on_last = low == 0 && middle >= self.starts[last];
        match holds(side).then_some(side).or(on_last.then_some(last)) {
            Some(side) => error(&format!("is flat: all its vertices lie on side {}", side + 1)),
            None => Ok(()),
        }
    }
}

/// Checks the sorted directed edges of all triangles and counts the edges at every vertex.
fn check_edges(edges: &[[u32; 2]], vertices: u64) -> Result<Vec<u32>, Defect> {
    let next = |vertex: u32| if u64::from(vertex) + 1 == vertices { 0 } else { vertex + 1 };
    let is_boundary_edge = |[from, to]: [u32; 2]| next(from) == to;

    let count = usize::try_from(vertices).expect("as many triangles are in memory");
    let mut has_boundary_edge = alloc::vec![false; count];
    for &edge in edges.iter().filter(|&&edge| is_boundary_edge(edge)) {
        has_boundary_edge[edge[0] as usize] = true;
    }
    if let Some((vertex, _)) = (0_u32..).zip(&has_boundary_edge).find(|&(_, &has)| !has) {
        let end = next(vertex);
        return Err(Defect::new(format!(
            "the boundary edge from {vertex} to {end} has no triangle"
        )));
    }

    let mut degrees = alloc::vec![2_u32; count];
    for same in edges.chunk_by(|&[a, b], &edge| edge == [a, b] || edge == [b, a]) {
        if let Some(pair) = same.windows(2).find(|pair| pair[0] == pair[1]) {
            let [from, to] = pair[0];
            return Err(Defect::new(format!(
                "more than one triangle has the edge from {from} to {to}"
            )));
        }
        // The edge now has one direction or both. A counter-clockwise triangle never has a boundary
        // edge backwards.
        let [from, to] = same[0];
        if is_boundary_edge(same[0]) {
            continue;
        }
        if same.len() == 1 {
            return Err(Defect::new(format!(
                "the interior edge from {from} to {to} has one triangle, not two"
            )));
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
        #[rustfmt::skip]
        let table = [
            (GOOD[1..].to_vec(), "found 7 triangles, expected 8"),
            ([&GOOD[..], &GOOD[..1]].concat(), "found 9 triangles, expected 8"),
            ([&GOOD[..], &[[0, 99, 1]]].concat(), "found 9 triangles, expected 8"),
            (with(2, [4, 10, 1]), "triangle 2 has vertex 10, which does not exist"),
            (with(2, [4, 4, 1]), "triangle 2 has vertex 4 twice"),
            (with(2, [4, 1, 4]), "triangle 2 has vertex 4 twice"),
            (with(2, [1, 4, 4]), "triangle 2 has vertex 4 twice"),
            (with(2, [5, 4, 1]), "triangle 2 is clockwise; reverse its vertices"),
            (with(2, [0, 1, 3]), "triangle 2 is flat: all its vertices lie on side 1"),
            (with(2, [6, 3, 4]), "triangle 2 is flat: all its vertices lie on side 2"),
            (with(2, [8, 9, 0]), "triangle 2 is flat: all its vertices lie on side 4"),
            (with(2, [4, 1, 2]), "the boundary edge from 4 to 5 has no triangle"),
            (with(0, [5, 6, 1]), "the boundary edge from 2 to 3 has no triangle"),
            (with(5, [6, 0, 1]), "the boundary edge from 9 to 0 has no triangle"),
            (with(2, [4, 5, 2]), "the interior edge from 4 to 1 has one triangle, not two"),
            (with(6, [7, 9, 5]), "the boundary edge from 6 to 7 has no triangle"),
            (with(1, [4, 5, 1]), "the boundary edge from 1 to 2 has no triangle"),
        ];
        for (triangles, defect) in table {
            assert_eq!(verify(&[3, 3, 2, 2], triangles).unwrap_err().to_string(), defect);
        }
        // The triangle in the middle has no boundary edge to miss.
        let ears = [[0, 1, 5], [1, 2, 3], [3, 4, 5]];
        assert_eq!(verify(&[2, 2, 2], [&ears[..], &[[1, 3, 5]]].concat()).unwrap().max_degree, 4);
        for (middle, defect) in [
            ([1, 2, 3], "more than one triangle has the edge from 1 to 2"),
            ([1, 3, 4], "the interior edge from 4 to 1 has one triangle, not two"),
        ] {
            let triangles = [&ears[..], &[middle]].concat();
            assert_eq!(verify(&[2, 2, 2], triangles).unwrap_err().to_string(), defect);
        }
        for intervals in [&[1, 1][..], &[1, 0, 2], &[1, u64::MAX, 2], &[1, 4_294_967_293, 1]] {
            assert_eq!(verify(intervals, []), Err(no_polygon()));
        }
    }
}
