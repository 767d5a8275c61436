//! The measures a report shows, and how it speaks of them.

use crate::figures::{Distribution, MetricFigures};
use mindeg::quality::{METRICS, Metric};

/// A measure in a report.
#[derive(Clone, Copy)]
pub(crate) struct ShownMetric {
    /// The key in reports, and the name in [`METRICS`].
    pub(crate) name: &'static str,
    /// What people call it.
    pub(crate) title: &'static str,
    /// Whether its values are told apart best on a logarithmic axis.
    pub(crate) is_logarithmic: bool,
    /// Reads it from a report.
    pub(crate) of: fn(&MetricFigures) -> &Distribution,
}

/// The measures, in the order of the report.
#[rustfmt::skip]
pub(crate) const SHOWN: [ShownMetric; 6] = [
    ShownMetric { name: "min_angle", title: "Minimum angle", is_logarithmic: true, of: |m| &m.min_angle },
    ShownMetric { name: "max_angle", title: "Maximum angle", is_logarithmic: false, of: |m| &m.max_angle },
    ShownMetric { name: "minimum_height", title: "Minimum height", is_logarithmic: true, of: |m| &m.minimum_height },
    ShownMetric { name: "aspect_ratio", title: "Aspect ratio", is_logarithmic: true, of: |m| &m.aspect_ratio },
    ShownMetric { name: "radius_ratio", title: "Radius ratio", is_logarithmic: true, of: |m| &m.radius_ratio },
    ShownMetric { name: "shape", title: "Shape", is_logarithmic: true, of: |m| &m.shape },
];

impl ShownMetric {
    /// Its definition.
    pub(crate) fn metric(&self) -> &'static Metric {
        let named = METRICS.iter().find(|metric| metric.name == self.name);
        named.expect("every measure of a report is one of METRICS")
    }

    pub(crate) fn higher_is_better(&self) -> bool {
        let metric = self.metric();
        metric.best.is_none_or(|best| best > metric.worst)
    }

    /// The title, with the unit if there is one.
    pub(crate) fn title_with_unit(&self) -> String {
        match self.metric().unit {
            "1" => self.title.to_owned(),
            unit => format!("{} ({unit})", self.title),
        }
    }

    /// The formula, which direction is better, and the ends of the range.
    pub(crate) fn explanation(&self) -> String {
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
