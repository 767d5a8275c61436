//! `mindeg mesh`: from a domain to files.

use crate::args::{MeshArguments, Optimize};
use crate::bar::Bar;
use crate::domain::domain;
use crate::failure::Failure;
use crate::interrupt::clean_up_on_interrupt;
use crate::output::Outputs;
use crate::standard_output::print_json;
use crate::targets::Targets;
use mindeg::exact::{self, ExactError};
use mindeg::{BoundaryMesh, Domain, Goal, Meshed, Progress};
use mindeg_exact::{MAX_VERTICES, ProblemError};
use serde::Serialize;
use std::io::{self, IsTerminal, Write};

/// What `--json` prints; angles in degrees, an output for each `-o`. Degrees are total: edges
/// outside the domain count.
#[derive(Serialize)]
struct Summary {
    vertices: u32,
    triangles: u32,
    max_degree: u32,
    optimal_max_degree: u32,
    min_angle: f64,
    max_angle: f64,
    outputs: Vec<String>,
}

pub(crate) fn run(arguments: &MeshArguments) -> Result<(), Failure> {
    let options = arguments.surface.options();
    let mut targets = Targets::new(&arguments.output, arguments.format, options, arguments.json)?;
    let domain = domain(&arguments.domain)?;
    let to_terminal = targets.use_standard_output() && io::stdout().is_terminal();
    let bar = Bar::new(arguments.quiet || to_terminal);
    clean_up_on_interrupt()?;

    // What can be refused is refused before the mesh is looked for, which can take minutes.
    targets.check(domain.placement(), domain.boundary().vertex_count() - 2)?;
    let mut outputs = Outputs::default();
    targets.open(&mut outputs)?;

    let callback = bar.callback();
    let progress = Progress::new(&callback);
    let Meshed { mesh, least_max_degree, .. } = mesh(arguments, &domain, progress)?;
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
        vertices: mesh.vertex_count(),
        triangles: mesh.triangle_count(),
        max_degree: mesh.max_total_degree(),
        optimal_max_degree: least_max_degree,
        min_angle: angles.min,
        max_angle: angles.max,
        outputs: arguments.output.iter().map(|path| path.display().to_string()).collect(),
    };
    if !arguments.quiet {
        // A summary that cannot be shown is no reason to fail: the files are there.
        let _ = io::stderr().write_all(text(&mesh, &summary).as_bytes());
    }
    if arguments.json { print_json(&summary) } else { Ok(()) }
}

/// The mesh that is asked for.
fn mesh(
    arguments: &MeshArguments,
    domain: &Domain,
    progress: Progress<'_>,
) -> Result<Meshed, Failure> {
    let goal = match (arguments.optimize, arguments.gates.max_degree) {
        (Some(Optimize::Angle), Some(max_degree)) => Goal::MaxDegree(max_degree),
        (Some(Optimize::Angle), None) => {
            let least = exact::least_max_degree(domain, progress);
            Goal::MaxDegree(least.map_err(|error| unsolved(&error, "use fewer limits"))?)
        }
        (None, _) => Goal::LeastDegree,
    };
    let dispensable = match goal {
        Goal::MaxDegree(_) | Goal::KeepAngle(_) => "--optimize",
        Goal::LeastDegree => "outside_degree and max_degree",
    };
    mindeg::mesh(domain, goal, progress).map_err(|error| {
        unsolved(
            &error,
            &format!("leave out {dispensable} for the mesh of least degree at any size"),
        )
    })
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

fn text(mesh: &BoundaryMesh, summary: &Summary) -> String {
    let reversed = if mesh.domain().was_reversed() {
        "The corners ran clockwise and were reversed; each side kept its edge.\n"
    } else {
        ""
    };
    format!(
        "{}: {} vertices, {} triangles, maximum {}degree {} (least possible {}), angles {} to {}\n\
         {reversed}",
        mesh.domain().name().unwrap_or("mesh"),
        summary.vertices,
        summary.triangles,
        if mesh.domain().is_constrained() { "total " } else { "" },
        summary.max_degree,
        summary.optimal_max_degree,
        degrees(summary.min_angle),
        degrees(summary.max_angle),
    )
}

/// An angle as people read it; one too small for three decimals as a power of ten.
pub(crate) fn degrees(angle: f64) -> String {
    if angle < 0.01 { format!("{angle:.1e}°") } else { format!("{angle:.3}°") }
}
