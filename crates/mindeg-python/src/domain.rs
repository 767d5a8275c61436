//! A domain: what to mesh.

use std::borrow::Cow;

use mindeg::changes::count_changes;
use mindeg::glam::DVec3;
use mindeg::{Domain as Inner, GOALS, Goal, Positions, exact};
use mindeg_answers::interior::InteriorAnswer;
use mindeg_answers::mesh::found_by;
use mindeg_mesh::filled;
use numpy::PyArray2;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::answers::{Degree, Suggestion, TradeOffPoint};
use crate::arrays;
use crate::dict::dict;
use crate::interior;
use crate::mesh::{Facts, Mesh};
use crate::work::{done, value_error};

/// A polygon with its boundary points.
#[pyclass(module = "mindeg", frozen, subclass, name = "_Domain")]
pub(crate) struct Domain {
    inner: Inner,
    /// The domain's source: it holds everything, so pickles store it.
    json: String,
}

#[pymethods]
impl Domain {
    #[new]
    fn from_json(json: String) -> PyResult<Self> {
        Ok(Self { inner: Inner::from_json(&json).map_err(value_error)?, json })
    }

    /// The domain as JSON, as `mindeg mesh` reads it.
    fn to_json(&self) -> &str {
        &self.json
    }

    /// The name, if there is one.
    #[getter]
    fn name(&self) -> Option<&str> {
        self.inner.name()
    }

    /// The boundary points, (n, 2) float64, read-only.
    #[getter]
    fn points<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let placement = self.inner.placement();
        let points = filled(0..placement.vertex_count(), DVec3::ZERO, |first, out| {
            placement.fill_positions(first, out);
        });
        arrays::points(py, &points)
    }

    /// The least maximum degree, and what is proven of it.
    fn degree(&self, py: Python<'_>) -> PyResult<Degree> {
        let found = done(py, |progress| exact::degree(&self.inner, progress))?;
        Ok(Degree { reached: found.reached, at_least: found.at_least })
    }

    /// The mesh of a goal; the package names the options.
    #[pyo3(name = "_mesh", signature = (**goal))]
    fn mesh(&self, py: Python<'_>, goal: Option<&Bound<'_, PyDict>>) -> PyResult<Mesh> {
        let goal = goal.map_or(Ok(Goal::default()), read_goal)?;
        let meshed = done(py, |progress| mindeg::mesh(&self.inner, goal, progress))?;
        let facts = Facts {
            least_max_degree: meshed.is_least_proven.then_some(meshed.least_max_degree),
            found_by: Some(found_by(meshed.found_by).to_owned()),
            report: None,
        };
        Ok(Mesh::new(meshed.mesh, facts))
    }

    /// A mesh with interior points; the package names the options.
    #[pyo3(name = "_interior")]
    fn interior(&self, py: Python<'_>, options: &str) -> PyResult<Mesh> {
        let base = self.inner.interior().cloned().unwrap_or_default();
        let (wanted, points) = interior::wanted(options, &base)?;
        let mut domain = Cow::Borrowed(&self.inner);
        if !points.is_empty() {
            let mut inside = self.inner.inside().clone();
            inside.points.extend(points);
            domain = Cow::Owned(self.inner.with_inside(inside).map_err(value_error)?);
        }
        let found = done(py, |progress| mindeg::interior::mesh(&domain, &wanted, progress))?;
        let report = dict(py, &InteriorAnswer::from(&found))?.cast_into::<PyDict>()?.unbind();
        let facts = Facts { report: Some(report), ..Facts::default() };
        Ok(Mesh::new(found.mesh, facts))
    }

    /// The best mesh for every maximum degree, from the least one on.
    fn tradeoff(&self, py: Python<'_>) -> PyResult<Vec<TradeOffPoint>> {
        let trade_off = done(py, |progress| exact::trade_off(&self.inner, progress))?;
        let least = trade_off.meshes().first().map(|least| least.max_degree);
        let point = |exact: &exact::ExactMesh| {
            let facts = Facts {
                least_max_degree: least,
                found_by: Some("search".to_owned()),
                report: None,
            };
            Ok(TradeOffPoint {
                max_degree: exact.max_degree,
                min_angle: exact.min_angle,
                share_of_delaunay: trade_off.share(exact),
                mesh: Py::new(py, Mesh::new(exact.mesh.clone(), facts))?,
            })
        };
        trade_off.meshes().iter().map(point).collect()
    }

    /// The smallest changes of interval counts that are found, one for each lower least maximum degree.
    fn suggest(&self, py: Python<'_>) -> PyResult<Vec<Suggestion>> {
        let suggestion = |one: mindeg_core::Suggestion, intervals, at_least| Suggestion {
            max_degree: one.max_degree,
            intervals,
            changes: one.changes.iter().map(|change| (change.side, change.by)).collect(),
            at_least,
        };
        if let Some(form) = self.inner.convex()
            && form.boundary().side_count() == self.inner.sides().len()
            && !self.inner.is_constrained()
        {
            let boundary = form.boundary();
            let by_formula = |one: mindeg_core::Suggestion| {
                let (intervals, cost) = (one.intervals(boundary), one.cost());
                suggestion(one, intervals, cost)
            };
            return Ok(mindeg_core::suggestions(boundary).map(by_formula).collect());
        }
        let changes = done(py, |progress| count_changes(&self.inner, None, progress))?;
        let found = changes.found.into_iter().map(|change| {
            let intervals = change.domain.rings().sides().map(u64::from).collect();
            suggestion(change.suggestion, intervals, change.at_least)
        });
        Ok(found.collect())
    }

    /// The comparison with other methods as JSON text.
    fn _compare(&self, py: Python<'_>) -> PyResult<String> {
        let options = mindeg_compare::CompareOptions::default();
        let compared = done(py, |_| mindeg_compare::compare(&self.inner, &options))?;
        let mut json = Vec::new();
        mindeg_compare::write_json(compared.report(), &mut json).map_err(value_error)?;
        String::from_utf8(json).map_err(value_error)
    }

    fn __repr__(&self) -> String {
        format!(
            "<mindeg.Domain {}{} vertices, {} sides>",
            self.inner.name().map(|name| format!("{name}: ")).unwrap_or_default(),
            self.inner.placement().vertex_count(),
            self.inner.sides().len(),
        )
    }
}

/// The goal among keyword arguments; one that is `None` is not given.
fn read_goal(given: &Bound<'_, PyDict>) -> PyResult<Goal> {
    let mut found: Option<(String, Goal)> = None;
    for (key, value) in given.iter().filter(|(_, value)| !value.is_none()) {
        let key = key.to_string();
        let Some(kind) = GOALS.iter().find(|kind| kind.key == key) else {
            let keys: Vec<&str> = GOALS.iter().map(|kind| kind.key).collect();
            return Err(value_error(format!(
                "no goal is named \"{key}\"; give {}",
                keys.join(", ")
            )));
        };
        if let Some((other, _)) = found {
            return Err(value_error(format!(
                "{other} and {key} exclude each other; give one of them"
            )));
        }
        let goal = kind.read(&value.str()?.to_string_lossy());
        let goal = goal.map_err(|problem| value_error(format!("{key}: {problem}")))?;
        found = Some((key, goal));
    }
    Ok(found.map(|(_, goal)| goal).unwrap_or_default())
}

/// The goals of a mesh, as dicts.
#[pyfunction]
#[pyo3(name = "_goals")]
pub(crate) fn goals(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    dict(py, &GOALS)
}
