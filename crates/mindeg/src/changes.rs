//! Changes of interval counts that bring the least maximum degree down where no formula tells them: of a domain with
//! holes or round a polygon that is not convex, and of a whole model.
//!
//! The positions of the points decide, so changes are tried: all of one interval, then all of two, and so on. While
//! each of them is decided, a change that is found is the smallest. Where they are too many, more intervals go to
//! one side alone, or in even shares to a ring or to all sides. The edges of a model are its sides.
//!
//! A side with points of its own keeps them: more intervals divide its longest edges. Lines inside keep their points.
//!
//! Limits: a number of tries that depends on the number of vertices, and a share of the steps of `degree` for each.

use mindeg_core::{Change, Suggestion};
use mindeg_mesh::Progress;
use mindeg_mesh::parallel::map_all;

use crate::error::MeshError;

mod listed;
mod of_domain;
mod of_model;
mod side;

pub use of_domain::{count_changes, own_boundary};
pub use of_model::model_count_changes;

/// The tries of a domain, times the square of its vertices: some seconds.
const WORK: usize = 4_000_000;
/// The least and the most tries.
const TRIES: [usize; 2] = [64, 4096];
/// The share of the steps of `degree` that a try may take.
const EFFORT: f64 = 0.02;
/// The share for the degree of a change that is found.
const FINAL_EFFORT: f64 = 0.2;
/// After this many tries without an answer, no more changes of several sides are tried.
const MOST_OPEN: usize = 16;
/// This many sides get more intervals alone, and this many rings.
const COARSEST: usize = 8;
/// The most intervals that are added to fewer vertices than these; else as many as there are vertices.
const FEW: u64 = 64;
/// Tries at the same time.
const CHUNK: usize = 16;

/// The changes that lead to smaller degrees, as far as they are found.
#[derive(Clone, Debug)]
pub struct CountChanges<T> {
    /// No mesh has a smaller maximum degree without a change.
    pub at_least: u32,
    /// Some mesh has this one without a change.
    pub reached: u32,
    /// The changes: degrees fall, costs do not.
    pub found: Vec<CountChange<T>>,
    /// No counts have a smaller least maximum degree than this.
    pub floor: u32,
    /// The first degree that no change was found for, and the size that a change for it has at least.
    pub open: Option<(u32, u64)>,
}

/// A change of counts, and the degree after it.
#[derive(Clone, Debug, PartialEq)]
pub struct CountChange<T> {
    /// The change, and a maximum degree that some mesh has after it.
    pub suggestion: Suggestion,
    /// Whether no mesh has a smaller degree after it.
    pub is_least: bool,
    /// No change of fewer intervals than this leads to a degree as small; the size of this change if it is proven to
    /// be the smallest.
    pub at_least: u64,
    /// The domain or model after it.
    pub after: T,
}

/// A domain or a model: its sides have counts of intervals, which can be others.
trait Divided: Clone + Send + Sync {
    /// How many times as long a try takes as that of a domain.
    const TRY: usize;
    /// The intervals of each side.
    fn counts(&self) -> Vec<u64>;
    fn vertex_count(&self) -> u32;
    /// The length of a side.
    fn length(&self, side: usize) -> f64;
    /// Whether a side has points that it keeps.
    fn keeps_points(&self, side: usize) -> bool;
    /// Sides that get more intervals together, besides all.
    fn together(&self) -> Vec<Vec<usize>>;
    /// The least maximum degree that any counts could have.
    fn floor(&self) -> u32;
    /// The size that a change to `target` has at least, by counting.
    fn least_size(&self, target: u32) -> u64;
    /// Whether counting excludes `target` after a change.
    fn is_excluded(&self, target: u32, by: &[Change]) -> bool;
    /// The same with other counts, if it can have them.
    fn with_counts(&self, counts: &[u64]) -> Option<Self>;
    /// A degree that no mesh is below, and one that some mesh has; the search may end once it knows about `wanted`.
    fn degree(
        &self,
        wanted: Option<u32>,
        effort: f64,
        progress: Progress<'_>,
    ) -> Result<[u32; 2], MeshError>;
}

/// The smallest changes that are found for every smaller degree, or for `wanted` alone.
fn found<T: Divided>(
    subject: &T,
    wanted: Option<u32>,
    effort: f64,
    progress: Progress<'_>,
) -> Result<CountChanges<T>, MeshError> {
    let mut tries = Tries::new(subject, effort, progress);
    let [today_at_least, today] = subject.degree(None, effort, progress)?;
    let floor = subject.floor();
    let (mut found, mut open, mut at_least) = (Vec::<CountChange<T>>::new(), None, 0);
    let mut reached = today;
    while reached > floor.max(wanted.unwrap_or(0)) {
        let target = wanted.map_or(reached - 1, |wanted| wanted.max(floor));
        if today_at_least > target {
            at_least = at_least.max(1);
        }
        let (change, proven) = tries.smallest(target, at_least)?;
        at_least = proven;
        let Some(change) = change else {
            open = Some((target, at_least));
            break;
        };
        reached = change.suggestion.max_degree;
        found.push(change);
    }
    Ok(CountChanges { at_least: today_at_least, reached: today, found, floor, open })
}

/// A change that leads to the wanted degree, and what it leads to.
type Leading<T> = (Vec<Change>, T);

/// How a try ended.
enum Tried<T> {
    Reached(T),
    Excluded,
    Open,
}

/// Tries of other counts.
struct Tries<'a, T> {
    subject: &'a T,
    counts: Vec<u64>,
    total: usize,
    left: usize,
    effort: f64,
    progress: Progress<'a>,
}

impl<'a, T: Divided> Tries<'a, T> {
    fn new(subject: &'a T, effort: f64, progress: Progress<'a>) -> Self {
        let vertices = subject.vertex_count() as usize;
        let total = (WORK / vertices.saturating_pow(2)).clamp(TRIES[0], TRIES[1]);
        let total = total / T::TRY;
        let total = (total as f64 * effort) as usize;
        Self { subject, counts: subject.counts(), total, left: total, effort, progress }
    }

    /// The smallest change that is found to lead to `target`, of `at_least` intervals, and how many it has at least.
    fn smallest(
        &mut self,
        target: u32,
        at_least: u64,
    ) -> Result<(Option<CountChange<T>>, u64), MeshError> {
        let mut at_least = at_least.max(self.subject.least_size(target));
        let (mut is_proven, mut open, mut size) = (at_least > 0, 0, at_least.max(1));
        let kept = self.left / 3;
        while open < MOST_OPEN
            && let Some(changes) = self.changes(target, size)
            && changes.len() + kept <= self.left
        {
            let (found, more_open) = self.first(target, changes)?;
            open += more_open;
            if let Some((by, after)) = found {
                return Ok((Some(self.found(by, after, at_least)?), at_least));
            }
            is_proven &= open == 0;
            size += 1;
            at_least = if is_proven { size } else { at_least };
        }
        Ok((self.of_few_kinds(target, size, at_least)?, at_least))
    }

    /// More intervals for one side alone, for those of a ring or for all: ever more of them.
    fn of_few_kinds(
        &mut self,
        target: u32,
        from: u64,
        at_least: u64,
    ) -> Result<Option<CountChange<T>>, MeshError> {
        let all: Vec<usize> = (0..self.counts.len()).collect();
        let mut coarsest = all.clone();
        coarsest.sort_by(|&a, &b| self.interval(b, 0).total_cmp(&self.interval(a, 0)));
        let mut kinds: Vec<Vec<usize>> = coarsest.iter().map(|&side| vec![side]).collect();
        kinds.truncate(COARSEST);
        kinds.extend(self.subject.together().into_iter().take(COARSEST));
        kinds.push(all);
        let most = u64::from(self.subject.vertex_count()).max(FEW);
        let (mut low, mut size) = (from, from);
        while self.left > 0 && size <= most {
            let more = kinds.iter().map(|sides| self.more(sides, size)).collect();
            if let (Some((mut changes, mut after)), _) = self.first(target, more)? {
                let is_it = |sides: &&Vec<usize>| self.more(sides, size) == changes;
                let kind = kinds.iter().find(is_it).cloned().unwrap_or_default();
                // The sizes below `low` were tried.
                while low < size && self.left > 0 {
                    let middle = low.midpoint(size);
                    let fewer = self.more(&kind, middle);
                    match self.first(target, vec![fewer])?.0 {
                        Some(found) => ((changes, after), size) = (found, middle),
                        None => low = middle + 1,
                    }
                }
                self.shrink(target, &mut changes, &mut after)?;
                return Ok(Some(self.found(changes, after, at_least)?));
            }
            low = size + 1;
            size += (size / 3).max(1);
        }
        Ok(None)
    }

    /// Takes intervals out of a change, side by side, while it leads to `target`.
    fn shrink(
        &mut self,
        target: u32,
        changes: &mut Vec<Change>,
        after: &mut T,
    ) -> Result<(), MeshError> {
        for at in 0..changes.len() {
            let mut low = 0;
            while low < changes[at].by && self.left > 0 {
                let middle = low.midpoint(changes[at].by);
                let mut fewer = changes.clone();
                fewer[at].by = middle;
                match self.first(target, vec![fewer])?.0 {
                    Some(found) => (*changes, *after) = found,
                    None => low = middle + 1,
                }
            }
        }
        changes.retain(|change| change.by != 0);
        Ok(())
    }

    /// The length of the intervals of a side with `more` of them.
    fn interval(&self, side: usize, more: i64) -> f64 {
        self.subject.length(side) / (self.counts[side] as i64 + more) as f64
    }

    /// This many more intervals on some sides, each on the one with the longest.
    fn more(&self, sides: &[usize], size: u64) -> Vec<Change> {
        let mut changes: Vec<Change> = sides.iter().map(|&side| Change { side, by: 0 }).collect();
        for _ in 0..size {
            let length = |change: &Change| self.interval(change.side, change.by);
            let longest = |a: &&mut Change, b: &&mut Change| {
                length(a).total_cmp(&length(b)).then(b.side.cmp(&a.side))
            };
            changes.iter_mut().max_by(longest).into_iter().for_each(|change| change.by += 1);
        }
        changes.retain(|change| change.by != 0);
        changes
    }

    /// The first of some changes that leads to `target`, and how many before it are open.
    fn first(
        &mut self,
        target: u32,
        changes: Vec<Vec<Change>>,
    ) -> Result<(Option<Leading<T>>, usize), MeshError> {
        let mut open = 0;
        let stage = "trying other counts";
        for chunk in changes.chunks(CHUNK) {
            self.progress.report(stage, (self.total - self.left) as u64, self.total as u64)?;
            self.left = self.left.saturating_sub(chunk.len());
            let tried = map_all(chunk.to_vec(), |by| {
                let is_excluded = self.subject.is_excluded(target, &by);
                let tried = if is_excluded { Ok(Tried::Excluded) } else { self.tried(target, &by) };
                (by, tried)
            });
            for (by, tried) in tried {
                match tried? {
                    Tried::Reached(after) => return Ok((Some((by, after)), open)),
                    Tried::Excluded => {}
                    Tried::Open => open += 1,
                }
            }
            if open >= MOST_OPEN {
                break;
            }
        }
        Ok((None, open))
    }

    fn tried(&self, target: u32, by: &[Change]) -> Result<Tried<T>, MeshError> {
        let mut counts = self.counts.clone();
        by.iter().for_each(|one| counts[one.side] = counts[one.side].saturating_add_signed(one.by));
        let Some(after) = self.subject.with_counts(&counts) else { return Ok(Tried::Excluded) };
        match after.degree(Some(target), EFFORT * self.effort, Progress::NONE) {
            Ok([_, reached]) if reached <= target => Ok(Tried::Reached(after)),
            Ok([at_least, _]) if at_least > target => Ok(Tried::Excluded),
            Ok(_) => Ok(Tried::Open),
            Err(MeshError::Cancelled(cancelled)) => Err(cancelled.into()),
            Err(_) => Ok(Tried::Open),
        }
    }

    /// A change that is found, with the degree after it.
    fn found(
        &self,
        changes: Vec<Change>,
        after: T,
        at_least: u64,
    ) -> Result<CountChange<T>, MeshError> {
        let [proven, reached] = after.degree(None, FINAL_EFFORT * self.effort, self.progress)?;
        let suggestion = Suggestion { changes, max_degree: reached };
        Ok(CountChange { suggestion, is_least: proven == reached, at_least, after })
    }
}
