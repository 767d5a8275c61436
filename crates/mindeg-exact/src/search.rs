//! The search for the largest minimum angle, and the choice of a mesh that reaches it.

use crate::chords::Chords;
use crate::delaunay::make_delaunay;
use crate::limits::{Capacity, DegreeLimits};
use crate::linked::chord_counts;
use crate::measure::{self, least_tangent};
use crate::merit::TieBreak;
use crate::pieces::{Pieces, Rules};
use crate::problem::Problem;
use crate::progress::{Passes, Stage};
use crate::reach::reaching;
use crate::unsolved::Unsolved;
use mindeg_mesh::{Cancelled, Progress};

/// From this multiple of the known tangent on, a threshold is far above it.
const FAR: f64 = 1.02;

/// More than the tangent of 60 degrees, the largest minimum angle of any triangle.
const LARGEST_TANGENT: f64 = 1.75;

/// The triangulation with the largest minimum angle under a degree limit.
#[derive(Clone, Debug, PartialEq)]
pub struct Optimum {
    /// The degree limit for all vertices. The triangulation's maximum degree may be smaller.
    pub max_degree: u32,
    /// The minimum angle, in degrees: 0 to 60, to the 36 bits of [`measure`].
    pub min_angle: f64,
    /// The number of vertices whose degree, external edges included, equals their limit: the least
    /// with this angle.
    pub vertices_at_limit: u32,
    /// The sum of Verdict's `shape` over all triangles, 0 to n-2: the largest with this angle and
    /// this number of vertices at their limit.
    pub shape_sum: f64,
    /// The n-2 triangles, counter-clockwise from their smallest vertex, in ascending order.
    pub triangles: Vec<[u32; 3]>,
}

/// A problem with the edges that matter.
pub(crate) struct Search<'a> {
    problem: &'a Problem,
    all: &'a Chords,
    /// The edges of `all` that are in a triangulation without a tangent below the floor.
    chords: Chords,
    floor: f64,
    /// The tangent of the largest minimum angle of all triangulations.
    unlimited: f64,
    progress: Progress<'a>,
    bounds: Stage<'a>,
    passes: Passes,
}

impl<'a> Search<'a> {
    /// Finds the largest minimum angle of all triangulations. It is that of a Delaunay
    /// triangulation; the search only makes sure that rounding makes no other one better.
    pub(crate) fn new(
        problem: &'a Problem,
        all: &'a Chords,
        progress: Progress<'a>,
    ) -> Result<Self, Unsolved> {
        let mut mesh = problem.triangulation();
        make_delaunay(&mut mesh, problem.points(), problem.sides());
        let known = least_tangent(problem.points(), &mesh.triangles);
        let mut search = Self {
            problem,
            all,
            chords: all.clone(),
            floor: 0.0,
            unlimited: known,
            progress,
            bounds: Stage::new(progress, "bounding the angles"),
            passes: Passes::new(),
        };
        // A triangulation of these very edges reaches it; one of other edges would only bound nothing.
        let known = match search.reaching(known)? {
            Some(chords) => {
                (search.chords, search.floor) = (chords, known);
                known
            }
            None => 0.0,
        };
        // Usually the first pass ends it: nothing is above the known tangent.
        let (mut possible, mut bound) = (known, LARGEST_TANGENT);
        let mut threshold = possible.next_up();
        while possible < bound {
            let points = problem.points();
            match search.reaching(threshold)? {
                None => bound = threshold.next_down(),
                Some(chords) => {
                    let capacities = vec![Capacity::Unlimited; points.len()];
                    let rules = Rules { points, threshold, capacities };
                    let report = |share| search.bounds.report(search.passes.done(share));
                    let pieces = Pieces::<()>::solve(rules, &chords, report)?;
                    search.passes.next();
                    let (triangles, ()) = pieces.triangles().expect("the edges reach it");
                    possible = least_tangent(points, &triangles);
                    (search.chords, search.floor) = (chords, threshold);
                }
            }
            let middle = possible + (bound - possible) / 2.0;
            threshold = if middle > possible { middle } else { bound };
        }
        search.unlimited = possible;
        search.set_floor(possible)?;
        Ok(search)
    }

    fn reaching(&mut self, threshold: f64) -> Result<Option<Chords>, Cancelled> {
        let report = |share| self.bounds.report(self.passes.done(share));
        let chords = reaching(&self.chords, self.problem.points(), threshold, report)?;
        self.passes.next();
        Ok(chords)
    }

    /// Goes on with the edges that reach this floor, which is not below the one before.
    fn raise_floor(&mut self, floor: f64) -> Result<(), Cancelled> {
        let chords = self.reaching(floor)?;
        (self.chords, self.floor) = (chords.expect("some triangulation reaches it"), floor);
        Ok(())
    }

    /// Goes on with the edges that reach this floor, wherever it was before.
    fn set_floor(&mut self, floor: f64) -> Result<(), Cancelled> {
        if floor < self.floor {
            (self.chords, self.floor) = (self.all.clone(), 0.0);
        }
        if floor > self.floor {
            self.raise_floor(floor)?;
        }
        Ok(())
    }

    /// The tangent of the largest minimum angle of all triangulations.
    pub(crate) fn unlimited_tangent(&self) -> f64 {
        self.unlimited
    }

    /// The tangent of the largest minimum angle under the limits; `known` is one that some
    /// triangulation has.
    ///
    /// The search halves the interval between a tangent that is possible and an upper bound. A pass
    /// that finds a triangulation raises the possible tangent to that of its minimum angle; a pass
    /// that finds none lowers the bound to the largest tangent that it left out. So both are
    /// tangents of actual triangles, and they meet. At first, edges that do not reach the threshold
    /// are left out as well, and then the bound falls only to the threshold.
    pub(crate) fn best_tangent(
        &mut self,
        limits: &DegreeLimits,
        known: f64,
    ) -> Result<f64, Cancelled> {
        let stage =
            Stage::new(self.progress, format!("degree {}: the best angle", limits.max_degree));
        let points = self.problem.points();
        let (mut possible, mut bound) = (known, self.unlimited);
        // The bound itself first: often the limit costs nothing.
        let mut threshold = bound;
        while possible < bound {
            let bits = libm::log2(bound / (bound - possible));
            // Far above the possible tangent, few edges reach the threshold. Near it, the pass has
            // all edges that reach the possible tangent, so that what it leaves out bounds the
            // rest.
            self.set_floor(possible)?;
            let is_far = threshold > FAR * possible;
            let reaching = if is_far { self.reaching(threshold)? } else { None };
            let chords = reaching.as_ref().unwrap_or(&self.chords);
            let capacities = limits.capacities(chords, |chords, most| chords > most);
            let rules = Rules { points, threshold, capacities };
            let report = |_| stage.report((bits / 36.0).min(1.0));
            let pieces = Pieces::<()>::solve(rules, chords, report)?;
            if let Some((triangles, ())) = pieces.triangles() {
                possible = least_tangent(points, &triangles);
            } else {
                let of_others = if is_far { threshold.next_down() } else { possible };
                bound = possible.max(of_others).max(pieces.left_out());
            }
            let middle = possible + (bound - possible) / 2.0;
            threshold = if middle > possible { middle } else { bound };
        }
        Ok(possible)
    }

    /// The best triangulation with this minimum angle, which must be possible.
    ///
    /// Fronts grow with the number of vertices whose chords are counted, and few vertices ever
    /// reach a large limit. So chords are counted where the limit is small, and elsewhere only
    /// around vertices that reach their limit in a solution that does not count them. A solution in
    /// which none does keeps all limits, and no other one that keeps them is better.
    pub(crate) fn optimum(
        &mut self,
        limits: &DegreeLimits,
        tangent: f64,
    ) -> Result<Optimum, Unsolved> {
        const SMALL: u32 = 4;
        let max_degree = limits.max_degree;
        let stage = Stage::new(self.progress, format!("degree {max_degree}: the best mesh"));
        self.set_floor(tangent)?;
        let can_reach = |chords, most| chords >= most;
        let is_counted = |chords, most| can_reach(chords, most) && most <= SMALL;
        let mut capacities = limits.capacities(&self.chords, is_counted);
        let all_capacities = limits.capacities(&self.chords, can_reach);
        let mut passes = Passes::new();
        let mut reach = 2;
        loop {
            let rules = Rules { points: self.problem.points(), threshold: tangent, capacities };
            let report = |share| stage.report(passes.done(share));
            let pieces = Pieces::<TieBreak>::solve(rules.clone(), &self.chords, report)?;
            let (mut triangles, merit) = pieces.triangles().expect("some triangulation reaches it");
            capacities = rules.capacities;
            let at_limit = uncounted_at_limit(limits, &capacities, &triangles);
            if at_limit.is_empty() {
                triangles.sort_unstable();
                return Ok(Optimum {
                    max_degree,
                    min_angle: measure::degrees(tangent),
                    vertices_at_limit: merit.full_vertices,
                    shape_sum: merit.shape as f64 / measure::SHAPE_UNIT as f64,
                    triangles,
                });
            }
            // The chords that one vertex may not have go to its neighbours next.
            for vertex in at_limit {
                let vertices = capacities.len();
                for step in 0..=2 * reach {
                    let other = (vertex + vertices + step - reach) % vertices;
                    capacities[other] = all_capacities[other];
                }
            }
            reach = (2 * reach).min(capacities.len() / 2);
            passes.next();
        }
    }
}

/// The vertices whose chords were not counted and that have as many as they may, or more.
fn uncounted_at_limit(
    limits: &DegreeLimits,
    capacities: &[Capacity],
    triangles: &[[u32; 3]],
) -> Vec<usize> {
    let chords = chord_counts(capacities.len(), triangles);
    let is_at_limit = |&vertex: &usize| {
        capacities[vertex] == Capacity::Unlimited && chords[vertex] >= limits.chords[vertex]
    };
    (0..capacities.len()).filter(is_at_limit).collect()
}
