//! One round of changes, but for narrow places.

use crate::chains::{Chains, is_closed};
use crate::changes::{Conditioned, Point};
use crate::demands::{BoundaryDemands, Given, Hold};
use crate::error::ConditionError;
use crate::inlets;
use crate::past::Past;
use glam::DVec2;
use mindeg_mesh::planar::PlanarBoundary;
use std::collections::{BTreeMap, BTreeSet};

/// A boundary that has all that is demanded stays as it is, unless it would have less than this share of its points, or lose its last
/// short edge.
const WORTH_POINTS: f64 = 0.9;

/// A round's boundary, with all that a later round takes from it.
pub(crate) struct Round {
    pub(crate) found: Conditioned,
    pub(crate) past: Vec<Past>,
    /// The boundary as it was proven, and each of its vertices as a point of the old one.
    pub(crate) checked: (PlanarBoundary, Vec<Point>),
}

/// [`crate::condition_map`] without a least width. With what the boundary has of an earlier round, only what does not have the demands changes.
pub(crate) fn of_wide<H, D, S>(
    boundary: &PlanarBoundary,
    demands: &BoundaryDemands,
    given: &Given<'_, H, D, S>,
    past: Option<&[Past]>,
) -> Result<Round, ConditionError>
where
    H: Fn(u32) -> Hold,
    D: Fn(u32) -> [bool; 2],
    S: Fn(u32) -> bool,
{
    let prove = |chains: &Chains<'_>| {
        let (rings, lines) = chains.points();
        Ok(checked(boundary, &rings, &lines)?.0)
    };
    let begun = || {
        let mut chains = Chains::new(boundary, given, demands.least_triangles);
        chains.begin_with(past.unwrap_or_default());
        chains
    };
    let mut chains = begun();
    let before = chains.limit_of_all();
    chains.drop_holes(demands.least_hole);
    let is_good = before >= demands.angle
        && chains.changes.is_empty()
        && chains.long_edges(&chains.alive().collect::<Vec<u32>>(), demands).is_empty()
        && chains.widen_inlets(prove, demands, 0)?.is_empty();
    let mut narrow_inlets = Vec::new();
    if !is_good || demands.size.is_some() {
        let (points, had_short) = (chains.edges().count() as f64, chains.has_short(demands));
        if past.is_none() {
            chains.thin(demands);
        }
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
    let checked = checked(boundary, &rings, &lines)?;
    let (after, mut left, moved) = (chains.limit_of_all(), chains.left(demands), chains.moved());
    left.extend(narrow_inlets);
    let (distances, past) = (chains.distances(), chains.past());
    let (mut changes, narrow) = (chains.changes, Vec::new());
    for change in &mut changes {
        change.moved = distances.get(&change.at.to_array().map(f64::to_bits)).copied();
    }
    let found = Conditioned { rings, lines, changes, left, narrow, before, after, moved };
    Ok(Round { found, past, checked })
}

/// Proves the new boundary by the exact sweep. Gives it, and each of its vertices as a point of the old one.
pub(crate) fn checked(
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
