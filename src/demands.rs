//! Ends a run whose mesh is not what was demanded of it.

use crate::bar::Bar;
use crate::failure::Failure;
use mindeg::BoundaryMesh;
use mindeg_answers::demands::{Demands, WorstPlaces};
use mindeg_mesh::TriMesh;
use std::ops::Range;

/// Fails if something demanded is unmet.
pub(crate) fn met(unmet: &[String]) -> Result<(), Failure> {
    if unmet.is_empty() {
        return Ok(());
    }
    Err(Failure::Gate(format!("{} (counted from 0)", unmet.join("; "))))
}

/// Fails if the mesh is not to be written for what is unmet; otherwise gives how the run ends once it is
/// written.
pub(crate) fn met_or_written_anyway(
    unmet: &[String],
    write_anyway: bool,
) -> Result<Result<(), Failure>, Failure> {
    match met(unmet) {
        Err(Failure::Gate(message)) if !write_anyway => {
            Err(Failure::Gate(format!("{message}; --write-anyway writes the mesh all the same")))
        }
        end => Ok(end),
    }
}

/// Fails if one of these triangles of a mesh, whose minimum angle is known, has an angle below `target`.
pub(crate) fn new_triangles_met(
    target_angle: Option<f64>,
    mesh: &TriMesh,
    triangles: &Range<u32>,
    min_angle: f64,
) -> Result<(), Failure> {
    let demands = Demands { target_angle, ..Demands::default() };
    let worst = || WorstPlaces::among(mesh, triangles.clone());
    met(&demands.unmet(0, min_angle, worst))
}

/// The demands that the mesh of a domain with a known minimum angle breaks. Degrees are total. To
/// name a triangle, all are examined again, and the bar shows it.
pub(crate) fn unmet_by_boundary_mesh(
    demands: &Demands,
    mesh: &BoundaryMesh,
    min_angle: f64,
    bar: &Bar,
) -> Result<Vec<String>, Failure> {
    let max_degree = mesh.max_total_degree();
    let worst = || {
        let is_highest = |&vertex: &u32| mesh.total_degree(vertex) == max_degree;
        let angles = (0..).zip(mesh.qualities().map(|quality| quality.min_angle));
        let triangle = bar.waiting("looking for the worst triangle", || {
            angles.min_by(|(_, a), (_, b)| a.total_cmp(b))
        });
        WorstPlaces {
            vertex: (0..mesh.vertex_count()).find(is_highest),
            triangle: triangle.map(|(index, _)| (index, mesh.triangle(index))),
        }
    };
    let mut unmet = demands.unmet(max_degree, min_angle, worst);
    if let Some(preset) = demands.preset {
        let listed = TriMesh::of(mesh).map_err(Failure::input)?;
        unmet.extend(preset.broken_by(&listed));
    }
    Ok(unmet)
}
