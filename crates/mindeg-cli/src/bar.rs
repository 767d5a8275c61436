//! How far long work is, as a bar on standard error.
//!
//! There is a bar only where standard error is a terminal, and only from a second on. It is gone
//! when the work is done, or interrupted.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use mindeg_mesh::Step;
use std::fmt;
use std::io::{self, Read};
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

/// What is counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Unit {
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
    pub(crate) fn stage(&self, name: impl Into<String>, total: u64, unit: Unit) {
        // In this order, nothing is drawn that is half of this stage and half of the last.
        self.bar.set_style(style(name.into(), unit));
        self.bar.update(|state| {
            state.set_pos(0);
            state.set_len(total);
        });
        self.bar.reset_eta();
    }

    /// So much of the stage is done.
    pub(crate) fn reach(&self, done: u64) {
        self.bar.set_position(done);
        self.show_when_due();
    }

    /// A progress callback that shows each stage and never cancels.
    pub(crate) fn callback(&self) -> impl Fn(Step<'_>) -> ControlFlow<()> + Sync {
        |Step { stage, done, total }| {
            let mut last = self.last_stage.lock().unwrap_or_else(PoisonError::into_inner);
            if *last != stage {
                stage.clone_into(&mut last);
                self.stage(stage, total, Unit::Parts);
            }
            drop(last);
            self.reach(done);
            ControlFlow::Continue(())
        }
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

    /// Counts the bytes that come from a `stream`, of which `expected` were counted in the
    /// stage's total.
    pub(crate) fn counting<T>(&self, stream: T, expected: u64) -> Counting<'_, T> {
        Counting { stream, bar: self, left: expected }
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

fn style(name: String, unit: Unit) -> ProgressStyle {
    let template = match unit {
        Unit::Bytes => {
            "{name} {wide_bar} {decimal_bytes} of {decimal_total_bytes}, \
             {decimal_bytes_per_sec}, {eta} left"
        }
        Unit::Parts => "{name} {wide_bar} {percent}%{million}, {eta} left",
        Unit::Time => "{name} {spinner} {elapsed}",
    };
    let millions = |count: f64, out: &mut dyn fmt::Write| {
        // A bar that cannot be drawn is no reason to fail.
        let _ = write!(out, "{:.0} million", count / 1e6);
    };
    ProgressStyle::with_template(template)
        .expect("the templates are well formed")
        .with_key("name", move |_: &ProgressState, out: &mut dyn fmt::Write| {
            let _ = out.write_str(&name);
        })
        .with_key("million", move |state: &ProgressState, out: &mut dyn fmt::Write| {
            let total = state.len().unwrap_or_default();
            // Where so much is counted, it is triangles.
            if total >= 1_000_000 {
                let _ = out.write_str(" of ");
                millions(total as f64, out);
                let _ = out.write_str(" triangles, ");
                millions(state.per_sec(), out);
                let _ = out.write_str("/s");
            }
        })
}

/// Passes bytes on and counts them.
///
/// What was expected need not be what comes. The total grows with what comes beyond it, and
/// shrinks in the end by what is missing: so the bar ends with the work, and not before.
pub(crate) struct Counting<'a, T> {
    stream: T,
    bar: &'a Bar,
    /// How many more bytes are expected.
    left: u64,
}

impl<T> Counting<'_, T> {
    fn count(&mut self, bytes: usize) {
        let bytes = bytes as u64;
        let beyond = bytes.saturating_sub(self.left);
        if beyond > 0 {
            self.bar.bar.inc_length(beyond);
        }
        self.left = self.left.saturating_sub(bytes);
        self.bar.bar.inc(bytes);
        self.bar.show_when_due();
    }
}

impl<R: Read> Read for Counting<'_, R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.stream.read(buffer)?;
        self.count(count);
        Ok(count)
    }
}

impl<T> Drop for Counting<'_, T> {
    fn drop(&mut self) {
        self.bar.bar.dec_length(self.left);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stage_ends_at_its_total_whatever_was_expected() {
        let bar = Bar::new(true);
        for (expected, blocks) in [
            (&[100_u64][..], &[&[40_u64, 60][..]][..]),
            (&[100], &[&[40, 50, 60]]),
            (&[100], &[&[40, 50]]),
            (&[100], &[&[]]),
            (&[100, 50, 0], &[&[90], &[70], &[5]]),
        ] {
            bar.stage("reading", expected.iter().sum(), Unit::Bytes);
            for (&expected, blocks) in expected.iter().zip(blocks) {
                let mut input = bar.counting(io::repeat(0), expected);
                for &len in *blocks {
                    assert_eq!(
                        input.read(&mut vec![0; len as usize]).expect("zeros"),
                        len as usize
                    );
                    assert!(Some(bar.bar.position()) <= bar.bar.length());
                }
            }
            let read = blocks.iter().copied().flatten().sum();
            assert_eq!((bar.bar.position(), bar.bar.length()), (read, Some(read)));
        }
    }
}
