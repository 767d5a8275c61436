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
use mindeg::{Domain, FoundBy, Goal, Meshed, Progress};
use mindeg_answers::words::{self, triangle_count};
use mindeg_exact::{MAX_VERTICES, ProblemError};
use serde::Serialize;
use std::io::{self, IsTerminal};
use std::path::PathBuf;

/// What `--json` prints; angles in degrees. Degrees are total: edges outside the domain count.
#[derive(Serialize)]
struct Summary<'a> {
    name: Option<&'a str>,
    intervals: Vec<u32>,
    vertices: u32,
    triangles: u32,
    max_degree: u32,
    /// Null where it is not known; no mesh has less than `at_least`.
    least_max_degree: Option<u32>,
    at_least: u32,
    min_angle: f64,
    max_angle: f64,
    /// "formula", "search" (exact), "windows" (the degree is an upper bound), "exhaustive" or "zig_zag"
    /// (the degree is the least, the angle may not be the largest with it).
    found_by: &'static str,
    /// Null where it was not worked out.
    delaunay_min_angle: Option<f64>,
    /// Whether the corners ran clockwise.
    reversed: bool,
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
    let Meshed { mesh, least_max_degree, .. } = &meshed;
    let angles =
        mesh.measure_angles(progress).map_err(|error| Failure::Input(error.to_string()))?;
    let demands = arguments.demands(arguments.interior.aims.target_angle);
    let unmet = unmet_by_boundary_mesh(&demands, mesh, angles.min, &bar)?;
    let end = met_or_written_anyway(&unmet, arguments.interior.aims.write_anyway)?;

    targets.write(mesh, outputs, &bar)?;
    drop(callback);
    drop(bar);

    let summary = Summary {
        name: domain.name(),
        intervals: domain.rings().sides().collect(),
        vertices: mesh.vertex_count(),
        triangles: mesh.triangle_count(),
        max_degree: mesh.max_total_degree(),
        least_max_degree: meshed.is_least_proven.then_some(*least_max_degree),
        at_least: *least_max_degree,
        min_angle: angles.min,
        max_angle: angles.max,
        found_by: match meshed.found_by {
            FoundBy::Formula => "formula",
            FoundBy::Search => "search",
            FoundBy::Windows { .. } => "windows",
            FoundBy::Exhaustive => "exhaustive",
            FoundBy::ZigZag => "zig_zag",
        },
        delaunay_min_angle: meshed.delaunay_min_angle,
        reversed: domain.was_reversed(),
        files,
    };
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

fn text(meshed: &Meshed, goal: Goal, summary: &Summary<'_>) -> String {
    let domain = meshed.mesh.domain();
    let angles = [summary.min_angle, summary.max_angle];
    let mut lines = vec![format!("{}: {}", name(domain), words::mesh(meshed, angles))];
    lines.extend(words::standing(meshed, goal, summary.min_angle));
    if let Some(higher) = &meshed.higher_degree {
        lines.push(words::higher_degree(summary.min_angle, higher));
    }
    lines.extend(domain.notes());
    let files: Vec<_> = summary.files.iter().filter(|file| *file != "-").cloned().collect();
    if !files.is_empty() {
        lines.push(format!("wrote {}", files.join(", ")));
    }
    lines.join("\n")
}
