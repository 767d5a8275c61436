//! `mindeg remesh`: a surface in space meshed anew.

use crate::args::RemeshArguments;
use crate::demands::met_or_written_anyway;
use crate::failure::Failure;
use crate::making::Making;
use mindeg::remesh::{PartError, Remesh, remesh};
use mindeg_answers::demands::Demands;
use mindeg_answers::remesh::RemeshAnswer;

pub(crate) fn run(arguments: &RemeshArguments) -> Result<(), Failure> {
    let mut making = Making::new(&arguments.surface, arguments.quiet, arguments.json)?;
    let part = making.read(&arguments.file)?;
    let file = arguments.file.display().to_string();
    making.open()?;
    let wish = Remesh {
        size: arguments.size,
        vertices: arguments.vertices,
        tolerance: arguments.tolerance.map(|tolerance| tolerance.of(&part)),
        feature_angle: arguments.feature_angle,
        target_angle: arguments.target_angle,
        keep_boundary: arguments.keep_boundary,
        keep_features: arguments.keep_features,
        curvature: arguments.curvature,
        repair: arguments.repair,
    };
    let found = making.work(|progress| remesh(&part, &wish, progress));
    let found = found.map_err(|error| {
        let hint = match error {
            PartError::NoSurface(_) if !wish.repair => "; --repair mends what can be mended",
            _ => "",
        };
        Failure::Input(format!("{file}: {error}{hint}"))
    })?;
    let answer = RemeshAnswer::of(&file, &part, wish.tolerance, &found);
    let (target_angle, preset) = (arguments.target_angle, arguments.preset.preset);
    let demands = Demands { target_angle, preset, ..Demands::default() };
    let mut unmet: Vec<String> =
        answer.defects.iter().map(|defect| defect.message.clone()).collect();
    unmet.extend(demands.unmet_by(&found.mesh, found.verified.min_angle.0));
    let end = met_or_written_anyway(&unmet, arguments.write_anyway)?;
    let made = making.write(&found.mesh)?;
    made.say(|| answer.text(), || &answer)?;
    end
}
