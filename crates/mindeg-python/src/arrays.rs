//! Arrays to numpy without copying.

use mindeg::glam::DVec3;
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// An array of n rows of three, in the memory of a flat list.
pub(crate) fn rows_of_three<'py, T: numpy::Element>(
    py: Python<'py>,
    flat: Vec<T>,
) -> PyResult<Bound<'py, PyArray2<T>>> {
    let rows = flat.len() / 3;
    PyArray1::from_vec(py, flat).reshape([rows, 3])
}

/// Triangles as the rows of an array of uint32.
pub(crate) fn triangles<'py>(
    py: Python<'py>,
    triangles: Vec<[u32; 3]>,
) -> PyResult<Bound<'py, PyArray2<u32>>> {
    rows_of_three(py, triangles.into_flattened())
}

/// Points as rows of two where all have z = 0, else of three.
pub(crate) fn points<'py>(
    py: Python<'py>,
    points: &[DVec3],
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    if points.iter().all(|point| point.z == 0.0) {
        let flat: Vec<f64> = points.iter().flat_map(|point| [point.x, point.y]).collect();
        return PyArray1::from_vec(py, flat).reshape([points.len(), 2]);
    }
    rows_of_three(py, points.iter().flat_map(|point| point.to_array()).collect())
}

/// The rows of an (n, 2) or (n, 3) array as points, z = 0 where there is none.
pub(crate) fn positions(points: &PyReadonlyArray2<'_, f64>) -> PyResult<Vec<DVec3>> {
    let points = points.as_array();
    let columns = points.ncols();
    if !(2..=3).contains(&columns) {
        let problem = format!("points has {columns} columns; give (n, 2) or (n, 3)");
        return Err(PyValueError::new_err(problem));
    }
    let z = |row: usize| if columns == 3 { points[[row, 2]] } else { 0.0 };
    Ok((0..points.nrows())
        .map(|row| DVec3::new(points[[row, 0]], points[[row, 1]], z(row)))
        .collect())
}
