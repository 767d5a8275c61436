//! `mindeg condition`: a boundary that lets a mesh reach an angle.

use crate::args::ConditionArguments;
use crate::bar::Bar;
use crate::domain::{describe, name, opened};
use crate::failure::Failure;
use crate::interrupt::clean_up_on_interrupt;
use crate::standard_output::{print, print_json};
use mindeg::Domain;
use mindeg::interior::{BoundaryDemands, condition};
use mindeg_answers::condition::ConditionAnswer;
use mindeg_answers::names::shown;
use mindeg_files::{Wanted, is_standard_output};

/// The growth of lengths where a length is given: at this one the search reaches the limits nearly everywhere.
const GROWTH: f64 = 0.4;

pub(crate) fn run(arguments: &ConditionArguments) -> Result<(), Failure> {
    clean_up_on_interrupt()?;
    let bar = Bar::new(arguments.quiet);
    let domain = opened(&arguments.file, &arguments.outline, None, Wanted::Domain, &bar)?.only()?;
    let kept = kept(&domain, &arguments.keep)?;
    let demands = BoundaryDemands {
        angle: arguments.limit,
        within: arguments.within.unwrap_or(0.0),
        size: arguments.size,
        growth: arguments.growth.unwrap_or(arguments.size.map_or(0.0, |_| GROWTH)),
        least_hole: arguments.least_island.unwrap_or(0.0),
    };
    let found = bar.waiting("conditioning the boundary", || condition(&domain, &demands, &kept));
    let (new, conditioned) = found.map_err(Failure::input)?;
    drop(bar);
    let answer = ConditionAnswer::of(&domain, &new, &conditioned);
    if let Some(path) = &arguments.output {
        describe::write(&new, path)?;
        if is_standard_output(path) {
            return Ok(());
        }
    }
    if arguments.json { print_json(&answer) } else { print(&answer.text(&name(&domain))) }
}

/// The indices of sides by their names.
fn kept(domain: &Domain, names: &[String]) -> Result<Vec<usize>, Failure> {
    let sides = 0..domain.sides().len();
    let mut kept = Vec::new();
    for wanted in names {
        let of_name: Vec<usize> =
            sides.clone().filter(|side| domain.side_name(*side) == *wanted).collect();
        if of_name.is_empty() {
            let all: Vec<String> =
                sides.clone().take(10).map(|side| domain.side_name(side)).collect();
            let more = if sides.len() > 10 { ", …" } else { "" };
            return Err(Failure::Input(format!(
                "--keep: the domain has no side {}; its sides are {}{more}",
                shown(wanted),
                shown(&all.join(", "))
            )));
        }
        kept.extend(of_name);
    }
    Ok(kept)
}
