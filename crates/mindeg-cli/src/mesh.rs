//! `mindeg mesh`: from a domain to files.

mod interior;

use crate::args::{GoalArguments, MeshArguments, Optimize};
use crate::bar::Bar;
use crate::domain::{domain, name, name_in_text};
use crate::failure::Failure;
use crate::interrupt::clean_up_on_interrupt;
use crate::memory;
use crate::output::Outputs;
use crate::standard_output::print_json;
use crate::targets::Targets;
use crate::terminal::say;
use mindeg::exact::ExactError;
use mindeg::{Domain, FoundBy, Goal, HigherDegree, MeshError, Meshed, Progress};
use mindeg_compare::number_format::steady_angle;
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
    /// "formula", "search" (exact) or "windows" (the degree is an upper bound).
    found_by: &'static str,
    /// Null where it was not worked out.
    delaunay_min_angle: Option<f64>,
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

    if let Some(wanted) = interior::wanted(arguments, &domain)? {
        return interior::run(arguments, &domain, &wanted, targets, bar);
    }
    // What can be refused is refused before the mesh is looked for, which can take minutes.
    targets.check(domain.placement(), domain.rings().vertex_count() - 2)?;
    memory::require_to_stream(domain.rings().vertex_count(), name_in_text(&domain))?;
    let goal = goal(&arguments.goal, arguments.optimize, &domain)?;
    let mut outputs = Outputs::default();
    targets.open(&mut outputs)?;
    let files = targets.files();

    let callback = bar.callback();
    let progress = Progress::new(&callback);
    let meshed = meshed(&domain, goal, progress)?;
    let Meshed { mesh, least_max_degree, .. } = &meshed;
    let angles =
        mesh.measure_angles(progress).map_err(|error| Failure::Input(error.to_string()))?;
    arguments.gates.check_mesh(mesh, angles.min, &bar)?;

    let all_taken = targets.write(mesh, &bar)?;
    outputs.finish()?;
    drop(callback);
    drop(bar);
    if !all_taken {
        return Err(Failure::ClosedPipe);
    }

    let summary = Summary {
        name: domain.name(),
        intervals: domain.rings().sides().collect(),
        vertices: mesh.vertex_count(),
        triangles: mesh.triangle_count(),
        max_degree: mesh.max_total_degree(),
        least_max_degree: *least_max_degree,
        min_angle: angles.min,
        max_angle: angles.max,
        found_by: match meshed.found_by {
            FoundBy::Formula => "formula",
            FoundBy::Search => "search",
            FoundBy::Windows { .. } => "windows",
        },
        delaunay_min_angle: meshed.delaunay_min_angle,
        reversed: domain.was_reversed(),
        files,
    };
    if !arguments.quiet {
        say(&text(&meshed, goal, &summary));
    }
    if arguments.json { print_json(&summary) } else { Ok(()) }
}

/// What the mesh is chosen for, if that can be: a limit below the least degree is refused at any
/// size, and so is exact work without the memory for it.
pub(crate) fn goal(
    arguments: &GoalArguments,
    optimize: Option<Optimize>,
    domain: &Domain,
) -> Result<Goal, Failure> {
    let convex = domain.convex().ok_or_else(|| Failure::Input(MeshError::NotConvex.to_string()))?;
    let least = mindeg_core::least_max_degree(convex.boundary());
    let goal = match (arguments.keep_angle, arguments.max_degree, optimize) {
        (Some(share), _, _) => Goal::KeepAngle(share),
        (None, Some(limit), _) => Goal::MaxDegree(limit),
        // The least degree of a domain with limits of its own takes the solver anyway.
        (None, None, Some(Optimize::Angle)) if !domain.is_constrained() => Goal::MaxDegree(least),
        (None, None, _) => Goal::LeastDegree,
    };
    match goal {
        Goal::MaxDegree(limit) if limit < least && !domain.is_constrained() => {
            Err(Failure::Input(format!(
                "no mesh of {} has maximum degree {limit}; the least is {least}",
                name_in_text(domain)
            )))
        }
        Goal::LeastDegree if !domain.is_constrained() => Ok(goal),
        _ => {
            require_for_exact_work(domain)?;
            Ok(goal)
        }
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

/// Asks for the memory of exact work on a domain, if it is not too large for that anyway.
pub(crate) fn require_for_exact_work(domain: &Domain) -> Result<(), Failure> {
    /// Bytes for each pair of vertices, as measured, 28 to 36, and a third more.
    const PER_PAIR: u64 = 48;
    let vertices = domain.rings().vertex_count();
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

fn text(meshed: &Meshed, goal: Goal, summary: &Summary<'_>) -> String {
    let domain = meshed.mesh.domain();
    let total = if domain.is_constrained() { "total " } else { "" };
    let mut lines = vec![format!(
        "{}: {} vertices, {} triangles, maximum {total}degree {} (least possible {}), angles {} \
         to {}",
        name(domain),
        summary.vertices,
        summary.triangles,
        summary.max_degree,
        summary.least_max_degree,
        steady_angle(summary.min_angle),
        steady_angle(summary.max_angle),
    )];
    lines.extend(standing(meshed, goal, summary));
    if let Some(higher) = &meshed.higher_degree {
        lines.push(hint(summary.min_angle, higher));
    }
    if summary.reversed {
        let turned = "The corners ran clockwise and were reversed; each side kept its edge.";
        lines.push(turned.to_owned());
    }
    let files: Vec<_> = summary.files.iter().filter(|file| *file != "-").cloned().collect();
    if !files.is_empty() {
        lines.push(format!("wrote {}", files.join(", ")));
    }
    lines.join("\n")
}

/// What is proven of a mesh, where the first line does not say it.
fn standing(meshed: &Meshed, goal: Goal, summary: &Summary<'_>) -> Option<String> {
    let Summary { min_angle, max_degree, least_max_degree: least, .. } = summary;
    let kept = meshed.delaunay_min_angle.map(|most| {
        let share = 100.0 * min_angle / most;
        format!("{share:.0}% of Delaunay's minimum angle, {}", steady_angle(most))
    });
    match (meshed.found_by, goal, kept) {
        (FoundBy::Formula, Goal::LeastDegree, _) => Some(
            "It is the best of the candidates that were tried; --keep-angle 95% trades degree for \
             angle at this size."
                .to_owned(),
        ),
        (FoundBy::Formula, _, _) => Some(
            "No window reached the limit; the formula did. A larger minimum angle may be possible."
                .to_owned(),
        ),
        (FoundBy::Search, Goal::KeepAngle(share), Some(kept)) => {
            let percent = 100.0 * share;
            Some(format!("It has {kept}. No smaller degree keeps {percent:.0}%."))
        }
        (FoundBy::Windows { share }, _, Some(kept)) => {
            let percent = 100.0 * share;
            let gap = if max_degree == least {
                "no degree is smaller".to_owned()
            } else {
                format!(
                    "whether a degree from {least} on is possible with {percent:.0}% is not known"
                )
            };
            Some(format!("It has {kept}. Degree {max_degree} was reached; {gap}."))
        }
        (FoundBy::Search | FoundBy::Windows { .. }, _, _) => None,
    }
}

/// What a higher degree would bring, and the option to copy.
pub(crate) fn hint(min_angle: f64, higher: &HigherDegree) -> String {
    format!(
        "Hint: degree {} has a minimum angle of {}, {:.1} times as much: add --max-degree {}",
        higher.max_degree,
        steady_angle(higher.min_angle),
        higher.min_angle / min_angle,
        higher.max_degree,
    )
}
