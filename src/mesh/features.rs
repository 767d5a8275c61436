//! Several polygons of a file: a mesh for each, in files of their own.

use crate::args::MeshArguments;
use crate::failure::Failure;
use crate::named_files::{is_pattern, names, prepare, summed_up};
use mindeg::Domain;
use mindeg_answers::advice::Purpose;
use mindeg_files::{Format, PolygonFile};
use std::path::PathBuf;

/// Advice for polygons that are not the regions of one mesh.
pub(super) const SEPARATE: &str = "give --separate and a folder, such as -o meshes/, for a mesh of each polygon, or choose one with --feature";

/// Whether the polygons of a file are regions of one mesh: with interior points, unless each is wanted by itself.
pub(super) fn are_one_map(arguments: &MeshArguments) -> bool {
    let is_wanted = arguments.interior.interior || arguments.goal.purpose == Some(Purpose::Solver);
    is_wanted && is_one_mesh(arguments)
}

/// Whether one mesh is wanted of all polygons.
pub(crate) fn is_one_mesh(arguments: &MeshArguments) -> bool {
    !arguments.separate && !arguments.surface.output.iter().any(|path| is_pattern(path))
}

/// Meshes every polygon. If one has no mesh, or fails a demand, the others still get theirs.
pub(super) fn run(
    arguments: &MeshArguments,
    polygons: &PolygonFile,
    mesh: impl Fn(&Domain, &[PathBuf]) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let patterns = &arguments.surface.output;
    if let Some(plain) = patterns.iter().find(|path| !is_pattern(path)) {
        let count = polygons.polygons.len();
        return Err(Failure::Input(format!(
            "{} has {count} polygons, and {} is one file; give a folder, such as -o meshes/, or a \
             name with {{name}} or {{index}}, such as -o 'meshes/{{name}}.glb', choose one polygon with \
             --feature, or leave out --separate for one mesh with the polygons as regions",
            polygons.file,
            plain.display()
        )));
    }
    let extension = arguments.surface.format.unwrap_or(Format::Obj).extension();
    let files: Vec<Vec<PathBuf>> =
        patterns.iter().map(|pattern| names(pattern, &polygons.polygons, extension)).collect();
    prepare(&files.concat())?;
    let mut failures = Vec::new();
    for (index, polygon) in polygons.polygons.iter().enumerate() {
        let outputs: Vec<PathBuf> =
            files.iter().map(|of_pattern| of_pattern[index].clone()).collect();
        let domain = polygons.domain(polygon).map_err(Failure::from);
        let meshed = domain.and_then(|domain| {
            // Several without a name would all be called alike.
            let called = domain.name().is_none().then(|| domain.clone().named(polygon.name()).ok());
            let domain = called.flatten().unwrap_or(domain);
            mesh(&domain, &outputs).map_err(|failure| failure.of(&polygon.name()))
        });
        match meshed {
            // Nobody reads what is printed.
            Err(Failure::ClosedPipe) => return Err(Failure::ClosedPipe),
            meshed => failures.extend(meshed.err()),
        }
    }
    summed_up(
        failures,
        polygons.polygons.len(),
        "polygons have no mesh; those of the others were written",
    )
}

/// The outputs for the mesh of the only polygon; its name replaces patterns.
pub(super) fn outputs_of_one(
    arguments: &MeshArguments,
    polygons: &PolygonFile,
) -> Result<Vec<PathBuf>, Failure> {
    let extension = arguments.surface.format.unwrap_or(Format::Obj).extension();
    let mut outputs = Vec::new();
    for path in &arguments.surface.output {
        if is_pattern(path) {
            let files = names(path, &polygons.polygons, extension);
            prepare(&files)?;
            outputs.extend(files);
        } else {
            outputs.push(path.clone());
        }
    }
    Ok(outputs)
}
