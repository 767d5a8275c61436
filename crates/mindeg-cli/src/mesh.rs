//! `mindeg mesh`: from a domain to files.

use crate::args::{MeshArguments, Optimize};
use crate::bar::Bar;
use crate::domain::{domain, name, name_in_text};
use crate::failure::Failure;
use crate::gates::degrees;
use crate::interrupt::clean_up_on_interrupt;
use crate::memory;
use crate::output::Outputs;
use crate::standard_output::print_json;
use crate::targets::Targets;
use crate::terminal::say;
use mindeg::exact::ExactError;
use mindeg::{BoundaryMesh, Domain, Goal, Meshed, Progress};
use mindeg_exact::{MAX_VERTICES, ProblemError};
use serde::Serialize;
use std::io::{self, IsTerminal};

/// What `--json` prints; angles in degrees. Degrees are total: edges outside the domain count.
#[derive(Serialize)]
struct Summary<'a> {
    name: Option<&'a str>,
    intervals: Vec<u32>,
    vertices: u32,
    triangles: u32,
    max_degree: u32,
    least_max_degree: u32,
    min_angle: f64,
    max_angle: f64,
    /// Whether the corners ran clockwise.
    reversed: bool,
    files: Vec<String>,
}

pub(crate) fn run(arguments: &MeshArguments) -> Result<(), Failure> {
    let surface = &arguments.surface;
    let mut targets =
        Targets::new(&surface.output, surface.format, surface.options(), arguments.json)?;
    let domain = domain(&arguments.domain)?;
    let to_terminal = targets.use_standard_output() && io::stdout().is_terminal();
    let bar = Bar::new(arguments.quiet || to_terminal);
    clean_up_on_interrupt()?;

    // What can be refused is refused before the mesh is looked for, which can take minutes.
    targets.check(domain.placement(), domain.boundary().vertex_count() - 2)?;
    memory::require_to_stream(domain.boundary().vertex_count(), name_in_text(&domain))?;
    let goal = goal(arguments, &domain)?;
    let mut outputs = Outputs::default();
    targets.open(&mut outputs)?;
    let files = targets.files();

    let callback = bar.callback();
    let progress = Progress::new(&callback);
    let Meshed { mesh, least_max_degree } =
        mindeg::mesh(&domain, goal, progress).map_err(|error| {
            unsolved(&error, &format!("leave out {} for any size", way_out(arguments)))
        })?;
    let angles =
        mesh.measure_angles(progress).map_err(|error| Failure::Input(error.to_string()))?;
    arguments.gates.check_mesh(&mesh, angles.min, &bar)?;

    let all_taken = targets.write(&mesh, &bar)?;
    outputs.finish()?;
    drop(callback);
    drop(bar);
    if !all_taken {
        return Err(Failure::ClosedPipe);
    }

    let summary = Summary {
        name: domain.name(),
        intervals: domain.boundary().sides().collect(),
        vertices: mesh.vertex_count(),
        triangles: mesh.triangle_count(),
        max_degree: mesh.max_total_degree(),
        least_max_degree,
        min_angle: angles.min,
        max_angle: angles.max,
        reversed: domain.was_reversed(),
        files,
    };
    if !arguments.quiet {
        say(&text(&mesh, &summary));
    }
    if arguments.json { print_json(&summary) } else { Ok(()) }
}

/// What the mesh is chosen for, if that can be: a limit below the least degree is refused at any
/// size, and so is exact work without the memory for it.
fn goal(arguments: &MeshArguments, domain: &Domain) -> Result<Goal, Failure> {
    let max_degree = arguments.max_degree;
    let goal = match arguments.optimize {
        Some(Optimize::Angle) => Goal::LargestAngle { max_degree },
        None if max_degree.is_some() => Goal::LargestAngle { max_degree },
        None => Goal::LeastDegree,
    };
    let least = mindeg_core::least_max_degree(domain.boundary());
    if let Some(limit) = max_degree.filter(|&limit| limit < least && !domain.is_constrained()) {
        return Err(Failure::Input(format!(
            "no mesh of {} has maximum degree {limit}; the least is {least}",
            name_in_text(domain)
        )));
    }
    if goal != Goal::LeastDegree || domain.is_constrained() {
        require_for_exact_work(domain)?;
    }
    Ok(goal)
}

/// The options without which a domain is meshed at any size.
fn way_out(arguments: &MeshArguments) -> &'static str {
    match (arguments.max_degree, arguments.optimize) {
        (Some(_), None) => "--max-degree",
        (None, Some(_)) => "--optimize",
        (Some(_), Some(_)) => "--max-degree and --optimize",
        (None, None) => "outside_degree and max_degree",
    }
}

/// Asks for the memory of exact work on a domain, if it is not too large for that anyway.
pub(crate) fn require_for_exact_work(domain: &Domain) -> Result<(), Failure> {
    /// Bytes for each pair of vertices, as measured, 28 to 36, and a third more.
    const PER_PAIR: u64 = 48;
    let vertices = domain.boundary().vertex_count();
    if vertices > MAX_VERTICES {
        return Ok(());
    }
    let bytes = u64::from(vertices).pow(2) * PER_PAIR;
    memory::require(bytes, &format!("exact work on {} ({vertices} vertices)", name_in_text(domain)))
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

fn text(mesh: &BoundaryMesh, summary: &Summary<'_>) -> String {
    let total = if mesh.domain().is_constrained() { "total " } else { "" };
    let mut text = format!(
        "{}: {} vertices, {} triangles, maximum {total}degree {} (least possible {}), angles {} \
         to {}",
        name(mesh.domain()),
        summary.vertices,
        summary.triangles,
        summary.max_degree,
        summary.least_max_degree,
        degrees(summary.min_angle),
        degrees(summary.max_angle),
    );
    if summary.reversed {
        text.push_str("\nThe corners ran clockwise and were reversed; each side kept its edge.");
    }
    let files: Vec<_> = summary.files.iter().filter(|file| *file != "-").cloned().collect();
    if !files.is_empty() {
        text.push_str(&format!("\nwrote {}", files.join(", ")));
    }
    text
}
