//! `mindeg suggest`: which interval counts to change, and by how little.

use crate::args::SuggestArguments;
use crate::degree::lifting;
use crate::domain::{Counted, counted, counts_of};
use crate::failure::Failure;
use crate::standard_output::{print, print_json};
use mindeg_answers::limit::{LiftAnswer, Lifting};
use mindeg_answers::suggest::{SuggestAnswer, SuggestedChange, in_words};
use mindeg_core::{Boundary, Suggestion, least_max_degree, suggest, suggestions};

pub(crate) fn run(arguments: &SuggestArguments) -> Result<(), Failure> {
    let (intervals, domain) = match counted(&arguments.counts)? {
        Counted::Counts(counts) => (counts, None),
        Counted::Domain(domain) => (counts_of(&domain)?, Some(domain)),
    };
    let boundary = Boundary::new(&intervals).map_err(Failure::input)?;
    let today = least_max_degree(&boundary);
    let all: Vec<Suggestion> = match arguments.max_degree {
        None => suggestions(&boundary).collect(),
        Some(limit) => vec![suggest(&boundary, limit).ok_or_else(|| {
            Failure::Input(format!(
                "no counts on {} sides have a least maximum degree of {limit} or less",
                boundary.side_count()
            ))
        })?],
    };
    let lifting = domain.and_then(|domain| lifting(&domain, None, usize::MAX));
    let shown = spread(all.len(), arguments.limit, None);
    let rows: Vec<&Suggestion> = shown.into_iter().map(|row| &all[row]).collect();
    if arguments.json {
        return print_json(&SuggestAnswer {
            least_max_degree: today,
            suggestion_count: all.len(),
            suggestions: rows.iter().map(|row| SuggestedChange::new(row, &boundary)).collect(),
            intervals,
            limit: lifting.as_ref().map(Lifting::answer),
            angle_suggestions: lifting
                .iter()
                .flat_map(|it| &it.steps)
                .map(LiftAnswer::from)
                .collect(),
        });
    }
    let mut text = format!("The least maximum degree is {today}.\n");
    if rows.is_empty() {
        text.push_str("No change of counts brings it down.\n");
    }
    for row in &rows {
        text.push_str(&if row.changes.is_empty() {
            "No change is needed.\n".to_owned()
        } else {
            let counts: Vec<String> = row.intervals(&boundary).iter().map(u64::to_string).collect();
            let counts = counts.join(",");
            format!("For {}: {}, giving {counts}.\n", row.max_degree, in_words(row))
        });
    }
    text.push_str(&left_out(rows.len(), all.len()));
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
