//! `mindeg suggest`: which interval counts to change, and by how little.

use crate::args::SuggestArguments;
use crate::failure::Failure;
use crate::standard_output::{print, print_json};
use mindeg_core::{Boundary, Change, Suggestion, least_max_degree, suggest, suggestions};
use serde::Serialize;

/// What `--json` prints; sides count from 0 like the lists of intervals.
#[derive(Serialize)]
struct Answer<'a> {
    intervals: &'a [u64],
    max_degree: u32,
    suggestions: Vec<Row>,
}

#[derive(Serialize)]
struct Row {
    max_degree: u32,
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
    let intervals = &arguments.intervals.0;
    let boundary = Boundary::new(intervals).map_err(|error| Failure::Input(error.to_string()))?;
    let today = least_max_degree(&boundary);
    let rows: Vec<Suggestion> = match arguments.target {
        None => suggestions(&boundary).collect(),
        Some(target) => vec![suggest(&boundary, target).ok_or_else(|| {
            Failure::Input(format!(
                "no counts on {} sides have a least maximum degree of {target} or less",
                boundary.side_count()
            ))
        })?],
    };
    if arguments.json {
        let row = |suggestion: Suggestion| Row {
            max_degree: suggestion.max_degree,
            cost: suggestion.cost(),
            intervals: suggestion.intervals(&boundary),
            changes: suggestion
                .changes
                .iter()
                .map(|&Change { side, by }| SideChange { side, by })
                .collect(),
        };
        let suggestions = rows.into_iter().map(row).collect();
        return print_json(&Answer { intervals, max_degree: today, suggestions });
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
            format!("For {}: {}, giving {}.\n", row.max_degree, in_words(row), counts.join(","))
        });
    }
    print(&text)
}

/// Such as "add 7 to side 2 and take 1 from side 4".
pub(crate) fn in_words(suggestion: &Suggestion) -> String {
    let change = |&Change { side, by }: &Change| {
        let (count, side) = (by.unsigned_abs(), side + 1);
        if by > 0 {
            format!("add {count} to side {side}")
        } else {
            format!("take {count} from side {side}")
        }
    };
    suggestion.changes.iter().map(change).collect::<Vec<_>>().join(" and ")
}
