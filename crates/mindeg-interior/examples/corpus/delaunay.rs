//! A constrained Delaunay triangulation by spade.

use glam::DVec2;
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation};

pub(crate) fn triangulate(points: &[DVec2], edges: &[[u32; 2]]) -> Result<Vec<[u32; 3]>, String> {
    let sites: Vec<Point2<f64>> = points.iter().map(|p| Point2::new(p.x, p.y)).collect();
    let edges = edges.iter().map(|e| e.map(|v| v as usize)).collect();
    let mut conflict = None;
    let mesh =
        ConstrainedDelaunayTriangulation::<Point2<f64>>::try_bulk_load_cdt(sites, edges, |edge| {
            conflict = Some(edge)
        });
    let mesh = mesh.map_err(|error| error.to_string())?;
    if let Some([a, b]) = conflict {
        return Err(format!("edge {a}-{b} crosses another"));
    }
    Ok(mesh.inner_faces().map(|face| face.vertices().map(|v| v.fix().index() as u32)).collect())
}
