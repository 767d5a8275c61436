//! `mindeg suggest`: which interval counts to change, and by how little.

use crate::args::SuggestArguments;
use crate::bar::Bar;
use crate::degree::lifting;
use crate::domain::{Counted, Parts, Subject, counted};
use crate::failure::Failure;
use crate::mesh::model;
use crate::standard_output::{print, print_json};
use mindeg::beside::each;
use mindeg::{MeshError, Model};
use mindeg_answers::limit::{LiftAnswer, Lifting};
use mindeg_answers::suggest::{SuggestAnswer, SuggestBeside, SuggestPart};
use mindeg_core::Boundary;
use mindeg_files::Wanted;

pub(crate) fn run(arguments: &SuggestArguments) -> Result<(), Failure> {
    let (file, options) = (arguments.counts.path(), &arguments.counts.options);
    match counted(&arguments.counts, Wanted::Model)? {
        Counted::Counts(counts) => {
            let boundary = Boundary::new(&counts).map_err(Failure::input)?;
            let answer = SuggestAnswer::of_counts(&boundary, arguments.max_degree);
            show(arguments, &mut answer.map_err(Failure::input)?, None)
        }
        Counted::Subject(Subject::Model(found)) => {
            of_model(arguments, &model::divided(*found, file, options)?)
        }
        Counted::Subject(Subject::Mesh(mesh)) => {
            of_model(arguments, &model::of_mesh(&mesh, file, options, &arguments.model)?)
        }
        Counted::Subject(subject) => of_parts(arguments, &subject.parts()?),
    }
}

/// The changes for a whole model.
fn of_model(arguments: &SuggestArguments, found: &Model) -> Result<(), Failure> {
    let SuggestArguments { max_degree, model: of_model, .. } = arguments;
    let bar = Bar::new(arguments.json);
    let answer =
        bar.work(|progress| SuggestAnswer::of_model(found, *max_degree, of_model.effort, progress));
    let answer = answer.map_err(|error| model::bad(arguments.counts.path(), &error));
    drop(bar);
    show(arguments, &mut answer?, None)
}

/// The changes for a domain, or for each of several.
fn of_parts(arguments: &SuggestArguments, parts: &Parts) -> Result<(), Failure> {
    let (wanted, effort) = (arguments.max_degree, arguments.model.effort);
    let bar = Bar::new(arguments.json);
    let found = bar.work(|progress| {
        each(&parts.domains, "trying other counts", progress, |domain, progress| {
            let mut answer = SuggestAnswer::of(domain, wanted, effort, progress)?;
            let lifting = lifting(domain, None, usize::MAX);
            answer.limit = lifting.as_ref().map(Lifting::answer);
            let steps = lifting.iter().flat_map(|lifting| &lifting.steps);
            answer.angle_suggestions = steps.map(LiftAnswer::from).collect();
            Ok::<_, MeshError>((answer, lifting.map(|lifting| lifting.steps_in_words())))
        })
    });
    let found = found.map_err(|(index, error)| parts.failure((index, Failure::input(error))))?;
    drop(bar);
    let (mut answers, mut steps): (Vec<_>, Vec<_>) = found.into_iter().unzip();
    if let [answer] = &mut answers[..] {
        return show(arguments, answer, steps.pop().flatten());
    }
    answers.iter_mut().for_each(|answer| shorten(answer, arguments.limit));
    let answer = SuggestBeside::of(&parts.domains, answers);
    if arguments.json {
        return print_json(&answer);
    }
    let in_lines = |(part, steps): (&SuggestPart, _)| {
        format!("\n{}: {}", part.part, text(&part.answer, steps))
    };
    print(&(answer.text() + &answer.parts.iter().zip(steps).map(in_lines).collect::<String>()))
}

/// Prints the only answer; `steps` lift the limit of the angle.
fn show(
    arguments: &SuggestArguments,
    answer: &mut SuggestAnswer,
    steps: Option<String>,
) -> Result<(), Failure> {
    shorten(answer, arguments.limit);
    if arguments.json { print_json(answer) } else { print(&text(answer, steps)) }
}

fn text(answer: &SuggestAnswer, steps: Option<String>) -> String {
    let left_out = left_out(answer.suggestions.len(), answer.suggestion_count);
    answer.text() + &left_out + &steps.unwrap_or_default()
}

/// Leaves at most `limit` rows, all of them if it is 0.
fn shorten(answer: &mut SuggestAnswer, limit: u32) {
    let kept = spread(answer.suggestions.len(), limit, None);
    answer.suggestions = kept.into_iter().map(|row| answer.suggestions[row].clone()).collect();
}

/// At most `limit` rows of `count`, all of them if it is 0: the first, the last, `one_more`, and
/// others spread evenly between.
pub(crate) fn spread(count: usize, limit: u32, one_more: Option<usize>) -> Vec<usize> {
    let limit = if limit == 0 { usize::MAX } else { limit as usize };
    if count <= limit {
        return (0..count).collect();
    }
    // Keep one row for `one_more`, which may be among the others.
    let even = limit - usize::from(one_more.is_some());
    let step = |row| if even < 2 { 0 } else { row * (count - 1) / (even - 1) };
    let mut rows: Vec<usize> = (0..even).map(step).chain(one_more).collect();
    rows.sort_unstable();
    rows.dedup();
    rows
}

/// A line that says what `--limit` leaves out.
pub(crate) fn left_out(shown: usize, count: usize) -> String {
    if shown == count {
        return String::new();
    }
    format!("{shown} of {count} rows, spread evenly; --limit 0 prints all.\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_spread_from_the_first_to_the_last() {
        for (count, limit, one_more, rows) in [
            (3, 5, None, &[0, 1, 2][..]),
            (3, 0, Some(1), &[0, 1, 2]),
            (101, 5, None, &[0, 25, 50, 75, 100]),
            (101, 4, Some(7), &[0, 7, 50, 100]),
            (101, 4, Some(50), &[0, 50, 100]),
            (101, 1, None, &[0]),
            (101, 1, Some(7), &[7]),
            (0, 5, None, &[]),
        ] {
            assert_eq!(spread(count, limit, one_more), rows, "{count} {limit} {one_more:?}");
        }
    }
}
