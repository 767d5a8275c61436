//! `mindeg mesh` of a whole model: from its faces to one watertight mesh.

mod source;

pub(crate) use source::{bad, divided, of_mesh};

use crate::args::MeshArguments;
use crate::demands::met_or_written_anyway;
use crate::failure::Failure;
use crate::making::Making;
use mindeg::Model;
use mindeg::model::{fill_model, mesh_model};
use mindeg_answers::advice::Purpose;
use mindeg_answers::model::ModelAnswer;
use mindeg_mesh::TriMesh;

pub(super) fn run(model: &Model, arguments: &MeshArguments) -> Result<(), Failure> {
    let mut making = Making::new(&arguments.surface, arguments.quiet, arguments.json)?;
    making.expect_materials(model.groups().iter().any(|group| group.material.is_some()))?;
    if arguments.interior.interior || arguments.goal.purpose == Some(Purpose::Solver) {
        return fill(model, arguments, making);
    }
    super::interior::refuse_options(arguments)?;
    let (goal, effort) = (arguments.goal.goal(), arguments.model.effort);
    making.open()?;
    let meshed = making.work(|progress| mesh_model(model, goal, effort, progress));
    let meshed = meshed.map_err(|error| bad(arguments.domain.file.as_deref(), &error))?;
    let mesh = &meshed.mesh;
    let end = judged(arguments, mesh, meshed.min_angle)?;
    let made = making.write(mesh)?;
    let answer = ModelAnswer::of(model, &meshed);
    made.say(|| answer.text(), || &answer)?;
    end
}

/// How the run ends once the mesh is written, if it is to be.
fn judged(
    arguments: &MeshArguments,
    mesh: &TriMesh,
    min_angle: f64,
) -> Result<Result<(), Failure>, Failure> {
    let aims = &arguments.interior.wanted;
    let unmet = arguments.demands(aims.target_angle()).unmet_by(mesh, min_angle);
    met_or_written_anyway(&unmet, aims.write_anyway)
}

/// Fills the faces with interior points.
fn fill(model: &Model, arguments: &MeshArguments, mut making: Making) -> Result<(), Failure> {
    arguments.refuse_goals_with_interior("--interior")?;
    making.open()?;
    let interior = arguments.interior.wanted.over(None);
    let filled = making.work(|progress| fill_model(model, &interior, progress));
    let filled = filled.map_err(|error| bad(arguments.domain.file.as_deref(), &error))?;
    let mesh = &filled.mesh;
    let end = judged(arguments, mesh, filled.min_angle)?;
    let made = making.write(mesh)?;
    let answer = ModelAnswer::filled(model, &filled);
    made.say(|| answer.text(), || &answer)?;
    end
}
