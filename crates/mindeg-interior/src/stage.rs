//! One stage of the work as the progress callback sees it.

use mindeg_mesh::{Cancelled, Progress};

/// A stage that tells which share of it is done; shares never fall.
#[derive(Debug, Clone)]
pub(crate) struct Stage<'a> {
    progress: Progress<'a>,
    name: String,
    done: u64,
    is_within: bool,
}

/// Shares are told in so many parts.
const PARTS: u64 = 1000;

impl<'a> Stage<'a> {
    /// The stage of one of several tries; the first needs no number.
    pub(crate) fn of_try(progress: Progress<'a>, name: &str, index: usize, tries: usize) -> Self {
        let name = match index {
            0 => name.to_owned(),
            _ => format!("{name}, try {} of {tries}", index + 1),
        };
        Self { progress, name, done: 0, is_within: false }
    }

    pub(crate) fn progress(&self) -> Progress<'a> {
        self.progress
    }

    /// A stage within this one, whose own shares are not told.
    pub(crate) fn within(&self) -> Self {
        Self { is_within: true, name: self.name.clone(), ..self.clone() }
    }

    /// A share from 0 to 1 is done.
    pub(crate) fn reach(&mut self, share: f64) -> Result<(), Cancelled> {
        if self.is_within {
            return self.still();
        }
        self.done = self.done.max((share * PARTS as f64) as u64).min(PARTS);
        self.progress.report(&self.name, self.done, PARTS)
    }

    /// Work goes on.
    pub(crate) fn still(&mut self) -> Result<(), Cancelled> {
        self.progress.report(&self.name, self.done, PARTS)
    }
}
