//! The least maximum degree of a domain with holes: what windows reach, bounds, strips, and then searches.

use super::descent::descend;
use super::{DegreeRange, LowerBound, Reached, by_windows, counting_bound};
use crate::annulus;
use crate::apex::apex_bound;
use crate::cover::{Cover, Decision, Order};
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
        let has_one_hole = mesh.triangles.len() == problem.points().len();
        if has_one_hole && range.lower_bound == 4 && range.max_degree > 4 {
            if let Some(triangles) = annulus::strip(problem, mesh) {
                range.reach(problem, triangles);
                range.reached_by = Reached::Strip;
            } else {
                (range.lower_bound, range.bounded_by) = (5, LowerBound::NoStrip);
            }
        }
        if !range.is_decided(problem)
            && let Some(cover) = Cover::of(problem, progress)?
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
            match cover.decide_within(most, &[0.0], Order::Chords, &start, &mut steps, progress)? {
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

/// One way to close a gap. Each is taken until it fails, and then the next.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    /// A short search at the lower bound: most that can be decided it decides.
    Short,
    /// Descent to the next smaller degree.
    Descent,
    /// A long search at the lower bound.
    Long,
    /// A search for the next smaller degree, in another order of decisions.
    Other,
}

impl Way {
    const ALL: [Self; 4] = [Self::Short, Self::Descent, Self::Long, Self::Other];

    /// The part of the steps that are left, as a divisor.
    fn share(self) -> u64 {
        match self {
            Self::Short => 32,
            Self::Descent => 8,
            Self::Long | Self::Other => 2,
        }
    }
}

/// Closes a gap as far as the steps suffice, from the lower bound up.
fn close(
    problem: &Problem,
    cover: &Cover,
    range: &mut DegreeRange,
    mut steps: u64,
    progress: Progress<'_>,
) -> Result<(), Unsolved> {
    let mut ways = Way::ALL.into_iter();
    let mut way = ways.next();
    while let Some(taken) = way
        && !range.is_decided(problem)
        && steps > 1
    {
        let next = match taken {
            Way::Short | Way::Long => range.lower_bound,
            Way::Descent | Way::Other => range.max_degree - 1,
        };
        let degree = problem.wanted_degree.unwrap_or(next);
        let Some(limits) = problem.degree_limits(degree) else { return Ok(()) };
        let most = &limits.chords;
        let mut left = steps.div_ceil(taken.share());
        steps -= left;
        let found = if taken == Way::Descent {
            let stage = Stage::new(progress, format!("looking for degree {degree}"));
            let found = descend(problem, &range.triangles, most, &mut left, &stage)?;
            found.map_or(Decision::Unknown, |triangles| Decision::Mesh(vec![triangles]))
        } else {
            let order = if taken == Way::Other { Order::Active } else { Order::Chords };
            let start = [range.triangles.clone()];
            cover.decide_within(most, &[0.0], order, &start, &mut left, progress)?
        };
        steps += left;
        match found {
            Decision::Mesh(faces) => {
                range.reach(problem, faces.concat());
                if taken == Way::Descent {
                    range.reached_by = Reached::Descent;
                }
            }
            Decision::Refuted(refutation) => {
                range.lower_bound = degree + 1;
                range.bounded_by = LowerBound::Refuted(refutation);
            }
            Decision::Unknown => way = ways.next(),
        }
    }
    Ok(())
}
