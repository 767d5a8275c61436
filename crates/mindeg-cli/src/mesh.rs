//! `mindeg mesh`: from a domain to files.

mod target;

use self::target::{Prepared, Target, targets};
use crate::args::{MeshArguments, Optimize};
use crate::bar::{Bar, Unit};
use crate::domain::domain;
use crate::failure::Failure;
use crate::interrupt::clean_up_on_interrupt;
use crate::output::Outputs;
use crate::standard_output::print_json;
use crate::watched::watched;
use mindeg_compare::exact;
use mindeg_core::least_max_degree;
use mindeg_geometry::export::{Plane, SurfaceOptions};
use mindeg_geometry::{Domain, Mesh};
use serde::Serialize;
use std::io::{self, IsTerminal, Write};

/// What to do where files do not fit.
const WAY_OUT_OF_NO_ROOM: &str = "choose a folder with more room, use fewer intervals, write glTF \
    rather than OBJ, which takes more than twice as much, or compress on the way: \
    -o - --format obj | zstd > mesh.obj.zst";

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
    let targets = targets(arguments)?;
    let domain = domain(&arguments.domain)?;
    let options = SurfaceOptions {
        degree_colors: arguments.degree_colors,
        boundary_lines: arguments.boundary_lines,
        plane: if arguments.floor { Plane::Floor } else { Plane::Xy },
        ..SurfaceOptions::default()
    };
    let to_terminal = targets.iter().any(Target::is_standard_output) && io::stdout().is_terminal();
    let bar = Bar::new(arguments.quiet || to_terminal);
    clean_up_on_interrupt()?;

    // What can be refused is refused before the mesh is looked for, which can take minutes: the
    // cheapest first.
    targets.iter().try_for_each(|target| target.check(&domain, &options))?;
    let mut outputs = Outputs::default();
    let prepared = targets.into_iter().map(|it| it.prepare(&domain, &options, &mut outputs));
    let prepared: Vec<Prepared<'_>> = prepared.collect::<Result<_, _>>()?;
    outputs.check_room(WAY_OUT_OF_NO_ROOM)?;

    let (mesh, optimal_max_degree) = mesh(arguments, &domain, &bar)?;
    bar.stage("measuring the angles", mesh.triangle_count().into(), Unit::Triangles);
    let angles = mesh.angle_range_watched(&bar.watch());
    arguments.gates.check_mesh(&mesh, angles.min, &bar)?;

    bar.stage("writing", prepared.iter().map(Prepared::expected_len).sum(), Unit::Bytes);
    let mut closed_pipe = false;
    for output in prepared {
        match output.write(&mesh, &bar) {
            // Nobody reads on, and the other outputs are not for that reader.
            Err(Failure::ClosedPipe) => closed_pipe = true,
            written => written?,
        }
    }
    outputs.finish()?;
    drop(bar);
    if closed_pipe {
        return Err(Failure::ClosedPipe);
    }

    let summary = Summary {
        vertices: mesh.vertex_count(),
        triangles: mesh.triangle_count(),
        max_degree: mesh.max_total_degree(),
        optimal_max_degree,
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

/// The mesh that is asked for, and the least maximum degree that there is.
fn mesh(arguments: &MeshArguments, domain: &Domain, bar: &Bar) -> Result<(Mesh, u32), Failure> {
    let for_angle = arguments.optimize == Some(Optimize::Angle);
    if !for_angle && !domain.is_constrained() {
        let triangles = u64::from(domain.boundary().vertex_count()) - 2;
        bar.stage("choosing the mesh", triangles, Unit::Triangles);
        let mesh = Mesh::least_degree_watched(domain, &bar.watch())
            .map_err(|error| Failure::Input(error.to_string()))?;
        return Ok((mesh, least_max_degree(domain.boundary())));
    }
    let dispensable = if for_angle { "--optimize" } else { "outside_degree and max_degree" };
    let way_out = format!(
        "leave out {dispensable} for the mesh of least degree, which can be had at any size"
    );
    watched(bar, &way_out, |watch| {
        let least = exact::optimal_max_degree(domain, watch)?;
        let allowed = arguments.gates.max_degree.filter(|_| for_angle);
        let exact = exact::mesh(domain, allowed.unwrap_or(least), watch)?;
        Ok((exact.mesh, least))
    })
}

fn text(mesh: &Mesh, summary: &Summary) -> String {
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
