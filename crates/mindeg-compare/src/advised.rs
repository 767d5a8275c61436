//! The meshes of a report that are advised.

use crate::Method;
use crate::figures::MethodFigures;
use crate::report::Report;
use mindeg_answers::advice::Purpose;
use std::cmp::Ordering::Equal;

/// The advised meshes, the one to take first: what each is for, and the first method that has it.
pub(crate) fn advised(report: &Report) -> Vec<(Purpose, Method)> {
    let mesh = |purpose: Purpose| match purpose {
        Purpose::Solver => {
            let has_mesh = |it: &&MethodFigures| it.method == Method::Inside && it.valid;
            report.methods.iter().find(has_mesh).map(|it| it.method)
        }
        Purpose::Patch => patch(report).map(|it| it.method),
        Purpose::Fewest => Some(fewest(report)),
    };
    let purposes = report.advice.purposes(report.purpose);
    let meshes = purposes.into_iter().filter_map(|purpose| Some((purpose, mesh(purpose)?)));
    meshes.map(|(purpose, method)| (purpose, first_with_mesh_of(report, method))).collect()
}

/// The mesh that is advised for a patch: that of `--keep-angle 95%`. The mesh of least degree can have the same figures and be
/// another one.
pub(crate) fn patch(report: &Report) -> Option<&MethodFigures> {
    let wanted = report.advice.patch?;
    let has_degree = |method: &&MethodFigures| {
        method.method != Method::Inside
            && method.outcome().is_some_and(|(degree, _)| degree == wanted.max_degree)
    };
    let is_kept =
        |method: &&MethodFigures| matches!(method.method, Method::Kept | Method::Exact { .. });
    let all = report.methods.iter().filter(has_degree);
    all.clone()
        .find(is_kept)
        .or_else(|| all.min_by(|a, b| b.min_angle.partial_cmp(&a.min_angle).unwrap_or(Equal)))
}

/// The mesh of the fewest edges: that of `--for fewest`.
fn fewest(report: &Report) -> Method {
    let is_best = |method: &&MethodFigures| match method.method {
        Method::Fewest => true,
        Method::Exact { max_degree } => {
            report.advice.fewest.is_some_and(|fewest| fewest.max_degree == max_degree)
        }
        _ => false,
    };
    let best = report.methods.iter().find(is_best);
    best.map_or(Method::LeastDegree, |method| method.method)
}

/// The mesh that a method has, under whatever name the report shows it.
pub(crate) fn first_with_mesh_of(report: &Report, wanted: Method) -> Method {
    let figures = report.methods.iter().find(|figures| figures.method == wanted);
    figures.and_then(|figures| figures.same_mesh_as).unwrap_or(wanted)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{CompareOptions, compare};
    use mindeg::{Domain, Goal, Progress};

    /// The mesh beside a command is the one that it makes, also where two have the same degree and angle.
    #[test]
    fn the_advised_meshes_are_those_of_their_commands() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/domains");
        for name in ["plate-with-holes", "wing-panel", "slender-fin", "l-bracket"] {
            let text = std::fs::read_to_string(format!("{folder}/{name}.json")).unwrap();
            let domain = Domain::from_json(&text).unwrap();
            let comparison = compare(&domain, &CompareOptions::default()).unwrap();
            let report = comparison.report();
            for (purpose, method) in advised(report) {
                let Some(goal) = purpose.goal() else { continue };
                let place = report.methods.iter().position(|it| it.method == method).unwrap();
                let made = mindeg::mesh(&domain, goal, Progress::NONE).unwrap().mesh;
                let made: Vec<[u32; 3]> = made.triangles().collect();
                assert_eq!(comparison.triangles(place), made, "{name}, {goal:?}");
                assert!(goal == Goal::LeastDegree || purpose == Purpose::Patch);
            }
        }
    }
}
