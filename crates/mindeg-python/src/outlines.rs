//! Domains from files: JSON, or outlines that other programs drew.

use std::fs;
use std::path::{Path, PathBuf};

use mindeg_outlines::{self as outlines, Division, FillRule, Listed, Outlines};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::save::os_error;

/// What is taken of a file of outlines, and how it is divided.
struct Options<'a> {
    division: Division,
    feature: Option<&'a str>,
    repair: bool,
    fill_rule: Option<FillRule>,
}

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
    feature: Option<&str>,
    repair: bool,
    fill_rule: Option<&str>,
) -> PyResult<(String, Vec<String>)> {
    if let Some(size) = size.filter(|size| !(size.is_finite() && *size > 0.0)) {
        let problem = format!("size is {size}; give a length above 0");
        return Err(PyValueError::new_err(problem));
    }
    if !(0.0..=180.0).contains(&corner_angle) {
        let problem = format!("corner_angle is {corner_angle}; give degrees from 0 to 180");
        return Err(PyValueError::new_err(problem));
    }
    let fill_rule = fill_rule.map(str::parse).transpose();
    let fill_rule =
        fill_rule.map_err(|error: String| PyValueError::new_err(format!("fill_rule: {error}")))?;
    if fill_rule.is_some() && !repair {
        return Err(PyValueError::new_err("fill_rule is for repair=True alone"));
    }
    let options = Options { division: Division { corner_angle, size }, feature, repair, fill_rule };
    py.detach(|| {
        let Some(path) = &path else {
            let bytes = text.unwrap_or_default().into_bytes();
            return domain(None, bytes, &options).map_err(PyValueError::new_err);
        };
        let bytes = fs::read(path).map_err(|error| os_error(path, &error))?;
        let bad = |problem| PyValueError::new_err(format!("{}: {problem}", path.display()));
        domain(Some(path), bytes, &options).map_err(bad)
    })
}

fn domain(
    path: Option<&Path>,
    bytes: Vec<u8>,
    options: &Options<'_>,
) -> Result<(String, Vec<String>), String> {
    let text = |error: &dyn ToString| error.to_string();
    let Some(format) = outlines::format_of(path, &bytes).map_err(|error| text(&error))? else {
        if options.feature.is_some() || options.repair || options.division.size.is_some() {
            let problem = "size, feature and repair are for outlines such as GeoJSON or SVG; this is \
                           a domain in JSON";
            return Err(problem.to_owned());
        }
        let json = String::from_utf8(bytes).map_err(|error| format!("no UTF-8 text: {error}"))?;
        return Ok((json, Vec::new()));
    };
    let beside = |extension: &str| match path {
        Some(path) => fs::read(path.with_extension(extension)),
        None => Err(std::io::ErrorKind::NotFound.into()),
    };
    let mut read = outlines::read(&bytes, format, beside).map_err(|error| text(&error))?;
    if options.repair {
        read = read.repaired(options.fill_rule).map_err(|error| text(&error))?;
    }
    let Outlines { features, notes, .. } = read;
    let mut polygons = outlines::labelled(features);
    if let Some(wanted) = options.feature {
        polygons = outlines::chosen(polygons, wanted).map_err(|error| text(&error))?;
    }
    let [polygon] = &polygons[..] else {
        return Err(format!(
            "{} polygons; choose one with feature, by its name or index: {}",
            polygons.len(),
            Listed(&polygons)
        ));
    };
    let domain = polygon.domain(&options.division).map_err(|error| {
        let hint = if error.is_touch() && !options.repair {
            "; repair=True parts rings that touch themselves"
        } else {
            ""
        };
        format!("{}: {error}{hint}", polygon.name())
    })?;
    Ok((domain.to_json(), notes))
}
