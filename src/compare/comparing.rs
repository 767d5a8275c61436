//! One comparison, and whether mindeg's mesh meets the demands.

use crate::bar::Bar;
use crate::demands::met;
use crate::domain::name_in_text;
use crate::failure::Failure;
use mindeg::Domain;
use mindeg_answers::demands::Demands;
use mindeg_compare::{CompareOptions, Comparison, compare};
use mindeg_mesh::TriMesh;

/// Fails if mindeg's own mesh, the first method, is not what was demanded.
pub(super) fn check(demands: &Demands, comparison: &Comparison) -> Result<(), Failure> {
    let Some((figures, triangles)) = comparison.methods().next() else { return Ok(()) };
    let Some(min_angle) = figures.min_angle else { return Ok(()) };
    let points = comparison.points(figures.method).iter().map(|point| point.extend(0.0)).collect();
    let mesh = TriMesh::new(points, triangles.to_vec());
    let mesh = mesh.map_err(Failure::input)?;
    met(&demands.unmet_by(&mesh, min_angle))
}

/// Compares a domain.
pub(super) fn compared(
    domain: &Domain,
    options: &CompareOptions,
    quiet: bool,
) -> Result<Comparison, Failure> {
    let stage = format!(
        "comparing {}, {} s at most for each method",
        name_in_text(domain),
        options.time_limit.as_secs_f64()
    );
    let compared = Bar::new(quiet).waiting(stage, || compare(domain, options));
    compared.map_err(Failure::input)
}
