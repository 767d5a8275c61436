//! Changes of interval counts that bring the least maximum degree down.

use crate::limit::{LiftAnswer, LimitAnswer};
use mindeg_core::{Boundary, Change, Suggestion};
use serde::Serialize;

/// The suggestions for a boundary; sides count from 1.
#[derive(Clone, Debug, Serialize)]
pub struct SuggestAnswer {
    /// The intervals of each side.
    pub intervals: Vec<u64>,
    /// The least maximum degree with these.
    pub least_max_degree: u32,
    /// The number of suggestions, of which some may be left out.
    pub suggestion_count: usize,
    /// The suggestions.
    pub suggestions: Vec<SuggestedChange>,
    /// The limit of the minimum angle with interior points; only for a domain.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit: Option<LimitAnswer>,
    /// Changes that lift the limit, each on top of the one before.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub angle_suggestions: Vec<LiftAnswer>,
}

/// A change of counts, and the degree after it.
#[derive(Clone, Debug, Serialize)]
pub struct SuggestedChange {
    least_max_degree: u32,
    /// Intervals added or taken away in all.
    cost: u64,
    changes: Vec<ChangedSide>,
    /// The counts after the changes.
    intervals: Vec<u64>,
}

#[derive(Clone, Debug, Serialize)]
struct ChangedSide {
    side: usize,
    by: i64,
}

impl SuggestedChange {
    /// A suggestion for a boundary.
    #[must_use]
    pub fn new(suggestion: &Suggestion, boundary: &Boundary) -> Self {
        let changed = |&Change { side, by }: &Change| ChangedSide { side: side + 1, by };
        Self {
            least_max_degree: suggestion.max_degree,
            cost: suggestion.cost(),
            intervals: suggestion.intervals(boundary),
            changes: suggestion.changes.iter().map(changed).collect(),
        }
    }
}

/// A suggestion in words, such as "add 7 to side 2 and take 1 from side 4".
#[must_use]
pub fn in_words(suggestion: &Suggestion) -> String {
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
