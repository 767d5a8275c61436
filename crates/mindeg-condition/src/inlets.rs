//! Inlets and straits about one edge wide: what single vertices and pairs of edges allow, their triangles together may not.
//!
//! In such a place there is hardly room for points, so its triangles have their corners on its shores. The best of these
//! triangulations is found exactly (`fit.rs`). Where it has hardly more than the demanded angle, what is around is meshed with points inside,
//! as the whole will be (`around.rs`). If that mesh has less there, points of the shores are moved (`shift.rs`), dropped, or
//! put on edges, each where it helps a mesh most, until there is one that has the angle.

mod around;
mod chords;
mod fit;
mod shift;
mod step;
mod straits;

use crate::chains::Chains;
use crate::changes::{BoundaryChange, ChangeKind, Left, Reason, Why};
use crate::demands::BoundaryDemands;
use crate::error::ConditionError;
use around::{Around, Meshed, Whole, size_far_inside};
use chords::inlets;
use fit::angle_of;
use glam::DVec2;
use mindeg_interior::{Interior, Options, generate_once, least_angle};
use mindeg_mesh::Progress;
use mindeg_mesh::parallel::map_all;
use mindeg_mesh::planar::PlanarBoundary;
use std::collections::{BTreeMap, BTreeSet};
use step::{Step, is_at_end};
use straits::straits;

/// So often all inlets are changed, since a change of one may be another one's.
pub(crate) const ROUNDS: usize = 2;
/// The most changes of one inlet.
const MOST_CHANGES: usize = 6;
/// Triangles of the shores alone with so many degrees more than wanted leave no doubt.
const MARGIN: f64 = 3.0;
/// The mesh of the whole may have so many degrees less at a place than that of what is around: searches differ.
const SURE: f64 = 1.0;
/// So many of the changes that help the triangles of the shores are meshed at most, to choose one.
const MOST_MESHES: usize = 8;
/// So many at the thinnest triangle of a mesh.
const MOST_AT_WORST: usize = 24;
/// So many meshes are made in search of changes at most, and one more for so many vertices: what is still too thin then is told.
const MOST_IN_ALL: usize = 100;
const VERTICES: usize = 50;
/// A change is worth so many degrees of the triangles of the shores at least, or of a mesh.
const WORTH: f64 = 0.05;
const WORTH_MESHED: f64 = 0.25;
/// The shares of the allowed distance by which a point is moved.
const SHARES: [f64; 2] = [1.0, 0.4];
/// The most edges of a boundary that is meshed as a whole to find thin triangles.
const MOST_MESHED: u32 = 20_000;
/// So many vertices to both sides of a thin triangle are its shore.
const BESIDE: usize = 2;
/// The directions in which it is.
const DIRECTIONS: usize = 8;

/// Runs of vertices with the domain on the left, in their order around a place.
type Shores = Vec<Vec<u32>>;

/// A place whose triangles may be too thin.
struct Place {
    shores: Shores,
    around: Around,
    meshed: Meshed,
}

impl Chains<'_> {
    /// Changes the inlets whose triangles cannot have the demanded angle. `prove` proves the chains as they are, and gives their boundary. Without rounds nothing is changed, and what is too thin is told.
    pub(crate) fn widen_inlets(
        &mut self,
        prove: impl Fn(&Self) -> Result<PlanarBoundary, ConditionError>,
        demands: &BoundaryDemands,
        rounds: usize,
    ) -> Result<Vec<Left>, ConditionError> {
        self.put_edges();
        let (mut is_changed, mut in_vain) = (true, BTreeSet::new());
        let mut meshes = MOST_IN_ALL + self.vertices.len() / VERTICES;
        let mut known = BTreeMap::new();
        for round in 0.. {
            let boundary = prove(self)?;
            let (inner, lines) = (boundary.inner_points(), boundary.segments());
            let triangles = mindeg_delaunay::triangles(&boundary, inner, lines, Progress::NONE)
                .map_err(|error| ConditionError::Narrow(error.to_string()))?;
            let whole = Whole::new(self.ring_order().concat(), &boundary, &triangles);
            let small = self.small(&whole, demands, &mut known);
            if !is_changed || small.is_empty() || round == rounds {
                let left = |place: &Place| Left {
                    at: self.at(place.shores[0][place.shores[0].len() / 2]),
                    limit: place.meshed.angle,
                    reason: Reason::Narrow,
                };
                let is_told = |place: &&Place| place.meshed.angle < demands.angle;
                // Two places may have the same point in their middle.
                let mut told = BTreeSet::new();
                let is_new = |left: &Left| told.insert(left.at.to_array().map(f64::to_bits));
                return Ok(small.iter().filter(is_told).map(left).filter(is_new).collect());
            }
            is_changed = false;
            for mut place in small {
                // A change of another one may have taken points of it, or put some on its edges.
                if place.shores.iter().any(|shore| !self.is_run(shore)) {
                    continue;
                }
                // Or have mended it.
                let was = Some(&place.meshed);
                if is_changed && let Some(now) = place.around.meshed(self, &place.shores, None, was)
                {
                    place.meshed = now;
                }
                let as_it_is = (place.shores.clone(), place.meshed.angle.to_bits());
                if !in_vain.contains(&as_it_is) {
                    let is_other = self.widen(place, demands, &mut meshes);
                    is_changed |= is_other;
                    in_vain.extend((!is_other).then_some(as_it_is));
                }
            }
            if is_changed {
                // An edge that grows fast may give a place its angle, and the angle counts in the end.
                let growth = if round + 1 == rounds { 0.0 } else { demands.growth };
                self.divide(&BoundaryDemands { growth, ..*demands })?;
            }
        }
        Ok(Vec::new())
    }

    /// The places where neither triangles with corners on the shores alone have an angle for sure, nor a mesh of what is around.
    /// Where each triangle has a corner inside, those of the shores alone tell nothing; a mesh of the whole tells, and it does
    /// at last everywhere, unless it would be large. `known` has the places that were meshed, by their shores.
    fn small(
        &self,
        whole: &Whole<'_>,
        demands: &BoundaryDemands,
        known: &mut BTreeMap<Shores, Meshed>,
    ) -> Vec<Place> {
        let wanted = demands.angle;
        let inlets = inlets(self, whole);
        let straits = straits(self, whole, &inlets);
        let all = inlets.into_iter().map(|shore| vec![shore]).chain(straits);
        // Where a vertex has a smaller limit of its own, that is what decides.
        let is_able = |shores: &Shores| self.least_limit(shores) >= wanted;
        let mut small = |all: Vec<Shores>| -> Vec<Place> {
            let places = map_all(all, |shores| {
                let around = whole.around(&shores)?;
                let meshed = around.meshed(self, &shores, None, known.get(&shores))?;
                Some(Place { shores, around, meshed })
            });
            let places: Vec<Place> = places.into_iter().flatten().collect();
            known.extend(places.iter().map(|place| (place.shores.clone(), place.meshed.clone())));
            places.into_iter().filter(|place| place.meshed.angle < wanted + SURE).collect()
        };
        let all = all.filter(&is_able);
        if self.least_triangles > 1 {
            let thin = self.thin_of_mesh(whole, wanted + SURE);
            let is_thin = |shores: &Shores| shores.iter().flatten().any(|v| thin.contains(v));
            let mut all: Vec<Shores> = all.filter(is_thin).collect();
            all.extend(self.runs_around(&thin, &all).into_iter().filter(&is_able));
            return small(all);
        }
        let doubtful = map_all(all.collect(), |shores: Shores| {
            let enough = wanted + MARGIN;
            (angle_of(self, &shores, None, enough) < enough).then_some(shores)
        });
        let found = small(doubtful.into_iter().flatten().collect());
        if !found.is_empty() || demands.size.is_none() || whole.boundary.edge_count() > MOST_MESHED
        {
            return found;
        }
        let thin = self.thin_of_mesh(whole, wanted);
        let runs = self.runs_around(&thin, &[]).into_iter().filter(is_able);
        small(runs.collect())
    }

    /// The vertices at and beside triangles of a mesh of the whole that are thinner than an angle.
    fn thin_of_mesh(&self, whole: &Whole<'_>, angle: f64) -> BTreeSet<u32> {
        let mut options = self.options();
        options.wanted.size_inside = size_far_inside(whole.boundary);
        let mesh = generate_once(whole.boundary, &options, Progress::NONE);
        let Ok(mesh) = mesh else { return whole.vertices.iter().copied().collect() };
        let at = |corners: &[u32; 3]| corners.map(|v| mesh.points[v as usize]);
        let thin = mesh.triangles.iter().filter(|corners| least_angle(at(corners)) < angle);
        let thin: BTreeSet<u32> = thin.flatten().copied().collect();
        let beside =
            mesh.triangles.iter().filter(|corners| corners.iter().any(|v| thin.contains(v)));
        beside.flatten().filter_map(|v| whole.vertices.get(*v as usize)).copied().collect()
    }

    /// The wishes for a mesh with so many triangles at each vertex of a ring.
    fn options(&self) -> Options {
        let corners = (self.least_triangles > 1).then_some(2);
        Interior { boundary_corners: corners, ..Interior::default() }.into()
    }

    /// Runs of vertices around those that are in no place yet.
    fn runs_around(&self, vertices: &BTreeSet<u32>, places: &[Shores]) -> Vec<Shores> {
        let mut known: BTreeSet<u32> = places.iter().flatten().flatten().copied().collect();
        let mut runs = Vec::new();
        for &vertex in vertices {
            if known.contains(&vertex) {
                continue;
            }
            let first = (0..BESIDE).fold(vertex, |v, _| self.previous(v));
            let run = std::iter::successors(Some(first), |v| Some(self.next(*v)));
            let run: Vec<u32> = run.take(2 * BESIDE + 1).collect();
            known.extend(&run);
            runs.push(vec![run]);
        }
        runs
    }

    /// Whether a shore is there, point by point.
    fn is_run(&self, shore: &[u32]) -> bool {
        shore.iter().all(|v| self.vertices[*v as usize].is_alive)
            && shore.windows(2).all(|ends| self.next(ends[0]) == ends[1])
    }

    /// Changes a place until a mesh of it has the demanded angle, or nothing more helps. Tells whether anything has changed.
    fn widen(&mut self, mut place: Place, demands: &BoundaryDemands, meshes: &mut usize) -> bool {
        let (mut is_changed, goal) = (false, demands.angle + SURE);
        for _ in 0..MOST_CHANGES {
            if place.meshed.angle >= goal {
                break;
            }
            let steps = self.of_shores(&place, demands, goal);
            let mut found = self.best_of(&steps, &place, goal, meshes);
            if found.is_none() && place.meshed.angle < demands.angle {
                let steps = self.of_worst(&place, demands);
                found = self.best_of(&steps, &place, goal, meshes);
            }
            let Some((meshed, step)) = found else { break };
            self.take(step, &mut place.shores, demands);
            place.meshed = meshed;
            is_changed = true;
        }
        is_changed
    }

    /// Of some changes the one with which a mesh of a place has the greatest angle, or the first that is enough; none if that is no greater than now.
    fn best_of(
        &self,
        steps: &[Step],
        place: &Place,
        goal: f64,
        meshes: &mut usize,
    ) -> Option<(Meshed, Step)> {
        let mut best: Option<(Meshed, Step)> = None;
        for step in steps {
            if *meshes == 0 {
                break;
            }
            *meshes -= 1;
            let Some(meshed) = place.around.meshed(self, &place.shores, Some(*step), None) else {
                continue;
            };
            let angle = meshed.angle;
            if angle > best.as_ref().map_or(place.meshed.angle + WORTH_MESHED, |best| best.0.angle)
            {
                best = Some((meshed, *step));
            }
            if angle >= goal {
                break;
            }
        }
        best
    }

    /// The changes that help the triangles with corners on the shores alone most.
    fn of_shores(&mut self, place: &Place, demands: &BoundaryDemands, goal: f64) -> Vec<Step> {
        let shores = &place.shores;
        if self.least_triangles > 1 {
            return Vec::new();
        }
        let least = (angle_of(self, shores, None, goal) + WORTH).min(goal);
        let mut steps: Vec<(f64, f64, Step)> = Vec::new();
        for step in self.steps(shores.iter().flatten(), demands) {
            let Some(moved) = self.moved_by(step, demands).filter(|_| !is_at_end(step, shores))
            else {
                continue;
            };
            let reached = angle_of(self, shores, Some(step), goal);
            if reached >= least {
                steps.push((reached.min(goal), moved, step));
            }
        }
        steps.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.total_cmp(&b.1)));
        let steps = steps.into_iter().map(|step| step.2);
        steps.filter(|step| self.is_safe(*step)).take(MOST_MESHES).collect()
    }

    /// The changes at the thinnest triangle that a mesh has there, from that which moves the shore least.
    fn of_worst(&mut self, place: &Place, demands: &BoundaryDemands) -> Vec<Step> {
        let mut steps: Vec<(f64, Step)> = Vec::new();
        for step in self.steps(&place.meshed.beside, demands) {
            let is_drop_at_end =
                matches!(step, Step::Drop { .. }) && is_at_end(step, &place.shores);
            if let Some(moved) = self.moved_by(step, demands)
                && !is_drop_at_end
            {
                steps.push((moved, step));
            }
        }
        steps.sort_by(|a, b| a.0.total_cmp(&b.0));
        let steps = steps.into_iter().map(|step| step.1);
        steps.filter(|step| self.is_safe(*step)).take(MOST_AT_WORST).collect()
    }

    /// The least limit at the shore's own vertices and those beside them.
    fn least_limit(&self, shores: &[Vec<u32>]) -> f64 {
        let around = |shore: &Vec<u32>| {
            let before = shore.first().map(|first| self.previous(*first));
            let after = shore.last().map(|last| self.next(*last));
            [before, after].into_iter().flatten()
        };
        let all = shores.iter().flatten().copied().chain(shores.iter().flat_map(around));
        all.map(|v| self.limit(v)).fold(60.0, f64::min)
    }

    /// All changes at some vertices.
    fn steps<'a>(
        &self,
        vertices: impl IntoIterator<Item = &'a u32>,
        demands: &BoundaryDemands,
    ) -> Vec<Step> {
        let mut steps = Vec::new();
        for &vertex in vertices {
            let is_old = demands.within > 0.0 && self.vertices[vertex as usize].home.is_none();
            if is_old && self.drop_distance(vertex, demands).is_some() {
                steps.push(Step::Drop { vertex });
            }
            if !self.is_kept_edge(vertex) {
                let at = self.middle(vertex);
                steps.push(Step::Insert { edge: vertex, at });
            }
            let Some((home, reach)) = self.reach(vertex, demands) else { continue };
            // Farther than an edge is long there is seldom a place for it.
            let edges = self.edges_at(vertex).map(|edge| self.length(edge));
            let reach = edges.fold(0.0, f64::max).min(reach);
            for share in SHARES {
                for direction in 0..DIRECTIONS {
                    let angle = std::f64::consts::TAU * direction as f64 / DIRECTIONS as f64;
                    let by = DVec2::new(libm::cos(angle), libm::sin(angle));
                    steps.push(Step::Shift { vertex, to: home + by * (reach * share) });
                }
            }
        }
        steps
    }

    /// How far a change moves the boundary; none if it would not do, or makes limits too small.
    fn moved_by(&mut self, step: Step, demands: &BoundaryDemands) -> Option<f64> {
        match step {
            Step::Shift { vertex, to } => {
                let moved = self.shifted_by(vertex, to, demands)?;
                let old = std::mem::replace(&mut self.vertices[vertex as usize].point.at, to);
                let around = [self.previous(vertex), vertex, self.next(vertex)];
                let own = around.into_iter().map(|v| self.limit(v)).fold(60.0, f64::min);
                self.vertices[vertex as usize].point.at = old;
                (own >= demands.angle).then_some(moved)
            }
            // Its own limits are no smaller then.
            Step::Drop { vertex } => self.drop_distance(vertex, demands),
            Step::Insert { edge, at } => {
                let [from, to] = [edge, self.next(edge)];
                let beside = self.limit_with(from, to, at).min(self.limit_with(to, from, at));
                (beside >= demands.angle).then_some(0.0)
            }
        }
    }

    /// Makes a change.
    fn take(&mut self, step: Step, shores: &mut [Vec<u32>], demands: &BoundaryDemands) {
        match step {
            Step::Shift { vertex, to } => self.shift(vertex, to, Why::Narrow, demands),
            Step::Drop { vertex } => {
                self.drop(vertex, Why::Narrow);
                shores.iter_mut().for_each(|shore| shore.retain(|v| *v != vertex));
            }
            Step::Insert { edge, at } => {
                let new = self.insert(edge, at);
                let (kind, of) = (ChangeKind::Inserted, self.vertices[edge as usize].point.edge);
                self.changes.push(BoundaryChange::of_edge(kind, at, Why::Narrow, of));
                for shore in shores {
                    if let Some(at) = shore.iter().position(|v| *v == edge) {
                        shore.insert(at + 1, new);
                    }
                }
            }
        }
    }

    /// Whether a change lets nothing cross; `drop_distance` has looked at drops.
    fn is_safe(&self, step: Step) -> bool {
        match step {
            Step::Shift { vertex, to } => self.is_shift_free(vertex, to),
            Step::Drop { .. } => true,
            Step::Insert { edge, at } => self.is_insert_free(edge, at),
        }
    }
}
