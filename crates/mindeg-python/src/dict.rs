//! Answers as dicts.

use pyo3::prelude::*;
use serde::Serialize;

use crate::work::value_error;

/// A value of the library as dicts and lists, with the keys that the command line prints.
pub(crate) fn dict<'py>(py: Python<'py>, answer: &impl Serialize) -> PyResult<Bound<'py, PyAny>> {
    let json = serde_json::to_string(answer).map_err(value_error)?;
    py.import("json")?.call_method1("loads", (json,))
}
