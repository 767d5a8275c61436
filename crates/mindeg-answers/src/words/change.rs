//! Changes of interval counts, and the limit of the minimum angle that they lift.

use mindeg::interior::{AngleLimit, Lift};
use mindeg_core::{Change, Suggestion};

use crate::numbers::steady_angle;

/// Such as "add 7 to side 2 and take 1 from side 4".
#[must_use]
pub fn suggestion(suggestion: &Suggestion) -> String {
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

/// The limit in a sentence, and in another what would lift it.
#[must_use]
pub fn limit(limit: &AngleLimit, lift: Option<&Lift>) -> String {
    let AngleLimit { min_angle, min_angle_at_any_degree: any, .. } = limit;
    let at_any = if any > &(min_angle * 1.001) {
        format!(" within the degree limits ({} at any degree)", steady_angle(*any))
    } else {
        String::new()
    };
    let lifted = lift.map_or_else(String::new, |lift| {
        format!(" With {} it would be {}.", lift_counts(lift), steady_angle(lift.min_angle))
    });
    format!(
        "The boundary allows a minimum angle of at most {}{at_any}, decided by {}.{lifted}",
        steady_angle(*min_angle),
        limit.cause
    )
}

/// Such as "9 intervals on side 2".
#[must_use]
pub fn lift_counts(lift: &Lift) -> String {
    let change = |(change, count): (&Change, &u64)| {
        let intervals = if *count == 1 { "interval" } else { "intervals" };
        format!("{count} {intervals} on {}", lift.domain.side_name(change.side))
    };
    let changes: Vec<_> = lift.changes.iter().zip(&lift.intervals).map(change).collect();
    changes.join(" and ")
}
