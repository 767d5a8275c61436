//! The least maximum degree of a domain with holes: what windows reach, bounds, strips, and then searches.

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

/// Closes a gap by searches, from the lower bound up, or as much of it as their steps suffice for.
fn close(
    problem: &Problem,
    cover: &Cover,
    range: &mut DegreeRange,
    mut steps: u64,
    progress: Progress<'_>,
) -> Result<(), Unsolved> {
    let mut is_upward = true;
    while !range.is_decided(problem) && steps > 1 {
        let wanted = problem.wanted_degree;
        let (degree, order) = if is_upward {
            (wanted.unwrap_or(range.lower_bound), Order::Chords)
        } else {
            (wanted.unwrap_or(range.max_degree - 1), Order::Active)
        };
        let Some(limits) = problem.degree_limits(degree) else { return Ok(()) };
        // Where the least degree stays open, other steps are for smaller ones than reached, in another order.
        let mut left = steps.div_ceil(2);
        steps -= left;
        let start = [range.triangles.clone()];
        let most = &limits.chords;
        let found = cover.decide_within(most, &[0.0], order, &start, &mut left, progress)?;
        steps += left;
        match found {
            Decision::Mesh(faces) => range.reach(problem, faces.concat()),
            Decision::Refuted(refutation) => {
                range.lower_bound = degree + 1;
                range.bounded_by = LowerBound::Refuted(refutation);
            }
            Decision::Unknown if is_upward => is_upward = false,
            Decision::Unknown => break,
        }
    }
    Ok(())
}
