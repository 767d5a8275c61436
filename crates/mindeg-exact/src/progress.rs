//! Watching long work, and stopping it.

use std::fmt;
use std::ops::ControlFlow;

/// What is being worked on, and how far it is.
///
/// # Example
///
/// ```
/// use mindeg_exact::{Progress, Stage};
///
/// let progress = Progress { stage: Stage::Bounds, done: 0.25 };
/// assert_eq!(progress.to_string(), "bounding the angles: 25%");
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// The stage.
    pub stage: Stage,
    /// The share of the stage that is done, 0 to 1; it never falls within a stage. Searching
    /// and choosing take a number of passes that is not known before: there it is a guess on
    /// the safe side, and they end early.
    pub done: f64,
}

/// The stages of the work, in this order; the last two come for every cap.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Stage {
    /// Finding out whether a cap can be kept, where single vertices have limits.
    Feasibility {
        /// The cap.
        max_degree: u32,
    },
    /// Retriangulating windows around the vertices with the most edges.
    Windows {
        /// The largest number of edges at a vertex so far.
        max_degree: u32,
    },
    /// Finding the best angle that goes with each edge, degrees aside.
    Bounds,
    /// Searching for the largest minimum angle under a cap.
    Search {
        /// The cap.
        max_degree: u32,
        /// An angle that is possible, in degrees.
        at_least: f64,
        /// An angle that cannot be exceeded, in degrees.
        at_most: f64,
    },
    /// Choosing among the triangulations that have it.
    Ties {
        /// The cap.
        max_degree: u32,
    },
}

impl fmt::Display for Progress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.stage {
            Stage::Feasibility { max_degree } => write!(f, "degree {max_degree}, is it possible")?,
            Stage::Windows { max_degree } => write!(f, "windows, from degree {max_degree} down")?,
            Stage::Bounds => f.write_str("bounding the angles")?,
            Stage::Search { max_degree, at_least, at_most } => {
                write!(f, "degree {max_degree}, between {at_least:.3} and {at_most:.3} degrees")?;
            }
            Stage::Ties { max_degree } => write!(f, "degree {max_degree}, choosing the mesh")?,
        }
        write!(f, ": {:.0}%", 100.0 * self.done)
    }
}

/// Hears of progress many times a second, on the thread that asked for the work, and stops it by
/// answering with a break. [`unwatched`] is one.
pub type Watch<'a> = &'a mut dyn FnMut(Progress) -> ControlFlow<()>;

/// A [`Watch`] that never stops anything.
pub fn unwatched(_: Progress) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// A [`Watch`] answered with a break.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Stopped;

pub(crate) fn report(watch: Watch<'_>, stage: Stage, done: f64) -> Result<(), Stopped> {
    match watch(Progress { stage, done }) {
        ControlFlow::Continue(()) => Ok(()),
        ControlFlow::Break(()) => Err(Stopped),
    }
}

/// The progress of passes whose number is not known: each is taken for half of what is left.
pub(crate) struct Passes {
    left: f64,
}

impl Passes {
    pub(crate) fn new() -> Self {
        Self { left: 1.0 }
    }

    /// What is done when this share of the current pass is.
    pub(crate) fn done(&self, share: f64) -> f64 {
        1.0 - self.left * (1.0 - share / 2.0)
    }

    pub(crate) fn next(&mut self) {
        self.left /= 2.0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_stage_is_put_into_words() {
        let search = Stage::Search { max_degree: 5, at_least: 2.5, at_most: 6.340_19 };
        for (stage, done, words) in [
            (Stage::Feasibility { max_degree: 7 }, 0.0, "degree 7, is it possible: 0%"),
            (Stage::Windows { max_degree: 9 }, 0.0, "windows, from degree 9 down: 0%"),
            (Stage::Bounds, 0.999, "bounding the angles: 100%"),
            (search, 0.5, "degree 5, between 2.500 and 6.340 degrees: 50%"),
            (Stage::Ties { max_degree: 114 }, 0.5, "degree 114, choosing the mesh: 50%"),
        ] {
            assert_eq!(Progress { stage, done }.to_string(), words);
        }
    }

    #[test]
    fn passes_go_on_where_the_last_one_ended() {
        let mut passes = Passes::new();
        assert_eq!(passes.done(0.0), 0.0);
        for _ in 0..10 {
            let end = passes.done(1.0);
            passes.next();
            assert_eq!(passes.done(0.0), end);
            assert!(passes.done(0.5) > end && passes.done(1.0) < 1.0);
        }
    }
}
