//! The mesh that is wanted: a goal, or points inside.

use std::borrow::Cow;
use std::ffi::CString;

use mindeg::{Domain, GOALS, Goal, InnerPoint, Interior};
use mindeg_answers::demands::Demands;
use mindeg_answers::interior::InteriorAnswer;
use mindeg_answers::mesh::found_by;
use mindeg_answers::sizes::too_coarse;
use pyo3::exceptions::PyUserWarning;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};
use serde_json::{Map, Value};

use crate::demands::demands;
use crate::dict::dict;
use crate::interior;
use crate::mesh::{Facts, Mesh};
use crate::work::{done, value_error};

/// A warning names the line that called `Domain.mesh`, which calls this.
const OF_CALLER: i32 = 2;

/// The mesh that is wanted: a dict that the Python side makes of keyword arguments.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Wish<'py> {
    /// Whether points are inside; as the domain says, if it is not given.
    interior: Option<bool>,
    /// The options of points inside, in JSON.
    options: String,
    goal: Bound<'py, PyDict>,
    /// The program whose rules the mesh must keep.
    preset: Option<String>,
}

impl Wish<'_> {
    /// Whether points are inside, where the domain itself asks for them or not; refuses what has no meaning then.
    pub(crate) fn has_interior(&self, is_asked_for: bool) -> PyResult<bool> {
        let has_interior = self.interior.unwrap_or(is_asked_for);
        if has_interior {
            if let Some((key, _)) = self.goal.iter().find(|(_, value)| !value.is_none()) {
                return Err(value_error(format!(
                    "{key} is for meshes of boundary points alone; with points inside, interior_degree and \
                     boundary_degree limit degrees, and the angle is as large as found anyway"
                )));
            }
        } else {
            let options: Map<String, Value> =
                serde_json::from_str(&self.options).map_err(value_error)?;
            if let Some(key) = options.keys().next() {
                return Err(value_error(format!(
                    "{key} is for meshes with points inside; give interior=True"
                )));
            }
        }
        Ok(has_interior)
    }

    /// The demands on the mesh.
    pub(crate) fn demands(&self) -> PyResult<Demands> {
        demands(None, None, self.preset.as_deref())
    }

    pub(crate) fn goal(&self) -> PyResult<Goal> {
        Ok(read_goal(&self.goal)?.0)
    }

    /// Refuses a mesh of a higher degree than is demanded beside another goal.
    pub(crate) fn refuse_above(&self, reached: u32) -> PyResult<()> {
        match read_goal(&self.goal)?.1 {
            Some(limit) if reached > limit => Err(value_error(format!(
                "{LIMIT} is {limit}, and the mesh has maximum degree {reached}; raise it, or give less of the angle"
            ))),
            _ => Ok(()),
        }
    }

    /// The wish for points inside, in place of the domain's own, with what a preset asks of them, and the points that the mesh must have.
    pub(crate) fn wanted(&self, base: &Interior) -> PyResult<(Interior, Vec<InnerPoint>)> {
        let (wanted, points) = interior::wanted(&self.options, base)?;
        let wanted = match self.demands()?.preset {
            Some(preset) => preset.asked_of(wanted),
            None => wanted,
        };
        Ok((wanted, points))
    }

    /// The mesh of a domain.
    pub(crate) fn mesh_of(&self, py: Python<'_>, domain: &Domain) -> PyResult<Mesh> {
        if self.has_interior(domain.interior().is_some())? {
            return self.with_points_inside(py, domain);
        }
        let goal = self.goal()?;
        let meshed = done(py, |progress| mindeg::mesh(domain, goal, progress))?;
        self.refuse_above(meshed.mesh.max_total_degree())?;
        let facts = Facts {
            least_max_degree: meshed.is_least_proven.then_some(meshed.least_max_degree),
            found_by: Some(found_by(meshed.found_by).to_owned()),
            report: None,
            projection: domain.projection().copied(),
        };
        Ok(Mesh::new(meshed.mesh, facts))
    }

    fn with_points_inside(&self, py: Python<'_>, domain: &Domain) -> PyResult<Mesh> {
        let base = domain.interior().cloned().unwrap_or_default();
        let (wanted, points) = self.wanted(&base)?;
        let mut domain = Cow::Borrowed(domain);
        if !points.is_empty() {
            let mut inside = domain.inside().clone();
            let first = inside.points.len();
            inside.points.extend(points);
            let given = domain.with_inside(inside);
            let given = given.map_err(|error| interior::fault_of_points(&error, first))?;
            domain = Cow::Owned(given);
        }
        let found = done(py, |progress| mindeg::interior::mesh(&domain, &wanted, progress))?;
        if let Some((problem, least)) = too_coarse(&found, domain.projection()) {
            let words = format!(
                "{problem}. Give these sides more intervals, or make the domain with size={least}, or \
                 condition it with the same sizes"
            );
            let category = py.get_type::<PyUserWarning>();
            PyErr::warn(py, &category, &CString::new(words)?, OF_CALLER)?;
        }
        let report = dict(py, &InteriorAnswer::from(&found))?.cast_into::<PyDict>()?.unbind();
        let projection = domain.projection().copied();
        let facts = Facts { report: Some(report), projection, ..Facts::default() };
        Ok(Mesh::new(found.mesh, facts))
    }
}

/// The goal among keyword arguments, and the maximum degree that is demanded besides: as on the command line the first of the
/// table decides. One that is `None` is not given.
fn read_goal(given: &Bound<'_, PyDict>) -> PyResult<(Goal, Option<u32>)> {
    let mut found: Vec<(usize, Goal)> = Vec::new();
    for (key, value) in given.iter().filter(|(_, value)| !value.is_none()) {
        let key = key.to_string();
        let Some(place) = GOALS.iter().position(|kind| kind.key == key) else {
            let keys: Vec<&str> = GOALS.iter().map(|kind| kind.key).collect();
            return Err(value_error(format!(
                "no goal is named \"{key}\"; give {}",
                keys.join(", ")
            )));
        };
        if key == LIMIT && value.is_instance_of::<PyString>() {
            return Err(value_error(format!("{key} is the text {value}; give a whole number")));
        }
        let goal = GOALS[place].read(&value.str()?.to_string_lossy());
        let goal = goal.map_err(|problem| value_error(format!("{key}: {problem}")))?;
        found.push((place, goal));
    }
    found.sort_by_key(|(place, _)| *place);
    let others: Vec<&str> =
        found.iter().map(|(place, _)| GOALS[*place].key).filter(|key| *key != LIMIT).collect();
    if let [one, other, ..] = others[..] {
        return Err(value_error(format!("{one} and {other} exclude each other; give one of them")));
    }
    let limit = found.iter().find_map(|(_, goal)| match goal {
        Goal::MaxDegree(limit) => Some(*limit),
        _ => None,
    });
    Ok((found.first().map(|(_, goal)| *goal).unwrap_or_default(), limit))
}

/// The goal that is a demand beside others.
const LIMIT: &str = "max_degree";

/// The goals of a mesh, as dicts.
#[pyfunction]
#[pyo3(name = "_goals")]
pub(crate) fn goals(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    dict(py, &GOALS)
}
