//! The work as the progress callback sees it: one stage from its begin to its end.

use mindeg_mesh::{Cancelled, Progress, Step};
use std::ops::ControlFlow;

/// A stage that tells which share of it is done; shares never fall.
#[derive(Debug, Clone)]
pub(crate) struct Stage<'a> {
    progress: Progress<'a>,
    name: &'static str,
    done: u64,
    /// The shares of the whole at which the section begins and ends that work is in.
    section: [f64; 2],
    is_within: bool,
}

/// Shares are told in so many parts.
const PARTS: u64 = 1000;

impl<'a> Stage<'a> {
    /// A stage of one section.
    pub(crate) fn new(progress: Progress<'a>, name: &'static str) -> Self {
        Self { progress, name, done: 0, section: [0.0, 1.0], is_within: false }
    }

    /// The next section begins here and ends at this share of the whole.
    pub(crate) fn section(&mut self, end: f64) {
        self.section = [self.share(), end];
    }

    /// Work that takes this share of the section, as a section of its own.
    pub(crate) fn part<T>(&mut self, share: f64, work: impl FnOnce(&mut Self) -> T) -> T {
        let (section, end) = (self.section, self.section[1]);
        self.section(self.share() + share * (end - self.share()).max(0.0));
        let done = work(self);
        self.section = section;
        done
    }

    /// The share of the whole that is done.
    pub(crate) fn share(&self) -> f64 {
        self.done as f64 / PARTS as f64
    }

    /// Does work that tells of stages of its own, up to this share of the section.
    pub(crate) fn through<T>(&self, share: f64, work: impl FnOnce(Progress<'_>) -> T) -> T {
        let end = self.parts(share).max(self.done);
        let tell = |step: Step<'_>| {
            let part = (end - self.done) * step.done.min(step.total) / step.total.max(1);
            match self.progress.report(self.name, self.done + part, PARTS) {
                Ok(()) => ControlFlow::Continue(()),
                Err(Cancelled) => ControlFlow::Break(()),
            }
        };
        work(Progress::new(&tell))
    }

    fn parts(&self, share: f64) -> u64 {
        let [begin, end] = self.section;
        let share = if self.is_within { 0.0 } else { begin + (end - begin) * share };
        ((share * PARTS as f64) as u64).min(PARTS)
    }

    /// A stage within this one, whose own shares are not told.
    pub(crate) fn within(&self) -> Self {
        Self { is_within: true, ..self.clone() }
    }

    /// A share of the section from 0 to 1 is done.
    pub(crate) fn reach(&mut self, share: f64) -> Result<(), Cancelled> {
        self.done = self.done.max(self.parts(share));
        self.still()
    }

    /// Work goes on.
    pub(crate) fn still(&self) -> Result<(), Cancelled> {
        self.progress.report(self.name, self.done, PARTS)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_ends_within_its_section() {
        let mut stage = Stage::new(Progress::NONE, "work");
        stage.section(0.8);
        stage.part(0.5, |part| part.reach(1.0)).unwrap();
        assert_eq!(stage.share(), 0.4);
        stage.reach(0.75).unwrap();
        assert_eq!(stage.share(), 0.6);
        stage.reach(1.0).unwrap();
        assert_eq!(stage.share(), 0.8);
    }
}
