//! `mindeg suggest`: which interval counts to change, and by how little.

use crate::angle_limit::Lifting;
use crate::args::SuggestArguments;
use crate::domain::counts;
use crate::failure::Failure;
use crate::interior_report::{LiftRow, Limit};
use crate::standard_output::{print, print_json};
use mindeg_answers::words;
use mindeg_core::{Boundary, Change, Suggestion, least_max_degree, suggest, suggestions};
use serde::Serialize;

/// What `--json` prints; sides count from 1, as in the text.
#[derive(Serialize)]
struct Answer<'a> {
    intervals: &'a [u64],
    least_max_degree: u32,
    /// Of all suggestions, of which `--limit` leaves some out.
    suggestion_count: usize,
    suggestions: Vec<Row>,
    /// The limit of the minimum angle with interior points, and changes that lift it, each on top of
    /// the one before; only for a domain.
    #[serde(skip_serializing_if = "Option::is_none")]
    angle_limit: Option<Limit>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    angle_suggestions: Vec<LiftRow>,
}

#[derive(Serialize)]
struct Row {
    least_max_degree: u32,
    /// Intervals added or taken away in all.
    cost: u64,
    changes: Vec<SideChange>,
    /// The counts after the changes.
    intervals: Vec<u64>,
}

#[derive(Serialize)]
struct SideChange {
    side: usize,
    by: i64,
}

pub(crate) fn run(arguments: &SuggestArguments) -> Result<(), Failure> {
    let (intervals, domain) = &counts(&arguments.counts, &arguments.file)?;
    let boundary = Boundary::new(intervals).map_err(|error| Failure::Input(error.to_string()))?;
    let today = least_max_degree(&boundary);
    let rows: Vec<Suggestion> = match arguments.max_degree {
        None => suggestions(&boundary).collect(),
        Some(target) => vec![suggest(&boundary, target).ok_or_else(|| {
            Failure::Input(format!(
                "no counts on {} sides have a least maximum degree of {target} or less",
                boundary.side_count()
            ))
        })?],
    };
    let lifting = domain.as_ref().and_then(|domain| Lifting::of(domain, None, usize::MAX));
    let suggestion_count = rows.len();
    let shown = spread(suggestion_count, arguments.limit, None);
    let rows: Vec<Suggestion> = shown.into_iter().map(|row| rows[row].clone()).collect();
    if arguments.json {
        let row = |suggestion: Suggestion| Row {
            least_max_degree: suggestion.max_degree,
            cost: suggestion.cost(),
            intervals: suggestion.intervals(&boundary),
            changes: suggestion
                .changes
                .iter()
                .map(|&Change { side, by }| SideChange { side: side + 1, by })
                .collect(),
        };
        let suggestions = rows.into_iter().map(row).collect();
        return print_json(&Answer {
            intervals,
            least_max_degree: today,
            suggestion_count,
            suggestions,
            angle_limit: lifting.as_ref().map(Lifting::json),
            angle_suggestions: lifting.as_ref().map_or_else(Vec::new, Lifting::rows),
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
            format!(
                "For {}: {}, giving {}.\n",
                row.max_degree,
                words::suggestion(row),
                counts.join(",")
            )
        });
    }
    text.push_str(&left_out(rows.len(), suggestion_count));
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
    // One row is kept for the one more, which may be among the others.
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
