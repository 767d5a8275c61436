//! Places narrower than a width: water is closed, spits of land are cut off.
//!
//! The constrained Delaunay triangulation of both sides of the boundary tells where shores face each other. What is closed or
//! opened is a set of its triangles, so the new boundary runs along old edges and edges of the triangulation, which cross
//! nothing.

mod pieces;
mod plane;
mod pockets;
mod rules;
mod runs;
mod trace;

use crate::changes::{BoundaryChange, Narrow, Point};
use crate::error::ConditionError;
use mindeg_mesh::planar::PlanarBoundary;
use pieces::Pieces;
use plane::Plane;
use rules::Narrows;
pub(crate) use rules::Rules;

/// So often water is closed or land opened at most, until nothing changes. Each makes the other wider, so few are enough.
const ROUNDS: usize = 8;
/// Water is closed first.
const KINDS: [Narrows; 2] = [Narrows::Domain, Narrows::Outside];

/// The rings without narrow places.
pub(crate) struct Narrowed {
    pub(crate) rings: Vec<Vec<Point>>,
    pub(crate) changes: Vec<BoundaryChange>,
    /// The narrow places that stay.
    pub(crate) narrow: Vec<Narrow>,
}

/// Closes and opens what is narrower than the width.
pub(crate) fn narrowed(
    boundary: &PlanarBoundary,
    rules: &Rules<'_>,
) -> Result<Narrowed, ConditionError> {
    let point = |of| Point { at: boundary.point(of), of: Some(of), edge: of };
    let rings = boundary.rings().map(|ring| ring.map(point).collect()).collect();
    let mut found = Narrowed { rings, changes: Vec::new(), narrow: Vec::new() };
    // How many looks have changed nothing since the last change, and how many there were.
    let (mut stays, mut next) = (0, 0);
    let mut narrow = [Vec::new(), Vec::new()];
    for _ in 0..ROUNDS {
        if stays == KINDS.len() {
            break;
        }
        let pieces = Pieces::new(boundary, &found.rings, rules)?;
        let plane = Plane::new(&pieces, rules)?;
        while stays < KINDS.len() {
            let kind = next % KINDS.len();
            let turned = runs::turned(&plane, rules, KINDS[kind]);
            narrow[kind] = turned.narrow;
            next += 1;
            if !turned.changes.is_empty() {
                found.rings = trace::rings(&plane, &turned.is_turned)?;
                found.changes.extend(turned.changes);
                stays = 0;
                break;
            }
            stays += 1;
        }
    }
    found.narrow = narrow.concat();
    Ok(found)
}
