//! `mindeg bridge`: two boundary loops joined by a strip.

use crate::args::{BridgeArguments, LoopChoice};
use crate::boundary_loops::{LoopName, crossing_text, index_of, listed};
use crate::demands::new_triangles_met;
use crate::failure::Failure;
use crate::making::Making;
use mindeg::bridge::{Bridged, bridge};
use mindeg::{Loops, TriMesh};
use mindeg_answers::numbers::steady_angle;
use serde::Serialize;
use std::path::Path;

/// The output of `--json`; angles in degrees.
#[derive(Serialize)]
struct Summary<'a> {
    from: &'a LoopName,
    to: &'a LoopName,
    vertices: usize,
    triangles: usize,
    /// The first triangle of the strip, and the one after the last.
    strip: [u32; 2],
    max_degree: u32,
    least_max_degree: u32,
    at_least: u32,
    min_angle: f64,
    /// The minimum angle with one degree more; null if that is not better.
    next_min_angle: Option<f64>,
    angle_without_limit: f64,
    degree_without_limit: u32,
    planar: bool,
    crossings: &'a [[u32; 2]],
}

/// A mesh that was read, and its loops.
struct Side<'a> {
    path: &'a Path,
    mesh: TriMesh,
    loops: Loops,
}

impl<'a> Side<'a> {
    fn read(path: &'a Path, making: &mut Making) -> Result<Self, Failure> {
        let mesh = making.read(path)?;
        let loops = Loops::of(&mesh);
        Ok(Self { path, mesh, loops })
    }

    /// The loop that is meant by an option; without one, the only one there is.
    fn index(&self, choice: Option<LoopChoice>, option: &str) -> Result<usize, Failure> {
        match (choice, self.loops.list()) {
            (Some(choice), _) => index_of(choice, &self.loops, &self.mesh, self.path),
            (None, [_]) => Ok(0),
            (None, []) => Err(Failure::Input(format!(
                "{} has no boundary loop; it is closed",
                self.path.display()
            ))),
            (None, all) => Err(Failure::Input(format!(
                "{} has {} boundary loops; name one with {option}{}",
                self.path.display(),
                all.len(),
                listed(&self.loops, &self.mesh)
            ))),
        }
    }

    fn name(&self, index: usize) -> LoopName {
        LoopName::new(index, &self.loops.list()[index])
    }
}

pub(crate) fn run(arguments: &BridgeArguments) -> Result<(), Failure> {
    let surface = &arguments.surface;
    let mut making = Making::new(surface, &surface.output, arguments.quiet, arguments.json)?;
    let first = Side::read(&arguments.file, &mut making)?;
    let second = match &arguments.other {
        Some(path) => Some(Side::read(path, &mut making)?),
        None => None,
    };
    let (from, to) = match &second {
        Some(second) => {
            (first.index(arguments.from, "--from")?, second.index(arguments.to, "--to")?)
        }
        None => both_of_one(&first, arguments)?,
    };
    let (from_name, to_name) = (first.name(from), second.as_ref().unwrap_or(&first).name(to));
    let Side { mesh, loops, .. } = first;
    // Refuse bad options before the search.
    let check = |making: &mut Making, whole: &TriMesh| {
        let most = whole.triangles().len().saturating_add(whole.positions().len());
        making.check(whole, u32::try_from(most).unwrap_or(u32::MAX))
    };
    match &second {
        Some(second) => {
            let whole = mesh.clone().with_mesh_added(&second.mesh);
            check(&mut making, &whole.map_err(|error| Failure::Input(error.to_string()))?)?;
        }
        None => check(&mut making, &mesh)?,
    }
    making.open()?;
    let other = second.as_ref().map(|side| (&side.mesh, &side.loops));
    let both = (mesh, &loops);
    let result = making
        .work(|progress| bridge(both, other, [from, to], arguments.max_degree, progress))
        .map_err(|error| Failure::Input(error.to_string()))?;
    let (angle, strip) = (result.min_angle, &result.triangles);
    new_triangles_met(arguments.target_angle, &result.mesh, strip, angle)?;
    let made = making.write_checked(&result.mesh)?;
    let strip = &result.strip;
    let text = || text(&result, &from_name, &to_name);
    made.say(text, || Summary {
        from: &from_name,
        to: &to_name,
        vertices: result.mesh.positions().len(),
        triangles: result.mesh.triangles().len(),
        strip: [result.triangles.start, result.triangles.end],
        max_degree: strip.max_degree,
        least_max_degree: strip.least_max_degree,
        at_least: strip.lower_bound,
        min_angle: result.min_angle,
        next_min_angle: strip.next_min_angle,
        angle_without_limit: strip.without_limit.0,
        degree_without_limit: strip.without_limit.1,
        planar: strip.is_planar,
        crossings: &result.crossings,
    })
}

/// Two loops of one mesh: those that are named, or the only two.
fn both_of_one(side: &Side<'_>, arguments: &BridgeArguments) -> Result<(usize, usize), Failure> {
    match (arguments.from, arguments.to, side.loops.list()) {
        (None, None, [_, _]) => Ok((0, 1)),
        (Some(choice), None, [_, _]) => {
            let from = side.index(Some(choice), "--from")?;
            Ok((from, 1 - from))
        }
        (None, Some(choice), [_, _]) => {
            let to = side.index(Some(choice), "--to")?;
            Ok((1 - to, to))
        }
        (_, _, all @ ([] | [_])) => Err(Failure::Input(format!(
            "{} has {} boundary loop{}; a bridge takes two: give a second mesh",
            side.path.display(),
            all.len(),
            if all.len() == 1 { "" } else { "s" }
        ))),
        (from, to, _) => Ok((side.index(from, "--from")?, side.index(to, "--to")?)),
    }
}

fn text(result: &Bridged, from: &LoopName, to: &LoopName) -> String {
    let strip = &result.strip;
    let optimal = match (strip.max_degree, strip.least_max_degree, strip.lower_bound) {
        (degree, least, bound) if degree == least && least == bound => {
            "the least possible, as counting proves".to_owned()
        }
        (degree, least, _) if degree == least => "the least possible, found by search".to_owned(),
        (_, least, _) => format!("the least possible is {least}"),
    };
    let mut text = format!(
        "joined {} and {} with {} triangles: maximum degree on them {} ({optimal}), minimum angle {}, the \
         largest for this degree",
        from.text(),
        to.text(),
        result.triangles.len(),
        strip.max_degree,
        steady_angle(result.min_angle),
    );
    if let Some(next) = strip.next_min_angle {
        text += &format!(
            "\nhint: --max-degree {} gives a minimum angle of {}",
            strip.max_degree + 1,
            steady_angle(next)
        );
    }
    if let Some(turned) = result.turned_over {
        text += &format!(
            "\nwarning: the strip is twisted; if the triangles of the second mesh were turned over, \
             its minimum angle would be {}",
            steady_angle(turned)
        );
    }
    text += &crossing_text(&result.crossings);
    text
}
