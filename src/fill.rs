//! `mindeg fill`: the holes of a mesh closed.

use crate::args::FillArguments;
use crate::boundary_loops::{index_of, listed};
use crate::demands::new_triangles_met;
use crate::failure::Failure;
use crate::making::Making;
use mindeg::Loops;
use mindeg::fill::{FillOptions, fill};
use mindeg_answers::loops::{FillAnswer, OpenLoop};
use mindeg_mesh::Triangles;

pub(crate) fn run(arguments: &FillArguments) -> Result<(), Failure> {
    let mut making = Making::new(&arguments.surface, arguments.quiet, arguments.json)?;
    let file = &arguments.file;
    let mesh = making.read(file)?;
    let loops = Loops::of(&mesh);
    if loops.list().is_empty() {
        let message = format!("{} has no boundary loop; it is closed", file.display());
        return Err(Failure::Input(message));
    }
    let only = match &arguments.loops[..] {
        [] => None,
        choices => {
            let indices = choices.iter().map(|&choice| index_of(choice, &loops, &mesh, file));
            Some(indices.collect::<Result<Vec<usize>, _>>()?)
        }
    };
    let options = FillOptions {
        max_degree: arguments.max_degree,
        extra_area: arguments.extra_area,
        max_loop: arguments.max_loop as usize,
        only,
        interior: arguments.interior,
    };
    let lengths = loops.list().iter().map(|found| found.vertices.len());

    // Refuse bad options before the search, which can take minutes.
    let most = mesh.triangle_count().saturating_add(lengths.sum::<usize>() as u32);
    making.check(&mesh, most)?;
    making.open()?;
    let listed = listed(&loops, &mesh);
    let is_named = options.only.is_some();
    let rim = loops.list().iter().position(|found| found.is_rim && !is_named);
    let hint = rim.map(|index| format!("--loop {} fills the rim all the same", index + 1));
    let result = making
        .work(|progress| fill(mesh, &loops, &options, progress))
        .map_err(|error| Failure::Input(format!("{}: {error}", file.display())))?;
    let answer = FillAnswer::of(&file.display().to_string(), &result, &loops);
    if result.filled.is_empty() {
        let reasons: Vec<String> = answer.left_open.iter().map(OpenLoop::text).collect();
        let message = if reasons.len() > 5 { listed } else { format!(": {}", reasons.join("; ")) };
        let name = file.display();
        let hint = hint.map_or_else(String::new, |hint| format!("; {hint}"));
        return Err(Failure::Input(format!("{name} has no loop to fill{message}{hint}")));
    }
    for found in &result.filled {
        new_triangles_met(arguments.target_angle, &result.mesh, &found.triangles, found.min_angle)?;
    }
    let made = making.write_checked(&result.mesh)?;
    let hint = hint.map_or_else(String::new, |hint| format!("\nhint: {hint}"));
    made.say(|| answer.text(&options) + &hint, || &answer)
}
