//! A mesh: numpy arrays, its figures, its files.

use std::fs::File;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

use mindeg::glam::DVec3;
use mindeg::inspection::{Inspection, InspectionOptions};
use mindeg::quality::TriangleQuality;
use mindeg::{Mesh as AnyMesh, TriMesh};
use mindeg_formats::svg;
use mindeg_mesh::filled;
use numpy::{PyArray1, PyArray2, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays;
use crate::interior;
use crate::save::{self, Wanted};
use crate::work::{done, value_error};

/// A triangle mesh. `points` is (n, 2) or (n, 3) float64, `triangles` (m, 3) uint32, counter-clockwise.
#[pyclass(module = "mindeg", frozen)]
pub(crate) struct Mesh {
    mesh: Arc<dyn AnyMesh + Send>,
    facts: Facts,
    points: OnceLock<Py<PyArray2<f64>>>,
    triangles: OnceLock<Py<PyArray2<u32>>>,
    angles: OnceLock<[f64; 2]>,
}

/// What is known of a mesh beyond its triangles.
#[derive(Default)]
pub(crate) struct Facts {
    /// The least maximum degree that any mesh of the domain has, where that is proven.
    pub(crate) least_max_degree: Option<u32>,
    /// How it was found, in words.
    pub(crate) found_by: Option<String>,
    /// What a mesh with interior points reached.
    pub(crate) report: Option<Py<PyDict>>,
}

impl Mesh {
    pub(crate) fn new(mesh: impl AnyMesh + Send + 'static, facts: Facts) -> Self {
        Self {
            mesh: Arc::new(mesh),
            facts,
            points: OnceLock::new(),
            triangles: OnceLock::new(),
            angles: OnceLock::new(),
        }
    }

    fn all_positions(&self) -> Vec<DVec3> {
        let mesh = &self.mesh;
        filled(0..mesh.vertex_count(), DVec3::ZERO, |first, out| mesh.fill_positions(first, out))
    }

    fn all_triangles(&self) -> Vec<[u32; 3]> {
        let mesh = &self.mesh;
        filled(0..mesh.triangle_count(), [0; 3], |first, out| mesh.fill_triangles(first, out))
    }

    fn angles(&self) -> [f64; 2] {
        *self.angles.get_or_init(|| {
            let positions = self.all_positions();
            let quality = |triangle: [u32; 3]| {
                let [a, b, c] = triangle.map(|vertex| positions[vertex as usize]);
                TriangleQuality::in_space(a, b, c)
            };
            self.all_triangles().into_iter().map(quality).fold([180.0, 0.0], |[min, max], one| {
                [f64::min(min, one.min_angle), f64::max(max, one.max_angle)]
            })
        })
    }
}

#[pymethods]
impl Mesh {
    /// A mesh from arrays: points (n, 2) or (n, 3), triangles (m, 3).
    #[new]
    #[pyo3(signature = (points, triangles, name=None))]
    fn from_arrays(
        points: PyReadonlyArray2<'_, f64>,
        triangles: &Bound<'_, PyAny>,
        name: Option<String>,
    ) -> PyResult<Self> {
        let mesh = tri_mesh(&points, triangles)?;
        let mesh = if let Some(name) = name { mesh.named(name) } else { mesh };
        Ok(Self::new(mesh, Facts::default()))
    }

    /// The positions, (n, 2) float64 in the plane z = 0, else (n, 3): the same array each time.
    #[getter]
    fn points<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        if let Some(array) = self.points.get() {
            return Ok(array.bind(py).clone());
        }
        let array = arrays::points(py, &self.all_positions())?;
        let array = self.points.get_or_init(|| array.unbind());
        Ok(array.bind(py).clone())
    }

    /// The triangles, (m, 3) uint32, counter-clockwise: the same array each time.
    #[getter]
    fn triangles<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<u32>>> {
        if let Some(array) = self.triangles.get() {
            return Ok(array.bind(py).clone());
        }
        let array = arrays::triangles(py, self.all_triangles())?;
        let array = self.triangles.get_or_init(|| array.unbind());
        Ok(array.bind(py).clone())
    }

    /// The number of edges at each vertex, (n,) uint32.
    #[getter]
    fn degrees<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u32>> {
        let mesh = &self.mesh;
        let degrees = filled(0..mesh.vertex_count(), 0, |first, out| mesh.fill_degrees(first, out));
        PyArray1::from_vec(py, degrees)
    }

    /// The sides or other lines of the mesh: a name and an (s, 2) uint32 array of segments each.
    #[getter]
    fn lines<'py>(&self, py: Python<'py>) -> PyResult<Vec<(String, Bound<'py, PyArray2<u32>>)>> {
        let mesh = &self.mesh;
        let line = |line: &mindeg::Line| {
            let segments = filled(line.segments.clone(), [0; 2], |first, out| {
                mesh.fill_segments(first, out);
            });
            let array = PyArray1::from_vec(py, segments.into_flattened());
            let rows = line.segments.len();
            Ok((line.name.clone(), numpy::PyArrayMethods::reshape(&array, [rows, 2])?))
        };
        mesh.lines().iter().map(line).collect()
    }

    /// The name, if the domain or the file gives one.
    #[getter]
    fn name(&self) -> Option<&str> {
        self.mesh.name()
    }

    /// The largest number of edges at a vertex.
    #[getter]
    fn max_degree(&self) -> u32 {
        self.mesh.max_degree()
    }

    /// The minimum angle of all triangles, in degrees.
    #[getter]
    fn min_angle(&self) -> f64 {
        self.angles()[0]
    }

    /// The maximum angle of all triangles, in degrees.
    #[getter]
    fn max_angle(&self) -> f64 {
        self.angles()[1]
    }

    /// The least maximum degree of all meshes of the domain, if that is proven.
    #[getter]
    fn least_max_degree(&self) -> Option<u32> {
        self.facts.least_max_degree
    }

    /// How the mesh was found, in words, and so what is proven of it.
    #[getter]
    fn found_by(&self) -> Option<&str> {
        self.facts.found_by.as_deref()
    }

    /// What a mesh with interior points reached, a dict; `None` for other meshes.
    #[getter]
    fn report<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyDict>> {
        self.facts.report.as_ref().map(|report| report.bind(py).clone())
    }

    /// Write the mesh: whole, or not at all. The extension tells the format, or `format` does.
    #[pyo3(signature = (path, *, format=None, ascii=false, msh_version=None, double=false, fields=true, degree_colors=false))]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments of Python")]
    fn save(
        &self,
        py: Python<'_>,
        path: PathBuf,
        format: Option<&str>,
        ascii: bool,
        msh_version: Option<&str>,
        double: bool,
        fields: bool,
        degree_colors: bool,
    ) -> PyResult<()> {
        let wanted = Wanted { format, ascii, msh_version, double, fields, degree_colors };
        py.detach(|| save::save(&*self.mesh, &path, &wanted))
    }

    fn _repr_svg_(&self) -> Option<String> {
        let mut picture = Vec::new();
        svg::write(&*self.mesh, &mut picture).ok()?;
        String::from_utf8(picture).ok()
    }

    fn __repr__(&self) -> String {
        format!(
            "<mindeg.Mesh {}{} vertices, {} triangles, maximum degree {}, angles {:.3}° to {:.3}°>",
            self.mesh.name().map(|name| format!("{name}: ")).unwrap_or_default(),
            self.mesh.vertex_count(),
            self.mesh.triangle_count(),
            self.mesh.max_degree(),
            self.angles()[0],
            self.angles()[1],
        )
    }

    /// Pickles the arrays, the lines and the facts.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let module = py.import("mindeg")?;
        let facts = (self.facts.least_max_degree, self.facts.found_by.clone(), self.report(py));
        let state =
            (self.points(py)?, self.triangles(py)?, self.mesh.name(), self.lines(py)?, facts);
        (module.getattr("_restored")?, state).into_pyobject(py).map(|pair| pair.into_any())
    }

    /// A mesh as `__reduce__` describes it.
    #[staticmethod]
    fn _of_parts(
        points: PyReadonlyArray2<'_, f64>,
        triangles: &Bound<'_, PyAny>,
        name: Option<String>,
        lines: Vec<(String, Vec<[u32; 2]>)>,
        facts: (Option<u32>, Option<String>, Option<Py<PyDict>>),
    ) -> PyResult<Self> {
        let mut mesh = tri_mesh(&points, triangles)?;
        if let Some(name) = name {
            mesh = mesh.named(name);
        }
        let (mut all, mut segments) = (Vec::new(), Vec::new());
        for (name, line) in lines {
            let start = segments.len() as u32;
            segments.extend(line);
            all.push(mindeg::Line {
                name,
                segments: start..segments.len() as u32,
                is_straight: false,
            });
        }
        let mesh = mesh.with_lines(all, segments).map_err(value_error)?;
        let (least_max_degree, found_by, report) = facts;
        Ok(Self::new(mesh, Facts { least_max_degree, found_by, report }))
    }
}

/// Read a mesh from a file of any format that mindeg reads.
#[pyfunction]
pub(crate) fn read(py: Python<'_>, path: PathBuf) -> PyResult<Mesh> {
    let read = || -> PyResult<TriMesh> {
        let file = File::open(&path).map_err(|error| save::os_error(&path, &error))?;
        let folder = path.parent().unwrap_or(Path::new("."));
        let beside = |name: &str| std::fs::read(folder.join(name));
        mindeg_formats::read(&path, file, beside)
            .map_err(|error| value_error(format!("{}: {error}", path.display())))
    };
    Ok(Mesh::new(py.detach(read)?, Facts::default()))
}

/// What is wrong with a mesh, and how good it is: a dict.
#[pyfunction]
#[pyo3(signature = (points, triangles, *, weld=Some(0.0), corner_angle=1.0))]
pub(crate) fn inspect<'py>(
    py: Python<'py>,
    points: PyReadonlyArray2<'py, f64>,
    triangles: &Bound<'py, PyAny>,
    weld: Option<f64>,
    corner_angle: f64,
) -> PyResult<Bound<'py, PyDict>> {
    let mesh = tri_mesh(&points, triangles)?;
    let options = InspectionOptions { weld, corner_angle, ..InspectionOptions::default() };
    let found = done(py, |_| Ok::<_, String>(Inspection::of(&mesh, &options)))?;
    let dict = PyDict::new(py);
    dict.set_item("vertices", found.vertex_count)?;
    dict.set_item("triangles", found.triangle_count)?;
    dict.set_item("edges", found.edge_count)?;
    dict.set_item("boundary_edges", found.boundary_edge_count)?;
    dict.set_item("boundary_loops", found.boundary_loop_count)?;
    dict.set_item("components", found.component_count)?;
    dict.set_item("euler_characteristic", found.euler_characteristic)?;
    dict.set_item("welded_vertices", found.welded_count)?;
    dict.set_item("non_manifold_edges", found.non_manifold_edges.clone())?;
    dict.set_item("non_manifold_vertices", found.non_manifold_vertices.clone())?;
    dict.set_item("inconsistent_edges", found.inconsistent_edges.clone())?;
    dict.set_item("duplicate_faces", found.duplicate_faces.clone())?;
    dict.set_item("zero_area_triangles", found.zero_area_triangles.clone())?;
    dict.set_item("unreferenced_vertices", found.unreferenced_vertices.clone())?;
    dict.set_item("max_degree", found.max_degree())?;
    for (key, metric) in [("min_angle", "min_angle"), ("max_angle", "max_angle")] {
        let spread = found.quality.metric(metric);
        let value = spread.map(|spread| if key == "min_angle" { spread.min } else { spread.max });
        dict.set_item(key, value)?;
    }
    Ok(dict)
}

/// The optimiser alone on a planar mesh: the boundary stays. Options as for `Domain.interior`.
#[pyfunction]
#[pyo3(signature = (points, triangles, **options))]
pub(crate) fn improve(
    py: Python<'_>,
    points: PyReadonlyArray2<'_, f64>,
    triangles: &Bound<'_, PyAny>,
    options: Option<&Bound<'_, PyDict>>,
) -> PyResult<Mesh> {
    let mesh = tri_mesh(&points, triangles)?;
    let wanted = interior::wanted(options, mindeg::Interior::default())?;
    let found = done(py, |progress| mindeg::interior::improve(&mesh, &wanted, progress))?;
    let report = interior::reached(py, &found.after)?;
    report.set_item("before", interior::reached(py, &found.before)?)?;
    Ok(Mesh::new(found.mesh, Facts { report: Some(report.unbind()), ..Facts::default() }))
}

/// Numpy's arrays, or what numpy makes one of, as a mesh.
fn tri_mesh(points: &PyReadonlyArray2<'_, f64>, triangles: &Bound<'_, PyAny>) -> PyResult<TriMesh> {
    let positions = arrays::positions(points)?;
    TriMesh::new(positions, index_rows(triangles)?).map_err(value_error)
}

/// The rows of an (m, 3) array of integers of any type.
fn index_rows(triangles: &Bound<'_, PyAny>) -> PyResult<Vec<[u32; 3]>> {
    let wrong = || PyValueError::new_err("triangles must be an (m, 3) array of indices from 0");
    let rows = |view: numpy::ndarray::ArrayView2<'_, i64>| {
        if view.ncols() != 3 {
            return Err(wrong());
        }
        let index = |value: i64| u32::try_from(value).map_err(|_| wrong());
        let row = |row: numpy::ndarray::ArrayView1<'_, i64>| {
            Ok([index(row[0])?, index(row[1])?, index(row[2])?])
        };
        view.rows().into_iter().map(row).collect()
    };
    if let Ok(array) = triangles.extract::<PyReadonlyArray2<'_, u32>>() {
        let view = array.as_array();
        if view.ncols() != 3 {
            return Err(wrong());
        }
        return Ok(view.rows().into_iter().map(|row| [row[0], row[1], row[2]]).collect());
    }
    let numpy = triangles.py().import("numpy")?;
    let array = numpy.call_method1("asarray", (triangles,))?;
    if !array.getattr("dtype")?.getattr("kind")?.extract::<String>()?.starts_with(['i', 'u']) {
        return Err(wrong());
    }
    let array = array.call_method1("astype", ("int64",))?;
    let array: PyReadonlyArray2<'_, i64> = array.extract().map_err(|_| wrong())?;
    rows(array.as_array())
}
