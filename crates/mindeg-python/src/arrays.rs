//! Arrays to numpy without copying; points and triangles from whatever numpy makes an array of.

use mindeg::TriMesh;
use mindeg::glam::DVec3;
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::work::value_error;

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

/// Points and triangles as a mesh.
pub(crate) fn tri_mesh(
    points: &Bound<'_, PyAny>,
    triangles: &Bound<'_, PyAny>,
) -> PyResult<TriMesh> {
    TriMesh::new(positions(points)?, index_rows(triangles)?).map_err(value_error)
}

/// The rows of an (n, 2) or (n, 3) array of real numbers as finite points, z = 0 where there is none.
pub(crate) fn positions(points: &Bound<'_, PyAny>) -> PyResult<Vec<DVec3>> {
    let wrong = |found: &str| {
        PyValueError::new_err(format!("points has {found}; give (n, 2) or (n, 3) real numbers"))
    };
    let array = numeric(points, "float64", "iuf", wrong)?;
    let rows: PyReadonlyArray2<'_, f64> =
        array.extract().map_err(|_| wrong("another number of axes than 2"))?;
    let rows = rows.as_array();
    let columns = rows.ncols();
    if !(2..=3).contains(&columns) {
        return Err(wrong(&format!("{columns} columns")));
    }
    let points = rows
        .rows()
        .into_iter()
        .map(|row| DVec3::new(row[0], row[1], if columns == 3 { row[2] } else { 0.0 }));
    let points: Vec<DVec3> = points.collect();
    match points.iter().position(|point| !point.is_finite()) {
        None => Ok(points),
        Some(index) => {
            let problem = format!("point {index} is not finite; give finite numbers");
            Err(PyValueError::new_err(problem))
        }
    }
}

/// The rows of an (m, 3) array of integers of any type.
fn index_rows(triangles: &Bound<'_, PyAny>) -> PyResult<Vec<[u32; 3]>> {
    let wrong = |found: &str| {
        let problem = format!("triangles has {found}; give (m, 3) indices from 0");
        PyValueError::new_err(problem)
    };
    // What has no rows has no type either.
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
    let index = |value: i64| u32::try_from(value).map_err(|_| wrong(&format!("the index {value}")));
    rows.rows()
        .into_iter()
        .map(|row| Ok([index(row[0])?, index(row[1])?, index(row[2])?]))
        .collect()
}

/// What is given as an array of a type, if it holds numbers of these kinds; copied only where it has
/// another type.
fn numeric<'py>(
    given: &Bound<'py, PyAny>,
    dtype: &str,
    kinds: &str,
    wrong: impl Fn(&str) -> PyErr,
) -> PyResult<Bound<'py, PyAny>> {
    let numpy = given.py().import("numpy")?;
    let array = numpy.call_method1("asarray", (given,))?;
    let kind: String = array.getattr("dtype")?.getattr("kind")?.extract()?;
    if !kinds.contains(&*kind) {
        return Err(wrong(&format!("the type {}", array.getattr("dtype")?)));
    }
    numpy.call_method1("ascontiguousarray", (array, dtype))
}
