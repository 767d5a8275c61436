//! Surfaces in space meshed anew.

use mindeg::remesh::{Remesh, remesh as meshed_anew};
use mindeg_answers::remesh::RemeshAnswer;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::demands::demands;
use crate::dict::dict;
use crate::mesh::{Facts, Mesh, tri_mesh};
use crate::work::{done, value_error};

/// Mesh a surface in space anew: 5 to 7 edges at every vertex off the boundary, features kept, the distance proven.
///
/// Takes a mesh in hand, or points (n, 3) and triangles (m, 3). `size` is the edge length, `vertices` about how many there
/// are instead, `tolerance` how far the surfaces may be apart, `feature_angle` from which angle edges are features (180:
/// none); `curvature` makes edges longer where the surface is flat, `repair` mends the surface first. `report` of the result has
/// what was reached. `ValueError` for what is no manifold surface, and for a result that does not keep the tolerance or a rule
/// of `preset`, a program of `mindeg.PRESETS`, crosses itself or is turned over.
#[pyfunction]
#[pyo3(signature = (
    points, triangles=None, *, size=None, vertices=None, tolerance=None, feature_angle=40.0,
    target_angle=None, keep_boundary=false, keep_features=false, curvature=false, repair=false, preset=None
))]
#[expect(clippy::too_many_arguments, reason = "they are keywords in Python")]
pub(crate) fn remesh(
    py: Python<'_>,
    points: &Bound<'_, PyAny>,
    triangles: Option<&Bound<'_, PyAny>>,
    size: Option<f64>,
    vertices: Option<u32>,
    tolerance: Option<f64>,
    feature_angle: f64,
    target_angle: Option<f64>,
    keep_boundary: bool,
    keep_features: bool,
    curvature: bool,
    repair: bool,
    preset: Option<&str>,
) -> PyResult<Mesh> {
    let demands = demands(None, None, preset)?;
    let part = tri_mesh(points, triangles)?;
    let wish = Remesh {
        size,
        vertices,
        tolerance,
        feature_angle,
        target_angle,
        keep_boundary,
        keep_features,
        curvature,
        repair,
    };
    let found = done(py, |progress| meshed_anew(&part, &wish, progress))?;
    let answer = RemeshAnswer::of("", &part, tolerance, &found);
    if !answer.defects.is_empty() {
        let words: Vec<&str> = answer.defects.iter().map(|defect| &*defect.message).collect();
        return Err(value_error(words.join("; ")));
    }
    let report = dict(py, &answer)?.cast_into::<PyDict>()?;
    report.del_item("file")?;
    report.del_item("defects")?;
    Mesh::new(found.mesh, Facts { report: Some(report.unbind()), ..Facts::default() })
        .keeping(&demands)
}
