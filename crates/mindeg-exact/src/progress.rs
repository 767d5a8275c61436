//! The progress of one stage, as a share.

use mindeg_mesh::{Cancelled, Progress};

/// One stage of long work.
pub(crate) struct Stage<'a> {
    progress: Progress<'a>,
    name: String,
    /// The shares of the whole where it begins and ends.
    shares: [f64; 2],
}

impl<'a> Stage<'a> {
    pub(crate) fn new(progress: Progress<'a>, name: impl Into<String>) -> Self {
        Self { progress, name: name.into(), shares: [0.0, 1.0] }
    }

    /// One of so many equal parts of the stage.
    pub(crate) fn part(&self, index: usize, parts: usize) -> Self {
        let shares = [index, index + 1].map(|index| self.of_whole(index as f64 / parts as f64));
        Self { progress: self.progress, name: self.name.clone(), shares }
    }

    fn of_whole(&self, share: f64) -> f64 {
        let [from, to] = self.shares;
        from + share * (to - from)
    }

    /// Reports that this share of the stage is done, 0 to 1.
    pub(crate) fn report(&self, share: f64) -> Result<(), Cancelled> {
        /// The resolution of a report.
        const PARTS: u64 = 1000;
        self.progress.report(&self.name, (self.of_whole(share) * PARTS as f64) as u64, PARTS)
    }
}

/// The progress of an unknown number of passes: each counts for half of the share that is left.
pub(crate) struct Passes {
    left: f64,
}

impl Passes {
    pub(crate) fn new() -> Self {
        Self { left: 1.0 }
    }

    /// The share of all passes that is done, given that of the current pass.
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
    use std::ops::ControlFlow;
    use std::sync::Mutex;

    #[test]
    fn a_share_is_reported_in_thousandths() {
        let steps = Mutex::new(Vec::new());
        let note = |step: mindeg_mesh::Step<'_>| {
            steps.lock().unwrap().push((step.stage.to_owned(), step.done, step.total));
            if step.done < 1000 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        };
        let stage = Stage::new(Progress::new(&note), "counting");
        assert_eq!(
            [0.0, 0.25, 1.0].map(|share| stage.report(share).is_err()),
            [false, false, true]
        );
        // The second half of the third quarter.
        assert!(stage.part(2, 4).part(1, 2).report(0.0).is_ok());
        let expected = [0, 250, 1000, 625].map(|done| ("counting".to_owned(), done, 1000));
        assert_eq!(*steps.lock().unwrap(), expected);
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
