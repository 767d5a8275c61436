//! `mindeg mesh`: from a domain to files.

mod features;
mod interior;
mod model;

use crate::args::{GoalArguments, MeshArguments, Optimize};
use crate::bar::Bar;
use crate::demands::{met_or_written_anyway, unmet_by_boundary_mesh};
use crate::domain::{Content, name, name_in_text, subject};
use crate::failure::Failure;
use crate::interrupt::clean_up_on_interrupt;
use crate::output::Outputs;
use crate::standard_output::print_json;
use crate::targets::Targets;
use crate::terminal::say;
use mindeg::exact::ExactError;
use mindeg::{Domain, Goal, Meshed, Progress};
use mindeg_answers::degree::triangle_count;
use mindeg_answers::mesh::{self as words, MeshAnswer};
use mindeg_exact::{MAX_VERTICES, ProblemError};
use serde::Serialize;
use std::io::{self, IsTerminal};
use std::path::PathBuf;

/// What `--json` prints.
#[derive(Serialize)]
struct Summary {
    #[serde(flatten)]
    mesh: MeshAnswer,
    files: Vec<String>,
}

pub(crate) fn run(arguments: &MeshArguments) -> Result<(), Failure> {
    if let Some(path) = arguments.domain.file.as_deref().filter(|path| model::is_model(path)) {
        return model::run(path, arguments);
    }
    let output = &arguments.surface.output;
    match subject(&arguments.domain)? {
        Content::Domain(domain) => mesh_of(&domain, arguments, output),
        Content::Polygons(polygons) if polygons.polygons.len() > 1 => {
            features::run(arguments, &polygons, |domain, output| mesh_of(domain, arguments, output))
        }
        Content::Polygons(polygons) => {
            let output = features::outputs_of_one(arguments, &polygons)?;
            mesh_of(&polygons.only()?, arguments, &output)
        }
    }
}

/// Meshes one domain into files.
fn mesh_of(domain: &Domain, arguments: &MeshArguments, output: &[PathBuf]) -> Result<(), Failure> {
    let surface = &arguments.surface;
    let mut targets = Targets::new(output, surface.format, surface.options(), arguments.json)?;
    let to_terminal = targets.use_standard_output() && io::stdout().is_terminal();
    let bar = Bar::new(arguments.quiet || to_terminal);
    clean_up_on_interrupt()?;

    if let Some(wanted) = interior::wanted(arguments, domain)? {
        return interior::run(arguments, domain, &wanted, targets, bar);
    }
    // What can be refused is refused before the mesh is looked for, which can take minutes.
    targets.check(domain.placement(), triangle_count(domain.rings()))?;
    let goal = goal(&arguments.goal, arguments.optimize, domain)?;
    let mut outputs = Outputs::default();
    targets.open(&mut outputs)?;
    let files = targets.files();

    let callback = bar.callback();
    let progress = Progress::new(&callback);
    let meshed = meshed(domain, goal, progress)?;
    let mesh = &meshed.mesh;
    let angles =
        mesh.measure_angles(progress).map_err(|error| Failure::Input(error.to_string()))?;
    let demands = arguments.demands(arguments.interior.aims.target_angle);
    let unmet = unmet_by_boundary_mesh(&demands, mesh, angles.min, &bar)?;
    let end = met_or_written_anyway(&unmet, arguments.interior.aims.write_anyway)?;

    targets.write(mesh, outputs, &bar)?;
    drop(callback);
    drop(bar);

    let summary = Summary { mesh: MeshAnswer::of(&meshed, [angles.min, angles.max]), files };
    if !arguments.quiet {
        say(&text(&meshed, goal, &summary));
    }
    if arguments.json {
        print_json(&summary)?;
    }
    end
}

/// The goal; a limit below the least degree is refused at any size.
pub(crate) fn goal(
    arguments: &GoalArguments,
    optimize: Option<Optimize>,
    domain: &Domain,
) -> Result<Goal, Failure> {
    let form = domain.convex().filter(|_| !domain.is_constrained());
    let least = form.map(|form| mindeg_core::least_max_degree(form.boundary()));
    let goal = match (arguments.keep_angle, arguments.max_degree, optimize) {
        (Some(share), _, _) => Goal::KeepAngle(share),
        (None, Some(limit), _) => Goal::MaxDegree(limit),
        (None, None, Some(Optimize::Angle)) => match least {
            Some(least) => Goal::MaxDegree(least),
            // The solver works on any other domain anyway.
            None => Goal::LeastDegree,
        },
        (None, None, None) => Goal::LeastDegree,
    };
    match (goal, least) {
        (Goal::MaxDegree(limit), Some(least)) if limit < least => Err(Failure::Input(format!(
            "no mesh of {} has maximum degree {limit}; the least is {least}",
            name_in_text(domain)
        ))),
        _ => Ok(goal),
    }
}

/// The mesh of a domain.
pub(crate) fn meshed(
    domain: &Domain,
    goal: Goal,
    progress: Progress<'_>,
) -> Result<Meshed, Failure> {
    mindeg::mesh(domain, goal, progress)
        .map_err(|error| unsolved(&error, "leave out outside_degree and max_degree"))
}

/// Why a domain has no mesh; where it is for its size, `way_out` says what to do.
pub(crate) fn unsolved(error: &ExactError, way_out: &str) -> Failure {
    Failure::Input(match error {
        ExactError::Problem(ProblemError::TooManyVertices { vertices }) => format!(
            "the domain has {vertices} boundary vertices; exact work takes at most {MAX_VERTICES}; \
             use fewer intervals, or {way_out}"
        ),
        error => error.to_string(),
    })
}

fn text(meshed: &Meshed, goal: Goal, summary: &Summary) -> String {
    let domain = meshed.mesh.domain();
    let angles = [summary.mesh.min_angle, summary.mesh.max_angle];
    let mut lines = vec![format!("{}: {}", name(domain), words::mesh(meshed, angles))];
    lines.extend(words::standing(meshed, goal, summary.mesh.min_angle));
    if let Some(higher) = &meshed.higher_degree {
        lines.push(words::higher_degree(summary.mesh.min_angle, higher));
    }
    lines.extend(domain.notes());
    let files: Vec<_> = summary.files.iter().filter(|file| *file != "-").cloned().collect();
    if !files.is_empty() {
        lines.push(format!("wrote {}", files.join(", ")));
    }
    lines.join("\n")
}
