//! The optimiser alone.

use mindeg_answers::interior::InteriorAnswer;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::demands::demands;
use crate::dict::dict;
use crate::interior;
use crate::mesh::{Facts, Mesh, tri_mesh};
use crate::work::done;

/// The optimiser alone on a planar mesh; the package names the options.
#[pyfunction]
#[pyo3(name = "_improve")]
pub(crate) fn improve(
    py: Python<'_>,
    points: &Bound<'_, PyAny>,
    triangles: Option<&Bound<'_, PyAny>>,
    preset: Option<&str>,
    options: &str,
) -> PyResult<Mesh> {
    let demands = demands(None, None, preset)?;
    let mesh = tri_mesh(points, triangles)?;
    let projection = points.cast::<Mesh>().ok().and_then(|mesh| mesh.get().projection());
    let (wanted, _) = interior::wanted(options, &mindeg::Interior::default())?;
    let found = done(py, |progress| mindeg::interior::improve(&mesh, &wanted, progress))?;
    let report = dict(py, &InteriorAnswer::from(&found.after))?.cast_into::<PyDict>()?;
    report.set_item("before", dict(py, &InteriorAnswer::from(&found.before))?)?;
    let facts = Facts { report: Some(report.unbind()), projection, ..Facts::default() };
    Mesh::new(found.mesh, facts).keeping(&demands)
}
