//! `mindeg inspect`: the properties of a mesh of any program.

mod text;

use crate::args::InspectArguments;
use crate::bar::Bar;
use crate::demands::met;
use crate::failure::Failure;
use crate::making::read_mesh;
use crate::standard_output::{print, print_json};
use crate::terminal::say;
use mindeg::inspection::{Inspection, InspectionOptions};
use mindeg_answers::demands::WorstPlaces;
use mindeg_answers::inspected::InspectionReport;
use mindeg_files::{Input, ProjectionChoice, look_like_degrees};
use mindeg_mesh::TriMesh;

/// The mesh in the plane of its region if its coordinates look like degrees, with a note: a program's rules are for lengths.
fn in_metres(mesh: TriMesh) -> TriMesh {
    let points = || mesh.positions().iter().map(|at| at.truncate());
    let is_flat = mesh.positions().iter().all(|at| at.z == 0.0);
    if !is_flat || !look_like_degrees(points()) {
        return mesh;
    }
    let Ok(Some(projection)) = ProjectionChoice::Auto.of(points()) else { return mesh };
    let plane = points().map(|at| projection.to_plane(at).extend(0.0)).collect();
    say(&format!(
        "the coordinates look like degrees: --preset judges them in metres, by {}",
        projection.name()
    ));
    mesh.clone().with_positions(plane).unwrap_or(mesh)
}

pub(crate) fn run(arguments: &InspectArguments) -> Result<(), Failure> {
    let bar = Bar::new(arguments.quiet);
    let input = Input::of(&arguments.file);
    if arguments.format.is_some() && input != Input::StandardInput {
        return Err(Failure::input(
            "--format is for standard input; the name of a file tells its format",
        ));
    }
    let mesh = read_mesh(&arguments.file, arguments.format, &bar)?;
    let options = InspectionOptions {
        weld: (!arguments.no_weld).then_some(arguments.weld),
        pole_degree: arguments.poles_above,
        corner_angle: arguments.corner_angle,
    };
    let inspection = bar.waiting("inspecting", || Inspection::of(&mesh, &options));
    let report = bar.waiting("the least degree of its outline", || {
        InspectionReport::new(Some(input.name()), &mesh, &inspection, &options)
    });
    drop(bar);
    let printed = if arguments.json {
        print_json(&report)
    } else {
        print(&text::text(&report, &inspection, &options))
    };
    // A demand holds whether somebody reads the report or not.
    let demands = arguments.demands.demands();
    let mut unmet = demands.unmet(report.max_degree, report.min_angle, || WorstPlaces {
        vertex: inspection.highest_degree.map(|highest| highest.vertex),
        triangle: report.worst_triangles.first().map(|worst| (worst.triangle, worst.vertices)),
    });
    if let Some(preset) = demands.preset {
        let welded = options.weld.map(|tolerance| mesh.welded(tolerance));
        let mesh = welded.unwrap_or(mesh);
        unmet.extend(preset.broken_by(&in_metres(mesh)));
    }
    met(&unmet).and(printed)
}
