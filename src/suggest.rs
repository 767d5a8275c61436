//! `mindeg suggest`: which interval counts to change, and by how little.

use crate::args::SuggestArguments;
use crate::bar::Bar;
use crate::degree::lifting;
use crate::domain::{Counted, counted};
use crate::failure::Failure;
use crate::standard_output::{print, print_json};
use mindeg_answers::limit::{LiftAnswer, Lifting};
use mindeg_answers::suggest::SuggestAnswer;
use mindeg_core::Boundary;
use mindeg_files::Wanted;

pub(crate) fn run(arguments: &SuggestArguments) -> Result<(), Failure> {
    let wanted = arguments.max_degree;
    let (mut answer, lifting) = match counted(&arguments.counts, Wanted::Domain)? {
        Counted::Counts(counts) => {
            let boundary = Boundary::new(&counts).map_err(Failure::input)?;
            (SuggestAnswer::of_counts(&boundary, wanted).map_err(Failure::input)?, None)
        }
        Counted::Subject(subject) => {
            let domain = subject.only()?;
            let bar = Bar::new(arguments.json);
            let found = bar.work(|progress| SuggestAnswer::of(&domain, wanted, progress));
            (found.map_err(Failure::input)?, lifting(&domain, None, usize::MAX))
        }
    };
    let shown = spread(answer.suggestions.len(), arguments.limit, None);
    answer.suggestions = shown.into_iter().map(|row| answer.suggestions[row].clone()).collect();
    if arguments.json {
        answer.limit = lifting.as_ref().map(Lifting::answer);
        let steps = lifting.iter().flat_map(|lifting| &lifting.steps);
        answer.angle_suggestions = steps.map(LiftAnswer::from).collect();
        return print_json(&answer);
    }
    let mut text = answer.text();
    text.push_str(&left_out(answer.suggestions.len(), answer.suggestion_count));
    text.extend(lifting.as_ref().map(Lifting::steps_in_words));
    print(&text)
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
