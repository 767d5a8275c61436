//! Meshes of the plane joined by a mesh of the gap between them.
//!
//! The gap is what an area has outside the meshes. It gets points inside, as [`interior`](crate::interior) makes them, with the
//! degrees of the given triangles counted where they meet. The meshes stay: vertices, triangles, groups and names keep their
//! indices, and no edge is divided. The new triangles form the group `stitch`, at the end.
//!
//! Of two meshes that overlap, the first one stays so. The other one loses the triangles that overlap it or are near it, and the
//! gap is what these had outside the first mesh.

mod cut;
mod depths;
mod front;
mod gap;
mod joining;
mod overlap;
mod proof;

use std::borrow::Cow;
use std::cmp::Reverse;

use glam::DVec3;
use mindeg_domain::{Domain, Interior, Projection};
use mindeg_mesh::{Progress, TriMesh, Triangles};

use self::cut::Cut;
use self::front::{Front, Named};
use self::gap::{Corner, Step};
use self::joining::{Joining, New, Told, beside, in_plane};
pub use self::joining::{STITCH, Stitched};
pub use self::overlap::Dropped;
use self::overlap::Overlap;
use self::proof::apart;
use crate::error::MeshError;

/// The gap that is filled.
#[derive(Clone, Copy, Debug)]
pub enum Gap<'a> {
    /// The part of an area outside the meshes. Where its border leaves a mesh, the new mesh begins at the last boundary vertex within the
    /// area. Its sides give the new boundary their names and kinds. If the area was [projected](Domain::projection), the meshes are
    /// in degrees.
    Within(&'a Domain),
    /// The place where two meshes overlap, when the second one has lost its triangles there; with a projection, if they are in
    /// degrees. New boundary is that of the second mesh, to within an edge of the first.
    Overlap(Option<&'a Projection>),
}

/// Joins meshes by a mesh of the gap between them. Depths of new vertices lie between those of the meshes. In degrees, longitudes go on
/// across the antimeridian from the first mesh.
///
/// O(n log n) for n triangles, and n k for an area of k points.
///
/// # Errors
///
/// [`MeshError::Refused`] with the place: meshes that are not flat, that overlap though an area is given, or that do not overlap though
/// none is; an area without a gap, or that does not join them.
///
/// # Example
///
/// ```
/// use mindeg::{Domain, Interior, Progress, Side, interior, stitch::{Gap, stitch}};
///
/// // Two squares, a third of their width apart.
/// let square = |x: f64| {
///     let corners = [[x, 0.0], [x + 3.0, 0.0], [x + 3.0, 3.0], [x, 3.0]];
///     let domain = Domain::polygon(corners, vec![Side::count(6); 4])?;
///     Ok::<_, Box<dyn std::error::Error>>(interior::mesh(&domain, &Interior::default(), Progress::NONE)?.mesh)
/// };
/// let meshes = [square(0.0)?, square(4.0)?];
/// let area = Domain::from_rings([[[2.9, 0.3], [4.1, 0.3], [4.1, 2.7], [2.9, 2.7]]])?;
/// let joined = stitch(&meshes, Gap::Within(&area), &Interior::default(), Progress::NONE)?;
/// assert_eq!(joined.mesh.boundary_loops().len(), 1);
/// assert_eq!(joined.mesh.triangles()[..10], meshes[0].triangles()[..10]);
/// assert!(joined.min_angle > 25.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn stitch(
    meshes: &[TriMesh],
    gap: Gap<'_>,
    wanted: &Interior,
    progress: Progress<'_>,
) -> Result<Stitched, MeshError> {
    let projection = match gap {
        Gap::Within(area) => area.projection(),
        Gap::Overlap(projection) => projection,
    };
    if projection.is_some()
        && let Some(at) = meshes.iter().flat_map(TriMesh::positions).find(|at| !is_in_degrees(at))
    {
        return Err(MeshError::Refused(format!(
            "a mesh is not in degrees, since it has a vertex at {}, and the area or the projection is for degrees: give the area in the \
             coordinates of the meshes, without a projection",
            mindeg_mesh::place(at.truncate())
        )));
    }
    let meshes = match projection {
        Some(_) => going_on(meshes)?,
        None => Cow::Borrowed(meshes),
    };
    let meshes = &*meshes;
    match gap {
        Gap::Within(area) => within(meshes, area, wanted, progress),
        Gap::Overlap(projection) => match meshes {
            [first, second] => overlapping([first, second], projection, wanted, progress),
            _ => Err(MeshError::refused(
                "without an area, two meshes are joined; join others to the result",
            )),
        },
    }
}

fn is_in_degrees(at: &DVec3) -> bool {
    at.x.abs() <= 360.0 && at.y.abs() <= 90.0
}

/// Meshes in degrees whose longitudes go on across the antimeridian from the first vertex on.
fn going_on(meshes: &[TriMesh]) -> Result<Cow<'_, [TriMesh]>, MeshError> {
    let mut positions = meshes.iter().flat_map(TriMesh::positions);
    let Some(&DVec3 { x: origin, .. }) = positions.next() else { return Ok(meshes.into()) };
    if positions.all(|at| beside(at.x, origin) == at.x) {
        return Ok(meshes.into());
    }
    let moved = |mesh: &TriMesh| {
        let at = |at: &DVec3| DVec3 { x: beside(at.x, origin), ..*at };
        Ok(mesh.clone().with_positions(mesh.positions().iter().map(at).collect())?)
    };
    meshes.iter().map(moved).collect()
}

fn within(
    meshes: &[TriMesh],
    area: &Domain,
    wanted: &Interior,
    progress: Progress<'_>,
) -> Result<Stitched, MeshError> {
    let Some((first, others)) = meshes.split_first() else {
        return Err(MeshError::refused("there is no mesh"));
    };
    let mut whole = first.clone();
    let mut starts = vec![0];
    for other in others {
        starts.push(whole.positions().len() as u32);
        whole = whole.with_mesh_added(other)?;
    }
    expect_flat(&whole)?;
    let border = area.boundary()?.into_owned();
    let told = |edge: u32| -> Told {
        let side = &area.sides()[area.rings().side_of(edge)];
        (side.name.clone(), side.kind)
    };
    let told = (0..border.vertex_count()).map(told).collect();
    let joined = Joining::new(whole, border.points().to_vec(), told, area.projection())?;
    apart(&joined.points, &joined.next, &starts)?;
    let gaps = joined.parts(gap::rings(&joined.points, &joined.next, &border)?);
    if gaps.is_empty() {
        let sentence = "the area has no gap: all of it lies in the meshes";
        return Err(MeshError::refused(sentence));
    }
    // One after the other: the new vertices of each follow those before.
    let mut new = New::default();
    for rings in gaps {
        joined.fill(&rings, wanted, &mut new, progress)?;
    }
    joined.with(new)
}

/// Widths of the gap that are tried, in edges; of equally good ones, the first holds.
const WIDTHS: [f64; 5] = [1.0, 1.5, 2.0, 2.5, 3.5];

/// New triangles with this minimum angle are good enough, in degrees, where all joined vertices have 5 to 7 edges.
const GOOD: f64 = 30.0;

fn overlapping(
    [first, second]: [&TriMesh; 2],
    projection: Option<&Projection>,
    wanted: &Interior,
    progress: Progress<'_>,
) -> Result<Stitched, MeshError> {
    [first, second].into_iter().try_for_each(expect_flat)?;
    let places = [first, second].map(|mesh| in_plane(mesh, projection));
    let named = Named::new(second);
    let overlap = Overlap::new([first, second], &places)?;
    let start = first.positions().len() as u32;
    let (mut best, mut problem) = (None, None);
    let merit = |stitched: &Stitched| {
        let degrees = stitched.mesh.degrees();
        let is_off = |vertex: &&u32| !(5..=7).contains(&degrees[**vertex as usize]);
        (
            stitched.joined.iter().filter(is_off).count(),
            Reverse(stitched.min_angle.min(GOOD).to_bits()),
        )
    };
    for width in WIDTHS {
        let stitched = overlap.dropped(width).and_then(|(dropped, told)| {
            let cut = Cut::new(second, &dropped);
            let front = Front::new(&overlap, &cut, &named)?;
            let whole = first.clone().with_mesh_added(&cut.mesh(second)?)?;
            let joined = Joining::new(whole, front.free, front.told, projection)?;
            let mut new = New::default();
            for rings in joined.parts(front.rings) {
                // Elsewhere the second mesh reached beyond the first one, without a way there.
                let is_second =
                    |step: &Step| matches!(step.0, Corner::Mesh(vertex) if vertex >= start);
                if rings.iter().flatten().any(is_second) {
                    joined.fill(&rings, wanted, &mut new, progress)?;
                }
            }
            let vertices = second.positions().len() - cut.vertices.len();
            Ok(Stitched { dropped: Some(Dropped { vertices, ..told }), ..joined.with(new)? })
        });
        match stitched {
            Ok(stitched) => {
                let found = merit(&stitched);
                if found == (0, Reverse(GOOD.to_bits())) {
                    return Ok(stitched);
                }
                if best.as_ref().is_none_or(|(of_best, _)| found < *of_best) {
                    best = Some((found, stitched));
                }
            }
            Err(error @ MeshError::Cancelled(_)) => return Err(error),
            Err(error) => {
                problem.get_or_insert(error);
            }
        }
    }
    // A width is tried, so there is a problem where there is no mesh.
    best.map(|(_, stitched)| stitched).ok_or_else(|| {
        problem.unwrap_or_else(|| MeshError::refused("no width of the gap is meshed"))
    })
}

fn expect_flat(mesh: &TriMesh) -> Result<(), MeshError> {
    if mesh.normal().is_some() {
        return Ok(());
    }
    let sentence = "a mesh is not flat, or has a triangle that is clockwise: only meshes of the plane are joined so";
    Err(MeshError::refused(sentence))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interior;
    use mindeg_domain::Side;
    use mindeg_mesh::Step;
    use std::ops::ControlFlow;
    use std::sync::atomic::{AtomicU32, Ordering};

    #[test]
    fn a_cancelled_gap_is_not_tried_again() {
        let square = |x: f64| {
            let corners = [[x, 0.0], [x + 3.0, 0.0], [x + 3.0, 3.0], [x, 3.0]];
            let domain = Domain::polygon(corners, vec![Side::count(6); 4]).unwrap();
            interior::mesh(&domain, &Interior::default(), Progress::NONE).unwrap().mesh
        };
        let meshes = [square(0.0), square(2.0)];
        let calls = AtomicU32::new(0);
        let cancel = |_: Step<'_>| {
            calls.fetch_add(1, Ordering::Relaxed);
            ControlFlow::Break(())
        };
        let run = |progress| stitch(&meshes, Gap::Overlap(None), &Interior::default(), progress);
        assert!(matches!(run(Progress::new(&cancel)), Err(MeshError::Cancelled(_))));
        assert_eq!(calls.load(Ordering::Relaxed), 1);
        run(Progress::NONE).unwrap();
    }
}
