//! The verdict on the figures, in sentences: first the mesh to take, then the objections to it.
//!
//! Every sentence is a consequence of the figures. What the tables say is not repeated.
//!
//! Limits: it speaks of the maximum degree and of minimum angles alone. Whether degree or
//! angle matters more is the reader's to know.

use crate::Method;
use crate::figures::{DefectKind, MethodFigures};
use crate::report::Report;
use mindeg_answers::advice::KEPT;
use mindeg_answers::numbers::{count, percent, steady_angle};
use std::cmp::Ordering::Equal;

/// Angles closer than this, relatively, are the same: a minimum angle of a millionth of a
/// degree, rounded in f64, is known to about eight digits.
const SAME: f64 = 1e-8;

/// A minimum angle, in degrees, below which meshers commonly ask for better.
const GOOD_ANGLE: f64 = 20.0;

/// The shares of small angles that the verdict compares: the worst triangles, and many.
const SMALL_ANGLES: [u32; 2] = [5, 15];

/// A share of triangles larger than Delaunay's by this is worth a sentence.
const MANY_MORE: f64 = 0.1;

/// A median below this share of Delaunay's is worth a sentence.
const LOW_MEDIAN: f64 = 0.8;

/// The conclusions of a report.
#[derive(Default)]
pub(crate) struct Verdict {
    /// The advice; it can stand alone.
    pub(crate) headline: String,
    /// The objections to the advice.
    pub(crate) caveat: Option<String>,
    /// Further remarks on the figures.
    pub(crate) notes: Vec<String>,
}

impl Verdict {
    fn only(headline: String) -> Self {
        Self { headline, ..Self::default() }
    }

    /// All of it, sentence by sentence.
    pub(crate) fn sentences(&self) -> impl Iterator<Item = &str> {
        let first = [&self.headline].into_iter().filter(|sentence| !sentence.is_empty());
        first.chain(&self.caveat).chain(&self.notes).map(String::as_str)
    }

    /// All of it as one text.
    pub(crate) fn text(&self) -> String {
        self.sentences().collect::<Vec<_>>().join(" ")
    }
}

/// The verdict on the figures of a report.
pub(crate) fn verdict(report: &Report) -> Verdict {
    let find = |wanted| report.methods.iter().find(|method| method.method == wanted);
    let (Some(mindeg), Some(delaunay)) = (find(Method::LeastDegree), find(Method::DELAUNAY)) else {
        return Verdict::default();
    };
    let Some((own_degree, own_angle)) = mindeg.outcome() else {
        return Verdict::only(format!("mindeg has no valid mesh here: {}.", reasons(mindeg)));
    };
    let Some((_, angle_there)) = delaunay.outcome() else {
        return Verdict::only(format!(
            "There is no Delaunay triangulation to compare with: {}. mindeg has at most {} edges at a \
             vertex{}, and a minimum angle of {}.",
            reasons(delaunay),
            count(own_degree),
            least(report),
            steady_angle(own_angle)
        ));
    };
    if own_angle > angle_there * (1.0 + SAME) {
        return Verdict::only(format!(
            "Something is wrong: mindeg's minimum angle, {}, is larger than Delaunay's, {}, \
             and no triangulation of the same points can have that. Please report this domain.",
            steady_angle(own_angle),
            steady_angle(angle_there)
        ));
    }
    let (headline, taken) = headline(report, mindeg, delaunay);
    Verdict { headline, caveat: caveat(taken, delaunay), notes: notes(report, angle_there) }
}

/// The words that follow mindeg's maximum degree.
fn least(report: &Report) -> &'static str {
    if report.domain.least_max_degree.is_some() { ", the least possible" } else { "" }
}

/// The advice, and the mesh it is about; both methods have a valid mesh.
fn headline<'a>(
    report: &'a Report,
    mindeg: &'a MethodFigures,
    delaunay: &'a MethodFigures,
) -> (String, &'a MethodFigures) {
    let degree = |method: &MethodFigures| method.max_degree.unwrap_or_default();
    let share = |method: &MethodFigures| {
        kept(method.min_angle.unwrap_or_default() / delaunay.min_angle.unwrap_or(f64::INFINITY))
    };
    let advised = report.advice.map_or(Method::DELAUNAY, |advice| advice.method);
    let advised = report.methods.iter().find(|method| method.method == advised).unwrap_or(delaunay);
    if degree(advised) < degree(delaunay) {
        let text = format!(
            "Take degree {}: {} of Delaunay's minimum angle, at most {} edges at a vertex instead of {}.",
            count(degree(advised)),
            share(advised),
            count(degree(advised)),
            count(degree(delaunay))
        );
        return (text, advised);
    }
    if degree(mindeg) >= degree(delaunay) {
        let text = format!(
            "Take degree {}: Delaunay's mesh has the least possible maximum degree, too.",
            count(degree(delaunay))
        );
        return (text, advised);
    }
    if report.trade_off.is_none() {
        let text = format!(
            "Degree {}{} keeps {} of Delaunay's minimum angle, with at most {} edges at a vertex instead of \
             {}.",
            count(degree(mindeg)),
            if report.domain.least_max_degree.is_some() { ", the least possible," } else { "" },
            share(mindeg),
            count(degree(mindeg)),
            count(degree(delaunay))
        );
        return (text, mindeg);
    }
    let lower = report.methods.iter().filter(|method| {
        method.outcome().is_some_and(|(its_degree, _)| its_degree < degree(delaunay))
    });
    let best = lower.max_by(|a, b| a.min_angle.partial_cmp(&b.min_angle).unwrap_or(Equal));
    let best = best.unwrap_or(mindeg);
    let text = format!(
        "Take Delaunay's degree, {}: every lower one costs more than {} of the minimum angle; degree \
         {} keeps {}.",
        count(degree(delaunay)),
        percent(1.0 - KEPT),
        count(degree(best)),
        share(best)
    );
    (text, advised)
}

/// Notes on the limits of the boundary and on methods that failed.
fn notes(report: &Report, angle_there: f64) -> Vec<String> {
    let mut sentences = Vec::new();
    if angle_there < GOOD_ANGLE {
        sentences.push(format!(
            "No triangulation of these boundary points alone has a minimum angle above {}; to \
             do better, change the intervals or add points inside.",
            steady_angle(angle_there)
        ));
    }
    sentences.extend(report.methods.iter().filter_map(failure));
    sentences
}

/// How much of Delaunay's minimum angle a mesh has.
fn kept(share: f64) -> String {
    if share >= 1.0 - SAME { "all".to_owned() } else { less_than_all(share) }
}

/// Less than all in whole percent: 99.7% is not 100%.
fn less_than_all(share: f64) -> String {
    if share < 0.1 { percent(share) } else { format!("{:.0}%", (share * 100.0).min(99.0)) }
}

/// Where a mesh with a good minimum angle has worse triangles than Delaunay's in general.
fn caveat(taken: &MethodFigures, delaunay: &MethodFigures) -> Option<String> {
    if taken.method == Method::DELAUNAY {
        return None;
    }
    let share = |method: &MethodFigures, below| method.share_below_degrees.get(&below).copied();
    let more = SMALL_ANGLES
        .into_iter()
        .filter_map(|below| Some((below, share(taken, below)?, share(delaunay, below)?)))
        .filter(|(_, own, there)| own - there > MANY_MORE)
        .max_by(|(_, own, there), (_, other, its)| (own - there).total_cmp(&(other - its)));
    let more = more.map(|(below, own, there)| {
        format!(
            "{} of its triangles have an angle below {below}°, against {} in Delaunay's mesh",
            rounded(own),
            rounded(there)
        )
    });
    let median = |method: &MethodFigures| method.spread("min_angle").map(|spread| spread.median);
    let low = median(taken).zip(median(delaunay)).filter(|(own, there)| *own < LOW_MEDIAN * there);
    let low = low.map(|(own, there)| {
        format!(
            "the median of its triangles' minimum angles is {}, against {}",
            steady_angle(own),
            steady_angle(there)
        )
    });
    let parts: Vec<String> = [more, low].into_iter().flatten().collect();
    (!parts.is_empty()).then(|| format!("But {}.", parts.join(", and ")))
}

/// A share in whole percent.
fn rounded(share: f64) -> String {
    if share > 0.0 && share < 0.01 { percent(share) } else { format!("{:.0}%", share * 100.0) }
}

/// The reason why a method has no valid mesh; a missing fan needs no reason.
fn failure(method: &MethodFigures) -> Option<String> {
    let is_late = method.defects.iter().any(|defect| defect.kind == DefectKind::TimeLimit);
    let is_invalid = method.max_degree.is_some() && !method.valid;
    let gives = if is_invalid { "no valid triangulation" } else { "nothing" };
    (is_late || is_invalid)
        .then(|| format!("{} gives {gives} here: {}.", method.method, reasons(method)))
}

fn reasons(method: &MethodFigures) -> String {
    let messages: Vec<&str> = method.defects.iter().map(|defect| &*defect.message).collect();
    if messages.is_empty() { "no reason is known".into() } else { messages.join("; ") }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figures::{DomainFigures, MethodDefect};
    use crate::report::Provenance;
    use crate::{Advice, Reference};
    use mindeg::quality::Distribution;
    use mindeg_answers::trade_off::TradeOffAnswer;

    const FAN: Method = Method::Reference(Reference::Fan);

    fn method(method: Method, degree: u32, angle: f64) -> MethodFigures {
        MethodFigures {
            method,
            max_degree: Some(degree),
            min_angle: Some(angle),
            valid: true,
            ..MethodFigures::default()
        }
    }

    fn mindeg(degree: u32, angle: f64) -> MethodFigures {
        method(Method::LeastDegree, degree, angle)
    }

    fn delaunay(degree: u32, angle: f64) -> MethodFigures {
        method(Method::DELAUNAY, degree, angle)
    }

    fn exact(degree: u32, angle: f64) -> MethodFigures {
        method(Method::Exact { max_degree: degree }, degree, angle)
    }

    fn failed(method: Method, kind: DefectKind, max_degree: Option<u32>) -> MethodFigures {
        let defect = MethodDefect { kind, count: None, message: "it went wrong".to_owned() };
        MethodFigures { method, max_degree, defects: vec![defect], ..MethodFigures::default() }
    }

    /// Checks the verdict on some methods; the trade-off is known where one of them is exact.
    #[track_caller]
    fn check(methods: Vec<MethodFigures>, expected: &[&str]) {
        let domain = DomainFigures {
            name: None,
            intervals: vec![10; 4],
            side_names: vec![None; 4],
            side_lengths: vec![4.0, 3.0, 4.0, 3.0],
            corners: vec![[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]],
            vertices: 40,
            triangles: 38,
            interior_edges: 37,
            at_least: 4,
            holes: 0,
            regions: None,
            least_max_degree: Some(4),
        };
        let has_exact = methods.iter().any(|m| matches!(m.method, Method::Exact { .. }));
        let trade_off = TradeOffAnswer { points: vec![], delaunay_min_angle: 1.0, advised: None };
        let report = Report {
            provenance: Provenance::default(),
            domain,
            advice: Advice::of(&methods, has_exact),
            methods,
            trade_off: has_exact.then_some(trade_off),
            interior: Vec::new(),
            verdict: String::new(),
        };
        assert_eq!(verdict(&report).sentences().collect::<Vec<_>>(), expected);
    }

    #[test]
    fn the_first_sentence_says_what_to_take() {
        for (methods, expected) in [
            (
                vec![mindeg(4, 2.0), delaunay(13, 30.0), exact(4, 2.0), exact(5, 29.1)],
                "Take degree 5: 97% of Delaunay's minimum angle, at most 5 edges at a vertex instead of 13.",
            ),
            (
                vec![mindeg(4, 30.0), delaunay(5, 30.000_000_000_1)],
                "Take degree 4: all of Delaunay's minimum angle, at most 4 edges at a vertex instead of 5.",
            ),
            (
                vec![mindeg(4, 25.0), delaunay(4, 30.0), exact(4, 29.0)],
                "Take degree 4: Delaunay's mesh has the least possible maximum degree, too.",
            ),
            (
                vec![
                    mindeg(4, 3.0),
                    delaunay(6, 30.0),
                    exact(4, 3.0),
                    exact(5, 15.0),
                    exact(6, 30.0),
                ],
                "Take Delaunay's degree, 6: every lower one costs more than 5% of the minimum angle; degree 5 keeps 50%.",
            ),
            (
                vec![mindeg(4, 15.0), delaunay(9, 30.0)],
                "Degree 4, the least possible, keeps 50% of Delaunay's minimum angle, with at most 4 edges at a vertex instead of 9.",
            ),
        ] {
            check(methods, &[expected]);
        }
    }

    /// The minimum alone misleads: on a regular polygon all triangulations have the same.
    #[test]
    fn worse_triangles_in_general_are_told() {
        let with = |method: MethodFigures, below_5: f64, below_15: f64| MethodFigures {
            share_below_degrees: [(5, below_5), (15, below_15)].into(),
            ..method
        };
        let first = "Take degree 4: all of Delaunay's minimum angle, at most 4 edges at a vertex instead of 14.";
        check(
            vec![with(mindeg(4, 25.0), 1.0, 1.0), with(delaunay(14, 25.0), 0.786, 0.95)],
            &[
                first,
                "But 100% of its triangles have an angle below 5°, against 79% in Delaunay's mesh.",
            ],
        );
        check(
            vec![with(mindeg(4, 25.0), 0.1, 0.5), with(delaunay(14, 25.0), 0.05, 0.45)],
            &[first],
        );
        // The text gives the greater of two differences, whatever the shares are.
        check(
            vec![with(mindeg(4, 25.0), 0.9, 0.95), with(delaunay(14, 25.0), 0.2, 0.5)],
            &[
                first,
                "But 90% of its triangles have an angle below 5°, against 20% in Delaunay's mesh.",
            ],
        );
        check(
            vec![with(mindeg(4, 25.0), 0.2, 0.95), with(delaunay(14, 25.0), 0.004, 0.5)],
            &[
                first,
                "But 95% of its triangles have an angle below 15°, against 50% in Delaunay's mesh.",
            ],
        );
        check(
            vec![with(mindeg(4, 25.0), 0.2, 0.5), with(delaunay(14, 25.0), 0.004, 0.5)],
            &[
                first,
                "But 20% of its triangles have an angle below 5°, against 0.4% in Delaunay's mesh.",
            ],
        );
    }

    #[test]
    fn a_median_far_below_delaunays_is_told() {
        let with = |method: MethodFigures, median: f64| {
            let [min, p01, mean, p99, max] = [25.0; 5];
            let all = Distribution { min, p01, median, mean, p99, max };
            let metrics = [("min_angle", all)].into();
            MethodFigures { metrics: Some(metrics), ..method }
        };
        let first = "Take degree 4: all of Delaunay's minimum angle, at most 4 edges at a vertex instead of 14.";
        for (own, there, told) in [
            (
                28.0,
                40.0,
                Some(
                    "But the median of its triangles' minimum angles is 28.000°, against 40.000°.",
                ),
            ),
            // No less than 0.8 of it.
            (33.0, 40.0, None),
            (45.0, 40.0, None),
        ] {
            let expected: Vec<&str> = [first].into_iter().chain(told).collect();
            check(vec![with(mindeg(4, 25.0), own), with(delaunay(14, 25.0), there)], &expected);
        }
    }

    #[test]
    fn an_angle_above_delaunays_is_reported_as_a_fault() {
        check(
            vec![mindeg(4, 30.0), delaunay(4, 29.0)],
            &[
                "Something is wrong: mindeg's minimum angle, 30.000°, is larger than Delaunay's, 29.000°, and no triangulation of the same points can have that. Please report this domain.",
            ],
        );
    }

    #[test]
    fn tells_the_limit() {
        let level = "Take degree 4: Delaunay's mesh has the least possible maximum degree, too.";
        check(
            vec![mindeg(4, 12.5), delaunay(4, 12.5)],
            &[
                level,
                "No triangulation of these boundary points alone has a minimum angle above 12.500°; to do better, change the intervals or add points inside.",
            ],
        );
        check(vec![mindeg(4, 25.0), delaunay(4, 25.0)], &[level]);
    }

    #[test]
    fn without_a_valid_method_there_is_nothing_to_conclude() {
        check(
            vec![mindeg(4, 25.0), failed(Method::DELAUNAY, DefectKind::TimeLimit, None)],
            &[
                "There is no Delaunay triangulation to compare with: it went wrong. mindeg has at most 4 edges at a vertex, the least possible, and a minimum angle of 25.000°.",
            ],
        );
        let invalid = failed(Method::LeastDegree, DefectKind::FlatTriangles, Some(4));
        check(vec![invalid, delaunay(4, 25.0)], &["mindeg has no valid mesh here: it went wrong."]);
        check(vec![], &[]);
    }

    #[test]
    fn failures_are_told_but_not_a_missing_fan() {
        let level = "Take degree 4: Delaunay's mesh has the least possible maximum degree, too.";
        for (other, told) in [
            (failed(FAN, DefectKind::NoTriangles, None), None),
            (
                failed(FAN, DefectKind::TimeLimit, None),
                Some("Fan gives nothing here: it went wrong."),
            ),
            (
                failed(FAN, DefectKind::FlatTriangles, Some(9)),
                Some("Fan gives no valid triangulation here: it went wrong."),
            ),
        ] {
            let expected: Vec<&str> = [level].into_iter().chain(told).collect();
            check(vec![mindeg(4, 25.0), delaunay(4, 25.0), other], &expected);
        }
    }
}
