//! How long one program takes on one input, next to mindeg in the same process.
//!
//! The time is that of the processor, in the program and in the system on its behalf, all threads
//! together: on an idle machine what a single-threaded program takes by the clock, on a busy one
//! not lengthened by what others do.
//!
//! Limits: a program that shares its caches and memory with busy neighbours is slower all the same,
//! so mindeg and the peer take turns and the best of several rounds counts.

use cpu_time::ProcessTime;
use std::convert::Infallible;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Short work is repeated until a sample takes so long.
const SAMPLE: Duration = Duration::from_millis(2);

/// Rounds are over when the peer has had so much time, and so many rounds, …
const ENOUGH: Duration = Duration::from_secs(1);
pub(crate) const ROUNDS: u32 = 7;
/// … or so much time whatever the rounds.
pub(crate) const TOO_MUCH: Duration = Duration::from_secs(4);

/// Times a peer, and mindeg before each of its rounds.
pub(crate) struct Clock<'a> {
    mindeg: &'a dyn Fn(),
    best: Duration,
    best_of_mindeg: Duration,
}

impl<'a> Clock<'a> {
    /// `mindeg` is its work on the same input.
    pub(crate) fn new(mindeg: &'a dyn Fn()) -> Self {
        let mut clock = Self { mindeg, best: Duration::MAX, best_of_mindeg: Duration::MAX };
        for _ in 0..ROUNDS {
            clock.time_mindeg();
        }
        clock
    }

    /// Times `work`, best of several, and gives its last result.
    pub(crate) fn time<T>(&mut self, mut work: impl FnMut() -> T) -> T {
        let Ok(result) = self.take(|| Ok::<_, Infallible>(sample(&mut work)));
        result
    }

    /// As [`time`](Self::time), for work that is timed elsewhere.
    pub(crate) fn take<T, E>(
        &mut self,
        mut timed: impl FnMut() -> Result<(Duration, T), E>,
    ) -> Result<T, E> {
        let mut spent = Duration::ZERO;
        let mut rounds = 0;
        loop {
            self.time_mindeg();
            let start = Instant::now();
            let (time, result) = timed()?;
            self.best = time.min(self.best);
            spent += start.elapsed();
            rounds += 1;
            if spent >= TOO_MUCH || spent >= ENOUGH && rounds >= ROUNDS {
                return Ok(result);
            }
        }
    }

    /// The best times in seconds: the peer's and mindeg's.
    pub(crate) fn seconds(&self) -> (f64, f64) {
        (self.best.as_secs_f64(), self.best_of_mindeg.as_secs_f64())
    }

    fn time_mindeg(&mut self) {
        let (time, ()) = sample(&mut || (self.mindeg)());
        self.best_of_mindeg = time.min(self.best_of_mindeg);
    }
}

/// The time of one run, on average over as many as take long enough, and the last result.
fn sample<T>(work: &mut impl FnMut() -> T) -> (Duration, T) {
    let start = ProcessTime::now();
    let mut result = black_box(work());
    let once = start.elapsed();
    if once >= SAMPLE {
        return (once, result);
    }
    let runs = (SAMPLE.as_nanos() / once.as_nanos().max(1) + 1) as u32;
    let start = ProcessTime::now();
    for _ in 0..runs {
        result = black_box(work());
    }
    (start.elapsed() / runs, result)
}
