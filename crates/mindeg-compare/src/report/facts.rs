//! The measures of reports, for pages that draw meshes in the same way.

use serde::Serialize;

use super::metric::SHOWN;

/// A measure of a triangle, as reports show it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MeasureFacts {
    /// The name in [`METRICS`](mindeg::quality::METRICS).
    pub name: &'static str,
    /// What people call it.
    pub title: &'static str,
    /// `1`, `degrees` or `length`.
    pub unit: &'static str,
    /// The formula, which direction is better, and the ends of the range.
    pub explanation: String,
    /// Whether larger values are better.
    pub higher_is_better: bool,
}

/// The measures of a report, in its order.
#[must_use]
pub fn measure_facts() -> Vec<MeasureFacts> {
    let facts = SHOWN.iter().map(|measure| MeasureFacts {
        name: measure.name,
        title: measure.title,
        unit: measure.metric().unit,
        explanation: measure.explanation(),
        higher_is_better: measure.higher_is_better(),
    });
    facts.collect()
}
