//! Times of several pieces of work, taken in turns.

use std::time::{Duration, Instant};

/// The best time of each piece of work in seconds, of `rounds` rounds.
///
/// In turns, so that what else the machine does meets all alike; the best, because nothing makes
/// work faster than it is.
pub(crate) fn rounds<const N: usize>(rounds: u32, mut work: [&mut dyn FnMut(); N]) -> [f64; N] {
    let mut best = [Duration::MAX; N];
    for _ in 0..rounds {
        for (best, work) in best.iter_mut().zip(&mut work) {
            let start = Instant::now();
            work();
            *best = start.elapsed().min(*best);
        }
    }
    best.map(|time| time.as_secs_f64())
}
