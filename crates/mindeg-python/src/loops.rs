//! Loops in space: closing one, joining two.

use mindeg::fill::{EXTRA_AREA, FIRST_LIMIT};
use mindeg::glam::DVec3;
use mindeg_exact::{BridgeProblem, LoopLimit, LoopProblem, bridge_rings, fill_loop as filled};
use numpy::PyArray2;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays;
use crate::work::{done, value_error};

/// The triangles, and what is known of them.
type Answer<'py> = (Bound<'py, PyArray2<u32>>, Bound<'py, PyDict>);

/// Close a loop in space by the triangulation of least area under a limit on the total degree.
///
/// `points` is (n, 2) or (n, 3); `external` counts the edges at each vertex without those of the filling, 2 each by
/// default; `excluded` are pairs that may not be joined. Without `max_degree`, the least limit
/// possible from 6 up that takes at most 5 % more area than no limit. Gives (n - 2, 3) triangles and a dict: limit, max_degree, area.
#[pyfunction]
#[pyo3(
    signature = (points, *, external=None, excluded=Vec::new(), max_degree=None),
    text_signature = "(points, *, external=None, excluded=(), max_degree=None)"
)]
pub(crate) fn fill_loop<'py>(
    py: Python<'py>,
    points: &Bound<'py, PyAny>,
    external: Option<Vec<u32>>,
    excluded: Vec<[u32; 2]>,
    max_degree: Option<u32>,
) -> PyResult<Answer<'py>> {
    let points = ring(points, "points")?;
    let external = degrees(external, points.len())?;
    check_pairs(&excluded, [points.len(); 2])?;
    let problem = LoopProblem::new(&points, &external, excluded).map_err(value_error)?;
    let within = LoopLimit::LeastWithin { from: FIRST_LIMIT, extra_area: EXTRA_AREA };
    let limit = max_degree.map_or(within, LoopLimit::AtMost);
    let found = done(py, |progress| filled(&problem, limit, progress))?;
    let facts = PyDict::new(py);
    facts.set_item("limit", found.limit)?;
    facts.set_item("max_degree", found.max_degree)?;
    facts.set_item("area", found.area)?;
    facts.set_item("area_without_limit", found.without_limit.0)?;
    Ok((arrays::rows(py, found.triangles)?, facts))
}

/// Join two loops by one strip: the largest minimum angle at the least maximum degree possible, or
/// within `max_degree`.
///
/// Triangles run forward along the first loop and backward along the second. Indices count the first loop's
/// vertices, then the second's. `external` as for `fill_loop`, for both loops together.
#[pyfunction]
#[pyo3(
    signature = (first, second, *, external=None, excluded=Vec::new(), max_degree=None),
    text_signature = "(first, second, *, external=None, excluded=(), max_degree=None)"
)]
pub(crate) fn bridge_loops<'py>(
    py: Python<'py>,
    first: &Bound<'py, PyAny>,
    second: &Bound<'py, PyAny>,
    external: Option<Vec<u32>>,
    excluded: Vec<[u32; 2]>,
    max_degree: Option<u32>,
) -> PyResult<Answer<'py>> {
    let (x, y) = (ring(first, "first")?, ring(second, "second")?);
    let external = degrees(external, x.len() + y.len())?;
    check_pairs(&excluded, [x.len(), y.len()])?;
    let external = external.split_at(x.len());
    let problem = BridgeProblem::new([&x, &y], [external.0, external.1], excluded);
    let problem = problem.map_err(value_error)?;
    let found = done(py, |progress| bridge_rings(&problem, max_degree, progress))?;
    let facts = PyDict::new(py);
    facts.set_item("max_degree", found.max_degree)?;
    facts.set_item("least_max_degree", found.least_max_degree)?;
    facts.set_item("at_least", found.lower_bound)?;
    facts.set_item("min_angle", found.min_angle)?;
    Ok((arrays::rows(py, found.triangles)?, facts))
}

fn ring(points: &Bound<'_, PyAny>, key: &str) -> PyResult<Vec<DVec3>> {
    let points = arrays::positions(points, key, 2..=3)?;
    if points.len() < 3 {
        return Err(value_error(format!("found {} points; a loop has at least 3", points.len())));
    }
    Ok(points)
}

fn degrees(given: Option<Vec<u32>>, count: usize) -> PyResult<Vec<u32>> {
    let degrees = given.unwrap_or_else(|| vec![2; count]);
    if degrees.len() != count {
        return Err(value_error(format!(
            "found {} external degrees for {count} vertices; give one for each",
            degrees.len()
        )));
    }
    /// More than any vertex of a mesh has; limits up to the greatest degree are tried one by one.
    const MOST: u32 = 1_000_000;
    if let Some(vertex) = degrees.iter().position(|&degree| degree > MOST) {
        return Err(value_error(format!(
            "the external degree of vertex {vertex} is {}; give at most {MOST}",
            degrees[vertex]
        )));
    }
    Ok(degrees)
}

fn check_pairs(pairs: &[[u32; 2]], counts: [usize; 2]) -> PyResult<()> {
    let is_there = |pair: &&[u32; 2]| {
        pair.iter().zip(counts).all(|(&vertex, count)| (vertex as usize) < count)
    };
    match pairs.iter().find(|pair| !is_there(pair)) {
        None => Ok(()),
        Some([a, b]) => Err(value_error(format!(
            "excluded has the pair ({a}, {b}), and there is no such vertex; count from 0"
        ))),
    }
}
