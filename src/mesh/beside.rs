//! Polygons that do not all hang together as one mesh, from their boundary points alone.

use super::interior::refuse_options;
use crate::args::MeshArguments;
use crate::demands::met_or_written_anyway;
use crate::domain::Parts;
use crate::failure::Failure;
use crate::making::{Making, advice_on};
use crate::provenance::mesh_command_again;
use mindeg::beside::mesh_all;
use mindeg_answers::advice::AdvisedMesh;
use mindeg_answers::mesh::{MeshBesideAnswer, mesh_beside};

/// Meshes all parts into the same files.
pub(super) fn run(parts: &Parts, arguments: &MeshArguments) -> Result<(), Failure> {
    refuse_options(arguments)?;
    let mut making = Making::new(&arguments.surface, arguments.quiet, arguments.json)?;
    let goal = arguments.goal.goal();
    making.open()?;
    let (mut found, angles) = making.work(|progress| {
        let found = mesh_all(&parts.domains, goal, progress)
            .map_err(|(index, error)| parts.failure((index, Failure::input(error))))?;
        let angles = found.parts.iter().map(|part| {
            let range = part.mesh.measure_angles(progress).map_err(Failure::input)?;
            Ok([range.min, range.max])
        });
        let angles = angles.collect::<Result<Vec<_>, Failure>>()?;
        Ok::<_, Failure>((found, angles))
    })?;
    found.mesh = found.mesh.called(parts.name.as_deref());
    let answer = MeshBesideAnswer::of(&found, &angles, parts.name.as_deref());
    let demands = arguments.demands(arguments.interior.wanted.target_angle());
    let unmet = demands.unmet_by(&found.mesh, answer.all.min_angle);
    let end = met_or_written_anyway(&unmet, arguments.interior.wanted.write_anyway)?;
    let made = making.write(&found.mesh)?;
    let hints = || {
        let command = mesh_command_again(&parts.whole(), arguments.domain.file.as_deref());
        let is_told = !arguments.goal.is_empty();
        let advice = (!is_told).then(|| advice_on(&parts.domains))?;
        advice.hints(&command, AdvisedMesh::of_all(&found.parts))
    };
    made.say_and_advise(|| mesh_beside(&found, &answer, goal).join("\n"), hints, || &answer)?;
    end
}
