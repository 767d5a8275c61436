//! The search for the largest minimum angle, and the choice of a mesh that has it.

use crate::answer::Optimum;
use crate::bottleneck::Bottleneck;
use crate::chords::Chords;
use crate::delaunay::{least_tangent, make_delaunay};
use crate::measure::{self, min_angle_tangent};
use crate::merit::TieBreak;
use crate::pieces::{Pieces, Room, Rules};
use crate::problem::{Caps, Problem};
use crate::progress::{Passes, Stage, Stopped, Watch, report};

/// A triangulation of these chords that keeps to the cap for all and to those of single
/// vertices, if there is one.
pub(crate) fn any_triangulation(
    problem: &Problem,
    chords: &Chords,
    max_degree: u32,
    watch: Watch<'_>,
) -> Result<Option<Vec<[u32; 3]>>, Stopped> {
    let Some(caps) = problem.caps(max_degree) else { return Ok(None) };
    let rooms = caps.rooms(chords, |chords, cap| chords > cap);
    let rules = Rules { points: problem.points(), threshold: 0.0, rooms };
    let pieces = Pieces::<()>::solve(rules, chords, |share| {
        report(watch, Stage::Feasibility { max_degree }, share)
    })?;
    Ok(pieces.triangles().map(|(triangles, ())| triangles))
}

impl Caps {
    /// What the dynamic program has to count: chords where there are so many that it matters.
    fn rooms(&self, chords: &Chords, matters: impl Fn(u32, u32) -> bool) -> Vec<Room> {
        let room = |(degree, &cap)| {
            if matters(degree, cap) { Room::For(cap as u16) } else { Room::Unlimited }
        };
        chords.degrees().into_iter().zip(&self.chords).map(room).collect()
    }
}

/// A problem with the bounds that prune the work on all caps.
pub(crate) struct Search<'a> {
    problem: &'a Problem,
    chords: &'a Chords,
    bottleneck: Bottleneck,
    /// Edges with smaller bounds are not in `bottleneck`.
    floor: f64,
}

impl<'a> Search<'a> {
    /// Starts from the angle of a Delaunay triangulation: no degree limit allows a larger one, and
    /// few edges have as large a bound.
    pub(crate) fn new(
        problem: &'a Problem,
        chords: &'a Chords,
        watch: Watch<'_>,
    ) -> Result<Self, Stopped> {
        let mut mesh = problem.triangulation();
        make_delaunay(&mut mesh, problem.points(), problem.sides());
        let floor = least_tangent(&mesh, problem.points(), problem.sides());
        let watch = |done| report(watch, Stage::Bounds, done);
        let bottleneck = Bottleneck::new(chords, problem.points(), floor, watch)?;
        Ok(Self { problem, chords, bottleneck, floor })
    }

    /// Goes down to edges with bounds from `floor` on.
    fn lower(&mut self, floor: f64, watch: Watch<'_>) -> Result<(), Stopped> {
        if floor < self.floor {
            let watch = |done| report(watch, Stage::Bounds, done);
            self.bottleneck = Bottleneck::new(self.chords, self.problem.points(), floor, watch)?;
            self.floor = floor;
        }
        Ok(())
    }

    /// The tangent of the largest minimum angle of all triangulations.
    pub(crate) fn uncapped_tangent(&self) -> f64 {
        self.bottleneck.of_all()
    }

    /// The tangent of the largest minimum angle under the caps, when `known` is possible.
    ///
    /// It halves the interval between what is possible and what is not exceeded. A pass that
    /// finds a triangulation raises the one to that triangulation's smallest angle; a pass that
    /// finds none lowers the other to the largest angle of what was left out, of triangles and of edges. So both are
    /// angles of actual triangles, as far as edges above the floor go, and they meet.
    pub(crate) fn best_tangent(
        &mut self,
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
            if threshold < self.floor {
                self.lower(possible.max(threshold / 2.0), watch)?;
            }
            let (chords, bound_of_others) = self.bottleneck.edges_from(threshold);
            // Of edges below the floor no more is known.
            let bound_of_others = bound_of_others.max(self.floor.next_down());
            let rooms = caps.rooms(&chords, |chords, cap| chords > cap);
            let rules = Rules { points, threshold, rooms };
            let pieces = Pieces::<()>::solve(rules, &chords, |_| {
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
        &mut self,
        caps: &Caps,
        tangent: f64,
        watch: Watch<'_>,
    ) -> Result<Optimum, Stopped> {
        const SMALL: u32 = 4;
        let max_degree = caps.max_degree;
        self.lower(tangent, watch)?;
        let (chords, _) = self.bottleneck.edges_from(tangent);
        let can_meet = |chords, cap| chords >= cap;
        let mut rooms = caps.rooms(&chords, |chords, cap| can_meet(chords, cap) && cap <= SMALL);
        let all_rooms = caps.rooms(&chords, can_meet);
        let mut passes = Passes::new();
        let mut reach = 2;
        loop {
            let rules = Rules { points: self.problem.points(), threshold: tangent, rooms };
            let pieces = Pieces::<TieBreak>::solve(rules.clone(), &chords, |share| {
                report(watch, Stage::Ties { max_degree }, passes.done(share))
            })?;
            let (mut triangles, merit) = pieces.triangles().expect("the angle is possible");
            rooms = rules.rooms;
            let met = self.uncounted_at_cap(caps, &rooms, &triangles);
            if met.is_empty() {
                triangles.sort_unstable();
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
