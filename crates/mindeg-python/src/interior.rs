//! What is wanted of interior points, from Python's keyword arguments.

use mindeg::{InnerPoint, Interior};
use pyo3::prelude::*;
use serde_json::{Map, Value};

use crate::work::value_error;

/// The keyword arguments, in place of what the domain itself wants, and the points that the mesh must have.
pub(crate) fn wanted(given: &str, base: &Interior) -> PyResult<(Interior, Vec<InnerPoint>)> {
    let mut wanted = serde_json::to_value(base).map_err(value_error)?;
    let mut points = Vec::new();
    for (key, value) in serde_json::from_str::<Map<String, Value>>(given).map_err(value_error)? {
        match &*key {
            "fixed_points" => {
                let rows: Option<Vec<[f64; 2]>> =
                    serde_json::from_value(value).map_err(value_error)?;
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
