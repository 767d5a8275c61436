//! A mesh: numpy arrays, its figures, its files.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::PathBuf;
use std::sync::{Arc, OnceLock};

use mindeg::glam::DVec3;
use mindeg::quality::TriangleQuality;
use mindeg::{Group, Mesh as AnyMesh, Positions, Projection, TriMesh};
use mindeg_answers::demands::Demands;
use mindeg_answers::numbers::{steady_angle, triangles};
use mindeg_files::{Input, Session, svg};
use mindeg_mesh::{ByName, LineKind, PeriodicLine, filled};
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays;
use crate::pickled::{self, PickledGroups, PickledParts, PickledPeriodic};
use crate::save::{self, Wanted};
use crate::work::value_error;

/// A triangle mesh. `points` is (n, 2) or (n, 3) float64, `triangles` (m, 3) uint32, counter-clockwise.
#[pyclass(module = "mindeg", frozen)]
pub(crate) struct Mesh {
    mesh: Arc<dyn AnyMesh + Send>,
    facts: Facts,
    points: OnceLock<Py<PyArray2<f64>>>,
    triangles: OnceLock<Py<PyArray2<u32>>>,
    angles: OnceLock<[f64; 2]>,
}

/// A mesh's figures and names, beyond its triangles.
#[derive(Default)]
pub(crate) struct Facts {
    /// The least maximum degree that any mesh of the domain has, where that is proven.
    pub(crate) least_max_degree: Option<u32>,
    /// How it was found, in words.
    pub(crate) found_by: Option<String>,
    /// The figures that a mesh with interior points reached.
    pub(crate) report: Option<Py<PyDict>>,
    /// The projection of degrees that its plane is.
    pub(crate) projection: Option<Projection>,
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

    /// The mesh as a list, with all that names parts of it.
    pub(crate) fn list(&self) -> PyResult<TriMesh> {
        TriMesh::of(&*self.mesh).map_err(value_error)
    }

    /// The projection of degrees that its plane is.
    pub(crate) fn projection(&self) -> Option<Projection> {
        self.facts.projection
    }

    /// The mesh, if it keeps the rules of a program that are among the demands.
    pub(crate) fn keeping(self, demands: &Demands) -> PyResult<Self> {
        let Some(preset) = demands.preset else { return Ok(self) };
        match preset.broken_by(&self.list()?) {
            Some(broken) => Err(value_error(format!("{broken} (counted from 0)"))),
            None => Ok(self),
        }
    }

    fn segments(&self, line: &mindeg::Line) -> Vec<[u32; 2]> {
        filled(line.segments.clone(), [0; 2], |first, out| self.mesh.fill_segments(first, out))
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

/// An array for each name of some items, which it is made of.
fn by_name<'py, T: IntoPyObject<'py>>(
    py: Python<'py>,
    names: impl IntoIterator<Item = impl AsRef<str>>,
    array: impl Fn(Vec<usize>) -> PyResult<T>,
) -> PyResult<Bound<'py, PyDict>> {
    let by_name = ByName::new(names);
    let dict = PyDict::new(py);
    for (name, of_name) in by_name.names.iter().zip(by_name.items()) {
        dict.set_item(name, array(of_name)?)?;
    }
    Ok(dict)
}

#[pymethods]
impl Mesh {
    /// A mesh from arrays: points (n, 2) or (n, 3), triangles (m, 3).
    #[new]
    #[pyo3(signature = (points, triangles, name=None))]
    fn from_arrays(
        points: &Bound<'_, PyAny>,
        triangles: &Bound<'_, PyAny>,
        name: Option<String>,
    ) -> PyResult<Self> {
        let mesh = tri_mesh(points, Some(triangles))?.called(name);
        Ok(Self::new(mesh, Facts::default()))
    }

    /// The positions, (n, 2) float64 in the plane z = 0, else (n, 3): the same read-only array each time.
    #[getter]
    fn points<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        if let Some(array) = self.points.get() {
            return Ok(array.bind(py).clone());
        }
        let array = arrays::points(py, &self.all_positions())?;
        let array = self.points.get_or_init(|| array.unbind());
        Ok(array.bind(py).clone())
    }

    /// The triangles, (m, 3) uint32, counter-clockwise: the same read-only array each time.
    #[getter]
    fn triangles<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<u32>>> {
        if let Some(array) = self.triangles.get() {
            return Ok(array.bind(py).clone());
        }
        let array = arrays::rows(py, self.all_triangles())?;
        let array = self.triangles.get_or_init(|| array.unbind());
        Ok(array.bind(py).clone())
    }

    /// The number of edges at each vertex, (n,) uint32, read-only.
    #[getter]
    fn degrees<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u32>> {
        let mesh = &self.mesh;
        let degrees = filled(0..mesh.vertex_count(), 0, |first, out| mesh.fill_degrees(first, out));
        arrays::read_only(PyArray1::from_vec(py, degrees))
    }

    /// The sides and other lines of the mesh: a read-only (s, 2) uint32 array of segments for each name.
    #[getter]
    fn lines<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let lines = self.mesh.lines();
        by_name(py, lines.iter().map(|line| &line.name), |of_name| {
            let segments = of_name.into_iter().flat_map(|line| self.segments(&lines[line]));
            arrays::rows(py, segments.collect())
        })
    }

    /// The groups of triangles, such as regions: a read-only (t,) uint32 array of triangles for each name.
    #[getter]
    fn groups<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let groups = self.mesh.groups();
        let named = by_name(py, groups.iter().map(Group::label), |of_name| {
            let triangles = of_name.into_iter().flat_map(|group| groups[group].triangles.clone());
            Ok(arrays::read_only(PyArray1::from_vec(py, triangles.collect())))
        })?;
        if named.contains("")? {
            named.del_item("")?;
        }
        Ok(named)
    }

    /// The vertices with names: a read-only (v,) uint32 array of vertices for each name.
    #[getter]
    fn named_points<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let named = self.mesh.named_vertices();
        by_name(py, named.iter().map(|one| &one.name), |of_name| {
            let vertices = of_name.into_iter().map(|one| named[one].vertex).collect();
            Ok(arrays::read_only(PyArray1::from_vec(py, vertices)))
        })
    }

    /// The periodic sides: for each name a read-only (p, 2) uint32 array of its vertices, each with the one that is moved there.
    #[getter]
    fn periodic<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let (lines, periodic) = (self.mesh.lines(), self.mesh.periodic_lines());
        let name = |own: &PeriodicLine| &lines[own.line as usize].name;
        by_name(py, periodic.iter().map(name), |of_name| {
            let pairs = of_name.into_iter().flat_map(|own| periodic[own].vertices.iter().copied());
            arrays::rows(py, pairs.collect())
        })
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

    /// The figures that a mesh with interior points reached, a dict; `None` for other meshes.
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
        let projection = self.facts.projection;
        py.detach(|| save::save(&*self.mesh, &path, &wanted, projection))
    }

    /// Whether points, triangles and all that names parts of them are the same.
    fn __eq__(&self, other: &Self) -> PyResult<bool> {
        let (a, b) = (&self.mesh, &other.mesh);
        let same_counts =
            a.vertex_count() == b.vertex_count() && a.triangle_count() == b.triangle_count();
        Ok(same_counts && self.list()? == other.list()?)
    }

    fn __hash__(&self) -> u64 {
        hash_of(&*self.mesh)
    }

    fn _repr_svg_(&self) -> Option<String> {
        let mut picture = Vec::new();
        svg::write(&*self.mesh, &mut picture).ok()?;
        String::from_utf8(picture).ok()
    }

    fn __repr__(&self) -> String {
        format!(
            "<mindeg.Mesh {}{} vertices, {}, maximum degree {}, angles {} to {}>",
            self.mesh.name().map(|name| format!("{name}: ")).unwrap_or_default(),
            self.mesh.vertex_count(),
            triangles(self.mesh.triangle_count()),
            self.mesh.max_degree(),
            steady_angle(self.angles()[0]),
            steady_angle(self.angles()[1]),
        )
    }

    /// Pickles the arrays, and what names parts of them.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let mesh = &self.mesh;
        let groups: PickledGroups = mesh
            .groups()
            .iter()
            .map(|group| {
                let material = group.material.as_ref().map(|it| (it.name.clone(), it.color));
                (group.name.clone(), [group.triangles.start, group.triangles.end], material)
            })
            .collect();
        let lines = mesh.lines();
        let segments: Vec<_> =
            lines.iter().map(|line| (line.name.clone(), self.segments(line))).collect();
        let named: Vec<_> =
            mesh.named_vertices().iter().map(|one| (one.name.clone(), one.vertex)).collect();
        let kinds: Vec<Option<&str>> =
            (0..lines.len()).map(|line| mesh.line_kind(line).map(LineKind::name)).collect();
        let straight: Vec<bool> = lines.iter().map(|line| line.is_straight).collect();
        let depths = filled(0..mesh.vertex_count(), 0.0, |first, out| mesh.fill_depths(first, out));
        let depths = depths.iter().any(|&depth| depth != 0.0).then_some(depths);
        let periodic = mesh.periodic_lines().into_owned();
        let periodic: Vec<PickledPeriodic> =
            periodic.into_iter().map(|own| (own.line, own.of, own.matrix, own.vertices)).collect();
        let Facts { least_max_degree, found_by, projection, .. } = &self.facts;
        let projection = projection.map(|it| it.to_string());
        let facts = (*least_max_degree, found_by.clone(), self.report(py), projection);
        let state = (
            self.points(py)?,
            self.triangles(py)?,
            mesh.name(),
            segments,
            (straight, kinds),
            (groups, depths, named, periodic),
            facts,
        );
        let restored = py.import("mindeg")?.getattr("_restored")?;
        (restored, state).into_pyobject(py).map(|pair| pair.into_any())
    }

    /// A mesh as `__reduce__` describes it.
    #[staticmethod]
    fn _of_parts(
        points: &Bound<'_, PyAny>,
        triangles: &Bound<'_, PyAny>,
        name: Option<String>,
        lines: Vec<(String, Vec<[u32; 2]>)>,
        of_lines: (Vec<bool>, Vec<Option<String>>),
        of_mesh: PickledParts,
        facts: (Option<u32>, Option<String>, Option<Py<PyDict>>, Option<String>),
    ) -> PyResult<Self> {
        let mesh =
            pickled::mesh(tri_mesh(points, Some(triangles))?, name, lines, of_lines, of_mesh)?;
        let (least_max_degree, found_by, report, projection) = facts;
        let projection = projection.map(|text| text.parse().map_err(value_error)).transpose()?;
        Ok(Self::new(mesh, Facts { least_max_degree, found_by, report, projection }))
    }
}

/// Read a mesh from a file of any format that mindeg reads.
#[pyfunction]
pub(crate) fn read(py: Python<'_>, path: PathBuf) -> PyResult<Mesh> {
    let read = || Session::new("").mesh(&Input::File(&path), None, mindeg::Progress::NONE);
    let mesh = py.detach(read).map_err(save::file_error)?;
    Ok(Mesh::new(mesh, Facts::default()))
}

/// A hash of points that are equal where meshes or domains are.
pub(crate) fn hash_of(points: &dyn Positions) -> u64 {
    let count = points.vertex_count();
    let some =
        filled(0..count.min(16), DVec3::ZERO, |first, out| points.fill_positions(first, out));
    let mut hasher = DefaultHasher::new();
    count.hash(&mut hasher);
    // -0.0 is 0.0.
    some.iter().for_each(|point| point.to_array().map(|x| (x + 0.0).to_bits()).hash(&mut hasher));
    hasher.finish()
}

/// A mesh in hand, or points and triangles, as a list.
pub(crate) fn tri_mesh(
    points: &Bound<'_, PyAny>,
    triangles: Option<&Bound<'_, PyAny>>,
) -> PyResult<TriMesh> {
    match (points.cast::<Mesh>(), triangles) {
        (Ok(mesh), None) => mesh.get().list(),
        (Err(_), Some(triangles)) => {
            let points = arrays::positions(points, "points", 2..=3)?;
            TriMesh::new(points, arrays::index_rows(triangles)?).map_err(value_error)
        }
        _ => Err(value_error(
            "give a mesh, or points and triangles; mindeg.read makes a mesh of a file",
        )),
    }
}
