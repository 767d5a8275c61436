//! The rings around the domain once some triangles have changed sides.

use super::pieces::Piece;
use super::plane::Plane;
use crate::chains::NONE;
use crate::changes::Point;
use crate::error::ConditionError;

/// Walks around the domain, which is on the left. Pieces of one edge that follow each other are one edge again, and rings that
/// stay begin where they did.
pub(super) fn rings(
    plane: &Plane<'_>,
    is_turned: &[bool],
) -> Result<Vec<Vec<Point>>, ConditionError> {
    let is_on_ring = |triangle: u32, side: usize| is_on_ring(plane, is_turned, triangle, side);
    let mut is_walked = vec![[false; 3]; plane.triangles.len()];
    // Each ring with the place of its first point among the old ones, and twice its area.
    let mut found: Vec<(u32, f64, Vec<Point>)> = Vec::new();
    for triangle in 0..plane.triangles.len() as u32 {
        for side in 0..3 {
            if is_walked[triangle as usize][side] || !is_on_ring(triangle, side) {
                continue;
            }
            let mut walk = Vec::new();
            let (mut at, mut on) = (triangle, side);
            while !std::mem::replace(&mut is_walked[at as usize][on], true) {
                walk.push((at, on));
                (at, on) = next(plane, is_on_ring, at, on)?;
            }
            found.extend(ring(plane, &walk));
        }
    }
    let outer = found.iter().filter(|ring| ring.1 > 0.0).count();
    if outer != 1 {
        return Err(unclear());
    }
    found.sort_by_key(|(first, area, _)| (*area <= 0.0, *first));
    Ok(found.into_iter().map(|ring| ring.2).collect())
}

/// Whether a triangle of the domain has something else behind a side; lines stay as they are.
pub(super) fn is_on_ring(
    plane: &Plane<'_>,
    is_turned: &[bool],
    triangle: u32,
    side: usize,
) -> bool {
    let is_domain =
        |index: u32| plane.triangles[index as usize].is_domain != is_turned[index as usize];
    let own = &plane.triangles[triangle as usize];
    let is_line = own.pieces[side].is_some_and(|piece| piece.of.is_none());
    let other = own.beside[side];
    !is_line && is_domain(triangle) && (other == NONE || !is_domain(other))
}

/// The side of the boundary that follows another.
fn next(
    plane: &Plane<'_>,
    is_on_ring: impl Fn(u32, usize) -> bool,
    triangle: u32,
    side: usize,
) -> Result<(u32, usize), ConditionError> {
    let (mut at, mut on) = (triangle, (side + 1) % 3);
    for _ in 0..plane.triangles.len() {
        if is_on_ring(at, on) {
            return Ok((at, on));
        }
        let other = plane.triangles[at as usize].beside[on];
        let behind = plane.triangles.get(other as usize).ok_or_else(unclear)?;
        let back = behind.beside.iter().position(|it| *it == at).ok_or_else(unclear)?;
        (at, on) = (other, (back + 1) % 3);
    }
    Err(unclear())
}

/// The points of a walk, from the one that comes first in the old order.
fn ring(plane: &Plane<'_>, walk: &[(u32, usize)]) -> Option<(u32, f64, Vec<Point>)> {
    // Each first end with the piece that goes on from there, if it is an old one.
    let mut steps: Vec<(u32, Option<Piece>)> = Vec::with_capacity(walk.len());
    for &(triangle, side) in walk {
        let piece = plane.triangles[triangle as usize].pieces[side];
        steps.push((plane.ends(triangle, side)?[0], piece));
    }
    let count = steps.len();
    let at = |i: usize| plane.at(steps[i % count].0);
    let doubled: f64 = (0..count).map(|i| at(i).perp_dot(at(i + 1))).sum();
    let edge = |i: usize| steps[i % count].1.and_then(|piece| piece.of);
    // A new edge begins nowhere among the old ones.
    let mut points: Vec<(u32, Point)> = Vec::with_capacity(count);
    for i in (0..count).filter(|i| edge(*i).is_none() || edge(*i) != edge(i + count - 1)) {
        let (node, piece) = steps[i];
        let point = piece.and_then(|piece| piece.from);
        let point = point.or(plane.pieces.nodes[node as usize].point)?;
        points.push((edge(i).unwrap_or(NONE), point));
    }
    let start = (0..points.len()).min_by_key(|i| points[*i].0)?;
    points.rotate_left(start);
    Some((points[0].0, doubled, points.into_iter().map(|point| point.1).collect()))
}

fn unclear() -> ConditionError {
    ConditionError::Narrow("the boundary touches itself, so its narrow places are unclear".into())
}
