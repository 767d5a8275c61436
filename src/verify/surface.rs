//! A remesh against the part that it was made from.

use crate::args::{Tolerance, VerifyArguments};
use crate::bar::Bar;
use crate::demands::met;
use crate::failure::Failure;
use crate::making::read_mesh;
use crate::standard_output::{print, print_json};
use mindeg::verify::{self, SurfaceRules};
use mindeg_answers::surface::SurfaceAnswer;
use std::path::Path;

pub(super) fn run(arguments: &VerifyArguments, part: &Path) -> Result<(), Failure> {
    let bar = Bar::new(arguments.quiet);
    let mesh = read_mesh(&arguments.file, None, &bar)?;
    let of_part = read_mesh(part, None, &bar)?;
    let surface = &arguments.surface;
    let of_corners = SurfaceRules::within(0.0).least_angle;
    let rules = SurfaceRules {
        least_angle: arguments.demands.demands().target_angle.unwrap_or(of_corners),
        feature_angle: surface.feature_angle.or(surface.keep_features.then_some(40.0)),
        keep_boundary: surface.keep_boundary,
        keep_features: surface.keep_features,
        ..SurfaceRules::within(arguments.tolerance.unwrap_or(Tolerance::OF_REMESHES).of(&of_part))
    };
    let found = bar
        .work(|progress| verify::surface(&mesh, &of_part, &rules, progress))
        .map_err(Failure::input)?;
    drop(bar);
    let [file, named_part] = [&arguments.file, part].map(|path| path.display().to_string());
    let demands = arguments.demands.demands();
    let answer =
        SurfaceAnswer::of((&file, &mesh), (&named_part, &of_part), &rules, &found, &demands);
    if arguments.json {
        print_json(&answer)?;
    } else {
        print(&answer.text())?;
    }
    met(&answer.failed)
}
