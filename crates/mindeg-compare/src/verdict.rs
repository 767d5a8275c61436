//! The verdict on the figures, in sentences: first the mesh to take, then the objections to it.
//!
//! Every sentence is a consequence of the figures. No sentence repeats the tables.
//!
//! Limits: it speaks of the maximum degree and of minimum angles alone. Whether degree or
//! angle matters more is the reader's to know.

use crate::advised::patch;
use crate::figures::{DefectKind, MethodFigures};
use crate::report::Report;
use crate::{Method, Reference};
use mindeg_answers::advice::Purpose;
use mindeg_answers::numbers::{count, percent, steady_angle};

/// Angles closer than this, relatively, are the same: a minimum angle of a millionth of a
/// degree, rounded in f64, is known to about eight digits.
const SAME: f64 = 1e-8;

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
    /// The advice for another purpose.
    pub(crate) also: Option<String>,
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
        first.chain(&self.also).chain(&self.caveat).chain(&self.notes).map(String::as_str)
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
    let purposes = report.advice.purposes(report.purpose);
    let on_edges = report.advice.on_edges(&purposes);
    let mut advised = purposes.into_iter();
    let mut sentence = || advised.next().map(|purpose| report.advice.as_it_is(purpose));
    let (headline, also) = (sentence().unwrap_or_default(), sentence());
    let is_about_patch = report.purpose.is_none_or(|purpose| purpose == Purpose::Patch);
    let taken = patch(report).filter(|_| is_about_patch);
    // Below the picture: above it, this would push it out of a small screen.
    let mut notes: Vec<String> = on_edges.into_iter().collect();
    notes.extend(beside_delaunay(taken.unwrap_or(mindeg), delaunay));
    notes.extend(report.methods.iter().filter_map(failure));
    Verdict { headline, also, caveat: taken.and_then(|taken| caveat(taken, delaunay)), notes }
}

/// The degree of a mesh beside Delaunay's, in a sentence.
fn beside_delaunay(mesh: &MethodFigures, delaunay: &MethodFigures) -> Option<String> {
    let (degree, angle) = mesh.outcome()?;
    let (degree_there, angle_there) = delaunay.outcome()?;
    Some(if degree < degree_there {
        format!(
            "Delaunay's triangulation has up to {} edges at a vertex where degree {} keeps {} of its minimum angle.",
            count(degree_there),
            count(degree),
            kept(angle / angle_there)
        )
    } else {
        "Delaunay's triangulation has no higher degree.".to_owned()
    })
}

/// The words that follow mindeg's maximum degree.
fn least(report: &Report) -> &'static str {
    if report.domain.least_max_degree.is_some() { ", the least possible" } else { "" }
}

/// How much of Delaunay's minimum angle a mesh has.
fn kept(share: f64) -> String {
    if share >= 1.0 - SAME { "all".to_owned() } else { percent(share) }
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
            "{} of the triangles have an angle below {below}°, against {} in Delaunay's mesh",
            percent(own),
            percent(there)
        )
    });
    let median = |method: &MethodFigures| method.spread("min_angle").map(|spread| spread.median);
    let low = median(taken).zip(median(delaunay)).filter(|(own, there)| *own < LOW_MEDIAN * there);
    let low = low.map(|(own, there)| {
        format!(
            "the median of the triangles' minimum angles is {}, against {}",
            steady_angle(own),
            steady_angle(there)
        )
    });
    let parts: Vec<String> = [more, low].into_iter().flatten().collect();
    (!parts.is_empty()).then(|| format!("But of that patch, {}.", parts.join(", and ")))
}

/// The reason why a method has no valid mesh; a missing fan needs no reason.
fn failure(method: &MethodFigures) -> Option<String> {
    let is_late = method.defects.iter().any(|defect| defect.kind == DefectKind::TimeLimit);
    let is_invalid = method.max_degree.is_some() && !method.valid;
    let gives = if is_invalid { "no valid triangulation" } else { "nothing" };
    let told = match left_out(method) {
        Some(_) => format!(
            "Ear clipping has left out points on straight lines, so its mesh is no triangulation of these points: {}.",
            reasons(method)
        ),
        None => format!("{} gives {gives} here: {}.", method.method, reasons(method)),
    };
    (is_late || is_invalid).then_some(told)
}

/// Why triangles of ear clipping are missing.
pub(crate) fn left_out(method: &MethodFigures) -> Option<&'static str> {
    let is_short = method.defects.iter().any(|it| it.kind == DefectKind::MissingTriangles);
    (is_short && method.method == Method::Reference(Reference::EarClipping)).then_some(
        "The crate has left out points on straight lines, so this is no triangulation of these points:",
    )
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
    use mindeg::quality::Distribution;
    use mindeg_answers::advice::{Advice, AdvisedMesh, NoPoints};

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

    /// Checks the verdict on some methods, of which the last is advised for a patch.
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
        let patch = methods.last().and_then(MethodFigures::outcome);
        let patch = patch.map(|(max_degree, min_angle)| AdvisedMesh {
            max_degree,
            min_angle,
            share_of_delaunay: None,
        });
        let report = Report {
            provenance: Provenance::default(),
            domain,
            purpose: Some(Purpose::Patch),
            advice: Advice::among(Err(NoPoints::Impossible(String::new())), patch, None),
            methods,
            trade_off: None,
            interior: Vec::new(),
            verdict: String::new(),
        };
        assert_eq!(verdict(&report).sentences().collect::<Vec<_>>(), expected);
    }

    #[test]
    fn the_advised_mesh_stands_beside_delaunays() {
        check(
            vec![mindeg(4, 2.0), delaunay(13, 30.0), exact(4, 2.0), exact(5, 29.1)],
            &[
                "For a patch that must keep its points, take degree 5: minimum angle 29.100°.",
                "Delaunay's triangulation has up to 13 edges at a vertex where degree 5 keeps 97% of its \
                 minimum angle.",
            ],
        );
        check(
            vec![mindeg(4, 25.0), delaunay(4, 30.0), exact(4, 29.0)],
            &[
                "For a patch that must keep its points, take degree 4: minimum angle 29.000°.",
                "Delaunay's triangulation has no higher degree.",
            ],
        );
    }

    /// The minimum alone misleads: on a regular polygon all triangulations have the same.
    #[test]
    fn worse_triangles_in_general_are_told() {
        let with = |method: MethodFigures, below_5: f64, below_15: f64| MethodFigures {
            share_below_degrees: [(5, below_5), (15, below_15)].into(),
            ..method
        };
        for (own, there, told) in [
            (
                (1.0, 1.0),
                (0.786, 0.95),
                Some("100% of the triangles have an angle below 5°, against 78.6%"),
            ),
            ((0.1, 0.5), (0.05, 0.45), None),
            // The text gives the greater of two differences, whatever the shares are.
            (
                (0.9, 0.95),
                (0.2, 0.5),
                Some("90% of the triangles have an angle below 5°, against 20%"),
            ),
            (
                (0.2, 0.95),
                (0.004, 0.5),
                Some("95% of the triangles have an angle below 15°, against 50%"),
            ),
            (
                (0.2, 0.5),
                (0.004, 0.5),
                Some("20% of the triangles have an angle below 5°, against 0.4%"),
            ),
        ] {
            let caveat = caveat(
                &with(exact(4, 25.0), own.0, own.1),
                &with(delaunay(14, 25.0), there.0, there.1),
            );
            let expected =
                told.map(|told| format!("But of that patch, {told} in Delaunay's mesh."));
            assert_eq!(caveat, expected);
        }
    }

    #[test]
    fn a_median_far_below_delaunays_is_told() {
        let with = |method: MethodFigures, median: f64| {
            let [min, p01, mean, p99, max] = [25.0; 5];
            let all = Distribution { min, p01, median, mean, p99, max };
            let metrics = [("min_angle", all)].into();
            MethodFigures { metrics: Some(metrics), ..method }
        };
        for (own, there, told) in [
            (
                28.0,
                40.0,
                Some("the median of the triangles' minimum angles is 28.000°, against 40.000°"),
            ),
            // No less than 0.8 of it.
            (33.0, 40.0, None),
            (45.0, 40.0, None),
        ] {
            let caveat = caveat(&with(exact(4, 25.0), own), &with(delaunay(14, 25.0), there));
            assert_eq!(caveat, told.map(|told| format!("But of that patch, {told}.")));
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
        for (other, told) in [
            (failed(FAN, DefectKind::NoTriangles, None), None),
            (
                failed(FAN, DefectKind::TimeLimit, None),
                Some("Fan gives nothing here: it went wrong."),
            ),
            (
                failed(
                    Method::Reference(Reference::EarClipping),
                    DefectKind::MissingTriangles,
                    Some(9),
                ),
                Some(
                    "Ear clipping has left out points on straight lines, so its mesh is no triangulation of these points: it went wrong.",
                ),
            ),
            (
                failed(FAN, DefectKind::FlatTriangles, Some(9)),
                Some("Fan gives no valid triangulation here: it went wrong."),
            ),
        ] {
            let expected: Vec<&str> = [
                "For a patch that must keep its points, take degree 4: minimum angle 25.000°.",
                "Delaunay's triangulation has no higher degree.",
            ]
            .into_iter()
            .chain(told)
            .collect();
            check(vec![delaunay(4, 25.0), other, mindeg(4, 25.0)], &expected);
        }
    }
}
