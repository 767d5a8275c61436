//! Watching work on very many triangles.
//!
//! Limits: what hears of progress cannot stop the work.

use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// How far the work is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// How many triangles have been dealt with, 0 to `total`. What turned out not to be worth
    /// looking at counts as well.
    pub done: u64,
    /// How many there are to deal with; a triangle counts anew in each plan that is tried.
    pub total: u64,
}

/// Hears of progress every ten thousand triangles or so, on any of the threads that work. Two of
/// them may tell in the wrong order. [`unwatched`] is one.
pub type Watch<'a> = &'a (dyn Fn(Progress) + Sync);

/// A [`Watch`] that looks away.
pub fn unwatched(_: Progress) {}

/// Counts what is done, for a watch.
pub struct Counter<'a> {
    done: AtomicU64,
    total: u64,
    watch: Watch<'a>,
}

impl<'a> Counter<'a> {
    /// Nothing is done yet.
    #[must_use]
    pub fn new(total: u64, watch: Watch<'a>) -> Self {
        Self { done: AtomicU64::new(0), total, watch }
    }

    /// So many more are done.
    pub fn add(&self, count: usize) {
        let count = count as u64;
        let done = self.done.fetch_add(count, Relaxed) + count;
        (self.watch)(Progress { done, total: self.total });
    }

    /// So many are done in all, no less than before; nobody works meanwhile.
    pub fn reach(&self, done: u64) {
        self.done.store(done, Relaxed);
        (self.watch)(Progress { done, total: self.total });
    }
}
