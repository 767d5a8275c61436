//! What is wanted of interior points, from Python's keyword arguments; what was reached, as a dict.

use mindeg::glam::DVec2;
use mindeg::interior::Report;
use mindeg::{Interior, Prefer, SizeAt};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyDictMethods};

/// The keyword arguments of `Domain.interior` and `improve`.
const KEYS: [&str; 9] = [
    "growth",
    "size_inside",
    "interior_degree",
    "boundary_degree",
    "target_angle",
    "prefer",
    "sizes",
    "fixed_points",
    "max_points",
];

/// What the keyword arguments want, over what the domain itself wants.
pub(crate) fn wanted(given: Option<&Bound<'_, PyDict>>, base: Interior) -> PyResult<Interior> {
    let mut wanted = base;
    let Some(given) = given else { return Ok(wanted) };
    for (key, value) in given.iter() {
        let key: String = key.extract()?;
        match &*key {
            "growth" => wanted.growth = Some(value.extract()?),
            "size_inside" => wanted.size_inside = Some(value.extract()?),
            "interior_degree" => {
                let (least, greatest) = value.extract()?;
                wanted.interior_degree = Some(least..=greatest);
            }
            "boundary_degree" => wanted.boundary_degree = Some(value.extract()?),
            "target_angle" => wanted.target_angle = Some(value.extract()?),
            "prefer" => wanted.prefer = Some(prefer(&value)?),
            "sizes" => {
                let sizes: Vec<(f64, f64, f64)> = value.extract()?;
                let size = |(x, y, size)| SizeAt { at: DVec2::new(x, y), size };
                wanted.sizes = sizes.into_iter().map(size).collect();
            }
            "fixed_points" => {
                let points: Vec<(f64, f64)> = value.extract()?;
                wanted.fixed.points = points.into_iter().map(DVec2::from).collect();
            }
            "max_points" => wanted.max_points = Some(value.extract()?),
            _ => {
                let problem = format!("no option is named {key:?}; give {}", KEYS.join(", "));
                return Err(PyValueError::new_err(problem));
            }
        }
    }
    Ok(wanted)
}

fn prefer(value: &Bound<'_, PyAny>) -> PyResult<Prefer> {
    match &*value.extract::<String>()? {
        "degree" => Ok(Prefer::Degree),
        "angle" => Ok(Prefer::Angle),
        other => {
            let problem = format!("prefer is {other:?}; give \"degree\" or \"angle\"");
            Err(PyValueError::new_err(problem))
        }
    }
}

/// What was reached.
pub(crate) fn reached<'py>(py: Python<'py>, report: &Report) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("min_angle", report.min_angle)?;
    dict.set_item("max_angle", report.max_angle)?;
    dict.set_item("angle_limit", report.limits.angle())?;
    dict.set_item("share_of_limit", report.share_of_limit)?;
    let interior = report.interior_degree.as_ref().map(|range| (*range.start(), *range.end()));
    dict.set_item("interior_degree", interior)?;
    let boundary = &report.boundary_degree;
    dict.set_item("boundary_degree", (*boundary.start(), *boundary.end()))?;
    let violation =
        |one: &mindeg::interior::Violation| (one.vertex, one.at.x, one.at.y, one.degree);
    dict.set_item("violations", report.violations.iter().map(violation).collect::<Vec<_>>())?;
    dict.set_item("area_ratio", report.area_ratio)?;
    dict.set_item("grading_p99", report.grading_p99)?;
    dict.set_item("interior_points", report.interior_points)?;
    Ok(dict)
}
