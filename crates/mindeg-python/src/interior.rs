//! What is wanted of interior points, from Python's keyword arguments.

use mindeg::glam::DVec3;
use mindeg::{Interior, Prefer, SizeAt};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyDictMethods};

use crate::arrays;

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
pub(crate) fn wanted(given: &Bound<'_, PyDict>, base: Interior) -> PyResult<Interior> {
    let mut wanted = base;
    for (key, value) in given.iter() {
        if value.is_none() {
            continue;
        }
        let key: String = key.extract()?;
        let named =
            |error: PyErr| PyTypeError::new_err(format!("{key}: {}", error.value(given.py())));
        match &*key {
            "growth" => wanted.growth = Some(value.extract().map_err(named)?),
            "size_inside" => wanted.size_inside = Some(value.extract().map_err(named)?),
            "interior_degree" => {
                let [least, greatest] = value.extract().map_err(named)?;
                wanted.interior_degree = Some(least..=greatest);
            }
            "boundary_degree" => wanted.boundary_degree = Some(value.extract().map_err(named)?),
            "target_angle" => wanted.target_angle = Some(value.extract().map_err(named)?),
            "prefer" => wanted.prefer = Some(prefer(&value.extract::<String>().map_err(named)?)?),
            "sizes" => {
                let size = |row: DVec3| SizeAt { at: row.truncate(), size: row.z };
                wanted.sizes = rows(&value, &key, 3)?.into_iter().map(size).collect();
            }
            "fixed_points" => {
                let points = rows(&value, &key, 2)?;
                wanted.fixed.points = points.into_iter().map(DVec3::truncate).collect();
            }
            "max_points" => wanted.max_points = Some(value.extract().map_err(named)?),
            _ => {
                let problem = format!("no option is named {key:?}; give {}", KEYS.join(", "));
                return Err(PyValueError::new_err(problem));
            }
        }
    }
    Ok(wanted)
}

/// Rows of so many numbers; none of an empty list, which has no columns.
fn rows(given: &Bound<'_, PyAny>, key: &str, columns: usize) -> PyResult<Vec<DVec3>> {
    if given.len().is_ok_and(|rows| rows == 0) {
        return Ok(Vec::new());
    }
    arrays::positions(given, key, columns..=columns)
}

fn prefer(value: &str) -> PyResult<Prefer> {
    match value {
        "degree" => Ok(Prefer::Degree),
        "angle" => Ok(Prefer::Angle),
        other => {
            let problem = format!("prefer is {other:?}; give \"degree\" or \"angle\"");
            Err(PyValueError::new_err(problem))
        }
    }
}
