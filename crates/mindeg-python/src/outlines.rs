//! Domains and maps from files: JSON, or outlines that other programs drew.

use std::path::PathBuf;

use mindeg::interior::mesh_all;
use mindeg::{Domain, Interior, Progress, Size};
use mindeg_answers::interior::InteriorAnswer;
use mindeg_files::{
    Content, Division, FillRule, Input, PolygonFile, ReadOptions, Selection, Session, Wanted,
};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::dict::dict;
use crate::interior;
use crate::mesh::{Facts, Mesh};
use crate::save::file_error;
use crate::work::{done, value_error};

/// A file, or the text of GeoJSON, and how its polygons are read: a dict that the Python side makes.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Given {
    path: Option<PathBuf>,
    text: Option<String>,
    layer: Option<String>,
    name_by: Option<String>,
    corner_angle: f64,
    size: Option<f64>,
    feature: Option<String>,
    repair: bool,
    snap: Option<f64>,
    fill_rule: Option<String>,
}

impl Given {
    fn input(&self) -> Input<'_> {
        match &self.path {
            Some(path) => Input::File(path),
            None => {
                Input::Bytes("the outline", self.text.as_deref().unwrap_or_default().as_bytes())
            }
        }
    }

    fn options(&self) -> PyResult<ReadOptions> {
        let Self { corner_angle, size, repair, snap, .. } = *self;
        let wrong = |problem: String| Err(value_error(problem));
        for (key, length) in [("size", size), ("snap", snap)] {
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
        Ok(ReadOptions {
            feature: self.feature.clone(),
            selection: Selection { layer: self.layer.clone(), name_by: self.name_by.clone() },
            repair,
            together: self.feature.is_none(),
            snap,
            fill_rule,
            division: Division { corner_angle, size },
        })
    }

    /// Whether something is given that is not for a domain in JSON.
    fn is_for_outlines(&self) -> bool {
        let texts = [&self.layer, &self.name_by, &self.feature];
        self.repair || self.size.is_some() || texts.into_iter().any(Option::is_some)
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
            Content::Domain(_) if given.is_for_outlines() => {
                let name = input.name();
                wrong(format!(
                    "{name}: size, feature, layer, name_by and repair are for outlines such as GeoJSON or SVG; this \
                     is a domain in JSON"
                ))
            }
            Content::Domain(text) => match Domain::from_json(&text) {
                Ok(domain) if names_files(&domain) => {
                    let domain = session.with_sizes(domain, &input).map_err(file_error)?;
                    Ok((domain.to_json(), Vec::new()))
                }
                _ => Ok((text, Vec::new())),
            },
            Content::Model(text) => Ok((text, Vec::new())),
            Content::Mesh(_) => wrong(format!("{}: it is a mesh; a domain is expected", input.name())),
        }
    })
}

/// One mesh of the polygons in a file, or in the text of GeoJSON, whose regions they are; and notes.
#[pyfunction]
#[pyo3(name = "_mesh_of_map")]
pub(crate) fn mesh_of_map(
    py: Python<'_>,
    given: Given,
    options: &str,
) -> PyResult<(Mesh, Vec<String>)> {
    let read = given.options()?;
    let (wanted, points) = interior::wanted(options, &Interior::default())?;
    if !points.is_empty() {
        return Err(value_error("fixed_points are for a single domain; leave them out"));
    }
    let (polygons, (domains, more)) = py.detach(|| {
        let polygons = polygons(&given.input(), &read)?;
        let maps = polygons.maps().map_err(file_error)?;
        PyResult::Ok((polygons, maps))
    })?;
    let mut found =
        done(py, |progress| mesh_all(&domains, &wanted, progress).map_err(|(_, error)| error))?;
    if let Some(name) = polygons.name() {
        found.mesh = found.mesh.named(name);
    }
    let report = dict(py, &InteriorAnswer::from(&found))?.cast_into::<PyDict>()?.unbind();
    let notes = polygons.notes.into_iter().chain(more).collect();
    Ok((Mesh::new(found.mesh, Facts { report: Some(report), ..Facts::default() }), notes))
}

fn polygons(input: &Input<'_>, options: &ReadOptions) -> PyResult<PolygonFile> {
    match Session::new("")
        .open(input, Wanted::Domain, options, Progress::NONE)
        .map_err(file_error)?
    {
        Content::Polygons(polygons) => Ok(polygons),
        _ => Err(value_error(format!("{}: it has no polygons; give it to Domain", input.name()))),
    }
}

/// Whether the domain's sizes are in files.
fn names_files(domain: &Domain) -> bool {
    let sizes = domain.interior().map_or(&[][..], |wanted| &wanted.sizes);
    sizes.iter().any(|size| matches!(size, Size::File(_)))
}
