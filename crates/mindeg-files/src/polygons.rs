//! The polygons of a file.

use crate::error::FileError;
use crate::input::Input;
use crate::session::Session;
use mindeg_domain::Domain;
use mindeg_outlines::{
    self as outlines, Division, FillRule, Listed, OutlineError, OutlineFormat, Outlines, Polygon,
};
use std::path::Path;

/// How the outlines of a file become polygons.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ReadOptions {
    /// The polygons that are taken, by a name or an index from 1; all without it.
    pub feature: Option<String>,
    /// Whether rings that touch or cross themselves are parted.
    pub repair: bool,
    /// The rule by which a repair counts points as inside; by default the format's.
    pub fill_rule: Option<FillRule>,
    /// How rings become sides and points.
    pub division: Division,
}

/// The polygons of a file, or those that were chosen.
#[derive(Debug)]
pub struct PolygonFile {
    /// The file, as messages name it.
    pub file: String,
    /// Its format.
    pub format: OutlineFormat,
    /// In the order of the file; indices count from 1 among all polygons of the file.
    pub polygons: Vec<Polygon>,
    /// Sentences for the user about parts that the reader left out or changed.
    pub notes: Vec<String>,
    division: Division,
    is_repaired: bool,
    dashes: &'static str,
}

impl PolygonFile {
    pub(crate) fn new(
        session: &Session,
        input: &Input<'_>,
        format: OutlineFormat,
        outlines: Result<Outlines, OutlineError>,
        options: &ReadOptions,
    ) -> Result<Self, FileError> {
        let wrong = |error: OutlineError| FileError::wrong(error.to_string());
        let mut outlines = outlines.map_err(wrong)?;
        if options.repair {
            outlines = outlines.repaired(options.fill_rule).map_err(wrong)?;
        }
        let Outlines { features, notes, .. } = outlines;
        let mut polygons = outlines::labelled(features);
        // A file of one shape without a name is called after that shape.
        if let ([polygon], Some(stem)) = (&mut polygons[..], input.path().and_then(plain_stem))
            && polygon.label.is_empty()
        {
            stem.clone_into(&mut polygon.label);
        }
        if let Some(wanted) = &options.feature {
            polygons = outlines::chosen(polygons, wanted).map_err(wrong)?;
        }
        Ok(Self {
            file: input.name(),
            format,
            polygons,
            notes,
            division: options.division,
            is_repaired: options.repair,
            dashes: session.dashes(),
        })
    }

    /// The domain of one of them.
    ///
    /// # Errors
    ///
    /// The reason why it is not a domain, under its name.
    pub fn domain(&self, polygon: &Polygon) -> Result<Domain, FileError> {
        polygon.domain(&self.division).map_err(|error| {
            let hint = if error.is_touch && !self.is_repaired {
                format!("; {}repair parts rings that touch themselves", self.dashes)
            } else {
                String::new()
            };
            FileError::wrong(format!("{error}{hint}")).of(&polygon.name())
        })
    }

    /// The only one.
    ///
    /// # Errors
    ///
    /// The reason why it is not a domain, or that the file has several polygons.
    pub fn only(&self) -> Result<Domain, FileError> {
        match &self.polygons[..] {
            [polygon] => self.domain(polygon).map_err(|error| error.of(&self.file)),
            polygons => Err(FileError::wrong(format!(
                "{} has {} polygons; choose one with {}feature, by its name or index: {}",
                self.file,
                polygons.len(),
                self.dashes,
                Listed(polygons)
            ))),
        }
    }
}

/// The name of a file without its extension, if it can be the name of a domain in every format.
fn plain_stem(path: &Path) -> Option<&str> {
    let is_plain = |stem: &&str| stem.chars().all(|c| c.is_alphanumeric() || "-_. ".contains(c));
    path.extension().and(path.file_stem())?.to_str().filter(is_plain)
}
