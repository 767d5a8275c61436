//! Wishes for interior points, from Python's keyword arguments.

use std::path::PathBuf;

use mindeg::{InnerPoint, Interior};
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
    Ok((wanted, points))
}
