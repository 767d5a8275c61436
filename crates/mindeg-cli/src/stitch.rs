//! `mindeg stitch`: meshes joined by a mesh of the gap between them.

use crate::args::StitchArguments;
use crate::bar::Bar;
use crate::demands::new_triangles_met;
use crate::domain::opened;
use crate::failure::Failure;
use crate::making::Making;
use mindeg::stitch::stitch;
use mindeg::{Interior, TriMesh};
use mindeg_answers::stitch::StitchAnswer;
use mindeg_files::Wanted;

pub(crate) fn run(arguments: &StitchArguments) -> Result<(), Failure> {
    let surface = &arguments.surface;
    let mut making = Making::new(surface, &surface.output, arguments.quiet, arguments.json)?;
    let bar = Bar::new(true);
    let area = opened(&arguments.area, &arguments.outline, None, Wanted::Domain, &bar)?.only()?;
    let read = |path| making.read(path);
    let meshes: Vec<TriMesh> =
        arguments.files.iter().map(|path| path.as_path()).map(read).collect::<Result<_, _>>()?;
    making.tell_dropped(&meshes);
    let wanted: Interior = arguments.wanted.over(None);
    making.open()?;
    let found = making
        .work(|progress| stitch(&meshes, &area, &wanted, progress))
        .map_err(Failure::input)?;
    new_triangles_met(wanted.target_angle, &found.mesh, &found.triangles, found.min_angle)?;
    let answer = StitchAnswer::of(&found);
    let made = making.write(&found.mesh)?;
    made.say(|| answer.text(), || &answer)
}
