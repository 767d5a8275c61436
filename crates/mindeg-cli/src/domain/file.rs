//! What a file is: a domain in JSON, or outlines that other programs drew.

use crate::args::OutlineOptions;
use crate::failure::{Failure, plain, plainly};
use crate::input;
use crate::terminal::say;
use mindeg::Domain;
use mindeg_outlines::{
    self as outlines, Division, Listed, OutlineFormat, Outlines, Polygon, ReadError,
};
use std::fs;
use std::io;
use std::path::Path;

/// What a file holds.
pub(crate) enum Content {
    /// One domain, in JSON.
    Domain(Box<Domain>),
    /// Polygons, in any other format.
    Polygons(Polygons),
}

/// The polygons of a file, or those that were chosen.
pub(crate) struct Polygons {
    /// The file, as messages name it.
    pub(crate) file: String,
    pub(crate) format: OutlineFormat,
    /// In the order of the file; indices count from 1 among all polygons of the file.
    pub(crate) polygons: Vec<Polygon>,
    division: Division,
    is_repaired: bool,
}

impl Polygons {
    /// The domain of one of them.
    pub(crate) fn domain(&self, polygon: &Polygon) -> Result<Domain, Failure> {
        polygon.domain(&self.division).map_err(|error| {
            let hint = if error.is_touch() && !self.is_repaired {
                "; --repair parts rings that touch themselves"
            } else {
                ""
            };
            Failure::Input(format!("{error}{hint}")).of(&polygon.name())
        })
    }

    /// The only one, or why there are several.
    pub(crate) fn only(&self) -> Result<Domain, Failure> {
        match &self.polygons[..] {
            [polygon] => self.domain(polygon).map_err(|failure| failure.of(&self.file)),
            polygons => Err(Failure::Input(format!(
                "{} has {} polygons; choose one with --feature, by its name or index: {}",
                self.file,
                polygons.len(),
                Listed(polygons)
            ))),
        }
    }
}

/// Reads a file, or standard input where the path is `-`.
pub(crate) fn read(
    path: &Path,
    options: &OutlineOptions,
    size: Option<f64>,
) -> Result<Content, Failure> {
    let (name, bytes) = bytes_of(path)?;
    if bytes.trim_ascii().is_empty() {
        return Err(Failure::Input(format!("{name} is empty; a domain is expected")));
    }
    let path = (path != Path::new("-")).then_some(path);
    let bad = |error: ReadError| Failure::Input(format!("{name}: {error}"));
    let Some(format) = outlines::format_of(path, &bytes).map_err(bad)? else {
        options.refuse_for_json(&name)?;
        let text = String::from_utf8(bytes).map_err(|error| {
            let byte = error.utf8_error().valid_up_to();
            Failure::Input(format!(
                "{name}: byte {byte}: this is not UTF-8 text; save the file as UTF-8"
            ))
        })?;
        let domain =
            Domain::from_json(&text).map_err(|error| Failure::Input(format!("{name}: {error}")))?;
        return Ok(Content::Domain(Box::new(domain)));
    };
    let beside = |extension: &str| match path {
        Some(path) => fs::read(path.with_extension(extension)).map_err(plain),
        None => Err(io::Error::other("standard input has no file beside it")),
    };
    let mut outlines = outlines::read(&bytes, format, beside).map_err(bad)?;
    drop(bytes);
    if options.repair {
        outlines = outlines.repaired(options.fill_rule).map_err(bad)?;
    }
    let Outlines { features, notes, .. } = outlines;
    notes.iter().for_each(|note| say(&format!("{name}: {note}")));
    let mut polygons = outlines::labelled(features);
    if let Some(wanted) = &options.feature {
        let chosen = outlines::chosen(polygons, wanted);
        polygons = chosen.map_err(|error| Failure::Input(format!("{name}: {error}")))?;
    }
    let corner_angle = options.corner_angle;
    let division = Division { corner_angle, size };
    let is_repaired = options.repair;
    Ok(Content::Polygons(Polygons { file: name, format, polygons, division, is_repaired }))
}

/// What messages call a file, and its bytes.
pub(crate) fn bytes_of(path: &Path) -> Result<(String, Vec<u8>), Failure> {
    let name = input::name_of(path);
    let bytes = if path == Path::new("-") {
        input::standard_input("domain").map(<[u8]>::to_vec)
    } else {
        outlines::refuse_mesh(path)
            .map_err(|error| Failure::Input(format!("{}: {error}", path.display())))?;
        input::note(path, "domain");
        fs::read(path)
    };
    match bytes {
        Ok(bytes) => Ok((name, bytes)),
        Err(error) => Err(Failure::Io(format!("cannot read {name}: {}", plainly(&error)))),
    }
}
