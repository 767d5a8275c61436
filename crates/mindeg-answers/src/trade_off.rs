//! The largest minimum angle for every maximum degree.

use crate::advice::{Advice, KEPT};
use mindeg::exact::{TradeOff, keeps, share_of};
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
/// assert!(answer.points[0].min_angle < answer.angle_limit);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(description = "The largest minimum angle for every maximum degree.")]
pub struct TradeOffAnswer {
    /// A point for every maximum degree, in ascending order.
    pub points: Vec<AngleAtDegree>,
    /// The minimum angle of a Delaunay triangulation, in degrees.
    pub angle_limit: f64,
    /// The degree to take: the smallest that keeps 95% of Delaunay's minimum angle; null if none does.
    pub advised: Option<u32>,
    /// The meshes to take by what they are for; absent where they were not asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub advice: Option<Advice>,
}

/// The largest minimum angle under one maximum degree.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct AngleAtDegree {
    /// The most edges that a vertex may have.
    pub max_degree: u32,
    /// The largest minimum angle there is then, in degrees.
    pub min_angle: f64,
    /// The same as a share of Delaunay's: 0 to 1.
    pub share_of_limit: f64,
    /// Whether that is proven; if not, a larger one may be possible.
    pub exact: bool,
}

impl TradeOffAnswer {
    /// The figures of a trade-off.
    #[must_use]
    pub fn of(trade_off: &TradeOff) -> Self {
        let points = trade_off.meshes().iter().map(|exact| AngleAtDegree {
            max_degree: exact.max_degree,
            min_angle: exact.min_angle,
            share_of_limit: trade_off.share(exact),
            exact: exact.is_proven,
        });
        Self {
            points: points.collect(),
            angle_limit: trade_off.delaunay_min_angle(),
            advised: trade_off.keeping(KEPT).map(|exact| exact.max_degree),
            advice: None,
        }
    }

    /// The figures of domains beside each other: at each degree, the least of the angles that the domains have there. The
    /// first degree is one that all domains have a mesh of.
    #[must_use]
    pub fn of_all(trade_offs: &[TradeOff]) -> Self {
        let most =
            trade_offs.iter().map(TradeOff::delaunay_min_angle).fold(f64::INFINITY, f64::min);
        let degrees = |trade_off: &TradeOff| -> Vec<u32> {
            trade_off.meshes().iter().map(|exact| exact.max_degree).collect()
        };
        let mut all: Vec<u32> = trade_offs.iter().flat_map(degrees).collect();
        all.sort_unstable();
        all.dedup();
        let mut points: Vec<AngleAtDegree> = Vec::new();
        for max_degree in all {
            // The best mesh of each domain within the degree.
            let best = |trade_off: &TradeOff| {
                let within =
                    trade_off.meshes().iter().take_while(|exact| exact.max_degree <= max_degree);
                within.last().map(|exact| {
                    // A trade-off that is not exact may leave out degrees without a better mesh.
                    let is_best = exact.max_degree == max_degree || trade_off.share(exact) >= 1.0;
                    (exact.min_angle, exact.is_proven && is_best)
                })
            };
            let Some(best) = trade_offs.iter().map(best).collect::<Option<Vec<_>>>() else {
                continue;
            };
            let min_angle = best.iter().map(|best| best.0).fold(f64::INFINITY, f64::min);
            if points.last().is_some_and(|last| last.min_angle >= min_angle) {
                continue;
            }
            let share_of_limit = share_of(min_angle, most);
            // Where a domain with the least angle is proven to have no larger one, neither have all.
            let exact = best.iter().any(|&(angle, is_proven)| is_proven && angle <= min_angle);
            points.push(AngleAtDegree { max_degree, min_angle, share_of_limit, exact });
        }
        let kept = |point: &&AngleAtDegree| keeps(point.min_angle, KEPT, most);
        let advised = points.iter().find(kept).map(|point| point.max_degree);
        Self { points, angle_limit: most, advised, advice: None }
    }

    /// The same with the meshes to take.
    #[must_use]
    pub fn with_advice(self, advice: Advice) -> Self {
        Self { advice: Some(advice), ..self }
    }

    /// The gap of the proof, in a sentence.
    #[must_use]
    pub fn open_question(&self) -> Option<&'static str> {
        if self.points.iter().all(|point| point.exact) {
            None
        } else if self.points.iter().all(|point| point.share_of_limit >= 1.0) {
            // No mesh has a larger minimum angle than Delaunay's.
            Some("Not all of these are proven: smaller degrees may be possible.")
        } else {
            Some("Not all of these are proven: smaller degrees and larger angles may be possible.")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mindeg::{Domain, Goal, Progress, Side, exact, mesh};

    /// At each degree, the angle of domains beside each other is the least that each has by itself.
    #[test]
    fn several_domains_have_the_least_angle_at_each_degree() {
        let rectangle = |width: f64, counts: [u64; 4]| {
            Domain::rectangle(width, 3.0, counts.map(Side::count).into()).unwrap()
        };
        let domains =
            [rectangle(4.0, [12, 9, 4, 4]), rectangle(9.0, [3, 7, 5, 2]), rectangle(1.0, [2; 4])];
        let trade_offs: Vec<TradeOff> = domains
            .iter()
            .map(|domain| exact::trade_off(domain, Progress::NONE).unwrap())
            .collect();
        let answer = TradeOffAnswer::of_all(&trade_offs);
        // No mesh of the first has less.
        assert_eq!(answer.points[0].max_degree, 5);
        let best = |limit| {
            let angle = |domain| {
                mesh(domain, Goal::MaxDegree(limit), Progress::NONE).unwrap().mesh.angle_range().min
            };
            domains.iter().map(angle).fold(f64::INFINITY, f64::min)
        };
        let mut expected = 0.0;
        for limit in 5..=15 {
            let angle = best(limit);
            let point = answer.points.iter().find(|point| point.max_degree == limit);
            assert_eq!(point.is_some(), angle > expected * (1.0 + 1e-9), "{limit}");
            expected = angle.max(expected);
            let Some(point) = point else { continue };
            assert!(
                (point.min_angle - angle).abs() < 1e-8 && point.exact,
                "{limit}: {point:?} {angle}"
            );
        }
        assert_eq!(answer.points.last().unwrap().share_of_limit, 1.0);
        assert!((expected - answer.angle_limit).abs() < 1e-8);
        // Alone, a domain has its own.
        let alone = TradeOffAnswer::of_all(&trade_offs[..1]);
        assert_eq!(alone.advised, TradeOffAnswer::of(&trade_offs[0]).advised);
    }

    #[test]
    fn no_angle_above_delaunays_is_said_to_be_possible() {
        let with = |shares: &[f64], exact| TradeOffAnswer {
            points: (5..)
                .zip(shares)
                .map(|(max_degree, &share_of_limit)| AngleAtDegree {
                    max_degree,
                    min_angle: 2.0 * share_of_limit,
                    share_of_limit,
                    exact,
                })
                .collect(),
            angle_limit: 2.0,
            advised: None,
            advice: None,
        };
        let says_angles =
            |answer: TradeOffAnswer| answer.open_question().map(|it| it.contains("larger angles"));
        assert_eq!(says_angles(with(&[0.5, 1.0], true)), None);
        assert_eq!(says_angles(with(&[0.5, 1.0], false)), Some(true));
        assert_eq!(says_angles(with(&[1.0], false)), Some(false));
    }
}
