//! `mindeg stitch`: meshes joined by a mesh of the gap between them.

use crate::args::StitchArguments;
use crate::bar::Bar;
use crate::demands::new_triangles_met;
use crate::domain::opened;
use crate::failure::Failure;
use crate::making::Making;
use crate::terminal::say;
use mindeg::stitch::{Gap, stitch};
use mindeg::{Interior, TriMesh};
use mindeg_answers::stitch::StitchAnswer;
use mindeg_files::{Wanted, look_like_degrees};

/// Meshes in degrees that lie farther apart are nearest across the antimeridian.
const HALF_ROUND: f64 = 180.0;

pub(crate) fn run(arguments: &StitchArguments) -> Result<(), Failure> {
    let mut making = Making::new(&arguments.surface, arguments.quiet, arguments.json)?;
    let bar = Bar::new(true);
    let area = arguments
        .area
        .as_ref()
        .map(|area| opened(area, &arguments.outline, None, Wanted::Domain, &bar)?.only());
    let area = area.transpose()?;
    let read = |path| making.read(path);
    let meshes: Vec<TriMesh> =
        arguments.files.iter().map(|path| path.as_path()).map(read).collect::<Result<_, _>>()?;
    making.tell_dropped(&meshes);
    let wanted: Interior = arguments.wanted.over(None);
    let points = || meshes.iter().flat_map(|mesh| mesh.positions()).map(|at| at.truncate());
    let projection = match (&area, arguments.outline.project) {
        (None, Some(choice)) => choice.of(points()).map_err(Failure::Input)?,
        _ => None,
    };
    if area.is_none() && arguments.outline.project.is_none() && look_like_degrees(points()) {
        say(
            "the coordinates look like degrees and are taken as planar: --project auto makes metres of them",
        );
    }
    // The gap would go around the globe.
    let is_flat = projection.is_none() && area.as_ref().is_none_or(|it| it.projection().is_none());
    let longitudes = points().map(|at| at.x);
    let [least, most] =
        longitudes.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)]);
    if is_flat && look_like_degrees(points()) && most - least > HALF_ROUND {
        return Err(Failure::input(
            "the meshes lie on both sides of the antimeridian, and as planar coordinates the gap goes around the globe: \
             add --project auto",
        ));
    }
    let gap = area.as_ref().map_or(Gap::Overlap(projection.as_ref()), Gap::Within);
    making.open()?;
    let found =
        making.work(|progress| stitch(&meshes, gap, &wanted, progress)).map_err(Failure::input)?;
    new_triangles_met(wanted.target_angle, &found.mesh, &found.triangles, found.min_angle)?;
    let answer = StitchAnswer::of(&found);
    let made = making.write(&found.mesh)?;
    made.say(|| answer.text(), || &answer)
}
