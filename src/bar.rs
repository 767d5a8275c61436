//! The progress of long work, as a bar on standard error.
//!
//! The bar shows only on a terminal, and only after the first second. It disappears
//! when the work ends or is interrupted.

use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use mindeg_answers::names::shown;
use mindeg_files::READING;
use mindeg_mesh::{Progress, Step};
use std::fmt;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

/// A run that is over before that shows nothing of itself.
const PATIENCE: Duration = Duration::from_secs(1);

/// The bar that can be seen.
static SHOWN: Mutex<Option<ProgressBar>> = Mutex::new(None);

/// Takes the bar away, if there is one, before the process ends.
pub(crate) fn clear() {
    if let Some(bar) = SHOWN.lock().unwrap_or_else(PoisonError::into_inner).take() {
        bar.finish_and_clear();
    }
}

/// The unit of the count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Unit {
    /// Bytes read.
    Bytes,
    /// Parts of work.
    Parts,
    /// Time, of work that nothing can be counted of.
    Time,
}

/// The bar of a run.
pub(crate) struct Bar {
    start: Instant,
    quiet: bool,
    due: AtomicBool,
    bar: ProgressBar,
    /// The stage that the callback was last called with.
    last_stage: Mutex<String>,
}

impl Bar {
    /// A bar that will not be seen if `quiet`, or if the run takes less than a second from here.
    pub(crate) fn new(quiet: bool) -> Self {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
        Self {
            start: Instant::now(),
            quiet,
            due: AtomicBool::new(false),
            bar,
            last_stage: Mutex::default(),
        }
    }

    /// The work from here on, and how much it is; the bar starts anew.
    fn stage(&self, name: impl Into<String>, total: u64, unit: Unit) {
        // This order avoids a bar that mixes this stage with the last.
        self.bar.set_style(style(name.into(), unit));
        self.bar.update(|state| {
            state.set_pos(0);
            state.set_len(total);
        });
        self.bar.reset_elapsed();
    }

    /// Does work that reports its progress, shows each stage and never cancels.
    pub(crate) fn work<T>(&self, work: impl FnOnce(Progress<'_>) -> T) -> T {
        work(Progress::new(&|Step { stage, done, total }| {
            let mut last = self.last_stage.lock().unwrap_or_else(PoisonError::into_inner);
            if *last != stage {
                stage.clone_into(&mut last);
                let unit = if stage == READING { Unit::Bytes } else { Unit::Parts };
                self.stage(stage, total, unit);
            }
            drop(last);
            self.bar.set_position(done.min(total));
            self.show_when_due();
            ControlFlow::Continue(())
        }))
    }

    /// Does work that nothing can be counted of, and shows how long it has been going on.
    pub(crate) fn waiting<T>(&self, name: impl Into<String>, work: impl FnOnce() -> T) -> T {
        const TICK: Duration = Duration::from_millis(100);
        self.stage(name, 0, Unit::Time);
        thread::scope(|scope| {
            // Closed when the work is over, also by a panic.
            let (_working, over) = mpsc::channel::<()>();
            // Without a thread for it, nothing is shown.
            let _ = thread::Builder::new().spawn_scoped(scope, move || {
                while over.recv_timeout(TICK) == Err(RecvTimeoutError::Timeout) {
                    self.show_when_due();
                    self.bar.tick();
                }
            });
            work()
        })
    }

    fn show_when_due(&self) {
        let due = !self.quiet && !self.due.load(Relaxed) && self.start.elapsed() >= PATIENCE;
        if due && !self.due.swap(true, Relaxed) {
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
            *SHOWN.lock().unwrap_or_else(PoisonError::into_inner) = Some(self.bar.clone());
        }
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

/// The time left, if all goes on as it has gone on the whole: parts of one stage take very different times, and a rate of the
/// last ones would say hours after a long part.
fn rest(state: &ProgressState) -> Duration {
    let share = f64::from(state.fraction());
    if share > 0.0 { state.elapsed().mul_f64((1.0 - share) / share) } else { Duration::ZERO }
}

fn style(name: String, unit: Unit) -> ProgressStyle {
    let template = match unit {
        Unit::Bytes => {
            "{name} {wide_bar} {decimal_bytes} of {decimal_total_bytes}, \
             {decimal_bytes_per_sec}, {rest} left"
        }
        Unit::Parts => "{name} {wide_bar} {percent}%{million}, {rest} left",
        Unit::Time => "{name} {spinner} {elapsed}",
    };
    let millions = |count: f64, out: &mut dyn fmt::Write| {
        // A bar that cannot be drawn does not fail the run.
        let _ = write!(out, "{:.0} million", count / 1e6);
    };
    ProgressStyle::with_template(template)
        .expect("the templates are well formed")
        .with_key("name", move |_: &ProgressState, out: &mut dyn fmt::Write| {
            let _ = out.write_str(&shown(&name));
        })
        .with_key("rest", |state: &ProgressState, out: &mut dyn fmt::Write| {
            let _ = write!(out, "{:#}", HumanDuration(rest(state)));
        })
        .with_key("million", move |state: &ProgressState, out: &mut dyn fmt::Write| {
            let total = state.len().unwrap_or_default();
            // Only triangles reach such counts.
            if total >= 1_000_000 {
                let _ = out.write_str(" of ");
                millions(total as f64, out);
                let _ = out.write_str(" triangles, ");
                millions(state.per_sec(), out);
                let _ = out.write_str("/s");
            }
        })
}
