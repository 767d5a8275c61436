//! `mindeg inspect`: the properties of a mesh of any program.

mod text;

use crate::args::InspectArguments;
use crate::bar::Bar;
use crate::demands::met;
use crate::failure::Failure;
use crate::making::read_mesh;
use crate::standard_output::{print, print_json};
use mindeg::inspection::{Inspection, InspectionOptions};
use mindeg_answers::demands::WorstPlaces;
use mindeg_answers::inspected::InspectionReport;
use mindeg_files::Input;

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
        unmet.extend(preset.broken_by(welded.as_ref().unwrap_or(&mesh)));
    }
    met(&unmet).and(printed)
}
