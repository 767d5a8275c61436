//! The search for the largest minimum angle, and the choice of a mesh that has it.

use crate::answer::Optimum;
use crate::bottleneck::Bottleneck;
use crate::chords::Chords;
use crate::measure::{self, min_angle_tangent};
use crate::merit::TieBreak;
use crate::pieces::{Pieces, Room, Rules};
use crate::problem::{Caps, Problem};
use crate::progress::{Passes, Stage, Stopped, Watch, report};

/// Whether some triangulation keeps to the cap for all and to those of single vertices.
pub(crate) fn is_feasible(
    problem: &Problem,
    max_degree: u32,
    watch: Watch<'_>,
) -> Result<bool, Stopped> {
    let Some(caps) = problem.caps(max_degree) else { return Ok(false) };
    let chords = Chords::all(problem.boundary());
    let rooms = caps.rooms(&chords, |chords, cap| chords > cap);
    let rules = Rules { points: problem.points(), threshold: 0.0, rooms };
    let pieces = Pieces::<()>::solve(rules, chords, |share| {
        report(watch, Stage::Feasibility { max_degree }, share)
    })?;
    Ok(pieces.triangles().is_some())
}

impl Caps {
    /// What the dynamic program has to count: chords where there are so many that it matters.
    fn rooms(&self, chords: &Chords, matters: impl Fn(u32, u32) -> bool) -> Vec<Room> {
        let room = |(vertex, &cap)| {
            if matters(chords.degree(vertex), cap) {
                Room::For(cap as u16)
            } else {
                Room::Unlimited
            }
        };
        self.chords.iter().enumerate().map(room).collect()
    }
}

/// A problem with the bounds that prune the work on all caps.
pub(crate) struct Search<'a> {
    problem: &'a Problem,
    bottleneck: Bottleneck,
}

impl<'a> Search<'a> {
    pub(crate) fn new(problem: &'a Problem, watch: Watch<'_>) -> Result<Self, Stopped> {
        let watch = |done| report(watch, Stage::Bounds, done);
        let bottleneck = Bottleneck::new(problem.boundary(), problem.points(), watch)?;
        Ok(Self { problem, bottleneck })
    }

    /// The tangent of the largest minimum angle of all triangulations.
    pub(crate) fn uncapped_tangent(&self) -> f64 {
        self.bottleneck.of_all()
    }

    /// The tangent of the largest minimum angle under the caps, when `known` is possible.
    ///
    /// It halves the interval between what is possible and what is not exceeded. A pass that
    /// finds a triangulation raises the one to that triangulation's smallest angle; a pass that
    /// finds none lowers the other to the largest angle of what was left out. So both are
    /// angles of actual triangles, and they meet.
    pub(crate) fn best_tangent(
        &self,
        caps: &Caps,
        known: f64,
        watch: Watch<'_>,
    ) -> Result<f64, Stopped> {
        let max_degree = caps.max_degree;
        let points = self.problem.points();
        let (mut possible, mut bound) = (known, self.uncapped_tangent());
        // The bound itself first: often the cap costs nothing.
        let mut threshold = bound;
        while possible < bound {
            let [at_least, at_most] = [possible, bound].map(measure::degrees);
            let stage = Stage::Search { max_degree, at_least, at_most };
            let bits = libm::log2(bound / (bound - possible));
            let (chords, bound_of_others) = self.bottleneck.edges_from(threshold);
            let rooms = caps.rooms(&chords, |chords, cap| chords > cap);
            let rules = Rules { points, threshold, rooms };
            let pieces = Pieces::<()>::solve(rules, chords, |_| {
                report(watch, stage, (bits / 36.0).min(1.0))
            })?;
            if let Some((triangles, ())) = pieces.triangles() {
                let corners = |triangle: &[u32; 3]| triangle.map(|vertex| points[vertex as usize]);
                let tangents =
                    triangles.iter().map(|triangle| min_angle_tangent(corners(triangle)));
                possible = tangents.fold(f64::INFINITY, f64::min);
            } else {
                bound = possible.max(bound_of_others).max(pieces.left_out());
            }
            let middle = possible + (bound - possible) / 2.0;
            threshold = if middle > possible { middle } else { bound };
        }
        Ok(possible)
    }

    /// The best triangulation with this minimum angle, which must be possible.
    ///
    /// Fronts grow with the number of vertices whose chords are counted, and of large caps few
    /// are ever met. So chords are counted where the cap is small, and elsewhere only where a
    /// solution without meets the cap. When none does, it keeps all caps, and nothing that
    /// does is better.
    pub(crate) fn optimum(
        &self,
        caps: &Caps,
        tangent: f64,
        watch: Watch<'_>,
    ) -> Result<Optimum, Stopped> {
        const SMALL: u32 = 4;
        let max_degree = caps.max_degree;
        let (chords, _) = self.bottleneck.edges_from(tangent);
        let can_meet = |chords, cap| chords >= cap;
        let mut rooms = caps.rooms(&chords, |chords, cap| can_meet(chords, cap) && cap <= SMALL);
        let all_rooms = caps.rooms(&chords, can_meet);
        let mut passes = Passes::new();
        let mut reach = 2;
        loop {
            let rules = Rules { points: self.problem.points(), threshold: tangent, rooms };
            let pieces = Pieces::<TieBreak>::solve(rules.clone(), chords.clone(), |share| {
                report(watch, Stage::Ties { max_degree }, passes.done(share))
            })?;
            let (triangles, merit) = pieces.triangles().expect("the angle is possible");
            rooms = rules.rooms;
            let met = self.uncounted_at_cap(caps, &rooms, &triangles);
            if met.is_empty() {
                return Ok(Optimum {
                    max_degree,
                    min_angle: measure::degrees(tangent),
                    vertices_at_cap: merit.full_vertices,
                    shape_sum: merit.shape as f64 / measure::SHAPE_UNIT as f64,
                    triangles,
                });
            }
            // What one vertex may not have goes to its neighbours next.
            for vertex in met {
                let vertices = rooms.len();
                for step in 0..=2 * reach {
                    let other = (vertex + vertices + step - reach) % vertices;
                    rooms[other] = all_rooms[other];
                }
            }
            reach = (2 * reach).min(rooms.len() / 2);
            passes.next();
        }
    }

    /// The vertices whose chords were not counted and that have as many as they may.
    fn uncounted_at_cap(&self, caps: &Caps, rooms: &[Room], triangles: &[[u32; 3]]) -> Vec<usize> {
        // Between the triangles at a vertex are its chords.
        let mut triangles_at = vec![0_u32; rooms.len()];
        for &vertex in triangles.as_flattened() {
            triangles_at[vertex as usize] += 1;
        }
        let is_met = |&vertex: &usize| {
            rooms[vertex] == Room::Unlimited && triangles_at[vertex] > caps.chords[vertex]
        };
        (0..rooms.len()).filter(is_met).collect()
    }
}
