//! Wishes for interior points, from Python's keyword arguments.

use std::path::PathBuf;

use mindeg::{DomainError, InnerPoint, Interior};
use mindeg_files::{Input, Session};
use pyo3::prelude::*;
use serde_json::{Map, Value};

use crate::dict::dict;
use crate::save::file_error;
use crate::work::value_error;

/// The sizes in a file, as a dict of points and triangles.
#[pyfunction]
#[pyo3(name = "_sizes_of_file")]
pub(crate) fn sizes_of_file(py: Python<'_>, path: PathBuf) -> PyResult<Bound<'_, PyAny>> {
    let sizes = py.detach(|| Session::new("").sizes(&Input::File(&path)));
    dict(py, &sizes.map_err(file_error)?)
}

/// The keyword arguments, in place of what the domain itself wants, and the points that the mesh must have.
pub(crate) fn wanted(given: &str, base: &Interior) -> PyResult<(Interior, Vec<InnerPoint>)> {
    let mut wanted = serde_json::to_value(base).map_err(value_error)?;
    let mut points = Vec::new();
    for (key, value) in serde_json::from_str::<Map<String, Value>>(given).map_err(value_error)? {
        match &*key {
            "fixed_points" => {
                let rows: Option<Vec<[f64; 2]>> = serde_json::from_value(value)
                    .map_err(|_| value_error("fixed_points: give (n, 2), x and y of each point"))?;
                let point = |at: [f64; 2]| InnerPoint { at: at.into(), ..InnerPoint::default() };
                points = rows.unwrap_or_default().into_iter().map(point).collect();
            }
            _ => wanted[key] = value,
        }
    }
    let read = Interior::from_json(&wanted.to_string());
    let wanted = read.map_err(|error| value_error(format!("{}: {}", error.path, error.message)))?;
    wanted.check().map_err(|DomainError { place, message, .. }| {
        let (place, key) = (place.to_string(), message.split(' ').next());
        value_error(if key == Some(&*place) { message } else { format!("{place}: {message}") })
    })?;
    Ok((wanted, points))
}

/// A fault of the points inside a domain, of which those from the `first` on were given as `fixed_points`.
pub(crate) fn fault_of_points(error: &DomainError, first: usize) -> PyErr {
    let place = error.place.to_string();
    let index = place.strip_prefix("points[").and_then(|rest| rest.split(']').next());
    let index = index.and_then(|index| index.parse::<usize>().ok()?.checked_sub(first));
    match index {
        Some(index) => value_error(format!("fixed_points[{index}]: {}", error.message)),
        None => value_error(error),
    }
}
