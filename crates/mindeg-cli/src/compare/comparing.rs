//! One comparison, and what gates say to it.

use crate::bar::Bar;
use crate::domain::name_in_text;
use crate::failure::Failure;
use crate::gates::{Gates, NamedTriangle};
use mindeg::Domain;
use mindeg_compare::{Comparison, Options, compare};
use mindeg_mesh::TriMesh;

/// Checks mindeg's own mesh, the first method.
pub(super) fn check_gates(gates: &Gates, comparison: &Comparison) -> Result<(), Failure> {
    let Some((figures, triangles)) = comparison.methods().next() else { return Ok(()) };
    let (Some(max_degree), Some(min_angle)) = (figures.max_degree, figures.min_angle) else {
        return Ok(());
    };
    let highest_vertex = || {
        // With boundary points alone, a vertex has one edge more than triangles.
        let mut degrees = vec![1; comparison.points().len()];
        triangles.as_flattened().iter().for_each(|&vertex| degrees[vertex as usize] += 1);
        (0..).zip(degrees).find(|&(_, degree)| degree == max_degree).map_or(0, |(vertex, _)| vertex)
    };
    let worst_triangle = || {
        let worst = figures.worst_triangles.first();
        let (number, vertices) =
            worst.map_or((0, [0, 1, 2]), |worst| (worst.triangle, worst.vertices));
        NamedTriangle { number, vertices }
    };
    gates.check(max_degree, min_angle, highest_vertex, worst_triangle)?;
    let Some(preset) = gates.preset else { return Ok(()) };
    let points = comparison.points().iter().map(|point| point.extend(0.0)).collect();
    let mesh = TriMesh::new(points, triangles.to_vec());
    preset.check(&mesh.map_err(|error| Failure::Input(error.to_string()))?)
}

/// Compares a domain.
pub(super) fn compared(
    domain: &Domain,
    options: &Options,
    quiet: bool,
) -> Result<Comparison, Failure> {
    let stage = format!(
        "comparing {}, {} s at most for each method",
        name_in_text(domain),
        options.time_limit.as_secs_f64()
    );
    let compared = Bar::new(quiet).waiting(stage, || compare(domain, options));
    compared.map_err(|error| Failure::Input(error.to_string()))
}
