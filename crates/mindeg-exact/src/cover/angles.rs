//! The largest minimum angle under degree limits: a search for every threshold that bisection tries.

use super::Cover;
use super::decision::{Decision, Refutation, SearchedAngle};
use crate::measure::{self, least_tangent};
use crate::problem::Problem;
use mindeg_mesh::{Cancelled, Progress};

impl Cover {
    /// Whether some triangulation whose minimum angle in degrees `is_enough`, as all larger ones are, keeps the degree limits
    /// of [`largest_angle`](Self::largest_angle), as `known` does: one question instead of all that lead to that angle.
    ///
    /// # Errors
    ///
    /// A cancelled `progress`.
    pub fn reaches_angle(
        &self,
        problem: &Problem,
        max_degree: u32,
        is_enough: impl Fn(f64) -> bool,
        known: &[[u32; 3]],
        steps: u64,
        progress: Progress<'_>,
    ) -> Result<Decision, Cancelled> {
        if is_enough(measure::degrees(least_tangent(problem.points(), known))) {
            return Ok(Decision::Mesh(vec![known.to_vec()]));
        }
        let refuted = Decision::Refuted(Refutation::at_once());
        let Some(limits) = problem.degree_limits(max_degree) else { return Ok(refuted) };
        let tangents = self.tangents_above(f64::NEG_INFINITY);
        let first = tangents.partition_point(|&tangent| !is_enough(measure::degrees(tangent)));
        let Some(&tangent) = tangents.get(first) else { return Ok(refuted) };
        self.decide(&limits.chords, &[tangent], &[known.to_vec()], steps, progress)
    }

    /// The largest minimum angle of all triangulations in which no vertex has more than `max_degree` edges,
    /// external ones included, or more than its own degree limit, as far as `steps` suffice, which it takes off
    /// them. `known` keeps these limits.
    ///
    /// # Errors
    ///
    /// A cancelled `progress`.
    pub fn largest_angle(
        &self,
        problem: &Problem,
        max_degree: u32,
        known: &[[u32; 3]],
        steps: &mut u64,
        progress: Progress<'_>,
    ) -> Result<SearchedAngle, Cancelled> {
        let points = problem.points();
        let mut triangles = known.to_vec();
        let mut possible = least_tangent(points, &triangles);
        let mut is_largest = false;
        if let Some(limits) = problem.degree_limits(max_degree) {
            let thresholds = self.tangents_above(possible);
            // All below `low` are reached, all from `high` on are not: refuted, or given up.
            let (mut low, mut high) = (0, thresholds.len());
            is_largest = true;
            // Often the limit costs nothing: first Delaunay's angle, and then whether more is possible.
            let delaunay = least_tangent(points, &problem.triangulation().triangles);
            let mut next = thresholds.partition_point(|&tangent| tangent < delaunay);
            next = next.min(high.saturating_sub(1));
            let mut is_first = true;
            while low < high {
                let mut left = steps.div_ceil(2);
                *steps -= left;
                let (most, start) = (&limits.chords, [triangles.clone()]);
                let tangents = [thresholds[next]];
                let found = self.decide_within(most, &tangents, &start, &mut left, progress)?;
                *steps += left;
                let is_reached = matches!(found, Decision::Mesh(_));
                match found {
                    Decision::Mesh(faces) => {
                        triangles = faces.concat();
                        possible = least_tangent(points, &triangles);
                        low = thresholds.partition_point(|&tangent| tangent <= possible);
                    }
                    Decision::Refuted(_) => high = next,
                    Decision::Unknown => (high, is_largest) = (next, false),
                }
                next =
                    if is_first && is_reached { low } else { low + high.saturating_sub(low) / 2 };
                is_first = false;
            }
        }
        Ok(SearchedAngle { triangles, min_angle: measure::degrees(possible), is_largest })
    }
}
