//! Exact work, watched from a terminal.

use crate::failure::Failure;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use mindeg_compare::exact::ExactError;
use mindeg_tradeoff::{MAX_VERTICES, ProblemError, Progress, Stage, Watch};
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

/// Work that is over before that shows nothing of itself.
const PATIENCE: Duration = Duration::from_millis(500);

/// The steps of the bar to one stage of the work.
const STEPS: f64 = 1000.0;

/// Does exact work, with a bar on standard error where that is a terminal and `quiet` does not
/// forbid it. What cannot be had says why; where it is for the size of the domain, `way_out` says
/// what to do.
pub(crate) fn watched<T>(
    quiet: bool,
    way_out: &str,
    work: impl FnOnce(Watch<'_>) -> Result<T, ExactError>,
) -> Result<T, Failure> {
    let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
    let bar = ProgressBar::with_draw_target(Some(STEPS as u64), target);
    if let Ok(style) = ProgressStyle::with_template("{msg} {wide_bar} {percent}%, {eta} left") {
        bar.set_style(style);
    }
    let start = Instant::now();
    let mut stage = None;
    let done = work(&mut |progress: Progress| {
        if start.elapsed() >= PATIENCE {
            show(&bar, progress, &mut stage);
        }
        ControlFlow::Continue(())
    });
    bar.finish_and_clear();
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

/// Moves the bar; it starts anew with each stage, since nobody knows how many there will be.
fn show(bar: &ProgressBar, progress: Progress, stage: &mut Option<String>) {
    let name = match progress.stage {
        Stage::Feasibility { max_degree } => format!("is degree {max_degree} possible?"),
        Stage::Bounds => "bounding the angles".to_owned(),
        Stage::Search { max_degree, .. } => format!("degree {max_degree}: the best angle"),
        Stage::Ties { max_degree } => format!("degree {max_degree}: the best mesh"),
        _ => "working".to_owned(),
    };
    if stage.as_ref() != Some(&name) {
        bar.reset();
        bar.set_message(name.clone());
        *stage = Some(name);
    }
    bar.set_position((progress.done * STEPS) as u64);
}
