//! `mindeg view`: a page to look at one mesh.

use crate::args::ViewArguments;
use crate::bar::Bar;
use crate::domain::{from_file, from_options, name_in_text};
use crate::failure::Failure;
use crate::interrupt::clean_up_on_interrupt;
use crate::mesh::{goal, meshed};
use crate::mesh_file;
use crate::output::{Outputs, is_standard_output, write_to};
use crate::provenance::provenance;
use crate::terminal::say;
use mindeg::glam::DVec3;
use mindeg::{Domain, Progress};
use mindeg_compare::write_view;
use mindeg_formats::{Format, extensions};
use mindeg_mesh::{Positions, TriMesh, filled};
use std::path::Path;

/// What is looked at, by its name.
enum Subject<'a> {
    Mesh(&'a Path),
    Domain(Box<Domain>),
}

pub(crate) fn run(arguments: &ViewArguments) -> Result<(), Failure> {
    let output = &arguments.output;
    check_output(output)?;
    let subject = subject(arguments)?;
    clean_up_on_interrupt()?;
    let bar = Bar::new(arguments.quiet);
    let mut outputs = Outputs::default();
    let (mesh, out) = match &subject {
        // A .gltf names further inputs, so the output is opened after it.
        Subject::Mesh(path) => {
            let mesh = mesh_file::read(path, &bar)?;
            (mesh, outputs.open(output)?)
        }
        // What cannot be written is refused before the work, which can take minutes.
        Subject::Domain(domain) => {
            let out = outputs.open(output)?;
            (mesh_of(domain, arguments, &bar)?, out)
        }
    };
    let what = match &subject {
        Subject::Mesh(path) => path.display().to_string(),
        Subject::Domain(domain) => name_in_text(domain).to_owned(),
    };
    let made_by = provenance(arguments.file.as_deref());
    bar.waiting(format!("making a view of {what}"), || {
        write_to(output, out, |out| write_view(&mesh, &made_by, out))
    })?;
    outputs.finish()?;
    drop(bar);
    if !arguments.quiet && !is_standard_output(output) {
        say(&format!("wrote {}", output.display()));
    }
    Ok(())
}

fn check_output(path: &Path) -> Result<(), Failure> {
    let extension = path.extension().map(|name| name.to_string_lossy().to_lowercase());
    if is_standard_output(path) || matches!(extension.as_deref(), Some("html" | "htm")) {
        return Ok(());
    }
    Err(Failure::Input(format!("-o {}: a view ends in .html", path.display())))
}

/// A mesh or a domain, by the extension of the file; a domain where there is no file.
fn subject(arguments: &ViewArguments) -> Result<Subject<'_>, Failure> {
    let options = &arguments.options;
    let Some(path) = &arguments.file else {
        return Ok(Subject::Domain(Box::new(from_options(options)?)));
    };
    if Format::of_path(path).is_some_and(|format| Format::READ.contains(&format)) {
        for (option, is_given) in [
            ("--intervals", options.intervals.is_some()),
            ("--size", options.size.is_some()),
            ("--spacing", options.spacing.is_some()),
            ("--keep-angle", arguments.goal.keep_angle.is_some()),
            ("--max-degree", arguments.goal.max_degree.is_some()),
        ] {
            if is_given {
                return Err(Failure::Input(format!(
                    "{} is a mesh, which is shown as it is; {option} is for domains",
                    path.display()
                )));
            }
        }
        return Ok(Subject::Mesh(path));
    }
    let is_json = path.extension().is_some_and(|name| name.eq_ignore_ascii_case("json"));
    if is_json || path.as_os_str() == "-" {
        return Ok(Subject::Domain(Box::new(from_file(path, options)?)));
    }
    Err(Failure::Input(format!(
        "{}: the name tells neither a mesh nor a domain; a mesh ends in {}, a domain in .json",
        path.display(),
        extensions(&Format::READ)
    )))
}

/// The mesh of a domain as a list.
fn mesh_of(domain: &Domain, arguments: &ViewArguments, bar: &Bar) -> Result<TriMesh, Failure> {
    let goal = goal(&arguments.goal, None, domain)?;
    let callback = bar.callback();
    let mesh = meshed(domain, goal, Progress::new(&callback))?.mesh;
    let positions = filled(0..mesh.vertex_count(), DVec3::ZERO, |first, out| {
        mesh.fill_positions(first, out);
    });
    let listed = TriMesh::new(positions, mesh.triangles().collect());
    let listed = listed.map_err(|error| Failure::Input(error.to_string()))?;
    Ok(match domain.name() {
        Some(name) => listed.named(name),
        None => listed,
    })
}
