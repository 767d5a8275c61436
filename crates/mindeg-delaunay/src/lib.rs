//! A constrained Delaunay triangulation of boundary rings, interior points and segments, by the
//! `spade` crate.
//!
//! ```
//! use glam::DVec2;
//! use mindeg_mesh::Progress;
//! use mindeg_mesh::planar::PlanarBoundary;
//!
//! let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(DVec2::from);
//! let boundary = PlanarBoundary::new(&[&square])?;
//! let triangles = mindeg_delaunay::triangles(&boundary, &[DVec2::ONE], &[], Progress::NONE)?;
//! assert_eq!(triangles.len(), 4);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Among all triangulations of a polygon without further points, Delaunay's has the largest minimum
//! angle; if four points lie on one circle, several triangulations are Delaunay's.
//!
//! Boundary points are harder than general points for two reasons. Points on a slanted side are
//! rounded, so some lie slightly inside the hull of the others, and slivers fill the hull. So the
//! boundary edges are constraints, and triangles that can be reached from outside, or from within a
//! hole, without crossing the boundary are dropped. And inserting points in the order of the
//! boundary takes quadratic time. So each ring's corners come first, then every 2^j-th vertex for
//! falling j, and the search for each starts at an inserted neighbour.
//!
//! The predicates are exact on the given points, so far from the origin the points need no shift: a
//! shift would give a mesh of other points.
//!
//! Limits: coordinates are 0 or of magnitude 2^-142 to 2^201, where the predicates are exact. On
//! intervals below a hundred-millionth of the domain's size, three rounded points of one side can
//! bulge so much that their flat triangle is Delaunay's; it stays in the result.

mod refine;
mod twins;

pub use refine::{Refined, refined};
use twins::first;

use glam::DVec2;
use mindeg_mesh::planar::PlanarBoundary;
use mindeg_mesh::{Cancelled, Progress};
use spade::handles::FixedVertexHandle;
use spade::{ConstrainedDelaunayTriangulation, HasPosition, Point2, Triangulation};

/// A vertex in the form that spade needs.
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
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum DelaunayError {
    /// The reason in a sentence, with the vertices.
    #[error("{0}")]
    Refused(String),
    /// The [`Progress`] callback has cancelled the work.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl DelaunayError {
    fn out_of_range(vertex: u32) -> Self {
        Self::Refused(format!(
            "vertex {vertex} has a coordinate that is neither 0 nor of magnitude 1.8e-43 to 3.2e60, where \
             the predicates are exact; use another unit of length"
        ))
    }

    fn crossing([from, to]: [u32; 2]) -> Self {
        Self::Refused(format!(
            "the boundary edge from {from} to {to} crosses or touches another once coordinates are rounded \
             to f64; use fewer intervals there, or an origin near the domain"
        ))
    }
}

/// The triangles inside a boundary, counter-clockwise, in no particular order.
///
/// `inner` are interior points; their vertices follow those of the boundary. `segments` join any two
/// vertices inside the domain; a segment that passes through a vertex is split there. The area
/// outside the domain gets no triangle. Of [twins](PlanarBoundary::twins), each gets the triangles of its sector.
///
/// O(n log n) for sides of similar length; more if one vertex gets a large share of all edges.
///
/// # Errors
///
/// [`DelaunayError`].
///
/// # Panics
///
/// If a segment names a vertex that does not exist.
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_mesh::Progress;
/// use mindeg_mesh::planar::PlanarBoundary;
///
/// let outer = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(DVec2::from);
/// let hole = [[1.0, 1.0], [1.0, 2.0], [2.0, 2.0]].map(DVec2::from);
/// let boundary = PlanarBoundary::new(&[&outer[..], &hole])?;
/// let inner = [[3.0, 3.0], [3.0, 1.0]].map(DVec2::from);
/// let triangles = mindeg_delaunay::triangles(&boundary, &inner, &[[7, 8]], Progress::NONE)?;
/// assert_eq!(triangles.len(), 7 + 2 * 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn triangles(
    boundary: &PlanarBoundary,
    inner: &[DVec2],
    segments: &[[u32; 2]],
    progress: Progress<'_>,
) -> Result<Vec<[u32; 3]>, DelaunayError> {
    let in_range = |point: &DVec2| spade::validate_vertex(&Point2::from(point.to_array())).is_ok();
    if let Some(vertex) = boundary.points().iter().chain(inner).position(|point| !in_range(point)) {
        return Err(DelaunayError::out_of_range(vertex as u32));
    }
    let (mut sites, handles) = insert(boundary, inner, progress)?;
    for [from, to] in boundary.edges() {
        let (a, b) = (handles[from as usize], handles[to as usize]);
        let is_free = sites.can_add_constraint(a, b);
        if is_free {
            sites.add_constraint(a, b);
        }
        // A constraint that passes through a vertex is split there.
        if !is_free || !sites.exists_constraint(a, b) {
            return Err(DelaunayError::crossing([from, to]));
        }
    }
    for &[from, to] in segments {
        let (a, b) = (handles[from as usize], handles[to as usize]);
        if !sites.can_add_constraint(a, b) {
            return Err(DelaunayError::Refused(format!(
                "the segment from {from} to {to} crosses the boundary or another segment; end both at a \
                 common point"
            )));
        }
        sites.add_constraint(a, b);
    }
    let next: Vec<u32> = boundary.edges().map(|[_, to]| first(boundary, to)).collect();
    let of_twins = twins::edges(boundary);
    let is_on_ring =
        |from: u32, to: u32| next.get(from as usize) == Some(&to) || of_twins.contains(&[from, to]);
    let mut triangles = inside(&sites, is_on_ring);
    twins::share_out(boundary, &mut triangles);
    Ok(triangles)
}

fn insert(
    boundary: &PlanarBoundary,
    inner: &[DVec2],
    progress: Progress<'_>,
) -> Result<(Sites, Vec<FixedVertexHandle>), DelaunayError> {
    let on_rings = boundary.vertex_count();
    let vertices = on_rings + inner.len() as u32;
    let point = |vertex: u32| match vertex.checked_sub(on_rings) {
        Some(index) => inner[index as usize],
        None => boundary.point(vertex),
    };
    let counter = progress.counter("Delaunay triangulation", vertices.into());
    let mut sites = Sites::new();
    let mut handles: Vec<Option<FixedVertexHandle>> = vec![None; vertices as usize];
    for near in order(boundary, vertices) {
        let (vertex, neighbor) = (first(boundary, near.0), first(boundary, near.1));
        if handles[vertex as usize].is_some() {
            continue;
        }
        let site = Site { position: point(vertex).to_array().into(), vertex };
        let before = sites.num_vertices();
        let inserted = match handles[neighbor as usize] {
            Some(hint) => sites.insert_with_hint(site, hint),
            None => sites.insert(site),
        };
        let handle = inserted.map_err(|_| DelaunayError::out_of_range(vertex))?;
        if sites.num_vertices() == before {
            let other = handles.iter().position(|&other| other == Some(handle)).unwrap_or(0);
            return Err(DelaunayError::Refused(format!(
                "vertices {other} and {vertex} coincide once their coordinates are rounded to f64; use \
                 fewer intervals there, or an origin near the domain"
            )));
        }
        handles[vertex as usize] = Some(handle);
        counter.add(1)?;
    }
    let handles: Vec<_> =
        (0..vertices).filter_map(|vertex| handles[first(boundary, vertex) as usize]).collect();
    assert_eq!(handles.len(), vertices as usize, "the order has every vertex");
    Ok((sites, handles))
}

/// Every vertex, some twice, each with an earlier vertex that is near on its ring; at the end the
/// interior points.
///
/// Corners come first: while all points are on one line, each insertion takes linear time.
fn order(boundary: &PlanarBoundary, vertices: u32) -> impl Iterator<Item = (u32, u32)> + '_ {
    let corners = boundary.corners();
    let of_rings = boundary.rings().enumerate().flat_map(move |(index, ring)| {
        let from = corners.partition_point(|&corner| corner <= ring.start);
        let to = corners.partition_point(|&corner| corner < ring.end);
        let own = &corners[from..to.max(from)];
        let corner = move |at: u32| if at == 0 { ring.start } else { own[at as usize - 1] };
        let corners = bisection(own.len() as u32 + 1).map(move |(a, b)| (corner(a), corner(b)));
        let start = ring.start;
        let all = bisection(ring.len() as u32).map(move |(a, b)| (start + a, start + b));
        let before = boundary.ring(index.saturating_sub(1)).start;
        [(start, before)].into_iter().chain(corners).chain(all)
    });
    let end = boundary.vertex_count();
    let interior = bisection(vertices - end).map(move |(a, b)| (end + a, end + b));
    let first = (end < vertices).then_some((end, 0));
    of_rings.chain(first).chain(interior)
}

/// In levels of at least this length, insertion by halves is faster than insertion in order.
const LARGE_LEVEL: u64 = 2048;

/// The indices from 1 to below a count, each after the smaller index that it is paired with.
///
/// A level may be all tips of a comb over all its roots. In order from one end, the first tip would get
/// edges to all roots, the next to all but one, and so on; by halves, the total is n log n.
fn bisection(count: u32) -> impl Iterator<Item = (u32, u32)> {
    let count = u64::from(count);
    let steps = (0..u64::BITS - count.leading_zeros()).rev().map(|power| 1_u64 << power);
    steps.flat_map(move |step| {
        let len = count.saturating_sub(step).div_ceil(2 * step);
        let bits = u64::BITS - len.saturating_sub(1).leading_zeros();
        let (in_order, all) = if len < LARGE_LEVEL { (len, 0) } else { (0, 1_u64 << bits) };
        let by_halves = (0..all)
            .map(move |at| at.reverse_bits() >> (u64::BITS - bits))
            .filter(move |&at| at < len);
        (0..in_order).chain(by_halves).map(move |at| {
            let at = step + 2 * step * at;
            (at as u32, (at - step) as u32)
        })
    })
}

/// The triangles that cannot be reached, without crossing the boundary, from outside the hull or
/// from the right of a boundary edge.
fn inside(sites: &Sites, is_on_ring: impl Fn(u32, u32) -> bool) -> Vec<[u32; 3]> {
    // Half-edges of triangles that are outside if the half-edge is not on the boundary.
    let mut border: Vec<_> = sites.convex_hull().map(|edge| edge.rev()).collect();
    let mut is_outside = vec![false; sites.num_all_faces()];
    for edge in sites.directed_edges() {
        let [from, to] = [edge.from().data().vertex, edge.to().data().vertex];
        if is_on_ring(to, from)
            && let Some(face) = edge.face().as_inner()
            && !std::mem::replace(&mut is_outside[face.fix().index()], true)
        {
            border.extend(face.adjacent_edges().map(|edge| edge.rev()));
        }
    }
    while let Some(edge) = border.pop() {
        let [from, to] = [edge.from().data().vertex, edge.to().data().vertex];
        if is_on_ring(from, to) || is_on_ring(to, from) {
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

    /// A regular polygon round `center`, with one side for each count.
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
                let boundary = domain.boundary().unwrap();
                let points = boundary.points();
                let triangles = triangles(&boundary, &[], &[], Progress::NONE).unwrap();
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
            // An unproven boundary, as rounded points may give.
            let boundary = PlanarBoundary::of_mesh(&[points.map(DVec2::from)]);
            triangles(&boundary, &[], &[], Progress::NONE).unwrap_err()
        };
        let out_of_range = DelaunayError::out_of_range(1);
        assert_eq!(refusal([[0.0, 0.0], [1.0, 1e-50], [2.0, 0.0], [0.0, 1.0]]), out_of_range);
        assert_eq!(refusal([[0.0, 0.0], [1e99, 0.0], [2e99, 0.0], [0.0, f64::NAN]]), out_of_range);
        let coincide = refusal([[0.0, 0.0], [0.0, 0.0], [2.0, 0.0], [0.0, 1.0]]);
        assert!(coincide.to_string().starts_with("vertices 0 and 1 coincide "), "{coincide}");
        assert_eq!(
            refusal([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0], [0.0, 1.0]]),
            DelaunayError::crossing([2, 3])
        );
    }

    /// A square of 6 by 6 with a square hole of 2 by 2.
    #[test]
    fn holes_stay_empty_and_segments_stay_edges() {
        let outer = [[0.0, 0.0], [6.0, 0.0], [6.0, 6.0], [0.0, 6.0]];
        let hole = [[2.0, 2.0], [2.0, 4.0], [4.0, 4.0], [4.0, 2.0]];
        let interior = [[5.0, 1.0], [1.0, 1.0], [3.0, 1.0], [3.0, 3.0]];
        let points = [outer, hole, interior].concat().into_iter().map(DVec2::from);
        let points: Vec<_> = points.collect();
        let area = |triangles: &[[u32; 3]]| {
            let double = |&[a, b, c]: &[u32; 3]| {
                let [a, b, c] = [a, b, c].map(|v| points[v as usize]);
                assert!((b - a).perp_dot(c - a) > 0.0);
                (b - a).perp_dot(c - a)
            };
            triangles.iter().map(double).sum::<f64>() / 2.0
        };
        let boundary = PlanarBoundary::new(&[&points[..4], &points[4..8]]).unwrap();
        let boundary = boundary.with_sides(vec![0, 2, 5], (0..8).collect());
        let of = |vertices: usize, segments: &[[u32; 2]]| {
            triangles(&boundary, &points[8..vertices], segments, Progress::NONE)
        };
        let plain = of(8, &[]).unwrap();
        assert_eq!((plain.len(), area(&plain)), (8, 32.0));
        // Delaunay's diagonals run from the corners of the square to those of the hole.
        assert!(!plain.iter().any(|corners| corners.contains(&0) && corners.contains(&7)));
        let with_segment = of(8, &[[0, 7]]).unwrap();
        assert_eq!((with_segment.len(), area(&with_segment)), (8, 32.0));
        assert!(with_segment.iter().any(|corners| corners.contains(&0) && corners.contains(&7)));
        // The last interior point is in the hole. The segment passes through vertex 10.
        let with_points = of(12, &[[8, 9]]).unwrap();
        assert_eq!((with_points.len(), area(&with_points)), (8 + 2 * 3, 32.0));
        let has =
            |a, b| with_points.iter().any(|corners| corners.contains(&a) && corners.contains(&b));
        assert!(has(8, 10) && has(10, 9) && !has(8, 9));

        let crossing = |segments: &[[u32; 2]]| {
            of(12, segments).unwrap_err().to_string().starts_with("the segment")
        };
        assert!(crossing(&[[10, 5]]) && crossing(&[[0, 8], [1, 9]]));
    }

    /// Vertex 5 is on the edge from 1 to 2.
    #[test]
    fn rings_that_touch_are_refused() {
        let points =
            [[0.0, 0.0], [6.0, 0.0], [6.0, 6.0], [0.0, 6.0], [4.0, 3.0], [6.0, 4.0], [4.0, 5.0]];
        let points = points.map(DVec2::from);
        // The hole is clockwise from 4 by 6 to 5.
        let clockwise = [points[4], points[6], points[5]];
        let boundary = PlanarBoundary::of_mesh(&[&points[..4], &clockwise]);
        let refusal = triangles(&boundary, &[], &[], Progress::NONE);
        assert_eq!(refusal, Err(DelaunayError::crossing([1, 2])));
    }

    /// Cancels at once, before the later fault.
    #[test]
    fn stops_when_it_is_cancelled() {
        let cancel = |_: mindeg_mesh::Step<'_>| ControlFlow::Break(());
        let boundary = PlanarBoundary::of_mesh(&[[DVec2::ZERO; 3]]);
        let refusal = triangles(&boundary, &[], &[], Progress::new(&cancel));
        assert_eq!(refusal, Err(DelaunayError::Cancelled(Cancelled)));
    }

    #[test]
    fn the_order_has_every_vertex_after_its_neighbor() {
        let of = |rings: &[u32], corners: &[u32]| {
            let points = |&count: &u32| vec![DVec2::ZERO; count as usize];
            let rings: Vec<Vec<DVec2>> = rings.iter().map(points).collect();
            let count = rings.concat().len() as u32;
            PlanarBoundary::of_mesh(&rings).with_sides(corners.to_vec(), (0..count).collect())
        };
        for (vertices, corners) in [
            (3, &[0, 1, 2][..]),
            (7, &[0, 5, 6]),
            (33, &[0, 7, 16, 17]),
            (66, &[0, 64, 65]),
            (9001, &[]),
        ] {
            for rings in [&[2, vertices - 2][..], &[2, vertices - 3], &[]] {
                let boundary = of(rings, corners);
                let mut seen = vec![false; vertices as usize];
                for (vertex, neighbor) in order(&boundary, vertices) {
                    assert!(seen[neighbor as usize] || (vertex, neighbor) == (0, 0));
                    seen[vertex as usize] = true;
                }
                assert!(seen.iter().all(|&seen| seen), "{rings:?}");
            }
        }
        // A large level does not take its vertices one by one from an end either.
        let last = bisection(16_384).skip(8191).map(|(vertex, _)| vertex).take(4);
        assert!(last.eq([1, 8193, 4097, 12_289]));
        // In the order of the ring, each of many corners would take time for all earlier ones.
        let boundary = of(&[8], &Vec::from_iter(0..8));
        let first = order(&boundary, 8).take(8).map(|(vertex, _)| vertex);
        assert!(first.eq([0, 4, 2, 6, 1, 3, 5, 7]));
    }
}
