//! `mindeg view`: a page to look at one mesh.

use crate::args::ViewArguments;
use crate::bar::Bar;
use crate::domain::{Parts, Subject, from_options, in_file};
use crate::failure::Failure;
use crate::interrupt::{SESSION, clean_up_on_interrupt};
use crate::making::{WithFiles, advice_on, wrote};
use crate::mesh::model::{bad, divided};
use crate::mesh::{WITHOUT_CONSTRAINTS, unsolved};
use crate::provenance::{mesh_command, provenance};
use crate::standard_output::print_json;
use crate::terminal::say;
use mindeg::beside::mesh_all;
use mindeg::model::{fill_model, mesh_model};
use mindeg::{GoalKind, Interior, Model, interior};
use mindeg_answers::advice::Purpose;
use mindeg_answers::mesh::{KnownLimits, ListedMesh, ShownMesh};
use mindeg_compare::write_view;
use mindeg_files::{Outputs, Wanted, is_standard_output, write_to};
use mindeg_mesh::TriMesh;
use std::path::Path;

pub(crate) fn run(arguments: &ViewArguments) -> Result<(), Failure> {
    let output = &arguments.output;
    check_output(output)?;
    if arguments.json && is_standard_output(output) {
        return Err(Failure::input(
            "standard output can take one page, or the summary of --json, not both",
        ));
    }
    clean_up_on_interrupt()?;
    let bar = Bar::new(arguments.quiet);
    let subject = match &arguments.file {
        None => Subject::Domain(Box::new(from_options(&arguments.options)?)),
        Some(path) => in_file(path, &arguments.options, Wanted::Mesh, &bar)?,
    };
    let mut outputs = Outputs::new(&SESSION);
    // Refuse outputs that cannot be written before the work, which can take minutes.
    let out = outputs.open(output)?;
    let ((mesh, limits), what, advised_on) = match (subject, &arguments.file) {
        (Subject::Mesh(mesh), Some(path)) => {
            refuse_for_mesh(path, arguments)?;
            ((*mesh, KnownLimits::default()), path.display().to_string(), None)
        }
        (Subject::Model(model), file) => {
            let model = divided(*model, file.as_deref(), &arguments.options)?;
            let name = model.name().unwrap_or("the model").to_owned();
            (mesh_of_model(&model, arguments, &bar)?, name, None)
        }
        (subject, _) => {
            let parts = subject.parts()?;
            let made = mesh_of(&parts, arguments, &bar)?;
            let is_told = arguments.interior
                || !arguments.goal.is_empty()
                || arguments.quiet
                || arguments.json
                || is_standard_output(output)
                || has_interior(&parts);
            (made, parts.name_in_text(), (!is_told).then_some(parts))
        }
    };
    let made_by = provenance(arguments.file.as_deref());
    bar.waiting(format!("making a view of {what}"), || {
        write_to(output, out, |out| write_view(&mesh, &made_by, out))
    })?;
    outputs.finish()?;
    drop(bar);
    if !arguments.quiet && !is_standard_output(output) {
        say(&wrote(&[output.display().to_string()]).unwrap_or_default());
    }
    if arguments.json {
        let file = arguments.file.as_ref().map(|path| path.display().to_string());
        let files = vec![output.display().to_string()];
        let summary = ShownMesh { mesh: ListedMesh::of(file, &mesh), limits };
        print_json(&WithFiles { summary, files })?;
    }
    if let Some(parts) = advised_on {
        let command = mesh_command(&parts.whole(), arguments.file.as_deref());
        // The page is no file of the mesh that it shows, so each mesh is named.
        advice_on(&parts.domains).hints(&command, None).iter().for_each(|hints| say(hints));
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

/// Refuses options that do not apply to a mesh: it is shown unchanged.
fn refuse_for_mesh(path: &Path, arguments: &ViewArguments) -> Result<(), Failure> {
    let options = &arguments.options;
    let given = [
        options.intervals.is_some().then_some("--intervals".to_owned()),
        options.size.is_some().then_some("--size".to_owned()),
        options.spacing.is_some().then_some("--spacing".to_owned()),
        arguments.goal.kinds().next().map(GoalKind::option),
        arguments.goal.purpose.map(|_| "--for".to_owned()),
        arguments.interior.then_some("--interior".to_owned()),
    ];
    match given.into_iter().flatten().next() {
        Some(option) => Err(Failure::Input(format!(
            "{} is a mesh, which is shown as it is; {option} is for domains",
            path.display()
        ))),
        None => Ok(()),
    }
}

/// The mesh of a whole model.
fn mesh_of_model(
    model: &Model,
    arguments: &ViewArguments,
    bar: &Bar,
) -> Result<(TriMesh, KnownLimits), Failure> {
    let file = arguments.file.as_deref();
    if arguments.interior || arguments.goal.purpose == Some(Purpose::Solver) {
        let filled = bar.work(|progress| fill_model(model, &Interior::default(), progress));
        return Ok((filled.map_err(|error| bad(file, &error))?.mesh, KnownLimits::default()));
    }
    let goal = arguments.goal.goal();
    let meshed = bar.work(|progress| mesh_model(model, goal, 1.0, progress));
    let meshed = meshed.map_err(|error| bad(file, &error))?;
    let limits = KnownLimits::from(&meshed);
    Ok((meshed.mesh, limits))
}

/// Whether the file of a domain asks for points inside.
fn has_interior(parts: &Parts) -> bool {
    parts.domains[0].interior().is_some()
}

/// The mesh of a domain, or of all parts of one, as a list.
fn mesh_of(
    parts: &Parts,
    arguments: &ViewArguments,
    bar: &Bar,
) -> Result<(TriMesh, KnownLimits), Failure> {
    let (first, purpose) = (&parts.domains[0], arguments.goal.purpose);
    let in_file = has_interior(parts) && arguments.goal.is_empty();
    let (mesh, limits) = if arguments.interior || in_file || purpose == Some(Purpose::Solver) {
        let wanted = first.interior().cloned().unwrap_or_default();
        let found = bar.work(|progress| interior::mesh_all(&parts.domains, &wanted, progress));
        let found =
            found.map_err(|(index, error)| parts.failure((index, Failure::input(error))))?;
        let limits = KnownLimits::from(&found);
        (found.mesh, limits)
    } else {
        let goal = arguments.goal.goal();
        let found = bar.work(|progress| mesh_all(&parts.domains, goal, progress));
        let found = found.map_err(|(index, error)| {
            parts.failure((index, unsolved(&error, WITHOUT_CONSTRAINTS)))
        })?;
        let limits = KnownLimits::from(&found);
        (found.mesh, limits)
    };
    let mesh = mesh.called(parts.name.as_deref());
    Ok((mesh, limits))
}
