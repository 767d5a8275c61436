//! A Delaunay triangulation of boundary points, by the `spade` crate.
//!
//! Among all triangulations of a polygon without further points, Delaunay's has the largest
//! minimum angle; where four points lie on one circle there are several.
//!
//! Two things make boundary points harder than points in general. Points on a slanted side
//! are rounded, so some lie a hair inside the hull of the others, and the hull is filled up
//! with slivers: hence the boundary goes in as constraints, and what can be reached from
//! outside without crossing one is dropped. And points in the order of the boundary make the
//! insertion quadratic: hence the corners come first, then every 2^j-th vertex for falling j,
//! with a neighbour already there as the place to start looking.
//!
//! The predicates are exact on the points as they are, so far from the origin they need not
//! be moved: a mesh of other points would be the result.
//!
//! Limits: coordinates are 0 or of magnitude 2^-142 to 2^201, where the predicates are exact.
//! On intervals below a hundred-millionth of the domain's size, three rounded points of one
//! side can bulge so much that the flat triangle on them is Delaunay's; it is left in.

use glam::DVec2;
use mindeg_mesh::{Cancelled, Progress};
use spade::handles::FixedVertexHandle;
use spade::{ConstrainedDelaunayTriangulation, HasPosition, Point2, Triangulation};

/// A boundary vertex as spade sees it.
#[derive(Clone, Copy)]
struct Site {
    position: Point2<f64>,
    vertex: u32,
}

impl HasPosition for Site {
    type Scalar = f64;

    fn position(&self) -> Point2<f64> {
        self.position
    }
}

type Sites = ConstrainedDelaunayTriangulation<Site>;

/// Why points have no Delaunay triangulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum DelaunayError {
    /// A coordinate for which the predicates are not exact.
    #[error(
        "vertex {vertex} has a coordinate that is neither 0 nor of magnitude 1.8e-43 to 3.2e60, \
         where the predicates are exact; use another unit of length"
    )]
    CoordinateOutOfRange {
        /// The first such vertex.
        vertex: u32,
    },
    /// Two vertices have the same position in f64.
    #[error(
        "vertices {} and {} coincide once their coordinates are rounded to f64; use fewer \
         intervals there, or an origin near the domain",
        vertices[0],
        vertices[1]
    )]
    CoincidentPoints {
        /// The vertices.
        vertices: [u32; 2],
    },
    /// The boundary through the rounded points crosses itself.
    #[error(
        "the boundary edge from {} to {} crosses another once coordinates are rounded to f64; \
         use fewer intervals there, or an origin near the domain",
        edge[0],
        edge[1]
    )]
    CrossingBoundary {
        /// The edge, counter-clockwise.
        edge: [u32; 2],
    },
    /// The [`Progress`] callback has cancelled the work.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// The triangles inside a boundary, counter-clockwise, in no particular order.
///
/// `points` run round the boundary; `corners` are the indices of its corners, in ascending order
/// from 0. O(n log n) for sides of like length; more where one vertex gets a large part of all edges.
///
/// # Errors
///
/// [`DelaunayError`].
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_mesh::Progress;
///
/// let square = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]].map(DVec2::from);
/// let triangles = mindeg_delaunay::of_boundary(&square, &[0, 2, 3, 4], Progress::NONE)?;
/// assert_eq!(triangles.len(), 3);
/// # Ok::<(), mindeg_delaunay::DelaunayError>(())
/// ```
pub fn of_boundary(
    points: &[DVec2],
    corners: &[u32],
    progress: Progress<'_>,
) -> Result<Vec<[u32; 3]>, DelaunayError> {
    let in_range = |point: &DVec2| spade::validate_vertex(&Point2::from(point.to_array())).is_ok();
    if let Some(vertex) = points.iter().position(|point| !in_range(point)) {
        return Err(DelaunayError::CoordinateOutOfRange { vertex: vertex as u32 });
    }
    let (mut sites, handles) = insert(points, corners, progress)?;
    for (from, to) in ring(points.len() as u32) {
        let (a, b) = (handles[from as usize], handles[to as usize]);
        if !sites.can_add_constraint(a, b) {
            return Err(DelaunayError::CrossingBoundary { edge: [from, to] });
        }
        sites.add_constraint(a, b);
    }
    Ok(inside(&sites))
}

/// The boundary edges.
fn ring(vertices: u32) -> impl Iterator<Item = (u32, u32)> {
    (0..vertices).map(move |from| (from, if from + 1 == vertices { 0 } else { from + 1 }))
}

fn insert(
    points: &[DVec2],
    corners: &[u32],
    progress: Progress<'_>,
) -> Result<(Sites, Vec<FixedVertexHandle>), DelaunayError> {
    let vertices = points.len() as u32;
    let counter = progress.counter("Delaunay triangulation", vertices.into());
    let mut sites = Sites::new();
    let mut handles: Vec<Option<FixedVertexHandle>> = vec![None; points.len()];
    for (vertex, neighbor) in order(vertices, corners) {
        if handles[vertex as usize].is_some() {
            continue;
        }
        let site = Site { position: points[vertex as usize].to_array().into(), vertex };
        let before = sites.num_vertices();
        let inserted = match handles[neighbor as usize] {
            Some(hint) => sites.insert_with_hint(site, hint),
            None => sites.insert(site),
        };
        let handle = inserted.map_err(|_| DelaunayError::CoordinateOutOfRange { vertex })?;
        if sites.num_vertices() == before {
            let other = handles.iter().position(|&other| other == Some(handle)).unwrap_or(0);
            return Err(DelaunayError::CoincidentPoints { vertices: [other as u32, vertex] });
        }
        handles[vertex as usize] = Some(handle);
        counter.add(1)?;
    }
    let handles: Vec<_> = handles.into_iter().flatten().collect();
    assert_eq!(handles.len(), vertices as usize, "the order has every vertex");
    Ok((sites, handles))
}

/// Every vertex, some twice, each with one that comes before it and is near on the boundary.
///
/// Corners come first: while all points are on one line, each insertion takes linear time.
fn order(vertices: u32, corners: &[u32]) -> impl Iterator<Item = (u32, u32)> + '_ {
    let vertices = u64::from(vertices);
    let corners = corners.iter().zip(corners.iter().take(1).chain(corners)).map(|(&a, &b)| (a, b));
    let steps = (0..u64::BITS - vertices.leading_zeros()).rev().map(|power| 1_u64 << power);
    let bisection = steps.flat_map(move |step| {
        (step..vertices).step_by(2 * step as usize).map(move |at| (at as u32, (at - step) as u32))
    });
    corners.chain(bisection)
}

/// The triangles that cannot be reached from outside without crossing the boundary.
fn inside(sites: &Sites) -> Vec<[u32; 3]> {
    let mut is_outside = vec![false; sites.num_all_faces()];
    let mut border: Vec<_> = sites.convex_hull().map(|edge| edge.rev()).collect();
    while let Some(edge) = border.pop() {
        if edge.is_constraint_edge() {
            continue;
        }
        let Some(face) = edge.face().as_inner() else { continue };
        if !std::mem::replace(&mut is_outside[face.fix().index()], true) {
            border.extend(face.adjacent_edges().map(|edge| edge.rev()));
        }
    }
    sites
        .inner_faces()
        .filter(|face| !is_outside[face.fix().index()])
        .map(|face| face.vertices().map(|vertex| vertex.data().vertex))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use mindeg_core::verify;
    use mindeg_domain::{Domain, Side};
    use robust::{Coord, incircle};
    use std::ops::ControlFlow;

    /// A regular polygon round `center`, with as many sides as counts.
    fn regular(center: DVec2, sides: &[u64]) -> Domain {
        let turn = std::f64::consts::TAU / sides.len() as f64;
        let corner = |side| center + 10.0 * DVec2::from_angle(0.1 + turn * side as f64);
        let corners = (0..sides.len()).map(corner);
        Domain::polygon(corners, sides.iter().copied().map(Side::count).collect()).unwrap()
    }

    fn coordinates(point: DVec2) -> Coord<f64> {
        Coord { x: point.x, y: point.y }
    }

    #[test]
    fn rounded_points_give_a_delaunay_triangulation_without_slivers() {
        for sides in [
            &[1, 1, 1][..],
            &[8, 8, 8],
            &[32, 32, 32],
            &[1000, 1, 1],
            &[1, 500, 3, 7],
            &[50, 60, 70, 80, 90],
            &[1000, 1, 10, 2, 500, 1, 3, 100],
        ] {
            for center in [DVec2::ZERO, DVec2::new(500_000.0, 4_650_000.0)] {
                let domain = regular(center, sides);
                let points: Vec<DVec2> = domain.placement().points().collect();
                let boundary = domain.rings();
                let corners: Vec<u32> =
                    (0..boundary.side_count()).map(|side| boundary.corner(side)).collect();
                let triangles = of_boundary(&points, &corners, Progress::NONE).unwrap();
                verify(sides, triangles.iter().copied()).unwrap();
                let mut edges: Vec<[u32; 3]> = triangles
                    .iter()
                    .flat_map(|&[a, b, c]| [[a, b, c], [b, c, a], [c, a, b]])
                    .collect();
                edges.sort_unstable_by_key(|&[a, b, _]| (a.min(b), a.max(b)));
                for pair in edges.windows(2) {
                    let ([a, b, c], [b2, a2, d]) = (pair[0], pair[1]);
                    if (a, b) == (a2, b2) {
                        let [a, b, c, d] = [a, b, c, d].map(|v| coordinates(points[v as usize]));
                        assert!(incircle(a, b, c, d) <= 0.0, "{sides:?} {center}");
                    }
                }
            }
        }
    }

    #[test]
    fn refuses_what_it_cannot_do_exactly() {
        let refusal = |points: [[f64; 2]; 4]| {
            of_boundary(&points.map(DVec2::from), &[0, 2, 3], Progress::NONE).unwrap_err()
        };
        assert_eq!(
            refusal([[0.0, 0.0], [1.0, 1e-50], [2.0, 0.0], [0.0, 1.0]]),
            DelaunayError::CoordinateOutOfRange { vertex: 1 }
        );
        assert_eq!(
            refusal([[0.0, 0.0], [1e99, 0.0], [2e99, 0.0], [0.0, f64::NAN]]),
            DelaunayError::CoordinateOutOfRange { vertex: 1 }
        );
        assert_eq!(
            refusal([[0.0, 0.0], [0.0, 0.0], [2.0, 0.0], [0.0, 1.0]]),
            DelaunayError::CoincidentPoints { vertices: [0, 1] }
        );
        assert_eq!(
            refusal([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0], [0.0, 1.0]]),
            DelaunayError::CrossingBoundary { edge: [2, 3] }
        );
    }

    /// At once, not at the fault that comes after.
    #[test]
    fn stops_when_it_is_cancelled() {
        let cancel = |_: mindeg_mesh::Step<'_>| ControlFlow::Break(());
        let refusal = of_boundary(&[DVec2::ZERO; 3], &[0, 1, 2], Progress::new(&cancel));
        assert_eq!(refusal, Err(DelaunayError::Cancelled(Cancelled)));
    }

    #[test]
    fn the_order_has_every_vertex_after_its_neighbor() {
        for (vertices, corners) in
            [(3, &[0, 1, 2][..]), (7, &[0, 5, 6]), (33, &[0, 7, 16, 17]), (66, &[0, 64, 65])]
        {
            let mut seen = vec![false; vertices as usize];
            for (vertex, neighbor) in order(vertices, corners) {
                assert!(seen[neighbor as usize] || (vertex, neighbor) == (0, 0));
                seen[vertex as usize] = true;
            }
            assert!(seen.iter().all(|&seen| seen));
        }
    }
}
