//! How large the minimum angle can be with interior points, and which changes of counts lift it.

use crate::numbers::steady_angle;
use mindeg::interior::{AngleLimit, InteriorError, Lift, angle_limit, lift};
use mindeg::{Domain, Interior};
use serde::Serialize;

/// The most changes one after another.
const MOST_STEPS: usize = 6;

/// From this limit on no change is suggested.
const ENOUGH: f64 = 30.0;

/// A domain's limit, with changes of counts that lift it.
#[derive(Debug)]
pub struct Lifting {
    /// The limit.
    pub limit: AngleLimit,
    /// The changes, each on top of the one before.
    pub steps: Vec<Lift>,
}

/// The limit of the minimum angle, and the change that lifts it; angles are in degrees.
#[derive(Clone, Debug, Serialize)]
pub struct LimitAnswer {
    /// The largest minimum angle that the boundary allows, at its degree limits.
    pub angle_limit: f64,
    /// The position that decides it, in words.
    pub cause: String,
    /// The largest at any degree.
    pub angle_limit_at_any_degree: f64,
    /// The position that decides that.
    pub cause_at_any_degree: String,
    /// The smallest change of counts that lifts the limit; null if no change at one position does.
    pub lift: Option<LiftAnswer>,
}

/// A change of counts, and the limit after it.
#[derive(Clone, Debug, Serialize)]
pub struct LiftAnswer {
    /// The sides that change.
    pub changes: Vec<SideCount>,
    /// The limit after the change.
    pub angle_limit: f64,
    /// The position that decides it then.
    pub cause: String,
}

/// The intervals of a side after a change; sides count from 1, through all rings.
#[derive(Clone, Debug, Serialize)]
pub struct SideCount {
    side: usize,
    by: i64,
    intervals: u64,
}

impl Lifting {
    /// The limit of a domain for what is wanted inside, and up to `steps` changes.
    ///
    /// # Errors
    ///
    /// The errors of [`angle_limit`].
    pub fn of(domain: &Domain, wanted: &Interior, steps: usize) -> Result<Self, InteriorError> {
        Self::from_limit(domain, wanted, angle_limit(domain, wanted)?, steps)
    }

    /// The same where the limit is known already.
    ///
    /// # Errors
    ///
    /// The errors of [`angle_limit`].
    pub fn from_limit(
        domain: &Domain,
        wanted: &Interior,
        limit: AngleLimit,
        steps: usize,
    ) -> Result<Self, InteriorError> {
        let mut found: Vec<Lift> = Vec::new();
        while found.len() < steps.min(MOST_STEPS) {
            let (domain, limit) = match found.last() {
                Some(last) => (&last.domain, angle_limit(&last.domain, wanted)?),
                None => (domain, limit.clone()),
            };
            if limit.min_angle >= ENOUGH && !found.is_empty() {
                break;
            }
            let Some(next) = lift(domain, wanted, &limit) else { break };
            found.push(next);
        }
        Ok(Self { limit, steps: found })
    }

    /// The answer as JSON gives it.
    #[must_use]
    pub fn answer(&self) -> LimitAnswer {
        LimitAnswer {
            angle_limit: self.limit.min_angle,
            cause: self.limit.cause.to_string(),
            angle_limit_at_any_degree: self.limit.min_angle_at_any_degree,
            cause_at_any_degree: self.limit.cause_at_any_degree.to_string(),
            lift: self.steps.first().map(LiftAnswer::from),
        }
    }

    /// The limit in a sentence, and in another the change that lifts it.
    #[must_use]
    pub fn text(&self) -> String {
        let AngleLimit { min_angle, min_angle_at_any_degree: any, cause, .. } = &self.limit;
        let at_any = if *any > min_angle * 1.001 {
            format!(" within the degree limits ({} at any degree)", steady_angle(*any))
        } else {
            String::new()
        };
        let lifted = self.steps.first().map_or_else(String::new, |lift| {
            format!(" With {} it would be {}.", lift_counts(lift), steady_angle(lift.min_angle))
        });
        format!(
            "The boundary allows a minimum angle of at most {}{at_any}, decided by {cause}.{lifted}",
            steady_angle(*min_angle),
        )
    }

    /// The changes one by one, a line each.
    #[must_use]
    pub fn steps_in_words(&self) -> String {
        let limit = steady_angle(self.limit.min_angle);
        let mut text = format!(
            "With interior points the minimum angle is at most {limit}, decided by {}.\n",
            self.limit.cause
        );
        for (index, step) in self.steps.iter().enumerate() {
            let then = if index == 0 { "" } else { "then " };
            let (angle, counts) = (steady_angle(step.min_angle), lift_counts(step));
            text.push_str(&format!("For {angle}: {then}give {counts}.\n"));
        }
        text
    }
}

impl From<&Lift> for LiftAnswer {
    fn from(lift: &Lift) -> Self {
        let changes = lift.changes.iter().zip(&lift.intervals).map(|(change, &intervals)| {
            SideCount { side: change.side + 1, by: change.by, intervals }
        });
        let changes = changes.collect();
        Self { changes, angle_limit: lift.min_angle, cause: lift.cause.to_string() }
    }
}

/// A change in words: "9 intervals on side 2".
#[must_use]
pub fn lift_counts(lift: &Lift) -> String {
    let changes = lift.changes.iter().zip(&lift.intervals).map(|(change, count)| {
        let intervals = if *count == 1 { "interval" } else { "intervals" };
        format!("{count} {intervals} on {}", lift.domain.side_in_text(change.side))
    });
    changes.collect::<Vec<_>>().join(" and ")
}
