//! The progress of long work, and its cancellation.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// The progress of one stage of the work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Step<'a> {
    /// The stage in words, such as "choosing among candidates".
    pub stage: &'a str,
    /// The finished amount of the stage, 0 to `total`. It never decreases within a stage.
    pub done: u64,
    /// The total amount; an estimate if it is not known in advance.
    pub total: u64,
}

type Callback<'a> = dyn Fn(Step<'_>) -> ControlFlow<()> + Sync + 'a;

/// A callback that long work calls with every [`Step`]; it cancels the work by a break.
///
/// Worker threads call it many times a second, possibly out of order.
///
/// # Example
///
/// ```
/// use mindeg_mesh::{Cancelled, Progress};
/// use std::ops::ControlFlow;
///
/// let at_most_one_half = |step: mindeg_mesh::Step<'_>| {
///     if 2 * step.done <= step.total { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
/// };
/// let progress = Progress::new(&at_most_one_half);
/// assert_eq!(progress.report("counting", 1, 2), Ok(()));
/// assert_eq!(progress.report("counting", 2, 2), Err(Cancelled));
/// assert_eq!(Progress::NONE.report("counting", 2, 2), Ok(()));
/// ```
#[derive(Clone, Copy)]
pub struct Progress<'a> {
    callback: Option<&'a Callback<'a>>,
}

/// A [`Progress`] callback has cancelled the work.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("cancelled")]
pub struct Cancelled;

impl<'a> Progress<'a> {
    /// Calls nobody and never cancels.
    pub const NONE: Progress<'static> = Progress { callback: None };

    /// Calls `callback`.
    pub fn new(callback: &'a Callback<'a>) -> Self {
        Self { callback: Some(callback) }
    }

    /// A callback that cancels the work once `goes_on` does not hold.
    pub fn while_it(
        goes_on: impl Fn() -> bool + Sync,
    ) -> impl Fn(Step<'_>) -> ControlFlow<()> + Sync {
        move |_| if goes_on() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    }

    /// Reports that `done` of `total` is done in a stage.
    ///
    /// # Errors
    ///
    /// [`Cancelled`], if the callback breaks.
    pub fn report(&self, stage: &str, done: u64, total: u64) -> Result<(), Cancelled> {
        match self.callback.map(|callback| callback(Step { stage, done, total })) {
            None | Some(ControlFlow::Continue(())) => Ok(()),
            Some(ControlFlow::Break(())) => Err(Cancelled),
        }
    }

    /// A counter of finished work in a stage, for several threads.
    pub fn counter<'b>(&'b self, stage: &'b str, total: u64) -> Counter<'b> {
        Counter { progress: self, stage, done: AtomicU64::new(0), total }
    }
}

impl std::fmt::Debug for Progress<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(if self.callback.is_some() { "Progress(callback)" } else { "Progress::NONE" })
    }
}

/// Counts finished work in a stage, on any number of threads.
pub struct Counter<'a> {
    progress: &'a Progress<'a>,
    stage: &'a str,
    done: AtomicU64,
    total: u64,
}

impl Counter<'_> {
    /// `count` more are done.
    ///
    /// # Errors
    ///
    /// [`Cancelled`], if the callback breaks.
    pub fn add(&self, count: usize) -> Result<(), Cancelled> {
        let count = count as u64;
        let done = self.done.fetch_add(count, Relaxed) + count;
        self.progress.report(self.stage, done, self.total)
    }

    /// Sets the finished work to `done`, never less than before; no other thread works now.
    ///
    /// # Errors
    ///
    /// [`Cancelled`], if the callback breaks.
    pub fn reach(&self, done: u64) -> Result<(), Cancelled> {
        self.done.store(done, Relaxed);
        self.progress.report(self.stage, done, self.total)
    }
}
