//! Meshes into files: whole, or not at all.

use std::io;
use std::path::Path;

use mindeg::{Mesh, Projection};
use mindeg_files::{
    Encoding, FileError, Format, MshVersion, Session, SurfaceOptions, WriteOptions,
};
use pyo3::prelude::*;

use crate::work::value_error;

/// The arguments of `Mesh.save` besides the path.
pub(crate) struct Wanted<'a> {
    pub(crate) format: Option<&'a str>,
    pub(crate) ascii: bool,
    pub(crate) msh_version: Option<&'a str>,
    pub(crate) double: bool,
    pub(crate) fields: bool,
    pub(crate) degree_colors: bool,
}

impl Wanted<'_> {
    fn format(&self) -> PyResult<Option<Format>> {
        let Some(name) = self.format else { return Ok(None) };
        match Format::WRITTEN.into_iter().find(|format| format.name() == name) {
            Some(format) => Ok(Some(format)),
            None => {
                let names: Vec<&str> = Format::WRITTEN.into_iter().map(Format::name).collect();
                Err(value_error(format!("format is {name:?}; give one of {}", names.join(", "))))
            }
        }
    }

    fn options(&self) -> PyResult<WriteOptions> {
        let msh_version = match self.msh_version {
            None | Some("4" | "4.1") => MshVersion::V4,
            Some("2" | "2.2") => MshVersion::V2,
            Some(other) => {
                return Err(value_error(format!(
                    "msh_version is {other:?}; give \"4.1\" or \"2.2\""
                )));
            }
        };
        Ok(WriteOptions {
            surface: SurfaceOptions {
                degree_colors: self.degree_colors,
                ..SurfaceOptions::default()
            },
            encoding: if self.ascii { Encoding::Ascii } else { Encoding::Binary },
            msh_version,
            double: self.double,
            fields: self.fields,
        })
    }
}

/// Writes a mesh to the files of a format; a fault leaves what was there.
pub(crate) fn save(
    mesh: &dyn Mesh,
    path: &Path,
    wanted: &Wanted<'_>,
    projection: Option<Projection>,
) -> PyResult<()> {
    let (format, options) = (wanted.format()?, wanted.options()?);
    let saved = Session::new("").save(mesh, path, format, options, projection);
    saved.map_err(file_error)
}

/// An `OSError`, such as a `FileNotFoundError`, for what the system refuses, else a `ValueError`; each
/// names the file.
pub(crate) fn file_error(error: FileError) -> PyErr {
    match error.kind() {
        Some(kind) => io::Error::new(kind, error).into(),
        None => value_error(error.to_string()),
    }
}
