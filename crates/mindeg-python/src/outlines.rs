//! Domains from files: JSON, or outlines that other programs drew.

use std::path::PathBuf;

use mindeg::{Domain, Progress, Size};
use mindeg_files::{Content, Division, FillRule, Input, ReadOptions, Session, Wanted};
use pyo3::prelude::*;

use crate::save::file_error;
use crate::work::value_error;

/// The domain in a file, or in the text of GeoJSON, as JSON, and what its reader left out.
#[pyfunction]
#[pyo3(name = "_domain_of_outline", signature = (path, text, *, corner_angle, size=None, feature=None, repair=false, fill_rule=None))]
#[expect(clippy::too_many_arguments, reason = "named by the callers in Python")]
pub(crate) fn domain_of_outline(
    py: Python<'_>,
    path: Option<PathBuf>,
    text: Option<String>,
    corner_angle: f64,
    size: Option<f64>,
    feature: Option<String>,
    repair: bool,
    fill_rule: Option<&str>,
) -> PyResult<(String, Vec<String>)> {
    let wrong = |problem: String| Err(value_error(problem));
    if let Some(size) = size.filter(|size| !(size.is_finite() && *size > 0.0)) {
        return wrong(format!("size is {size}; give a length above 0"));
    }
    if !(0.0..=180.0).contains(&corner_angle) {
        return wrong(format!("corner_angle is {corner_angle}; give degrees from 0 to 180"));
    }
    let fill_rule = fill_rule.map(str::parse::<FillRule>).transpose();
    let fill_rule =
        fill_rule.map_err(|error: String| value_error(format!("fill_rule: {error}")))?;
    if fill_rule.is_some() && !repair {
        return wrong("fill_rule is for repair=True alone".to_owned());
    }
    let division = Division { corner_angle, size };
    let options = ReadOptions { feature, repair, fill_rule, division, ..ReadOptions::default() };
    py.detach(|| {
        let text = text.unwrap_or_default();
        let input = match &path {
            Some(path) => Input::File(path),
            None => Input::Bytes("the outline", text.as_bytes()),
        };
        let session = Session::new("");
        let opened = session.open(&input, Wanted::Domain, &options, Progress::NONE);
        match opened.map_err(file_error)? {
            Content::Polygons(polygons) => {
                let domain = polygons.only().map_err(file_error)?;
                Ok((domain.to_json(), polygons.notes))
            }
            Content::Domain(_) if options.feature.is_some() || repair || size.is_some() => {
                let name = input.name();
                wrong(format!(
                    "{name}: size, feature and repair are for outlines such as GeoJSON or SVG; this is a \
                     domain in JSON"
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

/// Whether the domain's sizes are in files.
fn names_files(domain: &Domain) -> bool {
    let sizes = domain.interior().map_or(&[][..], |wanted| &wanted.sizes);
    sizes.iter().any(|size| matches!(size, Size::File(_)))
}
