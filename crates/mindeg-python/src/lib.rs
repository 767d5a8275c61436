//! The Python module `mindeg._mindeg`; the package in `python/mindeg` adds what is easier in Python.
//!
//! Everything is worked out by the library. Arrays go to numpy without copying, work runs without the
//! interpreter's lock, Ctrl-C cancels it, and errors are `ValueError`s with the words of the command line.

mod answers;
mod arrays;
mod demands;
mod dict;
mod domain;
mod improve;
mod interior;
mod loops;
mod mesh;
mod outlines;
mod pickled;
mod remesh;
mod save;
mod verify;
mod wish;
mod work;

use pyo3::prelude::*;

#[pymodule]
mod _mindeg {
    use pyo3::prelude::*;

    #[pymodule_export]
    use super::answers::{Degree, Suggestion, TradeOffPoint};
    #[pymodule_export]
    use super::arrays::rows_of_two;
    #[pymodule_export]
    use super::domain::Domain;
    #[pymodule_export]
    use super::improve::improve;
    #[pymodule_export]
    use super::interior::sizes_of_file;
    #[pymodule_export]
    use super::loops::{between, bridge, bridge_loops, fill, fill_loop, stitch};
    #[pymodule_export]
    use super::mesh::{Mesh, read};
    #[pymodule_export]
    use super::outlines::{domain_of_outline, mesh_of_file, mesh_of_mesh};
    #[pymodule_export]
    use super::remesh::remesh;
    #[pymodule_export]
    use super::verify::{inspect, presets, verify};
    #[pymodule_export]
    use super::wish::goals;

    #[pymodule_init]
    fn version(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
