//! `mindeg condition`: a boundary that lets a mesh reach an angle.

use crate::args::{ConditionArguments, Length, OutlineOptions};
use crate::bar::Bar;
use crate::domain::{describe, name, opened};
use crate::failure::Failure;
use crate::interrupt::clean_up_on_interrupt;
use crate::standard_output::{print, print_json};
use mindeg::interior::{BoundaryDemands, condition};
use mindeg_answers::condition::ConditionAnswer;
use mindeg_files::{Wanted, is_standard_output};

/// The growth of lengths where a length is given: at this one the search reaches the limits nearly everywhere.
const GROWTH: f64 = 0.4;

/// How far the boundary may move where only a length is given, as a share of it: less than a mesh of that length shows.
const WITHIN: f64 = 0.125;

pub(crate) fn run(arguments: &ConditionArguments) -> Result<(), Failure> {
    clean_up_on_interrupt()?;
    let bar = Bar::new(arguments.quiet);
    let ConditionArguments { within, size, least_island, .. } = *arguments;
    // Rings that touch themselves are changed here, too.
    let outline = OutlineOptions { mends: true, ..arguments.outline.clone() };
    let subject = opened(&arguments.file, &outline, None, Wanted::Domain, &bar)?;
    subject.refuse_degrees([
        ("--size", size),
        ("--within", within),
        ("--least-island", least_island),
    ])?;
    let domain = arguments.kinds.told(subject.only()?)?;
    let demands = BoundaryDemands {
        angle: arguments.limit,
        within: within
            .or(size.map(|it| Length { value: it.value * WITHIN, ..it }))
            .map_or(0.0, |it| it.value),
        size: size.map(|size| size.value),
        growth: arguments.growth.unwrap_or(arguments.size.map_or(0.0, |_| GROWTH)),
        least_hole: least_island.map_or(0.0, |least| least.value),
    };
    let found =
        bar.waiting("conditioning the boundary", || condition(&domain, &demands, &arguments.keep));
    let (new, conditioned) = found.map_err(Failure::input)?;
    drop(bar);
    let answer = ConditionAnswer::of(&domain, &new, &conditioned);
    let domain_file = arguments.output.as_deref().map(|path| (new.to_json(), path));
    let drawn = |path| (answer.drawn(&domain, &new).to_string(), path);
    let changes_file = arguments.changes.as_deref().map(drawn);
    let files: Vec<_> = changes_file.into_iter().chain(domain_file).collect();
    describe::write_texts(&files)?;
    if files.iter().any(|(_, path)| is_standard_output(path)) {
        return Ok(());
    }
    if arguments.json { print_json(&answer) } else { print(&answer.text(&name(&domain))) }
}
