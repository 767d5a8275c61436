//! Domains, and meshes of domains, maps and models, from files: JSON, or what other programs drew.

use std::collections::BTreeMap;
use std::path::PathBuf;

use mindeg::Triangles as _;
use mindeg::interior::mesh_all;
use mindeg::model::{fill_model, mesh_model};
use mindeg::{
    Domain, FromMesh, InnerPoint, Interior, Model, Progress, Side, Size, TriMesh, beside,
};
use mindeg_answers::interior::InteriorAnswer;
use mindeg_answers::model::ModelAnswer;
use mindeg_answers::names::part_name;
use mindeg_files::{
    Content, Division, FillRule, Format, Input, PolygonFile, ProjectionChoice, ReadOptions,
    Selection, Session, Wanted,
};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::dict::dict;
use crate::mesh::{Facts, Mesh};
use crate::save::file_error;
use crate::wish::Wish;
use crate::work::{done, value_error};

/// A file, or the text of GeoJSON, and how its polygons are read: a dict that the Python side makes.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Given {
    path: Option<PathBuf>,
    text: Option<String>,
    /// The name of a text in messages.
    called: String,
    layer: Option<String>,
    name_by: Option<String>,
    sea_in: Option<[f64; 4]>,
    corner_angle: f64,
    size: Option<f64>,
    size_of: BTreeMap<String, f64>,
    feature: Option<String>,
    repair: bool,
    snap: Option<f64>,
    fill_rule: Option<String>,
    project: Option<String>,
}

impl Given {
    fn input(&self) -> Input<'_> {
        match &self.path {
            Some(path) => Input::File(path),
            None => Input::Bytes(&self.called, self.text.as_deref().unwrap_or_default().as_bytes()),
        }
    }

    fn options(&self) -> PyResult<ReadOptions> {
        let Self { corner_angle, size, repair, snap, .. } = *self;
        let wrong = |problem: String| Err(value_error(problem));
        let of_names =
            self.size_of.iter().map(|(name, size)| (format!("size_of[{name:?}]"), Some(*size)));
        let lengths = [("size".to_owned(), size), ("snap".to_owned(), snap)];
        for (key, length) in of_names.chain(lengths) {
            if let Some(length) = length.filter(|length| !(length.is_finite() && *length > 0.0)) {
                return wrong(format!("{key} is {length}; give a length above 0"));
            }
        }
        if !(0.0..=180.0).contains(&corner_angle) {
            return wrong(format!("corner_angle is {corner_angle}; give degrees from 0 to 180"));
        }
        let fill_rule = self.fill_rule.as_deref().map(str::parse::<FillRule>).transpose();
        let fill_rule =
            fill_rule.map_err(|error: String| value_error(format!("fill_rule: {error}")))?;
        for (key, is_given) in [("fill_rule", fill_rule.is_some()), ("snap", snap.is_some())] {
            if is_given && !repair {
                return wrong(format!("{key} is for repair=True alone"));
            }
        }
        let project = self.project.as_deref().map(str::parse::<ProjectionChoice>).transpose();
        let project = project.map_err(|error| value_error(format!("project: {error}")))?;
        Ok(ReadOptions {
            project,
            feature: self.feature.clone(),
            selection: Selection { layer: self.layer.clone(), name_by: self.name_by.clone() },
            repair,
            separate: false,
            snap,
            fill_rule,
            parts_holes: None,
            sea_in: self.sea_in.map(|[x, y, right, top]| [[x, y].into(), [right, top].into()]),
            division: Division { corner_angle, size, sizes: self.size_of.clone() },
        })
    }

    /// Whether something is given that is not for a domain in JSON.
    fn is_for_outlines(&self) -> bool {
        let texts = [&self.layer, &self.name_by, &self.feature, &self.project];
        self.repair
            || self.size.is_some()
            || !self.size_of.is_empty()
            || self.sea_in.is_some()
            || texts.into_iter().any(Option::is_some)
    }
}

/// The domain in a file, or in the text of GeoJSON, as JSON, and what its reader left out.
#[pyfunction]
#[pyo3(name = "_domain_of_outline")]
pub(crate) fn domain_of_outline(py: Python<'_>, given: Given) -> PyResult<(String, Vec<String>)> {
    let options = given.options()?;
    let wrong = |problem: String| Err(value_error(problem));
    py.detach(|| {
        let input = given.input();
        let session = Session::new("");
        let opened = session.open(&input, Wanted::Domain, &options, Progress::NONE);
        match opened.map_err(file_error)? {
            Content::Polygons(polygons) => {
                let domain = polygons.only().map_err(file_error)?;
                Ok((domain.to_json(), polygons.notes))
            }
            Content::Domain(_) if given.is_for_outlines() => wrong(for_outlines(&input)),
            Content::Domain(text) => match Domain::from_json(&text) {
                Ok(domain) if names_files(&domain) => {
                    let domain = session.with_sizes(domain, &input).map_err(file_error)?;
                    Ok((domain.to_json(), Vec::new()))
                }
                _ => Ok((text, Vec::new())),
            },
            Content::Model(text) => Ok((text, Vec::new())),
            Content::Mesh(_) => {
                wrong(format!("{}: it is a mesh; a domain is expected", input.name()))
            }
        }
    })
}

/// How a model is read and meshed: a dict that the Python side makes.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct OfModel {
    merge_coplanar: bool,
    planar_tolerance: Option<f64>,
    effort: f64,
}

/// The mesh of what a file, or a text, holds, and notes: a domain, polygons as the regions of one mesh, or a model.
#[pyfunction]
#[pyo3(name = "_mesh_of_file")]
pub(crate) fn mesh_of_file(
    py: Python<'_>,
    given: Given,
    wish: Wish<'_>,
    of_model: OfModel,
) -> PyResult<(Mesh, Vec<String>)> {
    let demands = wish.demands()?;
    let (mesh, notes) = mesh_of_content(py, &given, &wish, of_model)?;
    Ok((mesh.keeping(&demands)?, notes))
}

fn mesh_of_content(
    py: Python<'_>,
    given: &Given,
    wish: &Wish<'_>,
    mut of_model: OfModel,
) -> PyResult<(Mesh, Vec<String>)> {
    let read = given.options()?;
    let input = given.input();
    let session = Session::new("");
    let content = py
        .detach(|| session.open(&input, Wanted::Model, &read, Progress::NONE))
        .map_err(file_error)?;
    let wrong =
        |error: &dyn ToString| value_error(format!("{}: {}", input.name(), error.to_string()));
    match content {
        Content::Polygons(polygons) if polygons.polygons.len() > 1 && given.feature.is_none() => {
            mesh_of_polygons(py, &polygons, wish)
        }
        Content::Polygons(polygons) => {
            let domain = polygons.only().map_err(file_error)?;
            Ok((wish.mesh_of(py, &domain)?, polygons.notes))
        }
        Content::Domain(_) if given.is_for_outlines() => Err(value_error(for_outlines(&input))),
        Content::Domain(text) => {
            let domain = Domain::from_json(&text).map_err(|error| wrong(&error))?;
            let domain = session.with_sizes(domain, &input).map_err(file_error)?;
            Ok((wish.mesh_of(py, &domain)?, Vec::new()))
        }
        Content::Model(text) => {
            let model = Model::from_json(&text).map_err(|error| wrong(&error))?;
            let model = match given.size {
                Some(size) => model.divided(&Side::size(size)).map_err(|error| wrong(&error))?,
                None => model,
            };
            Ok((mesh_of_model(py, &model, wish, &of_model)?, Vec::new()))
        }
        Content::Mesh(mesh) => {
            // A glTF has triangles, of which its faces are made.
            let is_obj = given.path.as_deref().and_then(Format::of_path) == Some(Format::Obj);
            of_model.merge_coplanar |= !is_obj;
            Ok((mesh_of_faces(py, &mesh, given.size, wish, &of_model)?, Vec::new()))
        }
    }
}

/// The mesh of the model whose faces are the polygons of a mesh.
#[pyfunction]
#[pyo3(name = "_mesh_of_faces")]
pub(crate) fn mesh_of_mesh(
    py: Python<'_>,
    mesh: &Bound<'_, Mesh>,
    size: Option<f64>,
    wish: Wish<'_>,
    of_model: OfModel,
) -> PyResult<Mesh> {
    let demands = wish.demands()?;
    mesh_of_faces(py, &mesh.get().list()?, size, &wish, &of_model)?.keeping(&demands)
}

fn mesh_of_faces(
    py: Python<'_>,
    mesh: &TriMesh,
    size: Option<f64>,
    wish: &Wish<'_>,
    of_model: &OfModel,
) -> PyResult<Mesh> {
    let size =
        size.ok_or_else(|| value_error("give the size of the edges of its faces, size=…"))?;
    let from_mesh = FromMesh {
        edges: Side::size(size),
        merge_coplanar: of_model.merge_coplanar,
        planar_tolerance: of_model.planar_tolerance,
    };
    mesh_of_model(py, &Model::of_mesh(mesh, &from_mesh).map_err(value_error)?, wish, of_model)
}

fn mesh_of_model(
    py: Python<'_>,
    model: &Model,
    wish: &Wish<'_>,
    of_model: &OfModel,
) -> PyResult<Mesh> {
    let (mesh, answer) = if wish.has_interior(false)? {
        let (wanted, points) = wish.wanted(&Interior::default())?;
        refuse_points(&points)?;
        let filled = done(py, |progress| fill_model(model, &wanted, progress))?;
        let answer = ModelAnswer::filled(model, &filled);
        (filled.mesh, answer)
    } else {
        let (goal, effort) = (wish.goal()?, of_model.effort);
        let meshed = done(py, |progress| mesh_model(model, goal, effort, progress))?;
        wish.refuse_above(meshed.mesh.max_degree())?;
        let answer = ModelAnswer::of(model, &meshed);
        (meshed.mesh, answer)
    };
    let report = Some(dict(py, &answer)?.cast_into::<PyDict>()?.unbind());
    Ok(Mesh::new(mesh, Facts { report, ..Facts::default() }))
}

/// One mesh of polygons whose regions they are.
fn mesh_of_polygons(
    py: Python<'_>,
    polygons: &PolygonFile,
    wish: &Wish<'_>,
) -> PyResult<(Mesh, Vec<String>)> {
    let (domains, more) = py.detach(|| polygons.maps().map_err(file_error))?;
    let notes = polygons.notes.iter().cloned().chain(more).collect();
    let named = |mesh: TriMesh| mesh.called(polygons.name());
    let of_part = |index: usize, error: &dyn ToString| match &domains[..] {
        [_] => error.to_string(),
        _ => format!("{}: {}", part_name(index, &domains[index]), error.to_string()),
    };
    let has_interior = wish.has_interior(false)?;
    if let [domain] = &domains[..] {
        return Ok((wish.mesh_of(py, domain)?, notes));
    }
    let projection = domains.first().and_then(|domain| domain.projection().copied());
    if !has_interior {
        let goal = wish.goal()?;
        let found = done(py, |progress| {
            beside::mesh_all(&domains, goal, progress).map_err(|(at, error)| of_part(at, &error))
        })?;
        wish.refuse_above(found.mesh.max_degree())?;
        let (least, is_known) = found.least_max_degree();
        let least_max_degree = is_known.then_some(least);
        let facts = Facts { least_max_degree, projection, ..Facts::default() };
        return Ok((Mesh::new(named(found.mesh), facts), notes));
    }
    let (wanted, points) = wish.wanted(&Interior::default())?;
    refuse_points(&points)?;
    let mut found = done(py, |progress| {
        mesh_all(&domains, &wanted, progress).map_err(|(at, error)| of_part(at, &error))
    })?;
    found.mesh = named(found.mesh);
    let report = Some(dict(py, &InteriorAnswer::from(&found))?.cast_into::<PyDict>()?.unbind());
    Ok((Mesh::new(found.mesh, Facts { report, projection, ..Facts::default() }), notes))
}

fn refuse_points(points: &[InnerPoint]) -> PyResult<()> {
    if points.is_empty() {
        return Ok(());
    }
    Err(value_error("fixed_points are for a single domain; leave them out"))
}

/// Why an option has no meaning for a domain in JSON.
fn for_outlines(input: &Input<'_>) -> String {
    format!(
        "{}: size, size_of, feature, layer, name_by, sea_in and repair are for outlines such as GeoJSON or SVG; this is a domain in \
         JSON",
        input.name()
    )
}

/// Whether the domain's sizes are in files.
fn names_files(domain: &Domain) -> bool {
    let sizes = domain.interior().map_or(&[][..], |wanted| &wanted.sizes);
    sizes.iter().any(|size| matches!(size, Size::File(_)))
}
