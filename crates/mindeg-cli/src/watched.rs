//! Exact work, watched from a terminal.

use crate::bar::{Bar, Unit};
use crate::failure::Failure;
use mindeg_compare::exact::ExactError;
use mindeg_exact::{MAX_VERTICES, ProblemError, Progress, Stage, Watch};
use std::ops::ControlFlow;

/// The parts of the bar to one stage of the work.
const PARTS: u64 = 1000;

/// Does exact work, and lets the bar tell how far it is. What cannot be had says why; where it is
/// for the size of the domain, `way_out` says what to do.
pub(crate) fn watched<T>(
    bar: &Bar,
    way_out: &str,
    work: impl FnOnce(Watch<'_>) -> Result<T, ExactError>,
) -> Result<T, Failure> {
    let mut last = None;
    let done = work(&mut |Progress { stage, done }| {
        // The bar starts anew with each stage, since nobody knows how many there will be.
        let name = Some(name(stage));
        if last != name {
            bar.stage(name.clone().unwrap_or_default(), PARTS, Unit::Parts);
            last = name;
        }
        bar.reach((done * PARTS as f64) as u64);
        ControlFlow::Continue(())
    });
    done.map_err(|error| {
        Failure::Input(match error {
            ExactError::Problem(ProblemError::TooManyVertices { vertices }) => format!(
                "the domain has {vertices} boundary vertices, and exact work serves \
                 {MAX_VERTICES} at most; use fewer intervals, or {way_out}"
            ),
            error => error.to_string(),
        })
    })
}

fn name(stage: Stage) -> String {
    match stage {
        Stage::Feasibility { max_degree } => format!("is degree {max_degree} possible?"),
        Stage::Bounds => "bounding the angles".to_owned(),
        Stage::Search { max_degree, .. } => format!("degree {max_degree}: the best angle"),
        Stage::Ties { max_degree } => format!("degree {max_degree}: the best mesh"),
        _ => "working".to_owned(),
    }
}
