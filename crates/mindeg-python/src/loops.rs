//! Loops in space: closing one, joining two; and those of whole meshes.

use mindeg::bridge::{BridgeOptions, bridge as joined};
use mindeg::fill::{EXTRA_AREA, FIRST_LIMIT, FillOptions, fill as closed, points_between};
use mindeg::glam::DVec3;
use mindeg::stitch::{Gap, stitch as stitched};
use mindeg::{Loops, TriMesh};
use mindeg_answers::loops::{BridgeAnswer, FillAnswer, LoopName, OpenLoop};
use mindeg_answers::stitch::StitchAnswer;
use mindeg_exact::{BridgeProblem, LoopLimit, LoopProblem, bridge_rings, fill_loop as filled};
use numpy::PyArray2;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays;
use crate::dict::dict;
use crate::domain::Domain;
use crate::mesh::{Facts, Mesh, tri_mesh};
use crate::work::{done, value_error};

/// The triangles, and what is known of them.
type Answer<'py> = (Bound<'py, PyArray2<u32>>, Bound<'py, PyDict>);

/// Points, and triangles that name them.
type PointsAndTriangles<'py> = (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<u32>>);

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

/// Points inside a surface between rims in space, and its triangles. `rims` is a list of (n, 3) arrays, `triangles` a surface between
/// them by the indices of all their points, and `around` the corners of the triangles beside them, three rows each.
#[pyfunction]
#[pyo3(name = "_points_between")]
pub(crate) fn between<'py>(
    py: Python<'py>,
    rims: Vec<Bound<'py, PyAny>>,
    triangles: &Bound<'py, PyAny>,
    around: &Bound<'py, PyAny>,
) -> PyResult<PointsAndTriangles<'py>> {
    let rims: Vec<Vec<DVec3>> =
        rims.iter().map(|rim| ring(rim, "rims")).collect::<PyResult<_>>()?;
    let plain = arrays::index_rows(triangles)?;
    let count: usize = rims.iter().map(Vec::len).sum();
    if plain.iter().flatten().any(|&vertex| vertex as usize >= count) {
        return Err(value_error(format!("triangles name a point beyond the {count} of the rims")));
    }
    let corners = arrays::positions(around, "around", 3..=3)?;
    let around: Vec<[DVec3; 3]> = corners.as_chunks().0.to_vec();
    let rims: Vec<&[DVec3]> = rims.iter().map(Vec::as_slice).collect();
    let (points, triangles) =
        done(py, |progress| points_between(&rims, &plain, &around, progress))?;
    let points = points.iter().map(DVec3::to_array);
    Ok((arrays::rows(py, points.collect())?, arrays::rows(py, triangles)?))
}

/// Close the holes of a mesh: each boundary loop by the triangulation of least area under a limit on the total degree.
///
/// Takes a mesh in hand, or points and triangles. `through` are vertices: only loops through these are filled; else all, but
/// not the rim of a flat sheet. With `interior`, fillings have points inside, 5 to 7 edges at each vertex and the rim, and continue
/// the mesh smoothly. `max_degree` and `extra_area` as for `mindeg fill`: without a degree, for each loop the least from 6 up that
/// takes no more than this share of area more. Loops of `max_loop` vertices or more stay open. `groups["fill"]` of the result are the new
/// triangles, after all others; `report` has the keys of `mindeg fill --json`, whose loops are counted from 1.
#[pyfunction]
#[pyo3(
    signature = (points, triangles=None, *, interior=false, through=None, max_degree=None, extra_area=EXTRA_AREA, max_loop=500),
    text_signature = "(points, triangles=None, *, interior=False, through=None, max_degree=None, extra_area=0.05, max_loop=500)"
)]
#[expect(clippy::too_many_arguments, reason = "they are keywords in Python")]
pub(crate) fn fill(
    py: Python<'_>,
    points: &Bound<'_, PyAny>,
    triangles: Option<&Bound<'_, PyAny>>,
    interior: bool,
    through: Option<Vec<u32>>,
    max_degree: Option<u32>,
    extra_area: f64,
    max_loop: usize,
) -> PyResult<Mesh> {
    if extra_area.is_nan() || extra_area < 0.0 {
        return Err(value_error(format!("extra_area is {extra_area}; give a share of 0 or more")));
    }
    let mesh = tri_mesh(points, triangles)?;
    let loops = Loops::of(&mesh);
    if loops.list().is_empty() {
        return Err(value_error("the mesh has no boundary loop; it is closed"));
    }
    let only = through.map(|through| {
        through.into_iter().map(|vertex| loop_through(&loops, vertex, "the mesh")).collect()
    });
    let options =
        FillOptions { max_degree, extra_area, max_loop, only: only.transpose()?, interior };
    let filled = done(py, |progress| closed(mesh, &loops, &options, progress))?;
    let answer = FillAnswer::of("", &filled, &loops);
    if filled.filled.is_empty() {
        let reasons: Vec<String> = answer.left_open.iter().take(5).map(OpenLoop::text).collect();
        return Err(value_error(format!("no loop to fill: {}", reasons.join("; "))));
    }
    let report = dict(py, &answer)?.cast_into::<PyDict>()?;
    report.del_item("file")?;
    Ok(Mesh::new(filled.mesh, Facts { report: Some(report.unbind()), ..Facts::default() }))
}

/// Join two boundary loops by a strip of triangles: the least maximum degree, or within `max_degree`, and the largest
/// minimum angle. With `interior`, by a tube with points inside, 5 to 7 edges at each vertex, that continues both ends smoothly.
///
/// With one mesh, two of its loops; with two, a loop of each, and the result has both. `through` are two vertices, one on each
/// loop; without it a mesh must have as many loops as are joined. `groups["bridge"]` of the result are the new triangles; `report` has the
/// keys of `mindeg bridge --json`.
#[pyfunction]
#[pyo3(
    signature = (first, second=None, *, interior=false, through=None, max_degree=None),
    text_signature = "(first, second=None, *, interior=False, through=None, max_degree=None)"
)]
pub(crate) fn bridge(
    py: Python<'_>,
    first: &Bound<'_, PyAny>,
    second: Option<&Bound<'_, PyAny>>,
    interior: bool,
    through: Option<[u32; 2]>,
    max_degree: Option<u32>,
) -> PyResult<Mesh> {
    let first = mesh_argument(first, "first")?.list()?;
    let second = second.map(|second| mesh_argument(second, "second")?.list()).transpose()?;
    let loops = Loops::of(&first);
    let other = second.as_ref().map(Loops::of);
    let target = other.as_ref().unwrap_or(&loops);
    let [a, b] = match (through, &other) {
        (Some([a, b]), Some(_)) => [
            loop_through(&loops, a, "the first mesh")?,
            loop_through(target, b, "the second mesh")?,
        ],
        (Some([a, b]), None) => {
            [loop_through(&loops, a, "the mesh")?, loop_through(target, b, "the mesh")?]
        }
        (None, Some(_)) => {
            expect_loops(&loops, 1, "the first mesh")?;
            expect_loops(target, 1, "the second mesh")?;
            [0, 0]
        }
        (None, None) => {
            expect_loops(&loops, 2, "the mesh")?;
            [0, 1]
        }
    };
    let names = [(&loops, a), (target, b)].map(|(of, at)| LoopName::new(at, &of.list()[at]));
    let both = second.as_ref().zip(other.as_ref());
    let options = BridgeOptions { max_degree, interior };
    let found = done(py, |progress| joined((first, &loops), both, [a, b], &options, progress))?;
    let [from, to] = names;
    let report = dict(py, &BridgeAnswer::of(&found, from, to))?.cast_into::<PyDict>()?;
    Ok(Mesh::new(found.mesh, Facts { report: Some(report.unbind()), ..Facts::default() }))
}

/// Join meshes of the plane by a mesh of the gap between them: of what the area `within` has outside them.
///
/// Without it, two meshes that overlap: the second one loses the triangles that overlap the first or are near it. Else the triangles
/// stay, with their names and depths, and degrees count across. `groups["stitch"]` of the result is the gap; `report` has the keys
/// of `mindeg stitch --json`.
#[pyfunction]
#[pyo3(signature = (meshes, *, within=None))]
pub(crate) fn stitch(
    py: Python<'_>,
    meshes: Vec<Bound<'_, PyAny>>,
    within: Option<&Bound<'_, Domain>>,
) -> PyResult<Mesh> {
    let of_area = within.and_then(|within| within.get().inner().projection().copied());
    let given = (0..)
        .zip(&meshes)
        .map(|(at, mesh): (usize, _)| mesh_argument(mesh, &format!("meshes[{at}]")));
    let given: Vec<&Mesh> = given.collect::<PyResult<_>>()?;
    let projection = of_area.or_else(|| given.first().and_then(|mesh| mesh.projection()));
    let meshes: Vec<TriMesh> = given.iter().map(|mesh| mesh.list()).collect::<PyResult<_>>()?;
    let area = within.map(|within| within.get().inner());
    let wanted = area.and_then(|area| area.interior().cloned()).unwrap_or_default();
    let gap = area.map_or(Gap::Overlap(None), Gap::Within);
    let found = done(py, |progress| stitched(&meshes, gap, &wanted, progress))?;
    let report = dict(py, &StitchAnswer::of(&found))?.cast_into::<PyDict>()?;
    let facts = Facts { report: Some(report.unbind()), projection, ..Facts::default() };
    Ok(Mesh::new(found.mesh, facts))
}

/// The mesh that an argument is.
fn mesh_argument<'a>(given: &'a Bound<'_, PyAny>, name: &str) -> PyResult<&'a Mesh> {
    match given.cast::<Mesh>() {
        Ok(mesh) => Ok(mesh.get()),
        Err(_) => Err(PyTypeError::new_err(format!(
            "{name} is a {}; give a mindeg.Mesh, which mindeg.read makes of a file",
            given.get_type().name()?
        ))),
    }
}

/// The index of the loop through a vertex.
fn loop_through(loops: &Loops, vertex: u32, mesh: &str) -> PyResult<usize> {
    loops.through(vertex).ok_or_else(|| {
        value_error(format!("through: {mesh} has no boundary loop through vertex {vertex}"))
    })
}

fn expect_loops(loops: &Loops, count: usize, mesh: &str) -> PyResult<()> {
    let found = loops.list().len();
    if found == count {
        return Ok(());
    }
    let loops = if found == 1 { "loop" } else { "loops" };
    Err(value_error(format!(
        "{mesh} has {found} boundary {loops}, and {count} are expected; name them by vertices, through=(…, …)"
    )))
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
