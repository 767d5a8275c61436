//! Conditioning of a boundary: the least change of its points that lets a mesh with points inside reach a given minimum angle.
//!
//! A mesh keeps its boundary bit for bit, so the boundary limits its angles
//! ([`mindeg_interior::limits`]): a short edge beside a long one, a sharp corner, two long edges in a strait. What can be
//! mended without moving the boundary is mended by points on its edges; what cannot, by dropping points and cutting
//! tips, nowhere farther than a given distance.
//!
//! ```
//! use glam::DVec2;
//! use mindeg_condition::{BoundaryDemands, Hold, condition};
//! use mindeg_mesh::planar::PlanarBoundary;
//!
//! // A square with a step of a hundredth in one side.
//! let ring = [[0.0, 0.0], [5.0, 0.0], [5.0, 0.01], [10.0, 0.01], [10.0, 10.0], [0.0, 10.0]];
//! let boundary = PlanarBoundary::new(&[ring.map(DVec2::from)])?;
//! let demands = BoundaryDemands { angle: 25.0, within: 0.02, ..BoundaryDemands::default() };
//! let conditioned = condition(&boundary, &demands, |_| Hold::Free)?;
//! assert!(conditioned.before < 10.0 && conditioned.after >= 25.0);
//! assert!(conditioned.moved <= 0.02 && conditioned.left.is_empty());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Lines inside are changed as rings are, each once for both sides; where they meet each other or rings, they stay.
//!
//! With a least width, narrower straits and arms of the domain are closed first, and narrower tongues of what is outside cut off.

mod chains;
mod changes;
mod demands;
mod dropping;
mod edges;
mod error;
mod grid;
mod inlets;
mod narrow;
mod opening;
mod stars;
mod straight;
mod tips;

pub use changes::{BoundaryChange, ChangeKind, Left, Narrow, NarrowReason, Point, Reason, Why};
pub use demands::{BoundaryDemands, Hold, LEAST_GROWTH};
pub use error::ConditionError;

use crate::chains::{Chains, is_closed};
use crate::narrow::Narrowed;
use glam::DVec2;
use mindeg_mesh::planar::PlanarBoundary;
use std::collections::{BTreeMap, BTreeSet};

/// A boundary that has all that is demanded stays as it is, unless it would have less than this share of its points, or lose its last
/// short edge.
const WORTH_POINTS: f64 = 0.9;

/// A conditioned boundary.
#[derive(Debug, Clone, PartialEq)]
pub struct Conditioned {
    /// The new rings; the first is the outer one, as before.
    pub rings: Vec<Vec<Point>>,
    /// The new lines, in their order. One that was closed does not have its first point again.
    pub lines: Vec<Vec<Point>>,
    /// All changes, in the order in which they were made.
    pub changes: Vec<BoundaryChange>,
    /// The places that stay below the demanded angle.
    pub left: Vec<Left>,
    /// The places that are narrower than the least width, and stay.
    pub narrow: Vec<Narrow>,
    /// The limit of the old boundary, in degrees.
    pub before: f64,
    /// The limit of the new boundary, in degrees.
    pub after: f64,
    /// The greatest distance of a dropped point from the new boundary, which bounds the distance of both boundaries from each
    /// other, but where something narrow was closed or cut off, or a hole dropped.
    pub moved: f64,
}

/// Changes a boundary by as little as it takes for the limit of its minimum angle to reach the demanded angle.
/// `hold` tells of each edge what may happen to it and to its first vertex. There is domain on both sides of every line.
///
/// First points are dropped, each where the boundary moves least, at vertices whose limit is too small (with a size,
/// wherever edges are shorter); then sharp corners are cut; then edges are divided. Dropping a point or cutting a
/// corner needs a triangle that no other point lies in, so nothing crosses, and points inside stay in their faces; the exact
/// sweep of [`PlanarBoundary::map`] checks the result. The same input gives the same result on every machine.
///
/// O(n log n) for n points of the result where edges are short beside the domain.
///
/// # Errors
///
/// [`ConditionError`].
pub fn condition(
    boundary: &PlanarBoundary,
    demands: &BoundaryDemands,
    hold: impl Fn(u32) -> Hold,
) -> Result<Conditioned, ConditionError> {
    let on_rings = boundary.vertex_count();
    condition_map(boundary, demands, hold, |edge| [true, edge >= on_rings], |_| false, &[])
}

/// [`condition`] where not all faces are meshed: `has_domain` tells of each edge whether one that is lies on its left, and on its
/// right; `is_straight` whether it is of a side that stays straight, such as those of a box. No change takes one of `marks` to the
/// other side of an edge.
///
/// # Errors
///
/// [`ConditionError`].
pub fn condition_map(
    boundary: &PlanarBoundary,
    demands: &BoundaryDemands,
    hold: impl Fn(u32) -> Hold,
    has_domain: impl Fn(u32) -> [bool; 2],
    is_straight: impl Fn(u32) -> bool,
    marks: &[DVec2],
) -> Result<Conditioned, ConditionError> {
    demands.check()?;
    if demands.narrowest == 0.0 {
        return of_wide(boundary, demands, hold, has_domain, is_straight, marks);
    }
    let rules =
        narrow::Rules { width: demands.narrowest, hold: &hold, has_domain: &has_domain, marks };
    let Narrowed { rings, changes, narrow } = narrow::narrowed(boundary, &rules)?;
    if changes.is_empty() {
        let found = of_wide(boundary, demands, hold, has_domain, is_straight, marks)?;
        return Ok(Conditioned { narrow, ..found });
    }
    let least_triangles = demands.least_triangles;
    let given = Chains::new(boundary, &hold, &has_domain, &is_straight, marks, least_triangles);
    let before = given.limit_of_all();
    // The lines are as they were.
    let line = |line: usize| -> Vec<Point> {
        let first: u32 = (0..line).map(|line| boundary.line(line).len() as u32).sum();
        let segments = (boundary.vertex_count() + first..).zip(boundary.line(line));
        let point = |of, edge| Point { at: boundary.point(of), of: Some(of), edge };
        let last = segments.clone().last().filter(|_| !is_closed(boundary.line(line)));
        let last = last.map(|(edge, ends)| point(ends[1], edge));
        segments.map(|(edge, ends)| point(ends[0], edge)).chain(last).collect()
    };
    let lines: Vec<Vec<Point>> = (0..boundary.line_count()).map(line).collect();
    let (wide, own) = checked(boundary, &rings, &lines)?;
    let old_edge = |edge: u32| match own.get(edge as usize) {
        Some(point) if edge < wide.vertex_count() => point.edge,
        _ => edge - wide.vertex_count() + boundary.vertex_count(),
    };
    let hold_of = |edge: u32| {
        let is_new = edge < wide.vertex_count() && own[edge as usize].of.is_none();
        let hold = hold(old_edge(edge));
        if is_new && hold < Hold::Edge { Hold::Free } else { hold }
    };
    let has_domain = |edge| has_domain(old_edge(edge));
    let is_straight = |edge| is_straight(old_edge(edge));
    let mut found = of_wide(&wide, demands, hold_of, has_domain, is_straight, marks)?;
    for point in found.rings.iter_mut().chain(&mut found.lines).flatten() {
        point.of = point.of.and_then(|of| own[of as usize].of);
        point.edge = old_edge(point.edge);
    }
    for change in &mut found.changes {
        change.edge = change.edge.map(old_edge);
    }
    found.changes.splice(0..0, changes);
    Ok(Conditioned { before, narrow, ..found })
}

/// [`condition_map`] without a least width.
fn of_wide(
    boundary: &PlanarBoundary,
    demands: &BoundaryDemands,
    hold: impl Fn(u32) -> Hold,
    has_domain: impl Fn(u32) -> [bool; 2],
    is_straight: impl Fn(u32) -> bool,
    marks: &[DVec2],
) -> Result<Conditioned, ConditionError> {
    let prove = |chains: &Chains| {
        let (rings, lines) = chains.points();
        Ok(checked(boundary, &rings, &lines)?.0)
    };
    let begun = || {
        let least_triangles = demands.least_triangles;
        Chains::new(boundary, &hold, &has_domain, &is_straight, marks, least_triangles)
    };
    let mut chains = begun();
    let before = chains.limit_of_all();
    chains.drop_holes(demands.least_hole);
    let is_good = before >= demands.angle
        && chains.changes.is_empty()
        && chains.long_edges(chains.alive(), demands).is_empty()
        && chains.widen_inlets(prove, demands, 0)?.is_empty();
    let mut narrow_inlets = Vec::new();
    if !is_good || demands.size.is_some() {
        let (points, had_short) = (chains.edges().count() as f64, chains.has_short(demands));
        chains.simplify(demands);
        chains.cut_tips(demands);
        chains.open_narrow(demands);
        chains.join_short(demands);
        chains.divide(demands)?;
        narrow_inlets = chains.widen_inlets(prove, demands, inlets::ROUNDS)?;
        let is_worth_it = (chains.edges().count() as f64) < WORTH_POINTS * points
            || had_short && !chains.has_short(demands);
        if is_good && !is_worth_it {
            chains = begun();
            narrow_inlets.clear();
        }
    }
    let (rings, lines) = chains.points();
    checked(boundary, &rings, &lines)?;
    let (after, mut left, moved) = (chains.limit_of_all(), chains.left(demands), chains.moved());
    left.extend(narrow_inlets);
    let distances = chains.distances();
    let (mut changes, narrow) = (chains.changes, Vec::new());
    for change in &mut changes {
        change.moved = distances.get(&change.at.to_array().map(f64::to_bits)).copied();
    }
    Ok(Conditioned { rings, lines, changes, left, narrow, before, after, moved })
}

/// Proves the new boundary by the exact sweep. Gives it, and each of its vertices as a point of the old one.
fn checked(
    old: &PlanarBoundary,
    rings: &[Vec<Point>],
    lines: &[Vec<Point>],
) -> Result<(PlanarBoundary, Vec<Point>), ConditionError> {
    let places: Vec<Vec<DVec2>> =
        rings.iter().map(|ring| ring.iter().map(|point| point.at).collect()).collect();
    let mut own: Vec<Point> = rings.concat();
    let on_rings = own.len() as u32;
    let vertices = (0..).zip(&own);
    let mut known: BTreeMap<u32, u32> =
        vertices.filter_map(|(vertex, point)| Some((point.of?, vertex))).collect();
    // Loose points inside stay, and so are vertices of no line.
    let mut vertex = |point: &Point| {
        let new = own.len() as u32;
        let vertex = point.of.map_or(new, |of| *known.entry(of).or_insert(new));
        if vertex == new {
            own.push(*point);
        }
        vertex
    };
    let lines: Vec<Vec<u32>> = (0..)
        .zip(lines)
        .map(|(line, points)| {
            let mut vertices: Vec<u32> = points.iter().map(&mut vertex).collect();
            if is_closed(old.line(line)) {
                vertices.extend(vertices.first().copied());
            }
            vertices
        })
        .collect();
    let of_lines: BTreeSet<u32> = old.segments().as_flattened().iter().copied().collect();
    let loose = (old.vertex_count()..).zip(old.inner_points());
    let loose = loose.filter(|(vertex, _)| !of_lines.contains(vertex));
    own.extend(loose.map(|(of, at)| Point { at: *at, of: Some(of), edge: of }));
    let inner: Vec<DVec2> = own[on_rings as usize..].iter().map(|point| point.at).collect();
    let (boundary, turned) =
        PlanarBoundary::map(&places, &inner, &lines).map_err(ConditionError::Unsound)?;
    if turned.is_empty() {
        return Ok((boundary, own));
    }
    // Names the rings.
    PlanarBoundary::new(&places).map_err(ConditionError::Unsound)?;
    Ok((boundary, own))
}
