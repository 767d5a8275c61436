//! A model from its file: JSON, or a mesh whose polygons are the faces.

use crate::args::{DomainOptions, MeshArguments};
use crate::bar::Bar;
use crate::failure::{Failure, plainly};
use crate::input;
use crate::mesh_file;
use mindeg::{FromMesh, Intervals, Model, Side, Spacing};
use std::fs;
use std::path::Path;

/// Whether a file holds a model: a glTF, an OBJ with faces, or JSON with the key `faces`; that may
/// also come by standard input.
pub(crate) fn is_model(path: &Path) -> bool {
    if path == Path::new("-") {
        let bytes = input::standard_input("model");
        return bytes.is_ok_and(|bytes| std::str::from_utf8(bytes).is_ok_and(Model::is_model_json));
    }
    let extension = path.extension().map(|name| name.to_string_lossy().to_lowercase());
    match extension.as_deref() {
        Some("glb" | "gltf") => true,
        Some("obj") => fs::read(path).is_ok_and(|bytes| {
            let mut lines = bytes.split(|&byte| byte == b'\n' || byte == b'\r');
            lines.any(|line| line.starts_with(b"f ") || line.starts_with(b"f\t"))
        }),
        Some("json") => fs::read_to_string(path).is_ok_and(|text| Model::is_model_json(&text)),
        _ => false,
    }
}

/// The model in a file, with the options in place of what the file gives for its edges.
pub(super) fn read(path: &Path, arguments: &MeshArguments, bar: &Bar) -> Result<Model, Failure> {
    let name = input::name_of(path);
    let bad = |error: String| Failure::Input(format!("{name}: {error}"));
    let division = division(&arguments.domain.options)?;
    let extension = path.extension().map(|name| name.to_string_lossy().to_lowercase());
    let is_standard_input = path == Path::new("-");
    if is_standard_input || extension.as_deref() == Some("json") {
        let text = if is_standard_input {
            input::standard_input("model").map(|bytes| String::from_utf8_lossy(bytes).into_owned())
        } else {
            input::note(path, "model");
            fs::read_to_string(path)
        };
        let text =
            text.map_err(|error| Failure::Io(format!("cannot read {name}: {}", plainly(&error))))?;
        let model = Model::from_json(&text).map_err(|error| bad(error.to_string()))?;
        return match division {
            Some(side) => model.divided(&side).map_err(|error| bad(error.to_string())),
            None => Ok(model),
        };
    }
    let Some(edges) = division else {
        let message = "how many intervals? give --size S, or --intervals N for every edge";
        return Err(Failure::Input(message.to_owned()));
    };
    let mesh = mesh_file::read(path, bar)?;
    let from_mesh = FromMesh {
        edges,
        merge_coplanar: arguments.model.merge_coplanar || extension.as_deref() != Some("obj"),
        planar_tolerance: arguments.model.planar_tolerance,
    };
    let model = Model::of_mesh(&mesh, &from_mesh).map_err(|error| bad(error.to_string()))?;
    // An OBJ has names for groups alone.
    let stem = path.file_stem().and_then(|stem| stem.to_str());
    let is_plain = |stem: &&str| stem.chars().all(|c| c.is_alphanumeric() || "-_. ".contains(c));
    Ok(match stem.filter(is_plain) {
        Some(stem) if model.name().is_none() => model.named(stem),
        _ => model,
    })
}

/// The division of every edge that the options ask for.
fn division(options: &DomainOptions) -> Result<Option<Side>, Failure> {
    let DomainOptions { intervals, size, spacing, .. } = options;
    let intervals = match (intervals.as_ref().map(|counts| &counts.0[..]), size) {
        (Some(&[count]), _) => Intervals::Count(count),
        (Some(counts), _) => {
            return Err(Failure::Input(format!(
                "--intervals gives {} counts; for a model give one, which every edge gets",
                counts.len()
            )));
        }
        (None, Some(size)) => Intervals::Size(*size),
        (None, None) if spacing.is_some() => {
            let message = "--spacing of a model needs --size or --intervals beside it";
            return Err(Failure::Input(message.to_owned()));
        }
        (None, None) => return Ok(None),
    };
    let spacing = spacing.clone().unwrap_or(Spacing::Uniform);
    Ok(Some(Side { intervals, ..Side::count(1).spaced(spacing) }))
}
