//! The answers in progress: one a tab, two at once, each with a time limit.

use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};
use tokio::sync::{OwnedSemaphorePermit, Semaphore};

/// How many answers are worked on at once.
const AT_ONCE: usize = 2;

/// The most tabs that are remembered; the answer of the one that asked longest ago ends.
const MOST_TABS: usize = 64;

/// The stack of a thread that works on an answer, as large as that of a main thread.
const STACK: usize = 8 << 20;

/// How long an answer may take. All of it takes a minute for a ring of 100,000 points that is not convex, on a slow machine.
pub(crate) const TIME_LIMIT: Duration = Duration::from_secs(120);

/// The answers that tabs wait for.
pub(crate) struct Works {
    /// The tab that asked last comes last.
    tabs: Mutex<Vec<(String, Arc<AtomicBool>)>>,
    turns: Arc<Semaphore>,
    pools: Arc<Mutex<Vec<ThreadPool>>>,
}

impl Works {
    pub(crate) fn new() -> Result<Self, ThreadPoolBuildError> {
        let pool = |_| ThreadPoolBuilder::new().stack_size(STACK).build();
        let pools = (0..AT_ONCE).map(pool).collect::<Result<_, _>>()?;
        let pools = Arc::new(Mutex::new(pools));
        Ok(Self { tabs: Mutex::default(), turns: Arc::new(Semaphore::new(AT_ONCE)), pools })
    }

    /// An answer for a tab; the one before it ends.
    pub(crate) fn start(&self, tab: &str) -> Work {
        let mut tabs = self.tabs.lock().unwrap_or_else(PoisonError::into_inner);
        let before = tabs.iter().position(|(name, _)| name == tab);
        let ended = before.or((tabs.len() >= MOST_TABS).then_some(0));
        if let Some(ended) = ended {
            tabs.remove(ended).1.store(true, Relaxed);
        }
        let is_over = Arc::new(AtomicBool::new(false));
        tabs.push((tab.to_owned(), Arc::clone(&is_over)));
        Work { is_over, deadline: Instant::now() + TIME_LIMIT }
    }

    /// Waits until fewer than two answers are worked on.
    pub(crate) async fn turn(&self) -> Option<Turn> {
        let permit = Arc::clone(&self.turns).acquire_owned().await.ok()?;
        let pool = self.pools.lock().unwrap_or_else(PoisonError::into_inner).pop();
        Some(Turn { pool, pools: Arc::clone(&self.pools), _permit: permit })
    }
}

/// The right to work, on threads that no other answer shares: in one pool, a thread that waits for its part
/// of one answer would take up the whole of another.
pub(crate) struct Turn {
    pool: Option<ThreadPool>,
    pools: Arc<Mutex<Vec<ThreadPool>>>,
    _permit: OwnedSemaphorePermit,
}

impl Turn {
    /// Works on the threads of this turn.
    pub(crate) fn work<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        match &self.pool {
            Some(pool) => pool.install(work),
            None => work(),
        }
    }
}

impl Drop for Turn {
    fn drop(&mut self) {
        // Before the permit goes, so that the next turn finds the threads.
        let mut pools = self.pools.lock().unwrap_or_else(PoisonError::into_inner);
        pools.extend(self.pool.take());
    }
}

/// An answer in the making.
pub(crate) struct Work {
    is_over: Arc<AtomicBool>,
    deadline: Instant,
}

impl Work {
    /// A work that no other one ends.
    pub(crate) fn alone() -> Self {
        Self { is_over: Arc::default(), deadline: Instant::now() + TIME_LIMIT }
    }

    /// Whether a newer request came.
    pub(crate) fn is_over(&self) -> bool {
        self.is_over.load(Relaxed)
    }

    /// Whether it took too long.
    pub(crate) fn is_late(&self) -> bool {
        Instant::now() > self.deadline
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_work_is_late_after_its_deadline_alone() {
        assert!(!Work::alone().is_late());
        let deadline = Instant::now().checked_sub(Duration::from_secs(1)).unwrap();
        let work = Work { deadline, ..Work::alone() };
        assert!(work.is_late());
        assert!(!work.is_over());
    }
}
