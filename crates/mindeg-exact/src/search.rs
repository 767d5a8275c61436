//! The search for the largest minimum angle, and the choice of a mesh that has it.

use crate::answer::Optimum;
use crate::chords::Chords;
use crate::delaunay::{least_tangent, make_delaunay};
use crate::measure::{self, min_angle_tangent};
use crate::merit::TieBreak;
use crate::pieces::{Pieces, Room, Rules};
use crate::problem::{Caps, Problem};
use crate::progress::{Passes, Stage, Stopped, Watch, report};
use crate::reach::reaching;
use glam::DVec2;

/// From this multiple of what is possible on, a threshold is far above it.
const FAR: f64 = 1.02;

/// More than the tangent of 60 degrees, the largest that there can be.
const LARGEST_TANGENT: f64 = 1.75;

fn smallest_tangent(points: &[DVec2], triangles: &[[u32; 3]]) -> f64 {
    let corners = |triangle: &[u32; 3]| triangle.map(|vertex| points[vertex as usize]);
    let tangents = triangles.iter().map(|triangle| min_angle_tangent(corners(triangle)));
    tangents.fold(f64::INFINITY, f64::min)
}

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

/// A problem with the edges that matter.
pub(crate) struct Search<'a> {
    problem: &'a Problem,
    all: &'a Chords,
    /// Those of `all` that are in a triangulation without a tangent below the floor.
    chords: Chords,
    floor: f64,
    /// The tangent of the largest minimum angle of all triangulations.
    uncapped: f64,
    passes: Passes,
}

impl<'a> Search<'a> {
    /// Finds the largest minimum angle of all, which is a Delaunay triangulation's; the search
    /// only makes sure that no other one is better by rounding.
    pub(crate) fn new(
        problem: &'a Problem,
        all: &'a Chords,
        watch: Watch<'_>,
    ) -> Result<Self, Stopped> {
        let mut mesh = problem.triangulation();
        make_delaunay(&mut mesh, problem.points(), problem.sides());
        let known = least_tangent(&mesh, problem.points(), problem.sides());
        let chords = all.clone();
        let passes = Passes::new();
        let mut search = Self { problem, all, chords, floor: 0.0, uncapped: known, passes };
        search.raise_floor(known, watch)?;
        // Usually the first pass ends it: nothing is above what is known.
        let (mut possible, mut bound) = (search.uncapped, LARGEST_TANGENT);
        let mut threshold = possible.next_up();
        while possible < bound {
            let points = problem.points();
            match search.reaching(threshold, watch)? {
                None => bound = threshold.next_down(),
                Some(chords) => {
                    let rooms = vec![Room::Unlimited; points.len()];
                    let rules = Rules { points, threshold, rooms };
                    let pieces = Pieces::<()>::solve(rules, &chords, |_| Ok(()))?;
                    let (triangles, ()) = pieces.triangles().expect("the edges reach it");
                    possible = smallest_tangent(points, &triangles);
                    (search.chords, search.floor) = (chords, threshold);
                }
            }
            let middle = possible + (bound - possible) / 2.0;
            threshold = if middle > possible { middle } else { bound };
        }
        search.uncapped = possible;
        search.set_floor(possible, watch)?;
        Ok(search)
    }

    fn reaching(&mut self, threshold: f64, watch: Watch<'_>) -> Result<Option<Chords>, Stopped> {
        let passes = &self.passes;
        let chords = reaching(&self.chords, self.problem.points(), threshold, |share| {
            report(watch, Stage::Bounds, passes.done(share))
        })?;
        self.passes.next();
        Ok(chords)
    }

    /// Goes on with the edges that reach this floor, which is not below the one before.
    fn raise_floor(&mut self, floor: f64, watch: Watch<'_>) -> Result<(), Stopped> {
        let chords = self.reaching(floor, watch)?;
        (self.chords, self.floor) = (chords.expect("some triangulation reaches it"), floor);
        Ok(())
    }

    /// Goes on with the edges that reach this floor, wherever it was before.
    fn set_floor(&mut self, floor: f64, watch: Watch<'_>) -> Result<(), Stopped> {
        if floor < self.floor {
            (self.chords, self.floor) = (self.all.clone(), 0.0);
        }
        if floor > self.floor {
            self.raise_floor(floor, watch)?;
        }
        Ok(())
    }

    /// The tangent of the largest minimum angle of all triangulations.
    pub(crate) fn uncapped_tangent(&self) -> f64 {
        self.uncapped
    }

    /// The tangent of the largest minimum angle under the caps, when `known` is possible.
    ///
    /// It halves the interval between what is possible and what is not exceeded. A pass that
    /// finds a triangulation raises the one to that triangulation's smallest angle; a pass that
    /// finds none lowers the other to the largest angle of what was left out. So both are
    /// angles of actual triangles, and they meet. At first, edges that do not reach the threshold
    /// are left out as well, and no more is known of those.
    pub(crate) fn best_tangent(
        &mut self,
        caps: &Caps,
        known: f64,
        watch: Watch<'_>,
    ) -> Result<f64, Stopped> {
        let max_degree = caps.max_degree;
        let points = self.problem.points();
        let (mut possible, mut bound) = (known, self.uncapped);
        // The bound itself first: often the cap costs nothing.
        let mut threshold = bound;
        while possible < bound {
            let [at_least, at_most] = [possible, bound].map(measure::degrees);
            let stage = Stage::Search { max_degree, at_least, at_most };
            let bits = libm::log2(bound / (bound - possible));
            // Far from what is possible, few edges reach the threshold. Near it, all that reach what
            // is possible are there, so that what is left out tells how far the bound may fall.
            self.set_floor(possible, watch)?;
            let is_far = threshold > FAR * possible;
            let reaching = if is_far { self.reaching(threshold, watch)? } else { None };
            let chords = reaching.as_ref().unwrap_or(&self.chords);
            let rooms = caps.rooms(chords, |chords, cap| chords > cap);
            let rules = Rules { points, threshold, rooms };
            let pieces = Pieces::<()>::solve(rules, chords, |_| {
                report(watch, stage, (bits / 36.0).min(1.0))
            })?;
            if let Some((triangles, ())) = pieces.triangles() {
                possible = smallest_tangent(points, &triangles);
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
        self.set_floor(tangent, watch)?;
        let chords = self.chords.clone();
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
