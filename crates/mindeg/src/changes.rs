//! Changes of interval counts that bring the least maximum degree of a domain down where no formula tells them:
//! with holes, and round a polygon that is not convex.
//!
//! The positions of the points decide, so changes are tried: all of one interval, then all of two, and so on. While
//! each of them is decided, a change that is found is the smallest. Where they are too many, more intervals go to
//! one side alone, or in even shares to a ring or to all sides.
//!
//! A side with points of its own keeps them: more intervals divide its longest edges. Lines inside keep their points.
//!
//! Limits: a number of tries that depends on the number of vertices, and a share of the steps of `degree` for each.

use glam::DVec2;
use mindeg_core::{Change, Suggestion};
use mindeg_domain::{Constraints, Domain, ExternalDegree, SideConstraint};
use mindeg_mesh::Progress;
use mindeg_mesh::parallel::map_all;

use crate::degree::{DegreeAnswer, degree_decided};
use crate::error::MeshError;

mod listed;
mod side;

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
pub struct CountChanges {
    /// The degree without a change.
    pub today: DegreeAnswer,
    /// The changes: degrees fall, costs do not.
    pub found: Vec<CountChange>,
    /// No counts have a smaller least maximum degree than this.
    pub floor: u32,
    /// The first degree that no change was found for, and the size that a change for it has at least.
    pub open: Option<(u32, u64)>,
}

/// A change of counts, and the degree after it.
#[derive(Clone, Debug, PartialEq)]
pub struct CountChange {
    /// The change, and a maximum degree that some mesh has after it.
    pub suggestion: Suggestion,
    /// Whether no mesh has a smaller degree after it.
    pub is_least: bool,
    /// No change of fewer intervals than this leads to a degree as small; the size of this change if it is proven to
    /// be the smallest.
    pub at_least: u64,
    /// The domain after it.
    pub domain: Domain,
}

/// The smallest changes of counts that are found for every smaller degree, or for `wanted` alone.
///
/// Of changes of the same size the first that is found is taken: one that adds before one that removes, of few sides
/// before one of many.
///
/// # Errors
///
/// A domain with degrees of single vertices, which other counts would move; the errors of
/// [`degree`](crate::exact::degree).
///
/// # Example
///
/// ```
/// use mindeg::{Domain, Progress, Ring, Side, changes::count_changes};
///
/// // Degree 4 takes rings of as many vertices: here 8 and 7.
/// let square = |half: f64| [(-half, -half), (half, -half), (half, half), (-half, half)];
/// let ring = |half, counts: [u64; 4]| Ring::new(square(half), counts.map(Side::count).into());
/// let domain = Domain::of_rings(vec![ring(2.0, [2, 2, 2, 2]), ring(1.0, [2, 1, 2, 2])])?;
/// let changes = count_changes(&domain, None, Progress::NONE)?;
/// assert_eq!((changes.today.reached, changes.floor), (5, 4));
/// assert_eq!(changes.found[0].suggestion.max_degree, 4);
/// assert_eq!(changes.found[0].suggestion.cost(), 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn count_changes(
    domain: &Domain,
    wanted: Option<u32>,
    progress: Progress<'_>,
) -> Result<CountChanges, MeshError> {
    if constrains_vertices(domain.constraints()) {
        return Err(MeshError::refused(
            "the domain gives outside_degree or max_degree of single vertices, which other counts would move; mindeg \
             degree, mesh and tradeoff keep to them",
        ));
    }
    if domain.periodic().is_some() {
        return Err(MeshError::refused(
            "the domain has periodic sides, whose counts change with those of others; mindeg degree and mesh count on the joined \
             mesh",
        ));
    }
    let mut tries = Tries::new(domain, progress);
    let today = degree_decided(domain, None, 1.0, progress)?;
    let floor = floor(domain);
    let (mut found, mut open, mut at_least) = (Vec::<CountChange>::new(), None, 0);
    let mut reached = today.reached;
    while reached > floor.max(wanted.unwrap_or(0)) {
        let target = wanted.map_or(reached - 1, |wanted| wanted.max(floor));
        if today.at_least > target {
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
    Ok(CountChanges { today, found, floor, open })
}

/// Whether degrees are given vertex by vertex.
fn constrains_vertices(constraints: &Constraints) -> bool {
    let each = |side: &SideConstraint| matches!(side.external_degree, ExternalDegree::Each(_));
    !constraints.vertices.is_empty() || constraints.sides.iter().any(each)
}

/// The least maximum degree that any counts could have. Without a hole an ear is left out only of few vertices; with
/// several, the mean of the degrees is above 4. Lines and points inside may join rings, or make small triangles.
fn floor(domain: &Domain) -> u32 {
    match domain.rings().ring_count() - 1 {
        _ if domain.is_map() => 2,
        0 => (domain.rings().side_count() as u32).clamp(3, 5) - 1,
        1 => 4,
        _ => 5,
    }
}

/// A change that leads to the wanted degree, and the domain after it.
type Leading = (Vec<Change>, Box<Domain>);

/// How a try ended.
enum Tried {
    Reached(Box<Domain>),
    Excluded,
    Open,
}

/// Tries of other counts.
struct Tries<'a> {
    domain: &'a Domain,
    counts: Vec<u64>,
    total: usize,
    left: usize,
    progress: Progress<'a>,
}

impl<'a> Tries<'a> {
    fn new(domain: &'a Domain, progress: Progress<'a>) -> Self {
        let vertices = domain.rings().vertex_count() as usize;
        let total = (WORK / vertices.saturating_pow(2)).clamp(TRIES[0], TRIES[1]);
        Self {
            domain,
            counts: domain.rings().sides().map(u64::from).collect(),
            total,
            left: total,
            progress,
        }
    }

    /// The points where a side begins and ends.
    fn ends(&self, side: usize) -> [DVec2; 2] {
        let rings = self.domain.rings();
        let own = rings.ring_sides(rings.in_ring(side).ring);
        let next = if side + 1 == own.end { own.start } else { side + 1 };
        [side, next].map(|corner| self.domain.placement().corners()[corner])
    }

    /// The smallest change that is found to lead to `target`, of `at_least` intervals, and how many it has at least.
    fn smallest(
        &mut self,
        target: u32,
        at_least: u64,
    ) -> Result<(Option<CountChange>, u64), MeshError> {
        let mut at_least = at_least.max(self.least_size(target));
        let (mut is_proven, mut open, mut size) = (at_least > 0, 0, at_least.max(1));
        let kept = self.left / 3;
        while open < MOST_OPEN
            && let Some(changes) = self.changes(target, size)
            && changes.len() + kept <= self.left
        {
            let (found, more_open) = self.first(target, changes)?;
            open += more_open;
            if let Some((by, domain)) = found {
                return Ok((Some(self.found(by, domain, at_least)?), at_least));
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
    ) -> Result<Option<CountChange>, MeshError> {
        let all: Vec<usize> = (0..self.counts.len()).collect();
        let mut coarsest = all.clone();
        coarsest.sort_by(|&a, &b| self.interval(b, 0).total_cmp(&self.interval(a, 0)));
        let rings = self.domain.rings();
        let of_ring = |ring: usize| rings.ring_sides(ring).collect();
        let mut kinds: Vec<Vec<usize>> = coarsest.iter().map(|&side| vec![side]).collect();
        kinds.truncate(COARSEST);
        kinds.extend((0..rings.ring_count()).map(of_ring).take(COARSEST));
        kinds.push(all);
        let most = u64::from(rings.vertex_count()).max(FEW);
        let (mut low, mut size) = (from, from);
        while self.left > 0 && size <= most {
            let more = kinds.iter().map(|sides| self.more(sides, size)).collect();
            if let (Some((mut changes, mut domain)), _) = self.first(target, more)? {
                let is_it = |sides: &&Vec<usize>| self.more(sides, size) == changes;
                let kind = kinds.iter().find(is_it).cloned().unwrap_or_default();
                // The sizes below `low` were tried.
                while low < size && self.left > 0 {
                    let middle = low.midpoint(size);
                    let fewer = self.more(&kind, middle);
                    match self.first(target, vec![fewer])?.0 {
                        Some(found) => ((changes, domain), size) = (found, middle),
                        None => low = middle + 1,
                    }
                }
                self.shrink(target, &mut changes, &mut domain)?;
                return Ok(Some(self.found(changes, domain, at_least)?));
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
        domain: &mut Box<Domain>,
    ) -> Result<(), MeshError> {
        for at in 0..changes.len() {
            let mut low = 0;
            while low < changes[at].by && self.left > 0 {
                let middle = low.midpoint(changes[at].by);
                let mut fewer = changes.clone();
                fewer[at].by = middle;
                match self.first(target, vec![fewer])?.0 {
                    Some(found) => (*changes, *domain) = found,
                    None => low = middle + 1,
                }
            }
        }
        changes.retain(|change| change.by != 0);
        Ok(())
    }

    /// The length of the intervals of a side with `more` of them.
    fn interval(&self, side: usize, more: i64) -> f64 {
        self.domain.placement().side_length(side) / (self.counts[side] as i64 + more) as f64
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
    ) -> Result<(Option<Leading>, usize), MeshError> {
        let mut open = 0;
        let stage = "trying other counts";
        for chunk in changes.chunks(CHUNK) {
            self.progress.report(stage, (self.total - self.left) as u64, self.total as u64)?;
            self.left = self.left.saturating_sub(chunk.len());
            let tried = map_all(chunk.to_vec(), |by| {
                let is_excluded = self.is_excluded(target, &by);
                let tried = if is_excluded { Ok(Tried::Excluded) } else { self.tried(target, &by) };
                (by, tried)
            });
            for (by, tried) in tried {
                match tried? {
                    Tried::Reached(domain) => return Ok((Some((by, domain)), open)),
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

    fn tried(&self, target: u32, by: &[Change]) -> Result<Tried, MeshError> {
        let mut sides = self.domain.sides().to_vec();
        for &Change { side, by } in by {
            let count = self.counts[side].saturating_add_signed(by);
            sides[side] = side::with_intervals(&sides[side], self.ends(side), count);
        }
        // Rings that touch or have too few vertices are no domain.
        let Ok(domain) = self.domain.with_sides(sides) else { return Ok(Tried::Excluded) };
        match degree_decided(&domain, Some(target), EFFORT, Progress::NONE) {
            Ok(answer) if answer.reached <= target => Ok(Tried::Reached(Box::new(domain))),
            Ok(answer) if answer.at_least > target => Ok(Tried::Excluded),
            Ok(_) => Ok(Tried::Open),
            Err(MeshError::Cancelled(cancelled)) => Err(cancelled.into()),
            Err(_) => Ok(Tried::Open),
        }
    }

    /// A change that is found, with the degree after it.
    fn found(
        &self,
        changes: Vec<Change>,
        domain: Box<Domain>,
        at_least: u64,
    ) -> Result<CountChange, MeshError> {
        let answer = degree_decided(&domain, None, FINAL_EFFORT, self.progress)?;
        let is_least = answer.least_max_degree().is_some();
        let suggestion = Suggestion { changes, max_degree: answer.reached };
        Ok(CountChange { suggestion, is_least, at_least, domain: *domain })
    }
}
