//! The largest minimum angle under degree limits: a search for every threshold that bisection tries.

use super::cut::Decided;
use super::decision::{Decision, SearchedAngle};
use super::{Cover, FIRST_TURN, MOST_HOLES, hole_count};
use crate::measure::{self, least_tangent};
use crate::problem::Problem;
use mindeg_mesh::{Cancelled, Progress};

impl Cover {
    /// A triangulation whose minimum angle in degrees `is_enough`, as all larger ones are, and that keeps the degree limits
    /// of [`largest_angle`](Self::largest_angle), as `known` does, if there is one; none if `steps` are too few to know. One
    /// question instead of all that lead to the largest angle.
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
        mut steps: u64,
        progress: Progress<'_>,
    ) -> Result<Option<Option<Vec<[u32; 3]>>>, Cancelled> {
        if is_enough(measure::degrees(least_tangent(problem.points(), known))) {
            return Ok(Some(Some(known.to_vec())));
        }
        let Some(limits) = problem.degree_limits(max_degree) else { return Ok(Some(None)) };
        let tangents = self.tangents_above(f64::NEG_INFINITY);
        let first = tangents.partition_point(|&tangent| !is_enough(measure::degrees(tangent)));
        let Some(&tangent) = tangents.get(first) else { return Ok(Some(None)) };
        self.decide_wide(problem, &limits.chords, tangent, known, &mut steps, progress)
    }

    /// A triangulation without smaller angles that keeps the numbers of chords: round one hole or two by the dynamic program,
    /// unless clauses are soon enough.
    fn decide_wide(
        &self,
        problem: &Problem,
        most: &[u32],
        tangent: f64,
        known: &[[u32; 3]],
        steps: &mut u64,
        progress: Progress<'_>,
    ) -> Result<Decided, Cancelled> {
        let (tangents, start) = ([tangent], [known.to_vec()]);
        let by_clauses = |left: &mut u64| {
            Ok(match self.decide_within(most, &tangents, &start, left, progress)? {
                Decision::Mesh(faces) => Some(Some(faces.concat())),
                Decision::Refuted(_) => Some(None),
                Decision::Unknown => None,
            })
        };
        if !(1..=MOST_HOLES).contains(&hole_count(problem)) {
            return by_clauses(steps);
        }
        let mut left = *steps / FIRST_TURN;
        *steps -= left;
        let mut found = by_clauses(&mut left)?;
        *steps += left;
        if found.is_none() {
            left = *steps / 2;
            *steps -= left;
            found = self.decide_around(problem, most, tangent, &mut left, progress)?;
            *steps += left;
        }
        if found.is_none() { by_clauses(steps) } else { Ok(found) }
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
                let (most, tangent) = (&limits.chords, thresholds[next]);
                let found =
                    self.decide_wide(problem, most, tangent, &triangles, &mut left, progress)?;
                *steps += left;
                let is_reached = matches!(found, Some(Some(_)));
                match found {
                    Some(Some(found)) => {
                        triangles = found;
                        possible = least_tangent(points, &triangles);
                        low = thresholds.partition_point(|&tangent| tangent <= possible);
                    }
                    Some(None) => high = next,
                    None => (high, is_largest) = (next, false),
                }
                next =
                    if is_first && is_reached { low } else { low + high.saturating_sub(low) / 2 };
                is_first = false;
            }
        }
        Ok(SearchedAngle { triangles, min_angle: measure::degrees(possible), is_largest })
    }
}
