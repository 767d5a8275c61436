//! Meshes into files: whole, or not at all.

use std::io;
use std::path::Path;

use mindeg::{Mesh, Progress};
use mindeg_formats::{
    Encoding, Format, MshVersion, SurfaceOptions, WriteError, WriteOptions, Writer,
};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use tempfile::NamedTempFile;

use crate::work::value_error;

/// What `Mesh.save` takes besides the path.
pub(crate) struct Wanted<'a> {
    pub(crate) format: Option<&'a str>,
    pub(crate) ascii: bool,
    pub(crate) msh_version: Option<&'a str>,
    pub(crate) double: bool,
    pub(crate) fields: bool,
    pub(crate) degree_colors: bool,
}

impl Wanted<'_> {
    fn format(&self, path: &Path) -> PyResult<Format> {
        let written = || Format::WRITTEN.iter().copied();
        match self.format {
            Some(name) => written().find(|format| format.name() == name),
            None => Format::of_path(path).filter(|format| written().any(|other| other == *format)),
        }
        .ok_or_else(|| {
            let names: Vec<&str> = written().map(Format::name).collect();
            PyValueError::new_err(format!(
                "{} names no format; give format= one of {}",
                path.display(),
                names.join(", ")
            ))
        })
    }

    fn options(&self) -> PyResult<WriteOptions> {
        let msh_version = match self.msh_version {
            None | Some("4" | "4.1") => MshVersion::V4,
            Some("2" | "2.2") => MshVersion::V2,
            Some(other) => {
                let problem = format!("msh_version is {other:?}; give \"4.1\" or \"2.2\"");
                return Err(PyValueError::new_err(problem));
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

/// Writes the files of a format beside their names and then gives them these names, so that a fault
/// leaves what was there.
pub(crate) fn save(mesh: &dyn Mesh, path: &Path, wanted: &Wanted<'_>) -> PyResult<()> {
    let format = wanted.format(path)?;
    let writer = Writer::new(format, wanted.options()?, mesh, mesh.triangle_count());
    let writer = writer.map_err(value_error)?;
    let mut paths = format.files(path);
    if mesh.groups().iter().any(|group| group.material.is_some()) {
        paths.extend(format.material_library(path));
    }
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    let folder = folder.unwrap_or(Path::new("."));
    let made = || -> Result<Vec<NamedTempFile>, WriteError> {
        let mut new = tempfile::Builder::new();
        new.prefix(".mindeg-").suffix(".part");
        // Like any other new file, not for the owner alone.
        #[cfg(unix)]
        new.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        let new = |_| new.tempfile_in(folder);
        let mut files = paths.iter().map(new).collect::<io::Result<Vec<_>>>()?;
        let names: Vec<String> = paths
            .iter()
            .map(|path| path.file_name().unwrap_or_default().to_string_lossy().into_owned())
            .collect();
        let mut outs: Vec<(&str, &mut NamedTempFile)> =
            names.iter().map(String::as_str).zip(&mut files).collect();
        writer.write(mesh, &mut outs, Progress::NONE)?;
        Ok(files)
    };
    let files = made().map_err(|error| match error {
        WriteError::Io(error) => os_error(path, &error),
        error => value_error(error),
    })?;
    for (file, path) in files.into_iter().zip(&paths) {
        file.persist(path).map_err(|failed| os_error(path, &failed.error))?;
    }
    Ok(())
}

/// An `OSError`, such as a `FileNotFoundError`, that names the file.
pub(crate) fn os_error(path: &Path, error: &io::Error) -> PyErr {
    io::Error::new(error.kind(), format!("{}: {error}", path.display())).into()
}
