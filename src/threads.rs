//! The threads that share work.

use crate::failure::Failure;
use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};
use std::{env, thread};

/// The stack of a thread, as large as that of a main thread.
const STACK: usize = 8 << 20;

/// More threads than this spend their time on one another.
const MOST: usize = 256;

/// Does work that is shared by all threads.
pub(crate) fn shared(work: impl FnOnce() -> Result<(), Failure> + Send) -> Result<(), Failure> {
    let failed = |error| Failure::Io(format!("cannot start threads: {error}"));
    let pool = pool().map_err(failed)?;
    pool.install(work)
}

/// As many threads as `RAYON_NUM_THREADS` asks for or the machine has cores, or this one alone
/// where the system allows no more. Not rayon's own, which are started when first needed, or panic.
fn pool() -> Result<ThreadPool, ThreadPoolBuildError> {
    let cores = thread::available_parallelism().map_or(1, usize::from);
    let wanted = env::var("RAYON_NUM_THREADS").ok().and_then(|count| count.trim().parse().ok());
    let count = count(wanted, cores);
    let builder = || ThreadPoolBuilder::new().stack_size(STACK);
    let alone = || builder().num_threads(1).use_current_thread().build();
    builder().num_threads(count).build().or_else(|_| alone())
}

/// The number of threads: what is wanted, up to four for a core.
fn count(wanted: Option<usize>, cores: usize) -> usize {
    let wanted = wanted.filter(|&count| count > 0).unwrap_or(cores);
    wanted.min(4 * cores).min(MOST)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_more_threads_start_than_are_of_use() {
        for (wanted, cores, threads) in [
            (None, 2, 2),
            (Some(0), 2, 2),
            (Some(1), 2, 1),
            (Some(8), 2, 8),
            (Some(2000), 2, 8),
            (Some(usize::MAX), 128, 256),
            (None, 512, 256),
        ] {
            assert_eq!(count(wanted, cores), threads, "{wanted:?} on {cores} cores");
        }
    }
}
