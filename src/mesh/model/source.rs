//! A model from its file: JSON, or a mesh whose polygons are the faces.

use crate::args::{DomainOptions, ModelArguments};
use crate::failure::Failure;
use mindeg::{FromMesh, Intervals, Model, Side, Spacing, TriMesh};
use mindeg_files::{Format, Input};
use std::path::Path;

/// The error in the model in a file.
pub(crate) fn bad(file: Option<&Path>, error: &dyn ToString) -> Failure {
    let name = file.map_or(String::new(), |path| Input::of(path).name());
    Failure::Input(format!("{name}: {}", error.to_string()))
}

/// A model in JSON; options override its settings of its edges.
pub(crate) fn divided(
    model: Model,
    file: Option<&Path>,
    options: &DomainOptions,
) -> Result<Model, Failure> {
    match division(options)? {
        Some(side) => model.divided(&side).map_err(|error| bad(file, &error)),
        None => Ok(model),
    }
}

/// The model whose faces are the polygons of a mesh.
pub(crate) fn of_mesh(
    mesh: &TriMesh,
    file: Option<&Path>,
    options: &DomainOptions,
    of_model: &ModelArguments,
) -> Result<Model, Failure> {
    let path = file.unwrap_or(Path::new("-"));
    let Some(edges) = division(options)? else {
        return Err(Failure::input(
            "how many intervals? give --size S, or --intervals N for every edge",
        ));
    };
    let is_obj = Format::of_path(path) == Some(Format::Obj);
    let from_mesh = FromMesh {
        edges,
        merge_coplanar: of_model.merge_coplanar || !is_obj,
        planar_tolerance: of_model.planar_tolerance,
    };
    let model = Model::of_mesh(mesh, &from_mesh).map_err(|error| bad(file, &error))?;
    // An OBJ has names for groups alone.
    let stem = file.filter(|path| matches!(Input::of(path), Input::File(_)));
    let stem = stem.and_then(|path| path.file_stem()?.to_str());
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
        (None, Some(size)) => Intervals::Size(size.value),
        (None, None) if spacing.is_some() => {
            return Err(Failure::input(
                "--spacing of a model needs --size or --intervals beside it",
            ));
        }
        (None, None) => return Ok(None),
    };
    let spacing = spacing.clone().unwrap_or(Spacing::Uniform);
    Ok(Some(Side { intervals, ..Side::count(1).spaced(spacing) }))
}
