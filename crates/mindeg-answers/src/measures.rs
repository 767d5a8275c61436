//! The measures of a triangle that pages show, and their words.

use mindeg::quality::{METRICS, Metric};
use serde::Serialize;

/// A measure that pages show.
#[derive(Clone, Copy, Debug)]
pub struct ShownMetric {
    /// The key in reports, and the name in [`METRICS`].
    pub name: &'static str,
    /// Its common name.
    pub title: &'static str,
    /// Whether its values are told apart best on a logarithmic axis.
    pub is_logarithmic: bool,
}

/// The measures, in the order of reports.
#[rustfmt::skip]
pub const SHOWN: [ShownMetric; 6] = [
    ShownMetric { name: "min_angle", title: "Minimum angle", is_logarithmic: true },
    ShownMetric { name: "max_angle", title: "Maximum angle", is_logarithmic: false },
    ShownMetric { name: "minimum_height", title: "Minimum height", is_logarithmic: true },
    ShownMetric { name: "aspect_ratio", title: "Aspect ratio", is_logarithmic: true },
    ShownMetric { name: "radius_ratio", title: "Radius ratio", is_logarithmic: true },
    ShownMetric { name: "shape", title: "Shape", is_logarithmic: true },
];

impl ShownMetric {
    /// Its definition.
    #[must_use]
    pub fn metric(&self) -> &'static Metric {
        let named = METRICS.iter().find(|metric| metric.name == self.name);
        named.expect("every measure of a report is one of METRICS")
    }

    /// Whether larger values are better.
    #[must_use]
    pub fn higher_is_better(&self) -> bool {
        let metric = self.metric();
        metric.best.is_none_or(|best| best > metric.worst)
    }

    /// The title, with the unit if there is one.
    #[must_use]
    pub fn title_with_unit(&self) -> String {
        match self.metric().unit {
            "1" => self.title.to_owned(),
            unit => format!("{} ({unit})", self.title),
        }
    }

    /// The formula, which direction is better, and the ends of the range.
    #[must_use]
    pub fn explanation(&self) -> String {
        let metric = self.metric();
        let direction = if self.higher_is_better() { "Higher" } else { "Lower" };
        let range = match metric.best {
            None => "it has the unit of the coordinates".to_owned(),
            Some(best) => {
                let worst =
                    if metric.worst.is_finite() { metric.worst.to_string() } else { "∞".into() };
                format!("{best} for an equilateral triangle, {worst} for a flat one")
            }
        };
        format!(
            "{} = {}, where x ≤ y ≤ z are the edge lengths and A is the area. {direction} is \
             better: {range}.",
            self.title, metric.formula
        )
    }
}

impl From<&ShownMetric> for MeasureFacts {
    fn from(measure: &ShownMetric) -> Self {
        Self {
            name: measure.name,
            title: measure.title,
            unit: measure.metric().unit,
            explanation: measure.explanation(),
            higher_is_better: measure.higher_is_better(),
        }
    }
}

/// A measure with its words.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MeasureFacts {
    /// The name in [`METRICS`].
    pub name: &'static str,
    /// Its common name.
    pub title: &'static str,
    /// `1`, `degrees` or `length`.
    pub unit: &'static str,
    /// The formula, which direction is better, and the ends of the range.
    pub explanation: String,
    /// Whether larger values are better.
    pub higher_is_better: bool,
}
