//! The limit of the minimum angle with interior points, for `degree` and `suggest`.

use crate::interior_report::{LiftRow, Limit};
use mindeg::interior::{AngleLimit, Lift, angle_limit, lift};
use mindeg::{Domain, Interior};
use mindeg_answers::numbers::steady_angle;
use mindeg_answers::words;

/// On larger domains the limit is not worked out: it takes all points in memory.
const MOST_VERTICES: u32 = 1_000_000;

/// Changes one after another, at most so many.
const MOST_STEPS: usize = 6;

/// From this limit on no change is suggested.
const ENOUGH: f64 = 30.0;

/// A domain's limit, with the changes of counts that lift it.
pub(crate) struct Lifting {
    limit: AngleLimit,
    /// Each on top of the one before.
    steps: Vec<Lift>,
}

impl Lifting {
    /// The limit of a domain, at a boundary degree, and up to `steps` changes.
    pub(crate) fn of(domain: &Domain, boundary_degree: Option<u32>, steps: usize) -> Option<Self> {
        if domain.rings().vertex_count() > MOST_VERTICES {
            return None;
        }
        let wanted = domain.interior().cloned().unwrap_or_default();
        let wanted =
            Interior { boundary_degree: boundary_degree.or(wanted.boundary_degree), ..wanted };
        let limit = angle_limit(domain, &wanted).ok()?;
        let mut found: Vec<Lift> = Vec::new();
        while found.len() < steps.min(MOST_STEPS) {
            let (domain, limit) = match found.last() {
                Some(last) => (&last.domain, angle_limit(&last.domain, &wanted).ok()?),
                None => (domain, limit.clone()),
            };
            if limit.min_angle >= ENOUGH && !found.is_empty() {
                break;
            }
            let Some(next) = lift(domain, &wanted, &limit) else { break };
            found.push(next);
        }
        Some(Self { limit, steps: found })
    }

    pub(crate) fn json(&self) -> Limit {
        Limit::new(&self.limit, self.steps.first())
    }

    pub(crate) fn rows(&self) -> Vec<LiftRow> {
        self.steps.iter().map(LiftRow::from).collect()
    }

    /// In sentences, for meshes with interior points.
    pub(crate) fn text(&self) -> String {
        format!("With interior points: {}\n", words::limit(&self.limit, self.steps.first()))
    }

    /// The changes one by one, for `suggest`.
    pub(crate) fn steps_in_words(&self) -> String {
        let mut text = format!(
            "With interior points the minimum angle is at most {}, decided by {}.\n",
            steady_angle(self.limit.min_angle),
            self.limit.cause
        );
        for (index, step) in self.steps.iter().enumerate() {
            let then = if index == 0 { "" } else { "then " };
            text.push_str(&format!(
                "For {}: {then}give {}.\n",
                steady_angle(step.min_angle),
                words::lift_counts(step)
            ));
        }
        text
    }
}
