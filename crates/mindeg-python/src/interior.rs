//! What is wanted of interior points, from Python's keyword arguments.

use mindeg::Interior;
use pyo3::prelude::*;
use serde_json::{Map, Value};

use crate::work::value_error;

/// What the keyword arguments want, as JSON, in place of what the domain itself wants.
pub(crate) fn wanted(given: &str, base: &Interior) -> PyResult<Interior> {
    let mut wanted = serde_json::to_value(base).map_err(value_error)?;
    for (key, value) in serde_json::from_str::<Map<String, Value>>(given).map_err(value_error)? {
        match &*key {
            "fixed_points" => wanted["fixed"]["points"] = value,
            _ => wanted[key] = value,
        }
    }
    let read = Interior::from_json(&wanted.to_string());
    read.map_err(|error| value_error(format!("{}: {}", error.path, error.message)))
}
