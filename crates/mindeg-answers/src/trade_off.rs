//! The largest minimum angle for every maximum degree, and which degree to take.

use crate::advice::KEPT;
use crate::numbers::{percent, steady_angle};
use mindeg::exact::TradeOff;
use schemars::JsonSchema;
use serde::Serialize;

/// The largest minimum angle for every maximum degree; angles are in degrees.
///
/// # Example
///
/// ```
/// use mindeg::{Domain, Progress, Side, exact};
/// use mindeg_answers::trade_off::TradeOffAnswer;
///
/// let domain = Domain::rectangle(4.0, 3.0, vec![Side::count(10); 4])?;
/// let answer = TradeOffAnswer::of(&exact::trade_off(&domain, Progress::NONE)?);
/// assert_eq!((answer.points[0].max_degree, answer.advised), (4, Some(5)));
/// assert!(answer.points[0].min_angle < answer.delaunay_min_angle);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(description = "The largest minimum angle for every maximum degree.")]
pub struct TradeOffAnswer {
    /// A point for every maximum degree, in ascending order.
    pub points: Vec<AngleAtDegree>,
    /// The minimum angle of a Delaunay triangulation, in degrees.
    pub delaunay_min_angle: f64,
    /// The degree to take: the smallest that keeps 95% of Delaunay's minimum angle; null if none does.
    pub advised: Option<u32>,
}

/// The largest minimum angle under one maximum degree.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct AngleAtDegree {
    /// The most edges that a vertex may have.
    pub max_degree: u32,
    /// The largest minimum angle there is then, in degrees.
    pub min_angle: f64,
    /// The same as a share of Delaunay's: 0 to 1.
    pub share_of_delaunay: f64,
    /// Whether that is proven; if not, windows reached it.
    pub exact: bool,
}

impl TradeOffAnswer {
    /// The figures of a trade-off.
    #[must_use]
    pub fn of(trade_off: &TradeOff) -> Self {
        let points = trade_off.meshes().iter().map(|exact| AngleAtDegree {
            max_degree: exact.max_degree,
            min_angle: exact.min_angle,
            share_of_delaunay: trade_off.share(exact),
            exact: exact.is_proven,
        });
        Self {
            points: points.collect(),
            delaunay_min_angle: trade_off.delaunay_min_angle(),
            advised: trade_off.keeping(KEPT).map(|exact| exact.max_degree),
        }
    }

    /// Which degree to take, and what the least costs, in a sentence or two. `delaunay_max_degree` is the
    /// maximum degree of a Delaunay triangulation.
    #[must_use]
    pub fn advice(&self, delaunay_max_degree: Option<u32>) -> String {
        let advised = self.points.iter().find(|point| Some(point.max_degree) == self.advised);
        let (Some(least), Some(taken)) = (self.points.first(), advised.or(self.points.last()))
        else {
            return String::new();
        };
        let instead = match delaunay_max_degree {
            Some(degree) if degree > taken.max_degree => format!(" instead of {degree}"),
            _ => String::new(),
        };
        let take = format!(
            "Take degree {}: {} of Delaunay's minimum angle, {}, with at most {} edges at a \
             vertex{instead}.",
            taken.max_degree,
            percent(taken.share_of_delaunay.min(1.0)),
            steady_angle(taken.min_angle),
            taken.max_degree,
        );
        let rest = if least.max_degree == taken.max_degree {
            "No mesh has a smaller maximum degree.".to_owned()
        } else {
            format!(
                "Degree {} keeps {}, {}: degree {} has {:.1} times the minimum angle.",
                least.max_degree,
                percent(least.share_of_delaunay),
                steady_angle(least.min_angle),
                taken.max_degree,
                taken.min_angle / least.min_angle,
            )
        };
        // Windows leave it open whether a smaller degree is possible.
        if taken.exact || least.max_degree < taken.max_degree {
            format!("{take} {rest}")
        } else {
            take
        }
    }

    /// The gap of the proof, in a sentence.
    #[must_use]
    pub fn open_question(&self) -> Option<&'static str> {
        if self.points.iter().all(|point| point.exact) {
            None
        } else if self.points.iter().all(|point| point.share_of_delaunay >= 1.0) {
            // No mesh has a larger minimum angle than Delaunay's.
            Some("Windows reached these; smaller degrees may be possible.")
        } else {
            Some("Windows reached these; smaller degrees and larger angles may be possible.")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_angle_above_delaunays_is_said_to_be_possible() {
        let with = |shares: &[f64], exact| TradeOffAnswer {
            points: (5..)
                .zip(shares)
                .map(|(max_degree, &share_of_delaunay)| AngleAtDegree {
                    max_degree,
                    min_angle: 2.0 * share_of_delaunay,
                    share_of_delaunay,
                    exact,
                })
                .collect(),
            delaunay_min_angle: 2.0,
            advised: None,
        };
        let says_angles =
            |answer: TradeOffAnswer| answer.open_question().map(|it| it.contains("larger angles"));
        assert_eq!(says_angles(with(&[0.5, 1.0], true)), None);
        assert_eq!(says_angles(with(&[0.5, 1.0], false)), Some(true));
        assert_eq!(says_angles(with(&[1.0], false)), Some(false));
    }
}
