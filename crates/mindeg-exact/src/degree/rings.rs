//! The least maximum degree of a domain with holes: what windows reach, bounds, strips, and then searches.

use super::descent::Descent;
use super::{DegreeRange, LowerBound, Reached, by_windows, counting_bound};
use crate::annulus;
use crate::apex::apex_bound;
use crate::cover::{
    Cover, Decision, Expected, FIRST_TURN, GROWTH, MAX_AROUND, MAX_CANDIDATES, MOST_HOLES, Search,
    hole_count,
};
use crate::linked::Linked;
use crate::problem::Problem;
use crate::progress::Stage;
use crate::unsolved::Unsolved;
use crate::visibility;
use mindeg_mesh::Progress;

impl DegreeRange {
    /// The degree that windows reach in a domain with holes, and bounds.
    pub(super) fn with_holes(
        problem: &Problem,
        mesh: &Linked,
        progress: Progress<'_>,
    ) -> Result<Self, Unsolved> {
        let lower_bound = counting_bound(problem, mesh.triangles.len());
        let (max_degree, triangles) = by_windows(problem, mesh, lower_bound, progress)?;
        let (reached_by, bounded_by) = (Reached::Windows, LowerBound::Counting);
        let mut range = DegreeRange { max_degree, lower_bound, reached_by, bounded_by, triangles };
        if range.is_decided(problem) {
            return Ok(range);
        }
        let stage = Stage::new(progress, "finding chords");
        let most = problem.max_chords();
        let pairs = visibility::pairs(mesh, problem.points(), problem.sides(), most, &stage)?;
        if let Some(pairs) = pairs {
            let mut next = vec![0; problem.points().len()];
            mesh.boundary_edges().for_each(|[from, to]| next[from as usize] = to);
            let edges = mesh.boundary_edges().chain(pairs.iter().flatten().copied());
            range.raise(apex_bound(&next, edges));
        }
        let has_one_hole = hole_count(problem) == 1;
        if has_one_hole && range.lower_bound == 4 && range.max_degree > 4 {
            if let Some(triangles) = annulus::strip(problem, mesh) {
                range.reach(problem, triangles);
                range.reached_by = Reached::Strip;
            } else {
                (range.lower_bound, range.bounded_by) = (5, LowerBound::NoStrip);
            }
        }
        let most = if has_one_hole { MAX_AROUND } else { MAX_CANDIDATES };
        if !range.is_decided(problem)
            && let Some(cover) = Cover::of_at_most(problem, most, progress)?
        {
            close(problem, &cover, &mut range, problem.max_steps(), progress)?;
        }
        Ok(range)
    }

    /// The range of a domain with holes from that of windows, which may not keep the limits of single vertices.
    pub(super) fn within_limits(
        mut self,
        problem: &Problem,
        keeps_limits: bool,
        progress: Progress<'_>,
    ) -> Result<Self, Unsolved> {
        let cover = Cover::of(problem, progress)?;
        let mut steps = problem.max_steps();
        if !keeps_limits {
            let limits = problem.degree_limits(problem.no_limit()).ok_or(Unsolved::VertexLimits)?;
            let cover = cover.as_ref().ok_or(Unsolved::Undecided)?;
            let start = [self.triangles.clone()];
            let most = &limits.chords;
            match cover.decide_within(most, &[0.0], &start, &mut steps, progress)? {
                Decision::Mesh(faces) => self.reach(problem, faces.concat()),
                Decision::Refuted(_) => return Err(Unsolved::VertexLimits),
                Decision::Unknown => return Err(Unsolved::Undecided),
            }
        }
        if let Some(cover) = cover {
            close(problem, &cover, &mut self, steps, progress)?;
        }
        Ok(self)
    }
}

/// The ways together may take the steps of one search and so many more, as a divisor: of the domains known that
/// they decide, the hardest takes more than half of them.
const MORE: u64 = 2;

/// The ways to close a gap, which take turns. Each goes on where it has stopped, so none waits long for another.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    /// A search at the lower bound, which expects a refutation.
    Refute,
    /// A descent to the next smaller degree.
    Descend,
    /// A search for the next smaller degree, which expects a mesh.
    Mesh,
    /// The dynamic program round one hole or two, at the lower bound.
    Around,
}

impl Way {
    /// Of the gaps that are left after the first turns most are refuted. Clauses are the shorter proof, where they are found soon.
    const TURNS: [Self; 7] = [
        Self::Refute,
        Self::Around,
        Self::Descend,
        Self::Refute,
        Self::Mesh,
        Self::Refute,
        Self::Refute,
    ];
}

/// Closes a gap as far as the steps suffice.
fn close(
    problem: &Problem,
    cover: &Cover,
    range: &mut DegreeRange,
    steps: u64,
    progress: Progress<'_>,
) -> Result<(), Unsolved> {
    let mut steps = steps.saturating_add(steps / MORE);
    let mut turn = (steps / FIRST_TURN).max(1);
    let mut around = steps / MORE;
    let mut refuting: UnderWay<Search<'_>> = None;
    let mut meshing: UnderWay<Search<'_>> = None;
    let mut descent: UnderWay<Descent<'_>> = None;
    let is_large = cover.candidate_count() > MAX_CANDIDATES;
    let turns: &[Way] = if is_large { &[Way::Around] } else { &Way::TURNS };
    let has_few_holes = hole_count(problem) <= MOST_HOLES;
    let ways = turns.iter().copied().filter(|way| has_few_holes || *way != Way::Around);
    let mut ways = ways.cycle().peekable();
    while let Some(&way) = ways.peek()
        && !range.is_decided(problem)
        && steps > 1
    {
        let next = match way {
            Way::Refute | Way::Around => range.lower_bound,
            Way::Descend | Way::Mesh => range.max_degree - 1,
        };
        let degree = problem.wanted_degree.unwrap_or(next);
        let Some(limits) = problem.degree_limits(degree) else { break };
        if way == Way::Around {
            // It cannot go on where it has stopped.
            let mut left = std::mem::take(&mut around);
            match cover.decide_around(problem, &limits.chords, 0.0, &mut left, progress)? {
                Some(Some(triangles)) => range.reach(problem, triangles),
                Some(None) => {
                    (range.lower_bound, range.bounded_by) = (degree + 1, LowerBound::Exhaustive);
                }
                None if is_large => break,
                None => drop(ways.next()),
            }
            around = left;
            continue;
        }
        let mut left = turn.min(steps);
        steps -= left;
        let found = if way == Way::Descend {
            let stage = Stage::new(progress, format!("looking for degree {degree}"));
            let begin = || Descent::new(problem, &range.triangles, limits.chords);
            let found = under_way(&mut descent, degree, begin).go_on(&mut left, &stage)?;
            found.map_or(Decision::Unknown, |triangles| Decision::Mesh(vec![triangles]))
        } else {
            let (search, expected) = match way {
                Way::Refute => (&mut refuting, Expected::Refutation),
                _ => (&mut meshing, Expected::Mesh),
            };
            let start = [range.triangles.clone()];
            let begin = || cover.search(&limits.chords, &[0.0], expected, &start);
            let stage = Stage::new(progress, "searching all triangulations");
            under_way(search, degree, begin).decide(&mut left, &stage)?
        };
        steps += left;
        turn += turn / GROWTH;
        match found {
            Decision::Mesh(faces) => {
                range.reach(problem, faces.concat());
                if way == Way::Descend {
                    range.reached_by = Reached::Descent;
                }
            }
            Decision::Refuted(refutation) => {
                range.lower_bound = degree + 1;
                range.bounded_by = LowerBound::Refuted(refutation);
            }
            // While a way decides, it goes on.
            Decision::Unknown => drop(ways.next()),
        }
    }
    Ok(())
}

/// The work of a way, with its degree.
type UnderWay<T> = Option<(u32, T)>;

/// The work at a degree, begun anew unless it is under way.
fn under_way<T>(work: &mut UnderWay<T>, degree: u32, begin: impl FnOnce() -> T) -> &mut T {
    let other = work.take().filter(|(of, _)| *of == degree);
    &mut work.insert(other.unwrap_or_else(|| (degree, begin()))).1
}
