//! The answers of the library besides meshes.

use pyo3::prelude::*;

use crate::mesh::Mesh;
use mindeg_answers::numbers::{percent, steady_angle};

/// The least maximum degree of a domain, and why it is no less.
#[pyclass(module = "mindeg", frozen, get_all)]
pub(crate) struct Degree {
    /// The maximum degree that a mesh reaches.
    pub(crate) reached: u32,
    /// No mesh has less than this.
    pub(crate) at_least: u32,
}

#[pymethods]
impl Degree {
    /// Whether no mesh has a smaller maximum degree than the one reached.
    #[getter]
    fn is_proven(&self) -> bool {
        self.reached == self.at_least
    }

    fn __repr__(&self) -> String {
        format!("<mindeg.Degree reached={} at_least={}>", self.reached, self.at_least)
    }
}

/// The best mesh with one maximum degree.
#[pyclass(module = "mindeg", frozen, get_all)]
pub(crate) struct TradeOffPoint {
    /// The limit on the degree of every vertex.
    pub(crate) max_degree: u32,
    /// The largest minimum angle within it, in degrees.
    pub(crate) min_angle: f64,
    /// The share of Delaunay's minimum angle, 0 to 1.
    pub(crate) share_of_limit: f64,
    /// Whether no mesh within the limit has a larger minimum angle; if not proven, one may.
    pub(crate) is_proven: bool,
    /// The mesh.
    pub(crate) mesh: Py<Mesh>,
}

#[pymethods]
impl TradeOffPoint {
    fn __repr__(&self) -> String {
        format!(
            "<mindeg.TradeOffPoint max_degree={} min_angle={} share_of_limit={}>",
            self.max_degree,
            steady_angle(self.min_angle),
            percent(self.share_of_limit)
        )
    }
}

/// The smallest change of interval counts that lowers the least maximum degree.
#[pyclass(module = "mindeg", frozen, get_all)]
pub(crate) struct Suggestion {
    /// The maximum degree that some mesh has after the change.
    pub(crate) max_degree: u32,
    /// The sides to change, from 0, and by how many intervals.
    pub(crate) changes: Vec<(usize, i64)>,
    /// The number of intervals of each side after the change.
    pub(crate) intervals: Vec<u64>,
    /// No change of fewer intervals than this leads to a degree as small.
    pub(crate) at_least: u64,
}

#[pymethods]
impl Suggestion {
    fn __repr__(&self) -> String {
        format!("<mindeg.Suggestion max_degree={} changes={:?}>", self.max_degree, self.changes)
    }
}
