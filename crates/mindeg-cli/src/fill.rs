//! `mindeg fill`: the holes of a mesh closed.

use crate::args::FillArguments;
use crate::boundary_loops::{LoopName, crossing_text, index_of, listed};
use crate::demands::new_triangles_met;
use crate::failure::Failure;
use crate::making::Making;
use mindeg::Loops;
use mindeg::fill::{FIRST_LIMIT, FillOptions, Filled, FilledLoop, fill};
use mindeg_answers::numbers::{four_digits, percent, steady_angle};
use mindeg_mesh::Triangles;
use serde::Serialize;
use std::path::Path;

/// The output of `--json`; angles in degrees.
#[derive(Serialize)]
struct Summary<'a> {
    file: String,
    vertices: usize,
    triangles: usize,
    max_degree: u32,
    filled: Vec<FilledSummary>,
    left_open: Vec<LeftSummary>,
    crossings: &'a [[u32; 2]],
}

#[derive(Serialize)]
struct FilledSummary {
    #[serde(flatten)]
    name: LoopName,
    limit: u32,
    max_degree: u32,
    area: f64,
    area_without_limit: f64,
    /// The least possible limit from 6 up and its area, where a higher one was chosen for its area;
    /// else null.
    least_limit: Option<u32>,
    area_at_least_limit: Option<f64>,
    degree_without_limit: u32,
    min_angle: f64,
    /// The first, and the one after the last.
    triangles: [u32; 2],
}

#[derive(Serialize)]
struct LeftSummary {
    #[serde(flatten)]
    name: LoopName,
    reason: String,
}

pub(crate) fn run(arguments: &FillArguments) -> Result<(), Failure> {
    let surface = &arguments.surface;
    let mut making = Making::new(surface, &surface.output, arguments.quiet, arguments.json)?;
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
    };
    let lengths = loops.list().iter().map(|found| found.vertices.len());

    // Refuse bad options before the search, which can take minutes.
    let most = mesh.triangle_count().saturating_add(lengths.sum::<usize>() as u32);
    making.check(&mesh, most)?;
    making.open()?;
    let listed = listed(&loops, &mesh);
    let result = making
        .work(|progress| fill(mesh, &loops, &options, progress))
        .map_err(|error| Failure::Input(format!("{}: {error}", file.display())))?;
    if result.filled.is_empty() {
        let reasons: Vec<String> = left(&result, &loops)
            .map(|left| format!("{} stays open: {}", left.name.text(), left.reason))
            .collect();
        let message = if reasons.len() > 5 { listed } else { format!(": {}", reasons.join("; ")) };
        let name = file.display();
        return Err(Failure::Input(format!("{name} has no loop to fill{message}")));
    }
    for found in &result.filled {
        new_triangles_met(arguments.target_angle, &result.mesh, &found.triangles, found.min_angle)?;
    }
    let made = making.write_checked(&result.mesh)?;
    let summary = || Summary {
        file: file.display().to_string(),
        vertices: result.mesh.positions().len(),
        triangles: result.mesh.triangles().len(),
        max_degree: result.max_degree,
        filled: result.filled.iter().map(|found| summary(found, &loops)).collect(),
        left_open: left(&result, &loops).collect(),
        crossings: &result.crossings,
    };
    made.say(|| text(file, &result, &loops, &options), summary)
}

fn summary(found: &FilledLoop, loops: &Loops) -> FilledSummary {
    FilledSummary {
        name: LoopName::new(found.index, &loops.list()[found.index]),
        limit: found.limit,
        max_degree: found.max_degree,
        area: found.area,
        area_without_limit: found.without_limit.0,
        least_limit: found.least_limit.map(|(limit, _)| limit),
        area_at_least_limit: found.least_limit.map(|(_, area)| area),
        degree_without_limit: found.without_limit.1,
        min_angle: found.min_angle,
        triangles: [found.triangles.start, found.triangles.end],
    }
}

fn left<'a>(result: &'a Filled, loops: &'a Loops) -> impl Iterator<Item = LeftSummary> + 'a {
    result.left.iter().map(|left| LeftSummary {
        name: LoopName::new(left.index, &loops.list()[left.index]),
        reason: left.reason.to_string(),
    })
}

/// How many loops a summary describes one by one.
const DESCRIBED: usize = 8;

fn text(file: &Path, result: &Filled, loops: &Loops, options: &FillOptions) -> String {
    let (filled, open) = (result.filled.len(), result.left.len());
    let triangles: usize = result.filled.iter().map(|found| found.triangles.len()).sum();
    let largest = result.filled.iter().map(|found| found.max_degree).max().unwrap_or(0);
    let angle = result.filled.iter().map(|found| found.min_angle).fold(f64::INFINITY, f64::min);
    let plural = if filled == 1 { "loop" } else { "loops" };
    let mut text = format!(
        "{}: filled {filled} {plural} with {triangles} triangles; maximum degree on them {largest}, \
         minimum angle {}",
        file.display(),
        steady_angle(angle),
    );
    for found in result.filled.iter().take(DESCRIBED) {
        let name = LoopName::new(found.index, &loops.list()[found.index]).text();
        let limit = match (options.max_degree, found.least_limit) {
            (None, Some(_)) => format!(
                "degree limit {}, the least that takes at most {} more area than no limit",
                found.limit,
                percent(options.extra_area)
            ),
            (None, None) if found.limit > FIRST_LIMIT => {
                format!("degree limit {}, the least that is possible", found.limit)
            }
            _ => format!("degree limit {}", found.limit),
        };
        let (least, degree) = found.without_limit;
        let more = (found.area / least - 1.0).max(0.0);
        let cost = if degree == found.max_degree && found.area <= least || least == 0.0 {
            "the least without a limit, too".to_owned()
        } else if more == 0.0 {
            format!("as little as without a limit, where the degree is {degree}")
        } else {
            format!("{} more than without a limit, where the degree is {degree}", percent(more))
        };
        text += &format!("\n  {name}: {limit}; area {}, {cost}", four_digits(found.area));
        if let Some((limit, area)) = found.least_limit {
            let more = percent((area / least - 1.0).max(0.0));
            text += &format!("; --max-degree {limit} takes {more} more");
        }
    }
    if filled > DESCRIBED {
        text += &format!("\n  and {} more", filled - DESCRIBED);
    }
    for left in left(result, loops).take(DESCRIBED) {
        text += &format!("\n  {} stays open: {}", left.name.text(), left.reason);
    }
    if open > DESCRIBED {
        text += &format!("\n  and {} more stay open", open - DESCRIBED);
    }
    text += &crossing_text(&result.crossings);
    text
}
