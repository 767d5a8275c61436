//! `mindeg bridge`: two boundary loops joined by a strip.

use crate::args::{BridgeArguments, LoopChoice};
use crate::boundary_loops::{index_of, listed};
use crate::demands::new_triangles_met;
use crate::failure::Failure;
use crate::making::Making;
use mindeg::bridge::{BridgeOptions, bridge};
use mindeg::{Loops, TriMesh};
use mindeg_answers::loops::{BridgeAnswer, LoopName};
use std::path::Path;

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
    let mut making = Making::new(&arguments.surface, arguments.quiet, arguments.json)?;
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
            check(&mut making, &whole.map_err(Failure::input)?)?;
        }
        None => check(&mut making, &mesh)?,
    }
    making.open()?;
    let other = second.as_ref().map(|side| (&side.mesh, &side.loops));
    let both = (mesh, &loops);
    let options = BridgeOptions { max_degree: arguments.max_degree, interior: arguments.interior };
    let result = making
        .work(|progress| bridge(both, other, [from, to], &options, progress))
        .map_err(Failure::input)?;
    let (angle, strip) = (result.min_angle, &result.triangles);
    new_triangles_met(arguments.target_angle, &result.mesh, strip, angle)?;
    let made = making.write_checked(&result.mesh)?;
    let answer = BridgeAnswer::of(&result, from_name, to_name);
    made.say(|| answer.text(), || &answer)
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
