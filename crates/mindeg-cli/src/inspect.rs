//! `mindeg inspect`: what is in a mesh, whatever program wrote it.

mod standard_input;
mod text;

use crate::args::InspectArguments;
use crate::bar::Bar;
use crate::demands::met;
use crate::failure::Failure;
use crate::mesh_file;
use crate::standard_output::{print, print_json};
use mindeg::inspection::{Inspection, InspectionOptions};
use mindeg_answers::demands::WorstPlaces;
use mindeg_answers::inspected::InspectionReport;

pub(crate) fn run(arguments: &InspectArguments) -> Result<(), Failure> {
    let bar = Bar::new(arguments.quiet);
    let is_standard_input = arguments.file.as_os_str() == "-";
    let (name, mesh) = if is_standard_input {
        ("standard input".to_owned(), standard_input::read(arguments.format)?)
    } else if arguments.format.is_some() {
        return Err(Failure::Input(
            "--format is for standard input; the name of a file tells its format".to_owned(),
        ));
    } else {
        (arguments.file.display().to_string(), mesh_file::read(&arguments.file, &bar)?)
    };
    let options = InspectionOptions {
        weld: (!arguments.no_weld).then_some(arguments.weld),
        pole_degree: arguments.poles_above,
        corner_angle: arguments.corner_angle,
    };
    let inspection = bar.waiting("inspecting", || Inspection::of(&mesh, &options));
    let report = bar.waiting("the least degree of its outline", || {
        InspectionReport::new(Some(name), &mesh, &inspection, &options)
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
    unmet.extend(demands.preset.and_then(|preset| preset.broken_by(&mesh)));
    met(&unmet).and(printed)
}
