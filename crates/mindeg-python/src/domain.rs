//! A domain: what to mesh.

use crate::answers::{Degree, Suggestion, TradeOffPoint};
use crate::arrays;
use crate::dict::dict;
use crate::mesh::{Facts, Mesh, hash_of};
use crate::wish::Wish;
use crate::work::{done, value_error};
use mindeg::changes::{count_changes, own_boundary};
use mindeg::glam::DVec3;
use mindeg::interior::{BoundaryDemands, condition};
use mindeg::{Domain as Inner, DomainJsonError, Positions, exact};
use mindeg_answers::advice::{Advice, AdviceAnswer, Purpose};
use mindeg_answers::condition::ConditionAnswer;
use mindeg_answers::numbers::counted;
use mindeg_mesh::filled;
use numpy::PyArray2;
use pyo3::prelude::*;
use serde_json::{Map, Value};
use std::collections::BTreeMap;

/// A polygon with its boundary points.
#[pyclass(module = "mindeg", frozen, subclass, name = "_Domain")]
pub(crate) struct Domain {
    inner: Inner,
    /// The domain's source: it holds everything, so pickles store it.
    json: String,
}

impl Domain {
    pub(crate) fn inner(&self) -> &Inner {
        &self.inner
    }
}

#[pymethods]
impl Domain {
    /// With `names`, the text was made of arguments: a fault then names these, and no line.
    #[new]
    #[pyo3(signature = (json, names=None))]
    fn from_json(json: String, names: Option<Vec<(String, String)>>) -> PyResult<Self> {
        let inner = Inner::from_json(&json).map_err(|error| match &names {
            None => value_error(error),
            Some(names) => value_error(in_arguments(&error, names)),
        })?;
        Ok(Self { inner, json })
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

    /// The mesh that is wished for; the package names the options.
    fn _mesh(&self, py: Python<'_>, wish: Wish<'_>) -> PyResult<Mesh> {
        let demands = wish.demands()?;
        wish.mesh_of(py, &self.inner)?.keeping(&demands)
    }

    /// The conditioned domain as JSON, and the changes; the package has the defaults.
    fn _condition<'py>(
        &self,
        py: Python<'py>,
        wish: Wish<'py>,
        limit: f64,
        given: [Option<f64>; 5],
        keep: Vec<String>,
    ) -> PyResult<(String, Bound<'py, PyAny>)> {
        let [within, size, growth, least_island, narrowest] = given;
        let (wanted, _) = wish.wanted(&self.inner.interior().cloned().unwrap_or_default())?;
        let base = size.map_or_else(BoundaryDemands::default, BoundaryDemands::of_size);
        let demands = BoundaryDemands {
            angle: limit,
            within: within.unwrap_or(base.within),
            growth: growth.unwrap_or(base.growth),
            least_hole: least_island.unwrap_or_default(),
            narrowest: narrowest.unwrap_or_default(),
            least_triangles: wanted.least_triangles(),
            ..base
        };
        let (new, conditioned) = done(py, |_| condition(&self.inner, &wanted, &demands, &keep))?;
        let json = new.to_json();
        let answer = ConditionAnswer::of(std::slice::from_ref(&self.inner), &[new], &[conditioned]);
        Ok((json, dict(py, &answer)?))
    }

    /// The best mesh for every maximum degree, from the least one on.
    fn tradeoff(&self, py: Python<'_>) -> PyResult<Vec<TradeOffPoint>> {
        let trade_off = done(py, |progress| exact::trade_off(&self.inner, progress))?;
        let least = trade_off.meshes().first().filter(|_| trade_off.is_least_proven());
        let least = least.map(|least| least.max_degree);
        let point = |exact: &exact::ExactMesh| {
            let facts = Facts {
                least_max_degree: least,
                found_by: Some(if exact.is_proven { "search" } else { "windows" }.to_owned()),
                report: None,
                projection: self.inner.projection().copied(),
            };
            Ok(TradeOffPoint {
                max_degree: exact.max_degree,
                min_angle: exact.min_angle,
                share_of_limit: trade_off.share(exact),
                is_proven: exact.is_proven,
                mesh: Py::new(py, Mesh::new(exact.mesh.clone(), facts))?,
            })
        };
        trade_off.meshes().iter().map(point).collect()
    }

    /// The mesh to take for each purpose, and the keywords of `Domain.mesh` that make it.
    fn _advice<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let own = std::slice::from_ref(&self.inner);
        let advice = done(py, |progress| Advice::of(own, progress).map_err(|(_, error)| error))?;
        let options = Purpose::ALL.map(|purpose| (purpose.name(), keywords(purpose)));
        dict(py, &(AdviceAnswer::of(advice), BTreeMap::from(options)))
    }

    /// The smallest changes of interval counts that are found, one for each lower least maximum degree.
    fn suggest(&self, py: Python<'_>) -> PyResult<Vec<Suggestion>> {
        let suggestion = |one: mindeg_core::Suggestion, intervals, at_least| Suggestion {
            max_degree: one.max_degree,
            intervals,
            changes: one.changes.iter().map(|change| (change.side, change.by)).collect(),
            at_least,
        };
        if let Some(boundary) = own_boundary(&self.inner) {
            let by_formula = |one: mindeg_core::Suggestion| {
                let (intervals, cost) = (one.intervals(boundary), one.cost());
                suggestion(one, intervals, cost)
            };
            return Ok(mindeg_core::suggestions(boundary).map(by_formula).collect());
        }
        let changes = done(py, |progress| count_changes(&self.inner, None, 1.0, progress))?;
        let found = changes.found.into_iter().map(|change| {
            let intervals = change.after.rings().sides().map(u64::from).collect();
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

    fn __eq__(&self, other: &Self) -> bool {
        self.inner == other.inner
    }

    fn __hash__(&self) -> u64 {
        hash_of(self.inner.placement())
    }

    fn __repr__(&self) -> String {
        format!(
            "<mindeg.Domain {}{} vertices, {}>",
            self.inner.name().map(|name| format!("{name}: ")).unwrap_or_default(),
            self.inner.placement().vertex_count(),
            counted(self.inner.sides().len() as u64, "side"),
        )
    }
}

/// The keywords of `Domain.mesh` for a purpose, whatever the domain itself asks for.
fn keywords(purpose: Purpose) -> Map<String, Value> {
    let mut keywords = Map::new();
    keywords.insert("interior".to_owned(), purpose.goal().is_none().into());
    if let Some((kind, value)) = purpose.goal().map(|goal| goal.kind_and_value())
        && !value.is_empty()
    {
        keywords.insert(kind.key.to_owned(), value.into());
    }
    keywords
}

/// A fault in the words of the arguments of which the text was made.
fn in_arguments(error: &DomainJsonError, names: &[(String, String)]) -> String {
    let DomainJsonError { path, message, .. } = error;
    let named = names.iter().find_map(|(key, name)| {
        let rest = path.strip_prefix(&**key)?;
        (rest.is_empty() || rest.starts_with(['.', '['])).then(|| format!("{name}{rest}"))
    });
    match named.as_deref().unwrap_or(path) {
        "" => message.clone(),
        path => format!("{path}: {message}"),
    }
}
