//! The content of a file.

use crate::beside::Beside;
use crate::error::{FileError, plain};
use crate::input::Input;
use crate::kind::{Kind, Wanted, kind, mesh_format, no_mesh};
use crate::polygons::{PolygonFile, ReadOptions};
use crate::session::{Session, whole};
use mindeg_domain::Model;
use mindeg_mesh::{Progress, TriMesh};
use mindeg_outlines::{self as outlines, OutlineFormat};
use std::fs::File;
use std::io;
use std::path::Path;

/// The content of a file.
#[derive(Debug)]
pub enum Content {
    /// The JSON text of one domain, for [`Domain::from_json`](mindeg_domain::Domain::from_json).
    Domain(String),
    /// The JSON text of a whole model, for [`Model::from_json`].
    Model(String),
    /// Polygons in any other format.
    Polygons(Box<PolygonFile>),
    /// A mesh.
    Mesh(Box<TriMesh>),
}

impl Session {
    /// Opens a file and tells what it holds. No output may replace the file, or those beside it that it
    /// names, from then on.
    ///
    /// # Errors
    ///
    /// A file that cannot be read, whose name and content disagree, or that holds something else than
    /// what is wanted.
    pub fn open(
        &self,
        input: &Input<'_>,
        wanted: Wanted,
        options: &ReadOptions,
        progress: Progress<'_>,
    ) -> Result<Content, FileError> {
        let name = input.name();
        let wrong = |problem: String| FileError::wrong(format!("{name}: {problem}"));
        if let Some(path) = input.path()
            && mesh_format(path).is_some()
        {
            if wanted == Wanted::Mesh || wanted == Wanted::Model && is_model_name(path) {
                return Ok(Content::Mesh(Box::new(self.mesh(input, None, progress)?)));
            }
            return Err(wrong(no_mesh(&name)));
        }
        let bytes = self.bytes(input, "domain")?;
        if bytes.trim_ascii().is_empty() {
            return Err(FileError::wrong(format!("{name} is empty; a domain is expected")));
        }
        let kind = kind(input.path(), &bytes, wanted, &name).map_err(wrong)?;
        if let Input::File(path) = input {
            let is_mesh = matches!(kind, Kind::Mesh(_) | Kind::MeshOrOutlines(..));
            self.note(path, if is_mesh { "mesh" } else { "domain" });
        }
        match kind {
            Kind::Mesh(format) => {
                Ok(Content::Mesh(Box::new(self.mesh_of_bytes(input, &bytes, Some(format))?)))
            }
            Kind::MeshOrOutlines(mesh, outline) => {
                match (
                    self.mesh_of_bytes(input, &bytes, Some(mesh)),
                    self.polygons(input, &bytes, outline, options),
                ) {
                    (Ok(mesh), _) => Ok(Content::Mesh(Box::new(mesh))),
                    (Err(_), Ok(polygons)) => Ok(Content::Polygons(Box::new(polygons))),
                    (Err(error), Err(_)) => Err(error),
                }
            }
            Kind::Outlines(format) => {
                let polygons = self.polygons(input, &bytes, format, options)?;
                Ok(Content::Polygons(Box::new(polygons)))
            }
            Kind::Json => {
                let text = String::from_utf8(bytes).map_err(|error| {
                    let byte = error.utf8_error().valid_up_to();
                    wrong(format!("byte {byte}: this is not UTF-8 text; save the file as UTF-8"))
                })?;
                if !Model::is_model_json(&text) {
                    return Ok(Content::Domain(text));
                }
                match wanted {
                    Wanted::Model | Wanted::Mesh => Ok(Content::Model(text)),
                    Wanted::Domain => Err(wrong(
                        "it is a whole model: mindeg mesh meshes its faces and tells their least degree; a domain is expected"
                            .to_owned(),
                    )),
                }
            }
        }
    }

    /// All bytes of an input; standard input is noted as a `what`.
    pub(crate) fn bytes(
        &self,
        input: &Input<'_>,
        what: &'static str,
    ) -> Result<Vec<u8>, FileError> {
        let bytes = match input {
            Input::File(path) => File::open(path).and_then(|file| {
                let is_file = file.metadata()?.is_file();
                whole(file, is_file)
            }),
            Input::StandardInput => self.standard_input(what),
            Input::Bytes(_, bytes) => Ok(bytes.to_vec()),
        };
        bytes.map_err(|error| match error.kind() {
            io::ErrorKind::InvalidData => FileError::wrong(format!("{}: {error}", input.name())),
            _ => FileError::cannot_read(&input.name(), &error),
        })
    }

    fn polygons(
        &self,
        input: &Input<'_>,
        bytes: &[u8],
        format: OutlineFormat,
        options: &ReadOptions,
    ) -> Result<PolygonFile, FileError> {
        let path = input.path().unwrap_or(Path::new("-"));
        let beside = |extension: &str| match input {
            Input::File(_) => {
                let name = path.with_extension(extension);
                let name = name.file_name().unwrap_or_default().to_string_lossy().into_owned();
                Beside::new(self, path, "domain's data").read(&name).map_err(plain)
            }
            alone => Err(io::Error::other(alone.alone())),
        };
        let outlines = outlines::read_selected(bytes, format, &options.selection, beside);
        PolygonFile::new(self, input, format, outlines, options)
            .map_err(|error| error.of(&input.name()))
    }
}

/// Whether a name is that of a mesh whose polygons are the faces of a model.
fn is_model_name(path: &Path) -> bool {
    use mindeg_formats::Format::{Glb, Gltf};
    matches!(mesh_format(path), Some(Glb | Gltf))
}
