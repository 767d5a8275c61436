//! Delaunay refinement of a boundary by `spade`, for comparison.

use glam::DVec2;
use mindeg_mesh::planar::PlanarBoundary;
use spade::{
    AngleLimit, ConstrainedDelaunayTriangulation, Point2, RefinementParameters, Triangulation,
};

use crate::DelaunayError;

/// Points and triangles inside some rings.
#[derive(Clone, Debug, PartialEq)]
pub struct Refined {
    /// The given points, then the added points.
    pub points: Vec<DVec2>,
    /// The triangles, counter-clockwise.
    pub triangles: Vec<[u32; 3]>,
    /// Whether every angle that can reach the limit does; false if `most` points were too few.
    pub is_complete: bool,
}

/// Adds points inside a boundary until no triangle away from the boundary has an angle below `min_angle`
/// degrees; boundary edges are kept whole. At most `most` points are added.
///
/// # Errors
///
/// [`DelaunayError`], for coordinates out of range and rings that cross.
///
/// # Example
///
/// ```
/// use glam::DVec2;
/// use mindeg_mesh::planar::PlanarBoundary;
///
/// let ring = [[0.0, 0.0], [1.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]].map(DVec2::from);
/// let refined = mindeg_delaunay::refined(&PlanarBoundary::new(&[ring])?, 25.0, 1000)?;
/// assert_eq!(refined.points[..5], ring);
/// assert!(refined.is_complete);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn refined(
    boundary: &PlanarBoundary,
    min_angle: f64,
    most: usize,
) -> Result<Refined, DelaunayError> {
    let sites: Vec<Point2<f64>> =
        boundary.points().iter().map(|point| point.to_array().into()).collect();
    let in_range = |site: &Point2<f64>| spade::validate_vertex(site).is_ok();
    if let Some(vertex) = sites.iter().position(|site| !in_range(site)) {
        return Err(DelaunayError::out_of_range(vertex as u32));
    }
    let edges = boundary.edges().map(|edge| edge.map(|vertex| vertex as usize)).collect();
    let mut conflict = None;
    let mut triangulation =
        ConstrainedDelaunayTriangulation::<Point2<f64>>::try_bulk_load_cdt(sites, edges, |edge| {
            conflict = Some(edge);
        })
        .map_err(|_| DelaunayError::out_of_range(0))?;
    if let Some([a, b]) = conflict {
        return Err(DelaunayError::crossing([a as u32, b as u32]));
    }
    let parameters = RefinementParameters::<f64>::new()
        .with_angle_limit(AngleLimit::from_deg(min_angle))
        .with_max_additional_vertices(most)
        .keep_constraint_edges()
        .exclude_outer_faces(true);
    let result = triangulation.refine(parameters);
    let mut is_outside = vec![false; triangulation.num_all_faces()];
    result.excluded_faces.iter().for_each(|face| is_outside[face.index()] = true);
    let triangles = triangulation
        .inner_faces()
        .filter(|face| !is_outside[face.fix().index()])
        .map(|face| face.vertices().map(|vertex| vertex.fix().index() as u32))
        .collect();
    let points = triangulation.vertices().map(|vertex| vertex.position());
    let points = points.map(|point| DVec2::new(point.x, point.y)).collect();
    Ok(Refined { points, triangles, is_complete: result.refinement_complete })
}
