//! Arrays to numpy without copying; points and triangles from whatever numpy makes an array of.

use std::ops::RangeInclusive;

use mindeg::glam::DVec3;
use numpy::{Element, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyList, PyTuple};

use crate::work::value_error;

/// The rows of a flat list as an array in its memory that nobody can write to: what is worked out from a
/// mesh or domain goes on from its own points, not from the array.
pub(crate) fn rows<const N: usize, T: Element>(
    py: Python<'_>,
    rows: Vec<[T; N]>,
) -> PyResult<Bound<'_, PyArray2<T>>> {
    let count = rows.len();
    read_only(PyArray1::from_vec(py, rows.into_flattened())).reshape([count, N])
}

/// The same array, to read alone.
pub(crate) fn read_only<T: Element>(array: Bound<'_, PyArray1<T>>) -> Bound<'_, PyArray1<T>> {
    let _ = array.readwrite().make_nonwriteable();
    array
}

/// Points as rows of two where all have z = 0, else of three.
pub(crate) fn points<'py>(
    py: Python<'py>,
    points: &[DVec3],
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    if points.iter().all(|point| point.z == 0.0) {
        return rows(py, points.iter().map(|point| [point.x, point.y]).collect());
    }
    rows(py, points.iter().map(DVec3::to_array).collect())
}

/// The rows of an array of real numbers as finite points, z = 0 where there is none; `key` is the name that the
/// caller knows it by.
pub(crate) fn positions(
    given: &Bound<'_, PyAny>,
    key: &str,
    columns: RangeInclusive<usize>,
) -> PyResult<Vec<DVec3>> {
    let shapes: Vec<String> = columns.clone().map(|count| format!("(n, {count})")).collect();
    let shapes = shapes.join(" or ");
    let wrong = |found: &str| value_error(format!("{key} has {found}; give {shapes} real numbers"));
    let array = numeric(given, "float64", "iuf", wrong)?;
    let rows: PyReadonlyArray2<'_, f64> =
        array.extract().map_err(|_| wrong("another number of axes than 2"))?;
    let rows = rows.as_array();
    let count = rows.ncols();
    if !columns.contains(&count) {
        return Err(wrong(&format!("{count} columns")));
    }
    let points = rows
        .rows()
        .into_iter()
        .map(|row| DVec3::new(row[0], row[1], if count == 3 { row[2] } else { 0.0 }));
    let points: Vec<DVec3> = points.collect();
    match points.iter().position(|point| !point.is_finite()) {
        None => Ok(points),
        Some(index) => {
            Err(value_error(format!("{key}[{index}] is not finite; give finite numbers")))
        }
    }
}

/// The rows of an array with two columns, for a domain's JSON.
#[pyfunction]
#[pyo3(name = "_rows_of_two")]
pub(crate) fn rows_of_two(given: &Bound<'_, PyAny>, key: &str) -> PyResult<Vec<[f64; 2]>> {
    let points = positions(given, key, 2..=2)?;
    Ok(points.into_iter().map(|point| [point.x, point.y]).collect())
}

/// The rows of an (m, 3) array of integers of any type.
pub(crate) fn index_rows(triangles: &Bound<'_, PyAny>) -> PyResult<Vec<[u32; 3]>> {
    let wrong =
        |found: &str| value_error(format!("triangles has {found}; give (m, 3) indices from 0"));
    // An array without rows has no type either.
    if triangles.len().is_ok_and(|rows| rows == 0) {
        return Ok(Vec::new());
    }
    // Wider than any index, so that those that are none are seen; too great for it, they turn negative.
    let array = numeric(triangles, "int64", "iu", wrong)?;
    let rows: PyReadonlyArray2<'_, i64> =
        array.extract().map_err(|_| wrong("another number of axes than 2"))?;
    let rows = rows.as_array();
    if rows.ncols() != 3 {
        return Err(wrong(&format!("{} columns", rows.ncols())));
    }
    let index = |((row, column), &value): ((usize, usize), &i64)| {
        u32::try_from(value).or_else(|_| {
            let given = triangles.get_item(row)?.get_item(column)?;
            Err(wrong(&format!("the index {given}")))
        })
    };
    let indices: Vec<u32> = rows.indexed_iter().map(index).collect::<PyResult<_>>()?;
    Ok(indices.chunks_exact(3).map(|row| [row[0], row[1], row[2]]).collect())
}

/// The argument as an array of a type, if it holds numbers of these kinds and hides none; copied only where
/// it has another type.
fn numeric<'py>(
    given: &Bound<'py, PyAny>,
    dtype: &str,
    kinds: &str,
    wrong: impl Fn(&str) -> PyErr,
) -> PyResult<Bound<'py, PyAny>> {
    let numpy = given.py().import("numpy")?;
    let masked = numpy.getattr("ma")?.getattr("MaskedArray")?;
    let hides = |one: &Bound<'py, PyAny>| -> PyResult<bool> {
        Ok(one.is_instance(&masked)? && one.getattr("mask")?.call_method0("any")?.is_truthy()?)
    };
    let mut hides_some = hides(given)?;
    // An array of masked arrays would be made of what they hide.
    if given.is_instance_of::<PyList>() || given.is_instance_of::<PyTuple>() {
        for row in given.try_iter()? {
            hides_some |= hides(&row?)?;
        }
    }
    if hides_some {
        return Err(wrong("masked values"));
    }
    let array = numpy.call_method1("asarray", (given,)).map_err(|error| {
        let is_ragged = error.is_instance_of::<PyValueError>(given.py());
        if is_ragged { wrong("rows of different lengths") } else { error }
    })?;
    let kind: String = array.getattr("dtype")?.getattr("kind")?.extract()?;
    if !kinds.contains(&*kind) {
        return Err(wrong(&format!("the type {}", array.getattr("dtype")?)));
    }
    numpy.call_method1("ascontiguousarray", (array, dtype))
}
