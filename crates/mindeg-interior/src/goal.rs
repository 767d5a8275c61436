//! The aims for each vertex and for the mesh as a whole.

use crate::breaklines::Breaklines;
use crate::ears::ear_limits;
use crate::edge_limits::edge_limits;
use crate::options::Options;
use crate::star::{Sector, Stars, allotted};
use crate::tents::tent_limits;
use mindeg_domain::Prefer;
use mindeg_mesh::planar::PlanarBoundary;
use std::f64::consts::PI;
use std::ops::RangeInclusive;

/// The wanted degrees and angles of a vertex that stays.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Goal {
    /// True on the boundary, where there is one edge more than triangles.
    pub(crate) is_boundary: bool,
    /// The least number of triangles.
    pub(crate) least: u32,
    /// The greatest number of triangles that a search allows.
    pub(crate) triangles: u32,
    /// The greatest number of triangles that is wanted; fewer only where no mesh keeps it.
    pub(crate) wanted: u32,
    /// The best number of triangles: the angle over 60 degrees.
    pub(crate) ideal: f64,
    /// The greatest number of triangles that a good fan may have; any if angles are preferred.
    pub(crate) fan: Option<u32>,
    /// The star limit with so many, in degrees.
    pub(crate) limit: f64,
    /// The limit of its edges, in degrees, by their tents, by the fans at both ends together and behind sharp corners, or [`MOST`]; whatever the degrees.
    pub(crate) tents: f64,
    /// The sine of the angle that a search at one place aims at.
    pub(crate) sine: f64,
}

/// As near to its limit a search at one place brings an angle, as a share.
const NEAR_LIMIT: f64 = 0.995;

/// Tent limits from here on do not matter, in degrees: no search aims so high unasked.
pub(crate) const MOST: f64 = 40.0;

impl Goal {
    /// No triangle at the vertex need have a greater minimum angle than this, in degrees.
    pub(crate) fn local_limit(&self) -> f64 {
        self.limit.min(self.tents)
    }

    /// With the sine of its limits.
    pub(crate) fn aimed(self) -> Self {
        Self { sine: libm::sin(NEAR_LIMIT * self.local_limit().min(60.0) * (PI / 180.0)), ..self }
    }
}

/// The goals of an outline's vertices, then of the points of lines.
pub(crate) fn goals(
    outline: &PlanarBoundary,
    lines: &Breaklines,
    stars: &Stars,
    options: &Options,
) -> Vec<Goal> {
    let mut tents = tent_limits(outline, lines, MOST);
    let (low, high) = options.wanted.interior_degree().into_inner();
    let fans = |vertex: u32| stars.at(vertex).iter().map(|sector| sector.limit(None));
    let with_fans = (0..).zip(&tents).map(|(vertex, tent)| fans(vertex).fold(*tent, f64::min));
    let mut known: Vec<f64> = with_fans.collect();
    for limits_of in [edge_limits, ear_limits] {
        for (vertex, limit) in limits_of(stars, MOST, &known).into_iter().enumerate() {
            known[vertex] = known[vertex].min(limit);
            tents[vertex] = tents[vertex].min(limit);
        }
    }
    let goal = |vertex| {
        let is_boundary = vertex < outline.vertex_count();
        let (least, wanted, ideal) = match is_boundary {
            true => {
                let ideal = outline.angle(vertex) / (PI / 3.0);
                (options.wanted.least_triangles(), options.degree_limit(outline, vertex) - 1, ideal)
            }
            false => (low, high, 6.0),
        };
        let triangles = wanted.max(stars.least(vertex));
        let fan = (options.wanted.prefer() == Prefer::Degree).then_some(triangles);
        let (limit, tents) = (stars.limit(vertex, fan), tents[vertex as usize]);
        Goal { is_boundary, least, triangles, wanted, ideal, fan, limit, tents, sine: 0.0 }.aimed()
    };
    let mut goals: Vec<Goal> = (0..tents.len() as u32).map(goal).collect();
    share_out(&mut goals, outline, stars, options);
    goals
}

/// Shares out the triangles of vertices that are one: the optimiser knows each alone. The one with the widest angles may have
/// the more or the fewer that the range allows.
fn share_out(goals: &mut [Goal], outline: &PlanarBoundary, stars: &Stars, options: &Options) {
    for one in &options.joined {
        let range = options.triangles_of(outline, one);
        let sectors: Vec<Sector> =
            one.vertices.iter().flat_map(|&vertex| stars.at(vertex)).copied().collect();
        let wanted = match one.is_inside {
            true => 6.clamp(*range.start(), (*range.end()).max(*range.start())),
            false => *range.end(),
        };
        let least = |sector: &Sector| sector.least;
        let counts =
            allotted(&sectors, wanted).unwrap_or_else(|| sectors.iter().map(least).collect());
        let mut counts = counts.iter();
        let mut widest: Option<(f64, u32)> = None;
        for &vertex in &one.vertices {
            let own = stars.at(vertex).iter().zip(counts.by_ref()).map(|(_, count)| *count);
            let triangles = own.sum::<u32>().max(stars.least(vertex));
            let goal = &mut goals[vertex as usize];
            (goal.wanted, goal.triangles) = (triangles, triangles);
            if one.is_inside {
                goal.least = triangles;
            }
            let each = outline.angle(vertex) / f64::from(triangles);
            if widest.is_none_or(|(most, _)| each > most + 1e-9) {
                widest = Some((each, vertex));
            }
        }
        if let (true, Some((_, vertex))) = (one.is_inside, widest) {
            let goal = &mut goals[vertex as usize];
            let fewer = wanted.saturating_sub(*range.start());
            goal.least = goal.least.saturating_sub(fewer).max(stars.least(vertex));
            goal.wanted += range.end().saturating_sub(wanted);
            goal.triangles = goal.wanted;
        }
        for &vertex in &one.vertices {
            let goal = &mut goals[vertex as usize];
            goal.fan = goal.fan.map(|_| goal.triangles);
            goal.limit = stars.limit(vertex, goal.fan);
            *goal = goal.aimed();
        }
    }
}

/// How much each aim counts.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Weights {
    /// The minimum angle aimed at, in degrees, where the boundary allows it.
    pub(crate) floor: f64,
    /// The cost of an angle 5 degrees below the floor.
    pub(crate) angle: f64,
    /// The cost of a degree 1 beyond its limit.
    pub(crate) degree: f64,
    /// The degrees wanted inside.
    pub(crate) interior: RangeInclusive<u32>,
    /// True if a better shape may cost a violation more.
    pub(crate) may_violate: bool,
    /// The sine of the floor.
    pub(crate) floor_sine: f64,
    /// True if a triangle with all corners at the boundary is wrong.
    pub(crate) corners_inside: bool,
    /// True if what an angle lacks counts as a share of its local limit, and shape hardly.
    pub(crate) by_share: bool,
}

impl Weights {
    /// The weights of single operations.
    pub(crate) fn single(options: &Options, floor: f64) -> Self {
        let (degree, may_violate) = match options.wanted.prefer() {
            Prefer::Degree => (1e3, false),
            Prefer::Angle => (2.0, true),
        };
        Self {
            floor,
            angle: 2.0,
            degree,
            interior: options.wanted.interior_degree(),
            may_violate,
            floor_sine: libm::sin(floor.min(60.0) * (PI / 180.0)),
            corners_inside: options.wanted.has_corners_inside(),
            by_share: false,
        }
    }

    /// The weights of the search for pairs of operations: angles count more, so that no good fan is
    /// given up.
    pub(crate) fn pairs(options: &Options, floor: f64) -> Self {
        let single = Self::single(options, floor);
        Self { angle: 100.0, degree: 100.0 * single.degree, ..single }
    }

    /// The weights of the search at one place.
    pub(crate) fn local(options: &Options, floor: f64) -> Self {
        let single = Self::single(options, floor);
        let degree = if single.may_violate { 2.0 } else { 300.0 };
        Self { angle: 30.0, degree, by_share: true, ..single }
    }

    /// The goal of a vertex inside.
    pub(crate) fn goal_inside(&self) -> Goal {
        let (least, triangles) = (*self.interior.start(), *self.interior.end());
        Goal {
            is_boundary: false,
            least,
            triangles,
            wanted: triangles,
            ideal: 6.0,
            fan: None,
            limit: 60.0,
            tents: MOST,
            sine: 1.0,
        }
    }
}
